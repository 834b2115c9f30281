//! Neighbours of patches: contacts of cells in one period, copied to all.

use crate::contact::{Curve, SlabMotion};
use crate::ids::PatchId;
use crate::parallel;
use crate::slice::CurveGeometry;

use crate::general::cells::cell::VerticalContact;
use crate::general::links::chains::{Chains, ClusterInPeriod, Linker, Member};
use crate::general::links::copies::Lifts;
use crate::general::verdict::shells::Shells;
use crate::space::{SideLink, VerticalLink};

/// Contacts copied at a time by one thread.
const CHUNK: usize = 1024;

pub(crate) struct Links<'a> {
    pub(crate) linker: Linker<'a>,
    pub(crate) shells: &'a Shells,
    pub(crate) chains: &'a Chains,
    pub(crate) lifts: &'a Lifts<'a>,
}

/// Two chains that follow each other, the second shifted by some periods, over orientations counted in the first chain's period.
#[derive(Clone, Copy)]
struct Following {
    before: u32,
    after: u32,
    shift: i32,
    from: ClusterInPeriod,
    to: ClusterInPeriod,
}

/// Contact of cells that are not of one patch: of two chains, or of copies of one chain in different periods.
struct Crossing<'v> {
    contact: &'v VerticalContact,
    /// Chain of the lower and of the upper cell, and the number of periods by which each is shifted.
    below: (u32, i64),
    above: (u32, i64),
    /// Contact curve of the lower cell at the orientation of the contact.
    curve: Curve,
}

/// Tolerance for equal orientations, radians: clusters are at least the narrowest band apart; reduced by turns they differ by rounding.
const SAME: f64 = crate::feature::tolerance::NARROWEST_BAND / 4.0;

impl Links<'_> {
    fn member(&self, cell: u32) -> Option<Member> {
        self.chains.members.of(cell)
    }

    /// Neighbours along the boundary, in order of the patch before and of orientation.
    pub(crate) fn side(&self) -> Vec<SideLink> {
        // The copies of a chain have consecutive numbers, so that links made chain by chain are in order.
        let following = self.following();
        let groups: Vec<&[Following]> = following.chunk_by(|a, b| a.before == b.before).collect();
        let parts = parallel::chunks(&groups, CHUNK, |_, groups| {
            let (mut links, mut own) = (Vec::new(), Vec::new());
            for group in groups {
                own.clear();
                for f in *group {
                    self.copies(f, &mut own);
                }
                joined(&mut own);
                links.extend_from_slice(&own);
            }
            links
        });
        one_list(parts)
    }

    fn copies(&self, f: &Following, links: &mut Vec<SideLink>) {
        let chain = &self.chains.chains[f.before as usize];
        let (first, last) = (self.radians(f.from), self.radians(f.to));
        for slabs in self.lifts.shifts(first, last) {
            let before = self.lifts.patch(f.before, slabs);
            let after = self.lifts.patch(f.after, slabs + i64::from(f.shift));
            let (Some(before), Some(after)) = (before, after) else {
                continue;
            };
            // The orientation in the interval of the patch before.
            let (start, _) = self.lifts.interval(chain, slabs);
            let bring = |place: ClusterInPeriod, theta: f64| {
                let at = self.lifts.orientation(place, slabs);
                self.lifts.near(at, start + (theta - chain.lo))
            };
            let (lo, hi) = self.lifts.clipped(bring(f.from, first), bring(f.to, last));
            links.push(SideLink {
                before: PatchId(before),
                after: PatchId(after),
                lo,
                hi,
            });
        }
    }

    /// A place in radians.
    fn radians(&self, place: ClusterInPeriod) -> f64 {
        self.linker.clusters.at(place.cluster) + self.lifts.steps.period(i64::from(place.slabs))
    }

    /// Side contacts of free cells, with consecutive ones joined.
    fn following(&self) -> Vec<Following> {
        let mut pieces: Vec<Following> = (self.shells.side.iter())
            .filter_map(|s| {
                let (before, after) = (self.member(s.before)?, self.member(s.after)?);
                let place = |cluster| ClusterInPeriod {
                    cluster,
                    slabs: before.slabs,
                };
                Some(Following {
                    before: before.chain,
                    after: after.chain,
                    shift: before.slabs - after.slabs,
                    from: place(s.from),
                    to: place(s.to),
                })
            })
            .collect();
        parallel::sort_by(&mut pieces, |a, b| {
            (a.before, a.after, a.shift)
                .cmp(&(b.before, b.after, b.shift))
                .then_with(|| self.radians(a.from).total_cmp(&self.radians(b.from)))
        });
        pieces.dedup_by(|next, last| {
            let joined = (last.before, last.after, last.shift)
                == (next.before, next.after, next.shift)
                && self.radians(next.from) - self.radians(last.to) <= SAME;
            if joined {
                last.to = next.to;
            }
            joined
        });
        pieces
    }

    /// Neighbours across critical orientations. Contacts are in order of their clusters: copied period by period, links are nearly in order
    /// of orientation.
    pub(crate) fn vertical(&self) -> Vec<VerticalLink> {
        let contacts = &self.shells.vertical;
        let lifted = match self.lifts.all_slabs() {
            // Every contact is copied to every period.
            Some(slabs) if slabs.end > 1 => {
                let chunks: Vec<&[VerticalContact]> = contacts.chunks(CHUNK).collect();
                let crossings = one_list(parallel::map(&chunks, 1, |c| self.crossings(c)));
                let pieces: Vec<_> = slabs
                    .flat_map(|slabs| crossings.chunks(CHUNK).map(move |c| (slabs, c)))
                    .collect();
                parallel::map(&pieces, 1, |&(slabs, crossings)| {
                    let motion = self.lifts.steps.motion(slabs);
                    let lifted = |c: &Crossing<'_>| self.lifted(c, slabs, &motion);
                    crossings.iter().filter_map(lifted).collect()
                })
            }
            _ => parallel::chunks(contacts, CHUNK, |_, contacts| {
                let mut links = Vec::new();
                for c in self.crossings(contacts) {
                    let theta = self.linker.clusters.at(c.contact.at);
                    // A slightly larger range than necessary, so that rounding does not lose a link.
                    links.extend((self.lifts.shifts(theta - 0.1, theta + 0.1)).filter_map(
                        |slabs| self.lifted(&c, slabs, &self.lifts.steps.motion(slabs)),
                    ));
                }
                links
            }),
        };
        let mut links = one_list(lifted);
        sort_vertical(&mut links);
        links
    }

    /// The contacts, of those given, that make links. Contacts within one chain, which most are, make none, unless a chain meets itself
    /// around the turn without being closed.
    fn crossings<'v>(&self, contacts: &'v [VerticalContact]) -> Vec<Crossing<'v>> {
        let crossing = |contact: &'v VerticalContact| {
            let (lower, upper) = (self.member(contact.lower)?, self.member(contact.upper)?);
            let shift = i64::from(self.linker.is_wrap(contact.lower));
            let below = (lower.chain, -lower.slabs());
            let above = (upper.chain, shift - upper.slabs());
            let chain = &self.chains.chains[lower.chain as usize];
            let within = below.0 == above.0
                && self.lifts.is_one_copy(below.0, below.1, above.1)
                && (chain.closed || chain.last != contact.lower);
            (!within).then(|| Crossing {
                contact,
                below,
                above,
                curve: self.linker.curve(contact.lower, contact.at),
            })
        };
        contacts.iter().filter_map(crossing).collect()
    }

    /// The link that a contact makes in one period, of which the motion is given.
    fn lifted(&self, c: &Crossing<'_>, slabs: i64, motion: &SlabMotion) -> Option<VerticalLink> {
        let lower = self.lifts.patch(c.below.0, slabs + c.below.1)?;
        let upper = self.lifts.patch(c.above.0, slabs + c.above.1)?;
        // Place of the contact in the lower cell's period.
        let place = ClusterInPeriod {
            cluster: c.contact.at,
            slabs: 0,
        };
        let theta = self.lifts.orientation(place, slabs);
        self.lifts.is_inside(theta).then(|| VerticalLink {
            lower: PatchId(lower),
            upper: PatchId(upper),
            theta,
            overlap: CurveGeometry::from_inner(
                &motion.curve(&c.curve),
                c.contact.lo,
                c.contact.hi,
                &self.linker.geometry.frame,
                theta,
            ),
        })
    }
}

/// Sorts the links of one chain by the patch before, the orientation, and the patch after; joins links that are connected.
fn joined(own: &mut Vec<SideLink>) {
    if own.len() < 2 {
        return;
    }
    own.sort_by(|a, b| {
        (a.before, a.after)
            .cmp(&(b.before, b.after))
            .then(a.lo.total_cmp(&b.lo))
    });
    // Where a patch goes around the turn, pieces that a window cuts from several copies are connected.
    own.dedup_by(|next, last| {
        let joined =
            (last.before, last.after) == (next.before, next.after) && next.lo - last.hi <= SAME;
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
}

/// Concatenates lists. Each is dropped when it has been appended, so that they are not all in memory twice.
fn one_list<T>(parts: Vec<Vec<T>>) -> Vec<T> {
    let mut all = Vec::with_capacity(parts.iter().map(Vec::len).sum());
    for part in parts {
        all.extend(part);
    }
    all
}

/// Sort key of a vertical link, and the link's number, by which equal links keep their order.
#[derive(Clone, Copy)]
struct Key {
    theta: f64,
    lower: PatchId,
    upper: PatchId,
    number: u32,
}

/// Sorts by orientation and patches. Links are large, so the keys are sorted, and then the links are permuted in place.
fn sort_vertical(links: &mut [VerticalLink]) {
    let mut keys: Vec<Key> = ((0u32..).zip(&*links))
        .map(|(number, l)| Key {
            theta: l.theta,
            lower: l.lower,
            upper: l.upper,
            number,
        })
        .collect();
    parallel::sort_unstable_by(&mut keys, |a, b| {
        (a.theta.total_cmp(&b.theta))
            .then((a.lower, a.upper, a.number).cmp(&(b.lower, b.upper, b.number)))
    });
    // Permutes cycle by cycle; a number that is its own place is done.
    for start in 0..links.len() {
        let (first, mut place) = (links[start], start);
        loop {
            let from = core::mem::replace(&mut keys[place].number, place as u32) as usize;
            if from == start || from == place {
                links[place] = first;
                break;
            }
            links[place] = links[from];
            place = from;
        }
    }
}
