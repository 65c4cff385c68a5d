use super::*;
use crate::cavity::Void;
use crate::fluid::Start;
use crate::fluid::corrected::Settings;
use erode_physics::eos::Tait;
use std::f64::consts::PI;

/// A map with one void per digit; the first text is its uppermost row. Each cell has a volume of 1 m3.
fn map(rows: &[&str]) -> Map {
    let digit = |c: char| c.to_digit(10).unwrap_or(0);
    let label: Vec<u32> = rows
        .iter()
        .rev()
        .flat_map(|r| r.chars().map(digit))
        .collect();
    let count = label.iter().copied().max().unwrap_or(0);
    let void = |l: u32| {
        let mut void = Void::default();
        void.cells = label.iter().filter(|k| **k == l).count();
        void.volume = void.cells as f64;
        void
    };
    let size = [rows[0].len(), rows.len()];
    Map {
        window: law(size).window([[0, 0], size]),
        size,
        voids: (1..=count).map(void).collect(),
        label,
    }
}

fn law(size: [usize; 2]) -> GasLaw {
    GasLaw {
        pressure: 1e5,
        polytropic_exponent: 1.4,
        limits: [[0.0; 2], size.map(|n| n as f64)],
        ends: [[true; 2]; 2],
        cell: 1.0,
    }
}

/// Gas in the first voids of a map, with these shares of 24 m3 at 100 kPa; the other voids are empty.
fn gas(map: &Map, shares: &[f64]) -> Gas {
    let (law, pockets) = (law(map.size), shares.len());
    let pocket = |(share, void): (&f64, &Void)| Pocket {
        share: *share,
        volume: void.volume,
        pressure: law.pressure_in(24.0, *share, void.volume),
    };
    let pocket_of: Vec<usize> = (0..=map.voids.len())
        .map(|l| if l <= pockets { l } else { 0 })
        .collect();
    Gas {
        law,
        first_volume: 24.0,
        pockets: shares.iter().zip(&map.voids).map(pocket).collect(),
        lost: 0.0,
        closed: 0,
        cut: 0,
        first_cell: law.cell,
        cells: Cells::of(map, [[0, 0], map.size], &pocket_of, pockets).0,
    }
}

impl Gas {
    fn meet(&mut self, map: &Map) -> Vec<usize> {
        let all = [[0, 0], map.size];
        let pocket_of = self.hand_on(map, all, Geometry::Plane);
        self.cells = Cells::of(map, all, &pocket_of, self.pockets.len()).0;
        pocket_of
    }
}

/// p V/(k - 1) of a share x of gas that has 100 kPa in 24 m3, J.
fn energy(share: f64, volume: f64) -> f64 {
    1e5 * (share * 24.0 / volume).powf(1.4) * volume / 0.4
}

const ONE: [&str; 2] = ["111111111111", "111111111111"];

#[test]
fn a_pocket_that_parts_shares_its_gas_by_volume() {
    let mut gas = gas(&map(&ONE), &[1.0]);
    let pocket_of = gas.meet(&map(&["1111111.2222", "1111111.2222"]));
    assert_eq!(pocket_of, [0, 1, 2]);
    let shares: Vec<f64> = gas.pockets.iter().map(|p| p.share).collect();
    assert!((shares[0] - 14.0 / 22.0).abs() < 1e-14 && (shares[1] - 8.0 / 22.0).abs() < 1e-14);
    // Both have the pressure of the whole: nothing is lost.
    let pressed = 1e5 * (24.0_f64 / 22.0).powf(1.4);
    assert!(
        gas.pockets
            .iter()
            .all(|p| (p.pressure / pressed - 1.0).abs() < 1e-12)
    );
    assert!(gas.lost.abs() < 1e-9 * energy(1.0, 24.0) && gas.closed == 0);
}

#[test]
fn pockets_that_meet_lose_what_their_pressures_differ_by() {
    let apart = map(&["111111222222", "111111222222"]);
    for (shares, equal) in [([0.5, 0.5], true), ([0.25, 0.75], false)] {
        let mut gas = gas(&apart, &shares);
        let before = gas.energy();
        gas.meet(&map(&ONE));
        assert_eq!(gas.pockets.len(), 1);
        assert!((gas.pockets[0].share - 1.0).abs() < 1e-14);
        let exact = energy(shares[0], 12.0) + energy(shares[1], 12.0) - energy(1.0, 24.0);
        assert!((gas.lost - exact).abs() < 1e-12 * before, "{}", gas.lost);
        assert_eq!(gas.lost < 1e-12 * before, equal);
        assert!(((gas.energy() + gas.lost) / before - 1.0).abs() < 1e-12);
    }
}

#[test]
fn gas_of_a_pocket_that_closes_is_counted() {
    let mut gas = gas(&map(&ONE), &[1.0]);
    assert_eq!(gas.meet(&map(&["............"])), [0]);
    assert_eq!((gas.closed, gas.pockets.len(), gas.energy()), (1, 0, 0.0));
    assert!((gas.lost / energy(1.0, 24.0) - 1.0).abs() < 1e-12);
}

#[test]
fn a_pocket_that_opens_into_an_empty_void_does_no_work_on_it() {
    // The second void holds no gas and is seen only in part: one more row of it lies below.
    let before = ["111111.22222", "111111.22222", "............"];
    let mut gas = gas(&map(&before), &[1.0]);
    gas.cells.seen[0][1] = 1;
    let full = gas.energy();
    gas.meet(&map(&["111111111111", "111111.11111", ".......11111"]));
    // 12 m3 of gas, 10 m3 of void that was seen, 5 m3 that was not; the cell between them opened meanwhile, with work.
    let exact = energy(1.0, 12.0) - energy(1.0, 27.0);
    assert!(
        (gas.lost / exact - 1.0).abs() < 1e-12,
        "{} {exact}",
        gas.lost
    );
    let pressure = 1e5 * (24.0_f64 / 28.0).powf(1.4);
    assert!((gas.pockets[0].pressure / pressure - 1.0).abs() < 1e-12);
    let work = energy(1.0, 27.0) - energy(1.0, 28.0);
    assert!(((gas.energy() + gas.lost + work) / full - 1.0).abs() < 1e-12);
}

#[test]
fn a_piece_that_comes_off_and_returns_leaves_no_trace() {
    let (whole, parted) = (map(&ONE), map(&["11111111.222", "11111111...."]));
    let mut gas = gas(&whole, &[1.0]);
    for _ in 0..3 {
        // Three cells are too few to hold gas. 24 m3 become 16 + 3 with work on all of it; then the 3 are lost to it.
        let pocket_of = gas.meet(&parted);
        assert_eq!((pocket_of, gas.pockets[0].share), (vec![0, 1, 0], 1.0));
        let pressed = energy(1.0, 24.0 * 16.0 / 19.0) - energy(1.0, 24.0);
        assert!(
            (gas.lost + pressed).abs() < 1e-12 * pressed,
            "{} {pressed}",
            gas.lost
        );
        gas.meet(&whole);
        let back = energy(1.0, 16.0) - energy(1.0, 19.0);
        assert!((gas.lost + pressed - back).abs() < 1e-9 * pressed);
        gas.lost = 0.0;
    }
}

#[test]
fn a_void_that_goes_on_beyond_the_search_is_looked_for_there() {
    let mut gas = gas(&map(&ONE), &[1.0]);
    gas.law.limits = [[0.0; 2], [40.0, 9.0]];
    let search = [[0, 0], [12, 3]];
    let seen = |rows: &[&str]| map(rows);
    // It ends before all sides that are no limits.
    let inside = seen(&["............", "11111111111.", "11111111111."]);
    assert_eq!(gas.wider(&inside, search), None);
    // Another void may touch them.
    let other = seen(&["222222222222", "............", "11111111111."]);
    assert_eq!(gas.wider(&other, search), None);
    let right = seen(&["............", "111111111111", "111111111111"]);
    assert_eq!(gas.wider(&right, search), Some([[0, 0], [24, 3]]));
    let up = seen(&["11..........", "11111111111.", "11111111111."]);
    assert_eq!(gas.wider(&up, search), Some([[0, 0], [12, 6]]));
    // Never beyond the limits.
    gas.law.limits[1] = [12.0, 3.0];
    assert_eq!(gas.wider(&right, search), None);
}

#[test]
fn halved_and_doubled_cells_belong_to_the_same_voids() {
    let map = map(&["11.11.222222", "111111.22222", "11.....33.11"]);
    let gas = gas(&map, &[0.5, 0.25]);
    let fine = gas.cells.halved();
    for j in 0..8 {
        for i in 0..26 {
            assert_eq!(fine.owner([i, j]), gas.cells.owner([i / 2, j / 2]));
        }
    }
    assert_eq!(fine.seen, [[0, 0], [24, 6]]);
    let back = fine.doubled();
    for j in 0..4 {
        for i in 0..13 {
            assert_eq!(back.owner([i, j]), gas.cells.owner([i, j]));
        }
    }
    // Cells at odd places too: none of a void is forgotten.
    let coarse = gas.cells.doubled();
    for j in 0..3 {
        for i in 0..12 {
            assert!(gas.cells.owner([i, j]).is_none() || coarse.owner([i / 2, j / 2]).is_some());
        }
    }
}

const DX: f64 = 0.1;

/// Water on a lattice up to 2 m from the axis, without the parts where `void` is true.
fn water(void: impl Fn(f64, f64) -> bool) -> Fluid {
    let at = |i: i32| (f64::from(i) + 0.5) * DX;
    let position: Vec<Vec2> = (0..20)
        .flat_map(|i| (-20..70).map(move |j| [at(i), at(j)]))
        .filter(|x| !void(x[0], x[1]))
        .collect();
    Fluid::new(&Start {
        geometry: Geometry::Axisymmetric,
        eos: Tait {
            reference_density: 1000.0,
            sound_speed: 1500.0,
            gamma: 7.0,
        },
        area: &vec![DX * DX; position.len()],
        position: &position,
        pressure: 1e5,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings::default()),
    })
}

#[test]
fn a_large_empty_void_that_opens_is_filled_as_a_whole() {
    let ball = |r: f64, z: f64| r.hypot(z) < 1.0;
    // A pipe from 1.6 m up to 5.6 m, far beyond the part that is searched.
    let pipe = |r: f64, z: f64| r < 0.8 && z > 1.6 && z < 5.6;
    let law = GasLaw {
        limits: [[0.0, -1.8], [1.8, 6.5]],
        cell: 0.5 * DX,
        ..law([1, 1])
    };
    let ghosts = |f: &Fluid| Ghosts::find(f, &[]);
    let first = water(ball);
    let mut gas = Gas::fill(law, &first, &ghosts(&first)).unwrap();
    let apart = water(|r, z| ball(r, z) || pipe(r, z));
    gas.follow(&apart, &ghosts(&apart));
    let before = gas.volume();
    assert!((before / gas.first_volume - 1.0).abs() < 1e-3 && gas.lost == 0.0);
    let hole = |r: f64, z: f64| r < 0.3 && z > 0.0 && z < 1.7;
    let opened = water(|r, z| ball(r, z) || pipe(r, z) || hole(r, z));
    gas.follow(&opened, &ghosts(&opened));
    // The lattice meets pipe and hole exactly; the ball to 2 %.
    let pipe = PI * 0.64 * 4.0;
    let exact = 4.0 / 3.0 * PI + pipe + PI * 0.09 * 0.65;
    assert_eq!(gas.pockets.len(), 1);
    assert!(
        (gas.volume() / exact - 1.0).abs() < 0.02,
        "{} {exact}",
        gas.volume()
    );
    let one = |v: f64| gas.energy_of(1.0, v);
    let lost = one(before) - one(before + pipe);
    assert!((gas.lost / lost - 1.0).abs() < 0.02, "{} {lost}", gas.lost);
}

#[test]
fn pockets_beyond_a_limit_are_counted_unless_the_liquid_ends_there() {
    let fluid = water(|r, z| r.hypot(z) < 1.0);
    let ghosts = Ghosts::find(&fluid, &[]);
    let cut = |limits: [Vec2; 2], ends: [[bool; 2]; 2]| {
        let law = GasLaw {
            limits,
            ends,
            cell: 0.5 * DX,
            ..law([1, 1])
        };
        Gas::fill(law, &fluid, &ghosts).unwrap().cut
    };
    let axis = [[true, false], [false; 2]];
    assert_eq!(cut([[0.0, -1.5], [1.5, 1.5]], axis), 0);
    assert_eq!(cut([[0.0, -1.5], [1.5, 1.5]], [[false; 2]; 2]), 1);
    assert_eq!(cut([[0.0, -0.5], [1.5, 1.5]], axis), 1);
    assert_eq!(cut([[0.0, -0.5], [1.5, 1.5]], [[true; 2], [false; 2]]), 0);
    assert_eq!(cut([[0.0, -1.5], [0.5, 1.5]], axis), 1);
    assert_eq!(cut([[0.0, -1.5], [1.5, 0.5]], axis), 1);
    assert_eq!(
        cut([[0.0, -1.5], [1.5, 0.5]], [[true, false], [false, true]]),
        0
    );
}
