//! The shortest way along a surface of the contact space, from patch to patch over their links.

use core::f64::consts::TAU;
use std::collections::{BTreeMap, BinaryHeap};

use cspace::{PatchId, Point};

use crate::legs::Coords;
use crate::open::Open;

use super::planar::Planar;
use super::station::{Across, Station, share_of};

/// Links are passed this share of their length away from their ends.
const MARGIN: f64 = 0.25;

/// A patch that the search has come to.
#[derive(Debug, Clone, Copy)]
struct Reached {
    length: f64,
    entry: Station,
    turn: f64,
    /// The patch before, and where it was left.
    before: Option<(PatchId, Station)>,
    done: bool,
}

impl Planar<'_> {
    /// The configuration at a station.
    fn place(&self, patch: PatchId, at: Station, turn: f64) -> Coords {
        let p = self
            .curve(patch, at.theta)
            .map_or(Point::ORIGIN, |c| c.point(at.share));
        self.numbers(p, at.theta + turn)
    }

    /// A way from a station on one patch, whose orientations count `turn` more, to a station on another of the same surface.
    pub(super) fn walk(
        &self,
        (first, entry, turn): (PatchId, Station, f64),
        (last, exit): (PatchId, Station),
    ) -> Option<Vec<Across>> {
        let goal = self.place(last, exit, 0.0);
        let lever = self.scene.levers()[2];
        let apart = |a: Coords, b: Coords, around: bool| {
            let turned = a[2] - b[2];
            let turned = if around {
                turned - TAU * (turned / TAU).round()
            } else {
                turned
            };
            (a[0] - b[0]).hypot(a[1] - b[1]) + lever * turned.abs()
        };
        let mut reached: BTreeMap<PatchId, Reached> = BTreeMap::new();
        let mut open = BinaryHeap::new();
        reached.insert(
            first,
            Reached {
                length: 0.0,
                entry,
                turn,
                before: None,
                done: false,
            },
        );
        open.push(Open {
            cost: 0.0,
            state: first,
        });
        // What is open costs the length to it and what is at least ahead.
        while let Some(Open { state: patch, .. }) = open.pop() {
            let here = reached.get_mut(&patch)?;
            if here.done {
                continue;
            }
            here.done = true;
            let here = *here;
            if patch == last {
                return Some(unrolled(&reached, last, exit));
            }
            let from = self.place(patch, here.entry, here.turn);
            self.links(patch, here.entry, |next, leave, entry| {
                let turn = here.turn + leave.theta - entry.theta;
                let at = self.place(next, entry, turn);
                let length = here.length + apart(from, at, false);
                let known = reached.get(&next);
                if known.is_some_and(|k| k.done || k.length <= length) {
                    return;
                }
                reached.insert(
                    next,
                    Reached {
                        length,
                        entry,
                        turn,
                        before: Some((patch, leave)),
                        done: false,
                    },
                );
                open.push(Open {
                    cost: length + apart(at, goal, true),
                    state: next,
                });
            });
        }
        None
    }

    /// Calls `with` for every link of a patch: the patch beyond, where this one is left and where that one is entered.
    fn links(
        &self,
        patch: PatchId,
        from: Station,
        mut with: impl FnMut(PatchId, Station, Station),
    ) {
        let space = self.space();
        let mut side = |next: PatchId, (lo, hi): (f64, f64), (leave, enter): (f64, f64)| {
            let lo = self.brought(patch, lo);
            let hi = lo
                + (hi - lo)
                    .min(space.patches()[patch.index()].hi - lo)
                    .max(0.0);
            let margin = MARGIN * (hi - lo);
            let theta = from
                .theta
                .clamp(lo + margin, (hi - margin).max(lo + margin));
            let there = self.brought(next, theta);
            with(
                next,
                Station {
                    theta,
                    share: leave,
                },
                Station {
                    theta: there,
                    share: enter,
                },
            );
        };
        for l in space.links_after(patch) {
            side(l.after, (l.lo, l.hi), (1.0, 0.0));
        }
        for l in space.links_before(patch) {
            side(l.before, (l.lo, l.hi), (0.0, 1.0));
        }
        let vertical = space.links_above(patch).map(|l| (l.upper, l));
        for (next, l) in vertical.chain(space.links_below(patch).map(|l| (l.lower, l))) {
            let theta = self.brought(patch, l.theta);
            let there = self.brought(next, l.theta);
            let (Some(own), Some(other)) = (self.curve(patch, theta), self.curve(next, there))
            else {
                continue;
            };
            // As far along as the way has come, within what the two share.
            let shares = [0.0, 1.0].map(|s| share_of(&own, l.overlap.point(s)));
            let (lo, hi) = (shares[0].min(shares[1]), shares[0].max(shares[1]));
            let margin = MARGIN * (hi - lo);
            let share = from.share.clamp(lo + margin, hi - margin);
            let enter = share_of(&other, own.point(share));
            with(
                next,
                Station { theta, share },
                Station {
                    theta: there,
                    share: enter,
                },
            );
        }
    }
}

fn unrolled(reached: &BTreeMap<PatchId, Reached>, last: PatchId, exit: Station) -> Vec<Across> {
    let mut walk = Vec::new();
    let (mut patch, mut leave) = (last, exit);
    while let Some(here) = reached.get(&patch) {
        walk.push(Across {
            patch,
            turn: here.turn,
            entry: here.entry,
            exit: leave,
        });
        match here.before {
            Some((before, left)) => (patch, leave) = (before, left),
            None => break,
        }
    }
    walk.reverse();
    walk
}
