//! Orientations so far from 0 that doubles say little of where they are on the circle.

use crate::helpers::Command;

use super::bounds::{PROGRAM, fails};
use crate::helpers::model;

#[test]
fn orientations_far_from_0_are_refused() {
    let file = model("peg_hole");
    for theta in ["1e12", "-1e9", "1000001", "1e300", "200000turn", "6e7deg"] {
        fails(
            &["slice", &file, "--theta", theta],
            2,
            &["--theta", "1e6 rad", "whole turns"],
        );
    }
    for window in ["1e7,10000001", "-1e12,-999999999999", "0,1e9"] {
        fails(
            &["compute", &file, "--window", window],
            2,
            &["--window", "1e6 rad"],
        );
        fails(
            &["info", &file, "--window", window],
            2,
            &["--window", "1e6 rad"],
        );
    }
    let dir = tempfile::tempdir().unwrap();
    let bad = dir.path().join("bad.toml");
    let window = "[[pair]]\nfixed = \"block\"\nmoving = \"peg\"\ntheta = [1e9, 1000000001]\n";
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(!text.contains("[[pair]]"));
    std::fs::write(&bad, text + window).unwrap();
    fails(
        &["compute", bad.to_str().unwrap()],
        2,
        &["bad.toml:", "pair 0", "`theta`", "1e6 rad"],
    );
}

#[test]
fn rows_with_such_orientations_are_named() {
    let mechanism = model("ratchet_mechanism");
    for (args, rows, words) in [
        (
            vec![model("peg_hole")],
            "x,y,theta\n0,0,1e6\n0,0,1e9\n",
            "line 3, column theta: the angle 1000000000 rad",
        ),
        (
            vec![model("peg_hole")],
            "x,y,theta\n0,0,-1e300\n",
            "line 2, column theta: the angle -1e300 rad",
        ),
        (
            vec![mechanism, "--pair=driver,link".into()],
            "u,v\n1,0\n1e7,0\n",
            "line 3, column u: the angle",
        ),
    ] {
        let mut command = Command::new(PROGRAM);
        command.arg("classify").args(&args).write_stdin(rows);
        let output = command.assert().code(2).stdout("").get_output().clone();
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.contains(words) && said.contains("1e6 rad"), "{said}");
    }
    // A length may be as long as it likes.
    let mut command = Command::new(PROGRAM);
    command
        .args(["classify", &model("peg_hole")])
        .write_stdin("x,y,theta\n1e308,-1e308,0.1\n");
    command
        .assert()
        .success()
        .stdout("x,y,theta,class\n1e308,-1e308,0.1,free\n");
}

#[test]
fn a_window_for_a_part_alone_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("one.toml");
    std::fs::write(
        &file,
        "[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n",
    )
    .unwrap();
    let file = file.to_str().unwrap();
    fails(
        &["info", file, "--window", "0,1"],
        2,
        &["one.toml", "one part", "--window"],
    );
}
