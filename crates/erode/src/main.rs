//! The command line of Erode.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
