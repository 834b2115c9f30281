//! Choice of the method for a pair: in full, or one period of a symmetric pair.

use core::f64::consts::TAU;

use crate::contact::{Fit, Geometry, Placed, Steps};
use crate::feature::{FeatureName, as_drawn};
use crate::part::{Corresponding, Part, Symmetrized};
use crate::space::{PairSymmetry, Symmetry};

use crate::general::limits::{MOST_EDGE_PAIRS, MOST_SHEETS};

/// Method by which a pair is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Method {
    /// The general method, over all orientations.
    General,
    /// One period, if the given elements are symmetric.
    Slab(Corresponding),
}

impl From<Symmetry> for Method {
    fn from(symmetry: Symmetry) -> Self {
        match symmetry {
            Symmetry::Detect => Self::Slab(Corresponding::Outlines),
            Symmetry::Ignore => Self::General,
        }
    }
}

/// A pair ready to be computed.
pub(crate) struct Plan {
    pub(crate) geometry: Geometry,
    pub(crate) symmetry: PairSymmetry,
    pub(crate) names: Names,
}

/// Maps from the features of the parts as computed to those of the parts as drawn.
#[derive(Default)]
pub(crate) struct Names {
    fixed: Option<Symmetrized>,
    moving: Option<Symmetrized>,
}

/// Margin in radians by which a window is extended at each end: more than the largest error of an event, so that no event of the window
/// lies in one cluster with an end of the extended window.
pub(crate) const BEYOND_WINDOW: f64 = 1.0 / 65536.0;

impl Plan {
    /// Prepares a pair by the method that the options and the parts ask for, with another perturbation for each attempt.
    pub(crate) fn new(
        fixed: &Part,
        moving: &Part,
        window: Option<(f64, f64)>,
        method: Method,
        attempt: u64,
    ) -> Self {
        // Events at the very end of the window are complete in a slightly extended window.
        let wider = (window.map(|(lo, hi)| (lo - BEYOND_WINDOW, hi + BEYOND_WINDOW)))
            .filter(|(lo, hi)| hi - lo < TAU);
        let general = |symmetry| Self {
            geometry: Geometry::attempt(
                fixed,
                moving,
                (Fit::Overlaps, attempt),
                wider,
                MOST_SHEETS,
            ),
            symmetry,
            names: Names::default(),
        };
        let Method::Slab(by) = method else {
            return general(PairSymmetry::default());
        };
        let (a, b) = (fixed.symmetrized(by), moving.symmetrized(by));
        let fold = |s: &Option<Symmetrized>| s.as_ref().map_or(1, |s| s.fold);
        let of_outline = |part: &Part, s: &Option<Symmetrized>| match by {
            Corresponding::Outlines => fold(s),
            Corresponding::Vertices => part.symmetry().fold(),
        };
        let folds = PairSymmetry {
            fixed: of_outline(fixed, &a),
            moving: of_outline(moving, &b),
            ..PairSymmetry::default()
        };
        let Some(steps) = Steps::new(fold(&a), fold(&b)).filter(|s| s.slabs > 1) else {
            return general(folds);
        };
        // A window narrower than the period is computed directly.
        if window.is_some_and(|(lo, hi)| hi - lo <= TAU / f64::from(steps.slabs)) {
            return general(folds);
        }
        // A part that does not turn from period to period need not be redrawn.
        let names = Names {
            fixed: a.filter(|_| steps.fixed > 0),
            moving: b.filter(|_| steps.moving > 0),
        };
        if names.pairs(fixed, moving) > MOST_EDGE_PAIRS {
            return general(folds);
        }
        let deviation = [&names.fixed, &names.moving]
            .into_iter()
            .flatten()
            .map(|s| s.deviation)
            .sum();
        match Geometry::slab(
            placed(&names.fixed, fixed),
            placed(&names.moving, moving),
            steps,
            MOST_SHEETS,
            attempt,
        ) {
            Some(geometry) => Self {
                geometry,
                symmetry: PairSymmetry {
                    slabs: steps.slabs,
                    deviation,
                    ..folds
                },
                names,
            },
            None => general(folds),
        }
    }
}

fn placed<'a>(symmetrized: &'a Option<Symmetrized>, drawn: &'a Part) -> Placed<'a> {
    match symmetrized {
        Some(s) => Placed {
            part: &s.part,
            center: crate::geometry::Point::ORIGIN,
            drawn_center: s.center,
            images: Some(&s.images),
            fold: s.fold,
        },
        None => Placed::as_drawn(drawn),
    }
}

impl Names {
    pub(crate) fn fixed(&self, name: FeatureName) -> FeatureName {
        as_drawn(&self.fixed, name)
    }

    pub(crate) fn moving(&self, name: FeatureName) -> FeatureName {
        as_drawn(&self.moving, name)
    }

    /// Whether a contact of two features, by their names as computed, is on a circle that was divided.
    ///
    /// There the patches would be cut finer than the features as drawn.
    pub(crate) fn divides(&self, fixed: FeatureName, moving: FeatureName) -> bool {
        let divided = |s: &Option<Symmetrized>, name: FeatureName| {
            (s.as_ref()).is_some_and(|s| s.divided[name.loop_index as usize])
        };
        divided(&self.fixed, fixed) || divided(&self.moving, moving)
    }

    /// Pairs of edges of the parts as computed.
    fn pairs(&self, fixed: &Part, moving: &Part) -> usize {
        let edges = |s: &Option<Symmetrized>, drawn: &Part| {
            drawn.edges().count() + s.as_ref().map_or(0, |s| s.added)
        };
        edges(&self.fixed, fixed).saturating_mul(edges(&self.moving, moving))
    }

    /// Number of features that the parts as computed have in addition to those of the parts as drawn.
    pub(crate) fn added(&self) -> (usize, usize) {
        let of = |s: &Option<Symmetrized>| s.as_ref().map_or(0, |s| s.added);
        (of(&self.fixed), of(&self.moving))
    }
}
