//! Values of a bubble at given times and radii, its events, and its energies.

use erode_physics::bubble::{DenseStep, Event, Watch};

/// Takes values of a bubble at given times, in order.
#[derive(Debug)]
pub(super) struct Sampler {
    times: Vec<f64>,
    /// Radius and wall velocity at each time that was reached.
    pub(super) values: Vec<[f64; 2]>,
    /// What happened.
    pub(super) events: Vec<Event>,
}

impl Sampler {
    /// A sampler at `times`, s, in rising order.
    pub(super) fn new(times: Vec<f64>) -> Self {
        Self {
            values: Vec::with_capacity(times.len()),
            times,
            events: Vec::new(),
        }
    }
}

impl Watch for Sampler {
    const STEPS: bool = true;

    fn step(&mut self, step: &DenseStep) {
        while let Some(&time) = self.times.get(self.values.len())
            && time <= step.end_time()
        {
            let [radius, velocity, ..] = step.at(time);
            self.values.push([radius, velocity]);
        }
    }

    fn event(&mut self, event: &Event) {
        self.events.push(*event);
    }
}
