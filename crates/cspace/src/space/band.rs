//! Bands: the orientations between critical ones.

use core::f64::consts::TAU;

use super::options::Window;

/// An interval between consecutive critical orientations: within it only lengths change.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Band {
    /// Critical orientation at which the band begins.
    pub lo: f64,
    /// Critical orientation at which the band ends; beyond π for the band that contains π.
    pub hi: f64,
}

/// The bands of a window, in order; a single one if there are no critical orientations.
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
