//! Queries to spaces, and to pairs of any class.

mod about;
#[cfg(feature = "serde")]
mod answers_saved;
mod contact;
mod farthest;
mod lower;
mod motion;
mod near;
mod nearest;
mod pairs;
mod project;
