//! Answers of the command `cspace`, as JSON: the same wherever it is asked, in a terminal or on a page.
//!
//! The schemas are in the folder `docs/answers` of the project's repository.

pub mod check;
mod frame;
mod leg;
mod made_of;
pub mod plan;
mod rest;
mod rounded;
mod side;
pub mod simulate;
mod twin;

pub use frame::{Answer, Is, Outcome, PairAnswer, Pairs, Units};
pub use leg::{legs_in_words, motion_in_words};
pub use made_of::MadeOf;
pub use rest::Rest;
pub use side::place_on_part;
pub use twin::Twin;
