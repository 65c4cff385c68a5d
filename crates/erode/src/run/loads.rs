//! Loads on solids while a run goes on.

use super::RunError;
use crate::case::{Indenter, Loads, Ramp, Simulation};
use erode_sph::solid::{self, Side, Solid};
use erode_sph::world::{Body, World};

impl Ramp {
    /// Share of the full load and its rate (1/s) at a time, s.
    #[must_use]
    pub fn share(&self, time: f64) -> solid::Share {
        let passing = |begun: f64, duration: f64| {
            let ramp = solid::QuasiStatic {
                ramp: duration,
                hold: 0.0,
                damping: 0.0,
            };
            ramp.share((time - begun).max(0.0))
        };
        let top = self.start + self.rise + self.hold;
        if self.fall > 0.0 && time > top {
            let fallen = passing(top, self.fall);
            solid::Share {
                value: 1.0 - fallen.value,
                rate: -fallen.rate,
            }
        } else {
            passing(self.start, self.rise)
        }
    }
}

impl Indenter {
    /// Depth of its lowest point below the undeformed side at a time, m.
    #[must_use]
    pub fn depth_at(&self, time: f64) -> f64 {
        self.depth * self.ramp.share(time).value
    }

    /// It at a time, on a body whose upper side is at height `top`.
    fn placed(&self, top: f64, time: f64) -> solid::Indenter {
        let mut indenter = solid::Indenter::new(
            Side::Top,
            self.radius,
            [self.centre, top + self.radius - self.depth_at(time)],
        );
        indenter.velocity = [0.0, -self.depth * self.ramp.share(time).rate];
        indenter
    }
}

/// Puts the loads on a world at its start or after a checkpoint was read.
///
/// # Errors
/// If the indenter cannot press on its body.
pub(crate) fn prepare(world: &mut World, simulation: &Simulation) -> Result<(), RunError> {
    let time = world.time;
    if let Some(i) = &simulation.loads.indenter
        && let Some(s) = solid_of(world, &i.body)
    {
        s.indent(i.placed(s.block.upper[1], time))
            .map_err(|source| RunError::Solid {
                body: i.body.clone(),
                source,
            })?;
    }
    apply(world, &simulation.loads, time);
    Ok(())
}

/// Sets all loads as they are at `time`.
pub(crate) fn apply(world: &mut World, loads: &Loads, time: f64) {
    if let Some(i) = &loads.indenter
        && let Some(s) = solid_of(world, &i.body)
    {
        s.indenter = Some(i.placed(s.block.upper[1], time));
    }
    for (k, p) in loads.pressures.iter().enumerate() {
        let acting = |x: f64| -> f64 {
            // Where several act on one body they add up.
            (loads.pressures.iter().filter(|q| q.body == p.body))
                .map(|q| {
                    let share = q.ramp.map_or(1.0, |r| r.share(time).value);
                    share * q.gaussian.at(x - q.centre, time)
                })
                .sum()
        };
        let first = loads.pressures[..k].iter().all(|q| q.body != p.body);
        if first
            && let Some(s) = solid_of(world, &p.body)
            && let Some(top) = s.surface_mut(Side::Top)
        {
            top.push(|x| acting(x[0]));
        }
    }
}

/// Damps the solids over the step of `dt` (s) that ended now.
pub(crate) fn settle(world: &mut World, loads: &Loads, dt: f64) {
    let Some(settling) = loads.settling.filter(|s| world.time > s.start) else {
        return;
    };
    for named in &mut world.bodies {
        if let Body::Solid(s) = &mut named.body {
            s.damp(settling.damping, dt);
        }
    }
}

fn solid_of<'a>(world: &'a mut World, name: &str) -> Option<&'a mut Solid> {
    world
        .bodies
        .iter_mut()
        .filter(|b| b.name == name)
        .find_map(|b| match &mut b.body {
            Body::Solid(s) => Some(s),
            Body::Fluid(_) => None,
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_rises_holds_and_falls_without_jumps() {
        let ramp = Ramp {
            start: 1.0,
            rise: 2.0,
            hold: 1.0,
            fall: 4.0,
        };
        for (time, value) in [
            (0.0, 0.0),
            (1.0, 0.0),
            (2.0, 0.5),
            (3.0, 1.0),
            (3.9, 1.0),
            (6.0, 0.5),
            (9.0, 0.0),
        ] {
            assert!((ramp.share(time).value - value).abs() < 1e-12, "{time}");
        }
        for i in 0..1000 {
            let (t, e) = (0.01 * f64::from(i) + 0.003, 1e-6);
            let slope = (ramp.share(t + e).value - ramp.share(t - e).value) / (2.0 * e);
            assert!((slope - ramp.share(t).rate).abs() < 1e-6, "{t}");
        }
        let stays = Ramp { fall: 0.0, ..ramp };
        assert_eq!(stays.share(100.0).value, 1.0);
    }
}
