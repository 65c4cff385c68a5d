//! Gas in the cavities of a liquid, without gas particles.
//!
//! In each cavity (pocket) the pressure is uniform, p = p_0 (x V_0/V)^k: V its volume by the colour integral ([`crate::cavity`]), x the
//! share of all gas that it holds, k the polytropic exponent. The gas acts on the liquid particles within reach of the cavity as
//! a pressure outside: forces of pairs are those of p - p_gas (`momentum.rs`), so that a liquid under the pressure of its gas is
//! at rest. Energy of the gas: sum of p V/(k - 1), or p_0 V_0 x ln(x V_0/V) for k = 1.
//!
//! Pockets are followed from step to step by the cells they have in common with themselves before. A pocket that parts shares
//! its gas by volume; pockets that meet put theirs together. Voids that open elsewhere hold no gas. A pocket too small to be
//! seen (no cell with colour below 1/2) is closed; the energy of its gas is counted as lost.
//!
//! Units: SI. Range: uniform pressure (the wall moves slowly beside sound in the gas); the cavity is four spacings or more across.

use crate::cavity::{Colour, Map, Window};
use crate::fluid::ghosts::Ghosts;
use crate::fluid::{Fluid, Formulation, PARTICLES_PER_TASK};
use crate::geometry::Vec2;
use crate::kernel;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Room around the pockets in which they are looked for in the next step, in supports of the kernel there.
const ROOM: f64 = 2.0;

/// Fewer cells (two particles) are noise between particles: they do not take gas from a pocket that parts.
const SMALLEST: usize = 8;

/// What the gas is, and where cavities count.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GasLaw {
    /// Pressure at the start, Pa.
    pub pressure: f64,
    /// Polytropic exponent: 1 isothermal, 1.4 adiabatic for air.
    pub polytropic_exponent: f64,
    /// Corners of the part of the plane in which cavities hold gas, m.
    pub limits: [Vec2; 2],
    /// Size of the cells by which volumes are measured, m: half the finest spacing.
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
    /// Energy of gas in pockets that closed, and lost where pockets of unequal pressure met, J.
    pub lost: f64,
    /// Pockets that closed.
    pub closed: u64,
    /// Steps in which a pocket reached beyond the limits, so that its volume was cut.
    pub cut: u64,
    cells: Cells,
}

/// Cells of the pockets. Cells have whole-number places from the lower limit on, so that windows fit together.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
struct Cells {
    /// Rows of cells: first cell (both places), how many, pocket.
    runs: Vec<([usize; 2], usize, usize)>,
    /// First cell, and one past the last, of the part to be searched next.
    search: [[usize; 2]; 2],
}

/// A pocket of which a part goes into a void.
struct Part {
    share: f64,
    /// Its volume before, m3.
    volume: f64,
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

    fn window(&self, [from, to]: [[usize; 2]; 2]) -> Window {
        let at = |c: [usize; 2]| [0, 1].map(|k| self.limits[0][k] + c[k] as f64 * self.cell);
        Window {
            lower: at(from),
            upper: at(to),
            cell: self.cell,
        }
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
            cells: Cells::default(),
        };
        gas.keep(fluid, &map, search[0], &pocket_of);
        Some(gas)
    }

    /// Energy of the gas, J.
    #[must_use]
    pub fn energy(&self) -> f64 {
        let one = |p: &Pocket| self.law.energy(self.first_volume, p.share, p.volume);
        self.pockets.iter().map(one).sum::<f64>() + 0.0
    }

    /// Volume of all pockets, m3.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.pockets.iter().map(|p| p.volume).sum::<f64>() + 0.0
    }

    /// Finds the pockets in the liquid as it is, with their new pressures. Returns the pressure of the gas on each particle,
    /// Pa; 0 out of reach.
    pub(crate) fn follow(&mut self, fluid: &Fluid, ghosts: &Ghosts) -> Vec<f64> {
        let search = self.cells.search;
        if self.pockets.is_empty() {
            return vec![0.0; fluid.len()];
        }
        let map = Colour::new(fluid, ghosts, self.law.window(search)).map();
        let pocket_of = self.hand_on(&map, search[0]);
        self.keep(fluid, &map, search[0], &pocket_of)
    }

    /// Gas goes from the pockets into the voids where they were. Returns the new pocket of each label, from 1; 0 for none.
    fn hand_on(&mut self, map: &Map, first: [usize; 2]) -> Vec<usize> {
        // Cells that a void has in common with a pocket.
        let mut common = vec![vec![0_usize; map.voids.len()]; self.pockets.len()];
        for &([i, j], count, pocket) in &self.cells.runs {
            for i in i..i + count {
                let inside = i >= first[0] && j >= first[1];
                let cell = [i.wrapping_sub(first[0]), j.wrapping_sub(first[1])];
                if inside && cell[0] < map.size[0] && cell[1] < map.size[1] {
                    let label = map.label[cell[0] + map.size[0] * cell[1]] as usize;
                    if label != 0 {
                        common[pocket][label - 1] += 1;
                    }
                }
            }
        }
        let all: Vec<usize> = (0..map.voids.len())
            .map(|v| common.iter().map(|c| c[v]).sum())
            .collect();
        let mut parts: Vec<Vec<Part>> = map.voids.iter().map(|_| Vec::new()).collect();
        for (pocket, common) in self.pockets.iter().zip(&common) {
            let largest = (0..common.len()).max_by_key(|&v| (common[v] > 0, map.voids[v].cells));
            let takes =
                |v: usize| common[v] > 0 && (map.voids[v].cells >= SMALLEST || Some(v) == largest);
            let weight = |v: usize| map.voids[v].volume * common[v] as f64 / all[v] as f64;
            let takers: Vec<usize> = (0..common.len()).filter(|&v| takes(v)).collect();
            let sum: f64 = takers.iter().map(|&v| weight(v)).sum();
            if takers.is_empty() {
                self.closed += 1;
                self.lost += self
                    .law
                    .energy(self.first_volume, pocket.share, pocket.volume);
            }
            for v in takers {
                let part = weight(v) / sum;
                parts[v].push(Part {
                    share: part * pocket.share,
                    volume: part * pocket.volume,
                });
            }
        }
        self.fill_voids(map, &parts)
    }

    fn fill_voids(&mut self, map: &Map, parts: &[Vec<Part>]) -> Vec<usize> {
        let mut pocket_of = vec![0; parts.len() + 1];
        let mut pockets = Vec::new();
        for (v, parts) in parts.iter().enumerate().filter(|(_, p)| !p.is_empty()) {
            let share: f64 = parts.iter().map(|p| p.share).sum();
            if parts.len() > 1 {
                let before: f64 = parts.iter().map(|p| p.volume).sum();
                let one = |p: &Part| self.law.energy(self.first_volume, p.share, p.volume);
                let apart: f64 = parts.iter().map(one).sum();
                self.lost += apart - self.law.energy(self.first_volume, share, before);
            }
            let volume = map.voids[v].volume;
            pockets.push(Pocket {
                share,
                volume,
                pressure: self.law.pressure_in(self.first_volume, share, volume),
            });
            pocket_of[v + 1] = pockets.len();
        }
        self.pockets = pockets;
        pocket_of
    }

    /// Remembers the cells of the pockets; the pressure on each particle.
    fn keep(
        &mut self,
        fluid: &Fluid,
        map: &Map,
        first: [usize; 2],
        pocket_of: &[usize],
    ) -> Vec<f64> {
        let width = map.size[0];
        let (mut runs, mut low, mut high) = (Vec::new(), [usize::MAX; 2], [0; 2]);
        for j in 0..map.size[1] {
            let mut i = 0;
            while i < width {
                let pocket = pocket_of[map.label[i + width * j] as usize];
                let begin = i;
                while i < width && pocket_of[map.label[i + width * j] as usize] == pocket {
                    i += 1;
                }
                if pocket != 0 {
                    let cell = [begin + first[0], j + first[1]];
                    runs.push((cell, i - begin, pocket - 1));
                    low = [low[0].min(cell[0]), low[1].min(cell[1])];
                    high = [high[0].max(i + first[0]), high[1].max(cell[1] + 1)];
                }
            }
        }
        let pressures: Vec<f64> = self.pockets.iter().map(|p| p.pressure).collect();
        let on = |a: usize| Reach::new(map, fluid, a).pressure(map, pocket_of, &pressures);
        let on: Vec<f64> = (0..fluid.len())
            .into_par_iter()
            .with_min_len(PARTICLES_PER_TASK)
            .map(on)
            .collect();
        let touched = (0..fluid.len()).filter(|&a| on[a] > 0.0);
        let largest = touched.fold(0.0, |m: f64, a| m.max(fluid.smoothing_length[a]));
        let room = ROOM * kernel::SUPPORT * largest.max(self.law.cell) / self.law.cell;
        let (room, size) = (room.ceil() as usize, self.law.size());
        if high[0] == size[0] || high[1] == size[1] {
            self.cut += 1;
        }
        self.cells = Cells {
            runs,
            search: [
                [0, 1].map(|k| low[k].saturating_sub(room).min(size[k])),
                [0, 1].map(|k| (high[k] + room).min(size[k])),
            ],
        };
        on
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

/// Cells of a map within the support of a particle.
struct Reach {
    x: Vec2,
    h: f64,
    from: [usize; 2],
    to: [usize; 2],
}

impl Reach {
    fn new(map: &Map, fluid: &Fluid, a: usize) -> Self {
        let (x, h) = (fluid.position[a], fluid.smoothing_length[a]);
        let (w, radius) = (map.window, kernel::SUPPORT * h);
        let cell = |v: f64, k: usize| {
            let cell = (v - w.lower[k]) / w.cell;
            cell.clamp(0.0, map.size[k] as f64) as usize
        };
        Self {
            x,
            h,
            from: [0, 1].map(|k| cell(x[k] - radius, k)),
            to: [0, 1].map(|k| cell(x[k] + radius + w.cell, k)),
        }
    }

    /// Kernel mean of the pressures of the pockets within reach; 0 without any.
    fn pressure(&self, map: &Map, pocket_of: &[usize], pressures: &[f64]) -> f64 {
        let (mut sum, mut weight) = (0.0, 0.0);
        for j in self.from[1]..self.to[1] {
            for i in self.from[0]..self.to[0] {
                let pocket = pocket_of[map.label[i + map.size[0] * j] as usize];
                if pocket != 0 {
                    let place = |k: usize, c: usize| {
                        map.window.lower[k] + (c as f64 + 0.5) * map.window.cell
                    };
                    let d = (place(0, i) - self.x[0]).hypot(place(1, j) - self.x[1]);
                    let w = kernel::value(d, self.h);
                    sum += w * pressures[pocket - 1];
                    weight += w;
                }
            }
        }
        if weight > 0.0 { sum / weight } else { 0.0 }
    }
}
