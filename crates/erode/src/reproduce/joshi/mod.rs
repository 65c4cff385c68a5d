//! Tables and figures of chapters 4, 6 and 7 of Joshi 2018: a bubble collapsing next to A-2205 steel.
//!
//! Statements are judged by the numbers that the text gives. Where it gives none, or leaves out a parameter, the value is
//! shown and not judged, and the note says what was assumed.

mod chapter4;
mod chapter6;
mod chapter6_times;
mod chapter6_wall;
mod chapter7;
mod chapter7_pressure;
mod chapter7_rate;
mod chapter7_size;
mod collapse;
mod near_wall;
mod resolution;
mod slow_loading;

use super::session::{Judged, Need, Session};
use super::{Kind, Reproduction};
use crate::validate::Failure;

const CHAPTER_4: &str = "Joshi 2018, section 4.3";
const CHAPTER_6: &str = "Joshi 2018, section 6.4";
const CHAPTER_7: &str = "Joshi 2018, section 7.3";

type Needs = fn(&super::Options) -> Vec<Need>;
type Judge = fn(&Session) -> Result<Judged, Failure>;

const fn of(
    id: &'static str,
    shows: &'static str,
    source: &'static str,
    needs: Needs,
    judge: Judge,
) -> Reproduction {
    Reproduction {
        id,
        shows,
        source,
        kind: Kind::OfRuns { needs, judge },
    }
}

pub(super) const ALL: [Reproduction; 23] = [
    of(
        "joshi-table-4.1",
        "speed of the jet in plane against the particle spacing",
        CHAPTER_4,
        chapter4::spacing_needs,
        chapter4::spacing,
    ),
    of(
        "joshi-table-4.2",
        "speed of the jet in plane against the CFL number",
        CHAPTER_4,
        chapter4::step_needs,
        chapter4::step,
    ),
    of(
        "joshi-fig-4.6",
        "collapse next to steel in plane: does the metal yield",
        CHAPTER_4,
        chapter4::steel_needs,
        chapter4::steel,
    ),
    of(
        "joshi-fig-6.3",
        "radius of a collapsing bubble far from walls against Rayleigh's solution",
        "Joshi 2018, section 6.3.1",
        collapse::needs,
        collapse::judge,
    ),
    of(
        "joshi-fig-6.7",
        "detached cavity, stand-off 1.33: plastic strain and its place",
        CHAPTER_6,
        chapter6::detached_needs,
        chapter6::detached,
    ),
    of(
        "joshi-fig-6.8",
        "attached cavity, stand-off 0.66: strain by the jet and by the ring",
        CHAPTER_6,
        chapter6::attached_needs,
        chapter6::attached,
    ),
    of(
        "joshi-fig-6.9",
        "pressure along the wall at six instants, plastic strain along the wall",
        CHAPTER_6,
        chapter6::detached_needs,
        chapter6_wall::profiles,
    ),
    of(
        "joshi-fig-6.10",
        "detached cavity without strain-rate effect",
        CHAPTER_6,
        chapter6::rate_needs,
        chapter6::rate,
    ),
    of(
        "joshi-fig-6.11",
        "the metal under the recorded pressure, slowly: is the offset due to inertia",
        CHAPTER_6,
        slow_loading::needs,
        slow_loading::judge,
    ),
    of(
        "joshi-fig-6.14",
        "speed and pressure of the shock front along the wall, eq. 6.20",
        CHAPTER_6,
        chapter6::detached_needs,
        chapter6_wall::front_along_wall,
    ),
    of(
        "joshi-fig-6.16",
        "effective pressure (6.21) and plastic strain for three stand-offs",
        CHAPTER_6,
        chapter6_wall::effective_needs,
        chapter6_wall::effective,
    ),
    of(
        "joshi-fig-6.18",
        "characteristic times of load and metal, stand-off 1.33",
        CHAPTER_6,
        chapter6::detached_needs,
        chapter6_times::detached,
    ),
    of(
        "joshi-fig-6.19",
        "characteristic times of load and metal, stand-off 1.2",
        CHAPTER_6,
        chapter6_times::near_needs,
        chapter6_times::near,
    ),
    of(
        "joshi-fig-7.3",
        "plastic strain for seven stand-offs",
        CHAPTER_7,
        chapter7::standoff_needs,
        chapter7::strain_of_standoff,
    ),
    of(
        "joshi-fig-7.4",
        "absorbed energy and its density against stand-off",
        CHAPTER_7,
        chapter7::standoff_needs,
        chapter7::energy_of_standoff,
    ),
    of(
        "joshi-fig-7.5",
        "plastic strain for three driving pressures",
        CHAPTER_7,
        chapter7_pressure::pressure_needs,
        chapter7_pressure::strain_of_pressure,
    ),
    of(
        "joshi-fig-7.6",
        "absorbed energy and its density against driving pressure",
        CHAPTER_7,
        chapter7_pressure::pressure_needs,
        chapter7_pressure::energy_of_pressure,
    ),
    of(
        "joshi-fig-7.7",
        "plastic strain for three bubble radii",
        CHAPTER_7,
        chapter7_size::size_needs,
        chapter7_size::strain_of_size,
    ),
    of(
        "joshi-fig-7.8",
        "absorbed energy and its density against bubble radius",
        CHAPTER_7,
        chapter7_size::size_needs,
        chapter7_size::energy_of_size,
    ),
    of(
        "joshi-fig-7.9",
        "plastic volume against bubble volume",
        CHAPTER_7,
        chapter7_size::size_needs,
        chapter7_size::volume_of_size,
    ),
    of(
        "joshi-fig-7.10",
        "plastic strain with and without strain-rate effect",
        CHAPTER_7,
        chapter7_rate::rate_needs,
        chapter7_rate::rate,
    ),
    of(
        "joshi-fig-7.11",
        "plastic deformation potential against stand-off",
        CHAPTER_7,
        chapter7::standoff_needs,
        chapter7::potential_of_standoff,
    ),
    of(
        "joshi-resolution",
        "the detached cavity at four resolutions: order and error bar of every scalar (no figure of the source)",
        CHAPTER_6,
        resolution::needs,
        resolution::judge,
    ),
];
