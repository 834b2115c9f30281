//! A sheet in double-double: its curve and carrier at any orientation, and the events at which crossings come and go.

use crate::feature::Outline;
use crate::geometry::Vector;
use crate::number::Dd;
use crate::number::plane::{Xy, exactly, length, minus, negative, plus, rounded, turned};

use super::super::carrier::Carrier;
use super::super::shared::SharedEnds;
use super::super::sheet::{Sheet, SheetKind};
use super::carrier::ExactCarrier;
use super::condition::{Condition, Rough, apart, height};
use super::curve::{Chart, ExactCrossing, ExactCurve};
use super::spiral::{ExactSpiral, ExactTurn, end};

#[derive(Debug, Clone, Copy)]
enum Locus {
    Line {
        normal: Xy<Dd>,
        turns: bool,
        through: ExactSpiral,
    },
    Circle {
        center: ExactSpiral,
        radius: Dd,
    },
}

/// A sheet in double-double.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactSheet<'a> {
    fixed: &'a Outline,
    moving: &'a Outline,
    rough: &'a Sheet,
    locus: Locus,
}

impl<'a> ExactSheet<'a> {
    /// The sheet of two outlines in double-double.
    pub(crate) fn new(fixed: &'a Outline, moving: &'a Outline, sheet: &'a Sheet) -> Self {
        let (f, m) = (sheet.fixed as usize, sheet.moving as usize);
        let line = |normal, turns| Locus::Line {
            normal,
            turns,
            through: end(fixed, moving, sheet, sheet.start_at),
        };
        let locus = match sheet.kind {
            SheetKind::LineRound => {
                let start = fixed.features[f].start;
                line(fixed.exact_joints[start as usize].normal, false)
            }
            SheetKind::RoundLine => {
                let start = moving.features[m].start;
                line(negative(moving.exact_joints[start as usize].normal), true)
            }
            SheetKind::RoundRound | SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => {
                let (a, b) = (&fixed.exact_features[f], &moving.exact_features[m]);
                Locus::Circle {
                    center: ExactSpiral {
                        u: a.center,
                        w: negative(b.center),
                    },
                    radius: a.radius + b.radius,
                }
            }
        };
        Self {
            fixed,
            moving,
            rough: sheet,
            locus,
        }
    }

    /// Where its curve starts and ends.
    fn ends(&self) -> [ExactSpiral; 2] {
        let end = |at| end(self.fixed, self.moving, self.rough, at);
        let start = match self.locus {
            Locus::Line { through, .. } => through,
            Locus::Circle { .. } => end(self.rough.start_at),
        };
        [start, end(self.rough.end_at)]
    }

    /// Its curve at an orientation.
    pub(crate) fn curve(&self, turn: &ExactTurn) -> ExactCurve {
        let [start, end] = self.ends().map(|p| p.at(turn));
        let carrier = self.carrier(turn);
        let middle = match carrier.carrier {
            Carrier::Circle { center, .. } => self.middle(turn, || {
                // Both ends are nearly in one direction from far away.
                let v = rounded(plus(minus(start, center), minus(end, center)));
                Vector::new(v.0, v.1).unit()
            }),
            _ => (Dd::ZERO, Dd::ZERO),
        };
        ExactCurve {
            carrier,
            start,
            end,
            middle,
            chart: self.chart(turn, start, end),
        }
    }

    /// How places on its curve are told, if that is large.
    fn chart(&self, turn: &ExactTurn, start: Xy<Dd>, end: Xy<Dd>) -> Option<Chart> {
        let Locus::Circle { radius, .. } = self.locus else {
            return None;
        };
        let (cos, sin) = (turn.cos.to_f64(), turn.sin.to_f64());
        let Carrier::FlatArc(arc) = self.rough.carrier(cos, sin) else {
            return None;
        };
        let chart = Chart {
            through: exactly(arc.through),
            normal: exactly(arc.normal),
            curvature: Dd::ONE / radius,
            middle: Dd::ZERO,
        };
        let middle = (chart.of(start) + chart.of(end)).scaled(0.5);
        Some(Chart { middle, ..chart })
    }

    /// From the centre of a circle to about the middle of the curve.
    fn middle(&self, turn: &ExactTurn, of_flat_arc: impl Fn() -> Vector) -> Xy<Dd> {
        let middle = if self.rough.is_flat_arc() {
            of_flat_arc()
        } else {
            let theta = turn.theta.to_f64();
            let (from, to) = (
                self.rough.start_angle.at(theta),
                self.rough.end_angle.at(theta),
            );
            Vector::from_angle(0.5 * (from + to)) * self.rough.radius.signum()
        };
        exactly((middle.x, middle.y))
    }

    /// The carrier at an orientation.
    pub(crate) fn carrier(&self, turn: &ExactTurn) -> ExactCarrier {
        let carrier = match self.locus {
            Locus::Line {
                normal,
                turns,
                through,
            } => Carrier::Line {
                normal: if turns {
                    turned(normal, turn.cos, turn.sin)
                } else {
                    normal
                },
                through: through.at(turn),
            },
            Locus::Circle { center, radius } => Carrier::Circle {
                center: center.at(turn),
                radius,
            },
        };
        ExactCarrier {
            carrier,
            is_flat_arc: self.rough.is_flat_arc(),
        }
    }

    fn passing(&self, p: &ExactSpiral) -> Condition {
        match self.locus {
            Locus::Line {
                normal,
                turns,
                through,
            } => height(normal, turns, &through, p, Dd::ZERO),
            Locus::Circle { center, radius } => apart(p, &center, radius),
        }
    }

    /// Calls `found` with every condition under which crossings of two sheets come or go, by its number; see `condition.rs`.
    fn conditions(
        &self,
        other: &Self,
        shared: &SharedEnds,
        asked: impl Fn(usize) -> bool,
        mut take: impl FnMut(usize, Condition),
    ) {
        let [end_shared, start_shared] = shared.corners.map(|c| c.is_some());
        let end = |of: &Self, at| end(of.fixed, of.moving, of.rough, at);
        let mut number = 0;
        let mut ask = |condition: &dyn Fn() -> Condition| {
            if asked(number) {
                take(number, condition());
            }
            number += 1;
        };
        for (shared, of, at, over) in [
            (start_shared, self, self.rough.start_at, other),
            (end_shared, self, self.rough.end_at, other),
            (end_shared, other, other.rough.start_at, self),
            (start_shared, other, other.rough.end_at, self),
        ] {
            if !shared {
                ask(&|| over.passing(&end(of, at)));
            }
        }
        match (&self.locus, &other.locus) {
            (Locus::Line { .. }, Locus::Line { .. }) => {}
            (
                Locus::Line {
                    normal,
                    turns,
                    through,
                },
                Locus::Circle { center, radius },
            )
            | (
                Locus::Circle { center, radius },
                Locus::Line {
                    normal,
                    turns,
                    through,
                },
            ) => {
                for r in [*radius, -*radius] {
                    ask(&|| height(*normal, *turns, through, center, r));
                }
            }
            (
                Locus::Circle { center, radius },
                Locus::Circle {
                    center: c,
                    radius: r,
                },
            ) => {
                let (a, b) = (radius.abs(), r.abs());
                for distance in [a + b, a - b] {
                    ask(&|| apart(center, c, distance));
                }
            }
        }
    }

    /// Calls `found` with every orientation within a range at which crossings with another sheet may come or go, and its error:
    /// as far as doubles tell by condition (see [`Rough`]).
    pub(crate) fn events(
        &self,
        other: &Self,
        shared: &SharedEnds,
        range: (Dd, Dd),
        rough: impl Fn(usize) -> Rough,
        mut found: impl FnMut(Dd, f64),
    ) {
        let middle = (range.0 + range.1).scaled(0.5);
        let half = (range.1 - range.0).scaled(0.5).to_f64();
        let asked = |number| rough(number) != Rough::None;
        self.conditions(other, shared, asked, |number, c| {
            let mut take = |theta: Dd, error| {
                let turns = ((theta - middle) / Dd::TAU).to_f64().round();
                let theta = theta - Dd::TAU * turns;
                if (theta - middle).to_f64().abs() <= half + error {
                    found(theta, error);
                }
            };
            match rough(number) {
                Rough::At(roots) if roots.iter().flatten().all(|&r| c.is_simple(r)) => {
                    for r in roots.into_iter().flatten() {
                        let (theta, error) = c.root_near(r);
                        take(theta, error);
                    }
                }
                _ => c.roots(take),
            }
        });
    }
}

/// The crossings of two curves, by the names of their roots: whether the first enters there. What they share as corners is none.
pub(crate) fn exact_crossings(
    f: &ExactSheet<'_>,
    g: &ExactSheet<'_>,
    shared: &SharedEnds,
    turn: &ExactTurn,
) -> [Option<bool>; 2] {
    let (c, d) = (f.curve(turn), g.curve(turn));
    let mut found = [0, 1].map(|root| c.crossing(&d, root));
    let [end_shared, start_shared] = shared.corners.map(|c| c.is_some());
    for (shared, p) in [(end_shared, c.end), (start_shared, c.start)] {
        if shared {
            let distance = |x: &Option<ExactCrossing>| {
                x.map_or(f64::INFINITY, |x| length(minus(x.point, p)).to_f64())
            };
            let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
            found[nearest] = None;
        }
    }
    found.map(|x| {
        x.filter(|x| c.holds(x.on) && d.holds(d.on(x.point)))
            .map(|x| x.enters)
    })
}
