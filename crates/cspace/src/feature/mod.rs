//! Features of a part: the lines, arcs and convex vertices that can touch, and the joints between them.
//!
//! Two parts of a pair are first moved to a common frame (`frame.rs`): each about its own centre, both scaled by one power of two so that
//! they fit the unit disc. All tolerances (`tolerance.rs`) are therefore lengths relative to the pair's size.
//!
//! A part then goes through three steps, each of which changes it by less than the resolution:
//!
//! ```text
//!   as drawn ──→ generic ──→ smooth ──→ grown      ┌───────────● apex: a vertex, with normals n₁ to n₂
//!                                                  │ ┌───────┐ │
//!                                                  │ │ drawn │ │ ← g, what the part is grown by
//!                                                  │ │   ┌───┘ │
//!                                                  │ │   │  ┌──┘
//!                                                  │ │   │ ─┼─    a concave corner: edges are carried on
//! ```
//!
//! 1. Every vertex is moved by its own amount (`perturbation.rs`), so that no two features coincide by design.
//! 2. Edges that are meant to meet smoothly are made smooth, to the last digit of double-double (`generic/`).
//! 3. Every edge moves outward by g (`extract.rs`): fits without clearance then certainly overlap, and near-coincidences are decided. A
//!    convex corner becomes an apex (`joining.rs`); nothing touches a concave one, and its edges are extended into the material, so that
//!    contact curves cross there instead of sharing an end.

mod as_drawn;
mod extract;
mod frame;
mod framed_edge;
mod generic;
mod inscribed;
mod joining;
mod material;
mod perturbation;
pub(crate) mod tolerance;
mod types;

pub(crate) use as_drawn::as_drawn;
pub use frame::PairFrame;
pub(crate) use inscribed::{SHARES, inscribed_disc, inscribed_discs};
pub(crate) use perturbation::Perturbation;
pub(crate) use types::{Feature, Joint, Near, Outline};
pub use types::{FeatureKind, FeatureName};
