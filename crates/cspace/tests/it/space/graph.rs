//! Properties that the contact graph guarantees, checked on spaces of many kinds.

use core::cell::RefCell;
use core::f64::consts::{PI, TAU};

use cspace::{
    BoundaryCurve, BoundaryKind, Configuration, ContactSpace, FeatureName, Options, PatchId,
    PatchRef, Point, Slice, SliceCurve,
};
use cspace_oracle::{Pair, effort, pair};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::SPACES;

/// Pairs whose contact curves cross at angles of a millionth: their crossings are known to 10⁻¹³ divided by that angle.
const GRAZING: [&str; 2] = [
    "pin in socket of equal radius",
    "peg in hole, clearance 1e-6",
];

/// Tolerance of lengths, as a share of the size.
const NEAR: f64 = 1e-9;
/// Tolerance of contact functions on their patches, as a share of the size.
const ON_PATCH: f64 = 1e-10;

struct Trial {
    pair: &'static Pair,
    space: &'static ContactSpace,
    size: f64,
    wrong: RefCell<Vec<String>>,
}

impl Trial {
    fn new((pair, space): &'static (Pair, ContactSpace)) -> Self {
        let size = pair.fixed.size().max(pair.moving.size());
        Self {
            pair,
            space,
            size,
            wrong: RefCell::default(),
        }
    }

    fn patch(&self, id: PatchId) -> PatchRef<'_> {
        self.space.patch(id).unwrap()
    }

    fn check(&self, holds: bool, message: impl FnOnce() -> String) {
        if !holds {
            self.wrong
                .borrow_mut()
                .push(format!("{}: {}", self.pair.name, message()));
        }
    }
}

/// Runs a check on every pair and reports all errors.
fn on_all_pairs(check: impl Fn(&Trial) + Sync) {
    let wrong: Vec<Vec<String>> = SPACES
        .par_iter()
        .map(|p| {
            let trial = Trial::new(p);
            check(&trial);
            trial.wrong.into_inner()
        })
        .collect();
    let wrong: Vec<String> = wrong
        .into_iter()
        .flat_map(|w| {
            let more = w.len().saturating_sub(6);
            let last = (more > 0).then(|| format!("  … and {more} more"));
            w.into_iter().take(6).chain(last).collect::<Vec<_>>()
        })
        .collect();
    for w in &wrong {
        println!("{w}");
    }
    assert!(wrong.is_empty(), "{} findings", wrong.len());
}

fn label(c: &SliceCurve) -> (FeatureName, FeatureName) {
    (c.fixed, c.moving)
}

/// The curves of a slice by label, each with its ends and its successor's label; negligibly short curves are left out.
fn described(
    slice: &Slice,
    shortest: f64,
) -> Vec<((FeatureName, FeatureName), Point, Point, Point)> {
    let mut all: Vec<_> = slice
        .curves
        .iter()
        .filter(|c| c.geometry.length() > shortest)
        .map(|c| {
            let g = c.geometry;
            (label(c), g.point(0.0), g.point(0.5), g.point(1.0))
        })
        .collect();
    all.sort_by(|a, b| {
        (a.0.cmp_key())
            .cmp(&b.0.cmp_key())
            .then(a.2.x.total_cmp(&b.2.x))
            .then(a.2.y.total_cmp(&b.2.y))
    });
    all
}

trait Key {
    fn cmp_key(&self) -> String;
}

impl Key for (FeatureName, FeatureName) {
    fn cmp_key(&self) -> String {
        format!("{self:?}")
    }
}

fn same_slices(trial: &Trial, theta: f64) {
    let read = trial.space.slice(theta);
    let made = Slice::compute(&trial.pair.fixed, &trial.pair.moving, theta);
    // Far from the origin positions are only as accurate as their rounding.
    let far = trial.space.fixed().bounds().center().to_vector().length()
        + trial.space.moving().bounds().center().to_vector().length();
    let shortest = NEAR * trial.size + 1e-14 * far;
    let (a, b) = (described(&read, shortest), described(&made, shortest));
    let labels = |d: &[((FeatureName, FeatureName), Point, Point, Point)]| -> Vec<String> {
        d.iter().map(|c| c.0.cmp_key()).collect()
    };
    let same = labels(&a) == labels(&b);
    trial.check(same, || {
        format!(
            "at {theta:.17} {} curves are read and {} made",
            a.len(),
            b.len()
        )
    });
    if !same {
        return;
    }
    for (p, q) in a.iter().zip(&b) {
        let off =
            p.1.distance(q.1)
                .max(p.2.distance(q.2))
                .max(p.3.distance(q.3));
        let grazing = GRAZING.contains(&trial.pair.name.as_str());
        let known = if grazing {
            1e-6 * trial.size
        } else {
            10.0 * shortest
        };
        trial.check(off <= known, || {
            format!("at {theta:.17} {:?} is {off:e} off", p.0)
        });
    }
    let count = |s: &Slice| {
        s.loops
            .iter()
            .filter(|l| {
                l.iter()
                    .any(|&c| s.curves[c as usize].geometry.length() > shortest)
            })
            .count()
    };
    let (m, n) = (count(&read), count(&made));
    trial.check(m == n, || format!("at {theta:.17} {m} loops, not {n}"));
}

#[test]
fn slices_read_off_equal_slices_from_scratch() {
    on_all_pairs(|trial| {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        for _ in 0..effort(8, 20) {
            let theta = rng.random_range(-PI..PI);
            same_slices(trial, theta);
        }
    });
}

#[test]
fn slices_beside_critical_orientations_equal_slices_from_scratch() {
    /// Distance from another critical orientation below which one is not tested: the slice between them is a different one.
    const ALONE: f64 = 3e-7;
    on_all_pairs(|trial| {
        let all = trial.space.critical_orientations().to_vec();
        let step = all.len().div_ceil(effort(12, 40)).max(1);
        for i in (0..all.len()).step_by(step) {
            let gap = |j: usize| (all[j % all.len()] - all[i]).rem_euclid(TAU);
            let alone =
                all.len() == 1 || (gap(i + 1) > ALONE && TAU - gap(i + all.len() - 1) > ALONE);
            // Known gap of slices from scratch: arcs of nearly equal radii that touch along their length, within 1e-6 of
            // that orientation.
            let by_length = [
                "half disc in socket of equal radius",
                "lens and crescent",
                "crescents of equal arcs",
            ];
            if alone && !by_length.contains(&trial.pair.name.as_str()) {
                same_slices(trial, all[i] - 1e-7);
                same_slices(trial, all[i] + 1e-7);
            }
        }
    });
}

/// Also where the orientation is some turns further.
#[test]
fn slices_at_critical_orientations_are_those_just_above() {
    /// Distance from another critical orientation below which one is not tested: the slice just above it may be a different one.
    const ALONE: f64 = 1e-8;
    /// Distance below a critical orientation, relative to orientations above one, that rounding may cause.
    const ROUNDING: f64 = 1e-15;
    on_all_pairs(|trial| {
        let all = trial.space.critical_orientations().to_vec();
        let step = all.len().div_ceil(effort(12, 40)).max(1);
        for i in (0..all.len()).step_by(step) {
            let gap = (all[(i + 1) % all.len()] - all[i]).rem_euclid(TAU);
            if all.len() > 1 && gap < ALONE {
                continue;
            }
            let patches = |theta: f64| -> Vec<Option<PatchId>> {
                let slice = trial.space.slice(theta);
                slice.curves.iter().map(|c| c.patch).collect()
            };
            let above = patches(all[i] + 0.1 * ALONE);
            for turns in [0.0, 1.0, -2.0, 9.0, -13.0] {
                let at = all[i] + turns * TAU;
                for theta in [at, at - ROUNDING * at.abs().max(1.0)] {
                    trial.check(patches(theta) == above, || {
                        format!("the slice at {theta:.17} is not that above {:.17}", all[i])
                    });
                }
            }
        }
    });
}

/// Slices at critical orientations, as above, for a window, which is not turned.
#[test]
fn slices_at_critical_orientations_of_a_window_are_those_just_above() {
    const ALONE: f64 = 1e-8;
    let options = Options {
        window: Some((-1.1, 1.3)),
        ..Options::default()
    };
    let mut tried = 0;
    for name in ["bar in maze", "random 5", "hexagon in a hexagonal hole"] {
        let pair = pair(name);
        let space = ContactSpace::compute(&pair.fixed, &pair.moving, &options).unwrap();
        let patches = |theta: f64| -> Vec<Option<PatchId>> {
            let slice = space.slice(theta);
            slice.curves.iter().map(|c| c.patch).collect()
        };
        let all = space.critical_orientations();
        for (i, &c) in all.iter().enumerate() {
            if all.get(i + 1).is_none_or(|next| next - c > ALONE) {
                let above = patches(c + 0.1 * ALONE);
                assert_eq!(patches(c), above, "{name} at {c}");
                assert_eq!(patches(c - 1e-15), above, "{name} below {c}");
                tried += 1;
            }
        }
        // Beyond the window there are no curves; at its end the last ones.
        assert!(patches(1.3 + 1e-9).is_empty());
        assert_eq!(patches(1.3), patches(1.3 - 1e-9), "{name}");
    }
    assert!(tried > 20, "{tried}");
}

/// Side links by the patch before, then by orientation; vertical links by orientation.
#[test]
fn links_are_in_order() {
    on_all_pairs(|trial| {
        let side = (trial.space.side_links().windows(2)).all(|l| {
            let key = |l: &cspace::SideLink| (l.before, l.lo, l.after);
            key(&l[0]) < key(&l[1])
        });
        let vertical = (trial.space.vertical_links().windows(2)).all(|l| {
            let key = |l: &cspace::VerticalLink| (l.theta, l.lower, l.upper);
            key(&l[0]) <= key(&l[1])
        });
        trial.check(side && vertical, || "links are not in order".to_string());
    });
}

#[test]
fn walks_along_side_links_close() {
    on_all_pairs(|trial| {
        for band in trial.space.bands() {
            if band.hi - band.lo < 1e-9 {
                continue;
            }
            let slice = trial.space.slice(0.5 * (band.lo + band.hi));
            let n = slice.curves.len();
            let mut entered = vec![0; n];
            for c in &slice.curves {
                if let Some(e) = entered.get_mut(c.next as usize) {
                    *e += 1;
                }
            }
            trial.check(entered.iter().all(|&e| e == 1), || {
                format!("band {band:?}: followers {entered:?}")
            });
            for c in &slice.curves {
                let Some(next) = slice.curves.get(c.next as usize) else {
                    continue;
                };
                let gap = c.geometry.point(1.0).distance(next.geometry.point(0.0));
                trial.check(gap <= 1e-7 * trial.size, || {
                    format!("band {band:?}: a gap of {gap:e} after {:?}", label(c))
                });
            }
        }
    });
}

#[test]
fn side_links_lie_on_both_patches_and_cover_them() {
    on_all_pairs(|trial| {
        let links = trial.space.side_links().to_vec();
        for l in &links {
            for s in [0.02, 0.3, 0.5, 0.7, 0.98] {
                let theta = l.lo + s * (l.hi - l.lo);
                let (before, after) = (trial.patch(l.before), trial.patch(l.after));
                // Moved to the interval of the patch after.
                let lo = after.data().lo;
                let turned = theta + TAU * ((lo - theta) / TAU).ceil();
                let (p, q) = (before.right().at(theta), after.left().at(turned));
                let apart = p.position().distance(q.position());
                let values = [before.contact_function(p), after.contact_function(p)];
                let far = 1e-15 * (p.x.abs() + p.y.abs());
                let tolerance = ON_PATCH * trial.size + 1e2 * far;
                trial.check(values.iter().all(|v| v.abs() <= tolerance), || {
                    format!("{l:?} at {theta}: contact functions {values:?}")
                });
                // Where carriers are almost tangent, the point is less accurate from either side.
                let slope = before.right().derivative(theta).length();
                // Likewise where the crossing carriers coincide at an end of the link: they separate with the angle turned since.
                let since = (theta - l.lo).min(l.hi - theta);
                let known = (1e-8 + 1e-14 / since) * trial.size + 1e-14 * slope;
                trial.check(apart <= known, || {
                    format!("{l:?} at {theta}: boundaries {apart:e} apart")
                });
            }
        }
        for (i, &p) in (0..).map(PatchId).zip(trial.space.patches()) {
            let covers = |spans: Vec<(f64, f64)>| {
                let length: f64 = spans.iter().map(|s| s.1 - s.0).sum();
                (length - (p.hi - p.lo)).abs() <= 1e-9
            };
            let after = covers(trial.space.links_after(i).map(|l| (l.lo, l.hi)).collect());
            let before = covers(trial.space.links_before(i).map(|l| (l.lo, l.hi)).collect());
            trial.check(after && before, || {
                format!("patch {i} [{}, {}] is not covered by links", p.lo, p.hi)
            });
        }
    });
}

/// The length of a curve of a slice within `near` of another curve that faces it.
fn pinched(slice: &Slice, curve: &SliceCurve, near: f64) -> f64 {
    let at = |i: u32| (f64::from(i) + 0.5) / f64::from(SAMPLES);
    let met = (0..SAMPLES).filter(|&i| {
        let p = curve.geometry.point(at(i));
        slice
            .curves
            .iter()
            .any(|c| c.patch != curve.patch && c.geometry.nearest(p).distance(p) <= near)
    });
    curve.geometry.length() * met.count() as f64 / f64::from(SAMPLES)
}

/// Number of places at which the distance of facing curves is examined.
const SAMPLES: u32 = 2000;

#[test]
fn vertical_links_lie_on_both_patches_and_cover_their_ends() {
    /// Distance from its end at which a patch's curve is measured, in radians.
    const INSIDE: f64 = 1e-11;
    /// Three contacts lie on one circle at a critical orientation: the growth of the parts determines which part of it is linked.
    const ONE_CIRCLE: &str = "three pegs in three holes";
    on_all_pairs(|trial| {
        if trial.pair.name == ONE_CIRCLE {
            return;
        }
        for l in trial.space.vertical_links().to_vec() {
            for s in [0.0, 0.5, 1.0] {
                let p = l.overlap.point(s);
                let c = Configuration::new(p.x, p.y, l.theta);
                let values = [l.lower, l.upper].map(|i| trial.patch(i).contact_function(c));
                let tolerance = ON_PATCH * trial.size + 1e-13 * (p.x.abs() + p.y.abs());
                trial.check(values.iter().all(|v| v.abs() <= tolerance), || {
                    format!("{l:?}: contact functions {values:?}")
                });
            }
        }
        for (i, &p) in (0..).map(PatchId).zip(trial.space.patches()) {
            if p.hi - p.lo >= TAU - 1e-9 || p.hi - p.lo < 4.0 * INSIDE {
                continue;
            }
            for (top, theta) in [(true, p.hi - INSIDE), (false, p.lo + INSIDE)] {
                let slice = trial.space.slice(theta);
                let curve = slice.curves.iter().find(|c| c.patch == Some(i));
                let length = curve.map_or(0.0, |c| c.geometry.length());
                let linked: f64 = trial
                    .space
                    .vertical_links()
                    .iter()
                    .filter(|l| if top { l.lower == i } else { l.upper == i })
                    .map(|l| l.overlap.length())
                    .sum();
                // Ends that meet in a tangency move with the square root of the remaining angle.
                let tolerance = 3e-5 * trial.size;
                if (length - linked).abs() <= tolerance {
                    continue;
                }
                // Where another curve faces this one at zero distance, free space itself ends or begins.
                let met = curve.map_or(0.0, |c| pinched(&slice, c, 10.0 * INSIDE * trial.size));
                let known = tolerance + 2.0 * length / f64::from(SAMPLES);
                trial.check((length - linked - met).abs() <= known, || {
                    let end = if top { "top" } else { "bottom" };
                    format!(
                        "patch {i}: {end} of {length:e} at {theta} is linked over {linked:e}, met over {met:e}"
                    )
                });
            }
        }
    });
}

fn slope_by_differences(curve: &BoundaryCurve<'_>, theta: f64, h: f64) -> (f64, f64) {
    let at = |s: f64| curve.at(theta + s * h).position();
    // Fourth order.
    let (a, b, c, e) = (at(-2.0), at(-1.0), at(1.0), at(2.0));
    let d = |w: f64, x: f64, y: f64, z: f64| (8.0 * (y - x) - (z - w)) / (12.0 * h);
    (d(a.x, b.x, c.x, e.x), d(a.y, b.y, c.y, e.y))
}

#[test]
fn derivatives_of_boundary_curves_agree_with_differences() {
    on_all_pairs(|trial| {
        let mut tried = std::collections::BTreeMap::<BoundaryKind, u32>::new();
        for (i, &p) in (0..).map(PatchId).zip(trial.space.patches()) {
            if p.hi - p.lo < 1e-2 {
                continue;
            }
            let far = trial.space.moving().bounds().center().to_vector().length()
                + trial.space.fixed().bounds().center().to_vector().length();
            let mut bad = Vec::new();
            let patch = trial.patch(i);
            for curve in [patch.left(), patch.right()] {
                let theta = 0.5 * (p.lo + p.hi);
                let given = curve.derivative(theta);
                let (dx, dy) = slope_by_differences(&curve, theta, 1e-4);
                let off = (given.x - dx).hypot(given.y - dy);
                let scale = trial.size + given.length();
                *tried.entry(curve.kind()).or_default() += 1;
                if off > 1e-6 * scale + 1e-11 * far {
                    bad.push(format!(
                        "patch {i} {:?} at {theta}: {given:?}, not ({dx}, {dy})",
                        curve.kind()
                    ));
                }
            }
            for b in bad {
                trial.check(false, || b);
            }
        }
    });
}

#[test]
fn bands_cover_the_turn() {
    on_all_pairs(|trial| {
        let bands = trial.space.bands();
        let length: f64 = bands.iter().map(|b| b.hi - b.lo).sum();
        trial.check((length - TAU).abs() < 1e-12, || format!("{length} in all"));
        trial.check(bands.windows(2).all(|w| w[0].hi == w[1].lo), || {
            "bands do not follow each other".to_owned()
        });
        trial.check(
            bands
                .iter()
                .all(|b| b.lo < b.hi && (-PI..PI).contains(&b.lo)),
            || "a band is none".to_owned(),
        );
    });
}

#[test]
fn gradients_of_patches_agree_with_differences() {
    on_all_pairs(|trial| {
        for (i, &p) in (0..).map(PatchId).zip(trial.space.patches()) {
            let patch = trial.patch(i);
            let c = patch.left().at(0.5 * (p.lo + p.hi));
            let size = trial.size;
            let [gx, gy, gt] = patch.gradient(c);
            let f = |dx: f64, dy: f64, dt: f64| {
                patch.contact_function(Configuration::new(c.x + dx, c.y + dy, c.theta + dt))
            };
            let h = 1e-5;
            let l = h * size;
            let dx = (f(l, 0.0, 0.0) - f(-l, 0.0, 0.0)) / (2.0 * l);
            let dy = (f(0.0, l, 0.0) - f(0.0, -l, 0.0)) / (2.0 * l);
            let far = (c.x.abs() + c.y.abs()) / size;
            // A turn moves distant positions far.
            let turn = h / (1.0 + far);
            let dt = (f(0.0, 0.0, turn) - f(0.0, 0.0, -turn)) / (2.0 * turn);
            let off = (gx - dx)
                .abs()
                .max((gy - dy).abs())
                .max((gt - dt).abs() / (size * (1.0 + far)));
            let unit = (gx.hypot(gy) - 1.0).abs();
            let message = format!("patch {i}: {:?} against {:?}", [gx, gy, gt], [dx, dy, dt]);
            // Small circles are curved on the scale of the difference.
            trial.check(unit < 1e-9, || format!("{message}: not a unit normal"));
            trial.check(off < 1e-4 + 1e-9 * far, || message.clone());
        }
    });
}

#[test]
fn known_pairs_have_their_numbers_of_regions() {
    for (name, regions) in [
        ("squares", 1),
        // It can neither turn nor move: only the outside remains.
        ("square in its square hole", 1),
        // Four quarter turns, none of which has an exit.
        ("square in a larger hole", 5),
        ("square in a much larger hole", 2),
        // Six sixths of a turn.
        ("hexagon in a hexagonal hole", 7),
        ("peg in hole, clearance 1e-6", 1),
        ("disc in maze", 1),
        ("ball caged in a C", 2),
        ("ball free to leave a C", 1),
        // The ring's hole has no exit: inside it, the disc in it, and the outside.
        ("disc in annulus of equal radius", 1),
        // A disc that hides a ring cannot be inside it.
        ("disc that hides a ring", 1),
        ("sector in a groove of the same arcs", 1),
        ("sector in a wider groove", 2),
        // One pocket in each direction, each through an orientation at which three circles coincide.
        ("three pegs in three holes", 3),
    ] {
        let pair = pair(name);
        let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
        let found = space.free_regions();
        assert_eq!(found.len(), regions, "{name}: {found:?}");
        assert!(found[0].unbounded, "{name}");
        assert!(found[1..].iter().all(|r| !r.unbounded), "{name}");
    }
}
