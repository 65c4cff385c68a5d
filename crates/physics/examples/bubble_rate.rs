//! How many bubbles and collapses are computed per second: `cargo run --release -p erode-physics --example bubble_rate`.
//!
//! Bubbles of 4 to 12 um in the acoustic field of Peters and el Moctar 2020, section 4.1, over two periods with
//! Keller-Miksis; some 25 collapses each, from violent ones to the last rebounds. Arguments: bubbles, tolerance, threads.

use erode_physics::bubble::{
    BubbleError, BubbleState, Controls, KellerMiksis, Liquid, Member, Sine, advance_all,
    equilibrium_gas,
};
use std::time::Instant;

fn main() -> Result<(), BubbleError> {
    let mut arguments = std::env::args().skip(1);
    let mut number = |usual: f64| {
        let given = arguments.next().and_then(|text| text.parse().ok());
        given.unwrap_or(usual)
    };
    let (bubbles, tolerance, threads) = (number(2000.0), number(1e-8), number(1.0));
    let driving = Sine {
        mean: 1e5,
        amplitude: 132e3,
        frequency: 21.4e3,
    };
    let liquid = Liquid::WATER;
    let make = |i: u32| -> Result<Member<Sine, ()>, BubbleError> {
        let radius = 4e-6 + 8e-6 * f64::from(i) / bubbles;
        Ok(Member {
            gas: equilibrium_gas(&liquid, radius, 1e5, 4.0 / 3.0)?,
            state: BubbleState::at_rest(radius, 0.0)?,
            driving,
            watch: (),
        })
    };
    let mut members: Vec<Member<Sine, ()>> =
        (0..bubbles as u32).map(make).collect::<Result<_, _>>()?;
    let controls = Controls {
        tolerance,
        ..Controls::default()
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads as usize)
        .build();
    let Ok(pool) = pool else {
        eprintln!("the threads could not be started");
        return Ok(());
    };
    let begun = Instant::now();
    pool.install(|| {
        advance_all(
            &KellerMiksis,
            &liquid,
            &controls,
            &mut members,
            2.0 / driving.frequency,
        )
    })
    .map_err(|(_, error)| error)?;
    let seconds = begun.elapsed().as_secs_f64();
    let sum = |f: fn(&Member<Sine, ()>) -> u64| members.iter().map(f).sum::<u64>() as f64;
    let collapses = sum(|m| m.state.counters.collapses);
    let steps = sum(|m| m.state.counters.steps + m.state.counters.rejected);
    println!(
        "{bubbles} bubbles, {collapses} collapses, {steps} steps in {seconds:.2} s, tolerance {tolerance:e}"
    );
    println!(
        "{:.3e} collapses and {:.3e} steps per second and thread",
        collapses / seconds / threads,
        steps / seconds / threads
    );
    Ok(())
}
