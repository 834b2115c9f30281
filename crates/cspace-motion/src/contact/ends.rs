//! Ends of contacts: where a contact of two features ends because one of the features does.
//!
//! ```text
//!   edge: the place of the contact p is between its ends      vertex: the normal is between those of its sides
//!
//!        t₁ · (p − a) ≥ 0    t₂ · (b − p) ≥ 0                        n · t₁ ≥ 0    −n · t₂ ≥ 0
//!
//!       a →t₁ ------ p ------ b →t₂                               →t₁ ·  n ↗
//!             (material)                                                ↓t₂
//! ```
//!
//! For an arc of more than half a turn the functions are correct only near the ends they belong to, where they are
//! evaluated.

use cspace::{
    Coordinates, FeatureId, FeatureKind, FeatureName, FeatureShape, Part, Placement, Point, Vector,
};

use crate::pairs::{MovingPair, Touch};
use crate::system::System;

/// Smallest distance past the end of a feature, as an angle or a length, that is more than rounding.
pub(crate) const PAST_END: f64 = 2e-11;

/// Functions that are positive while the contact is between the ends of both features; one of them vanishes at an end.
/// They are always in the same order. Empty if the features do not determine them.
pub(crate) fn ends(pair: &MovingPair, touch: &Touch, system: &System, q: &[f64]) -> Vec<f64> {
    let Some(place) = pair.touching(touch, system, q) else {
        return Vec::new();
    };
    let relative = system.relative(pair.fixed, pair.moving, q);
    let fixed_from_moving = Placement::from(relative);
    let moving_from_fixed = fixed_from_moving.inverse();
    let n = place.normal;
    let [x, y] = moving_from_fixed.point([place.on_moving.x, place.on_moving.y]);
    let [nx, ny] = moving_from_fixed.vector([-n.x, -n.y]);
    let fixed = Contact {
        at: place.on_fixed,
        normal: n,
    };
    let moving = Contact {
        at: Point::new(x, y),
        normal: Vector::new(nx, ny),
    };
    let (f, m) = touch.features;
    let of = |part: &Part, feature: FeatureId, contact: &Contact| contact.ends(part, feature.name);
    let both = [
        of(pair.space.fixed(), f, &fixed),
        of(pair.space.moving(), m, &moving),
    ];
    both.into_iter().flatten().flatten().collect()
}

/// Whether two features that touch go past an end of one of them from one configuration to another: where features bend slowly, the space
/// still reports the contact for some distance.
pub(crate) fn goes_past(
    pair: &MovingPair,
    touch: &Touch,
    system: &System,
    way: [&[f64]; 2],
) -> bool {
    let (f, m) = touch.features;
    let long = [
        is_long(pair.space.fixed(), f),
        is_long(pair.space.moving(), m),
    ];
    let [before, after] = way.map(|q| ends(pair, touch, system, q));
    let mut each = before
        .into_iter()
        .zip(after)
        .enumerate()
        .filter(|(k, _)| !long[k / 2]);
    each.any(|(_, (before, after))| after <= -PAST_END && after < before)
}

/// Whether an edge is an arc of more than half a turn, whose end functions are correct only near the ends.
pub(super) fn is_long(part: &Part, feature: FeatureId) -> bool {
    matches!(part.feature_shape(feature.name), Some(FeatureShape::Edge { bulge, .. }) if bulge.abs() > 1.0)
}

/// The place and the outward normal of a contact, in a part's frame.
struct Contact {
    at: Point,
    normal: Vector,
}

impl Contact {
    fn ends(&self, part: &Part, name: FeatureName) -> Option<[f64; 2]> {
        let outline = part.loops().get(name.loop_index as usize)?;
        let (index, count) = (name.index as usize, outline.vertices().len());
        if name.kind != FeatureKind::Vertex {
            let edge = outline.edge(index)?;
            return Some([
                edge.start_direction().dot(self.at - edge.start),
                edge.end_direction().dot(edge.end - self.at),
            ]);
        }
        let (before, after) = (
            outline.edge((index + count - 1) % count)?,
            outline.edge(index)?,
        );
        let (before, after) = if outline.is_reversed() {
            (after, before)
        } else {
            (before, after)
        };
        Some([
            self.normal.dot(before.end_direction()),
            -self.normal.dot(after.start_direction()),
        ])
    }
}

impl MovingPair {
    /// Points at which two features touch, in the fixed part's frame.
    fn touching(&self, touch: &Touch, system: &System, q: &[f64]) -> Option<cspace::Touching> {
        let at: Coordinates = self.coordinates(system, q);
        touch.contact().touching(at).ok()
    }
}
