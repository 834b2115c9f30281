//! Search along a motion for the first root of a contact function that is on its patch.

use core::f64::consts::TAU;

use crate::feature::tolerance::{GROWTH, NARROWEST_BAND};
use crate::ids::PatchId;
use crate::number::{Ball, Dual, Real, halved};
use crate::space::{ContactSpace, Patch};

use super::Classification;
use super::path::Path;
use super::swept::{Orientations, Swept};

/// Distance from a curve below which a position is on it (length of the pair's frame): the resolution of a space.
const ON_CURVE: f64 = 8.0 * GROWTH;
/// Depth in blocked space at which a motion from contact is stopped (length of the pair's frame).
const DEPTH: f64 = 2.0 * ON_CURVE;
/// Distance beyond an end of a patch within which a root at that depth is accepted (length of the pair's frame): there the answer is
/// checked.
const BESIDE: f64 = 64.0 * ON_CURVE;
/// Rounding of orientations of patches, after a turn (radians).
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Extension of the intervals of patches at both ends (radians): critical orientations are known to this, and a pocket may close in
/// between.
const SEAM: f64 = NARROWEST_BAND;
/// Largest speed of a curve and its ends where nothing is singular (length of the pair's frame per radian).
const SPEED: f64 = 4.0;
/// Length of a motion up to which only the patches near it are looked up (length of the pair's frame, and radians).
const SHORT: f64 = 0.25;
/// Displacement and turn below which an interval of time is not halved (length of the pair's frame, and radians).
const NARROWEST: f64 = 1e-13;

/// The search along one motion.
pub(super) struct Search<'a> {
    space: &'a ContactSpace,
    path: Path,
    /// Whether the motion begins in contact: then roots are searched at [`DEPTH`].
    from_contact: bool,
    /// Length of an interval of time below which it is not halved.
    narrowest: f64,
}

/// The first contact found so far.
type Best = Option<Touch>;

/// A contact along the motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    /// Time from which it is certain: where the motion touches, or is at [`DEPTH`].
    known: f64,
    /// Time at which the motion comes to the patch.
    pub(super) time: f64,
    pub(super) patch: PatchId,
}

/// A patch along the motion; the motion's orientations exceed the patch's own by `turn`.
struct Along<'a> {
    index: PatchId,
    patch: &'a Patch,
    turn: f64,
}

impl<'a> Search<'a> {
    pub(super) fn new(space: &'a ContactSpace, path: Path, from_contact: bool) -> Self {
        let speed = path.speed().max(path.turning.abs());
        Self {
            space,
            path,
            from_contact,
            narrowest: NARROWEST / speed.max(f64::MIN_POSITIVE),
        }
    }

    /// The first contact at a time from 0 to `end`, while the orientation is known.
    pub(super) fn first(&self, end: f64) -> Best {
        let (lo, hi) = self.path.times_in_reach(end)?;
        let known = hi.min(self.path.time_known());
        if known < lo {
            return None;
        }
        self.path
            .pieces(lo, known)
            .find_map(|(lo, hi)| self.first_between(lo, hi))
            .or_else(|| self.squeezed_in(known))
    }

    /// All contacts that the motion crosses up to `end`: time, patch, and whether it enters blocked space there.
    pub(super) fn all(&self, end: f64) -> Vec<(f64, PatchId, bool)> {
        let Some((lo, hi)) = self.path.times_in_reach(end) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for (lo, hi) in self.path.pieces(lo, hi) {
            for (index, patch) in (0..).map(PatchId).zip(&self.space.data.patches) {
                self.presences(patch, lo, hi, |turn, from, to| {
                    let along = Along { index, patch, turn };
                    self.all_of(&along, from, to, &mut found);
                });
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // A contact at the boundary of two pieces of time is found in both.
        let same = |a: &mut (f64, PatchId, bool), b: &mut (f64, PatchId, bool)| {
            (a.1, a.2) == (b.1, b.2) && a.0 - b.0 <= 4.0 * self.narrowest
        };
        found.dedup_by(same);
        found
    }

    /// Finds every contact with one patch: after each contact the search continues behind it.
    fn all_of(
        &self,
        along: &Along<'_>,
        mut lo: f64,
        hi: f64,
        found: &mut Vec<(f64, PatchId, bool)>,
    ) {
        loop {
            let mut best: Best = None;
            self.search(along, lo, hi, &mut best);
            let Some(touch) = best else {
                return;
            };
            let rate = self.function(along, Ball::constant(touch.time)).slope[0].mid;
            found.push((touch.time, along.index, rate < 0.0));
            // Where the motion is tangent to the contact, it stays near for a while: this is one contact.
            let mut step = 4.0 * self.narrowest;
            while self
                .function(along, Ball::constant(touch.time + step))
                .value
                .sign()
                == 0
            {
                step *= 2.0;
                if touch.time + step >= hi {
                    return;
                }
            }
            lo = touch.time + step;
            if lo >= hi {
                return;
            }
        }
    }

    /// Fallback for a motion that starts in contact and ends blocked without crossing any patch: it entered a notch so narrow that its
    /// sides end before either is passed at [`DEPTH`]. Returns the last unblocked time, found by bisection, and the nearest patch.
    fn squeezed_in(&self, end: f64) -> Best {
        if !self.from_contact || !self.is_blocked(end) {
            return None;
        }
        let time = self.last_not_blocked(end);
        let nearest = self.space.nearest_contact(self.path.outer_at(time))?;
        Some(Touch {
            known: end,
            time,
            patch: nearest.patch,
        })
    }

    /// A time just after which, to rounding, the motion is blocked, before a time at which it is blocked.
    fn last_not_blocked(&self, blocked: f64) -> f64 {
        self.bisect(0.0, blocked, |t| self.is_blocked(t)).0
    }

    /// Halves an interval down to the narrowest, towards the time at which `is_upper` becomes true.
    fn bisect(&self, lo: f64, hi: f64, is_upper: impl Fn(f64) -> bool) -> (f64, f64) {
        halved((lo, hi), self.narrowest, |t| !is_upper(t))
    }

    fn first_between(&self, lo: f64, hi: f64) -> Best {
        let mut all: Vec<(f64, f64, Along<'_>)> = Vec::new();
        for index in self.near_between(lo, hi) {
            let index = PatchId(index);
            let patch = &self.space.data.patches[index.index()];
            self.presences(patch, lo, hi, |turn, from, to| {
                let along = Along { index, patch, turn };
                all.push((from, to, along));
            });
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.index.cmp(&b.2.index)));
        let mut best: Best = None;
        for (from, to, along) in &all {
            if best.is_some_and(|b| b.known < *from) {
                break;
            }
            self.search(along, *from, *to, &mut best);
        }
        best
    }

    /// A list, in ascending order, that includes all patches that the motion may touch between two times: for a short motion, the few near
    /// it.
    fn near_between(&self, lo: f64, hi: f64) -> Vec<u32> {
        let all = || (0..self.space.data.patches.len() as u32).collect();
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let (moves, wide) = (self.path.speed() * half, self.path.turning.abs() * half);
        if moves.max(wide) > SHORT {
            return all();
        }
        let (p, theta) = (self.path.inner_at(mid), self.path.theta(mid));
        let beyond = SEAM + ROUNDING * theta.abs();
        let reach = moves + SPEED * beyond + self.near();
        (self.space.around(p, theta, reach, wide + beyond)).unwrap_or_else(all)
    }

    /// Calls `with` for every whole turn by which a patch coincides with the motion between two times: the turn, and the times.
    fn presences(&self, patch: &Patch, lo: f64, hi: f64, mut with: impl FnMut(f64, f64, f64)) {
        let (a, b) = (self.path.theta(lo), self.path.theta(hi));
        let (least, most) = (a.min(b), a.max(b));
        let seam = SEAM + ROUNDING * least.abs().max(most.abs());
        let (first, last) = if self.space.data.window.full_turn {
            let turns = |x: f64| x / TAU;
            (
                turns(least - patch.hi - seam).ceil(),
                turns(most - patch.lo + seam).floor(),
            )
        } else {
            (0.0, 0.0)
        };
        let mut k = first;
        while k <= last {
            let turn = k * TAU;
            let (begin, end) = (patch.lo + turn - seam, patch.hi + turn + seam);
            if begin <= most && end >= least {
                if self.path.turning == 0.0 {
                    with(turn, lo, hi);
                } else {
                    let at = |theta: f64| lo + (theta - a) / self.path.turning;
                    let (s, t) = (at(begin), at(end));
                    with(turn, s.min(t).max(lo), s.max(t).min(hi));
                }
            }
            k += 1.0;
        }
    }

    /// Searches for a root between two times, the earlier half first, and keeps it if it is the first.
    fn search(&self, along: &Along<'_>, lo: f64, hi: f64, best: &mut Best) {
        if best.is_some_and(|b| b.known <= lo) {
            return;
        }
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let f = self.function(along, Ball::between(lo, hi));
        if f.value.sign() != 0 {
            return;
        }
        let at = self.function(along, Ball::constant(mid)).value;
        // By the mean value theorem, f is within |f′| · half of its value in the middle.
        let rise = (f.slope[0].mid.abs() + f.slope[0].radius) * half;
        if at.mid.abs() > at.radius + rise || self.is_away(along, mid, half) {
            return;
        }
        let sign = f.slope[0].sign();
        if sign != 0 {
            self.alone(along, (lo, hi), sign, best);
        } else if self.is_narrow(lo, mid, hi) {
            self.accept(along, lo, hi, best);
        } else {
            self.search(along, lo, mid, best);
            self.search(along, mid, hi, best);
        }
    }

    /// Whether the position is off the curves of the patch at all times mid − half to mid + half.
    fn is_away(&self, along: &Along<'_>, mid: f64, half: f64) -> bool {
        let (theta, wide, beyond) = self.within(along, mid, half);
        let swept = Swept::new(along.patch, &Orientations::about(theta, wide));
        let moves = self.path.speed() * half + SPEED * beyond;
        swept.is_away(self.path.inner_at(mid), moves + self.near())
    }

    /// Distance from a curve within which a position counts as on it.
    fn near(&self) -> f64 {
        self.space.data.frame.rounding() + if self.from_contact { BESIDE } else { ON_CURVE }
    }

    /// The orientations of the patch about a time: the middle, half their range, and the distance of the orientation from the patch's
    /// interval.
    fn within(&self, along: &Along<'_>, mid: f64, half: f64) -> (f64, f64, f64) {
        let theta = self.path.theta(mid) - along.turn;
        let wide = self.path.turning.abs() * half + ROUNDING;
        let clamp = |t: f64| t.clamp(along.patch.lo, along.patch.hi);
        let (a, b) = (clamp(theta - wide), clamp(theta + wide));
        (0.5 * (a + b), 0.5 * (b - a), (theta - clamp(theta)).abs())
    }

    /// The contact function of a patch over an interval of time, with its derivative by time, plus the depth at which contact is sought.
    ///
    /// For a circle it is (|v|² − r²) / 2 |r|, which needs no square root.
    fn function(&self, along: &Along<'_>, t: Ball) -> Dual<1, Ball> {
        let (turn, p) = self.path.enclosed(t);
        let depth = Dual::constant(if self.from_contact { DEPTH } else { 0.0 });
        let cycle = along.patch.function.cycle(turn);
        cycle.level(p) / cycle.size + depth
    }

    /// Narrows down the only possible root of f, which is monotonous.
    fn alone(&self, along: &Along<'_>, (mut lo, mut hi): (f64, f64), sign: i8, best: &mut Best) {
        let value = |t: f64| self.function(along, Ball::constant(t)).value;
        let sign_at = |t: f64| value(t).sign() * sign;
        // For a motion that may be deep in blocked space, only entries count.
        if self.from_contact && sign > 0 {
            return;
        }
        // If f increases: negative below the root, positive above it.
        if sign_at(lo) > 0 || sign_at(hi) < 0 {
            return;
        }
        // Halves down to the narrowest, or until rounding hides the sign; then moves both ends there.
        loop {
            let mid = 0.5 * (lo + hi);
            if self.is_narrow(lo, mid, hi) {
                break;
            }
            match sign_at(mid) {
                1 => hi = mid,
                -1 => lo = mid,
                _ => {
                    lo = self.bisect(lo, mid, |t| sign_at(t) >= 0).0;
                    hi = self.bisect(mid, hi, |t| sign_at(t) > 0).1;
                    break;
                }
            }
        }
        self.accept(along, lo, hi, best);
    }

    /// Whether an interval of time is too short to be halved, or contains no other number.
    fn is_narrow(&self, lo: f64, mid: f64, hi: f64) -> bool {
        hi - lo <= self.narrowest || mid <= lo || mid >= hi
    }

    /// Accepts as a contact the first time of an interval in which f cannot be distinguished from zero, if the position is on the patch
    /// then.
    fn accept(&self, along: &Along<'_>, lo: f64, hi: f64, best: &mut Best) {
        let (time, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        if best.is_some_and(|b| b.known <= time) {
            return;
        }
        let frame = &self.space.data.frame;
        let (theta, wide, beyond) = self.within(along, time, half);
        let curve = self.space.surface().curve(along.patch, theta);
        let p = frame.outer_from_inner(self.path.inner_at(time), theta);
        let off = curve.nearest(p.position()).distance(p.position()) * frame.scale;
        // Displacement of the position, and of the curve with its ends, within the uncertainty of time and orientation.
        let swept = Swept::new(along.patch, &Orientations::about(theta, wide));
        let moved = self.path.speed() * half + SPEED * beyond;
        let uncertain = moved + swept.spread + swept.slack;
        if off > self.near() + uncertain {
            return;
        }
        if uncertain > self.near() && !self.is_narrow(lo, time, hi) {
            self.accept(along, lo, time, best);
            self.accept(along, time, hi, best);
            return;
        }
        if !self.from_contact || self.is_blocked(time) {
            *best = Some(Touch {
                known: time,
                time: if self.from_contact {
                    self.came(along, time)
                } else {
                    time
                },
                patch: along.index,
            });
        }
    }

    fn is_blocked(&self, time: f64) -> bool {
        let class = self.space.classify(self.path.outer_at(time));
        class == Some(Classification::Blocked)
    }

    /// Time at which a motion that began in contact, and is deep in blocked space at `deep`, came to the patch: the last root of the
    /// contact function after it was clear of the patch; 0 if it never was.
    fn came(&self, along: &Along<'_>, deep: f64) -> f64 {
        let value = |t: f64| {
            let p = self.path.inner_at(t);
            along.patch.function.value(p, self.path.theta(t))
        };
        let (mut lo, mut hi) = (0.0, deep);
        // Goes backwards by doubling steps to a time at which it was clear of the patch.
        let mut step = self.narrowest.max(deep * f64::EPSILON);
        loop {
            let t = deep - step;
            if t <= 0.0 {
                let start = value(0.0);
                if start > ON_CURVE {
                    break;
                }
                // The motion was in contact with this patch all the time, or with others first.
                return if start >= -DEPTH {
                    0.0
                } else {
                    self.last_not_blocked(deep)
                };
            }
            if value(t) > ON_CURVE {
                lo = t;
                break;
            }
            hi = t;
            step *= 2.0;
        }
        self.bisect(lo, hi, |t| value(t) <= 0.0).1
    }
}
