//! One indentation: a Gaussian displacement pressed slowly into the top of a block.

use super::reference::{COMPONENTS, Top};
use crate::validate::Failure;
use crate::validate::steel_lattice::Lattice;
use erode_physics::load::gaussian_one_percent;
use erode_sph::Geometry;
use erode_sph::solid::{Driven, Face, Formulation, QuasiStatic, Side, Solid, Tangential};
use std::time::Instant;

const SIZE: [f64; 2] = [1e-3, 0.8e-3];
/// Depth of the pit on the axis, m.
const DEPTH: f64 = 6e-6;
/// Height of the line, and how far it is compared: the corner beyond is a stress of a few MPa.
const LINE: f64 = 0.68e-3;
const LINE_END: f64 = 0.9e-3;
/// Twenty passages of a wave through the height.
const LOADING: QuasiStatic = QuasiStatic {
    ramp: 3e-6,
    hold: 0.5e-6,
    damping: 5e6,
};

/// What is pressed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Case {
    pub(super) radius_um: u32,
    pub(super) top: Top,
    pub(super) spacing: f64,
    pub(super) formulation: Formulation,
    /// +1 pushes, -1 pulls.
    pub(super) sign: f64,
}

/// What came out.
#[derive(Debug, Clone)]
pub(super) struct Indented {
    /// Curves of [`COMPONENTS`]; normal and shear stresses times the sign of the load.
    pub(super) line: Vec<Vec<[f64; 2]>>,
    pub(super) force: Vec<[f64; 2]>,
    pub(super) peak_strain: f64,
    pub(super) plastic_work: f64,
    /// Kinetic over internal energy at the end.
    pub(super) inertia: f64,
    /// What the energy ledger misses over the work done.
    pub(super) defect: f64,
    pub(super) particles: usize,
    pub(super) steps: u64,
    pub(super) seconds: f64,
}

impl Case {
    pub(super) fn new(radius_um: u32, top: Top, spacing: f64) -> Self {
        Self {
            radius_um,
            top,
            spacing,
            formulation: Formulation::TotalLagrangian,
            sign: 1.0,
        }
    }

    /// How the case is called in tables.
    pub(super) fn title(&self) -> String {
        let top = match self.top {
            Top::Bonded => "bonded",
            Top::Free => "free of shear",
        };
        format!(
            "R {} mm, top {top}, {} um",
            f64::from(self.radius_um) * 1e-3,
            (self.spacing * 1e6).round()
        )
    }

    fn lattice(&self) -> Lattice {
        let tangential = match self.top {
            Top::Bonded => Tangential::Bonded,
            Top::Free => Tangential::Free,
        };
        let top = Driven {
            tangential,
            part: None,
        };
        Lattice {
            geometry: Geometry::Axisymmetric,
            size: SIZE,
            spacing: self.spacing,
            faces: [
                Face::Axis,
                Face::Symmetry,
                Face::Symmetry,
                Face::Driven(top),
            ],
            formulation: self.formulation,
        }
    }

    pub(super) fn run(&self) -> Result<Indented, Failure> {
        let (start, lattice) = (Instant::now(), self.lattice());
        let mut solid = lattice.build()?;
        let radius = f64::from(self.radius_um) * 1e-6;
        let depth = |r: f64| self.sign * DEPTH * gaussian_one_percent(r, radius);
        let (mut force, mut steps) = (vec![[0.0; 2]], 0);
        LOADING.run(
            &mut solid,
            |solid, share| {
                if let Some(top) = solid.surface_mut(Side::Top) {
                    top.drive(|x| [share.value, share.rate].map(|s| [0.0, -s * depth(x[0])]));
                }
            },
            |solid, share| {
                steps += 1;
                if share.rate > 0.0 {
                    let push = solid.surface(Side::Top).map_or(f64::NAN, |s| -s.force()[1]);
                    force.push([share.value * DEPTH, self.sign * push]);
                }
            },
        )?;
        Ok(Indented {
            line: self.line(&lattice, &solid),
            force,
            peak_strain: lattice.peak_strain(&solid),
            plastic_work: solid.energy().plastic_work,
            inertia: solid.inertia_share(),
            defect: solid.energy_defect() / solid.state.work.driving,
            particles: solid.len(),
            steps,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    fn line(&self, lattice: &Lattice, solid: &Solid) -> Vec<Vec<[f64; 2]>> {
        let value = |component: usize, k: usize| {
            let s = solid.state.stress[k];
            let signed = [s.xx, s.yy, s.zz, s.xy].map(|x| self.sign * x);
            match component {
                4 => s.von_mises(),
                5 => solid.state.plastic_strain[k],
                i => signed[i],
            }
        };
        (0..COMPONENTS.len())
            .map(|c| lattice.line(LINE, LINE_END, |k| value(c, k)))
            .collect()
    }
}
