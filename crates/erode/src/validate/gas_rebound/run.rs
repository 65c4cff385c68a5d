//! One bubble with gas, by particles and by a law of spherical bubbles.

use super::spherical::Spherical;
use crate::validate::Failure;
use crate::validate::materials::water;
use erode_physics::bubble::{self, BubbleModel, BubbleState, Constant, Controls, Liquid, advance};
use erode_sph::Geometry;
use erode_sph::cavity::{Window, fronts};
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::gas::{Gas, GasLaw};
use erode_sph::fluid::ghosts::{Ghosts, Plane};
use erode_sph::fluid::refinement::Refinement;
use erode_sph::fluid::{Fluid, Formulation, Start};
use erode_sph::packing::{Options, Spacing, pack};
use erode_sph::shapes::{Region, Shape};
use erode_sph::world::{Body, Named, World};
use std::f64::consts::PI;

/// Radius at the start, m.
pub(super) const R0: f64 = 1e-4;
/// Density of water at zero pressure, kg/m3.
pub(super) const DENSITY: f64 = 1000.0;
/// Adiabatic gas.
const EXPONENT: f64 = 1.4;
/// Cavities below this radius are not refined, R0: a little less than the smallest radius at 50 MPa.
const SMALLEST: f64 = 0.05;
/// The finest spacing reaches to this distance, R0.
const CORE: f64 = 1.4;
/// Growth of the spacing per distance at `n` particles per radius, times n.
const GROWTH: f64 = 1.8;
/// Points of a curve of the theory.
const POINTS: u32 = 4000;

/// How many particles lie over the radius of the bubble.
#[derive(Clone, Copy)]
pub(super) struct Particles {
    /// At the start.
    pub(super) n: f64,
    /// That refinement keeps there, if it is asked for.
    pub(super) kept: Option<f64>,
}

impl Particles {
    /// As in tables.
    pub(super) fn name(&self) -> String {
        match self.kept {
            None => format!("n = {}", self.n),
            Some(kept) => format!("n = {}, refined to {kept} per R", self.n),
        }
    }
}

/// What is computed.
#[derive(Clone, Copy)]
pub(super) struct Setting {
    pub(super) name: &'static str,
    /// Of the water, Pa.
    pub(super) pressure: f64,
    /// Of the gas at the start, Pa.
    pub(super) gas_pressure: f64,
    /// Half of the domain, R0.
    pub(super) extent: f64,
    /// Time simulated, in collapse times 0.915 R0 sqrt(rho/p).
    pub(super) end: f64,
    /// Thinnest shell of the calculation in one dimension, R0: a thirtieth of the smallest radius or less.
    pub(super) finest_shell: f64,
}

/// Radius against time, and what was counted.
pub(super) struct Swing {
    /// Time (s) and R/R0.
    pub(super) curve: Vec<[f64; 2]>,
    /// Defect of the ledger at the same times, p V0.
    defects: Vec<f64>,
    pub(super) closed: u64,
    /// Radius of the bubble before it moved, R0: particles fill the liquid around it to a part of a spacing.
    pub(super) first_radius: f64,
}

impl Swing {
    /// A radius known from theory.
    fn of(curve: Vec<[f64; 2]>) -> Self {
        Self {
            curve,
            defects: Vec::new(),
            closed: 0,
            first_radius: 1.0,
        }
    }

    /// Largest defect until a time, p V0.
    pub(super) fn defect(&self, until: f64) -> f64 {
        let all = self.curve.iter().zip(&self.defects);
        let all = all.filter(|(p, _)| p[0] <= until);
        all.map(|(_, d)| d.abs()).fold(0.0, f64::max)
    }
}

/// The first two extremes of a swing that loses energy, time (s) and R/R0 each.
pub(super) struct Extremes {
    pub(super) first: [f64; 2],
    pub(super) second: [f64; 2],
}

impl Extremes {
    /// Smallest radius and the largest after it.
    pub(super) fn of_collapse(curve: &[[f64; 2]]) -> Result<Self, Failure> {
        Self::find(curve, 1.0)
    }

    /// Largest radius and the smallest after it.
    pub(super) fn of_growth(curve: &[[f64; 2]]) -> Result<Self, Failure> {
        Self::find(curve, -1.0)
    }

    fn find(curve: &[[f64; 2]], sign: f64) -> Result<Self, Failure> {
        let at = |curve: &[[f64; 2]], sign: f64| {
            let all = curve.iter().enumerate();
            let least = all.min_by(|a, b| (sign * a.1[1]).total_cmp(&(sign * b.1[1])));
            let none = || Failure::Absent("the radius has no extremes".into());
            least.map(|(k, p)| (k, *p)).ok_or_else(none)
        };
        let (first, smallest) = at(curve, sign)?;
        let (_, largest) = at(&curve[first..], -sign)?;
        Ok(Self {
            first: smallest,
            second: largest,
        })
    }
}

impl Setting {
    fn end_time(&self) -> f64 {
        self.end * 0.915 * R0 * (DENSITY / self.pressure).sqrt()
    }

    /// The radius by a law. A compressible liquid moves at once when its surface is let go, with the speed dp/(rho c) of a plane
    /// wave; the laws follow from then on. (From rest they are late by R0/c.)
    pub(super) fn theory(&self, law: &dyn BubbleModel) -> Result<Swing, Failure> {
        let eos = water()?;
        let liquid = Liquid {
            density: eos.density(self.pressure),
            sound_speed: eos.sound_speed_at(eos.density(self.pressure)),
            viscosity: 0.0,
            surface_tension: 0.0,
            vapour_pressure: 0.0,
        };
        let gas = bubble::Gas {
            pressure: self.gas_pressure,
            radius: R0,
            polytropic_exponent: EXPONENT,
        };
        let wrong = |e: bubble::BubbleError| Failure::Absent(e.to_string());
        let driving = Constant {
            pressure: self.pressure,
        };
        let speed = (self.gas_pressure - self.pressure) / (liquid.density * liquid.sound_speed);
        let mut state = BubbleState::moving(R0, speed, 0.0).map_err(wrong)?;
        let mut curve = Vec::new();
        for k in 1..=POINTS {
            let time = self.end_time() * 1.3 * f64::from(k) / f64::from(POINTS);
            let controls = Controls::default();
            advance(
                law,
                &liquid,
                &gas,
                &driving,
                &controls,
                &mut state,
                time,
                &mut (),
            )
            .map_err(wrong)?;
            curve.push([time, state.radius / R0]);
        }
        Ok(Swing::of(curve))
    }

    /// The radius by the equations of the compressible liquid in one dimension, with shells finer by `refined`.
    pub(super) fn in_one_dimension(&self, refined: f64) -> Result<Swing, Failure> {
        let eos = water()?;
        let end = self.end_time() * 1.1;
        let gas = (self.gas_pressure, EXPONENT);
        // Sound is not back from there before the end.
        let extent = 1.0 + 0.6 * end * eos.sound_speed_at(eos.density(self.pressure)) / R0;
        let shells = (self.finest_shell / refined, extent);
        let mut bubble = Spherical::new(eos, self.pressure, gas, shells);
        let mut curve = Vec::new();
        while bubble.time * R0 < end {
            bubble.step();
            curve.push([bubble.time * R0, bubble.radius]);
        }
        if curve.iter().all(|p| p[1].is_finite()) {
            Ok(Swing::of(curve))
        } else {
            let message = "the calculation in one dimension has no finite radius";
            Err(Failure::Absent(message.into()))
        }
    }

    fn liquid(&self, dx: f64) -> Result<Fluid, Failure> {
        let extent = self.extent * R0;
        let region = Region::new(Shape::Rectangle {
            lower: [0.0, -extent],
            upper: [extent, extent],
        })
        .with_hole(Shape::Disc {
            centre: [0.0; 2],
            radius: R0,
        });
        let spacing = Spacing {
            finest: dx,
            coarsest: extent / 8.0,
            growth: GROWTH * dx / R0,
            core: Some(Shape::Rectangle {
                lower: [0.0, -CORE * R0],
                upper: [CORE * R0; 2],
            }),
        };
        let packing = pack(&region, &spacing, &Options::default())?;
        let mut f = Fluid::new(&Start {
            geometry: Geometry::Axisymmetric,
            eos: water()?,
            position: &packing.position,
            area: &packing.area,
            pressure: self.pressure,
            velocity: [0.0; 2],
            formulation: Formulation::Corrected(Settings::default()),
        });
        let far = FarField {
            pressure: self.pressure,
            step_pressure: self.pressure,
            ..FarField::NONE
        };
        for normal in [[-1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
            let side = Plane {
                normal,
                offset: -extent,
                speed: 0.0,
            };
            f.open_side(&side, far);
        }
        let law = GasLaw {
            pressure: self.gas_pressure,
            polytropic_exponent: EXPONENT,
            limits: [[0.0, -2.0 * R0], [2.0 * R0; 2]],
            ends: [[true, false], [false; 2]],
            cell: 0.5 * dx,
        };
        f.gas = Gas::fill(law, &f, &Ghosts::find(&f, &[]));
        Ok(f)
    }
}

/// Refines after a step where it is asked for.
fn refine(world: &mut World, particles: &Particles) {
    let step = world.step;
    let Some(Body::Fluid(f)) = world.bodies.first_mut().map(|b| &mut b.body) else {
        return;
    };
    let (Some(kept), Some(gas)) = (particles.kept, &f.gas) else {
        return;
    };
    if !Refinement::is_due(step) {
        return;
    }
    let asked = Refinement {
        per_radius: kept,
        growth: GROWTH / particles.n,
        smallest: SMALLEST * R0,
    };
    let cell = gas.law.cell;
    let reach = 1.3 * (0.75 * gas.volume() / PI).cbrt() + 8.0 * cell;
    let window = Window {
        lower: [0.0, -reach],
        upper: [reach; 2],
        cell,
    };
    let found = fronts(f, &[], window, asked.smallest);
    f.refine(&asked, &found, step);
}

/// The same by particles. Times are those of a bubble of the radius R0: all of them are proportional to the radius
/// of the bubble, the only length.
pub(super) fn run(setting: &Setting, particles: Particles) -> Result<Swing, Failure> {
    let body = Body::Fluid(setting.liquid(R0 / particles.n)?);
    let name = "water".into();
    let mut world = World::new(vec![Named { name, body }], 0.3)?;
    let (mut curve, mut defects) = (Vec::new(), Vec::new());
    let (mut start, mut closed, mut first_radius) = (None, 0, 1.0);
    while world.time < setting.end_time() {
        let dt = world.stable_time_step().0;
        world.advance(dt)?;
        refine(&mut world, &particles);
        let Some(Body::Fluid(f)) = world.bodies.first().map(|b| &b.body) else {
            return Err(Failure::Absent("there is no water".into()));
        };
        let Some(gas) = &f.gas else {
            return Err(Failure::Absent("there is no gas".into()));
        };
        let account = &f.account;
        let energy = f.kinetic_energy() + f.compression_energy() + gas.energy() + gas.lost;
        let balance = energy + account.dissipation - account.far_field_work;
        let first = *start.get_or_insert(balance);
        first_radius = (0.75 * gas.first_volume / PI).cbrt() / R0;
        let radius = (gas.volume() / gas.first_volume).cbrt();
        curve.push([world.time / first_radius, radius]);
        defects.push((balance - first) / (setting.pressure * gas.first_volume));
        closed = gas.closed;
    }
    Ok(Swing {
        curve,
        defects,
        closed,
        first_radius,
    })
}
