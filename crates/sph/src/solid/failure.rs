//! Taking failed material out of the body.
//!
//! A particle whose damage reaches 1 leaves all neighbour sums (Joshi 2018, section 5.4.1); so does one that is left with
//! too few neighbours for a gradient. It stays in the arrays, at rest where it failed, free of stress; its mass, momentum
//! and energy go to the ledger (`Lost`).
//!
//! Total Lagrangian form. The gradients of its former neighbours are corrected anew with what is left, exact for linear
//! fields: F is evaluated with them and taken over without strain, tau = J sigma kept. Their force uses the same correction,
//! so that it is the adjoint of the strain: the new surface is free of traction and no energy comes from it. Beside an
//! open face the images of what is left go on acting and count in the correction of the force; the tractions of the points
//! beside the hole are scaled anew so that each transmits its force in full (else an indenter's ledger misses a fifth).
//!
//! What fails: pairs reach over a crack of one row (two rows part a body); pressure on a face point whose particle is
//! gone acts no more, nor does any pressure on the new surface.

use super::reference::Reference;
use super::state::{FAILED, LOOSE};
use super::step::LONG_TASK;
use super::{Formulation, Solid, stress};
use erode_physics::Sym3;
use rayon::prelude::*;

impl Solid {
    /// Whether a particle has been taken out.
    #[must_use]
    pub fn is_removed(&self, particle: usize) -> bool {
        self.state.removed[particle] != 0.0
    }

    /// Mass still in the body, kg.
    #[must_use]
    pub fn mass(&self) -> f64 {
        (0..self.len())
            .filter(|&a| !self.is_removed(a))
            .map(|a| self.reference.mass[a])
            .sum()
    }

    /// Takes out what has failed, then what came loose by that.
    pub(super) fn remove_failed(&mut self) {
        let gone = self.find(|a| self.state.damage[a] >= 1.0 && !self.is_removed(a));
        for &a in &gone {
            self.count_as_lost(a, FAILED);
        }
        if !gone.is_empty() {
            self.part_with(gone);
        }
    }

    /// Brings the neighbour sums of a body whose state was replaced up to its removed particles.
    pub(super) fn forget_removed(&mut self) {
        let gone = self.find(|a| self.is_removed(a) && !self.reference.forgotten[a]);
        if gone.is_empty() || !self.stores_pairs() {
            return;
        }
        self.reference.forget(&gone);
        self.share_out_again();
    }

    /// Particles of which something rare is true, ascending.
    fn find(&self, is_true: impl Fn(usize) -> bool + Sync) -> Vec<usize> {
        let task = |task: usize| task * LONG_TASK..self.len().min((task + 1) * LONG_TASK);
        let tasks = (0..self.len().div_ceil(LONG_TASK)).into_par_iter();
        let found = tasks.filter(|&t| task(t).any(&is_true));
        let found: Vec<usize> = found.collect();
        let particles = found.into_iter().flat_map(task);
        particles.filter(|&a| is_true(a)).collect()
    }

    fn stores_pairs(&self) -> bool {
        self.numerics.formulation == Formulation::TotalLagrangian
    }

    fn part_with(&mut self, mut gone: Vec<usize>) {
        if !self.stores_pairs() {
            return;
        }
        let mut touched = Vec::new();
        while !gone.is_empty() {
            let (near, loose) = self.reference.forget(&gone);
            touched.extend(near);
            for &a in &loose {
                self.count_as_lost(a, LOOSE);
            }
            gone = loose;
        }
        touched.sort_unstable();
        touched.dedup();
        self.take_over_gradients(&touched);
        self.share_out_again();
    }

    /// Tractions act on what is left beneath their points.
    fn share_out_again(&mut self) {
        for surface in &mut self.surfaces {
            surface.share_out_again(self.geometry, &self.block, &self.reference);
        }
    }

    /// New neighbours give another F at the same place: no strain.
    fn take_over_gradients(&mut self, touched: &[usize]) {
        self.place_images();
        for &a in touched {
            if self.is_removed(a) {
                continue;
            }
            let before = self.volume_ratio(a);
            let f = stress::gradient(&self.reference, &self.positions(), a);
            let after = before * super::mat2::determinant(&f)
                / super::mat2::determinant(&self.state.deformation[a]);
            if after > 0.0 {
                self.state.deformation[a] = f;
                self.state.stress[a] = self.state.stress[a] * (before / after);
            }
        }
    }

    fn count_as_lost(&mut self, a: usize, why: f64) {
        let (kinetic, elastic) = (self.kinetic_energy(a), self.elastic_energy(a));
        let mass = self.reference.mass[a];
        let lost = &mut self.state.work.lost;
        if why == FAILED {
            lost.failed += 1;
        } else {
            lost.loose += 1;
        }
        lost.mass += mass;
        lost.momentum += mass * self.state.velocity[a][1];
        lost.kinetic += kinetic;
        lost.elastic += elastic;
        lost.plastic_work += self.reference.volume[a] * self.state.plastic_work[a];
        let s = &mut self.state;
        s.removed[a] = why;
        s.stress[a] = Sym3::ZERO;
        s.von_mises[a] = 0.0;
        s.plastic_strain_rate[a] = 0.0;
        (s.velocity[a], s.acceleration[a]) = ([0.0; 2], [0.0; 2]);
    }
}

impl Reference {
    /// Takes particles out of all sums. Returns the particles that lost neighbours and those left with too few.
    fn forget(&mut self, gone: &[usize]) -> (Vec<usize>, Vec<usize>) {
        for &a in gone {
            self.forgotten[a] = true;
        }
        let mut near: Vec<usize> = gone.iter().flat_map(|&a| self.sources_near(a)).collect();
        near.extend(gone);
        near.sort_unstable();
        near.dedup();
        self.silence_near(&near);
        for &a in &near {
            self.silence(a);
        }
        let changed = near.clone();
        near.retain(|&a| !self.forgotten[a]);
        let loose = (near.iter().copied())
            .filter(|&a| !self.correct_again(a))
            .collect();
        self.settle(&changed);
        (near, loose)
    }
}
