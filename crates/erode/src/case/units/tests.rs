//! Tests of quantities with units.

use super::*;

#[test]
fn values_are_rounded_once_and_dimensions_follow() {
    let read = |t: &str| {
        let q = parse(t).unwrap();
        (q.value, q.dimension)
    };
    assert_eq!(read("0.15 mm"), (1.5e-4, Some(LENGTH)));
    assert_eq!(read("50MPa"), (50e6, Some(PRESSURE)));
    assert_eq!(read("20 ns"), (20e-9, Some(TIME)));
    assert_eq!(read("1.5 km/s"), (1500.0, Some(VELOCITY)));
    assert_eq!(read("7.8 g/cm^3"), (7800.0, Some(DENSITY)));
    assert_eq!(read("0.05 1/s"), (0.05, Some(RATE)));
    assert_eq!(read("0.05 s^-1"), (0.05, Some(RATE)));
    assert_eq!(read("500 J/(kg K)"), (500.0, Some(HEAT_CAPACITY)));
    assert_eq!(read("500 J/kg/K"), (500.0, Some(HEAT_CAPACITY)));
    assert_eq!(read("1 N/mm^2"), (1e6, Some(PRESSURE)));
    assert_eq!(read("1 kg m^-1 s^-2"), (1.0, Some(PRESSURE)));
    assert_eq!(read("30 %"), (0.3, Some(NUMBER)));
    assert_eq!(read("-1_000.5e3"), (-1_000_500.0, None));
    assert_eq!(read("3 µs"), (3e-6, Some(TIME)));
    assert_eq!(read("1e-3 m"), (1e-3, Some(LENGTH)));
}

#[test]
fn what_is_no_quantity_says_why() {
    for (text, phrase) in [
        ("", "empty"),
        ("fast", "begin with a number"),
        ("0,15 mm", "comma"),
        ("1.2.3 m", "not a number"),
        ("50 mpa", "did you mean `MPa`"),
        ("5 furlong", "known units are"),
        ("5 m^", "not a unit"),
        ("5 J/(kg K", "not a unit"),
        ("5 m^99 m^99", "not a unit"),
    ] {
        let message = parse(text).unwrap_err().to_string();
        assert!(message.contains(phrase), "{text}: {message}");
    }
}
