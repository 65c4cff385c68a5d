//! Pictures of particle fields: bodies coloured by a field each, mirrored about the axis, with colour bars.

use std::borrow::Cow;

use super::colour::{Bar, Colouring, draw_bar};
use super::frame::{Axis, Frame, Span};
use super::raster::{Raster, View};
use super::svg::{Anchor, LABEL_SIZE, Svg};

/// One body in a picture; the arrays have one entry per particle.
#[derive(Debug, Clone)]
pub struct Layer<'a> {
    /// (r, z), m.
    pub position: &'a [[f64; 2]],
    /// Spacing (square root of the area in the plane), m.
    pub size: &'a [f64],
    /// The field shown, SI.
    pub value: Cow<'a, [f64]>,
    /// How it is coloured.
    pub colouring: Colouring,
}

impl Layer<'_> {
    /// Whether particles in `view` have values below and above the colour range.
    fn beyond(&self, view: View) -> [bool; 2] {
        let mut beyond = [false; 2];
        let [low, high] = self.colouring.range;
        // Differences too small to be seen count as inside.
        let slack = 1e-6 * (high - low);
        for (position, value) in self.position.iter().zip(self.value.iter()) {
            if view.contains([position[0].abs(), position[1]]) {
                beyond[0] |= *value < low - slack;
                beyond[1] |= *value > high + slack;
            }
        }
        beyond
    }
}

/// A picture of one or more bodies at one instant.
#[derive(Debug, Clone)]
pub struct Picture<'a> {
    /// Text above the picture.
    pub title: String,
    /// What is seen.
    pub view: View,
    /// Particles are also drawn at -r.
    pub mirrored: bool,
    /// Bodies; where two overlap, the nearest particle is seen.
    pub layers: Vec<Layer<'a>>,
    /// Width of the drawing, pixels.
    pub width: f64,
    /// Text on the horizontal and vertical axis.
    pub axes: [&'static str; 2],
}

const LEFT: f64 = 68.0;
/// Height above the picture with and without title.
const TOPS: [f64; 2] = [30.0, 14.0];
const BARS: f64 = 104.0;
const BOTTOM: f64 = 46.0;
/// Pixels of the embedded picture per pixel of the drawing, so that it stays crisp on dense screens and in print.
const DENSITY: f64 = 1.5;

impl Picture<'_> {
    /// The picture as SVG text with an embedded PNG.
    pub fn to_svg(&self) -> String {
        let top = TOPS[usize::from(self.title.is_empty())];
        let width = self.width - LEFT - BARS;
        let raster = self.raster((width * DENSITY) as usize);
        let height = width * raster.height as f64 / raster.width as f64;
        let mut svg = Svg::new(self.width, top + height + BOTTOM, &self.title);
        svg.bold_text(
            [LEFT, top - 10.0],
            Anchor::Start,
            LABEL_SIZE + 1.0,
            &self.title,
        );
        svg.image(LEFT, top, width, height, &raster.data_uri());
        let axis = |label: &str, range: [f64; 2]| {
            let axis = Axis::new(label, "m").with_range(range[0], range[1]);
            Span::new(&axis, range, 0.0)
        };
        let frame = Frame {
            left: LEFT,
            top,
            width,
            height,
            x: axis(self.axes[0], self.view.r),
            y: axis(self.axes[1], self.view.z),
        };
        frame.draw_axes(&mut svg);
        self.draw_bars(&mut svg, &frame);
        svg.finish()
    }

    fn raster(&self, width: usize) -> Raster {
        let mut raster = Raster::new(self.view, width.max(1));
        for layer in &self.layers {
            for ((position, size), value) in layer
                .position
                .iter()
                .zip(layer.size)
                .zip(layer.value.iter())
            {
                let colour = layer.colouring.colour(*value);
                raster.splat(*position, *size, colour);
                if self.mirrored {
                    raster.splat([-position[0], position[1]], *size, colour);
                }
            }
        }
        raster.open_voids();
        raster
    }

    /// One bar per body with a labelled colouring, one above the other in the order of the layers.
    fn draw_bars(&self, svg: &mut Svg, frame: &Frame) {
        let labelled: Vec<&Layer> = self
            .layers
            .iter()
            .filter(|l| !l.colouring.label.is_empty())
            .collect();
        let count = labelled.len().max(1) as f64;
        let each = (frame.height - 26.0 * (count - 1.0)) / count;
        for (index, layer) in labelled.into_iter().enumerate() {
            let top = frame.top + index as f64 * (each + 26.0);
            // Arrows at the ends stay inside the height of the picture.
            let bar = Bar {
                left: frame.left + frame.width + 14.0,
                top: top + 10.0,
                height: each - 20.0,
                beyond: layer.beyond(self.view),
            };
            draw_bar(svg, bar, &layer.colouring);
        }
    }
}
