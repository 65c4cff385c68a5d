//! Gas goes from the pockets into the voids where they were.

use super::cells::Part;
use super::{Gas, Pocket, SMALLEST, ring};
use crate::cavity::Map;
use crate::geometry::Geometry;

/// Gas of a pocket that goes into a void.
struct Portion {
    share: f64,
    /// Its volume before, m3.
    volume: f64,
}

impl Gas {
    /// A larger part to be searched, if a void where a pocket was goes on beyond the part that the map shows.
    pub(super) fn wider(&self, map: &Map, search: Part) -> Option<Part> {
        let common = self.cells.common(map, search, self.pockets.len());
        let held = |label: u32| {
            let void = (label as usize).checked_sub(1);
            void.is_some_and(|v| common[..self.pockets.len()].iter().any(|c| c[v] > 0))
        };
        let [nx, ny] = map.size;
        let column = |i: usize| (0..ny).any(|j| held(map.label[i + nx * j]));
        let row = |j: usize| (0..nx).any(|i| held(map.label[i + nx * j]));
        let (limit, mut wider) = (self.law.size(), search);
        for k in 0..2 {
            let touched = |at: usize| if k == 0 { column(at) } else { row(at) };
            let room = map.size[k];
            if search[0][k] > 0 && touched(0) {
                wider[0][k] = search[0][k].saturating_sub(room);
            }
            if search[1][k] < limit[k] && touched(map.size[k] - 1) {
                wider[1][k] = (search[1][k] + room).min(limit[k]);
            }
        }
        (wider != search).then_some(wider)
    }

    /// New pockets, in the order of the voids that hold them. Returns the pocket of each label, from 1; 0 for none.
    pub(super) fn hand_on(&mut self, map: &Map, search: Part, geometry: Geometry) -> Vec<usize> {
        let common = self.cells.common(map, search, self.pockets.len());
        let (held, empty) = common.split_at(self.pockets.len());
        let portions = self.portions(map, held);
        let opened = self.opened(map, search, empty, geometry);
        let mut pocket_of = vec![0; map.voids.len() + 1];
        let mut pockets = Vec::new();
        for (v, portions) in portions.iter().enumerate().filter(|(_, p)| !p.is_empty()) {
            let share: f64 = portions.iter().map(|p| p.share).sum();
            let before: f64 = portions.iter().map(|p| p.volume).sum();
            if portions.len() > 1 {
                let one = |p: &Portion| self.energy_of(p.share, p.volume);
                let apart: f64 = portions.iter().map(one).sum();
                self.lost += apart - self.energy_of(share, before);
            }
            if opened[v] > 0.0 {
                let filled = self.energy_of(share, before + opened[v]);
                self.lost += self.energy_of(share, before) - filled;
            }
            let volume = map.voids[v].volume;
            pockets.push(Pocket {
                share,
                volume,
                pressure: self.law.pressure_in(self.first_volume, share, volume),
            });
            pocket_of[v + 1] = pockets.len();
        }
        self.pockets = pockets;
        pocket_of
    }

    /// Gas that goes into each void. `held`: cells that each pocket has in common with each void.
    fn portions(&mut self, map: &Map, held: &[Vec<usize>]) -> Vec<Vec<Portion>> {
        let all: Vec<usize> = (0..map.voids.len())
            .map(|v| held.iter().map(|c| c[v]).sum())
            .collect();
        let mut portions: Vec<Vec<Portion>> = map.voids.iter().map(|_| Vec::new()).collect();
        for (k, common) in held.iter().enumerate() {
            let pocket = self.pockets[k];
            let touched = || (0..common.len()).filter(|&v| common[v] > 0);
            let Some(largest) = touched().max_by_key(|&v| map.voids[v].cells) else {
                self.closed += 1;
                self.lost += self.energy_of(pocket.share, pocket.volume);
                continue;
            };
            let takes = |v: &usize| map.voids[*v].cells >= SMALLEST || *v == largest;
            let weight = |v: usize| map.voids[v].volume * common[v] as f64 / all[v] as f64;
            let whole: f64 = touched().map(weight).sum();
            let taken: f64 = touched().filter(takes).map(weight).sum();
            // What is in pieces too small to hold gas is pressed into the others at once.
            let left = pocket.volume * taken / whole;
            if taken < whole {
                let pressed = self.energy_of(pocket.share, left);
                self.lost += self.energy_of(pocket.share, pocket.volume) - pressed;
            }
            for v in touched().filter(takes) {
                let part = weight(v) / taken;
                portions[v].push(Portion {
                    share: part * pocket.share,
                    volume: part * left,
                });
            }
        }
        portions
    }

    /// Volume of each void that was void without gas, m3: that of the empty voids which went into it, and what lies where it
    /// was not looked for voids before.
    fn opened(
        &self,
        map: &Map,
        search: Part,
        empty: &[Vec<usize>],
        geometry: Geometry,
    ) -> Vec<f64> {
        let mut opened = vec![0.0; map.voids.len()];
        for (volume, common) in self.cells.empty.iter().zip(empty) {
            let sum: usize = common.iter().sum();
            for (opened, cells) in opened.iter_mut().zip(common).filter(|(_, c)| **c > 0) {
                *opened += volume * *cells as f64 / sum as f64;
            }
        }
        let [from, to] = self.cells.seen;
        if (0..2).all(|k| from[k] <= search[0][k] && search[1][k] <= to[k]) {
            return opened;
        }
        let (mut unseen, mut whole) = (vec![0.0; opened.len()], vec![0.0; opened.len()]);
        for (k, &label) in map.label.iter().enumerate().filter(|(_, l)| **l > 0) {
            let cell = [
                search[0][0] + k % map.size[0],
                search[0][1] + k / map.size[0],
            ];
            let weight = ring(&self.law, geometry, cell[0]);
            whole[label as usize - 1] += weight;
            if !(0..2).all(|k| from[k] <= cell[k] && cell[k] < to[k]) {
                unseen[label as usize - 1] += weight;
            }
        }
        for (v, void) in map.voids.iter().enumerate() {
            opened[v] += void.volume * unseen[v] / whole[v];
        }
        opened
    }
}
