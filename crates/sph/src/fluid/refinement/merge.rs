//! Two particles become one.
//!
//! Mass, volume, momentum and area are the sums of both, so the place is the mean by area. Only what was halved
//! is merged: two of one level are one of the level above, and what is left over from mixing joins a larger one, whose level
//! stays. (Small ones that are left alone keep the time step small.)

use super::particles::Piece;
use super::target::Wanted;
use crate::fluid::Fluid;
use crate::neighbours::Neighbours;

/// Two particles are merged when the root of their joint area is below this multiple of the wanted spacing. Small enough
/// that the next step does not halve them again.
const MERGE: f64 = 0.75;

impl Fluid {
    /// Merges pairs that are small for the `wanted` spacing (m); returns how many. Each particle is merged at most once.
    pub(super) fn merge(&mut self, wanted: &mut Vec<Wanted>) -> u64 {
        let small = |a: &usize| {
            self.origin[*a].level > 0 && 2.0 * self.area(*a) < (MERGE * wanted[*a].spacing).powi(2)
        };
        let candidates: Vec<usize> = (0..self.len()).filter(small).collect();
        if candidates.len() < 2 {
            return 0;
        }
        let position: Vec<_> = candidates.iter().map(|&a| self.position[a]).collect();
        // Neighbours are partners within 1.3 spacings.
        let reach: Vec<f64> = (candidates.iter())
            .map(|&a| 0.65 * self.area(a).sqrt())
            .collect();
        let near = Neighbours::build(&position, &reach, candidates.len(), 0.0);
        let mut keep = vec![true; self.len()];
        let mut taken = vec![false; candidates.len()];
        let mut count = 0;
        for i in 0..candidates.len() {
            if taken[i] {
                continue;
            }
            let a = candidates[i];
            let free = near.of(i).iter().map(|j| *j as usize).filter(|&j| {
                let b = candidates[j];
                let joint = self.area(a) + self.area(b);
                !taken[j] && joint < (MERGE * wanted[a].spacing.min(wanted[b].spacing)).powi(2)
            });
            let square = |j: &usize| {
                let (p, q) = (position[i], position[*j]);
                (p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2)
            };
            let Some(j) = free.min_by(|j, k| square(j).total_cmp(&square(k)).then(j.cmp(k))) else {
                continue;
            };
            (taken[i], taken[j]) = (true, true);
            self.unite(a, candidates[j]);
            keep[candidates[j]] = false;
            count += 1;
        }
        if count > 0 {
            self.retain(&keep);
            let mut keep = keep.iter();
            wanted.retain(|_| *keep.next().unwrap_or(&true));
        }
        count
    }

    /// Puts `b` into `a`.
    fn unite(&mut self, a: usize, b: usize) {
        let (ma, mb) = (self.mass[a], self.mass[b]);
        let (area_a, area_b) = (self.area(a), self.area(b));
        let mass = ma + mb;
        let by_mass = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|i| (ma * p[i] + mb * q[i]) / mass);
        let (x, y) = (self.position[a], self.position[b]);
        let place = [0, 1].map(|i| (area_a * x[i] + area_b * y[i]) / (area_a + area_b));
        self.acceleration[a] = by_mass(self.acceleration[a], self.acceleration[b]);
        self.support[a] = self.support[a].min(self.support[b]);
        self.strain_rate[a] = self.strain_rate[a].max(self.strain_rate[b]);
        let (la, lb) = (self.origin[a].level, self.origin[b].level);
        self.origin[a].level = if la == lb { la - 1 } else { la.min(lb) };
        self.reshape(
            a,
            &Piece {
                position: place,
                velocity: by_mass(self.velocity[a], self.velocity[b]),
                mass,
                volume: self.volume[a] + self.volume[b],
            },
        );
    }
}
