//! Identification of edges and vertices of a part.

use core::fmt;

/// An edge or a vertex of a part, by its loop and vertex as given, counted from 0. An edge has the number of the vertex at which it starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum PartFeature {
    /// A line or an arc.
    Edge {
        /// The loop.
        loop_index: u32,
        /// The vertex at which the edge starts.
        index: u32,
    },
    /// A vertex.
    Vertex {
        /// The loop.
        loop_index: u32,
        /// The vertex.
        index: u32,
    },
}

impl fmt::Display for PartFeature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Edge { loop_index, index } => write!(f, "edge {index} of loop {loop_index}"),
            Self::Vertex { loop_index, index } => write!(f, "vertex {index} of loop {loop_index}"),
        }
    }
}
