//! `erode new`: writes a case to start from.

use super::{
    args::NewArgs,
    failure::{Failure, Outcome},
    format::columns,
    say::say,
};
use std::{
    fs::{self, OpenOptions},
    io::{ErrorKind, Write},
    path::PathBuf,
};

/// A case to start from.
pub(crate) struct Template {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    pub(crate) text: &'static str,
}

pub(crate) const TEMPLATES: [Template; 10] = [
    Template {
        name: "bubble-near-wall",
        about: "a bubble near a steel wall, hit by a pressure step: jet, ring, pit",
        text: include_str!("../../../../cases/bubble-near-steel/case.toml"),
    },
    Template {
        name: "bubble-attached",
        about: "the same with the bubble cut by the wall",
        text: include_str!("../../../../cases/bubble-attached/case.toml"),
    },
    Template {
        name: "bubble-in-liquid",
        about: "a bubble far from walls under pressure: Rayleigh's collapse",
        text: include_str!("templates/bubble-in-liquid.toml"),
    },
    Template {
        name: "indentation",
        about: "a sphere pressed into steel and taken away again: force, pit, stress",
        text: include_str!("../../../../cases/indentation/case.toml"),
    },
    Template {
        name: "pressure-pulse",
        about: "steel hit by a Gaussian pressure in space and time",
        text: include_str!("templates/pressure-pulse.toml"),
    },
    Template {
        name: "coating",
        about: "coated steel hit by the same: layers of other materials",
        text: include_str!("../../../../cases/coated-steel/case.toml"),
    },
    Template {
        name: "repeated-impacts",
        about: "bubbles one after the other on the same wall: damage adds up until mass is lost",
        text: include_str!("../../../../cases/repeated-impacts/case.toml"),
    },
    Template {
        name: "single-bubble",
        about: "the radius of a gas bubble in an acoustic field: growth, collapse, rebounds",
        text: include_str!("../../../../cases/single-bubble/case.toml"),
    },
    Template {
        name: "bubble-cloud",
        about: "nuclei above a wall in an acoustic field: collapses and impacts",
        text: include_str!("../../../../cases/bubble-cloud/case.toml"),
    },
    Template {
        name: "own-bodies",
        about: "bodies written out: shapes, spacing, sides, materials of your own",
        text: include_str!("templates/own-bodies.toml"),
    },
];

/// Runs the command.
pub(crate) fn new(args: &NewArgs) -> Outcome {
    let Some(name) = &args.template else {
        say!("Templates, to be used as `erode new TEMPLATE [DIR]`:");
        print_templates();
        return Ok(());
    };
    let Some(template) = TEMPLATES.iter().find(|t| t.name == name) else {
        let names: Vec<&str> = TEMPLATES.iter().map(|t| t.name).collect();
        let help = format!("templates: {}", names.join(", "));
        return Err(Failure::input(
            format!("there is no template `{name}`"),
            help,
        ));
    };
    let dir = args
        .dir
        .clone()
        .unwrap_or_else(|| PathBuf::from(template.name));
    let file = dir.join("case.toml");
    let fail = |what: &str, e: &std::io::Error| {
        Failure::input(
            format!("{what} cannot be written: {e}"),
            "choose a folder that you may write to",
        )
    };
    fs::create_dir_all(&dir).map_err(|e| fail(&dir.display().to_string(), &e))?;
    let mut out = match OpenOptions::new().write(true).create_new(true).open(&file) {
        Ok(out) => out,
        Err(e) if e.kind() == ErrorKind::AlreadyExists => {
            let message = format!("{} exists already and is left as it is", file.display());
            return Err(Failure::input(
                message,
                "give another folder: erode new TEMPLATE DIR",
            ));
        }
        Err(e) => return Err(fail(&file.display().to_string(), &e)),
    };
    out.write_all(template.text.as_bytes())
        .map_err(|e| fail(&file.display().to_string(), &e))?;
    say!("{} written: {}", file.display(), template.about);
    say!("Next: erode check {0}, then erode run {0}", dir.display());
    Ok(())
}

fn print_templates() {
    let rows: Vec<Vec<String>> = TEMPLATES
        .iter()
        .map(|t| vec![format!("  {}", t.name), t.about.to_owned()])
        .collect();
    for line in columns(&rows) {
        say!("{line}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use erode::case::{Case, check_advice};

    #[test]
    fn every_template_checks_clean() {
        for t in TEMPLATES {
            let simulation =
                Case::parse(t.name, t.text, &[]).unwrap_or_else(|e| panic!("{}: {e}", t.name));
            assert_eq!(
                check_advice(&simulation),
                Vec::<String>::new(),
                "{}",
                t.name
            );
        }
    }
}
