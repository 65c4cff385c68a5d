//! Rigid indenters.

use crate::bodies::{DX, Faces, build, lattice};
use erode_physics::damage::{Damage, RuptureStrain};
use erode_physics::strength::Strength;
use erode_sph::Geometry::{self, Axisymmetric, Plane};
use erode_sph::solid::{Face, Indenter, QuasiStatic, Side, Solid};
use std::f64::consts::PI;

const RADIUS: f64 = 2e-3;
const N: usize = 50;

/// An elastic body with an indenter pressed `depth` into its top.
fn indented(geometry: Geometry, depth: f64) -> Solid {
    let left = if geometry == Plane {
        Face::Symmetry
    } else {
        Face::Axis
    };
    let faces: Faces = [left, Face::Traction, Face::Symmetry, Face::Traction];
    let mut solid = build(lattice(geometry, faces, [N, N], Strength::Elastic));
    let height = solid.block.upper[1];
    let start = height + RADIUS;
    solid
        .indent(Indenter::new(Side::Top, RADIUS, [0.0, start]))
        .unwrap();
    let transit = height / 5666.0;
    let loading = QuasiStatic {
        ramp: 10.0 * transit,
        hold: 10.0 * transit,
        damping: 0.5 / transit,
    };
    let lower = |solid: &mut Solid, value: f64, rate: f64| {
        let indenter = solid.indenter.as_mut().unwrap();
        indenter.centre[1] = start - depth * value;
        indenter.velocity[1] = -depth * rate;
    };
    loading
        .run(
            &mut solid,
            |solid, share| lower(solid, share.value, share.rate),
            |_, _| (),
        )
        .unwrap();
    solid
}

/// Hertz: for the force that came out, the pressure in the middle; it does not depend on the size of the body.
#[test]
fn pressure_is_that_of_hertz() {
    let modulus = 186e9 / 0.91;
    for geometry in [Plane, Axisymmetric] {
        let solid = indented(geometry, 5e-6);
        let top = solid.surface(Side::Top).unwrap();
        let force = -top.contact_force()[1];
        // Half of the symmetric body in plane strain.
        let expected = match geometry {
            Plane => (2.0 * force * modulus / (PI * RADIUS)).sqrt(),
            Axisymmetric => {
                (6.0 * force * modulus * modulus / (PI.powi(3) * RADIUS * RADIUS)).cbrt()
            }
        };
        let middle = -top.contact[0][1];
        let touching = top.contact.iter().filter(|t| t[1] != 0.0).count();
        println!(
            "{geometry:?}: {touching} points touch, pressure {}",
            middle / expected
        );
        assert!((6..30).contains(&touching));
        // The edge of contact is known to one spacing of about ten, which shifts some of the load.
        assert!((middle / expected - 1.0).abs() < 0.02);
    }
}

#[test]
fn contact_pushes_balances_and_hardly_gives_way() {
    let solid = indented(Axisymmetric, 5e-6);
    let top = solid.surface(Side::Top).unwrap();
    // It never pulls.
    assert!(top.contact.iter().all(|t| t[1] <= 0.0));
    let section: f64 = (0..N)
        .map(|i| (20 * N + i, (i as f64 + 0.5) * DX))
        .map(|(k, r)| solid.state.stress[k].yy * 2.0 * PI * r * DX)
        .sum();
    println!("section {}", section / top.contact_force()[1]);
    assert!((section / top.contact_force()[1] - 1.0).abs() < 0.02);
    let indenter = solid.indenter.unwrap();
    let x = top.position[0];
    let depth = indenter.radius - (x[1] - indenter.centre[1]).hypot(x[0]);
    println!("penetration {} of a spacing", depth / DX);
    assert!(depth > 0.0 && depth < 0.02 * DX);
}

#[test]
fn an_indenter_beside_the_body_or_on_a_wall_is_refused() {
    let faces: Faces = [Face::Axis, Face::Traction, Face::Symmetry, Face::Traction];
    let mut solid = build(lattice(Axisymmetric, faces, [20, 20], Strength::Elastic));
    let mut refused = |side, centre| {
        let bad = solid.indent(Indenter::new(side, RADIUS, centre));
        bad.unwrap_err().to_string()
    };
    let message = refused(Side::Top, [1e-4, 3e-3]);
    assert!(message.contains("only a sphere on the axis"), "{message}");
    let message = refused(Side::Bottom, [0.0, -3e-3]);
    assert!(
        message.contains("needs a face with given pressure"),
        "{message}"
    );
    let faces: Faces = [
        Face::Symmetry,
        Face::Traction,
        Face::Symmetry,
        Face::Traction,
    ];
    let mut solid = build(lattice(Plane, faces, [20, 20], Strength::Elastic));
    let beside = Indenter::new(Side::Top, RADIUS, [1e-2, 3e-3]);
    let message = solid.indent(beside).unwrap_err().to_string();
    assert!(message.contains("outside the body"), "{message}");
}

/// The indenter goes on pressing where the surface has failed: on what lies beneath, with its work in the ledger.
#[test]
fn an_indenter_follows_the_surface_that_failure_leaves() {
    let faces: Faces = [Face::Axis, Face::Traction, Face::Symmetry, Face::Traction];
    let strength = Strength::PerfectlyPlastic {
        yield_stress: 500e6,
    };
    let mut solid = build(lattice(Axisymmetric, faces, [20, 20], strength));
    solid.damage = Damage::RuptureStrain(RuptureStrain {
        rupture_strain: 0.05,
        modulus_loss: false,
    });
    let (height, radius, depth) = (solid.block.upper[1], 8.0 * DX, 1.5 * DX);
    let start = height + radius;
    solid
        .indent(Indenter::new(Side::Top, radius, [0.0, start]))
        .unwrap();
    let transit = height / 5666.0;
    let loading = QuasiStatic {
        ramp: 40.0 * transit,
        hold: 0.0,
        damping: 0.0,
    };
    // A force that the material cannot bear: the circle of contact times four times the yield stress.
    let bearable = 4.0 * 500e6 * PI * 2.0 * radius * depth;
    loading
        .run(
            &mut solid,
            |solid, share| {
                let indenter = solid.indenter.as_mut().unwrap();
                indenter.centre[1] = start - depth * share.value;
                indenter.velocity[1] = -depth * share.rate;
            },
            |solid, _| assert!(-solid.indenter_force()[1] < bearable),
        )
        .unwrap();
    let work = solid.state.work;
    assert!(
        work.lost.failed > 2,
        "{} particles failed",
        work.lost.failed
    );
    // No particle that is left lies inside the indenter by more than half a spacing.
    let centre = solid.indenter.unwrap().centre;
    for a in (0..solid.len()).filter(|&a| !solid.is_removed(a)) {
        let x = solid.state.position[a];
        let distance = (x[0] - centre[0]).hypot(x[1] - centre[1]);
        assert!(distance > radius - 0.5 * DX, "{x:?}");
    }
    println!("defect {} of {}", solid.energy_defect(), work.pressure);
    // The work is counted at face points, by a spacing from where it acts: 1.2 % were measured.
    assert!(solid.energy_defect().abs() < 0.03 * work.pressure);
}
