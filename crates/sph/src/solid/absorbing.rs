//! Faces through which waves leave.
//!
//! t_n = nu' sigma_mm - (1 - nu'^2) rho c_l v_n,  t_t = -rho c_s v_t      (Lysmer and Kuhlemeyer 1969 for nu' = 0)
//!
//! nu' = lambda/(lambda + 2 mu) on the left and right faces: a plane wave that runs along the face (m is the direction along
//! it) has the lateral stress nu' sigma_mm, which is held so that it passes undisturbed. A wave that meets the face head on has
//! sigma_nn = -rho c_l v_n and sigma_mm = nu' sigma_nn; the sum of both waves obeys the first formula exactly.
//! nu' = 0 on the bottom and top faces.
//! Units: Pa, m/s. Range: elastic, angles of incidence below about 60 degrees.

use super::surface::Surface;
use crate::geometry::Vec2;
use erode_physics::Sym3;
use erode_physics::material_point::Material;

/// Traction on an absorbing face from the state of the particle behind it, Pa.
pub(super) fn traction(
    material: &Material,
    surface: &Surface,
    stress: Sym3,
    velocity: Vec2,
) -> Vec2 {
    let (elastic, density) = (material.elastic, material.density);
    let normal = surface.side.normal_axis();
    let ratio = if normal == 0 {
        let lambda = elastic.lame_lambda();
        lambda / (lambda + 2.0 * elastic.shear_modulus())
    } else {
        0.0
    };
    let mut traction = [0.0; 2];
    traction[normal] = ratio * stress.yy * surface.side.sign()
        - (1.0 - ratio * ratio) * density * elastic.longitudinal_speed(density) * velocity[normal];
    traction[1 - normal] = -density * elastic.shear_speed(density) * velocity[1 - normal];
    traction
}
