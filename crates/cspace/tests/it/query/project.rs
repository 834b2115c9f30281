//! Projections to patches, compared with dense sampling of the patches.

use core::f64::consts::TAU;

use cspace::{
    Axis, AxisMotion, Configuration, ContactSpace, Coordinates, FixedAxesSpace, Metric, Options,
    PairSpace, PatchId, Projection, QueryError, Relation,
};
use cspace_oracle::pair;
use cspace_oracle::shapes::mechanisms::mechanisms;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Tolerance of a projection's distance, compared with the minimum, and of its distance from the patch, as shares of the size.
const NEAR: f64 = 2e-11;
const ON_PATCH: f64 = 1e-9;
/// Configurations projected to each patch, and patches of each pair: fewer for a pair in the plane, because samples take long there.
const ASKED: usize = 3;
const PATCHES: usize = 8;
const PATCHES_ON_AXES: usize = 60;

/// Angles reduced to the shorter way around.
fn turned(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// The smallest distance of samples of a patch, at orientations that get denser towards both ends and towards one within.
fn sampled(space: &ContactSpace, patch: PatchId, c: Configuration, rho: f64, about: f64) -> f64 {
    let data = space.patches()[patch.index()];
    let (lo, hi) = (data.lo, data.hi);
    let even = (0..=150).map(|i| 0.5 * (1.0 - (f64::from(i) * TAU / 300.0).cos()));
    let close = (-20..=20).map(|i: i32| about + 1e-3 * f64::from(i).powi(3) / 8e3);
    let orientations = even
        .map(|s| lo + (hi - lo) * s)
        .chain(close.filter(|t| (lo..=hi).contains(t)));
    let mut least = f64::INFINITY;
    for theta in orientations {
        let slice = space.slice(theta);
        let Some(curve) = slice.curves.iter().find(|s| s.patch == Some(patch)) else {
            continue;
        };
        let away = (0..=20)
            .map(|i| curve.geometry.point(f64::from(i) / 20.0))
            .chain([curve.geometry.nearest(c.position())])
            .map(|q| q.distance(c.position()))
            .fold(f64::INFINITY, f64::min);
        least = least.min(away.hypot(rho * turned(theta - c.theta)));
    }
    least
}

#[test]
fn no_sample_of_a_patch_is_nearer() {
    let full = None;
    for (name, window) in [
        ("peg in chamfered hole", full),
        ("ball caged in a C", full),
        ("ratchet 8 and pawl", full),
        ("gears 10 and 9", full),
        ("random 5", full),
        ("random rings", Some((2.0, 4.5))),
        ("half discs", full),
        ("discs", full),
        ("lens and crescent", full),
        ("nearly straight arcs", full),
        ("square in its square hole", full),
        ("peg in hole, clearance 1e-3", Some((-0.4, 0.3))),
    ] {
        let p = pair(name);
        let options = Options {
            window,
            ..Options::default()
        };
        let space = ContactSpace::compute(&p.fixed, &p.moving, &options).unwrap();
        let all = PairSpace::Planar(std::sync::Arc::new(space.clone()));
        let size = p.fixed.size().max(p.moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(17);
        let count = space.patches().len();
        for k in 0..count.min(PATCHES) {
            let patch = PatchId((k * count / count.min(PATCHES)) as u32);
            let data = space.patches()[patch.index()];
            for asked in 0..ASKED {
                // Anywhere, near the patch, and in between; with different weights of a radian.
                let by = [1.5, 0.1, 1e-4][asked] * size;
                let theta = rng.random_range(data.lo..=data.hi);
                let curve = space.slice(theta).curves;
                let on = curve.iter().find(|s| s.patch == Some(patch));
                let q = on.map_or(cspace::Point::ORIGIN, |s| s.geometry.point(0.4));
                let mut off = |by: f64| rng.random_range(-by..by);
                let c =
                    Configuration::new(q.x + off(by), q.y + off(by), theta + off(3.0) * by / size);
                let rho = size * [1.0, 0.03, 7.0][(patch.index() + asked) % 3];
                let metric = Metric {
                    length_per_radian: rho,
                };
                let turns = TAU * f64::from((patch.0 % 3) as i32 - 1);
                let from = Configuration::new(c.x, c.y, c.theta + turns);
                let Projection { at, distance } = all
                    .project(Coordinates::Planar(from), patch, metric)
                    .unwrap();
                let Coordinates::Planar(found) = at else {
                    panic!("{at:?}")
                };
                let what = format!("{name}: {c:?} to {patch}, {rho}: {found:?} {distance}");
                // At the reported distance, and on the patch.
                let way = (found.position().distance(c.position()))
                    .hypot(rho * turned(found.theta - c.theta));
                assert!(
                    (way - distance).abs() <= NEAR * size + 1e-12 * way,
                    "{what} {way}"
                );
                if window.is_none() {
                    assert!(
                        (found.theta - from.theta).abs() < 0.5 * TAU + 1e-9,
                        "{what}"
                    );
                } else {
                    assert!((data.lo..=data.hi).contains(&found.theta), "{what}");
                }
                let inside = (found.theta - data.lo).rem_euclid(TAU);
                let beyond = inside
                    .min(TAU - inside)
                    .min((inside - (data.hi - data.lo)).abs());
                assert!(inside <= data.hi - data.lo || beyond < 1e-12, "{what}");
                let f = space.patch(patch).unwrap().contact_function(found);
                assert!(f.abs() < ON_PATCH * size, "{what}: {f}");
                let touched = space.contacts(found, ON_PATCH * size);
                let ends = beyond < 1e-6;
                assert!(
                    ends || touched.iter().any(|t| t.0 == patch),
                    "{what}: {touched:?}"
                );
                let about = data.lo + inside;
                let least = sampled(&space, patch, c, rho, about);
                assert!(
                    distance <= least + NEAR * size + 1e-12 * least,
                    "{what}, not {least}"
                );
            }
        }
    }
}

/// The smallest distance of samples of a patch, given a function for the distance.
fn sampled_on_axes(
    space: &FixedAxesSpace,
    patch: PatchId,
    away: impl Fn((f64, f64)) -> f64,
) -> f64 {
    use cspace::fixed_axes::BranchForm;
    let mut least = f64::INFINITY;
    for i in space.patches()[patch.index()].branches.clone() {
        let b = space.branches()[i as usize];
        let (from, to) = match b.form {
            BranchForm::VOfU => (b.start.0, b.end.0),
            BranchForm::UOfV => (b.start.1, b.end.1),
        };
        for k in 0..=400 {
            let s = 0.5 * (1.0 - (f64::from(k) * TAU / 800.0).cos());
            let (at, _) = space.branch_at(i as usize, from + (to - from) * s).unwrap();
            least = least.min(away(at));
        }
    }
    least
}

#[test]
fn no_sample_of_a_curve_on_axes_is_nearer() {
    let mut asked = 0;
    for m in mechanisms() {
        let relation = Relation::Axes {
            fixed: m.fixed_axis,
            moving: m.moving_axis,
        };
        let all = PairSpace::compute(&m.fixed, &m.moving, relation, &Options::default()).unwrap();
        let PairSpace::FixedAxes(space) = &all else {
            panic!("{}", m.name)
        };
        let size = m.fixed.size().max(m.moving.size());
        let mut rng = ChaCha8Rng::seed_from_u64(18);
        let count = space.patches().len();
        for k in 0..count.min(PATCHES_ON_AXES) {
            let patch = PatchId((k * count / count.min(PATCHES_ON_AXES)) as u32);
            let rho = size * [1.0, 0.05, 7.0][k % 3];
            let metric = Metric {
                length_per_radian: rho,
            };
            let apart = |axis: &Axis, by: f64| match (axis.motion, axis.range) {
                (AxisMotion::Fixed, _) => 0.0,
                (AxisMotion::Revolute { .. }, None) => rho * turned(by),
                (AxisMotion::Revolute { .. }, Some(_)) => rho * by,
                (AxisMotion::Prismatic { .. }, _) => by,
            };
            let (u, v) = m.somewhere(size, &mut rng);
            let away = |at: (f64, f64)| {
                apart(&m.fixed_axis, at.0 - u).hypot(apart(&m.moving_axis, at.1 - v))
            };
            let at = Coordinates::Axes { u, v };
            let found = all.project(at, patch, metric).unwrap();
            let Coordinates::Axes { u: s, v: t } = found.at else {
                panic!("{found:?}")
            };
            let what = format!("{}: ({u}, {v}) to {patch}, {rho}: {found:?}", m.name);
            let distance = found.distance;
            let scale = 1.0 + distance / size;
            assert!(
                (away((s, t)) - distance).abs() < NEAR * size * scale,
                "{what}"
            );
            let f = space.contact_function(patch, s, t).unwrap();
            assert!(f.abs() < ON_PATCH * size, "{what}: {f}");
            let least = sampled_on_axes(space, patch, away);
            assert!(
                distance <= least + NEAR * size * scale,
                "{what}, not {least}"
            );
            asked += 1;
        }
    }
    assert!(asked > 500, "{asked}");
}

#[test]
fn what_makes_no_projection_is_refused() {
    let p = pair("discs");
    let space = PairSpace::compute(&p.fixed, &p.moving, Relation::Planar, &Options::default());
    let space = space.unwrap();
    let at = |x: f64| Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
    let metric = |length_per_radian| Metric { length_per_radian };
    let first = PatchId(0);
    assert!(space.project(at(1.0), first, metric(1.0)).is_ok());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e200, 1e-200] {
        let refused = space.project(at(1.0), first, metric(bad));
        assert_eq!(refused, Err(QueryError::Metric), "{bad}");
    }
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let refused = space.project(at(bad), first, metric(1.0));
        assert_eq!(refused, Err(QueryError::Outside), "{bad}");
    }
    let none = space.project(at(1.0), PatchId(u32::MAX), metric(1.0));
    assert!(matches!(none, Err(QueryError::NoPatch { .. })));
    let wrong = space.project(Coordinates::Axes { u: 0.0, v: 0.0 }, first, metric(1.0));
    assert!(matches!(wrong, Err(QueryError::Coordinates { .. })));
}

/// At each orientation a square in a bore is as far from contact as its farthest corner: the nearest of all orientations is found by
/// steps, the smallest of which is halved until it is known.
#[test]
fn the_nearest_place_in_a_bore_is_that_of_the_farthest_corner() {
    let circle = |radius| cspace::part::circle_loop((0.0, 0.0), radius).unwrap();
    let plate = cspace::Part::new("plate", vec![circle(9.0), circle(4.0)]).unwrap();
    let square = cspace::Part::rectangle("square", (0.0, 0.0), 2.0, 2.0).unwrap();
    let space = ContactSpace::compute(&plate, &square, &Options::default()).unwrap();
    let space = PairSpace::Planar(std::sync::Arc::new(space));
    for k in 0..60 {
        let turn = f64::from(k);
        let c = Configuration::new(1.5 * (1.7 * turn).cos(), 1.5 * (2.3 * turn).sin(), turn);
        for length_per_radian in [1e6, 1.0, 0.1] {
            let metric = Metric { length_per_radian };
            let (_, Projection { distance, .. }) = space
                .nearest_patch(Coordinates::Planar(c), metric)
                .unwrap()
                .unwrap();
            let away = |turned: f64| {
                let at = Configuration::new(c.x, c.y, c.theta + turned);
                let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
                let farthest = (corners.iter())
                    .map(|&corner| at.fixed_from_moving(corner.into()).to_vector().length())
                    .fold(0.0, f64::max);
                (4.0 - farthest).hypot(length_per_radian * turned)
            };
            let (mut best, mut step) = (0.0, 0.0);
            for k in -1000..=1000 {
                let turned = 0.5 * TAU / 1000.0 * f64::from(k);
                if away(turned) < away(best) {
                    (best, step) = (turned, 0.5 * TAU / 1000.0);
                }
            }
            while step > 1e-12 {
                let beside = [best - step, best + step];
                match beside.into_iter().find(|&t| away(t) < away(best)) {
                    Some(better) => best = better,
                    None => step *= 0.5,
                }
            }
            let expected = away(best);
            assert!(
                (distance - expected).abs() < 1e-9,
                "{c:?}, {length_per_radian}: {distance} for {expected}"
            );
        }
    }
}
