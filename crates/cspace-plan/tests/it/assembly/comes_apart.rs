//! Assemblies that come apart.

use cspace::Part;
use cspace_plan::assembly::Outcome;

use crate::assembly::judged::{asked, mechanism, polygon};

fn slot() -> Part {
    polygon(
        "slot",
        &[
            (-3.0, -2.0),
            (3.0, -2.0),
            (3.0, 0.0),
            (1.0, 0.0),
            (1.0, -1.0),
            (-1.0, -1.0),
            (-1.0, 0.0),
            (-3.0, 0.0),
        ],
    )
}

#[test]
fn the_lid_before_the_block() {
    let block = Part::rectangle("block", (0.0, -0.5), 2.0, 1.0).unwrap();
    let lid = Part::rectangle("lid", (0.0, 0.5), 6.0, 1.0).unwrap();
    for planar in [[block.clone(), lid.clone()], [lid, block]] {
        let names = [planar[0].name().to_owned(), planar[1].name().to_owned()];
        let apart = asked(&mechanism(&[slot()], &planar));
        assert_eq!(apart.outcome, Outcome::Apart);
        let order: Vec<&str> = (apart.steps.iter())
            .map(|s| names[s.moving[0] - 1].as_str())
            .collect();
        assert_eq!(order, ["lid", "block"]);
        assert!(apart.locked.is_none());
    }
}

#[test]
fn hooks_come_apart_by_more_than_one_motion() {
    // The lip over the hook's arm keeps it from going straight up.
    let hook = polygon(
        "hook",
        &[
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 2.0),
            (3.0, 2.0),
            (3.0, 1.0),
            (1.0, 1.0),
            (1.0, 3.2),
            (1.9, 3.2),
            (1.9, 4.2),
            (0.0, 4.2),
        ],
    );
    let other = polygon(
        "other",
        &[
            (1.5, 1.1),
            (2.5, 1.1),
            (2.5, 2.2),
            (4.2, 2.2),
            (4.2, 0.0),
            (5.2, 0.0),
            (5.2, 3.0),
            (1.5, 3.0),
        ],
    );
    let apart = asked(&mechanism(&[], &[hook, other]));
    assert_eq!(apart.outcome, Outcome::Apart);
    assert_eq!(apart.steps.len(), 1);
    assert!(apart.steps[0].path.configurations.len() > 2);
}

/// A channel, and in it side by side two halves, of which the one has a tongue in the other's groove.
fn tongue_and_groove() -> [Part; 3] {
    [
        polygon(
            "channel",
            &[
                (-3.0, -1.0),
                (3.0, -1.0),
                (3.0, 3.0),
                (2.0, 3.0),
                (2.0, 0.0),
                (-2.0, 0.0),
                (-2.0, 3.0),
                (-3.0, 3.0),
            ],
        ),
        polygon(
            "groove",
            &[
                (-2.0, 0.0),
                (0.0, 0.0),
                (0.0, 1.0),
                (-1.0, 1.0),
                (-1.0, 2.0),
                (0.0, 2.0),
                (0.0, 3.0),
                (-2.0, 3.0),
            ],
        ),
        polygon(
            "tongue",
            &[
                (0.0, 0.0),
                (2.0, 0.0),
                (2.0, 3.0),
                (0.0, 3.0),
                (0.0, 2.0),
                (-1.0, 2.0),
                (-1.0, 1.0),
                (0.0, 1.0),
            ],
        ),
    ]
}

#[test]
fn two_that_hold_each_other_leave_as_one() {
    let [channel, groove, tongue] = tongue_and_groove();
    let apart = asked(&mechanism(&[channel], &[groove, tongue]));
    assert_eq!(apart.outcome, Outcome::Apart);
    assert_eq!(apart.steps[0].moving, [1, 2]);
    assert_eq!(apart.steps[0].staying, [0]);
    assert_eq!(apart.steps.len(), 2);
    assert_eq!(apart.steps[1].moving.len(), 1);
}

#[test]
fn the_order_of_parts_does_not_change_whether() {
    let [channel, groove, tongue] = tongue_and_groove();
    // No part stands still: the channel may as well be taken off the two.
    for planar in [
        [channel.clone(), groove.clone(), tongue.clone()],
        [tongue, channel, groove],
    ] {
        let apart = asked(&mechanism(&[], &planar));
        assert_eq!(apart.outcome, Outcome::Apart);
        assert_eq!(apart.steps.len(), 2);
    }
}
