//! The arrangement of contact curves at one orientation, and which pieces of them bound free space.
//!
//! Travelling a contact curve, blocked space is on the left. Crossings and ends cut the curves into gaps; a gap is on
//! the boundary of free space as a whole or not at all. Right after a curve has entered the blocked side of another,
//! and right before it leaves it, it is in blocked space; so is an end that no other curve continues. The other gaps
//! hang together at crossings and shared ends in shells; one test of the parts for overlap decides each shell.

use crate::contact::{Curve, Geometry};
use crate::feature::tolerance::{LONGEST_STEP, NARROWEST_BAND, ROOM, TIED};
use crate::geometry::{Point, Rotation};
use crate::part::Bounds;
use crate::union_find::UnionFind;

use super::coincident::Coincidences;
use super::cut::{Cut, Live, cut, live_curves};

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
#[derive(Debug, Default)]
pub(crate) struct Arrangement {
    pub(crate) gaps: Vec<FreeGap>,
    /// Whether no orientation as near as the narrowest band is without contradiction.
    pub(crate) doubtful: bool,
}

/// What is tested for overlap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Test {
    /// One gap of each shell, where nothing that bounds its gaps tells.
    Shells,
    /// Every gap for itself.
    Gaps,
}

impl Arrangement {
    /// Computes the slice at `theta`; `at` brings an orientation into the span of the sheets, and tells which of them may
    /// exist there.
    ///
    /// Where curves begin or end just there, or what bounds a shell contradicts the test of it, as happens where a
    /// crossing lies on the end of a curve, the slice just above is computed, within rounding of the one asked for.
    pub(super) fn new<S: Iterator<Item = u32>>(
        geometry: &Geometry,
        coincidences: &Coincidences,
        theta: f64,
        at: impl Fn(f64) -> (f64, S),
    ) -> Self {
        /// How far above, radians, relative to an orientation beyond one.
        const STEPS: [f64; 8] = [0.0, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7];
        let (theta, sheets) = at(theta);
        let scale = theta.abs().max(1.0);
        for step in STEPS {
            let (above, sheets) = at(theta + step * scale);
            let (mut this, certain) = Self::at(geometry, coincidences, sheets, above, Test::Shells);
            if certain {
                this.doubtful |= step > NARROWEST_BAND;
                return this;
            }
        }
        // A touch of second order: what bounds the gaps tells nothing.
        let (mut this, _) = Self::at(geometry, coincidences, sheets, theta, Test::Gaps);
        this.doubtful = true;
        this
    }

    /// Computes the slice at just this orientation, and tells whether nothing contradicts it.
    fn at(
        geometry: &Geometry,
        coincidences: &Coincidences,
        sheets: impl Iterator<Item = u32>,
        theta: f64,
        test: Test,
    ) -> (Self, bool) {
        let turn = Rotation::by(theta);
        let mut this = Self::default();
        let (mut live, live_of_sheet, seams) = live_curves(geometry, sheets, theta, turn);
        cut(&mut live, geometry, turn);
        let consistent = this.keep_free(
            geometry,
            coincidences,
            &mut live,
            &live_of_sheet,
            theta,
            test,
        );
        (this, consistent && !seams)
    }

    /// Decides every shell; tells whether the tests agree with what bounds the gaps where that was in doubt.
    fn keep_free(
        &mut self,
        geometry: &Geometry,
        coincidences: &Coincidences,
        live: &mut [Live],
        live_of_sheet: &[u32],
        theta: f64,
        test: Test,
    ) -> bool {
        let mut count = 0;
        for l in live.iter_mut() {
            l.cuts.sort_by(|a, b| a.position.total_cmp(&b.position));
            l.tied |= l
                .cuts
                .windows(2)
                .any(|c| c[1].position - c[0].position < c[0].error + c[1].error);
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
        // Whether a curve is not blocked throughout by what bounds its gaps.
        let open = |sheet: u32| {
            let live = live.get(live_of_sheet[sheet as usize] as usize);
            live.is_some_and(|l| {
                let first = l.first_gap as usize;
                blocked[first..=first + l.cuts.len()].contains(&false)
            })
        };
        self.doubtful = coincidences.any(theta, open);
        let mut shell_blocked = vec![false; count as usize];
        let mut doubt = vec![false; count as usize];
        let mut witness: Vec<Option<(u32, f64, f64)>> = vec![None; count as usize];
        for (i, l) in live.iter().enumerate() {
            for g in 0..=l.cuts.len() {
                let gap = l.first_gap + g as u32;
                let root = shells.find(gap) as usize;
                shell_blocked[root] |= blocked[gap as usize];
                doubt[root] |= l.tied;
                let (from, to) = l.gap_range(g);
                if witness[root].is_none_or(|w| to - from > w.2) {
                    witness[root] = Some((i as u32, from, to - from));
                }
            }
        }
        let mut consistent = true;
        for root in 0..count as usize {
            if shells.find(root as u32) as usize != root || (shell_blocked[root] && !doubt[root]) {
                continue;
            }
            if let Some((i, from, length)) = witness[root] {
                let free = is_free(geometry, live, i as usize, from + 0.5 * length, theta);
                // A gap shorter than the error of its ends may not be there: it contradicts nothing.
                consistent &= !(free && shell_blocked[root]) || length < TIED;
                if !free && doubt[root] {
                    // What lies furthest out is free, unless all is blocked.
                    let of_shell = |gap: u32| shells.find(gap) as usize == root;
                    if let Some((i, position)) = furthest(live, of_shell) {
                        consistent &= !is_free(geometry, live, i, position, theta);
                    }
                }
                shell_blocked[root] |= !free;
            }
        }
        // Of curves with a crossing in doubt every piece is looked at: where one was lost, shells hang together wrongly.
        // Where all gaps are tested anyway, nothing is to be contradicted.
        let looked = |l: &Live| l.tied && test == Test::Shells;
        for (i, l) in live.iter().enumerate().filter(|(_, l)| looked(l)) {
            for g in 0..=l.cuts.len() {
                let (from, to) = l.gap_range(g);
                let middle = 0.5 * (from + to);
                let blocked = shell_blocked[shells.find(l.first_gap + g as u32) as usize];
                let (beside, reach) = beside(live, i, middle);
                if to - from > ROOM && (blocked || reach > ROOM) {
                    consistent &= geometry.overlaps(beside, theta) == blocked;
                }
            }
        }
        let mut number = vec![u32::MAX; count as usize];
        let (mut all, mut bounding) = (Bounds::EMPTY, Bounds::EMPTY);
        for (i, l) in live.iter().enumerate() {
            all = all.union(l.extent());
            for g in 0..=l.cuts.len() {
                let gap = l.first_gap + g as u32;
                let free = match test {
                    Test::Shells => !shell_blocked[shells.find(gap) as usize],
                    Test::Gaps => {
                        let (from, to) = l.gap_range(g);
                        is_free(geometry, live, i, 0.5 * (from + to), theta)
                    }
                };
                if !free {
                    continue;
                }
                bounding = bounding.union(l.gap_extent(g));
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
        // Far away all is free, and the outermost curves bound that: every place of a contact curve is touched or blocked, so that
        // free space is bounded by pieces that reach as far as all curves do.
        consistent && !self.gaps.is_empty() && reaches(bounding, all)
    }
}

/// Whether a box reaches as far as another on every side.
fn reaches(inner: Bounds, outer: Bounds) -> bool {
    inner.min.x <= outer.min.x + ROOM
        && inner.min.y <= outer.min.y + ROOM
        && inner.max.x >= outer.max.x - ROOM
        && inner.max.y >= outer.max.y - ROOM
}

/// Of some gaps the one whose middle is furthest from the middle of the pair: its curve, and where on it.
fn furthest(live: &[Live], mut of: impl FnMut(u32) -> bool) -> Option<(usize, f64)> {
    let mut best: Option<(f64, (usize, f64))> = None;
    for (i, l) in live.iter().enumerate() {
        for g in 0..=l.cuts.len() {
            let (from, to) = l.gap_range(g);
            let middle = 0.5 * (from + to);
            if to - from < TIED || !of(l.first_gap + g as u32) {
                continue;
            }
            let distance = l.curve.point(middle).to_vector().length_squared();
            if best.is_none_or(|b| distance > b.0) {
                best = Some((distance, (i, middle)));
            }
        }
    }
    best.map(|b| b.1)
}

/// Whether a gap is free: the parts do not overlap half way to the next contact curve on the free side.
fn is_free(geometry: &Geometry, live: &[Live], i: usize, position: f64, theta: f64) -> bool {
    !geometry.overlaps(beside(live, i, position).0, theta)
}

/// Half way to the next contact curve on the free side of a place of a curve, and how far it is to that.
fn beside(live: &[Live], i: usize, position: f64) -> (Point, f64) {
    let curve = &live[i].curve;
    let p = curve.point(position);
    let normal = curve.normal(p);
    let mut reach = longest_step(curve);
    for (j, l) in live.iter().enumerate() {
        if i != j {
            reach = l.curve.hit(p, normal, reach).unwrap_or(reach);
        }
    }
    (p + normal * (0.5 * reach), reach)
}

/// How far from a curve its free side is looked at: not beyond the middle of the circle it goes around.
fn longest_step(curve: &Curve) -> f64 {
    LONGEST_STEP.min(0.5 / curve.cycle.curvature().abs())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
