//! The liquid of one impact of a sequence: as that of the case, with the bubble of the impact, on the wall as it is now.
//!
//! Particles are packed above the flat wall and then moved along z with its surface u(r):
//!
//! z' = z + u(r) f(z/L),  A' = A (1 + u f'(z/L)/L),  f = 1 - smoothstep
//!
//! A' keeps the density at rest. L is the gap between wall and bubble, so that the bubble stays where and what it is; where
//! the gap is narrow, four times the largest |u| or eight spacings: the lower side of the bubble then follows the pit.
//! No particle is dropped and none lies in the metal.

use crate::case::{Body, BodyKind, Bubble, Impact, Side, Simulation};
use erode_sph::geometry::Vec2;
use erode_sph::packing::Packing;
use erode_sph::shapes::Shape;
use erode_sph::solid::{QuasiStatic, smoothstep};

/// Bubbles that differ by less are the same: stand-offs are quotients of rounded numbers.
const SAME: f64 = 1e-12;
/// Least way over which the lift of the surface fades, in units of the largest lift and of the finest spacing.
const FADE: [f64; 2] = [4.0, 8.0];

/// The case with the bubble of an impact that begins at `begin`, s. The liquid keeps its extent and its core of fine particles
/// in radii above and beside the bubble; spacing and width stay.
pub(super) fn simulation(base: &Simulation, impact: &Impact, begin: f64) -> Simulation {
    let mut new = base.clone();
    let Some(first) = base.bubble else {
        return new;
    };
    let distance = impact.standoff * impact.radius;
    let same = |a: f64, b: f64| (a - b).abs() <= SAME * b.abs();
    let old = first.wall_distance.unwrap_or(first.centre[1]);
    if !(same(impact.radius, first.radius) && same(distance, old)) {
        let bubble = Bubble {
            centre: [0.0, first.centre[1] - old + distance],
            radius: impact.radius,
            wall_distance: Some(distance),
            ..first
        };
        new.bubble = Some(bubble);
        for body in new.bodies.iter_mut().filter(|b| is_liquid(b)) {
            move_bubble(body, &first, &bubble);
        }
    }
    if let Some(bubble) = &mut new.bubble {
        bubble.driving_pressure = impact.driving_pressure;
    }
    for body in new.bodies.iter_mut().filter(|b| is_liquid(b)) {
        if let Side::NonReflecting {
            pressure,
            wave: Some(wave),
        } = &mut body.sides.top
        {
            if impact.driving_pressure != first.driving_pressure {
                wave.pressure = impact.driving_pressure - *pressure;
            }
            wave.start += begin;
        }
    }
    new.run.end_time = begin + impact.duration;
    new
}

pub(super) fn is_liquid(body: &Body) -> bool {
    matches!(body.kind, BodyKind::Fluid(_))
}

/// Another bubble in a liquid: its hole, the height of the liquid, the core.
fn move_bubble(body: &mut Body, old: &Bubble, new: &Bubble) {
    let ratio = new.radius / old.radius;
    let height = |z: f64| new.centre[1] + (z - old.centre[1]) * ratio;
    body.holes = vec![Shape::Disc {
        centre: new.centre,
        radius: new.radius,
    }];
    if let Shape::Rectangle { upper, .. } = &mut body.shape {
        upper[1] = height(upper[1]);
    }
    if let Some(Shape::Rectangle { upper, .. }) = &mut body.spacing.core {
        *upper = [upper[0] * ratio, height(upper[1])];
    }
}

/// Moves particles that were packed above the flat wall onto its surface, given by its points from the axis outwards.
/// Nothing changes where there are none.
pub(super) fn lay_on(
    packing: &mut Packing,
    surface: &[Vec2],
    flat: f64,
    finest: f64,
    bubble: &Bubble,
) {
    let lift = |r: f64| height_at(surface, r) - flat;
    let largest = surface
        .iter()
        .map(|x| (x[1] - flat).abs())
        .fold(0.0, f64::max);
    if surface.len() < 2 || largest == 0.0 {
        return;
    }
    let gap = bubble.centre[1] - flat - bubble.radius;
    let fade = gap.max(FADE[0] * largest).max(FADE[1] * finest);
    let step = QuasiStatic {
        ramp: fade,
        hold: 0.0,
        damping: 0.0,
    };
    for (x, area) in packing.position.iter_mut().zip(&mut packing.area) {
        let (u, z) = (lift(x[0]), x[1] - flat);
        // The derivative of the smooth step along z.
        *area *= 1.0 - u * step.share(z).rate;
        x[1] += u * (1.0 - smoothstep(z / fade));
    }
}

/// Height of a line of points at `r`, its first and last pieces going on beyond its ends.
fn height_at(line: &[Vec2], r: f64) -> f64 {
    let after = line.partition_point(|p| p[0] <= r);
    let i = after.saturating_sub(1).min(line.len() - 2);
    let (a, b) = (line[i], line[i + 1]);
    a[1] + (b[1] - a[1]) * (r - a[0]) / (b[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    fn case(more: &str) -> Simulation {
        let text = include_str!("../../../../../cases/bubble-near-steel/case.toml");
        Case::parse("case.toml", &format!("{text}\n{more}"), &[]).unwrap()
    }

    #[test]
    fn the_same_bubble_is_the_same_case_bit_for_bit() {
        let base = case("[[impacts.bubble]]\ntimes = 2");
        let impacts = base.impacts.clone().unwrap();
        assert_eq!(simulation(&base, &impacts.bubbles[0], 0.0), base);
        let later = simulation(&base, &impacts.bubbles[1], 1e-6);
        assert_eq!(later.bubble, base.bubble);
        assert_eq!(later.run.end_time, 1e-6 + base.run.end_time);
    }

    #[test]
    fn another_bubble_is_that_of_a_case_of_its_own() {
        let base =
            case("[[impacts.bubble]]\nradius = 0.1e-3\nstandoff = 0.9\ndriving_pressure = 3e7");
        let own = |key: &str, value: &str| format!("setup.bubble_near_wall.{key}={value}");
        // As many particles per radius as the spacing of the sequence makes.
        let own = [
            own("radius", "1e-4"),
            own("standoff", "0.9"),
            own("driving_pressure", "3e7"),
            own("particles_per_radius", "20"),
        ];
        let text = include_str!("../../../../../cases/bubble-near-steel/case.toml");
        let alone = Case::parse("case.toml", text, &own).unwrap();
        let made = simulation(&base, &base.impacts.as_ref().unwrap().bubbles[0], 0.0);
        let (a, b) = (&made.bodies[0], &alone.bodies[0]);
        assert_eq!(made.bubble, alone.bubble);
        assert_eq!(a.holes, b.holes);
        let near = |x: f64, y: f64| (x - y).abs() < 1e-12;
        assert!(near(
            a.shape.bounding_box().1[1],
            b.shape.bounding_box().1[1]
        ));
        let core = |body: &Body| body.spacing.core.as_ref().unwrap().bounding_box().1;
        assert!(near(core(a)[0], core(b)[0]) && near(core(a)[1], core(b)[1]));
        assert!(near(made.run.end_time * 1e6, alone.run.end_time * 1e6));
        assert_eq!(a.sides.top, b.sides.top);
    }

    /// A pit two spacings deep: volume is kept to that of the pit, every particle stays above the metal by what
    /// it was above the flat wall, and the bubble stays a sphere.
    #[test]
    fn liquid_fills_a_pit() {
        let base = case("[[impacts.bubble]]");
        let bubble = base.bubble.unwrap();
        let spacing = 5e-6;
        let mut packing = Packing::default();
        for i in 0..120 {
            for j in 0..160 {
                let at = [i, j].map(|k| (f64::from(k) + 0.5) * spacing);
                packing.position.push(at);
                packing.area.push(spacing * spacing);
            }
        }
        let flat = packing.clone();
        let depth = |r: f64| -10e-6 * (-(r / 60e-6).powi(2)).exp();
        let surface: Vec<Vec2> = (0..120)
            .map(|i| (f64::from(i) + 0.5) * spacing)
            .map(|r| [r, depth(r)])
            .collect();
        lay_on(&mut packing, &surface, 0.0, spacing, &bubble);
        let gap = bubble.centre[1] - bubble.radius;
        for (new, old) in packing.position.iter().zip(&flat.position) {
            assert_eq!(new[0], old[0]);
            if old[1] > gap {
                assert_eq!(new[1], old[1]);
            } else if old[1] < spacing {
                // Half a spacing above the wall the lift has faded by 10 (z/L)^3 = 1e-3 of itself at most.
                assert!((new[1] - depth(new[0]) - old[1]).abs() < 2e-3 * 10e-6);
            }
        }
        let sum = |p: &Packing| p.area.iter().sum::<f64>();
        let pit: f64 = surface.iter().map(|x| -x[1] * spacing).sum();
        // Midpoint sums of smooth functions.
        assert!(((sum(&packing) - sum(&flat)) / pit - 1.0).abs() < 0.01);
    }

    #[test]
    fn a_flat_wall_changes_nothing() {
        let base = case("[[impacts.bubble]]");
        let mut packing = Packing {
            position: vec![[1e-5, 2e-5]],
            area: vec![1e-12],
            ..Packing::default()
        };
        let before = packing.clone();
        for surface in [vec![], vec![[0.0, 0.0], [1e-3, 0.0]]] {
            lay_on(&mut packing, &surface, 0.0, 5e-6, &base.bubble.unwrap());
            assert_eq!(packing, before);
        }
    }
}
