//! A mechanism as a system of coordinates, with what constrains them and what pushes.

mod coordinates;
mod dead_point;
mod force;
mod hand;
mod joint;
mod layout;
mod metric;
mod resistance;
mod row;

pub(crate) use coordinates::Law;
pub use coordinates::System;
pub(crate) use force::Pull;
pub use layout::PartCoordinates;
pub(crate) use layout::Placed;
pub use row::Row;
