//! Is a configuration free, and what touches there?

use crate::query::Classification;

use super::bands::Graphs;
use super::domain::{ExtentKind, brought_between};
use super::motion::Motion;
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;

/// Slots of x in which the free boundary's cells are looked up.
const SLOTS: usize = 1024;
/// A configuration farther than this from a curve whose function vanishes there, but for the resolution, is looked at itself
/// (radians or length of the frame): the square root of the rounding, which a place beside a tangency may be off.
const ASTRAY: f64 = 1e-7;

impl FixedAxesSpace {
    /// Classifies a configuration: contact if a contact function of the boundary there is within the
    /// [`resolution`](Self::resolution), otherwise by the free gaps at u, or by intersecting the placed parts if the space
    /// has [conflicts](super::AxesStatistics::conflicts). `None` outside the ranges of motion, which of a
    /// part that does not move is 0 alone, or if the configuration is not finite.
    pub fn classify(&self, u: f64, v: f64) -> Option<Classification> {
        let (x, y) = self.placed(u, v)?;
        if self.touching(x, y).next().is_some() {
            return Some(Classification::Contact);
        }
        let free = if self.statistics.conflicts > 0 {
            !self.bodies.overlap(x, y)
        } else {
            self.gap(x, y).is_some()
        };
        Some(if free {
            Classification::Free
        } else {
            Classification::Blocked
        })
    }

    /// The patches that touch at (u, v) within `tolerance` (model length), with their contact functions there; the nearest
    /// first. Empty outside the ranges of motion.
    pub fn contacts(&self, u: f64, v: f64, tolerance: f64) -> Vec<(u32, f64)> {
        let Some((x, y)) = self.placed(u, v) else {
            return Vec::new();
        };
        let scale = self.map.frame.scale;
        let reach = tolerance * scale;
        let mut found: Vec<(u32, f64)> = self
            .branches
            .iter()
            .filter_map(|b| {
                let value = self.touch(b.cell(), x, y, reach.max(NEAR), reach)?;
                Some((b.patch, value / scale))
            })
            .collect();
        let nearer = |a: &(u32, f64), b: &(u32, f64)| a.1.abs().total_cmp(&b.1.abs());
        found.sort_by(|a, b| a.0.cmp(&b.0).then(nearer(a, b)));
        found.dedup_by_key(|f| f.0);
        found.sort_by(|a, b| nearer(a, b).then(a.0.cmp(&b.0)));
        found
    }

    /// Coordinates within the extents; none outside the ranges.
    pub(super) fn placed(&self, u: f64, v: f64) -> Option<(f64, f64)> {
        let (x, y) = self.map.inner(u, v);
        if !(x.is_finite() && y.is_finite()) {
            return None;
        }
        let (mut x, mut y) = (x, y);
        for (t, extent) in [(&mut x, &self.x), (&mut y, &self.y)] {
            match extent.kind {
                ExtentKind::Circle => *t = extent.reduced(*t),
                ExtentKind::TurnLimits | ExtentKind::SlideLimits => {
                    if !(extent.lo..=extent.hi).contains(t) {
                        return None;
                    }
                }
                ExtentKind::Open => {}
            }
        }
        // A part that does not move is at 0 and nowhere else.
        let moved = |t: f64, m: Motion| m == Motion::Still && t != 0.0;
        if moved(x, self.motions.first) || moved(y, self.motions.second) {
            return None;
        }
        if let Some(share) = self.on_one_line() {
            y -= x * share;
            x = 0.0;
        }
        Some((x, y))
    }

    /// Of parts that slide along one line without limits only the difference of y and so many x matters.
    pub(super) fn on_one_line(&self) -> Option<f64> {
        let (Motion::Slide { direction: d }, Motion::Slide { direction: e }) =
            (self.motions.first, self.motions.second)
        else {
            return None;
        };
        let open = self.x.kind == ExtentKind::Open && self.y.kind == ExtentKind::Open;
        (open && d.cross(e).abs() < super::tolerance::INDEPENDENT).then(|| d.dot(e))
    }

    pub(super) fn graphs(&self) -> Graphs<'_> {
        Graphs {
            pairs: &self.pairs,
            pieces: &self.pieces,
            cells: &self.cells,
            y: self.y,
        }
    }

    /// The free gap that holds a configuration.
    pub(super) fn gap(&self, x: f64, y: f64) -> Option<u32> {
        let bands = &self.bands.bands;
        let outside = x < self.x.lo || x > self.x.hi || y < self.y.lo || y > self.y.hi;
        if outside && !self.y.is_circle() {
            // Beyond the window nothing touches.
            return Some(u32::MAX);
        }
        let k = bands.partition_point(|b| b.hi < x).min(bands.len() - 1);
        self.gap_in(k, x, y)
    }

    /// The free gap of a band that holds a configuration.
    pub(super) fn gap_in(&self, band: usize, x: f64, y: f64) -> Option<u32> {
        let graphs = self.graphs();
        self.bands.bands[band].gaps.clone().find(|&g| {
            let (from, to) = graphs.interval(&self.bands.gaps[g as usize], x);
            if self.y.is_circle() {
                let turn = core::f64::consts::TAU;
                let y = y + turn * ((from - y) / turn).ceil();
                y <= to
            } else {
                (from..=to).contains(&y)
            }
        })
    }

    /// Cells of the free boundary within the resolution of a configuration, with the contact functions' values.
    pub(super) fn touching(&self, x: f64, y: f64) -> impl Iterator<Item = (u32, f64)> + '_ {
        let distance = self.contact_distance() * self.map.frame.scale;
        self.slots[self.slot(x)].iter().filter_map(move |&i| {
            let value = self.touch(i, x, y, distance, distance)?;
            // A corner that is all but on a pivot is as near to a side everywhere, deep in blocked space too.
            let strays = self.above_curve(i, x, y).abs() > ASTRAY && self.bodies.overlap(x, y);
            (!strays).then_some((i, value))
        })
    }

    /// Where a cell is along x and along y.
    pub(super) fn cell_box(&self, cell: u32) -> ((f64, f64), (f64, f64)) {
        let (c, p) = self.cell_and_piece(cell);
        if p.vertical {
            return ((p.start.x, p.start.x), (c.from, c.to));
        }
        let (a, b) = (p.y(&self.pairs, c.from), p.y(&self.pairs, c.to));
        ((c.from, c.to), (a.min(b), a.max(b)))
    }

    /// Whether a configuration is in a cell's box, or no farther from it than `reach`.
    pub(super) fn in_box(&self, cell: u32, x: f64, y: f64, reach: f64) -> bool {
        let (x_range, y_range) = self.cell_box(cell);
        self.x.brought(x, x_range, reach).is_some() && self.y.brought(y, y_range, reach).is_some()
    }

    /// The contact function of a cell at a configuration that touches there: the function vanishes, give or take `within`,
    /// and no farther than `reach` from the cell's curve.
    fn touch(&self, cell: u32, x: f64, y: f64, reach: f64, within: f64) -> Option<f64> {
        let (_, p) = self.cell_and_piece(cell);
        let value = self.pairs[p.pair as usize].condition.value(x, y);
        let near = value.abs() <= within && self.in_box(cell, x, y, reach);
        (near && self.on_own_root(cell, x, y, within)).then_some(value)
    }

    /// Whether a configuration at which the contact function of a cell vanishes, give or take `within`, is on its curve.
    ///
    /// At one x the function is a parabola or a cosine of y and has a second root, which may be in the cell's box as well,
    /// deep in blocked space. Between the two it is extreme in the middle.
    pub(super) fn on_own_root(&self, cell: u32, x: f64, y: f64, within: f64) -> bool {
        let (_, p) = self.cell_and_piece(cell);
        // The shorter way: between the roots that is the side on which the function varies less.
        let middle = y - 0.5 * self.above_curve(cell, x, y);
        let condition = &self.pairs[p.pair as usize].condition;
        condition.value(x, middle).abs() <= within.max(condition.value(x, y).abs())
    }

    /// How far a configuration is above a cell's curve along y, the shorter way around; 0 of one that is vertical.
    fn above_curve(&self, cell: u32, x: f64, y: f64) -> f64 {
        let (c, p) = self.cell_and_piece(cell);
        if p.vertical {
            return 0.0;
        }
        let middle = 0.5 * (c.from + c.to);
        let x = middle + self.x.apart(x, middle);
        self.y
            .apart(y, p.y(&self.pairs, brought_between(x, c.from, c.to)))
    }

    fn slot(&self, x: f64) -> usize {
        let share = (x - self.x.lo) / (self.x.hi - self.x.lo);
        ((share * SLOTS as f64).max(0.0) as usize).min(SLOTS - 1)
    }

    /// For every slot of x the free cells in it.
    pub(super) fn near_slots(&self) -> Vec<Vec<u32>> {
        let mut slots = vec![Vec::new(); SLOTS];
        for i in (0..self.cells.len() as u32).filter(|&i| self.free[i as usize]) {
            let c = &self.cells[i as usize];
            let p = &self.pieces[c.piece as usize];
            let (lo, hi) = if p.vertical {
                (p.start.x, p.start.x)
            } else {
                (c.from, c.to)
            };
            for s in &mut slots[self.slot(lo - NEAR)..=self.slot(hi + NEAR)] {
                s.push(i);
            }
        }
        slots
    }
}
