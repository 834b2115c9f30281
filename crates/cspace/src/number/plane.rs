//! Points and vectors of the plane as pairs of any kind of number.

use super::{Dd, Real};

/// Coordinates.
pub(crate) type Xy<T> = (T, T);

#[inline(always)]
pub(crate) fn plus<T: Real>(a: Xy<T>, b: Xy<T>) -> Xy<T> {
    (a.0 + b.0, a.1 + b.1)
}

#[inline(always)]
pub(crate) fn minus<T: Real>(a: Xy<T>, b: Xy<T>) -> Xy<T> {
    (a.0 - b.0, a.1 - b.1)
}

#[inline(always)]
pub(crate) fn times<T: Real>(a: Xy<T>, by: T) -> Xy<T> {
    (a.0 * by, a.1 * by)
}

#[inline(always)]
pub(crate) fn negative<T: Real>(a: Xy<T>) -> Xy<T> {
    (-a.0, -a.1)
}

#[inline(always)]
pub(crate) fn dot<T: Real>(a: Xy<T>, b: Xy<T>) -> T {
    a.0 * b.0 + a.1 * b.1
}

#[inline(always)]
pub(crate) fn cross<T: Real>(a: Xy<T>, b: Xy<T>) -> T {
    a.0 * b.1 - a.1 * b.0
}

/// A quarter turn counter-clockwise.
#[inline(always)]
pub(crate) fn left<T: Real>(a: Xy<T>) -> Xy<T> {
    (-a.1, a.0)
}

/// A quarter turn clockwise.
#[inline(always)]
pub(crate) fn right<T: Real>(a: Xy<T>) -> Xy<T> {
    (a.1, -a.0)
}

#[inline(always)]
pub(crate) fn length<T: Real>(a: Xy<T>) -> T {
    dot(a, a).sqrt()
}

/// Turned by the angle with the given cosine and sine.
#[inline(always)]
pub(crate) fn turned<T: Real>(a: Xy<T>, cos: T, sin: T) -> Xy<T> {
    (cos * a.0 - sin * a.1, sin * a.0 + cos * a.1)
}

/// The nearest doubles.
pub(crate) fn rounded(a: Xy<Dd>) -> (f64, f64) {
    (a.0.to_f64(), a.1.to_f64())
}

/// Doubles as they are.
pub(crate) fn exactly(a: (f64, f64)) -> Xy<Dd> {
    (Dd::from(a.0), Dd::from(a.1))
}
