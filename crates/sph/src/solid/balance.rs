//! What a uniform stress in balance with its tractions leaves in the force on a packing that is no lattice.
//!
//! E_a = sum_b A_b (R_a L_a + R_b L_b) grad_a W - e_r (the last in axisymmetry only), images included; at an open image
//! also 2 R_b (s - 1) (n.L_b grad_a W) n for the scale s of its traction. Stored as L_a^-1 E_a/R_a, so that the force to
//! take off is (R P L)_a times it.
//!
//! It is zero on a lattice. In a packing shaken by 10 % a uniform pressure would relax to stresses with 15 % noise (root
//! mean square) without it. The price: forces of pairs are then not exactly opposite; what the body gains in momentum is
//! the sum of P_a E_a A_a, which vanishes for uniform stress.
//! Within reach of a free face nothing is taken off, since no uniform stress is in balance there; nor anywhere in a body
//! on which no traction can act: forces of pairs are then exactly opposite.

use super::block::{Block, Face, Side};
use super::images::{Image, reflected_weight};
use super::mat2::{apply, inverse};
use super::reference::Reference;
use super::surface::Surface;
use crate::geometry::Vec2;
use crate::kernel;

/// Image factors of the two columns of R P under a uniform stress, as multiples of P.
fn columns(
    image: &Image,
    block: &Block,
    axisymmetric: bool,
    surfaces: &[Surface],
    own: f64,
) -> Vec2 {
    let mut weight = own;
    let mut extra = [0.0; 2];
    for step in image.steps() {
        let side = step.side;
        let axis = side.normal_axis();
        if step.is_open() {
            let on_face = if axisymmetric && axis == 0 {
                block.coordinate(side)
            } else {
                weight
            };
            let scale = surfaces
                .iter()
                .find(|s| s.side == side)
                .map_or(1.0, |s| s.scale_on(image.source));
            extra[axis] += 2.0 * on_face * (scale - 1.0);
        }
        weight = reflected_weight(axisymmetric, side, block, weight);
    }
    extra.map(|x| x + weight)
}

fn near_free_face(block: &Block, reference: &Reference, a: usize) -> bool {
    let reach = kernel::SUPPORT * reference.smoothing_length[a];
    Side::ALL.into_iter().any(|side| {
        block.face(side) == Face::Free && block.depth(side, reference.position[a]) < reach
    })
}

/// The imbalance of every particle.
pub(super) fn imbalance(
    reference: &Reference,
    block: &Block,
    axisymmetric: bool,
    surfaces: &[Surface],
) -> Vec<Vec2> {
    let full = &reference.full_correction;
    let n = reference.position.len();
    if reference.open_images.is_empty() {
        return vec![[0.0; 2]; n];
    }
    let of_image = |image: &Image| {
        let b = image.source as usize;
        let weights = columns(image, block, axisymmetric, surfaces, reference.weight[b]);
        (image.turn_matrix(full[b]), weights)
    };
    let of_particle = |a: usize| {
        if near_free_face(block, reference, a) {
            return [0.0; 2];
        }
        let mut sum = [if axisymmetric { -1.0 } else { 0.0 }, 0.0];
        let real_and_mirror = reference.pairs_of(a).map(|p| {
            let b = p.neighbour as usize;
            let other = if b < n {
                (full[b], [reference.weight[b]; 2])
            } else {
                of_image(&reference.mirror_images[b - n])
            };
            (p.offset, p.gradient, other)
        });
        let open = (reference.open_pairs_of(a).iter()).map(|p| {
            (
                p.offset,
                p.gradient,
                of_image(&reference.open_images[p.image as usize]),
            )
        });
        for (offset, gradient, (correction, weights)) in real_and_mirror.chain(open) {
            let (own, other) = (apply(&full[a], offset), apply(&correction, offset));
            for k in 0..2 {
                sum[k] += gradient * (reference.weight[a] * own[k] + weights[k] * other[k]);
            }
        }
        apply(&inverse(&full[a]), sum).map(|x| x / reference.weight[a])
    };
    (0..n).map(of_particle).collect()
}
