//! The arrangement of contact curves at one orientation, and which pieces of them bound free space.
//!
//! Travelling a contact curve, blocked space is on the left. Crossings and ends cut the curves into gaps; a gap is on
//! the boundary of free space as a whole or not at all. Right after a curve has entered the blocked side of another,
//! and right before it leaves it, it is in blocked space; so is an end that no other curve continues. The other gaps
//! hang together at crossings and shared ends in shells; one honest test of overlap decides each shell.

use crate::contact::{Curve, CurveShape, Geometry, crossing, roots};
use crate::geometry::{Point, Rotation};
use crate::union_find::UnionFind;

/// What bounds a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum GapEnd {
    /// The end of the contact curve, with its name.
    End(u32),
    /// A crossing with the curve of a sheet, and which root.
    Crossing(u32, u8),
}

/// A piece of a contact curve on the boundary of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FreeGap {
    pub(crate) sheet: u32,
    pub(crate) from: GapEnd,
    pub(crate) to: GapEnd,
    pub(crate) from_position: f64,
    pub(crate) to_position: f64,
    pub(crate) curve: Curve,
    /// The free gap that follows around the loop.
    pub(crate) next: u32,
}

/// The pieces on the boundary of free space.
#[derive(Debug)]
pub(crate) struct Arrangement {
    /// The orientation it was computed at: the one asked for, or just above.
    pub(crate) theta: f64,
    pub(crate) gaps: Vec<FreeGap>,
}

struct Live {
    sheet: u32,
    curve: Curve,
    half: f64,
    lo: Point,
    hi: Point,
    cuts: Vec<Cut>,
    first_gap: u32,
}

#[derive(Clone, Copy)]
struct Cut {
    position: f64,
    other: u32,
    root: u8,
    enters: bool,
}

impl Arrangement {
    /// Computes the slice at `theta`, from the sheets that may exist there.
    ///
    /// Where curves begin or end just there, or what bounds a shell contradicts the test of it, as happens where a
    /// crossing lies on the end of a curve, the slice just above is computed, within rounding of the one asked for.
    pub(crate) fn new(
        geometry: &Geometry,
        sheets: impl Iterator<Item = u32> + Clone,
        theta: f64,
    ) -> Self {
        /// How far above, radians, relative to an orientation beyond one.
        const STEPS: [f64; 6] = [0.0, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9];
        let scale = theta.abs().max(1.0);
        let mut last = None;
        for step in STEPS {
            let (this, certain) = Self::at(geometry, sheets.clone(), theta + step * scale);
            if certain {
                return this;
            }
            last = Some(this);
        }
        last.unwrap_or(Self {
            theta,
            gaps: Vec::new(),
        })
    }

    /// Computes the slice at just this orientation, and tells whether nothing contradicts it.
    fn at(geometry: &Geometry, sheets: impl Iterator<Item = u32>, theta: f64) -> (Self, bool) {
        let turn = Rotation::by(theta);
        let mut this = Self {
            theta,
            gaps: Vec::new(),
        };
        let (mut live, live_of_sheet, seams) = live_curves(geometry, sheets, theta, turn);
        cut(&mut live, geometry, turn);
        let consistent = this.keep_free(geometry, &mut live, &live_of_sheet, theta);
        (this, consistent && !seams)
    }

    /// Decides every shell; tells whether the tests agree with what bounds the gaps where that was in doubt.
    fn keep_free(
        &mut self,
        geometry: &Geometry,
        live: &mut [Live],
        live_of_sheet: &[u32],
        theta: f64,
    ) -> bool {
        let mut count = 0;
        let mut doubt = false;
        for l in live.iter_mut() {
            l.cuts.sort_by(|a, b| a.position.total_cmp(&b.position));
            doubt |= l.is_tied();
            l.first_gap = count;
            count += l.cuts.len() as u32 + 1;
        }
        let mut blocked = vec![false; count as usize];
        let mut next = vec![u32::MAX; count as usize];
        let mut shells = UnionFind::new(count as usize);
        let find_live = |names: &mut dyn Iterator<Item = u32>| {
            names
                .map(|s| live_of_sheet[s as usize])
                .find(|&i| i != u32::MAX)
        };
        for l in live.iter() {
            let sheet = &geometry.contacts.sheets[l.sheet as usize];
            if find_live(&mut geometry.contacts.ending_at(sheet.start_name)).is_none() {
                blocked[l.first_gap as usize] = true;
            }
            let last = l.first_gap + l.cuts.len() as u32;
            match find_live(&mut geometry.contacts.starting_at(sheet.end_name)) {
                None => blocked[last as usize] = true,
                Some(other) => {
                    let to = live[other as usize].first_gap;
                    next[last as usize] = to;
                    shells.union(last, to);
                }
            }
            for (i, c) in l.cuts.iter().enumerate() {
                let (before, after) = (l.first_gap + i as u32, l.first_gap + i as u32 + 1);
                let (inside, outside) = if c.enters {
                    (after, before)
                } else {
                    (before, after)
                };
                blocked[inside as usize] = true;
                if c.enters {
                    let g = &live[c.other as usize];
                    let me = live_of_sheet[l.sheet as usize];
                    if let Some(j) = g
                        .cuts
                        .iter()
                        .position(|d| d.other == me && d.root == c.root)
                    {
                        let to = g.first_gap + j as u32 + 1;
                        next[outside as usize] = to;
                        shells.union(outside, to);
                    }
                }
            }
        }
        let mut shell_blocked = vec![false; count as usize];
        let mut witness: Vec<Option<(u32, f64, f64)>> = vec![None; count as usize];
        for (i, l) in live.iter().enumerate() {
            for g in 0..=l.cuts.len() {
                let gap = l.first_gap + g as u32;
                let root = shells.find(gap) as usize;
                shell_blocked[root] |= blocked[gap as usize];
                let (from, to) = l.gap_range(g);
                if witness[root].is_none_or(|w| to - from > w.2) {
                    witness[root] = Some((i as u32, from, to - from));
                }
            }
        }
        let mut consistent = true;
        for root in 0..count as usize {
            if shells.find(root as u32) as usize != root || (shell_blocked[root] && !doubt) {
                continue;
            }
            if let Some((i, from, length)) = witness[root] {
                let free = is_free(geometry, live, i as usize, from + 0.5 * length, theta);
                // What is too short to be told from nothing contradicts nothing.
                consistent &= !(free && shell_blocked[root]) || length < TIED;
                shell_blocked[root] |= !free;
            }
        }
        let mut number = vec![u32::MAX; count as usize];
        for l in live.iter() {
            for g in 0..=l.cuts.len() {
                let gap = l.first_gap + g as u32;
                if shell_blocked[shells.find(gap) as usize] {
                    continue;
                }
                number[gap as usize] = self.gaps.len() as u32;
                let sheet = &geometry.contacts.sheets[l.sheet as usize];
                let end = |c: &Cut| GapEnd::Crossing(live[c.other as usize].sheet, c.root);
                let (from_position, to_position) = l.gap_range(g);
                self.gaps.push(FreeGap {
                    sheet: l.sheet,
                    from: if g == 0 {
                        GapEnd::End(sheet.start_name)
                    } else {
                        end(&l.cuts[g - 1])
                    },
                    to: l.cuts.get(g).map_or(GapEnd::End(sheet.end_name), end),
                    from_position,
                    to_position,
                    curve: l.curve,
                    next: next[gap as usize],
                });
            }
        }
        for gap in &mut self.gaps {
            if gap.next != u32::MAX {
                gap.next = number[gap.next as usize];
            }
            consistent &= gap.next != u32::MAX;
        }
        consistent
    }
}

/// Crossings closer than this, to each other or to an end, may have come in the wrong order by rounding; in the
/// pair's frame.
const TIED: f64 = 1e-10;

/// Curves that begin or end within this of an orientation, in radians, may exist there or not by rounding.
const SEAM: f64 = 1e-14;

impl Live {
    /// Whether crossings, in order already, lie on each other or on an end.
    fn is_tied(&self) -> bool {
        let mut at = -self.half;
        let places = self.cuts.iter().map(|c| c.position);
        places.chain([self.half]).any(|p| {
            let tied = p - at < TIED;
            at = p;
            tied
        })
    }

    /// Whether a point of the carrier is in the curve's box, up to more than rounding.
    fn may_hold(&self, p: Point) -> bool {
        const MARGIN: f64 = 1e-9;
        self.lo.x - MARGIN <= p.x
            && p.x <= self.hi.x + MARGIN
            && self.lo.y - MARGIN <= p.y
            && p.y <= self.hi.y + MARGIN
    }

    fn gap_range(&self, gap: usize) -> (f64, f64) {
        let from = if gap == 0 {
            -self.half
        } else {
            self.cuts[gap - 1].position
        };
        let to = self.cuts.get(gap).map_or(self.half, |c| c.position);
        (from, to)
    }
}

/// The curves, where they are by sheet, and whether some begin or end at the orientation.
fn live_curves(
    geometry: &Geometry,
    sheets: impl Iterator<Item = u32>,
    theta: f64,
    turn: Rotation,
) -> (Vec<Live>, Vec<u32>, bool) {
    let (core, reach) = geometry.core(turn);
    let mut live = Vec::new();
    let mut live_of_sheet = vec![u32::MAX; geometry.contacts.sheets.len()];
    let mut seams = false;
    let seam = SEAM * theta.abs().max(1.0);
    for i in sheets {
        let sheet = &geometry.contacts.sheets[i as usize];
        seams |= (sheet.lo - theta).abs().min((sheet.hi - theta).abs()) <= seam;
        if !(sheet.lo < theta && theta < sheet.hi) {
            continue;
        }
        let curve = sheet.curve(theta, turn);
        let (lo, hi) = curve.bounds();
        let far = (core.x - lo.x)
            .abs()
            .max((core.x - hi.x).abs())
            .hypot((core.y - lo.y).abs().max((core.y - hi.y).abs()));
        if far < reach {
            continue;
        }
        live_of_sheet[i as usize] = live.len() as u32;
        let half = curve.half_length();
        live.push(Live {
            sheet: i,
            curve,
            half,
            lo,
            hi,
            cuts: Vec::new(),
            first_gap: 0,
        });
    }
    (live, live_of_sheet, seams)
}

/// Finds all crossings.
fn cut(live: &mut [Live], geometry: &Geometry, turn: Rotation) {
    let mut order: Vec<u32> = (0..live.len() as u32).collect();
    order.sort_by(|&a, &b| live[a as usize].lo.x.total_cmp(&live[b as usize].lo.x));
    for (n, &i) in order.iter().enumerate() {
        let (x, y0, y1) = {
            let l = &live[i as usize];
            (l.hi.x, l.lo.y, l.hi.y)
        };
        for &j in &order[n + 1..] {
            let m = &live[j as usize];
            if m.lo.x > x {
                break;
            }
            if m.lo.y <= y1 && y0 <= m.hi.y {
                let (a, b) = (i.min(j), i.max(j));
                cut_pair(live, geometry, turn, a, b);
            }
        }
    }
}

fn cut_pair(live: &mut [Live], geometry: &Geometry, turn: Rotation, i: u32, j: u32) {
    let (f, g) = (&live[i as usize], &live[j as usize]);
    let sheets = &geometry.contacts.sheets;
    let (fs, gs) = (&sheets[f.sheet as usize], &sheets[g.sheet as usize]);
    let shared = fs.shared_ends(gs, geometry.contacts.first_vertex_name);
    if shared.tangent {
        return;
    }
    let mut found: [Option<(Point, bool)>; 2] = [None; 2];
    for root in 0..roots(&f.curve, &g.curve) {
        found[usize::from(root)] = crossing(&f.curve, &g.curve, root).map(|c| (c.point, c.enters));
    }
    for spiral in shared.corners.into_iter().flatten() {
        let p = spiral.at(turn);
        let distance = |c: &Option<(Point, bool)>| c.map_or(f64::INFINITY, |c| c.0.distance(p));
        let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
        found[nearest] = None;
    }
    let mut cuts = Vec::new();
    for (root, c) in (0u8..).zip(found) {
        let Some((p, enters)) = c else { continue };
        if !(f.may_hold(p) && g.may_hold(p)) {
            continue;
        }
        let (s, t) = (f.curve.position(p), g.curve.position(p));
        if s.abs() < f.half && t.abs() < g.half {
            cuts.push((root, enters, s, t));
        }
    }
    for &(root, enters, s, t) in &cuts {
        live[i as usize].cuts.push(Cut {
            position: s,
            other: j,
            root,
            enters,
        });
        live[j as usize].cuts.push(Cut {
            position: t,
            other: i,
            root,
            enters: !enters,
        });
    }
}

/// An honest test beside a gap: the parts must not overlap half way to the next contact curve on the free side.
fn is_free(geometry: &Geometry, live: &[Live], i: usize, position: f64, theta: f64) -> bool {
    let curve = &live[i].curve;
    let p = curve.point(position);
    let normal = curve.normal(p);
    let mut reach = longest_step(curve);
    for (j, l) in live.iter().enumerate() {
        if i != j {
            reach = l.curve.hit(p, normal, reach).unwrap_or(reach);
        }
    }
    !geometry.overlaps(p + normal * (0.5 * reach), theta)
}

/// How far from a curve its free side is looked at: not beyond the middle of the circle it goes around.
fn longest_step(curve: &Curve) -> f64 {
    const STEP: f64 = 1.0 / 256.0;
    match curve.shape {
        CurveShape::Line { .. } => STEP,
        CurveShape::Circle { radius, .. } => STEP.min(0.5 * radius.abs()),
    }
}
