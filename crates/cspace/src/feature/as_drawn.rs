//! Names of the features of a part that was redrawn as symmetric, in the part as given.

use crate::part::Symmetrized;

use super::FeatureName;

/// The name, in the part as drawn, of a feature of the redrawn part.
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
