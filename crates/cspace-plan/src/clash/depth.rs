//! How deep two parts overlap.

use cspace::{Configuration, FeatureName, Part, Placement, Point, Rotation, Slice, touching};

/// The most pairs of edges of two parts of which a slice is computed: it takes about a second.
const MOST_EDGE_PAIRS: usize = 1 << 20;

/// The shortest translation of the second part after which two parts do not overlap.
pub(super) struct Separated {
    /// Its length.
    pub(super) depth: f64,
    /// The points that touch then, in the assembly's frame: the second where it is before.
    pub(super) points: [Point; 2],
    pub(super) features: [FeatureName; 2],
}

/// The shortest translation that separates two parts, the frames of which are seen from the assembly's; none if they have too many
/// edges for it.
///
/// At the orientation that the second part has relative to the first, the boundary of free space is a slice of their contact
/// space. The nearest point of it to where the second part is, is where it is moved to. Places at which the part would fit without
/// any play are no free space.
pub(super) fn separated(parts: [&Part; 2], at: [Configuration; 2]) -> Option<Separated> {
    let [first, second] = parts;
    if first.edges().count() * second.edges().count() > MOST_EDGE_PAIRS {
        return None;
    }
    let relative = at[0].inverse().compose(at[1]);
    let slice = Slice::compute(first, second, relative.theta);
    let here = relative.position();
    let (curve, there) = slice.nearest(here)?;
    let moved = Configuration::new(there.x, there.y, relative.theta);
    let shapes = (
        first.feature_shape(curve.fixed)?,
        second.feature_shape(curve.moving)?,
    );
    let placement = Placement::new([moved.x, moved.y], moved.theta);
    let touch = touching(&shapes.0, &shapes.1, &placement);
    let assembly = |p: Point| at[0].fixed_from_moving(p);
    let translation = Rotation::by(at[0].theta) * (there - here);
    let on_first = assembly(touch.on_fixed);
    Some(Separated {
        depth: there.distance(here),
        points: [on_first, on_first - translation],
        features: [curve.fixed, curve.moving],
    })
}

/// How deep two parts overlap as they are drawn; none if they have too many edges for it.
pub(crate) fn depth(first: &Part, second: &Part) -> Option<f64> {
    separated([first, second], [Configuration::default(); 2]).map(|s| s.depth)
}
