//! Mechanisms with masses as systems of the integrator of [`crate::dynamic`].
//!
//! Free coordinates are the integrator's; driven ones are functions of time. Parts that move in the plane have their centres of mass
//! for coordinates, so that the mass matrix is diagonal and constant.

mod bodies;
mod contacts;
mod forces;
mod observer;
mod rates;
mod run;
mod world;

pub(crate) use run::{Scheme, run};
