//! Operating modes of any number of parts whose contacts make a tree: a cam and its followers, a plug and its pins.
//!
//! The part that touches the most others is the hub. Its coordinate is swept; where parts hang on it that do not touch each other, the
//! free configurations at one place of the hub are products of what is free of each, and only the critical values of one part beside the
//! hub at a time change them (`branch`). Parts that hang on others are done first, so that a tree may be as deep as it is (`hang`).
//! The cost grows with the number of combinations of free intervals, not with that of cells of a space of so many dimensions.

mod branch;
mod hang;
mod reach;
mod turning;

use core::f64::consts::{PI, TAU};
use std::collections::HashMap;

use cspace::Axis;
use cspace_model::Mechanism;

use crate::modes::error::ModesError;
use crate::modes::extent::Extent;
use crate::modes::locate::{ModePlace, place_by_pairs};
use crate::modes::mode::in_order;
use crate::modes::tree::branch::Branch;
use crate::modes::tree::hang::Parts;
use crate::modes::tree::reach::Sample;
use crate::modes::tree::turning::MOST_TURNING;
use crate::modes::trio::{self, TrioPair};
use crate::modes::turns::reduced;

/// The free space of two parts or more on axes whose contacts make a tree, and its modes.
#[derive(Debug)]
pub struct TreeModes {
    parts: Parts,
    root: Branch,
    extents: Vec<Extent>,
    /// The mode of every cell of the root.
    mode_of: Vec<u32>,
    modes: Vec<TreeMode>,
}

/// An operating mode of some parts: a connected component of their free space.
#[derive(Debug, Clone, PartialEq)]
pub struct TreeMode {
    /// A configuration within it: radians, or the model's unit of length.
    pub sample: Vec<f64>,
    /// Minimum and maximum of each coordinate. One that goes on past a turn is unrolled; the range of one around which the mode
    /// closes is a full turn.
    pub ranges: Vec<(f64, f64)>,
    /// Whether each coordinate is unbounded below its minimum and above its maximum.
    pub open: Vec<(bool, bool)>,
    /// The turns by which motions within the mode come back to where they began: all of them are sums of whole multiples of these.
    pub turns: Vec<Vec<i64>>,
}

/// State of a mode while its cells are collected.
struct Gathered {
    /// The cell that stands for it.
    root: u32,
    ranges: Vec<(f64, f64)>,
    /// A configuration in the largest cell.
    sample: Option<Sample>,
}

impl TreeMode {
    /// Whether the mode closes on itself around a coordinate: the part can turn without end, with the others or alone.
    pub fn around(&self, coordinate: usize) -> bool {
        (self.turns.iter()).any(|t| t.get(coordinate).is_some_and(|&t| t != 0))
    }
}

impl TreeModes {
    /// Computes the modes of some parts of a mechanism, with coordinates in that order.
    ///
    /// A configuration is free if it is free for each pair; pairs that the mechanism does not have constrain nothing. Openings less than
    /// 10⁻¹¹ of a pair's size are closed, as they are in its space.
    ///
    /// # Errors
    /// If the parts are not two or more that each turn or slide on an axis, if contacts of them make a cycle, if joints connect two, or
    /// if a pair's space cannot be computed; if their free intervals combine in too many ways.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::{Mechanism, PartEntry};
    /// use cspace_plan::modes::{ModePlace, TreeModes};
    /// // A bar with a tooth at each of four places, and a bolt above each, which must be raised for the tooth to pass.
    /// let mut bar = vec![(-2.0, -2.0), (42.0, -2.0), (42.0, 0.0)];
    /// for k in (0..4).rev() {
    ///     let x = 10.0 * f64::from(k);
    ///     bar.extend([(x + 1.0, 0.0), (x + 1.0, 1.0), (x - 1.0, 1.0), (x - 1.0, 0.0)]);
    /// }
    /// bar.push((-2.0, 0.0));
    /// let mut lock = Mechanism::new("lock");
    /// let mut add = |part, direction: (f64, f64), range: (f64, f64)| {
    ///     let mut entry = PartEntry::prismatic(part, direction);
    ///     entry.axis = entry.axis.map(|axis| axis.within(range.0, range.1));
    ///     lock.parts.push(entry);
    /// };
    /// add(Part::polygon("bar", &bar)?, (1.0, 0.0), (0.0, 7.0));
    /// for (k, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
    ///     // The last bolt cannot be raised as far as the teeth are high.
    ///     let raised = if name == "d" { 0.4 } else { 2.0 };
    ///     let bolt = Part::rectangle(name, (10.0 * k as f64 + 4.0, 2.5), 2.0, 4.0)?;
    ///     add(bolt, (0.0, 1.0), (-0.4, raised));
    /// }
    /// lock.pairs = lock.every_two();
    /// let modes = TreeModes::compute(&lock, &[0, 1, 2, 3, 4])?;
    /// assert_eq!(modes.locate(&[0.0; 5])?, ModePlace::Mode(0));
    /// // As drawn the teeth come as far as the bolts: the last one keeps the bar there.
    /// let (_, furthest) = modes.list()[0].ranges[0];
    /// assert!((furthest - 2.0).abs() < 1e-8);
    /// assert_eq!(modes.list().len(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute(mechanism: &Mechanism, parts: &[usize]) -> Result<Self, ModesError> {
        let parts = Parts::of(mechanism, parts)?;
        let root = Branch::of(parts.tree(mechanism)?, &parts.names, &parts.turning)?;
        let mut extents = vec![root.x; parts.axes.len()];
        collect(&root, &mut extents);
        let mut modes = Self {
            parts,
            root,
            extents,
            mode_of: Vec::new(),
            modes: Vec::new(),
        };
        modes.gather();
        Ok(modes)
    }

    /// The modes, those with the minimum first coordinate first, then the second, and so on.
    pub fn list(&self) -> &[TreeMode] {
        &self.modes
    }

    /// The parts' indices in the mechanism.
    pub fn parts(&self) -> &[usize] {
        &self.parts.indices
    }

    /// The names of the parts.
    pub fn names(&self) -> &[String] {
        &self.parts.names
    }

    /// The axes of the parts.
    pub fn axes(&self) -> &[Axis] {
        &self.parts.axes
    }

    /// The pairs of the parts that the mechanism has.
    pub fn pairs(&self) -> &[TrioPair] {
        &self.parts.pairs
    }

    /// The hub: number of the part, from 0, on which the others hang.
    pub fn hub(&self) -> usize {
        self.root.coordinate
    }

    /// Places at which pairs' spaces contradict themselves; 0 unless contacts coincide but for rounding. If there are any, modes are
    /// not to be relied upon.
    pub fn doubts(&self) -> usize {
        self.root.conflicts()
    }

    /// The combinations of free intervals that the computation made.
    pub fn cells(&self) -> usize {
        self.root.cells
    }

    /// Finds the mode of a configuration; radians or the model's unit of length.
    ///
    /// # Errors
    /// If it is not finite, or has another number of coordinates.
    pub fn locate(&self, at: &[f64]) -> Result<ModePlace, ModesError> {
        if at.len() != self.parts.axes.len() {
            return Err(ModesError::Coordinates {
                given: at.len(),
                parts: self.parts.axes.len(),
            });
        }
        if let Some(place) = place_by_pairs(at, &self.parts.axes, &self.parts.pairs)? {
            return Ok(place);
        }
        let cell = self.root.cells_at(at).first().copied();
        let mode = cell.map(|cell| self.mode_of[cell] as usize);
        Ok(mode.map_or(ModePlace::Closed, ModePlace::Mode))
    }

    fn gather(&mut self) {
        let (n, turning) = (self.parts.axes.len(), &self.parts.turning);
        let mut sets = self.root.sets();
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        let mut all: Vec<Gathered> = Vec::new();
        for cell in 0..self.root.cells {
            let (root, at) = sets.find(cell as u32);
            let next = numbers.len() as u32;
            let number = *numbers.entry(root).or_insert(next);
            if number == next {
                all.push(Gathered {
                    root,
                    ranges: vec![(f64::INFINITY, f64::NEG_INFINITY); n],
                    sample: None,
                });
            }
            self.mode_of.push(number);
            let gathered = &mut all[number as usize];
            let whole = (f64::NEG_INFINITY, f64::INFINITY);
            (self.root).reach(cell, whole, (&at, turning), &mut gathered.ranges);
            let sample = self.root.sample(cell, &at, turning, n);
            let best = gathered.sample.as_ref();
            if best.is_none_or(|best| sample.room > best.room) {
                gathered.sample = Some(sample);
            }
        }
        let modes: Vec<TreeMode> = (all.into_iter())
            .map(|gathered| {
                let turns = sets.lattice(gathered.root).reduced();
                let sample = gathered.sample.map_or_else(|| vec![0.0; n], |s| s.at);
                self.mode(&turns, gathered.ranges, sample)
            })
            .collect();
        self.modes = in_order(modes, |m| (&m.ranges, &m.sample), &mut self.mode_of);
    }

    fn mode(
        &self,
        turns: &[[i64; MOST_TURNING]],
        mut ranges: Vec<(f64, f64)>,
        mut sample: Vec<f64>,
    ) -> TreeMode {
        let n = ranges.len();
        let rows = reduced(turns.iter().copied());
        let turns: Vec<Vec<i64>> = (rows.iter())
            .map(|row| self.parts.turning.of_all(n, row))
            .collect();
        let mut open = vec![(false, false); n];
        for k in 0..n {
            let extent = &self.extents[k];
            if extent.circle {
                if turns.iter().any(|t| t[k] != 0) {
                    ranges[k] = (-PI, PI);
                    sample[k] -= TAU * ((sample[k] + PI) / TAU).floor();
                } else {
                    let turns = TAU * ((ranges[k].0 + PI) / TAU).floor();
                    ranges[k] = (ranges[k].0 - turns, ranges[k].1 - turns);
                    sample[k] -= turns;
                }
            }
            let near = |a: f64, b: f64| (a - b).abs() <= extent.opening;
            let is_open = trio::is_open(&self.parts.axes[k]);
            open[k] = (
                is_open && near(ranges[k].0, extent.lo),
                is_open && near(ranges[k].1, extent.hi),
            );
        }
        TreeMode {
            sample,
            ranges,
            open,
            turns,
        }
    }
}

/// The extents of the coordinates of a branch.
fn collect(branch: &Branch, extents: &mut [Extent]) {
    extents[branch.coordinate] = branch.x;
    for (_, child) in &branch.children {
        collect(child, extents);
    }
}
