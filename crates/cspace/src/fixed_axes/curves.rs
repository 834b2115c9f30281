//! Contact curves as a user asks them: points, derivatives and contact functions; and how they are gathered from cells.

use super::chain::{Chain, end_of, goes_up};
use super::domain::brought_between;
use super::motion::Motion;
use super::patch::{AxesBranch, AxesPatch, BranchForm};
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;

impl FixedAxesSpace {
    /// The contact curves that bound free space.
    pub fn patches(&self) -> &[AxesPatch] {
        &self.patches
    }

    /// Their branches.
    pub fn branches(&self) -> &[AxesBranch] {
        &self.branches
    }

    /// The point of a branch at a value of its independent coordinate ([`AxesBranch::form`]), in closed form, and the
    /// derivative of the dependent coordinate by it. Brought to the branch's interval if beyond. `None` if there is no such
    /// branch.
    ///
    /// For line against arc and for two arcs, of a part that turns, a cos t + b sin t = c is solved, otherwise a linear or
    /// quadratic equation. The derivative is −(∂f/∂u) / (∂f/∂v) or its inverse; not finite where the curve turns around.
    pub fn branch_at(&self, branch: usize, t: f64) -> Option<((f64, f64), f64)> {
        let b = self.branches.get(branch)?;
        let (c, p) = self.cell_and_piece(b.cell);
        let unit = self.map.units();
        let first = |of_u: bool| if of_u { unit.0 } else { unit.1 };
        let of_u = b.form == BranchForm::VOfU;
        let inner = brought_between(t / first(of_u), c.from, c.to);
        let (x, y) = if p.vertical {
            (p.start.x, inner)
        } else {
            (inner, p.y(&self.pairs, inner))
        };
        let slope = if p.vertical {
            0.0
        } else {
            let (by_x, by_y) = self.pairs[p.pair as usize].condition.gradient(x, y);
            -by_x / by_y
        };
        Some((self.outer(x, y), slope * first(!of_u) / first(of_u)))
    }

    /// The contact function of a patch at (u, v), in the model's unit of length: zero on the patch, positive on its free
    /// side (equations 1 and 2 of Sacks 1999, scaled to distances). `None` if there is no such patch.
    pub fn contact_function(&self, patch: usize, u: f64, v: f64) -> Option<f64> {
        let condition = &self.pairs[self.pair_of(patch)?].condition;
        let (x, y) = self.map.inner(u, v);
        Some(condition.value(x, y) / self.map.frame.scale)
    }

    /// Its derivatives by u and by v.
    pub fn contact_gradient(&self, patch: usize, u: f64, v: f64) -> Option<(f64, f64)> {
        let condition = &self.pairs[self.pair_of(patch)?].condition;
        let (x, y) = self.map.inner(u, v);
        let (by_x, by_y) = condition.gradient(x, y);
        let (by_u, by_v) = if self.map.swapped {
            (by_y, by_x)
        } else {
            (by_x, by_y)
        };
        let unit = self.map.units();
        let scale = self.map.frame.scale;
        Some((by_u / (scale * unit.0), by_v / (scale * unit.1)))
    }

    /// u and v of a point on a curve: 0 of a part that does not move, of which the arrangement has a strip.
    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let at = |t: f64, m: Motion| if m == Motion::Still { 0.0 } else { t };
        self.map
            .outer(at(x, self.motions.first), at(y, self.motions.second))
    }

    pub(super) fn cell_and_piece(
        &self,
        cell: u32,
    ) -> (&super::arrange::Cell, &super::piece::Piece) {
        let c = &self.cells[cell as usize];
        (c, &self.pieces[c.piece as usize])
    }

    fn pair_of(&self, patch: usize) -> Option<usize> {
        let first = self.patches.get(patch)?.branches.start;
        let cell = self.branches.get(first as usize)?.cell;
        Some(self.cell_and_piece(cell).1.pair as usize)
    }

    pub(super) fn set_patches(&mut self, mut chains: Vec<Chain>) {
        if self.map.swapped {
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
            let pair = &self.pairs[chain.pair as usize];
            let (a, b) = (
                self.names.0[pair.first as usize],
                self.names.1[pair.second as usize],
            );
            let (fixed, moving) = if self.map.swapped { (b, a) } else { (a, b) };
            patches.push(AxesPatch {
                fixed,
                moving,
                branches: first..branches.len() as u32,
                previous: chain.previous,
                next: chain.next,
                region,
            });
        }
        self.patches = patches;
        self.branches = branches;
    }

    fn branch(&self, patch: u32, cell: u32) -> AxesBranch {
        let (c, p) = self.cell_and_piece(cell);
        let forward = goes_up(p) != self.map.swapped;
        let end = |at_end| {
            let (x, y) = end_of(c, p, &self.pairs, at_end);
            self.outer(x, y)
        };
        AxesBranch {
            patch,
            form: if p.vertical == self.map.swapped {
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
        let mut of_cell: Vec<Option<u32>> = vec![None; self.cells.len()];
        for gap in &self.bands.gaps {
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
        let (c, p) = self.cell_and_piece(cell);
        if p.vertical {
            return None;
        }
        let x = 0.5 * (c.from + c.to);
        let aside = if p.root == 0 { NEAR } else { -NEAR };
        let gap = self.gap(self.x.folded(x), self.y.folded(p.y(&self.pairs, x) + aside))?;
        Some(self.bands.gaps.get(gap as usize)?.region)
    }

    /// The region just beside a vertical one on its free side.
    fn beside_vertical(&self, cell: u32) -> Option<u32> {
        let (c, p) = self.cell_and_piece(cell);
        if !p.vertical {
            return None;
        }
        let y = 0.5 * (c.from + c.to);
        let bands = &self.bands.bands;
        let n = bands.len();
        let right = p.root == 0;
        let after = bands.partition_point(|b| 0.5 * (b.lo + b.hi) < p.start.x);
        let k = if right {
            if after == n && self.x.is_circle() {
                0
            } else {
                after
            }
        } else if after == 0 && self.x.is_circle() {
            n.checked_sub(1)?
        } else {
            after.checked_sub(1)?
        };
        let band = bands.get(k)?;
        let x = if right { band.lo } else { band.hi };
        let gap = self.gap_in(k, x, y)?;
        Some(self.bands.gaps[gap as usize].region)
    }
}
