//! Exact arithmetic: dyadic rationals, and cosines and sines to 200 bits.
//!
//! Every finite `f64` is a dyadic rational, and sums and products of dyadic rationals are dyadic, without rounding.
//! Quotients and roots are never formed; they are checked by multiplying back.

mod angle;
mod dyadic;

pub use angle::{ANGLE_ERROR, cos_sin};
pub use dyadic::Dyadic;
