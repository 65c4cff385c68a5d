//! Tests of the material library.

use super::*;

fn library() -> Library {
    Library::embedded().unwrap_or_else(|e| panic!("{e}"))
}

fn value(material: &str, path: &str) -> f64 {
    library().get(material).unwrap().properties[path].value
}

#[test]
fn every_number_has_a_unit_and_a_full_source() {
    let library = library();
    assert!(library.iter().count() >= 8);
    for m in library.iter() {
        assert!(!m.title.is_empty(), "{}", m.name);
        assert!(!m.properties.is_empty(), "{}", m.name);
        for (path, p) in &m.properties {
            // A full source is a sentence, not the key of one.
            assert!(
                p.source.as_ref().is_some_and(|s| s.contains(' ')),
                "{} {path}",
                m.name
            );
            assert!(!p.unit.is_empty(), "{} {path}", m.name);
        }
    }
}

#[test]
fn what_is_missing_is_said_and_nothing_else() {
    let all = Terms {
        strain_rate: true,
        thermal_softening: true,
    };
    for m in library().iter() {
        let lacks = match m.law {
            Some(_) => m.solid(all).err().unwrap_or_default(),
            None => m.fluid().err().unwrap_or_default(),
        };
        let mut lacks: Vec<&String> = lacks.iter().collect();
        lacks.sort();
        let said: Vec<&String> = m.missing.keys().collect();
        assert_eq!(lacks, said, "{}", m.name);
    }
}

#[test]
fn constants_are_those_of_the_sources() {
    let jc =
        |material: &str, key: &str| value(material, &format!("solid.strength.johnson_cook.{key}"));
    // Joshi 2018, table 7.1, and the longitudinal speed that follows (5666 m/s).
    assert_eq!(
        [jc("steel_a2205", "a"), jc("steel_a2205", "b")],
        [508e6, 832e6]
    );
    assert_eq!(
        [jc("steel_a2205", "n"), jc("steel_a2205", "c")],
        [0.29, 0.031]
    );
    let c = library().get("steel_a2205").unwrap().sound_speed().unwrap();
    assert!((c - 5666.0).abs() < 1.0, "{c}");
    // n and C are exchanged in the script: a rate coefficient of 0.42 would be nearly explosive.
    assert_eq!(
        [jc("aluminium_6061_t6", "n"), jc("aluminium_6061_t6", "c")],
        [0.42, 0.002]
    );
    // G = 26 GPa is what is printed.
    let e = value("aluminium_6061_t6", "solid.elastic.young_modulus");
    assert!((e / (2.0 * 1.33) / 26e9 - 1.0).abs() < 1e-12);
    let water = library().get("water").unwrap().fluid().unwrap();
    assert_eq!(
        (water.reference_density, water.sound_speed, water.gamma),
        (1000.0, 1500.0, 7.0)
    );
}

#[test]
fn a_rate_explosive_coefficient_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[sources]\nx = \"a b\"\n[solid.strength.johnson_cook]\nc = { value = 0.42, source = \"x\" }\n";
    std::fs::write(folder.path().join("bad.toml"), text).unwrap();
    let error = Library::with_folders(&[folder.path().to_owned()])
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("bad.toml:4:") && error.contains("from 0 to 0.2"),
        "{error}"
    );
}

#[test]
fn files_of_a_folder_replace_those_of_the_program_and_need_sources() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("water.toml");
    let folders = [folder.path().to_owned()];
    std::fs::write(&file, "[fluid.tait]\ngamma = 4\n").unwrap();
    let error = Library::with_folders(&folders).unwrap_err().to_string();
    assert!(
        error.contains("water.toml:2:") && error.contains("no source"),
        "{error}"
    );
    let text = "[sources]\nx = \"my own\"\n[fluid.tait]\ngamma = { value = 4, source = \"x\" }\n";
    std::fs::write(&file, text).unwrap();
    let library = Library::with_folders(&folders).unwrap();
    let water = library.get("water").unwrap();
    // Replaced as a whole: nothing of the built-in water is mixed in.
    assert_eq!(water.properties.len(), 1);
    assert_eq!(
        water.fluid().unwrap_err(),
        ["fluid.tait.reference_density", "fluid.tait.sound_speed"]
    );
}

#[test]
fn johnson_cook_damage_of_the_library_makes_tension_brittle() {
    use erode_physics::damage::{Damage, PlasticStep};
    let library = library();
    let at = |name: &str, triaxiality| {
        let m = library.get(name).unwrap();
        let law = m.damage("johnson_cook");
        let Ok(Damage::JohnsonCook(law)) = law else {
            return Err(law);
        };
        Ok(law.failure_strain(PlasticStep {
            increment: 1e-3,
            rate: 1.0,
            triaxiality,
            temperature: 293.0,
        }))
    };
    // 0.54 + 4.89 exp(-1.01) in a tensile bar of OFHC copper.
    assert!((at("copper_ofhc", 1.0 / 3.0).unwrap() - 2.321).abs() < 1e-3);
    assert!(at("copper_ofhc", 1.0).unwrap() < at("copper_ofhc", 0.0).unwrap());
    // What the sources of the others do not give is named.
    let missing = at("titanium_6al4v", 0.0).unwrap_err().unwrap_err();
    assert!(missing.contains(&"solid.damage.johnson_cook.reference_rate".to_owned()));
    let missing = library.get("steel_1045").unwrap().damage("rupture_strain");
    assert_eq!(
        missing.unwrap_err(),
        ["solid.damage.rupture_strain.rupture_strain"]
    );
}
