//! Criticalities of two contacts: an end of one on the other, or both tangent.

use core::f64::consts::PI;
use std::collections::BTreeSet;

use cspace::{Point, Rotation, Vector};

use super::bernstein::Polynomial;
use super::contact::{Carrier, Contact, Wave};
use super::outline::{Feature, Outline, Shape};
use super::search::{Search, Work};
use super::span::{Interval, Span};

/// An end of contact curves: u + R w while the normal of a joint opposes one of a round feature.
struct End {
    span: Span,
    at: [Wave; 2],
}

pub(super) fn search(search: &mut Search<'_>) -> Option<()> {
    let ends = ends(search);
    search.each(ends.len(), |work, i| ends_on_carriers(work, &ends[i]))?;
    search.each(search.pair.contacts.len(), tangencies)
}

/// The ends of all contacts, each once.
fn ends(search: &Search<'_>) -> Vec<End> {
    let (fixed, moving) = (&search.pair.fixed, &search.pair.moving);
    let mut named = BTreeSet::new();
    for c in &search.pair.contacts {
        let a = &fixed.features[c.fixed as usize];
        let b = &moving.features[c.moving as usize];
        for k in [0, 1] {
            if !b.is_line() {
                named.insert((false, a.joints[k], c.moving));
            }
            if !a.is_line() {
                named.insert((true, b.joints[k], c.fixed));
            }
        }
    }
    let ends = named.into_iter().filter_map(|(of_moving, joint, feature)| {
        if of_moving {
            end_of_moving(moving, joint, &fixed.features[feature as usize])
        } else {
            end_of_fixed(fixed, joint, &moving.features[feature as usize])
        }
    });
    ends.collect()
}

/// p = joint + r n − R q, with the joint's normal n.
fn end_of_fixed(fixed: &Outline, joint: u32, b: &Feature) -> Option<End> {
    let j = &fixed.joints[joint as usize];
    let Shape::Round { center: q, radius } = b.shape else {
        return None;
    };
    let u = j.point + Vector::from_angle(j.angle) * radius;
    Some(End {
        span: Span::new(j.angle - b.hi - PI, b.width()),
        at: [Wave([u.x, -q.x, q.y]), Wave([u.y, -q.y, -q.x])],
    })
}

/// p = centre − R (joint + r m), with the joint's normal m in the moving part's frame.
fn end_of_moving(moving: &Outline, joint: u32, a: &Feature) -> Option<End> {
    let j = &moving.joints[joint as usize];
    let Shape::Round { center: u, radius } = a.shape else {
        return None;
    };
    let q = j.point + Vector::from_angle(j.angle) * radius;
    Some(End {
        span: Span::new(a.lo - j.angle - PI, a.width()),
        at: [Wave([u.x, -q.x, q.y]), Wave([u.y, -q.y, -q.x])],
    })
}

fn on_common(a: &Span, b: &Span, mut take: impl FnMut(&Interval)) {
    for common in a.common(b).into_iter().flatten() {
        common.intervals(&mut take);
    }
}

fn point(at: &[Wave; 2], turn: Rotation) -> Point {
    Point::new(at[0].at(turn), at[1].at(turn))
}

/// 1 + t² on an interval.
pub(super) fn unit(on: &Interval) -> Polynomial {
    Wave([1.0, 0.0, 0.0]).over(on)
}

fn ends_on_carriers(work: &mut Work<'_>, end: &End) {
    let pair = work.pair;
    for contact in &pair.contacts {
        on_common(&end.span, &contact.span, |on| {
            let p = value(&contact.carrier, &end.at, on);
            pair.basis.roots(&p, |s| {
                let theta = on.theta(s);
                if work.is_candidate(theta) {
                    let p = point(&end.at, Rotation::by(theta));
                    work.examine(&[contact], p, theta);
                }
            });
        });
    }
}

/// The carrier's equation at a point that moves as waves do, times (1 + t²)².
fn value(carrier: &Carrier, at: &[Wave; 2], on: &Interval) -> Polynomial {
    let [x, y] = at.map(|w| w.over(on));
    let mut sum = carrier.a.over(on).times(&x);
    sum = sum.plus(&carrier.b.over(on).times(&y), 1.0);
    sum = sum.plus(&carrier.c.over(on).times(&unit(on)), 1.0);
    if carrier.round {
        sum = sum.plus(&x.times(&x), 1.0).plus(&y.times(&y), 1.0);
    }
    sum
}

/// Tangencies of one contact with all that follow.
fn tangencies(work: &mut Work<'_>, i: usize) {
    let pair = work.pair;
    let f = &pair.contacts[i];
    for g in &pair.contacts[i + 1..] {
        match (f.carrier.round, g.carrier.round) {
            (false, false) => {}
            (true, false) => line_tangent(work, g, f),
            (false, true) => line_tangent(work, f, g),
            (true, true) => circles_tangent(work, f, g),
        }
    }
}

/// The centre's distance from the line is the radius, on either side.
fn line_tangent(work: &mut Work<'_>, line: &Contact, circle: &Contact) {
    let pair = work.pair;
    let center = circle.carrier.center();
    on_common(&line.span, &circle.span, |on| {
        let height = value(&line.carrier, &center, on);
        let one = unit(on).times(&unit(on));
        for r in [circle.carrier.radius, -circle.carrier.radius] {
            pair.basis.roots(&height.plus(&one, -r), |s| {
                let theta = on.theta(s);
                if work.is_candidate(theta) {
                    let turn = Rotation::by(theta);
                    let c = point(&center, turn);
                    let (_, normal, _) = line.carrier.distance(c, turn);
                    work.examine(&[line, circle], c + normal * -r, theta);
                }
            });
        }
    });
}

/// The centres' distance is the sum or the difference of the radii.
fn circles_tangent(work: &mut Work<'_>, f: &Contact, g: &Contact) {
    /// Circles nearer to having one centre are not tangent at a place.
    const CONCENTRIC: f64 = 1e-9;
    let pair = work.pair;
    let (r, s) = (f.carrier.radius.abs(), g.carrier.radius.abs());
    let [c, d] = [f.carrier.center(), g.carrier.center()];
    let apart = [0, 1].map(|k| Wave([0, 1, 2].map(|i| d[k].0[i] - c[k].0[i])));
    on_common(&f.span, &g.span, |on| {
        let [x, y] = apart.map(|w| w.over(on));
        let square = x.times(&x).plus(&y.times(&y), 1.0);
        let one = unit(on).times(&unit(on));
        for signed in [s, -s] {
            // Within each other, the smaller is on the side of the larger's centre on which its own is.
            let (sum, from_c) = (r + signed, if signed < 0.0 && r < s { -r } else { r });
            pair.basis.roots(&square.plus(&one, -sum * sum), |at| {
                let theta = on.theta(at);
                if work.is_candidate(theta) {
                    let turn = Rotation::by(theta);
                    let v = Vector::new(apart[0].at(turn), apart[1].at(turn));
                    if v.length() > CONCENTRIC {
                        let p = point(&c, turn) + v.unit() * from_c;
                        work.examine(&[f, g], p, theta);
                    }
                }
            });
        }
    });
}
