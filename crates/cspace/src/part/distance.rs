//! How far two parts are apart.

use crate::geometry::{Configuration, Point, Rotation, Vector};

use super::{Edge, Part};

/// The least distance of the boundaries of two parts that do not overlap, the moving one placed in the fixed one's frame, in
/// the model's unit of length.
///
/// Of every two edges it is between an end of one and the other, or along a line through the centres of both (of a line, at
/// right angles to it). Pairs of edges whose boxes are farther apart than what was found are passed over.
pub(crate) fn distance_of(fixed: &Part, moving: &Part, moving_at: Configuration) -> f64 {
    let turn = Rotation::by(moving_at.theta);
    let place = |p: Point| turn * p + moving_at.position().to_vector();
    let placed = |e: Edge| Edge {
        start: place(e.start),
        end: place(e.end),
        ..e
    };
    let first: Vec<Piece> = fixed.edges().map(Piece::new).collect();
    let second: Vec<Piece> = moving.edges().map(placed).map(Piece::new).collect();
    let mut least = f64::INFINITY;
    for a in &first {
        for b in &second {
            let apart = a.middle.distance(b.middle) - a.reach - b.reach;
            if apart < least {
                least = least.min(a.distance(b));
            }
        }
    }
    least
}

/// An edge with a disc that holds it.
struct Piece {
    edge: Edge,
    middle: Point,
    reach: f64,
}

impl Piece {
    fn new(edge: Edge) -> Self {
        let half = 0.5 * edge.start.distance(edge.end);
        // Up to a half circle the arc is within half its chord of the chord's middle, a larger one within its sagitta.
        let reach = half * edge.bulge.abs().max(1.0) * (1.0 + 4.0 * f64::EPSILON);
        Self {
            middle: edge.start.midpoint(edge.end),
            reach,
            edge,
        }
    }

    fn distance(&self, other: &Self) -> f64 {
        let (a, b) = (&self.edge, &other.edge);
        let ends = [
            nearest(b, a.start).distance(a.start),
            nearest(b, a.end).distance(a.end),
            nearest(a, b.start).distance(b.start),
            nearest(a, b.end).distance(b.end),
        ];
        let mut least = ends.into_iter().fold(f64::INFINITY, f64::min);
        // Along the line of centres both are met at right angles.
        let mut along = |from: &Edge, to: &Edge, direction: Vector| {
            let center = from.center();
            for way in [1.0, -1.0] {
                let p = center + direction * (way * from.radius());
                if holds(from, p) {
                    least = least.min(nearest(to, p).distance(p));
                }
            }
        };
        match (a.is_line(), b.is_line()) {
            (true, true) => {}
            (true, false) => along(b, a, (a.end - a.start).unit().left()),
            (false, true) => along(a, b, (b.end - b.start).unit().left()),
            (false, false) => {
                let d = b.center() - a.center();
                if d.length() > 0.0 {
                    along(a, b, d.unit());
                }
            }
        }
        least
    }
}

/// Whether a point of an arc's circle is on the arc: beyond its chord, on the side to which it bulges.
fn holds(arc: &Edge, p: Point) -> bool {
    let chord = arc.end - arc.start;
    chord.cross(p - arc.start) * arc.bulge <= 0.0
}

/// The point of an edge nearest to a point.
fn nearest(edge: &Edge, p: Point) -> Point {
    let chord = edge.end - edge.start;
    if edge.is_line() {
        let share = chord.dot(p - edge.start) / chord.length_squared();
        return edge.start.lerp(edge.end, share.clamp(0.0, 1.0));
    }
    let center = edge.center();
    let out = p - center;
    if out.length() > 0.0 {
        let q = center + out.unit() * edge.radius();
        if holds(edge, q) {
            return q;
        }
    }
    if p.distance(edge.start) <= p.distance(edge.end) {
        edge.start
    } else {
        edge.end
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::Vertex;

    fn points(part: &Part, at: Configuration) -> Vec<Point> {
        let on = |e: Edge, s: f64| {
            if e.is_line() {
                return e.start.lerp(e.end, s);
            }
            let c = e.center();
            c + Rotation::by(e.sweep() * s) * (e.start - c)
        };
        let all =
            |e: Edge| (0..=400).map(move |i| at.fixed_from_moving(on(e, f64::from(i) / 400.0)));
        part.edges().flat_map(all).collect()
    }

    /// The distance of many points of both boundaries is as much, but for the steps between them.
    #[test]
    fn it_is_that_of_many_points() {
        let spoon = |x: f64, b: f64| {
            Part::new(
                "spoon",
                vec![vec![
                    Vertex::new(x, 0.0, b),
                    Vertex::new(x + 2.0, 0.3, -0.3),
                    Vertex::new(x + 2.2, 1.5, 0.0),
                    Vertex::new(x + 0.1, 1.2, 0.4),
                ]],
            )
            .unwrap()
        };
        let (a, b) = (spoon(0.0, 0.8), spoon(-0.5, 1.6));
        for k in 0..40 {
            let t = f64::from(k);
            let at = Configuration::new(5.0 * t.cos(), 5.0 * t.sin(), 2.3 * t);
            let exact = distance_of(&a, &b, at);
            let (p, q) = (points(&a, Configuration::default()), points(&b, at));
            let least =
                (p.iter().flat_map(|p| q.iter().map(|q| p.distance(*q)))).fold(9.9, f64::min);
            assert!(
                exact <= least + 1e-12 && least < exact + 0.02,
                "{k}: {exact} {least}"
            );
        }
    }
}
