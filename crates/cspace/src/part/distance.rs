//! Distance of two parts.

use crate::geometry::{Configuration, Point, Rotation};

use super::{Edge, Part};

/// Minimum distance of the boundaries of two parts that do not overlap, the moving one placed in the fixed one's frame, in the model's unit
/// of length.
///
/// For any two edges the minimum is between an end of one and the other, or along a line at right angles to both. Pairs of edges whose
/// discs are farther apart than the minimum found so far are skipped.
pub(crate) fn distance_of(fixed: &Part, moving: &Part, moving_at: Configuration) -> f64 {
    let turn = Rotation::by(moving_at.theta);
    let place = |p: Point| turn * p + moving_at.position().to_vector();
    let with_disc = |e: Edge| (e, e.disc());
    let first: Vec<_> = fixed.edges().map(with_disc).collect();
    let second: Vec<_> = moving.edges().map(|e| with_disc(e.placed(place))).collect();
    let mut least = f64::INFINITY;
    for (a, (p, r)) in &first {
        for (b, (q, s)) in &second {
            if p.distance(*q) - r - s < least {
                least = least.min(between(a, b));
            }
        }
    }
    least
}

/// The distance of two edges that do not cross.
fn between(a: &Edge, b: &Edge) -> f64 {
    let ends = [
        b.distance(a.start),
        b.distance(a.end),
        a.distance(b.start),
        a.distance(b.end),
    ];
    let right_angles = normals(a, b).into_iter().flatten().map(|p| b.distance(p));
    let other_way = normals(b, a).into_iter().flatten().map(|p| a.distance(p));
    (ends.into_iter().chain(right_angles).chain(other_way)).fold(f64::INFINITY, f64::min)
}

/// The places of an arc whose normals meet another edge's line or circle at right angles; none for a line.
fn normals(arc: &Edge, other: &Edge) -> [Option<Point>; 2] {
    if arc.is_line() {
        return [None; 2];
    }
    if other.is_line() {
        let along = other.start_direction();
        return [along, -along].map(|d| arc.fraction_heading(d).map(|u| arc.at(u)));
    }
    // Towards the other centre, and away from it.
    let (center, to) = (arc.center(), other.center());
    [arc.foot(to), arc.foot(center + (center - to))]
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

    /// The distance agrees with that of many points of both boundaries, up to the steps between them.
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
