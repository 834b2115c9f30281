//! The nearest contact when one part is moved and the other held.

use super::motion::{Extent, Motion, brought_between};
use super::place::crossing_of_level;
use super::ranges::Ranges;
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;
use crate::ids::PatchId;
use core::f64::consts::TAU;

/// The contact nearest to a configuration when only one part is moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestOnAxes {
    /// Contact curve of the contact.
    pub patch: PatchId,
    /// The configuration (u, v) in contact.
    pub at: (f64, f64),
    /// Displacement of the part: radians if it turns, length if it slides.
    pub distance: f64,
}

impl FixedAxesSpace {
    /// The contact nearest to (u, v), free or blocked, when only the moving part is moved and u is constant. If the moving part cannot
    /// move, the fixed part is moved and v is constant. For a free configuration this is the play to the nearer side.
    ///
    /// `None` outside the ranges of motion, or if the motion of the part leads to no contact.
    ///
    /// Along each branch the other coordinate is a monotone function in closed form, or is solved for by halving.
    ///
    /// ```
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(-1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// let nearest = space.nearest_contact(0.0, 1.0).ok_or("there is one")?;
    /// assert!((nearest.distance - 2.0).abs() < 1e-9 && (nearest.at.1 - 3.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nearest_contact(&self, u: f64, v: f64) -> Option<NearestOnAxes> {
        self.nearest_among(
            |ranges, held| ranges.between(held - NEAR, held + NEAR),
            u,
            v,
        )
    }

    /// The nearest contact among the branches that `near` finds at the value that is held.
    pub(super) fn nearest_among(
        &self,
        near: impl FnOnce(&Ranges, f64) -> Vec<u32>,
        u: f64,
        v: f64,
    ) -> Option<NearestOnAxes> {
        let setting = &self.setting;
        let (x, y) = setting.placed(u, v)?;
        let first_still = setting.motions.first == Motion::Still;
        let second_still = setting.motions.second == Motion::Still;
        let swapped = setting.map.swapped;
        // x is u, unless they are exchanged.
        let moves_v = !if swapped { first_still } else { second_still };
        let one_line = setting.on_one_line();
        let moves_y = moves_v != swapped;
        // For slides along one line, only y minus a multiple of x counts: moving x changes that difference in the opposite sense.
        let rate = one_line.filter(|_| !moves_y).map_or(1.0, |share| -share);
        let along_y = moves_y || one_line.is_some();
        let (held, moved) = if along_y { (x, y) } else { (y, x) };
        let extent = if along_y { &setting.y } else { &setting.x };
        let (unit_u, unit_v) = setting.map.units();
        let unit = if moves_v { unit_v } else { unit_u };
        let ranges = if along_y { &self.by_x } else { self.by_y() };
        let mut nearest: Option<NearestOnAxes> = None;
        for branch in near(ranges, held) {
            let b = &self.data.branches[branch as usize];
            let Some(t) = self.beside(b.cell, held, moved, along_y) else {
                continue;
            };
            let by = extent.apart(t, moved) / rate * unit;
            let found = NearestOnAxes {
                patch: b.patch,
                at: if moves_v { (u, v + by) } else { (u + by, v) },
                distance: by.abs(),
            };
            if nearest.is_none_or(|n| (found.distance, found.patch) < (n.distance, n.patch)) {
                nearest = Some(found);
            }
        }
        nearest
    }

    /// The value of the moved coordinate, nearest to the given one, at which a cell has the held value.
    fn beside(&self, cell: u32, held: f64, moved: f64, along_y: bool) -> Option<f64> {
        let graphs = self.graphs();
        let (x_range, y_range) = graphs.cell_box(cell);
        let (c, p) = graphs.cell(cell);
        let of_x = (x_range, &self.setting.x);
        let of_y = (y_range, &self.setting.y);
        let (across, along) = if along_y { (of_x, of_y) } else { (of_y, of_x) };
        let (lo, hi) = across.0;
        let s = across.1.brought(held, across.0, NEAR)?;
        let s = brought_between(s, lo, hi);
        if hi - lo <= NEAR {
            // The cell is constant in the other coordinate: its nearest value is used.
            return Some(nearest_of(along.0, moved, along.1));
        }
        if along_y {
            return Some(p.y(&self.pairs, s));
        }
        if p.vertical {
            return Some(p.start.x);
        }
        Some(crossing_of_level(p, &self.pairs, (c.from, c.to), s))
    }
}

/// The value of a range that is nearest to the given one.
fn nearest_of((lo, hi): (f64, f64), t: f64, extent: &Extent) -> f64 {
    if !extent.is_circle() {
        return brought_between(t, lo, hi);
    }
    let brought = lo + (t - lo).rem_euclid(TAU);
    if brought <= hi {
        brought
    } else if extent.apart(t, lo).abs() < extent.apart(t, hi).abs() {
        lo
    } else {
        hi
    }
}
