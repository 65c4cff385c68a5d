//! Particles as coloured pixels, and pixels as an embedded PNG.

use base64::Engine as _;

use super::colour::VOID;

/// A pixel is inside a body if a particle is not farther away than this part of the particle's size. On a square
/// lattice the farthest place is 0.71 sizes from a particle: bodies have no holes, voids stay open.
pub const REACH: f64 = 0.75;

/// Gaps of a disordered arrangement are closed if no place in them is farther from a particle than this part of its
/// size: a void must be wider than two particles to count.
pub const CLOSING: f64 = 1.2;

/// The rectangle that is seen, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Smallest and largest first coordinate.
    pub r: [f64; 2],
    /// Smallest and largest second coordinate.
    pub z: [f64; 2],
}

impl View {
    /// Whether a point is seen.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        self.r[0] <= point[0]
            && point[0] <= self.r[1]
            && self.z[0] <= point[1]
            && point[1] <= self.z[1]
    }
}

/// A picture in memory, rows from the top, three bytes per pixel.
#[derive(Debug, Clone)]
pub(crate) struct Raster {
    pub(crate) width: usize,
    pub(crate) height: usize,
    view: View,
    rgb: Vec<u8>,
    /// Squared distance to the nearest particle, pixels; infinite beyond its closing distance.
    distance: Vec<f64>,
    /// Pixels inside a body.
    inside: Vec<bool>,
}

impl Raster {
    /// An empty (white) picture of `view` with square pixels and the given width.
    pub(crate) fn new(view: View, width: usize) -> Self {
        let ratio = (view.z[1] - view.z[0]) / (view.r[1] - view.r[0]);
        let height = ((width as f64 * ratio).round() as usize).max(1);
        Self {
            width,
            height,
            view,
            rgb: VOID.repeat(width * height),
            distance: vec![f64::INFINITY; width * height],
            inside: vec![false; width * height],
        }
    }

    /// Colours the pixels that are nearer to this particle than to those before it.
    pub(crate) fn splat(&mut self, centre: [f64; 2], size: f64, colour: [u8; 3]) {
        if !(size.is_finite() && centre[0].is_finite() && centre[1].is_finite()) {
            return;
        }
        let pixel = (self.view.r[1] - self.view.r[0]) / self.width as f64;
        // Particles smaller than a pixel still show.
        let reach = (REACH * size / pixel).max(0.71);
        let closing = (CLOSING * size / pixel).max(reach);
        let x = (centre[0] - self.view.r[0]) / pixel - 0.5;
        let y = (self.view.z[1] - centre[1]) / pixel - 0.5;
        let columns = covered(x, closing, self.width);
        for row in covered(y, closing, self.height) {
            for column in columns.clone() {
                let away = (column as f64 - x).powi(2) + (row as f64 - y).powi(2);
                let index = row * self.width + column;
                self.inside[index] |= away <= reach * reach;
                if away <= closing * closing && away < self.distance[index] {
                    self.distance[index] = away;
                    self.rgb[3 * index..3 * index + 3].copy_from_slice(&colour);
                }
            }
        }
    }

    /// To be called after the last particle: makes white what is a void, and leaves closed what is only a gap.
    pub(crate) fn open_voids(&mut self) {
        let mut seen = self.inside.clone();
        for start in 0..seen.len() {
            if seen[start] {
                continue;
            }
            let region = self.region(start, &mut seen);
            if region.iter().any(|k| self.distance[*k].is_infinite()) {
                for index in region {
                    self.rgb[3 * index..3 * index + 3].copy_from_slice(&VOID);
                }
            }
        }
    }

    /// Pixels outside of bodies that are connected with `start`.
    fn region(&self, start: usize, seen: &mut [bool]) -> Vec<usize> {
        let mut region = vec![start];
        seen[start] = true;
        let mut next = 0;
        while let Some(index) = region.get(next).copied() {
            next += 1;
            let column = index % self.width;
            let neighbours = [
                (column > 0).then(|| index - 1),
                (column + 1 < self.width).then(|| index + 1),
                index.checked_sub(self.width),
                Some(index + self.width).filter(|k| *k < seen.len()),
            ];
            for neighbour in neighbours.into_iter().flatten() {
                if !seen[neighbour] {
                    seen[neighbour] = true;
                    region.push(neighbour);
                }
            }
        }
        region
    }

    /// Colour of a pixel.
    #[cfg(test)]
    pub(crate) fn pixel(&self, column: usize, row: usize) -> [u8; 3] {
        let at = 3 * (row * self.width + column);
        [self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]]
    }

    /// The picture as `data:image/png;base64,...`.
    pub(crate) fn data_uri(&self) -> String {
        data_uri(self.width, self.height, &self.rgb)
    }
}

/// Indices within `radius` of `centre`, inside `0..count`.
fn covered(centre: f64, radius: f64, count: usize) -> std::ops::Range<usize> {
    let from = (centre - radius).ceil().max(0.0) as usize;
    let to = (centre + radius).floor() + 1.0;
    from..(to.max(0.0) as usize).min(count)
}

/// RGB pixels (rows from the top) as an embedded PNG.
pub(crate) fn data_uri(width: usize, height: usize, rgb: &[u8]) -> String {
    let mut bytes = Vec::new();
    // Writing to memory fails only for sizes that do not match, which would leave the picture empty.
    let written = encode(&mut bytes, width as u32, height as u32, rgb);
    debug_assert!(written.is_ok(), "{written:?}");
    format!(
        "data:image/png;base64,{}",
        base64::engine::general_purpose::STANDARD.encode(bytes)
    )
}

fn encode(
    bytes: &mut Vec<u8>,
    width: u32,
    height: u32,
    rgb: &[u8],
) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(rgb)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: [u8; 3] = [255, 0, 0];

    /// A body on a square lattice with a round hole of radius 0.3 at the origin; particles are moved by up to
    /// `disorder` spacings.
    fn lattice(view: View, width: usize, spacing: f64, disorder: f64) -> Raster {
        let mut raster = Raster::new(view, width);
        let count = (2.0 / spacing) as i32;
        for i in -count..count {
            for j in -count..count {
                let noise = |k: i32| {
                    disorder * f64::from((k * 7919 + i * 104_729 + j * 1_299_709) % 1000) / 1000.0
                };
                let p = [
                    (f64::from(i) + 0.5 + noise(1)) * spacing,
                    (f64::from(j) + 0.5 + noise(517)) * spacing,
                ];
                if p[0].hypot(p[1]) > 0.3 {
                    raster.splat(p, spacing, RED);
                }
            }
        }
        raster.open_voids();
        raster
    }

    #[test]
    fn no_holes_in_a_body_and_the_void_stays_open() {
        let view = View {
            r: [-1.0, 1.0],
            z: [-1.0, 1.0],
        };
        for disorder in [0.0, 0.35] {
            let raster = lattice(view, 217, 0.05, disorder);
            for index in 0..raster.width * raster.height {
                let (row, column) = (index / raster.width, index % raster.width);
                let r = (column as f64 + 0.5) / 217.0 * 2.0 - 1.0;
                let z = (row as f64 + 0.5) / 217.0 * 2.0 - 1.0;
                let is_white = raster.pixel(column, row) == VOID;
                // The edge of the void is uncertain by one spacing and the disorder.
                let edge = 0.05 * (1.0 + disorder);
                assert!(!(is_white && r.hypot(z) > 0.3 + edge), "hole at {r} {z}");
                assert!(
                    is_white || r.hypot(z) > 0.3 - edge,
                    "void covered at {r} {z}"
                );
            }
        }
    }

    #[test]
    fn gaps_are_closed_and_voids_of_two_particles_are_not() {
        let view = View {
            r: [0.0, 9.0],
            z: [0.0, 9.0],
        };
        for (missing, white) in [(0.0, false), (0.6, false), (1.5, true)] {
            let mut raster = Raster::new(view, 90);
            for k in 0..81 {
                let p = [f64::from(k % 9) + 0.5, f64::from(k / 9) + 0.5];
                if (p[0] - 4.5).hypot(p[1] - 4.5) >= missing {
                    raster.splat(p, 1.0, RED);
                }
            }
            raster.open_voids();
            assert_eq!(raster.pixel(45, 45) == VOID, white, "{missing}");
        }
    }

    #[test]
    fn the_nearest_particle_wins_in_any_order() {
        let view = View {
            r: [0.0, 2.0],
            z: [0.0, 1.0],
        };
        let blue = [0, 0, 255];
        for swap in [false, true] {
            let mut raster = Raster::new(view, 20);
            let mut particles = [([0.5, 0.5], RED), ([1.5, 0.5], blue)];
            if swap {
                particles.swap(0, 1);
            }
            for (at, colour) in particles {
                raster.splat(at, 1.4, colour);
            }
            assert_eq!(raster.pixel(9, 5), RED);
            assert_eq!(raster.pixel(10, 5), blue);
        }
    }

    #[test]
    fn the_picture_is_a_png_of_the_right_size_and_colour() {
        let view = View {
            r: [0.0, 2.0],
            z: [0.0, 1.0],
        };
        let mut raster = Raster::new(view, 40);
        raster.splat([1.0, 0.5], 0.5, RED);
        raster.open_voids();
        let uri = raster.data_uri();
        let bytes = base64::engine::general_purpose::STANDARD
            .decode(uri.strip_prefix("data:image/png;base64,").unwrap())
            .unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (40, 20));
        assert_eq!(&pixels[3 * (10 * 40 + 20)..][..3], &RED);
        assert_eq!(&pixels[..3], &VOID);
    }

    #[test]
    fn particles_outside_or_broken_do_no_harm() {
        let mut raster = Raster::new(
            View {
                r: [0.0, 1.0],
                z: [0.0, 1.0],
            },
            10,
        );
        raster.splat([-50.0, 3.0], 0.1, RED);
        raster.splat([f64::NAN, 0.5], 0.1, RED);
        raster.splat([0.5, 0.5], f64::INFINITY, RED);
        raster.open_voids();
        assert!(raster.rgb.iter().all(|b| *b == 255));
    }
}
