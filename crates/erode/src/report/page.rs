//! The order of the report.

use super::html::Page;
use super::instants::Instants;
use super::run_data::RunData;
use super::sections::{
    asked, bubble, bubble_cloud, energy, fields, impacts, layers, load, probes, results,
    single_bubble, stepping, strain, wall,
};

/// The whole page as HTML.
pub(crate) fn compose(data: &RunData) -> String {
    let last_impact = impacts::last_impact(data);
    let one = last_impact.as_ref().unwrap_or(data);
    let instants = Instants::find(one);
    let mut page = Page::default();
    let title = asked::title(data);
    asked::write_head(&mut page, data, &title);
    if bubble_cloud::is(data) {
        return compose_bubble_cloud(page, data, &title);
    }
    if single_bubble::is(data) {
        return compose_single_bubble(page, data, &title);
    }
    page.columns(
        |left| results::write(left, data),
        |right| asked::write(right, data),
    );
    results::write_comparison(&mut page, data);
    let end = data
        .frames
        .last()
        .map_or_else(Vec::new, |frame| frame.read().0);
    impacts::write(&mut page, data);
    fields::write(&mut page, one, &instants, &end);
    if !load::write(&mut page, data, &end) {
        bubble::write(&mut page, one, &instants);
    }
    wall::write(&mut page, one, &instants);
    strain::write(&mut page, data, &instants, &end);
    layers::write(&mut page, data);
    energy::write(&mut page, data);
    stepping::write(&mut page, data, &instants);
    probes::write(&mut page, data);
    asked::write_files(&mut page, data);
    page.finish(&title)
}

/// The page of a run of one spherical bubble: it has no fields and no wall.
fn compose_single_bubble(mut page: Page, data: &RunData, title: &str) -> String {
    page.columns(
        |left| results::write(left, data),
        |right| asked::write(right, data),
    );
    single_bubble::write(&mut page, data);
    energy::write(&mut page, data);
    stepping::write(&mut page, data, &Instants::default());
    asked::write_files(&mut page, data);
    page.finish(title)
}

/// The page of a run of a cloud of bubbles.
fn compose_bubble_cloud(mut page: Page, data: &RunData, title: &str) -> String {
    page.columns(
        |left| results::write(left, data),
        |right| asked::write(right, data),
    );
    bubble_cloud::write(&mut page, data);
    energy::write(&mut page, data);
    asked::write_files(&mut page, data);
    page.finish(title)
}
