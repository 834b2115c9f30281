//! Few and simple legs for a way that was found: along tracks, and along the way itself where tracks lead nowhere.

use super::legs::Legs;
use super::outside::{Outs, Outside};
use super::raise::ENOUGH;
use super::search::{ACROSS, Given, Keep, Search};
use super::shorten::KEPT;
use super::tracks::Tracks;

/// Criterion for choosing among paths.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, schemars::JsonSchema, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Prefer {
    /// Few legs, each straight or a turn on the spot where that is possible.
    #[default]
    Legs,
    /// Clearance: legs keep most of what the way has where it is.
    Clearance,
    /// A short way.
    Length,
}

impl<'a> Legs<'a> {
    /// The way with few and simple legs, none of which has less than a clearance; to the last place or, if that is given, to where the
    /// part is out. No way between the two has more than the clearance `most`.
    pub(crate) fn simple(
        &self,
        clearance: f64,
        most: f64,
        outside: Option<&Outside<'_>>,
    ) -> Legs<'a> {
        /// Shares of the clearance that no way exceeds, of which a way with as many legs has the largest that is found.
        const SHARES: [f64; 7] = [0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 0.999];
        /// Weights that differ by less are those of as many legs of the same kinds.
        const SAME: f64 = 0.8 * (ACROSS - 1.0);
        let bends = self.shortened(clearance, KEPT);
        let tracks = Tracks::new(self.scene, &self.places, bends.places());
        let profile: Vec<f64> = self.narrowest.iter().map(|n| n.distance).collect();
        let outs = Outs::new(&tracks, outside);
        let given = Given {
            scene: self.scene,
            places: &self.places,
            length: self.length(),
            profile: &profile,
            bends: bends.places(),
            tracks: &tracks,
            outs: &outs,
        };
        // The fewest legs first: without a turn that nothing asks for, then with turns.
        let keep = Keep {
            least: clearance,
            most: gaps(&profile).min(ENOUGH * self.scene.size()),
        };
        let few = tracks.angles.len().min(2);
        let mut best = Search::new(&given, keep, few, f64::INFINITY).run();
        let least = best.as_ref().map_or(f64::INFINITY, |b| b.0);
        if tracks.angles.len() > few
            && let Some(found) = Search::new(&given, keep, tracks.angles.len(), least).run()
        {
            best = Some(found);
        }
        let Some(mut best) = best else {
            return bends;
        };
        // Then as many with the most clearance: where less is not found, more is not either.
        let shares = SHARES.iter().map(|s| s * most).filter(|&l| l > clearance);
        let levels: Vec<f64> = core::iter::once(clearance).chain(shares).collect();
        let (mut lo, mut hi) = (0, levels.len());
        while lo < hi {
            let middle = lo.midpoint(hi);
            let keep = Keep {
                least: levels[middle],
                most: f64::INFINITY,
            };
            let found = Search::new(&given, keep, tracks.angles.len(), best.0 + SAME).run();
            if let Some(found) = found {
                best.1 = found.1;
                lo = middle + 1;
            } else {
                hi = middle;
            }
        }
        Legs::new(self.scene, best.1)
    }
}

/// The least clearance of a way in its gaps, from that of its legs: beside its ends, from which it may rise first.
fn gaps(profile: &[f64]) -> f64 {
    let rises = |p: &[f64]| p[1] > p[0];
    let first = profile.windows(2).take_while(|p| rises(p)).count();
    let falls = profile.windows(2).rev().take_while(|p| !rises(p)).count();
    let within = profile
        .get(first..profile.len() - falls)
        .unwrap_or_default();
    within.iter().copied().fold(f64::INFINITY, f64::min)
}
