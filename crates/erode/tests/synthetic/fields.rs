//! The snapshots of a synthetic run.

use super::{CENTRE, Has, LARGEST_STRAIN, grown, pressure, radius, times};
use erode::output::{Collection, Data, Encoding, Entry, Field, Snapshot};
use std::path::Path;

pub(crate) fn write_fields(dir: &Path, has: Has) {
    let mut collection = Collection::new(dir.join("fields.pvd"));
    for (index, time) in times(24).enumerate() {
        let mut bodies = vec![("liquid", liquid(time, has))];
        if has.solid {
            bodies.push(("solid", solid(time)));
        }
        let entries: Vec<Entry> = bodies
            .into_iter()
            .enumerate()
            .map(|(part, (name, snapshot))| {
                let file = format!("fields/{name}_{index:06}.vtu");
                snapshot.write(&dir.join(&file), Encoding::Zlib).unwrap();
                Entry {
                    time,
                    part,
                    name: name.into(),
                    file,
                }
            })
            .collect();
        collection.add(entries).unwrap();
    }
}

/// Lattice points of a rectangle: fine where r < 0.4 mm and z < 0.5 mm, twice as coarse outside.
fn lattice(z_range: [f64; 2]) -> (Vec<[f64; 2]>, Vec<f64>) {
    let (mut points, mut sizes) = (Vec::new(), Vec::new());
    for (spacing, fine) in [(5e-6, true), (1e-5, false)] {
        let columns = (8e-4 / spacing) as i32;
        let rows = ((z_range[1] - z_range[0]) / spacing).round() as i32;
        for i in 0..columns {
            for j in 0..rows {
                let p = [
                    (f64::from(i) + 0.5) * spacing,
                    z_range[0] + (f64::from(j) + 0.5) * spacing,
                ];
                if (p[0] < 4e-4 && p[1].abs() < 4.5e-4) == fine {
                    points.push(p);
                    sizes.push(spacing);
                }
            }
        }
    }
    (points, sizes)
}

fn area(sizes: &[f64]) -> Field {
    Field::scalar(
        "area",
        "m2",
        Data::F64(sizes.iter().map(|s| s * s).collect()),
    )
}

fn liquid(time: f64, has: Has) -> Snapshot {
    let hole = if has.bubble { radius(time) } else { 0.0 };
    let (points, sizes) = lattice([0.0, 9e-4]);
    let wet: Vec<usize> = (0..points.len())
        .filter(|k| points[*k][0].hypot(points[*k][1] - CENTRE) > hole)
        .collect();
    let points: Vec<[f64; 2]> = wet.iter().map(|k| points[*k]).collect();
    let sizes: Vec<f64> = wet.iter().map(|k| sizes[*k]).collect();
    let pressures = points.iter().map(|p| pressure(p[0], p[1], time)).collect();
    let velocity = |p: &[f64; 2]| {
        [
            0.0,
            -300.0 * (-(p[0] / 6e-5).powi(2) - ((p[1] - 3e-4) / 1e-4).powi(2)).exp(),
        ]
    };
    let velocities: Vec<[f64; 2]> = points.iter().map(velocity).collect();
    Snapshot::new(time, &points)
        .with(area(&sizes))
        .with(Field::scalar("pressure", "Pa", Data::F64(pressures)))
        .with(Field::vector("velocity", "m/s", &velocities))
}

fn solid(time: f64) -> Snapshot {
    let (points, sizes) = lattice([-6e-4, 0.0]);
    let strain = |p: &[f64; 2]| {
        let away = ((p[0] - 6e-5) / 4e-5).powi(2) + ((p[1] + 1.25e-5) / 3e-5).powi(2);
        let strain = LARGEST_STRAIN * grown(time) * (-away).exp();
        if strain > 1e-5 { strain } else { 0.0 }
    };
    let strains: Vec<f64> = points.iter().map(strain).collect();
    Snapshot::new(time, &points)
        .with(area(&sizes))
        .with(Field::scalar(
            "plastic_strain",
            "-",
            Data::F64(strains.clone()),
        ))
        .with(Field::scalar("von_mises", "Pa", Data::F64(strains)))
        .with(Field::scalar(
            "pressure",
            "Pa",
            Data::F64(vec![0.0; points.len()]),
        ))
}
