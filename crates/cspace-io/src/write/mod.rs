//! Writers for contact spaces and slices.

pub mod svg;
