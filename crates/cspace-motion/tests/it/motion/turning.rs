//! Contacts of a part that turns are found, however large the mechanism about it is and however long its steps are.

use cspace_motion::{EventKind, Record, Status, What};

use crate::motion::helpers::{judge, thrown};

/// A chip that flies past an arm that is driven to turn, alone or in a housing that neither comes near.
fn past_an_arm(housing: Option<f64>) -> Record {
    let around = housing.map_or(String::new(), |r| {
        let o = r + 1.0;
        format!(
            r#"
            [[part]]
            name = "housing"
            motion = {{ type = "fixed" }}
            loops = [
                [[-{o}, -{o}], [{o}, -{o}], [{o}, {o}], [-{o}, {o}]],
                [[-{r}, -{r}], [-{r}, {r}], [{r}, {r}], [{r}, -{r}]],
            ]"#
        )
    });
    let text = format!(
        r#"
        {around}
        [[part]]
        name = "arm"
        motion = {{ type = "revolute", center = [0, 0] }}
        loops = [[[-0.1, -0.05], [1, -0.05], [1, 0.05], [-0.1, 0.05]]]
        [[part]]
        name = "chip"
        mass = 1
        rate = [0, -4.438841277916572, -0.04955302402838058]
        loops = [[[0.6487, 3], [1.0487, 3], [1.0487, 3.1], [0.6487, 3.1]]]
        [[drive]]
        part = "arm"
        rate = 7.8746213812014645"#
    );
    let (simulation, record) = thrown(&text, 3.0, 0.005);
    judge(&simulation, &record);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    record
}

#[test]
fn a_chip_strikes_an_arm_in_a_housing_of_any_size() {
    let of_arm = |record: &Record| -> Vec<(f64, EventKind)> {
        let between = |what: &What| matches!(what, What::Contact { fixed, .. } if fixed == "arm");
        let events = record.events.iter().filter(|e| between(&e.what));
        events.map(|e| (e.t, e.kind)).collect()
    };
    let alone = of_arm(&past_an_arm(None));
    assert!(alone.iter().any(|e| e.1 == EventKind::Impact), "{alone:?}");
    for size in [20.0, 100.0, 500.0, 3000.0] {
        let within = of_arm(&past_an_arm(Some(size)));
        assert_eq!(within.len(), alone.len(), "{size}: {within:?} {alone:?}");
        for (a, b) in within.iter().zip(&alone) {
            assert!(
                a.1 == b.1 && (a.0 - b.0).abs() < 1e-8,
                "{size}: {a:?} {b:?}"
            );
        }
    }
}
