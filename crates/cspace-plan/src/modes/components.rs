//! The operating modes of three parts: the connected components of their free space.

use core::f64::consts::TAU;
use std::collections::HashMap;

use cspace::fixed_axes::{Role, SweptPlane};
use cspace::{Axis, AxisMotion, parallel};
use cspace_model::Mechanism;

use crate::modes::error::ModesError;
use crate::modes::extent::Extent;
use crate::modes::mode::{Gathered, Mode, in_order};
use crate::modes::plane::{Opening, Plane};
use crate::modes::shape::Shape;
use crate::modes::sweep::{Planes, Swept};
use crate::modes::trio::{Trio, TrioPair, failed};

/// The free space of three parts on axes, and its modes.
#[derive(Debug)]
pub struct Modes {
    pub(crate) trio: Trio,
    /// The coordinates that are called s, p and q.
    pub(crate) order: [usize; 3],
    pub(crate) planes: Planes,
    pub(crate) openings: Vec<Vec<Opening>>,
    pub(crate) swept: Swept,
    /// The mode of every cell.
    pub(crate) mode_of: Vec<u32>,
    /// Turns of s, p and q of each cell.
    pub(crate) turns_of: Vec<[i32; 3]>,
    modes: Vec<Mode>,
}

impl Modes {
    /// Computes the modes of three parts of a mechanism, with coordinates u, v and w in that order.
    ///
    /// (u, v, w) is free if (u, v), (v, w) and (u, w) are free in the spaces of their pairs; pairs that the mechanism does not
    /// have constrain nothing. Openings less than 10⁻¹¹ of a pair's size are closed, as they are in its space.
    ///
    /// # Errors
    /// If the parts are not three that each turn or slide on an axis, if joints connect two of them, or if a pair's space cannot be
    /// computed; if their free intervals combine in too many ways.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::{Mechanism, PartEntry};
    /// use cspace_plan::modes::Modes;
    /// // Three blocks on one rail: they cannot pass each other, so each order is a mode.
    /// let mut blocks = Mechanism::new("blocks");
    /// for (name, x) in [("a", -4.0), ("b", 0.0), ("c", 4.0)] {
    ///     let mut entry = PartEntry::prismatic(Part::rectangle(name, (x, 0.0), 2.0, 2.0)?, (1.0, 0.0));
    ///     entry.axis = entry.axis.map(|axis| axis.within(-20.0, 20.0));
    ///     blocks.parts.push(entry);
    /// }
    /// blocks.pairs = blocks.every_two();
    /// let modes = Modes::compute(&blocks, [0, 1, 2])?;
    /// assert_eq!(modes.list().len(), 6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute(mechanism: &Mechanism, parts: [usize; 3]) -> Result<Self, ModesError> {
        let trio = Trio::of(mechanism, parts)?;
        let (order, planes) = planes(mechanism, &trio)?;
        let swept = planes.sweep()?;
        let mut modes = Self {
            openings: planes.openings(),
            trio,
            order,
            planes,
            swept,
            mode_of: Vec::new(),
            turns_of: Vec::new(),
            modes: Vec::new(),
        };
        modes.gather();
        Ok(modes)
    }

    /// The modes, those with the minimum u first, then v, then w.
    pub fn list(&self) -> &[Mode] {
        &self.modes
    }

    /// The three parts' indices in the mechanism.
    pub fn parts(&self) -> [usize; 3] {
        self.trio.parts
    }

    /// The names of the parts.
    pub fn names(&self) -> &[String; 3] {
        &self.trio.names
    }

    /// The axes of the parts.
    pub fn axes(&self) -> &[Axis; 3] {
        &self.trio.axes
    }

    /// The pairs of the first and the second part, of the second and the third, and of the first and the third.
    pub fn pairs(&self) -> &[TrioPair; 3] {
        &self.trio.pairs
    }

    /// Places at which pairs' spaces contradict themselves, and columns in which curves of three pairs could not be put in
    /// order; 0 unless contacts coincide but for rounding. If there are any, modes are not to be relied upon.
    pub fn doubts(&self) -> usize {
        let Planes { sp, sq, pq } = &self.planes;
        sp.conflicts() + sq.conflicts() + pq.conflicts() + self.swept.undecided
    }

    /// The cells of free space that the computation made.
    pub fn cells(&self) -> usize {
        self.swept.cells as usize
    }

    /// Calls `each` with every cell, its number and its shape.
    pub(crate) fn shapes<'a>(&'a self, mut each: impl FnMut(u32, Shape<'a>)) {
        for stack in &self.swept.stacks {
            let slab = &self.swept.slabs[stack.slab];
            let column = self.planes.column(&self.openings, slab, stack.gaps);
            let mut number = stack.first;
            for layer in &stack.layers {
                for &place in &layer.cells {
                    let s = (layer.lo, layer.hi);
                    each(number, Shape { column, place, s });
                    number += 1;
                }
            }
        }
    }

    fn gather(&mut self) {
        let n = self.swept.cells;
        let mut numbers: HashMap<u32, u32> = HashMap::new();
        let mut roots = Vec::new();
        for cell in 0..n {
            let (root, turns) = self.swept.sets.find(cell);
            let next = numbers.len() as u32;
            let number = *numbers.entry(root).or_insert(next);
            if number == next {
                roots.push(root);
            }
            self.mode_of.push(number);
            self.turns_of.push(turns);
        }
        let extents = [self.planes.sp.x, self.planes.sp.y, self.planes.sq.y];
        let mut sets: Vec<(u32, Vec<(u32, Shape<'_>)>)> =
            roots.iter().map(|&root| (root, Vec::new())).collect();
        self.shapes(|number, shape| {
            let (_, cells) = &mut sets[self.mode_of[number as usize] as usize];
            cells.push((number, shape));
        });
        let gathered: Vec<Gathered> = parallel::map(&sets, 1, |(root, cells)| {
            let turns = self.swept.sets.lattice(*root).reduced();
            let mut gathered = Gathered::new(turns, extents);
            for (number, shape) in cells {
                let turns = self.turns_of[*number as usize].map(|t| TAU * f64::from(t));
                gathered.add(shape, turns);
            }
            gathered
        });
        let open = [0, 1, 2].map(|k| self.trio.is_open(k));
        let modes = gathered.into_iter().map(|g| g.mode(self.order, open));
        self.modes = in_order(modes, |m| (&m.ranges, &m.sample), &mut self.mode_of);
    }
}

/// Assigns s, p and q to coordinates, and prepares the planes of their pairs.
fn planes(mechanism: &Mechanism, trio: &Trio) -> Result<([usize; 3], Planes), ModesError> {
    let axes = trio.limited_axes();
    // The pair that is not moved by s is the simplest one, or one that constrains nothing.
    let cost = |pair: &TrioPair| {
        let patches = pair.space.as_ref().map_or(0, |s| s.patches().len());
        if pair.is_bound() { 1 + patches } else { 0 }
    };
    let simplest = (0..3).min_by_key(|&k| cost(&trio.pairs[k])).unwrap_or(2);
    let order = match simplest {
        0 => [2, 0, 1],
        1 => [0, 1, 2],
        _ => [1, 0, 2],
    };
    let [s, p, q] = order;
    let sides = [[s, p], [s, q], [p, q]];
    let swept: Vec<Option<SweptPlane>> =
        parallel::map(&sides, 1, |&[x, y]| swept(mechanism, trio, &axes, x, y))
            .into_iter()
            .collect::<Result<_, _>>()?;
    let mut planes = swept.into_iter().map(|s| s.map(Plane::of));
    let mut next = || planes.next().flatten();
    let (sp, sq, pq) = (next(), next(), next());
    let extent = |k: usize| -> Extent {
        let sides = [(&sp, [s, p]), (&sq, [s, q]), (&pq, [p, q])];
        let known = sides.into_iter().filter_map(|(plane, of)| {
            let plane = plane.as_ref()?;
            match of {
                [x, _] if x == k => Some(plane.x),
                [_, y] if y == k => Some(plane.y),
                _ => None,
            }
        });
        known.reduce(|a, b| a.coarser(&b)).unwrap_or_else(|| {
            alone(
                &axes[k],
                trio.is_circle(k),
                mechanism.parts[trio.parts[k]].part.size(),
            )
        })
    };
    let (es, ep, eq) = (extent(s), extent(p), extent(q));
    let whole = |plane: Option<Plane>, x: Extent, y: Extent| match plane {
        Some(plane) => plane.with(x, y),
        None => Plane::free(x, y),
    };
    let planes = Planes {
        sp: whole(sp, es, ep),
        sq: whole(sq, es, eq),
        pq: whole(pq, ep, eq),
    };
    Ok((order, planes))
}

/// The plane of two coordinates, swept along x; `None` if the pair constrains nothing.
fn swept(
    mechanism: &Mechanism,
    trio: &Trio,
    axes: &[Axis; 3],
    x: usize,
    y: usize,
) -> Result<Option<SweptPlane>, ModesError> {
    let of = |pair: &&TrioPair| pair.role(x).is_some() && pair.role(y).is_some();
    let Some(pair) = trio.pairs.iter().find(of).filter(|p| p.is_bound()) else {
        return Ok(None);
    };
    let along = pair.role(x).unwrap_or(Role::Fixed);
    let [fixed, moving] = pair.coordinates;
    let of = |k: usize| (&mechanism.parts[trio.parts[k]].part, axes[k]);
    let names = [fixed, moving].map(|k| trio.names[k].as_str());
    SweptPlane::compute(of(fixed), of(moving), along)
        .map(Some)
        .map_err(|error| failed(names, error))
}

/// The extent of a coordinate that no pair constrains.
pub(crate) fn alone(axis: &Axis, circle: bool, size: f64) -> Extent {
    /// Tolerances as in the spaces of pairs: openings of 10⁻¹¹, and bands of 10⁻¹⁰, of a turn or the part's size.
    const OPENING: f64 = 1e-11;
    let unit = match axis.motion {
        AxisMotion::Revolute { .. } => 1.0,
        _ => size,
    };
    let (lo, hi) = axis
        .range
        .unwrap_or((-core::f64::consts::PI, core::f64::consts::PI));
    Extent {
        lo,
        hi,
        circle,
        opening: OPENING * unit,
        narrowest: 10.0 * OPENING * unit,
    }
}
