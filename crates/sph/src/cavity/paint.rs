//! The colouring of a window by particles, eight cells side by side.

use crate::cavity::Colour;
use crate::geometry::Vec2;
use crate::kernel;
use crate::simd::{LANES, Simd, Task};
use std::ops::RangeInclusive;

/// w R^2 at distance 0.
const AT_CENTRE: f64 = 5.0 / std::f64::consts::PI;

/// Rows of cells that one task colours.
pub(super) const BAND: usize = 8;

/// What one particle covers.
pub(super) struct Blot {
    x: Vec2,
    area: f64,
    pub(super) h: f64,
    /// First and last cell in both directions.
    from: [usize; 2],
    to: [usize; 2],
}

impl Blot {
    /// None if the window has no cell within the support of the kernel.
    pub(super) fn new(
        colour: &Colour,
        x: Vec2,
        h: f64,
        area: impl FnOnce() -> f64,
    ) -> Option<Self> {
        let (w, radius) = (colour.window, kernel::SUPPORT * h);
        let (mut from, mut to) = ([0; 2], [0; 2]);
        for k in 0..2 {
            // The number of cells with their centre at or before a place: `as` rounds down (`floor` would be a call).
            let size = colour.size[k];
            let cells = |v: f64| ((v - w.lower[k]) / w.cell + 0.5).clamp(0.0, size as f64) as usize;
            let (before, until) = (cells(x[k] - radius), cells(x[k] + radius));
            if until == 0 || before == size {
                return None;
            }
            (from[k], to[k]) = (before, until - 1);
        }
        (from[0] <= to[0] && from[1] <= to[1]).then(|| Self {
            x,
            area: area(),
            h,
            from,
            to,
        })
    }
}

impl Blot {
    /// Bands of rows in which it lies.
    pub(super) fn bands(&self) -> RangeInclusive<usize> {
        self.from[1] / BAND..=self.to[1] / BAND
    }
}

/// Colours the cells of a few rows.
pub(super) struct Band<'a> {
    pub(super) colour: &'a Colour,
    pub(super) blots: &'a [Blot],
    /// Which of them lie in these rows.
    pub(super) own: &'a [usize],
    /// First row.
    pub(super) first: usize,
    pub(super) cells: &'a mut [[f64; LANES]],
    /// Eights of cells in a row; the last one is filled up.
    pub(super) eights: usize,
}

impl Task for Band<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let w = self.colour.window;
        let last = self.first + self.cells.len() / self.eights - 1;
        let mut steps = [0.0; LANES];
        for (i, step) in steps.iter_mut().enumerate() {
            *step = i as f64 * w.cell;
        }
        let (steps, zero, one) = (S::load(&steps), S::splat(0.0), S::splat(1.0));
        for b in self.own.iter().map(|k| &self.blots[*k]) {
            let support = (kernel::SUPPORT * b.h).powi(2);
            let scale = S::splat(b.area * AT_CENTRE / support);
            let inverse = S::splat(-1.0 / support);
            for j in b.from[1].max(self.first)..=b.to[1].min(last) {
                let row = (j - self.first) * self.eights;
                let dy = S::splat(self.colour.centre(0, j)[1] - b.x[1]);
                let dy2 = dy * dy;
                // Always the same eights: what one particle has just stored the next one loads as it is.
                for e in b.from[0] / LANES..=b.to[0] / LANES {
                    let dx = steps + S::splat(self.colour.centre(LANES * e, j)[0] - b.x[0]);
                    // Cells beyond the support get exactly nothing.
                    let u = (dx.mul_add(dx, dy2)).mul_add(inverse, one).max(zero);
                    let (u2, scaled) = (u * u, scale * u);
                    let cells = &mut self.cells[row + e];
                    *cells = (scaled * u).mul_add(u2, S::load(cells)).store();
                }
            }
        }
    }
}

/// How many void cells (colour below 1/2) lie in the rectangle from the first cell to each, rows and columns before it.
pub(super) struct VoidCells {
    count: Vec<u32>,
    columns: usize,
}

impl VoidCells {
    pub(super) fn of(colour: &Colour) -> Self {
        let columns = colour.size[0] + 1;
        let mut count = vec![0; columns * (colour.size[1] + 1)];
        for (j, row) in colour.colour.chunks(colour.size[0]).enumerate() {
            let mut in_row = 0;
            for (i, c) in row.iter().enumerate() {
                in_row += u32::from(*c < 0.5);
                count[columns * (j + 1) + i + 1] = count[columns * j + i + 1] + in_row;
            }
        }
        Self { count, columns }
    }

    /// Whether one lies in the square about the support of a particle.
    pub(super) fn meet(&self, b: &Blot) -> bool {
        let before = |i: usize, j: usize| self.count[self.columns * j + i];
        let (left, right) = (b.from[0], b.to[0] + 1);
        let (low, high) = (b.from[1], b.to[1] + 1);
        before(right, high) + before(left, low) != before(left, high) + before(right, low)
    }
}
