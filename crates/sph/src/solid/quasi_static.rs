//! Quasi-static loading with the true density: a smooth ramp, then a hold with mass damping.
//!
//! share(t) = x^3 (10 - 15 x + 6 x^2), x = t/ramp in [0, 1];  dv/dt = ... - damping v during the hold
//!
//! The quintic has no jump in velocity or acceleration at its ends, so a ramp of several wave transits through the body
//! excites almost no waves; the damping takes what is left. Whether inertia is negligible is measured: the kinetic energy
//! over the internal energy (elastic + plastic work) at the end. Units: s, 1/s.

use super::{Solid, SolidError};

/// A ramp and a hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuasiStatic {
    /// Time in which the load rises, s.
    pub ramp: f64,
    /// Time for which it is then held, s.
    pub hold: f64,
    /// Mass damping during the hold, 1/s.
    pub damping: f64,
}

/// How far a load has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Share of the full load.
    pub value: f64,
    /// Its rate, 1/s.
    pub rate: f64,
}

/// x^3 (10 - 15 x + 6 x^2) between 0 and 1, constant outside: no jump up to the second derivative.
#[must_use]
pub fn smoothstep(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * x * (10.0 - 15.0 * x + 6.0 * x * x)
}

impl QuasiStatic {
    /// Share of the load at a time after the start, s.
    #[must_use]
    pub fn share(&self, time: f64) -> Share {
        let x = (time / self.ramp).clamp(0.0, 1.0);
        let y = x * (1.0 - x);
        Share {
            value: smoothstep(x),
            rate: 30.0 * y * y / self.ramp,
        }
    }

    /// Brings a body from its present state to the full load: `load` applies a share before each step, `watch` sees the
    /// body after it.
    ///
    /// # Errors
    /// As [`Solid::step`].
    pub fn run(
        &self,
        solid: &mut Solid,
        mut load: impl FnMut(&mut Solid, Share),
        mut watch: impl FnMut(&Solid, Share),
    ) -> Result<(), SolidError> {
        let steps = ((self.ramp + self.hold) / solid.stable_time_step().dt).ceil();
        let dt = (self.ramp + self.hold) / steps;
        for step in 1..=steps as u64 {
            let time = step as f64 * dt;
            let share = self.share(time);
            load(solid, share);
            solid.step(dt)?;
            if time > self.ramp {
                solid.damp(self.damping, dt);
            }
            watch(solid, share);
        }
        Ok(())
    }
}

impl Solid {
    /// Mass damping over `dt` (s): velocities times exp(-rate dt). What it takes is in the ledger.
    pub fn damp(&mut self, rate: f64, dt: f64) {
        let factor = (-rate * dt).exp();
        let squares = self
            .state
            .velocity
            .iter()
            .map(|v| v[0] * v[0] + v[1] * v[1]);
        let kinetic: f64 = (squares.zip(&self.reference.mass))
            .map(|(v, m)| 0.5 * m * v)
            .sum();
        for v in self.state.velocity.iter_mut().flatten() {
            *v *= factor;
        }
        self.state.work.damping += kinetic * (1.0 - factor * factor);
    }

    /// Kinetic over internal energy (elastic + plastic work): far below 1 when inertia is negligible; 0 at rest.
    #[must_use]
    pub fn inertia_share(&self) -> f64 {
        let energy = self.energy();
        if energy.kinetic == 0.0 {
            return 0.0;
        }
        energy.kinetic / (energy.elastic + energy.plastic_work)
    }
}
