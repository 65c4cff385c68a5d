#![allow(missing_docs, clippy::all, clippy::unwrap_used)]
use erode_physics::eos::Tait;
use erode_sph::Geometry;
use erode_sph::cavity::{Colour, Window};
use erode_sph::fluid::Formulation;
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::ghosts::{Ghosts, Plane, Wall};
use erode_sph::fluid::{Fluid, Start};
use erode_sph::world::*;
fn main() {
    let arg: Vec<String> = std::env::args().collect();
    let get = |k: &str, d: f64| -> f64 {
        arg.iter()
            .find_map(|a| a.strip_prefix(&format!("{k}=")))
            .map_or(d, |v| v.parse().unwrap())
    };
    let n = get("n", 30.0);
    let r0 = 0.095e-3;
    let c0 = 1500.0;
    let dx = r0 / n;
    let eos = Tait {
        reference_density: 1000.0,
        sound_speed: c0,
        gamma: 7.0,
    };
    let p0 = 60e6;
    let big = get("domain", 5.0) * r0;
    let (mut pos, mut area) = (vec![], vec![]);
    if get("shells", 0.0) > 0.0 {
        let grow = get("grow", 0.06 * 30.0 / n);
        let mut rho = r0;
        let s_of = |rho: f64| (dx + grow * (rho - 1.35 * r0).max(0.0)).min(8.0 * dx);
        while rho < big {
            let s = s_of(rho + 0.5 * s_of(rho));
            let mid = rho + 0.5 * s;
            let m = (std::f64::consts::PI * mid / s).round();
            for k in 0..m as usize {
                let th = std::f64::consts::PI * (k as f64 + 0.5) / m;
                pos.push([mid * th.sin(), mid * th.cos()]);
                // exact ring volume / (2 pi r)
                let v = 2.0 * std::f64::consts::PI / 3.0
                    * ((rho + s).powi(3) - rho.powi(3))
                    * ((th - 0.5 * std::f64::consts::PI / m).cos()
                        - (th + 0.5 * std::f64::consts::PI / m).cos());
                area.push(v / (2.0 * std::f64::consts::PI * mid * th.sin()));
            }
            rho += s;
        }
    } else if get("pack", 0.0) > 0.0 {
        use erode_sph::{packing::*, shapes::*};
        let core = get("core", 1.4) * r0;
        let pk = pack(
            &Region::new(Shape::Rectangle {
                lower: [0.0, -big],
                upper: [big, big],
            })
            .with_hole(Shape::Disc {
                centre: [0.0; 2],
                radius: r0,
            }),
            &Spacing {
                finest: dx,
                coarsest: 8.0 * dx,
                growth: get("grow", 0.06 * 30.0 / n),
                core: Some(Shape::Rectangle {
                    lower: [0.0, -core],
                    upper: [core, core],
                }),
            },
            &Options {
                arrangement: if get("shells_core", 0.0) > 0.0 {
                    Arrangement::Shells
                } else {
                    Arrangement::Lattice
                },
                ..Default::default()
            },
        )
        .unwrap();
        println!("pack {:?} steps {}", pk.residual, pk.steps);
        pos = pk.position;
        area = pk.area;
    } else {
        let m = (big / dx).round() as i64;
        for i in 0..m {
            for j in -m..m {
                let x = [(i as f64 + 0.5) * dx, (j as f64 + 0.5) * dx];
                if x[0].hypot(x[1]) > r0 {
                    pos.push(x);
                    area.push(dx * dx);
                }
            }
        }
    }
    let mut f = Fluid::new(&Start {
        geometry: Geometry::Axisymmetric,
        eos,
        position: &pos,
        area: &area,
        pressure: p0,
        velocity: [0.0; 2],
        formulation: Formulation::Corrected(Settings::default()),
    });
    let far = FarField {
        normal: [0.0; 2],
        pressure: p0,
        step_pressure: p0,
        start: 0.0, rise: 0.0,
        face_area: 0.0,
    };
    if get("shells", 0.0) == 0.0 {
        for (nn, off) in [([-1.0, 0.0], -big), ([0.0, -1.0], -big), ([0.0, 1.0], -big)] {
            f.open_side(
                &Plane {
                    normal: nn,
                    offset: off,
                    speed: 0.0,
                },
                far,
            );
        }
    } else {
        for a in 0..f.len() {
            let x = f.position[a];
            let rr = x[0].hypot(x[1]);
            if rr > big - 2.5 * f.smoothing_length[a] {
                f.far_field[a] = FarField {
                    normal: [x[0] / rr, x[1] / rr],
                    ..far
                };
            }
        }
    }
    f.formulation = Formulation::Corrected(Settings {
        shifting: get("k", 10.0),
        shifting_limit: get("lim", 2.0),
    });
    let mut w = World {
        bodies: vec![Named {
            name: "l".into(),
            body: Body::Fluid(f.clone()),
        }],
        time: 0.0,
        step: 0,
        safety: get("cfl", 0.3),
    };
    // reference
    let text = std::fs::read_to_string(
        "../shared/reference/bubble-compressible-60MPa/tait_empty60_R_of_t.csv",
    )
    .unwrap();
    let rf: Vec<(f64, f64, f64)> = text
        .lines()
        .skip(1)
        .map(|l| {
            let v: Vec<f64> = l.split(',').map(|s| s.parse().unwrap_or(0.0)).collect();
            (v[0], v[5], v[7])
        })
        .collect();
    let mut t = 0.0;
    let mut steps = 0;
    let e0 = f.kinetic_energy() + f.compression_energy();
    let m0: f64 = f.mass.iter().sum();
    let mut last = (0.0, 1.0);
    let marks = [0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.15, 0.1];
    let mut mi = 0;
    let cfl = get("cfl", 0.3);
    let wall: [&dyn Wall; 0] = [];
    let _: Option<Plane> = None;
    let t0 = std::time::Instant::now();
    println!("n {} particles {}", n, f.len());
    let mut hist: Vec<(f64, f64)> = vec![];
    while t < 3.4e-7 && steps < 20000 {
        let dt = w.stable_time_step().0;
        w.advance(dt).unwrap();
        let Body::Fluid(ff) = &w.bodies[0].body else {
            panic!()
        };
        let f = ff;
        t += dt;
        steps += 1;
        if steps % 4 != 0 {
            continue;
        }
        let g = Ghosts::find(f, &wall);
        let col = Colour::new(
            f,
            &g,
            Window {
                lower: [0.0, -1.3 * r0],
                upper: [1.3 * r0, 1.3 * r0],
                cell: 0.5 * dx,
            },
        );
        let cav = col.cavities(2);
        let vol = cav.first().map_or(0.0, |c| c.volume);
        let mean = (vol * 3.0 / (4.0 * std::f64::consts::PI)).cbrt() / r0;
        let sec = col.radii([0.0, 0.0], 16);
        let mx = sec.iter().copied().fold(0.0, f64::max) / r0;
        let mn = sec.iter().copied().fold(1e9, f64::min) / r0;
        hist.push((t, mean));
        while mi < marks.len() && mean < marks[mi] {
            let tr = last.0 + (t - last.0) * (last.1 - marks[mi]) / (last.1 - mean);
            // speed by a fit over the last R change of 0.06
            let lo = hist
                .iter()
                .rposition(|h| h.1 > marks[mi] * 1.08)
                .unwrap_or(0);
            let pts = &hist[lo..];
            let (mut sx, mut sy, mut sxx, mut sxy) = (0.0, 0.0, 0.0, 0.0);
            for p in pts {
                let (a, b) = ((p.0 - t) * 1e9, p.1.powf(2.5));
                sx += a;
                sy += b;
                sxx += a * a;
                sxy += a * b;
            }
            let k = pts.len() as f64;
            let slope =
                (k * sxy - sx * sy) / (k * sxx - sx * sx) * 1e9 / (2.5 * (sy / k).powf(0.6));
            let rmid = (sy / k).powf(0.4);
            let q = rf.windows(2).find(|w| w[1].0 <= rmid).unwrap();
            let vref = q[0].2 + (q[1].2 - q[0].2) * (q[0].0 - rmid) / (q[0].0 - q[1].0);
            let r = rf.iter().find(|r| (r.0 - marks[mi]).abs() < 1e-9);
            if let Some(r) = r {
                let e = f.kinetic_energy() + f.compression_energy();
                println!(
                    "R {:.2} t {:+.2}% v {:+.1}% round {:.3} steps {} E {:.4} ({:.2} pV0) M {:.1e} pmax {:.0} MPa ledger {:.5}",
                    marks[mi],
                    100.0 * (tr / r.1 - 1.0),
                    100.0 * (slope * r0 / vref - 1.0),
                    (mx - mn) / mean,
                    steps,
                    e / e0 - 1.0,
                    (e - e0) / (p0 * 4.19 * r0.powi(3)),
                    f.mass.iter().sum::<f64>() / m0 - 1.0,
                    f.pressure.iter().copied().fold(0.0, f64::max) / 1e6,
                    (e - e0 + f.account.dissipation - f.account.far_field_work)
                        / (p0 * 4.19 * r0.powi(3))
                );
            }
            mi += 1;
        }
        last = (t, mean);
        if mi >= marks.len() {
            break;
        }
    }
    if let Body::Fluid(f) = &w.bodies[0].body {
        println!("{:?}", f.account);
    }
    println!(
        "end t {:.3e} steps {} wall {:.1}",
        t,
        steps,
        t0.elapsed().as_secs_f64()
    );
}
