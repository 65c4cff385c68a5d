//! throw-away
use erode_physics::bubble::*;
use erode_physics::eos::Tait;
use erode_sph::Geometry;
use erode_sph::fluid::corrected::Settings;
use erode_sph::fluid::far_field::FarField;
use erode_sph::fluid::gas::{Gas, GasLaw};
use erode_sph::fluid::ghosts::{Ghosts, Plane};
use erode_sph::fluid::{Fluid, Formulation, Start};
use erode_sph::packing::{Arrangement, Options, Spacing, pack};
use erode_sph::shapes::{Region, Shape};
use erode_sph::world::{Body, Named, World};
const R0: f64 = 1e-4;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let num = |k: usize, d: f64| args.get(k).map_or(d, |s| s.parse().unwrap());
    let (n, p, extent, until) = (num(1, 15.0), num(2, 1e6), num(3, 50.0) * R0, num(4, 2.5));
    let shells = num(5, 0.0) > 0.0;
    let shift = num(6, 10.0);
    let pg = num(7, 1e5);
    let dx = R0 / n;
    let region = Region::new(Shape::Rectangle { lower: [0.0, -extent], upper: [extent, extent] })
        .with_hole(Shape::Disc { centre: [0.0; 2], radius: R0 });
    let spacing = Spacing {
        finest: dx, coarsest: extent / 8.0, growth: 0.06 * 30.0 / n,
        core: if shells { Some(Shape::Disc { centre: [0.0;2], radius: 1.4*R0}) } else { Some(Shape::Rectangle { lower: [0.0, -1.4 * R0], upper: [1.4 * R0, 1.4 * R0] }) },
    };
    let options = Options { arrangement: if shells { Arrangement::Shells } else { Arrangement::Lattice }, ..Options::default() };
    let packing = pack(&region, &spacing, &options).unwrap();
    let eos = Tait { reference_density: 1000.0, sound_speed: 1500.0, gamma: 7.0 };
    let mut f = Fluid::new(&Start { geometry: Geometry::Axisymmetric, eos, position: &packing.position, area: &packing.area, pressure: p, velocity: [0.0; 2], formulation: Formulation::Corrected(Settings { shifting: shift, ..Settings::default() }) });
    let far = FarField { pressure: p, step_pressure: p, ..FarField::NONE };
    for normal in [[-1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
        f.open_side(&Plane { normal, offset: -extent, speed: 0.0 }, far);
    }
    let law = GasLaw { pressure: pg, polytropic_exponent: 1.4, limits: [[0.0, -2.0 * R0], [2.0 * R0, 2.0 * R0]], cell: 0.5 * dx };
    f.gas = Gas::fill(law, &f, &Ghosts::find(&f, &[]));
    let v0 = f.gas.as_ref().unwrap().volume();
    let particles = f.len();
    eprintln!("particles {particles} r {}", (v0 / (4.0 / 3.0 * std::f64::consts::PI)).cbrt() / R0);
    let liquid = Liquid { density: eos.density(p), sound_speed: 1500.0, viscosity: 0.0, surface_tension: 0.0, vapour_pressure: 0.0 };
    let gas = erode_physics::bubble::Gas { pressure: pg, radius: R0, polytropic_exponent: 1.4 };
    let tc = 0.915 * R0 * (1000.0 / p).sqrt();
    let mut state = BubbleState::at_rest(R0, 0.0).unwrap();
    let mut events: Vec<Event> = Vec::new();
    let mut world = World::new(vec![Named { name: "water".into(), body: Body::Fluid(f) }], 0.3).unwrap();
    let start = std::time::Instant::now();
    let mut e0 = None;
    let (mut rmin, mut rmax) = ((0.0, 9.0), (0.0, 0.0));
    let mut next = 0.0;
    while world.time < until * tc {
        let dt = world.stable_time_step().0;
        world.advance(dt).unwrap();
        let Body::Fluid(f) = &world.bodies[0].body else { unreachable!() };
        let g = f.gas.as_ref().unwrap();
        let balance = f.kinetic_energy() + f.compression_energy() + f.account.dissipation - f.account.far_field_work + g.energy() + g.lost;
        let r = (g.volume() / v0).cbrt();
        if r < rmin.1 { rmin = (world.time / tc, r); rmax = (0.0, 0.0); }
        if r > rmax.1 { rmax = (world.time / tc, r); }
        let e0 = *e0.get_or_insert(balance);
        if world.time >= next * tc {
            next += 0.04;
            advance(&KellerMiksis, &liquid, &gas, &Constant { pressure: p }, &Controls::default(), &mut state, world.time, &mut events).unwrap();
            let r = (g.volume() / v0).cbrt();
            // roundness
            let win = erode_sph::cavity::Window { lower: [0.0, -2.0 * R0], upper: [2.0 * R0, 2.0 * R0], cell: 0.5 * dx };
            let colour = erode_sph::cavity::Colour::new(f, &Ghosts::find(f, &[]), win);
            let radii = colour.radii([0.0; 2], 24);
            let (lo, hi) = radii.iter().fold((f64::MAX, 0.0f64), |m, r| (m.0.min(*r), m.1.max(*r)));
            println!("{:.3} R {:.4} KM {:.4} pockets {} p {:.3e} rough {:.3} defect/pV0 {:.4} diss {:.4} closed {} steps {}", world.time / tc, r, state.radius / R0, g.pockets.len(), g.pockets.first().map_or(0.0, |p| p.pressure), (hi - lo) / (r * R0), (balance - e0) / (p * v0), f.account.dissipation/(p*v0), g.closed, world.step);
        }
    }
    for m in 0..3 {
        let mut state = BubbleState::at_rest(R0, 0.0).unwrap();
        let mut ev: Vec<Event> = Vec::new();
        let g = Gilmore { tait_exponent: 7.0, reference_pressure: p };
        let mut liquid = liquid;
        liquid.sound_speed = eos.sound_speed_at(eos.density(p));
        match m {
            0 => advance(&KellerMiksis, &liquid, &gas, &Constant { pressure: p }, &Controls::default(), &mut state, 3.0 * tc, &mut ev).map(|_| ()).unwrap(),
            1 => advance(&TomitaShima { density_factor: 1.0 }, &liquid, &gas, &Constant { pressure: p }, &Controls::default(), &mut state, 3.0 * tc, &mut ev).map(|_| ()).unwrap(),
            _ => advance(&g, &liquid, &gas, &Constant { pressure: p }, &Controls::default(), &mut state, 3.0 * tc, &mut ev).map(|_| ()).unwrap(),
        }
        eprintln!("{m} {:?}", ev.iter().map(|e| (e.time / tc, e.radius / R0)).collect::<Vec<_>>());
    }
    eprintln!("min {rmin:?} max {rmax:?}");
    eprintln!("{:?} {:?}", events.iter().map(|e| (e.time / tc, e.radius / R0)).collect::<Vec<_>>(), start.elapsed());
}
