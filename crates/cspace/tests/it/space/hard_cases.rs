//! Cases that are known to be hard, each with properties known by reasoning.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{ContactSpace, Options, Point};
use cspace_oracle::{Oracle, near_contact_about, pair};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

struct Expected {
    name: &'static str,
    /// Number of regions, including the unbounded one.
    regions: usize,
    free: &'static [(f64, f64, f64)],
    blocked: &'static [(f64, f64, f64)],
}

fn check(expected: &Expected) -> ContactSpace {
    let pair = pair(expected.name);
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
    let name = expected.name;
    assert_eq!(space.free_regions().len(), expected.regions, "{name}");
    for (list, free) in [(expected.free, true), (expected.blocked, false)] {
        for &(x, y, theta) in list {
            let found = space.slice(theta).is_free(Point::new(x, y));
            assert_eq!(found, free, "{name} at {x} {y} {theta}");
        }
    }
    let oracle = Oracle::new(&pair.fixed, &pair.moving);
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for near in near_contact_about(&oracle, &pair.notable, &mut rng, 40) {
        if near.verdict.margin > 1e-10 * oracle.size() {
            let c = near.configuration;
            let found = space.slice(c.theta).is_free(c.position());
            assert_eq!(found, near.free, "{name}: {near:?}");
        }
    }
    space
}

fn has_critical(space: &ContactSpace, theta: f64) -> bool {
    space
        .critical_orientations()
        .iter()
        .any(|t| (t - theta).abs() < 1e-9)
}

macro_rules! case {
    ($test:ident, $name:literal, $regions:literal, free $free:expr, blocked $blocked:expr) => {
        #[test]
        fn $test() {
            check(&Expected {
                name: $name,
                regions: $regions,
                free: $free,
                blocked: $blocked,
            });
        }
    };
}

// A side of 2 in a hole of 2 leaves no free space, at any orientation.
case!(
    square_fills_its_hole,
    "square in its square hole",
    1,
    free & [(3.1, 0.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0), (0.0, 0.0, FRAC_PI_2)]
);
// Its diagonal of 2.55 does not pass: four separate quarter turns.
case!(
    square_in_larger_hole,
    "square in a larger hole",
    5,
    free & [(0.09, 0.09, 0.0), (0.0, 0.0, FRAC_PI_2)],
    blocked & [(0.0, 0.0, 0.785), (0.11, 0.0, 0.0)]
);
case!(
    peg_without_clearance,
    "peg in hole, no clearance",
    1,
    free & [(0.0, 3.1, 0.0)],
    blocked & [(0.0, 2.0, 0.0)]
);
case!(
    peg_with_clearance_of_a_thousandth,
    "peg in hole, clearance 1e-3",
    1,
    free & [(0.0, 2.0, 0.0), (4.9e-4, 2.0, 0.0)],
    blocked & [(5.1e-4, 2.0, 0.0)]
);
case!(
    peg_with_clearance_of_a_millionth,
    "peg in hole, clearance 1e-6",
    1,
    free & [(0.0, 2.0, 0.0), (4.9e-7, 2.0, 0.0)],
    blocked & [(5.1e-7, 2.0, 0.0), (0.0, 2.0, 1e-5)]
);
case!(
    rounded_peg,
    "rounded peg in hole",
    1,
    free & [(0.0, 1.5, 0.0)],
    blocked & [(0.0, 0.9, 0.0)]
);
case!(
    pin_in_socket,
    "pin in socket of equal radius",
    1,
    free & [(0.0, 1e-3, 0.3)],
    blocked & [(0.0, -1e-6, 0.3), (1e-4, 1e-9, 0.0)]
);
case!(
    disc_fills_annulus,
    "disc in annulus of equal radius",
    1,
    free & [(3.1, 0.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0), (1e-6, 0.0, 0.0)]
);
// The hole has a radius of 1.5, the disc one of 1.
case!(
    disc_in_annulus,
    "disc in annulus",
    2,
    free & [(0.0, 0.0, 0.0), (0.499, 0.0, 1.0)],
    blocked & [(0.501, 0.0, 1.0), (2.9, 0.0, 0.0)]
);
case!(
    ball_caged,
    "ball caged in a C",
    2,
    free & [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0)],
    blocked & [(1.0, 0.0, 0.0)]
);
case!(
    ball_leaves,
    "ball free to leave a C",
    1,
    free & [(0.0, 0.0, 0.0), (1.2, 0.0, 0.0)],
    blocked & [(-1.2, 0.0, 0.0)]
);
case!(
    disc_in_maze,
    "disc in maze",
    1,
    free & [(1.5, 5.0, 0.0), (7.5, 2.5, 0.0)],
    blocked & [(1.4, 5.0, 0.0)]
);
case!(
    bar_in_maze,
    "bar in maze",
    1,
    free & [(7.5, 2.5, 1.0)],
    blocked & [(0.5, 5.0, 0.0)]
);
case!(
    lens_and_crescent,
    "lens and crescent",
    1,
    free & [(5.0, 0.0, 0.0)],
    blocked & []
);
case!(
    equal_crescents,
    "crescents of equal arcs",
    1,
    free & [(5.0, 0.0, 0.0)],
    blocked & []
);
case!(
    half_discs,
    "half discs",
    1,
    free & [(0.0, -1e-6, PI)],
    blocked & [(0.0, 1e-6, PI)]
);
case!(
    nearly_full_arcs,
    "nearly full arcs",
    1,
    free & [(1.9, 0.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0)]
);
case!(
    collinear_tips,
    "racks",
    1,
    free & [(0.0, 3.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0)]
);
case!(
    tips_on_one_circle,
    "gears 10 and 9",
    1,
    free & [(11.6, 0.0, 0.0)],
    blocked & [(5.0, 0.0, 0.0)]
);
// Half a turn moves the pegs into the same holes: two pockets, each through the orientation at which all three circles coincide.
case!(
    three_pegs,
    "three pegs in three holes",
    3,
    free & [
        (0.0, 0.0, 0.0),
        (0.0, 0.0, PI),
        (0.0, 0.0, -1e-6),
        (0.049, 0.0, 0.0)
    ],
    blocked & [(0.051, 0.0, 0.0), (0.0, 0.051, 1e-9), (0.0, 0.051, -1e-9)]
);
case!(
    three_pegs_that_fill,
    "three pegs that fill three holes",
    1,
    free & [(9.0, 0.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0)]
);
case!(
    squares_far_away,
    "squares drawn far away",
    1,
    free & [(1.6, 0.0, 0.0)],
    blocked & [(0.0, 0.0, 0.0)]
);
case!(
    parts_of_a_millionth,
    "gears 1e-6 in module",
    1,
    free & [(11.6e-6, 0.0, 0.0)],
    blocked & [(5e-6, 0.0, 0.0)]
);

#[test]
fn squares_are_critical_at_quarter_turns_alone() {
    let pair = pair("squares");
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
    assert_eq!(space.critical_orientations().len(), 4);
    for theta in [-PI, -FRAC_PI_2, 0.0, FRAC_PI_2] {
        assert!(has_critical(&space, theta), "{theta}");
    }
}

#[test]
fn discs_have_one_band_and_two_patches_or_more() {
    let pair = pair("discs");
    let space = ContactSpace::compute(&pair.fixed, &pair.moving, &Options::default()).unwrap();
    let slice = space.slice(0.3);
    assert_eq!(slice.loops.len(), 1);
    let length: f64 = slice.curves.iter().map(|c| c.geometry.length()).sum();
    assert!((length - 3.4 * PI).abs() < 1e-9, "{length}");
}
