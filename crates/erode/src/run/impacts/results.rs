//! The scalars of a sequence.

use super::Sequence;
use super::incubation::{Incubation, loss_per_impact};
use super::table::Row;
use crate::analysis::plastic_potential;
use crate::output::{Summary, Table};

/// Adds the scalars of a sequence to the summary.
pub(in crate::run) fn add(s: &mut Summary, sequence: &Sequence) {
    let rows = &sequence.state.rows;
    s.set_count("impacts", rows.len() as u64);
    let (reached, estimated) = match Incubation::of(rows) {
        Incubation::Reached(n) => (n as f64, f64::NAN),
        Incubation::Estimated(n) => (f64::NAN, n),
        Incubation::Unknown => (f64::NAN, f64::NAN),
    };
    s.set("incubation_impacts", "-", reached);
    s.set("incubation_impacts_estimate", "-", estimated);
    s.set(
        "lost_mass_per_impact",
        "kg",
        loss_per_impact(rows).unwrap_or(f64::NAN),
    );
    s.set(
        "max_damage",
        "-",
        rows.last().map_or(f64::NAN, |r| r.max_damage),
    );
    if let (Some(row), Some(bubble)) = (rows.last(), s.get("bubble_energy")) {
        // Of the last bubble alone, as its energy is.
        let share = plastic_potential(row.absorbed_energy, bubble);
        s.set("plastic_deformation_potential_share", "-", share);
    }
    let largest = |of: fn(&Row) -> f64| rows.iter().map(of).fold(0.0, f64::max);
    s.set("settling_residual", "-", largest(|r| r.settling_residual));
    s.set(
        "settling_energy",
        "J",
        rows.iter().map(|r| r.settling_energy).sum::<f64>() + 0.0,
    );
}

/// The rows of a table that belong to the last impact; all of them before the first settling.
pub(in crate::run) fn last(table: Table, sequence: Option<&Sequence>) -> Table {
    let Some(sequence) = sequence else {
        return table;
    };
    let state = &sequence.state;
    let end = if state.stage == super::Stage::Impact {
        f64::INFINITY
    } else {
        state.impact_end
    };
    table.between(state.row.begin_time, end)
}
