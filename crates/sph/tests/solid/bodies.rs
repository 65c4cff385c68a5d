//! Small bodies for the tests.

use erode_physics::Elastic;
use erode_physics::material_point::Material;
use erode_physics::strength::{JohnsonCook, Strength};
use erode_sph::Geometry;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};

pub(crate) const DX: f64 = 10e-6;

/// A-2205, table 7.1 of Joshi 2018.
pub(crate) fn steel(strength: Strength) -> Material {
    Material {
        elastic: Elastic {
            young_modulus: 186e9,
            poisson_ratio: 0.3,
        },
        strength,
        density: 7800.0,
        temperature: 293.0,
    }
}

pub(crate) fn johnson_cook() -> Strength {
    Strength::JohnsonCook(JohnsonCook {
        a: 508e6,
        b: 832e6,
        n: 0.29,
        c: 0.031,
        reference_rate: 4e-4,
        thermal: None,
    })
}

/// left, right, bottom, top.
pub(crate) type Faces = [Face; 4];

pub(crate) const FREE: Faces = [Face::Free; 4];
/// Free as long as no pressure is set.
pub(crate) const OPEN: Faces = [Face::Traction; 4];

fn setup(geometry: Geometry, faces: Faces, size: [f64; 2], strength: Strength) -> Setup {
    let [left, right, bottom, top] = faces;
    Setup {
        geometry,
        block: Block {
            lower: [0.0, 0.0],
            upper: size,
            left,
            right,
            bottom,
            top,
        },
        material: steel(strength),
        numerics: Numerics::default(),
        position: Vec::new(),
        area: Vec::new(),
    }
}

/// nx by nz particles on a square lattice of spacing DX, half a spacing inside the faces.
pub(crate) fn lattice(
    geometry: Geometry,
    faces: Faces,
    n: [usize; 2],
    strength: Strength,
) -> Setup {
    let mut s = setup(geometry, faces, n.map(|n| n as f64 * DX), strength);
    for j in 0..n[1] {
        for i in 0..n[0] {
            s.position
                .push([(i as f64 + 0.5) * DX, (j as f64 + 0.5) * DX]);
            s.area.push(DX * DX);
        }
    }
    s
}

/// Spacing grows by 1.5 % per row and column away from the upper left corner, every inner particle shaken by 10 %.
pub(crate) fn graded(geometry: Geometry, faces: Faces, n: [usize; 2], strength: Strength) -> Setup {
    let edges = |n: usize| -> Vec<f64> {
        (0..=n)
            .map(|i| DX * (1.015_f64.powi(i as i32) - 1.0) / 0.015)
            .collect()
    };
    let (x, z) = (edges(n[0]), edges(n[1]));
    let mut s = setup(geometry, faces, [x[n[0]], z[n[1]]], strength);
    let mut random = Random(1);
    for j in 0..n[1] {
        for i in 0..n[0] {
            let (w, h) = (x[i + 1] - x[i], z[j + 1] - z[j]);
            let shake = |r: &mut Random, size: f64, edge: bool| {
                if edge {
                    0.0
                } else {
                    0.2 * size * (r.next() - 0.5)
                }
            };
            let dx = shake(&mut random, w, i == 0 || i + 1 == n[0]);
            let dz = shake(&mut random, h, j == 0 || j + 1 == n[1]);
            let depth = 0.5 * (z[j] + z[j + 1]) + dz;
            s.position
                .push([0.5 * (x[i] + x[i + 1]) + dx, z[n[1]] - depth]);
            s.area.push(w * h);
        }
    }
    s
}

pub(crate) fn build(setup: Setup) -> Solid {
    Solid::new(setup).expect("a body")
}

/// A small generator of numbers in [0, 1), for states without pattern.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}
