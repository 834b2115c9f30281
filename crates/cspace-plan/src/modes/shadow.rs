//! Shadow of a mode in the plane of two parts: the configurations (u, v) of the pair for which the third part has a
//! free position.

use core::f64::consts::TAU;

use crate::modes::components::Modes;
use crate::modes::plane::turns_onto;
use crate::modes::roots::sign_change;
use crate::modes::shape::Shape;

/// The projection of a mode to the plane of a pair, as fields of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Shadow {
    /// Fields along the pair's u and along its v.
    pub fields: [usize; 2],
    /// Flags of the fields that the mode enters: those of the smallest u first, in order of v.
    pub reached: Vec<bool>,
}

/// A grid over a window of two coordinates.
struct Fields {
    shadow: Shadow,
    window: [(f64, f64); 2],
    circle: [bool; 2],
    /// Whether the coordinates of the shadow are those of the window in the other order.
    swapped: bool,
}

impl Modes {
    /// Computes the projection of a mode onto the plane of a pair, by its number in [`PAIRS`](crate::modes::PAIRS), over a
    /// window of the pair's u and v: every field that the mode enters, even slightly. Empty if there is no such mode or
    /// pair.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::{Mechanism, PartEntry};
    /// use cspace_plan::modes::Modes;
    /// let mut blocks = Mechanism::new("blocks");
    /// for (name, x) in [("a", -4.0), ("b", 0.0), ("c", 4.0)] {
    ///     let mut entry = PartEntry::prismatic(Part::rectangle(name, (x, 0.0), 2.0, 2.0)?, (1.0, 0.0));
    ///     entry.axis = entry.axis.map(|axis| axis.within(-4.0, 4.0));
    ///     blocks.parts.push(entry);
    /// }
    /// blocks.pairs = blocks.every_two();
    /// let modes = Modes::compute(&blocks, [0, 1, 2])?;
    /// // The first block at u = -4, the second at v = 4: drawn they are 4 apart, so now 12, and the third is to the right of both or
    /// // between. Exchanged it is the other way: the second has to be left of the first.
    /// let window = [(-4.0, 4.0), (-4.0, 4.0)];
    /// let by_mode: Vec<bool> = (0..modes.list().len())
    ///     .map(|m| modes.shadow(m, 0, window, [8, 8]).reached[7])
    ///     .collect();
    /// assert_eq!(by_mode.iter().filter(|b| **b).count(), 2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn shadow(
        &self,
        mode: usize,
        pair: usize,
        window: [(f64, f64); 2],
        fields: [usize; 2],
    ) -> Shadow {
        let shadow = Shadow {
            fields,
            reached: vec![false; fields[0] * fields[1]],
        };
        let Some(coordinates) = self.trio.pairs.get(pair).map(|p| p.coordinates) else {
            return shadow;
        };
        let [first, second] = coordinates.map(|c| self.order.iter().position(|&o| o == c));
        let (Some(first), Some(second)) = (first, second) else {
            return shadow;
        };
        let swapped = first > second;
        let kinds = if swapped {
            [second, first]
        } else {
            [first, second]
        };
        let mut to = Fields {
            shadow,
            window,
            circle: coordinates.map(|c| self.trio.is_circle(c)),
            swapped,
        };
        self.shapes(|number, shape| {
            if self.mode_of[number as usize] as usize == mode {
                match kinds {
                    [0, 1] => to.mark(shape.s, |s| shape.p(s)),
                    [0, _] => to.mark(shape.s, |s| shape.q(s)),
                    _ => to.mark(shape.p_range(), |p| shape.q_over(p)),
                }
            }
        });
        to.shadow
    }

    /// Minimum and maximum u, v and w that were looked at: the ranges, a turn, or as far as parts that slide without limits can touch.
    pub fn extents(&self) -> [(f64, f64); 3] {
        let extents = [self.planes.sp.x, self.planes.sp.y, self.planes.sq.y];
        let mut all = [(0.0, 0.0); 3];
        for (extent, &to) in extents.iter().zip(&self.order) {
            all[to] = (extent.lo, extent.hi);
        }
        all
    }
}

impl Fields {
    /// Marks the fields between two functions of the first coordinate over an interval.
    fn mark(&mut self, (lo, hi): (f64, f64), at: impl Fn(f64) -> (f64, f64)) {
        let [i, j] = if self.swapped { [1, 0] } else { [0, 1] };
        let window = self.window[i];
        let n = self.shadow.fields[i];
        let width = (window.1 - window.0) / n as f64;
        for turns in turns_onto(self.circle[i], (lo, hi), window) {
            let by = TAU * f64::from(turns);
            let (from, to) = ((lo + by).max(window.0), (hi + by).min(window.1));
            if from > to {
                continue;
            }
            let field = |x: f64| (((x - window.0) / width).max(0.0) as usize).min(n - 1);
            for k in field(from)..=field(to) {
                let a = from.max(window.0 + width * k as f64);
                let b = to.min(window.0 + width * (k + 1) as f64).max(a);
                let (mut lower, mut upper) = (f64::INFINITY, f64::NEG_INFINITY);
                for x in [a, 0.5 * (a + b), b] {
                    let (p, q) = at((x - by).clamp(lo, hi));
                    if p <= q {
                        (lower, upper) = (lower.min(p), upper.max(q));
                    }
                }
                if lower <= upper {
                    self.mark_beside(j, k, (lower, upper));
                }
            }
        }
    }

    /// Marks an interval of the other coordinate beside field `k` of the one.
    fn mark_beside(&mut self, j: usize, k: usize, (lo, hi): (f64, f64)) {
        let window = self.window[j];
        let n = self.shadow.fields[j];
        let width = (window.1 - window.0) / n as f64;
        for turns in turns_onto(self.circle[j], (lo, hi), window) {
            let by = TAU * f64::from(turns);
            let (from, to) = ((lo + by).max(window.0), (hi + by).min(window.1));
            if from > to {
                continue;
            }
            let field = |x: f64| (((x - window.0) / width).max(0.0) as usize).min(n - 1);
            for m in field(from)..=field(to) {
                let [u, v] = if j == 1 { [k, m] } else { [m, k] };
                self.shadow.reached[u * self.shadow.fields[1] + v] = true;
            }
        }
    }
}

impl Shape<'_> {
    /// Range of q at a value of p, over all s.
    fn q_over(&self, p: f64) -> (f64, f64) {
        let (mut lo, mut hi) = self.s;
        if let Some(span) = self.column.p {
            // Where the ends, which are monotone, leave p between them.
            for f in [&(|s| p - span.lower.at(s)) as &dyn Fn(f64) -> f64, &|s| {
                span.upper.at(s) - p
            }] {
                match (f(lo) > 0.0, f(hi) > 0.0) {
                    (true, true) => {}
                    // At the end of all p: where it is reached.
                    (false, false) => {
                        let at = if f(lo) > f(hi) { lo } else { hi };
                        (lo, hi) = (at, at);
                    }
                    (from_lo, _) => {
                        if let Some(at) = sign_change(f, (lo, hi)) {
                            *(if from_lo { &mut hi } else { &mut lo }) = at;
                        }
                    }
                }
            }
        }
        self.q_along((lo, hi), p)
    }
}
