//! Two parts on axes over all motions that their ranges allow: whether they are clear of each other and by how much, what stops them, and
//! whether one turns only with the other.
//!
//! The plane of their motions (u, v) decides. If no contact bounds the free region in which the parts are drawn, it is all that the ranges
//! allow, and the parts are clear. Then a smallest gap is *found* by descent, and *proved* by the plane of the same parts, the moving one
//! grown by a billionth less than the gap: the gap is the smallest if nothing touches there, and if something does, a smaller one is found
//! beside it. Otherwise the region's boundary says what stops which part: along each of its curves one coordinate is a monotone function of
//! the other, so that the least and the greatest value of a coordinate are at ends of curves. No pose is sampled to decide anything.
//!
//! ```
//! use cspace::{Axis, Part, Point};
//! use cspace_model::{PartEntry, compute_anew};
//! use cspace_plan::ranges::{Pair, Verdict};
//! // A disc of radius 1, whose middle turns at 2 about the origin, and a disc of radius 0.5 at 5.
//! let arm = PartEntry::revolute(Part::circle("arm", [0.0, 2.0], 1.0)?, Point::ORIGIN);
//! let post = PartEntry::fixed(Part::circle("post", [5.0, 0.0], 0.5)?);
//! let pair = Pair::new([&arm, &post], [0.0, 0.0]).ok_or("both have axes")?;
//! let compute = compute_anew(&cspace::Silent);
//! let Verdict::Clear(tightest) = pair.over_ranges(f64::INFINITY, &compute)? else {
//!     return Err("nothing touches".into());
//! };
//! assert!((tightest.gap - 1.5).abs() < 1e-12);
//! assert!(tightest.gap - tightest.least < 1e-8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod backlash;
mod descent;
mod free;
mod gap;
mod kept;
mod mesh;
mod over;
mod pair;
mod reach;
mod region;
mod swept;
mod widths;

pub use answer::{Backlash, Contact, End, Held, Limits, Stop, Tightest, Verdict};
pub use free::Free;
pub use mesh::Mesh;
pub use pair::Pair;
pub use swept::Pairs;
