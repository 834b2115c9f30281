//! Chains of cells made patches: their branches, and the region that each bounds.

use super::chain::{Chain, end_of, goes_up};
use super::gaps::Gaps;
use super::patch::{AxesBranch, AxesPatch, BranchForm};
use super::setting::Setting;
use super::tolerance::NEAR;

/// What patches are made with.
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
                branches.push(self.branch(patches.len() as u32, cell));
            }
            let pair = &self.gaps.graphs.pairs[chain.pair as usize];
            let (a, b) = (firsts[pair.first as usize], seconds[pair.second as usize]);
            let (fixed, moving) = if swapped { (b, a) } else { (a, b) };
            patches.push(AxesPatch {
                fixed,
                moving,
                branches: first..branches.len() as u32,
                previous: chain.previous,
                next: chain.next,
                region,
            });
        }
        (patches, branches)
    }

    fn branch(&self, patch: u32, cell: u32) -> AxesBranch {
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

    /// For every chain the region it bounds: that of a gap beside one of its cells.
    fn regions_of_cells(&self, chains: &[Chain]) -> Vec<Option<u32>> {
        let mut of_cell: Vec<Option<u32>> = vec![None; self.gaps.graphs.cells.len()];
        for gap in self.gaps.gaps {
            for cell in [gap.lower, gap.upper].into_iter().flatten() {
                of_cell[cell as usize] = Some(gap.region);
            }
        }
        let mut regions: Vec<Option<u32>> = chains
            .iter()
            .map(|c| c.cells.iter().find_map(|&i| of_cell[i as usize]))
            .collect();
        // Vertical ones have it from the gap on their free side.
        for (chain, region) in chains.iter().zip(&mut regions) {
            if region.is_none() {
                *region = chain.cells.iter().find_map(|&i| self.beside_vertical(i));
            }
        }
        // Of two on one curve, as far as rounding tells, only one bounds a gap.
        for (chain, region) in chains.iter().zip(&mut regions) {
            if region.is_none() {
                *region = chain.cells.iter().find_map(|&i| self.beside_graph(i));
            }
        }
        // Beside one that is too short or too steep there is nothing to be seen: what it follows bounds the same region.
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

    /// The region just beside a graph on its free side.
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

    /// The region just beside a vertical one on its free side.
    fn beside_vertical(&self, cell: u32) -> Option<u32> {
        let graphs = self.gaps.graphs;
        let (c, p) = graphs.cell(cell);
        if !p.vertical {
            return None;
        }
        let y = 0.5 * (c.from + c.to);
        let bands = self.gaps.bands;
        let n = bands.len();
        let right = p.root == 0;
        let after = bands.partition_point(|b| 0.5 * (b.lo + b.hi) < p.start.x);
        let k = if right {
            if after == n && self.gaps.x.is_circle() {
                0
            } else {
                after
            }
        } else if after == 0 && self.gaps.x.is_circle() {
            n.checked_sub(1)?
        } else {
            after.checked_sub(1)?
        };
        let band = bands.get(k)?;
        let x = if right { band.lo } else { band.hi };
        self.gaps.region_in(band, x, y)
    }
}
