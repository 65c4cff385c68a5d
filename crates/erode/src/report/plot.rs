//! Line plots as SVG: several curves with legend, engineering units, marked instants; linear and logarithmic axes.
//!
//! ```
//! use erode::report::plot::{Axis, Plot};
//! let svg = Plot::new(Axis::new("time", "s"), Axis::new("pressure", "Pa"))
//!     .titled("Pressure at the wall")
//!     .line("simulation", vec![[0.0, 0.0], [1e-6, 5e7], [2e-6, 2e7]])
//!     .dashed("reference", vec![[0.0, 0.0], [1e-6, 4.8e7]])
//!     .event(1e-6, "wave arrives")
//!     .to_svg();
//! assert!(svg.contains("time [µs]") && svg.contains("pressure [MPa]"));
//! ```

use std::path::Path;

pub use super::frame::Axis;
use super::frame::{Frame, Span};
use super::svg::{Anchor, LABEL_SIZE, Svg, TICK_SIZE, text_width};
use super::thin::thinned;
use super::{ReportError, write_file};

/// Colours of curves; the first seven are told apart also by colour-blind readers (Okabe and Ito 2008, "Color universal
/// design").
pub const COLOURS: [&str; 9] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#222222", "#8c564b",
    "#999999",
];

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A solid line.
    Line,
    /// A dashed line (references and theory).
    Dashed,
    /// Dots.
    Points,
}

/// One curve: points in SI, NaN where there is nothing.
#[derive(Debug, Clone)]
pub struct Series {
    /// What the legend says; empty for no entry.
    pub label: String,
    /// (x, y) in SI units of the axes.
    pub points: Vec<[f64; 2]>,
    /// Line, dashes or dots.
    pub style: Style,
    /// Colour as in CSS; chosen from [`COLOURS`] where `None`.
    pub colour: Option<String>,
}

/// A line plot.
#[derive(Debug, Clone)]
pub struct Plot {
    title: String,
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    events: Vec<(f64, String)>,
    size: [f64; 2],
}

impl Plot {
    /// An empty plot of 560 x 360 pixels.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            title: String::new(),
            x,
            y,
            series: Vec::new(),
            events: Vec::new(),
            size: [560.0, 360.0],
        }
    }

    /// Sets the title above the plot.
    pub fn titled(mut self, title: &str) -> Self {
        self.title = title.to_string();
        self
    }

    /// Sets width and height in pixels.
    pub fn sized(mut self, width: f64, height: f64) -> Self {
        self.size = [width, height];
        self
    }

    /// Adds a curve.
    pub fn series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a solid curve.
    pub fn line(self, label: &str, points: Vec<[f64; 2]>) -> Self {
        self.styled(label, points, Style::Line)
    }

    /// Adds a dashed curve.
    pub fn dashed(self, label: &str, points: Vec<[f64; 2]>) -> Self {
        self.styled(label, points, Style::Dashed)
    }

    /// Adds dots.
    pub fn points(self, label: &str, points: Vec<[f64; 2]>) -> Self {
        self.styled(label, points, Style::Points)
    }

    fn styled(self, label: &str, points: Vec<[f64; 2]>, style: Style) -> Self {
        self.series(Series {
            label: label.to_string(),
            points,
            style,
            colour: None,
        })
    }

    /// Marks an x value (SI) by a vertical line with a text.
    pub fn event(mut self, x: f64, label: &str) -> Self {
        self.events.push((x, label.to_string()));
        self
    }

    /// Writes the plot as an SVG file.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), ReportError> {
        write_file(path, self.to_svg().as_bytes())
    }

    /// The plot as SVG text.
    pub fn to_svg(&self) -> String {
        let [width, height] = self.size;
        let mut svg = Svg::new(width, height, &self.title);
        let left = 72.0;
        let right = 18.0;
        let mut top = 10.0;
        if !self.title.is_empty() {
            svg.bold_text(
                [left, top + 11.0],
                Anchor::Start,
                LABEL_SIZE + 1.0,
                &self.title,
            );
            top += 22.0;
        }
        top = self.draw_legend(&mut svg, left, top, width - right);
        let frame = Frame {
            left,
            top,
            width: width - left - right,
            height: height - top - 48.0,
            x: Span::new(&self.x, self.bounds(0), 0.0),
            y: Span::new(&self.y, self.bounds(1), 0.06),
        };
        frame.draw_grid(&mut svg);
        self.draw_data(&mut svg, &frame);
        self.draw_events(&mut svg, &frame);
        frame.draw_axes(&mut svg);
        svg.finish()
    }

    /// Smallest and largest shown value along one axis; only points with a place on both axes count.
    fn bounds(&self, axis: usize) -> [f64; 2] {
        let fits = |a: &Axis, v: f64| v.is_finite() && !(a.log && v <= 0.0);
        let inside = |a: &Axis, v: f64| {
            fits(a, v) && a.range.is_none_or(|[low, high]| low <= v && v <= high)
        };
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
        for point in self.series.iter().flat_map(|s| &s.points) {
            if inside(&self.x, point[0]) && fits(&self.y, point[1]) {
                bounds[0] = bounds[0].min(point[axis]);
                bounds[1] = bounds[1].max(point[axis]);
            }
        }
        bounds
    }

    fn colour(&self, index: usize) -> &str {
        self.series[index]
            .colour
            .as_deref()
            .unwrap_or(COLOURS[index % COLOURS.len()])
    }

    /// Legend entries in rows above the plot, where they hide nothing; returns the y where the plot starts.
    fn draw_legend(&self, svg: &mut Svg, left: f64, top: f64, right: f64) -> f64 {
        let mut x = left;
        let mut y = top;
        let mut drawn = false;
        for (index, series) in self
            .series
            .iter()
            .enumerate()
            .filter(|(_, s)| !s.label.is_empty())
        {
            let width = 32.0 + text_width(&series.label, TICK_SIZE);
            if x > left && x + width > right {
                x = left;
                y += 17.0;
            }
            let middle = y + 7.0;
            let colour = self.colour(index);
            match series.style {
                Style::Points => svg.dot([x + 11.0, middle], 3.5, colour),
                Style::Line => svg.curve(&[[x, middle], [x + 22.0, middle]], colour, 2.2, ""),
                Style::Dashed => svg.curve(&[[x, middle], [x + 22.0, middle]], colour, 2.2, "6 4"),
            }
            svg.text(
                [x + 27.0, y + 11.0],
                Anchor::Start,
                TICK_SIZE,
                &series.label,
            );
            x += width + 10.0;
            drawn = true;
        }
        if drawn { y + 22.0 } else { y + 4.0 }
    }

    fn draw_data(&self, svg: &mut Svg, frame: &Frame) {
        svg.begin_clip(frame.left, frame.top, frame.width, frame.height);
        for (index, series) in self.series.iter().enumerate() {
            let placed: Vec<[f64; 2]> = series.points.iter().map(|p| frame.place(*p)).collect();
            let colour = self.colour(index);
            match series.style {
                Style::Points => {
                    for point in placed
                        .iter()
                        .filter(|p| p[0].is_finite() && p[1].is_finite())
                    {
                        svg.dot(*point, if placed.len() > 150 { 2.0 } else { 3.0 }, colour);
                    }
                }
                Style::Line => svg.curve(&thinned(&placed), colour, 1.8, ""),
                Style::Dashed => svg.curve(&thinned(&placed), colour, 1.8, "6 4"),
            }
        }
        svg.end_clip();
    }

    /// Vertical lines; where two are too close for both texts, the later text goes to the next free place rightwards.
    fn draw_events(&self, svg: &mut Svg, frame: &Frame) {
        let mut events: Vec<&(f64, String)> = self.events.iter().collect();
        events.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut free_from = frame.left;
        for (value, label) in events {
            let part = frame.x.part(*value);
            if !(0.0..=1.0).contains(&part) {
                continue;
            }
            let x = frame.left + part * frame.width;
            svg.dashed_line([x, frame.top], [x, frame.top + frame.height], "#777", "3 3");
            let baseline = (x - 4.0).max(free_from + 12.0);
            svg.upright_text(
                [baseline, frame.top + 6.0],
                Anchor::End,
                TICK_SIZE - 0.5,
                label,
            );
            free_from = baseline + 2.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_without_data_is_still_a_plot() {
        let svg = Plot::new(Axis::new("time", "s"), Axis::new("p", "Pa").logarithmic())
            .line("none", Vec::new())
            .to_svg();
        assert!(svg.starts_with("<svg") && svg.ends_with("</svg>"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn a_known_point_lies_where_the_axes_say() {
        let plot = Plot::new(
            Axis::new("x", "-").with_range(0.0, 10.0),
            Axis::new("y", "-").with_range(0.0, 10.0),
        )
        .line("", vec![[0.0, 0.0], [10.0, 10.0], [5.0, 5.0]]);
        // Frame: x from 72 to 542, y from 14 to 312.
        assert!(
            plot.to_svg().contains("M72 312L542 14L307 163"),
            "{}",
            plot.to_svg()
        );
    }
}
