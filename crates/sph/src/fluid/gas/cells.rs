//! The cells of pockets and of empty voids.

use crate::cavity::Map;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// First cell of a part of the plane, and one past the last.
pub(super) type Part = [[usize; 2]; 2];

/// Cells of the voids. They have whole-number places from the lower limit on, so that windows fit together.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub(super) struct Cells {
    /// In the order of their cells: by row, then along it.
    runs: Vec<Run>,
    /// Volumes of the voids without gas, m3.
    pub(super) empty: Vec<f64>,
    /// The part in which all of these were looked for.
    pub(super) seen: Part,
    /// The part to be searched next.
    pub(super) search: Part,
}

/// Cells of a void side by side in a row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
struct Run {
    first: [usize; 2],
    count: usize,
    /// Pocket, or after the last of them empty void.
    owner: usize,
}

impl Cells {
    /// Cells of the voids in a map of the part `seen`, and the box around those of the pockets. `pocket_of` gives the
    /// pocket of each label from 1; 0 for none.
    pub(super) fn of(map: &Map, seen: Part, pocket_of: &[usize], pockets: usize) -> (Self, Part) {
        let mut owner = vec![None; pocket_of.len()];
        let mut empty = Vec::new();
        for label in 1..pocket_of.len() {
            owner[label] = Some(if pocket_of[label] > 0 {
                pocket_of[label] - 1
            } else {
                empty.push(map.voids[label - 1].volume);
                pockets + empty.len() - 1
            });
        }
        let (mut runs, mut low, mut high) = (Vec::new(), [usize::MAX; 2], [0; 2]);
        let width = map.size[0];
        for (j, row) in map.label.chunks(width).enumerate() {
            let mut begin = 0;
            for cells in row.chunk_by(|a, b| a == b) {
                let (first, count) = ([begin + seen[0][0], j + seen[0][1]], cells.len());
                begin += count;
                let Some(owner) = owner[cells[0] as usize] else {
                    continue;
                };
                runs.push(Run {
                    first,
                    count,
                    owner,
                });
                if owner < pockets {
                    low = [0, 1].map(|k| low[k].min(first[k]));
                    high = [high[0].max(first[0] + count), high[1].max(first[1] + 1)];
                }
            }
        }
        let cells = Self {
            runs,
            empty,
            seen,
            search: Part::default(),
        };
        (cells, [low, high])
    }

    /// The same with four cells in the place of each.
    pub(super) fn halved(&self) -> Self {
        let twice = |part: Part| part.map(|corner| corner.map(|c| 2 * c));
        let half = |r: &Run, row: usize| Run {
            first: [2 * r.first[0], 2 * r.first[1] + row],
            count: 2 * r.count,
            owner: r.owner,
        };
        let rows = self.runs.chunk_by(|a, b| a.first[1] == b.first[1]);
        Self {
            runs: rows
                .flat_map(|row| (0..2).flat_map(move |k| row.iter().map(move |r| half(r, k))))
                .collect(),
            empty: self.empty.clone(),
            seen: twice(self.seen),
            search: twice(self.search),
        }
    }

    /// The same with one cell in the place of each four; it belongs to the first of them that is no liquid.
    pub(super) fn doubled(&self) -> Self {
        let half = |[from, to]: Part| [from.map(|c| c / 2), to.map(|c| c.div_ceil(2))];
        let mut runs: Vec<Run> = Vec::new();
        for rows in (self.runs).chunk_by(|a, b| a.first[1] / 2 == b.first[1] / 2) {
            let mut owner = BTreeMap::new();
            for r in rows {
                for i in r.first[0] / 2..(r.first[0] + r.count).div_ceil(2) {
                    owner.entry(i).or_insert(r.owner);
                }
            }
            let place = |i: usize| [i, rows[0].first[1] / 2];
            runs.extend(owner.into_iter().map(|(i, owner)| Run {
                first: place(i),
                count: 1,
                owner,
            }));
        }
        Self {
            runs,
            empty: self.empty.clone(),
            seen: half(self.seen),
            search: half(self.search),
        }
    }

    /// Pocket or empty void of a cell.
    pub(super) fn owner(&self, cell: [usize; 2]) -> Option<usize> {
        let after = |r: &Run| (r.first[1], r.first[0]) <= (cell[1], cell[0]);
        let run = self.runs[..self.runs.partition_point(after)].last()?;
        let inside = run.first[1] == cell[1] && cell[0] < run.first[0] + run.count;
        inside.then_some(run.owner)
    }

    /// Number of cells that each pocket, and after them each empty void, has in common with each void of a map of the
    /// part `search`.
    pub(super) fn common(&self, map: &Map, search: Part, pockets: usize) -> Vec<Vec<usize>> {
        let mut common = vec![vec![0; map.voids.len()]; pockets + self.empty.len()];
        for run in &self.runs {
            for i in run.first[0]..run.first[0] + run.count {
                let label = label(map, search, [i, run.first[1]]);
                if label != 0 {
                    common[run.owner][label - 1] += 1;
                }
            }
        }
        common
    }
}

/// Label of a cell; 0 outside the map.
fn label(map: &Map, search: Part, cell: [usize; 2]) -> usize {
    if cell[0] < search[0][0] || cell[1] < search[0][1] {
        return 0;
    }
    let [i, j] = [0, 1].map(|k| cell[k] - search[0][k]);
    if i < map.size[0] && j < map.size[1] {
        map.label[i + map.size[0] * j] as usize
    } else {
        0
    }
}
