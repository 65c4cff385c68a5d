//! The state of a world as named arrays of a checkpoint, and back.

use super::{RunError, refinement};
use crate::output::Checkpoint;
use erode_physics::tensor::Sym3;
use erode_sph::departed::Departed;
use erode_sph::fluid::Clustering;
use erode_sph::world::{Body, World};
use serde_json::{Value, json};

/// Stores all that the next step depends on.
///
/// # Errors
/// Never in practice: only if two bodies had the same name.
pub(crate) fn store(world: &World, checkpoint: &mut Checkpoint) -> Result<(), RunError> {
    for named in &world.bodies {
        let key = |field: &str| format!("{}/{field}", named.name);
        match &named.body {
            Body::Fluid(f) => {
                checkpoint.push_vectors(&key("position"), &f.position)?;
                checkpoint.push_vectors(&key("velocity"), &f.velocity)?;
                checkpoint.push_vectors(&key("acceleration"), &f.acceleration)?;
                checkpoint.push(&key("mass"), f.mass.clone())?;
                checkpoint.push(&key("volume"), f.volume.clone())?;
                checkpoint.push(&key("pressure"), f.pressure.clone())?;
                checkpoint.push(&key("smoothing_length"), f.smoothing_length.clone())?;
                checkpoint.push(&key("support"), f.support.clone())?;
                checkpoint.push(&key("strain_rate"), f.strain_rate.clone())?;
                let clusters = f.clustering;
                let state = vec![clusters.fresh as f64, f64::from(u8::from(clusters.stale))];
                checkpoint.push(&key("cluster_state"), state)?;
                refinement::store(f, &named.name, checkpoint)?;
            }
            Body::Solid(s) => {
                let q = &s.state;
                checkpoint.push_vectors(&key("position"), &q.position)?;
                checkpoint.push_vectors(&key("velocity"), &q.velocity)?;
                checkpoint.push_vectors(&key("acceleration"), &q.acceleration)?;
                let deformation: Vec<[f64; 4]> = q
                    .deformation
                    .iter()
                    .map(|f| [f[0][0], f[0][1], f[1][0], f[1][1]])
                    .collect();
                checkpoint.push_vectors(&key("deformation"), &deformation)?;
                let stress: Vec<[f64; 6]> = q
                    .stress
                    .iter()
                    .map(|t| [t.xx, t.yy, t.zz, t.xy, t.xz, t.yz])
                    .collect();
                checkpoint.push_vectors(&key("stress"), &stress)?;
                for (name, values) in scalars(q) {
                    checkpoint.push(&key(name), values.clone())?;
                }
            }
        }
    }
    Ok(())
}

fn scalars(q: &erode_sph::solid::State) -> [(&'static str, &Vec<f64>); 9] {
    [
        ("hoop_stretch", &q.hoop_stretch),
        ("von_mises", &q.von_mises),
        ("plastic_strain", &q.plastic_strain),
        ("plastic_strain_rate", &q.plastic_strain_rate),
        ("plastic_work", &q.plastic_work),
        ("temperature", &q.temperature),
        ("damage", &q.damage),
        ("damage_work", &q.damage_work),
        ("removed", &q.removed),
    ]
}

/// What is counted since the start, for the description of a checkpoint.
#[must_use]
pub(crate) fn accounts(world: &World) -> Value {
    let all = world.bodies.iter().map(|named| match &named.body {
        Body::Fluid(f) => json!({ "account": f.account, "gas": f.gas }),
        // A renewed reference configuration goes with it.
        Body::Solid(s) => json!({ "work": s.state.work, "base": s.state.base }),
    });
    let departed = (world.departed.liquids > 0).then(|| json!({ "departed": world.departed }));
    all.chain(departed).collect()
}

/// Puts the state of a checkpoint into a world freshly built from the same case.
///
/// # Errors
/// If an array is missing or has another length than the world.
pub(crate) fn restore(
    world: &mut World,
    checkpoint: &Checkpoint,
    accounts: &Value,
) -> Result<(), RunError> {
    world.time = checkpoint.meta.time;
    world.step = checkpoint.meta.step;
    let departed = accounts.as_array().and_then(|a| a.last()?.get("departed"));
    world.departed = match departed {
        Some(value) => serde_json::from_value(value.clone()).map_err(|e| {
            RunError::Checkpoint(format!("what left with liquids is not readable ({e})"))
        })?,
        None => Departed::default(),
    };
    for (i, named) in world.bodies.iter_mut().enumerate() {
        let name = named.name.clone();
        let vectors = |field: &str, n: usize| -> Result<Vec<[f64; 2]>, RunError> {
            fits(
                checkpoint.vectors::<2>(&format!("{name}/{field}"))?,
                n,
                &name,
                field,
            )
        };
        let numbers = |field: &str, n: usize| -> Result<Vec<f64>, RunError> {
            fits(
                checkpoint.f64(&format!("{name}/{field}"))?.to_vec(),
                n,
                &name,
                field,
            )
        };
        let account = accounts.get(i).cloned().unwrap_or(Value::Null);
        let wrong = |e: serde_json::Error| {
            RunError::Checkpoint(format!(
                "the account of body `{name}` is not readable ({e})"
            ))
        };
        match &mut named.body {
            Body::Fluid(f) => {
                f.account = serde_json::from_value(account["account"].clone()).map_err(wrong)?;
                refinement::restore(f, &name, checkpoint)?;
                let n = f.len();
                f.position = vectors("position", n)?;
                f.velocity = vectors("velocity", n)?;
                f.acceleration = vectors("acceleration", n)?;
                f.mass = numbers("mass", n)?;
                f.volume = numbers("volume", n)?;
                f.pressure = numbers("pressure", n)?;
                f.smoothing_length = numbers("smoothing_length", n)?;
                f.support = numbers("support", n)?;
                f.strain_rate = numbers("strain_rate", n)?;
                let state = numbers("cluster_state", 2)?;
                f.clustering = Clustering {
                    fresh: state[0] as usize,
                    stale: state[1] != 0.0,
                };
                f.gas = serde_json::from_value(account["gas"].clone()).map_err(wrong)?;
            }
            Body::Solid(s) => {
                let n = s.len();
                s.state.position = vectors("position", n)?;
                s.state.velocity = vectors("velocity", n)?;
                s.state.acceleration = vectors("acceleration", n)?;
                let deformation = checkpoint.vectors::<4>(&format!("{name}/deformation"))?;
                s.state.deformation = fits(deformation, n, &name, "deformation")?
                    .into_iter()
                    .map(|f| [[f[0], f[1]], [f[2], f[3]]])
                    .collect();
                let stress = checkpoint.vectors::<6>(&format!("{name}/stress"))?;
                s.state.stress = fits(stress, n, &name, "stress")?
                    .into_iter()
                    .map(|t| Sym3 {
                        xx: t[0],
                        yy: t[1],
                        zz: t[2],
                        xy: t[3],
                        xz: t[4],
                        yz: t[5],
                    })
                    .collect();
                s.state.hoop_stretch = numbers("hoop_stretch", n)?;
                s.state.von_mises = numbers("von_mises", n)?;
                s.state.plastic_strain = numbers("plastic_strain", n)?;
                s.state.plastic_strain_rate = numbers("plastic_strain_rate", n)?;
                s.state.plastic_work = numbers("plastic_work", n)?;
                s.state.temperature = numbers("temperature", n)?;
                s.state.damage = numbers("damage", n)?;
                s.state.damage_work = numbers("damage_work", n)?;
                s.state.removed = numbers("removed", n)?;
                s.state.work = serde_json::from_value(account["work"].clone()).map_err(wrong)?;
                s.state.base = serde_json::from_value(account["base"].clone()).map_err(wrong)?;
                s.take_up()
                    .map_err(|e| RunError::Checkpoint(format!("body `{name}`: {e}")))?;
            }
        }
    }
    Ok(())
}

fn fits<T>(values: Vec<T>, n: usize, body: &str, field: &str) -> Result<Vec<T>, RunError> {
    if values.len() == n {
        Ok(values)
    } else {
        let found = values.len();
        Err(RunError::Checkpoint(format!(
            "`{field}` of body `{body}` has {found} entries, the case makes {n}"
        )))
    }
}
