//! Bands: the orientations between critical ones.

use core::f64::consts::TAU;

use super::options::Window;

/// An interval between consecutive critical orientations: within it nothing but lengths changes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Band {
    /// The critical orientation it begins at.
    pub lo: f64,
    /// The one it ends at, beyond π for the band that passes it.
    pub hi: f64,
}

/// The bands of a window, in order. Without critical orientations there is one.
pub(crate) fn bands(window: Window, critical: &[f64]) -> Vec<Band> {
    let mut bounds = critical.to_vec();
    if !window.full_turn || critical.is_empty() {
        bounds.insert(0, window.lo);
        bounds.push(window.hi);
    } else {
        bounds.push(critical[0] + TAU);
    }
    let bands = bounds.windows(2).map(|w| Band { lo: w[0], hi: w[1] });
    bands.filter(|b| window.full_turn || b.lo < b.hi).collect()
}
