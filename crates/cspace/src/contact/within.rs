//! Whether what a condition tells happens within the ends of the curves.
//!
//! Conditions are told of carriers. Where these touch beyond the curves nothing comes or goes, and the orientation, known to
//! the square root of the rounding, would only make what happens nearby uncertain too.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::{Event, LARGEST_ERROR, Trig};

use super::condition::Happening;
use super::curve::wrap;
use super::sheet::Sheet;
use super::spiral::Spiral;

/// The largest speed of a place of a curve, in the pair's frame per radian.
const SPEED: f64 = 8.0;

/// More than rounding of a place: length, and angle on a circle.
const ROUNDING: f64 = 1e-9;

/// Centres nearer to each other than this do not tell a direction (length).
const CONCENTRIC: f64 = 1e-6;

/// What is nearer than estimated is taken for near.
const MARGIN: f64 = 4.0;

/// Ends that pass at an orientation known as well as this (radians) make nothing nearby uncertain.
const SHARP: f64 = 1e-9;

/// Whether the curves may touch or cross where a root of a condition is, as well as that is known.
///
/// A sharp passing of an end always may.
pub(crate) fn within_ends(
    f: &Sheet,
    g: &Sheet,
    happening: &Happening<'_>,
    condition: &Trig,
    event: Event,
) -> bool {
    if event.error >= LARGEST_ERROR {
        return true;
    }
    match *happening {
        Happening::Passing { .. } if event.error < SHARP => true,
        Happening::Passing { end, over } => passes(end, over, event),
        Happening::Tangency(distance) => touch(f, g, distance, condition, event),
    }
}

/// Whether an end that is on the carrier of a curve may be on the curve.
fn passes(end: &Spiral, over: &Sheet, event: Event) -> bool {
    let (theta, turn) = (event.theta, Rotation::by(event.theta));
    let way = SPEED * event.error + ROUNDING;
    let p = end.at(turn);
    if over.is_circle() {
        let direction = p - over.center().at(turn);
        return holds(over, direction, theta, MARGIN * way / over.radius.abs());
    }
    let along = over.normal_at(turn).left();
    let place = |q: Point| along.dot(q - p);
    spans(place(over.start.at(turn)), place(over.end.at(turn)), way)
}

/// Whether the curves may touch or cross near the place at which their carriers are tangent: `distance` is that from the
/// line to the centre, along its normal, or of the centres.
fn touch(f: &Sheet, g: &Sheet, distance: f64, condition: &Trig, event: Event) -> bool {
    let (theta, turn) = (event.theta, Rotation::by(event.theta));
    let way = SPEED * event.error + ROUNDING;
    // How far from zero the condition may be where the event is: the curves overlap by that, and cross beside the place.
    let slope = condition.beta * turn.cos - condition.alpha * turn.sin;
    let amplitude = condition.alpha.hypot(condition.beta);
    let depth =
        (slope.abs() + amplitude * event.error) * event.error + f64::EPSILON * condition.scale;
    match (f.is_circle(), g.is_circle()) {
        (true, true) => {
            let (r, s) = (f.radius.abs(), g.radius.abs());
            let v = g.center().at(turn) - f.center().at(turn);
            let apart = v.length();
            if apart < CONCENTRIC {
                return true;
            }
            let beside = |r: f64, s: f64| MARGIN * ((depth * s / r).sqrt() / apart + way / apart);
            // Of two circles one in the other both touch on the side of the smaller.
            let (of_f, of_g) = if distance == r + s {
                (v, -v)
            } else {
                let side = if r > s { v } else { -v };
                (side, side)
            };
            holds(f, of_f, theta, beside(r, s)) && holds(g, of_g, theta, beside(s, r))
        }
        (false, true) => touches_line(f, g, distance, theta, depth, way, event.error),
        (true, false) => touches_line(g, f, distance, theta, depth, way, event.error),
        (false, false) => true,
    }
}

fn touches_line(
    line: &Sheet,
    circle: &Sheet,
    distance: f64,
    theta: f64,
    depth: f64,
    way: f64,
    error: f64,
) -> bool {
    let turn = Rotation::by(theta);
    let normal = line.normal_at(turn);
    let r = circle.radius.abs();
    let beside = MARGIN * ((2.0 * depth / r).sqrt() + error) + ROUNDING;
    let to_line = normal * -distance;
    let foot = circle.center().at(turn) + to_line;
    let along = normal.left();
    let place = |p: Point| along.dot(p - foot);
    let (from, to) = (place(line.start.at(turn)), place(line.end.at(turn)));
    let slack = way + MARGIN * r * beside;
    spans(from, to, slack) && holds(circle, to_line, theta, beside)
}

/// Whether zero is between two places, or not much beyond.
fn spans(from: f64, to: f64, slack: f64) -> bool {
    from.min(to) <= slack && -slack <= from.max(to)
}

/// Whether a circle's curve, or what is at most some angle beyond its ends, lies from its centre in a direction.
fn holds(circle: &Sheet, direction: Vector, theta: f64, beside: f64) -> bool {
    let (from, to) = (circle.start_angle.at(theta), circle.end_angle.at(theta));
    let normal = (direction * circle.radius.signum()).angle();
    let off = wrap(normal - 0.5 * (from + to)).abs();
    off <= 0.5 * (to - from).abs() + beside
}
