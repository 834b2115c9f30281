//! Where two lines or circles meet near a known place.

use cspace::{Real, Vector};

/// A line or circle about a place: its points x, as seen from there, have
///
/// ```text
/// n·x = f + k |x|².
/// ```
#[derive(Debug, Clone, Copy)]
pub(crate) struct Level<T> {
    /// The normal n.
    pub(crate) normal: Vector<T>,
    /// The number f: how far the place is off.
    pub(crate) off: T,
    /// The number k.
    pub(crate) bend: T,
}

/// The point at which two of them meet that is nearest to the place; `None` if they do not meet there. The normals may not be parallel.
///
/// The two equations are linear in x and q = |x|², so that x = a + b q, and q is the root of |a + b q|² = q that is 0 where both are off by
/// nothing.
pub(crate) fn meeting<T: Real>(first: Level<T>, second: Level<T>) -> Option<Vector<T>> {
    let (n, m) = (first.normal, second.normal);
    let part = T::constant(1.0) / n.cross(m);
    let solve = |f: T, g: T| Vector::new(f * m.y - g * n.y, g * n.x - f * m.x) * part;
    let a = solve(first.off, second.off);
    let b = solve(first.bend, second.bend);
    let linear = T::constant(1.0) - a.dot(b) * T::constant(2.0);
    let constant = a.length_squared();
    let inner = linear * linear - constant * b.length_squared() * T::constant(4.0);
    if inner.value() <= 0.0 || linear.value() <= 0.0 {
        return None;
    }
    let q = constant * T::constant(2.0) / (linear + inner.sqrt());
    Some(a + b * q)
}
