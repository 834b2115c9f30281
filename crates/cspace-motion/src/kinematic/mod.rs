//! Motion without inertia: forces in balance while drives move, and what no force acts on as it is pushed.

mod balance;
mod between;
mod check;
mod choose;
mod ending;
mod events;
mod flow;
mod foreseen;
mod friction;
mod holding;
mod locate;
mod modes;
mod resisted;
mod rest;
mod run;
mod settle;
mod there;
mod velocity;

pub(crate) use flow::close;
pub(crate) use settle::run;
