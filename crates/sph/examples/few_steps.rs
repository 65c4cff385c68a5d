//! A fixed number of steps of one small body, for counting instructions (`benches/instructions.sh`).
//!
//! `few_steps water|steel STEPS`

#[path = "../benches/bodies/mod.rs"]
mod bodies;

use erode_sph::world::Body;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let (body, steps) = (words.next(), words.next());
    let mut world = match body.as_deref() {
        Some("water") => bodies::water(48)?,
        Some("steel") => bodies::alone(Body::Solid(bodies::steel(48)?))?,
        _ => return Err("usage: few_steps water|steel STEPS".into()),
    };
    let steps: u32 = steps.ok_or("how many steps?")?.parse()?;
    for _ in 0..steps {
        let (dt, _) = world.stable_time_step();
        world.advance(dt)?;
    }
    println!("{steps} steps to {:e} s", world.time);
    Ok(())
}
