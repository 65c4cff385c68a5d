//! Vectors in space.

/// Three components.
pub(crate) type Vector = [f64; 3];

/// a + b.
pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a - b.
pub(crate) fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// s a.
pub(crate) fn scale(s: f64, a: Vector) -> Vector {
    [s * a[0], s * a[1], s * a[2]]
}

/// a + s b.
pub(crate) fn along(a: Vector, s: f64, b: Vector) -> Vector {
    add(a, scale(s, b))
}

/// a . b.
pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Length.
pub(crate) fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// a x b.
pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// (1 - x) a + x b.
pub(crate) fn mix(a: Vector, b: Vector, x: f64) -> Vector {
    add(scale(1.0 - x, a), scale(x, b))
}

/// Whether all components are finite.
pub(crate) fn finite(a: Vector) -> bool {
    a.iter().all(|x| x.is_finite())
}
