//! `erode bench`.

use super::{
    args::BenchArgs,
    failure::{Failure, Outcome as Ended},
    json,
    say::say,
};
use erode::bench::{self, Outcome, Workload};
use std::path::Path;
use std::process::Command;

/// Measures workloads and prints the table.
pub(crate) fn run(args: &BenchArgs) -> Ended {
    if args.list {
        list();
        return Ok(());
    }
    let chosen = bench::selected(&args.cases)
        .map_err(|e| Failure::input(e.to_string(), "`erode bench --list` tells what they are"))?;
    let outcome = if let [workload] = chosen[..] {
        bench::run(workload, args.particles.map(|n| n as usize)).map_err(|e| failed(&e))?
    } else {
        each_alone(&chosen, args)?
    };
    say!("{}", bench::text(&outcome));
    json::write_and_end(args.json.as_deref(), &outcome, Ok(()))
}

fn list() {
    say!(
        "Workloads, to be used as `erode bench --case NAME`; those with a star are the usual ones:"
    );
    for w in &bench::ALL {
        let star = if w.usual { '*' } else { ' ' };
        say!("{star} {:22} {}", w.name, w.description);
    }
}

/// Measures each workload in a process of its own.
fn each_alone(workloads: &[&Workload], args: &BenchArgs) -> Result<Outcome, Failure> {
    let folder = tempfile::tempdir().map_err(|e| failed(&e))?;
    let file = folder.path().join("outcome.json");
    let mut parts = Vec::new();
    for w in workloads {
        eprintln!("{}: {}", w.name, w.description);
        parts.push(alone(w, args.particles, &file)?);
    }
    Outcome::joined(parts).ok_or_else(|| failed(&"nothing was measured"))
}

fn alone(workload: &Workload, particles: Option<u32>, file: &Path) -> Result<Outcome, Failure> {
    let mut command = Command::new(std::env::current_exe().map_err(|e| failed(&e))?);
    command
        .args(["bench", "--case", workload.name, "--json"])
        .arg(file);
    if let Some(n) = particles {
        command.args(["--particles", &n.to_string()]);
    }
    let output = command.output().map_err(|e| failed(&e))?;
    if !output.status.success() {
        // It has said already that it failed, and why.
        let said = String::from_utf8_lossy(&output.stderr);
        let said = said.trim().trim_start_matches("error: ");
        return Err(Failure::failed(
            format!("workload {}: {said}", workload.name),
            "",
        ));
    }
    let text = std::fs::read_to_string(file).map_err(|e| failed(&e))?;
    serde_json::from_str(&text).map_err(|e| failed(&e))
}

fn failed(e: &dyn std::fmt::Display) -> Failure {
    Failure::failed(format!("the benchmark failed: {e}"), "")
}
