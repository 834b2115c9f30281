//! Conversions from and to the types of other crates, each behind the Cargo feature of its name.

#[cfg(feature = "geo-types")]
mod geo_types;
#[cfg(feature = "kurbo")]
mod kurbo;
#[cfg(feature = "mint")]
mod mint;

#[cfg(feature = "kurbo")]
pub use kurbo::NoCircle;
