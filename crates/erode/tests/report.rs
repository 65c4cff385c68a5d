//! The report of synthetic run folders: complete, incomplete, damaged.

// Helpers of tests may unwrap like the tests themselves; clippy only sees the latter.
#![allow(clippy::unwrap_used)]

mod synthetic;

use erode::report::{ReportError, build, plot};
use std::fs;
use std::path::{Path, PathBuf};
use synthetic::{Has, write_run};

const BOTH: Has = Has {
    bubble: true,
    solid: true,
};

/// A fresh folder below the build folder; it stays there, so that the page can be looked at.
fn folder(name: &str) -> PathBuf {
    let dir = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("report-{name}"));
    if dir.exists() {
        fs::remove_dir_all(&dir).unwrap();
    }
    fs::create_dir_all(&dir).unwrap();
    dir
}

fn page(dir: &Path) -> String {
    let path = build(dir).unwrap();
    assert_eq!(path, dir.join("report/index.html"));
    let html = fs::read_to_string(path).unwrap();
    assert_well_formed(&html);
    assert_offline(&html);
    html
}

/// Every tag that opens closes in order (the page is also valid XML apart from its head).
fn assert_well_formed(html: &str) {
    let mut open: Vec<&str> = Vec::new();
    let body = html.split_once("</head>").unwrap().1;
    for piece in body.split('<').skip(1) {
        let (tag, _) = piece.split_once('>').expect("a tag that ends");
        let name = tag.split([' ', '/']).find(|n| !n.is_empty()).unwrap_or("");
        if tag.starts_with('/') {
            assert!(
                open.last() == Some(&name) || name == "html",
                "</{name}> after {:?}",
                open.last()
            );
            open.pop();
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

/// Nothing is fetched and nothing runs.
fn assert_offline(html: &str) {
    assert!(!html.contains("<script") && !html.contains("@import") && !html.contains("url("));
    for attribute in ["href=\"", "src=\""] {
        for target in html.split(attribute).skip(1) {
            assert!(
                target.starts_with("data:image/png;base64,"),
                "{}",
                &target[..40.min(target.len())]
            );
        }
    }
    assert_eq!(
        html.matches("http").count(),
        html.matches("xmlns=\"http://www.w3.org/2000/svg\"").count()
    );
}

/// All: seven instants, three of the velocity, the yielded region, the map of the wall pressure.
fn pictures(html: &str) -> usize {
    html.matches("data:image/png;base64,").count()
}

#[test]
fn a_bubble_next_to_a_solid() {
    let dir = folder("bubble");
    write_run(&dir, BOTH);
    let html = page(&dir);
    assert!(html.contains("<h1>Bubble next to A-2205 steel, standoff 1.33</h1>"));
    for text in [
        "0.250 %",
        "0.230 %",
        "+8.7 %",
        "Joshi 2018, figure 6.7d",
        "812.0 m/s",
        "1.234 GPa",
        "81\u{2009}234",
    ] {
        assert!(html.contains(text), "{text}");
    }
    // 0.914 68 R0 sqrt(rho / p) for 0.15 mm and 50 MPa.
    assert!(html.contains("collapse in 613.6 ns"));
    assert_eq!(pictures(&html), 12);
    assert!(
        html.contains("Largest plastic strain 0.2500 %")
            || html.contains("Largest plastic strain 0.249")
    );
    assert!(!html.contains("class=\"absent\"") && !html.contains("class=\"alert\""));
    assert!(!html.contains("NaN"));
}

#[test]
fn the_same_folder_gives_the_same_page() {
    let dir = folder("twice");
    write_run(&dir, BOTH);
    assert_eq!(page(&dir), page(&dir));
}

#[test]
fn without_solid_and_without_bubble() {
    let dir = folder("no-solid");
    write_run(
        &dir,
        Has {
            bubble: true,
            solid: false,
        },
    );
    let html = page(&dir);
    assert!(html.contains("This run has no solid with plastic strain"));
    assert!(html.contains("No wall pressure was recorded"));
    assert!(html.contains("Rayleigh"));
    let dir = folder("no-bubble");
    write_run(
        &dir,
        Has {
            bubble: false,
            solid: true,
        },
    );
    let html = page(&dir);
    assert!(html.contains("No bubble was recorded"));
    assert_eq!(pictures(&html), 8);
}

#[test]
fn any_file_may_be_missing() {
    let dir = folder("missing");
    for (gone, said) in [
        ("history.csv", "history.csv is missing"),
        ("summary.json", "This run has not ended"),
        ("fields.pvd", "No fields were written"),
        (
            "surface/wall_pressure.csv",
            "surface/wall_pressure.csv is missing",
        ),
        ("probes", "This run has no probes"),
        ("case.toml", "case.toml is missing"),
        (
            "resolved.toml",
            "the driving pressure is not in the run folder",
        ),
    ] {
        write_run(&dir, BOTH);
        let path = dir.join(gone);
        if path.is_dir() {
            fs::remove_dir_all(path).unwrap()
        } else {
            fs::remove_file(path).unwrap()
        }
        let html = page(&dir);
        assert!(html.contains(said), "without {gone}: {said}");
    }
}

#[test]
fn damaged_files_are_named_and_the_rest_is_shown() {
    let dir = folder("damaged");
    write_run(&dir, BOTH);
    fs::write(dir.join("history.csv"), "time [s],dt [s]\n1.0,oops\n2,3\n").unwrap();
    fs::write(dir.join("summary.json"), "{").unwrap();
    fs::write(dir.join("fields/liquid_000024.vtu"), "not a file").unwrap();
    fs::write(
        dir.join("status.json"),
        r#"{"state":"failed","message":"NaN <in> pressure."}"#,
    )
    .unwrap();
    let html = page(&dir);
    for said in [
        "line 2",
        "summary.json is damaged",
        "liquid_000024.vtu",
        "This run failed. NaN &lt;in&gt; pressure.",
    ] {
        assert!(html.contains(said), "{said}");
    }
    assert_eq!(pictures(&html), 8);
}

#[test]
fn what_is_no_run_is_refused() {
    let dir = folder("empty");
    let error = build(&dir).unwrap_err();
    assert!(matches!(error, ReportError::NotARun { .. }), "{error}");
    let error = build(&dir.join("nowhere")).unwrap_err();
    assert!(
        error.to_string().starts_with("there is no folder"),
        "{error}"
    );
}

#[test]
fn a_figure_can_be_written_alone() {
    let path = folder("figure").join("sub/plot.svg");
    let figure = plot::Plot::new(plot::Axis::new("time", "s"), plot::Axis::new("radius", "m"))
        .line("result", vec![[0.0, 1e-4], [1e-6, 5e-5]])
        .dashed("reference", vec![[0.0, 1e-4], [1e-6, 4e-5]]);
    figure.write(&path).unwrap();
    let svg = fs::read_to_string(&path).unwrap();
    assert!(svg.contains("time [µs]") && svg.contains("radius [µm]") && svg.contains("reference"));
}
