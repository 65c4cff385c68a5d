//! Neighbour lists for smoothing lengths that vary in space.
//!
//! Particles a and b are neighbours when |x_a - x_b| < SUPPORT (h_a + h_b)/2 (1 + skin). Particles are sorted into
//! one cell grid per factor of two in h; each particle searches every grid with the radius that grid needs.

use crate::geometry::Vec2;
use crate::kernel::SUPPORT;
use rayon::prelude::*;

/// Rows handled by one task; results do not depend on it.
const CHUNK: usize = 256;

/// Neighbours of each real particle, in ascending order, without the particle itself.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Neighbours {
    start: Vec<usize>,
    index: Vec<u32>,
}

impl Neighbours {
    /// Lists the neighbours of the first `n_real` particles among all particles (ghosts come after the real ones).
    ///
    /// `position` (m) and `smoothing_length` (m, positive) have one entry per particle. `skin` widens the pair
    /// radius by that fraction. Particles at places that are not finite have no neighbours.
    ///
    /// # Panics
    /// When the two arrays differ in length or hold fewer than `n_real` or more than 2^32 - 1 particles.
    #[must_use]
    pub fn build(position: &[Vec2], smoothing_length: &[f64], n_real: usize, skin: f64) -> Self {
        assert_eq!(
            position.len(),
            smoothing_length.len(),
            "one smoothing length per particle"
        );
        assert!(
            n_real <= position.len(),
            "more real particles than particles"
        );
        assert!(u32::try_from(position.len()).is_ok(), "too many particles");
        let factor = 0.5 * SUPPORT * (1.0 + skin);
        let grids = Grid::levels(position, smoothing_length, factor);
        let chunks: Vec<Chunk> = (0..n_real.div_ceil(CHUNK))
            .into_par_iter()
            .map(|c| {
                let rows = c * CHUNK..n_real.min((c + 1) * CHUNK);
                Chunk::search(&grids, position, smoothing_length, rows, factor)
            })
            .collect();
        Self::join(n_real, &chunks)
    }

    fn join(n_real: usize, chunks: &[Chunk]) -> Self {
        let mut start = Vec::with_capacity(n_real + 1);
        start.push(0);
        let mut total = 0;
        for count in chunks.iter().flat_map(|chunk| &chunk.count) {
            total += count;
            start.push(total);
        }
        let mut index = Vec::with_capacity(total);
        for chunk in chunks {
            index.extend_from_slice(&chunk.index);
        }
        Self { start, index }
    }

    /// Neighbours of particle `a` in ascending order.
    #[must_use]
    pub fn of(&self, a: usize) -> &[u32] {
        &self.index[self.start[a]..self.start[a + 1]]
    }

    /// Number of particles that have a list.
    #[must_use]
    pub fn len(&self) -> usize {
        self.start.len().saturating_sub(1)
    }

    /// Whether there are no lists.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Number of directed pairs.
    #[must_use]
    pub fn pairs(&self) -> usize {
        self.index.len()
    }

    /// Offsets into `index`, one more than particles.
    #[must_use]
    pub fn start(&self) -> &[usize] {
        &self.start
    }

    /// All lists behind each other.
    #[must_use]
    pub fn index(&self) -> &[u32] {
        &self.index
    }
}

/// The order that sorts particles by cells: the new particle i is the old particle `order[i]`.
///
/// Stable within a cell; finest grid first, rows along the first coordinate. Keeping particles in this order makes
/// neighbours neighbours in memory.
///
/// # Panics
/// When the two arrays differ in length.
#[must_use]
pub fn cell_order(position: &[Vec2], smoothing_length: &[f64]) -> Vec<u32> {
    assert_eq!(
        position.len(),
        smoothing_length.len(),
        "one smoothing length per particle"
    );
    Grid::levels(position, smoothing_length, 0.5 * SUPPORT)
        .iter()
        .flat_map(|grid| grid.member.iter().map(|m| m.index))
        .collect()
}

/// What the search reads of a particle, in cell order.
#[derive(Clone, Copy)]
struct Member {
    position: Vec2,
    smoothing_length: f64,
    index: u32,
}

/// Cells over the particles of one range of smoothing lengths.
struct Grid {
    largest: f64,
    lower: Vec2,
    per_cell: Vec2,
    cells: [usize; 2],
    /// First member of each cell, row by row, and one more.
    start: Vec<u32>,
    member: Vec<Member>,
}

impl Grid {
    /// One grid per factor of two in smoothing length, the finest first; ranges without particles have none.
    fn levels(position: &[Vec2], smoothing_length: &[f64], factor: f64) -> Vec<Self> {
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

    fn row(&self, y: f64) -> usize {
        self.bin(1, y)
    }

    /// Places outside the grid and places that are not finite go to the cells on its edge.
    fn bin(&self, k: usize, x: f64) -> usize {
        (((x - self.lower[k]) * self.per_cell[k]) as usize).min(self.cells[k] - 1)
    }

    /// Members of the cells of one row that reach from `from` to `to`.
    fn range(&self, row: usize, from: f64, to: f64) -> &[Member] {
        let first = row * self.cells[0];
        let (from, to) = (first + self.column(from), first + self.column(to) + 1);
        &self.member[self.start[from] as usize..self.start[to] as usize]
    }

    /// Whether a square of half side `reach` about `x` touches the grid.
    fn touches(&self, x: Vec2, reach: f64) -> bool {
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

/// Lists of consecutive particles.
struct Chunk {
    count: Vec<usize>,
    index: Vec<u32>,
}

impl Chunk {
    fn search(
        grids: &[Grid],
        position: &[Vec2],
        smoothing_length: &[f64],
        rows: std::ops::Range<usize>,
        factor: f64,
    ) -> Self {
        let mut chunk = Self {
            count: Vec::with_capacity(rows.len()),
            index: Vec::with_capacity(rows.len() * 28),
        };
        let mut found = vec![0; 64];
        for a in rows {
            let n = collect(grids, position[a], smoothing_length[a], factor, &mut found);
            let list = &mut found[..n];
            list.sort_unstable();
            let before = chunk.index.len();
            chunk
                .index
                .extend(list.iter().filter(|&&b| b as usize != a));
            chunk.count.push(chunk.index.len() - before);
        }
        chunk
    }
}

/// Writes all particles closer than the pair radius (the particle itself included) to `found` and returns their
/// number.
fn collect(grids: &[Grid], x: Vec2, h: f64, factor: f64, found: &mut Vec<u32>) -> usize {
    let mut n = 0;
    for grid in grids {
        let reach = factor * (h + grid.largest);
        if !grid.touches(x, reach) {
            continue;
        }
        for row in grid.row(x[1] - reach)..=grid.row(x[1] + reach) {
            let candidates = grid.range(row, x[0] - reach, x[0] + reach);
            if found.len() < n + candidates.len() {
                found.resize(2 * (n + candidates.len()), 0);
            }
            // Every candidate is written and kept by advancing: a branch here would be guessed wrong half the time.
            for b in candidates {
                let d = [x[0] - b.position[0], x[1] - b.position[1]];
                let radius = factor * (h + b.smoothing_length);
                found[n] = b.index;
                n += usize::from(d[0] * d[0] + d[1] * d[1] < radius * radius);
            }
        }
    }
    n
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(n: usize, seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ n as u64;
        move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    fn brute_force(x: &[Vec2], h: &[f64], a: usize, skin: f64) -> Vec<u32> {
        let near = |b: &usize| {
            let radius = 0.5 * SUPPORT * (1.0 + skin) * (h[a] + h[*b]);
            *b != a && (x[a][0] - x[*b][0]).hypot(x[a][1] - x[*b][1]) < radius
        };
        (0..x.len()).filter(near).map(|b| b as u32).collect()
    }

    /// Random places, smoothing lengths in a ratio of 1:8 (graded or not).
    fn cloud(n: usize, seed: u64, graded: bool) -> (Vec<Vec2>, Vec<f64>) {
        let mut next = random(n, seed);
        let x: Vec<Vec2> = (0..n).map(|_| [next() - 0.3, 2.0 * next()]).collect();
        let h = x
            .iter()
            .map(|x| 0.01 * (1.0 + 7.0 * if graded { x[0] + 0.3 } else { next() }))
            .collect();
        (x, h)
    }

    #[test]
    fn equals_brute_force() {
        for (seed, n) in [0, 1, 2, 3, 17, 300, 1500].into_iter().enumerate() {
            for graded in [true, false] {
                let (mut x, h) = cloud(n, seed as u64, graded);
                if n > 10 {
                    x[7] = x[3]; // coincident
                    x[5] = [1e3, -4e2]; // stray, far outside
                }
                for skin in [0.0, 0.15] {
                    for n_real in [n, n / 2] {
                        let list = Neighbours::build(&x, &h, n_real, skin);
                        assert_eq!(list.len(), n_real);
                        for a in 0..n_real {
                            assert_eq!(list.of(a), brute_force(&x, &h, a, skin), "particle {a}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn places_that_are_not_finite_have_no_neighbours() {
        let (mut x, h) = cloud(50, 1, true);
        x[4] = [f64::NAN, 0.5];
        x[9] = [f64::INFINITY, f64::NEG_INFINITY];
        let list = Neighbours::build(&x, &h, 50, 0.0);
        assert!(list.of(4).is_empty() && list.of(9).is_empty());
        assert_eq!(list.of(11), brute_force(&x, &h, 11, 0.0));
    }

    #[test]
    fn does_not_depend_on_threads() {
        let (x, h) = cloud(3000, 5, true);
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| Neighbours::build(&x, &h, 3000, 0.0))
        };
        assert_eq!(with(1), with(3));
    }

    #[test]
    fn cell_order_is_a_stable_permutation_that_brings_neighbours_together() {
        let (mut x, h) = cloud(2000, 9, true);
        x[1200] = x[100];
        let mut equal_h = h.clone();
        equal_h[1200] = equal_h[100];
        let order = cell_order(&x, &equal_h);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert!(sorted.iter().enumerate().all(|(i, &o)| i == o as usize));
        let place = |p: u32| order.iter().position(|&o| o == p).unwrap();
        assert!(place(100) < place(1200));
        let gap = |x: &[Vec2], h: &[f64]| {
            let list = Neighbours::build(x, h, x.len(), 0.0);
            let distance = |a: usize| list.of(a).iter().map(move |&b| a.abs_diff(b as usize));
            let total: usize = (0..x.len()).flat_map(distance).sum();
            total as f64 / list.pairs() as f64
        };
        let moved: Vec<Vec2> = order.iter().map(|&o| x[o as usize]).collect();
        let moved_h: Vec<f64> = order.iter().map(|&o| equal_h[o as usize]).collect();
        assert!(gap(&moved, &moved_h) < 0.3 * gap(&x, &equal_h));
    }

    /// Prints the speed: `cargo test --release -p erode-sph neighbours -- --ignored --nocapture`.
    #[test]
    #[ignore = "a measurement"]
    fn speed() {
        for ratio in [1.0, 8.0_f64] {
            let (x, h) = sheet(ratio);
            let order = cell_order(&x, &h);
            let x: Vec<Vec2> = order.iter().map(|&o| x[o as usize]).collect();
            let h: Vec<f64> = order.iter().map(|&o| h[o as usize]).collect();
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(1)
                .build()
                .unwrap();
            let mut best = f64::INFINITY;
            let mut pairs = 0;
            for _ in 0..20 {
                let clock = std::time::Instant::now();
                pairs = pool.install(|| Neighbours::build(&x, &h, x.len(), 0.05).pairs());
                best = best.min(clock.elapsed().as_secs_f64());
            }
            println!(
                "h 1:{ratio}: {} particles, {:.1} neighbours, {:.1} M pairs/s on one thread",
                x.len(),
                pairs as f64 / x.len() as f64,
                pairs as f64 / best * 1e-6
            );
        }
    }

    /// Jittered columns whose spacing grows from 1 to `ratio` along x, about 40 000 particles.
    fn sheet(ratio: f64) -> (Vec<Vec2>, Vec<f64>) {
        let mut next = random(1, 3);
        let (mut x, mut h) = (Vec::new(), Vec::new());
        let mut at = 0.0;
        while x.len() < 40_000 {
            let s = 1.0 + (ratio - 1.0) * (x.len() as f64 / 40_000.0).powi(2);
            for j in 0..(800.0 / s) as usize {
                x.push([at + 0.2 * s * next(), (j as f64 + 0.2 * next()) * s]);
                h.push(1.3 * s);
            }
            at += s;
        }
        (x, h)
    }
}
