//! Events of a bubble, placed between the two rows around them: they do not hang on how often rows are taken.

use super::bubble_state::BubbleState;
use super::monitor::{COLLAPSED, Record};
use serde::{Deserialize, Serialize};

/// The jet is read when the gap between the two walls of the bubble on the axis falls below this many initial radii: the
/// last values before the impact are those of one or two particles.
const JET_GAP: f64 = 0.2;

/// What the events are read from, at one row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Seen {
    /// s.
    time: f64,
    /// m3.
    volume: f64,
    /// m.
    gap: f64,
    /// m/s; none without a void on the axis.
    jet_speed: Option<f64>,
    /// m; none where the jet has none.
    jet_half_width: Option<f64>,
}

impl Seen {
    fn of(state: &BubbleState, time: f64) -> Self {
        let known = |x: f64| Some(x).filter(|x| x.is_finite());
        Self {
            time,
            volume: state.volume,
            gap: state.gap,
            jet_speed: known(state.jet_speed),
            jet_half_width: known(state.jet_half_width),
        }
    }
}

/// A value at a share of the way between two; the first where the second is not known.
fn mix(share: f64, before: Option<f64>, after: Option<f64>) -> Option<f64> {
    let before = before?;
    Some(after.map_or(before, |after| before + share * (after - before)))
}

/// Share of the way from `before` to `after` at which a falling number passes `level`; all of it where it was below already.
fn passage(before: f64, after: f64, level: f64) -> f64 {
    if before > level {
        (before - level) / (before - after)
    } else {
        1.0
    }
}

impl Record {
    /// Looks for events between the last row and this one, of a bubble with this `radius` at the start (m).
    pub(super) fn see_bubble(&mut self, state: &BubbleState, radius: f64, time: f64) {
        let now = Seen::of(state, time);
        let before = self.last_bubble.replace(now).unwrap_or(now);
        self.smallest_volume = self.smallest_volume.min(now.volume);
        let instant = |share: f64| before.time + share * (time - before.time);
        let collapsed = COLLAPSED * self.initial_volume;
        if self.collapsed.is_none() && now.volume < collapsed {
            self.collapsed = Some(instant(passage(before.volume, now.volume, collapsed)));
        }
        if self.jet_time.is_none() && time > 0.0 && now.gap < JET_GAP * radius {
            let share = passage(before.gap, now.gap, JET_GAP * radius);
            self.jet_time = Some(instant(share));
            self.jet_speed = mix(share, before.jet_speed, now.jet_speed).or(self.jet_speed);
            let width = mix(share, before.jet_half_width, now.jet_half_width);
            self.jet_half_width = width.or(self.jet_half_width);
        }
        if self.jet_time.is_none() && now.jet_speed.is_some() {
            self.jet_speed = now.jet_speed;
            self.jet_half_width = now.jet_half_width;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bubble of radius 1 whose gap closes with speed 1 and whose jet gains speed evenly: at a gap of 0.2 the time is 1.8 and
    /// the speed 3.6; its volume falls evenly from 4 to nothing at time 2.
    fn state(time: f64) -> BubbleState {
        BubbleState {
            volume: 4.0 - 2.0 * time,
            centre: 0.0,
            centre_r: 0.0,
            parts: 1,
            inner_radius: 0.0,
            gap: 2.0 - time,
            jet_speed: 2.0 * time,
            jet_half_width: f64::NAN,
        }
    }

    fn record(rows: &[f64]) -> Record {
        let mut record = Record {
            initial_volume: 4.0,
            ..Record::default()
        };
        for time in rows {
            record.see_bubble(&state(*time), 1.0, *time);
        }
        record
    }

    #[test]
    fn events_do_not_hang_on_the_rows() {
        for rows in [&[0.0, 1.0, 1.75, 1.99][..], &[0.0, 1.79, 1.81, 1.9, 1.97]] {
            let record = record(rows);
            let near = |x: Option<f64>, exact: f64| (x.unwrap() - exact).abs() < 1e-12;
            assert!(near(record.jet_time, 1.8), "{:?}", record.jet_time);
            assert!(near(record.jet_speed, 3.6), "{:?}", record.jet_speed);
            assert!(near(record.collapsed, 1.96), "{:?}", record.collapsed);
            assert_eq!(record.jet_half_width, None);
        }
    }

    #[test]
    fn a_jet_that_has_struck_keeps_the_speed_before() {
        let mut record = record(&[0.0, 1.0]);
        let struck = BubbleState {
            gap: 0.0,
            jet_speed: f64::NAN,
            ..state(1.5)
        };
        record.see_bubble(&struck, 1.0, 1.5);
        assert_eq!(record.jet_speed, Some(2.0));
        // The gap of 1 at time 1 is gone at 1.5: 0.2 of it are left at 1.4.
        assert!((record.jet_time.unwrap() - 1.4).abs() < 1e-12);
    }
}
