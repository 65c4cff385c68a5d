//! Writes small snapshots with known values, for `validation/vtu-reader/check_vtu.py`.
//!
//! `cargo run --release -p erode --example write_snapshot -- DIR [PARTICLES]`

use erode::output::{Collection, Data, Encoding, Entry, Field, OutputError, Snapshot};
use erode_physics::tensor::Sym3;
use std::path::{Path, PathBuf};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("give a folder")?);
    let count: u32 = arguments.next().map_or(Ok(1000), |text| text.parse())?;
    std::fs::create_dir_all(folder.join("fields"))?;
    let mut collection = Collection::new(folder.join("fields.pvd"));
    for (index, (count, encoding)) in [
        (count, Encoding::Raw),
        (count, Encoding::Zlib),
        (0, Encoding::Zlib),
    ]
    .into_iter()
    .enumerate()
    {
        let time = 1e-9 * index as f64;
        let file = format!("fields/liquid_{index:06}.vtu");
        write(&folder.join(&file), time, count, encoding)?;
        let name = "liquid".into();
        collection.add([Entry {
            time,
            part: 0,
            name,
            file,
        }])?;
    }
    Ok(())
}

/// Particle i has the values that the checking script computes again.
fn write(path: &Path, time: f64, count: u32, encoding: Encoding) -> Result<(), OutputError> {
    let all = |value: fn(f64) -> f64| (0..count).map(f64::from).map(value).collect::<Vec<f64>>();
    let positions: Vec<[f64; 2]> = (0..count)
        .map(f64::from)
        .map(|i| [i / 7.0, -i / 3.0])
        .collect();
    let stress = |i: f64| Sym3 {
        xx: i,
        yy: 2.0 * i,
        zz: 3.0 * i,
        xy: 4.0 * i,
        yz: 5.0 * i,
        xz: 6.0 * i,
    };
    let stresses: Vec<Sym3> = (0..count).map(f64::from).map(stress).collect();
    let gradient = (0..9 * count).map(|k| k as f32 / 9.0).collect();
    let snapshot = Snapshot::new(time, &positions)
        .with(Field::scalar(
            "pressure",
            "Pa",
            Data::F64(all(|i| 1e5 + i / 11.0)),
        ))
        .with(Field::scalar(
            "temperature",
            "K",
            Data::F64(vec![f64::NAN; count as usize]),
        ))
        .with(Field::vector("velocity", "m/s", &positions))
        .with(Field::symmetric("stress", "Pa", &stresses))
        .with(Field {
            name: "velocity_gradient".into(),
            unit: "1/s".into(),
            components: 9,
            data: Data::F32(gradient),
        })
        .with(Field::scalar(
            "body",
            "-",
            Data::U8((0..count).map(|i| (i % 5) as u8).collect()),
        ))
        .with(Field::scalar(
            "neighbours",
            "-",
            Data::U32((0..count).map(|i| u32::MAX - i).collect()),
        ))
        .with(Field::scalar(
            "index",
            "-",
            Data::I64((0..count).map(|i| -i64::from(i)).collect()),
        ));
    let start = Instant::now();
    snapshot.write(path, encoding)?;
    println!(
        "{} {count} particles {encoding:?} in {:.3} s",
        path.display(),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}
