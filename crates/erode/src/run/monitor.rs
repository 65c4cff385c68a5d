//! What is watched while a run goes on: the bubble (measured in `bubble_state.rs`), the metal (in `metal.rs`), the energy.

pub(super) use super::bubble_state::bubble;
use super::bubble_state::equivalent_radius;
use super::events::Seen;
use super::ledger::Ledger;
use super::metal::{Metal, indenter_force};
use crate::case::Simulation;
use crate::output::Column;
use erode_sph::fluid::Fluid;
use erode_sph::fluid::gas::Pocket;
use erode_sph::solid::{Side, Solid};
use erode_sph::world::{Body, World};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

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
    /// The bubble at the last row.
    #[serde(default)]
    pub last_bubble: Option<Seen>,
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

/// One row of `history.csv`; extremes go to the record.
pub(crate) fn row(
    world: &World,
    simulation: &Simulation,
    cell: f64,
    dt: f64,
    record: &mut Record,
) -> Vec<f64> {
    let mut values = vec![world.time, dt];
    // Side by side: neither of the two keeps all threads busy.
    let (state, (ledger, metal)) = rayon::join(
        || (simulation.bubble.as_ref()).map(|b| (b, bubble(world, b, cell))),
        || (Ledger::of(world), solid(world).map(|s| (s, Metal::of(s)))),
    );
    if let Some((b, state)) = state {
        record.see_bubble(&state, b.radius, world.time);
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
    values.extend([
        pressure,
        speed,
        ledger.liquid_kinetic + ledger.solid_kinetic,
    ]);
    if let Some((s, metal)) = metal {
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
