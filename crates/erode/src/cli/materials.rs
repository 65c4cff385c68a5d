//! `erode materials`: the library with its sources.

use super::{
    args::MaterialsArgs,
    failure::{Failure, Outcome},
    format::{columns, si, significant},
    say::say,
};
use erode::materials::{Library, Material, Property};

/// Runs the command.
pub(crate) fn materials(args: &MaterialsArgs) -> Outcome {
    let library = Library::with_folders(args.folder.as_slice())?;
    match &args.name {
        None => list(&library),
        Some(name) => match library.get(name) {
            Some(material) => show(material),
            None => {
                let names: Vec<&str> = library.iter().map(|m| m.name.as_str()).collect();
                let help = format!("materials: {}", names.join(", "));
                return Err(Failure::input(
                    format!("there is no material `{name}`"),
                    help,
                ));
            }
        },
    }
    Ok(())
}

fn list(library: &Library) {
    let head = [
        "name",
        "usable as",
        "density",
        "speed of sound",
        "yield law",
        "title",
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(library.iter().map(row));
    for line in columns(&rows) {
        say!("{line}");
    }
    say!();
    say!(
        "`erode materials NAME` shows each number with its source, and what the sources do not give."
    );
}

fn row(m: &Material) -> Vec<String> {
    let usable = match (m.is_fluid(), m.is_solid(), m.is_solid_without_rate()) {
        (true, _, _) => "liquid",
        (_, true, _) => "solid",
        (_, _, true) => "solid, strain_rate = false",
        _ => "incomplete",
    };
    let first = |paths: [&str; 2]| paths.iter().find_map(|p| m.properties.get(*p));
    let density = first(["fluid.tait.reference_density", "solid.density"]);
    let speed = m
        .sound_speed()
        .map_or_else(|| "-".to_owned(), |c| format!("{c:.0} m/s"));
    let density = density.map_or_else(
        || "-".to_owned(),
        |p| format!("{} kg/m^3", significant(p.value)),
    );
    let law = m.law.clone().unwrap_or_else(|| "-".to_owned());
    vec![
        m.name.clone(),
        usable.to_owned(),
        density,
        speed,
        law,
        m.title.clone(),
    ]
}

fn show(m: &Material) {
    say!("{}: {}", m.name, m.title);
    if !m.notes.is_empty() {
        say!("{}", m.notes);
    }
    say!();
    let rows: Vec<Vec<String>> = m
        .properties
        .iter()
        .map(|(path, p)| property_row(path, p))
        .collect();
    for line in columns(&rows) {
        say!("  {line}");
    }
    if !m.missing.is_empty() {
        say!("\nMissing:");
        let rows: Vec<Vec<String>> = m
            .missing
            .iter()
            .map(|(path, why)| vec![path.clone(), why.clone()])
            .collect();
        for line in columns(&rows) {
            say!("  {line}");
        }
        say!(
            "\nGive what is missing in a case under [material.{}...], or in materials/{0}.toml beside it.",
            m.name
        );
    }
}

fn property_row(path: &str, p: &Property) -> Vec<String> {
    let value = match p.unit.as_str() {
        "1" => significant(p.value),
        "Pa" => si(p.value, "Pa"),
        unit => format!("{} {unit}", significant(p.value)),
    };
    vec![path.to_owned(), value, p.source.clone().unwrap_or_default()]
}
