//! Absorbed energy and what is compared with it (Joshi 2018, section 7.3): sums over the particles of a solid.
//!
//! Absorbed energy W = sum of w_p V (w_p: area under the stress-strain curve), plastic volume V_p = sum of V of the
//! particles that yielded, absorbed energy density W/V_p, plastic deformation potential W / (p_driving V_bubble) (7.3).

use erode_sph::Geometry;
use std::f64::consts::PI;

/// Energy absorbed by plastic work, J: `plastic_work` in J/m3, `volume` in m3, of each particle.
#[must_use]
pub fn absorbed_energy(plastic_work: &[f64], volume: &[f64]) -> f64 {
    plastic_work.iter().zip(volume).map(|(w, v)| w * v).sum()
}

/// Volume of the particles whose plastic strain exceeds `yielded`, m3.
#[must_use]
pub fn plastic_volume(plastic_strain: &[f64], volume: &[f64], yielded: f64) -> f64 {
    let all = plastic_strain.iter().zip(volume);
    // A sum of nothing is -0 in Rust.
    all.filter(|(e, _)| **e > yielded)
        .map(|(_, v)| v)
        .sum::<f64>()
        + 0.0
}

/// Absorbed energy over the volume that absorbed it, J/m3; NaN where nothing yielded.
#[must_use]
pub fn energy_density(energy: f64, volume: f64) -> f64 {
    if volume > 0.0 {
        energy / volume
    } else {
        f64::NAN
    }
}

/// Energy of an empty bubble: driving pressure (Pa) times its volume, J (per metre of thickness in plane). In plane the
/// half of the disc that is computed counts.
#[must_use]
pub fn bubble_energy(radius: f64, driving_pressure: f64, geometry: Geometry) -> f64 {
    let volume = match geometry {
        Geometry::Axisymmetric => 4.0 / 3.0 * PI * radius.powi(3),
        Geometry::Plane => 0.5 * PI * radius * radius,
    };
    volume * driving_pressure
}

/// Plastic deformation potential (7.3) as a share, not in per cent.
#[must_use]
pub fn plastic_potential(energy: f64, bubble_energy: f64) -> f64 {
    energy / bubble_energy
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_over_particles() {
        let (strain, work) = ([0.0, 1e-3, 2e-3, 1e-9], [0.0, 5e5, 1e6, 1.0]);
        let volume = [1e-15, 2e-15, 3e-15, 4e-15];
        assert!((absorbed_energy(&work, &volume) - 4e-9).abs() < 1e-14);
        let yielded = plastic_volume(&strain, &volume, 1e-6);
        assert!((yielded - 5e-15).abs() < 1e-27);
        assert!((energy_density(4e-9, yielded) - 8e5).abs() < 1e-6);
        assert!(energy_density(0.0, plastic_volume(&[0.0], &[1.0], 1e-6)).is_nan());
        assert!(plastic_volume(&[0.0], &[1.0], 1e-6).is_sign_positive());
    }

    /// The main case: 0.15 mm at 50 MPa holds 0.7069 mJ; 0.83 % of it is the largest potential in figure 7.11.
    #[test]
    fn the_bubble_of_the_thesis() {
        let energy = bubble_energy(0.15e-3, 50e6, Geometry::Axisymmetric);
        assert!((energy / 7.0686e-4 - 1.0).abs() < 1e-4, "{energy}");
        assert!((plastic_potential(5.867e-6, energy) - 0.0083).abs() < 1e-6);
        let half_disc = bubble_energy(1.0, 2.0, Geometry::Plane);
        assert!((half_disc - PI).abs() < 1e-12);
    }
}
