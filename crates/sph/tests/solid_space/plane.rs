//! A slab without motion across it is a body in plane strain.

use crate::bodies::{DX, build, lattice, set_velocity, steel};
use erode_physics::strength::Strength;
use erode_sph::Geometry;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};
use std::f64::consts::PI;

const COUNT: usize = 24;

fn velocity(x: f64, y: f64) -> [f64; 2] {
    let k = PI / (COUNT as f64 * DX);
    [
        20.0 * (k * x).cos() + 8.0 * (k * y).sin(),
        -12.0 * (k * y).cos() * (k * x).sin(),
    ]
}

fn plane() -> Solid {
    let size = COUNT as f64 * DX;
    let place = |k: usize| [k % COUNT, k / COUNT].map(|i| (i as f64 + 0.5) * DX);
    let setup = Setup {
        geometry: Geometry::Plane,
        block: Block {
            lower: [0.0; 2],
            upper: [size; 2],
            left: Face::Free,
            right: Face::Free,
            bottom: Face::Free,
            top: Face::Free,
        },
        material: steel(Strength::Elastic),
        numerics: Numerics::default(),
        position: (0..COUNT * COUNT).map(place).collect(),
        area: vec![DX * DX; COUNT * COUNT],
    };
    let mut solid = Solid::new(setup).unwrap();
    for a in 0..solid.len() {
        let [x, y] = solid.reference.position[a];
        solid.state.velocity[a] = velocity(x, y);
    }
    solid
}

#[test]
fn a_slab_moves_as_the_plane_solid() {
    let mut flat = plane();
    let mut slab = build(&lattice([COUNT, COUNT, 3], Strength::Elastic));
    for a in 0..slab.len() {
        slab.hold(a, [false, false, true]);
    }
    set_velocity(&mut slab, |x| {
        let [u, v] = velocity(x[0], x[1]);
        [u, v, 0.0]
    });
    let dt = flat.stable_time_step().dt;
    assert!((slab.stable_time_step().dt / dt - 1.0).abs() < 1e-12);
    flat.accelerations();
    slab.accelerations(0.0);
    // Once along an edge.
    for _ in 0..60 {
        flat.step(dt).unwrap();
        slab.step(dt).unwrap();
    }
    let (mut largest, mut square, mut gap) = (0.0_f64, 0.0, 0.0);
    for a in 0..slab.len() {
        let start = slab.reference_position(a);
        let [i, j] = [0, 1].map(|k| (start[k] / DX) as usize);
        let (x, y) = (
            slab.state.position.get(a),
            flat.state.position[i + COUNT * j],
        );
        for k in 0..2 {
            let (u, w) = (x[k] - start[k], y[k] - start[k]);
            largest = largest.max((u - w).abs());
            square += w * w;
            gap += (u - w).powi(2);
        }
        assert_eq!(x[2], start[2]);
    }
    let (share, most) = (
        (gap / square).sqrt(),
        largest / (square / slab.len() as f64).sqrt(),
    );
    println!("difference {share:e}, largest {most:e}");
    // Two kernels, and free faces whose outer layer is too soft in either.
    assert!(share < 0.02 && most < 0.1, "{share} {most}");
}
