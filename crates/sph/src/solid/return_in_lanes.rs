//! The radial return of `erode_physics::return_mapping` for eight particles at once: the same equation, bracket and tolerance.
//!
//! f(d) = s_trial - 3 G d - sigma_y(e + d, d/dt, T) = 0
//!
//! Newton's method begins at the plastic increment of the last step where that lies in the bracket: two or three iterations in
//! steady flow. A lane that has converged is left alone, so that no particle's result depends on who stands beside it.

use crate::simd::Simd;
use crate::simd::functions::{exp, ln};
use erode_physics::strength::Strength;

/// Largest |f| accepted, relative to the trial stress, as in the scalar solver.
const TOLERANCE: f64 = 1e-11;
/// Lanes that need more are left to the scalar solver.
const MAX_ITERATIONS: u32 = 40;
/// Plastic strains below count as this one, whose power is as good as zero.
const LEAST_STRAIN: f64 = 1e-300;

/// (A + B e^n) (1 + C ln(max(1, rate/rate0))) times a softening given by the caller (Joshi 2018, eqs 2.27, 6.15): all laws of
/// [`Strength`], whose scalar form stays the reference (see the tests).
#[derive(Debug, Clone, Copy)]
pub(super) struct YieldStress {
    a: f64,
    b: f64,
    n: f64,
    c: f64,
    reference_rate: f64,
}

impl YieldStress {
    /// The constants of a law; none for one that never yields.
    pub(super) fn of(strength: &Strength) -> Option<Self> {
        let constant = |a: f64, b: f64| Self {
            a,
            b,
            n: 1.0,
            c: 0.0,
            reference_rate: 1.0,
        };
        match *strength {
            Strength::Elastic => None,
            Strength::PerfectlyPlastic { yield_stress } => Some(constant(yield_stress, 0.0)),
            Strength::LinearHardening {
                yield_stress,
                hardening_modulus,
            } => Some(constant(yield_stress, hardening_modulus)),
            Strength::JohnsonCook(law) => Some(Self {
                a: law.a,
                b: law.b,
                n: law.n,
                c: law.c,
                reference_rate: law.reference_rate,
            }),
        }
    }

    /// B e^n, Pa.
    #[inline(always)]
    fn hardening<S: Simd>(&self, strain: S) -> S {
        let (b, n) = (S::splat(self.b), S::splat(self.n));
        if self.b == 0.0 {
            b
        } else if self.n == 1.0 {
            b * strain
        } else {
            b * exp(n * ln(strain.max(S::splat(LEAST_STRAIN))))
        }
    }

    /// No yield stress without softening is lower, Pa.
    fn least(&self) -> f64 {
        if self.b >= 0.0 { self.a } else { 0.0 }
    }

    /// Yield stress at no rate, without softening, Pa.
    #[inline(always)]
    fn at_rest<S: Simd>(&self, strain: S) -> S {
        S::splat(self.a) + self.hardening(strain)
    }

    /// Yield stress without softening (Pa), and numerator and denominator of its derivative by an increment of strain within
    /// `dt`.
    #[inline(always)]
    fn with_slope<S: Simd>(&self, strain: S, increment: S, dt: S) -> (S, [S; 2]) {
        let (zero, one) = (S::splat(0.0), S::splat(1.0));
        let hardening = self.hardening(strain);
        let base = S::splat(self.a) + hardening;
        let by_strain = S::splat(self.n) * hardening * increment;
        if self.c == 0.0 {
            return (base, [by_strain, strain * increment]);
        }
        let ratio = increment / (dt * S::splat(self.reference_rate));
        let fast = one.lt(ratio);
        let ratio = S::select(fast, ratio, one);
        let factor = S::splat(self.c).mul_add(ln(ratio), one);
        // n B e^n/e times the factor of the rate, and C (A + B e^n)/(rate dt).
        let by_rate = S::select(fast, S::splat(self.c) * base * strain, zero);
        let slope = by_strain.mul_add(factor, by_rate);
        (base * factor, [slope, strain * increment])
    }
}

/// What the return of eight particles is asked with.
pub(super) struct Trial<S> {
    /// Von Mises norm of the trial stress, Pa.
    pub(super) stress: S,
    pub(super) plastic_strain: S,
    /// Increment in the last step.
    pub(super) last_increment: S,
    /// Softening by heat, 1 when cold.
    pub(super) softening: S,
    pub(super) shear_modulus: S,
    pub(super) dt: S,
}

/// Its answer.
pub(super) struct Returned<S> {
    /// Increment of plastic strain, zero in an elastic step.
    pub(super) increment: S,
    /// Von Mises stress after the step, Pa.
    pub(super) stress: S,
    /// Lanes without a solution, as bits: the scalar solver says why.
    pub(super) unsolved: u8,
}

impl<S: Simd> Trial<S> {
    /// Solves for the plastic increments.
    #[inline(always)]
    pub(super) fn solve(&self, law: Option<&YieldStress>) -> Returned<S> {
        let zero = S::splat(0.0);
        let elastic = Returned {
            increment: zero,
            stress: self.stress,
            unsolved: !self.usable(),
        };
        let Some(law) = law else { return elastic };
        let least = S::splat(law.least()) * self.softening;
        if S::bits(least.lt(self.stress)) & !elastic.unsolved == 0 {
            return elastic;
        }
        let start = law.at_rest(self.plastic_strain) * self.softening;
        let yields = start.lt(self.stress);
        let plastic = S::bits(yields) & !elastic.unsolved;
        if plastic == 0 {
            return elastic;
        }
        let (increment, stress, solved) = self.iterate(law, start, plastic);
        Returned {
            increment: S::select(yields, increment, zero),
            stress: S::select(yields, stress, self.stress),
            unsolved: elastic.unsolved | (plastic & !solved),
        }
    }

    /// Lanes whose numbers are in the range of the equation, as bits; the others are the scalar solver's to refuse.
    #[inline(always)]
    fn usable(&self) -> u8 {
        let (zero, most) = (S::splat(0.0), S::splat(f64::MAX));
        S::bits(self.stress.lt(most))
            & S::bits(self.plastic_strain.lt(most))
            & !S::bits(self.plastic_strain.lt(zero))
            & S::bits(zero.lt(self.shear_modulus))
            & S::bits(zero.lt(self.dt))
    }

    /// Newton's method inside a shrinking bracket, bisection where Newton leaves it: increment, yield stress, and the lanes that
    /// converged as bits.
    #[inline(always)]
    fn iterate(&self, law: &YieldStress, start: S, wanted: u8) -> (S, S, u8) {
        let (zero, half) = (S::splat(0.0), S::splat(0.5));
        let three_g = S::splat(3.0) * self.shear_modulus;
        let tolerance = S::splat(TOLERANCE) * self.stress;
        let (mut low, mut high) = (zero, (self.stress - start) / three_g);
        let guess = self.last_increment;
        let mut d = S::select(guess.lt(high), guess, half * high);
        d = S::select(zero.lt(d), d, half * high);
        let (mut stress, mut solved) = (zero, 0);
        for _ in 0..MAX_ITERATIONS {
            let (sigma, slope) = law.with_slope(self.plastic_strain + d, d, self.dt);
            stress = sigma * self.softening;
            let f = self.stress - three_g.mul_add(d, stress);
            let done = f.abs().lt(tolerance);
            solved = S::bits(done);
            if solved & wanted == wanted {
                break;
            }
            let below = zero.lt(f);
            low = S::select(below, d, low);
            high = S::select(below, high, d);
            let [slope, per] = slope;
            let newton = d + f * per / slope.mul_add(self.softening, three_g * per);
            let next = S::select(low.lt(newton), newton.min(high), half * (low + high));
            d = S::select(done, d, next);
        }
        (d, stress, solved)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::{self, LANES, Task};
    use erode_physics::return_mapping::radial_return;
    use erode_physics::strength::{JohnsonCook, Thermal};

    const DT: f64 = 1e-9;
    const SHEAR: f64 = 80e9;
    const HEAT: Thermal = Thermal {
        m: 1.03,
        reference_temperature: 293.0,
        melting_temperature: 1800.0,
        heat_capacity: 480.0,
        taylor_quinney: 0.9,
    };

    struct Ask<'a> {
        law: &'a Strength,
        /// Trial stress, plastic strain, last increment, temperature.
        lanes: [[f64; LANES]; 4],
    }

    impl Task for Ask<'_> {
        type Output = ([[f64; LANES]; 2], u8);

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let factor = |t: f64| self.law.thermal().map_or(1.0, |l| l.factor(t));
            let mut softening = self.lanes[3];
            softening.iter_mut().for_each(|t| *t = factor(*t));
            let found = Trial {
                stress: S::load(&self.lanes[0]),
                plastic_strain: S::load(&self.lanes[1]),
                last_increment: S::load(&self.lanes[2]),
                softening: S::load(&softening),
                shear_modulus: S::splat(SHEAR),
                dt: S::splat(DT),
            }
            .solve(YieldStress::of(self.law).as_ref());
            (
                [found.increment.store(), found.stress.store()],
                found.unsolved,
            )
        }
    }

    fn laws() -> [Strength; 5] {
        let cook = JohnsonCook {
            a: 508e6,
            b: 832e6,
            n: 0.29,
            c: 0.031,
            reference_rate: 4e-4,
            thermal: None,
        };
        [
            Strength::Elastic,
            Strength::PerfectlyPlastic { yield_stress: 5e8 },
            Strength::LinearHardening {
                yield_stress: 5e8,
                hardening_modulus: 2e9,
            },
            Strength::JohnsonCook(cook),
            Strength::JohnsonCook(JohnsonCook {
                thermal: Some(HEAT),
                ..cook
            }),
        ]
    }

    #[test]
    fn lanes_return_to_the_same_place_as_the_scalar_solver() {
        let trial = [1e7, 5.1e8, 9e8, 1.5e9, 3e9, 2e10, 7e8, 1.2e9];
        let strain = [0.0, 0.0, 1e-9, 1e-3, 0.02, 0.3, 1.5, 0.0];
        for law in &laws() {
            for guess in [0.0, 1e-6, 1e-3, 1.0] {
                for temperature in [293.0, 700.0, 2000.0] {
                    let lanes = [trial, strain, [guess; 8], [temperature; 8]];
                    let ([increment, stress], unsolved) = simd::run(Ask { law, lanes });
                    assert_eq!(unsolved, 0, "{law:?}");
                    for l in 0..LANES {
                        let one = radial_return(trial[l], strain[l], DT, temperature, SHEAR, law)
                            .unwrap();
                        // Both stop where |f| < 1e-11 of the trial stress.
                        assert!(
                            (increment[l] - one.increment).abs() * 3.0 * SHEAR < 3e-11 * trial[l]
                        );
                        assert!((stress[l] - one.yield_stress).abs() < 3e-11 * trial[l]);
                        assert_eq!(increment[l] == 0.0, one.increment == 0.0);
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_number_is_left_to_the_scalar_solver() {
        let mut lanes = [[1e9; 8], [0.0; 8], [0.0; 8], [293.0; 8]];
        lanes[0][3] = f64::NAN;
        lanes[0][5] = f64::INFINITY;
        lanes[1][6] = -1e-3;
        let (_, unsolved) = simd::run(Ask {
            law: &laws()[3],
            lanes,
        });
        assert_eq!(unsolved, 0b0110_1000);
    }
}
