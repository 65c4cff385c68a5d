//! What is watched while a run goes on: the bubble, the jet, the wall, the metal, the energy.

use super::ledger::Ledger;
use crate::analysis::{YIELDED, absorbed_energy, half_width, plastic_volume};
use crate::case::{Bubble, Simulation};
use crate::output::Column;
use erode_sph::cavity::{Cavity, Colour, Window};
use erode_sph::fluid::Fluid;
use erode_sph::fluid::gas::Pocket;
use erode_sph::fluid::ghosts::{Ghosts, Wall};
use erode_sph::geometry::Vec2;
use erode_sph::interface::SurfaceLine;
use erode_sph::solid::{Side, Solid};
use erode_sph::world::{Body, World};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// A void of fewer cells than this is a gap between particles, not a bubble (a cell is half a spacing wide).
const SMALLEST_VOID: usize = 8;

/// The jet is read when the gap between the two walls of the bubble on the axis falls below this many initial radii: the
/// last values before the impact are those of one or two particles.
const JET_GAP: f64 = 0.2;

/// The bubble counts as collapsed when less than this share of its initial volume is left.
pub(crate) const COLLAPSED: f64 = 0.02;

/// Extremes and events since the start: part of a checkpoint.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Record {
    /// Energy balance at the start, J.
    pub initial_balance: f64,
    /// Mass at the start, kg.
    pub initial_mass: f64,
    /// Largest change of the mass of a liquid that was taken away / its mass at the start.
    #[serde(default)]
    pub mass_drift: Option<f64>,
    /// Void volume at the start, m3.
    pub initial_volume: f64,
    /// Largest pressure on the wall, Pa, with its radius (m) and time (s).
    pub peak_wall_pressure: [f64; 3],
    /// Largest plastic strain rate, 1/s.
    pub max_strain_rate: f64,
    /// Time when the bubble had collapsed, s.
    pub collapsed: Option<f64>,
    /// Smallest void volume, m3.
    pub smallest_volume: f64,
    /// Speed of the jet towards the wall when the gap closed, m/s.
    pub jet_speed: Option<f64>,
    /// Time of that, s.
    pub jet_time: Option<f64>,
    /// Half-width of the jet at that time, m.
    #[serde(default)]
    pub jet_half_width: Option<f64>,
    /// Largest pressure of the gas, Pa.
    #[serde(default)]
    pub max_gas_pressure: f64,
    /// Largest pressure in the liquid, Pa.
    pub max_pressure: f64,
    /// Largest energy that the boundaries put in and the start held, J.
    pub energy_scale: f64,
    /// Largest departure of the energy balance, J.
    pub energy_drift: f64,
    /// Largest force on an indenter, N.
    #[serde(default)]
    pub max_indenter_force: f64,
    /// Steps limited by each criterion.
    pub limiters: BTreeMap<String, u64>,
    /// Seconds of computing in each part of the run, before a resume.
    #[serde(default)]
    pub seconds: BTreeMap<String, f64>,
    /// Seconds of computing before a resume.
    pub wall_time: f64,
}

/// The bubble at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BubbleState {
    /// Void volume, m3 (per metre in plane).
    pub volume: f64,
    /// Height of the centroid, m.
    pub centre: f64,
    /// Distance of the centroid from the axis, m: zero for a void on the axis.
    pub centre_r: f64,
    /// Voids.
    pub parts: usize,
    /// Distance of the largest void from the axis, m: positive for a toroid.
    pub inner_radius: f64,
    /// Gap on the axis between the upper and lower side of the void, m.
    pub gap: f64,
    /// Mean velocity of the liquid at the upper side on the axis towards the wall, m/s; NaN without a void on the axis.
    pub jet_speed: f64,
    /// Distance from the axis at which that velocity has fallen to half, m; NaN without a void on the axis.
    pub jet_half_width: f64,
}

/// Columns of `history.csv`.
#[must_use]
pub(crate) fn columns(simulation: &Simulation) -> Vec<Column> {
    let mut names = vec![("time", "s"), ("dt", "s")];
    if simulation.bubble.is_some() {
        names.extend([
            ("bubble_volume", "m3"),
            ("bubble_radius", "m"),
            ("bubble_centre", "m"),
            ("bubble_centre_r", "m"),
            ("bubble_parts", "-"),
            ("bubble_inner_radius", "m"),
            ("jet_gap", "m"),
            ("jet_speed", "m/s"),
            ("jet_half_width", "m"),
        ]);
    }
    if simulation.bubble.is_some_and(|b| b.gas.is_some()) {
        names.extend([
            ("gas_pressure", "Pa"),
            ("gas_volume", "m3"),
            ("gas_parts", "-"),
        ]);
    }
    names.extend([
        ("max_pressure", "Pa"),
        ("max_speed", "m/s"),
        ("kinetic_energy", "J"),
    ]);
    if has_solid(simulation) {
        names.extend([
            ("wall_pressure_centre", "Pa"),
            ("wall_pressure_max", "Pa"),
            ("max_plastic_strain", "-"),
            ("max_plastic_strain_rate", "1/s"),
            ("plastic_work", "J"),
            ("plastic_volume", "m3"),
            ("wall_depth", "m"),
            ("lost_mass", "kg"),
        ]);
    }
    if simulation.loads.indenter.is_some() {
        names.extend([("indenter_depth", "m"), ("indenter_force", "N")]);
    }
    if !simulation.loads.is_empty() {
        names.push(("inertia_share", "-"));
    }
    names.extend(Ledger::default().entries().map(|(name, _)| (name, "J")));
    names.push(("energy_residual", "J"));
    names
        .into_iter()
        .map(|(name, unit)| Column::new(name, unit))
        .collect()
}

fn has_solid(simulation: &Simulation) -> bool {
    simulation
        .bodies
        .iter()
        .any(|b| matches!(b.kind, crate::case::BodyKind::Solid(_)))
}

/// The liquid and the solid of a world, as far as there are.
pub(crate) fn liquid(world: &World) -> Option<&Fluid> {
    world.bodies.iter().find_map(|b| {
        if let Body::Fluid(f) = &b.body {
            Some(f)
        } else {
            None
        }
    })
}

pub(crate) fn solid(world: &World) -> Option<&Solid> {
    world.bodies.iter().find_map(|b| {
        if let Body::Solid(s) = &b.body {
            Some(s)
        } else {
            None
        }
    })
}

/// Surfaces of solids that the liquid meets.
pub(super) fn wetted(world: &World) -> Vec<SurfaceLine> {
    let surface = solid(world).and_then(|s| s.surface(Side::Top));
    surface.map(SurfaceLine::of).into_iter().collect()
}

/// Where the bubble is looked for, in cells of the size `cell` (m).
pub(super) fn window(bubble: &Bubble, cell: f64) -> Window {
    let reach = 1.4 * bubble.radius;
    let floor = if bubble.wall_distance.is_some() {
        0.0
    } else {
        f64::NEG_INFINITY
    };
    Window {
        lower: [0.0, (bubble.centre[1] - reach).max(floor)],
        upper: [bubble.centre[0] + reach, bubble.centre[1] + reach],
        cell,
    }
}

/// Measures the bubble.
#[must_use]
pub fn bubble(world: &World, bubble: &Bubble, cell: f64) -> BubbleState {
    let nothing = BubbleState {
        volume: 0.0,
        centre: f64::NAN,
        centre_r: f64::NAN,
        parts: 0,
        inner_radius: f64::NAN,
        gap: 0.0,
        jet_speed: f64::NAN,
        jet_half_width: f64::NAN,
    };
    let Some(fluid) = liquid(world) else {
        return nothing;
    };
    let lines = wetted(world);
    let walls: Vec<&dyn Wall> = lines.iter().map(|l| l as &dyn Wall).collect();
    let window = window(bubble, cell);
    let colour = Colour::new(fluid, &Ghosts::find(fluid, &walls), window);
    let cavities = colour.cavities(SMALLEST_VOID);
    let Some(largest) = cavities.first() else {
        return nothing;
    };
    let volume: f64 = cavities.iter().map(|c| c.volume).sum();
    let on_axis = cavities.iter().find(|c| c.inner_radius == 0.0);
    let mean = |k: usize| cavities.iter().map(|c| c.volume * c.centre[k]).sum::<f64>() / volume;
    BubbleState {
        volume,
        centre: mean(1),
        centre_r: mean(0),
        parts: cavities.len(),
        inner_radius: largest.inner_radius,
        gap: on_axis.map_or(0.0, Cavity::gap),
        jet_speed: on_axis.map_or(f64::NAN, |c| tip_speed(fluid, [0.0, c.axis_extent[1]])),
        jet_half_width: on_axis.map_or(f64::NAN, |c| jet_width(fluid, c.axis_extent[1])),
    }
}

/// Half-width of the jet one smoothing length above its tip, NaN where it has none.
fn jet_width(fluid: &Fluid, tip: f64) -> f64 {
    let finest = fluid
        .smoothing_length
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let speed: Vec<f64> = fluid.velocity.iter().map(|v| -v[1]).collect();
    half_width(&fluid.position, &speed, tip + finest, 0.5 * finest).unwrap_or(f64::NAN)
}

/// Kernel mean of the velocity towards smaller z just above `tip`.
fn tip_speed(fluid: &Fluid, tip: Vec2) -> f64 {
    let nearest = (0..fluid.len())
        .filter(|&a| fluid.position[a][1] > tip[1] - fluid.smoothing_length[a])
        .min_by(|&a, &b| {
            distance(fluid.position[a], tip).total_cmp(&distance(fluid.position[b], tip))
        });
    let Some(nearest) = nearest else {
        return f64::NAN;
    };
    let reach = 2.0 * fluid.smoothing_length[nearest];
    let (mut sum, mut weight) = (0.0, 0.0);
    for a in 0..fluid.len() {
        let d = distance(fluid.position[a], tip);
        if d < reach && fluid.position[a][1] > tip[1] - fluid.smoothing_length[a] {
            let w = fluid.mass[a] / fluid.geometry.ring(fluid.position[a][0]);
            sum -= w * fluid.velocity[a][1];
            weight += w;
        }
    }
    sum / weight
}

fn distance(a: Vec2, b: Vec2) -> f64 {
    // Not `hypot`: it is slow, and nothing here is near the ends of the range of numbers.
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt()
}

/// Radius of the ball (disc in plane) with a volume.
#[must_use]
pub(crate) fn equivalent_radius(volume: f64, geometry: erode_sph::Geometry) -> f64 {
    match geometry {
        erode_sph::Geometry::Axisymmetric => (3.0 * volume.max(0.0) / (4.0 * PI)).cbrt(),
        // Half a disc lies at x > 0.
        erode_sph::Geometry::Plane => (2.0 * volume.max(0.0) / PI).sqrt(),
    }
}

/// One row of `history.csv`; extremes go to the record.
pub(crate) fn row(
    world: &World,
    simulation: &Simulation,
    cell: f64,
    dt: f64,
    record: &mut Record,
) -> Vec<f64> {
    let mut values = vec![world.time, dt];
    if let Some(b) = &simulation.bubble {
        let state = bubble(world, b, cell);
        record.see_bubble(&state, b, world.time);
        let radius = equivalent_radius(state.volume, simulation.geometry);
        let parts = state.parts as f64;
        values.extend([
            state.volume,
            radius,
            state.centre,
            state.centre_r,
            parts,
            state.inner_radius,
            state.gap,
            state.jet_speed,
            state.jet_half_width,
        ]);
    }
    let fluids = liquid(world);
    if simulation.bubble.is_some_and(|b| b.gas.is_some()) {
        let gas = fluids.and_then(|f| f.gas.as_ref());
        let parts = gas.map_or(&[][..], |g| &g.pockets);
        values.extend([
            record.see_gas(parts),
            parts.iter().map(|p| p.volume).sum::<f64>() + 0.0,
            parts.len() as f64,
        ]);
    }
    let pressure = fluids.map_or(0.0, |f| largest(&f.pressure));
    let speed = fluids.map_or(0.0, |f| {
        f.velocity
            .iter()
            .map(|v| v[0] * v[0] + v[1] * v[1])
            .fold(0.0, f64::max)
            .sqrt()
    });
    let ledger = Ledger::of(world);
    values.extend([
        pressure,
        speed,
        ledger.liquid_kinetic + ledger.solid_kinetic,
    ]);
    if let Some(s) = solid(world) {
        let metal = Metal::of(s);
        let wall = s.surface(Side::Top);
        values.extend([
            wall.and_then(|w| w.pressure.first().copied())
                .unwrap_or(f64::NAN),
            wall.map_or(f64::NAN, |w| largest(&w.pressure)),
            metal.max_plastic_strain,
            largest(&s.state.plastic_strain_rate),
            metal.plastic_work,
            metal.plastic_volume,
            metal.depth,
            s.state.work.lost.mass,
        ]);
        if let Some(i) = &simulation.loads.indenter {
            values.extend([i.depth_at(world.time), indenter_force(s)]);
        }
        if !simulation.loads.is_empty() {
            values.push(s.inertia_share());
        }
    }
    values.extend(ledger.entries().map(|(_, value)| value));
    values.push(record.see_energy(&ledger));
    values
}

impl Record {
    /// Mass of the liquid now / at the start, less 1; none without one.
    pub(crate) fn mass_drift_of(&self, world: &World) -> Option<f64> {
        let mass: f64 = liquid(world)?.mass.iter().sum();
        (self.initial_mass > 0.0).then(|| mass / self.initial_mass - 1.0)
    }

    /// The largest of this liquid and those that were taken away.
    pub(crate) fn largest_mass_drift(&self, world: &World) -> Option<f64> {
        let drifts = self.mass_drift.into_iter().chain(self.mass_drift_of(world));
        drifts.max_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// After every step: what must not be missed between rows.
    pub(crate) fn see_step(&mut self, world: &World, limiter: &str) {
        *self.limiters.entry(limiter.to_owned()).or_default() += 1;
        if let Some(s) = solid(world) {
            self.max_indenter_force = self.max_indenter_force.max(indenter_force(s));
            self.max_strain_rate = self
                .max_strain_rate
                .max(largest(&s.state.plastic_strain_rate));
            if let Some(wall) = s.surface(Side::Top) {
                for (p, x) in wall.pressure.iter().zip(&wall.reference_position) {
                    if *p > self.peak_wall_pressure[0] {
                        self.peak_wall_pressure = [*p, x[0], world.time];
                    }
                }
            }
        }
        if let Some(f) = liquid(world) {
            self.max_pressure = self.max_pressure.max(largest(&f.pressure));
        }
    }

    fn see_bubble(&mut self, state: &BubbleState, bubble: &Bubble, time: f64) {
        self.smallest_volume = self.smallest_volume.min(state.volume);
        if self.collapsed.is_none() && state.volume < COLLAPSED * self.initial_volume {
            self.collapsed = Some(time);
        }
        if self.jet_time.is_none() && time > 0.0 && state.gap < JET_GAP * bubble.radius {
            self.jet_time = Some(time);
        }
        if self.jet_time.is_none() && state.jet_speed.is_finite() {
            self.jet_speed = Some(state.jet_speed);
            self.jet_half_width = Some(state.jet_half_width).filter(|w| w.is_finite());
        }
    }

    /// Pressure of the pocket with the largest share; 0 when all have closed.
    fn see_gas(&mut self, pockets: &[Pocket]) -> f64 {
        let main = pockets.iter().max_by(|a, b| a.share.total_cmp(&b.share));
        let pressure = main.map_or(0.0, |p| p.pressure);
        self.max_gas_pressure = self.max_gas_pressure.max(pressure);
        pressure
    }

    fn see_energy(&mut self, ledger: &Ledger) -> f64 {
        let residual = ledger.balance() - self.initial_balance;
        self.energy_scale = self
            .energy_scale
            .max(self.initial_balance + (ledger.boundary_work + ledger.taken_out).abs());
        if residual.abs() > self.energy_drift.abs() {
            self.energy_drift = residual;
        }
        residual
    }
}

/// Largest value; zero for none.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// What the metal suffered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Metal {
    /// Largest plastic strain.
    pub max_plastic_strain: f64,
    /// Its distance from the axis and depth below the undeformed surface, m; not a number where nothing yielded.
    pub place: Vec2,
    /// Plastic work, J.
    pub plastic_work: f64,
    /// Volume that yielded, m3.
    pub plastic_volume: f64,
    /// Largest depth of the surface below its undeformed place relative to its rim (elastic part included), m.
    pub depth: f64,
}

impl Metal {
    /// Of a solid as it is now.
    #[must_use]
    pub fn of(s: &Solid) -> Self {
        let strain = &s.state.plastic_strain;
        let worst = (0..s.len())
            .max_by(|&a, &b| strain[a].total_cmp(&strain[b]))
            .unwrap_or(0);
        let at = s.reference.position[worst];
        let place = [at[0], s.block.upper[1] - at[1]];
        let volume = &s.reference.volume;
        Self {
            max_plastic_strain: strain[worst],
            place: if strain[worst] > YIELDED {
                place
            } else {
                [f64::NAN; 2]
            },
            plastic_work: absorbed_energy(&s.state.plastic_work, volume),
            plastic_volume: plastic_volume(strain, volume, YIELDED),
            depth: pit_depth(s),
        }
    }
}

/// Force that the solid puts on its indenter upwards, N (per metre in plane).
pub(crate) fn indenter_force(s: &Solid) -> f64 {
    -s.indenter_force()[1]
}

/// Depth of the deepest surface point below the mean of the outer third of the surface, what failed taken out, m.
fn pit_depth(s: &Solid) -> f64 {
    let Some(surface) = s.surface(Side::Top) else {
        return f64::NAN;
    };
    let sunk: Vec<f64> = (0..surface.position.len())
        .map(|j| {
            let height = if s.is_removed(surface.particle[j]) {
                ground(s, surface.reference_position[j][0], surface.width[j])
            } else {
                surface.position[j][1]
            };
            surface.reference_position[j][1] - height
        })
        .collect();
    let outer = &sunk[2 * sunk.len() / 3..];
    let rim = outer.iter().sum::<f64>() / outer.len() as f64;
    sunk.iter()
        .map(|d| d - rim)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Height of what is left in a column of the reference where the surface has failed, m.
fn ground(s: &Solid, column: f64, width: f64) -> f64 {
    (0..s.len())
        .filter(|&a| !s.is_removed(a))
        .filter(|&a| (s.reference.position[a][0] - column).abs() <= 0.5 * width)
        .map(|a| s.state.position[a][1] + 0.5 * s.reference.area[a].sqrt())
        .fold(s.block.lower[1], f64::max)
}

#[cfg(test)]
#[path = "monitor_tests.rs"]
mod tests;
