//! The published schemas, held against what is written.

mod classes;
mod helpers;
mod labels;
mod planar;
