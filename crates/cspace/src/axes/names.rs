//! Names of nodes: ends of curves that have one name are one place.

/// What a node is, so that ends of curves find each other.
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
    /// The two roots of a pair become one: pair, which of them.
    Turning(u32, u32),
    /// A curve goes on with the same pair: at the cut of a circle, or where it is cut to be monotone.
    Same(u32, u32),
    /// A curve goes on in the next copy of the window.
    Seam(u32, u32),
    /// A limit of a motion, or the window's end.
    Limit,
}

/// A name, which of several such configurations, and in which turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Key {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x_turn: i32,
    pub(super) y_turn: i32,
}

impl Key {
    /// The key when pairs have other numbers.
    pub(super) fn renumbered(mut self, number: impl Fn(u32) -> u32) -> Self {
        if let Name::Turning(pair, _) | Name::Same(pair, _) = &mut self.name {
            *pair = number(*pair);
        }
        self
    }
}

/// A node on the curve of a pair; coordinates in the first turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub(super) name: Name,
    pub(super) root: u8,
    pub(super) x: f64,
    pub(super) y: f64,
    /// Where it is in the window, and in which copy of it x is.
    pub(super) in_window: f64,
    pub(super) copy: u32,
}
