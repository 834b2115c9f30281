//! A sheet in double-double: its curve and carrier at any orientation, and the events at which crossings come and go.

use crate::feature::Outline;
use crate::geometry::{Rotation, Vector};
use crate::number::Dd;

use super::super::cycle::Cycle;
use super::super::shared::SharedEnds;
use super::super::sheet::{EndAt, Sheet, SheetKind};
use super::super::spiral::Spiral;
use super::condition::{Condition, Rough, apart, height};
use super::curve::{ExactCrossing, ExactCurve};
use super::turn::ExactTurn;

#[derive(Debug, Clone, Copy)]
enum Locus {
    Line {
        normal: Vector<Dd>,
        turns: bool,
        through: Spiral<Dd>,
    },
    Circle {
        center: Spiral<Dd>,
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
                line(-moving.exact_joints[start as usize].normal, true)
            }
            SheetKind::RoundRound | SheetKind::FixedFlatArc | SheetKind::MovingFlatArc => {
                let (a, b) = (&fixed.exact_features[f], &moving.exact_features[m]);
                Locus::Circle {
                    center: Spiral::new(a.center, -b.center.to_vector()),
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
    fn ends(&self) -> [Spiral<Dd>; 2] {
        let end = |at| end(self.fixed, self.moving, self.rough, at);
        let start = match self.locus {
            Locus::Line { through, .. } => through,
            Locus::Circle { .. } => end(self.rough.start_at),
        };
        [start, end(self.rough.end_at)]
    }

    /// Its curve at an orientation.
    pub(crate) fn curve(&self, turn: &ExactTurn) -> ExactCurve {
        let [start, end] = self.ends().map(|p| p.at(turn.turn));
        let cycle = self.cycle(turn);
        let middle = if cycle.is_centred() {
            let theta = turn.theta.to_f64();
            let (from, to) = (self.rough.start_angle, self.rough.end_angle);
            let normal = Vector::from_angle(0.5 * (from.at(theta) + to.at(theta)));
            (normal * self.rough.radius.signum()).map(Dd::from)
        } else {
            (cycle.place(start) + cycle.place(end)) * Dd::from(0.5)
        };
        ExactCurve {
            cycle,
            start,
            end,
            middle,
        }
    }

    /// All of the line or circle on which its curve lies at an orientation.
    ///
    /// A large circle is written by the point with the normal that it is written by in doubles.
    pub(crate) fn cycle(&self, turn: &ExactTurn) -> Cycle<Dd> {
        match self.locus {
            Locus::Line {
                normal,
                turns,
                through,
            } => {
                let normal = if turns { turn.turn * normal } else { normal };
                Cycle::line(through.at(turn.turn), normal)
            }
            Locus::Circle { center, radius } => {
                let center = center.at(turn.turn);
                if !self.rough.is_flat_arc() {
                    return Cycle::round(center, radius);
                }
                let rough: Cycle = self.rough.cycle(Rotation {
                    cos: turn.turn.cos.to_f64(),
                    sin: turn.turn.sin.to_f64(),
                });
                let normal = rough.normal.map(Dd::from).unit();
                Cycle::flat(center + normal * radius, normal, Dd::ONE / radius)
            }
        }
    }

    fn passing(&self, p: &Spiral<Dd>) -> Condition {
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
                x.map_or(f64::INFINITY, |x| x.point.distance(p).to_f64())
            };
            let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
            found[nearest] = None;
        }
    }
    found.map(|x| {
        x.filter(|x| c.holds(x.on) && d.holds(d.cycle.place(x.point)))
            .map(|x| x.enters)
    })
}

/// Where a curve starts or ends.
fn end(fixed: &Outline, moving: &Outline, sheet: &Sheet, at: EndAt) -> Spiral<Dd> {
    let (a, b) = (
        &fixed.exact_features[sheet.fixed as usize],
        &moving.exact_features[sheet.moving as usize],
    );
    match at {
        EndAt::Fixed(j) => {
            let j = &fixed.exact_joints[j as usize];
            Spiral::new(j.point + j.normal * b.radius, -b.center.to_vector())
        }
        EndAt::Moving(j) => {
            let j = &moving.exact_joints[j as usize];
            Spiral::new(a.center, -(j.point + j.normal * a.radius).to_vector())
        }
    }
}
