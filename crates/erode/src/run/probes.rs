//! Fields at points fixed in space, and snapshots of whole bodies.

use crate::case::BodyKind;
use crate::output::{Column, Data, Field, Snapshot};
use erode_sph::fluid::Fluid;
use erode_sph::geometry::Vec2;
use erode_sph::kernel;
use erode_sph::solid::Solid;
use erode_sph::world::Body;

/// Below this sum of A W there is no support and a probe reads NaN.
const SUPPORT: f64 = 0.3;

const FLUID: [(&str, &str); 4] = [
    ("pressure", "Pa"),
    ("density", "kg/m3"),
    ("velocity_r", "m/s"),
    ("velocity_z", "m/s"),
];
const SOLID: [(&str, &str); 9] = [
    ("stress_rr", "Pa"),
    ("stress_zz", "Pa"),
    ("stress_tt", "Pa"),
    ("stress_rz", "Pa"),
    ("von_mises", "Pa"),
    ("plastic_strain", "-"),
    ("plastic_strain_rate", "1/s"),
    ("velocity_r", "m/s"),
    ("velocity_z", "m/s"),
];

/// Columns of a probe in a body.
#[must_use]
pub(crate) fn columns(body: &BodyKind) -> Vec<Column> {
    let fields: &[(&str, &str)] = match body {
        BodyKind::Fluid(_) => &FLUID,
        BodyKind::Solid(_) => &SOLID,
    };
    std::iter::once(&("time", "s"))
        .chain(fields)
        .map(|(name, unit)| Column::new(*name, *unit))
        .collect()
}

/// One row of a probe: kernel means over the particles around `x`; NaN where there is no support.
#[must_use]
pub(crate) fn row(body: &Body, time: f64, x: Vec2) -> Vec<f64> {
    let values = match body {
        Body::Fluid(f) => mean(
            x,
            &f.position,
            |a| (f.area(a), f.smoothing_length[a]),
            |a| fluid_values(f, a),
        )
        .to_vec(),
        Body::Solid(s) => mean(
            x,
            &s.state.position,
            |a| (area_left(s, a), s.reference.smoothing_length[a]),
            |a| solid_values(s, a),
        )
        .to_vec(),
    };
    std::iter::once(time).chain(values).collect()
}

/// A row of a probe in a body that is not there.
#[must_use]
pub(crate) fn nothing(time: f64, columns: usize) -> Vec<f64> {
    let mut row = vec![f64::NAN; columns];
    row[0] = time;
    row
}

/// Area of a particle, m2; zero where it was removed by failure.
fn area_left(s: &Solid, a: usize) -> f64 {
    if s.is_removed(a) {
        0.0
    } else {
        s.reference.area[a]
    }
}

fn fluid_values(f: &Fluid, a: usize) -> [f64; 4] {
    [
        f.pressure[a],
        f.density(a),
        f.velocity[a][0],
        f.velocity[a][1],
    ]
}

fn solid_values(s: &Solid, a: usize) -> [f64; 9] {
    let (q, t) = (&s.state, s.state.stress[a]);
    let v = q.velocity[a];
    [
        t.xx,
        t.yy,
        t.zz,
        t.xy,
        q.von_mises[a],
        q.plastic_strain[a],
        q.plastic_strain_rate[a],
        v[0],
        v[1],
    ]
}

fn mean<const N: usize>(
    x: Vec2,
    position: &[Vec2],
    size: impl Fn(usize) -> (f64, f64),
    values: impl Fn(usize) -> [f64; N],
) -> [f64; N] {
    let (mut sum, mut weight) = ([0.0; N], 0.0);
    for (a, p) in position.iter().enumerate() {
        let (area, h) = size(a);
        let square = (p[0] - x[0]).powi(2) + (p[1] - x[1]).powi(2);
        if square < (kernel::SUPPORT * h).powi(2) {
            let w = area * kernel::value(square.sqrt(), h);
            weight += w;
            for (s, v) in sum.iter_mut().zip(values(a)) {
                *s += w * v;
            }
        }
    }
    // Half the support lies beyond the axis or a wall for a point on it.
    if weight < SUPPORT {
        [f64::NAN; N]
    } else {
        sum.map(|s| s / weight)
    }
}

/// All fields of a body.
#[must_use]
pub(crate) fn snapshot(body: &Body, time: f64) -> Snapshot {
    match body {
        Body::Fluid(f) => {
            let density: Vec<f64> = (0..f.len()).map(|a| f.density(a)).collect();
            let area: Vec<f64> = (0..f.len()).map(|a| f.area(a)).collect();
            Snapshot::new(time, &f.position)
                .with(Field::scalar(
                    "pressure",
                    "Pa",
                    Data::F64(f.pressure.clone()),
                ))
                .with(Field::scalar("density", "kg/m3", Data::F64(density)))
                .with(Field::vector("velocity", "m/s", &f.velocity))
                .with(Field::scalar(
                    "smoothing_length",
                    "m",
                    Data::F64(f.smoothing_length.clone()),
                ))
                .with(Field::scalar("area", "m2", Data::F64(area)))
                .with(Field::scalar("support", "-", Data::F64(f.support.clone())))
                .with(Field::scalar(
                    "particle_id",
                    "-",
                    Data::U32(f.origin.iter().map(|o| o.id).collect()),
                ))
        }
        Body::Solid(s) => {
            let q = &s.state;
            let snapshot = Snapshot::new(time, &q.position);
            let snapshot = if s.layers.is_empty() {
                snapshot
            } else {
                let layer = (0..s.len()).map(|a| s.layers.index(a) as f64).collect();
                snapshot.with(Field::scalar("material", "-", Data::F64(layer)))
            };
            snapshot
                .with(Field::scalar(
                    "plastic_strain",
                    "-",
                    Data::F64(q.plastic_strain.clone()),
                ))
                .with(Field::scalar(
                    "plastic_strain_rate",
                    "1/s",
                    Data::F64(q.plastic_strain_rate.clone()),
                ))
                .with(Field::scalar(
                    "von_mises",
                    "Pa",
                    Data::F64(q.von_mises.clone()),
                ))
                .with(Field::symmetric("stress", "Pa", &q.stress))
                .with(Field::vector("velocity", "m/s", &q.velocity))
                .with(Field::scalar(
                    "plastic_work",
                    "J/m3",
                    Data::F64(q.plastic_work.clone()),
                ))
                .with(Field::scalar(
                    "temperature",
                    "K",
                    Data::F64(q.temperature.clone()),
                ))
                .with(Field::scalar("damage", "-", Data::F64(q.damage.clone())))
                .with(Field::scalar("removed", "-", Data::F64(q.removed.clone())))
                .with(Field::scalar(
                    "area",
                    "m2",
                    Data::F64(s.reference.area.clone()),
                ))
                .with(Field::scalar(
                    "smoothing_length",
                    "m",
                    Data::F64(s.reference.smoothing_length.clone()),
                ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Case;

    #[test]
    fn fields_of_a_liquid_name_the_particle_of_each_row() {
        let text = include_str!("../cli/templates/bubble-in-liquid.toml");
        let set = ["particles_per_radius=6", "domain=4"];
        let set = set.map(|s| format!("setup.bubble_in_liquid.{s}"));
        let simulation = Case::parse("case.toml", text, &set).unwrap();
        let mut world = crate::run::world(&simulation).unwrap();
        let body = &mut world.bodies[0].body;
        if let Body::Fluid(f) = body {
            f.origin.swap(3, 8);
        }
        let snapshot = snapshot(body, 0.0);
        let Data::U32(ids) = &snapshot.field("particle_id").unwrap().data else {
            panic!("numbers of particles are whole")
        };
        assert_eq!([ids[3], ids[8], ids[9]], [8, 3, 9]);
    }
}
