//! Points about which a part may turn along curved walls: centres of its arcs that fit arcs of the other part.

use cspace::{Configuration, Part, Vector};

/// So many points are proposed.
const MOST: usize = 2;
/// Arcs fit if their radii differ by less than this share.
const FITS: f64 = 0.1;
/// And none farther from the part than so many of its sizes: turning about it is hardly a turn.
const FAR: f64 = 16.0;
/// Centres that are as near as this share of the part's size are one.
const SAME: f64 = 1e-6;

/// The centres of arcs of the moving part, in its frame, about whose radii the fixed part has arcs: those of the longest arcs first.
pub(crate) fn fitting_centers(fixed: &Part, moving: &Part) -> Vec<Vector> {
    let same = SAME * moving.size();
    let mut found: Vec<(Vector, f64)> = Vec::new();
    for arc in moving.edges().filter(|e| !e.is_line()) {
        let (center, radius) = (arc.center().to_vector(), arc.radius());
        if is_far(moving, center) {
            continue;
        }
        let fits = |r: f64| (r - radius).abs() < FITS * r.max(radius);
        if !(fixed.edges()).any(|e| !e.is_line() && fits(e.radius())) {
            continue;
        }
        let known = found.iter_mut().find(|f| (f.0 - center).length() < same);
        match known {
            Some(known) => known.1 += arc.length(),
            None => found.push((center, arc.length())),
        }
    }
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    found.iter().map(|f| f.0).take(MOST).collect()
}

/// The point of the moving part, in its frame, that is at the same place in two configurations: (R(θ₂) − R(θ₁)) p = t₁ − t₂. None if the
/// orientations are the same, or that point is far from the part.
pub(crate) fn still_point(moving: &Part, a: Configuration, b: Configuration) -> Option<Vector> {
    let by = Vector::from_angle(b.theta) - Vector::from_angle(a.theta);
    let to = a.position() - b.position();
    // Division of complex numbers.
    let point = Vector::new(by.dot(to), by.cross(to)) * (1.0 / by.dot(by));
    let is_near = point.x.is_finite() && point.y.is_finite() && !is_far(moving, point);
    is_near.then_some(point)
}

fn is_far(part: &Part, point: Vector) -> bool {
    (point - part.bounds().center().to_vector()).length() > FAR * part.size()
}
