//! Classification of a configuration, and the contacts there.

use super::condition::Condition;
use super::motion::{Extent, brought_between};
use super::patches::{AxesBranch, AxesPatch, BranchForm};
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;
use crate::ids::{PatchId, RegionId};
use crate::query::{Classification, Location};

/// Distance from a curve above which a configuration at which its function vanishes, up to the resolution, is tested itself (radians or
/// length of the frame): the square root of rounding, which is the possible error of a place beside a tangency.
const ASTRAY: f64 = 1e-7;

impl FixedAxesSpace {
    /// Classifies a configuration: contact if a contact function of the boundary there is within the [`resolution`](Self::resolution),
    /// otherwise by the free gaps at u, or by intersecting the placed parts if the space has [conflicts](super::AxesStatistics::conflicts).
    /// `None` outside the ranges of motion (for a part that does not move, only 0 is inside), or if the configuration is not finite.
    pub fn classify(&self, u: f64, v: f64) -> Option<Classification> {
        self.locate(u, v).class()
    }

    /// Classifies a configuration, as [`classify`](Self::classify) says, with the free region that contains a free one: two free
    /// configurations can be joined by a motion if and only if they are in one region.
    ///
    /// ```
    /// use cspace::{Axis, FixedAxesSpace, Location, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// // It cannot come to the other side of the wall.
    /// assert_ne!(space.locate(0.0, 0.0), space.locate(0.0, -10.0));
    /// assert_eq!(space.locate(0.0, -5.0), Location::Blocked);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn locate(&self, u: f64, v: f64) -> Location {
        let Some((x, y)) = self.setting.placed(u, v) else {
            return Location::Outside;
        };
        if self.is_touching(x, y) {
            return Location::Contact;
        }
        // Beyond the window nothing touches: a straight motion leads to its border.
        let into = |t: f64, extent: &Extent| t.clamp(extent.lo, extent.hi);
        let nearest = || {
            let (x, y) = (into(x, &self.setting.x), into(y, &self.setting.y));
            self.gaps().region_nearest(x, y)
        };
        let region = match self.data.statistics.conflicts > 0 {
            true if self.setting.bodies.overlap(x, y) => None,
            true => nearest(),
            false if self.gaps().is_beyond(x, y) => nearest(),
            false => self.gaps().region(x, y),
        };
        region.map_or(Location::Blocked, |r| Location::Free(RegionId(r)))
    }

    /// Whether a configuration is finite and within the ranges of motion.
    pub(crate) fn covers(&self, u: f64, v: f64) -> bool {
        self.setting.placed(u, v).is_some()
    }

    /// The patches that touch at (u, v) within `tolerance` (model length), with the values of their contact functions; the nearest first.
    /// Empty outside the ranges of motion.
    pub fn contacts(&self, u: f64, v: f64, tolerance: f64) -> Vec<(PatchId, f64)> {
        let Some((x, y)) = self.setting.placed(u, v) else {
            return Vec::new();
        };
        let reach = tolerance * self.setting.map.frame.scale;
        let near = reach.max(NEAR);
        self.contacts_among(self.by_x.between(x - near, x + near), (x, y), reach)
    }

    /// Whether a patch touches at (u, v) within `tolerance` (model length). False outside the ranges of motion, and if there is no such
    /// patch.
    pub fn is_on(&self, patch: PatchId, u: f64, v: f64, tolerance: f64) -> bool {
        let (Some((x, y)), Some(patch)) = (
            self.setting.placed(u, v),
            self.data.patches.get(patch.index()),
        ) else {
            return false;
        };
        let reach = tolerance * self.setting.map.frame.scale;
        patch.branches.clone().any(|b| {
            let cell = self.data.branches[b as usize].cell;
            self.touch(cell, x, y, reach.max(NEAR), reach).is_some()
        })
    }

    /// The patches in contact among those of some branches.
    fn contacts_among(
        &self,
        branches: impl IntoIterator<Item = u32>,
        (x, y): (f64, f64),
        reach: f64,
    ) -> Vec<(PatchId, f64)> {
        let branches = branches.into_iter().map(|b| self.data.branches[b as usize]);
        let mut found: Vec<(PatchId, f64)> = branches
            .filter_map(|b| {
                let value = self.touch(b.cell, x, y, reach.max(NEAR), reach)?;
                Some((b.patch, value / self.setting.map.frame.scale))
            })
            .collect();
        let nearer = |a: &(PatchId, f64), b: &(PatchId, f64)| a.1.abs().total_cmp(&b.1.abs());
        found.sort_by(|a, b| a.0.cmp(&b.0).then(nearer(a, b)));
        found.dedup_by_key(|f| f.0);
        found.sort_by(|a, b| nearer(a, b).then(a.0.cmp(&b.0)));
        found
    }

    /// Whether a configuration is within the resolution of the free boundary.
    pub(super) fn is_touching(&self, x: f64, y: f64) -> bool {
        let distance = self.setting.inner_contact_distance();
        self.by_x.any(x - distance, x + distance, |branch| {
            let cell = self.data.branches[branch as usize].cell;
            // A corner that is almost on a pivot has nearly the same distance from a side everywhere, also deep in blocked space.
            self.touch(cell, x, y, distance, distance).is_some()
                && (self.above_curve(cell, x, y).abs() <= ASTRAY
                    || !self.setting.bodies.overlap(x, y))
        })
    }

    /// Whether a configuration is in a cell's box extended by `reach`.
    pub(super) fn in_box(&self, cell: u32, x: f64, y: f64, reach: f64) -> bool {
        let (x_range, y_range) = self.graphs().cell_box(cell);
        self.setting.x.brought(x, x_range, reach).is_some()
            && self.setting.y.brought(y, y_range, reach).is_some()
    }

    /// The contact function of a cell, if it touches at a configuration: the function vanishes up to `within`, and the cell's curve is no
    /// farther than `reach`.
    fn touch(&self, cell: u32, x: f64, y: f64, reach: f64, within: f64) -> Option<f64> {
        let value = self.graphs().condition(cell).value(x, y);
        let near = value.abs() <= within && self.in_box(cell, x, y, reach);
        (near && self.on_own_root(cell, x, y, within)).then_some(value)
    }

    /// Whether a configuration at which the contact function of a cell vanishes, up to `within`, is on the cell's curve.
    ///
    /// At one x the function is a parabola or a cosine of y and has a second root, which may be in the cell's box as well, deep in blocked
    /// space. Between the two it has an extremum in the middle.
    pub(super) fn on_own_root(&self, cell: u32, x: f64, y: f64, within: f64) -> bool {
        // On the shorter arc between the roots the function varies less.
        let middle = y - 0.5 * self.above_curve(cell, x, y);
        let condition = self.graphs().condition(cell);
        condition.value(x, middle).abs() <= within.max(condition.value(x, y).abs())
    }

    /// Signed distance of a configuration above a cell's curve along y, the shorter way around; 0 for a vertical cell.
    fn above_curve(&self, cell: u32, x: f64, y: f64) -> f64 {
        let graphs = self.graphs();
        let (c, p) = graphs.cell(cell);
        if p.vertical {
            return 0.0;
        }
        let middle = 0.5 * (c.from + c.to);
        let x = middle + self.setting.x.apart(x, middle);
        graphs.y.apart(y, graphs.at(cell, x))
    }
}

// Contact curves for users: points, derivatives and contact functions.

impl FixedAxesSpace {
    /// The contact curves that bound free space.
    pub fn patches(&self) -> &[AxesPatch] {
        &self.data.patches
    }

    /// The branches of the contact curves.
    pub fn branches(&self) -> &[AxesBranch] {
        &self.data.branches
    }

    /// The point of a branch at a value of its independent coordinate ([`AxesBranch::form`]), in closed form, and the derivative of the
    /// dependent coordinate by it. A value outside the branch's interval is moved to its end. `None` if there is no such branch.
    ///
    /// For line against arc and for two arcs, on a part that turns, a cos t + b sin t = c is solved, otherwise a linear or quadratic
    /// equation. The derivative is −(∂f/∂u) / (∂f/∂v) or its inverse; not finite where the curve turns around.
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
    pub fn contact_function(&self, patch: PatchId, u: f64, v: f64) -> Option<f64> {
        let condition = self.condition_of(patch)?;
        let (x, y) = self.setting.map.inner(u, v);
        Some(condition.value(x, y) / self.setting.map.frame.scale)
    }

    /// Its derivatives by u and by v.
    pub fn contact_gradient(&self, patch: PatchId, u: f64, v: f64) -> Option<(f64, f64)> {
        let condition = self.condition_of(patch)?;
        let (x, y) = self.setting.map.inner(u, v);
        let (by_x, by_y) = condition.gradient(x, y);
        let (by_u, by_v) = self.setting.map.exchanged(by_x, by_y);
        let unit = self.setting.map.units();
        let scale = self.setting.map.frame.scale;
        Some((by_u / (scale * unit.0), by_v / (scale * unit.1)))
    }

    fn condition_of(&self, patch: PatchId) -> Option<&Condition> {
        let first = self.data.patches.get(patch.index())?.branches.start;
        let cell = self.data.branches.get(first as usize)?.cell;
        Some(self.graphs().condition(cell))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::fixed_axes::FixedAxesSpace;
    use crate::fixed_axes::axis::Axis;
    use crate::geometry::{Point, Vector};
    use crate::ids::PatchId;
    use crate::part::{Part, Vertex};

    /// Pairs for which x and y run over a turn, between limits, and without limits.
    fn spaces() -> Vec<FixedAxesSpace> {
        let star = |x: f64, teeth: u32| {
            let at = |k: u32| {
                let p = Vector::from_angle(core::f64::consts::PI * f64::from(k) / f64::from(teeth));
                let p = p * if k.is_multiple_of(2) { 1.0 } else { 0.7 };
                Vertex::line(x + p.x, p.y)
            };
            Part::new("star", vec![(0..2 * teeth).map(at).collect()]).unwrap()
        };
        let turn = |x: f64| Axis::revolute(Point::new(x, 0.0));
        let slide = |x: f64, y: f64| Axis::prismatic(Vector::new(x, y));
        let of = |x: f64, a: Axis, b: Axis| {
            FixedAxesSpace::compute(&star(0.0, 5), a, &star(x, 4), b).unwrap()
        };
        vec![
            of(1.8, turn(0.1), turn(1.8)),
            of(1.8, turn(0.1), turn(1.8).within(-1.0, 7.5)),
            of(1.8, turn(0.1).within(-4.0, 4.0), slide(0.6, 0.8)),
            of(1.8, slide(0.6, 0.8).within(-1.0, 1.0), turn(1.8)),
            of(2.5, slide(0.0, 1.0), slide(1.0, 0.0)),
            of(2.5, slide(1.0, 0.0), slide(1.0, 0.0)),
            of(1.8, Axis::FIXED, turn(1.7)),
            of(1.8, turn(0.1), Axis::FIXED),
        ]
    }

    /// The answers equal those from all branches, to the last bit.
    #[test]
    fn slots_hold_all_that_is_near() {
        let (mut touching, mut nearest) = (0, 0);
        for space in spaces() {
            let all = || 0..space.data.branches.len() as u32;
            let (x, y) = (space.setting.x, space.setting.y);
            // Some at the ends of the extents, some between, in irrational ratios.
            let shares = (1..60).map(|k| (f64::from(k) * 0.754_877_666).fract());
            let shares = shares.chain([0.0, 1e-13, 1e-10, 1.0 - 1e-10, 1.0]);
            for (i, share) in shares.enumerate() {
                let other = (f64::from(i as u32) * 0.569_840_291).fract();
                for (s, t) in [(share, other), (other, share)] {
                    let at = (x.lo + s * (x.hi - x.lo), y.lo + t * (y.hi - y.lo));
                    for tolerance in [1e-9, 0.01, 0.3, 10.0] {
                        let scale = space.setting.map.frame.scale;
                        let (u, v) = space.setting.outer(at.0, at.1);
                        let Some(placed) = space.setting.placed(u, v) else {
                            continue;
                        };
                        let asked = space.contacts(u, v, tolerance);
                        assert_eq!(
                            asked,
                            space.contacts_among(all(), placed, tolerance * scale)
                        );
                        for patch in (0..space.data.patches.len() as u32).map(PatchId) {
                            let is_told = asked.iter().any(|a| a.0 == patch);
                            assert_eq!(space.is_on(patch, u, v, tolerance), is_told);
                        }
                        touching += asked.len();
                    }
                    let (u, v) = space.setting.outer(at.0, at.1);
                    let asked = space.nearest_contact(u, v);
                    assert_eq!(asked, space.nearest_among(|_, _| all().collect(), u, v));
                    nearest += usize::from(asked.is_some());
                }
            }
        }
        assert!(touching > 1000 && nearest > 100, "{touching} {nearest}");
    }
}
