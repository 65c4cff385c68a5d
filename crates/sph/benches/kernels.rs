//! Times of the parts that steps are made of: `cargo bench -p erode-sph`.
//!
//! For whole steps of standard workloads use `erode bench`; for numbers that do not depend on what else the machine does, the
//! count of instructions in `benches/instructions.sh`.

#![allow(missing_docs)]

mod bodies;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use erode_sph::kernel;
use erode_sph::neighbours::Neighbours;
use erode_sph::solid::Solid;
use erode_sph::world::{Body, World};
use std::hint::black_box;

/// 4096 particles: one thread, and everything stays in its cache.
const ACROSS: usize = 64;

fn kernel_functions(c: &mut Criterion) {
    let distance: Vec<f64> = (0..1000).map(|k| 2.2e-3 * f64::from(k)).collect();
    let sum = |f: fn(f64, f64) -> f64| distance.iter().map(|&r| f(r, 1.0)).sum::<f64>();
    c.bench_function("1000 kernel values", |b| {
        b.iter(|| black_box(sum(kernel::value)));
    });
    c.bench_function("1000 kernel gradients", |b| {
        b.iter(|| black_box(sum(kernel::gradient_factor)));
    });
}

fn neighbour_list(c: &mut Criterion) {
    let (position, area) = bodies::lattice(ACROSS);
    let h = vec![1.3 * area.sqrt(); position.len()];
    c.bench_function("neighbours of 4096 particles", |b| {
        b.iter(|| Neighbours::build(black_box(&position), &h, position.len(), 0.0));
    });
}

fn moved(mut world: World, steps: usize) -> World {
    for _ in 0..steps {
        let (dt, _) = world.stable_time_step();
        world.advance(dt).expect("the body is at ease");
    }
    world
}

fn steps(c: &mut Criterion) {
    let water = moved(bodies::water(ACROSS).expect("water is alone"), 5);
    c.bench_function("step of 4096 particles of water", |b| {
        b.iter_batched(|| water.clone(), |w| moved(w, 1), BatchSize::LargeInput);
    });
    let steel = Body::Solid(bodies::steel(ACROSS).expect("the block is right"));
    let steel = moved(bodies::alone(steel).expect("steel is alone"), 12);
    c.bench_function("step of 4096 particles of yielding steel", |b| {
        b.iter_batched(|| steel.clone(), |w| moved(w, 1), BatchSize::LargeInput);
    });
    let Body::Solid(solid) = &steel.bodies[0].body else {
        return;
    };
    let forces = |mut s: Solid| {
        s.accelerations();
        s
    };
    c.bench_function("forces on 4096 particles of steel", |b| {
        b.iter_batched(|| solid.clone(), forces, BatchSize::LargeInput);
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30);
    targets = kernel_functions, neighbour_list, steps
}
criterion_main!(benches);
