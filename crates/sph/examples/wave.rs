#![allow(missing_docs, clippy::all, clippy::unwrap_used)]
//! plane wave water <-> steel
use erode_physics::eos::Tait;
use erode_physics::material_point::Material;
use erode_physics::strength::Strength;
use erode_physics::*;
use erode_sph::Geometry;
use erode_sph::fluid::ghosts::Plane;
use erode_sph::fluid::*;
use erode_sph::solid::{Block, Face, Numerics, Setup, Solid};
use erode_sph::world::*;
fn main() {
    let arg: Vec<String> = std::env::args().collect();
    let get = |k: &str, d: f64| -> f64 {
        arg.iter()
            .find_map(|a| a.strip_prefix(&format!("{k}=")))
            .map_or(d, |v| v.parse().unwrap())
    };
    let dx = 1.0e-5;
    let nx = 6;
    let width = get("width", 25.0) * dx;
    let to_steel = get("rev", 0.0) == 0.0;
    let geometry = if get("axi", 0.0) > 0.0 {
        Geometry::Axisymmetric
    } else {
        Geometry::Plane
    };
    let nf = get("nf", 400.0) as usize;
    let ns = get("ns", 1000.0) as usize;
    let eos = Tait {
        reference_density: 1000.0,
        sound_speed: 1500.0,
        gamma: 7.0,
    };
    let steel = Material {
        elastic: Elastic {
            young_modulus: 186e9,
            poisson_ratio: 0.3,
        },
        strength: Strength::Elastic,
        density: 7800.0,
        temperature: 293.0,
    };
    let mut xf = vec![];
    for i in 0..nx {
        for j in 0..nf {
            xf.push([(i as f64 + 0.5) * dx, (j as f64 + 0.5) * dx]);
        }
    }
    let mut xs = vec![];
    for i in 0..nx {
        for j in 0..ns {
            xs.push([(i as f64 + 0.5) * dx, -(j as f64 + 0.5) * dx]);
        }
    }
    let w = nx as f64 * dx;
    let mut f = Fluid::new(&Start {
        geometry,
        eos,
        position: &xf,
        area: &vec![dx * dx; xf.len()],
        pressure: 0.0,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Default::default()),
    });
    let left = if geometry == Geometry::Plane {
        Face::Symmetry
    } else {
        Face::Axis
    };
    let block = Block {
        lower: [0.0, -(ns as f64) * dx],
        upper: [w, 0.0],
        left,
        right: Face::Symmetry,
        bottom: Face::Absorbing,
        top: Face::Traction,
    };
    let mut s = Solid::new(Setup {
        geometry,
        block,
        material: steel,
        numerics: Numerics::default(),
        position: xs.clone(),
        area: vec![dx * dx; xs.len()],
    })
    .unwrap();
    let p0 = get("p", 1e6);
    let sig = width / 2.3548;
    let c_l = steel.elastic.longitudinal_speed(7800.0);
    if to_steel {
        let z0 = 4.0 * width.max(40.0 * dx) * 0.6;
        for a in 0..f.len() {
            let p = p0 * (-0.5 * ((f.position[a][1] - z0) / sig).powi(2)).exp();
            let rho = eos.density(p);
            f.volume[a] = f.mass[a] / rho;
            f.pressure[a] = p;
            f.velocity[a][1] = -eos.riemann_integral(rho);
        }
        println!("z0/dx {}", z0 / dx);
    } else {
        let width_s = get("width_s", 100.0) * dx;
        let sig = width_s / 2.3548;
        let z0 = -3.0 * width_s;
        for a in 0..s.len() {
            let g = (-0.5 * ((xs[a][1] - z0) / sig).powi(2)).exp();
            s.state.velocity[a][1] = p0 * g / (7800.0 * c_l);
            // displacement: u_z(z) with du/dz = -p/(rho c^2)
            let m = 2000;
            let mut u = 0.0;
            let lo = z0 - 5.0 * sig;
            let d = (xs[a][1] - lo) / m as f64;
            if d > 0.0 {
                for k in 0..m {
                    let z = lo + (k as f64 + 0.5) * d;
                    u -= p0 * (-0.5 * ((z - z0) / sig).powi(2)).exp() / (7800.0 * c_l * c_l) * d;
                }
            }
            s.state.position[a][1] += u;
        }
        s.update_stress(1e-12).unwrap();
    }
    if geometry == Geometry::Plane {
        f.sides.push(Plane {
            normal: [1.0, 0.0],
            offset: 0.0,
            speed: 0.0,
        });
    }
    f.sides.push(Plane {
        normal: [-1.0, 0.0],
        offset: -w,
        speed: 0.0,
    });
    let walls = vec![
        Named {
            name: "f".into(),
            body: Body::Fluid(f),
        },
        Named {
            name: "s".into(),
            body: Body::Solid(s),
        },
    ];
    let mut world = World::new(
        walls.into_iter().filter(|b| true || b.name == "").collect(),
        0.3,
    )
    .unwrap_or_else(|e| panic!("{e}"));
    let (mut imax, mut rmax, mut tmax, mut wall) = (0f64, 0f64, 0f64, 0f64);
    let (mut ri, mut ti) = (0.0, 0.0);
    let tend = get("t", 0.0).max(if to_steel {
        230.0 * dx / 1500.0
    } else {
        700.0 * dx / c_l
    });
    while world.time < tend {
        let dt = world.stable_time_step().0;
        world.advance(dt).unwrap();
        let (Body::Fluid(f), Body::Solid(s)) = (&world.bodies[0].body, &world.bodies[1].body)
        else {
            panic!()
        };
        let at_f = |z: f64| {
            let mut q = (0.0, 0.0);
            for a in 0..f.len() {
                let k = (-((f.position[a][1] - z) / dx).powi(2)).exp();
                q.0 += k * f.pressure[a];
                q.1 += k;
            }
            q.0 / q.1
        };
        let at_s = |z: f64| {
            let mut q = (0.0, 0.0);
            for a in 0..s.len() {
                let k = (-((s.reference.position[a][1] - z) / dx).powi(2)).exp();
                q.0 -= k * s.state.stress[a].yy;
                q.1 += k;
            }
            q.0 / q.1
        };
        wall = wall.max(
            s.surface(erode_sph::solid::Side::Top)
                .unwrap()
                .pressure
                .iter()
                .copied()
                .fold(0.0, f64::max),
        );
        if to_steel {
            let z = 50.0 * dx;
            let split = get("split", 110.0) * dx / 1500.0;
            let p = at_f(z);
            if world.time < split {
                imax = imax.max(p);
            } else {
                rmax = rmax.max(p);
                ri += p * dt;
            }
            let q = at_s(-100.0 * dx);
            tmax = tmax.max(q);
            ti += q * dt;
        } else {
            let z = -100.0 * dx;
            let p = at_s(z);
            let split = 295.0 * dx / c_l;
            imax = imax.max(p);
            if world.time > split {
                rmax = rmax.min(p);
                ri += p * dt;
            }
            let q = at_f(20.0 * dx);
            tmax = tmax.max(q);
            ti += q * dt;
        }
    }
    println!(
        "incident {:.4} reflected {:.4} transmitted {:.4} wall {:.4} (of p0)  R impulse {:.3e} T impulse {:.3e}; pulse impulse {:.3e}",
        imax / p0,
        rmax / p0,
        tmax / p0,
        wall / p0,
        ri,
        ti,
        p0 * sig * 2.5066 / 1500.0
    );
    println!(
        "R/I {:.4} (0.9343) T/I {:.4} (1.9343 | 0.0657)",
        rmax / imax,
        tmax / imax
    );
    let (Body::Fluid(f), Body::Solid(s)) = (&world.bodies[0].body, &world.bodies[1].body) else {
        panic!()
    };
    println!(
        "{:?} defect {:.3e} of {:.3e}",
        f.account,
        s.energy_defect(),
        s.energy().total()
    );
}
