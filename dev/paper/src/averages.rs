//! Averages over the nine engineering pairs and the two knee pairs.

use cspace_baseline::paper::Group;
use serde::Serialize;

use crate::measure::Measured;

/// `None` where no pair of the group was measured.
#[derive(Serialize)]
pub(crate) struct Averages {
    pub(crate) engineering: Option<Average>,
    pub(crate) knee: Option<Average>,
}

#[derive(Serialize)]
pub(crate) struct Average {
    /// How many pairs of the group were measured.
    pub(crate) pairs: usize,
    pub(crate) slices: Ratios,
    /// The ratios of slices for the same pairs, from the numbers in Figure 5.
    pub(crate) paper_slices: Ratios,
    pub(crate) seconds: Ratios,
    /// Geometric mean of the time ratios with the general algorithm's search of critical orientations.
    pub(crate) seconds_with_criticalities: f64,
    /// How many pairs' searches did not end, so that it is more than that.
    pub(crate) criticalities_unfinished: usize,
    /// Geometric mean of the time ratios without symmetry.
    pub(crate) seconds_without_symmetry: f64,
    /// The factor that the paper's text gives.
    pub(crate) paper_factor: f64,
}

/// Three averages of old by new: the paper does not say which its own is.
#[derive(Serialize, Clone, Copy)]
pub(crate) struct Ratios {
    pub(crate) mean: f64,
    pub(crate) geometric_mean: f64,
    /// Sum of the old by sum of the new.
    pub(crate) of_totals: f64,
}

impl Ratios {
    fn of(pairs: &[(f64, f64)]) -> Self {
        let n = pairs.len() as f64;
        let ratios = || pairs.iter().map(|(old, new)| old / new);
        let (old, new) = (pairs.iter()).fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1));
        Self {
            mean: ratios().sum::<f64>() / n,
            geometric_mean: (ratios().map(f64::ln).sum::<f64>() / n).exp(),
            of_totals: old / new,
        }
    }
}

impl Averages {
    pub(crate) fn of(pairs: &[Measured]) -> Self {
        let of = |group: Group| {
            let members: Vec<&Measured> = pairs.iter().filter(|p| p.group == group).collect();
            let ratios = |f: fn(&Measured) -> (f64, f64)| {
                Ratios::of(&members.iter().map(|m| f(m)).collect::<Vec<_>>())
            };
            (!members.is_empty()).then(|| Average {
                pairs: members.len(),
                slices: ratios(|m| (m.old_slices as f64, m.new_slices as f64)),
                paper_slices: ratios(|m| {
                    (f64::from(m.paper.old_slices), f64::from(m.paper.new_slices))
                }),
                seconds: ratios(|m| (m.old_seconds, m.new_seconds)),
                seconds_with_criticalities: ratios(|m| (m.ratio_with_criticalities, 1.0))
                    .geometric_mean,
                criticalities_unfinished: (members.iter())
                    .filter(|m| m.criticality_seconds_without_skipping.is_none())
                    .count(),
                seconds_without_symmetry: ratios(|m| {
                    (m.old_seconds, m.new_seconds_without_symmetry)
                })
                .geometric_mean,
                paper_factor: group.paper_factor(),
            })
        };
        Self {
            engineering: of(Group::Engineering),
            knee: of(Group::Knee),
        }
    }
}
