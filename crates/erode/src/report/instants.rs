//! The instants of a bubble collapse that are worth a picture, found in the recorded curves.

use super::map::nearest;
use super::run_data::RunData;

/// Part of the volume at which the wave counts as arrived.
pub(crate) const ARRIVED: f64 = 0.999;

/// Instants of a run, s; `None` where the run does not have them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Instants {
    /// The bubble has lost 0.1 % of its volume: the wave has arrived. None where the bubble shrinks from the start.
    pub(crate) arrival: Option<f64>,
    /// The bubble has a quarter of its volume.
    pub(crate) quarter: Option<f64>,
    /// The jet closes the gap on the axis.
    pub(crate) jet: Option<f64>,
    /// The bubble is gone, or smallest.
    pub(crate) collapse: Option<f64>,
    /// The pressure at the wall is largest.
    pub(crate) impact: Option<f64>,
}

impl Instants {
    /// Finds the instants in history, wall pressure and summary.
    pub(crate) fn find(data: &RunData) -> Self {
        let volume = data.history_points("bubble_volume").unwrap_or_default();
        let start = volume.first().map_or(0.0, |p| p[1]);
        let end = volume.last().map_or(0.0, |p| p[0]);
        let falls_to = |share: f64| {
            volume
                .iter()
                .find(|p| start > 0.0 && p[1] <= share * start)
                .map(|p| p[0])
        };
        let smallest = volume
            .iter()
            .filter(|p| p[1].is_finite())
            .min_by(|a, b| a[1].total_cmp(&b[1]));
        let collapsed = smallest.filter(|p| p[1] < 0.2 * start).map(|p| p[0]);
        Self {
            arrival: falls_to(ARRIVED).filter(|time| *time > 0.03 * end),
            quarter: falls_to(0.25),
            jet: data.number("jet_time"),
            collapse: data.number("collapse_instant").or(collapsed),
            impact: largest_wall_pressure(data),
        }
    }

    /// The instants that exist, in words.
    pub(crate) fn named(&self) -> Vec<(f64, &'static str)> {
        let all = [
            (self.arrival, "wave arrives"),
            (self.quarter, "quarter volume"),
            (self.jet, "jet impact"),
            (self.collapse, "collapse"),
            (self.impact, "peak at the wall"),
        ];
        all.into_iter()
            .filter_map(|(time, name)| Some((time?, name)))
            .collect()
    }
}

fn largest_wall_pressure(data: &RunData) -> Option<f64> {
    let wall = data.wall.as_ref()?;
    let (time, radii) = wall.values.split_first()?;
    let row = |k: usize| {
        radii
            .iter()
            .map(|c| c[k])
            .filter(|p| p.is_finite())
            .fold(0.0, f64::max)
    };
    let peaks: Vec<f64> = (0..time.len()).map(row).collect();
    let (index, peak) = peaks.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1))?;
    (*peak > 0.0).then_some(time[index])
}

/// Which of the snapshots at `times` (increasing) to show: first and last, those nearest to the named instants, and
/// others in the widest gaps until there are `count`. Returns index and words for each.
pub(crate) fn choose(
    times: &[f64],
    named: &[(f64, &'static str)],
    count: usize,
) -> Vec<(usize, String)> {
    let Some(last) = times.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut chosen: Vec<(usize, String)> = vec![(0, "start".into())];
    for (time, name) in named.iter().filter(|(time, _)| *time <= times[last]) {
        add(&mut chosen, nearest(times, *time), name);
    }
    add(&mut chosen, last, "end");
    chosen.sort_by_key(|c| c.0);
    while chosen.len() < count.min(times.len()) {
        let gap = |pair: &[(usize, String)]| {
            if pair[1].0 - pair[0].0 > 1 {
                times[pair[1].0] - times[pair[0].0]
            } else {
                0.0
            }
        };
        let widest = chosen
            .windows(2)
            .enumerate()
            .max_by(|a, b| gap(a.1).total_cmp(&gap(b.1)).then(b.0.cmp(&a.0)));
        let Some((place, pair)) = widest.filter(|(_, pair)| pair[1].0 - pair[0].0 > 1) else {
            break;
        };
        let middle = nearest(times, 0.5 * (times[pair[0].0] + times[pair[1].0]));
        let between = middle.clamp(pair[0].0 + 1, pair[1].0 - 1);
        chosen.insert(place + 1, (between, String::new()));
    }
    chosen
}

fn add(chosen: &mut Vec<(usize, String)>, index: usize, name: &str) {
    match chosen.iter_mut().find(|c| c.0 == index) {
        Some(entry) => entry.1 = format!("{}, {name}", entry.1),
        None => chosen.push((index, name.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_instants_first_then_the_widest_gaps() {
        let times: Vec<f64> = (0..=20).map(f64::from).collect();
        let chosen = choose(&times, &[(9.2, "wave"), (9.4, "half"), (99.0, "never")], 5);
        let indices: Vec<usize> = chosen.iter().map(|c| c.0).collect();
        assert_eq!(indices, [0, 4, 9, 14, 20]);
        assert_eq!(chosen[2].1, "wave, half");
        assert_eq!(choose(&[0.0], &[], 6).len(), 1);
        assert_eq!(choose(&[0.0, 1.0, 2.0], &[], 6).len(), 3);
        assert!(choose(&[], &[(1.0, "x")], 6).is_empty());
    }
}
