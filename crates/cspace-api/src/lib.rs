//! Questions about parts, pairs and mechanisms, and their answers: the same for the command, Python, the page, and other programs.
//!
//! Each module has one question and its answer. An answer is data, with a schema in the folder `docs/answers` of the project's repository;
//! [`frame`] says which command it is of, in which units, and how it came out in one word.
//!
//! With the feature `command` each question is the arguments of a command as well: what documents a field is the help of its option.

mod ask;
pub mod check;
pub mod classify;
pub mod clearance;
#[cfg(feature = "command")]
mod command;
pub mod compute;
pub mod disassemble;
pub mod error;
pub mod escape;
pub mod files;
pub mod frame;
pub mod given;
mod host;
pub mod import;
pub mod info;
mod leg;
mod made_of;
pub mod modes;
mod outcome;
pub mod plan;
pub mod play;
mod rest;
mod rounded;
pub mod scene;
pub mod schemas;
mod side;
pub mod simulate;
pub mod slice;
pub mod solve;
pub mod subject;
pub mod sweep;
pub mod template;
pub mod tolerances;
mod twin;
mod vary;
pub mod written;

pub use ask::{AnyAnswer, Kind, Question, inlined};
pub use error::Error;
pub use frame::{Answer, Content, PairAnswer, Pairs, Units};
pub use given::Given;
pub use host::{Deaf, Host, Pieces, spaces};
pub use leg::{legs_in_words, motion_in_words};
pub use made_of::MadeOf;
pub use outcome::{Done, Is, Outcome, worst};
pub use rest::Rest;
pub use side::place_on_part;
pub use subject::{Chosen, Named, Subject, Which};
pub use twin::Twin;
pub use vary::Vary;
