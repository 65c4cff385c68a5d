//! The files of a reproduction: its figures as SVG and one HTML page with the comparison.

use super::Reproduced;
use crate::output::OutputError;
use crate::output::atomic::write_atomic;
use crate::report::html::Page;
use crate::validate::{Kind, text};
use std::path::{Path, PathBuf};

/// Writes `ID.html` and `ID-NAME.svg` into a folder, which is made; the path of the page.
///
/// # Errors
/// If a file cannot be written.
pub fn write(folder: &Path, reproduced: &Reproduced) -> Result<PathBuf, OutputError> {
    let outcome = &reproduced.outcome;
    std::fs::create_dir_all(folder).map_err(|cause| OutputError::NotWritable {
        path: folder.to_path_buf(),
        cause,
    })?;
    let put = |path: &Path, text: &str| write_atomic(path, |f| f.write_all(text.as_bytes()));
    let mut page = Page::default();
    page.title(
        &outcome.name,
        &format!("{} ({})", outcome.description, outcome.reference),
    );
    let mut figures = Vec::new();
    for figure in &outcome.finding.figures {
        let svg = figure.to_svg();
        put(
            &folder.join(format!("{}-{}.svg", outcome.name, figure.name)),
            &svg,
        )?;
        figures.push((svg, figure.title.clone()));
    }
    page.figures(&figures);
    let pictures = reproduced.pictures.iter();
    let pictures: Vec<(String, String)> = pictures
        .map(|p| (p.svg.clone(), p.caption.clone()))
        .collect();
    page.multiples(&pictures);
    page.section("Comparison with what the source states");
    page.details("as printed by `erode reproduce`", &text(outcome));
    let rows: Vec<Vec<String>> = outcome
        .finding
        .checks
        .iter()
        .map(|c| {
            let verdict = match (c.kind, c.passed) {
                (Kind::Shown, _) => "not judged",
                (Kind::NoData, _) => "not judged: no data",
                (_, true) => "met",
                (_, false) => "not met",
            };
            let number = |x: Option<f64>| match x.filter(|x| !x.is_nan()) {
                Some(x) => format!("{x:.4e}"),
                None => "-".into(),
            };
            vec![
                c.quantity.clone(),
                number(Some(c.value)),
                number(c.reference),
                verdict.into(),
                c.reason_for_tolerance.clone(),
            ]
        })
        .collect();
    page.table(
        &[
            "quantity",
            "this program",
            "stated or bound",
            "",
            "statement",
        ],
        &rows,
    );
    for note in &outcome.finding.notes {
        page.paragraph(note);
    }
    let path = folder.join(format!("{}.html", outcome.name));
    put(&path, &page.finish(&outcome.name))?;
    Ok(path)
}
