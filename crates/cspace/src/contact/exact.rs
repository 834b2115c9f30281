//! Sheets in double-double: what is decided again where doubles leave it open.
//!
//! A sheet is made anew from the features in double-double that it belongs to. Lines and circles are all there is: large
//! circles need no form of their own, for with 106 bits a place near the parts is known about any centre.

use crate::feature::Outline;
use crate::geometry::Vector;
use crate::number::Dd;
use crate::number::plane::{
    Xy, cross, dot, exactly, left, length, minus, negative, plus, rounded, times, turned,
};

use super::carrier::{Carrier, place_on};
use super::condition::{apart_coefficients, height_coefficients};
use super::shared::SharedEnds;
use super::sheet::{EndAt, Sheet, SheetKind};

/// An orientation in double-double, with its rotation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactTurn {
    pub(crate) theta: Dd,
    cos: Dd,
    sin: Dd,
}

impl ExactTurn {
    pub(crate) fn by(theta: Dd) -> Self {
        let (sin, cos) = theta.sin_cos();
        Self { theta, cos, sin }
    }

    /// By cosine and sine, where the angle itself is not asked for.
    pub(crate) fn of(cos: Dd, sin: Dd) -> Self {
        let theta = Dd::from(sin.to_f64().atan2(cos.to_f64()));
        Self { theta, cos, sin }
    }
}

/// A point u + R w.
#[derive(Debug, Clone, Copy)]
struct ExactSpiral {
    u: Xy<Dd>,
    w: Xy<Dd>,
}

impl ExactSpiral {
    fn at(&self, turn: &ExactTurn) -> Xy<Dd> {
        plus(self.u, turned(self.w, turn.cos, turn.sin))
    }

    fn size(&self) -> f64 {
        let (u, w) = (rounded(self.u), rounded(self.w));
        u.0.abs() + u.1.abs() + w.0.abs() + w.1.abs()
    }
}

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

/// The carrier of a sheet at one orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCarrier {
    pub(crate) carrier: Carrier<Dd>,
    /// Whether roots with it are named by where it enters.
    is_flat_arc: bool,
}

/// The curve of a sheet at one orientation.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCurve {
    carrier: ExactCarrier,
    start: Xy<Dd>,
    end: Xy<Dd>,
    /// From the centre of a circle to about the middle of the curve, of length about one.
    middle: Xy<Dd>,
    /// How places on a large circle are told.
    chart: Option<Chart>,
}

/// Places on a large circle as doubles have them: by the tangent of half the angle about its centre from a point near the parts
/// (see `flat_arc.rs`), which differs from the length of travel in the third order; counted from the middle of the curve.
#[derive(Debug, Clone, Copy)]
struct Chart {
    through: Xy<Dd>,
    normal: Xy<Dd>,
    curvature: Dd,
    middle: Dd,
}

impl Chart {
    /// The place of a point, from where the circle is told.
    fn of(&self, p: Xy<Dd>) -> Dd {
        let d = minus(p, self.through);
        let fall = self.curvature * dot(self.normal, d);
        dot(left(self.normal), d) / (fall.scaled(0.5) + 1.0)
    }

    /// The point at a place, to the rounding of the point near the parts.
    fn point(&self, place: Dd) -> Xy<Dd> {
        let u = place + self.middle;
        let half = u * self.curvature.scaled(0.5);
        let t = u / (half * half + 1.0);
        let way = plus(times(left(self.normal), t), times(self.normal, -(t * half)));
        plus(self.through, way)
    }
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

/// What doubles tell of the roots of a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Rough {
    /// There is none.
    None,
    /// There are these, to within [`Rough::ERROR`].
    At([Option<f64>; 2]),
    /// Nothing is certain.
    Unknown,
}

impl Rough {
    /// Roots that are known worse are not certain (radians).
    pub(crate) const ERROR: f64 = 1e-11;
}

/// Where a curve starts or ends.
fn end(fixed: &Outline, moving: &Outline, sheet: &Sheet, at: EndAt) -> ExactSpiral {
    let (a, b) = (
        &fixed.exact_features[sheet.fixed as usize],
        &moving.exact_features[sheet.moving as usize],
    );
    match at {
        EndAt::Fixed(j) => {
            let j = &fixed.exact_joints[j as usize];
            ExactSpiral {
                u: plus(j.point, times(j.normal, b.radius)),
                w: negative(b.center),
            }
        }
        EndAt::Moving(j) => {
            let j = &moving.exact_joints[j as usize];
            ExactSpiral {
                u: a.center,
                w: negative(plus(j.point, times(j.normal, a.radius))),
            }
        }
    }
}

/// The condition p ↦ n·(p − through) − offset at a spiral.
fn height(
    normal: Xy<Dd>,
    turns: bool,
    through: &ExactSpiral,
    p: &ExactSpiral,
    offset: Dd,
) -> Condition {
    let (u, w) = (minus(p.u, through.u), minus(p.w, through.w));
    let (stays, moves) = if turns { (w, u) } else { (u, w) };
    Condition {
        coefficients: height_coefficients(normal, stays, moves, offset, turns),
        scale: p.size() + through.size() + offset.to_f64().abs(),
        kind: Kind::Height { moves },
    }
}

fn apart(p: &ExactSpiral, q: &ExactSpiral, distance: Dd) -> Condition {
    let (u, w) = (minus(p.u, q.u), minus(p.w, q.w));
    let size = |v: Xy<Dd>| v.0.to_f64().abs() + v.1.to_f64().abs();
    let distance_size = distance.to_f64().abs();
    let reach = size(u) + size(w) + distance_size;
    let parts = p.size() + q.size() + distance_size;
    Condition {
        coefficients: apart_coefficients(u, w, distance),
        scale: reach * parts,
        kind: Kind::Apart {
            u,
            w,
            distance: distance.abs(),
            parts,
        },
    }
}

/// α cos θ + β sin θ + γ in double-double, with the size of what its coefficients were made from.
struct Condition {
    coefficients: [Dd; 3],
    scale: f64,
    kind: Kind,
}

/// What the extreme values of a condition are made of.
enum Kind {
    /// The height of what moves so over a line.
    Height { moves: Xy<Dd> },
    /// |u + R w|² less the square of a distance, made from parts of that size.
    Apart {
        u: Xy<Dd>,
        w: Xy<Dd>,
        distance: Dd,
        parts: f64,
    },
}

/// Error of a coefficient, in units of its scale.
const COEFFICIENT_ERROR: f64 = 64.0 * Dd::EPSILON;

impl Condition {
    /// Value, first and second derivative at an orientation in doubles.
    fn at(&self, theta: f64) -> [Dd; 3] {
        let [alpha, beta, gamma] = self.coefficients;
        let (sin, cos) = Dd::from(theta).sin_cos();
        let wave = alpha * cos + beta * sin;
        [wave + gamma, beta * cos - alpha * sin, -wave]
    }

    /// Whether it has just one root where doubles tell of one, and that is found by [`root_near`](Self::root_near).
    fn is_simple(&self, theta: f64) -> bool {
        /// The cube of the distance of a root from where doubles tell it, in double-double, is nothing.
        const NEAR: f64 = 10.0 * Rough::ERROR;
        /// The angle from a double root, at least.
        const FAR: f64 = 1e-3;
        let [alpha, beta, gamma] = self.coefficients.map(Dd::to_f64);
        let (sin, cos) = theta.sin_cos();
        let slope = beta * cos - alpha * sin;
        let value = alpha * cos + beta * sin + gamma;
        slope.abs() > FAR * alpha.hypot(beta)
            && value.abs() <= NEAR * slope.abs()
            && slope.abs() > FAR * self.scale
    }

    /// The root near to where doubles tell it: by the parabola there.
    fn root_near(&self, theta: f64) -> (Dd, f64) {
        let [value, slope, bend] = self.at(theta);
        let step = -(value / slope);
        let step = step - step * step * bend / slope * 0.5;
        let error = 2.0 * COEFFICIENT_ERROR * self.scale / slope.to_f64().abs() + COEFFICIENT_ERROR;
        (Dd::from(theta) + step, error)
    }

    /// √(α² + β²) + γ and √(α² + β²) − γ, with their errors: of distances as products of lengths, for of circles of nearly one radius
    /// about nearly one centre the differences of lengths are known, not those of their squares.
    fn extremes(&self) -> [(Dd, f64); 2] {
        match self.kind {
            Kind::Height { moves } => {
                let (amplitude, gamma) = (length(moves), self.coefficients[2]);
                [amplitude + gamma, amplitude - gamma].map(|x| (x, COEFFICIENT_ERROR * self.scale))
            }
            Kind::Apart {
                u,
                w,
                distance: d,
                parts,
            } => {
                let (a, b) = (length(u), length(w));
                [(a + b - d, a + b + d), (d - (a - b), d + (a - b))].map(|(x, y)| {
                    let error = COEFFICIENT_ERROR * parts;
                    let sizes = x.to_f64().abs() + y.to_f64().abs();
                    (x * y, error * (sizes + error))
                })
            }
        }
    }

    /// Its roots up to whole turns: as in `number/trig.rs`.
    fn roots(&self, mut found: impl FnMut(Dd, f64)) {
        let [alpha, beta, _] = self.coefficients;
        let a = (alpha * alpha + beta * beta).sqrt().to_f64();
        let error = COEFFICIENT_ERROR * self.scale;
        if a <= 4.0 * error {
            return;
        }
        // Vertices are moved so far that a double root is one by the making of the parts: where two arcs face each other, the
        // contact of their ends touches the circle of their contacts. What only touches zero changes nothing.
        let [(most, most_error), (least, least_error)] = self.extremes();
        let (m, l) = (most.to_f64(), least.to_f64());
        if m <= most_error || l <= least_error {
            return;
        }
        let middle = Dd::atan2(beta, alpha);
        let aside = Dd::atan2(most.sqrt(), least.sqrt()).scaled(2.0);
        // By the derivatives of twice the angle whose tangent is √(most / least).
        let of_aside = (m * l).sqrt() / (m + l) * (most_error / m + least_error / l);
        let error = 2.0 * (of_aside + error / a) + COEFFICIENT_ERROR;
        found(middle + aside, error);
        if !aside.is_zero() {
            found(middle - aside, error);
        }
    }
}

/// A crossing of two curves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ExactCrossing {
    /// Length of travel from about the middle of either curve.
    pub(crate) places: (Dd, Dd),
    pub(crate) point: Xy<Dd>,
    pub(crate) enters: bool,
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
    fn own_root(&self, other: &Self, root: u8) -> u8 {
        if self.is_flat_arc || other.is_flat_arc {
            (0..2)
                .find(|&r| self.enters(other, r) == (root == 1))
                .unwrap_or(root)
        } else {
            root
        }
    }

    /// Whether travel along it enters the blocked side of another curve at a crossing; see `crossing.rs`.
    fn enters(&self, other: &Self, root: u8) -> bool {
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
    fn meets(&self, other: &Self) -> bool {
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

impl ExactCurve {
    /// Length of travel from about the middle of the curve to a point of it, given as `place_on` gives it.
    fn length_of(&self, v: Xy<Dd>) -> Dd {
        if let Some(chart) = &self.chart {
            return chart.of(self.carrier.point(v)) - chart.middle;
        }
        match self.carrier.carrier {
            Carrier::Line { normal, .. } => {
                let all = dot(left(normal), minus(self.end, self.start));
                v.0 - all.scaled(0.5)
            }
            Carrier::Circle { radius, .. } => {
                Dd::atan2(cross(self.middle, v), dot(self.middle, v)) * radius
            }
            Carrier::FlatArc(_) => Dd::ZERO,
        }
    }

    /// What grows with the length of travel to a point, given as `place_on` gives it: on a circle y / (|x| + |y|) along and across
    /// the direction to its middle, continued beyond the quarter turns.
    pub(crate) fn rank(&self, v: Xy<Dd>) -> Dd {
        let Carrier::Circle { radius, .. } = self.carrier.carrier else {
            return v.0;
        };
        let (x, y) = (dot(self.middle, v), cross(self.middle, v));
        let y = if radius.is_negative() { -y } else { y };
        let quarter = y / (x.abs() + y.abs());
        if !x.is_negative() {
            quarter
        } else if y.is_negative() {
            -quarter - 2.0
        } else {
            -quarter + 2.0
        }
    }

    /// The length of travel to a point of the plane on the curve.
    fn position(&self, p: Xy<Dd>) -> Dd {
        match self.carrier.carrier {
            Carrier::Line { normal, through } => {
                self.length_of((dot(left(normal), minus(p, through)), Dd::ZERO))
            }
            Carrier::Circle { center, .. } => self.length_of(minus(p, center)),
            Carrier::FlatArc(_) => Dd::ZERO,
        }
    }

    /// The places of its ends.
    pub(crate) fn ends(&self) -> (Dd, Dd) {
        let (start, end) = (self.position(self.start), self.position(self.end));
        match self.carrier.carrier {
            // All of a circle ends where it starts, half a turn from the middle.
            Carrier::Circle { .. } if start > end && self.chart.is_none() => {
                if start.abs() > end.abs() {
                    (-start.abs(), end)
                } else {
                    (start, end.abs())
                }
            }
            _ => (start, end),
        }
    }

    /// The point at a place, given as a length of travel from about the middle.
    pub(crate) fn point(&self, place: Dd) -> Xy<Dd> {
        match self.carrier.carrier {
            Carrier::Line { normal, .. } => {
                let middle = times(plus(self.start, self.end), Dd::from(0.5));
                plus(middle, times(left(normal), place))
            }
            Carrier::Circle { center, radius } => {
                let way = if let Some(chart) = &self.chart {
                    minus(chart.point(place), center)
                } else {
                    let (sin, cos) = (place / radius).sin_cos();
                    turned(self.middle, cos, sin)
                };
                let far = times(way, radius.abs() / length(way));
                plus(center, far)
            }
            Carrier::FlatArc(_) => self.start,
        }
    }

    /// Where it starts and ends.
    pub(crate) fn end_points(&self) -> [Xy<Dd>; 2] {
        [self.start, self.end]
    }

    /// Its carrier.
    pub(crate) fn carrier(&self) -> &ExactCarrier {
        &self.carrier
    }

    /// On which side of it a point beside it is: whether on that of its line's normal, or outside of its circle.
    pub(crate) fn side_of(&self, p: Xy<Dd>) -> Option<bool> {
        let off = match self.carrier.carrier {
            Carrier::Line { normal, through } => dot(normal, minus(p, through)),
            Carrier::Circle { center, radius } => length(minus(p, center)) - radius.abs(),
            Carrier::FlatArc(_) => return None,
        };
        let (place, (lo, hi)) = (self.position(p), self.ends());
        (lo < place && place < hi).then_some(!off.is_negative())
    }

    /// Where another carrier crosses its own, as a length of travel; where they do not, the nearest place to that.
    pub(crate) fn place(&self, other: &ExactCarrier, root: u8, swapped: bool) -> Dd {
        self.length_of(self.carrier.crossed_by(other, root, swapped))
    }

    /// The crossing with the given name, wherever it lies on the carriers.
    pub(crate) fn crossing(&self, other: &Self, root: u8) -> Option<ExactCrossing> {
        let lines = matches!(
            (&self.carrier.carrier, &other.carrier.carrier),
            (Carrier::Line { .. }, Carrier::Line { .. })
        );
        if !self.carrier.meets(&other.carrier) || (lines && root > 0) {
            return None;
        }
        let root = self.carrier.own_root(&other.carrier, root);
        let v = place_on(&self.carrier.carrier, &other.carrier.carrier, root, false);
        let point = self.carrier.point(v);
        Some(ExactCrossing {
            places: (self.length_of(v), other.position(point)),
            point,
            enters: self.carrier.enters(&other.carrier, root),
        })
    }

    /// How far outward along a direction from a point its carrier lies, near that point.
    pub(crate) fn height(&self, p: Xy<Dd>, outward: Xy<Dd>) -> Dd {
        match self.carrier.carrier {
            Carrier::Line { normal, through } => {
                dot(normal, minus(through, p)) / dot(normal, outward)
            }
            Carrier::Circle { center, radius } => {
                let v = minus(p, center);
                let off = length(v) - radius.abs();
                if dot(v, outward).is_negative() {
                    off
                } else {
                    -off
                }
            }
            Carrier::FlatArc(_) => Dd::ZERO,
        }
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
    let (of_f, of_g) = (c.ends(), d.ends());
    let within = |place: Dd, (lo, hi): (Dd, Dd)| lo < place && place < hi;
    found.map(|x| {
        x.filter(|x| within(x.places.0, of_f) && within(x.places.1, of_g))
            .map(|x| x.enters)
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests;
