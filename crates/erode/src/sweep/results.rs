//! The final numbers of the runs of a sweep.

use super::execute::{Outcome, summary_of};
use super::folder::Folder;
use super::plan::Plan;
use super::table::{Cell, Column, Table};
use crate::output::Summary;

/// What came out of each run, in the order of the plan.
#[derive(Debug, Clone)]
pub struct Results {
    /// How each run ended; a run whose numbers cannot be read counts as failed.
    pub outcomes: Vec<Outcome>,
    /// The final numbers of the complete ones.
    pub summaries: Vec<Option<Summary>>,
}

impl Results {
    /// Reads the numbers of the complete runs.
    #[must_use]
    pub fn read(plan: &Plan, folder: &Folder, outcomes: &[Outcome]) -> Self {
        let mut results = Self {
            outcomes: outcomes.to_vec(),
            summaries: Vec::new(),
        };
        for (run, outcome) in plan.runs.iter().zip(&mut results.outcomes) {
            let summary = outcome
                .is_complete()
                .then(|| summary_of(&folder.run(&run.name)));
            let summary = summary.and_then(|s| match s {
                Ok(summary) => Some(summary),
                Err(e) => {
                    *outcome = Outcome::Failed(e.to_string());
                    None
                }
            });
            results.summaries.push(summary);
        }
        results
    }

    /// Names and units of all scalars in the order in which they first appear.
    #[must_use]
    pub fn scalars(&self) -> Vec<(String, String)> {
        let mut all: Vec<(String, String)> = Vec::new();
        for (name, _, unit) in self.summaries.iter().flatten().flat_map(Summary::scalars) {
            if !all.iter().any(|(n, _)| n == name) {
                all.push((name.to_owned(), unit.to_owned()));
            }
        }
        all
    }

    /// The table: run, state, what is varied, all scalars, why it failed.
    #[must_use]
    pub fn table(&self, plan: &Plan) -> Table {
        let text = |name: &str, cells: Vec<String>| Column {
            name: name.to_owned(),
            unit: "-".to_owned(),
            cells: cells.into_iter().map(Cell::Text).collect(),
        };
        let mut columns = vec![
            text("run", plan.runs.iter().map(|r| r.name.clone()).collect()),
            text(
                "state",
                self.outcomes.iter().map(|o| o.word().into()).collect(),
            ),
        ];
        columns.extend(plan.keys.iter().map(|key| varied(plan, key)));
        for (name, unit) in self.scalars() {
            let cell = |s: &Option<Summary>| match s {
                // Known not to be known, and not yet known, are two things.
                Some(s) => Cell::Number(s.get(&name).unwrap_or(f64::NAN)),
                None => Cell::Empty,
            };
            let cells = self.summaries.iter().map(cell).collect();
            columns.push(Column { name, unit, cells });
        }
        let why = |o: &Outcome| match o {
            Outcome::Failed(why) => why.clone(),
            _ => String::new(),
        };
        columns.push(text("message", self.outcomes.iter().map(why).collect()));
        Table { columns }
    }
}

/// The values of a varied key: numbers if all of them are, else as written.
fn varied(plan: &Plan, key: &str) -> Column {
    let values: Vec<_> = plan.runs.iter().map(|r| r.value(key)).collect();
    let given = || values.iter().flatten();
    let numbers = given().all(|v| v.number.is_some());
    let cells = values.iter().map(|v| match v {
        None => Cell::Empty,
        Some(v) if numbers => v.number.map_or(Cell::Empty, Cell::Number),
        Some(v) => Cell::Text(v.shown.clone()),
    });
    let unit = given().map(|v| v.unit.clone()).find(|u| u != "-");
    Column {
        name: key.to_owned(),
        unit: unit.filter(|_| numbers).unwrap_or_else(|| "-".into()),
        cells: cells.collect(),
    }
}
