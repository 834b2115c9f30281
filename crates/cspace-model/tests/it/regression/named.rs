//! Regression tests that have no key in an expectation.

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{
    Axis, Classification, Classifier, Configuration, ContactSpace, FixedAxesSpace, Location,
    Options, Part, Point, RegionId, Slicer, Vector, Vertex,
};
use cspace_oracle::{Oracle, effort};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::regression::axes::OnAxes;
use crate::regression::parts;

/// Orientations some roundings beside a critical one: patches that end there and that begin there are turns apart.
#[test]
fn disc_in_loose_hole_at_critical_orientations() {
    let [fixed, moving] = parts("tests/regression/disc_in_loose_hole.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = Classifier::new(&space);
    let quarter = core::f64::consts::FRAC_PI_2;
    let orientations = (-2..=2).flat_map(|k| {
        let theta = quarter * f64::from(k);
        (-5..=5).map(move |ulps| theta + f64::from(ulps) * f64::EPSILON)
    });
    for theta in orientations {
        for k in 0..400 {
            let (x, y) = (
                0.45 * f64::from(k % 20) - 4.3,
                0.45 * f64::from(k / 20) - 4.3,
            );
            // In the hole, or beyond the plate; the grid has no contacts.
            let expected = if x.hypot(y) < 0.5 {
                Classification::Free
            } else {
                Classification::Blocked
            };
            let at = Configuration { x, y, theta };
            assert_eq!(space.classify(at), Some(expected), "{at:?}");
            assert_eq!(classifier.classify(at), Some(expected), "{at:?}");
        }
    }
}

/// A sleeve askew on its pole is clamped between two corners, as far as it can turn: all contacts end there. It cannot turn on.
#[test]
fn no_motion_leads_on_where_all_contacts_end() {
    let [fixed, moving] = parts("models/woodpecker.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let from = Configuration::new(
        -5.902_403_010_793_478e-10,
        -191.726_108_981_998_46,
        -0.100_900_924_669_869_37,
    );
    assert_eq!(space.classify(from), Some(Classification::Contact));
    let on = [
        14.458_785_623_051_578,
        4.341_498_320_729,
        -2.450_109_263_507_843,
    ];
    let motion = space.first_contact(from, on, 1.0).unwrap();
    assert_eq!(motion.contact().map(|c| c.time), Some(0.0), "{motion:?}");
    // Along the pole and back it is free to go.
    for rates in [[0.0, 50.0, 0.0], [0.0, 0.0, 0.05]] {
        let motion = space.first_contact(from, rates, 1.0).unwrap();
        assert_eq!(motion.contact().map(|c| c.time), None, "{motion:?}");
    }
}

#[test]
fn windows_that_end_at_a_critical_orientation() {
    let [fixed, moving] = parts("models/paper/cam.toml");
    let hi = 30f64.to_radians();
    let options = Options {
        window: Some((0.0, hi)),
        ..Options::default()
    };
    let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
    let slice = Slicer::new(&fixed, &moving).slice(hi);
    assert_eq!(space.slice(hi).loops.len(), slice.loops.len());
}

/// However many arcs a circle is drawn in, and wherever they meet, a disc in a hole is free within their play.
#[test]
fn circles_of_many_arcs() {
    let mut rng = ChaCha8Rng::seed_from_u64(45);
    for _ in 0..effort(50, 150) {
        let mut circle = |center: f64, radius: f64, decimals: Option<i32>| {
            let n = rng.random_range(2..10);
            let mut angles: Vec<f64> = (0..n).map(|_| rng.random_range(0.0..TAU)).collect();
            if rng.random_bool(0.5) {
                angles = (0..n)
                    .map(|i| angles[0] + TAU * f64::from(i) / f64::from(n))
                    .collect();
            }
            angles.sort_by(f64::total_cmp);
            let rounded =
                |x: f64| decimals.map_or(x, |d| (x * 10f64.powi(d)).round() / 10f64.powi(d));
            (0..angles.len())
                .map(|i| {
                    let next = angles.get(i + 1).copied().unwrap_or(angles[0] + TAU);
                    let p = Vector::from_angle(angles[i]) * radius;
                    Vertex::new(
                        rounded(center + p.x),
                        rounded(center + p.y),
                        (0.25 * (next - angles[i])).tan(),
                    )
                })
                .collect::<Vec<_>>()
        };
        let square = [(-3.0, -3.0), (4.0, -3.0), (4.0, 4.0), (-3.0, 4.0)];
        for decimals in [None, Some(12), Some(9)] {
            let outline = square.map(|(x, y)| Vertex::line(x, y)).to_vec();
            let fixed = Part::new("plate", vec![outline, circle(0.5, 1.25, decimals)]);
            let moving = Part::new("disc", vec![circle(0.0, 1.0, decimals)]);
            // Points nearer than one part in a thousand million of each other are none.
            let (Ok(fixed), Ok(moving)) = (fixed, moving) else {
                continue;
            };
            let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
            assert_eq!(space.free_regions().len(), 2, "{fixed:?} {moving:?}");
            for k in 0..40 {
                let theta = 0.157 * f64::from(k) - 3.1;
                let way = Vector::from_angle(7.0 * theta);
                for (play, expected) in [
                    (0.0, Classification::Free),
                    (0.25 - 1e-7, Classification::Free),
                    (0.25 + 1e-7, Classification::Blocked),
                ] {
                    let at = Configuration::new(0.5 + play * way.x, 0.5 + play * way.y, theta);
                    assert_eq!(
                        space.classify(at),
                        Some(expected),
                        "{fixed:?} {moving:?} {at:?}"
                    );
                }
            }
        }
    }
}

/// Two pins in holes, and a star in its own shape, with the plays that README promises.
#[test]
fn pockets_of_small_play() {
    use cspace::Vertex;
    let plate = || {
        [(-3.0, -2.0), (3.0, -2.0), (3.0, 2.0), (-3.0, 2.0)]
            .map(|(x, y)| Vertex::line(x, y))
            .to_vec()
    };
    let circle =
        |x: f64, y: f64, r: f64| vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)];
    let pins = |r: f64| vec![circle(-1.0, 0.0, r), circle(1.1, 0.3, r)];
    let star = |size: f64| -> Vec<Vertex> {
        (0..10)
            .map(|i| {
                let (sin, cos) = (0.1 + PI * f64::from(i) / 5.0).sin_cos();
                let r = if i % 2 == 0 { 0.5 * size } else { size };
                Vertex::line(r * cos, r * sin)
            })
            .collect()
    };
    for play in [1e-6, 1e-7, 1e-8] {
        let (mut holes, mut hollow) = (vec![plate()], vec![plate()]);
        holes.extend(pins(0.5));
        hollow.push(star(1.0));
        // The pins go in two ways round, the star in five.
        for (fixed, moving, ways) in [
            (holes, pins(0.5 - play), 2),
            (hollow, vec![star(1.0 - play)], 5),
        ] {
            let (fixed, moving) = (
                Part::new("plate", fixed).unwrap(),
                Part::new("in it", moving).unwrap(),
            );
            let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
            let at = Configuration::default();
            assert_eq!(
                space.classify(at),
                Some(Classification::Free),
                "play {play}"
            );
            assert_eq!(space.free_regions().len(), 1 + ways, "play {play}");
        }
    }
}

/// Upright curves just beyond the ends of others mark these, although their boxes do not touch.
#[test]
fn slice_from_scratch_beside_a_tie() {
    let [fixed, moving] = parts("tests/regression/slice_from_scratch_beside_a_tie.toml");
    let slicer = Slicer::new(&fixed, &moving);
    let loops = |theta: f64| slicer.slice(theta).loops.len();
    let before = |by: f64| loops(core::f64::consts::FRAC_PI_4 - by);
    assert_eq!(before(1e-12), before(1e-4));
}

/// Half circles of one centre: contacts of two pairs of them are one curve but for the perturbation. Slices that are open there are
/// doubtful, and the parts themselves are asked.
#[test]
fn spiral_with_itself() {
    let [fixed, moving] = parts("tests/regression/spiral_with_itself.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    let oracle = Oracle::new(&fixed, &moving);
    for k in (0..360).step_by(effort(9, 1)) {
        let theta = (f64::from(k) + 0.4).to_radians();
        let slice = space.slice(theta);
        let scratch = slicer.slice(theta);
        let n = slice.curves.len();
        let open = slice.curves.iter().any(|c| c.next as usize >= n);
        assert!(slice.doubtful || !open, "at {theta}");
        let same = slice.loops.len() == scratch.loops.len();
        assert!(slice.doubtful || scratch.doubtful || same, "at {theta}");
        for curve in &slice.curves {
            let (p, step) = (
                curve.geometry.point(0.5),
                curve.geometry.free_normal(0.5) * 1e-6,
            );
            for p in [p + step, p + -step] {
                let at = Configuration::new(p.x, p.y, theta);
                let verdict = oracle.judge(at);
                if verdict.margin > 1e-8 {
                    let free = space.classify(at) == Some(Classification::Free);
                    assert_eq!(free, !verdict.overlap, "{at:?}");
                }
            }
        }
    }
}

/// Equal numbers of positions just within and just beyond the circle are classified correctly, also where the inner
/// ring is open.
#[test]
fn equal_room_inside_and_outside() {
    let parts = parts("tests/regression/equal_room_inside_and_outside.toml");
    let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
    for angle in (0..360).step_by(effort(5, 1)) {
        let out = Vector::from_angle(f64::from(angle).to_radians());
        for theta in [0.0, 1.0, -2.0] {
            let at = |r: f64| Configuration::new(r * out.x, r * out.y, theta);
            let told = [0.19999, 0.20001].map(|r| space.classify(at(r)));
            let expected = [Classification::Free, Classification::Blocked];
            assert_eq!(told, expected.map(Some), "{angle} {theta}");
        }
    }
}

/// The contact function of a line through the pivot of both parts vanishes half a turn from the contact too, in free space or
/// deep in blocked space.
#[test]
fn door_and_peg() {
    let part = |name, corners: &[(f64, f64)]| {
        let corners = corners.iter().map(|&(x, y)| Vertex::line(x, y));
        Part::new(name, vec![corners.collect()]).unwrap()
    };
    let fixed = part("peg", &[(-0.1, 3.0), (0.1, 3.0), (0.1, 3.2), (-0.1, 3.2)]);
    let moving = part("door", &[(0.0, 0.0), (4.0, 0.0), (4.0, 0.5), (0.0, 0.5)]);
    let turn = Axis::revolute(Point::ORIGIN);
    let pair = OnAxes {
        space: FixedAxesSpace::compute(&fixed, turn, &moving, turn).unwrap(),
        oracle: Oracle::new(&fixed, &moving),
    };
    // The lower side, which begins at the pivot, touches the peg's left corner; half a turn before it is far from it.
    let across = 3.0_f64.atan2(-0.1) - PI;
    let behind: Vec<(f64, f64)> = (-10..10)
        .map(|k| 0.1 * f64::from(k))
        .map(|t| (t, t + across))
        .collect();
    assert!(pair.certainly_right(&behind) > 900);
    for (u, v) in behind {
        assert_eq!(pair.space.locate(u, v), Location::Free(RegionId(0)));
    }
    let still = FixedAxesSpace::compute(&fixed, Axis::FIXED, &moving, turn).unwrap();
    for rate in [1.0, -1.0] {
        let times = [&pair.space, &still].map(|space| {
            let from = (0.0, across - 0.3 * rate);
            match space.first_contact(from, (0.0, rate), 10.0).unwrap() {
                AxesMotionOutcome::Contact(contact) => contact.time,
                none => panic!("{none:?}"),
            }
        });
        assert!((times[0] - times[1]).abs() < 1e-9, "{times:?}");
    }
}
