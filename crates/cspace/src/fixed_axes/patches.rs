//! Makes patches of chains of cells: their branches, and the region that each bounds.

use super::arrange::{Cell, Stop};
use super::motion::Extent;
use super::piece::{Name, Pair, Piece};
use super::setup::Setting;
use super::sweep::{Gaps, Graphs};
use super::tolerance::NEAR;
use crate::feature::FeatureName;
use crate::ids::{PatchId, RegionId};

/// Data from which patches are made.
pub(super) struct Patches<'a> {
    pub(super) setting: &'a Setting,
    pub(super) gaps: Gaps<'a>,
}

impl Patches<'_> {
    /// The patches and their branches.
    pub(super) fn of(&self, mut chains: Vec<Chain>) -> (Vec<AxesPatch>, Vec<AxesBranch>) {
        let swapped = self.setting.map.swapped;
        let (firsts, seconds) = &self.setting.names;
        if swapped {
            // Exchanging the coordinates exchanges left and right.
            for c in &mut chains {
                c.cells.reverse();
                core::mem::swap(&mut c.previous, &mut c.next);
            }
        }
        let regions = self.regions_of_cells(&chains);
        let (mut patches, mut branches) = (Vec::new(), Vec::new());
        for (chain, region) in chains.iter().zip(regions) {
            let first = branches.len() as u32;
            for &cell in &chain.cells {
                branches.push(self.branch(PatchId(patches.len() as u32), cell));
            }
            let pair = &self.gaps.graphs.pairs[chain.pair as usize];
            let (a, b) = (firsts[pair.first as usize], seconds[pair.second as usize]);
            let (fixed, moving) = if swapped { (b, a) } else { (a, b) };
            patches.push(AxesPatch {
                fixed,
                moving,
                branches: first..branches.len() as u32,
                previous: chain.previous.map(PatchId),
                next: chain.next.map(PatchId),
                region: region.map(RegionId),
            });
        }
        (patches, branches)
    }

    fn branch(&self, patch: PatchId, cell: u32) -> AxesBranch {
        let graphs = self.gaps.graphs;
        let (c, p) = graphs.cell(cell);
        let swapped = self.setting.map.swapped;
        let forward = goes_up(p) != swapped;
        let end = |at_end| {
            let (x, y) = end_of(c, p, graphs.pairs, at_end);
            self.setting.outer(x, y)
        };
        AxesBranch {
            patch,
            form: if p.vertical == swapped {
                BranchForm::VOfU
            } else {
                BranchForm::UOfV
            },
            start: end(!forward),
            end: end(forward),
            cell,
        }
    }

    /// For every chain, the region it bounds: that of a gap beside one of its cells.
    fn regions_of_cells(&self, chains: &[Chain]) -> Vec<Option<u32>> {
        let mut of_cell: Vec<Option<u32>> = vec![None; self.gaps.graphs.cells.len()];
        for gap in self.gaps.gaps {
            for cell in [gap.lower, gap.upper].into_iter().flatten() {
                of_cell[cell as usize] = Some(gap.region);
            }
        }
        let mut regions: Vec<Option<u32>> = (chains.iter())
            .map(|chain| {
                // Vertical cells get it from the gap on their free side. If two cells coincide up to rounding, only one of them bounds a
                // gap.
                let cells = || chain.cells.iter();
                (cells().find_map(|&i| of_cell[i as usize]))
                    .or_else(|| cells().find_map(|&i| self.beside_vertical(i)))
                    .or_else(|| cells().find_map(|&i| self.beside_graph(i)))
            })
            .collect();
        // Beside a cell that is too short or too steep no gap is found: its neighbours in the chain bound the same region.
        for i in 0..chains.len() {
            let towards = |step: fn(&Chain) -> Option<u32>| {
                core::iter::successors(Some(i), |&j| step(&chains[j]).map(|k| k as usize))
                    .take(chains.len())
                    .find_map(|j| regions[j])
            };
            regions[i] = towards(|c| c.previous).or_else(|| towards(|c| c.next));
        }
        regions
    }

    /// The region just beside a graph, on its free side.
    fn beside_graph(&self, cell: u32) -> Option<u32> {
        let graphs = self.gaps.graphs;
        let (c, p) = graphs.cell(cell);
        if p.vertical {
            return None;
        }
        let x = 0.5 * (c.from + c.to);
        let up = if p.root == 0 { NEAR } else { -NEAR };
        let y = p.y(graphs.pairs, x) + up;
        self.gaps.region(self.gaps.x.folded(x), graphs.y.folded(y))
    }

    /// The region just beside a vertical cell, on its free side.
    fn beside_vertical(&self, cell: u32) -> Option<u32> {
        let graphs = self.gaps.graphs;
        let (c, p) = graphs.cell(cell);
        if !p.vertical {
            return None;
        }
        let y = 0.5 * (c.from + c.to);
        let bands = self.gaps.bands;
        let right = p.root == 0;
        let after = bands.partition_point(|b| 0.5 * (b.lo + b.hi) < p.start.x);
        let (inside, around) = if right {
            (bands.get(after), bands.first())
        } else {
            let before = after.checked_sub(1);
            (before.and_then(|k| bands.get(k)), bands.last())
        };
        let band = inside.or(around.filter(|_| self.gaps.x.is_circle()))?;
        let x = if right { band.lo } else { band.hi };
        self.gaps.region_in(band, x, y)
    }
}

// Contact curves as patches; a pair on fixed axes has only one band.

/// A contact curve: one pair of features touches along it, on the boundary of free space.
///
/// It is traversed with blocked space on its left and free space on its right in the (u, v) plane. It has no upper or lower neighbours;
/// where it ends without a neighbour, a motion is at its limit (section 3.2 of Sacks 1999).
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesPatch {
    /// The feature of the fixed part.
    pub fixed: FeatureName,
    /// The feature of the moving part.
    pub moving: FeatureName,
    /// Its branches, as indices into [`FixedAxesSpace::branches`](super::FixedAxesSpace::branches), in order of travel.
    pub branches: core::ops::Range<u32>,
    /// The contact curve before it, on its left side.
    pub previous: Option<PatchId>,
    /// The contact curve after it.
    pub next: Option<PatchId>,
    /// The free region it bounds.
    pub region: Option<RegionId>,
}

/// Direction of the function on a branch: v of u, or u of v.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum BranchForm {
    /// v is a monotone function of u, or constant.
    VOfU,
    /// u is a monotone function of v, or constant.
    UOfV,
}

/// A piece of a contact curve on which one coordinate is a monotone function of the other, in closed form.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesBranch {
    /// Contact curve of the branch.
    pub patch: PatchId,
    /// Which coordinate is a function of the other.
    pub form: BranchForm,
    /// The configuration (u, v) at which travel along it begins; v and u are continuous along the branch.
    pub start: (f64, f64),
    /// The configuration at which it ends.
    pub end: (f64, f64),
    /// The cell of the arrangement.
    pub(super) cell: u32,
}

// Free cells in order along the boundary of free space.

/// Distance of ends without a common name below which they follow each other (radians or length): three curves through one point, or lines
/// that continue each other.
const SAME_PLACE: f64 = 1e-8;

/// One contact curve: consecutive free cells of one pair of features, in order of travel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain {
    pub(super) pair: u32,
    pub(super) cells: Vec<u32>,
    pub(super) previous: Option<u32>,
    pub(super) next: Option<u32>,
}

/// Whether travel along a cell, with blocked space on the left and free space on the right, increases its parameter.
pub(super) fn goes_up(piece: &Piece) -> bool {
    // Above is right of leftward travel; right is right of upward travel.
    (piece.root == 0) == piece.vertical
}

/// The configuration at an end of a cell.
pub(super) fn end_of(cell: &Cell, piece: &Piece, pairs: &[Pair], at_end: bool) -> (f64, f64) {
    let t = if at_end { cell.to } else { cell.from };
    if piece.vertical {
        (piece.start.x, t)
    } else {
        (t, piece.y(pairs, t))
    }
}

/// Finds the successor of each free cell, and joins cells of the same features, according to `same`, to curves.
pub(super) fn chains(
    graphs: &Graphs<'_>,
    x: &Extent,
    joints: &[[(u32, bool); 2]],
    same: impl Fn(&Pair, &Pair) -> bool,
) -> Vec<Chain> {
    const NONE: u32 = u32::MAX;
    let (cells, pairs) = (graphs.cells, graphs.pairs);
    let piece = |i: u32| graphs.piece(i);
    let leaves = |(i, at_end): (u32, bool)| goes_up(piece(i)) == at_end;
    let mut next = vec![NONE; cells.len()];
    let mut previous = vec![NONE; cells.len()];
    for &[a, b] in joints {
        if leaves(a) == leaves(b) {
            continue;
        }
        let (from, to) = if leaves(a) { (a.0, b.0) } else { (b.0, a.0) };
        next[from as usize] = to;
        previous[to as usize] = from;
    }
    // Remaining ends are matched by their places.
    let all = || 0..cells.len() as u32;
    let place = |i: u32, leaving: bool| {
        end_of(
            &cells[i as usize],
            piece(i),
            pairs,
            goes_up(piece(i)) == leaving,
        )
    };
    let stop = |i: u32, leaving: bool| {
        let c = &cells[i as usize];
        if goes_up(piece(i)) == leaving {
            c.end
        } else {
            c.start
        }
    };
    let at_limit = |i: u32, leaving: bool| matches!(stop(i, leaving), Stop::Node(key) if key.name == Name::Limit);
    let open: Vec<u32> = all()
        .filter(|&i| previous[i as usize] == NONE && !at_limit(i, false))
        .collect();
    let leaving: Vec<u32> = all()
        .filter(|&i| next[i as usize] == NONE && !at_limit(i, true))
        .collect();
    for i in leaving {
        let (u, v) = place(i, true);
        let near = open
            .iter()
            .copied()
            .filter(|&j| previous[j as usize] == NONE)
            .map(|j| {
                let (s, t) = place(j, false);
                (x.apart(s, u).hypot(graphs.y.apart(t, v)), j)
            })
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if let Some((_, j)) = near.filter(|n| n.0 < SAME_PLACE) {
            next[i as usize] = j;
            previous[j as usize] = i;
        }
    }
    let pair = |i: u32| piece(i).pair;
    // A curve starts where the pair of features changes, and where it crosses itself.
    let continues = |from: u32, to: u32| {
        same(&pairs[pair(from) as usize], &pairs[pair(to) as usize])
            && matches!(stop(from, true), Stop::Node(_))
            && matches!(stop(to, false), Stop::Node(_))
    };
    let mut of_cell = vec![NONE; cells.len()];
    let mut chains: Vec<Chain> = Vec::new();
    let first = |i: u32| {
        let before = previous[i as usize];
        before == NONE || !continues(before, i)
    };
    // First curves with a beginning, then closed curves.
    for i in all().filter(|&i| first(i)).chain(all()) {
        if of_cell[i as usize] != NONE {
            continue;
        }
        let mut members = Vec::new();
        let mut at = i;
        loop {
            of_cell[at as usize] = chains.len() as u32;
            members.push(at);
            let after = next[at as usize];
            if after == NONE || of_cell[after as usize] != NONE || !continues(at, after) {
                break;
            }
            at = after;
        }
        chains.push(Chain {
            pair: pair(i),
            cells: members,
            previous: None,
            next: None,
        });
    }
    for chain in &mut chains {
        let (Some(&from), Some(&to)) = (chain.cells.first(), chain.cells.last()) else {
            continue;
        };
        // A missing neighbour is `None` in the result, not the marker of this function.
        let of = |i: u32| {
            let chain = of_cell.get(i as usize).copied();
            chain.filter(|&c| c != NONE)
        };
        chain.previous = of(previous[from as usize]);
        chain.next = of(next[to as usize]);
    }
    chains
}
