//! Checkable proofs that there is no path between two configurations.
//!
//! If start and goal are in different free regions, one of them is enclosed by a surface in blocked space. [`prove`]
//! finds such a surface, writes it as triangles, and gives for each triangle two discs of the parts' material that
//! overlap at every configuration in it. Each returned proof has passed `cspace_check`, which does not use contact
//! spaces.
//!
//! ```text
//! pair → moving part shrunk (barrier) → its region's surface as triangles → discs for each (witness), split where
//! there are none (refine) → proof, checked
//! ```

mod barrier;
mod complex;
mod disc;
mod error;
mod prove;
mod refine;
mod witness;

pub use error::ProofError;
pub use prove::prove;
