//! Ways, judged by what knows nothing of contact spaces.
#![allow(clippy::unwrap_used, clippy::panic)]

mod distances;
mod ends;
mod hidden;
mod random;
mod shrunk;
mod sliders;
mod thresholds;
