//! First-order motion: the velocity nearest to the free one that no contact forbids.

mod bound;
mod choose;
mod describe;
mod ends;
mod events;
mod flow;
mod locate;
mod run;
mod velocity;
mod watch;

pub(crate) use flow::close;
pub(crate) use run::run;
