//! Masses, gravity, drives, loads and springs in model files: what is read, refused and written.

use core::f64::consts::{PI, TAU};

use cspace::{Configuration, Point, Vector};
use cspace_model::{
    Drive, DriveMotion, Dynamics, Load, LoadKind, Mass, Mechanism, ModelError, PairSurface,
    PartDynamics, PartPosition, PartVelocity, Spring, SpringKind, model,
};

/// A frame that stands still, a driver that turns, a slider with limits, and a pawl that moves freely.
const PARTS: [&str; 4] = [
    "name = \"frame\"\nloops = [{ circle = 1, at = [0, 0] }]\nmotion = { type = \"fixed\" }\n",
    "name = \"driver\"\nloops = [{ circle = 1, at = [4, 0] }]\nmotion = { type = \"revolute\", center = [4, 0] }\n",
    "name = \"slider\"\nloops = [{ circle = 1, at = [8, 0] }]\n\
     motion = { type = \"prismatic\", direction = [0, 1], range = [-1, 2] }\n",
    "name = \"pawl\"\nloops = [[[0, 8], [2, 8], [2, 9], [0, 9]]]\n",
];

/// The model with these keys before, in each part, and after.
fn text(before: &str, parts: [&str; 4], after: &str) -> String {
    let tables = PARTS.iter().zip(parts);
    let tables: String = tables
        .map(|(part, more)| format!("[[part]]\n{part}{more}\n"))
        .collect();
    format!("{before}\n{tables}{after}\n")
}

fn all_of_it() -> String {
    text(
        "gravity = [0, -9810]\nfriction = 0.1\nrestitution = 0.4",
        [
            "mass = 3",
            "density = 0.5\nstart = \"90deg\"",
            "rate = -2.5\nstart = 1\nmass = 0.2\ninertia = 0.75\ncenter_of_mass = [8, 0.25]",
            "mass = 0.076\nstart = [1, 2, \"180deg\"]\nrate = [3, 4, \"0.5turn\"]",
        ],
        "[[pair]]\nfixed = \"frame\"\nmoving = \"pawl\"\nfriction = 0.3\n\
         [[pair]]\nfixed = \"driver\"\nmoving = \"pawl\"\nrestitution = 1\n\
         [[pair]]\nfixed = \"slider\"\nmoving = \"pawl\"\n\
         [[drive]]\npart = \"driver\"\nrate = \"360deg\"\n\
         [[load]]\npart = \"pawl\"\nforce = [0, -3]\n\
         [[load]]\npart = \"pawl\"\nforce = [0, -3]\nat = [1, 8.5]\n\
         [[load]]\npart = \"driver\"\ntorque = 0.5\n\
         [[spring]]\nparts = [\"pawl\", \"driver\"]\nat = [[0, 8], [4, 1]]\nstiffness = 20\nlength = 6\ndamping = 0.1\n\
         [[spring]]\nparts = [\"pawl\"]\nat = [[0, 8], [3, 4]]\nstiffness = 20\n\
         [[spring]]\ntype = \"torsion\"\nparts = [\"driver\"]\nstiffness = 5\nangle = \"-90deg\"",
    )
}

fn read(text: &str) -> Mechanism {
    model::from_toml(text, "m.toml").unwrap_or_else(|e| panic!("{e}: {text}"))
}

#[test]
fn every_key_is_read() {
    let model = read(&all_of_it());
    let none = PartDynamics::default();
    let planar = Configuration::new(1.0, 2.0, PI);
    let linear = Vector::new(3.0, 4.0);
    let angular = PI;
    let spring = |other, at, length, damping| Spring {
        part: 3,
        other,
        kind: SpringKind::Linear {
            at,
            stiffness: 20.0,
            length,
            damping,
        },
    };
    let end = Point::new(0.0, 8.0);
    let force = Vector::new(0.0, -3.0);
    let load = |at| Load {
        part: 3,
        kind: LoadKind::Force { force, at },
    };
    let expected = Dynamics {
        gravity: Vector::new(0.0, -9810.0),
        friction: 0.1,
        restitution: 0.4,
        parts: vec![
            PartDynamics {
                mass: Some(Mass::Total(3.0)),
                ..none
            },
            PartDynamics {
                mass: Some(Mass::Density(0.5)),
                start: Some(PartPosition::Axis(PI / 2.0)),
                ..none
            },
            PartDynamics {
                mass: Some(Mass::Total(0.2)),
                inertia: Some(0.75),
                center_of_mass: Some(Point::new(8.0, 0.25)),
                start: Some(PartPosition::Axis(1.0)),
                rate: Some(PartVelocity::Axis(-2.5)),
            },
            PartDynamics {
                mass: Some(Mass::Total(0.076)),
                start: Some(PartPosition::Planar(planar)),
                rate: Some(PartVelocity::Planar { linear, angular }),
                ..none
            },
        ],
        pairs: vec![
            PairSurface {
                parts: (0, 3),
                friction: Some(0.3),
                restitution: None,
            },
            PairSurface {
                parts: (1, 3),
                friction: None,
                restitution: Some(1.0),
            },
        ],
        drives: vec![Drive {
            part: 1,
            motion: DriveMotion::Rate(TAU),
        }],
        loads: vec![
            load(None),
            load(Some(Point::new(1.0, 8.5))),
            Load {
                part: 1,
                kind: LoadKind::Torque(0.5),
            },
        ],
        springs: vec![
            spring(Some(1), (end, Point::new(4.0, 1.0)), 6.0, 0.1),
            // Without a length it is at rest as it is drawn.
            spring(None, (end, Point::new(3.0, 4.0)), 5.0, 0.0),
            Spring {
                part: 1,
                other: None,
                kind: SpringKind::Torsion {
                    stiffness: 5.0,
                    angle: -PI / 2.0,
                    damping: 0.0,
                },
            },
        ],
    };
    assert_eq!(model.dynamics, expected);
    model.check().unwrap();
}

#[test]
fn tables_have_angles_or_lengths() {
    let table = |part: &str, table: &str| {
        let drive = format!("[[drive]]\npart = \"{part}\"\ntable = {table}");
        let model = read(&text("", [""; 4], &drive));
        let DriveMotion::Table(points) = &model.dynamics.drives[0].motion else {
            panic!("a table");
        };
        points.clone()
    };
    assert_eq!(
        table("driver", "[[0, 0], [0.5, \"90deg\"], [2, 3]]"),
        [(0.0, 0.0), (0.5, PI / 2.0), (2.0, 3.0)]
    );
    assert_eq!(
        table("slider", "[[-1, -1], [0.5, 2]]"),
        [(-1.0, -1.0), (0.5, 2.0)]
    );
}

#[test]
fn what_is_written_is_read_as_it_was() {
    let table = "[[drive]]\npart = \"slider\"\ntable = [[0, 0.1], [0.1, 1e-9], [0.3, 1.9]]";
    for text in [
        all_of_it(),
        text("", [""; 4], table),
        text("friction = 0.1", [""; 4], ""),
    ] {
        let model = read(&text);
        let toml = model::to_toml(&model);
        assert_eq!(model::from_toml(&toml, "m.toml").unwrap(), model, "{toml}");
        let json = model::to_json(&model);
        assert_eq!(model::from_json(&json, "m.json").unwrap(), model, "{json}");
        // Through the data of the library, too.
        let data = serde_json::to_string(&model).unwrap();
        assert_eq!(serde_json::from_str::<Mechanism>(&data).unwrap(), model);
    }
}

#[test]
fn pairs_are_written_for_their_friction() {
    let own = |i: usize, j: usize| {
        format!(
            "[[pair]]\nfixed = {}\nmoving = {}\nfriction = 0\n",
            name(i),
            name(j)
        )
    };
    let every: String = (0..4)
        .flat_map(|i| (i + 1..4).map(move |j| own(i, j)))
        .collect();
    let model = read(&text("friction = 0.5", [""; 4], &every));
    assert_eq!(model.pairs, model.every_two());
    let again = read(&model::to_toml(&model));
    assert_eq!(again, model);
    assert_eq!(again.dynamics.friction_between(2, 1), 0.0);
}

fn name(part: usize) -> String {
    format!("\"{}\"", ["frame", "driver", "slider", "pawl"][part])
}

/// A model without any of it is what it was: nothing is stored, nothing written.
#[test]
fn shapes_alone_have_no_dynamics() {
    let model = read(&text("", [""; 4], ""));
    assert!(model.dynamics.is_none());
    let written = model::to_toml(&model);
    for key in [
        "gravity",
        "friction",
        "mass",
        "start",
        "rate =",
        "[[drive]]",
        "[[load]]",
        "[[spring]]",
    ] {
        assert!(!written.contains(key), "{key}");
    }
    let data = serde_json::to_value(&model).unwrap();
    assert_eq!(data.get("dynamics"), None);
}

/// Asserts that the model is refused in TOML and in JSON, at this line of the TOML, and that error and help have all the words.
#[track_caller]
fn refused(toml: &str, line_has: &str, words: &[&str]) {
    let error = model::from_toml(toml, "m.toml").unwrap_err();
    says(&error, words);
    let line = error.line().and_then(|l| toml.lines().nth(l - 1));
    assert!(
        line.is_some_and(|l| l.contains(line_has)),
        "{line:?}: {error}"
    );
    if let Ok(tree) = toml::from_str::<serde_json::Value>(toml)
        && !toml.contains("nan")
        && !toml.contains("inf\n")
    {
        let error = model::from_json(&tree.to_string(), "m.json").unwrap_err();
        says(&error, words);
        assert!(error.line().is_some());
    }
}

#[track_caller]
fn says(error: &ModelError, words: &[&str]) {
    let all = format!("{error} | {}", error.help().unwrap_or_default());
    for w in words {
        assert!(all.contains(w), "{w:?} is not in: {all}");
    }
}

#[test]
fn wholes_and_parts_are_refused() {
    let whole = |line: &str, words: &[&str]| refused(&text(line, [""; 4], ""), line, words);
    whole(
        "gravity = 9.81",
        &["`gravity` is the number 9.81", "gravity = [1.5, -2]"],
    );
    whole("gravity = [0, nan]", &["`gravity`", "finite"]);
    whole(
        "friction = -0.1",
        &["m.", "`friction`: -0.1 is negative", "0 or more"],
    );
    whole(
        "restitution = 1.5",
        &["`restitution`: 1.5 is not from 0 to 1", "bounce"],
    );
    whole(
        "gravty = [0, -1]",
        &["unknown key \"gravty\"", "did you mean `gravity`?"],
    );
    whole("drive = 3", &["`drive` is the number 3", "[[drive]]"]);

    let pawl = |line: &str, words: &[&str]| refused(&text("", ["", "", "", line], ""), line, words);
    let name = "part 3 \"pawl\"";
    pawl(
        "mass = 0",
        &[name, "`mass`: 0.0 is not positive", "above 0"],
    );
    pawl("mass = -1", &[name, "`mass`: -1.0 is not positive"]);
    pawl("mass = inf", &[name, "`mass` is the number inf", "finite"]);
    pawl(
        "mass = \"1 kg\"",
        &[name, "in \"1 kg\": an operator is missing before \"kg\""],
    );
    pawl("density = 0", &[name, "`density`: 0.0 is not positive"]);
    pawl(
        "inertia = 2",
        &[name, "inertia and no mass", "mass or a density"],
    );
    pawl(
        "center_of_mass = [1]",
        &[name, "`center_of_mass`", "[x, y]"],
    );
    pawl(
        "start = 3",
        &[
            name,
            "`start` has the number 3",
            "moves freely",
            "[x, y, theta]",
        ],
    );
    pawl(
        "start = [1, 2]",
        &[name, "a list of 2 items", "[x, y, theta]"],
    );
    pawl(
        "start = [1, 2, \"3 grad\"]",
        &[name, "\"3 grad\"", "deg, rad and turn"],
    );
    pawl(
        "start = [1, \"2deg\", 3]",
        &[name, "\"2deg\"", "a finite number"],
    );
    pawl("start = [1, 2, 2e6]", &[name, "2000000 rad", "whole turns"]);
    pawl(
        "rate = [1, 2, 3, 4]",
        &[name, "a list of 4 items", "[vx, vy, omega]"],
    );
    let both = text("", ["", "", "", "mass = 1\ndensity = 2"], "");
    refused(
        &both,
        "density = 2",
        &[name, "`mass` and `density` are both given", "keep one"],
    );
    let zero = text("", ["", "", "", "mass = 1\ninertia = 0"], "");
    refused(
        &zero,
        "inertia = 0",
        &[name, "`inertia`: 0.0 is not positive"],
    );

    let wheel =
        |line: &str, words: &[&str]| refused(&text("", ["", line, "", ""], ""), line, words);
    wheel(
        "start = [1, 2, 3]",
        &["part 1 \"driver\"", "a list of 3 items", "one number"],
    );
    wheel(
        "rate = [1, 2, 3]",
        &["part 1 \"driver\"", "a list of 3 items", "one number"],
    );
    wheel(
        "rate = \"fast\"",
        &["part 1 \"driver\"", "no parameter \"fast\""],
    );
    let slider =
        |line: &str, words: &[&str]| refused(&text("", ["", "", line, ""], ""), line, words);
    slider(
        "start = \"5deg\"",
        &["part 2 \"slider\"", "a finite number"],
    );
    slider(
        "start = 2.5",
        &["part 2 \"slider\"", "outside of the range", "-1.0 to 2.0"],
    );
    let frame =
        |line: &str, words: &[&str]| refused(&text("", [line, "", "", ""], ""), line, words);
    frame(
        "start = 1",
        &["part 0 \"frame\"", "`start`: the part stands still"],
    );
    frame(
        "rate = 1",
        &["part 0 \"frame\"", "`rate`: the part stands still"],
    );
}

#[test]
fn pairs_are_refused() {
    let pair = |line: &str, words: &[&str]| {
        let pair = format!("[[pair]]\nfixed = \"frame\"\nmoving = \"slider\"\n{line}");
        refused(&text("", [""; 4], &pair), line, words);
    };
    pair("friction = -1", &["pair 0", "`friction`: -1.0 is negative"]);
    pair(
        "restitution = -0.5",
        &["pair 0", "`restitution`: -0.5 is not from 0 to 1"],
    );
    pair("frction = 1", &["pair 0", "did you mean `friction`?"]);
}

#[test]
fn drives_are_refused() {
    let drive = |keys: &str, line: &str, words: &[&str]| {
        refused(
            &text("", [""; 4], &format!("[[drive]]\n{keys}")),
            line,
            words,
        );
    };
    drive("rate = 1", "[[drive]]", &["drive 0", "`part` is missing"]);
    drive(
        "part = \"drivr\"\nrate = 1",
        "drivr",
        &["drive 0", "no part named \"drivr\"", "`driver`"],
    );
    drive(
        "part = \"pawl\"\nrate = 1",
        "pawl",
        &["drive 0", "moves freely", "revolute or prismatic"],
    );
    drive(
        "part = \"frame\"\nrate = 1",
        "frame",
        &["drive 0", "stands still"],
    );
    drive(
        "part = \"driver\"",
        "[[drive]]",
        &["drive 0", "`rate` is missing", "table"],
    );
    drive(
        "part = \"driver\"\nrate = 1\ntable = [[0, 0], [1, 1]]",
        "table",
        &["both given", "keep one"],
    );
    drive(
        "part = \"slider\"\nrate = \"5deg\"",
        "5deg",
        &["drive 0", "a finite number"],
    );
    drive(
        "part = \"driver\"\ntable = [[0, 0]]",
        "table",
        &["drive 0", "a table of one point", "two points"],
    );
    drive(
        "part = \"driver\"\ntable = []",
        "table",
        &["drive 0", "a table of 0 points"],
    );
    drive(
        "part = \"driver\"\ntable = [[0, 0], [1, 1, 1]]",
        "table",
        &["drive 0", "a list of 3 items", "[t, u]"],
    );
    let words = [
        "drive 0",
        "the time 1.0 of point 2 is not after",
        "order the points",
    ];
    drive(
        "part = \"driver\"\ntable = [[0, 0], [1, 1], [1, 2]]",
        "table",
        &words,
    );
    drive(
        "part = \"driver\"\ntable = [[0, 0], [1, 1], [0.5, 2]]",
        "table",
        &["the time 0.5 of point 2"],
    );
    drive(
        "part = \"slider\"\ntable = [[0, 0], [1, 7]]",
        "table",
        &["outside of the range"],
    );
    let twice = "part = \"driver\"\nrate = 1\n[[drive]]\npart = \"driver\"\nrate = 2";
    drive(
        twice,
        "part = \"driver\"",
        &["drive 1", "drive 0 drives the same part", "keep one"],
    );
    let rate = text(
        "",
        ["", "rate = 2", "", ""],
        "[[drive]]\npart = \"driver\"\nrate = 1",
    );
    refused(
        &rate,
        "rate = 2",
        &["part 1 \"driver\"", "drive 0 already says it"],
    );
    let table = "[[drive]]\npart = \"driver\"\ntable = [[0, 0], [1, 1]]";
    let start = text("", ["", "start = 2", "", ""], table);
    refused(
        &start,
        "start = 2",
        &["part 1 \"driver\"", "drive 0 already says it"],
    );
    // By a rate it goes on from where it starts.
    read(&text(
        "",
        ["", "start = 2", "", ""],
        "[[drive]]\npart = \"driver\"\nrate = 1",
    ));
}

#[test]
fn loads_are_refused() {
    let load = |keys: &str, line: &str, words: &[&str]| {
        refused(
            &text("", [""; 4], &format!("[[load]]\n{keys}")),
            line,
            words,
        );
    };
    load(
        "force = [1, 2]",
        "[[load]]",
        &["load 0", "`part` is missing"],
    );
    load(
        "part = \"pawl\"",
        "[[load]]",
        &["load 0", "`force` is missing", "torque"],
    );
    load(
        "part = \"pawl\"\nforce = 3",
        "force",
        &["load 0", "`force` is the number 3", "[x, y]"],
    );
    load(
        "part = \"pawl\"\nforce = [0, 1]\ntorque = 2",
        "torque",
        &["both given", "two loads"],
    );
    load(
        "part = \"pawl\"\ntorque = 1\nat = [0, 0]",
        "at =",
        &["load 0", "a torque has no point"],
    );
    load(
        "part = \"frame\"\ntorque = 1",
        "frame",
        &["load 0", "stands still"],
    );
    load(
        "part = \"pawl\"\nforces = [0, 1]",
        "forces",
        &["did you mean `force`?"],
    );
}

#[test]
fn springs_are_refused() {
    let spring = |keys: &str, line: &str, words: &[&str]| {
        refused(
            &text("", [""; 4], &format!("[[spring]]\n{keys}")),
            line,
            words,
        );
    };
    const TWO: &str = "parts = [\"pawl\", \"driver\"]\n";
    const AT: &str = "at = [[0, 8], [4, 1]]\n";
    spring(
        "stiffness = 1",
        "[[spring]]",
        &["spring 0", "`parts` is missing"],
    );
    spring(
        "parts = []\nstiffness = 1",
        "parts",
        &["spring 0", "one or two names", "to the ground"],
    );
    spring(
        "parts = [\"a\"]\nstiffness = 1",
        "parts",
        &["spring 0", "no part named \"a\""],
    );
    let same = format!("parts = [\"pawl\", \"pawl\"]\n{AT}stiffness = 1");
    spring(
        &same,
        "parts",
        &["spring 0", "a part and itself", "one part alone"],
    );
    spring(
        &format!("{TWO}stiffness = 1"),
        "[[spring]]",
        &["spring 0", "`at` is missing"],
    );
    let one = format!("{TWO}at = [[0, 8]]\nstiffness = 1");
    spring(
        &one,
        "at =",
        &["spring 0", "`at` has one point", "two points"],
    );
    let flat = format!("{TWO}at = [0, 8]\nstiffness = 1");
    spring(
        &flat,
        "at =",
        &["spring 0", "`at` has the number 0", "[[x, y], [x, y]]"],
    );
    spring(
        &format!("{TWO}{AT}"),
        "[[spring]]",
        &["spring 0", "`stiffness` is missing"],
    );
    spring(
        &format!("{TWO}{AT}stiffness = 0"),
        "stiffness",
        &["does nothing"],
    );
    spring(
        &format!("{TWO}{AT}stiffness = -1"),
        "stiffness",
        &["-1.0 is negative"],
    );
    spring(
        &format!("{TWO}{AT}damping = -1"),
        "damping",
        &["-1.0 is negative"],
    );
    spring(
        &format!("{TWO}{AT}stiffness = 1\nlength = -1"),
        "length",
        &["-1.0 is negative"],
    );
    spring(
        &format!("{TWO}{AT}stiffness = 1\nangle = 1"),
        "angle",
        &["a linear spring has the keys"],
    );
    let torsion = format!("{TWO}{AT}type = \"torsion\"\nstiffness = 1");
    spring(&torsion, "at =", &["a torsion spring has the keys"]);
    let kind = format!("{TWO}{AT}type = \"torson\"\nstiffness = 1");
    spring(
        &kind,
        "type",
        &["unknown type of spring \"torson\"", "`torsion`"],
    );
    let angle = format!("{TWO}type = \"torsion\"\nstiffness = 1\nangle = \"1 grad\"");
    spring(
        &angle,
        "angle",
        &["spring 0", "in \"1 grad\"", "deg, rad and turn"],
    );
}
