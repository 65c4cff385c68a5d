//! A quantity over two axes (pressure over time and radius) as a coloured map.

use super::colour::{Bar, Colouring, draw_bar};
use super::frame::{Axis, Frame, Span};
use super::raster::data_uri;
use super::svg::{Anchor, LABEL_SIZE, Svg};

/// A map of values on a grid whose lines need not be evenly spaced.
#[derive(Debug, Clone)]
pub struct Map<'a> {
    /// Text above the map.
    pub title: String,
    /// Horizontal axis and the increasing places of the columns, SI.
    pub x: (Axis, &'a [f64]),
    /// Vertical axis and the increasing places of the rows, SI.
    pub y: (Axis, &'a [f64]),
    /// `values[row][column]`; NaN stays white.
    pub values: &'a [Vec<f64>],
    /// How values become colours.
    pub colouring: Colouring,
    /// Width and height of the drawing, pixels.
    pub size: [f64; 2],
}

const LEFT: f64 = 72.0;
/// Height above the picture with and without title.
const TOPS: [f64; 2] = [30.0, 14.0];
const BARS: f64 = 104.0;
const BOTTOM: f64 = 48.0;

impl Map<'_> {
    /// The map as SVG text with an embedded PNG.
    pub fn to_svg(&self) -> String {
        let top = TOPS[usize::from(self.title.is_empty())];
        let [width, height] = [self.size[0] - LEFT - BARS, self.size[1] - top - BOTTOM];
        let mut svg = Svg::new(self.size[0], self.size[1], &self.title);
        svg.bold_text(
            [LEFT, top - 10.0],
            Anchor::Start,
            LABEL_SIZE + 1.0,
            &self.title,
        );
        let frame = Frame {
            left: LEFT,
            top,
            width,
            height,
            x: span(&self.x),
            y: span(&self.y),
        };
        let uri = self.pixels(width as usize, height as usize, &frame);
        svg.image(LEFT, top, width, height, &uri);
        frame.draw_axes(&mut svg);
        let bar = Bar {
            left: LEFT + width + 14.0,
            top: top + 10.0,
            height: height - 20.0,
            beyond: self.beyond(),
        };
        draw_bar(&mut svg, bar, &self.colouring);
        svg.finish()
    }

    fn pixels(&self, width: usize, height: usize, frame: &Frame) -> String {
        let at = |span: &Span, k: usize, count: usize| {
            span.low + (k as f64 + 0.5) / count as f64 * (span.high - span.low)
        };
        let columns: Vec<usize> = (0..width)
            .map(|k| nearest(self.x.1, at(&frame.x, k, width)))
            .collect();
        let mut rgb = Vec::with_capacity(3 * width * height);
        for k in (0..height).rev() {
            let row = nearest(self.y.1, at(&frame.y, k, height));
            for column in &columns {
                let value = self
                    .values
                    .get(row)
                    .and_then(|r| r.get(*column))
                    .copied()
                    .unwrap_or(f64::NAN);
                let white = value.is_nan();
                rgb.extend(if white {
                    [255; 3]
                } else {
                    self.colouring.colour(value)
                });
            }
        }
        data_uri(width, height, &rgb)
    }

    fn beyond(&self) -> [bool; 2] {
        let [low, high] = self.colouring.range;
        let values = || self.values.iter().flatten();
        [values().any(|v| *v < low), values().any(|v| *v > high)]
    }
}

fn span((axis, places): &(Axis, &[f64])) -> Span {
    let ends = [
        places.first().copied().unwrap_or(0.0),
        places.last().copied().unwrap_or(1.0),
    ];
    let range = axis.range.unwrap_or(if ends[1] > ends[0] {
        ends
    } else {
        [ends[0] - 0.5, ends[0] + 0.5]
    });
    Span::new(&axis.clone().with_range(range[0], range[1]), range, 0.0)
}

/// Index of the place nearest to `value`; `places` increase.
pub(crate) fn nearest(places: &[f64], value: f64) -> usize {
    let after = places.partition_point(|p| *p < value);
    if after == 0 {
        return 0;
    }
    if after == places.len() || value - places[after - 1] <= places[after] - value {
        after - 1
    } else {
        after
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_place() {
        let places = [0.0, 1.0, 4.0];
        assert_eq!(
            [-1.0, 0.4, 0.6, 2.4, 2.6, 9.0].map(|v| nearest(&places, v)),
            [0, 0, 1, 1, 2, 2]
        );
        assert_eq!(nearest(&[], 1.0), 0);
    }
}
