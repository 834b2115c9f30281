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
    /// An arc with a radius of more than [`FLAT`] times the size.
    FlatArc,
    /// Beside a tangency a critical orientation is known to 1e-6 rad only: an answer nearer to contact than
    /// [`BESIDE_TANGENCY`] times the size.
    BesideTangency,
}

/// Radii from which on places on an arc lose the digits that decisions need, in sizes.
const FLAT: f64 = 1e4;

/// How near to contact answers may be wrong beside a tangency, as a share of the size.
const BESIDE_TANGENCY: f64 = 1e-6;

/// Why a pair is not asked at all, if it is one of those.
pub(crate) fn pair(case: &Case) -> Option<Known> {
    let size = case.fixed.size().max(case.moving.size());
    let edges = case.fixed.edges().chain(case.moving.edges());
    edges
        .filter(|e| !e.is_line())
        .any(|e| e.radius() > FLAT * size)
        .then_some(Known::FlatArc)
}

/// Why a pair of a family is not asked.
pub(crate) fn member(family: &str, value: f64) -> Option<Known> {
    known(family, value).map(Known::Family)
}

/// Why a fault is no finding.
pub(crate) fn fault(case: &Case, fault: &Fault) -> Option<Known> {
    let near = BESIDE_TANGENCY * Oracle::new(&case.fixed, &case.moving).size();
    match fault {
        Fault::Wrong { verdict, .. } | Fault::Inverse { verdict, .. } if verdict.margin < near => {
            Some(Known::BesideTangency)
        }
        _ => None,
    }
}
