//! Repeated impacts: what each did, how strain, damage and lost mass add up, incubation.

use crate::output::Table;
use crate::report::html::Page;
use crate::report::plot::{Axis, Plot, Series, Style};
use crate::report::run_data::RunData;
use crate::report::units::quantity;

/// Rows that are shown; the rest stands in the file.
const MOST_ROWS: usize = 40;

/// Columns of the table with their heads.
const SHOWN: [(&str, &str); 11] = [
    ("impact", "impact"),
    ("radius", "radius"),
    ("standoff", "stand-off"),
    ("jet_speed", "jet speed"),
    ("peak_wall_pressure", "largest wall pressure"),
    ("absorbed_energy", "absorbed energy"),
    ("max_plastic_strain", "largest plastic strain"),
    ("pit_depth", "pit depth"),
    ("max_damage", "largest damage"),
    ("lost_mass", "lost mass so far"),
    ("settling_residual", "motion left after settling"),
];

/// Curves over the impacts: column, axis label, unit, whether the sum begins with nothing, caption.
const CURVES: [(&str, &str, &str, &str); 5] = [
    (
        "max_damage",
        "largest damage",
        "-",
        "Largest damage anywhere in the wall; material fails at 1 and is taken out.",
    ),
    (
        "max_plastic_strain",
        "largest plastic strain",
        "-",
        "Largest plastic strain anywhere in the wall, lost material included.",
    ),
    (
        "pit_depth",
        "pit depth",
        "m",
        "Depth of the pit when the wall has settled: the elastic part is gone.",
    ),
    (
        "plastic_work",
        "plastic work",
        "J",
        "Energy that the wall has absorbed by plastic work so far.",
    ),
    (
        "plastic_volume",
        "volume that yielded",
        "m3",
        "Volume that has yielded so far.",
    ),
];

/// Writes the section; nothing for a run without repeated impacts.
pub(crate) fn write(page: &mut Page, data: &RunData) {
    let Some(table) = data.impacts.as_ref().filter(|t| t.rows() > 0) else {
        return;
    };
    page.section("Repeated impacts");
    page.paragraph(&in_words(data, table));
    let mut figures = Vec::new();
    if table
        .column("lost_mass")
        .is_some_and(|m| m.iter().any(|m| *m > 0.0))
    {
        figures.push((
            curve(table, "lost_mass", ("lost mass", "kg")),
            "Mass that failed or came loose and was taken out, of the whole ring.".to_owned(),
        ));
    }
    for (column, label, unit, caption) in CURVES {
        figures.push((curve(table, column, (label, unit)), caption.to_owned()));
    }
    page.figures(&figures);
    write_table(page, table);
    page.paragraph(
        "All columns: impacts.csv. After each impact the liquid is taken away and the wall comes to rest, free of pressure and with \
         damped motion; the next liquid is laid on the surface as it is then. The energy ledger counts what leaves with the \
         liquid and what damping takes out. In axisymmetry every bubble lies on the same axis and what fails is a ring: \
         more harm in one place than bubbles that are scattered over a wall do. Pressure does not act on the ground \
         of a hole where material was lost: what the curve shows after the first loss is an outline.",
    );
    page.paragraph("Numbers on bubble, jet and wall pressure in the table of results, and the chapters on fields, bubble and wall pressure, are those of the last impact; times count from the start of the first.");
}

/// What came out, in a few sentences.
fn in_words(data: &RunData, table: &Table) -> String {
    let last = |name: &str| table.column(name).and_then(|c| c.last().copied());
    let n = table.rows();
    let impacts = if n == 1 { "impact" } else { "impacts" };
    let damage = last("max_damage").unwrap_or(f64::NAN);
    if let Some(first) = first_loss(table) {
        let rate = data
            .number("lost_mass_per_impact")
            .map_or_else(String::new, |m| {
                format!(", from then on {} per impact", quantity(m, "kg"))
            });
        return format!(
            "Incubation: mass was lost first in impact {first} of {n}{rate}; {} in all.",
            quantity(last("lost_mass").unwrap_or(f64::NAN), "kg")
        );
    }
    let estimate = match data.number("incubation_impacts_estimate") {
        Some(estimate) => format!(
            " The largest damage is {damage:.3}. Estimate: it reaches 1 after about {estimate:.0} impacts, if every further \
             impact adds as much damage at the same place as the last ones did on average (Miner's rule over the last half of the sequence)."
        ),
        None if data.summary.is_null() => " The run has not ended.".to_owned(),
        None if damage > 0.0 => {
            format!(
                " The largest damage is {damage:.3} and did not grow: nothing tells when mass will be lost."
            )
        }
        None => {
            " The wall has no damage law, or did not yield: nothing tells when mass will be lost."
                .to_owned()
        }
    };
    format!("No mass was lost within {n} {impacts}.{estimate}")
}

/// Number of the impact in which mass was lost first.
fn first_loss(table: &Table) -> Option<usize> {
    let lost = table.column("lost_mass")?;
    lost.iter().position(|m| *m > 0.0).map(|k| k + 1)
}

/// A column over the number of the impact, from nothing before the first.
fn curve(table: &Table, column: &str, (label, unit): (&str, &str)) -> String {
    let values = table.column(column).unwrap_or(&[]);
    let numbers = (1..).map(f64::from);
    let points: Vec<[f64; 2]> = std::iter::once([0.0, 0.0])
        .chain(numbers.zip(values).map(|(n, v)| [n, *v]))
        .collect();
    let series = |style| Series {
        label: String::new(),
        points: points.clone(),
        style,
        colour: Some("#0072b2".to_owned()),
    };
    let plot = Plot::new(Axis::new("impacts", "-"), Axis::new(label, unit))
        .series(series(Style::Line))
        .series(series(Style::Points));
    match first_loss(table) {
        Some(first) => plot.event(first as f64, "first loss"),
        None => plot,
    }
    .to_svg()
}

fn write_table(page: &mut Page, table: &Table) {
    let heads = SHOWN.map(|(_, head)| head);
    let cell = |name: &str, row: usize| {
        let value = table.column(name).map_or(f64::NAN, |c| c[row]);
        match table.unit(name).unwrap_or("-") {
            _ if !value.is_finite() => "not determined".to_owned(),
            "-" if name == "impact" => format!("{value:.0}"),
            "-" if name == "settling_residual" => format!("{value:.1e}"),
            unit => quantity(value, unit),
        }
    };
    let row = |k: usize| {
        SHOWN
            .iter()
            .map(|(name, _)| cell(name, k))
            .collect::<Vec<_>>()
    };
    let rows: Vec<Vec<String>> = (0..table.rows().min(MOST_ROWS)).map(row).collect();
    page.table(&heads, &rows);
    if table.rows() > MOST_ROWS {
        page.paragraph(&format!(
            "The first {MOST_ROWS} of {} impacts.",
            table.rows()
        ));
    }
}

/// The run as if it had only had its last complete impact, for the chapters that show one collapse.
pub(crate) fn last_impact(data: &RunData) -> Option<RunData> {
    let table = data.impacts.as_ref()?;
    let last = |name: &str| table.column(name)?.last().copied();
    let begin = last("begin_time")?;
    let end = last("time")? - last("settling_time")?;
    // Rounding of the difference must not cut the last row; rows are farther apart than that.
    let end = end * (1.0 + 1e-9);
    let cut = |t: &Option<Table>| t.as_ref().map(|t| t.between(begin, end));
    let inside = |time: f64| (begin..=end).contains(&time);
    Some(RunData {
        dir: data.dir.clone(),
        summary: data.summary.clone(),
        status: data.status.clone(),
        case: data.case.clone(),
        resolved: data.resolved.clone(),
        history: cut(&data.history),
        wall: cut(&data.wall),
        frames: data
            .frames
            .iter()
            .filter(|f| inside(f.time))
            .cloned()
            .collect(),
        ..RunData::default()
    })
}
