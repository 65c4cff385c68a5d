//! Starting a run and going on with one.

use super::course::Course;
use super::observer::Observer;
use super::steps::Run;
use super::{RunError, bubble_cloud, build, impacts, single_bubble};
use crate::case::Case;
use crate::output::{CheckpointStore, OutputError, RunFolder, hash_hex};
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

/// What to run, and where to.
#[derive(Debug, Clone)]
pub struct Start {
    /// Case file or folder.
    pub case: PathBuf,
    /// `path.to.key=value` replacements.
    pub overrides: Vec<String>,
    /// Run folder to make.
    pub output: PathBuf,
    /// Number of threads; all cores if none.
    pub threads: Option<usize>,
}

/// How a run ended without an error.
#[derive(Debug, Clone, PartialEq)]
pub enum Ended {
    /// At its end time; the report is written.
    Done {
        /// The report.
        report: PathBuf,
    },
    /// It was asked to stop; a checkpoint is written.
    Interrupted {
        /// Simulated time, s.
        time: f64,
    },
}

/// Starts a run in a new folder. `stop` asks it to write a checkpoint and end.
///
/// # Errors
/// A wrong case, a folder that cannot be used, a calculation that fails.
pub fn start(
    options: &Start,
    stop: &AtomicBool,
    observer: &mut dyn Observer,
) -> Result<Ended, RunError> {
    let loaded = Case::load(&options.case, &options.overrides, &[]).map_err(RunError::Case)?;
    let folder = RunFolder::create(&options.output)?;
    observer.say(&format!("run folder: {}", options.output.display()));
    folder.write_case(loaded.source.as_bytes(), &loaded.resolved_toml)?;
    let hash = hash_hex(loaded.resolved_toml.as_bytes());
    if let Some(bubble) = loaded.simulation.single_bubble {
        return single_bubble::Run::new(folder, loaded.simulation, bubble, hash)?
            .go(stop, observer);
    }
    if let Some(cloud) = loaded.simulation.bubble_cloud.clone() {
        return with_threads(options.threads, || {
            bubble_cloud::Run::new(folder, loaded.simulation, cloud, hash)?.go(stop, observer)
        });
    }
    with_threads(options.threads, || {
        observer.say("filling the bodies with particles");
        let (simulation, sequence) = impacts::begin(loaded.simulation);
        let world = build::world(&simulation)?;
        Run::new(folder, simulation, world, sequence, hash)?.go(stop, observer)
    })
}

/// Goes on from the newest good checkpoint of a run folder, bitwise as if it had never stopped.
///
/// # Errors
/// No usable checkpoint, a folder that cannot be used, a calculation that fails.
pub fn resume(
    dir: &Path,
    threads: Option<usize>,
    stop: &AtomicBool,
    observer: &mut dyn Observer,
) -> Result<Ended, RunError> {
    let folder = RunFolder::open(dir)?;
    folder.require_same_case()?;
    let loaded = Case::load(&folder.paths().resolved(), &[], &[]).map_err(RunError::Case)?;
    let text = std::fs::read(folder.paths().resolved()).map_err(|cause| OutputError::Read {
        path: folder.paths().resolved(),
        cause,
    })?;
    let hash = hash_hex(&text);
    let store = CheckpointStore::new(folder.paths().checkpoints());
    let found = store.load_newest(&hash)?;
    for refused in &found.refused {
        observer.say(&format!("{refused}"));
    }
    store.set_aside(&found.refused)?;
    observer.say(&format!(
        "going on from {} (t = {:.4e} s)",
        found.path.display(),
        found.checkpoint.meta.time
    ));
    let (ours, theirs) = (
        env!("CARGO_PKG_VERSION"),
        &found.checkpoint.meta.code_version,
    );
    if theirs != ours {
        observer.say(&format!(
            "it was written by Erode {theirs}, and this is {ours}: the result may differ from that of one version alone"
        ));
    }
    if let Some(bubble) = loaded.simulation.single_bubble {
        let checkpoint = &found.checkpoint;
        return single_bubble::Run::from_checkpoint(
            folder,
            loaded.simulation,
            bubble,
            hash,
            checkpoint,
        )?
        .go(stop, observer);
    }
    if let Some(cloud) = loaded.simulation.bubble_cloud.clone() {
        let checkpoint = &found.checkpoint;
        return with_threads(threads, || {
            bubble_cloud::Run::from_checkpoint(folder, loaded.simulation, cloud, hash, checkpoint)?
                .go(stop, observer)
        });
    }
    with_threads(threads, || {
        let state = &found.checkpoint.meta.extra["impacts"];
        let (simulation, world, sequence) = impacts::take_up(loaded.simulation, state)?;
        Run::from_checkpoint(folder, simulation, world, sequence, hash, &found.checkpoint)?
            .go(stop, observer)
    })
}

fn with_threads<T: Send>(
    threads: Option<usize>,
    work: impl FnOnce() -> Result<T, RunError>,
) -> Result<T, RunError> {
    if let Some(n) = threads {
        // The global pool can be set once; a second run in one process keeps the first one's pool.
        let built = rayon::ThreadPoolBuilder::new()
            .num_threads(n)
            .build_global();
        if let Err(e) = built
            && rayon::current_num_threads() != n
        {
            return Err(RunError::Threads(e.to_string()));
        }
    }
    work()
}
