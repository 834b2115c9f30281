//! One of many parts of an assembly, each of which moves on its own.

use cspace::part::Bounds;
use cspace::{Axis, AxisMotion, Configuration, FeatureName, Part, Point, Vector};
use cspace_model::PartEntry;

use super::at::At;
use super::depth::overlaps_deeper;
use super::overlap::overlap;
use super::pose::{Coords, Pose, origin};
use super::search::{Nearest, Search};
use super::shape::Piece;
use super::tree::Tree;

/// A part with its motion relative to the ground, prepared for distances to others.
#[derive(Debug, Clone)]
pub(crate) struct Body<'a> {
    part: &'a Part,
    motion: Option<AxisMotion>,
    /// The point of the part that is the origin of its placed frame.
    origin: Vector,
    tree: Tree,
    /// How far from that origin the part reaches.
    reach: f64,
}

impl<'a> Body<'a> {
    pub(crate) fn new(entry: &'a PartEntry) -> Self {
        Self::of(&entry.part, entry.axis.map(|axis| axis.motion))
    }

    fn of(part: &'a Part, motion: Option<AxisMotion>) -> Self {
        let origin = motion.map_or(Vector::ZERO, origin);
        let tree = Tree::new(part, origin);
        let far = |p: &Piece| p.middle.distance(Point::ORIGIN) + p.reach;
        Self {
            part,
            motion,
            origin,
            reach: tree.pieces.iter().map(far).fold(0.0, f64::max),
            tree,
        }
    }

    pub(crate) fn part(&self) -> &'a Part {
        self.part
    }

    /// Another part that moves as this one does.
    pub(crate) fn with<'b>(&self, part: &'b Part) -> Body<'b> {
        Body::of(part, self.motion)
    }

    /// The size of the part: the diameter of a disc around it.
    pub(crate) fn size(&self) -> f64 {
        self.tree.extent()
    }

    /// Where the part is: x, y and θ of a part in the plane, or its motion on an axis as the first of the numbers.
    pub(crate) fn configuration(&self, at: Coords) -> Configuration {
        match self.motion {
            None => Configuration::new(at[0], at[1], at[2]),
            Some(motion) => Axis {
                motion,
                range: None,
            }
            .configuration(at[0]),
        }
    }

    /// A box that holds the part at a place, however it is turned there. It holds it all along a motion of constant rates together
    /// with the box at the other end.
    pub(crate) fn around(&self, at: Coords) -> Bounds {
        let p = self.pose(at, at).from;
        let far = Vector::new(self.reach, self.reach);
        Bounds {
            min: p - far,
            max: p + far,
        }
    }

    fn pose(&self, from: Coords, to: Coords) -> Pose {
        match self.motion {
            None => Pose::planar(from, to),
            Some(motion) => Pose::on_axis(motion, from[0], to[0]),
        }
    }

    fn placed(&self, at: Coords) -> At<'a> {
        At {
            part: self.part,
            placed: self.pose(at, at).at(0.0),
            origin: self.origin,
        }
    }
}

/// Two bodies during a motion of constant rates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Between<'a> {
    pub(crate) bodies: [&'a Body<'a>; 2],
    pub(crate) from: [Coords; 2],
    pub(crate) to: [Coords; 2],
}

impl Between<'_> {
    fn search(&self) -> Search<'_> {
        let [a, b] = self.bodies;
        let poses = (
            a.pose(self.from[0], self.to[0]),
            b.pose(self.from[1], self.to[1]),
        );
        Search::new(&a.tree, &b.tree, poses, a.size().max(b.size()))
    }

    /// The distance of the boundaries at the start if it is less than a limit; else infinite.
    pub(crate) fn distance_below(&self, limit: f64) -> Nearest {
        self.search().at_below(0.0, limit)
    }

    /// The least distance of the boundaries during the motion if it is less than a limit; else infinite.
    pub(crate) fn least_below(&self, limit: f64) -> Nearest {
        self.search().least_below(limit)
    }

    /// Whether the boundaries are farther apart than a distance during the motion, as far as that is found by looking at so many pairs of discs
    /// and pieces.
    pub(crate) fn is_apart(&self, distance: f64, effort: u32) -> bool {
        self.search().is_apart(distance, effort)
    }

    /// The nearest features at the start, and their nearest points in the assembly's frame.
    pub(crate) fn nearest(&self) -> Option<([FeatureName; 2], [Point; 2])> {
        let ((a, b), (p, q)) = self.search().nearest()?;
        Some(([a, b], [p, q]))
    }

    /// Whether the parts overlap at the start, where they do not just touch.
    pub(crate) fn overlaps(&self) -> bool {
        let [a, b] = self.bodies;
        let (at_a, at_b) = (a.placed(self.from[0]), b.placed(self.from[1]));
        overlap(&self.search(), &at_a, &at_b)
    }

    /// Whether the parts overlap at the start deeper than a depth, also where their boundaries coincide. What overlaps five times as
    /// deep is always found.
    pub(crate) fn overlaps_deeper(&self, depth: f64) -> bool {
        let [a, b] = self.bodies;
        let (at_a, at_b) = (a.placed(self.from[0]), b.placed(self.from[1]));
        overlaps_deeper(&self.search(), &at_a, &at_b, depth)
    }

    /// The bodies part of the way, as a share of it, and at rest there.
    pub(crate) fn at(&self, share: f64) -> Self {
        let there = [0, 1].map(|i| {
            core::array::from_fn(|k| self.from[i][k] + (self.to[i][k] - self.from[i][k]) * share)
        });
        Self {
            from: there,
            to: there,
            ..*self
        }
    }
}
