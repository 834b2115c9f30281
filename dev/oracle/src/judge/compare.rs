//! Two boundaries in one frame.

use super::curve::Mark;
use super::outline::Outline;
use super::plane::Place;
use super::real::Real;

/// Relation of two boundaries.
#[derive(Debug)]
pub(super) struct Finding {
    /// Whether the boundaries meet.
    pub(super) meeting: bool,
    /// The distance between them, if they do not meet.
    pub(super) clearance: f64,
    /// Largest depth found of a boundary point of one part inside the other; 0 if there is none.
    pub(super) depth: f64,
    /// Points, with a normal there, of stretches that belong to both boundaries.
    pub(super) shared: Vec<(Place<f64>, Place<f64>)>,
}

/// Cuts at which a curve is split: by curve, then along it.
type Cuts<S> = Vec<(usize, Mark<S>)>;

/// Finds the distance of the boundaries, or how deep a point of one is inside the other.
///
/// `slack` bounds the rounding errors of doubles here, and a depth much above it is enough. `thorough` is for numbers
/// better than doubles, when doubles have found no point as deep as that: only the curves near the other boundary are
/// looked at, at more points, and shared stretches are noted.
pub(super) fn compare<S: Real>(
    a: &Outline<S>,
    b: &Outline<S>,
    slack: f64,
    size: f64,
    thorough: bool,
) -> Finding {
    let mut cuts: [Cuts<S>; 2] = [Vec::new(), Vec::new()];
    let mut clearance = f64::INFINITY;
    let mut meeting = false;
    // Pairs of curves whose boxes are farther from each other than this do not matter.
    let mut reach = least_vertex_distance(a, b) + slack;
    let tie = 1e-9 * size;
    for (i, p) in a.curves.iter().enumerate() {
        let frame = a.frames[i];
        if frame.distance_squared(&b.frame) > reach * reach {
            continue;
        }
        for (j, other) in b.frames.iter().enumerate() {
            let gap = frame.distance_squared(other);
            if gap > reach * reach {
                continue;
            }
            let q = &b.curves[j];
            let mut met = false;
            if gap <= slack * slack {
                p.meet(q, |x| {
                    met = true;
                    cuts[0].push((i, p.mark(x)));
                    cuts[1].push((j, q.mark(x)));
                });
                if thorough {
                    for x in [q.start, q.end] {
                        let (foot, distance) = p.nearest(x);
                        if distance.to_f64() < tie {
                            cuts[0].push((i, p.mark(foot)));
                        }
                    }
                    for x in [p.start, p.end] {
                        let (foot, distance) = q.nearest(x);
                        if distance.to_f64() < tie {
                            cuts[1].push((j, q.mark(foot)));
                        }
                    }
                }
            }
            if met {
                meeting = true;
                reach = slack;
            } else if thorough || !meeting {
                let distance = p.distance(q).to_f64();
                clearance = clearance.min(distance);
                if thorough && distance < tie {
                    // A cut where the curves begin, to say that they matter.
                    cuts[0].push((i, p.ends()[0]));
                    cuts[1].push((j, q.ends()[0]));
                }
                if !meeting {
                    reach = reach.min(clearance + slack);
                }
            }
        }
    }
    let mut found = Finding {
        meeting,
        clearance,
        depth: 0.0,
        shared: Vec::new(),
    };
    if !meeting && clearance > slack {
        // Each loop is wholly inside or outside the other part.
        let inside = |a: &Outline<S>, b: &Outline<S>| {
            a.loops.iter().any(|&first| {
                let p = a.curves[first].start;
                let r = p.rough();
                r.x >= b.frame.low[0] - slack
                    && r.x <= b.frame.high[0] + slack
                    && r.y >= b.frame.low[1] - slack
                    && r.y <= b.frame.high[1] + slack
                    && b.holds(p, slack)
            })
        };
        if inside(a, b) || inside(b, a) {
            found.depth = clearance;
        }
        return found;
    }
    let enough = if thorough { 100.0 * slack } else { 1e-3 * size };
    let [mut cut_a, mut cut_b] = cuts;
    for cuts in [&mut cut_a, &mut cut_b] {
        cuts.sort_by(|x, y| {
            x.0.cmp(&y.0).then(
                x.1.0
                    .partial_cmp(&y.1.0)
                    .unwrap_or(core::cmp::Ordering::Equal),
            )
        });
    }
    let mut search = Search {
        slack,
        enough,
        thorough,
        touching: 1e-15 * size,
        found: &mut found,
    };
    // The cut curves first: there something will be inside if anything is.
    let _ = search.pieces(a, b, &cut_a, true)
        || search.pieces(b, a, &cut_b, true)
        || thorough
        || search.found.depth > slack
        || search.pieces(a, b, &cut_a, false)
        || search.pieces(b, a, &cut_b, false);
    found
}

struct Search<'a> {
    slack: f64,
    enough: f64,
    thorough: bool,
    touching: f64,
    found: &'a mut Finding,
}

impl Search<'_> {
    /// Tries a point of each piece of the curves of `a` that are cut, or of those that are not.
    /// Whether it found enough.
    fn pieces<S: Real>(
        &mut self,
        a: &Outline<S>,
        b: &Outline<S>,
        cuts: &Cuts<S>,
        cut: bool,
    ) -> bool {
        let mut next = 0;
        for (i, curve) in a.curves.iter().enumerate() {
            let first = next;
            while next < cuts.len() && cuts[next].0 == i {
                next += 1;
            }
            if (next > first) != cut {
                continue;
            }
            let [mut from, end] = curve.ends();
            let ends = cuts[first..next].iter().map(|c| c.1);
            for to in ends.chain([end]) {
                let middle = curve.between(from, to);
                if self.point(b, middle.1)
                    || !cut && self.point(b, curve.start)
                    || self.thorough
                        && (self.point(b, curve.between(from, middle).1)
                            || self.point(b, curve.between(middle, to).1))
                {
                    return true;
                }
                if self.thorough
                    && (to.1 - from.1).length().to_f64() > self.slack
                    && b.distance(middle.1, self.slack) <= self.touching
                {
                    self.found
                        .shared
                        .push((middle.1.rough(), curve.normal(middle.1).rough()));
                }
                from = to;
            }
        }
        false
    }

    /// Tries one point.
    fn point<S: Real>(&mut self, b: &Outline<S>, p: Place<S>) -> bool {
        if b.holds(p, self.slack) {
            self.found.depth = self.found.depth.max(b.distance(p, self.slack));
        }
        self.found.depth > self.enough
    }
}

/// Depth inside one part of some point that is inside both, searched on both sides of a boundary point of both.
pub(super) fn overlap_beside<S: Real>(
    a: &Outline<S>,
    b: &Outline<S>,
    p: Place<f64>,
    normal: Place<f64>,
    size: f64,
    trust: f64,
) -> f64 {
    let mut best = 0.0_f64;
    let mut step = 0.25 * size;
    while step > 2.0 * trust {
        for side in [step, -step] {
            let q = p + normal.times(side);
            let q = Place::new(S::of(q.x), S::of(q.y));
            if a.holds(q, trust) && b.holds(q, trust) {
                let (d, e) = (a.distance(q, 0.0), b.distance(q, 0.0));
                if d.min(e) > trust {
                    best = best.max(d.max(e));
                }
            }
        }
        if best > 0.0 {
            break;
        }
        step *= 0.1;
    }
    best
}

fn least_vertex_distance<S: Real>(a: &Outline<S>, b: &Outline<S>) -> f64 {
    let ends: Vec<Place<f64>> = b.curves.iter().map(|c| c.start.rough()).collect();
    let mut best = f64::INFINITY;
    for p in &a.curves {
        let p = p.start.rough();
        for q in &ends {
            let (x, y) = (p.x - q.x, p.y - q.y);
            best = best.min(x * x + y * y);
        }
    }
    best.sqrt()
}
