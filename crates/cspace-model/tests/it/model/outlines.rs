//! Outlines that are put somewhere, and that are united.

use core::f64::consts::PI;

use cspace::{Part, Point};
use cspace_model::model::{Setting, Template, from_toml, to_toml};
use cspace_model::{Host, Model, ModelError};

/// Two gears drawn about 0, 0, of which one is put at a centre distance that has a tolerance.
const GEARS: &str = r#"
unit = "mm"

[parameter]
distance = { value = 30, tol = 0.05 }
teeth = 10
lift = "2deg"
hub = 3

[[part]]
name = "wheel"
motion = { type = "revolute", center = [0, 0] }
loops = [
  [{ repeat = "teeth", about = [0, 0], path = [[13, -1.5], [17, -0.6, 0.05], [17, 0.6], [13, 1.5]] }],
  { circle = "hub", at = [0, 0] },
]

[[part]]
name = "pinion"
motion = { type = "revolute", center = ["distance", 0] }
place = { at = ["distance", 0], turn = "180deg/teeth + lift", mirror = "y" }
loops = [
  [{ repeat = "teeth", about = [0, 0], path = [[13, -1.5], [17, -0.6, 0.05], [17, 0.6], [13, 1.5]] }],
  { circle = "hub", at = [0, 0] },
]

[[part]]
name = "washer"
place = { at = ["distance", "-distance/2"], turn = "lift", mirror = "x" }
dxf = "washer.dxf"
offset = 0.25
profile = "(distance - 30)/10"

[[part]]
name = "lever"
place = { at = ["distance", 1], turn = "lift" }
profile = 0.01
union = [
  [ { circle = "hub + 1", at = [0, 0] }, { circle = "hub", at = [0, 0] } ],
  [ [["hub + 0.5", -1], [12, -0.75, 0.5], [12, 0.75], ["hub + 0.5", 1]] ],
  [ [[11, -6], [11.5, -6], [11.5, 6], [11, 6]] ],
]

[[part]]
name = "arbor"
layers = [
  { z = [0, 4], place = { turn = "lift" }, loops = [ [["hub + 9", 0], [0, 10], [-10, -10]], { circle = "hub", at = [0, 0] } ] },
  { z = [4, 10], place = { at = ["distance/10", 0] }, dxf = "washer.dxf" },
  { z = [9, 12], loops = [ { circle = 2, at = [0, 0] } ] },
]
"#;

/// A circle and an arm.
const WASHER: &str = "0\nSECTION\n2\nENTITIES\n\
    0\nARC\n8\nw\n10\n0\n20\n0\n40\n5\n50\n0\n51\n270\n\
    0\nLINE\n8\nw\n10\n5\n20\n0\n11\n9\n21\n0\n\
    0\nLINE\n8\nw\n10\n9\n20\n0\n11\n9\n21\n-5\n\
    0\nLINE\n8\nw\n10\n9\n20\n-5\n11\n0\n21\n-5\n0\nENDSEC\n0\nEOF\n";

struct Gears {
    template: Template,
    _folder: tempfile::TempDir,
}

impl Gears {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("washer.dxf"), WASHER).unwrap();
        let path = folder.path().join("gears.toml");
        std::fs::write(&path, GEARS).unwrap();
        Self {
            template: Template::read(&path, &Host::default()).unwrap(),
            _folder: folder,
        }
    }

    fn at(&self, set: &[(&str, f64)]) -> Model {
        let set: Vec<Setting> = set.iter().map(|(n, x)| Setting::number(*n, *x)).collect();
        let host = Host {
            set: &set,
            ..Host::default()
        };
        self.template.model(&host).unwrap()
    }
}

fn part(keys: &str) -> Result<Part, ModelError> {
    let text = format!("[[part]]\nname = \"a\"\n{keys}\n");
    from_toml(&text, "m.toml").map(|m| m.parts[0].part.clone())
}

#[test]
fn an_outline_is_mirrored_turned_and_moved() {
    let model = Gears::new().at(&[]);
    let [wheel, pinion] = [0, 1].map(|i| &model.mechanism.parts[i].part);
    let turn = (18f64 + 2.0).to_radians();
    for (a, b) in wheel.loops().iter().zip(pinion.loops()) {
        for (v, w) in a.vertices().iter().zip(b.vertices()) {
            let (x, y) = (-v.x, v.y);
            let (sin, cos) = turn.sin_cos();
            let right = Point::new(30.0 + cos * x - sin * y, sin * x + cos * y);
            assert!(w.point().distance(right) < 1e-13 && w.bulge == -v.bulge);
        }
    }
    assert!((pinion.area() - wheel.area()).abs() < 1e-10);
    // The axis is where it is given, in the assembly, and so is all else that is.
    let axis = model.mechanism.parts[1].axis.unwrap();
    assert_eq!(axis, cspace::Axis::revolute(Point::new(30.0, 0.0)));
    // Quarter turns are exact.
    let lug = part("place = { turn = \"90deg\", mirror = \"x\" }\nloops = [[[0, 0], [3, 0, 0.5], [3, 1], [0, 1]]]").unwrap();
    let at: Vec<[f64; 3]> = lug.loops()[0]
        .vertices()
        .iter()
        .map(|v| [v.x, v.y, v.bulge])
        .collect();
    assert_eq!(
        at,
        [
            [0.0, 0.0, 0.0],
            [0.0, 3.0, -0.5],
            [1.0, 3.0, 0.0],
            [1.0, 0.0, 0.0]
        ]
    );
}

#[test]
fn places_and_unions_have_the_derivatives_of_differences() {
    let gears = Gears::new();
    let all = [
        ("distance", 30.0),
        ("lift", 2f64.to_radians()),
        ("hub", 3.0),
        ("lever_profile", 0.0),
    ];
    for (name, value) in all {
        for away in [0.0, 0.02] {
            let value = value + away;
            let model = gears.at(&[(name, value)]);
            let set = [Setting::number(name, value)];
            let host = Host {
                set: &set,
                ..Host::default()
            };
            let slopes = gears.template.slopes(&host, &model, name).unwrap();
            let step = 1e-6;
            let [after, before] = [step, -step].map(|by| gears.at(&[(name, value + by)]));
            let mut moved = [0; 5];
            for (p, part) in slopes.parts.iter().enumerate() {
                let outlines = [&model, &after, &before].map(|m| m.mechanism.parts[p].part.loops());
                assert!(part.loops.is_empty() || part.loops.len() == outlines[0].len());
                for (l, outline) in outlines[0].iter().enumerate() {
                    for v in 0..outline.vertices().len() {
                        let [_, a, b] = outlines.map(|o| o[l].vertices()[v]);
                        let differences = [a.x - b.x, a.y - b.y, a.bulge - b.bulge];
                        for (i, difference) in differences.into_iter().enumerate() {
                            let difference = difference / (2.0 * step);
                            let slope = part.loops.get(l).map_or(0.0, |l| l[v][i]);
                            assert!(
                                (slope - difference).abs() < 1e-7,
                                "{name} {p} {l} {v} {i}: {slope} {difference}"
                            );
                            moved[p] += usize::from(difference.abs() > 1e-3);
                        }
                    }
                }
            }
            let is_moved = moved.map(|n| n > 0);
            let right = match name {
                "distance" | "lift" => [false, true, true, true, true],
                "hub" => [true, true, false, true, true],
                _ => [false, false, false, true, false],
            };
            assert_eq!(is_moved, right, "{name}");
        }
    }
}

#[test]
fn places_have_tight_enclosures_and_unions_that_vary_none() {
    let gears = Gears::new();
    let model = gears.at(&[]);
    let of = |name: &str, by: f64| {
        let ranges = [(name.to_owned(), -by, by)];
        gears
            .template
            .enclosures(&Host::default(), &model, name, &ranges)
            .unwrap()
    };
    let width = |part: &cspace_model::model::PartSlopes<_>| {
        let all: &Vec<Vec<[cspace::Dual<1, cspace::Ball>; 3]>> = &part.loops;
        (all.iter().flatten().flatten())
            .map(|x| x.value.radius)
            .fold(0.0, f64::max)
    };
    let placed = of("distance", 0.05);
    assert!((0.05..0.0501).contains(&width(&placed.parts[1])));
    // The lever's union is as it is, wherever it is put.
    assert!((0.05..0.0501).contains(&width(&placed.parts[3])));
    let range = [("hub".to_owned(), -0.01, 0.01)];
    let united = (gears.template).enclosures(&Host::default(), &model, "hub", &range);
    assert!(
        united
            .unwrap_err()
            .message()
            .contains("over a range of the parameter")
    );
    let point = of("hub", 0.0);
    assert!(width(&point.parts[3]) < 1e-11);
}

#[test]
fn what_is_written_is_placed_already() {
    let model = Gears::new().at(&[]).mechanism;
    let text = to_toml(&model);
    assert!(!text.contains("place") && !text.contains("union"));
    assert_eq!(from_toml(&text, "again.toml").unwrap(), model);
    // The text with other values keeps its keys.
    let gears = Gears::new();
    let template = Template::from_text(
        GEARS.replace("dxf = \"washer.dxf\"", "loops = [[[0, 0], [4, 0], [4, 4]]]"),
        "g.toml",
    )
    .unwrap();
    let text = template
        .text_with(&[Setting::number("distance", 31.0)])
        .unwrap();
    assert!(text.contains("place = { at = [\"distance\", 0]") && text.contains("value = 31"));
    drop(gears);
}

#[test]
fn names_and_profiles_are_of_the_outline_where_it_is_put() {
    let keys = "names = { \"line 0 of loop 0\" = \"floor\" }\nprofile = { floor = \"1/4\" }\nloops = [[[0, 0], [3, 0], [3, 1], [0, 1]]]";
    let made = part(&format!(
        "place = {{ mirror = \"x\", turn = \"90deg\", at = [1, 2] }}\n{keys}"
    ))
    .unwrap();
    assert!(made.feature_names().any(|(_, name)| name == "floor"));
    assert_eq!(made.area(), 3.0 * 1.25);
    let bounds = made.bounds();
    assert_eq!(
        [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y],
        [0.75, 2.0, 2.0, 5.0]
    );
}

#[test]
fn a_union_is_what_any_entry_encloses() {
    let lever = part(
        "union = [ [ { circle = 4, at = [0, 0] }, { circle = 2, at = [0, 0] } ], [ [[1, -1], [9, -1], [9, 1], [1, 1]] ], [ { circle = 2, at = [9, 0] } ] ]",
    )
    .unwrap();
    // The bar reaches into the hole: 1 to where the hole ends.
    assert_eq!(lever.loops().len(), 2);
    let segment = |r: f64| r * r * (1.0 / r).asin() + (r * r - 1.0).sqrt();
    // The bar's strip beyond the ring, between the two discs.
    let between = 2.0 * 9.0 - segment(4.0) - segment(2.0);
    let inner = segment(2.0) - 2.0;
    let right = 12.0 * PI + between + inner + 4.0 * PI;
    assert!(
        (lever.area() - right).abs() < 1e-12,
        "{} {right}",
        lever.area()
    );
    // Patterns are loops of an entry.
    let rosette = part(
        "union = [ [ { circle = 1, at = [3, 0], pattern = { count = 6, about = [0, 0] } } ], [ { circle = 3, at = [0, 0] } ] ]",
    )
    .unwrap();
    assert_eq!(
        (rosette.symmetry().fold(), rosette.edges().count()),
        (6, 18)
    );
}

#[test]
fn what_is_wrong_is_told_where_it_is() {
    let square = "[[0, 0], [1, 0], [1, 1], [0, 1]]";
    let far = "[[1, 1], [2, 1], [2, 2], [1, 2]]";
    for (keys, place, message, help) in [
        (
            format!("place = {{ at = [1] }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "`at` is",
            "at = [1.5, -2]",
        ),
        (
            format!("place = {{ turn = [1] }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "an angle is expected",
            "\"30deg\"",
        ),
        (
            format!("place = {{ turn = 2e6 }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "more than 1e6 rad",
            "whole turns",
        ),
        (
            format!("place = {{ mirror = \"z\" }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "unknown axis \"z\"",
            "`x`",
        ),
        (
            format!("place = {{ mirror = true }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "where text is expected",
            "mirror = ",
        ),
        (
            format!("place = {{ by = [1, 2] }}\nloops = [{square}]"),
            "part 0 \"a\", place",
            "unknown key \"by\"",
            "turn",
        ),
        (
            format!("place = [1, 2]\nloops = [{square}]"),
            "part 0 \"a\", place",
            "where a table is expected",
            "at = [x, y]",
        ),
        (
            format!("place = {{ at = [\"gap\", 2] }}\nloops = [{square}]"),
            "part 0 \"a\"",
            "gap",
            "",
        ),
        (
            format!("place = {{ at = [1e12, 2] }}\nloops = [{square}]"),
            "part 0 \"a\"",
            "where it is put, the outline is none",
            "nearer to the origin",
        ),
        (
            format!("union = [[{square}]]\nloops = [{square}]"),
            "part 0 \"a\"",
            "both `loops` and `union` are given",
            "one outline",
        ),
        (
            format!("union = [[{square}]]\nlayer = \"0\""),
            "part 0 \"a\"",
            "`layer` is given without",
            "remove",
        ),
        (
            "union = []".into(),
            "part 0 \"a\"",
            "an empty list where a list of outlines",
            "pair of brackets",
        ),
        (
            format!("union = [{square}]"),
            "part 0 \"a\", union entry 0",
            "where a list of loops is expected",
            "pair of brackets",
        ),
        (
            "union = [{ circle = 1, at = [0, 0] }]".into(),
            "union entry 0",
            "where a list of loops is expected",
            "pair of brackets",
        ),
        (
            format!("union = [[{square}], [[[0, 0], [1, \"x\"]]]]"),
            "union entry 1, loop 0, vertex 1",
            "x",
            "",
        ),
        (
            format!("union = [[{square}], [{far}, [[0, 0], [1, 0], [1, 0], [0, 1]]]]"),
            "union entry 1",
            "loop 1, vertex 1",
            "remove one",
        ),
        (
            format!("union = [[{square}, {square}]]"),
            "part 0 \"a\", union",
            "enclose nothing",
            "twice",
        ),
        (
            format!("union = [[{square}], [{far}]]"),
            "union entry 0, loop 0, edge",
            "touches itself near (1.0, 1.0), where union entry",
            "overlap",
        ),
        (
            "union = [[{ circle = 1, at = [0, 1] }], [[[-3, -1], [3, -1], [3, 0], [-3, 0]]], [[[0, -0.5], [2, -0.5], [2, 1.5], [0, 1.5]]]]".into(),
            "union entry",
            "cusp",
            "overlap",
        ),
    ] {
        let e = part(&keys).unwrap_err();
        assert!(e.to_string().starts_with("m.toml:"), "{keys}: {e}");
        assert!(e.place().contains(place), "{keys}: {e}");
        assert!(e.message().contains(message), "{keys}: {e}");
        assert!(
            e.help().unwrap_or_default().contains(help),
            "{keys}: {e}: {:?}",
            e.help()
        );
    }
    // Entries that lie on each other at one value of a parameter alone.
    let text = "[parameter]\nw = 1\n[[part]]\nname = \"a\"\nunion = [[[[0, 0], [\"w\", 0], [\"w\", 1], [0, 1]]], [[[1, 0], [2, 0], [2, 0.5], [1, 0.5]]]]\n";
    let template = Template::from_text(text.into(), "m.toml").unwrap();
    let model = template.model(&Host::default()).unwrap();
    let e = template.slopes(&Host::default(), &model, "w").unwrap_err();
    assert!(
        e.message().contains(
            "union entry 0, loop 0, edge 1 and union entry 1, loop 0, edge 3 lie on each other"
        ),
        "{e}"
    );
}

#[test]
fn layers_are_read_and_written() {
    let model = Gears::new().at(&[]);
    let arbor = &model.mechanism.parts[4].part;
    let z: Vec<_> = arbor.layers().iter().map(|l| l.z().unwrap()).collect();
    assert_eq!(z, [[0.0, 4.0], [4.0, 10.0], [9.0, 12.0]]);
    let counts: Vec<_> = arbor.layers().iter().map(|l| l.loops()).collect();
    assert_eq!(counts, [0..2, 2..3, 3..4]);
    let written = to_toml(&model.mechanism);
    assert_eq!(from_toml(&written, "m.toml").unwrap(), model.mechanism);
    let json = cspace_model::model::to_json(&model.mechanism);
    let read = cspace_model::model::from_json(&json, "m.json").unwrap();
    assert_eq!(read, model.mechanism);
    // Heights beside loops, with parameters; and an offset, a profile and a place of all layers.
    let square = "[[[0, 0], [2, 0], [2, 2], [0, 2]]]";
    let one = part(&format!("z = [\"1 - 2\", 3]\nloops = {square}")).unwrap();
    assert_eq!(one.layers()[0].z(), Some([-1.0, 3.0]));
    let all = part(&format!(
        "layers = [{{ z = [0, 1], loops = {square} }}, {{ z = [1, 2], place = {{ at = [1, 1] }}, loops = {square} }}]\n\
         place = {{ at = [10, 0] }}\noffset = 0.5\nnames = {{ \"line 0 of loop 1\" = \"flank\" }}"
    ))
    .unwrap();
    let bounds = [0, 1].map(|i| all.layer(i).bounds());
    assert_eq!((bounds[0].min.x, bounds[0].max.y), (9.5, 2.5));
    assert_eq!((bounds[1].min.x, bounds[1].max.y), (10.5, 3.5));
    assert_eq!(all.feature_names().count(), 1);
}

#[test]
fn bad_layers_are_refused_at_their_places() {
    let square = "[[[0, 0], [2, 0], [2, 2], [0, 2]]]";
    let cases = [
        (
            "layers = []".to_owned(),
            "layers",
            "an empty list where a list of layers",
        ),
        (
            format!("layers = {square}"),
            "layer 0",
            "where a table is expected",
        ),
        (
            format!("layers = [{{ z = [0, 1], loops = {square} }}]\nz = [0, 1]"),
            "z",
            "`z` is given beside `layers`",
        ),
        (
            format!("layers = [{{ z = [0, 1] }}]\nloops = {square}"),
            "loops",
            "`loops` is given beside `layers`",
        ),
        (format!("z = [1, 1]\nloops = {square}"), "z", "from 1 to 1"),
        (format!("z = [2, 1]\nloops = {square}"), "z", "from 2 to 1"),
        (
            format!("z = 3\nloops = {square}"),
            "z",
            "where two numbers is expected",
        ),
        (
            "layers = [{ z = [0, 1] }]".to_owned(),
            "layer 0",
            "`loops` is missing",
        ),
        (
            "layers = [{ z = [0, 1], loops = [[[0, 0], [2, 0], [2, 2], [1, -1]]] }]".to_owned(),
            "layer 0",
            "crosses",
        ),
        (
            format!("layers = [{{ z = [0, 1], name = \"b\", loops = {square} }}]"),
            "layer 0",
            "unknown key \"name\"",
        ),
    ];
    for (text, place, message) in cases {
        let e = part(&text).unwrap_err();
        let told = e.to_string();
        assert!(
            told.contains(place) && told.contains(message),
            "{text}: {told}"
        );
        assert!(e.help().is_some(), "{text}: {told}");
    }
    let many: Vec<String> = (0..17)
        .map(|i| format!("{{ z = [{i}, {}], loops = {square} }}", i + 1))
        .collect();
    let e = part(&format!("layers = [{}]", many.join(", "))).unwrap_err();
    assert!(e.to_string().contains("17 layers, more than 16"), "{e}");
}
