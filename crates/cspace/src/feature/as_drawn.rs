//! What a feature of a part that was drawn anew, to be symmetric, is called in the part as it is given.

use crate::part::Symmetrized;

use super::FeatureName;

/// What a feature of a part drawn anew is called in the part as drawn.
pub(crate) fn as_drawn(symmetrized: &Option<Symmetrized>, name: FeatureName) -> FeatureName {
    let place = |s: &Symmetrized| {
        let l = s.drawn.get(name.loop_index as usize)?;
        l.get(name.index as usize).copied()
    };
    let Some(drawn) = symmetrized.as_ref().and_then(place) else {
        return name;
    };
    let index = match name.kind {
        crate::feature::FeatureKind::Vertex => drawn.vertex,
        _ => drawn.edge,
    };
    FeatureName { index, ..name }
}
