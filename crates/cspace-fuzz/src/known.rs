//! What is known to be wrong, and is not told as a finding again.
//!
//! Each sort is described in the README under *Known limits*; `tests/regression` has an example. When one is mended, its
//! entry here goes.

use cspace_load::{Fault, known};
use cspace_oracle::{Case, Oracle};

/// A sort of pairs or answers that are known to be wrong at times.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// A pair of a family at a value from which on it goes wrong: the list of `cspace-load`.
    Family(&'static str),
    /// Beside a tangency a critical orientation is known to 1e-6 rad only: a slice may be wrong nearer to contact than
    /// 1e-6 times the size. Configurations are classified rightly all the same.
    BesideTangency,
    /// The space says itself that it has a conflict, two touches nearly at one orientation that it cannot tell apart: its
    /// cells are decided one by one, and the loops of its slices may be open between the two.
    Conflict,
    /// A slice from scratch that is open within 1e-6 rad of an orientation at which it is closed: curves of second order
    /// contact, as of a part in a hole of its own shape.
    SliceAtATie,
    /// An event beside a tangency of curves of which one hardly turns: it is told with 1e-6 rad, the largest error, and would need more.
    CappedError,
}

/// How near to contact answers may be wrong beside a tangency, as a share of the size.
const BESIDE_TANGENCY: f64 = 1e-6;

/// How near (radians) to an orientation at which it is closed a slice from scratch may be open.
pub(crate) const AT_A_TIE: f64 = 1e-6;

/// The largest error with which an event is told, radians.
const LARGEST_ERROR: f64 = 1e-6;

/// The error of a coefficient of an event, in units of the lengths it is made of: 8 roundings of four times their sum.
const COEFFICIENT_ERROR: f64 = 32.0 * f64::EPSILON;

/// A function of an amplitude below this, in units of the lengths it is made of, hardly turns.
const HARDLY: f64 = 1e-2;

/// Why a pair of a family is not asked.
pub(crate) fn member(family: &str, value: f64) -> Option<Known> {
    known(family, value).map(Known::Family)
}

/// Why a root need not be told: by its function's amplitude, its slope there, and the lengths of which it is made.
///
/// An error e of the coefficients moves a root by e over the slope, and by √(2 e / amplitude) at most.
pub(crate) fn root(amplitude: f64, slope: f64, lengths: f64) -> Option<Known> {
    let e = COEFFICIENT_ERROR * lengths;
    let error = (e / slope).min((2.0 * e / amplitude).sqrt());
    let hardly_turns = amplitude < HARDLY * lengths;
    (hardly_turns && error > 0.5 * LARGEST_ERROR).then_some(Known::CappedError)
}

/// Why a fault is no finding, of a space with so many conflicts.
pub(crate) fn fault(case: &Case, fault: &Fault, conflicts: u64) -> Option<Known> {
    let near = BESIDE_TANGENCY * Oracle::new(&case.fixed, &case.moving).size();
    match fault {
        Fault::Slice { verdict, .. } if verdict.margin < near => Some(Known::BesideTangency),
        Fault::Open { .. } | Fault::Loops { .. } if conflicts > 0 => Some(Known::Conflict),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cspace_oracle::families;

    /// Only what is named is left out: most members of the families are asked.
    #[test]
    fn few_pairs_are_left_out() {
        let (mut all, mut left_out) = (0, 0);
        for family in families() {
            for &value in &family.values {
                if family.build(value).is_err() {
                    continue;
                }
                all += 1;
                left_out += u32::from(member(family.name, value).is_some());
            }
        }
        assert!(4 * left_out < all, "{left_out} of {all}");
        assert!(left_out > 0);
    }

    #[test]
    fn an_event_needs_a_large_error_only_where_little_turns() {
        assert_eq!(root(1.0, 0.0, 1.0), None);
        assert_eq!(root(1e-12, 1e-13, 1.0), Some(Known::CappedError));
    }
}
