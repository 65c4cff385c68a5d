//! The finite elements of `validation/indentation-axisym`.

use crate::validate::Failure;
use crate::validate::columns::Columns;

/// What happens along the loaded surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Top {
    /// No radial displacement.
    Bonded,
    /// No shear traction.
    Free,
}

/// Results of one run of the finite elements, SI.
#[derive(Debug, Clone)]
pub(super) struct Reference {
    /// Curves of [`COMPONENTS`] over the reference radius, 0.12 mm below the surface.
    pub(super) line: Vec<Vec<[f64; 2]>>,
    /// Force over depth.
    pub(super) force: Vec<[f64; 2]>,
    pub(super) peak_strain: f64,
    pub(super) plastic_work: f64,
}

/// Name, column of the table and its unit.
pub(super) const COMPONENTS: [(&str, &str, f64); 6] = [
    ("stress rr", "sigma_rr_MPa", 1e6),
    ("stress zz", "sigma_zz_MPa", 1e6),
    ("stress tt", "sigma_tt_MPa", 1e6),
    ("stress rz", "sigma_rz_MPa", 1e6),
    ("von Mises stress", "von_mises_MPa", 1e6),
    ("plastic strain", "eq_plastic_strain_1", 1.0),
];

macro_rules! data {
    ($name:literal) => {
        include_str!(concat!(
            "../../../../../validation/indentation-axisym/",
            $name,
            ".csv"
        ))
    };
}

/// Line, force, and what `summary.csv` says of the finest mesh: peak strain at a Gauss point, plastic work in mJ.
fn tables(radius_um: u32, top: Top) -> (&'static str, &'static str, f64, f64) {
    match (radius_um, top) {
        (400, Top::Bonded) => (
            data!("line_material_R400_ur0"),
            data!("force_depth_R400_ur0"),
            0.019_630_89,
            0.231_067_3,
        ),
        (400, Top::Free) => (
            data!("line_material_R400_urfree"),
            data!("force_depth_R400_urfree"),
            0.019_267_24,
            0.220_506,
        ),
        (_, Top::Bonded) => (
            data!("line_material_R200_ur0"),
            data!("force_depth_R200_ur0"),
            0.041_984_6,
            0.100_449_9,
        ),
        (_, Top::Free) => (
            data!("line_material_R200_urfree"),
            data!("force_depth_R200_urfree"),
            0.042_563_17,
            0.099_933_29,
        ),
    }
}

pub(super) fn read(radius_um: u32, top: Top) -> Result<Reference, Failure> {
    let (line, force, peak_strain, plastic_work) = tables(radius_um, top);
    let line = Columns::parse(line)?;
    let curves = COMPONENTS.map(|(_, column, unit)| line.curve(column, 1e-3, unit));
    Ok(Reference {
        line: curves.into_iter().collect::<Result<_, _>>()?,
        force: Columns::parse(force)?.curve("force_N", 1e-6, 1.0)?,
        peak_strain,
        plastic_work: 1e-3 * plastic_work,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_the_summary() {
        let summary = data!("summary");
        for (radius, top, variant) in [
            (400, Top::Bonded, "0.4,u_r = 0,fine"),
            (400, Top::Free, "0.4,u_r free,fine"),
            (200, Top::Bonded, "0.2,u_r = 0,fine"),
            (200, Top::Free, "0.2,u_r free,fine"),
        ] {
            let row = summary.lines().find(|l| l.starts_with(variant)).unwrap();
            let cell = |i: usize| row.split(',').nth(i).unwrap().parse::<f64>().unwrap();
            let reference = read(radius, top).unwrap();
            assert!((reference.peak_strain / cell(9) - 1.0).abs() < 1e-6);
            assert!((reference.plastic_work / (1e-3 * cell(12)) - 1.0).abs() < 1e-6);
            assert!((reference.force.last().unwrap()[1] / cell(13) - 1.0).abs() < 1e-3);
        }
    }
}
