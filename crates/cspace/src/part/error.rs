//! Errors of a part.

use crate::geometry::Point;

use super::drawing::OutlineError;
use super::part_feature::PartFeature;
use super::tolerance::{
    FULL_BULGE, MAX_COORDINATE, MAX_LAYERS, MAX_OFFSET, MAX_VERTICES, MIN_SIZE,
};

/// Reasons for which loops do not make a part. Loops, vertices and edges are counted from 0, as given; an edge has the number of the vertex
/// at which it starts.
///
/// ```
/// use cspace::{Part, PartError, Vertex};
/// let there_and_back = vec![Vertex::line(0.0, 0.0), Vertex::line(1.0, 0.0)];
/// assert_eq!(
///     Part::new("flat", vec![there_and_back]),
///     Err(PartError::TooFewVertices { loop_index: 0, count: 2 })
/// );
/// ```
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PartError {
    /// There is no loop.
    #[error("the part has no loops: give at least one closed loop of vertices")]
    Empty,

    /// There are more layers than the limit.
    #[error("the part has {count} layers, more than {MAX_LAYERS}: merge some, or split the part")]
    TooManyLayers {
        /// The number of layers.
        count: usize,
    },

    /// A layer has no loop.
    #[error("layer {layer} has no loops: give at least one closed loop of vertices")]
    EmptyLayer {
        /// The layer.
        layer: usize,
    },

    /// The heights of a layer are not an interval.
    #[error(
        "layer {layer}: its heights are not two finite numbers of which the second is the larger: give z = [lowest, highest]"
    )]
    BadHeights {
        /// The layer.
        layer: usize,
    },

    /// There are more vertices than the limit.
    #[error(
        "the part has {count} vertices, more than {MAX_VERTICES}: replace runs of short lines by arcs, or split the part"
    )]
    TooManyVertices {
        /// The number of vertices of all loops.
        count: usize,
    },

    /// A loop has fewer than two vertices, or two that are joined by lines only.
    #[error(
        "loop {loop_index} has {count} vertices and encloses nothing: give three, or two of which one has a bulge"
    )]
    TooFewVertices {
        /// The loop.
        loop_index: usize,
        /// Its number of vertices.
        count: usize,
    },

    /// A coordinate is not a finite number.
    #[error(
        "loop {loop_index}, vertex {vertex_index}: a coordinate is not a finite number: give numbers for x and y"
    )]
    BadCoordinate {
        /// The loop.
        loop_index: usize,
        /// The vertex.
        vertex_index: usize,
    },

    /// A vertex, or the arc that leaves it, reaches too far for squares to be computed.
    #[error(
        "loop {loop_index}, vertex {vertex_index}: the vertex or its edge reaches beyond {MAX_COORDINATE:e}: choose a larger unit of length or a smaller bulge"
    )]
    CoordinateTooLarge {
        /// The loop.
        loop_index: usize,
        /// The vertex.
        vertex_index: usize,
    },

    /// A bulge is not a finite number or gives no arc.
    #[error(
        "loop {loop_index}, vertex {vertex_index}: the bulge {bulge:?} gives no arc: give tan(sweep / 4), of magnitude at most {FULL_BULGE:e}; draw a full circle as two half circles of bulge 1"
    )]
    BadBulge {
        /// The loop.
        loop_index: usize,
        /// The vertex.
        vertex_index: usize,
        /// The bulge.
        bulge: f64,
    },

    /// The part is too small for squares to be computed.
    #[error("the part's size is {size:e}, less than {MIN_SIZE:e}: choose a smaller unit of length")]
    TooSmall {
        /// The diagonal of the part's box.
        size: f64,
    },

    /// The part is so far from the origin that its coordinates are coarse.
    #[error(
        "the part, of size {size:e}, is {distance:e} from the origin, more than {MAX_OFFSET:e} sizes: move it nearer to the origin"
    )]
    TooFar {
        /// The diagonal of the part's box.
        size: f64,
        /// The largest coordinate of the box.
        distance: f64,
    },

    /// A vertex and the next are at one place.
    #[error(
        "loop {loop_index}, vertex {vertex_index}: the next vertex, {next_index}, is at the same place: remove one of them"
    )]
    CoincidentVertices {
        /// The loop.
        loop_index: usize,
        /// The vertex.
        vertex_index: usize,
        /// The vertex after it.
        next_index: usize,
    },

    /// The edges before and after a vertex leave it in the same direction.
    #[error(
        "loop {loop_index}, vertex {vertex_index}: the boundary turns back on itself here: remove the spike, or open its angle"
    )]
    Spike {
        /// The loop.
        loop_index: usize,
        /// The vertex.
        vertex_index: usize,
    },

    /// Two edges cross.
    #[error(
        "loop {loop_index}, edge {edge_index} crosses loop {other_loop}, edge {other_edge} near ({:?}, {:?}): move the vertices so that the edges stay apart",
        at.x, at.y
    )]
    Crossing {
        /// The loop of the first edge.
        loop_index: usize,
        /// The first edge, by the vertex at which it starts.
        edge_index: usize,
        /// The loop of the second edge.
        other_loop: usize,
        /// The second edge, by the vertex at which it starts.
        other_edge: usize,
        /// Place of the crossing.
        at: Point,
    },

    /// Two edges touch, or overlap, elsewhere than at the vertex they share.
    #[error(
        "loop {loop_index}, edge {edge_index} touches loop {other_loop}, edge {other_edge} near ({:?}, {:?}): move them apart, or merge the loops there",
        at.x, at.y
    )]
    Touching {
        /// The loop of the first edge.
        loop_index: usize,
        /// The first edge, by the vertex at which it starts.
        edge_index: usize,
        /// The loop of the second edge.
        other_loop: usize,
        /// The second edge, by the vertex at which it starts.
        other_edge: usize,
        /// Place of the contact.
        at: Point,
    },

    /// A loop is given twice, perhaps from another vertex or the other way around.
    #[error("loop {other_loop} is loop {loop_index} again: remove one of them")]
    RepeatedLoop {
        /// The loop.
        loop_index: usize,
        /// The loop that repeats it.
        other_loop: usize,
    },

    /// A size of a plain shape is not a positive number.
    #[error("the {what} is {value:?}: give a positive number")]
    BadSize {
        /// Which size.
        what: &'static str,
        /// Value that was given.
        value: f64,
    },

    /// A size of a plain shape is negligible compared with the others.
    #[error(
        "the {what} is {value:e}, at most {least:e}, which is nothing in a part of this size: give a larger one"
    )]
    TooThin {
        /// Which size.
        what: &'static str,
        /// Value that was given.
        value: f64,
        /// Bound that the value must exceed.
        least: f64,
    },

    /// A name is given to an edge or a vertex that does not exist.
    #[error("there is no {feature}: choose one of the part's loops and vertices, counted from 0")]
    NoFeature {
        /// The feature that does not exist.
        feature: PartFeature,
    },

    /// The name of an edge or a vertex is empty, or is used twice.
    #[error(
        "the name {name:?} of {feature} is empty or given twice: give every one a name of its own"
    )]
    FeatureName {
        /// The feature that was to be named.
        feature: PartFeature,
        /// The name.
        name: String,
    },

    /// An outline cannot be drawn.
    #[error(transparent)]
    Outline(#[from] OutlineError),
}
