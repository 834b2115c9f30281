//! Pairs of all classes, through one type.
//!
//! | class | computed by | a configuration is |
//! |---|---|---|
//! | lower | table look-up ([`LowerPair`]) | (x, y, θ), on the joint |
//! | fixed axes | planar partition ([`FixedAxesSpace`](crate::FixedAxesSpace)) | (u, v) |
//! | symmetric | one period and copies ([`ContactSpace`](crate::ContactSpace)) | (x, y, θ) |
//! | general | the general method ([`ContactSpace`](crate::ContactSpace)) | (x, y, θ) |

mod answers;
mod data;
mod graph;
mod ids;
mod locate;
mod lower;
mod motion;
mod near;
mod patch;
mod project;
mod relation;
mod space;

pub use answers::{Neighbours, PairContact, PairCrossing, PairMotion, PairNearest, QueryError};
pub use data::{LowerData, PairData};
pub use graph::{LinkKind, PairLink, PairRegion};
pub use ids::FeatureId;
pub use lower::{Joint, LowerPair, PermanentContact, PermanentKind};
pub use motion::{SmoothMotion, SmoothOutcome};
pub use near::{NearFeatures, touching_features};
pub use patch::{ByDrawing, ByVertex, FeatureContact, PairPatch};
pub use project::{Metric, Projection};
pub use relation::{Coordinates, PairClass, Relation};
pub use space::{PairError, PairSpace};
