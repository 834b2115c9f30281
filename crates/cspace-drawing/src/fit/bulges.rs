//! The arcs between two points that pass other points within a distance.

use cspace::Point;

use super::run::Run;

/// Arcs sweep at most 225 degrees: this is tan(225°/4). A circle needs two.
const MOST: f64 = 1.496_605_762_665_489;

/// Bulge of the arc from p to q through a point: tan(φ / 2), where φ is the angle by which the polyline p, point, q
/// turns.
pub(super) fn bulge_through(p: Point, at: Point, q: Point) -> f64 {
    let (a, b) = (at - p, q - at);
    let (cross, dot) = (a.cross(b), a.dot(b));
    let lengths = (a.length_squared() * b.length_squared()).sqrt();
    let below = lengths + dot;
    if below > 0.0 {
        cross / below
    } else {
        cross.signum() * f64::INFINITY
    }
}

/// Samples at which arcs are tested, in order: all, or from each block those that are farthest to either side.
#[derive(Debug)]
pub(super) struct Tested {
    samples: Vec<usize>,
    /// The number of samples of a closed run; none of an open one.
    around: Option<usize>,
}

impl Tested {
    /// Selects from every block of samples those that stand out most to either side of the smoothed points, or of the
    /// chord of the block.
    pub(super) fn new(run: &Run, block: usize) -> Self {
        let (n, block) = (run.points.len(), block.max(1));
        let mut samples: Vec<usize> = Vec::new();
        for first in (0..n).step_by(block) {
            let last = (first + block).min(n) - 1;
            let off = |i: usize| match &run.joints {
                Some(joints) => (run.points[i] - joints[i]).dot(run.normals[i]),
                None => 0.0,
            };
            let by_off = |a: &usize, b: &usize| off(*a).total_cmp(&off(*b));
            let mut kept: Vec<usize> =
                [(first..=last).min_by(by_off), (first..=last).max_by(by_off)]
                    .into_iter()
                    .flatten()
                    .collect();
            kept.sort_unstable();
            kept.dedup();
            samples.extend(kept);
        }
        Self {
            samples,
            around: run.is_closed.then_some(n),
        }
    }

    /// Tested samples after one sample and before another, which may be a turn further.
    fn between(&self, from: usize, to: usize) -> impl Iterator<Item = usize> {
        let n = self.around.unwrap_or(usize::MAX);
        let turns = from.checked_div(n).unwrap_or(0);
        let start = from - turns * n;
        let end = to - turns * n;
        let first = self.samples.partition_point(|&s| s <= start);
        let here = self.samples[first..].iter().copied();
        let next = self.samples.iter().map(move |s| s.saturating_add(n));
        here.chain(next)
            .take_while(move |&s| s < end)
            .map(move |s| s + turns * n)
    }
}

/// Bulges of the arcs between two samples that pass the tested samples between them within the band of this half width;
/// `None` if there are none. All arcs between two points are nested, so that each sample allows an interval.
pub(super) fn allowed(
    run: &Run,
    tested: &Tested,
    from: usize,
    to: usize,
    width: f64,
) -> Option<(f64, f64)> {
    let (p, q) = (run.joint(from), run.joint(to));
    let (mut lo, mut hi) = (-MOST, MOST);
    let middle = run.band.middle();
    for i in tested.between(from, to) {
        let (at, normal) = (run.point(i), run.normal(i));
        // Arcs to the left of the way have the lower bulges.
        let low = bulge_through(p, at + normal * (middle + width), q);
        let high = bulge_through(p, at + normal * (middle - width), q);
        if low > high {
            // Next to an end, the band has the end in it: any arc passes there.
            continue;
        }
        (lo, hi) = (lo.max(low), hi.min(high));
        if lo > hi {
            return None;
        }
    }
    Some((lo, hi))
}
