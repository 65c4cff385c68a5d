//! Whether a load lies on the body and is resolved by its particles.

use super::{Side, Solid, SolidError};
use std::fmt;

/// Particles across a load from which on strains beneath it are right to a few percent (ten per half width of a Gaussian).
const ENOUGH: usize = 20;

/// How many particles of the first row a load covers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LoadResolution {
    /// The loaded face.
    pub side: Side,
    /// Particles across the whole width; those beyond an axis or a symmetry face count too.
    pub particles: usize,
}

impl LoadResolution {
    /// Whether there are enough for strains that are right to a few percent.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.particles >= ENOUGH
    }
}

impl fmt::Display for LoadResolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the load on the {:?} face has {} particles across its width",
            self.side, self.particles
        )?;
        if self.is_enough() {
            Ok(())
        } else {
            write!(
                f,
                "; plastic strain beneath it is off by more than 5 % with fewer than {ENOUGH}: use a smaller spacing"
            )
        }
    }
}

impl Solid {
    /// Particles across a load of half width `half_width` (m) around the coordinate `centre` (m) along a face.
    ///
    /// # Errors
    /// If the load has no width, its centre lies beside the face, or the face has no points where a load could act.
    pub fn load_resolution(
        &self,
        side: Side,
        centre: f64,
        half_width: f64,
    ) -> Result<LoadResolution, SolidError> {
        let along = 1 - side.normal_axis();
        let (first, last) = (self.block.lower[along], self.block.upper[along]);
        if !half_width.is_finite() || half_width <= 0.0 || !(first..=last).contains(&centre) {
            return Err(SolidError::LoadOutside {
                side,
                centre,
                half_width,
                face: [first, last],
            });
        }
        let surface = self.surface(side).ok_or(SolidError::NotLoadable {
            side,
            face: self.block.face(side),
        })?;
        let ends = if along == 0 {
            [Side::Left, Side::Right]
        } else {
            [Side::Bottom, Side::Top]
        };
        let inside = |x: f64| (x - centre).abs() < half_width;
        let mirrored = ends.map(|s| (self.block.face(s).mirrors(), self.block.coordinate(s)));
        let count = |x: f64| {
            let images = mirrored.iter().filter(|(m, at)| *m && inside(2.0 * at - x));
            usize::from(inside(x)) + images.count()
        };
        Ok(LoadResolution {
            side,
            particles: (surface.reference_position.iter())
                .map(|x| count(x[along]))
                .sum(),
        })
    }
}
