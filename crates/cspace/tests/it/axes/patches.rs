//! Contact curves of fixed-axes pairs: closed forms, sides, neighbours; and comparison with general pairs.

use core::f64::consts::TAU;

use cspace::fixed_axes::{AxisMotion, BranchForm, FixedAxesSpace};
use cspace::{Axis, Classification, ContactSpace, Options, Part, PatchId, Point, Vector, Vertex};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::{Mechanism, mechanisms};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

fn compute(m: &Mechanism) -> FixedAxesSpace {
    FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap()
}

/// Contact functions vanish at points of branches, with free space on the right of travel and blocked space on the left.
#[test]
fn branches_have_free_space_on_their_right() {
    let mut tried = 0;
    for m in mechanisms() {
        let space = compute(&m);
        let size = Oracle::new(&m.fixed, &m.moving).size();
        let one = |axis: &Axis| match axis.motion {
            AxisMotion::Prismatic { .. } => size,
            _ => 1.0,
        };
        // Steps of equal length in both coordinates.
        let (unit_u, unit_v) = (one(&m.fixed_axis), one(&m.moving_axis));
        for (i, b) in space.branches().iter().enumerate() {
            let (from, to) = match b.form {
                BranchForm::VOfU => (b.start.0, b.end.0),
                BranchForm::UOfV => (b.start.1, b.end.1),
            };
            let t = from + 0.4 * (to - from);
            let ((u, v), slope) = space.branch_at(i, t).unwrap();
            let value = space.contact_function(b.patch, u, v).unwrap();
            assert!(value.abs() < 1e-12 * size, "{}: {value:e}", m.name);
            let contacts = space.contacts(u, v, 1e-11 * size);
            assert!(contacts.iter().any(|c| c.0 == b.patch), "{}", m.name);
            if (to - from).abs() < 1e-4 || !slope.is_finite() {
                continue;
            }
            let direction = (to - from).signum();
            let (du, dv) = match b.form {
                BranchForm::VOfU => (direction / unit_u, direction * slope / unit_v),
                BranchForm::UOfV => (direction * slope / unit_u, direction / unit_v),
            };
            // Not along an axis that does not move.
            let step = 1e-7 / du.hypot(dv);
            let right = (u + step * dv * unit_u, v - step * du * unit_v);
            let left = (u - step * dv * unit_u, v + step * du * unit_v);
            if m.fixed_axis.motion == AxisMotion::Fixed || m.moving_axis.motion == AxisMotion::Fixed
            {
                continue;
            }
            let contact = Some(Classification::Contact);
            assert_eq!(space.classify(u, v), contact, "{}: {b:?}", m.name);
            if let Some(class) = space.classify(right.0, right.1) {
                assert_eq!(class, Classification::Free, "{}: {b:?}", m.name);
                let region = space.locate(right.0, right.1).region();
                assert_eq!(
                    region,
                    space.patches()[b.patch.index()].region,
                    "{}",
                    m.name
                );
                tried += 1;
            }
            if let Some(class) = space.classify(left.0, left.1) {
                assert_eq!(class, Classification::Blocked, "{}: {b:?}", m.name);
            }
        }
    }
    assert!(tried > 1000, "{tried}");
}

/// A disc with a bore that turns on its own pivot, and a roller in line with it: every contact is at a joint of two arcs,
/// so that each curve exists twice. All of them bound the region on their free side: in the bore, left or right.
#[test]
fn curves_that_coincide_bound_the_region_on_their_free_side() {
    let circle = |x: f64, r: f64| vec![Vertex::new(x + r, 0.0, 1.0), Vertex::new(x - r, 0.0, 1.0)];
    let wheel = Part::new("wheel", vec![circle(0.0, 2.0), circle(0.0, 1.0)]).unwrap();
    let turn = Axis::revolute(Point::ORIGIN);
    for (x, radius, angles) in [
        (0.1, 0.5, [0.0, 0.3, 2.0]),
        (0.0, 0.3, [0.0, 0.3, 2.0]),
        (-7.0, 0.25, [0.0, 0.1, -0.2]),
    ] {
        let roller = Part::new("roller", vec![circle(x, radius)]).unwrap();
        for angle in angles {
            let slide = Axis::prismatic(Vector::from_angle(angle));
            // Along a line through the pivot and beside it: v = 0 is not always in line.
            let (a, b) = (
                FixedAxesSpace::compute(&wheel, turn, &roller, slide).unwrap(),
                FixedAxesSpace::compute(&roller, slide, &wheel, turn).unwrap(),
            );
            for (space, sliding_first) in [(&a, false), (&b, true)] {
                assert!(space.regions().len() > 1, "{x} {radius} {angle}");
                for (i, p) in (0..).map(PatchId).zip(space.patches()) {
                    let b = p.branches.start as usize;
                    let branch = space.branches()[b];
                    let ends = match branch.form {
                        BranchForm::VOfU => (branch.start.0, branch.end.0),
                        BranchForm::UOfV => (branch.start.1, branch.end.1),
                    };
                    let ((u, v), _) = space.branch_at(b, 0.5 * (ends.0 + ends.1)).unwrap();
                    let (by_u, by_v) = space.contact_gradient(i, u, v).unwrap();
                    let (by_slide, by_turn) = if sliding_first {
                        (by_u, by_v)
                    } else {
                        (by_v, by_u)
                    };
                    assert!(by_turn.abs() < 1e-9 && by_slide.abs() > 0.1);
                    let step = 1e-6 * by_slide.signum();
                    let aside = if sliding_first {
                        (u + step, v)
                    } else {
                        (u, v + step)
                    };
                    let region = space.locate(aside.0, aside.1).region();
                    assert!(region.is_some());
                    assert_eq!(p.region, region, "{x} {radius} {angle}: {p:?}");
                }
            }
        }
    }
}

/// Gradients of contact functions are the differences of their values.
#[test]
fn gradients_agree_with_differences() {
    for m in mechanisms() {
        let space = compute(&m);
        for (i, b) in space.branches().iter().enumerate().step_by(7) {
            let ((u, v), _) = space.branch_at(i, 0.5 * (b.start.0 + b.end.0)).unwrap();
            let f = |du: f64, dv: f64| space.contact_function(b.patch, u + du, v + dv).unwrap();
            let h = 1e-6;
            let differences = (
                (f(h, 0.0) - f(-h, 0.0)) / (2.0 * h),
                (f(0.0, h) - f(0.0, -h)) / (2.0 * h),
            );
            let (by_u, by_v) = space.contact_gradient(b.patch, u, v).unwrap();
            assert!((by_u - differences.0).abs() < 1e-7, "{}", m.name);
            assert!((by_v - differences.1).abs() < 1e-7, "{}", m.name);
        }
    }
}

/// Each patch is the next one of its previous one, begins where that ends, and bounds the same region. Patches without neighbours end at a
/// limit of motion.
#[test]
fn patches_follow_each_other() {
    for m in mechanisms() {
        let space = compute(&m);
        let (patches, branches) = (space.patches(), space.branches());
        let turns = |axis: &Axis| matches!(axis.motion, AxisMotion::Revolute { .. });
        let near = |a: f64, b: f64, turning: bool| {
            let d = a - b;
            let d = if turning {
                d - TAU * (d / TAU).round()
            } else {
                d
            };
            d.abs() < 1e-7
        };
        for (i, p) in (0..).map(PatchId).zip(patches) {
            let last = branches[p.branches.end as usize - 1];
            assert!(p.region.is_some(), "{}: {p:?}", m.name);
            match p.next {
                Some(n) => {
                    let next = &patches[n.index()];
                    assert_eq!(next.previous, Some(i), "{}", m.name);
                    assert_eq!(next.region, p.region, "{}", m.name);
                    let first = branches[next.branches.start as usize];
                    assert!(near(last.end.0, first.start.0, turns(&m.fixed_axis)));
                    assert!(near(last.end.1, first.start.1, turns(&m.moving_axis)));
                }
                None => {
                    let at = |axis: &Axis, t: f64| {
                        axis.motion == AxisMotion::Fixed
                            || axis.range.is_some_and(|(lo, hi)| {
                                t.min(hi - t).abs() < 1e-9
                                    || (t - lo).abs() < 1e-9
                                    || (t - hi).abs() < 1e-9
                            })
                    };
                    let on_line = m.name == "blocks on one line";
                    assert!(
                        on_line || at(&m.fixed_axis, last.end.0) || at(&m.moving_axis, last.end.1),
                        "{}: {p:?} {last:?}",
                        m.name
                    );
                }
            }
        }
    }
}

/// Classes agree with those that the general contact space of the pair gives at the relative configuration.
#[test]
fn agrees_with_the_general_space() {
    let slow = ["gears", "escapement", "ratchet"];
    let all: Vec<Mechanism> = mechanisms()
        .into_iter()
        .filter(|m| !slow.iter().any(|s| m.name.contains(s)))
        .collect();
    let asked: usize = all
        .par_iter()
        .map(|m| {
            let space = compute(m);
            let general = ContactSpace::compute(&m.fixed, &m.moving, &Options::default()).unwrap();
            let mut rng = ChaCha8Rng::seed_from_u64(5);
            let mut coordinate = |axis: &Axis| match (axis.motion, axis.range) {
                (AxisMotion::Fixed, _) => 0.0,
                (_, Some((lo, hi))) => rng.random_range(lo..hi),
                (AxisMotion::Revolute { .. }, None) => rng.random_range(0.0..TAU),
                (AxisMotion::Prismatic { .. }, None) => rng.random_range(-6.0..6.0),
            };
            let mut asked = 0;
            for _ in 0..150 {
                let (u, v) = (coordinate(&m.fixed_axis), coordinate(&m.moving_axis));
                let here = space.classify(u, v).unwrap();
                let there = general.classify(space.configuration(u, v)).unwrap();
                if here != Classification::Contact && there != Classification::Contact {
                    assert_eq!(here, there, "{}: {u} {v}", m.name);
                    asked += 1;
                }
            }
            asked
        })
        .sum();
    assert!(asked > 2000, "{asked}");
}

/// Regions of the torus, the cylinder and the strip extend around the expected coordinates.
#[test]
fn regions_reach_around_where_parts_can_turn_for_ever() {
    let of = |name: &str| {
        let m = mechanisms().into_iter().find(|m| m.name == name).unwrap();
        let space = compute(&m);
        for r in space.regions() {
            assert_eq!(
                space.classify(r.sample.0, r.sample.1),
                Some(Classification::Free),
                "{name}"
            );
        }
        space.regions()
    };
    let never = of("never touching");
    assert_eq!(never.len(), 1);
    assert!(never[0].around_u && never[0].around_v);
    assert!(of("always blocked").is_empty());
    // Gears in mesh turn together: one region that winds around both ways, as many times as there are teeth.
    let gears = of("gears 10 and 9");
    assert_eq!(gears.len(), 1);
    assert!(gears[0].around_u && gears[0].around_v);
    // Above and below the cam.
    let cam = of("cam and round follower");
    assert_eq!(cam.len(), 2);
    assert!(cam.iter().all(|r| r.around_u && !r.around_v));
    // A stopped gear has one region in each gap of its teeth.
    let stopped = of("gear against a stop");
    assert_eq!(stopped.len(), 9);
    assert!(stopped.iter().all(|r| !r.around_u));
}

/// A space that was saved and read gives the same answers; data of another version are rejected.
#[test]
fn saved_spaces_answer_the_same() {
    let m = mechanisms().into_iter().next().unwrap();
    let space = compute(&m);
    let again = FixedAxesSpace::from_data(space.data().clone()).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    for _ in 0..200 {
        let (u, v) = (rng.random_range(0.0..TAU), rng.random_range(0.0..TAU));
        assert_eq!(space.classify(u, v), again.classify(u, v));
        assert_eq!(space.contacts(u, v, 0.1), again.contacts(u, v, 0.1));
    }
    let mut other = space.data().clone();
    other.version += 1;
    assert!(FixedAxesSpace::from_data(other).is_err());
}

/// The result does not depend on the number of threads.
#[test]
fn threads_do_not_matter() {
    for m in mechanisms().iter().take(8) {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| format!("{:?}", compute(m).data()))
        };
        assert_eq!(with(1), with(5), "{}", m.name);
    }
}

/// Invalid axes are rejected, with a hint in the message.
#[test]
fn axes_without_sense_are_refused() {
    let m = mechanisms().into_iter().next().unwrap();
    let refused = |axis: Axis| {
        FixedAxesSpace::compute(&m.fixed, axis, &m.moving, m.moving_axis)
            .unwrap_err()
            .to_string()
    };
    let zero = Axis::prismatic(Vector::ZERO);
    assert!(refused(zero).contains("direction"));
    let x = Axis::prismatic(Vector::new(1.0, 0.0));
    assert!(refused(x.within(2.0, 1.0)).contains("empty"));
    assert!(refused(x.within(0.0, f64::NAN)).contains("not finite"));
    let far = Axis::revolute(Point::new(1e9, 0.0));
    assert!(refused(far).contains("slide"));
}
