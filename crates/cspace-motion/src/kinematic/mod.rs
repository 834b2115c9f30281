//! First-order motion: the velocity nearest to the free one that no contact forbids.

mod balance;
mod check;
mod choose;
mod events;
mod flow;
mod locate;
mod run;
mod settle;
mod velocity;

pub(crate) use flow::close;
pub(crate) use run::run;
