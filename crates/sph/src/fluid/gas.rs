//! Gas in the cavities of a liquid, without gas particles.
//!
//! In each cavity (pocket) the pressure is uniform, p = p_0 (x V_0/V)^k: V its volume by the colour integral ([`crate::cavity`]), x the
//! share of all gas that it holds, k the polytropic exponent. The gas acts on the liquid particles within reach of the cavity as
//! a pressure outside: forces of pairs are those of p - p_gas (`momentum.rs`), so that a liquid under the pressure of its gas is
//! at rest. It pushes on the surface of a solid where the cavity touches it. Energy of the gas: sum of p V/(k - 1), or
//! p_0 V_0 x ln(x V_0/V) for k = 1.
//!
//! Pockets are followed from step to step by the cells they have in common with themselves before (`gas/hand_on.rs`). A pocket that
//! parts shares its gas by volume; pockets that meet put theirs together; a pocket that opens into an empty void fills it. A
//! pocket too small to be seen (no cell with colour below 1/2) is closed. Where volumes jump in this way no work is done, and
//! what the energy of the gas falls by is counted as lost.
//!
//! Units: SI. Range: uniform pressure (the wall moves slowly beside sound in the gas); the cavity is four spacings or more across.

mod cells;
mod hand_on;
mod reach;
#[cfg(test)]
mod tests;

use crate::cavity::{Colour, Map, Window};
use crate::fluid::ghosts::Ghosts;
use crate::fluid::{Fluid, Formulation, PARTICLES_PER_TASK, SMOOTHING};
use crate::geometry::{Geometry, Vec2};
use crate::interface::SurfaceLine;
use crate::kernel;
use cells::{Cells, Part};
use rayon::prelude::*;
use reach::Reach;
use serde::{Deserialize, Serialize};

/// Room around the pockets in which they are looked for in the next step, in supports of the kernel there.
const ROOM: f64 = 2.0;

/// Fewer cells (two particles) are noise between particles: they do not take gas from a pocket that parts.
const SMALLEST: usize = 8;

/// Cells per spacing of the particles beside the gas: with fewer they are halved, with more doubled again. Two at the start.
const CELLS_PER_SPACING: [f64; 2] = [1.5, 4.0];

/// Places across the width of a point of a surface where it is looked for gas.
const PLACES: usize = 4;

/// What the gas is, and where cavities count.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GasLaw {
    /// Pressure at the start, Pa.
    pub pressure: f64,
    /// Polytropic exponent: 1 isothermal, 1.4 adiabatic for air.
    pub polytropic_exponent: f64,
    /// Corners of the part of the plane in which cavities hold gas, m.
    pub limits: [Vec2; 2],
    /// Whether the liquid ends at these limits (a wall, the axis): a pocket that reaches them is whole. Beyond the others
    /// its volume is cut, which is counted.
    pub ends: [[bool; 2]; 2],
    /// Size of the cells by which volumes are measured, m: half the finest spacing. They are halved where particles are.
    pub cell: f64,
}

/// A cavity with gas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pocket {
    /// Share of all gas.
    pub share: f64,
    /// Volume, m3 (per metre in plane).
    pub volume: f64,
    /// Pressure, Pa.
    pub pressure: f64,
}

/// Gas in a liquid.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Gas {
    /// What it is.
    pub law: GasLaw,
    /// Volume at the start, m3.
    pub first_volume: f64,
    /// Pockets now.
    pub pockets: Vec<Pocket>,
    /// Energy of gas in pockets that closed; what it lost without work where pockets met at unequal pressure and where one
    /// opened into an empty void, less what it gained where a piece too small to hold gas came off, J.
    pub lost: f64,
    /// Pockets that closed.
    pub closed: u64,
    /// Steps in which a pocket reached beyond the limits, so that its volume was cut.
    pub cut: u64,
    /// Size of the cells at the start, m; [`GasLaw::cell`] is the one now.
    first_cell: f64,
    cells: Cells,
}

impl GasLaw {
    fn squeezed(&self, first_volume: f64, share: f64, volume: f64) -> f64 {
        share * first_volume / volume
    }

    fn pressure_in(&self, first_volume: f64, share: f64, volume: f64) -> f64 {
        let squeezed = self.squeezed(first_volume, share, volume);
        self.pressure * squeezed.powf(self.polytropic_exponent)
    }

    /// Energy of a share of the gas in a volume, J.
    fn energy(&self, first_volume: f64, share: f64, volume: f64) -> f64 {
        let squeezed = self.squeezed(first_volume, share, volume);
        let (scale, k) = (
            self.pressure * first_volume * share,
            self.polytropic_exponent,
        );
        if k == 1.0 {
            scale * squeezed.ln()
        } else {
            scale * squeezed.powf(k - 1.0) / (k - 1.0)
        }
    }

    /// Number of cells between the limits.
    fn size(&self) -> [usize; 2] {
        [0, 1].map(|k| {
            let cells = (self.limits[1][k] - self.limits[0][k]) / self.cell;
            cells.round().max(1.0) as usize
        })
    }

    fn window(&self, [from, to]: Part) -> Window {
        let at = |c: [usize; 2]| [0, 1].map(|k| self.limits[0][k] + c[k] as f64 * self.cell);
        Window {
            lower: at(from),
            upper: at(to),
            cell: self.cell,
        }
    }

    /// Cell of a point; a point behind a limit where the liquid ends (a wall that was pushed in) has the cell before it.
    fn cell_of(&self, x: Vec2) -> Option<[usize; 2]> {
        let (mut cell, size) = ([0; 2], self.size());
        for k in 0..2 {
            let place = ((x[k] - self.limits[0][k]) / self.cell).floor();
            let last = (size[k] - 1) as f64;
            if (place < 0.0 && !self.ends[0][k]) || (place > last && !self.ends[1][k]) {
                return None;
            }
            cell[k] = place.clamp(0.0, last) as usize;
        }
        Some(cell)
    }
}

impl Gas {
    /// Gas in all cavities of a liquid within the limits; none where there is no cavity.
    #[must_use]
    pub fn fill(law: GasLaw, fluid: &Fluid, ghosts: &Ghosts) -> Option<Self> {
        let search = [[0, 0], law.size()];
        let map = Colour::new(fluid, ghosts, law.window(search)).map();
        let seen = |v: &&crate::cavity::Void| v.cells >= SMALLEST;
        let first_volume: f64 = map.voids.iter().filter(seen).map(|v| v.volume).sum();
        let mut pocket_of = vec![0; map.voids.len() + 1];
        let mut pockets = Vec::new();
        for (k, void) in map.voids.iter().enumerate().filter(|(_, v)| seen(v)) {
            pockets.push(Pocket {
                share: void.volume / first_volume,
                volume: void.volume,
                pressure: law.pressure,
            });
            pocket_of[k + 1] = pockets.len();
        }
        if pockets.is_empty() {
            return None;
        }
        let mut gas = Self {
            law,
            first_volume,
            pockets,
            lost: 0.0,
            closed: 0,
            cut: 0,
            first_cell: law.cell,
            cells: Cells::default(),
        };
        gas.keep(fluid, &map, search, &pocket_of);
        Some(gas)
    }

    /// Energy of the gas, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let one = |p: &Pocket| self.energy_of(p.share, p.volume);
        self.pockets.iter().map(one).sum::<f64>() + 0.0
    }

    fn energy_of(&self, share: f64, volume: f64) -> f64 {
        self.law.energy(self.first_volume, share, volume)
    }

    /// Volume of all pockets, m3.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.pockets.iter().map(|p| p.volume).sum::<f64>() + 0.0
    }

    /// Pressure of the gas on each point of the surface of a solid, Pa; 0 where no pocket touches it.
    #[must_use]
    pub fn pressure_on(&self, line: &SurfaceLine) -> Vec<f64> {
        let places = |k: usize| {
            (0..PLACES).map(move |i| {
                let along = ((i as f64 + 0.5) / PLACES as f64 - 0.5) * line.width[k];
                let x = line.position[k];
                [x[0] + along, x[1] + 0.5 * self.law.cell]
            })
        };
        let at = |x: Vec2| {
            let pocket = (self.law.cell_of(x)).and_then(|c| self.cells.owner(c));
            (pocket.and_then(|p| self.pockets.get(p))).map_or(0.0, |p| p.pressure)
        };
        (0..line.position.len())
            .map(|k| places(k).map(at).sum::<f64>() / PLACES as f64)
            .collect()
    }

    /// Finds the pockets in the liquid as it is, with their new pressures. Returns the pressure of the gas on each particle,
    /// Pa; 0 out of reach.
    pub(crate) fn follow(&mut self, fluid: &Fluid, ghosts: &Ghosts) -> Vec<f64> {
        if self.pockets.is_empty() {
            return vec![0.0; fluid.len()];
        }
        let mut search = self.cells.search;
        let map = loop {
            let map = Colour::new(fluid, ghosts, self.law.window(search)).map();
            // A void that has opened to a pocket is to be seen as a whole.
            match self.wider(&map, search) {
                Some(wider) => search = wider,
                None => break map,
            }
        };
        let pocket_of = self.hand_on(&map, search, fluid.geometry);
        self.keep(fluid, &map, search, &pocket_of)
    }

    /// Remembers the cells of the pockets and of empty voids; the pressure on each particle.
    fn keep(&mut self, fluid: &Fluid, map: &Map, search: Part, pocket_of: &[usize]) -> Vec<f64> {
        let pressures: Vec<f64> = self.pockets.iter().map(|p| p.pressure).collect();
        let on = |a: usize| Reach::new(map, fluid, a).pressure(map, pocket_of, &pressures);
        let on: Vec<f64> = (0..fluid.len())
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .map(on)
            .collect();
        let touched: Vec<f64> = (0..fluid.len())
            .filter(|&a| on[a] > 0.0)
            .map(|a| fluid.smoothing_length[a])
            .collect();
        let largest = touched.iter().copied().fold(0.0, f64::max);
        let room = ROOM * kernel::SUPPORT * largest.max(self.law.cell) / self.law.cell;
        let size = self.law.size();
        let (cells, [low, high]) = Cells::of(map, search, pocket_of, self.pockets.len());
        let beyond = |k: usize| {
            (low[k] == 0 && !self.law.ends[0][k]) || (high[k] == size[k] && !self.law.ends[1][k])
        };
        if !self.pockets.is_empty() && (beyond(0) || beyond(1)) {
            self.cut += 1;
        }
        self.cells = cells;
        let room = room.ceil() as usize;
        self.cells.search = [
            [0, 1].map(|k| low[k].saturating_sub(room).min(size[k])),
            [0, 1].map(|k| (high[k] + room).min(size[k])),
        ];
        let mean = touched.iter().sum::<f64>() / touched.len().max(1) as f64;
        self.fit_cells(mean / SMOOTHING);
        on
    }

    /// Halves or doubles the cells when they no longer fit the mean `spacing` of the particles that the gas touches, m.
    fn fit_cells(&mut self, spacing: f64) {
        let [fewest, most] = CELLS_PER_SPACING.map(|n| n * self.law.cell);
        if spacing > 0.0 && spacing < fewest {
            self.law.cell *= 0.5;
            self.cells = self.cells.halved();
        } else if spacing > most && self.law.cell < self.first_cell {
            self.law.cell *= 2.0;
            self.cells = self.cells.doubled();
        }
    }
}

impl Fluid {
    /// Finds the pockets of gas where the liquid is now, with their pressure on the particles.
    pub(crate) fn follow_gas(&mut self, ghosts: &Ghosts) {
        if let Some(mut gas) = self.gas.take() {
            if let Formulation::Corrected(_) = self.formulation {
                self.update_smoothing_length();
            }
            self.gas_pressure = gas.follow(self, ghosts);
            self.gas = Some(gas);
        }
    }
}

/// Weight of a cell in a volume, by its place between the limits.
fn ring(law: &GasLaw, geometry: Geometry, column: usize) -> f64 {
    geometry.ring(law.limits[0][0] + (column as f64 + 0.5) * law.cell)
}
