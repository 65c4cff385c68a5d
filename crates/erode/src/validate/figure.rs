//! Curves of a validation.

use crate::report::plot::{Axis, Plot};
use serde::Serialize;

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Style {
    /// What the program computes.
    Line,
    /// What it is compared with.
    Dashed,
    /// Single values.
    Points,
}

/// One curve.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// What the legend says.
    pub label: String,
    /// (x, y) in the units of the axes.
    pub points: Vec<[f64; 2]>,
    /// Line, dashes or dots.
    pub style: Style,
}

/// A figure with one pair of axes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figure {
    /// File name without ending.
    pub name: String,
    /// Title.
    pub title: String,
    /// Quantity and SI unit along x.
    pub x: (String, String),
    /// Quantity and SI unit along y.
    pub y: (String, String),
    /// Curves.
    pub curves: Vec<Curve>,
}

impl Figure {
    /// An empty figure; axes are (quantity, SI unit).
    pub(crate) fn new(name: &str, title: &str, x: (&str, &str), y: (&str, &str)) -> Self {
        let own = |(a, b): (&str, &str)| (a.to_owned(), b.to_owned());
        Self {
            name: name.into(),
            title: title.into(),
            x: own(x),
            y: own(y),
            curves: Vec::new(),
        }
    }

    /// Adds a curve.
    pub(crate) fn add(&mut self, label: &str, style: Style, points: Vec<[f64; 2]>) {
        self.curves.push(Curve {
            label: label.into(),
            points,
            style,
        });
    }

    /// The figure as SVG text.
    #[must_use]
    pub fn to_svg(&self) -> String {
        let axis = |(quantity, unit): &(String, String)| Axis::new(quantity, unit);
        let empty = Plot::new(axis(&self.x), axis(&self.y)).titled(&self.title);
        let drawn = self.curves.iter().fold(empty, |plot, c| {
            let points = c.points.clone();
            match c.style {
                Style::Line => plot.line(&c.label, points),
                Style::Dashed => plot.dashed(&c.label, points),
                Style::Points => plot.points(&c.label, points),
            }
        });
        drawn.to_svg()
    }
}
