//! Crossings of two pieces.
//!
//! Whether the number of crossings is odd is decided only by the order of the two pieces at the ends of their common interval. An end is a
//! node, and a node has one place for all pieces that meet there; so a third curve is on the same side of it for all of them, and it
//! crosses a chain of pieces as often as the chain's ends demand, whatever the rounding. Two monotone pieces that run in opposite
//! directions cross at most once. For others the resultant of the two conditions, a trigonometric polynomial of degree four at most,
//! isolates all crossings.

use super::condition::Condition;
use super::equation::Equation;
use super::motion::{Motion, Placement};
use super::piece::{Height, Pair, Piece};
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::geometry::{Rotation, Vector};
use crate::number::TrigPolynomial;
use core::f64::consts::TAU;

/// Upper bound of the rounds of narrowing a bracket: a guard against NaN.
const MOST_ROUNDS: u32 = 200;
/// Width of a bracket about a crossing below which it is not narrowed, as a share of 1 + |x|: a few last bits.
const NARROWEST_BRACKET: f64 = 4.0 * f64::EPSILON;
/// Number of times that boxes about two pieces are halved before the resultant is used.
const HALVINGS: u32 = 5;

/// Order of two pieces at x, the second shifted by a number of turns: the sign of y₁ − y₂, never 0.
///
/// `None` where they share a node.
fn order(pairs: &[Pair], p: &Piece, q: &Piece, shift: i32, x: f64) -> Option<i8> {
    let heights = (p.height(pairs, x), q.height(pairs, x));
    order_of(p, q, shift, x, heights)
}

fn order_of(p: &Piece, q: &Piece, shift: i32, x: f64, heights: (Height, Height)) -> Option<i8> {
    let difference = heights.0.above(heights.1, shift);
    if difference != 0.0 {
        return Some(if difference > 0.0 { 1 } else { -1 });
    }
    // A node counts as above a curve that passes through it up to rounding.
    let node = |r: &Piece| {
        [&r.start, &r.end]
            .into_iter()
            .find(|e| e.x == x)
            .map(|e| e.key)
    };
    match (node(p), node(q)) {
        (Some(a), Some(b)) if a == b => None,
        (Some(a), Some(b)) => Some(if a > b { 1 } else { -1 }),
        (None, Some(_)) => Some(-1),
        _ => Some(1),
    }
}

fn difference(pairs: &[Pair], p: &Piece, q: &Piece, shift: i32, x: f64) -> f64 {
    p.height(pairs, x).above(q.height(pairs, x), shift)
}

/// Calls `found` with every x at which two graphs cross, and the order on the left of it.
pub(super) fn crossings(
    pairs: &[Pair],
    p: &Piece,
    q: &Piece,
    shift: i32,
    mut found: impl FnMut(f64, i8),
) {
    let lo = p.start.x.max(q.start.x);
    let hi = p.end.x.min(q.end.x);
    let motions = &pairs[p.pair as usize].condition.motions;
    // If both parts have one pivot, only y − x matters: curves are parallel, or equal.
    if lo >= hi || motions.share_a_pivot() {
        return;
    }
    let heights = |x: f64| (p.height(pairs, x), q.height(pairs, x));
    let (ends_lo, ends_hi) = (heights(lo), heights(hi));
    let (at_lo, at_hi) = (
        order_of(p, q, shift, lo, ends_lo),
        order_of(p, q, shift, hi, ends_hi),
    );
    let rising = |r: &Piece| r.start.y() < r.end.y();
    let same_way = rising(p) == rising(q);
    let level = |c: &Piece| c.start.y() == c.end.y();
    let once = !same_way || level(p) || level(q);
    let mut report = |from: f64, to: f64, before: i8| {
        found(bisect(pairs, p, q, shift, (from, to), before), before);
    };
    let (f, g) = (
        &pairs[p.pair as usize].condition,
        &pairs[q.pair as usize].condition,
    );
    if once || parallel(f, g) {
        if let (Some(a), Some(b)) = (at_lo, at_hi)
            && a != b
        {
            report(lo, hi, a);
        }
        return;
    }
    if at_lo.is_some() && at_lo == at_hi {
        // The upper one first.
        let ys = |(a, b): (Height, Height)| {
            let (a, b) = (a.y(), b.y() + TAU * f64::from(shift));
            if at_lo == Some(1) { (a, b) } else { (b, a) }
        };
        let at = |x: f64| ys(heights(x));
        if separate(&at, lo, hi, ys(ends_lo), ys(ends_hi), rising(p), HALVINGS) {
            return;
        }
    }
    // Between brackets the order cannot change.
    let mut marks = vec![lo];
    let mut mark = |a: f64, b: f64| {
        marks.push(a);
        marks.push(b);
    };
    isolate(f, g, lo, hi, &mut mark);
    marks.push(hi);
    marks.sort_by(f64::total_cmp);
    let mut before = at_lo;
    let mut from = lo;
    for &x in &marks[1..] {
        let here = if x == hi {
            at_hi
        } else {
            order(pairs, p, q, shift, x)
        };
        if x <= from {
            continue;
        }
        if let (Some(a), Some(b)) = (before, here)
            && a != b
        {
            report(from, x, a);
        }
        from = x;
        before = here.or(before);
    }
}

/// Whether boxes show that a monotone graph stays above another, both running in one direction.
fn separate(
    at: &impl Fn(f64) -> (f64, f64),
    lo: f64,
    hi: f64,
    at_lo: (f64, f64),
    at_hi: (f64, f64),
    rising: bool,
    halvings: u32,
) -> bool {
    let apart = if rising {
        at_lo.0 > at_hi.1
    } else {
        at_hi.0 > at_lo.1
    };
    if apart {
        return true;
    }
    if halvings == 0 || at_lo.0 < at_lo.1 || at_hi.0 < at_hi.1 {
        return false;
    }
    let middle = 0.5 * (lo + hi);
    let at_middle = at(middle);
    separate(at, lo, middle, at_lo, at_middle, rising, halvings - 1)
        && separate(at, middle, hi, at_middle, at_hi, rising, halvings - 1)
}

/// The x at which the order changes, given the order at the left end and a different one at the right end.
///
/// The method is inverse quadratic interpolation where the last three values indicate that it converges, otherwise bisection (T. R.
/// Chandrupatla, *A new hybrid quadratic/bisection algorithm*, 1997). Curves often end near a crossing with a vertical tangent, where false
/// position is slow. An end where the two are equal counts according to the order.
fn bisect(
    pairs: &[Pair],
    p: &Piece,
    q: &Piece,
    shift: i32,
    (lo, hi): (f64, f64),
    before: i8,
) -> f64 {
    let side = f64::from(before);
    let value = |x: f64| side * difference(pairs, p, q, shift, x);
    let least = f64::EPSILON * f64::EPSILON;
    // The newest end of the bracket, the other one, and the previous one.
    let (mut x1, mut f1) = (hi, value(hi).min(-least));
    let (mut x2, mut f2) = (lo, value(lo).max(least));
    let mut share = 0.5;
    for _ in 0..MOST_ROUNDS {
        let x = x1 + share * (x2 - x1);
        let f = value(x);
        if f == 0.0 {
            return x;
        }
        let (x3, f3);
        if (f > 0.0) == (f1 > 0.0) {
            (x3, f3) = (x1, f1);
        } else {
            (x3, f3) = (x2, f2);
            (x2, f2) = (x1, f1);
        }
        (x1, f1) = (x, f);
        let width = (x2 - x1).abs();
        let narrowest = NARROWEST_BRACKET * (1.0 + x1.abs());
        if width <= narrowest {
            break;
        }
        let xi = (x1 - x2) / (x3 - x2);
        let phi = (f1 - f2) / (f3 - f2);
        share = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            let quadratic = f1 / (f2 - f1) * f3 / (f2 - f3)
                + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
            let step = 0.5 * narrowest / width;
            quadratic.max(step).min(1.0 - step)
        } else {
            0.5
        };
    }
    0.5 * (x1 + x2)
}

// The resultant of two conditions: a polynomial that vanishes where one y satisfies both.

/// Width of x below which intervals are not halved when crossings are isolated (radians or length); two crossings nearer than that, between
/// which the pieces are a hundred times nearer than rounding, may be missed as a pair.
const NARROWEST: f64 = 1e-8;

/// Whether two conditions are levels of one function of (x, y), so that their curves never cross.
pub(super) fn parallel(f: &Condition, g: &Condition) -> bool {
    let same = |a: &Cycle, b: &Cycle| {
        if a.is_centred() && b.is_centred() {
            a.through.distance(b.through) < INDEPENDENT
        } else {
            a.weight == 0.0 && b.weight == 0.0 && a.normal.cross(b.normal).abs() < INDEPENDENT
        }
    };
    same(&f.first, &g.first) && same(&f.second, &g.second)
}

/// Calls `mark` with intervals that contain all x at which one y satisfies both conditions.
pub(super) fn isolate(
    f: &Condition,
    g: &Condition,
    lo: f64,
    hi: f64,
    mark: &mut impl FnMut(f64, f64),
) {
    let resultant = |first: Placement| resultant(f.in_y(first), g.in_y(first));
    if let Motion::Turn { center } = f.motions.first {
        let polynomial = TrigPolynomial::sampled(|turn: Rotation| {
            let shift = center.to_vector() - turn * center.to_vector();
            resultant(Placement { turn, shift })
        });
        let mut vague = Vec::new();
        polynomial.brackets(lo, hi, NARROWEST, mark, &mut |a, b| vague.push((a, b)));
        for (a, b) in vague {
            mark(a, b);
        }
        return;
    }
    // A polynomial of x = m + h cos φ is a trigonometric one of φ.
    let (m, h) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let x = |angle: f64| m + h * angle.cos();
    let polynomial = TrigPolynomial::sampled(|Rotation { cos, .. }: Rotation| {
        let shift = match f.motions.first {
            Motion::Slide { direction } => direction * (m + h * cos),
            _ => Vector::ZERO,
        };
        let turn = Rotation::IDENTITY;
        resultant(Placement { turn, shift })
    });
    let mut both = Vec::new();
    let mut vague = Vec::new();
    polynomial.brackets(
        0.0,
        core::f64::consts::PI,
        NARROWEST,
        &mut |a, b| both.push((a, b)),
        &mut |a, b| vague.push((a, b)),
    );
    for (a, b) in both.into_iter().chain(vague) {
        mark(x(b).max(lo), x(a).min(hi));
    }
}

/// A value that is zero where one y satisfies both equations, and the size of its terms.
fn resultant(f: Equation, g: Equation) -> (f64, f64) {
    let size = |a: f64, b: f64| a.abs() + b.abs();
    match (f, g) {
        (
            Equation::Trig {
                alpha: a,
                beta: b,
                gamma: c,
            },
            Equation::Trig {
                alpha: d,
                beta: e,
                gamma: f,
            },
        ) => {
            // Cramer's rule for (cos y, sin y), whose length is one.
            let (p, q, r) = (c * e - f * b, a * f - d * c, a * e - d * b);
            let terms = [size(c * e, f * b), size(a * f, d * c), size(a * e, d * b)];
            (p * p + q * q - r * r, terms.iter().map(|t| t * t).sum())
        }
        (Equation::Quadratic { a, b, c }, Equation::Quadratic { a: d, b: e, c: f }) => {
            let (p, q, r) = (a * e - d * b, a * f - d * c, b * f - e * c);
            if a == 0.0 && d == 0.0 {
                return (r, size(b * f, e * c));
            }
            let terms = size(a * f, d * c).powi(2) + size(a * e, d * b) * size(b * f, e * c);
            (q * q - p * r, terms)
        }
        _ => (f64::NAN, 0.0),
    }
}
