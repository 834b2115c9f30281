//! Joints that turn by less and less.

use core::f64::consts::PI;

use super::outline::*;
use super::{Case, Family, family, powers};
use crate::shapes::bulge_of;

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(family("side broken outwards, turn", powers(-1, -16), |t| {
        Ok(Case::new(broken(t), rectangle(0.8, 0.5))?.about(&[(0.0, 1.25, 0.0)]))
    }));
    all.push(family("side broken inwards, turn", powers(-1, -16), |t| {
        Ok(Case::new(broken(-t), rectangle(0.8, 0.5))?.about(&[(0.0, 1.25, 0.0)]))
    }));
    all.push(family(
        "broken sides on each other, turn",
        powers(-1, -16),
        |t| Ok(Case::new(broken(t), broken(-t))?.about(&[(0.0, 2.0, PI)])),
    ));
    all.push(family(
        "arc all but tangent to lines, turn",
        powers(-1, -16),
        |t| Ok(Case::new(stadium(PI - t), plate(6.0, stadium(PI)))?.about(&[(0.0, 0.0, 0.0)])),
    ));
    all.push(family(
        "arc bulging past its lines, turn",
        powers(-1, -16),
        |t| Ok(Case::new(stadium(PI + t), rectangle(1.0, 1.0))?.about(&[(0.0, 1.5, 0.0)])),
    ));
}

/// A square of side 2 whose upper side has a corner in the middle, at which it turns by `t`.
fn broken(t: f64) -> Loops {
    let rise = (0.5 * t).tan();
    vec![vec![
        line(-1.0, -1.0),
        line(1.0, -1.0),
        line(1.0, 1.0),
        line(0.0, 1.0 + rise),
        line(-1.0, 1.0),
    ]]
}

/// Two parallel lines and two arcs of that sweep: a stadium at π.
fn stadium(sweep: f64) -> Loops {
    let b = bulge_of(sweep);
    vec![vec![
        line(-1.0, -1.0),
        arc(1.0, -1.0, b),
        line(1.0, 1.0),
        arc(-1.0, 1.0, b),
    ]]
}
