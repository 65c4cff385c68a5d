//! Small bodies for the tests.

use erode_physics::Elastic;
use erode_physics::material_point::Material;
use erode_physics::strength::{JohnsonCook, Strength};
use erode_sph::solid::space::{Setup, SpaceSolid};

pub(crate) const DX: f64 = 10e-6;

/// Young's modulus, Pa.
pub(crate) const YOUNG: f64 = 186e9;

/// A-2205, table 7.1 of Joshi 2018.
pub(crate) fn steel(strength: Strength) -> Material {
    Material {
        elastic: Elastic {
            young_modulus: YOUNG,
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

pub(crate) fn lattice(count: [usize; 3], strength: Strength) -> Setup {
    Setup::lattice(steel(strength), count, DX)
}

/// Numbers in [-1, 1] that look random.
pub(crate) fn noise(k: usize) -> f64 {
    let x = ((k as f64 + 1.0) * 12.989_8).sin() * 43_758.545_3;
    2.0 * (x - x.floor()) - 1.0
}

/// Particles moved off the lattice by up to a quarter of a spacing, with volumes that differ by up to a third.
pub(crate) fn disordered(count: [usize; 3], strength: Strength) -> Setup {
    let mut setup = lattice(count, strength);
    for (a, (x, volume)) in setup.position.iter_mut().zip(&mut setup.volume).enumerate() {
        for (i, x) in x.iter_mut().enumerate() {
            *x += 0.25 * DX * noise(3 * a + i);
        }
        *volume *= 1.0 + 0.3 * noise(7 * a);
    }
    setup
}

pub(crate) fn build(setup: &Setup) -> SpaceSolid {
    SpaceSolid::new(setup).unwrap()
}

/// Sets velocities from reference positions.
pub(crate) fn set_velocity(solid: &mut SpaceSolid, of: impl Fn([f64; 3]) -> [f64; 3]) {
    for a in 0..solid.len() {
        let v = of(solid.reference_position(a));
        solid.state.velocity.set(a, v);
    }
}
