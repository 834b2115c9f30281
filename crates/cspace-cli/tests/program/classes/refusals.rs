//! Rejected requests, and their messages.

use crate::helpers::{cspace, fails, mechanism, model, printed, with_rows};

#[test]
fn wrong_columns_and_rows_beyond_the_range_are_told() {
    let file = mechanism();
    let ask = |pair: &str, more: &[&str], rows: &str| {
        with_rows(&[&[file.as_str(), "--pair", pair], more].concat(), rows)
    };
    let wants_axes = [
        "line 1",
        "fixed-axes",
        "driver,link",
        "is u and v",
        "--general",
    ];
    fails(
        ask("driver,link", &[], "x,y,theta\n0,0,0\n"),
        2,
        &wants_axes,
    );
    fails(ask("driver,link", &[], "u\n0\n"), 2, &wants_axes);
    for (pair, more) in [
        ("driver,link", &["--general"][..]),
        ("ratchet,pawl", &[]),
        ("frame,link", &[]),
    ] {
        let words = ["line 1", "\"u,v\"", pair, "x, y and theta"];
        fails(ask(pair, more, "u,v\n0,0\n"), 2, &words);
    }
    fails(
        ask("driver,link", &[], "u,v,u\n0,0,0\n"),
        2,
        &["column u", "twice", "once"],
    );
    fails(
        ask("driver,link", &[], "u,v\n0,0\n0,x\n"),
        2,
        &["line 3", "column v", "\"x\""],
    );
    fails(
        ask("driver,link", &[], "u,v\n0,inf\n"),
        2,
        &["line 2", "column v"],
    );
    fails(
        ask("driver,link", &[], "u,v\n9,0\n0,0.36\n"),
        2,
        &["line 3", "v 0.36", "-0.349", "0.349", "link", "range"],
    );
    fails(
        ask("ratchet,pawl", &["--window", "0,1"], "x,y,theta\n0,0,2\n"),
        2,
        &["line 2", "theta 2", "from 0 to 1"],
    );
    fails(
        with_rows(&[&model("rack_pinion")], "u,v\n0,-70\n0,-70.5\n"),
        2,
        &["line 3", "v -70.5", "from -70 to 70", "rack"],
    );
    // With --general it is asked by orientations, and the message says why.
    let general = ask("driver,link", &["--general"], "u,v\n0,0\n");
    fails(
        general,
        2,
        &[
            "fixed-axes pair",
            "by the general method is x, y and theta",
            "leave out --general",
        ],
    );
    let help = printed(&["classify", "--help"]);
    let words = "With --general such a pair too is asked by x, y and theta, not by u and v";
    let help = help.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains(words), "{help}");
    // The answer's own column.
    for (pair, rows) in [
        ("driver,link", "u,v,class\n0,0,free\n"),
        ("ratchet,pawl", "class,x,y,theta\n1,0,0,0\n"),
    ] {
        for format in ["text", "json"] {
            let command = ask(pair, &["--format", format], rows);
            fails(command, 2, &["line 1", "`class`", "another name"]);
        }
    }
    let command = ask("driver,link", &["--format", "json"], "u,v,n,n\n0,0,1,2\n");
    fails(command, 2, &["line 1", "column n", "twice"]);
    // Angles may have a unit, lengths may not.
    let angles = ask("driver,link", &[], "u,v\n0.1turn,-30deg\n");
    fails(angles, 2, &["line 2", "v -0.52"]);
    fails(
        with_rows(&[&model("rack_pinion")], "u,v\n5deg,1deg\n"),
        2,
        &["column v", "1deg"],
    );
}

#[test]
fn orientations_are_refused_where_they_are_no_coordinate() {
    let file = mechanism();
    for (pair, class) in [("frame,link", "lower"), ("driver,link", "fixed-axes")] {
        for command in ["info", "compute"] {
            let args = [command, &file, "--pair", pair, "--window", "0,1"];
            fails(cspace(&args), 2, &[pair, class, "window", "--general"]);
        }
        let args = ["classify", &file, "--pair", pair, "--window", "0,1"];
        let mut command = cspace(&args);
        command.write_stdin("x,y,theta,u,v\n0,0,0,0,0\n");
        fails(command, 2, &[pair, class, "--general"]);
        fails(
            cspace(&["slice", &file, "--pair", pair, "--theta", "0.1"]),
            2,
            &["--theta", pair, class, "--general"],
        );
    }
    // The commands for one pair refuse it also where the file has no other.
    let alone = model("geneva");
    let mut classify = cspace(&["classify", &alone, "--window", "0,1"]);
    classify.write_stdin("u,v\n0,0\n");
    fails(classify, 2, &["fixed-axes", "window"]);
    fails(
        cspace(&["slice", &file, "--pair", "frame,link"]),
        2,
        &["lower", "--general"],
    );
    printed(&[
        "slice",
        &file,
        "--pair",
        "driver,link",
        "--theta",
        "0.1",
        "--general",
    ]);
}

#[test]
fn surfaces_are_refused_where_there_are_none() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = mechanism();
    for (pair, class) in [("frame,link", "lower"), ("driver,link", "fixed-axes")] {
        let saved = path("saved.json");
        printed(&["export", &file, "--pair", pair, "-o", &saved]);
        for name in ["out.ply", "out.obj", "out.stl", "out.glb"] {
            let out = path(name);
            let words = [pair, class, "surface", "--general"];
            fails(
                cspace(&["export", &file, "--pair", pair, "-o", &out]),
                2,
                &words,
            );
            fails(cspace(&["export", &saved, "-o", &out]), 2, &words);
            assert!(!std::path::Path::new(&out).exists());
        }
    }
    let out = path("out.svg");
    fails(
        cspace(&["export", &file, "--pair", "frame,link", "-o", &out]),
        2,
        &["picture", "lower"],
    );
}
