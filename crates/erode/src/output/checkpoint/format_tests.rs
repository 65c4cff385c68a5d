use super::*;

fn checkpoint() -> Checkpoint {
    let meta = CheckpointMeta {
        code_version: "0.1.0".into(),
        case_hash: "ab".into(),
        time: 0.1 + 0.2,
        step: u64::MAX,
        extra: serde_json::json!({"rows": 12}),
    };
    let mut checkpoint = Checkpoint::new(meta);
    checkpoint
        .push(
            "density",
            vec![0.1, -0.0, f64::MIN_POSITIVE / 3.0, f64::NEG_INFINITY],
        )
        .unwrap();
    checkpoint.push("steps", vec![u64::MAX, 1]).unwrap();
    checkpoint.push("cell", vec![7_u32, 8, 9]).unwrap();
    checkpoint.push("flag", vec![1_u8, 0]).unwrap();
    checkpoint.push("empty", Vec::<f64>::new()).unwrap();
    checkpoint
}

#[test]
fn everything_comes_back_bit_for_bit() {
    let mut written = checkpoint();
    let not_numbers = [0x7ff8_0000_0000_0001, 0xfff4_dead_beef_0000].map(f64::from_bits);
    written.push("nan", not_numbers.to_vec()).unwrap();
    written
        .push_vectors("velocity", &[[1.0 / 3.0, 2.0], [3.0, 4.0]])
        .unwrap();
    let read = decode(&encode(&written).unwrap()).unwrap();
    assert_eq!(read.meta, written.meta);
    for (a, b) in read.arrays().iter().zip(written.arrays()).take(5) {
        assert_eq!(a, b);
    }
    assert_eq!(
        read.f64("density").unwrap()[1].to_bits(),
        (-0.0_f64).to_bits()
    );
    let bits: Vec<_> = read
        .f64("nan")
        .unwrap()
        .iter()
        .map(|x| x.to_bits())
        .collect();
    assert_eq!(bits, not_numbers.map(f64::to_bits));
    assert_eq!(
        read.vectors::<2>("velocity").unwrap(),
        [[1.0 / 3.0, 2.0], [3.0, 4.0]]
    );
    assert!(read.vectors::<3>("velocity").is_err());
    assert!(read.u64("density").is_err() && read.u64("nothing").is_err());
}

/// The JSON of the words must not round the time.
#[test]
fn any_time_is_exact() {
    let mut bits = 0x9e37_79b9_7f4a_7c15_u64;
    for _ in 0..5000 {
        bits = bits
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let time = f64::from_bits(bits);
        if time.is_finite() {
            let mut written = checkpoint();
            written.meta.time = time;
            let read = decode(&encode(&written).unwrap()).unwrap();
            assert_eq!(read.meta.time.to_bits(), time.to_bits());
        }
    }
}

#[test]
fn one_wrong_bit_anywhere_is_noticed_and_located() {
    let whole = encode(&checkpoint()).unwrap();
    let mut regions = Vec::new();
    for at in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[at] ^= 1 << (at % 8);
        let reason = decode(&bytes).unwrap_err().to_string();
        if regions.last() != Some(&reason) {
            regions.push(reason);
        }
    }
    let mut expected =
        vec!["it is not an Erode checkpoint: it does not begin like one".to_string()];
    let parts = ["its header", "the description of the run"]
        .map(String::from)
        .into_iter();
    let arrays = (1..=5).map(|number| format!("array {number} of 5"));
    for part in parts.chain(arrays).chain(["its end".into()]) {
        expected.push(format!("{part} is damaged: the checksum is wrong"));
    }
    assert_eq!(regions, expected);
}

#[test]
fn any_shorter_file_is_cut_short_and_a_longer_one_damaged() {
    let mut bytes = encode(&checkpoint()).unwrap();
    for length in 0..bytes.len() {
        assert!(
            matches!(decode(&bytes[..length]), Err(Refusal::Truncated { .. })),
            "{length}"
        );
    }
    bytes.push(0);
    assert!(matches!(decode(&bytes), Err(Refusal::Damaged { .. })));
}

#[test]
fn another_schema_is_told_from_damage() {
    let mut bytes = encode(&checkpoint()).unwrap();
    bytes[8..12].copy_from_slice(&7_u32.to_le_bytes());
    let checksum = hash(&bytes[..28]);
    bytes[28..32].copy_from_slice(&checksum.to_le_bytes());
    let reason = decode(&bytes).unwrap_err();
    assert_eq!(
        reason.to_string(),
        "it has checkpoint schema 7, and this program reads schema 3: only the version of Erode that wrote it can go on with \
         it"
    );
}

#[test]
fn what_cannot_be_restored_is_not_written() {
    let mut twice = checkpoint();
    assert!(twice.push("density", vec![1.0]).is_err());
    twice.meta.time = f64::NAN;
    assert!(encode(&twice).is_err());
}
