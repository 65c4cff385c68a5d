//! Small tensors of continuum mechanics.
//!
//! Index order is (r, z, theta) in axisymmetry, (x, y, z) otherwise: the first two directions span the plane of
//! motion, the third is the hoop (axisymmetric) or out-of-plane (plane strain) direction.

use serde::{Deserialize, Serialize};
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// Symmetric 3x3 tensor, six components.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sym3 {
    /// Component 11 (rr or xx).
    pub xx: f64,
    /// Component 22 (zz in axisymmetry, or yy).
    pub yy: f64,
    /// Component 33 (hoop, or out of plane).
    pub zz: f64,
    /// Component 12.
    pub xy: f64,
    /// Component 13.
    pub xz: f64,
    /// Component 23.
    pub yz: f64,
}

impl Sym3 {
    /// The zero tensor.
    pub const ZERO: Self = Self::isotropic(0.0);
    /// The unit tensor.
    pub const IDENTITY: Self = Self::isotropic(1.0);

    /// `value` times the unit tensor.
    #[must_use]
    pub const fn isotropic(value: f64) -> Self {
        Self {
            xx: value,
            yy: value,
            zz: value,
            xy: 0.0,
            xz: 0.0,
            yz: 0.0,
        }
    }

    /// Sum of the diagonal.
    #[must_use]
    pub fn trace(self) -> f64 {
        self.xx + self.yy + self.zz
    }

    /// Mean of the diagonal: minus the pressure, when this is a stress.
    #[must_use]
    pub fn mean(self) -> f64 {
        self.trace() / 3.0
    }

    /// The part without trace.
    #[must_use]
    pub fn deviator(self) -> Self {
        self - Self::isotropic(self.mean())
    }

    /// Double contraction A:B, the sum over all nine products of components.
    #[must_use]
    pub fn double_dot(self, other: Self) -> f64 {
        self.xx * other.xx
            + self.yy * other.yy
            + self.zz * other.zz
            + 2.0 * (self.xy * other.xy + self.xz * other.xz + self.yz * other.yz)
    }

    /// Von Mises norm sqrt(3/2 s:s) of the deviator s (Joshi 2018, eq. B.1 with its missing 1/sqrt(2)).
    #[must_use]
    pub fn von_mises(self) -> f64 {
        let s = self.deviator();
        (1.5 * s.double_dot(s)).sqrt()
    }

    /// Spin part W A - A W of the Jaumann rate, for a spin in the plane of motion with
    /// `spin` = W_12 = (dv_1/dx_2 - dv_2/dx_1)/2 (1/s).
    #[must_use]
    pub fn spin_rate(self, spin: f64) -> Self {
        Self {
            xx: 2.0 * spin * self.xy,
            yy: -2.0 * spin * self.xy,
            zz: 0.0,
            xy: spin * (self.yy - self.xx),
            xz: spin * self.yz,
            yz: -spin * self.xz,
        }
    }

    /// Q A Q^T for the rotation Q that a spin increment `spin` = W_12 dt makes by the midpoint rule of Hughes and
    /// Winget (1980), Q = (I - W dt/2)^-1 (I + W dt/2). Exactly orthogonal, so the invariants are kept to round-off.
    #[must_use]
    pub fn rotated_by_spin(self, spin: f64) -> Self {
        let half = 0.5 * spin;
        let scale = 1.0 / (1.0 + half * half);
        let (c, s) = ((1.0 - half * half) * scale, 2.0 * half * scale);
        let (cc, ss, cs) = (c * c, s * s, c * s);
        Self {
            xx: cc * self.xx + ss * self.yy + 2.0 * cs * self.xy,
            yy: ss * self.xx + cc * self.yy - 2.0 * cs * self.xy,
            zz: self.zz,
            xy: cs * (self.yy - self.xx) + (cc - ss) * self.xy,
            xz: c * self.xz + s * self.yz,
            yz: c * self.yz - s * self.xz,
        }
    }
}

impl Add for Sym3 {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self {
            xx: self.xx + o.xx,
            yy: self.yy + o.yy,
            zz: self.zz + o.zz,
            xy: self.xy + o.xy,
            xz: self.xz + o.xz,
            yz: self.yz + o.yz,
        }
    }
}

impl AddAssign for Sym3 {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Mul<f64> for Sym3 {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        Self {
            xx: self.xx * k,
            yy: self.yy * k,
            zz: self.zz * k,
            xy: self.xy * k,
            xz: self.xz * k,
            yz: self.yz * k,
        }
    }
}

impl Neg for Sym3 {
    type Output = Self;
    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Sub for Sym3 {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Sym3 = Sym3 {
        xx: 3.0,
        yy: -1.5,
        zz: 0.7,
        xy: 2.2,
        xz: -0.4,
        yz: 1.1,
    };

    #[test]
    fn deviator_has_no_trace_and_pressure_no_von_mises() {
        assert!(A.deviator().trace().abs() < 1e-15);
        assert!((A.deviator() + Sym3::isotropic(A.mean()) - A).von_mises() < 1e-15);
        assert!(Sym3::isotropic(-5e9).von_mises() < 1e-6);
    }

    #[test]
    fn von_mises_of_known_states() {
        let uniaxial = Sym3 {
            xx: -7.0,
            ..Sym3::ZERO
        };
        let shear = Sym3 {
            yz: 2.0,
            ..Sym3::ZERO
        };
        assert!((uniaxial.von_mises() - 7.0).abs() < 1e-14);
        assert!((shear.von_mises() - 2.0 * 3.0_f64.sqrt()).abs() < 1e-14);
    }

    #[test]
    fn rotation_keeps_invariants_and_turns_uniaxial_stress() {
        for spin in [-3.0, -0.1, 1e-6, 0.5, 2.0] {
            let b = A.rotated_by_spin(spin);
            assert!((b.von_mises() - A.von_mises()).abs() < 1e-14);
            assert!((b.trace() - A.trace()).abs() < 1e-14);
        }
        // A quarter turn, 2 atan(1): rr becomes zz.
        let b = Sym3 {
            xx: 1.0,
            ..Sym3::ZERO
        }
        .rotated_by_spin(2.0);
        assert!((b.yy - 1.0).abs() < 1e-15 && b.xx.abs() < 1e-15 && b.xy.abs() < 1e-15);
    }

    #[test]
    fn spin_rate_is_the_derivative_of_the_rotation_and_does_no_work() {
        let (w, dt) = (0.8, 1e-6);
        let difference = (A.rotated_by_spin(w * dt) - A.rotated_by_spin(-w * dt)) * (0.5 / dt);
        let gap = difference - A.spin_rate(w);
        assert!(gap.double_dot(gap).sqrt() < 1e-8);
        assert!(A.spin_rate(w).double_dot(A).abs() < 1e-14);
        assert!(A.spin_rate(w).trace().abs() < 1e-15);
    }
}
