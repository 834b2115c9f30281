//! Checks by `parry2d` in double precision: a part is the polyline of its boundary in a tree of boxes. Where boundaries
//! do not meet, one part may be within the other, which is tested for a corner of each loop by the even-odd rule. Arcs
//! become chords.

use std::time::Instant;

use cspace::{Configuration, Part};
use parry2d_f64::math::{Pose, Vector as V};
use parry2d_f64::query::intersection_test;
use parry2d_f64::shape::Polyline;

use super::Checker;
use crate::models::Pair;
use crate::polygons::rings;
use crate::stack::CHORD;

/// A part as polygons.
pub(crate) struct Polygons {
    loops: Vec<Vec<V>>,
    lines: Polyline,
}

impl Polygons {
    pub(crate) fn new(part: &Part, chord: f64) -> Self {
        let loops: Vec<Vec<V>> = (rings(part, chord).iter())
            .map(|r| r.iter().map(|p| V::new(p.x, p.y)).collect())
            .collect();
        let mut indices = Vec::new();
        let mut first = 0;
        for l in &loops {
            let n = l.len() as u32;
            indices.extend((0..n).map(|k| [first + k, first + (k + 1) % n]));
            first += n;
        }
        let lines = Polyline::new(loops.concat(), Some(indices));
        Self { loops, lines }
    }

    /// Whether a point is in the material: a ray to the right crosses the boundary an odd number of times.
    fn contains(&self, p: V) -> bool {
        let mut inside = false;
        for l in &self.loops {
            for (i, a) in l.iter().enumerate() {
                let b = l[(i + 1) % l.len()];
                if (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
                {
                    inside = !inside;
                }
            }
        }
        inside
    }

    /// Whether two placed parts overlap; `None` if the library has no answer.
    pub(crate) fn overlaps(&self, at: &Pose, other: &Self, bt: &Pose) -> Option<bool> {
        let meets = intersection_test(at, &self.lines, bt, &other.lines).ok()?;
        Some(meets.intersecting || self.holds(at, other, bt) || other.holds(bt, self, at))
    }

    /// Whether a loop of the other part, not meeting this boundary, is within the material.
    fn holds(&self, at: &Pose, other: &Self, bt: &Pose) -> bool {
        let own = |p: V| at.inverse_transform_point(bt.transform_point(p));
        other.loops.iter().any(|l| self.contains(own(l[0])))
    }
}

pub(super) fn checker(pair: &Pair) -> Checker<'static> {
    let begin = Instant::now();
    let chord = CHORD * pair.fixed.size().max(pair.moving.size());
    let (a, b) = (
        Polygons::new(&pair.fixed, chord),
        Polygons::new(&pair.moving, chord),
    );
    let prepared_seconds = begin.elapsed().as_secs_f64();
    let overlaps = move |c: Configuration| {
        a.overlaps(&Pose::IDENTITY, &b, &Pose::new(V::new(c.x, c.y), c.theta))
    };
    Checker {
        name: "parry2d",
        prepared_seconds,
        overlaps: Box::new(overlaps),
    }
}
