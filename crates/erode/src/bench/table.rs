//! What was measured, for people.

use super::{Machine, Measurement, Outcome, Run};
use std::fmt::Write;

/// The outcome as text.
#[must_use]
pub fn text(outcome: &Outcome) -> String {
    let m = &outcome.machine;
    let mut text = format!(
        "Erode {} on {}, {} cores; measured peak {:.0} Gflop/s with 1 thread, {:.0} with 2 (f64)\n",
        outcome.version, m.processor, m.cores, m.peak_one_thread, m.peak_two_threads
    );
    for w in &outcome.workloads {
        write_workload(&mut text, m, w);
    }
    text
}

fn write_workload(text: &mut String, machine: &Machine, w: &Measurement) {
    let neighbours = w.pairs as f64 / w.particles as f64;
    let checkpoint =
        (w.checkpoint_seconds).map_or_else(String::new, |s| format!("; one checkpoint {s:.2} s"));
    let _ = writeln!(text, "\n{}: {}", w.name, w.description);
    let _ = writeln!(
        text,
        "  {} particles, {neighbours:.1} neighbours each, {} steps; resident memory {} bytes per particle{checkpoint}",
        w.particles,
        w.steps,
        known(w.bytes_per_particle, 0),
    );
    let _ = writeln!(
        text,
        "  threads  M steps/s   mean  per CPU s  M pairs/s  of peak   time by phase"
    );
    for run in &w.runs {
        let _ = writeln!(text, "{}", line(machine, run));
    }
    let asked = match w.target {
        Some(t) if w.runs[0].rate < t => format!("; asked {t:.1} with 1 thread: missed"),
        Some(t) => format!("; asked {t:.1} with 1 thread: reached"),
        None => String::new(),
    };
    let _ = writeln!(text, "  2 threads over 1: {:.2}{asked}", w.two_over_one);
}

/// A number, or a dash where it is not known.
fn known(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".into(), |x| format!("{x:.digits$}"))
}

fn line(machine: &Machine, run: &Run) -> String {
    let peak = if run.threads == 1 {
        machine.peak_one_thread
    } else {
        machine.peak_two_threads
    };
    let phases: Vec<String> = (run.phases.iter())
        .filter_map(|(name, share)| Some((name, share.as_f64()?)))
        .filter(|(_, share)| *share > 0.0)
        .map(|(name, share)| format!("{} {:.0} %", name.replace('_', " "), 100.0 * share))
        .collect();
    format!(
        "  {:7}  {:9.2}  {:5.2}  {:>9}  {:9.1}  {:5.1} %   {}",
        run.threads,
        run.rate,
        run.mean_rate,
        known(run.rate_per_processor_second, 2),
        run.pair_rate,
        100.0 * run.operation_rate / peak,
        phases.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_known_is_a_dash_and_no_zero() {
        assert_eq!(
            [known(Some(0.0), 0), known(Some(1.25), 1), known(None, 0)],
            ["0", "1.2", "-"]
        );
    }
}
