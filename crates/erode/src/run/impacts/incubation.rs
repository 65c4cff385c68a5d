//! Incubation: how many impacts it takes until the first mass is lost.
//!
//! Reached within the sequence it is the number of the impact in which something was lost first. Otherwise it is estimated
//! with Miner's rule: N + (1 - D)/dD, D the largest damage after all N impacts, dD its mean rise over the last half of them.
//! Assumption: every further impact adds as much damage at the same place, as the last ones did.

use super::table::Row;

/// When mass is lost first, in impacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Incubation {
    /// Mass was lost first in this impact.
    Reached(usize),
    /// No mass was lost; Miner's rule says after so many impacts.
    Estimated(f64),
    /// No mass was lost, and damage does not grow.
    Unknown,
}

impl Incubation {
    /// From the rows of a sequence.
    pub(crate) fn of(rows: &[Row]) -> Self {
        if let Some(first) = rows.iter().find(|r| r.lost_mass > 0.0) {
            return Self::Reached(first.impact);
        }
        let Some(last) = rows.last() else {
            return Self::Unknown;
        };
        let earlier = rows.len() / 2;
        let before = earlier.checked_sub(1).map_or(0.0, |k| rows[k].max_damage);
        let rise = (last.max_damage - before) / (rows.len() - earlier) as f64;
        if rise > 0.0 {
            Self::Estimated(last.impact as f64 + (1.0 - last.max_damage) / rise)
        } else {
            Self::Unknown
        }
    }
}

/// Mass lost per impact from the first loss on, kg; none before it or with the first loss in the last impact.
pub(crate) fn loss_per_impact(rows: &[Row]) -> Option<f64> {
    let first = rows.iter().find(|r| r.lost_mass > 0.0)?;
    let last = rows.last().filter(|l| l.impact > first.impact)?;
    Some((last.lost_mass - first.lost_mass) / (last.impact - first.impact) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(damage: &[f64], lost: &[f64]) -> Vec<Row> {
        let row = |(k, (d, m)): (usize, (&f64, &f64))| Row {
            impact: k + 1,
            max_damage: *d,
            lost_mass: *m,
            ..Row::default()
        };
        damage.iter().zip(lost).enumerate().map(row).collect()
    }

    #[test]
    fn the_first_loss_is_the_end_of_incubation() {
        let rows = rows(&[0.6, 1.1, 1.7, 2.0], &[0.0, 2e-9, 5e-9, 9e-9]);
        assert_eq!(Incubation::of(&rows), Incubation::Reached(2));
        assert!((loss_per_impact(&rows).unwrap() / 3.5e-9 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn without_loss_damage_goes_on_as_in_the_last_half() {
        // A first impact that does more, then 0.05 each: 0.35 after four, 13 more to 1.
        let four = rows(&[0.2, 0.25, 0.3, 0.35], &[0.0; 4]);
        let Incubation::Estimated(n) = Incubation::of(&four) else {
            panic!("{four:?}")
        };
        assert!((n - 17.0).abs() < 1e-9);
        let one = rows(&[0.25], &[0.0]);
        assert_eq!(Incubation::of(&one), Incubation::Estimated(4.0));
        assert_eq!(loss_per_impact(&one), None);
    }

    #[test]
    fn without_damage_nothing_is_said() {
        assert_eq!(
            Incubation::of(&rows(&[0.0; 3], &[0.0; 3])),
            Incubation::Unknown
        );
        assert_eq!(
            Incubation::of(&rows(&[0.3, 0.3, 0.3], &[0.0; 3])),
            Incubation::Unknown
        );
        assert_eq!(Incubation::of(&[]), Incubation::Unknown);
    }
}
