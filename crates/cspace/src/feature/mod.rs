//! Features of a part: the lines, arcs and convex vertices that can touch, and the joints between them.
//!
//! Two parts of a pair are brought to a common frame first: each about its own centre, both scaled by one power of
//! two so that they fit the unit disc. All tolerances of the kernel are therefore lengths relative to the pair's size.

mod concentric;
mod extract;
mod frame;
mod framed_edge;
mod generic;
mod growth;
mod inscribed;
mod joining;
mod material;
mod perturbation;
pub(crate) mod tolerance;
mod types;

pub(crate) use concentric::equal_sums;
pub(crate) use frame::PairFrame;
pub(crate) use growth::Growths;
pub(crate) use inscribed::{Plenty, inscribed_discs};
pub(crate) use material::Material;
pub(crate) use perturbation::Perturbation;
pub(crate) use types::{Feature, Near, Outline, Shape};
pub use types::{FeatureKind, FeatureName};
