//! A body strained evenly is a material point.

use crate::bodies::{build, johnson_cook, lattice, steel};
use erode_physics::material_point::{Material, Path, uniaxial_strain_path};
use erode_physics::return_mapping::radial_return;
use erode_physics::strength::{JohnsonCook, Strength, Thermal};
use erode_sph::solid::space::SpaceSolid;

const DT: f64 = 1e-9;

/// Stretches the body along the axes.
fn stretch(solid: &mut SpaceSolid, stretches: [f64; 3]) {
    for a in 0..solid.len() {
        let x = solid.reference_position(a);
        let y = std::array::from_fn(|k| stretches[k] * x[k]);
        solid.state.position.set(a, y);
    }
    solid.update_stress(DT).unwrap();
}

/// The same in three numbers per tensor: Kirchhoff stress along the axes, with the scalar radial return.
struct Point {
    material: Material,
    stretches: [f64; 3],
    tau: [f64; 3],
    plastic_strain: f64,
    work: f64,
}

impl Point {
    fn temperature(&self) -> f64 {
        let m = &self.material;
        let thermal = m.strength.thermal();
        m.temperature + thermal.map_or(0.0, |t| t.heating(self.work, m.density))
    }

    fn stretch(&mut self, new: [f64; 3]) {
        let m = self.material;
        let strain: [f64; 3] = std::array::from_fn(|k| {
            2.0 * (new[k] - self.stretches[k]) / (new[k] + self.stretches[k])
        });
        self.stretches = new;
        let j: f64 = new.iter().product();
        let volumetric = m.elastic.lame_lambda() * strain.iter().sum::<f64>();
        let mu = m.elastic.shear_modulus();
        let tau: [f64; 3] =
            std::array::from_fn(|k| self.tau[k] + volumetric + 2.0 * mu * strain[k]);
        let mean = tau.iter().sum::<f64>() / 3.0;
        let size = (1.5 * tau.iter().map(|t| (t - mean).powi(2)).sum::<f64>()).sqrt() / j;
        let (strain, heat) = (self.plastic_strain, self.temperature());
        let found = radial_return(size, strain, DT, heat, mu / j, &m.strength).unwrap();
        let scale = if size > 0.0 {
            found.yield_stress / size
        } else {
            1.0
        };
        self.tau = tau.map(|t| mean + (t - mean) * scale);
        self.plastic_strain += found.increment;
        self.work += found.yield_stress * found.increment * j;
    }
}

fn hot() -> Strength {
    match johnson_cook() {
        Strength::JohnsonCook(law) => Strength::JohnsonCook(JohnsonCook {
            thermal: Some(Thermal {
                m: 1.03,
                reference_temperature: 293.0,
                melting_temperature: 1800.0,
                heat_capacity: 480.0,
                taylor_quinney: 0.9,
            }),
            ..law
        }),
        other => other,
    }
}

#[test]
fn lanes_follow_the_scalar_law_there_and_back() {
    for strength in [johnson_cook(), hot()] {
        let mut solid = build(&lattice([5, 4, 5], strength));
        let mut point = Point {
            material: steel(strength),
            stretches: [1.0; 3],
            tau: [0.0; 3],
            plastic_strain: 0.0,
            work: 0.0,
        };
        for k in 0..240 {
            let e = 0.05 * (0.02 * f64::from(k)).sin();
            let stretches = [-e, 0.3 * e, 0.4 * e].map(f64::exp);
            stretch(&mut solid, stretches);
            point.stretch(stretches);
        }
        assert!(point.plastic_strain > 0.05);
        for a in 0..solid.len() {
            let tau = solid.kirchhoff_stress(a);
            for (tau, scalar) in [tau.xx, tau.yy, tau.zz].into_iter().zip(point.tau) {
                // Round-off of F (1e-15 times 186 GPa) in 240 steps.
                assert!((tau - scalar).abs() < 1e5, "{tau} {scalar}");
            }
            let [strain] = solid.state.plastic_strain.get(a);
            assert!((strain / point.plastic_strain - 1.0).abs() < 1e-6);
            assert!((solid.temperature(a) - point.temperature()).abs() < 1e-3);
        }
    }
}

#[test]
fn uniaxial_strain_is_that_of_the_material_point() {
    let material = steel(johnson_cook());
    let path = Path {
        final_strain: -0.01,
        rate: 0.01 / (100.0 * DT),
        steps: 100,
    };
    let expected = uniaxial_strain_path(&material, path).unwrap();
    let mut solid = build(&lattice([5, 5, 5], johnson_cook()));
    for point in &expected {
        stretch(&mut solid, [point.strain.exp(), 1.0, 1.0]);
        let stress = solid.stress(60);
        // The rate is written for the Kirchhoff stress here and for the Cauchy stress there: J differs from 1 by the strain.
        let close = |a: f64, b: f64| (a - b).abs() <= 0.012 * b.abs() + 1e3;
        assert!(close(stress.xx, point.stress), "{stress:?} {point:?}");
        assert!(close(stress.von_mises(), point.von_mises));
    }
    assert!(expected[99].plastic_strain > 1e-3);
}
