//! Words for features, angles and counts.

use cspace::{FeatureKind, FeatureName};

/// `line 3 of loop 0`.
pub(crate) fn feature(name: FeatureName) -> String {
    let kind = match name.kind {
        FeatureKind::Line => "line",
        FeatureKind::ConvexArc => "convex arc",
        FeatureKind::ConcaveArc => "concave arc",
        FeatureKind::Vertex => "vertex",
    };
    format!("{kind} {} of loop {}", name.index, name.loop_index)
}

/// `1 patch`, `2 patches`.
pub(crate) fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// An angle in radians with degrees after it.
pub(crate) fn angle(radians: f64) -> String {
    format!("{radians:.6} rad ({:.4} deg)", radians.to_degrees())
}
