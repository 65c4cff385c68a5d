//! Radial return to the yield surface of von Mises, with the strain rate inside the equation.
//!
//! f(d) = s_trial - 3 G d - sigma_y(e + d, d/dt, T) = 0,  d in [0, (s_trial - sigma_y(e, 0, T))/(3G)]
//! (Joshi 2018, eq. B.3; the rate is d/dt of this very step. Its eq. B.4, a rate from the last step, is wrong:
//! plastic and elastic steps would alternate.)
//!
//! Units: Pa, s, K; d is the increment of the equivalent plastic strain. Range: laws that do not soften with plastic
//! strain or with rate, for which f falls and the bracket holds the one root; anything else is an error, never a clip.

use crate::strength::Strength;
use crate::tensor::Sym3;
use thiserror::Error;

/// Largest |f| accepted, relative to the trial stress: far above round-off, far below any use of the result.
const TOLERANCE: f64 = 1e-11;
/// Plain bisection alone would need about 60 steps from the widest bracket to the smallest root in use.
const MAX_ITERATIONS: u32 = 200;

/// Why no plastic increment was found.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum ReturnError {
    /// The arguments are outside the range of the equation.
    #[error(
        "radial return was asked at trial stress {trial} Pa, plastic strain {plastic_strain}, time step {dt} s, \
         shear modulus {shear_modulus} Pa; all must be finite, the strain not negative, the others positive \
         (a state that is not finite usually means that the time step was too large)"
    )]
    BadInput {
        /// Von Mises norm of the trial stress, Pa.
        trial: f64,
        /// Plastic strain before the step.
        plastic_strain: f64,
        /// Time step, s.
        dt: f64,
        /// Shear modulus, Pa.
        shear_modulus: f64,
    },
    /// No root was found.
    #[error(
        "radial return found no plastic increment at trial stress {trial} Pa, plastic strain {plastic_strain}: \
         residual {residual} Pa after {iterations} iterations (does the yield stress fall with plastic strain?)"
    )]
    NotConverged {
        /// Von Mises norm of the trial stress, Pa.
        trial: f64,
        /// Plastic strain before the step.
        plastic_strain: f64,
        /// f(d) at the last iterate, Pa.
        residual: f64,
        /// Iterations made.
        iterations: u32,
    },
}

/// Solution of the scalar equation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Return {
    /// Increment of plastic strain d, zero in an elastic step.
    pub increment: f64,
    /// Von Mises stress after the step, Pa: the yield stress, or the trial stress in an elastic step.
    pub yield_stress: f64,
    /// Iterations used.
    pub iterations: u32,
}

/// Solves for the plastic increment of one step; `trial` is the von Mises norm of the trial stress (Pa).
///
/// # Errors
/// If an argument is out of range or the equation has no root in its bracket.
pub fn radial_return(
    trial: f64,
    plastic_strain: f64,
    dt: f64,
    temperature: f64,
    shear_modulus: f64,
    strength: &Strength,
) -> Result<Return, ReturnError> {
    let usable = trial.is_finite()
        && (0.0..f64::INFINITY).contains(&plastic_strain)
        && dt > 0.0
        && (0.0..f64::INFINITY).contains(&shear_modulus)
        && shear_modulus > 0.0;
    if !usable {
        return Err(ReturnError::BadInput {
            trial,
            plastic_strain,
            dt,
            shear_modulus,
        });
    }
    let start = strength.yield_stress(plastic_strain, 0.0, temperature);
    if trial <= start {
        return Ok(Return {
            increment: 0.0,
            yield_stress: trial,
            iterations: 0,
        });
    }
    let equation = Equation {
        trial,
        plastic_strain,
        dt,
        temperature,
        three_g: 3.0 * shear_modulus,
        strength,
    };
    equation.solve((trial - start) / (3.0 * shear_modulus))
}

struct Equation<'a> {
    trial: f64,
    plastic_strain: f64,
    dt: f64,
    temperature: f64,
    three_g: f64,
    strength: &'a Strength,
}

impl Equation<'_> {
    fn residual(&self, d: f64) -> f64 {
        self.trial - self.three_g * d - self.yield_stress(d)
    }

    fn yield_stress(&self, d: f64) -> f64 {
        self.strength
            .yield_stress(self.plastic_strain + d, d / self.dt, self.temperature)
    }

    fn slope(&self, d: f64) -> f64 {
        let (by_strain, by_rate) =
            self.strength
                .yield_slopes(self.plastic_strain + d, d / self.dt, self.temperature);
        -self.three_g - by_strain - by_rate / self.dt
    }

    /// Newton's method inside a shrinking bracket, bisection where Newton leaves it.
    fn solve(&self, widest: f64) -> Result<Return, ReturnError> {
        let (mut low, mut high) = (0.0, widest);
        // One linearised step; where the slope is infinite (first yield) half of the bracket.
        let mut d = -widest * self.three_g / self.slope(0.0);
        if !(d > low && d <= high) {
            d = 0.5 * widest;
        }
        let mut f = f64::NAN;
        for iterations in 1..=MAX_ITERATIONS {
            f = self.residual(d);
            if f.abs() <= TOLERANCE * self.trial {
                return Ok(Return {
                    increment: d,
                    yield_stress: self.yield_stress(d),
                    iterations,
                });
            }
            if f > 0.0 {
                low = d;
            } else {
                high = d;
            }
            let newton = d - f / self.slope(d);
            d = if newton > low && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
        }
        Err(ReturnError::NotConverged {
            trial: self.trial,
            plastic_strain: self.plastic_strain,
            residual: f,
            iterations: MAX_ITERATIONS,
        })
    }
}

/// State of a material point that the return reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// Equivalent plastic strain before the step.
    pub plastic_strain: f64,
    /// Temperature before the step, K.
    pub temperature: f64,
    /// Density, kg/m3.
    pub density: f64,
}

/// What one step did to a material point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plastic {
    /// Stress on or inside the yield surface, Pa.
    pub stress: Sym3,
    /// Increment of plastic strain.
    pub increment: f64,
    /// Increment of plastic work per current volume sigma_y d, J/m3.
    pub work: f64,
    /// Temperature rise by the Taylor-Quinney share of the work, K (zero for laws without temperature).
    pub heating: f64,
    /// Iterations of the scalar solve.
    pub iterations: u32,
}

/// Brings a trial stress back to the yield surface: the deviator is scaled, the pressure kept.
///
/// # Errors
/// As [`radial_return`].
pub fn return_stress(
    trial: Sym3,
    point: PointState,
    dt: f64,
    shear_modulus: f64,
    strength: &Strength,
) -> Result<Plastic, ReturnError> {
    let von_mises = trial.von_mises();
    let back = radial_return(
        von_mises,
        point.plastic_strain,
        dt,
        point.temperature,
        shear_modulus,
        strength,
    )?;
    if back.increment == 0.0 {
        return Ok(Plastic {
            stress: trial,
            increment: 0.0,
            work: 0.0,
            heating: 0.0,
            iterations: back.iterations,
        });
    }
    let scale = back.yield_stress / von_mises;
    let work = back.yield_stress * back.increment;
    Ok(Plastic {
        stress: Sym3::isotropic(trial.mean()) + trial.deviator() * scale,
        increment: back.increment,
        work,
        heating: strength
            .thermal()
            .map_or(0.0, |t| t.heating(work, point.density)),
        iterations: back.iterations,
    })
}

#[cfg(test)]
mod tests;
