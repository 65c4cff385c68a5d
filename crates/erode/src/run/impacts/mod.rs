//! Repeated impacts: one bubble after the other next to the same wall, which settles in between.
//!
//! ```text
//! impact:   liquid with its bubble and wall together, as in a run of a single bubble, until its time is over
//! settling: the liquid is taken away; the wall alone, free of pressure, with mass damping, until next to no motion is left;
//!           its absorbing sides absorb for the first transit of a wave, then they are free
//! next:     what still moves is stopped, the wall put back by what it drifted as a whole, a new liquid laid on its surface
//! ```
//!
//! Deformation, plastic strain, damage, temperature and losses of the wall go on. What leaves with a liquid, and what damping
//! takes out, is in the ledger.

mod incubation;
mod liquid;
mod results;
mod table;

pub(super) use results::{add, last};

use super::course::Course;
use super::metal::Metal;
use super::monitor::{self, Record, solid};
use super::observer::Stage as Seen;
use super::steps::Run;
use super::{RunError, build, gas};
use crate::analysis::absorbed_energy;
use crate::case::{BodyKind, Impact, Impacts, Simulation};
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Side, Solid};
use erode_sph::world::{Body, World};
use serde::{Deserialize, Serialize};
use table::Row;

/// What is going on in a sequence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Stage {
    /// A bubble collapses.
    Impact,
    /// The wall comes to rest.
    Settling,
    /// All impacts are over.
    Over,
}

/// Where a sequence stands: part of a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct State {
    stage: Stage,
    /// The impact in progress, or the last one; its numbers as far as they are known.
    row: Row,
    /// Impacts that are over.
    rows: Vec<Row>,
    /// When the liquid was taken away, s.
    impact_end: f64,
    /// Surface of the wall when the impact began, m; empty while it was flat.
    surface: Vec<Vec2>,
    /// Kinetic energy of the wall now and its largest in this impact, J.
    kinetic: f64,
    largest_kinetic: f64,
    /// Since when it has been small, s.
    quiet_since: Option<f64>,
    /// Energy that damping had taken out when settling began, J.
    damped: f64,
    /// Plastic work when the impact began, J.
    worked: f64,
}

/// A sequence in progress.
pub(super) struct Sequence {
    base: Simulation,
    impacts: Impacts,
    pub(super) state: State,
}

/// The sequence of a case at its start, if it has one, and the simulation of the first impact; else the case as it is.
pub(super) fn begin(simulation: Simulation) -> (Simulation, Option<Sequence>) {
    let Some(impacts) = simulation.impacts.clone() else {
        return (simulation, None);
    };
    let state = State {
        stage: Stage::Impact,
        row: Row::default(),
        rows: Vec::new(),
        impact_end: 0.0,
        surface: Vec::new(),
        kinetic: 0.0,
        largest_kinetic: 0.0,
        quiet_since: None,
        damped: 0.0,
        worked: 0.0,
    };
    let mut sequence = Sequence {
        base: simulation,
        impacts,
        state,
    };
    let first = sequence.announce(1, 0.0);
    (first, Some(sequence))
}

/// Simulation, world and sequence of a run as it was when `state` was stored; their arrays are still to be set.
///
/// # Errors
/// If a body cannot be built, or the state is not one of this case.
pub(super) fn take_up(
    simulation: Simulation,
    state: &serde_json::Value,
) -> Result<(Simulation, World, Option<Sequence>), RunError> {
    let (first, sequence) = begin(simulation);
    let Some(mut sequence) = sequence else {
        let world = build::world(&first)?;
        return Ok((first, world, None));
    };
    sequence.state = serde_json::from_value(state.clone()).map_err(|e| {
        RunError::Checkpoint(format!("its sequence of impacts is not readable ({e})"))
    })?;
    let now = sequence.simulation();
    let surface = &sequence.state.surface;
    let mut world = build::world_with(&now, |body, packing| {
        sequence.lay(&now, body, packing, surface);
    })?;
    if sequence.state.stage != Stage::Impact {
        world.take_out_liquids();
    }
    Ok((now, world, Some(sequence)))
}

impl Sequence {
    fn impact(&self) -> &Impact {
        &self.impacts.bubbles[self.state.row.impact - 1]
    }

    /// Begins the row of an impact; its simulation.
    fn announce(&mut self, number: usize, begin: f64) -> Simulation {
        self.state.row = Row {
            impact: number,
            begin_time: begin,
            ..Row::default()
        };
        let impact = *self.impact();
        let row = &mut self.state.row;
        row.radius = impact.radius;
        row.standoff = impact.standoff;
        row.driving_pressure = impact.driving_pressure;
        self.simulation()
    }

    /// The simulation of the impact and stage in progress.
    fn simulation(&self) -> Simulation {
        let mut s = liquid::simulation(&self.base, self.impact(), self.state.row.begin_time);
        if self.state.stage != Stage::Impact {
            s.run.end_time = self.state.impact_end + self.impacts.settling.longest;
        }
        s
    }

    /// Lays packed liquid on the wall.
    fn lay(
        &self,
        now: &Simulation,
        body: &crate::case::Body,
        packing: &mut erode_sph::packing::Packing,
        surface: &[Vec2],
    ) {
        if let (true, Some(bubble)) = (liquid::is_liquid(body), now.bubble) {
            let flat = body.shape.bounding_box().0[1];
            liquid::lay_on(packing, surface, flat, body.spacing.finest, &bubble);
        }
    }

    /// After a step of `dt`, s: damps the wall while it settles, and looks how much it still moves.
    pub(super) fn follow(&mut self, world: &mut World, dt: f64) {
        let settling = &self.impacts.settling;
        let time = world.time;
        let Some(wall) = solid_mut(world) else { return };
        let state = &mut self.state;
        if state.stage == Stage::Settling {
            wall.damp(settling.damping, dt);
            wall.open_sides(time - state.impact_end > wall.transit());
        }
        state.kinetic = wall.kinetic();
        state.largest_kinetic = state.largest_kinetic.max(state.kinetic);
        let quiet = state.kinetic <= settling.residual * state.largest_kinetic;
        state.quiet_since = quiet.then(|| state.quiet_since.unwrap_or(time));
    }

    /// Sides of the wall as they were at a checkpoint.
    pub(super) fn prepare(&self, world: &mut World) {
        let passed = world.time - self.state.impact_end;
        if let (Stage::Settling, Some(wall)) = (self.state.stage, solid_mut(world)) {
            wall.open_sides(passed > wall.transit());
        }
    }

    /// Whether the wall has been quiet for as long as a wave needs through it: at a turning point it seems quiet too.
    pub(super) fn has_settled(&self, world: &World) -> bool {
        let window = solid(world).map_or(0.0, Solid::transit);
        let long_enough = |since: f64| world.time - since >= window;
        self.state.stage == Stage::Settling && self.state.quiet_since.is_some_and(long_enough)
    }

    pub(super) fn is_over(&self) -> bool {
        self.state.stage == Stage::Over
    }

    pub(super) fn is_settling(&self) -> bool {
        self.state.stage == Stage::Settling
    }

    pub(super) fn is_last(&self) -> bool {
        self.state.row.impact == self.impacts.bubbles.len()
    }

    /// For progress.
    pub(super) fn seen(&self) -> Seen {
        Seen {
            impact: self.state.row.impact,
            impacts: self.impacts.bubbles.len(),
            settling: self.is_settling(),
        }
    }

    /// Simulated time at the end of all impacts as far as it can be foreseen, s: settling as long as it took so far.
    pub(super) fn end_time(&self, time: f64) -> f64 {
        let done = &self.state.rows;
        let s = &self.impacts.settling;
        let expected = if done.is_empty() {
            s.longest.min(-4.0 * s.residual.ln() / s.damping)
        } else {
            done.iter().map(|r| r.settling_time).sum::<f64>() / done.len() as f64
        };
        let number = self.state.row.impact;
        let later = self.impacts.bubbles[number..].iter();
        let later: f64 = later.map(|b| b.duration + expected).sum();
        let present = match self.state.stage {
            Stage::Impact => self.state.row.begin_time + self.impact().duration + expected,
            Stage::Settling => (self.state.impact_end + expected).max(time),
            Stage::Over => time,
        };
        present + later
    }
}

fn solid_mut(world: &mut World) -> Option<&mut Solid> {
    world.bodies.iter_mut().find_map(|b| match &mut b.body {
        Body::Solid(s) => Some(s),
        Body::Fluid(_) => None,
    })
}

impl Run {
    /// From one stage of a sequence to the next.
    ///
    /// # Errors
    /// If a liquid cannot be built or a file cannot be written.
    pub(super) fn next_stage(&mut self) -> Result<(), RunError> {
        let Some(mut sequence) = self.sequence.take() else {
            return Ok(());
        };
        let changed = match sequence.state.stage {
            Stage::Impact => {
                self.begin_settling(&mut sequence);
                Ok(())
            }
            Stage::Settling => self.end_settling(&mut sequence),
            Stage::Over => Ok(()),
        };
        self.sequence = Some(sequence);
        changed?;
        if !self.finished() {
            self.write_checkpoint()?;
        }
        Ok(())
    }

    fn begin_settling(&mut self, sequence: &mut Sequence) {
        self.record.mass_drift = self.record.largest_mass_drift(&self.world);
        let row = &mut sequence.state.row;
        row.bubble_volume = self.record.initial_volume;
        row.jet_speed = (self.record.jet_speed).filter(|_| self.record.jet_time.is_some());
        row.peak_wall_pressure = self.record.peak_wall_pressure[0];
        row.liquid_energy = self.world.take_out_liquids();
        let state = &mut sequence.state;
        state.stage = Stage::Settling;
        state.impact_end = self.world.time;
        state.quiet_since = None;
        state.damped = solid(&self.world).map_or(0.0, |s| s.state.work.damping);
        self.simulation = sequence.simulation();
    }

    fn end_settling(&mut self, sequence: &mut Sequence) -> Result<(), RunError> {
        let state = &mut sequence.state;
        let row = &mut state.row;
        row.time = self.world.time;
        row.settling_time = row.time - state.impact_end;
        row.settling_residual = if state.largest_kinetic > 0.0 {
            state.kinetic / state.largest_kinetic
        } else {
            0.0
        };
        if let Some(wall) = solid_mut(&mut self.world) {
            wall.stop();
            wall.open_sides(false);
            row.settling_energy = wall.state.work.damping - state.damped;
            row.wall_drift = drift(wall);
            wall.shift(row.wall_drift);
            see_wall(row, wall);
            row.absorbed_energy = row.plastic_work - state.worked;
            state.worked = row.plastic_work;
            state.surface = surface(wall);
        }
        state.kinetic = 0.0;
        state.largest_kinetic = 0.0;
        state.quiet_since = None;
        state.rows.push(state.row.clone());
        table::write(&self.files.paths().impacts(), &state.rows)?;
        if sequence.is_last() {
            sequence.state.stage = Stage::Over;
            return self.files.write_fields(&self.world);
        }
        self.begin_impact(sequence)
    }

    fn begin_impact(&mut self, sequence: &mut Sequence) -> Result<(), RunError> {
        sequence.state.stage = Stage::Impact;
        let number = sequence.state.row.impact + 1;
        self.simulation = sequence.announce(number, self.world.time);
        let now = &self.simulation;
        for (place, body) in now.bodies.iter().enumerate() {
            if let BodyKind::Fluid(_) = &body.kind {
                let lay = |packing: &mut _| {
                    sequence.lay(now, body, packing, &sequence.state.surface);
                };
                self.world.put_in(place, build::built(now, body, lay)?);
            }
        }
        gas::fill(&mut self.world, now)?;
        self.record.begin_impact();
        self.see_beginning();
        self.last = self.world.stable_time_step();
        self.write_row(0.0)?;
        self.files.write_fields(&self.world)
    }

    /// What the beginning of an impact has.
    pub(super) fn see_beginning(&mut self) {
        self.record.initial_mass =
            monitor::liquid(&self.world).map_or(0.0, |f| f.mass.iter().sum());
        if let Some(b) = &self.simulation.bubble {
            self.record.initial_volume = monitor::bubble(&self.world, b, self.cell).volume;
            self.record.smallest_volume = self.record.initial_volume;
        }
    }
}

impl Record {
    /// Forgets what belongs to one bubble.
    fn begin_impact(&mut self) {
        *self = Self {
            initial_balance: self.initial_balance,
            max_strain_rate: self.max_strain_rate,
            mass_drift: self.mass_drift,
            energy_scale: self.energy_scale,
            energy_drift: self.energy_drift,
            limiters: std::mem::take(&mut self.limiters),
            seconds: std::mem::take(&mut self.seconds),
            wall_time: self.wall_time,
            ..Self::default()
        };
    }
}

/// The wall's part of a row.
fn see_wall(row: &mut Row, wall: &Solid) {
    let metal = Metal::of(wall);
    let lost = wall.state.work.lost;
    row.max_plastic_strain = metal.max_plastic_strain;
    row.plastic_volume = metal.plastic_volume;
    row.plastic_work = absorbed_energy(&wall.state.plastic_work, &wall.reference.volume);
    row.pit_depth = metal.depth;
    row.max_damage = monitor::largest(&wall.state.damage);
    row.lost_mass = lost.mass;
    row.particles_failed = lost.failed;
    row.particles_loose = lost.loose;
}

/// How far a wall that nothing holds has sunk as a whole, m: the mean over the outer third of its surface.
fn drift(wall: &Solid) -> f64 {
    let Some(top) = wall.surface(Side::Top).filter(|_| wall.floats()) else {
        return 0.0;
    };
    let sunk: Vec<f64> = (top.reference_position.iter().zip(&top.position))
        .map(|(before, now)| before[1] - now[1])
        .collect();
    let outer = &sunk[2 * sunk.len() / 3..];
    outer.iter().sum::<f64>() / outer.len() as f64
}

/// Points of the wall's surface from the axis outwards, m.
fn surface(wall: &Solid) -> Vec<Vec2> {
    wall.surface(Side::Top)
        .map_or_else(Vec::new, |top| top.position.clone())
}
