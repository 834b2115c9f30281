//! Numbers: one trait, and the kinds of arithmetic in which formulas are evaluated.

mod ball;
mod dd;
mod dual;
mod expansion;
mod least;
mod polynomial;
mod real;
mod trig;

pub use ball::Ball;
pub(crate) use dd::Dd;
pub use dual::{Dual, SecondOrder};
pub(crate) use expansion::Expansion;
pub(crate) use least::{Bounded, NARROWEST, halved, least};
pub(crate) use polynomial::TrigPolynomial;
pub(crate) use real::Ordered;
pub use real::Real;
pub(crate) use trig::{Distances, Event, Trig};
