//! What a run of one bubble remembers, and its rows.

use crate::case::bubbles::{Piece, SingleBubble};
use erode_physics::bubble::{
    BubbleState, DenseStep, Driving, Energy, Event, EventKind, Ledger, Watch, bubble_pressure,
};
use serde::{Deserialize, Serialize};

/// Number of columns of `history.csv`.
pub(super) const WIDTH: usize = 13;
/// A row is added where the radius has changed by this factor since the last one: the end of a collapse is far shorter
/// than the interval of rows.
const CHANGE: f64 = 1.05;

/// Extremes and sums of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Record {
    /// Wall time before the last start, s.
    pub(super) wall_time: f64,
    /// Checkpoints at regular times so far.
    pub(super) checkpoints: u64,
    /// Rows at regular times so far, that at the start left out.
    pub(super) rows: u64,
    /// Time of the last row, s.
    pub(super) last_time: f64,
    /// Radius in the last row, m.
    pub(super) last_radius: f64,
    /// Total of the ledger at the start, J.
    pub(super) first_total: f64,
    /// Energies at the start that count as put in when they change, J.
    pub(super) first_stored: f64,
    /// Largest departure of the total, J.
    pub(super) worst: f64,
    /// Largest energy exchanged, J.
    pub(super) scale: f64,
    /// (radius m, time s).
    pub(super) largest: [f64; 2],
    /// (radius m, time s).
    pub(super) smallest: [f64; 2],
    /// Largest |dR/dt|, m/s.
    pub(super) largest_speed: f64,
    /// Whether the bubble has closed.
    pub(super) closed: bool,
}

impl Record {
    pub(super) fn at_start(bubble: &SingleBubble, state: &BubbleState) -> Self {
        let ambient = bubble.ambient_pressure.between(0.0, 0.0).at(0.0);
        let energy = state.energy(&bubble.liquid, &bubble.gas, &ambient);
        Self {
            wall_time: 0.0,
            checkpoints: 0,
            rows: 0,
            last_time: 0.0,
            last_radius: bubble.radius,
            first_total: energy.total(),
            first_stored: energy.potential + energy.gas,
            worst: 0.0,
            scale: energy.kinetic,
            largest: [bubble.radius, 0.0],
            smallest: [bubble.radius, 0.0],
            largest_speed: bubble.wall_velocity.abs(),
            closed: false,
        }
    }

    /// Error of the ledger over the largest energy exchanged.
    pub(super) fn drift(&self) -> f64 {
        self.worst / self.scale.max(f64::MIN_POSITIVE)
    }

    fn see(&mut self, time: f64, radius: f64, velocity: f64, energy: &Energy) {
        let off = energy.total() - self.first_total;
        if off.abs() > self.worst.abs() {
            self.worst = off;
        }
        let stored = (energy.potential + energy.gas - self.first_stored).abs();
        self.scale = self
            .scale
            .max(energy.kinetic)
            .max(stored)
            .max(energy.driven.abs());
        if radius > self.largest[0] {
            self.largest = [radius, time];
        }
        if radius < self.smallest[0] {
            self.smallest = [radius, time];
        }
        self.largest_speed = self.largest_speed.max(velocity.abs());
    }
}

/// A row of `history.csv` for a state.
pub(super) fn row(
    bubble: &SingleBubble,
    piece: &Piece,
    state: &BubbleState,
    record: &Record,
) -> [f64; WIDTH] {
    let l = &state.ledger;
    let values = [
        state.radius,
        state.wall_velocity,
        l.viscous,
        l.radiated,
        l.driven,
    ];
    line(bubble, piece, state.time, 0.0, &values, record.first_total).0
}

fn line(
    bubble: &SingleBubble,
    piece: &Piece,
    time: f64,
    dt: f64,
    values: &[f64; 5],
    first_total: f64,
) -> ([f64; WIDTH], Energy) {
    let [radius, velocity, viscous, radiated, driven] = *values;
    let ambient = piece.at(time);
    let ledger = Ledger {
        viscous,
        radiated,
        driven,
    };
    let e = Energy::new(
        &bubble.liquid,
        &bubble.gas,
        &ambient,
        radius,
        velocity,
        &ledger,
    );
    let inside = bubble_pressure(&bubble.liquid, &bubble.gas, radius);
    let row = [
        time,
        dt,
        radius,
        velocity,
        inside,
        ambient.pressure,
        e.kinetic,
        e.potential,
        e.gas,
        e.viscous,
        e.radiated,
        e.driven,
        e.total() - first_total,
    ];
    (row, e)
}

/// Turns steps and events into rows.
pub(super) struct Recorder<'a> {
    bubble: &'a SingleBubble,
    piece: &'a Piece,
    every: f64,
    record: &'a mut Record,
    rows: Vec<[f64; WIDTH]>,
    events: Vec<[f64; 5]>,
}

impl<'a> Recorder<'a> {
    pub(super) fn new(
        bubble: &'a SingleBubble,
        piece: &'a Piece,
        every: f64,
        record: &'a mut Record,
    ) -> Self {
        Self {
            bubble,
            piece,
            every,
            record,
            rows: Vec::new(),
            events: Vec::new(),
        }
    }

    /// Rows of `history.csv` and of `events.csv`.
    pub(super) fn finish(self) -> (Vec<[f64; WIDTH]>, Vec<[f64; 5]>) {
        (self.rows, self.events)
    }

    fn add(&mut self, time: f64, dt: f64, values: &[f64; 5]) {
        // A row may be due for two reasons at once.
        if time <= self.record.last_time {
            return;
        }
        let (row, energy) = line(
            self.bubble,
            self.piece,
            time,
            dt,
            values,
            self.record.first_total,
        );
        self.record.see(time, values[0], values[1], &energy);
        self.record.last_radius = values[0];
        self.record.last_time = time;
        self.rows.push(row);
    }

    /// A row for the end of the run.
    pub(super) fn end(&mut self, state: &BubbleState) {
        let l = &state.ledger;
        let values = [
            state.radius,
            state.wall_velocity,
            l.viscous,
            l.radiated,
            l.driven,
        ];
        self.add(state.time, state.next_step, &values);
    }

    /// Time of the next regular row.
    fn next(&self) -> f64 {
        // Counts stay far below 2^53.
        #[allow(clippy::cast_precision_loss)]
        let number = (self.record.rows + 1) as f64;
        number * self.every
    }
}

impl Watch for Recorder<'_> {
    const STEPS: bool = true;

    fn step(&mut self, step: &DenseStep) {
        let dt = step.end_time() - step.start_time();
        while self.next() <= step.end_time() {
            let time = self.next();
            self.add(time, dt, &step.at(time));
            self.record.rows += 1;
        }
        let end = step.at_fraction(1.0);
        let change = end[0] / self.record.last_radius;
        let changed = !(1.0 / CHANGE..=CHANGE).contains(&change);
        if changed {
            self.add(step.end_time(), dt, &end);
        }
        let (_, energy) = line(self.bubble, self.piece, step.end_time(), dt, &end, 0.0);
        self.record.see(step.end_time(), end[0], end[1], &energy);
    }

    fn event(&mut self, event: &Event) {
        let largest = f64::from(u8::from(event.kind == EventKind::CollapseBegins));
        self.events.push([
            event.time,
            largest,
            event.radius,
            event.bubble_pressure,
            event.ambient_pressure,
        ]);
    }
}
