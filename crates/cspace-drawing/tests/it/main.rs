//! Drawings read, fitted, offset and refused.
#![allow(clippy::panic, clippy::unwrap_used)]
// 2π as files have it.
#![allow(clippy::approx_constant)]

mod curves;
mod drawings;
mod gaps;
mod hostile;
mod offset;
mod ordinary;
mod sources;
mod union;
