//! Measures of motions, against closed forms.

use cspace_design::{Unmeasured, check};

use crate::common::{model, number};

/// A block that is pushed after 2/speed seconds; an eccentric and its roller, whose stroke is twice the eccentricity.
const MOTIONS: &str = r#"
[parameter]
gap = 2
speed = 1
eccentric = 4

[[part]]
name = "pusher"
motion = { type = "prismatic", direction = [1, 0] }
loops = [[[-2, -1], [0, -1], [0, 1], [-2, 1]]]

[[part]]
name = "block"
motion = { type = "prismatic", direction = [1, 0] }
loops = [[["gap", -1], ["gap + 2", -1], ["gap + 2", 1], ["gap", 1]]]

[[part]]
name = "cam"
motion = { type = "revolute", center = [0, 50] }
loops = [{ circle = 10, at = ["eccentric", 50] }]

[[part]]
name = "roller"
motion = { type = "prismatic", direction = [0, 1] }
loops = [{ circle = 3, at = [0, "50 + sqrt(13^2 - eccentric^2)"] }]

[[drive]]
part = "pusher"
rate = "speed"

[[drive]]
part = "cam"
rate = "360deg"

[[load]]
part = "roller"
force = [0, -1e7]

[[pair]]
fixed = "pusher"
moving = "block"

[[pair]]
fixed = "cam"
moving = "roller"

[[requirement]]
name = "meets"
measure = "event"
event = "touch"
pair = ["block", "pusher"]
time = 4
limits = [0, 2.5]

[[requirement]]
name = "lift"
measure = "stroke"
part = "roller"
time = 4
limits = [7, 9]

[[requirement]]
name = "pushed"
measure = "ratio"
part = "block"
by = "pusher"
time = 4

[[requirement]]
name = "pushed early"
measure = "ratio"
part = "block"
by = "pusher"
time = "1.5*gap/speed"

[[requirement]]
name = "parts"
measure = "event"
event = "release"
pair = ["pusher", "block"]
time = 4
"#;

#[test]
fn motions_are_measured() {
    for (gap, speed, eccentric) in [(0.5, 1.0, 4.0), (1.5, 2.0, 3.0)] {
        let set = [("gap", gap), ("speed", speed), ("eccentric", eccentric)];
        let set = set.map(|(name, x)| (name, x.to_string()));
        let all = check(&model(MOTIONS, &set));
        let [meets, lift, pushed, early, parts] = &all[..] else {
            panic!("{all:?}");
        };
        assert!((number(meets) - gap / speed).abs() < 1e-9, "{meets:?}");
        assert_eq!(meets.is_met(), Some(true));
        // Parts are named in the order of the requirement.
        assert_eq!(meets.parts, Some([1, 0]));
        // The right side of the pusher is its line 1, and the block's feature is named first.
        assert!(meets.touching[0][1].contains("line 1 "), "{meets:?}");
        assert!((number(lift) - 2.0 * eccentric).abs() < 1e-6, "{lift:?}");
        // Once the cam's motion repeats, the block goes with the pusher; before, it has been left behind by two of three parts.
        assert!((number(pushed) - 1.0).abs() < 1e-9, "{pushed:?}");
        assert!((number(early) - 1.0 / 3.0).abs() < 1e-9, "{early:?}");
        assert_eq!(parts.measured, Err(Unmeasured::Never));
    }
}

/// A motion that jams does not come to an end: what is measured to its end has no value, what happens before has.
#[test]
fn a_motion_that_jams_has_its_events() {
    let text = MOTIONS.replace(
        "motion = { type = \"prismatic\", direction = [1, 0] }\nloops = [[[\"gap\"",
        "motion = { type = \"prismatic\", direction = [1, 0], range = [0, 1] }\nloops = [[[\"gap\"",
    );
    let set = [("gap", "1.9".to_owned())];
    let all = check(&model(&text, &set));
    assert!((number(&all[0]) - 1.9).abs() < 1e-9, "{all:?}");
    // That of a shorter time is over before.
    for stopped in [&all[1], &all[2], &all[4]] {
        assert!(
            matches!(stopped.measured, Err(Unmeasured::EndsEarly { until, .. }) if (until - 2.9).abs() < 1e-9),
            "{stopped:?}"
        );
    }
}
