//! Files of `tests/regression`: what went wrong once.

#![allow(clippy::unwrap_used, clippy::panic)]

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{
    Axis, AxisMotion, Classification, Configuration, ContactSpace, FixedAxesSpace, Options, Part,
    Point, Relation, Rotation, Slicer, Vector, Vertex,
};
use cspace_io::Model;
use cspace_oracle::{Oracle, near_contact};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The two parts of a file of this project.
fn parts(file: &str) -> [Part; 2] {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let model = Model::read(format!("{folder}/{file}")).unwrap();
    [0, 1].map(|i| model.parts[i].part.clone())
}

/// Configurations near contact that the space and brute force judge differently, of those that are certain by more than
/// 1e-10 of the size and the resolution.
fn wrong([fixed, moving]: &[Part; 2]) -> Vec<Configuration> {
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    let oracle = Oracle::new(fixed, moving);
    let least = space.resolution().max(1e-10 * oracle.size());
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    near_contact(&oracle, &mut rng, 1000)
        .into_iter()
        .filter(|near| {
            let c = near.configuration;
            near.verdict.margin > least && space.slice(c.theta).is_free(c.position()) != near.free
        })
        .map(|near| near.configuration)
        .collect()
}

/// Slices at evenly spaced orientations are made of closed loops, as many as those from scratch.
fn assert_closed([fixed, moving]: &[Part; 2]) {
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    let slicer = Slicer::new(fixed, moving);
    for k in 0..360 {
        let theta = (f64::from(k) + 0.4).to_radians();
        let slice = space.slice(theta);
        let open = slice
            .curves
            .iter()
            .find(|c| c.next as usize >= slice.curves.len());
        assert_eq!(open, None, "at {theta}");
        let scratch = slicer.slice(theta);
        assert_eq!(slice.loops.len(), scratch.loops.len(), "at {theta}");
    }
}

/// An arc just fits a fillet, and what follows it smoothly does not: the contact curve of the two is a point.
#[test]
fn equal_radii_in_a_fillet() {
    let [fixed, moving] = parts("tests/regression/equal_radii_in_a_fillet.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    for band in space.bands() {
        let theta = 0.5 * (band.lo + band.hi);
        for slice in [space.slice(theta), slicer.slice(theta)] {
            assert!(!slice.loops.is_empty(), "{band:?}");
        }
    }
    assert_eq!(space.statistics().conflicts, 0);
}

/// Orientations some roundings beside a critical one: patches that end there and that begin there are turns apart.
#[test]
fn disc_in_loose_hole_at_critical_orientations() {
    let [fixed, moving] = parts("tests/regression/disc_in_loose_hole.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = space.classifier();
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

#[test]
fn rounded_peg_between_bars() {
    let [fixed, moving] = parts("tests/regression/rounded_peg_between_bars.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    for x in [0.0, 5.0] {
        let at = Configuration {
            x,
            y: 0.0,
            theta: 0.0,
        };
        assert_eq!(space.classify(at), Some(Classification::Free), "{at:?}");
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

/// No disc is found in so thin a ring; the disc that goes into it has one all the same.
#[test]
fn thin_ring() {
    let [ring, disc] = parts("tests/regression/thin_ring.toml");
    for (fixed, moving) in [(&ring, &disc), (&disc, &ring)] {
        let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
        let slicer = Slicer::new(fixed, moving);
        for k in 0..40 {
            let x = 0.05 * f64::from(k);
            let expected = if (0.25..1.2504).contains(&x) {
                Classification::Blocked
            } else {
                Classification::Free
            };
            if (x - 0.25).abs() < 1e-9 {
                continue;
            }
            let at = Configuration {
                x,
                y: 0.0,
                theta: 0.3,
            };
            assert_eq!(space.classify(at), Some(expected), "{at:?}");
            let free = slicer.slice(at.theta).is_free(at.position());
            assert_eq!(free, expected == Classification::Free, "{at:?}");
        }
    }
}

/// Contact curves with the floor, the face and the corner of a step meet in one point at every orientation.
#[test]
fn step_as_high_as_a_radius() {
    for name in ["step_as_high_as_a_radius", "step_as_high_as_a_half_disc"] {
        let parts = parts(&format!("tests/regression/{name}.toml"));
        assert_eq!(wrong(&parts), [], "{name}");
    }
}

#[test]
fn sector_in_hollow_corners() {
    let parts = parts("tests/regression/sector_in_hollow_corners.toml");
    assert_eq!(wrong(&parts), []);
    assert_closed(&parts);
}

#[test]
fn disc_in_a_hole_at_45_degrees() {
    let parts = parts("tests/regression/disc_in_a_hole_at_45_degrees.toml");
    let [fixed, moving] = &parts;
    let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
    assert_eq!(space.free_regions().len(), 2);
    let at = |x: f64| space.classify(Configuration::new(x, 0.0, 0.3));
    assert_eq!(at(0.0), Some(Classification::Free));
    assert_eq!(at(0.249), Some(Classification::Free));
    assert_eq!(at(0.251), Some(Classification::Blocked));
    assert_closed(&parts);
}

/// However many arcs a circle is drawn in, and wherever they meet, a disc in a hole is free within their play.
#[test]
fn circles_of_many_arcs() {
    let mut rng = ChaCha8Rng::seed_from_u64(45);
    for _ in 0..150 {
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

#[test]
fn step_below_a_slope() {
    assert_closed(&parts("tests/regression/step_below_a_slope.toml"));
}

#[test]
fn pieces_in_line() {
    let [fixed, moving] = parts("tests/regression/pieces_in_line.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = space.classifier();
    // At -30 deg itself, where the order of the curves is not known.
    let theta = -core::f64::consts::FRAC_PI_6;
    for (x, y) in [
        (0.843_607_230_109_343_5, 1.874_950_606_564_892_2),
        (0.624_506_065_648_925_6, 1.922_356_679_531_538_3),
    ] {
        let at = Configuration { x, y, theta };
        assert_eq!(space.classify(at), Some(Classification::Blocked), "{at:?}");
        let blocked = classifier.classify(at);
        assert_eq!(blocked, Some(Classification::Blocked), "{at:?}");
    }
}

/// Cells leak to one shell; what lies furthest out of it is free, so that they are decided one by one.
#[test]
fn star_with_itself() {
    let parts = parts("tests/regression/star_with_itself.toml");
    let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
    assert!(!space.patches().is_empty());
    assert_eq!(wrong(&parts), []);
}

/// Shells leak where sides become parallel at two orientations less than 1e-10 apart: a conflict, decided cell by cell.
#[test]
fn swallowtail_with_itself() {
    let parts = parts("tests/regression/swallowtail_with_itself.toml");
    assert_eq!(wrong(&parts), []);
}

/// Play below the resolution is none, and leaves no open boundary.
#[test]
fn disc_in_a_socket_by_1e_11() {
    let parts = parts("tests/regression/disc_in_a_socket_by_1e-11.toml");
    assert_eq!(wrong(&parts), []);
}

#[test]
fn corner_in_a_half_ring() {
    assert_closed(&parts("tests/regression/corner_in_a_half_ring.toml"));
}

#[test]
fn segment_of_a_disc_in_an_arc_of_its_radius() {
    let name = "tests/regression/segment_of_a_disc_in_an_arc_of_its_radius.toml";
    assert_closed(&parts(name));
}

#[test]
fn sector_between_two_pieces() {
    assert_closed(&parts("tests/regression/sector_between_two_pieces.toml"));
}

#[test]
fn rectangle_and_disc_with_itself() {
    assert_closed(&parts(
        "tests/regression/rectangle_and_disc_with_itself.toml",
    ));
}

/// Curves of slices that no other follows, of the contact space and from scratch.
fn open_curves(name: &str, orientations: &[f64]) -> [usize; 2] {
    let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    let mut open = [0; 2];
    for &theta in orientations {
        for (n, slice) in open
            .iter_mut()
            .zip([space.slice(theta), slicer.slice(theta)])
        {
            let len = slice.curves.len();
            *n += (slice.curves.iter())
                .filter(|c| c.next as usize >= len)
                .count();
        }
    }
    open
}

#[test]
fn part_in_a_hole_of_its_shape() {
    let about = 15f64.to_radians();
    let all = [-1e-11, -1e-12, 0.0, 1e-12, 1e-11, 1e-9].map(|d| about + d);
    assert_eq!(open_curves("part_in_a_hole_of_its_shape", &all), [0, 0]);
}

#[test]
fn slot_with_nearly_smooth_joints() {
    let all = [-0.976, -0.9, -0.8];
    assert_eq!(open_curves("slot_with_nearly_smooth_joints", &all), [0, 0]);
}

#[test]
fn two_polygons_beside_30_degrees() {
    let about = -30f64.to_radians();
    let all = [1e-6, 3e-6, 3.3e-6].map(|d| about + d);
    assert_eq!(open_curves("two_polygons_beside_30_degrees", &all), [0, 0]);
}

/// Between two critical orientations so near that the error of one covers both, one slice stands for all.
#[test]
fn beside_tangencies() {
    certain(&[(
        "half_disc_on_a_long_side",
        Configuration::new(-2.0823690084595325, -3.9999996184396984, 3.1415924981163417),
    )]);
}

/// At the orientation itself at which a gap closes, whose two sides rounding has brought into the wrong order.
#[test]
fn gaps_that_close() {
    certain(&[(
        "annular_sector_and_bar_at_75_degrees",
        Configuration::new(0.24999434314575084, 1.2248002123068442, -1.308996938995747),
    )]);
}

/// Arcs whose centres are so far away that places about these are lost; just beside the orientations at which sides align.
#[test]
fn flat_sides() {
    certain(&[
        (
            "sides_of_radius_1e5",
            Configuration::new(0.999988709392276, 0.9974126608344671, -3.141570238975972),
        ),
        (
            "sides_of_radius_1e9",
            Configuration::new(
                -0.09202803600054993,
                0.9565851593688555,
                -0.00017755062146971746,
            ),
        ),
        (
            "hollow_sides_of_radius_1e7",
            Configuration::new(
                0.7999999949049443,
                -0.5586947271621112,
                -4.3395126379451596e-8,
            ),
        ),
        (
            "hollow_sides_of_radius_1e7",
            Configuration::new(
                -0.6754385115383246,
                -0.6499999976842201,
                5.7372616928579566e-9,
            ),
        ),
    ]);
}

/// Ends of arcs whose normals oppose each other touch by their making: at orientations that are told apart, however large the
/// radii are that cancel there.
#[test]
fn ends_of_arcs_that_touch_by_their_making() {
    let name = "bent_bar_and_slot_of_nearly_equal_radii";
    certain(&[
        (
            name,
            Configuration::new(
                -3.0428052132753485e-6,
                -0.7000000433394351,
                6.525235021466986e-9,
            ),
        ),
        (
            name,
            Configuration::new(
                1.0000000009123706,
                0.5803771827564458,
                -3.323078517975089e-8,
            ),
        ),
    ]);
    let all = [-1e-7, -3e-8, -3e-9, 3e-9, 3e-8, 1e-7];
    assert_eq!(open_curves(name, &all), [0, 0]);
    let name = "sides_of_radius_3e6_between_corners";
    certain(&[
        (
            name,
            Configuration::new(0.7499999735570713, 0.296802385622668, -1.5707964550834848),
        ),
        (
            name,
            Configuration::new(
                -0.34697008831755716,
                0.7499999862921358,
                3.2320052796557563e-9,
            ),
        ),
        (
            name,
            Configuration::new(0.7499999816161798, 0.2775678271431522, 3.1415925042529667),
        ),
    ]);
}

/// A pocket one of whose walls is an arc on an arc of nearly its radius: places on that contact circle, of 2e-6, are told apart.
#[test]
fn hollow_arc_with_a_play_of_1e_6() {
    let name = "hollow_arc_with_a_play_of_1e-6";
    // From every point about here all of the part is seen: that much larger about it, the hole has room on all sides.
    let from = (1.95, -0.2);
    let at = Configuration::new(1e-6 * from.0, 1e-6 * from.1, 0.0);
    certain(&[(name, at)]);
    let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    assert_eq!(space.classify(at), Some(Classification::Free));
    assert_eq!(space.free_regions().len(), 2);
    let slicer = Slicer::new(&fixed, &moving);
    for theta in [-5e-7, -1e-8, 0.0, 1e-8, 5e-7] {
        let loops = [space.slice(theta), slicer.slice(theta)].map(|s| s.loops.len());
        assert_eq!(loops, [2, 2], "{theta}");
    }
}

/// What is told of a large arc is written and read back.
#[test]
fn flat_sides_are_saved() {
    // Nothing ends on the normal of a hollow side, whose end would swing with it.
    for (name, swings) in [
        ("sides_of_radius_1e9", true),
        ("hollow_sides_of_radius_1e7", false),
    ] {
        let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let saved = space.to_saved();
        let text = serde_json::to_string(&saved).unwrap();
        assert!(text.contains("flat-circle"), "{name}");
        assert_eq!(text.contains("\"rest\""), swings, "{name}");
        let read = serde_json::from_str(&text).unwrap();
        assert_eq!(
            ContactSpace::from_saved(read).unwrap().to_saved(),
            saved,
            "{name}"
        );
    }
}

/// The graph says what brute force is certain of.
fn certain(all: &[(&str, Configuration)]) {
    for &(name, at) in all {
        let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
        let verdict = Oracle::new(&fixed, &moving).judge(at);
        assert!(verdict.margin > 1e-9, "{name}: {verdict:?}");
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let free = space.slice(at.theta).is_free(at.position());
        assert_eq!(free, !verdict.overlap, "{name}");
    }
}

/// Whether the parts as drawn together are in a pocket: free, for the graph and for a slice from scratch.
fn pocket_is_free(file: &str) {
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let at = Configuration::default();
    assert!(
        Slicer::new(&fixed, &moving)
            .slice(at.theta)
            .is_free(at.position())
    );
    assert!(space.slice(at.theta).is_free(at.position()), "{file}");
    assert_eq!(space.classify(at), Some(Classification::Free), "{file}");
}

/// Configurations of a file are classified as brute force has it, alone and by a classifier.
fn classified(file: &str, rows: &[(f64, f64, f64)]) {
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = space.classifier();
    let oracle = Oracle::new(&fixed, &moving);
    for &(x, y, theta) in rows {
        let at = Configuration::new(x, y, theta);
        let verdict = oracle.judge(at);
        assert!(
            verdict.margin > 1e-10 * oracle.size(),
            "{file}: {verdict:?}"
        );
        let class = if verdict.margin <= space.resolution() {
            // Then it may be anything, but the same for both.
            space.classify(at)
        } else if verdict.overlap {
            Some(Classification::Blocked)
        } else {
            Some(Classification::Free)
        };
        assert_eq!(space.classify(at), class, "{file} at {at:?}: {verdict:?}");
        assert_eq!(classifier.classify(at), class, "{file} at {at:?}");
    }
}

/// At θ = 0 the circles of both pins are one; half way to the next event they have moved by more than their radius.
#[test]
fn two_pins_of_equal_play() {
    pocket_is_free("tests/regression/two_pins_of_equal_play.toml");
}

/// A sliver of a circle, between joints that all but align, passes the other pin's circle within one cluster.
#[test]
fn pins_that_swallow_slivers() {
    pocket_is_free("tests/regression/two_pins_of_unequal_play.json");
    pocket_is_free("tests/regression/three_pins.toml");
}

#[test]
fn two_pins_of_play_1e_6() {
    pocket_is_free("tests/regression/two_pins_of_play_1e-6.toml");
}

#[test]
fn l_in_l_of_play_5e_8() {
    pocket_is_free("tests/regression/l_in_l_of_play_5e-8.toml");
}

/// Circles on which round corners touch are tangent to lines that they do not reach, to the square root of rounding just
/// then: the pocket went under in that. The bar fits in two ways, and each is one region.
#[test]
fn rounded_bar_in_its_own_shape_of_play_1e_7() {
    let file = "tests/regression/rounded_bar_in_its_own_shape_of_play_1e-7.toml";
    pocket_is_free(file);
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let caged = space.free_regions().iter().filter(|r| !r.unbounded);
    assert_eq!(caged.count(), 2);
}

/// Two pins in holes, and a star in its own shape, with plays above those that docs/limits.md warns of.
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

/// A pair on fixed axes, and brute force to judge it.
struct OnAxes {
    space: FixedAxesSpace,
    oracle: Oracle,
}

impl OnAxes {
    fn read(name: &str) -> Self {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/regression");
        let model = Model::read(format!("{folder}/{name}")).unwrap();
        let Relation::Axes {
            fixed: u,
            moving: v,
        } = model.relation(&model.pairs[0])
        else {
            panic!("{name} is no pair on fixed axes");
        };
        let [fixed, moving] = [0, 1].map(|i| model.parts[i].part.clone());
        Self {
            space: FixedAxesSpace::compute(&fixed, u, &moving, v).unwrap(),
            oracle: Oracle::new(&fixed, &moving),
        }
    }

    /// Where the moving part is in the fixed part's frame.
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

    /// Fails if an answer is not the one of brute force at one of these positions, or at one of a thousand others.
    fn assert_right(&self, at: &[(f64, f64)]) {
        let certain = self.certainly_right(at);
        assert!(certain > 900, "{certain} certain");
    }

    /// The same, and how many of the positions are certain.
    fn certainly_right(&self, at: &[(f64, f64)]) -> usize {
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
}

/// Where more happens at one place than rounding can order, both parts are moved by a hair, and the resolution says so: a
/// corner that passes over a pivot, slides along sides of both parts, an end that rolls about its own centre, a part in a
/// larger hole of its shape.
#[test]
fn ties_on_fixed_axes() {
    for name in [
        "corner_over_pivot",
        "corner_over_pivot_no_range",
        "rect_and_slot_slide",
        "two_polygons_slide",
        "stadium_and_its_half_slide",
        "stadium_end_and_roller",
        "triangle_in_triangle_hole",
        "equal_stadiums_far",
    ] {
        let pair = OnAxes::read(&format!("axes_{name}.json"));
        let size = pair.oracle.size();
        let resolution = pair.space.resolution();
        assert!(resolution < 1e-6 * size, "{name}: {resolution:e}");
        pair.assert_right(&[]);
        // What is found can be saved, and its regions are free.
        let saved = serde_json::to_string(&pair.space.to_saved()).unwrap();
        let read = serde_json::from_str(&saved).unwrap();
        let read = FixedAxesSpace::from_saved(read).unwrap();
        assert_eq!(read.resolution(), resolution, "{name}");
        for (i, region) in (0..).zip(pair.space.regions()) {
            let (u, v) = region.sample;
            let verdict = pair.oracle.judge(pair.relative((u, v)));
            assert!(!verdict.overlap, "{name}: region {i}");
            assert_eq!(pair.space.region_at(u, v), Some(i), "{name}");
            assert_eq!(read.region_at(u, v), Some(i), "{name}");
        }
        for patch in pair.space.patches() {
            assert!(patch.region.is_some(), "{name}: {patch:?}");
            if let Some(next) = patch.next {
                let next = &pair.space.patches()[next as usize];
                assert_eq!(next.region, patch.region, "{name}");
            }
        }
    }
    // Two stadiums that are far from each other but for a line of touch: one region, as any way around shows.
    let pair = OnAxes::read("axes_equal_stadiums_far.json");
    assert_eq!(pair.space.regions().len(), 1);
}

/// The contact function of a line through the pivot of both parts vanishes half a turn from the contact too, in free space or
/// deep in blocked space.
#[test]
fn one_pivot_on_a_side() {
    let pair = OnAxes::read("axes_one_pivot_on_a_side.toml");
    let alike: Vec<(f64, f64)> = (-30..30)
        .map(|k| 0.1 * f64::from(k))
        .map(|t| (t, t))
        .collect();
    pair.assert_right(&alike);

    // A door and a peg.
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
    pair.assert_right(&behind);
    for (u, v) in behind {
        assert_eq!(pair.space.region_at(u, v), Some(0));
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

/// A curve that has no width but where its range ends does not go on beyond the features.
#[test]
fn side_along_the_slide_at_the_limit() {
    let pair = OnAxes::read("axes_side_along_the_slide_at_the_limit.toml");
    let (u, v) = pair.space.axes();
    let (u, v) = (u.range.unwrap(), v.range.unwrap());
    let along = |t: f64| (u.0, v.0 + t * (v.1 - v.0));
    let limit: Vec<(f64, f64)> = (0..=50).map(|k| along(f64::from(k) / 50.0)).collect();
    pair.assert_right(&limit);
}

/// Circles that hardly differ cross at the ends of their arcs, as far as rounding tells: what is outermost must be free.
#[test]
fn discs_with_joints_of_1e_10() {
    let [fixed, moving] = parts("tests/regression/discs_with_joints_of_1e-10.toml");
    let slicer = Slicer::new(&fixed, &moving);
    for theta in [-1e-9, -1e-11, -1e-12, 0.0, 1e-12, 1e-11, 1e-9] {
        let slice = slicer.slice(theta);
        let length: f64 = slice.curves.iter().map(|c| c.geometry.length()).sum();
        assert!(!slice.doubtful && slice.loops.len() == 1, "{theta}");
        // A circle of radius 2.
        assert!((length - 2.0 * TAU).abs() < 1e-8, "{theta}: {length}");
        assert!(!slice.is_free(Point::ORIGIN), "{theta}");
    }
}

/// A pocket whose contacts hang together with blocked ones, by a link that is none, is tested for itself.
#[test]
fn pocket_linked_to_blocked_contacts() {
    let pair = parts("tests/regression/pocket_linked_to_blocked_contacts.toml");
    let space = ContactSpace::compute(&pair[0], &pair[1], &Options::default()).unwrap();
    let oracle = Oracle::new(&pair[0], &pair[1]);
    for (x, y, theta) in [
        (2.457888724678159, 1.8547342152440576, -1.6908969462317167),
        (2.432165551251859, 0.9667765945612544, -1.9634954084971574),
        (1.914846758007145, 1.1834968119308993, -1.923619370490583),
    ] {
        let c = Configuration::new(x, y, theta);
        assert!(!oracle.judge(c).overlap);
        assert_eq!(space.classify(c), Some(Classification::Free), "{c:?}");
    }
}

/// A shell that leaks into blocked space is told by what lies furthest out of all of it: that is free.
#[test]
fn outermost_shell_with_a_leak() {
    let pair = parts("tests/regression/outermost_shell_with_a_leak.toml");
    let space = ContactSpace::compute(&pair[0], &pair[1], &Options::default()).unwrap();
    let outer = space.patches().iter().filter(|p| p.region == 0).count();
    assert!(outer > 100, "{outer}");
    for (x, y, theta) in [(1.0, 0.3, 0.0), (0.0, 0.0, 1.0), (3.0, 1.5, 2.0)] {
        let class = space.classify(Configuration::new(x, y, theta));
        assert_eq!(class, Some(Classification::Blocked));
    }
    assert_eq!(wrong(&pair), []);
}

/// Pivots and directions that differ by rounding are one: corners and sides there are told apart no better.
#[test]
fn axes_that_differ_by_rounding() {
    for name in [
        "pivots_1e-12_apart",
        "corners_1e-12_from_pivots",
        "slides_parallel_to_5e-13",
    ] {
        let pair = OnAxes::read(&format!("axes_{name}.toml"));
        assert!(pair.space.resolution() < 1e-9, "{name}");
        // Corners at both pivots are always all but in contact: the others are blocked.
        let certain = pair.certainly_right(&[]);
        assert!(certain > 400, "{name}: {certain} certain");
    }
}

/// An exact fit is blocked, though but a single position of a single motion is one.
#[test]
fn corner_past_a_corner() {
    let pair = OnAxes::read("axes_corner_past_a_corner.toml");
    let regions = [-0.1, 0.1].map(|v| pair.space.region_at(0.0, v).unwrap());
    assert_ne!(regions[0], regions[1]);
    assert_eq!(pair.space.regions().len(), 2);
    assert_eq!(pair.space.classify(0.0, 0.0), Some(Classification::Contact));
}

/// Cells are not turned around by rounding.
#[test]
fn crossing_beyond_an_end() {
    let pair = OnAxes::read("axes_crossing_beyond_an_end.toml");
    assert_eq!(pair.space.classify(0.0, 0.0), Some(Classification::Contact));
    pair.assert_right(&[]);
}

/// What is written is read again, though carriers that all but coincide for 1e-10 rad cross anywhere.
#[test]
fn patches_for_1e_10_rad() {
    let [fixed, moving] = parts("tests/regression/patches_for_1e-10_rad.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let saved = space.to_saved();
    let read = ContactSpace::from_saved(saved.clone()).unwrap();
    assert_eq!(read.to_saved(), saved);
}

/// Arcs of 1e9 sizes are taken for lines on fixed axes, and the resolution says so.
#[test]
fn flat_sides_beside_a_pivot() {
    let pair = OnAxes::read("axes_flat_sides_beside_a_pivot.toml");
    let resolution = pair.space.resolution();
    assert!((1e-10..1e-9).contains(&resolution), "{resolution:e}");
    assert_eq!(pair.space.regions().len(), 1);
    pair.assert_right(&[(2.825000001402805, 0.9373089717269001)]);
}

/// A bar over a groove of a radius: links there were contradictory while decisions were made in doubles alone.
#[test]
fn bar_over_a_groove_of_a_radius() {
    let pair = parts("tests/regression/bar_over_a_groove_of_a_radius.toml");
    let space = ContactSpace::compute(&pair[0], &pair[1], &Options::default()).unwrap();
    assert_eq!(space.statistics().conflicts, 0);
    assert_eq!(space.doubtful_orientations(), []);
    assert_eq!(wrong(&pair), []);
}

/// Corners that are all but on the pivots of both parts: contacts that depend on so little are lost, which an overlap beside
/// one of them tells, and a corner touches a side, within the resolution, wherever the parts are.
#[test]
fn pivots_that_are_nearly_one() {
    for name in ["1e-10", "1e-8"] {
        let pair = OnAxes::read(&format!("axes_pivots_{name}_apart.toml"));
        let resolution = pair.space.resolution();
        assert!(resolution < 1e-7 * pair.oracle.size());
        let range = pair.space.axes().1.range.unwrap_or((-3.1, 3.1));
        let mut rng = ChaCha8Rng::seed_from_u64(9);
        let mut blocked = 0;
        for _ in 0..1000 {
            let (u, v) = (
                rng.random_range(-3.1..3.1),
                rng.random_range(range.0..range.1),
            );
            let verdict = pair.oracle.judge(pair.relative((u, v)));
            // The corners at the pivots are never farther apart than the resolution.
            if verdict.margin > resolution {
                assert!(verdict.overlap, "{name}: ({u}, {v})");
                let class = pair.space.classify(u, v);
                assert_eq!(class, Some(Classification::Blocked), "{name}: ({u}, {v})");
                blocked += 1;
            }
        }
        assert!(blocked > 300, "{name}: {blocked}");
    }
}

/// At a critical orientation positions are those of the orientation asked for, and not of a place just above.
#[test]
fn peg_and_hole_drawn_1e8_away() {
    let rows = [
        (2.689842981231048, 99999997.49999745, -PI),
        (-2.1607893564408647, 100000002.49999745, -PI),
    ];
    let file = "tests/regression/peg_and_hole_drawn_1e8_away.toml";
    classified(file, &rows);
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    for ((x, y, theta), free) in rows.into_iter().zip([true, false]) {
        let at = Configuration::new(x, y, theta).position();
        assert_eq!(space.slice(theta).is_free(at), free);
        assert_eq!(slicer.slice(theta).is_free(at), free);
    }
}

/// An event that may be two, one or none is told where it is known best.
#[test]
fn sides_that_meet_at_quarter_turns() {
    let file = "tests/regression/sides_that_meet_at_quarter_turns.toml";
    classified(
        file,
        &[
            (1.5185144410375377, 0.12838190163121882, 1.5707963167241776),
            (-0.8838841102438366, -1.5309287509790979, 1.5707963167241776),
        ],
    );
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let quarter = core::f64::consts::FRAC_PI_2;
    let off = (space.critical_orientations().iter()).map(|c| (c - quarter).abs());
    assert!(off.fold(1.0, f64::min) < 1e-10);
}

#[test]
fn side_broken_inwards_by_9e_9() {
    let file = "tests/regression/side_broken_inwards_by_9e-9.toml";
    classified(file, &[(-0.38770897094439627, 1.2499999981753875, 0.0)]);
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    // Blocked by 4e-10 and free by 6e-10.
    let slice = space.slice(0.0);
    assert!(!slice.is_free(Point::new(-0.38770897094439627, 1.2499999981753875)));
    assert!(slice.is_free(Point::new(-0.38770897094439627, 1.2499999991753875)));
}

/// A part is grown, and a sharp corner by more than its sides: answers may be wrong within the resolution, not beyond.
#[test]
fn corner_of_a_quarter_degree() {
    let file = "tests/regression/corner_of_a_quarter_degree.toml";
    let (x, y, theta) = (-1.0042925438184338, 1.6223491991049026, 1.5739215269190339);
    let beside = |away: f64| (x + away, y, theta);
    classified(file, &[-3e-9, 0.0, 3e-9, 1e-8].map(beside));
    let [fixed, moving] = parts(file);
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    assert!((1e-9..4e-9).contains(&space.resolution()));
}

#[test]
fn pocket_in_narrow_bands() {
    let theta = -2.5132740012064794;
    classified(
        "tests/regression/pocket_in_narrow_bands.toml",
        &[(6.457167633145068e-8, -2.7912508543102955e-7, theta)],
    );
}

/// A piece of contact that has free space in its middle only is none.
#[test]
fn line_tangent_to_a_pocket() {
    let [fixed, moving] = parts("tests/regression/line_tangent_to_a_pocket.toml");
    for window in [None, Some((-0.02, 0.02))] {
        let options = Options {
            window,
            ..Options::default()
        };
        let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
        for theta in [-0.01, 0.0, 0.013] {
            let slice = space.slice(theta);
            assert_eq!(slice.loops.len(), 2, "{window:?} {theta}");
            let n = slice.curves.len() as u32;
            assert!(
                slice.curves.iter().all(|c| c.next < n),
                "{window:?} {theta}"
            );
        }
    }
}

/// A shell of a slice in which a tie joins free and blocked curves is tested where it lies furthest out, too.
#[test]
fn blocked_and_free_curves_in_one_shell() {
    let [fixed, moving] = parts("tests/regression/blocked_and_free_curves_in_one_shell.toml");
    let slicer = Slicer::new(&fixed, &moving);
    for beside in [0.0, 1e-10, 1e-9, 1e-8] {
        let slice = slicer.slice(core::f64::consts::FRAC_PI_4 + beside);
        assert_eq!(slice.loops.len(), 2, "{beside}");
        assert_eq!(slice.curves.len(), 39, "{beside}");
    }
}

#[test]
fn tiny_part_whose_joint_is_on_a_side() {
    classified(
        "tests/regression/tiny_part_whose_joint_is_on_a_side.toml",
        &[(
            -1.9999434342889517,
            -1.9999999971766882,
            core::f64::consts::FRAC_PI_2,
        )],
    );
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

/// Where the patches lose a pocket, as of re-entrant corners with arcs at a play of 2e-7, the slice says that it is
/// doubtful, and the parts themselves are asked.
#[test]
fn lobes_in_their_negative_of_play_2e_7() {
    let [fixed, moving] = parts("tests/regression/lobes_in_their_negative_of_play_2e-7.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let at = Configuration::default();
    let slice = space.slice(at.theta);
    assert!(slice.doubtful || slice.is_free(at.position()));
    assert_eq!(space.classify(at), Some(Classification::Free));
    let scratch = Slicer::new(&fixed, &moving).slice(at.theta);
    assert!(!scratch.doubtful && scratch.is_free(at.position()));
}

/// Half circles of one centre: contacts of two pairs of them are one curve. Slices that are open there are doubtful, and the
/// parts themselves are asked.
#[test]
fn spiral_with_itself() {
    let [fixed, moving] = parts("tests/regression/spiral_with_itself.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    let oracle = Oracle::new(&fixed, &moving);
    for k in 0..360 {
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

/// Coordinates with seven digits: sides and arcs that were tangent meet at some 1e-7 rad, of either sign.
#[test]
fn drawings_rounded_to_seven_digits() {
    for (name, at) in [
        ("slot_rounded_to_7_digits", (1.388, -1.020, 1.294)),
        ("slot_rounded_to_7_digits", (1.150, -0.669, 1.535)),
        ("ring_with_round_ends_rounded", (-0.285, -2.233, 0.158)),
        ("ring_with_round_ends_rounded", (0.66, 1.2064, 1.1916)),
    ] {
        let parts = parts(&format!("tests/regression/{name}.json"));
        let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
        let at = Configuration::new(at.0, at.1, at.2);
        assert_eq!(
            space.classify(at),
            Some(Classification::Blocked),
            "{name}: {at:?}"
        );
        assert_closed(&parts);
        assert_eq!(wrong(&parts), [], "{name}");
    }
}

/// The joints of a disc that slides towards a disc's pivot are always where they touch.
#[test]
fn discs_on_their_pivots_and_rollers_in_line() {
    let pair = OnAxes::read("disc_on_its_pivot_and_roller.json");
    pair.assert_right(&[(-1.5, 0.5), (-2.0, 1.2)]);
    assert_eq!(pair.space.regions().len(), 2);
    assert_eq!(pair.space.statistics().conflicts, 0);
    OnAxes::read("hub_and_roller_in_line.json").assert_right(&[(-3.1, -20.204)]);
}

#[test]
fn l_with_its_corner_on_the_pivot() {
    let pair = OnAxes::read("l_with_its_corner_on_the_pivot.json");
    pair.assert_right(&[(0.05, 0.7), (0.1, 0.7), (0.1, 2.5)]);
}

/// A side of the slider, carried on, goes through the pivot of an arc that turns about its own centre.
#[test]
fn bar_in_line_with_a_pivot() {
    let pair = OnAxes::read("bar_in_line_with_a_pivot.toml");
    pair.assert_right(&[(1.77, 2.65), (-0.186, -1.52)]);
    assert_eq!(pair.space.regions().len(), 2);
}

#[test]
fn tappet_in_line_with_a_pivot() {
    let pair = OnAxes::read("tappet_in_line_with_a_pivot.toml");
    pair.assert_right(&[(0.7, -2.24), (-2.92, -1.7)]);
    assert_eq!(pair.space.regions().len(), 2);
}

#[test]
fn gear_under_a_block_in_line_with_its_pivot() {
    let pair = OnAxes::read("gear_under_a_block_in_line_with_its_pivot.json");
    pair.assert_right(&[(0.7, -5.0)]);
}

/// What slides goes with a joint exactly through the pivot, which is on the boundary of what turns.
#[test]
fn pivot_on_the_turning_part() {
    OnAxes::read("pivot_on_the_turning_part.toml").assert_right(&[(-2.49, 2.33)]);
}

/// The part without a range follows the other as far as that goes.
#[test]
fn parallel_slides_one_with_a_range() {
    let pair = OnAxes::read("parallel_slides_one_with_a_range.toml");
    pair.assert_right(&[(-2.92, -1.92), (-2.5, -2.0)]);
}

/// Where the partition contradicts itself both parts are moved a hair; their slides were tilted apart then, and met
/// a hundred million sizes away.
#[test]
fn stars_along_one_line() {
    let pair = OnAxes::read("axes_stars_along_one_line.toml");
    assert!(pair.space.resolution() < 1e-6);
    pair.assert_right(&[(-2.76, -5.29), (0.0, 2.5), (5.0, 7.2), (0.0, 1.0)]);
}

/// Sides drawn with sines and cosines, parallel to a direction of motion but for the last bit.
#[test]
fn upright_to_the_last_bit() {
    OnAxes::read("upright_to_the_last_bit.json").assert_right(&[(-2.99, 2.23)]);
}

/// The range of one part ends near the cut of the other's period.
#[test]
fn range_that_ends_near_the_cut() {
    let pair = OnAxes::read("range_that_ends_near_the_cut.toml");
    pair.assert_right(&[(0.4, 0.05), (0.4, 0.03)]);
}

/// From the middle of a side a ray goes through the joint of two arcs, and beyond them the parts overlap.
#[test]
fn pockets_across_a_joint() {
    for (name, x, y, theta) in [
        ("pocket_across_a_joint", -0.788, 1.2417, -1.1817127444282312),
        (
            "pocket_across_a_joint_aslant",
            2.471,
            -3.547,
            -2.432904753691291,
        ),
    ] {
        let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
        let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
        let scratch = Slicer::new(&fixed, &moving).slice(theta);
        for slice in [space.slice(theta), scratch] {
            assert_eq!(slice.loops.len(), 2, "{name}");
            assert!(slice.is_free(Point::new(x, y)), "{name}");
        }
    }
}

/// Configurations near contact that are classified wrongly, of those that are certain, and how many there are of these.
fn misclassified([fixed, moving]: &[Part; 2], window: (f64, f64)) -> (Vec<Configuration>, usize) {
    let options = Options {
        window: Some(window),
        ..Options::default()
    };
    let space = ContactSpace::compute(fixed, moving, &options).unwrap();
    let oracle = Oracle::new(fixed, moving);
    let least = space.resolution().max(1e-10 * oracle.size());
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut certain = 0;
    let wrong = (near_contact(&oracle, &mut rng, 10_000).into_iter())
        .filter_map(|near| {
            let mut c = near.configuration;
            c.theta = window.0 + (window.1 - window.0) * (c.theta / TAU).rem_euclid(1.0);
            let verdict = oracle.judge(c);
            let told = space.classify(c);
            certain += usize::from(verdict.margin > least);
            let right = if verdict.overlap {
                Classification::Blocked
            } else {
                Classification::Free
            };
            (verdict.margin > least && told != Some(right)).then_some(c)
        })
        .collect();
    (wrong, certain)
}

/// Two contacts lie on one circle: a ring, open on one side, leaves as much room inside as a closed one outside, which
/// touches where the other is open.
#[test]
fn equal_room_inside_and_outside() {
    let parts = parts("tests/regression/equal_room_inside_and_outside.toml");
    let (wrong, certain) = misclassified(&parts, (-PI, PI));
    assert_eq!(wrong, []);
    assert!(certain > 5000, "{certain}");
    // Beyond the circle, where the inner ring is open.
    let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
    assert_eq!(space.free_regions().len(), 2);
    for angle in 0..360 {
        let out = Vector::from_angle(f64::from(angle).to_radians());
        for theta in [0.0, 1.0, -2.0] {
            let at = |r: f64| Configuration::new(r * out.x, r * out.y, theta);
            let told = [0.19999, 0.20001].map(|r| space.classify(at(r)));
            let expected = [Classification::Free, Classification::Blocked];
            assert_eq!(told, expected.map(Some), "{angle} {theta}");
        }
    }
}

/// The same within one loop of each part: nothing separates the contacts, and slices say so.
#[test]
fn tongue_with_equal_room_on_both_sides() {
    let parts = parts("tests/regression/tongue_with_equal_room_on_both_sides.toml");
    let (wrong, certain) = misclassified(&parts, (-0.2, 0.2));
    assert_eq!(wrong, []);
    assert!(certain > 5000, "{certain}");
    let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
    let slicer = Slicer::new(&parts[0], &parts[1]);
    for (theta, doubtful) in [(0.1, true), (-0.05, true), (0.5, false)] {
        assert_eq!(space.slice(theta).doubtful, doubtful, "{theta}");
        assert_eq!(slicer.slice(theta).doubtful, doubtful, "{theta}");
    }
}

/// Where the contact of one ring ends, that of another goes on along the same circle.
#[test]
fn open_rings_of_equal_room() {
    let parts = parts("tests/regression/open_rings_of_equal_room.toml");
    let (wrong, certain) = misclassified(&parts, (-0.3, 0.3));
    assert_eq!(wrong, []);
    assert!(certain > 5000, "{certain}");
    let at = Configuration::new(0.0039, 0.01, -0.262);
    let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
    assert_eq!(space.classify(at), Some(Classification::Free));
}

/// Two sides that face each other, one of them of a very flat arc, pass each other at less than 1e-11 rad.
#[test]
fn bowed_boxes() {
    for (name, room, turns, regions) in [
        ("bowed_box_in_its_own_hole", 6e-5, 2e-4, 2),
        ("bowed_box_in_a_hole_of_flat_arcs", 6e-5, 2e-4, 2),
        ("bowed_box_with_room", 6e-3, 1e-2, 3),
        ("box_of_flat_arcs_in_a_hole", 6e-5, 1e-4, 3),
    ] {
        let parts = parts(&format!("tests/regression/{name}.toml"));
        let space = ContactSpace::compute(&parts[0], &parts[1], &Options::default()).unwrap();
        assert_eq!(space.free_regions().len(), regions, "{name}");
        let oracle = Oracle::new(&parts[0], &parts[1]);
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut free = 0;
        for _ in 0..3000 {
            let mut within = |w: f64| rng.random_range(-w..w);
            let c = Configuration::new(within(room), within(room), within(turns));
            let verdict = oracle.judge(c);
            if verdict.margin > 1e-9 {
                let expected = if verdict.overlap {
                    Classification::Blocked
                } else {
                    Classification::Free
                };
                assert_eq!(space.classify(c), Some(expected), "{name} {c:?}");
                free += usize::from(!verdict.overlap);
            }
        }
        assert!(free > 300, "{name}: {free}");
    }
}

/// Two pieces of play 1e-5, far from each other: free for less than 1e-5 rad.
#[test]
fn two_bowed_pieces() {
    for (name, at) in [
        (
            "two_bowed_trapezoids",
            Configuration::new(0.0, -3.824_173_934_7e-6, -0.299_996_200_5),
        ),
        ("two_bowed_tees", Configuration::new(0.0, 0.0, 0.0)),
    ] {
        let [fixed, moving] = parts(&format!("tests/regression/{name}.toml"));
        let options = Options {
            window: Some((at.theta - 3e-5, at.theta + 3e-5)),
            ..Options::default()
        };
        let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
        assert_eq!(space.classify(at), Some(Classification::Free), "{name}");
    }
}

/// Where doubles put a curve of the slice at a place at which the parts overlap by 4e-8.
#[test]
fn contact_where_parts_overlap() {
    let [fixed, moving] = parts("tests/regression/contact_of_a_doubtful_slice.toml");
    let options = Options {
        window: Some((0.0, 0.05)),
        ..Options::default()
    };
    let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
    let at = Configuration::new(-2.5, -0.000_100_000_121_162_480_59, 0.0);
    assert_eq!(space.classify(at), Some(Classification::Blocked));
}

/// Sides that are bowed by a millionth and less, their ends on pivots or passing them: told by their centres, a million sizes
/// away, whole contacts were lost, and regions with them.
#[test]
fn flat_sides_and_pivots() {
    let pairs: [(&str, &[(f64, f64)]); 6] = [
        ("two_flat_sides_at_a_pivot", &[(0.2958, 1.0), (0.51, 1.0)]),
        (
            "corner_on_its_pivot_along_a_flat_side",
            &[(0.04992, -0.3448), (0.0499, 0.5)],
        ),
        ("flat_sides_about_one_pivot", &[(7.5296, 0.9676)]),
        ("flat_side_along_a_far_corner", &[(4.8125, -19.4356)]),
        ("flat_sides_at_both_pivots", &[(6.15727, -1.047)]),
        (
            "flat_side_along_its_slide",
            &[(0.086372, -0.869), (0.086373, -0.3)],
        ),
    ];
    for (name, places) in pairs {
        let pair = OnAxes::read(&format!("axes_{name}.toml"));
        assert!(pair.space.resolution() < 1e-7, "{name}");
        // Brute force is certain of half of them where much is on one line.
        let certain = pair.certainly_right(places);
        assert!(certain > 400, "{name}: {certain} certain");
        assert_eq!(pair.space.statistics().conflicts, 0, "{name}");
    }
}
