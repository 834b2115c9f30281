//! The carrier of a contact curve at one orientation in double-double, and where it crosses others.

use crate::number::Dd;
use crate::number::plane::{Xy, cross, dot, left, length, minus, plus, times};

use super::super::carrier::{Carrier, place_on};

/// The carrier of a sheet at one orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCarrier {
    pub(crate) carrier: Carrier<Dd>,
    /// Whether roots with it are named by where it enters.
    pub(super) is_flat_arc: bool,
}

impl ExactCarrier {
    /// Where another carrier crosses it, as [`place_on`] gives it; where they do not, the nearest place to that.
    pub(crate) fn crossed_by(&self, other: &Self, root: u8, swapped: bool) -> Xy<Dd> {
        let root = if swapped {
            other.own_root(self, root)
        } else {
            self.own_root(other, root)
        };
        place_on(&self.carrier, &other.carrier, root, swapped)
    }

    /// Roots with large circles are named by where the first curve enters: the name of that crossing here.
    pub(super) fn own_root(&self, other: &Self, root: u8) -> u8 {
        if self.is_flat_arc || other.is_flat_arc {
            (0..2)
                .find(|&r| self.enters(other, r) == (root == 1))
                .unwrap_or(root)
        } else {
            root
        }
    }

    /// Whether travel along it enters the blocked side of another curve at a crossing; see `crossing.rs`.
    pub(super) fn enters(&self, other: &Self, root: u8) -> bool {
        match (&self.carrier, &other.carrier) {
            (Carrier::Line { normal: m, .. }, Carrier::Line { normal: n, .. }) => {
                dot(*n, left(*m)).is_negative()
            }
            (Carrier::Line { .. }, Carrier::Circle { radius, .. }) => {
                (root == 1) == radius.is_negative()
            }
            (Carrier::Circle { radius, .. }, Carrier::Line { .. }) => {
                (root == 1) != radius.is_negative()
            }
            (Carrier::Circle { radius: r, .. }, Carrier::Circle { radius: s, .. }) => {
                let into_disc = (root == 1) == r.is_negative();
                into_disc != s.is_negative()
            }
            _ => false,
        }
    }

    /// The point of the plane at a place as [`place_on`] gives it.
    pub(crate) fn point(&self, v: Xy<Dd>) -> Xy<Dd> {
        match self.carrier {
            Carrier::Line { normal, through } => plus(through, times(left(normal), v.0)),
            Carrier::Circle { center, .. } => plus(center, v),
            Carrier::FlatArc(arc) => arc.through,
        }
    }

    /// The normal towards the free side at a point of it.
    pub(crate) fn normal(&self, p: Xy<Dd>) -> Xy<Dd> {
        match self.carrier {
            Carrier::Line { normal, .. } => normal,
            Carrier::Circle { center, radius } => times(minus(p, center), Dd::ONE / radius),
            Carrier::FlatArc(arc) => arc.normal,
        }
    }

    /// Whether both lie on one line or circle.
    pub(crate) fn is_one_with(&self, other: &Self) -> bool {
        /// What is nearer than this is one: orientations at which circles become one are known to the square root of the
        /// rounding (length, and sine of an angle).
        const SAME: f64 = 1e-14;
        let is_none = |x: Dd| x.to_f64().abs() < SAME;
        match (&self.carrier, &other.carrier) {
            (
                Carrier::Line { normal: m, through },
                Carrier::Line {
                    normal: n,
                    through: q,
                },
            ) => is_none(cross(*m, *n)) && is_none(dot(*m, minus(*q, *through))),
            (
                Carrier::Circle { center, radius },
                Carrier::Circle {
                    center: c,
                    radius: r,
                },
            ) => is_none(radius.abs() - r.abs()) && is_none(length(minus(*c, *center))),
            _ => false,
        }
    }

    /// Whether two carriers cross.
    pub(super) fn meets(&self, other: &Self) -> bool {
        /// Lines at a smaller angle are parallel (radians).
        const PARALLEL: f64 = 1e-28;
        let line_circle = |n: Xy<Dd>, through: Xy<Dd>, center: Xy<Dd>, radius: Dd| {
            dot(n, minus(center, through)).abs() < radius.abs()
        };
        match (&self.carrier, &other.carrier) {
            (Carrier::Line { normal: m, .. }, Carrier::Line { normal: n, .. }) => {
                cross(*m, *n).to_f64().abs() > PARALLEL
            }
            (&Carrier::Line { normal, through }, &Carrier::Circle { center, radius })
            | (&Carrier::Circle { center, radius }, &Carrier::Line { normal, through }) => {
                line_circle(normal, through, center, radius)
            }
            (
                Carrier::Circle { center: c, radius },
                Carrier::Circle {
                    center: d,
                    radius: r,
                },
            ) => {
                let v = minus(*d, *c);
                let square = dot(v, v);
                let (a, b) = (radius.abs(), r.abs());
                let (sum, difference) = (a + b, a - b);
                square < sum * sum && difference * difference < square
            }
            _ => false,
        }
    }
}
