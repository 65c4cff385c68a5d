//! The arguments of all commands, with the texts of `--help`.

use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Erode: from the flow to the pit.
#[derive(Debug, Parser)]
#[command(
    name = "erode",
    version,
    about = "A simulator of material erosion: a bubble collapses, metal is pitted",
    long_about = "A simulator of material erosion: a bubble collapses next to a metal, Erode computes the flow, the \
                  impact and the plastic deformation, and reports the pit.\n\n\
                  A case is a TOML file, or a folder with a case.toml. A run writes a folder with fields for \
                  ParaView, histories as CSV, checkpoints and a report that opens in a browser.",
    after_long_help = "\
First steps:
  erode new bubble-near-wall mycase   write a commented case
  erode check mycase                  what is understood, how large, how long
  erode run mycase                    compute it
  erode report RUN                    rebuild its report

Exit codes:
  0 done
  1 the case (or the command line) is wrong
  2 the run, or one of a sweep, failed for a named cause;
    a validation missed its tolerance; a reproduction does not
    meet its source or lacks data; a file could not be written
  3 interrupted, a checkpoint is written: go on with erode resume"
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write a commented case to start from
    #[command(
        long_about = "Writes a commented case to start from: DIR/case.toml. Without a template, lists them.\n\n\
                            An existing case is never overwritten."
    )]
    #[command(after_long_help = "Example:\n  erode new bubble-near-wall mycase")]
    New(NewArgs),
    /// Check a case: keys, physics, size, cost
    #[command(
        long_about = "Checks a case without running it: prints what was understood, the particles of each body, \
                            memory, time step and an estimate of the time a run takes.\n\n\
                            All errors are shown in one pass, each with its place and what is allowed."
    )]
    #[command(after_long_help = "Examples:
  erode check cases/bubble-near-steel
  erode check cases/bubble-near-steel --set setup.bubble_near_wall.particles_per_radius=60
  erode check cases/bubble-near-steel --resolved > resolved.toml
  erode check --schema > case.schema.json")]
    Check(CheckArgs),
    /// Run a case
    #[command(
        long_about = "Runs a case and writes a run folder: case.toml (as given), resolved.toml (every default), \
                            history.csv, probes, fields for ParaView, checkpoints, summary.json, report/index.html.\n\n\
                            Ctrl-C writes a checkpoint and ends with exit code 3; erode resume goes on from there."
    )]
    #[command(after_long_help = "Examples:
  erode run cases/bubble-near-steel
  erode run cases/bubble-near-steel -o runs/first --threads 2
  erode run cases/bubble-near-steel --set setup.bubble_near_wall.standoff=1.1
  erode run mycase --set \"run.end_time=1.5 us\" --set body.wall.solid.strain_rate=false")]
    Run(RunArgs),
    /// Go on with an interrupted run, bitwise equal
    #[command(
        long_about = "Goes on from the last good checkpoint of a run folder. The result is bitwise equal to that \
                            of a run without interruption, for any number of threads."
    )]
    #[command(after_long_help = "Example:\n  erode resume runs/first")]
    Resume(ResumeArgs),
    /// Rebuild report/index.html of a run folder
    #[command(
        long_about = "Rebuilds report/index.html from what a run folder holds; the report is one file that opens \
                            offline."
    )]
    #[command(after_long_help = "Example:\n  erode report runs/first")]
    Report(ReportArgs),
    /// Many runs of one case: lists and grids of values, one table of results
    #[command(
        long_about = "Does many runs of one case as a sweep file says. Its keys: title; case (file or folder, relative to \
                            the sweep file); [set] for all runs; [grid] with lists of which every combination is run; [zip] \
                            with lists whose first values are taken together, then the second ones, and so on; [[run]] for \
                            runs one by one; [quick] with settings of --quick. All keys under them are those of `--set`.\n\n\
                            All cases are checked, and the cost is told, before the first run. Complete runs are skipped, \
                            begun ones go on, a failed one stops none. Results: results.csv, results.parquet, report.html. \
                            A changed sweep is refused in the folder of an old one, with the difference."
    )]
    #[command(after_long_help = "Example of a sweep file:
  case = \"cases/bubble-near-steel\"
  [set]
  \"setup.bubble_near_wall.particles_per_radius\" = 15
  [grid]
  \"setup.bubble_near_wall.standoff\" = [0.66, 1.0, 1.33]
  \"setup.bubble_near_wall.driving_pressure\" = [\"25 MPa\", \"50 MPa\"]

Examples:
  erode sweep standoff.toml --dry-run
  erode sweep standoff.toml -o sweeps/standoff --threads 2")]
    Sweep(SweepArgs),
    /// Compare with references: result, error, tolerance
    #[command(
        long_about = "Runs validations and prints reference, result, error and tolerance of each. Without names, \
                            lists what there is. A missed tolerance ends with exit code 2."
    )]
    #[command(after_long_help = "Examples:
  erode validate rayleigh-collapse
  erode validate --all --quick --json results.json")]
    Validate(ValidateArgs),
    /// A figure of the sources: computed, drawn, compared with the text
    #[command(
        long_about = "Computes figures and tables of the sources again, draws them (SVG and HTML), and compares them with \
                            what the text beside them states. Without an ID, lists what there is. A statement that is not \
                            met ends with exit code 2; nothing is tuned to a misprint."
    )]
    #[command(after_long_help = "Examples:
  erode reproduce peters-fig-11
  erode reproduce peters-fig-13 peters-fig-14 -o figures --json figures.json
  erode reproduce 'joshi-fig-7.*' --quick --dry-run
  erode reproduce 'joshi-fig-7.*' --quick

What is made of runs keeps them in DIR/runs, shared between figures: complete ones are not done again.")]
    Reproduce(ReproduceArgs),
    /// The material library, with sources
    #[command(
        long_about = "Lists the materials, or shows one in full: each number with its unit and source, and what \
                            the sources do not give.\n\n\
                            Own materials: NAME.toml files in a folder `materials` beside the case, or \
                            [material.NAME] tables in the case."
    )]
    #[command(after_long_help = "Examples:\n  erode materials\n  erode materials steel_a2205")]
    Materials(MaterialsArgs),
    /// Where a run stands
    #[command(long_about = "Prints where a run stands, from the status.json of its folder.")]
    #[command(after_long_help = "Example:\n  erode status runs/first")]
    Status(StatusArgs),
    /// How fast steps are on this machine
    #[command(
        long_about = "Measures whole steps of standard workloads with one thread and with two, and prints million \
                            particle-steps per second, pairs per second, share of the measured peak of the machine, time by \
                            phase and memory. Without a case, measures the usual ones (about a minute). Other work on the \
                            machine makes the numbers smaller. How to read them: docs/performance.md."
    )]
    #[command(after_long_help = "Examples:
  erode bench --list
  erode bench
  erode bench --case solid-plane --case main-case-60 --json bench.json")]
    Bench(BenchArgs),
}

/// `erode new`
#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Template; leave it out to list them
    pub(crate) template: Option<String>,
    /// Folder for the case; named after the template when left out
    pub(crate) dir: Option<PathBuf>,
}

/// `erode check`
#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Case file, or folder with a case.toml
    #[arg(required_unless_present = "schema")]
    pub(crate) case: Option<PathBuf>,
    /// Replace a value: path.to.key=value; may be given several times
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub(crate) set: Vec<String>,
    /// Print the case with every default written out, and nothing else
    #[arg(long)]
    pub(crate) resolved: bool,
    /// Print the JSON schema of case files, for editors
    #[arg(long, conflicts_with_all = ["case", "set", "resolved"])]
    pub(crate) schema: bool,
}

/// `erode run`
#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    /// Case file, or folder with a case.toml
    pub(crate) case: PathBuf,
    /// Run folder to write
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// Replace a value: path.to.key=value; may be given several times
    #[arg(long = "set", value_name = "PATH=VALUE")]
    pub(crate) set: Vec<String>,
    /// Number of threads; all cores when left out; results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
}

/// `erode resume`
#[derive(Debug, Args)]
pub(crate) struct ResumeArgs {
    /// Run folder
    pub(crate) dir: PathBuf,
    /// Number of threads; all cores when left out; results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
}

/// `erode report`
#[derive(Debug, Args)]
pub(crate) struct ReportArgs {
    /// Run folder
    pub(crate) dir: PathBuf,
}

/// `erode sweep`
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// Sweep file
    pub(crate) file: PathBuf,
    /// Folder for runs and results; sweeps/NAME when left out
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,
    /// With the settings under [quick]
    #[arg(long)]
    pub(crate) quick: bool,
    /// Show the runs and their cost, and run nothing
    #[arg(long)]
    pub(crate) dry_run: bool,
    /// Go on in the folder of an old sweep although the sweep has changed
    #[arg(long)]
    pub(crate) accept_changes: bool,
    /// Number of threads; all cores when left out; results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
    /// Write the results to a file
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
}

/// `erode validate`
#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Validations to run
    #[arg(value_name = "NAME", conflicts_with = "all")]
    pub(crate) names: Vec<String>,
    /// Run all of them
    #[arg(long)]
    pub(crate) all: bool,
    /// Low resolution, with the tolerance that belongs to it
    #[arg(long)]
    pub(crate) quick: bool,
    /// Write the results to a file
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Write validation.md and its figures into a folder, such as docs
    #[arg(long, value_name = "DIR")]
    pub(crate) markdown: Option<PathBuf>,
}

/// `erode reproduce`
#[derive(Debug, Args)]
pub(crate) struct ReproduceArgs {
    /// What to reproduce; leave it out to list all
    #[arg(value_name = "ID")]
    pub(crate) ids: Vec<String>,
    /// Folder for the figures
    #[arg(short, long, value_name = "DIR", default_value = "reproduced")]
    pub(crate) output: PathBuf,
    /// Low resolution, for what is made of runs
    #[arg(long)]
    pub(crate) quick: bool,
    /// Resolution of what is made of runs; 20 in the quick form, 60 in the full one
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(4..))]
    pub(crate) particles_per_radius: Option<u32>,
    /// Show the runs and their cost, and run nothing
    #[arg(long)]
    pub(crate) dry_run: bool,
    /// Number of threads; all cores when left out; results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(crate) threads: Option<u16>,
    /// Write the results to a file
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Write reproduction.md and its figures into a folder, such as docs
    #[arg(long, value_name = "DIR")]
    pub(crate) markdown: Option<PathBuf>,
}

/// `erode bench`
#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// Workload to measure; may be given several times
    #[arg(long = "case", value_name = "NAME")]
    pub(crate) cases: Vec<String>,
    /// List the workloads, and nothing else
    #[arg(long)]
    pub(crate) list: bool,
    /// Write the results to a file
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Particles instead of the usual number (per radius in a mixture): for tests
    #[arg(long, value_name = "N", hide = true, value_parser = clap::value_parser!(u32).range(6..))]
    pub(crate) particles: Option<u32>,
}

/// `erode materials`
#[derive(Debug, Args)]
pub(crate) struct MaterialsArgs {
    /// Material to show in full
    pub(crate) name: Option<String>,
    /// Folder with further materials
    #[arg(long, value_name = "DIR")]
    pub(crate) folder: Option<PathBuf>,
}

/// `erode status`
#[derive(Debug, Args)]
pub(crate) struct StatusArgs {
    /// Run folder
    pub(crate) dir: PathBuf,
}
