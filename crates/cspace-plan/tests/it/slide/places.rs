//! Where parts are dragged, and where they come to: the model, and the places, are those where parts stuck once.

use cspace::{Classification, PairSpace};
use cspace_plan::slide::{Slider, advance, slide};

use crate::slide::models::{read, space, space_of};
use crate::slide::weighted::Weighted;
use crate::slide::{at, planar};

#[test]
fn a_peg_goes_to_the_seat_along_both_walls_of_its_hole() {
    let space = space("peg_hole.toml");
    let slider = Slider::new(&space);
    let mut began = 0;
    for theta in [0.0, 0.001, -0.002, 0.003, 0.005] {
        for x in [-0.1, -0.05, 0.03, 0.05, 0.1] {
            let mut c = at(x, 18.5, theta);
            if space.classify(c).unwrap() != Classification::Free {
                continue;
            }
            began += 1;
            for k in 1..=30 {
                c = slider
                    .slide(c, at(x, 18.5 - 0.7 * f64::from(k), theta))
                    .unwrap()
                    .at;
            }
            let y = planar(c).y;
            assert!(
                y.abs() < 1e-3,
                "from x = {x}, θ = {theta} the peg comes to {c:?}"
            );
        }
    }
    assert!(began > 10);
}

#[test]
fn a_seated_peg_that_is_dragged_up_comes_out_whichever_way_it_drifts() {
    let space = space("peg_hole.toml");
    let slider = Slider::new(&space);
    for turns in [false, true] {
        for drift in [
            -20.0, -3.0, -1.0, -0.3, -0.05, 0.0, 0.05, 0.3, 1.0, 3.0, 20.0,
        ] {
            let mut c = at(0.0, 0.0, 0.0);
            for k in 1..=20 {
                let k = f64::from(k);
                let theta = if turns { planar(c).theta } else { 0.0 };
                c = slider
                    .slide(c, at(drift * k / 20.0, 0.75 * k, theta))
                    .unwrap()
                    .at;
                assert!(
                    planar(c).y > 0.75 * k - 1e-2,
                    "drifting by {drift} it is at {c:?} after {k} moves"
                );
            }
        }
    }
}

/// A slot 2 wide and 6 deep, and a peg 1.8 wide: its end is the origin, and its centre is far from it.
const SLOT: &str = r#"
name = "slot"
unit = "mm"
[[part]]
name = "block"
loops = [[[-6, 0], [-1, 0], [-1, -6], [1, -6], [1, 0], [6, 0], [6, -10], [-6, -10]]]
[[part]]
name = "peg"
loops = [[[-0.9, 0], [0.9, 0], [0.9, 16], [-0.9, 16]]]
[[pair]]
fixed = "block"
moving = "peg"
theta = ["-20deg", "20deg"]
"#;

#[test]
fn a_peg_that_is_dragged_into_a_slot_comes_to_where_it_is_dragged_and_not_past_it() {
    let space = space_of(&read(SLOT), 0);
    let slider = Slider::new(&space);
    for follows in [false, true] {
        for x in [-0.2, -0.05, 0.0, 0.05, 0.2] {
            let mut c = at(0.0, 2.0, 0.1);
            for k in 1..=25 {
                let k = f64::from(k.min(20));
                let theta = if follows { planar(c).theta } else { 0.0 };
                let goal = at(x * k / 20.0, 2.0 - 7.5 * k / 20.0, theta);
                c = slider.slide(c, goal).unwrap().at;
            }
            // Aslant it is nearest to the goal a little above: its end and its centre are not wanted at the same height.
            assert!(
                (planar(c).y + 5.5).abs() < 5e-2,
                "dragged to x = {x} it is at {c:?}"
            );
        }
    }
}

#[test]
fn no_motion_leads_on_from_where_free_space_ends_with_the_contacts_last_orientation() {
    let space = space("woodpecker.toml");
    let from = at(
        -5.902403010793478e-10,
        -191.72610898199846,
        -0.10090092466986937,
    );
    let to = at(14.458785622461338, -187.38461066126945, -2.551010188177715);
    let (a, b) = (planar(from), planar(to));
    let middle = at(
        0.5 * (a.x + b.x),
        0.5 * (a.y + b.y),
        0.5 * (a.theta + b.theta),
    );
    assert_eq!(space.classify(middle).unwrap(), Classification::Blocked);
    let moved = advance(&space, from, to).unwrap();
    assert!(moved.stopped.is_some());
    assert!((planar(moved.at).theta - a.theta).abs() < 1e-6, "{moved:?}");
}

type Place = (&'static str, &'static str, [f64; 3], [f64; 3]);

/// Why parts stuck, the model, where they are, and where they are dragged.
const PLACES: [Place; 6] = [
    (
        "contacts that are tangent part from there on",
        "paper/tibia_femur.toml",
        [0.0, 0.0, 0.0],
        [-4.112733816545131, -120.23114144914875, -3.0497707724275527],
    ),
    (
        "a second contact is all but come to",
        "fixture_plate.toml",
        [54.50849445161337, 52.60416873526535, -2.896024027964216],
        [52.469827503252844, -97.78439262953671, -2.896024027964216],
    ),
    (
        "a second contact is all but come to, across the first",
        "paper/film_advance.toml",
        [33.45325665448284, 9.042019657675096, 0.8021779454187049],
        [26.02987124628295, 37.717730513952766, 1.6997875565296994],
    ),
    (
        "the lift off a curved surface is stopped from above",
        "paper/fixture.toml",
        [0.0, 0.0, 0.0],
        [134.97103415420895, 16.506326595579438, -0.33983063183468154],
    ),
    (
        "the lift off a curved surface is stopped from above",
        "paper/blocks.toml",
        [0.0, 0.0, 0.0],
        [49.43096752877977, 54.005445610993306, -2.4243809460653147],
    ),
    (
        "a surface that is all but tangent to another rises above it",
        "paper/geneva.toml",
        [-36.22342986751883, -42.71225125911961, 0.8978422045852895],
        [18.33453787099279, -66.67310234693451, 1.9611431510621253],
    ),
];

fn leaves(space: &PairSpace, from: [f64; 3], goal: [f64; 3]) -> Result<(), String> {
    let weighted = Weighted::new(space);
    let [from, goal] = [from, goal].map(|[x, y, theta]| at(x, y, theta));
    let end = slide(space, from, goal).unwrap().at;
    let nearer = weighted.apart(from, goal) - weighted.apart(end, goal);
    if nearer > 0.01 {
        return Ok(());
    }
    Err(format!("it comes nearer by {nearer} and stays at {end:?}"))
}

#[test]
fn a_part_leaves_places_where_contacts_all_but_meet() {
    let mut stuck = Vec::new();
    for (why, model, from, goal) in PLACES {
        if let Err(told) = leaves(&space(model), from, goal) {
            stuck.push(format!("{model}: {why}: {told}"));
        }
    }
    assert!(stuck.is_empty(), "{stuck:#?}");
}
