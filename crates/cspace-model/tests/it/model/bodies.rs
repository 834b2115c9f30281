//! Parts joined rigidly are one body: what a file may say of it, and what is written of it.

use cspace::pair::Joint;
use cspace::part::PartFeature;
use cspace::{Axis, Part, Point};
use cspace_model::model::Template;
use cspace_model::{Host, Mass, Mechanism, model};

use super::errors::{error, says};

fn part(name: &str, x: f64, more: &str) -> String {
    format!(
        "[[part]]\nname = \"{name}\"\nloops = [[[{x}, 0], [{}, 0], [{}, 2], [{x}, 2]]]\n{more}\n",
        x + 2.0,
        x + 2.0
    )
}

fn weld(a: &str, b: &str) -> String {
    format!("[[joint]]\ntype = \"rigid\"\nparts = [\"{a}\", \"{b}\"]\n")
}

fn read(text: &str) -> Mechanism {
    let mechanism = model::from_toml(text, "m.toml").unwrap();
    mechanism.check().unwrap();
    mechanism
}

const TURNS: &str = "motion = { type = \"revolute\", center = [0, 1] }";

#[test]
fn every_connected_set_is_one_part_in_the_place_of_its_first() {
    let text = [
        part("x", -9.0, "motion = { type = \"fixed\" }"),
        part("c", 1.0, ""),
        part("y", 20.0, ""),
        part("a", 0.0, TURNS),
        part("b", 2.0, TURNS),
        "[[joint]]\ntype = \"revolute\"\nparts = [\"x\", \"b\"]\nat = [0, 1]\n".to_owned(),
        weld("a", "b"),
        weld("b", "c"),
        weld("a", "c"),
    ];
    let mechanism = read(&text.concat());
    let names: Vec<_> = mechanism.parts.iter().map(|p| p.part.name()).collect();
    assert_eq!(names, ["x", "c + a + b", "y"]);
    let body = &mechanism.parts[1];
    assert_eq!(body.axis, Some(Axis::revolute(Point::new(0.0, 1.0))));
    let drawn = body.drawn();
    let square = |x: f64| Part::rectangle("", (x + 1.0, 1.0), 2.0, 2.0).unwrap();
    for (member, (name, x)) in drawn.iter().zip([("c", 1.0), ("a", 0.0), ("b", 2.0)]) {
        assert_eq!(member.name(), name);
        assert_eq!(member.loops(), square(x).loops());
        assert_eq!(mechanism.part_index(name), Some(1));
    }
    // Every two parts of which none are members of one body.
    let pairs: Vec<_> = mechanism
        .pairs
        .iter()
        .map(|p| (p.fixed, p.moving))
        .collect();
    assert_eq!(pairs, [(0, 1), (0, 2), (1, 2)]);
    assert_eq!(mechanism.joints.len(), 1);
    assert_eq!(mechanism.joints[0].parts, (0, 1));
    assert!(matches!(mechanism.joints[0].joint, Joint::Revolute { .. }));
}

#[test]
fn what_is_said_of_a_member_is_said_of_the_body() {
    let text = [
        part("x", -9.0, "motion = { type = \"fixed\" }"),
        part(
            "a",
            0.0,
            "names = { \"line 0 of loop 0\" = \"foot\" }\nstart = 0.25\nsymmetry = 4",
        ),
        part(
            "b",
            2.0,
            &format!("{TURNS}\nnames = {{ \"line 2 of loop 0\" = \"top\" }}"),
        ),
        weld("a", "b"),
        "[[pair]]\nfixed = \"x\"\nmoving = \"a\"\nfriction = 0.5\n".to_owned(),
        "[[drive]]\npart = \"a\"\nrate = 1\n[[load]]\npart = \"b\"\ntorque = 1\n".to_owned(),
        "[[spring]]\nparts = [\"x\", \"a + b\"]\nat = [[0, 0], [1, 0]]\nstiffness = 1\n".to_owned(),
        "[[requirement]]\nname = \"r\"\npair = [\"x\", \"b\"]\nmeasure = \"clearance\"\n"
            .to_owned(),
    ];
    let template = Template::from_text(text.concat(), "m.toml").unwrap();
    let read = template.model(&Host::default()).unwrap().mechanism;
    let (body, dynamics) = (&read.parts[1], &read.dynamics);
    assert_eq!(body.symmetry, None);
    assert_eq!(dynamics.drives[0].part, 1);
    assert_eq!(dynamics.loads[0].part, 1);
    assert_eq!(dynamics.springs[0].other, Some(1));
    assert_eq!(dynamics.friction_between(0, 1), 0.5);
    assert!(dynamics.part(1).start.is_some());
    let edge = |loop_index, index| PartFeature::Edge { loop_index, index };
    assert_eq!(body.part.feature_name(edge(0, 0)), Some("foot"));
    assert_eq!(body.part.feature_name(edge(1, 2)), Some("top"));
}

/// Masses about a common centre, beside sums over the members by hand.
#[test]
fn masses_add_up_about_the_common_centre() {
    let text = [
        part("a", 0.0, "mass = 3"),
        part("b", 2.0, "density = 0.25\ninertia = 7"),
        part("c", 40.0, ""),
        weld("a", "b"),
        weld("c", "b"),
    ];
    let mechanism = read(&text.concat());
    let of = mechanism.mass_properties(0).unwrap();
    // 3 kg at (1, 1) and 1 kg at (3, 1): at 1.5; (3 (2² + 2²)/12 + 3·0.5²) + (7 + 1·1.5²).
    assert_eq!(of.mass, 4.0);
    assert!((of.center - Point::new(1.5, 1.0)).length() < 1e-15);
    assert!(
        (of.inertia - (2.0 + 0.75 + 7.0 + 2.25)).abs() < 1e-13,
        "{}",
        of.inertia
    );
}

#[test]
fn what_is_written_is_read_as_the_same_body() {
    let text = [
        part("a", 0.0, "mass = 3\nz = [0, 4]"),
        part(
            "b",
            1.0,
            &format!("{TURNS}\ndensity = 0.25\nnames = {{ \"line 2 of loop 0\" = \"top\" }}"),
        ),
        part("x", -9.0, ""),
        part("c", 40.0, "start = 0.25"),
        weld("a", "b"),
        weld("c", "b"),
        "[[load]]\npart = \"b\"\nforce = [1, 0]\n".to_owned(),
    ];
    let mechanism = read(&text.concat());
    let written = model::to_toml(&mechanism);
    assert_eq!(
        model::from_toml(&written, "m.toml").unwrap(),
        mechanism,
        "{written}"
    );
    let json = model::to_json(&mechanism);
    assert_eq!(model::from_json(&json, "m.json").unwrap(), mechanism);
    // A density that is given of the body is that of all its members.
    let mut dense = mechanism;
    dense.dynamics.part_mut(0).mass = Some(Mass::Density(2.0));
    dense.dynamics.part_mut(0).inertia = None;
    let again = model::from_toml(&model::to_toml(&dense), "m.toml").unwrap();
    assert_eq!(again.mass_properties(0), dense.mass_properties(0));
}

/// Derivatives by a parameter of one member are those of the body's loops.
#[test]
fn derivatives_are_those_of_all_loops() {
    let text = format!(
        "[parameter]\nr = 1\n{}[[part]]\nname = \"x\"\nloops = [{{ circle = 1, at = [9, 9] }}]\n[[part]]\nname = \"b\"\nloops = [{{ circle = \"r\", at = [0, 0] }}]\n{}",
        part(
            "a",
            0.0,
            "motion = { type = \"revolute\", center = [\"2*r\", 0] }"
        ),
        weld("b", "a")
    );
    let template = Template::from_text(text, "m.toml").unwrap();
    let read = template.model(&Host::default()).unwrap();
    assert_eq!(read.parameters[0].used_by, ["part \"a\"", "part \"b\""]);
    let slopes = template.slopes(&Host::default(), &read, "r").unwrap();
    assert_eq!(slopes.parts.len(), 2);
    assert_eq!(slopes.parts[0].loops[0], [[0.0; 3]; 4]);
    assert_eq!(slopes.parts[0].loops[1][0], [-1.0, 0.0, 0.0]);
    assert_eq!(slopes.parts[0].axis, Some([2.0, 0.0]));
    assert!(slopes.parts[1].loops.is_empty());
}

#[test]
fn contradictions_are_refused_where_they_are() {
    let two = |a: &str, b: &str, more: &str| {
        let text = [part("a", 0.0, a), part("b", 2.0, b), part("c", 9.0, "")];
        error(&(text.concat() + &weld("a", "b") + more))
    };
    let slides = "motion = { type = \"prismatic\", direction = [1, 0] }";
    for (a, b) in [
        (TURNS, slides),
        (TURNS, "motion = { type = \"planar\" }"),
        (
            TURNS,
            "motion = { type = \"revolute\", center = [0, 1], range = [0, 1] }",
        ),
        ("motion = { type = \"fixed\" }", TURNS),
    ] {
        let words = [
            "m.toml:8:10",
            "part 1 \"b\"",
            "part 0 \"a\"",
            "`motion`",
            "one of them",
        ];
        says(&two(a, b, ""), &words);
    }
    says(
        &two("start = [1, 0, 0]", "start = [2, 0, 0]", ""),
        &["part 1 \"b\"", "`start`"],
    );
    says(
        &two("rate = [1, 0, 0]", "rate = [2, 0, 0]", ""),
        &["part 1 \"b\"", "`rate`"],
    );
    let centers = ["center_of_mass = [1, 0]", "center_of_mass = [2, 0]"];
    says(&two(centers[0], centers[1], ""), &["`center_of_mass`"]);
    // What is wrong of one member is not made good by another.
    says(
        &two("mass = 3", "inertia = 1", ""),
        &["part 1 \"b\"", "no mass"],
    );
    says(
        &two(TURNS, "start = [1, 0, 0]", ""),
        &["part 1 \"b\"", "`start`"],
    );
    let driven = "[[drive]]\npart = \"a\"\nrate = 1\n";
    says(
        &two(TURNS, "rate = 2", driven),
        &["part 1 \"b\"", "drive 0 already"],
    );
    says(
        &two(
            "",
            "",
            "[[joint]]\ntype = \"revolute\"\nparts = [\"b\", \"a\"]\nat = [0, 0]\n",
        ),
        &["joint 1", "one body"],
    );
    let hinge = "[[joint]]\ntype = \"revolute\"\nat = [0, 0]\n";
    let hinges = format!("{hinge}parts = [\"a\", \"c\"]\n{hinge}parts = [\"b\", \"c\"]\n");
    says(&two("", "", &hinges), &["joint 2", "same parts as joint 1"]);
    let pair = |a: &str, b: &str| format!("[[pair]]\nfixed = \"{a}\"\nmoving = \"{b}\"\n");
    says(
        &two("", "", &pair("a", "b")),
        &["pair 0", "one body", "remove this pair"],
    );
    let both = pair("a", "c") + &pair("b", "c");
    says(&two("", "", &both), &["pair 1", "pair 0", "joined rigidly"]);
    let names = "names = { \"line 0 of loop 0\" = \"foot\" }";
    says(
        &two(names, names, ""),
        &["joint 0", "foot", "a name of its own"],
    );
    let spring = "[[spring]]\nparts = [\"a\", \"b\"]\nat = [[0, 0], [1, 0]]\nstiffness = 1\n";
    says(&two("", "", spring), &["spring 0"]);
    let text = part("a", 0.0, "") + &part("b", 1.0, "") + &part("a + b", 9.0, "") + &weld("a", "b");
    says(&error(&text), &["joint 0", "a + b", "another name"]);
    let many: Vec<String> = (0..17)
        .map(|i| part(&format!("p{i}"), 3.0 * f64::from(i), ""))
        .collect();
    let welds: Vec<String> = (1..17).map(|i| weld("p0", &format!("p{i}"))).collect();
    says(
        &error(&(many.concat() + &welds.concat())),
        &["joint 0", "17 layers", "16"],
    );
    // Of an outline, the part itself is named.
    let bad = "[[part]]\nname = \"a\"\nloops = [[[0, 0], [1, 0]]]\n";
    says(
        &error(&(bad.to_owned() + &part("b", 0.0, "") + &weld("a", "b"))),
        &["part 0 \"a\""],
    );
}

/// A part without a motion beside one on an axis is named, unless something says that it moves.
#[test]
fn parts_that_lack_a_motion_are_noted() {
    let notes = |text: String| {
        let template = Template::from_text(text, "m.toml").unwrap();
        template.model(&Host::default()).unwrap().on_pairs
    };
    let beside = |of_b: &str, more: &str| {
        let all = [part("a", 0.0, TURNS), part("b", 9.0, of_b), more.to_owned()];
        notes(all.concat())
    };
    let found = beside("", "");
    assert_eq!(found.len(), 1);
    for words in [
        "m.toml:5:1: part 1 \"b\"",
        "axis of \"a\"",
        "motion = { type = \"fixed\" }",
    ] {
        assert!(found[0].contains(words), "{found:?}");
    }
    let hinge = "[[joint]]\ntype = \"revolute\"\nparts = [\"a\", \"b\"]\nat = [0, 0]\n";
    let load = "[[load]]\npart = \"b\"\ntorque = 1\n";
    for (of_b, more) in [
        ("motion = { type = \"fixed\" }", ""),
        ("motion = { type = \"planar\" }", ""),
        ("mass = 1", ""),
        ("", hinge),
        ("", load),
        ("", &*weld("a", "b")),
    ] {
        assert!(beside(of_b, more).is_empty(), "{of_b} {more}");
    }
    // Without an axis, and in no pair with one, there is nothing to lose.
    assert!(notes(part("a", 0.0, "") + &part("b", 9.0, "")).is_empty());
    let apart = part("c", 20.0, "") + "[[pair]]\nfixed = \"b\"\nmoving = \"c\"\n";
    assert!(beside("", &apart).is_empty());
}
