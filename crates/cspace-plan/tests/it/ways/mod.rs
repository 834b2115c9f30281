//! Ways, judged by what knows nothing of contact spaces.

mod by_hand;
mod distances;
mod ends;
mod every;
mod fits;
mod hidden;
mod hook;
mod judge;
mod out;
mod random;
mod shrunk;
mod sliders;
mod thresholds;
