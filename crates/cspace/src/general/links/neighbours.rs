//! Neighbours of patches: contacts of cells in one slab, copied to all.

use crate::contact::Curve;
use crate::parallel;
use crate::slice::CurveGeometry;

use crate::general::cells::cell::VerticalContact;
use crate::general::links::chains::{Chains, Linker, Member, Place};
use crate::general::links::copies::Lifts;
use crate::general::verdict::shells::Shells;
use crate::space::Patch;
use crate::space::{SideLink, VerticalLink};

/// Contacts copied at a time by one thread.
const CHUNK: usize = 1024;

pub(crate) struct Links<'a> {
    pub(crate) linker: Linker<'a>,
    pub(crate) shells: &'a Shells,
    pub(crate) chains: &'a Chains,
    pub(crate) lifts: &'a Lifts<'a>,
}

/// Two chains that follow each other, the second shifted by some slabs, over orientations seen from the first's slab.
#[derive(Clone, Copy)]
struct Following {
    before: u32,
    after: u32,
    shift: i64,
    from: Place,
    to: Place,
    /// The same in radians.
    lo: f64,
    hi: f64,
}

/// Clusters are at least the narrowest band apart; brought home by turns they differ by rounding, in radians.
const SAME: f64 = crate::feature::tolerance::NARROWEST_BAND / 4.0;

impl Links<'_> {
    fn member(&self, cell: u32) -> Option<Member> {
        self.chains.members[cell as usize]
    }

    /// Neighbours along the boundary, in order of the patch before and of orientation.
    pub(crate) fn side(&self, patches: &[Patch]) -> Vec<SideLink> {
        let mut links: Vec<SideLink> = Vec::new();
        // The copies of a chain are numbered on, so that what is made chain by chain is in order.
        for group in self.following().chunk_by(|a, b| a.before == b.before) {
            let first = links.len();
            for f in group {
                self.copies(f, patches, &mut links);
            }
            if links.len() < first + 2 {
                continue;
            }
            let mut own = links.split_off(first);
            own.sort_by(|a, b| {
                (a.before, a.after)
                    .cmp(&(b.before, b.after))
                    .then(a.lo.total_cmp(&b.lo))
            });
            // Where a patch goes around the turn, what a window cuts from several copies hangs together.
            own.dedup_by(|next, last| {
                let joined = (last.before, last.after) == (next.before, next.after)
                    && next.lo - last.hi <= SAME;
                if joined {
                    last.hi = last.hi.max(next.hi);
                }
                joined
            });
            own.sort_by(|a, b| {
                a.before
                    .cmp(&b.before)
                    .then(a.lo.total_cmp(&b.lo))
                    .then(a.after.cmp(&b.after))
            });
            links.append(&mut own);
        }
        links
    }

    fn copies(&self, f: &Following, patches: &[Patch], links: &mut Vec<SideLink>) {
        let chain = &self.chains.chains[f.before as usize];
        for slabs in self.lifts.shifts(f.lo, f.hi) {
            let before = self.lifts.patch(f.before, slabs);
            let after = self.lifts.patch(f.after, slabs + f.shift);
            let (Some(before), Some(after)) = (before, after) else {
                continue;
            };
            // Into the interval of the patch before.
            let start = patches[before as usize].lo;
            let bring = |place: Place, theta: f64| {
                let at = self.lifts.orientation(place, slabs);
                self.lifts.near(at, start + (theta - chain.lo))
            };
            let (lo, hi) = self.lifts.clipped(bring(f.from, f.lo), bring(f.to, f.hi));
            links.push(SideLink {
                before,
                after,
                lo,
                hi,
            });
        }
    }

    /// Side contacts of free cells, those that hang together as one.
    fn following(&self) -> Vec<Following> {
        let clusters = self.linker.clusters;
        let steps = &self.lifts.steps;
        let mut pieces: Vec<Following> = (self.shells.side.iter())
            .filter_map(|s| {
                let (before, after) = (self.member(s.before)?, self.member(s.after)?);
                let place = |cluster| Place {
                    cluster,
                    slabs: before.slabs,
                };
                let up = steps.period(before.slabs);
                Some(Following {
                    before: before.chain,
                    after: after.chain,
                    shift: before.slabs - after.slabs,
                    from: place(s.from),
                    to: place(s.to),
                    lo: clusters.at(s.from) + up,
                    hi: clusters.at(s.to) + up,
                })
            })
            .collect();
        pieces.sort_by(|a, b| {
            (a.before, a.after, a.shift)
                .cmp(&(b.before, b.after, b.shift))
                .then(a.lo.total_cmp(&b.lo))
        });
        pieces.dedup_by(|next, last| {
            let joined = (last.before, last.after, last.shift)
                == (next.before, next.after, next.shift)
                && next.lo - last.hi <= SAME;
            if joined {
                (last.to, last.hi) = (next.to, next.hi);
            }
            joined
        });
        pieces
    }

    /// Neighbours across critical orientations.
    pub(crate) fn vertical(&self) -> Vec<VerticalLink> {
        let lifted = parallel::chunks(&self.shells.vertical, CHUNK, |_, contacts| {
            let mut links = Vec::new();
            for v in contacts {
                self.lifted(v, &mut links);
            }
            links
        });
        let mut links = lifted.concat();
        parallel::sort_by(&mut links, |a, b| {
            a.theta
                .total_cmp(&b.theta)
                .then((a.lower, a.upper).cmp(&(b.lower, b.upper)))
        });
        links
    }

    /// The links that a contact of two cells makes in all slabs.
    fn lifted(&self, v: &VerticalContact, links: &mut Vec<VerticalLink>) {
        let (Some(lower), Some(upper)) = (self.member(v.lower), self.member(v.upper)) else {
            return;
        };
        // Seen from the lower cell's slab.
        let shift = i64::from(self.linker.is_wrap(v.lower));
        let place = Place {
            cluster: v.at,
            slabs: 0,
        };
        let theta = self.linker.clusters.at(v.at);
        let sheet = self.linker.sheet(v.lower);
        // Within one chain nothing happens, so that most contacts need no curve.
        let mut curve = None;
        // A little more than there are: rounding is not to lose one.
        for slabs in self.lifts.shifts(theta - 0.1, theta + 0.1) {
            let at = self.lifts.orientation(place, slabs);
            if !self.lifts.is_inside(at) {
                continue;
            }
            let below = self.lifts.patch(lower.chain, slabs - lower.slabs);
            let above = self.lifts.patch(upper.chain, slabs + shift - upper.slabs);
            let (Some(below), Some(above)) = (below, above) else {
                continue;
            };
            // Unless a chain meets itself around the turn without being closed, nothing happens within it.
            let chain = &self.chains.chains[lower.chain as usize];
            if below == above && (chain.closed || chain.last != v.lower) {
                continue;
            }
            let curve =
                curve.get_or_insert_with(|| sheet.curve(theta, self.linker.clusters.turn(v.at)));
            links.push(VerticalLink {
                lower: below,
                upper: above,
                theta: at,
                overlap: self.overlap(curve, v, slabs, at),
            });
        }
    }

    /// What two cells share of their curve, some slabs further.
    fn overlap(&self, curve: &Curve, v: &VerticalContact, slabs: i64, at: f64) -> CurveGeometry {
        let steps = &self.lifts.steps;
        let curve = steps.motion(slabs).curve(curve, steps.angle(slabs));
        CurveGeometry::from_inner(&curve, v.lo, v.hi, &self.linker.geometry.frame, at)
    }
}
