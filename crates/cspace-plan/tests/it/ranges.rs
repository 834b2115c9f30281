//! Parts over their ranges beside closed forms, and beside many poses of which none may be nearer than is told.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::pair::Joint;
use cspace::{Axis, FixedAxesSpace, Part, Point, Silent, Vector, Vertex};
use cspace_model::{JointEntry, Mechanism, PartEntry, compute_anew};
use cspace_oracle::effort;
use cspace_plan::legs::Scene;
use cspace_plan::ranges::{End, Held, Pair, Pairs, Tightest, Verdict};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn verdict(fixed: &PartEntry, moving: &PartEntry, within: f64) -> Verdict {
    let pair = Pair::new([fixed, moving], [0.0, 0.0]).unwrap();
    pair.over_ranges(within, &compute_anew(&Silent)).unwrap()
}

#[track_caller]
fn clear(fixed: &PartEntry, moving: &PartEntry) -> Tightest {
    match verdict(fixed, moving, f64::INFINITY) {
        Verdict::Clear(found) => found,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn held(fixed: &PartEntry, moving: &PartEntry) -> Held {
    match verdict(fixed, moving, f64::INFINITY) {
        Verdict::Touches(found) => found,
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn is_proved(found: &Tightest, size: f64) {
    let short = found.gap - found.least;
    assert!(
        (0.0..=(2e-9 * found.gap).max(2e-10 * size)).contains(&short),
        "{found:?}"
    );
}

fn on(part: Part, axis: Axis) -> PartEntry {
    PartEntry::on(part, axis)
}

fn disc(at: Point, r: f64) -> Part {
    Part::circle("disc", at, r).unwrap()
}

/// A disc on an arm comes as near as its range lets the arm turn towards the other.
#[test]
fn a_disc_on_an_arm_beside_a_disc() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..effort(40, 400) {
        let (arm, r, s) = (
            rng.random_range(1.0..3.0),
            rng.random_range(0.1..0.9),
            rng.random_range(0.1..2.0),
        );
        let to = Vector::from_angle(rng.random_range(-PI..PI)) * rng.random_range(6.5..9.0);
        let from: f64 = rng.random_range(-PI..PI);
        let drawn = disc(Point::ORIGIN + Vector::from_angle(from) * arm, r);
        let post = PartEntry::fixed(disc(Point::ORIGIN + to, s));
        let range = (-rng.random_range(0.0..3.0), rng.random_range(0.1..3.0));
        let turn = Axis::revolute(Point::ORIGIN);
        let distance = |angle: f64| {
            (Point::ORIGIN + Vector::from_angle(angle) * arm).distance(Point::ORIGIN + to) - r - s
        };
        let whole = clear(&post, &on(drawn.clone(), turn));
        assert!((whole.gap - (to.length() - arm - r - s)).abs() < 1e-11);
        is_proved(&whole, 10.0);
        let found = clear(&post, &on(drawn, turn.within(range.0, range.1)));
        let towards = to.y.atan2(to.x);
        let off = (towards - from - range.0).rem_euclid(TAU);
        let expected = match off <= range.1 - range.0 {
            true => distance(towards),
            false => distance(from + range.0).min(distance(from + range.1)),
        };
        assert!((found.gap - expected).abs() < 1e-11, "{found:?} {expected}");
        assert!((distance(from + found.at.1) - found.gap).abs() < 1e-11);
        is_proved(&found, 10.0);
    }
}

/// Two stars that turn come as near as their tips reach.
#[test]
fn two_that_turn_are_as_near_as_they_reach() {
    let star = |x: f64, teeth: u32, r: f64| {
        let at = |k: u32| {
            let p = Vector::from_angle(0.1 + PI * f64::from(k) / f64::from(teeth));
            let p = p * if k.is_multiple_of(2) { r } else { 0.6 * r };
            Vertex::line(x + p.x, p.y)
        };
        Part::new("star", vec![(0..2 * teeth).map(at).collect()]).unwrap()
    };
    let turn = |x: f64| Axis::revolute(Point::new(x, 0.0));
    let found = clear(
        &on(star(0.0, 5, 1.0), turn(0.0)),
        &on(star(4.0, 7, 2.5), turn(4.0)),
    );
    assert!((found.gap - 0.5).abs() < 1e-11, "{found:?}");
    is_proved(&found, 5.0);
    let (u, v) = found.at;
    let tip = |angle: f64, teeth: f64| (angle / (TAU / teeth)).fract().abs();
    assert!(tip(0.1 + u, 5.0).min(1.0 - tip(0.1 + u, 5.0)) < 1e-4, "{u}");
    let back = tip(0.1 + v - PI, 7.0);
    assert!(back.min(1.0 - back) < 1e-4, "{v}");
}

/// A bar that turns to a wall; parts that slide past each other, without a range.
#[test]
fn bars_walls_and_slides() {
    let bar = Part::rectangle("bar", (1.0, 0.0), 4.0, 0.5).unwrap();
    let wall = PartEntry::fixed(Part::rectangle("wall", (0.0, 6.0), 20.0, 2.0).unwrap());
    let turn = Axis::revolute(Point::ORIGIN);
    let reach = 3.0_f64.hypot(0.25);
    let found = clear(&wall, &on(bar.clone(), turn));
    assert!((found.gap - (5.0 - reach)).abs() < 1e-11, "{found:?}");
    // At 30 degrees the corner is the highest.
    let range = turn.within(-0.3, PI / 6.0);
    let found = clear(&wall, &on(bar.clone(), range));
    let height = 3.0 * 0.5 + 0.25 * (PI / 6.0).cos();
    assert!((found.gap - (5.0 - height)).abs() < 1e-11, "{found:?}");
    assert!((found.at.1 - PI / 6.0).abs() < 1e-12 && found.at.0 == 0.0);
    is_proved(&found, 20.0);
    // A box passes below the wall and beside a post.
    let slide = Axis::prismatic(Vector::new(1.0, 0.0));
    let slider = on(
        Part::rectangle("box", (-30.0, 2.0), 2.0, 2.0).unwrap(),
        slide,
    );
    let found = clear(&wall, &slider);
    assert!((found.gap - 2.0).abs() < 1e-11, "{found:?}");
    is_proved(&found, 20.0);
    let post = PartEntry::fixed(disc(Point::new(70.0, -3.0), 1.0));
    let found = clear(&post, &slider);
    assert!((found.gap - 3.0).abs() < 1e-11, "{found:?}");
    assert!((found.at.1 - 100.0).abs() < 1.0 + 1e-6, "{found:?}");
}

/// A shaft in a hole turns at the same gap all around.
#[test]
fn a_gap_that_stays_the_same() {
    let circle = |r: f64| vec![Vertex::new(r, 0.0, 1.0), Vertex::new(-r, 0.0, 1.0)];
    let ring = Part::new("ring", vec![circle(3.0), circle(2.0)]).unwrap();
    let turn = Axis::revolute(Point::ORIGIN);
    let found = clear(&on(ring, turn), &on(disc(Point::ORIGIN, 1.75), turn));
    assert!((found.gap - 0.25).abs() < 1e-12, "{found:?}");
    is_proved(&found, 6.0);
}

/// Pairs farther apart than is asked for are not looked for, and those that are nearer are found all the same.
#[test]
fn what_is_beyond_is_counted() {
    let bar = Part::rectangle("bar", (1.0, 0.0), 4.0, 0.5).unwrap();
    let turning = on(bar, Axis::revolute(Point::ORIGIN));
    let wall = PartEntry::fixed(Part::rectangle("wall", (0.0, 6.0), 20.0, 2.0).unwrap());
    let gap = 5.0 - 3.0_f64.hypot(0.25);
    assert_eq!(verdict(&wall, &turning, gap - 1e-6), Verdict::Beyond);
    assert!(
        matches!(verdict(&wall, &turning, gap + 1e-6), Verdict::Clear(t) if (t.gap - gap).abs() < 1e-11)
    );
    let mut mechanism = Mechanism::new("two");
    mechanism.parts = vec![wall, turning];
    let pairs = Pairs::of(&mechanism);
    assert_eq!(pairs.near(2.0), [[0, 1]]);
    assert!(pairs.near(1.9).is_empty());
    assert_eq!(pairs.count(), 1);
}

/// Random outlines on random axes: no pose is nearer than is told, and what is told is there.
#[test]
fn no_pose_is_nearer() {
    let poses = effort(20_000, 100_000);
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut part = |x: f64| loop {
        let loops = cspace_load::outline::outline(&mut rng);
        let moved = |v: &Vertex| Vertex::new(v.x + x, v.y, v.bulge);
        let loops = loops
            .iter()
            .map(|l| l.iter().map(moved).collect())
            .collect();
        if let Ok(part) = Part::new("random", loops) {
            break part;
        }
    };
    let parts: Vec<[Part; 2]> = (0..effort(30, 200))
        .map(|_| [part(0.0), part(0.0)])
        .collect();
    let (mut clears, mut proved) = (0, 0);
    for [a, b] in parts {
        let far = (a.size() + b.size()) * rng.random_range(0.5..1.2);
        let shift = |v: &Vertex| Vertex::new(v.x + far, v.y, v.bulge);
        let loops = b
            .loops()
            .iter()
            .map(|l| l.vertices().iter().map(shift).collect());
        let b = Part::new("other", loops.collect()).unwrap();
        let mut axis = |x: f64| {
            let axis = match rng.random_bool(0.6) {
                true => Axis::revolute(Point::new(
                    x + rng.random_range(-0.3..0.3),
                    rng.random_range(-0.3..0.3),
                )),
                false => Axis::prismatic(Vector::from_angle(rng.random_range(-PI..PI))),
            };
            match rng.random_bool(0.6) {
                true => axis.within(-rng.random_range(0.01..1.0), rng.random_range(0.01..1.0)),
                false => axis,
            }
        };
        let axes = (axis(0.0), axis(far));
        let scene = Scene::new(&a, &b, Some(axes));
        if scene.overlaps([0.0; 3]) {
            continue;
        }
        let Verdict::Clear(found) = verdict(
            &on(a.clone(), axes.0),
            &on(b.clone(), axes.1),
            f64::INFINITY,
        ) else {
            continue;
        };
        clears += 1;
        proved += u32::from(found.least > 0.0);
        let size = scene.size();
        let there = scene.clearance([found.at.0, found.at.1, 0.0]);
        assert!((there - found.gap).abs() <= 1e-12 * size);
        let extent = FixedAxesSpace::compute(&a, axes.0, &b, axes.1)
            .unwrap()
            .extent();
        for _ in 0..poses {
            let [u, v] = extent.map(|(lo, hi)| rng.random_range(lo..=hi));
            let nearer = scene.clearance([u, v, 0.0]);
            assert!(
                nearer > found.least && nearer >= found.gap * (1.0 - 1e-9) - 1e-9 * size,
                "{nearer} {found:?}"
            );
        }
    }
    assert!(clears >= 5 && proved == clears, "{clears} {proved}");
}

/// A door whose corner meets a wall: it is told where, and what touches.
#[test]
fn what_stops_a_door() {
    // The far corner is at (10, 1) about the hinge; the wall's face is at x = -6.
    let door = Part::rectangle("door", (5.0, 0.0), 10.0, 2.0).unwrap();
    let wall = PartEntry::fixed(Part::rectangle("wall", (-8.0, 0.0), 4.0, 60.0).unwrap());
    let hinge = Axis::revolute(Point::ORIGIN);
    let found = held(&wall, &on(door.clone(), hinge.within(0.0, 1.5 * PI)));
    // The first corner to come there is (10, 1): 10 cos t - sin t = -6.
    let (far, lead) = (10.0_f64.hypot(1.0), 0.1_f64.atan());
    let stop = (-6.0 / far).acos() - lead;
    assert_eq!(found.stopped.len(), 1);
    let told = &found.stopped[0];
    assert!(told.part == 1 && told.end == End::Hi && told.is_declared);
    assert!((told.at.1 - stop).abs() < 1e-9, "{} {stop}", told.at.1);
    assert_eq!(told.features.len(), 1);
    assert!((found.reach[1].lo, found.reach[0].hi) == (0.0, 0.0));
    assert!((found.reach[1].hi - stop).abs() < 1e-9);
    let [p, q] = found.points.unwrap();
    assert!(
        p.distance(q) < 1e-8 && (p.x + 6.0).abs() < 1e-8,
        "{p:?} {q:?}"
    );
    // Without a range it stops on both sides of a whole turn.
    let free = held(&wall, &on(door.clone(), hinge));
    assert_eq!(free.stopped.len(), 2);
    assert!(free.stopped.iter().all(|s| !s.is_declared));
    assert!((free.reach[1].hi + free.reach[1].lo).abs() < 1e-9);
    // Within the stops nothing is met.
    let found = clear(&wall, &on(door, hinge.within(-1.0, 1.0)));
    assert!(
        (found.gap - (6.0 - 1.0_f64.sin())).abs() < 1e-11,
        "{found:?}"
    );
}

/// A cam lifts its follower, which is stopped by nothing.
#[test]
fn a_cam_and_its_follower() {
    let cam = disc(Point::new(0.5, 0.0), 1.0);
    let follower = Part::rectangle("follower", (0.0, 3.0), 6.0, 1.0).unwrap();
    let turn = Axis::revolute(Point::ORIGIN);
    let lift = Axis::prismatic(Vector::new(0.0, 1.0)).within(-1.5, 2.0);
    let found = held(&on(cam.clone(), turn), &on(follower.clone(), lift));
    // The top of the cam is at 1 + sin(u) / 2, the follower's face at 2.5 + v.
    assert!(found.reach[0].lo == f64::NEG_INFINITY && found.reach[0].hi == f64::INFINITY);
    assert!(
        found.stopped.is_empty() && found.ratio.is_none(),
        "{found:?}"
    );
    // One that goes down to -2.2 does not come there.
    let lower = Axis::prismatic(Vector::new(0.0, 1.0)).within(-2.2, 2.0);
    let found = held(&on(cam, turn), &on(follower, lower));
    assert_eq!(found.stopped.len(), 1);
    let told = &found.stopped[0];
    assert!(
        (told.at.1 + 2.0).abs() < 1e-9 && told.end == End::Lo,
        "{told:?}"
    );
    assert!(
        (told.at.0.rem_euclid(TAU) - 3.0 * FRAC_PI_2).abs() < 1e-6,
        "{told:?}"
    );
}

/// The gear of 12 teeth and the pinion of 10 that is drawn at a distance from it, moved farther away by some more.
fn gears(more: f64) -> [PartEntry; 2] {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../models/gears_on_shafts.toml"
    );
    let cspace_model::Document::Model(model) =
        cspace_model::read(std::path::Path::new(file)).unwrap()
    else {
        unreachable!()
    };
    let part = |i: usize| model.mechanism.parts[i].part.clone();
    let moved = |v: &Vertex| Vertex::new(v.x + more, v.y, v.bulge);
    let pinion = part(1);
    let loops = pinion
        .loops()
        .iter()
        .map(|l| l.vertices().iter().map(moved).collect());
    let pinion = Part::new("pinion", loops.collect()).unwrap();
    [
        PartEntry::revolute(part(0), (0.0, 0.0)),
        PartEntry::revolute(pinion, (44.0 + more, 0.0)),
    ]
}

/// Gears turn together, by their numbers of teeth; their backlash is that of motions to contact on both sides.
#[test]
fn gears_that_mesh() {
    let [gear, pinion] = gears(0.0);
    let found = held(&gear, &pinion);
    assert_eq!(found.ratio, Some((-6, 5)));
    assert!(found.stopped.is_empty());
    let play = found.backlash.unwrap();
    // By the model 0.23 to 0.30 along the pitch circle of 40.
    let along = |angle: f64| 20.0 * angle;
    assert!(
        (0.2..play.most * 20.0).contains(&along(play.least)),
        "{play:?}"
    );
    assert!((0.2..0.35).contains(&along(play.most)), "{play:?}");
    let axis = |entry: &PartEntry| entry.axis.unwrap();
    let space =
        FixedAxesSpace::compute(&gear.part, axis(&gear), &pinion.part, axis(&pinion)).unwrap();
    let to_contact =
        |from: (f64, f64), way: f64| match space.first_contact(from, (0.0, way), 7.0).unwrap() {
            AxesMotionOutcome::Contact(contact) => contact.time,
            other => panic!("{other:?}"),
        };
    let there = to_contact(play.at, 1.0) + to_contact(play.at, -1.0);
    assert!((there - play.least).abs() < 1e-8, "{there} {play:?}");
    // Once around, in steps from the middle of the play.
    let n = effort(2_000, 100_000);
    let (mut v, mut least, mut most) = (0.0, f64::INFINITY, 0.0_f64);
    for k in 0..n {
        let u = TAU * f64::from(k) / f64::from(n);
        let (up, down) = (to_contact((u, v), 1.0), to_contact((u, v), -1.0));
        let width = up + down;
        assert!(
            (play.least - 1e-9..=play.most + 1e-9).contains(&width),
            "{width} {play:?}"
        );
        (least, most) = (least.min(width), most.max(width));
        v += 0.5 * (up - down) - 1.2 * TAU / f64::from(n);
    }
    assert!(
        least - play.least < 1e-4 && play.most - most < 1e-4,
        "{least} {most} {play:?}"
    );
}

/// Gears with ranges turn together as those without, and their backlash is that within the range.
#[test]
fn gears_with_ranges_mesh() {
    let [gear, pinion] = gears(0.0);
    let whole = held(&gear, &pinion).backlash.unwrap();
    let limited = |entry: &PartEntry, by: f64| {
        let axis = entry.axis.unwrap();
        on(entry.part.clone(), axis.within(-by, by))
    };
    // A pitch of the gear is 30 degrees.
    let found = held(&limited(&gear, 0.6), &limited(&pinion, 0.725));
    assert_eq!(found.ratio, Some((-6, 5)));
    assert!(found.stopped.is_empty(), "{found:?}");
    let play = found.backlash.unwrap();
    assert!((play.least - whole.least).abs() < 2e-9 && (play.most - whole.most).abs() < 2e-9);
    // The pinion's range ends before the gear's.
    let found = held(&limited(&gear, 0.6), &limited(&pinion, 0.5));
    assert_eq!(found.stopped.len(), 2, "{found:?}");
    assert!(found.stopped.iter().all(|s| s.part == 0 && s.is_declared));
    // Within so little only some of the play is seen.
    let found = held(&limited(&gear, 0.05), &limited(&pinion, 0.07));
    let little = found.backlash.unwrap();
    assert!(little.least > whole.least - 1e-9 && little.most < whole.most + 1e-9);
    assert!(
        little.at.0.abs() <= 0.05 && little.most - little.least < whole.most - whole.least - 1e-6
    );
}

/// Two discs of radius 0.2 at 2 from the origin, 0.5 rad to both sides of the x axis; and one on an arm of length 2 about (e, 0) between them.
fn fork_and_hand(e: f64) -> [PartEntry; 2] {
    let at = |angle: f64| Vector::from_angle(angle) * 2.0;
    let circle = |c: Vector| {
        vec![
            Vertex::new(c.x + 0.2, c.y, 1.0),
            Vertex::new(c.x - 0.2, c.y, 1.0),
        ]
    };
    let fork = Part::new("fork", vec![circle(at(0.5)), circle(at(-0.5))]).unwrap();
    let hand = disc(Point::new(e + 2.0, 0.0), 0.2);
    [
        PartEntry::revolute(fork, Point::ORIGIN),
        PartEntry::revolute(hand, (e, 0.0)),
    ]
}

/// The play of the hand in the fork that is turned by u, in closed form.
fn play_of_hand(e: f64, u: f64) -> f64 {
    let pivot = Vector::new(e, 0.0);
    let side = |angle: f64| {
        let to = Vector::from_angle(u + angle) * 2.0 - pivot;
        let d = to.length();
        (to, ((4.0 + d * d - 0.16) / (4.0 * d)).acos())
    };
    let ((p, a), (q, b)) = (side(0.5), side(-0.5));
    q.cross(p).atan2(q.dot(p)) - a - b
}

/// The hand turns with the fork, with a play that is known; where both turn about one point it is the same all around.
#[test]
fn backlash_in_closed_form() {
    for e in [0.0, 0.1, 0.25] {
        let [fork, hand] = fork_and_hand(e);
        let found = held(&fork, &hand);
        assert_eq!(found.ratio, Some((1, 1)), "{found:?}");
        let play = found.backlash.unwrap();
        let least_of = |sign: f64| {
            let of = |u: f64| sign * play_of_hand(e, u);
            let n = 2000;
            let best = (0..n)
                .map(|k| TAU * f64::from(k) / f64::from(n))
                .min_by(|&a, &b| of(a).total_cmp(&of(b)));
            let (mut lo, mut hi) = (best.unwrap() - TAU / 1000.0, best.unwrap() + TAU / 1000.0);
            for _ in 0..100 {
                let (a, b) = (lo + (hi - lo) / 3.0, hi - (hi - lo) / 3.0);
                match of(a) < of(b) {
                    true => hi = b,
                    false => lo = a,
                }
            }
            sign * of(0.5 * (lo + hi))
        };
        let (least, most) = (least_of(1.0), least_of(-1.0));
        assert!((play.least - least).abs() < 1e-9, "{play:?} {least}");
        assert!((play.most - most).abs() < 1e-9, "{play:?} {most}");
        assert!((play_of_hand(e, play.at.0) - play.least).abs() < 1e-9);
    }
}

/// Random outlines whose ranges end in contact: the parts touch where they are told to stop, and no free place of the region is farther.
#[test]
fn no_place_is_farther() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut stops = 0;
    for _ in 0..effort(150, 1_500) {
        let mut part = |x: f64| loop {
            let loops = cspace_load::outline::outline(&mut rng);
            let moved = |v: &Vertex| Vertex::new(v.x + x, v.y, v.bulge);
            let loops = loops
                .iter()
                .map(|l| l.iter().map(moved).collect())
                .collect();
            if let Ok(part) = Part::new("random", loops) {
                break part;
            }
        };
        let a = part(0.0);
        let far = 0.9 * a.size();
        let b = part(far);
        let mut axis = |x: f64| {
            let axis = match rng.random_bool(0.6) {
                true => Axis::revolute(Point::new(x, rng.random_range(-0.3..0.3))),
                false => Axis::prismatic(Vector::from_angle(rng.random_range(-PI..PI))),
            };
            axis.within(-rng.random_range(0.5..3.0), rng.random_range(0.5..3.0))
        };
        let axes = (axis(0.0), axis(far));
        let scene = Scene::new(&a, &b, Some(axes));
        if scene.overlaps([0.0; 3]) {
            continue;
        }
        let entries = [on(a.clone(), axes.0), on(b.clone(), axes.1)];
        let Verdict::Touches(found) = verdict(&entries[0], &entries[1], f64::INFINITY) else {
            continue;
        };
        let size = scene.size();
        for stop in &found.stopped {
            stops += 1;
            let at = [stop.at.0, stop.at.1, 0.0];
            assert!(scene.clearance(at) < 1e-8 * size, "{stop:?}");
            assert!(!stop.features.is_empty() && stop.is_declared);
            let limits = found.reach[stop.part];
            let end = match stop.end {
                End::Lo => limits.lo,
                End::Hi => limits.hi,
            };
            assert!((at[stop.part] - end).abs() < 1e-12);
        }
        let space = FixedAxesSpace::compute(&a, axes.0, &b, axes.1).unwrap();
        let Some(region) = space.locate(0.0, 0.0).region() else {
            // Outlines on a grid may touch as drawn, between two regions.
            continue;
        };
        for _ in 0..effort(2_000, 20_000) {
            let [u, v] = space.extent().map(|(lo, hi)| rng.random_range(lo..=hi));
            if space.locate(u, v).region() == Some(region) {
                for (t, limits) in [u, v].into_iter().zip(found.reach) {
                    assert!(
                        (limits.lo - 1e-9..=limits.hi + 1e-9).contains(&t),
                        "{u} {v} {found:?}"
                    );
                }
            }
        }
    }
    assert!(stops >= 10, "{stops}");
}

/// Pulled apart by more than their teeth are high, they are clear, and do not turn each other.
#[test]
fn gears_that_do_not_mesh() {
    let [gear, pinion] = gears(9.0);
    let found = clear(&gear, &pinion);
    // Tip circles of 56 and 48 at 53.
    assert!((found.gap - 1.0).abs() < 1e-6, "{found:?}");
    is_proved(&found, 56.0);
    let [gear, pinion] = gears(7.0);
    let found = held(&gear, &pinion);
    assert_eq!(found.ratio, None);
}

/// Parts of a linkage move together, and are not taken to move independently; joints to what stands still are pivots.
#[test]
fn parts_of_a_linkage_are_left_out() {
    let bar = |x: f64| Part::rectangle("bar", (x, 0.0), 1.0, 0.5).unwrap();
    let turning = |x: f64| PartEntry::revolute(bar(x), (x, 0.0));
    let mut mechanism = Mechanism::new("linkage");
    mechanism.parts = vec![
        PartEntry::fixed(bar(0.0)),
        turning(5.0),
        PartEntry::planar(bar(10.0)),
        turning(15.0),
        turning(20.0),
    ];
    let joint = |a: usize, b: usize| JointEntry {
        joint: Joint::Revolute { at: Point::ORIGIN },
        parts: (a, b),
    };
    mechanism.joints = vec![joint(1, 2), joint(2, 3), joint(0, 1), joint(0, 4)];
    let pairs = Pairs::of(&mechanism);
    assert_eq!(pairs.near(f64::INFINITY), [[0, 3], [1, 4], [3, 4]]);
    assert_eq!(pairs.count(), 3);
}
