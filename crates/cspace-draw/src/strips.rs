//! Free space in the plane of motions as strips: gaps of one region that follow each other.

use cspace::fixed_axes::FreeGap;
use cspace::{FixedAxesSpace, RegionId};

use crate::line::{SEEN, off, simplified};
use crate::scene::{Area, Dot, Path, Step};
use crate::view::View;

/// Free space between two lines whose points belong together: corresponding ones differ in one coordinate.
#[derive(Debug, Clone)]
pub(crate) struct Strip {
    pub(crate) region: RegionId,
    lower: Vec<Dot>,
    upper: Vec<Dot>,
    /// Visible rectangle.
    area: Area,
}

/// The free space that is seen, in every period.
pub(crate) fn strips(space: &FixedAxesSpace, view: &View) -> Vec<Strip> {
    let mut done: Vec<Strip> = Vec::new();
    // Strips to which the gaps of the next interval may be added: those that end where it begins.
    let mut open: Vec<Strip> = Vec::new();
    for gap in space.free_gaps() {
        let corners = [gap.ends(0.0), gap.ends(1.0)].concat();
        let corners: Vec<(f64, f64)> = corners.into_iter().map(|c| view.opened(c)).collect();
        let range = |of: fn(&(f64, f64)) -> f64| {
            let values = corners.iter().map(of);
            let lo = values.clone().fold(f64::INFINITY, f64::min);
            (lo, values.fold(f64::NEG_INFINITY, f64::max))
        };
        for shift in view.copies(range(|c| c.0), range(|c| c.1)) {
            let (lower, upper) = sides(&gap, shift, view);
            let joins = |s: &Strip| {
                let end = |line: &[Dot]| line.last().copied();
                let meets = |a: Option<Dot>, b: Dot| a.is_some_and(|a| a.distance(b) < SEEN);
                s.region == gap.region()
                    && meets(end(&s.lower), lower[0])
                    && meets(end(&s.upper), upper[0])
            };
            match open.iter_mut().rev().find(|s| joins(s)) {
                Some(strip) => {
                    strip.lower.extend(&lower[1..]);
                    strip.upper.extend(&upper[1..]);
                }
                None => open.push(Strip {
                    region: gap.region(),
                    lower,
                    upper,
                    area: view.plot.area,
                }),
            }
        }
        /// Largest number of strips that are extended at once: of more, the oldest have most likely ended.
        const MOST_OPEN: usize = 256;
        if open.len() > MOST_OPEN {
            done.extend(open.drain(..MOST_OPEN / 2));
        }
    }
    done.extend(open);
    done
}

/// Both sides of a gap, followed together.
fn sides(gap: &FreeGap<'_>, (du, dv): (f64, f64), view: &View) -> (Vec<Dot>, Vec<Dot>) {
    let at = |share: f64| {
        gap.ends(share).map(|motions| {
            let (u, v) = view.opened(motions);
            view.place((u + du, v + dv))
        })
    };
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    let first = at(0.0);
    lower.push(first[0]);
    upper.push(first[1]);
    let mut last = (0.0, first);
    let mut ends = vec![(1.0, at(1.0), 0u32)];
    /// Largest number of halvings: enough for any curve on a picture that is shown as a whole.
    const DEEPEST: u32 = 12;
    while let Some((share, end, depth)) = ends.pop() {
        let middle = 0.5 * (last.0 + share);
        let at_middle = at(middle);
        let bent = (0..2).any(|k| off(at_middle[k], last.1[k], end[k]) > SEEN);
        let long = last.1[0].distance(end[0]).max(last.1[1].distance(end[1])) > SEEN;
        if depth < DEEPEST && long && (bent || depth < 1) {
            ends.push((share, end, depth + 1));
            ends.push((middle, at_middle, depth + 1));
            continue;
        }
        lower.push(end[0]);
        upper.push(end[1]);
        last = (share, end);
    }
    (lower, upper)
}

impl Strip {
    /// Outline of the strip.
    pub(crate) fn outline(&self) -> Path {
        let mut path = Path::through(simplified(&self.lower));
        let mut back = simplified(&self.upper);
        back.reverse();
        path.steps.extend(back.into_iter().map(Step::Line));
        path.steps.push(Step::Close);
        path
    }

    /// Lines along the middle of the strip where it is narrower than a number of dots.
    pub(crate) fn thin(&self, dots: f64) -> Vec<Vec<Dot>> {
        /// Width in dots below which an end is a corner.
        const CORNER: f64 = 1e-3;
        let n = self.lower.len();
        let mut lines: Vec<Vec<Dot>> = Vec::new();
        let mut from = None;
        for i in 0..=n {
            let is_thin = i < n && self.width(i) < dots;
            match from {
                None if is_thin => from = Some(i),
                Some(first) if !is_thin => {
                    let line: Vec<Dot> = (first..i).map(|k| self.middle(k)).collect();
                    let length: f64 = line.windows(2).map(|w| w[0].distance(w[1])).sum();
                    let is_corner = |k: usize| self.lower[k].distance(self.upper[k]) < CORNER;
                    // A strip that ends in a corner is thin there without being a channel.
                    if length > 2.0 * dots || !(is_corner(first) || is_corner(i - 1)) {
                        lines.push(line);
                    }
                    from = None;
                }
                _ => {}
            }
        }
        lines.iter().map(|l| simplified(l)).collect()
    }

    /// As above, for a strip that is short and wide, across which a channel runs: lines from side to side where
    /// `is_free` does not hold, `dots` apart.
    pub(crate) fn thin_across(&self, dots: f64, is_free: impl Fn(Dot) -> bool) -> Vec<Vec<Dot>> {
        let n = self.lower.len();
        let (a, b) = (self.lower[n / 2], self.upper[n / 2]);
        let wide = a.distance(b);
        if wide <= 2.0 * dots {
            return Vec::new();
        }
        let (dx, dy) = ((b.x - a.x) / wide, (b.y - a.y) / wide);
        let (first, last) = (self.lower[0], self.lower[n - 1]);
        let long = ((last.x - first.x) * dy - (last.y - first.y) * dx).abs();
        if long >= dots {
            return Vec::new();
        }
        let mut lines: Vec<Vec<Dot>> = vec![Vec::new()];
        let steps = wide.ceil().min(1e4);
        for k in 0..=steps as usize {
            let at = a.moved(dx * wide * k as f64 / steps, dy * wide * k as f64 / steps);
            let beside = |far: f64| at.moved(-far * dy, far * dx);
            let is_thin = !is_free(beside(0.7 * dots)) && !is_free(beside(-0.7 * dots));
            match lines.last_mut() {
                Some(line) if is_thin => line.push(at),
                Some(line) if !line.is_empty() => lines.push(Vec::new()),
                _ => {}
            }
        }
        lines.retain(|l| l.len() as f64 > 2.0 * dots);
        lines.iter().map(|l| simplified(l)).collect()
    }

    fn middle(&self, i: usize) -> Dot {
        let (a, b) = (self.lower[i], self.upper[i]);
        Dot::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y))
    }

    /// Width of the strip at a pair of points, perpendicular to its direction there.
    fn width(&self, i: usize) -> f64 {
        let (a, b) = (self.lower[i], self.upper[i]);
        let (before, after) = (
            self.middle(i.saturating_sub(1)),
            self.middle((i + 1).min(self.lower.len() - 1)),
        );
        let (dx, dy) = (after.x - before.x, after.y - before.y);
        let length = dx.hypot(dy);
        if length == 0.0 {
            return a.distance(b);
        }
        ((b.x - a.x) * dy - (b.y - a.y) * dx).abs() / length
    }

    /// Largest visible width of the strip, and its place.
    pub(crate) fn widest(&self) -> Option<(f64, Dot)> {
        let mut best: Option<(f64, Dot)> = None;
        let clamp = |d: Dot| {
            Dot::new(
                d.x.clamp(self.area.lo.x, self.area.hi.x),
                d.y.clamp(self.area.lo.y, self.area.hi.y),
            )
        };
        for i in 1..self.lower.len() {
            // In the middle of a piece there is room on both sides.
            let half = |line: &[Dot]| {
                let (a, b) = (line[i - 1], line[i]);
                clamp(Dot::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y)))
            };
            let (a, b) = (half(&self.lower), half(&self.upper));
            let along = clamp(self.lower[i]).distance(clamp(self.lower[i - 1]));
            let room = a.distance(b).min(2.0 * along);
            if best.is_none_or(|b| room > b.0) {
                best = Some((room, Dot::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y))));
            }
        }
        best
    }
}
