//! How much of a part's outline lies flush on walls.

use cspace::{Configuration, Edge, Part};

/// The length of a part's outline, at a configuration, that is no farther from the walls than a touching distance on a stretch where lines
/// lie on lines, or arcs in arcs of the same radius.
pub(super) fn length(walls: &[Edge], moving: &Part, at: Configuration, touch: f64) -> f64 {
    let mut sum = 0.0;
    for own in moving.edges() {
        let own = own.placed(|p| at.fixed_from_moving(p));
        for wall in walls {
            sum += match own.is_line() && wall.is_line() {
                true => of_lines(own, *wall, touch),
                false => of_arcs(own, *wall, touch),
            };
        }
    }
    sum
}

/// The length that two lines in opposite directions share, seen along the wall, if both ends of that stretch are on the wall.
fn of_lines(own: Edge, wall: Edge, touch: f64) -> f64 {
    let along = (wall.end - wall.start).unit();
    let place = |p| along.dot(p - wall.start);
    let (from, to) = (place(own.end), place(own.start));
    let (lo, hi) = (from.max(0.0), to.min(wall.length()));
    if hi - lo <= touch {
        return 0.0;
    }
    let off =
        |at: f64| along.cross(own.end.lerp(own.start, (at - from) / (to - from)) - wall.start);
    match off(lo).abs() <= touch && off(hi).abs() <= touch {
        true => hi - lo,
        false => 0.0,
    }
}

/// The length of the angle that two arcs about one centre, of opposite radii, both span.
fn of_arcs(own: Edge, wall: Edge, touch: f64) -> f64 {
    use core::f64::consts::TAU;
    let (r, s) = (own.signed_radius(), wall.signed_radius());
    // Of a line neither is finite.
    if !((r + s).abs() <= touch && own.center().distance(wall.center()) <= touch) {
        return 0.0;
    }
    // Counter-clockwise from its first end.
    let span = |edge: Edge| {
        let first = if edge.bulge > 0.0 {
            edge.start
        } else {
            edge.end
        };
        ((first - edge.center()).angle(), edge.sweep().abs())
    };
    let ((a, of_own), (b, of_wall)) = (span(own), span(wall));
    let begins = (b - a).rem_euclid(TAU);
    // The other may begin in the one, and reach beyond a turn into its beginning.
    let shared = |begins: f64| (of_own.min(begins + of_wall) - begins.max(0.0)).max(0.0);
    let length = r.abs() * (shared(begins) + shared(begins - TAU));
    if length <= touch { 0.0 } else { length }
}
