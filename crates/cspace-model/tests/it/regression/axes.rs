//! Expectations of spaces on fixed axes.

use cspace::{
    Axis, AxisMotion, Classification, Configuration, FixedAxesSpace, Location, RegionId, Relation,
    Rotation, Vector,
};
use cspace_model::Mechanism;
use cspace_oracle::Oracle;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::regression::expectation::Axes;

/// A pair on fixed axes, and brute force to judge it.
pub(crate) struct OnAxes {
    pub(crate) space: FixedAxesSpace,
    pub(crate) oracle: Oracle,
}

impl OnAxes {
    fn new(model: &Mechanism) -> Self {
        let Relation::Axes {
            fixed: u,
            moving: v,
        } = model.relation(&model.pairs[0])
        else {
            panic!("no pair on fixed axes");
        };
        let [fixed, moving] = [0, 1].map(|i| &model.parts[i].part);
        Self {
            space: FixedAxesSpace::compute(fixed, u, moving, v).unwrap(),
            oracle: Oracle::new(fixed, moving),
        }
    }

    /// Configuration of the moving part in the fixed part's frame.
    fn relative(&self, (u, v): (f64, f64)) -> Configuration {
        let place = |axis: &Axis, t: f64| match axis.motion {
            AxisMotion::Fixed => (0.0, Vector::ZERO),
            AxisMotion::Revolute { center } => {
                let c = center.to_vector();
                (t, c - Rotation::by(t) * c)
            }
            AxisMotion::Prismatic { direction } => (0.0, direction.unit() * t),
        };
        let axes = self.space.axes();
        let (a, b) = (place(&axes.0, u), place(&axes.1, v));
        let shift = Rotation::by(-a.0) * (b.1 - a.1);
        Configuration::new(shift.x, shift.y, b.0 - a.0)
    }

    /// Fails if an answer is not the one of brute force at one of these positions, or at one of a thousand others; how many of
    /// them are certain.
    pub(crate) fn certainly_right(&self, at: &[(f64, f64)]) -> usize {
        let mut rng = ChaCha8Rng::seed_from_u64(5);
        let mut anywhere = |axis: &Axis| {
            let (lo, hi) = axis.range.unwrap_or(match axis.motion {
                AxisMotion::Prismatic { .. } => (-6.0, 6.0),
                _ => (-3.2, 3.2),
            });
            rng.random_range(lo..hi)
        };
        let axes = self.space.axes();
        let others: Vec<(f64, f64)> = (0..1000)
            .map(|_| (anywhere(&axes.0), anywhere(&axes.1)))
            .collect();
        let mut certain = 0;
        let wrong: Vec<String> = (at.iter().chain(&others))
            .filter_map(|&(u, v)| {
                let verdict = self.oracle.judge(self.relative((u, v)));
                if verdict.margin < 1e-8 {
                    return None;
                }
                certain += 1;
                let expected = if verdict.overlap {
                    Classification::Blocked
                } else {
                    Classification::Free
                };
                let answer = self.space.classify(u, v).unwrap();
                (answer != expected).then(|| format!("({u}, {v}) is {expected:?}, not {answer:?}"))
            })
            .collect();
        let statistics = self.space.statistics();
        assert_eq!(wrong, [""; 0], "{} wrong, {statistics:?}", wrong.len());
        certain
    }

    /// Checks that random positions beyond the resolution are blocked; returns how many of a thousand there are.
    fn only_blocked(&self) -> usize {
        let range = self.space.axes().1.range.unwrap_or((-3.1, 3.1));
        let mut rng = ChaCha8Rng::seed_from_u64(9);
        let beyond = |&(u, v): &(f64, f64)| {
            let verdict = self.oracle.judge(self.relative((u, v)));
            // Corners at the pivots are never farther apart than the resolution.
            let beyond = verdict.margin > self.space.resolution();
            assert!(!beyond || verdict.overlap, "({u}, {v}) is free");
            let class = self.space.classify(u, v);
            assert!(
                !beyond || class == Some(Classification::Blocked),
                "({u}, {v})"
            );
            beyond
        };
        let at = |_| {
            let u = rng.random_range(-3.1..3.1);
            (u, rng.random_range(range.0..range.1))
        };
        (0..1000).map(at).filter(beyond).count()
    }

    fn assert_whole(&self) {
        let space = &self.space;
        let saved = serde_json::to_string(space.data()).unwrap();
        let read = serde_json::from_str(&saved).unwrap();
        let read = FixedAxesSpace::from_data(read).unwrap();
        assert_eq!(read.resolution(), space.resolution());
        for (i, region) in (0..).map(RegionId).zip(space.regions()) {
            let (u, v) = region.sample;
            let verdict = self.oracle.judge(self.relative((u, v)));
            assert!(!verdict.overlap, "region {i}");
            assert_eq!(space.locate(u, v), Location::Free(i));
            assert_eq!(read.locate(u, v), Location::Free(i));
        }
        for patch in space.patches() {
            assert!(patch.region.is_some(), "{patch:?}");
            if let Some(next) = patch.next {
                assert_eq!(space.patches()[next.index()].region, patch.region);
            }
        }
    }
}

pub(crate) fn check(model: &Mechanism, e: &Axes) {
    let pair = OnAxes::new(model);
    let space = &pair.space;
    let resolution = space.resolution();
    for (range, found) in [
        (e.resolution, resolution),
        (e.resolution_of_size, resolution / pair.oracle.size()),
    ] {
        assert!(
            range.is_none_or(|(lo, hi)| (lo..hi).contains(&found)),
            "{found:e}"
        );
    }
    let regions = space.regions().len();
    assert!(e.regions.is_none_or(|n| regions == n), "{regions} regions");
    let conflicts = space.statistics().conflicts;
    assert!(
        e.conflicts.is_none_or(|n| conflicts == n),
        "{conflicts} conflicts"
    );
    for &(u, v) in &e.contact {
        assert_eq!(space.classify(u, v), Some(Classification::Contact));
    }
    let mut own: Vec<_> = (e.regions_of_their_own.iter())
        .map(|&(u, v)| space.locate(u, v).region().unwrap())
        .collect();
    own.sort_unstable();
    assert!(own.windows(2).all(|w| w[0] != w[1]), "{own:?}");
    if let Some(positions) = &e.positions {
        let certain = pair.certainly_right(positions);
        assert!(
            certain > e.certain_more_than.unwrap_or(900),
            "{certain} certain"
        );
    }
    if let Some(least) = e.only_blocked_more_than {
        let blocked = pair.only_blocked();
        assert!(blocked > least, "{blocked} are blocked");
    }
    if e.whole {
        pair.assert_whole();
    }
}
