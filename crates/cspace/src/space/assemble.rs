//! From free cells to patches and links.

use core::f64::consts::{PI, TAU};

use crate::contact::{ContactFunction, Geometry, Seam, Sheet};
use crate::geometry::{Point, Rotation};
use crate::part::Part;
use crate::slice::CurveGeometry;

use super::branch::Branch;
use super::cells::{Cell, END};
use super::clusters::Clusters;
use super::graph::{ContactSpace, FeatureCounts, SideLink, VerticalLink, Walk, Window};
use super::patch::{Boundary, Patch};
use super::regions::find_regions;
use super::shells::Shells;
use super::stats::Statistics;

/// What a bound of a cell is, in terms that do not depend on how sheets were cut: an end of features, or a crossing
/// with a feature pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum BoundKey {
    End(u32),
    Crossing {
        fixed: u32,
        moving: u32,
        root: u8,
        enters: bool,
    },
}

struct Assembler<'a> {
    geometry: &'a Geometry,
    clusters: &'a Clusters,
    branches: &'a [Branch],
    cells: &'a [Cell],
    window: Window,
}

/// A chain of cells that make one patch, as first and last cell and the turns between them.
struct Chain {
    cells: Vec<u32>,
    lo: f64,
    hi: f64,
}

#[allow(clippy::too_many_arguments)]
pub(super) fn assemble(
    fixed: &Part,
    moving: &Part,
    window: Window,
    geometry: &Geometry,
    clusters: &Clusters,
    branches: &[Branch],
    cells: &[Cell],
    shells: &Shells,
) -> ContactSpace {
    let a = Assembler {
        geometry,
        clusters,
        branches,
        cells,
        window,
    };
    let (chains, patch_of) = a.chains(shells);
    let patches: Vec<Patch> = chains.iter().map(|c| a.patch(c)).collect();
    let side_links = a.side_links(shells, &patch_of, &patches);
    let vertical_links = a.vertical_links(shells, &patch_of, &chains);
    let critical_orientations = critical_orientations(window, &patches);
    let walk = Walk::new(patches.len(), &side_links);
    let shell_of_patch: Vec<u32> = chains
        .iter()
        .map(|c| shells.shell[c.cells[0] as usize])
        .collect();
    let mut space = ContactSpace {
        fixed: fixed.clone(),
        moving: moving.clone(),
        window,
        frame: geometry.frame,
        critical_orientations,
        patches,
        side_links,
        vertical_links,
        regions: Vec::new(),
        features: FeatureCounts {
            fixed: geometry.fixed.feature_count as u32,
            moving: geometry.moving.feature_count as u32,
        },
        statistics: Statistics::default(),
        walk,
    };
    find_regions(&mut space, &shell_of_patch);
    space
}

/// Orientations at which a patch begins or ends, other than the window's own ends.
fn critical_orientations(window: Window, patches: &[Patch]) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for p in patches {
        for theta in [p.lo, p.hi] {
            if window.full_turn {
                if p.hi - p.lo < TAU {
                    all.push(normalized(theta));
                }
            } else if window.lo < theta && theta < window.hi {
                all.push(theta);
            }
        }
    }
    all.sort_by(f64::total_cmp);
    all.dedup_by(|b, a| *b - *a <= SAME_ORIENTATION);
    all
}

/// The same cluster brought home by different turns differs by rounding.
const SAME_ORIENTATION: f64 = 8.0 * f64::EPSILON;

/// Brings an orientation to [−π, π); half a turn is −π, whichever side of it rounding has it on.
fn normalized(theta: f64) -> f64 {
    let t = theta - TAU * ((theta + PI) / TAU).floor();
    if (t - PI).abs() <= SAME_ORIENTATION || (t + PI).abs() <= SAME_ORIENTATION {
        -PI
    } else if t >= PI {
        t - TAU
    } else {
        t
    }
}

impl Assembler<'_> {
    fn sheet(&self, cell: u32) -> &Sheet {
        &self.geometry.contacts.sheets[self.cells[cell as usize].sheet as usize]
    }

    fn keys(&self, cell: u32) -> [BoundKey; 2] {
        let c = &self.cells[cell as usize];
        let sheet = self.sheet(cell);
        let key = |bound: u32, end: u32| {
            if bound == END {
                return BoundKey::End(end);
            }
            let b = &self.branches[bound as usize];
            let other = &self.geometry.contacts.sheets[b.other(c.sheet) as usize];
            BoundKey::Crossing {
                fixed: other.fixed,
                moving: other.moving,
                root: self.own_root(b, c.sheet),
                enters: b.enters(c.sheet),
            }
        };
        [key(c.left, sheet.start_name), key(c.right, sheet.end_name)]
    }

    /// The name of a branch's root as seen from one of its sheets: sides are exchanged between two circles.
    fn own_root(&self, b: &Branch, sheet: u32) -> u8 {
        let sheets = &self.geometry.contacts.sheets;
        let circles = sheets[b.first as usize].is_circle() && sheets[b.second as usize].is_circle();
        if circles && b.second == sheet {
            1 - b.root
        } else {
            b.root
        }
    }

    fn is_wrap(&self, lower: u32) -> bool {
        matches!(self.sheet(lower).top, Seam::Wrap(..)) && self.cells[lower as usize].at_top
    }

    /// Chains of cells that continue each other with nothing changed, and for every cell its chain.
    fn chains(&self, shells: &Shells) -> (Vec<Chain>, Vec<u32>) {
        const NONE: u32 = u32::MAX;
        let n = self.cells.len();
        let (mut up, mut down) = (vec![NONE; n], vec![NONE; n]);
        for v in &shells.vertical {
            let (l, u) = (v.lower as usize, v.upper as usize);
            if !shells.free[l] || !shells.free[u] || up[l] != NONE || down[u] != NONE {
                continue;
            }
            let (ls, us) = (self.sheet(v.lower), self.sheet(v.upper));
            let same = ls.fixed == us.fixed
                && ls.moving == us.moving
                && self.keys(v.lower) == self.keys(v.upper);
            if same {
                up[l] = v.upper;
                down[u] = v.lower;
            }
        }
        let mut patch_of = vec![NONE; n];
        let mut chains: Vec<Chain> = Vec::new();
        let mut start_chain = |first: u32, patch_of: &mut Vec<u32>| {
            let number = chains.len() as u32;
            let mut cells = vec![first];
            let lo = self.clusters.at(self.cells[first as usize].from);
            let mut at = first;
            let mut turns = 0.0;
            patch_of[first as usize] = number;
            loop {
                let next = up[at as usize];
                if next == NONE || patch_of[next as usize] != NONE {
                    break;
                }
                turns += if self.is_wrap(at) { TAU } else { 0.0 };
                let top = self.clusters.at(self.cells[next as usize].to) + turns;
                if top - lo > TAU {
                    break;
                }
                at = next;
                patch_of[at as usize] = number;
                cells.push(at);
            }
            let turns = cells.windows(2).filter(|w| self.is_wrap(w[0])).count() as f64 * TAU;
            let hi = self.clusters.at(self.cells[at as usize].to) + turns;
            chains.push(Chain { cells, lo, hi });
        };
        // First the chains with a first cell; what is left goes around.
        for first in [true, false] {
            for i in 0..n as u32 {
                if shells.free[i as usize]
                    && patch_of[i as usize] == NONE
                    && (!first || down[i as usize] == NONE)
                {
                    start_chain(i, &mut patch_of);
                }
            }
        }
        // In the order of their first cells, whichever way they were found.
        let mut order: Vec<u32> = (0..chains.len() as u32).collect();
        order.sort_by_key(|&c| chains[c as usize].cells.iter().copied().min());
        let mut rank = vec![0u32; chains.len()];
        for (r, &c) in (0..).zip(&order) {
            rank[c as usize] = r;
        }
        for p in &mut patch_of {
            if *p != NONE {
                *p = rank[*p as usize];
            }
        }
        let mut sorted: Vec<Option<Chain>> = chains.into_iter().map(Some).collect();
        let chains = order
            .iter()
            .filter_map(|&c| sorted[c as usize].take())
            .collect();
        (chains, patch_of)
    }

    fn patch(&self, chain: &Chain) -> Patch {
        let first = chain.cells[0];
        let cell = &self.cells[first as usize];
        let sheet = self.sheet(first);
        let bound = |bound: u32, spiral| {
            if bound == END {
                return Boundary::End { spiral };
            }
            let b = &self.branches[bound as usize];
            let with: ContactFunction =
                self.geometry.contacts.sheets[b.other(cell.sheet) as usize].function();
            Boundary::Crossing {
                with,
                root: self.own_root(b, cell.sheet),
            }
        };
        let shift = if self.window.full_turn {
            normalized(chain.lo) - chain.lo
        } else {
            0.0
        };
        Patch {
            fixed: self.geometry.fixed.features[sheet.fixed as usize].name,
            moving: self.geometry.moving.features[sheet.moving as usize].name,
            function: sheet.function(),
            lo: chain.lo + shift,
            hi: chain.hi + shift,
            left: bound(cell.left, sheet.start),
            right: bound(cell.right, sheet.end),
            region: 0,
        }
    }

    fn side_links(&self, shells: &Shells, patch_of: &[u32], patches: &[Patch]) -> Vec<SideLink> {
        let mut pieces: Vec<(u32, u32, f64, f64)> = shells
            .side
            .iter()
            .filter(|s| shells.free[s.before as usize] && shells.free[s.after as usize])
            .map(|s| {
                let (before, after) = (patch_of[s.before as usize], patch_of[s.after as usize]);
                let (lo, hi) = (self.clusters.at(s.from), self.clusters.at(s.to));
                // Into the interval of the patch before.
                let p = &patches[before as usize];
                let shift = TAU * ((p.lo - 0.5 * (lo + hi)) / TAU).ceil();
                (before, after, lo + shift, hi + shift)
            })
            .collect();
        pieces.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        let mut links: Vec<SideLink> = Vec::new();
        // Clusters are at least the narrowest band apart; brought home by turns they differ by rounding.
        const SAME: f64 = crate::feature::tolerance::NARROWEST_BAND / 4.0;
        for (before, after, lo, hi) in pieces {
            match links.last_mut() {
                Some(l) if l.before == before && l.after == after && lo - l.hi <= SAME => l.hi = hi,
                _ => links.push(SideLink {
                    before,
                    after,
                    lo,
                    hi,
                }),
            }
        }
        links.sort_by(|a, b| {
            a.before
                .cmp(&b.before)
                .then(a.lo.total_cmp(&b.lo))
                .then(a.after.cmp(&b.after))
        });
        links
    }

    fn vertical_links(
        &self,
        shells: &Shells,
        patch_of: &[u32],
        chains: &[Chain],
    ) -> Vec<VerticalLink> {
        let mut links = Vec::new();
        for v in &shells.vertical {
            if !shells.free[v.lower as usize] || !shells.free[v.upper as usize] {
                continue;
            }
            let (lower, upper) = (patch_of[v.lower as usize], patch_of[v.upper as usize]);
            // Within one chain nothing happens, unless it closes upon itself around the turn.
            let chain = &chains[lower as usize];
            let inner = lower == upper && chain.cells.last() != Some(&v.lower);
            let closed = lower == upper && chain.hi - chain.lo >= TAU * (1.0 - 1e-12);
            if inner || closed {
                continue;
            }
            let theta = self.clusters.at(v.at);
            let turn = Rotation::by(theta);
            let sheet = self.sheet(v.lower);
            let curve = sheet.curve(theta, turn);
            let overlap = match sheet.function() {
                ContactFunction::Circle { .. } => {
                    CurveGeometry::from_inner(&curve, v.lo, v.hi, &self.geometry.frame, theta)
                }
                _ => {
                    let outer =
                        |p: Point| self.geometry.frame.outer_from_inner(p, theta).position();
                    CurveGeometry::Segment {
                        start: outer(curve.point(v.lo)),
                        end: outer(curve.point(v.hi)),
                    }
                }
            };
            let theta = if self.window.full_turn {
                normalized(theta)
            } else {
                theta
            };
            links.push(VerticalLink {
                lower,
                upper,
                theta,
                overlap,
            });
        }
        links.sort_by(|a, b| {
            a.theta
                .total_cmp(&b.theta)
                .then((a.lower, a.upper).cmp(&(b.lower, b.upper)))
        });
        links
    }
}
