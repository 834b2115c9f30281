//! The shipped lock, whose plug turns under its pins with the right key only.

use cspace_model::model::from_toml;
use cspace_plan::modes::{ModePlace, TreeModes};

/// The lock with some parameters set, as `--set` does.
fn modes(set: &[(&str, f64)]) -> TreeModes {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../models/layers/pin_tumbler_lock.toml"
    );
    let mut text = std::fs::read_to_string(file).unwrap();
    for (name, value) in set {
        let begin = text.find(&format!("\n{name} = ")).unwrap() + 1;
        let end = begin + text[begin..].find('\n').unwrap();
        text.replace_range(begin..end, &format!("{name} = {value}"));
    }
    let lock = from_toml(&text, "lock").unwrap();
    TreeModes::compute(&lock, &[0, 1, 2, 3, 4, 5, 6]).unwrap()
}

/// The range of the plug in the mode of the parts as drawn, in degrees.
fn turned(set: &[(&str, f64)]) -> (f64, f64) {
    let modes = modes(set);
    assert_eq!((modes.hub(), modes.doubts()), (0, 0));
    let ModePlace::Mode(mode) = modes.locate(&[0.0; 7]).unwrap() else {
        panic!("{set:?}: {:?}", modes.locate(&[0.0; 7]));
    };
    let (lo, hi) = modes.list()[mode].ranges[0];
    (lo.to_degrees(), hi.to_degrees())
}

/// The plug turns until a corner of a pin meets the wall of a bore, 0.05 or 0.1 away.
#[test]
fn each_pin_and_each_ward_stops_a_wrong_key() {
    let (lo, hi) = turned(&[]);
    assert!((lo + 1.0).abs() < 1e-9 && (hi - 90.0).abs() < 1e-9);
    for (set, least, most) in [
        (("key1", 2.0), 0.5, 1.5),
        (("key1", 4.0), 0.2, 1.0),
        (("slot1", 11.8), 18.0, 26.0),
        (("slot2", 12.2), 18.0, 26.0),
    ] {
        let (_, hi) = turned(&[set]);
        assert!(least < hi && hi < most, "{set:?} {hi}");
    }
}
