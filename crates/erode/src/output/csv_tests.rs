use super::*;

fn columns() -> Vec<Column> {
    vec![
        Column::new("time", "s"),
        Column::new("bubble_radius", "m"),
        Column::new("steps", "-"),
    ]
}

/// Values whose decimal form is easily rounded, from a small linear congruential generator over all bit patterns.
fn awkward(count: usize) -> Vec<f64> {
    let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
    let mut values = vec![
        0.1,
        -0.0,
        f64::MIN_POSITIVE / 3.0,
        f64::MAX,
        1.0 / 3.0,
        1e-9,
        f64::INFINITY,
    ];
    while values.len() < count {
        bits = bits
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let value = f64::from_bits(bits);
        if !value.is_nan() {
            values.push(value);
        }
    }
    values
}

#[test]
fn header_and_rows_are_the_documented_text() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("history.csv");
    let mut table = TableWriter::create(&path, &columns()).unwrap();
    table.write_row(&[1e-9, f64::NAN, 3.0]).unwrap();
    table.sync().unwrap();
    let expected = "time [s],bubble_radius [m],steps [-]\n1e-9,NaN,3.0\n";
    assert_eq!(fs::read_to_string(&path).unwrap(), expected);
}

#[test]
fn every_value_comes_back_bit_for_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.csv");
    let values = awkward(3 * 4000);
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    for row in values.chunks_exact(3) {
        writer.write_row(row).unwrap();
    }
    drop(writer);
    let table = Table::read(&path).unwrap();
    assert_eq!((table.rows(), table.unfinished), (4000, false));
    assert_eq!(table.unit("bubble_radius"), Some("m"));
    for (name, offset) in [("time", 0), ("bubble_radius", 1), ("steps", 2)] {
        let read: Vec<_> = table
            .column(name)
            .unwrap()
            .iter()
            .map(|v| v.to_bits())
            .collect();
        let written: Vec<_> = values
            .iter()
            .skip(offset)
            .step_by(3)
            .map(|v| v.to_bits())
            .collect();
        assert_eq!(read, written);
    }
    assert_eq!(table.column("radius"), None);
}

#[test]
fn a_resumed_table_equals_an_uninterrupted_one() {
    let folder = tempfile::tempdir().unwrap();
    let (whole, cut) = (
        folder.path().join("whole.csv"),
        folder.path().join("cut.csv"),
    );
    let row = |i: u32| [f64::from(i) / 3.0, f64::NAN, f64::from(i)];
    let mut writer = TableWriter::create(&whole, &columns()).unwrap();
    (0..20).for_each(|i| writer.write_row(&row(i)).unwrap());
    writer.sync().unwrap();
    let mut writer = TableWriter::create(&cut, &columns()).unwrap();
    (0..12).for_each(|i| writer.write_row(&row(i)).unwrap());
    drop(writer);
    // A killed process may leave half a row.
    let mut file = OpenOptions::new().append(true).open(&cut).unwrap();
    file.write_all(b"4.0,Na").unwrap();
    assert!(Table::read(&cut).unwrap().unfinished);
    assert_eq!(Table::read(&cut).unwrap().rows(), 12);
    let mut writer = TableWriter::resume(&cut, &columns(), 7).unwrap();
    assert_eq!(writer.rows(), 7);
    (7..20).for_each(|i| writer.write_row(&row(i)).unwrap());
    drop(writer);
    assert_eq!(fs::read(&whole).unwrap(), fs::read(&cut).unwrap());
}

#[test]
fn resuming_with_missing_rows_or_other_columns_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.csv");
    TableWriter::create(&path, &columns())
        .unwrap()
        .write_row(&[0.0; 3])
        .unwrap();
    let error = TableWriter::resume(&path, &columns(), 2).unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("the checkpoint needs 2 rows, it has 1"),
        "{error}"
    );
    let error = TableWriter::resume(&path, &columns()[..2], 1).unwrap_err();
    assert!(error.to_string().contains("columns"), "{error}");
    assert_eq!(
        Table::read(&path).unwrap().rows(),
        1,
        "a refused table is untouched"
    );
}

#[test]
fn what_does_not_fit_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("t.csv");
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    assert!(matches!(
        writer.write_row(&[1.0]),
        Err(OutputError::Content { .. })
    ));
    assert!(TableWriter::create(&path, &[Column::new("a,b", "m")]).is_err());
    fs::write(&path, "time [s]\n1.0\n2.0,3.0\n").unwrap();
    assert!(
        Table::read(&path)
            .unwrap_err()
            .to_string()
            .contains("line 3 has 2 values for 1 columns")
    );
    fs::write(&path, "time [s]\n1.0\nx\n").unwrap();
    assert!(
        Table::read(&path)
            .unwrap_err()
            .to_string()
            .contains("line 3 has something")
    );
    fs::write(&path, "").unwrap();
    assert!(Table::read(&path).is_err());
}

/// /dev/full answers every write as a full disk does.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_not_a_lost_row() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("history.csv");
    let mut writer = TableWriter::create(&path, &columns()).unwrap();
    writer.file = OpenOptions::new().write(true).open("/dev/full").unwrap();
    writer.write_row(&[0.0; 3]).unwrap();
    let error = writer.flush().unwrap_err();
    assert!(
        error
            .to_string()
            .ends_with("history.csv could not be written: the disk is full"),
        "{error}"
    );
    assert!(error.hint().contains("erode resume"));
}
