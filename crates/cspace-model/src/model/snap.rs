//! Lines and arcs that all but meet in one direction are made to.

use core::f64::consts::TAU;

use cspace::{Part, Point, Vector, Vertex};

use super::slips::is_nearly_tangent;
use crate::mechanism::Mechanism;

/// Largest displacement of a vertex, as a share of the part's size.
const FARTHEST: f64 = 1e-3;

/// Lines whose directions are so nearly parallel (sine of the angle between) have no corner that could be rounded: between
/// them an arc is half a circle.
const PARALLEL: f64 = 1e-2;

/// Changes made to a part.
#[derive(Debug, Clone, PartialEq)]
pub struct Snapped {
    /// The part.
    pub part: String,
    /// Number of joints of a line and an arc that are tangent now.
    pub joints: usize,
    /// Largest displacement of a point of the outline, in the model's unit.
    pub moved: f64,
}

/// The mechanism with arcs tangent to the lines that they all but continue, and what was done.
///
/// Lines stay on their carriers. An arc between two of them becomes the one of its radius that is tangent to both, and its
/// ends move along the lines; an arc that continues one line alone keeps its ends, and takes the sweep that makes it tangent
/// there. Joints at which a vertex would move by more than a thousandth of the part's size are left, and so is a part whose
/// outline would not be one any more.
///
/// ```
/// let text = "[[part]]\nname = \"slot\"\nloops = [[[0, 0], [10, 0, 0.9999], [10, 4], [0, 4, 1]]]";
/// let model = cspace_model::model::from_toml(text, "slot.toml")?;
/// let (snapped, done) = cspace_model::model::snap(&model);
/// assert_eq!((done[0].joints, cspace_model::model::slips(&snapped).len()), (2, 0));
/// assert_eq!(snapped.parts[0].part.loops()[0].vertices()[1].bulge, 1.0);
/// # Ok::<(), cspace_model::ModelError>(())
/// ```
pub fn snap(mechanism: &Mechanism) -> (Mechanism, Vec<Snapped>) {
    let mut snapped = mechanism.clone();
    let mut done = Vec::new();
    for entry in &mut snapped.parts {
        if let Some((part, what)) = snap_part(&entry.part) {
            entry.part = part;
            done.push(what);
        }
    }
    (snapped, done)
}

fn snap_part(part: &Part) -> Option<(Part, Snapped)> {
    let farthest = FARTHEST * part.size();
    let (mut joints, mut moved) = (0, 0.0f64);
    let loops: Vec<Vec<Vertex>> = (part.loops().iter())
        .map(|l| {
            let old = l.vertices();
            let mut new = old.to_vec();
            for k in 0..old.len() {
                let Some(arc) = tangent(old, k) else {
                    continue;
                };
                let next = (k + 1) % old.len();
                let far = [
                    arc.start.distance(old[k].point()),
                    arc.end.distance(old[next].point()),
                    // The middle of an arc is half a chord times its bulge from the chord.
                    0.5 * old[k].point().distance(old[next].point())
                        * (arc.bulge - old[k].bulge).abs(),
                ];
                let far = far.into_iter().fold(0.0, f64::max);
                if far > farthest || !far.is_finite() {
                    continue;
                }
                (new[k].x, new[k].y, new[k].bulge) = (arc.start.x, arc.start.y, arc.bulge);
                (new[next].x, new[next].y) = (arc.end.x, arc.end.y);
                joints += arc.joints;
                moved = moved.max(far);
            }
            new
        })
        .collect();
    if joints == 0 {
        return None;
    }
    let snapped = part.redrawn(loops).ok()?;
    let what = Snapped {
        part: part.name().to_owned(),
        joints,
        moved,
    };
    Some((snapped, what))
}

/// An arc as it should be.
struct Arc {
    start: Point,
    end: Point,
    bulge: f64,
    /// Number of ends at which it is tangent now, and was not.
    joints: usize,
}

/// The edge that leaves a vertex of a loop, if it is an arc that all but continues a line, tangent to it.
fn tangent(vertices: &[Vertex], k: usize) -> Option<Arc> {
    let n = vertices.len();
    let at = |i: usize| vertices[i % n];
    let (arc, end) = (at(k), at(k + 1).point());
    let start = arc.point();
    if arc.bulge == 0.0 {
        return None;
    }
    let sweep = 4.0 * arc.bulge.atan();
    let chord = end - start;
    let turned = |by: f64| cspace::Rotation::by(by) * chord.unit();
    // Directions of the lines before and after, where these are lines.
    let before = at(k + n - 1);
    let line_before = (before.bulge == 0.0).then(|| (start - before.point()).unit());
    let line_after = (at(k + 1).bulge == 0.0).then(|| (at(k + 2).point() - end).unit());
    let starts = line_before.filter(|d| is_nearly_tangent(*d, turned(-0.5 * sweep)));
    let ends = line_after.filter(|d| is_nearly_tangent(turned(0.5 * sweep), *d));
    // Directions that are tangent already are kept.
    let tangent_at =
        |d: Option<Vector>, of: Vector| d.filter(|d| d.cross(of).abs() < 1e-3 && d.dot(of) > 0.0);
    let both = (
        tangent_at(line_before, turned(-0.5 * sweep)),
        tangent_at(line_after, turned(0.5 * sweep)),
    );
    let joints = usize::from(starts.is_some()) + usize::from(ends.is_some());
    if joints == 0 {
        return None;
    }
    let radius = 0.25 * chord.length() * (1.0 + arc.bulge * arc.bulge) / arc.bulge.abs();
    let (start, end, bulge) = match both {
        (Some(d), Some(e)) if d.cross(e).abs() > PARALLEL => {
            rounded((start, d), (end, e), radius * sweep.signum(), sweep)
        }
        (Some(d), Some(e)) if d.cross(e) == 0.0 && d.dot(e) < 0.0 => {
            // Half a circle, from one line straight across to the other.
            let across = (end - start) - d * (end - start).dot(d);
            (start, start + across, sweep.signum())
        }
        (Some(d), _) => (start, end, half_tangent(d, chord)),
        (None, Some(e)) => (start, end, half_tangent(chord, e)),
        (None, None) => return None,
    };
    Some(Arc {
        start,
        end,
        bulge,
        joints,
    })
}

/// The arc of a signed radius that is tangent to two lines, each by a point and its direction; its bulge is that of the turn
/// nearest to a sweep.
fn rounded(
    (p, d): (Point, Vector),
    (q, e): (Point, Vector),
    radius: f64,
    sweep: f64,
) -> (Point, Point, f64) {
    let left = |v: Vector| Vector::new(-v.y, v.x);
    // The centre is so far to the left of both.
    let (a, b) = (p + left(d) * radius, q + left(e) * radius);
    let center = a + d * ((b - a).cross(e) / d.cross(e));
    let turn = d.cross(e).atan2(d.dot(e));
    let turn = turn + TAU * ((sweep - turn) / TAU).round();
    (
        center - left(d) * radius,
        center - left(e) * radius,
        (0.25 * turn).tan(),
    )
}

/// tan of a quarter of the sweep of an arc whose direction at one end and whose chord are given, in the order of travel: half
/// the sweep is between them.
fn half_tangent(first: Vector, second: Vector) -> f64 {
    (0.5 * first.cross(second).atan2(first.dot(second))).tan()
}
