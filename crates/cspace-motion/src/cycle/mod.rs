//! Linkages over one cycle of their drives: where each part is at every time, with bounds of its motion between any two.
//!
//! The joints determine where parts are that they carry, given where drives are; contacts are left out of account. A part that can still move
//! while the drives stand is not carried.
//!
//! ```
//! use cspace::pair::Joint;
//! use cspace::{Part, Point};
//! use cspace_model::{Drive, DriveMotion, JointEntry, Mechanism, PartEntry};
//! use cspace_motion::cycle::Cycles;
//! // A crank pushes a slider by a rod.
//! let mut model = Mechanism::new("slider and crank");
//! let bar = |name: &str, x: f64, y: f64, l: f64| Part::rectangle(name, (x + 0.5 * l, y), l, 0.2);
//! model.parts.push(PartEntry::revolute(bar("crank", 0.0, 0.0, 1.0)?, Point::ORIGIN));
//! model.parts.push(PartEntry::planar(bar("rod", 1.0, 0.0, 3.0)?));
//! model.parts.push(PartEntry::prismatic(bar("slider", 3.5, 0.0, 1.0)?, (1.0, 0.0)));
//! for (parts, x) in [((0, 1), 1.0), ((1, 2), 4.0)] {
//!     let joint = Joint::Revolute { at: Point::new(x, 0.0) };
//!     model.joints.push(JointEntry { joint, parts });
//! }
//! model.dynamics.drives.push(Drive { part: 0, motion: DriveMotion::Rate(1.0) });
//! let mut cycles = Cycles::of(&model)?;
//! assert!(cycles.has([0, 2]));
//! let cycle = cycles.pair([0, 2]).map_err(|why| format!("{why:?}"))?;
//! assert_eq!(cycle.halt, None);
//! assert!((cycle.reached - core::f64::consts::TAU).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod enclosure;
mod linkage;
mod span;
mod way;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use cspace_model::Mechanism;
use cspace_plan::clash::{Course, Leg};
use cspace_plan::legs::Coords;

use crate::assemble::assemble;
use crate::error::SimulateError;
use crate::pairs::Pairs;
use crate::system::{PartCoordinates, System};
use linkage::{Linkage, linkages};
pub use span::{MOST_TURNS, NoCycle, Span};
pub use way::Halt;
use way::Way;

/// The smallest number of intervals at the ends of which a pair is looked at first.
const LOOKS: u32 = 64;
/// Solutions are right to this share of the mechanism's size.
const SOLVED: f64 = 1e-14;

/// The linkages of a mechanism.
#[derive(Debug)]
pub struct Cycles {
    system: System,
    start: Vec<f64>,
    linkages: Vec<Linkage>,
    ways: BTreeMap<(usize, [u64; 2]), Rc<RefCell<Way>>>,
}

/// Two parts over one cycle of the drives that move them.
#[derive(Debug)]
pub struct PairCycle<'a> {
    /// The cycle.
    pub span: Span,
    /// The time up to which the parts go (s).
    pub reached: f64,
    /// Why they go no farther, if that is not all of the cycle.
    pub halt: Option<Halt>,
    /// The driven parts, by their numbers.
    pub driven: Vec<usize>,
    system: &'a System,
    parts: [usize; 2],
    ways: [Option<Rc<RefCell<Way>>>; 2],
}

impl Cycles {
    /// The linkages of a mechanism, where its joints hold.
    ///
    /// # Errors
    /// If the mechanism is invalid, or its joints cannot hold.
    pub fn of(mechanism: &Mechanism) -> Result<Self, SimulateError> {
        mechanism.check()?;
        let system = System::new(mechanism);
        let none = Self {
            start: system.start(),
            linkages: Vec::new(),
            ways: BTreeMap::new(),
            system,
        };
        if none.system.drives().is_empty() || none.system.joint_entries().is_empty() {
            return Ok(none);
        }
        let Some(start) = assemble(&none.system, &Pairs::none()) else {
            return Err(none.system.open_joint(&none.start));
        };
        let mut linkages = linkages(&none.system, &start);
        // What no drive moves stands still.
        linkages.retain(|linkage| !linkage.driven.is_empty());
        Ok(Self {
            start,
            linkages,
            ..none
        })
    }

    fn linkage(&self, part: usize) -> Option<usize> {
        (self.linkages.iter()).position(|linkage| linkage.parts.contains(&part))
    }

    fn is_driven(&self, part: usize) -> bool {
        let drives = &self.system.mechanism().dynamics.drives;
        drives.iter().any(|drive| drive.part == part)
    }

    /// Whether joints and drives determine where a part is, and joints carry it.
    pub fn carries(&self, part: usize) -> bool {
        self.linkage(part).is_some()
    }

    /// Whether two parts are looked at over a cycle: one is carried, drives and joints say where the other is or it stands still, they are at a
    /// common height, and no joint connects them.
    pub fn has(&self, [a, b]: [usize; 2]) -> bool {
        let parts = self.system.parts();
        let is_known =
            |i: usize| self.carries(i) || self.is_driven(i) || parts[i] == PartCoordinates::Fixed;
        let model = self.system.mechanism();
        (self.carries(a) || self.carries(b))
            && is_known(a)
            && is_known(b)
            && model.joint(a, b).is_none()
            && model.parts[a].part.meets(&model.parts[b].part)
    }

    /// Two parts that [are looked at](Self::has) over one cycle of the drives that move them.
    ///
    /// # Errors
    /// If these have no cycle.
    pub fn pair(&mut self, parts: [usize; 2]) -> Result<PairCycle<'_>, NoCycle> {
        let mut driven: Vec<usize> = (parts.iter())
            .flat_map(|&i| match self.linkage(i) {
                Some(linkage) => self.linkages[linkage].driven.clone(),
                None => Some(i).filter(|&i| self.is_driven(i)).into_iter().collect(),
            })
            .collect();
        driven.sort_unstable();
        driven.dedup();
        let span = span::span(&self.system, &driven)?;
        let ways = parts.map(|i| self.linkage(i).map(|linkage| self.way(linkage, span.times)));
        let mut reached = span.times[1];
        let mut halt = None;
        for way in ways.iter().flatten() {
            let way = way.borrow();
            if way.end < reached || (halt.is_none() && way.halt.is_some()) {
                (reached, halt) = (way.end, way.halt);
            }
        }
        Ok(PairCycle {
            span,
            reached,
            halt,
            driven,
            system: &self.system,
            parts,
            ways,
        })
    }

    fn way(&mut self, linkage: usize, times: [f64; 2]) -> Rc<RefCell<Way>> {
        let key = (linkage, times.map(f64::to_bits));
        let way = self.ways.entry(key).or_insert_with(|| {
            let way = Way::new(&self.system, &self.linkages[linkage], &self.start, times);
            Rc::new(RefCell::new(way))
        });
        Rc::clone(way)
    }
}

impl PairCycle<'_> {
    /// The coordinate of a driven part at a time.
    pub fn drive(&self, part: usize, time: f64) -> Option<f64> {
        let own = self.system.parts()[part].indices();
        let drives = self.system.drives().iter();
        (drives
            .filter(|d| own.contains(&d.0))
            .map(|d| d.1.at(time).value))
        .next()
    }

    /// Coordinates of a part, given those of its linkage.
    fn coordinates(&self, k: usize, time: f64, of: Option<&[f64]>) -> Coords {
        let mut at = [0.0; 3];
        let own = self.system.parts()[self.parts[k]].indices();
        match (&self.ways[k], of) {
            (Some(way), Some(x)) => {
                let way = way.borrow();
                for (value, i) in at.iter_mut().zip(own) {
                    if let Ok(n) = way.unknown().binary_search(&i) {
                        *value = x[n];
                    }
                }
            }
            _ => at[0] = self.drive(self.parts[k], time).unwrap_or(0.0),
        }
        at
    }

    /// How far points of a part are, at most, from where they are at constant rates, if its coordinates bend by no more than this.
    fn off(&self, k: usize, bend: Coords, far: Coords, half: f64) -> f64 {
        let levers = self.system.levers()[self.parts[k]];
        let bent: f64 = bend.iter().zip(levers).map(|(b, l)| b * l).sum();
        let rounded = SOLVED * (self.system.size() + far[0].abs() + far[1].abs());
        0.5 * half * half * bent + rounded
    }

    fn still(&self, time: f64, k: usize) -> Option<Coords> {
        match &self.ways[k] {
            Some(way) => {
                let x = way.borrow().at(self.system, time)?;
                Some(self.coordinates(k, time, Some(&x)))
            }
            None => Some(self.coordinates(k, time, None)),
        }
    }
}

impl Course for PairCycle<'_> {
    fn times(&self) -> Vec<f64> {
        let [from, _] = self.span.times;
        let looks =
            (0..=LOOKS).map(|i| from + (self.reached - from) * f64::from(i) / f64::from(LOOKS));
        let ways = self.ways.iter().flatten();
        let mut times: Vec<f64> = match ways.clone().next() {
            // The pieces of the ways are enough.
            Some(_) if self.halt.is_none() => vec![from, self.reached],
            _ => looks.collect(),
        };
        for way in ways {
            times.extend(way.borrow().times());
        }
        let drives = self.system.drives().iter();
        times.extend(drives.flat_map(|(_, curve)| curve.corners()));
        times.retain(|t| (from..=self.reached).contains(t));
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    fn at(&mut self, time: f64) -> Option<[Coords; 2]> {
        Some([self.still(time, 0)?, self.still(time, 1)?])
    }

    fn between(&mut self, lo: f64, hi: f64) -> Option<Leg> {
        let half = 0.5 * (hi - lo);
        let mut leg = Leg {
            from: [[0.0; 3]; 2],
            to: [[0.0; 3]; 2],
            off: 0.0,
        };
        for k in 0..2 {
            let mut bend = [0.0; 3];
            if let Some(way) = &self.ways[k] {
                let bent = way.borrow_mut().over(self.system, [lo, hi])?;
                leg.from[k] = self.coordinates(k, lo, Some(&bent.from));
                leg.to[k] = self.coordinates(k, hi, Some(&bent.to));
                bend = self.coordinates(k, lo, Some(&bent.bend));
            } else {
                leg.from[k] = self.coordinates(k, lo, None);
                leg.to[k] = self.coordinates(k, hi, None);
                let own = self.system.parts()[self.parts[k]].indices();
                for (i, curve) in self.system.drives() {
                    if own.contains(i) {
                        let [.., most] = curve.over([lo, hi]);
                        bend[0] = most.mid.abs() + most.radius;
                    }
                }
            }
            leg.off += self.off(k, bend, leg.from[k], half);
        }
        Some(leg)
    }
}
