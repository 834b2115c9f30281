//! Contact curves as a user asks them: points, derivatives and contact functions.

use super::condition::Condition;
use super::domain::brought_between;
use super::patch::{AxesBranch, AxesPatch, BranchForm};
use super::space::FixedAxesSpace;

impl FixedAxesSpace {
    /// The contact curves that bound free space.
    pub fn patches(&self) -> &[AxesPatch] {
        &self.data.patches
    }

    /// Their branches.
    pub fn branches(&self) -> &[AxesBranch] {
        &self.data.branches
    }

    /// The point of a branch at a value of its independent coordinate ([`AxesBranch::form`]), in closed form, and the
    /// derivative of the dependent coordinate by it. Brought to the branch's interval if beyond. `None` if there is no such
    /// branch.
    ///
    /// For line against arc and for two arcs, of a part that turns, a cos t + b sin t = c is solved, otherwise a linear or
    /// quadratic equation. The derivative is −(∂f/∂u) / (∂f/∂v) or its inverse; not finite where the curve turns around.
    pub fn branch_at(&self, branch: usize, t: f64) -> Option<((f64, f64), f64)> {
        let b = self.data.branches.get(branch)?;
        let graphs = self.graphs();
        let (c, p) = graphs.cell(b.cell);
        let unit = self.setting.map.units();
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
            let (by_x, by_y) = graphs.condition(b.cell).gradient(x, y);
            -by_x / by_y
        };
        Some((self.setting.outer(x, y), slope * first(!of_u) / first(of_u)))
    }

    /// The contact function of a patch at (u, v), in the model's unit of length: zero on the patch, positive on its free
    /// side (equations 1 and 2 of Sacks 1999, scaled to distances). `None` if there is no such patch.
    pub fn contact_function(&self, patch: usize, u: f64, v: f64) -> Option<f64> {
        let condition = self.condition_of(patch)?;
        let (x, y) = self.setting.map.inner(u, v);
        Some(condition.value(x, y) / self.setting.map.frame.scale)
    }

    /// Its derivatives by u and by v.
    pub fn contact_gradient(&self, patch: usize, u: f64, v: f64) -> Option<(f64, f64)> {
        let condition = self.condition_of(patch)?;
        let (x, y) = self.setting.map.inner(u, v);
        let (by_x, by_y) = condition.gradient(x, y);
        let (by_u, by_v) = if self.setting.map.swapped {
            (by_y, by_x)
        } else {
            (by_x, by_y)
        };
        let unit = self.setting.map.units();
        let scale = self.setting.map.frame.scale;
        Some((by_u / (scale * unit.0), by_v / (scale * unit.1)))
    }

    fn condition_of(&self, patch: usize) -> Option<&Condition> {
        let first = self.data.patches.get(patch)?.branches.start;
        let cell = self.data.branches.get(first as usize)?.cell;
        Some(self.graphs().condition(cell))
    }
}
