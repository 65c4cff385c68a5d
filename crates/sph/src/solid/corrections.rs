//! Corrections of the gradients: inverse moment matrices, see `reference.rs`.

use super::SolidError;
use super::mat2::{Mat2, UNIT, determinant, inverse};
use super::reference::Reference;
use crate::geometry::Vec2;

/// Smallest determinant of a moment matrix that spans a gradient; 1 inside.
const LEAST_MOMENT: f64 = 0.01;

impl Reference {
    /// Corrects the gradients of a particle that lost neighbours; false if those left do not span one.
    pub(super) fn correct_again(&mut self, a: usize) -> bool {
        let mut moment = [[0.0; 2]; 2];
        for p in self.pairs_of(a) {
            add_moment(&mut moment, p.offset, p.gradient);
        }
        if determinant(&moment) <= LEAST_MOMENT {
            return false;
        }
        self.own_correction[a] = inverse(&moment);
        for p in self.open_pairs_of(a) {
            add_moment(&mut moment, p.offset, p.gradient);
        }
        self.full_correction[a] = inverse(&moment);
        self.imbalance[a] = [0.0; 2];
        true
    }

    /// Corrects the gradients of all particles.
    pub(super) fn correct(&mut self) -> Result<(), SolidError> {
        for a in 0..self.position.len() {
            if self.forgotten[a] {
                self.own_correction.push(UNIT);
                self.full_correction.push(UNIT);
                continue;
            }
            let mut moment = [[0.0; 2]; 2];
            for p in self.pairs_of(a) {
                add_moment(&mut moment, p.offset, p.gradient);
            }
            let own = self.checked_inverse(a, &moment)?;
            for p in self.open_pairs_of(a) {
                add_moment(&mut moment, p.offset, p.gradient);
            }
            let full = self.checked_inverse(a, &moment)?;
            self.own_correction.push(own);
            self.full_correction.push(full);
        }
        Ok(())
    }

    /// A moment is near the unit matrix inside and near half of it at a free edge, a quarter in a free corner.
    fn checked_inverse(&self, a: usize, moment: &Mat2) -> Result<Mat2, SolidError> {
        if determinant(moment) > LEAST_MOMENT {
            Ok(inverse(moment))
        } else {
            Err(SolidError::TooFewNeighbours {
                particle: a,
                position: self.position[a],
                neighbours: self.pairs_of(a).count(),
            })
        }
    }
}

fn add_moment(moment: &mut Mat2, offset: Vec2, gradient: f64) {
    for i in 0..2 {
        for j in 0..2 {
            moment[i][j] -= offset[i] * offset[j] * gradient;
        }
    }
}
