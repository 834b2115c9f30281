//! Pieces of contact curves: monotone graphs y(x), and vertical segments.

use super::condition::Condition;
use core::f64::consts::TAU;

/// Two features that can touch, and their condition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub(super) first: u32,
    pub(super) second: u32,
    pub(super) condition: Condition,
}

/// An end of a piece. Its y is `base` + 2π `turns`; the base is the node's, equal for all pieces that end there.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct End {
    pub(super) key: Key,
    pub(super) x: f64,
    pub(super) base: f64,
    pub(super) turns: i32,
}

impl End {
    pub(super) fn y(&self) -> f64 {
        self.base + TAU * f64::from(self.turns)
    }
}

/// A piece of the contact curve of a pair on which y is a monotone function of x, or x is constant.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Piece {
    pub(super) pair: u32,
    /// Root 0 has free space above it, root 1 below. For a vertical piece, 0 has it on the right, 1 on the left.
    pub(super) root: u8,
    pub(super) vertical: bool,
    /// y is the condition's root plus this number of turns.
    pub(super) turns: i32,
    /// The left end, or the lower one.
    pub(super) start: End,
    pub(super) end: End,
}

/// A value of y as a sum whose second term is exact: value + 2π turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Height {
    pub(super) value: f64,
    pub(super) turns: i32,
}

impl Height {
    pub(super) fn y(self) -> f64 {
        self.value + TAU * f64::from(self.turns)
    }

    /// Distance of this above another that is moved up by `shift` turns.
    pub(super) fn above(self, other: Self, shift: i32) -> f64 {
        (self.value - other.value) + TAU * f64::from(self.turns - other.turns - shift)
    }
}

impl Piece {
    /// The piece with another number of its pair, also in names.
    pub(super) fn renumbered(mut self, number: impl Fn(u32) -> u32) -> Self {
        self.pair = number(self.pair);
        for end in [&mut self.start, &mut self.end] {
            end.key = end.key.renumbered(&number);
        }
        self
    }

    /// Converts a graph to a vertical piece: it is so steep that rounding leaves it no width.
    pub(super) fn stand_up(&mut self, pairs: &[Pair]) {
        let condition = &pairs[self.pair as usize].condition;
        let (by_x, _) = condition.gradient(self.start.x, self.start.y());
        self.vertical = true;
        self.root = u8::from(by_x < 0.0);
        if self.start.y() > self.end.y() {
            core::mem::swap(&mut self.start, &mut self.end);
        }
    }

    pub(super) fn x_range(&self) -> (f64, f64) {
        (self.start.x, self.end.x)
    }

    pub(super) fn y_range(&self) -> (f64, f64) {
        let (a, b) = (self.start.y(), self.end.y());
        (a.min(b), a.max(b))
    }

    /// y at x; not for a vertical piece.
    pub(super) fn y(&self, pairs: &[Pair], x: f64) -> f64 {
        self.height(pairs, x).y()
    }

    /// y at x; at an end it is the node's, equal for all pieces that meet there.
    pub(super) fn height(&self, pairs: &[Pair], x: f64) -> Height {
        for end in [&self.start, &self.end] {
            if x == end.x {
                return Height {
                    value: end.base,
                    turns: end.turns,
                };
            }
        }
        Height {
            value: pairs[self.pair as usize].condition.y(x, self.root),
            turns: self.turns,
        }
    }
}

// Names of nodes: ends of curves with equal names are one place.

/// Identity of a node, by which ends of curves are matched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum Name {
    /// A joint of the first part touches a round feature of the second.
    FirstJoint(u32, u32),
    /// A round feature of the first part touches a joint of the second.
    SecondJoint(u32, u32),
    /// Two vertices touch.
    Vertices(u32, u32),
    /// Two lines touch along a stretch.
    Lines(u32, u32),
    /// A line of the first part has the normal of a joint of the second, between round features.
    LineJoint(u32, u32),
    /// A joint of the first part, between round features, has the normal of a line of the second.
    JointLine(u32, u32),
    /// Two smooth joints between arcs touch, their normals opposite.
    Joints(u32, u32),
    /// The two roots of a pair merge: pair, number of the place.
    Turning(u32, u32),
    /// A curve continues with the same pair: at the cut of a circle, or where it is cut to be monotone.
    Same(u32, u32),
    /// A curve continues in the next copy of the window.
    Seam(u32, u32),
    /// A limit of a motion, or the window's end.
    Limit,
}

/// A name, the number of the configuration among those of that name, and its turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Key {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x_turn: i32,
    pub(super) y_turn: i32,
}

impl Key {
    /// The key with other numbers of pairs.
    pub(super) fn renumbered(mut self, number: impl Fn(u32) -> u32) -> Self {
        if let Name::Turning(pair, _) | Name::Same(pair, _) = &mut self.name {
            *pair = number(*pair);
        }
        self
    }
}

/// A node on the curve of a pair, with coordinates in the first turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x: f64,
    pub(super) y: f64,
    /// Its place in the window, and the copy of the window that contains x.
    pub(super) in_window: f64,
    pub(super) copy: u32,
}
