//! Ways, judged by what knows nothing of contact spaces.

mod distances;
mod random;
mod shrunk;
mod thresholds;
