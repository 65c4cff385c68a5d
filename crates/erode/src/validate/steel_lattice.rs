//! A rectangle of A-2205 on a square lattice, without rate, and what is read from it.

use super::Failure;
use super::materials::steel_without_rate;
use erode_physics::material_point::Material;
use erode_sph::Geometry;
use erode_sph::solid::{Block, Face, Formulation, Numerics, Setup, Solid};

/// What the rectangle is like; its lower left corner is the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lattice {
    pub(crate) geometry: Geometry,
    /// Width and height, m.
    pub(crate) size: [f64; 2],
    pub(crate) spacing: f64,
    /// Left, right, bottom, top.
    pub(crate) faces: [Face; 4],
    pub(crate) formulation: Formulation,
}

impl Lattice {
    /// Columns and rows.
    pub(crate) fn count(&self) -> [usize; 2] {
        self.size.map(|s| (s / self.spacing).round() as usize)
    }

    /// The body at rest.
    pub(crate) fn build(&self) -> Result<Solid, Failure> {
        let (density, elastic, strength) = steel_without_rate()?;
        let ([columns, rows], dx) = (self.count(), self.spacing);
        let place = |k: usize| [k % columns, k / columns].map(|i| (i as f64 + 0.5) * dx);
        let [left, right, bottom, top] = self.faces;
        Ok(Solid::new(Setup {
            geometry: self.geometry,
            block: Block {
                lower: [0.0; 2],
                upper: self.size,
                left,
                right,
                bottom,
                top,
            },
            material: Material {
                elastic,
                strength,
                density,
                temperature: 293.0,
            },
            numerics: Numerics {
                formulation: self.formulation,
                ..Numerics::default()
            },
            position: (0..columns * rows).map(place).collect(),
            area: vec![dx * dx; columns * rows],
        })?)
    }

    /// Values along the material line at height `z`, from r = 0 to `end`: (reference r, value), by a cubic through four rows.
    pub(crate) fn line(&self, z: f64, end: f64, value: impl Fn(usize) -> f64) -> Vec<[f64; 2]> {
        let ([columns, rows], dx) = (self.count(), self.spacing);
        let row = z / dx - 0.5;
        let first = (row.floor() as usize).clamp(1, rows - 3) - 1;
        let f = row - first as f64;
        // Lagrange polynomials through 0, 1, 2, 3.
        let weights = [
            -(f - 1.0) * (f - 2.0) * (f - 3.0) / 6.0,
            f * (f - 2.0) * (f - 3.0) / 2.0,
            -f * (f - 1.0) * (f - 3.0) / 2.0,
            f * (f - 1.0) * (f - 2.0) / 6.0,
        ];
        let at = |i: usize| -> f64 {
            let row = |m: usize| weights[m] * value((first + m) * columns + i);
            (0..4).map(row).sum()
        };
        (0..columns)
            .map(|i| [(i as f64 + 0.5) * dx, i as f64])
            .take_while(|[r, _]| *r <= end)
            .map(|[r, i]| [r, at(i as usize)])
            .collect()
    }
}

impl Lattice {
    /// Largest plastic strain: of the particles and, by even parabolas across it, of the axis or plane of symmetry on the
    /// left, there by parabolas between the rows too.
    pub(crate) fn peak_strain(&self, solid: &Solid) -> f64 {
        let ([columns, rows], strain) = (self.count(), &solid.state.plastic_strain);
        let on_axis = |j: usize| (9.0 * strain[columns * j] - strain[columns * j + 1]) / 8.0;
        let between = |j: usize| {
            let [a, b, c] = [j - 1, j, j + 1].map(on_axis);
            let bend = 2.0 * b - a - c;
            if bend > 0.0 && b >= a && b >= c {
                b + (c - a) * (c - a) / (8.0 * bend)
            } else {
                b
            }
        };
        let axis = (1..rows - 1).map(between).fold(0.0, f64::max);
        strain.iter().copied().fold(axis, f64::max)
    }
}
