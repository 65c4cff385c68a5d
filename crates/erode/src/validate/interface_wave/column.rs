//! Columns of water and steel, and a pulse in them.

use crate::validate::Failure;
use crate::validate::materials::{steel, water};
use erode_physics::material_point::Material;
use erode_physics::strength::Strength;
use erode_sph::Geometry;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::{Fluid, Formulation, Start};
use erode_sph::geometry::Vec2;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};
use erode_sph::world::{Body, Named, World};

/// Spacing, m.
pub(super) const DX: f64 = 1e-5;

/// Height of the pulse, Pa: weak enough for acoustics (0.04 % of the modulus of water).
pub(super) const HEIGHT: f64 = 1e6;

/// A Gaussian pulse along an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pulse {
    /// Coordinate along which it runs.
    pub(super) axis: usize,
    pub(super) centre: f64,
    /// Full width at half height, m.
    pub(super) width: f64,
    /// +1 or -1.
    pub(super) towards: f64,
}

impl Pulse {
    fn sigma(&self) -> f64 {
        self.width / (8.0 * std::f64::consts::LN_2).sqrt()
    }

    pub(super) fn pressure(&self, x: f64) -> f64 {
        HEIGHT * (-0.5 * ((x - self.centre) / self.sigma()).powi(2)).exp()
    }

    /// Integral of the pressure from far below to x: Simpson's rule, whose error is far below round-off of the stress.
    fn integral(&self, x: f64) -> f64 {
        let from = self.centre - 8.0 * self.sigma();
        if x <= from {
            return 0.0;
        }
        let n = 400;
        let d = (x - from) / f64::from(n);
        let weight = |k: i32| match k {
            0 => 1.0,
            k if k == n => 1.0,
            k if k % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=n)
            .map(|k| weight(k) * self.pressure(from + f64::from(k) * d))
            .sum();
        sum * d / 3.0
    }

    /// Adds the pulse to a liquid as a simple wave.
    pub(super) fn start_in_liquid(&self, f: &mut Fluid) {
        for a in 0..f.len() {
            let before = f.eos.riemann_integral(f.density(a));
            let p = f.pressure[a] + self.pressure(f.position[a][self.axis]);
            let rho = f.eos.density(p);
            f.volume[a] = f.mass[a] / rho;
            f.pressure[a] = p;
            f.velocity[a][self.axis] = self.towards * (f.eos.riemann_integral(rho) - before);
        }
    }

    /// Puts a solid at rest into the state of the pulse.
    pub(super) fn start_in_solid(&self, s: &mut Solid) -> Result<(), Failure> {
        let rho = s.material.density;
        let c = s.material.elastic.longitudinal_speed(rho);
        for a in 0..s.len() {
            let x = s.reference.position[a][self.axis];
            s.state.velocity[a][self.axis] = self.towards * self.pressure(x) / (rho * c);
            s.state.position[a][self.axis] -= self.integral(x) / (rho * c * c);
        }
        s.update_stress(1e-12)?;
        s.follow_surfaces();
        s.accelerations();
        Ok(())
    }
}

/// Lattice of `n` particles from `lower`.
fn lattice(lower: Vec2, n: [usize; 2]) -> Vec<Vec2> {
    let at = |k: usize| [(k % n[0]) as f64 + 0.5, (k / n[0]) as f64 + 0.5];
    (0..n[0] * n[1])
        .map(|k| [0, 1].map(|i| lower[i] + at(k)[i] * DX))
        .collect()
}

/// Water above z = 0 between rigid sides along z.
pub(super) fn water_column(
    geometry: Geometry,
    n: [usize; 2],
    pressure: f64,
) -> Result<Fluid, Failure> {
    let position = lattice([0.0; 2], n);
    let mut f = Fluid::new(&Start {
        geometry,
        eos: water()?,
        area: &vec![DX * DX; position.len()],
        position: &position,
        pressure,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(erode_sph::fluid::corrected::Settings::default()),
    });
    let side = |normal: Vec2, offset: f64| Plane {
        normal,
        offset,
        speed: 0.0,
    };
    if geometry == Geometry::Plane {
        f.sides.push(side([1.0, 0.0], 0.0));
    }
    f.sides.push(side([-1.0, 0.0], -(n[0] as f64) * DX));
    Ok(f)
}

/// Elastic steel below z = 0; `faces` are right, bottom, top.
pub(super) fn steel_block(
    geometry: Geometry,
    n: [usize; 2],
    [right, bottom, top]: [Face; 3],
) -> Result<Solid, Failure> {
    let (density, elastic, _) = steel()?;
    let size = n.map(|n| n as f64 * DX);
    let position = lattice([0.0, -size[1]], n);
    let left = match geometry {
        Geometry::Plane => Face::Symmetry,
        Geometry::Axisymmetric => Face::Axis,
    };
    Ok(Solid::new(Setup {
        geometry,
        block: Block {
            lower: [0.0, -size[1]],
            upper: [size[0], 0.0],
            left,
            right,
            bottom,
            top,
        },
        material: Material {
            elastic,
            strength: Strength::Elastic,
            density,
            temperature: 293.0,
        },
        numerics: Numerics::default(),
        area: vec![DX * DX; position.len()],
        position,
    })?)
}

/// A world of bodies with a liquid's usual safety.
pub(super) fn world(bodies: Vec<Body>) -> Result<World, Failure> {
    let name = |b: &Body| match b {
        Body::Fluid(_) => "water",
        Body::Solid(_) => "steel",
    };
    let named = bodies.into_iter().map(|body| Named {
        name: name(&body).into(),
        body,
    });
    Ok(World::new(named.collect(), 0.3)?)
}
