//! What the environment asks for.

use super::failure::{Failure, Outcome};
use erode_sph::simd::Width;
use std::ffi::OsStr;

/// The variable that chooses the vector instructions.
const SIMD: &str = "ERODE_SIMD";

/// Refuses a name of instructions that there is not; says when this processor lacks those that are asked for.
pub(crate) fn check() -> Outcome {
    let Some(asked) = std::env::var_os(SIMD) else {
        return Ok(());
    };
    let width = named(&asked)?;
    if !width.is_available() {
        eprintln!(
            "warning: {SIMD} asks for {}, which this processor does not have; the widest that it has are used",
            width.name()
        );
    }
    Ok(())
}

fn named(asked: &OsStr) -> Result<Width, Failure> {
    let known = Width::ALL.into_iter().find(|w| asked == w.name());
    known.ok_or_else(|| {
        let names = Width::ALL.map(Width::name).join(", ");
        Failure::input(
            format!(
                "{SIMD} is `{}`, which names no instructions",
                asked.display()
            ),
            format!("it may be one of {names}, or absent: the widest that the processor has"),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_names_are_taken_and_others_refused() {
        assert_eq!(named(OsStr::new("scalar")).unwrap().name(), "scalar");
        for wrong in ["", "AVX2", "sse"] {
            assert!(named(OsStr::new(wrong)).is_err(), "{wrong}");
        }
    }
}
