//! Searching the contact functions along a motion for their first root that is on a patch.

use core::f64::consts::TAU;

use crate::feature::tolerance::{GROWTH, NARROWEST_BAND};
use crate::number::{Ball, Dual, Real, halved};
use crate::space::{ContactSpace, Patch};

use super::classify::Classification;
use super::path::Path;
use super::swept::{Orientations, Swept};

/// Positions nearer than this to a curve are on it (length of the pair's frame): the resolution of a space.
const ON_CURVE: f64 = 8.0 * GROWTH;
/// A motion from contact is stopped where it is as deep as this in blocked space (length of the pair's frame).
const DEPTH: f64 = 2.0 * ON_CURVE;
/// At that depth it may be beyond an end of a patch by this (length of the pair's frame): there the answer is checked.
const BESIDE: f64 = 64.0 * ON_CURVE;
/// Orientations of patches are rounded by this, after a turn (radians).
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Patches are taken to begin earlier and end later by this (radians): critical orientations are known to that, and a pocket may
/// close in between.
const SEAM: f64 = NARROWEST_BAND;
/// How fast a curve and its ends move at most where nothing is singular (length of the pair's frame per radian).
const SPEED: f64 = 4.0;
/// Among all patches those are looked up that a motion is near that is no longer than this (length of the pair's frame, and radians).
const SHORT: f64 = 0.25;
/// Times are halved until neither way nor orientation moves by this (length of the pair's frame, and radians).
const NARROWEST: f64 = 1e-13;

/// The search along one motion.
pub(super) struct Search<'a> {
    space: &'a ContactSpace,
    path: Path,
    /// Whether it begins in contact: then roots are sought at [`DEPTH`].
    from_contact: bool,
    /// Times narrower than this are not halved.
    narrowest: f64,
}

/// The first contact that is known.
type Best = Option<Touch>;

/// A contact along the motion.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    /// When it is certain: where the motion touches, or is at [`DEPTH`].
    known: f64,
    /// When the motion comes to the patch.
    pub(super) time: f64,
    pub(super) patch: u32,
}

/// A patch along the motion, whose orientations are `turn` more than the patch counts them.
struct Along<'a> {
    index: u32,
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

    /// The first contact at a time from 0 to `end`, as long as its orientation is known.
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

    /// Every contact that the motion comes through up to `end`: when, which patch, and whether it goes into blocked space there.
    pub(super) fn all(&self, end: f64) -> Vec<(f64, u32, bool)> {
        let Some((lo, hi)) = self.path.times_in_reach(end) else {
            return Vec::new();
        };
        let mut found = Vec::new();
        for (lo, hi) in self.path.pieces(lo, hi) {
            for (index, patch) in (0u32..).zip(&self.space.data.patches) {
                self.presences(patch, lo, hi, |turn, from, to| {
                    let along = Along { index, patch, turn };
                    self.all_of(&along, from, to, &mut found);
                });
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // Where one piece of time ends and the next begins a contact is found in both.
        let same = |a: &mut (f64, u32, bool), b: &mut (f64, u32, bool)| {
            (a.1, a.2) == (b.1, b.2) && a.0 - b.0 <= 4.0 * self.narrowest
        };
        found.dedup_by(same);
        found
    }

    /// Finds every contact with one patch: after each contact the search continues behind it.
    fn all_of(&self, along: &Along<'_>, mut lo: f64, hi: f64, found: &mut Vec<(f64, u32, bool)>) {
        loop {
            let mut best: Best = None;
            self.search(along, lo, hi, &mut best);
            let Some(touch) = best else {
                return;
            };
            let rate = self.function(along, Ball::constant(touch.time)).slope[0].mid;
            found.push((touch.time, along.index, rate < 0.0));
            // Where the motion is tangent to the contact, it stays near for a while: it is one contact.
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

    /// Contact of a motion that began in contact and ends in blocked space, though no patch was seen to be passed: it
    /// slid into a notch so sharp that its sides are left behind before either is passed at [`DEPTH`].
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

    /// A time after which, to rounding, the motion is blocked, before one at which it is.
    fn last_not_blocked(&self, blocked: f64) -> f64 {
        self.bisect(0.0, blocked, |t| self.is_blocked(t)).0
    }

    /// Halves an interval down to the narrowest, towards where `is_upper` becomes true.
    fn bisect(&self, lo: f64, hi: f64, is_upper: impl Fn(f64) -> bool) -> (f64, f64) {
        halved((lo, hi), self.narrowest, |t| !is_upper(t))
    }

    fn first_between(&self, lo: f64, hi: f64) -> Best {
        let mut all: Vec<(f64, f64, Along<'_>)> = Vec::new();
        for index in self.near_between(lo, hi) {
            let patch = &self.space.data.patches[index as usize];
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

    /// Patches among which are all that the motion may touch between two times, in ascending order: of a short motion the few that are
    /// near it.
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

    /// Calls `with` for every turn by which a patch is met between two times: the turn, and the times.
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

    /// Looks for a root between two times, the first first, and makes it the best if it is.
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

    /// How near to a curve a position counts as on it.
    fn near(&self) -> f64 {
        self.space.data.frame.rounding() + if self.from_contact { BESIDE } else { ON_CURVE }
    }

    /// The orientations of the patch about a time: the middle, half their range, and how far the time is beyond them.
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

    /// Narrows down the only root there may be, f being monotonous.
    fn alone(&self, along: &Along<'_>, (mut lo, mut hi): (f64, f64), sign: i8, best: &mut Best) {
        let value = |t: f64| self.function(along, Ball::constant(t)).value;
        let sign_at = |t: f64| value(t).sign() * sign;
        // Of a motion that is deep in blocked space only the way in counts.
        if self.from_contact && sign > 0 {
            return;
        }
        // Increasing, say: below the root −1, above it 1.
        if sign_at(lo) > 0 || sign_at(hi) < 0 {
            return;
        }
        // Down to the narrowest, or to where rounding hides the sign; then both ends towards there.
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

    /// Whether times are too near to each other to be halved, or have no number between them.
    fn is_narrow(&self, lo: f64, mid: f64, hi: f64) -> bool {
        hi - lo <= self.narrowest || mid <= lo || mid >= hi
    }

    /// Takes the first time of an interval, in which f cannot be told from zero, for contact at which the position is on
    /// the patch.
    fn accept(&self, along: &Along<'_>, lo: f64, hi: f64, best: &mut Best) {
        let (time, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        if best.is_some_and(|b| b.known <= time) {
            return;
        }
        let frame = &self.space.data.frame;
        let (theta, wide, beyond) = self.within(along, time, half);
        let curve = self.space.curve(along.patch, theta);
        let p = frame.outer_from_inner(self.path.inner_at(time), theta);
        let off = curve.nearest(p.position()).distance(p.position()) * frame.scale;
        // How the position, and the curve with its ends, move within the uncertainty of time and orientation.
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

    /// When a motion that began in contact, and is deep in blocked space at a time, came to the patch: the last root of
    /// the contact function since it was clear of the patch; 0 if it never was.
    fn came(&self, along: &Along<'_>, deep: f64) -> f64 {
        let value = |t: f64| {
            let p = self.path.inner_at(t);
            along.patch.function.value(p, self.path.theta(t))
        };
        let (mut lo, mut hi) = (0.0, deep);
        // Backwards by steps that double, to a time at which it was clear of the patch.
        let mut step = self.narrowest.max(deep * f64::EPSILON);
        loop {
            let t = deep - step;
            if t <= 0.0 {
                let start = value(0.0);
                if start > ON_CURVE {
                    break;
                }
                // In contact with this patch all the time, or with others first.
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
