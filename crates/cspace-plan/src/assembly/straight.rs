//! Straight ways out: what a designer expects where there is one.

use cspace::{Configuration, Coordinates, Part, Vector};

use crate::answer::Path;
use crate::check::{Checked, check};
use crate::legs::Scene;

/// So many directions are tried, those of the longest lines first.
const MOST: usize = 64;
/// Directions that differ by less are the same: sines of angles.
const SAME: f64 = 1e-9;

/// The shortest of the straight ways out along the lines of either part, across them and along the axes; `None` if none of
/// them is free. `far` says how far it is until the parts are apart in a direction.
pub(super) fn straight(
    (fixed, moving): (&Part, &Part),
    far: impl Fn(Vector) -> f64,
) -> Option<Path> {
    let scene = Scene::new(fixed, moving, None);
    let mut ways: Vec<(f64, Vector)> = directions(fixed, moving)
        .into_iter()
        .map(|d| (far(d), d))
        .collect();
    ways.sort_by(|a, b| a.0.total_cmp(&b.0));
    ways.into_iter().find_map(|(by, direction)| {
        let to = direction * by;
        let path = [
            Coordinates::Planar(Configuration::default()),
            Coordinates::Planar(Configuration::new(to.x, to.y, 0.0)),
        ];
        match check(&scene, &path) {
            Ok(Checked::Free(narrowest)) if narrowest.clearance > 0.0 => Some(Path {
                configurations: path.to_vec(),
                narrowest,
            }),
            _ => None,
        }
    })
}

fn directions(fixed: &Part, moving: &Part) -> Vec<Vector> {
    let mut lines: Vec<(f64, Vector)> = (fixed.edges().chain(moving.edges()))
        .filter(|e| e.is_line())
        .map(|e| {
            let chord = e.end - e.start;
            (chord.length(), chord.unit())
        })
        .collect();
    lines.sort_by(|a, b| b.0.total_cmp(&a.0));
    let axes = [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)];
    let mut found: Vec<Vector> = Vec::new();
    for direction in axes.into_iter().chain(lines.into_iter().map(|l| l.1)) {
        for d in [direction, -direction, direction.left(), -direction.left()] {
            let known = |f: &Vector| f.cross(d).abs() < SAME && f.dot(d) > 0.0;
            if found.len() < MOST && !found.iter().any(known) {
                found.push(d);
            }
        }
    }
    found
}
