//! Saved spaces that were changed so that they lie are computed again: no answer comes from the lie.

use cspace::{
    Axis, Configuration, ContactSpace, FixedAxesSpace, Options, PairSpace, Part, Point, Symmetry,
    Vertex,
};
use cspace_model::saved;
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

fn square(r: f64) -> Vec<Vertex> {
    [(-r, -r), (r, -r), (r, r), (-r, r)]
        .map(|(x, y)| Vertex::line(x, y))
        .to_vec()
}

/// A block in a ring: two regions.
fn ring_and_block(window: Option<(f64, f64)>) -> ContactSpace {
    let ring = Part::new("ring", vec![square(3.0), square(2.0)]).unwrap();
    let block = Part::rectangle("block", (0.1, 0.0), 1.5, 1.0).unwrap();
    let options = Options {
        window,
        symmetry: Symmetry::Ignore,
    };
    ContactSpace::compute(&ring, &block, &options).unwrap()
}

fn value(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Checks that both spaces have the same patches, links and regions.
fn assert_same(a: &ContactSpace, b: &ContactSpace) {
    assert_eq!(a.patches(), b.patches());
    assert_eq!(a.side_links(), b.side_links());
    assert_eq!(a.vertical_links(), b.vertical_links());
    assert_eq!(a.free_regions(), b.free_regions());
    assert_eq!(a.critical_orientations(), b.critical_orientations());
    assert_eq!(a.doubtful_orientations(), b.doubtful_orientations());
}

/// All data but the parts and the options are changed at random, with and without the checksum.
#[test]
fn no_answer_comes_from_a_lie() {
    for window in [None, Some((-0.4, 1.0))] {
        let space = ring_and_block(window);
        let good = value(&saved::to_json(&space));
        let (mut numbers, mut lists) = (Vec::new(), Vec::new());
        collect(&good, String::new(), &mut numbers, &mut lists);
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let mut read = 0;
        for k in 0..60 {
            let mut bad = good.clone();
            for _ in 0..rng.random_range(1..3) {
                if rng.random_bool(0.5) {
                    let at = numbers.choose(&mut rng).unwrap();
                    // A list before it may have become shorter.
                    let Some(number) = bad.pointer_mut(at) else {
                        continue;
                    };
                    *number = match number.as_u64() {
                        Some(n) => json!(n + rng.random_range(0..3) - n.min(1)),
                        None => json!(
                            number.as_f64().unwrap() * (1.0 + 10f64.powi(-rng.random_range(1..14)))
                        ),
                    };
                } else {
                    let at = lists.choose(&mut rng).unwrap();
                    let Some(list) = bad.pointer_mut(at).and_then(Value::as_array_mut) else {
                        continue;
                    };
                    match (rng.random_range(0..4), list.len()) {
                        (0, _) => list.clear(),
                        (_, 0) => {}
                        (1, n) => drop(list.remove(rng.random_range(0..n))),
                        (2, n) => list.swap(0, n - 1),
                        (_, n) => list.truncate(n / 2),
                    }
                }
            }
            if k % 3 == 0 {
                bad.as_object_mut().unwrap().remove("checksum");
            }
            if let Ok(again) = saved::from_json(&bad.to_string(), "space.json") {
                assert_same(&again, &space);
                read += 1;
            }
        }
        assert!(read > 10, "{read}");
    }
}

/// A space without patches, which would be free everywhere.
#[test]
fn a_space_without_patches_is_computed_again() {
    let space = ring_and_block(None);
    let mut bad = value(&saved::to_json(&space));
    for list in [
        "patches",
        "side_links",
        "vertical_links",
        "critical_orientations",
    ] {
        bad[list] = json!([]);
    }
    bad["free_regions"].as_array_mut().unwrap().truncate(1);
    bad["free_regions"][0]["patches"] = json!(0);
    for checksum in [bad["checksum"].clone(), Value::Null, json!("0")] {
        bad["checksum"] = checksum;
        let again = saved::from_json(&bad.to_string(), "space.json").unwrap();
        assert_same(&again, &space);
    }
}

/// Roots of a partition, and what is free in it.
#[test]
fn fixed_axes_are_computed_again() {
    let gear = Part::new(
        "gear",
        vec![vec![
            Vertex::line(-2.0, -0.5),
            Vertex::line(2.0, -0.5),
            Vertex::new(2.0, 0.5, 0.2),
            Vertex::line(-2.0, 0.5),
        ]],
    )
    .unwrap();
    let turning = Axis::revolute(Point::new(0.0, 0.0));
    let other = Axis::revolute(Point::new(2.5, 0.0));
    let moved = Part::rectangle("bar", (2.5, 0.0), 2.0, 0.6).unwrap();
    let space = FixedAxesSpace::compute(&gear, turning, &moved, other).unwrap();
    let saved = PairSpace::FixedAxes(Box::new(space));
    let text = saved::pair_to_json(&saved);
    let PairSpace::FixedAxes(space) = &saved else {
        unreachable!();
    };
    let mut rng = ChaCha8Rng::seed_from_u64(12);
    for list in [
        "free",
        "cells",
        "pieces",
        "gaps",
        "regions",
        "patches",
        "free_regions",
    ] {
        let mut bad = value(&text);
        let of = bad[list].as_array_mut().unwrap();
        let n = of.len();
        of.swap(0, n - 1);
        if of[0].is_boolean() {
            of.reverse();
        }
        let Ok(PairSpace::FixedAxes(again)) = saved::pair_from_json(&bad.to_string(), "s.json")
        else {
            continue;
        };
        assert_eq!(again.patches(), space.patches(), "{list}");
        for _ in 0..200 {
            let (u, v) = (rng.random_range(-3.0..3.0), rng.random_range(-3.0..3.0));
            assert_eq!(again.classify(u, v), space.classify(u, v), "{list}");
        }
    }
}

/// If only white space, order and labels are changed, nothing is computed again: the seconds are those of the file.
#[test]
fn what_says_the_same_is_taken_as_it_is() {
    let space = ring_and_block(None);
    let mut same = value(&saved::to_json(&space));
    same["name"] = json!("renamed");
    same["unit"] = json!("mm");
    let again = saved::from_json(&same.to_string(), "space.json").unwrap();
    assert_eq!(again.data(), space.data());
    assert_eq!(
        again.classify(Configuration::default()),
        space.classify(Configuration::default())
    );
}

/// Paths of numbers and of lists, except those of the parts, of the window and of the requested symmetry.
fn collect(value: &Value, at: String, numbers: &mut Vec<String>, lists: &mut Vec<String>) {
    if ["/fixed", "/moving", "/window", "/symmetry"].contains(&at.as_str()) {
        return;
    }
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                collect(value, format!("{at}/{key}"), numbers, lists);
            }
        }
        Value::Array(list) => {
            for (i, value) in list.iter().enumerate() {
                collect(value, format!("{at}/{i}"), numbers, lists);
            }
            lists.push(at);
        }
        Value::Number(_) => numbers.push(at),
        _ => {}
    }
}
