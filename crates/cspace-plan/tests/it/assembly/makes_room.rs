//! Parts that leave after others have made room.

use cspace::{Axis, Coordinates, Part, Vector};
use cspace_model::{Mechanism, PartEntry};
use cspace_plan::assembly::{Kind, Outcome, TakenApart};

use crate::assembly::judged::{asked, mechanism, polygon};

/// A box of 4 inside with walls of 1, open above.
fn tray() -> Part {
    polygon(
        "tray",
        &[
            (-1.0, -1.0),
            (5.0, -1.0),
            (5.0, 4.0),
            (4.0, 4.0),
            (4.0, 0.0),
            (0.0, 0.0),
            (0.0, 4.0),
            (-1.0, 4.0),
        ],
    )
}

/// A box of 40 inside with walls of 10, open above.
fn wide_tray() -> Part {
    polygon(
        "tray",
        &[
            (-10.0, -10.0),
            (50.0, -10.0),
            (50.0, 40.0),
            (40.0, 40.0),
            (40.0, 0.0),
            (0.0, 0.0),
            (0.0, 40.0),
            (-10.0, 40.0),
        ],
    )
}

/// A block in the middle of the tray, and a door on it that is hinged at the left and opens up to a limit.
fn behind_a_door(limit: f64) -> Mechanism {
    let mut model = mechanism(
        &[tray()],
        &[Part::rectangle("block", (2.0, 1.5), 2.0, 3.0).unwrap()],
    );
    let door = Part::rectangle("door", (2.0, 4.15), 4.0, 0.3).unwrap();
    let hinge = Axis::revolute((0.0, 4.0).into()).within(0.0, limit.to_radians());
    model.parts.push(PartEntry::on(door, hinge));
    model
}

fn kinds(apart: &TakenApart) -> Vec<(Kind, usize)> {
    apart.steps.iter().map(|s| (s.kind, s.moving[0])).collect()
}

/// How far a part on an axis comes in a step.
fn comes_to(apart: &TakenApart, step: usize) -> f64 {
    match apart.steps[step].path.configurations.last() {
        Some(Coordinates::Axes { v, .. }) => *v,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_door_is_opened_wide_but_not_up_to_its_stop() {
    let apart = asked(&behind_a_door(100.0));
    assert_eq!(apart.outcome, Outcome::Apart);
    assert_eq!(kinds(&apart), [(Kind::Moves, 2), (Kind::Leaves, 1)]);
    // The end of the door, 4 from the hinge, is left of the block, which is 1 from it, at acos 1/4; the door meets the wall at 90 degrees.
    let angle = comes_to(&apart, 0).to_degrees();
    assert!((angle - 0.95 * 90.0).abs() < 0.1, "{angle}");
    assert_eq!(apart.steps[1].path.configurations.len(), 2);
    assert_eq!(apart.tree.left, [0, 2]);
}

#[test]
fn a_door_that_opens_hardly_enough_is_opened_halfway_to_its_stop() {
    let needed = (1.0_f64 / 4.0).acos().to_degrees();
    let apart = asked(&behind_a_door(77.0));
    let angle = comes_to(&apart, 0).to_degrees();
    assert!((angle - 0.5 * (needed + 77.0)).abs() < 0.1, "{angle}");
}

#[test]
fn a_door_that_opens_less_lets_the_block_out_beside_it() {
    // Along the right wall it is 2 from the hinge: 60 degrees.
    let apart = asked(&behind_a_door(70.0));
    assert_eq!(apart.outcome, Outcome::Apart);
    assert_eq!(kinds(&apart), [(Kind::Moves, 2), (Kind::Leaves, 1)]);
    assert!(comes_to(&apart, 0) > 60.0_f64.to_radians());
}

#[test]
fn a_door_that_hardly_opens_proves_nothing() {
    let apart = asked(&behind_a_door(10.0));
    assert_eq!(apart.outcome, Outcome::Unknown);
    assert!(apart.steps.is_empty());
    let tried = apart.tried.unwrap();
    assert!(tried.aside == 2 && tried.places > 0);
    assert_eq!(apart.locked.unwrap().parts, [0, 1, 2]);
}

/// A block behind two doors, each of which opens up to the walls, and a bar that slides from before both.
#[test]
fn a_bar_then_two_doors_then_the_block() {
    let part = |name: &str, (x, y): (f64, f64), (w, h): (f64, f64)| {
        Part::rectangle(name, (x + 0.5 * w, y + 0.5 * h), w, h).unwrap()
    };
    let door = |x: f64, angles: [f64; 2]| {
        let hinge = Axis::revolute((x, 40.0).into());
        hinge.within(angles[0].to_radians(), angles[1].to_radians())
    };
    let bar = Axis::prismatic(Vector::new(1.0, 0.0)).within(-60.0, 0.0);
    let doors = [
        (
            part("left door", (-5.0, 40.0), (24.9, 3.0)),
            door(-5.0, [0.0, 170.0]),
        ),
        (
            part("right door", (20.1, 40.0), (24.9, 3.0)),
            door(45.0, [-170.0, 0.0]),
        ),
        (part("bar", (-10.0, 44.0), (60.0, 3.0)), bar),
    ];
    let block = part("block", (0.5, 0.0), (39.0, 30.0));
    let mut model = mechanism(&[wide_tray()], &[block]);
    (model.parts).extend(doors.map(|(part, axis)| PartEntry::on(part, axis)));
    let apart = asked(&model);
    assert_eq!(apart.outcome, Outcome::Apart, "{apart:?}");
    let made: Vec<_> = kinds(&apart);
    assert_eq!(made[0], (Kind::Moves, 4));
    assert_eq!(made.last(), Some(&(Kind::Leaves, 1)));
    // Both stop before the wall at 90 degrees, and neither just where the block passes, at 77.
    for step in [1, 2] {
        let angle = comes_to(&apart, step).abs().to_degrees();
        assert!((80.0..90.0).contains(&angle), "{angle}");
    }
}

/// A block between 1 and 39 under two slides that meet at 20: the left one goes 20, the right one 18.5, so that the opening reaches from 0
/// to 38.5 and the block has to go left by more than 0.5 before it goes up.
#[test]
fn two_slides_go_to_their_stops_for_a_block_that_moves_aside() {
    let block = Part::rectangle("block", (20.0, 19.5), 38.0, 39.0).unwrap();
    let mut model = mechanism(&[wide_tray()], &[block]);
    for (name, x, range) in [("left", 10.0, [-20.0, 0.0]), ("right", 30.0, [0.0, 18.5])] {
        let slide = Part::rectangle(name, (x, 41.5), 20.0, 3.0).unwrap();
        let axis = Axis::prismatic(Vector::new(1.0, 0.0)).within(range[0], range[1]);
        model.parts.push(PartEntry::on(slide, axis));
    }
    let apart = asked(&model);
    assert_eq!(apart.outcome, Outcome::Apart);
    let order = [(Kind::Moves, 2), (Kind::Moves, 3), (Kind::Leaves, 1)];
    assert_eq!(kinds(&apart), order);
    assert!((comes_to(&apart, 0) + 20.0).abs() < 0.01);
    assert!((comes_to(&apart, 1) - 18.5).abs() < 0.01);
}

#[test]
fn a_bolt_then_the_door_then_the_block() {
    let mut model = behind_a_door(100.0);
    // Over the door's end, until it is beyond the circle of the door's far corner.
    let bolt = Part::rectangle("bolt", (4.75, 4.5), 2.5, 0.4).unwrap();
    let slide = Axis::prismatic(Vector::new(1.0, 0.0)).within(0.0, 3.0);
    model.parts.push(PartEntry::on(bolt, slide));
    let apart = asked(&model);
    assert_eq!(apart.outcome, Outcome::Apart);
    let order = [(Kind::Moves, 3), (Kind::Moves, 2), (Kind::Leaves, 1)];
    assert_eq!(kinds(&apart), order);
    let far = 4.0_f64.hypot(0.3) - 3.5;
    assert!(comes_to(&apart, 0) > 0.5 && far < 0.6);
    // A bolt that slides less holds the door.
    model.parts[3].axis = Some(slide.within(0.0, 0.3));
    assert_eq!(asked(&model).outcome, Outcome::Unknown);
}

/// A shaft of width 2, across it a slot in which a bar slides, and under the bar a block.
fn behind_a_bar(slot: f64) -> Mechanism {
    let frame = polygon(
        "frame",
        &[
            (-2.0, -1.0),
            (8.0, -1.0),
            (8.0, 6.0),
            (2.0, 6.0),
            (2.0, 4.0),
            (2.0 + slot, 4.0),
            (2.0 + slot, 3.0),
            (2.0, 3.0),
            (2.0, 0.0),
            (0.0, 0.0),
            (0.0, 3.0),
            (-1.0, 3.0),
            (-1.0, 4.0),
            (0.0, 4.0),
            (0.0, 6.0),
            (-2.0, 6.0),
        ],
    );
    let bar = Part::rectangle("bar", (0.75, 3.5), 3.5, 1.0).unwrap();
    let block = Part::rectangle("block", (1.0, 1.5), 2.0, 3.0).unwrap();
    mechanism(&[frame], &[bar, block])
}

#[test]
fn a_bar_moves_aside_and_never_comes_out() {
    let apart = asked(&behind_a_bar(4.0));
    assert_eq!(kinds(&apart), [(Kind::Moves, 1), (Kind::Leaves, 2)]);
    // Its left end goes from -1 past the wall of the shaft at 2, up to a margin before the end of the slot, which it reaches after 3.5.
    let Some(Coordinates::Planar(to)) = apart.steps[0].path.configurations.last() else {
        panic!("a bar in the plane");
    };
    assert!(
        (to.x - 0.95 * 3.5).abs() < 1e-4 && to.y.abs() < 1e-12,
        "{to:?}"
    );
    // The bar in the frame is proved to stay.
    assert_eq!(apart.outcome, Outcome::Locked);
    assert_eq!(apart.locked.unwrap().parts, [0, 1]);
}

#[test]
fn a_bar_in_a_short_slot_stays_in_the_way() {
    let apart = asked(&behind_a_bar(2.9));
    assert!(apart.steps.is_empty());
    assert_eq!(apart.outcome, Outcome::Locked);
}

#[test]
fn two_move_aside() {
    // Two bars in two slots, one over the other.
    let frame = polygon(
        "frame",
        &[
            (-2.0, -1.0),
            (8.0, -1.0),
            (8.0, 8.0),
            (2.0, 8.0),
            (2.0, 6.0),
            (6.0, 6.0),
            (6.0, 5.0),
            (2.0, 5.0),
            (2.0, 4.0),
            (6.0, 4.0),
            (6.0, 3.0),
            (2.0, 3.0),
            (2.0, 0.0),
            (0.0, 0.0),
            (0.0, 3.0),
            (-1.0, 3.0),
            (-1.0, 4.0),
            (0.0, 4.0),
            (0.0, 5.0),
            (-1.0, 5.0),
            (-1.0, 6.0),
            (0.0, 6.0),
            (0.0, 8.0),
            (-2.0, 8.0),
        ],
    );
    let bar = |name, y| Part::rectangle(name, (0.75, y), 3.5, 1.0).unwrap();
    let block = Part::rectangle("block", (1.0, 1.5), 2.0, 3.0).unwrap();
    let apart = asked(&mechanism(
        &[frame],
        &[bar("low", 3.5), bar("high", 5.5), block],
    ));
    let order: Vec<Kind> = apart.steps.iter().map(|s| s.kind).collect();
    assert_eq!(order, [Kind::Moves, Kind::Moves, Kind::Leaves]);
    assert_eq!(apart.steps[2].moving, [3]);
}
