//! The main case beside the source: plastic strain of A-2205 after a bubble of 0.15 mm collapsed, 50 MPa.
//!
//! Joshi 2018, section 6.4.1: standoff 1.33 (figure 6.7): 0.23 %, off the axis; standoff 0.66 (figure 6.8): 0.83 %, on
//! the axis.

use super::Check;

/// Scalars of a finished run of the main case, SI, as named in `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MainCase {
    /// Largest equivalent plastic strain.
    pub max_plastic_strain: f64,
    /// Its distance from the axis, m.
    pub max_plastic_strain_r: f64,
    /// Its depth below the surface, m.
    pub max_plastic_strain_depth: f64,
    /// Largest speed of the jet, m/s.
    pub jet_speed: f64,
    /// Time of collapse, s.
    pub collapse_time: f64,
    /// Defect of the energy ledger, relative.
    pub energy_drift: f64,
    /// Radius of the bubble at the start, m.
    pub radius: f64,
    /// Particles per radius.
    pub particles_per_radius: f64,
}

/// What the source says about one standoff.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// Largest equivalent plastic strain.
    pub max_plastic_strain: f64,
    /// Whether it lies off the axis.
    pub off_axis: bool,
}

/// Standoff 1.33.
pub const DETACHED: Source = Source {
    max_plastic_strain: 0.0023,
    off_axis: true,
};

/// Standoff 0.66.
pub const ATTACHED: Source = Source {
    max_plastic_strain: 0.0083,
    off_axis: false,
};

const SIDE_BY_SIDE: &str = "one published run of another method, without error bars; the jet tip is not converged at \
                            any resolution, so the value is set beside it and not judged";

/// Checks of a finished run against the source.
#[must_use]
pub fn checks(source: &Source, run: &MainCase) -> Vec<Check> {
    let spacing = run.radius / run.particles_per_radius;
    let place = run.max_plastic_strain_r;
    let off_axis = "the source has it off the axis; two spacings tell it from the axis";
    let on_axis =
        "the source has it on the axis; within two spacings it cannot be told from the axis";
    let largest = Check::shown(
        "largest plastic strain",
        "-",
        run.max_plastic_strain,
        Some(source.max_plastic_strain),
        SIDE_BY_SIDE,
    );
    let where_it_is = if source.off_axis {
        Check::at_least(
            "its distance from the axis",
            "m",
            place,
            2.0 * spacing,
            off_axis,
        )
    } else {
        Check::absolute(
            "its distance from the axis",
            "m",
            (place, 0.0),
            2.0 * spacing,
            on_axis,
        )
    };
    let shown = |what: &str, unit: &str, value| {
        Check::shown(what, unit, value, None, "the source gives no number")
    };
    vec![
        largest,
        where_it_is,
        shown("its depth", "m", run.max_plastic_strain_depth),
        shown("jet speed", "m/s", run.jet_speed),
        shown("collapse time", "s", run.collapse_time),
        Check::absolute(
            "defect of the energy ledger",
            "-",
            (run.energy_drift, 0.0),
            0.01,
            "issue 2: the ledger closes to 1 %",
        ),
    ]
}
