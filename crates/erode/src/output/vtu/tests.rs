use super::*;
use flate2::read::ZlibDecoder;
use std::fs;
use std::io::Read;

fn snapshot(count: usize) -> Snapshot {
    let real = |i: usize| i as f64;
    let positions: Vec<[f64; 2]> = (0..count)
        .map(|i| [real(i) / 7.0, -real(i) / 3.0])
        .collect();
    let stress = |i| Sym3 {
        xx: real(i),
        yy: 1.0,
        zz: 2.0,
        xy: 3.0,
        xz: 5.0,
        yz: 4.0,
    };
    let pressure = (0..count)
        .map(|i| if i == 1 { f64::NAN } else { 1.0 / real(i + 1) })
        .collect();
    Snapshot::new(1.25e-7, &positions)
        .with(Field::scalar("pressure", "Pa", Data::F64(pressure)))
        .with(Field::vector("velocity", "m/s", &positions))
        .with(Field::symmetric(
            "stress",
            "Pa",
            &(0..count).map(stress).collect::<Vec<_>>(),
        ))
        .with(Field::scalar(
            "neighbours",
            "-",
            Data::U32((0..count as u32).collect()),
        ))
        .with(Field::scalar("body", "-", Data::U8(vec![3; count])))
        .with(Field::scalar(
            "index",
            "-",
            Data::I64((0..count as i64).map(|i| -i).collect()),
        ))
        .with(Field {
            name: "gradient".into(),
            unit: "1/s".into(),
            components: 9,
            data: Data::F32(vec![0.1; 9 * count]),
        })
}

/// Equality that also holds for NaN.
fn same(a: &Snapshot, b: &Snapshot) -> bool {
    format!("{a:?}") == format!("{b:?}")
}

#[test]
fn both_encodings_come_back_exactly() {
    let folder = tempfile::tempdir().unwrap();
    // 40 000 particles fill more than one compressed block; 32 768 numbers of 8 bytes fill exactly one.
    for count in [0, 1, 2, 32_768, 40_000] {
        for encoding in [Encoding::Raw, Encoding::Zlib] {
            let path = folder.path().join("s.vtu");
            let written = snapshot(count);
            written.write(&path, encoding).unwrap();
            assert!(
                same(&Snapshot::read(&path).unwrap(), &written),
                "{count} {encoding:?}"
            );
        }
    }
}

/// Splits a file into its header and the bytes after the underscore, by the rules of the format.
fn parts(bytes: &[u8]) -> (String, &[u8]) {
    let mark = b"<AppendedData encoding=\"raw\">";
    let at = bytes
        .windows(mark.len())
        .position(|part| part == mark)
        .unwrap();
    let underscore = at + bytes[at..].iter().position(|&b| b == b'_').unwrap();
    (
        String::from_utf8(bytes[..underscore].to_vec()).unwrap(),
        &bytes[underscore + 1..],
    )
}

fn offsets(header: &str) -> Vec<usize> {
    let after = header.split("offset=\"").skip(1);
    after
        .map(|rest| rest.split('"').next().unwrap().parse().unwrap())
        .collect()
}

fn u64_at(bytes: &[u8], at: usize) -> usize {
    u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap()) as usize
}

#[test]
fn raw_blocks_lie_where_the_offsets_say_and_have_the_sizes_of_their_types() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vtu");
    snapshot(5).write(&path, Encoding::Raw).unwrap();
    let bytes = fs::read(&path).unwrap();
    let (header, data) = parts(&bytes);
    // In the order of the header: the fields, then points, connectivity, offsets, types.
    let sizes = [
        5 * 8,
        15 * 8,
        30 * 8,
        5 * 4,
        5,
        5 * 8,
        45 * 4,
        15 * 8,
        5 * 8,
        5 * 8,
        5,
    ];
    let offsets = offsets(&header);
    assert_eq!(offsets.len(), sizes.len());
    for (&offset, size) in offsets.iter().zip(sizes) {
        assert_eq!(u64_at(data, offset), size);
    }
    let total: usize = sizes.iter().map(|size| size + 8).sum();
    assert_eq!(&data[total..], b"\n  </AppendedData>\n</VTKFile>\n");
    let points = offsets[7] + 8;
    assert_eq!(
        data[points + 24..points + 32],
        (1.0_f64 / 7.0).to_le_bytes()
    );
    assert_eq!(
        data[points + 40..points + 48],
        0.0_f64.to_le_bytes(),
        "the third coordinate is 0"
    );
    assert_eq!(
        data[offsets[10] + 8..offsets[10] + 13],
        [1; 5],
        "vertex cells"
    );
    assert_eq!(
        u64_at(data, offsets[9] + 8 + 8 * 4),
        5,
        "the last cell ends at the last point"
    );
    assert!(header.contains("<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">1.25e-7<"));
    assert!(header.contains("Name=\"stress\" NumberOfComponents=\"6\" ComponentName0=\"XX\""));
    assert!(header.contains(
        "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">Pa</InformationKey>"
    ));
    assert!(!header.contains("compressor"));
}

#[test]
fn compressed_blocks_follow_the_layout_of_the_format() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vtu");
    snapshot(40_000).write(&path, Encoding::Zlib).unwrap();
    let bytes = fs::read(&path).unwrap();
    let (header, data) = parts(&bytes);
    assert!(header.contains("compressor=\"vtkZLibDataCompressor\""));
    let pressure = &data[offsets(&header)[0]..];
    let (blocks, full, last) = (
        u64_at(pressure, 0),
        u64_at(pressure, 8),
        u64_at(pressure, 16),
    );
    assert_eq!((blocks - 1) * full + last, 40_000 * 8);
    let first = 24 + 8 * blocks;
    let mut out = Vec::new();
    ZlibDecoder::new(&pressure[first..first + u64_at(pressure, 24)])
        .read_to_end(&mut out)
        .unwrap();
    assert_eq!(out.len(), full);
    assert_eq!(out[..8], 1.0_f64.to_le_bytes());
    assert_eq!(out[16..24], (1.0_f64 / 3.0).to_le_bytes());
}

#[test]
fn symmetric_tensors_are_in_the_order_of_vtk() {
    let tensor = Sym3 {
        xx: 1.0,
        yy: 2.0,
        zz: 3.0,
        xy: 4.0,
        yz: 5.0,
        xz: 6.0,
    };
    assert_eq!(
        Field::symmetric("s", "Pa", &[tensor]).data,
        Data::F64(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    );
}

#[test]
fn selection_takes_whole_particles() {
    let chosen = snapshot(10).select(&[7, 2]).unwrap();
    assert_eq!(
        chosen.points,
        [[1.0, -7.0 / 3.0, 0.0], [2.0 / 7.0, -2.0 / 3.0, 0.0]]
    );
    assert_eq!(
        chosen.values("stress").unwrap()[..7],
        [7.0, 1.0, 2.0, 3.0, 4.0, 5.0, 2.0]
    );
    assert!(snapshot(10).select(&[10]).is_err());
}

#[test]
fn fields_that_do_not_fit_are_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vtu");
    let wrong = [
        Field::scalar("density", "kg/m^3", Data::F64(vec![1.0])),
        Field::scalar("pressure", "Pa", Data::F64(vec![1.0; 2])),
        Field::scalar("a<b", "Pa", Data::F64(vec![1.0; 2])),
        Field {
            name: "pair".into(),
            unit: "-".into(),
            components: 2,
            data: Data::U8(vec![0; 4]),
        },
    ];
    for field in wrong {
        let error = snapshot(2)
            .with(field.clone())
            .write(&path, Encoding::Raw)
            .unwrap_err();
        assert!(
            matches!(&error, OutputError::Content { name, .. } if *name == field.name),
            "{error}"
        );
        assert!(!path.exists());
    }
}

#[test]
fn damaged_and_foreign_files_are_refused_with_a_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("s.vtu");
    for encoding in [Encoding::Raw, Encoding::Zlib] {
        snapshot(20).write(&path, encoding).unwrap();
        let whole = fs::read(&path).unwrap();
        for length in (0..whole.len() - 40).step_by(97) {
            fs::write(&path, &whole[..length]).unwrap();
            assert!(
                matches!(Snapshot::read(&path), Err(OutputError::Malformed { .. })),
                "{length}"
            );
        }
    }
    fs::write(&path, "# vtk DataFile Version 3.0\n").unwrap();
    assert!(
        Snapshot::read(&path)
            .unwrap_err()
            .to_string()
            .ends_with("it has no appended raw data")
    );
}
