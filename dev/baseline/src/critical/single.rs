//! Criticalities of one contact: a normal that ends a feature opposes one of the other part.

use cspace::{Point, Rotation, Vector};

use super::contact::Contact;
use super::outline::Facet;
use super::search::{Search, Work};
use super::tolerance::{BEYOND, PARALLEL};

/// Searches criticalities of all facets of one part with all of the other.
pub(super) fn search(search: &mut Search<'_>) -> Option<()> {
    let [fixed, moving] = [search.pair.fixed.facets(), search.pair.moving.facets()];
    search.each(fixed.len() * moving.len(), |work, i| {
        let (a, b) = (&fixed[i / moving.len()], &moving[i % moving.len()]);
        let theta = a.opposes(b);
        if work.is_candidate(theta) && is_somewhere_free(work, a, b, theta) {
            work.realised(theta);
        }
    })
}

/// Whether the parts are free at one of the positions in which the facets touch: these are a segment, which other
/// contacts cut into pieces that are free or blocked as a whole.
fn is_somewhere_free(work: &mut Work<'_>, a: &Facet, b: &Facet, theta: f64) -> bool {
    let turn = Rotation::by(theta);
    let position = |x: Point, y: Point| x - turn * y.to_vector();
    let (from, to) = (position(a.start, b.start), position(a.end, b.end));
    let by = to - from;
    if by.length() <= BEYOND {
        return work.is_apart(from, theta);
    }
    let mut cuts = vec![0.0, 1.0];
    for contact in &work.pair.contacts {
        if contact.span.contains(theta) {
            crossings(work, contact, (from, by), theta, turn, &mut cuts);
        }
    }
    cuts.sort_by(f64::total_cmp);
    (cuts.windows(2)).any(|w| {
        let piece = (w[1] - w[0]) * by.length();
        piece > BEYOND && !work.stopped() && work.is_apart(from + by * (0.5 * (w[0] + w[1])), theta)
    })
}

/// Fractions of the segment at which it crosses a contact's curve.
fn crossings(
    work: &Work<'_>,
    contact: &Contact,
    (from, by): (Point, Vector),
    theta: f64,
    turn: Rotation,
    cuts: &mut Vec<f64>,
) {
    let mut take = |s: f64| {
        if s > 0.0 && s < 1.0 {
            let (fixed, moving) = (&work.pair.fixed, &work.pair.moving);
            if contact.touches(fixed, moving, from + by * s, theta, turn) {
                cuts.push(s);
            }
        }
    };
    let c = &contact.carrier;
    if c.round {
        let [x, y] = c.center().map(|w| w.at(turn));
        let v = Point::new(x, y) - from;
        let along = v.dot(by) / by.length_squared();
        let off = v.cross(by) / by.length();
        let r = c.radius.abs();
        // A circle that the segment just touches cuts it too.
        let half = ((r - off) * (r + off)).max(0.0).sqrt() / by.length();
        take(along - half);
        take(along + half);
    } else {
        let (height, normal, _) = c.distance(from, turn);
        let slope = normal.dot(by);
        if slope.abs() > PARALLEL * by.length() {
            take(-height / slope);
        }
    }
}
