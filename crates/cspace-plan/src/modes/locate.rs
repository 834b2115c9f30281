//! Location of a configuration among the modes.

use core::f64::consts::TAU;

use cspace::{Axis, Classification};

use crate::modes::components::Modes;
use crate::modes::error::ModesError;
use crate::modes::plane::turns_onto;
use crate::modes::trio::TrioPair;

/// Name of a coordinate by its number from 0: u, v and w, and from the fourth on q4, q5 and so on.
pub fn coordinate_name(k: usize) -> String {
    match k {
        0 => "u".to_owned(),
        1 => "v".to_owned(),
        2 => "w".to_owned(),
        _ => format!("q{}", k + 1),
    }
}

/// Place of a configuration of the parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModePlace {
    /// Free, in the mode with that number.
    Mode(usize),
    /// Two parts touch: a number of the list of pairs.
    Contact(usize),
    /// Two parts overlap: a number of the list of pairs.
    Blocked(usize),
    /// Outside the range of the coordinate of that number.
    Outside(usize),
    /// Free by its pairs, but so near to contacts of several that there is no opening.
    Closed,
}

/// The place of a configuration that is not free in all pairs.
pub(crate) fn place_by_pairs(
    at: &[f64],
    axes: &[Axis],
    pairs: &[TrioPair],
) -> Result<Option<ModePlace>, ModesError> {
    if let Some(k) = at.iter().position(|t| !t.is_finite()) {
        let coordinate = coordinate_name(k);
        return Err(ModesError::NotFinite { coordinate });
    }
    for (k, axis) in axes.iter().enumerate() {
        if axis
            .range
            .is_some_and(|(lo, hi)| !(lo..=hi).contains(&at[k]))
        {
            return Ok(Some(ModePlace::Outside(k)));
        }
    }
    let mut touching = None;
    for (k, pair) in pairs.iter().enumerate() {
        let [u, v] = pair.coordinates.map(|c| at[c]);
        match pair.space.as_ref().map(|s| s.classify(u, v)) {
            Some(Some(Classification::Blocked)) => return Ok(Some(ModePlace::Blocked(k))),
            Some(Some(Classification::Contact)) => touching = touching.or(Some(k)),
            _ => {}
        }
    }
    Ok(touching.map(ModePlace::Contact))
}

impl Modes {
    /// Finds the mode of a configuration (u, v, w); radians or the model's unit of length.
    ///
    /// # Errors
    /// If it is not finite.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::{Mechanism, PartEntry};
    /// use cspace_plan::modes::{ModePlace, Modes};
    /// let mut blocks = Mechanism::new("blocks");
    /// for (name, x) in [("a", -4.0), ("b", 0.0), ("c", 4.0)] {
    ///     let mut entry = PartEntry::prismatic(Part::rectangle(name, (x, 0.0), 2.0, 2.0)?, (1.0, 0.0));
    ///     entry.axis = entry.axis.map(|axis| axis.within(-20.0, 20.0));
    ///     blocks.parts.push(entry);
    /// }
    /// blocks.pairs = blocks.every_two();
    /// let modes = Modes::compute(&blocks, [0, 1, 2])?;
    /// let drawn = modes.locate([0.0; 3])?;
    /// assert!(matches!(drawn, ModePlace::Mode(_)));
    /// // The first block, moved to where the third is.
    /// assert_eq!(modes.locate([8.0, 0.0, 0.0])?, ModePlace::Blocked(2));
    /// // All three moved alike.
    /// assert_eq!(modes.locate([10.0; 3])?, drawn);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn locate(&self, at: [f64; 3]) -> Result<ModePlace, ModesError> {
        if let Some(place) = place_by_pairs(&at, &self.trio.axes, &self.trio.pairs)? {
            return Ok(place);
        }
        let mode = self.cell_at(at).map(|cell| self.mode_of[cell as usize]);
        Ok(mode.map_or(ModePlace::Closed, |m| ModePlace::Mode(m as usize)))
    }

    /// The cell that holds a configuration.
    fn cell_at(&self, at: [f64; 3]) -> Option<u32> {
        let planes = &self.planes;
        let extents = [planes.sp.x, planes.sp.y, planes.sq.y];
        let [s, p, q] = [0, 1, 2].map(|k| {
            let (t, e) = (at[self.order[k]], &extents[k]);
            if e.circle {
                t - TAU * ((t - e.lo) / TAU).floor()
            } else {
                // Beyond the window of an open coordinate all goes on.
                t.clamp(e.lo, e.hi)
            }
        });
        let slabs = &self.swept.slabs;
        let after = slabs.partition_point(|slab| slab.hi < s);
        let near = after.saturating_sub(1)..(after + 1).min(slabs.len());
        let holds = |circle: bool, t: f64, (lo, hi): (f64, f64)| {
            let turns = turns_onto(circle, (t, t), (lo, hi));
            turns.into_iter().any(|k| {
                let t = t + TAU * f64::from(k);
                lo <= t && t <= hi
            })
        };
        // Between two slabs, in either.
        for k in near.rev() {
            let slab = &slabs[k];
            let s = s.clamp(slab.lo, slab.hi);
            let gaps = |plane: &crate::modes::plane::Plane, band: usize, t: f64| -> Vec<usize> {
                let all = plane.bands[band].gaps.clone();
                all.filter(|&g| holds(plane.y.circle, t, plane.interval(g, s)))
                    .collect()
            };
            for i in gaps(&planes.sp, slab.bands.0, p) {
                for j in gaps(&planes.sq, slab.bands.1, q) {
                    let columns = planes.sq.bands[slab.bands.1].gaps.clone();
                    let first = planes.sp.bands[slab.bands.0].gaps.start;
                    let number = slab.first + (i - first) * columns.len() + (j - columns.start);
                    if let Some(cell) = self.cell_of(number, [s, p, q]) {
                        return Some(cell);
                    }
                }
            }
        }
        None
    }

    /// The cell of a stack that holds a configuration.
    fn cell_of(&self, stack: usize, [s, p, q]: [f64; 3]) -> Option<u32> {
        let stack = &self.swept.stacks[stack];
        let slab = &self.swept.slabs[stack.slab];
        let column = self.planes.column(&self.openings, slab, stack.gaps);
        let (circle_p, circle_q) = (self.planes.sp.y.circle, self.planes.sq.y.circle);
        let mut number = stack.first;
        for layer in &stack.layers {
            for &place in &layer.cells {
                if layer.lo <= s && s <= layer.hi {
                    let shape = crate::modes::shape::Shape {
                        column,
                        place,
                        s: (layer.lo, layer.hi),
                    };
                    let over = shape.p(s);
                    for turn in turns_onto(circle_p, (p, p), over) {
                        let p = p + TAU * f64::from(turn);
                        let at = shape.q_at(s, p);
                        let holds = turns_onto(circle_q, (q, q), at).any(|t| {
                            let q = q + TAU * f64::from(t);
                            at.0 <= q && q <= at.1
                        });
                        if over.0 <= p && p <= over.1 && holds {
                            return Some(number);
                        }
                    }
                }
                number += 1;
            }
        }
        None
    }
}
