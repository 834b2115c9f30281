//! The contact curves at one orientation, and where they cross.

use crate::contact::{Curve, Cycle, Geometry, Seam, Sheet, crossing};
use crate::feature::tolerance::{BLUNT, TIED};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::Bounds;

/// A contact curve with its crossings.
pub(super) struct Live {
    pub(super) sheet: u32,
    pub(super) curve: Curve,
    pub(super) half: f64,
    pub(super) bounds: Bounds,
    pub(super) cuts: Vec<Cut>,
    /// Whether a crossing may be on either side of the end of a curve.
    pub(super) tied: bool,
    pub(super) first_gap: u32,
}

/// A crossing with another curve.
#[derive(Clone, Copy)]
pub(super) struct Cut {
    pub(super) position: f64,
    pub(super) other: u32,
    pub(super) root: u8,
    pub(super) enters: bool,
    /// How far off the place may be.
    pub(super) error: f64,
}

/// Crossings closer than this to the end of a curve, divided by the sine at which the curves cross, may have come to lie
/// on the wrong side of it by rounding; in the pair's frame.
const ROUNDING: f64 = 1e-13;

/// Curves that begin or end within this of an orientation, in radians, may exist there or not by rounding.
const SEAM: f64 = 1e-14;

impl Live {
    /// Whether a point of its line or circle is in the curve's box, widened by a margin.
    fn may_hold(&self, p: Point, margin: f64) -> bool {
        let (lo, hi) = (self.bounds.min, self.bounds.max);
        lo.x - margin <= p.x && p.x <= hi.x + margin && lo.y - margin <= p.y && p.y <= hi.y + margin
    }

    /// The range of places of a gap.
    pub(super) fn gap_range(&self, gap: usize) -> (f64, f64) {
        let from = if gap == 0 {
            -self.half
        } else {
            self.cuts[gap - 1].position
        };
        let to = self.cuts.get(gap).map_or(self.half, |c| c.position);
        (from, to)
    }

    /// A box no larger than the curve: its own but for the height of a large circle.
    pub(super) fn extent(&self) -> Bounds {
        if self.curve.cycle.is_centred() {
            self.bounds
        } else {
            Bounds::of(self.curve.start, self.curve.end)
        }
    }

    /// A box no smaller than a gap.
    pub(super) fn gap_extent(&self, gap: usize) -> Bounds {
        if self.cuts.is_empty() {
            return self.bounds;
        }
        let (from, to) = self.gap_range(gap);
        let ends = Bounds::of(self.curve.point(from), self.curve.point(to));
        let cycle = &self.curve.cycle;
        if cycle.is_line() {
            return ends;
        }
        if !cycle.is_centred() {
            return self.bounds;
        }
        let r = cycle.size;
        [(r, 0.0), (-r, 0.0), (0.0, r), (0.0, -r)]
            .map(|(x, y)| cycle.through + Vector::new(x, y))
            .into_iter()
            .filter(|p| (from..=to).contains(&self.curve.position(*p)))
            .fold(ends, |all, p| all.union(Bounds::of(p, p)))
    }
}

/// The curves, where they are by sheet, and whether some begin or end at the orientation.
pub(super) fn live_curves(
    geometry: &Geometry,
    sheets: impl Iterator<Item = u32>,
    theta: f64,
    turn: Rotation,
) -> (Vec<Live>, Vec<u32>, bool) {
    let core = geometry.core(turn);
    let mut live = Vec::new();
    let mut live_of_sheet = vec![u32::MAX; geometry.contacts.sheets.len()];
    let mut seams = false;
    let seam = SEAM * theta.abs().max(1.0);
    for i in sheets {
        let sheet = &geometry.contacts.sheets[i as usize];
        // Where a full turn is cut nothing happens: the lower end belongs to the sheet.
        let goes_on = |end: Seam| matches!(end, Seam::Wrap(..));
        let (begins, ends) = (!goes_on(sheet.bottom), !goes_on(sheet.top));
        seams |= begins && (sheet.lo - theta).abs() <= seam;
        seams |= ends && (sheet.hi - theta).abs() <= seam;
        let above = sheet.lo < theta || (!begins && sheet.lo == theta);
        if !(above && theta < sheet.hi) {
            continue;
        }
        let curve = sheet.curve(theta, turn);
        let bounds = curve.bounds();
        let far = |core: Point| {
            let off = |c: f64, lo: f64, hi: f64| (c - lo).abs().max((c - hi).abs());
            let (lo, hi) = (bounds.min, bounds.max);
            off(core.x, lo.x, hi.x).hypot(off(core.y, lo.y, hi.y))
        };
        if core.is_some_and(|(center, reach)| far(center) < reach) {
            continue;
        }
        live_of_sheet[i as usize] = live.len() as u32;
        let half = curve.half;
        live.push(Live {
            sheet: i,
            curve,
            half,
            bounds,
            cuts: Vec::new(),
            tied: false,
            first_gap: 0,
        });
    }
    (live, live_of_sheet, seams)
}

/// Finds all crossings.
pub(super) fn cut(live: &mut [Live], geometry: &Geometry, turn: Rotation) {
    let mut order: Vec<u32> = (0..live.len() as u32).collect();
    let left = |i: u32| live[i as usize].bounds.min.x;
    order.sort_by(|&a, &b| left(a).total_cmp(&left(b)));
    for (n, &i) in order.iter().enumerate() {
        // What is just beyond the end of a curve marks both.
        let (x, y0, y1) = {
            let (lo, hi) = (live[i as usize].bounds.min, live[i as usize].bounds.max);
            (hi.x + TIED, lo.y - TIED, hi.y + TIED)
        };
        for &j in &order[n + 1..] {
            let m = live[j as usize].bounds;
            if m.min.x > x {
                break;
            }
            if m.min.y <= y1 && y0 <= m.max.y {
                let (a, b) = (i.min(j), i.max(j));
                cut_pair(live, geometry, turn, a, b);
            }
        }
    }
}

/// Finds the crossings of two curves.
fn cut_pair(live: &mut [Live], geometry: &Geometry, turn: Rotation, i: u32, j: u32) {
    let (f, g) = (&live[i as usize], &live[j as usize]);
    let sheets = &geometry.contacts.sheets;
    let (fs, gs) = (&sheets[f.sheet as usize], &sheets[g.sheet as usize]);
    let shared = fs.shared_ends(gs, geometry.contacts.first_vertex_name);
    if shared.tangent {
        return;
    }
    /// More than rounding.
    const MARGIN: f64 = 1e-9;
    let mut found: [Option<(Point, bool)>; 2] = [None; 2];
    // Circles about nearly one centre are crossed as seen from there.
    let origin = fs.close_to(gs).map(|c| c.0);
    let seen = |sheet: &Sheet, curve: &Curve| match origin {
        Some(o) => Curve {
            cycle: sheet.locus.about(&o).cycle(turn),
            ..*curve
        },
        None => *curve,
    };
    let (fc, gc) = (seen(fs, &f.curve), seen(gs, &g.curve));
    let back = origin.map_or(Vector::ZERO, |o| o.at(turn).to_vector());
    for root in 0..2 {
        found[usize::from(root)] = crossing(&fc, &gc, root).map(|c| (c.point + back, c.enters));
    }
    // Where curves are all but tangent, two crossings may be taken for each other; not so seen from their own centre.
    let blunt = |p: Point| {
        origin.is_none()
            && f.may_hold(p, BLUNT)
            && g.may_hold(p, BLUNT)
            && f.curve.normal(p).cross(g.curve.normal(p)).abs() < BLUNT
    };
    let mut tied = found.iter().flatten().any(|c| blunt(c.0));
    // What comes from upon one line or circle to the other may cross it at its end, unseen.
    let grazes = |l: &Live, on: &Live| {
        let cycle: &Cycle = &on.curve.cycle;
        [l.curve.start, l.curve.end].into_iter().any(|p| {
            on.may_hold(p, TIED)
                && cycle.distance(p).abs() < ROUNDING
                && l.curve.normal(p).cross(on.curve.normal(p)).abs() < BLUNT
        })
    };
    tied |= found == [None; 2] && (grazes(f, g) || grazes(g, f));
    let ends = shared.corners.into_iter().zip([f.curve.end, f.curve.start]);
    for (_, p) in ends.filter(|end| end.0) {
        let distance = |c: &Option<(Point, bool)>| c.map_or(f64::INFINITY, |c| c.0.distance(p));
        let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
        found[nearest] = None;
    }
    let mut cuts = Vec::new();
    for (root, c) in (0u8..).zip(found) {
        let Some((p, enters)) = c else { continue };
        if !(f.may_hold(p, MARGIN) && g.may_hold(p, MARGIN)) {
            continue;
        }
        let (s, t) = (f.curve.position(p), g.curve.position(p));
        let sine = f.curve.normal(p).cross(g.curve.normal(p)).abs();
        let angle = if origin.is_some() {
            1.0
        } else {
            sine.max(ROUNDING)
        };
        let near = TIED + ROUNDING / angle;
        if s.abs() < f.half && t.abs() < g.half {
            cuts.push((root, enters, s, t, near));
        }
        let beyond = (s.abs() - f.half).max(t.abs() - g.half);
        tied |= beyond.abs() < near;
    }
    live[i as usize].tied |= tied;
    live[j as usize].tied |= tied;
    for &(root, enters, s, t, error) in &cuts {
        live[i as usize].cuts.push(Cut {
            position: s,
            other: j,
            root,
            enters,
            error,
        });
        live[j as usize].cuts.push(Cut {
            position: t,
            other: i,
            root,
            enters: !enters,
            error,
        });
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
