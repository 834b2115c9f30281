//! Mechanisms moved by hand: brute force judges where parts are after every drag.

use std::f64::consts::TAU;

use cspace::{Configuration, Part, Point};
use cspace_model::{Mechanism, PartEntry, PartPosition};
use cspace_motion::{Dragged, Ending, Hand, PartCoordinates, SimulateError, Target, What};
use cspace_oracle::Oracle;

use crate::motion::helpers::{keyed, mechanism, model, near, read};

/// Checks that no two parts overlap by more than the resolution.
#[track_caller]
fn judge(hand: &Hand, mechanism: &Mechanism) {
    let system = hand.system();
    for pair in &mechanism.pairs {
        let [a, b] = [pair.fixed, pair.moving].map(|i| &mechanism.parts[i].part);
        let joined = |j: &cspace_model::JointEntry| {
            j.parts == (pair.fixed, pair.moving) || j.parts == (pair.moving, pair.fixed)
        };
        if mechanism.joints.iter().any(joined) {
            continue;
        }
        let at = system.relative(pair.fixed, pair.moving, hand.state());
        let verdict = Oracle::new(a, b).judge(at);
        let allowed = 1e-9 * a.size().max(b.size());
        assert!(
            !verdict.overlap || verdict.margin < allowed,
            "{} and {} overlap by {:e} at {:?}",
            a.name(),
            b.name(),
            verdict.margin,
            hand.state()
        );
    }
}

/// Drags a part on an axis in even steps.
#[track_caller]
fn turn(hand: &mut Hand, model: &Mechanism, part: usize, by: f64, steps: u32) -> Vec<Dragged> {
    let at = hand.system().parts()[part].indices().start;
    let from = hand.state()[at];
    let one = |k: u32| {
        let to = from + by * f64::from(k) / f64::from(steps);
        let dragged = hand.drag(part, Target::Axis(to)).unwrap();
        judge(hand, model);
        assert_eq!(dragged.way.last().unwrap(), hand.state());
        dragged
    };
    (1..=steps).map(one).collect()
}

#[test]
fn a_driver_leads_its_wheel_around_and_back() {
    let geneva = model("geneva");
    let mut hand = Hand::new(&geneva).unwrap();
    turn(&mut hand, &geneva, 1, TAU, 120);
    let before = hand.state()[0];
    let all = turn(&mut hand, &geneva, 1, TAU, 120);
    assert!(all.iter().all(Dragged::reached));
    let step = (hand.state()[0] - before).to_degrees();
    near("a step of the wheel", step, -60.0, 1e-9);
    let all = turn(&mut hand, &geneva, 1, -TAU, 90);
    assert!(all.iter().all(Dragged::reached));
    let before = hand.state()[0];
    turn(&mut hand, &geneva, 1, -TAU, 90);
    let step = (hand.state()[0] - before).to_degrees();
    near("a step back", step, 60.0, 1e-9);
}

#[test]
fn a_gear_turns_the_other() {
    let gears = model("gears_on_shafts");
    let mut hand = Hand::new(&gears).unwrap();
    turn(&mut hand, &gears, 0, 0.5 * TAU, 60);
    let before = hand.state()[1];
    turn(&mut hand, &gears, 0, TAU, 120);
    near("ratio", (hand.state()[1] - before) / TAU, -1.2, 1e-11);
}

/// Driver, link, pawl and wheel, with springs and joints.
#[test]
fn a_ratchet_advances_by_a_tooth() {
    let ratchet = model("ratchet_mechanism");
    let mut hand = Hand::new(&ratchet).unwrap();
    let driver = ratchet.dynamics.drives[0].part;
    let wheel = hand.system().parts()[4].indices().start;
    turn(&mut hand, &ratchet, driver, TAU, 120);
    let before = hand.state()[wheel];
    let all = turn(&mut hand, &ratchet, driver, TAU, 120);
    assert!(all.iter().all(Dragged::reached));
    let step = (hand.state()[wheel] - before).to_degrees().abs();
    near("a tooth", step, 18.0, 1e-9);
}

/// Between the dwell at R34 and the base circle at R22, drawn 0.1 above the dwell; the spring follows.
#[test]
fn a_tappet_follows_its_cam() {
    let tappet = model("cam_tappet");
    let mut hand = Hand::new(&tappet).unwrap();
    let (mut least, mut most) = (f64::MAX, f64::MIN);
    for _ in 0..144 {
        turn(&mut hand, &tappet, 0, TAU / 144.0, 1);
        least = least.min(hand.state()[1]);
        most = most.max(hand.state()[1]);
    }
    near("the dwell", most, -0.1, 1e-9);
    near("the base circle", least, -12.1, 1e-9);
}

#[test]
fn a_wall_stops_an_arm_at_the_first_contact() {
    let wall = Part::rectangle("wall", (5.0, 0.0), 2.0, 9.0).unwrap();
    let arm = Part::rectangle("arm", (0.0, 3.0), 1.0, 6.0).unwrap();
    let parts = vec![PartEntry::fixed(wall), PartEntry::revolute(arm, (0.0, 0.0))];
    let both = mechanism(parts);
    let mut hand = Hand::new(&both).unwrap();
    // The arm's corner (0.5, 6) comes to x = 4.
    let radius = 6.0_f64.hypot(0.5);
    let turned = (0.5_f64).atan2(6.0) - (4.0 / radius).asin();
    for target in [
        Target::Axis(-1.5),
        Target::Point {
            of: Point::new(0.0, 6.0),
            to: Point::new(9.0, 1.0),
        },
    ] {
        hand.set_state(&[0.0]).unwrap();
        let dragged = hand.drag(1, target).unwrap();
        assert_eq!(dragged.ending, Ending::Stopped);
        near("where it is stopped", hand.state()[0], turned, 1e-9);
        let of_wall = |what: &What| matches!(what, What::Contact { fixed, moving, .. } if fixed == "wall" && moving == "arm");
        assert!(
            !dragged.stopped_by.is_empty() && dragged.stopped_by.iter().all(|s| of_wall(&s.what))
        );
    }
    // It lets go.
    assert!(hand.drag(1, Target::Axis(0.0)).unwrap().reached());
}

/// A slider pushes a block, which pushes another; a third one is beside.
#[test]
fn a_part_that_is_not_pushed_stays_to_the_last_bit() {
    let block = |name: &str, x: f64, y: f64| Part::rectangle(name, (x, y), 2.0, 2.0).unwrap();
    let parts = vec![
        PartEntry::prismatic(block("slider", 0.0, 0.0), (1.0, 0.0)),
        PartEntry::planar(block("first", 3.0, 0.3)),
        PartEntry::planar(block("second", 6.0, 0.1)),
        PartEntry::planar(block("beside", 4.0, 5.0)),
    ];
    let mut blocks = mechanism(parts);
    let beside = Configuration::new(1.0 / 3.0, 0.7_f64.sin(), 0.1);
    blocks.dynamics.part_mut(3).start = Some(PartPosition::Planar(beside));
    let mut hand = Hand::new(&blocks).unwrap();
    let all = turn(&mut hand, &blocks, 0, 5.0, 50);
    assert!(all.iter().all(Dragged::reached));
    let q = hand.state();
    near("first", q[1], 4.0, 1e-9);
    near("second", q[4], 3.0, 1e-9);
    assert_eq!(q[7..], [beside.x, beside.y, beside.theta]);
    let pushed = q[1..].to_vec();
    turn(&mut hand, &blocks, 0, -5.0, 7);
    assert_eq!(hand.state()[1..], pushed);
}

#[test]
fn a_block_slides_along_a_wall() {
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0).unwrap();
    let wall = Part::rectangle("wall", (5.0, 0.0), 2.0, 20.0).unwrap();
    let both = mechanism(vec![PartEntry::fixed(wall), PartEntry::planar(block)]);
    let mut hand = Hand::new(&both).unwrap();
    let mut dragged = None;
    for k in 1..=20 {
        let share = f64::from(k) / 20.0;
        let to = Configuration::new(4.0 * share, 1.5 * share, 0.0);
        dragged = Some(hand.drag(1, Target::Planar(to)).unwrap());
        judge(&hand, &both);
    }
    assert_eq!(dragged.unwrap().ending, Ending::Stopped);
    // As near as it comes: at the wall, and as high as the hand.
    for (found, wanted) in hand.state().iter().zip([3.0, 1.5, 0.0]) {
        near("coordinate", *found, wanted, 1e-9);
    }
}

/// A coupler between two parallel cranks of 8.5, dragged by its middle, which goes around on a circle.
#[test]
fn joints_hold_a_coupler_on_its_circle() {
    let mut text =
        "[[part]]\nname = \"coupler\"\nloops = [ [[-4, 8], [4, 8], [4, 9], [-4, 9]] ]\n".to_owned();
    for x in [-3.0, 3.0] {
        let (a, b) = (x - 0.5, x + 0.5);
        text += &format!(
            "[[part]]\nname = \"crank {x}\"\nmotion = {{ type = \"revolute\", center = [{x}, 0] }}\nloops = [ [[{a}, 0], [{b}, 0], [{x}, 8]] ]\n\
             [[joint]]\nparts = [\"crank {x}\", \"coupler\"]\ntype = \"revolute\"\nat = [{x}, 8.5]\n"
        );
    }
    let mut hand = Hand::new(&read(&text)).unwrap();
    let of = Point::new(0.0, 8.5);
    for (k, (x, y)) in [(0.3, 9.0), (1.0, 12.0), (5.0, 20.0), (-2.0, 5.0)]
        .into_iter()
        .enumerate()
    {
        let to = Point::new(x, y);
        // It is far for one call.
        let mut calls = (0..20).map(|_| hand.drag(0, Target::Point { of, to }).unwrap().ending);
        let ending = calls.find(|ending| *ending != Ending::Unfinished);
        assert_eq!(ending, Some(Ending::Held), "{k}");
        let [px, py] = hand.placement(0).unwrap().point([of.x, of.y]);
        let far = 8.5 / x.hypot(y);
        near("x", px, far * x, 1e-7);
        near("y", py, far * y, 1e-7);
        near("turned", hand.state()[2], 0.0, 1e-11);
    }
}

/// Whatever hand it is, the same drags lead to the same place.
#[test]
fn drags_are_repeated_to_the_last_bit() {
    let ratchet = model("ratchet_mechanism");
    let dragged = || {
        let mut hand = Hand::new(&ratchet).unwrap();
        let all = turn(&mut hand, &ratchet, 1, 1.0, 20);
        (hand.state().to_vec(), all)
    };
    assert_eq!(dragged(), dragged());
}

#[test]
fn parts_that_overlap_are_pulled_apart() {
    let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0).unwrap();
    let wall = Part::rectangle("wall", (1.5, 0.0), 2.0, 6.0).unwrap();
    let both = mechanism(vec![
        PartEntry::fixed(wall),
        PartEntry::prismatic(block, (1.0, 0.0)),
    ]);
    let mut hand = Hand::new(&both).unwrap();
    assert_eq!(hand.overlapping(), [(0, 1)]);
    let dragged = hand.drag(1, Target::Axis(-0.2)).unwrap();
    assert!(dragged.reached());
    assert_eq!(dragged.overlapping, [(0, 1)]);
    let dragged = hand.drag(1, Target::Axis(-2.0)).unwrap();
    assert!(dragged.reached() && dragged.overlapping.is_empty());
    // Now the wall is one.
    let dragged = hand.drag(1, Target::Axis(0.0)).unwrap();
    assert_eq!(dragged.ending, Ending::Stopped);
    near("where it is stopped", hand.state()[0], -0.5, 1e-9);
}

/// It does not overlap: it goes out of the slot and back, and no other way.
#[test]
fn a_key_drawn_in_its_slot_has_room() {
    let keyed = keyed();
    let mut begun_outside = keyed.clone();
    begun_outside.dynamics.part_mut(1).start =
        Some(PartPosition::Planar(Configuration::new(0.0, 20.0, 0.0)));
    for mechanism in [&keyed, &begun_outside] {
        let mut hand = Hand::new(mechanism).unwrap();
        let [gap] = hand.gaps() else {
            panic!("{:?}", hand.gaps())
        };
        assert_eq!(gap.part, "key");
        let told = gap.sentence(mechanism);
        assert!(told.contains("key is smaller"), "{told}");
        let gap = gap.gap;
        assert!(gap > 0.0 && gap < 3e-5, "{gap}");
        hand.set_state(&[0.0; 3]).unwrap();
        for (x, y) in [(7.0, 0.0), (-7.0, -1.0), (0.0, -8.0)] {
            let target = Target::Planar(Configuration::new(x, y, 0.0));
            let dragged = hand.drag(1, target).unwrap();
            assert_eq!(dragged.ending, Ending::Stopped);
            assert!(dragged.overlapping.is_empty());
            let far = hand.state().iter().fold(0.0_f64, |far, u| far.max(u.abs()));
            assert!(far < 1.5 * gap, "{:?}", hand.state());
        }
        for y in [30.0, 0.0] {
            let target = Target::Planar(Configuration::new(0.0, y, 0.0));
            let dragged = hand.drag(1, target).unwrap();
            assert!(dragged.reached() && dragged.overlapping.is_empty());
        }
        // Another hand knows the state for one in which nothing overlaps.
        let mut other = Hand::new(mechanism).unwrap();
        other.set_state(&[0.5 * gap, -0.5 * gap, 0.0]).unwrap();
        assert!(other.overlapping().is_empty());
    }
}

/// Beside a key that fits exactly, one that overlaps is left out of contact until it is apart.
#[test]
fn an_exact_fit_beside_an_overlap() {
    let mut keyed = keyed();
    let cap = Part::rectangle("cap", (0.0, 9.5), 10.0, 10.0).unwrap();
    keyed.parts.push(PartEntry::planar(cap));
    let flush = Part::rectangle("rail", (20.0, -1.0), 10.0, 2.0).unwrap();
    keyed.parts.push(PartEntry::fixed(flush));
    let slider = Part::rectangle("slider", (20.0, 1.0), 2.0, 2.0).unwrap();
    keyed.parts.push(PartEntry::prismatic(slider, (1.0, 0.0)));
    keyed.pairs = keyed.every_two();
    let mut hand = Hand::new(&keyed).unwrap();
    assert_eq!(hand.overlapping(), [(1, 2)]);
    let smaller: Vec<_> = hand.gaps().iter().map(|gap| &*gap.part).collect();
    assert_eq!(smaller, ["key", "slider"]);
    let up = Target::Planar(Configuration::new(0.0, 3.0, 0.0));
    let dragged = hand.drag(2, up).unwrap();
    assert!(dragged.reached() && dragged.overlapping.is_empty());
    assert!(hand.drag(4, Target::Axis(3.0)).unwrap().reached());
    // The key stops the cap, and the slot the key.
    let down = Target::Planar(Configuration::new(0.0, 0.0, 0.0));
    let dragged = hand.drag(2, down).unwrap();
    assert_eq!(dragged.ending, Ending::Stopped);
    assert!((hand.state()[4] - 0.5).abs() < 4.0 * hand.gaps()[0].gap);
}

#[test]
fn what_cannot_be_dragged_is_told() {
    let geneva = model("geneva");
    let mut hand = Hand::new(&geneva).unwrap();
    let before = hand.state().to_vec();
    let planar = Target::Planar(Configuration::new(0.0, 0.0, 0.0));
    assert!(matches!(
        hand.drag(9, Target::Axis(0.0)),
        Err(SimulateError::NoPart { part: 9, count: 2 })
    ));
    for target in [planar, Target::Axis(f64::NAN)] {
        assert!(matches!(
            hand.drag(0, target),
            Err(SimulateError::Drag { .. })
        ));
    }
    assert!(hand.set_state(&[0.0]).is_err() && hand.set_state(&[0.0, f64::INFINITY]).is_err());
    assert_eq!(hand.state(), before);
}

/// The cost of one call for a step of a hundredth of the size, of every part of the models that ship: to and fro, or around a circle.
#[test]
#[ignore = "prints times"]
fn times() {
    let models = format!("{}/../../models", env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(models)
        .unwrap()
        .map(|e| e.unwrap().path());
    let files = files.filter(|p| p.extension().is_some_and(|e| e == "toml"));
    let mut names: Vec<String> = files
        .map(|p| p.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    for name in names {
        let mechanism = model(&name);
        let mut hand = Hand::new(&mechanism).unwrap();
        let (start, size) = (hand.state().to_vec(), hand.system().size());
        for (part, entry) in mechanism.parts.iter().enumerate() {
            hand.set_state(&start).unwrap();
            let coordinates = hand.system().parts()[part];
            let Some(at) = coordinates.indices().next() else {
                continue;
            };
            let step = 0.01 * size / hand.system().lengths()[at];
            let (mut times, mut reached) = (Vec::new(), 0);
            for k in 0..120 {
                let (sin, cos) = (TAU * f64::from(k) / 60.0).sin_cos();
                let target = match coordinates {
                    PartCoordinates::Axis { .. } => {
                        Target::Axis(start[at] + step * f64::from(60 - (60_i32 - k).abs()))
                    }
                    _ => Target::Planar(Configuration::new(
                        start[at] + 10.0 * step * sin,
                        start[at + 1] + 10.0 * step * (cos - 1.0),
                        start[at + 2],
                    )),
                };
                let began = std::time::Instant::now();
                reached += usize::from(hand.drag(part, target).unwrap().reached());
                times.push(began.elapsed().as_secs_f64() * 1e3);
            }
            times.sort_by(f64::total_cmp);
            let name = format!("{name}, {}", entry.part.name());
            println!(
                "{name:40} median {:8.3} ms, 95 % {:8.3} ms, most {:8.3} ms, {reached} of 120 reached",
                times[60], times[114], times[119]
            );
        }
    }
}
