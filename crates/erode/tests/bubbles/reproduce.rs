//! `erode reproduce`.

use super::common::{fresh, refused, says};
use std::fs;

#[test]
fn the_list_has_the_figures_of_the_flow_paper() {
    let list = says(&["reproduce"]);
    for figure in [8, 9, 11, 13, 14, 15, 16, 17] {
        assert!(
            list.contains(&format!("peters-fig-{figure} ")),
            "{figure}: {list}"
        );
    }
}

#[test]
fn a_figure_that_meets_its_text_is_drawn() {
    let dir = fresh("reproduced");
    let json = dir.with_extension("json");
    let args = [
        "reproduce",
        "peters-fig-8",
        "-o",
        dir.to_str().unwrap(),
        "--json",
        json.to_str().unwrap(),
    ];
    let said = says(&args);
    assert!(said.contains("peters-fig-8: met"), "{said}");
    assert!(
        fs::read_to_string(dir.join("peters-fig-8-nuclei.svg"))
            .unwrap()
            .contains("<svg")
    );
    assert!(
        fs::read_to_string(dir.join("peters-fig-8.html"))
            .unwrap()
            .contains("as printed")
    );
    assert!(
        fs::read_to_string(json)
            .unwrap()
            .contains("integral of the distribution")
    );
}

/// The turns before the core in figure 13 belong to the misprinted drag, which is not in use: a known miss.
#[test]
fn a_statement_that_is_not_met_ends_with_code_2() {
    let dir = fresh("missed");
    let said = refused(
        &["reproduce", "peters-fig-13", "-o", dir.to_str().unwrap()],
        2,
    );
    assert!(said.contains("not met"), "{said}");
    assert!(dir.join("peters-fig-13.html").exists());
}

#[test]
fn unknown_figures_are_refused_with_the_list() {
    let said = refused(&["reproduce", "peters-fig-12"], 1);
    assert!(
        said.contains("did you mean") && said.contains("peters-fig-17"),
        "{said}"
    );
}

#[test]
fn the_list_has_the_tables_and_figures_of_the_thesis() {
    let list = says(&["reproduce"]);
    let figures = [
        "table-4.1",
        "table-4.2",
        "fig-4.6",
        "fig-6.3",
        "fig-6.7",
        "fig-6.8",
        "fig-6.9",
        "fig-6.10",
        "fig-6.11",
        "fig-6.14",
        "fig-6.16",
        "fig-6.18",
        "fig-6.19",
        "fig-7.3",
        "fig-7.4",
        "fig-7.5",
        "fig-7.6",
        "fig-7.7",
        "fig-7.8",
        "fig-7.9",
        "fig-7.10",
        "fig-7.11",
    ];
    for figure in figures {
        assert!(list.contains(&format!("joshi-{figure} ")), "{figure}");
    }
}

/// With the fewest particles that there can be: what counts is that the run is done once, kept, and judged.
#[test]
fn a_figure_made_of_runs_keeps_them() {
    let dir = fresh("joshi");
    let args = [
        "reproduce",
        "joshi-fig-6.3",
        "--quick",
        "--particles-per-radius",
        "4",
        "-o",
        dir.to_str().unwrap(),
    ];
    let dry = says(&[&args[..], &["--dry-run"]].concat());
    assert!(
        dry.contains("free,60MPa,0.095mm,n=4") && dry.contains("1 runs"),
        "{dry}"
    );
    assert!(!dir.exists(), "a dry run writes nothing");
    let said = |args: &[&str]| {
        let output = super::common::erode(args);
        // Met or not at such a resolution: both ways it is judged.
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let verdict = text
            .lines()
            .find_map(|l| l.trim().strip_prefix("joshi-fig-6.3: "));
        match verdict {
            Some("met") => assert_eq!(output.status.code(), Some(0)),
            Some(other) => {
                assert!(other.starts_with("not met ("), "{text}");
                assert_eq!(output.status.code(), Some(2));
            }
            None => panic!("no verdict in {text}"),
        }
        text
    };
    let first = said(&args);
    for share in ["0.9", "0.8", "0.6", "0.4"] {
        let row = first
            .lines()
            .find(|l| l.contains(&format!("delay at R = {share} R0")));
        let row = row.unwrap_or_else(|| panic!("{share}: {first}"));
        assert!(row.ends_with("pass") || row.ends_with("MISS"), "{row}");
    }
    let summary = dir.join("runs/free,60MPa,0.095mm,n=4/summary.json");
    let written = summary.metadata().unwrap().modified().unwrap();
    let second = said(&args);
    assert!(second.contains("complete"), "{second}");
    assert_eq!(summary.metadata().unwrap().modified().unwrap(), written);
    let page = fs::read_to_string(dir.join("joshi-fig-6.3.html")).unwrap();
    assert!(page.contains("Rayleigh") && page.contains("this program"));
    // What lies there may be another run under the same name: its numbers are not those of the figure.
    let resolved = dir.join("runs/free,60MPa,0.095mm,n=4/resolved.toml");
    let text = fs::read_to_string(&resolved).unwrap();
    fs::write(&resolved, text + "\n# changed\n").unwrap();
    let dry = says(&[&args[..], &["--dry-run"]].concat());
    assert!(dry.contains("of another case: set aside"), "{dry}");
}
