//! Volume and equivalent radius of the bubble against time, with Rayleigh's collapse.

use crate::report::html::Page;
use crate::report::instants::{ARRIVED, Instants};
use crate::report::lookup::{self, Found};
use crate::report::plot::{Axis, Plot};
use crate::report::rayleigh::{collapse_curve, collapse_time};
use crate::report::run_data::RunData;
use crate::report::units::quantity;

/// Writes the section.
pub(crate) fn write(page: &mut Page, data: &RunData, instants: &Instants) {
    page.section("Bubble");
    let (Some(volume), Some(radius)) = (
        data.history_points("bubble_volume"),
        data.history_points("bubble_radius"),
    ) else {
        page.absent(
            "No bubble was recorded: history.csv has no columns bubble_volume and bubble_radius.",
        );
        return;
    };
    if !volume.iter().any(|p| p[1] > 0.0) {
        page.absent("This run has no bubble.");
        return;
    }
    let theory = Theory::of(data, instants, &radius);
    let mut volumes = Plot::new(Axis::new("time", "s"), Axis::new("bubble volume", "m3"))
        .line("this run", volume);
    let mut radii = Plot::new(Axis::new("time", "s"), Axis::new("equivalent radius", "m"))
        .line("this run", radius);
    if let Some(theory) = &theory {
        let sphere = |p: &[f64; 2]| [p[0], 4.0 / 3.0 * std::f64::consts::PI * p[1].powi(3)];
        volumes = volumes.dashed("Rayleigh", theory.curve.iter().map(sphere).collect());
        radii = radii.dashed("Rayleigh", theory.curve.clone());
    }
    for (time, name) in instants.named() {
        volumes = volumes.event(time, name);
        radii = radii.event(time, name);
    }
    let about = theory.map_or_else(
        || {
            "Rayleigh's curve is left out: the driving pressure is not in the run folder."
                .to_string()
        },
        |t| t.words,
    );
    let mut figures = vec![
        (volumes.to_svg(), "Volume of the bubble.".to_string()),
        (
            radii.to_svg(),
            format!("Radius of the sphere of the same volume. {about}"),
        ),
    ];
    figures.extend(MORE.iter().filter_map(|(name, label, unit, caption)| {
        let points = data
            .history_points(name)
            .filter(|points| points.iter().any(|p| p[1].is_finite()))?;
        let plot = Plot::new(Axis::new("time", "s"), Axis::new(label, unit)).line("", points);
        let plot = instants
            .named()
            .into_iter()
            .fold(plot, |plot, (time, name)| plot.event(time, name));
        Some((plot.to_svg(), (*caption).to_string()))
    }));
    page.figures(&figures);
}

/// Column, axis label, unit and caption of curves that are shown where they were recorded.
const MORE: [(&str, &str, &str, &str); 3] = [
    (
        "gas_pressure",
        "pressure of the gas",
        "Pa",
        "Pressure of the gas in the largest piece of the bubble.",
    ),
    (
        "jet_speed",
        "speed towards the wall",
        "m/s",
        "Speed of the liquid at the far side of the bubble on the axis, until the jet crosses the bubble.",
    ),
    (
        "max_pressure",
        "largest pressure",
        "Pa",
        "Largest pressure anywhere in the liquid.",
    ),
];

struct Theory {
    curve: Vec<[f64; 2]>,
    words: String,
}

impl Theory {
    /// Rayleigh's collapse from the first recorded radius, begun when the wave arrives.
    fn of(data: &RunData, instants: &Instants, radius: &[[f64; 2]]) -> Option<Self> {
        let start = radius.first()?[1];
        let pressure = lookup::driving_pressure(data)?;
        let Found {
            value: density,
            assumed,
        } = lookup::liquid_density(data);
        let curve = collapse_curve(start, pressure, density, 400);
        let lost = time_of(&curve, ARRIVED.cbrt() * start)?;
        let (begin, placed) = match instants.arrival {
            Some(arrival) => (
                arrival - lost,
                "placed so that both have lost 0.1 % of the volume at the same time",
            ),
            None => (0.0, "begun at the start of the run"),
        };
        let end = radius.last()?[0];
        let curve: Vec<[f64; 2]> = curve
            .into_iter()
            .map(|p| [p[0] + begin, p[1]])
            .take_while(|p| p[0] <= end)
            .collect();
        let words = format!(
            "Rayleigh: empty sphere in an unbounded incompressible liquid at {}, density {}{}; collapse in {}, {placed}. \
             It knows no wall, wave or jet: it shows the scale of time.",
            quantity(pressure, "Pa"),
            quantity(density, "kg/m3"),
            if assumed { " (assumed)" } else { "" },
            quantity(collapse_time(start, pressure, density), "s"),
        );
        (start > 0.0 && pressure > 0.0).then_some(Self { curve, words })
    }
}

/// When a falling curve reaches a radius, between its points.
fn time_of(curve: &[[f64; 2]], radius: f64) -> Option<f64> {
    let pair = curve.windows(2).find(|pair| pair[1][1] <= radius)?;
    let share = (pair[0][1] - radius) / (pair[0][1] - pair[1][1]);
    Some(pair[0][0] + share * (pair[1][0] - pair[0][0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_is_found_between_the_points() {
        let curve = [[0.0, 1.0], [2.0, 0.5], [3.0, 0.0]];
        assert_eq!(time_of(&curve, 0.75), Some(1.0));
        assert_eq!(time_of(&curve, -1.0), None);
    }
}
