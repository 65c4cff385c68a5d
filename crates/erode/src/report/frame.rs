//! The rectangle of a plot: what is where, ticks, grid and axis labels.

use super::svg::{Anchor, GRID, INK, LABEL_SIZE, Svg, TICK_SIZE, text_width};
use super::units::{Scale, decades, ticks};

/// One axis of a plot: a quantity, its SI unit and, if wanted, its range (SI) and a logarithmic division.
#[derive(Debug, Clone)]
pub struct Axis {
    /// The quantity in words.
    pub label: String,
    /// Its unit in SI (`s`, `Pa`, `-`, ...); the plot chooses the prefix.
    pub unit: String,
    /// Fixed range in SI; found from the data where `None`.
    pub range: Option<[f64; 2]>,
    /// Logarithmic division; values that are not positive are left out.
    pub log: bool,
}

impl Axis {
    /// A linear axis whose range follows the data.
    pub fn new(label: &str, unit: &str) -> Self {
        Self {
            label: label.to_string(),
            unit: unit.to_string(),
            range: None,
            log: false,
        }
    }

    /// The axis with a fixed range in SI.
    pub fn with_range(mut self, low: f64, high: f64) -> Self {
        self.range = Some([low, high]);
        self
    }

    /// The axis with a logarithmic division.
    pub fn logarithmic(mut self) -> Self {
        self.log = true;
        self
    }
}

/// An axis with its final range and scale.
#[derive(Debug, Clone)]
pub(crate) struct Span {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) log: bool,
    pub(crate) scale: Scale,
    pub(crate) label: String,
}

impl Span {
    /// The range of `axis` around `data` (`[smallest, largest]` in SI), with `margin` of the range added on each side.
    pub(crate) fn new(axis: &Axis, data: [f64; 2], margin: f64) -> Self {
        let [low, high] = axis.range.unwrap_or_else(|| padded(data, margin, axis.log));
        let scale = if axis.log {
            Scale {
                factor: 1.0,
                unit: axis.unit.clone(),
            }
        } else {
            Scale::for_magnitude(low.abs().max(high.abs()), &axis.unit)
        };
        let label = format!("{}{}", axis.label, scale.bracketed());
        Self {
            low,
            high,
            log: axis.log,
            scale,
            label,
        }
    }

    /// Position of an SI value along the axis, 0 at its low and 1 at its high end; NaN where a log axis has no place.
    pub(crate) fn part(&self, value: f64) -> f64 {
        if self.log {
            (value / self.low).log10() / (self.high / self.low).log10()
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    /// Tick positions (SI) and labels (shown units).
    pub(crate) fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.log {
            return decades(self.low, self.high);
        }
        let factor = self.scale.factor;
        ticks(self.low / factor, self.high / factor, count)
            .into_iter()
            .map(|(value, label)| (value * factor, label))
            .collect()
    }
}

/// Data range with margins; a single value gets a range around it, and zero is included when it is near.
fn padded([low, high]: [f64; 2], margin: f64, log: bool) -> [f64; 2] {
    if !(low.is_finite() && high.is_finite()) || low > high {
        return if log { [1.0, 10.0] } else { [0.0, 1.0] };
    }
    if log {
        let (low, high) = if high > low {
            (low, high)
        } else {
            (low / 3.0, high * 3.0)
        };
        return [low / 1.3, high * 1.3];
    }
    if high - low <= 1e-12 * high.abs().max(low.abs()) {
        return if high == 0.0 {
            [0.0, 1.0]
        } else {
            [low - 0.1 * low.abs(), high + 0.1 * high.abs()]
        };
    }
    let room = margin * (high - low);
    let near_zero = low >= 0.0 && low < 0.3 * high;
    [
        if near_zero { 0.0 } else { low - room },
        if high == 0.0 { 0.0 } else { high + room },
    ]
}

/// A plot rectangle in a drawing.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
    pub(crate) x: Span,
    pub(crate) y: Span,
}

impl Frame {
    /// Pixel position of a point in SI.
    pub(crate) fn place(&self, point: [f64; 2]) -> [f64; 2] {
        [
            self.left + self.x.part(point[0]) * self.width,
            self.top + (1.0 - self.y.part(point[1])) * self.height,
        ]
    }

    /// Grid lines behind the data.
    pub(crate) fn draw_grid(&self, svg: &mut Svg) {
        for (value, _) in self.x_ticks() {
            let x = self.place([value, self.y.low])[0];
            svg.line([x, self.top], [x, self.top + self.height], GRID, 1.0);
        }
        for (value, _) in self.y_ticks() {
            let y = self.place([self.x.low, value])[1];
            svg.line([self.left, y], [self.left + self.width, y], GRID, 1.0);
        }
    }

    /// Outline, ticks, tick labels and axis labels.
    pub(crate) fn draw_axes(&self, svg: &mut Svg) {
        let bottom = self.top + self.height;
        svg.frame(self.left, self.top, self.width, self.height);
        for (value, label) in self.x_ticks() {
            let x = self.place([value, self.y.low])[0];
            svg.line([x, bottom], [x, bottom + 5.0], INK, 1.0);
            svg.text([x, bottom + 18.0], Anchor::Middle, TICK_SIZE, &label);
        }
        for (value, label) in self.y_ticks() {
            let y = self.place([self.x.low, value])[1];
            svg.line([self.left - 5.0, y], [self.left, y], INK, 1.0);
            svg.text([self.left - 8.0, y + 4.0], Anchor::End, TICK_SIZE, &label);
        }
        svg.text(
            [self.left + 0.5 * self.width, bottom + 37.0],
            Anchor::Middle,
            LABEL_SIZE,
            &self.x.label,
        );
        let widest = self
            .y_ticks()
            .iter()
            .map(|(_, label)| text_width(label, TICK_SIZE))
            .fold(0.0, f64::max);
        let left = self.left - (widest + 16.0).max(46.0);
        let middle = self.top + 0.5 * self.height;
        svg.upright_text([left, middle], Anchor::Middle, LABEL_SIZE, &self.y.label);
    }

    fn x_ticks(&self) -> Vec<(f64, String)> {
        // A narrow picture has three at least.
        self.x.ticks((self.width / 80.0).max(3.0) as usize)
    }

    fn y_ticks(&self) -> Vec<(f64, String)> {
        self.y.ticks((self.height / 45.0) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_the_data() {
        assert_eq!(padded([0.1, 1.0], 0.05, false)[0], 0.0);
        let [low, high] = padded([5.0, 6.0], 0.05, false);
        assert!(low < 5.0 && high > 6.0);
        assert_eq!(
            padded([f64::INFINITY, f64::NEG_INFINITY], 0.05, false),
            [0.0, 1.0]
        );
        let [low, high] = padded([7.0, 7.0], 0.05, false);
        assert!(low < 7.0 && 7.0 < high);
        assert_eq!(padded([0.0, 0.0], 0.05, false), [0.0, 1.0]);
    }

    #[test]
    fn log_axis_places_decades_evenly() {
        let span = Span::new(
            &Axis::new("r", "m").with_range(1e-3, 1e1).logarithmic(),
            [1.0, 2.0],
            0.0,
        );
        assert!((span.part(1e-1) - 0.5).abs() < 1e-12);
        assert_eq!(span.label, "r [m]");
        assert!(span.part(0.0) == f64::NEG_INFINITY);
    }
}
