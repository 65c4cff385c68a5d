//! `impacts.csv`: one row per impact.

use crate::output::{Column, OutputError, TableWriter};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What one impact did; masses, energies and volumes of the wall are those since the start unless said otherwise.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Row {
    /// Number, from 1.
    pub impact: usize,
    /// When the wall had settled, s.
    pub time: f64,
    /// When the impact began, s.
    pub begin_time: f64,
    /// Of the bubble: radius, m.
    pub radius: f64,
    /// Stand-off.
    pub standoff: f64,
    /// Driving pressure, Pa.
    pub driving_pressure: f64,
    /// Void at the beginning, m3.
    pub bubble_volume: f64,
    /// Speed of the jet, m/s.
    pub jet_speed: Option<f64>,
    /// Largest pressure on the wall in this impact, Pa.
    pub peak_wall_pressure: f64,
    /// Largest plastic strain.
    pub max_plastic_strain: f64,
    /// Volume that yielded, m3.
    pub plastic_volume: f64,
    /// Plastic work, J.
    pub plastic_work: f64,
    /// Plastic work of this impact, J.
    pub absorbed_energy: f64,
    /// Depth of the surface when settled, m.
    pub pit_depth: f64,
    /// Largest damage.
    pub max_damage: f64,
    /// Mass that was lost, kg.
    pub lost_mass: f64,
    /// Particles that failed.
    pub particles_failed: u64,
    /// Particles that came loose.
    pub particles_loose: u64,
    /// How far the wall had moved as a whole and was put back, m (positive: it had sunk).
    pub wall_drift: f64,
    /// Time of settling, s.
    pub settling_time: f64,
    /// Kinetic energy of the wall at its end / largest in this impact.
    pub settling_residual: f64,
    /// Energy that settling took out, J.
    pub settling_energy: f64,
    /// Energy that left with the liquid and its gas, J.
    pub liquid_energy: f64,
}

impl Row {
    /// Names, units and values of the columns.
    pub(crate) fn entries(&self) -> [(&'static str, &'static str, f64); 23] {
        [
            ("impact", "-", self.impact as f64),
            ("time", "s", self.time),
            ("begin_time", "s", self.begin_time),
            ("radius", "m", self.radius),
            ("standoff", "-", self.standoff),
            ("driving_pressure", "Pa", self.driving_pressure),
            ("bubble_volume", "m3", self.bubble_volume),
            ("jet_speed", "m/s", self.jet_speed.unwrap_or(f64::NAN)),
            ("peak_wall_pressure", "Pa", self.peak_wall_pressure),
            ("max_plastic_strain", "-", self.max_plastic_strain),
            ("plastic_volume", "m3", self.plastic_volume),
            ("plastic_work", "J", self.plastic_work),
            ("absorbed_energy", "J", self.absorbed_energy),
            ("pit_depth", "m", self.pit_depth),
            ("max_damage", "-", self.max_damage),
            ("lost_mass", "kg", self.lost_mass),
            ("particles_failed", "-", self.particles_failed as f64),
            ("particles_loose", "-", self.particles_loose as f64),
            ("wall_drift", "m", self.wall_drift),
            ("settling_time", "s", self.settling_time),
            ("settling_residual", "-", self.settling_residual),
            ("settling_energy", "J", self.settling_energy),
            ("liquid_energy", "J", self.liquid_energy),
        ]
    }
}

/// Writes the rows so far; a table that is there is replaced.
pub(super) fn write(path: &Path, rows: &[Row]) -> Result<(), OutputError> {
    let head = Row::default();
    let columns = head
        .entries()
        .map(|(name, unit, _)| Column::new(name, unit));
    let mut table = TableWriter::create(path, &columns)?;
    for row in rows {
        table.write_row(&row.entries().map(|(_, _, value)| value))?;
    }
    table.sync()
}
