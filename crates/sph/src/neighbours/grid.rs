//! Cells that hold the particles of one range of smoothing lengths.

use crate::geometry::Vec2;

/// What the search reads of a particle, in cell order.
#[derive(Clone, Copy)]
pub(super) struct Member {
    pub(super) position: Vec2,
    pub(super) smoothing_length: f64,
    pub(super) index: u32,
}

/// Cells over the particles of one range of smoothing lengths.
pub(super) struct Grid {
    /// Largest smoothing length, m.
    pub(super) largest: f64,
    lower: Vec2,
    per_cell: Vec2,
    cells: [usize; 2],
    /// First member of each cell, row by row, and one more.
    start: Vec<u32>,
    pub(super) member: Vec<Member>,
}

impl Grid {
    /// One grid per factor of two in smoothing length, the finest first; ranges without particles have none.
    pub(super) fn levels(position: &[Vec2], smoothing_length: &[f64], factor: f64) -> Vec<Self> {
        let smallest = smoothing_length
            .iter()
            .copied()
            .filter(|h| *h > 0.0)
            .fold(f64::INFINITY, f64::min);
        let mut levels: Vec<Vec<Member>> = Vec::new();
        for (i, (&position, &smoothing_length)) in position.iter().zip(smoothing_length).enumerate()
        {
            // A cast of a negative number or NaN gives level 0.
            let level = ((smoothing_length / smallest).log2() as usize).min(63);
            if levels.len() <= level {
                levels.resize_with(level + 1, Vec::new);
            }
            levels[level].push(Member {
                position,
                smoothing_length,
                index: i as u32,
            });
        }
        levels.retain(|members| !members.is_empty());
        levels
            .into_iter()
            .map(|members| Self::new(&members, factor))
            .collect()
    }

    fn new(members: &[Member], factor: f64) -> Self {
        let largest = members
            .iter()
            .map(|m| m.smoothing_length)
            .fold(0.0, f64::max);
        let mut lower = [f64::INFINITY; 2];
        let mut upper = [f64::NEG_INFINITY; 2];
        for m in members
            .iter()
            .filter(|m| m.position.iter().all(|x| x.is_finite()))
        {
            for k in 0..2 {
                lower[k] = lower[k].min(m.position[k]);
                upper[k] = upper[k].max(m.position[k]);
            }
        }
        let (per_cell, cells) = cell_layout(lower, upper, factor * largest, members.len());
        let mut grid = Self {
            largest,
            lower,
            per_cell,
            cells,
            start: Vec::new(),
            member: Vec::new(),
        };
        grid.sort(members);
        grid
    }

    /// Stable counting sort of the members by cell.
    fn sort(&mut self, members: &[Member]) {
        let cell: Vec<usize> = members
            .iter()
            .map(|m| self.column(m.position[0]) + self.cells[0] * self.row(m.position[1]))
            .collect();
        self.start = vec![0; self.cells[0] * self.cells[1] + 1];
        for &c in &cell {
            self.start[c + 1] += 1;
        }
        for c in 1..self.start.len() {
            self.start[c] += self.start[c - 1];
        }
        let mut next = self.start.clone();
        let mut order = vec![0; members.len()];
        for (i, &c) in cell.iter().enumerate() {
            order[next[c] as usize] = i;
            next[c] += 1;
        }
        self.member = order.into_iter().map(|i| members[i]).collect();
    }

    fn column(&self, x: f64) -> usize {
        self.bin(0, x)
    }

    pub(super) fn row(&self, y: f64) -> usize {
        self.bin(1, y)
    }

    /// Places outside the grid and places that are not finite go to the cells on its edge.
    fn bin(&self, k: usize, x: f64) -> usize {
        (((x - self.lower[k]) * self.per_cell[k]) as usize).min(self.cells[k] - 1)
    }

    /// Members of the cells of one row that reach from `from` to `to`.
    pub(super) fn range(&self, row: usize, from: f64, to: f64) -> &[Member] {
        let first = row * self.cells[0];
        let (from, to) = (first + self.column(from), first + self.column(to) + 1);
        &self.member[self.start[from] as usize..self.start[to] as usize]
    }

    /// Whether a square of half side `reach` about `x` touches the grid.
    pub(super) fn touches(&self, x: Vec2, reach: f64) -> bool {
        (0..2).all(|k| {
            let place = (x[k] - self.lower[k]) * self.per_cell[k];
            let margin = reach * self.per_cell[k];
            place + margin >= 0.0 && place - margin <= self.cells[k] as f64
        })
    }
}

/// Cells per metre and numbers of cells: half a pair radius high and a quarter wide, larger when that would give
/// many more cells than particles.
fn cell_layout(lower: Vec2, upper: Vec2, radius: f64, particles: usize) -> (Vec2, [usize; 2]) {
    let limit = (4 * particles + 64) as f64;
    let mut size = [0.5 * radius, radius];
    for _ in 0..2100 {
        let number = [0, 1].map(|k| ((upper[k] - lower[k]) / size[k]).floor().max(0.0) + 1.0);
        if number[0] * number[1] <= limit {
            return (size.map(f64::recip), number.map(|n| n as usize));
        }
        size = size.map(|s| 2.0 * s);
    }
    ([0.0; 2], [1; 2])
}
