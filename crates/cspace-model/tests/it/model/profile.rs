//! Deviations of form.

use cspace_model::Host;
use cspace_model::model::{Setting, Template};

const MODEL: &str = r#"
[parameter]
w = 4

[[part]]
name = "no 1"
names = { "line 0 of loop 0" = "floor" }
loops = [[[0, 0], ["w", 0], { fillet = "w/8" }, ["w", 3, 0.2], [0, 3]], { circle = 0.5, at = ["w/2", 1.5] }]
profile = "w/1000"

[[part]]
name = "drawn"
dxf = "washer.dxf"
profile = 0.05

[[part]]
name = "named"
names = { "line 0 of loop 0" = "floor" }
loops = [[[0, 0], [3, 0], [3, 3], [0, 3]]]
profile = { "floor" = 0.1, "line 2 of loop 0" = 0.2 }
"#;

/// Two circles.
const WASHER: &str = "0\nSECTION\n2\nENTITIES\n\
    0\nCIRCLE\n8\nw\n10\n0\n20\n0\n40\n5\n\
    0\nCIRCLE\n8\nw\n10\n0\n20\n0\n40\n2\n0\nENDSEC\n0\nEOF\n";

#[test]
fn outlines_are_off_by_parameters() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("washer.dxf"), WASHER).unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, MODEL).unwrap();
    let template = Template::read(&path, &Host::default()).unwrap();
    let at = |set: &[Setting]| {
        let host = Host {
            set,
            ..Host::default()
        };
        template.model(&host).unwrap()
    };
    let model = at(&[]);
    let tolerances: Vec<(&str, Option<(f64, f64)>)> = (model.parameters.iter())
        .map(|p| (p.name.as_str(), p.deviations))
        .collect();
    assert_eq!(
        tolerances,
        [
            ("drawn_profile", Some((0.05, 0.05))),
            ("named_floor_profile", Some((0.1, 0.1))),
            ("named_line_2_of_loop_0_profile", Some((0.2, 0.2))),
            ("w", None),
        ]
    );
    let pi = core::f64::consts::PI;
    let washer = at(&[Setting::number("drawn_profile", -0.1)]);
    let area = washer.mechanism.parts[1].part.area();
    assert!((area - pi * (4.9 * 4.9 - 2.1 * 2.1)).abs() < 1e-12);
    let named = at(&[
        Setting::number("named_floor_profile", 0.5),
        Setting::number("named_line_2_of_loop_0_profile", -0.25),
    ]);
    let part = &named.mechanism.parts[2].part;
    assert!((part.area() - 3.0 * 3.25).abs() < 1e-12);
    assert!(part.feature_names().any(|(_, name)| name == "floor"));
    // Derivatives, nominal and not.
    for value in [0.0, 0.03] {
        let slopes_of = |name: &str| {
            let set = |by: f64| match name {
                "w" => vec![Setting::number("w", 4.0 + value + by)],
                _ => vec![Setting::number(name, value + by)],
            };
            let settings = set(0.0);
            let host = Host {
                set: &settings,
                ..Host::default()
            };
            let slopes = template.slopes(&host, &at(&settings), name).unwrap();
            let step = 1e-6;
            let (after, before) = (at(&set(step)), at(&set(-step)));
            let mut compared = 0;
            for (p, part) in slopes.parts.iter().enumerate() {
                for (l, outline) in part.loops.iter().enumerate() {
                    for (v, slope) in outline.iter().enumerate() {
                        let of = |m: &cspace_model::Model| {
                            let v = m.mechanism.parts[p].part.loops()[l].vertices()[v];
                            [v.x, v.y, v.bulge]
                        };
                        let (a, b) = (of(&after), of(&before));
                        for i in 0..3 {
                            let difference = (a[i] - b[i]) / (2.0 * step);
                            assert!((slope[i] - difference).abs() < 1e-7, "{name} {p} {l} {v}");
                            compared += 1;
                        }
                    }
                }
            }
            compared
        };
        assert_eq!(slopes_of("drawn_profile"), 12);
        assert_eq!(slopes_of("named_floor_profile"), 12);
        assert_eq!(slopes_of("w"), 21);
    }
}

#[test]
fn what_is_wrong_is_told_where_it_is() {
    for (from, to, expected, help) in [
        ("0.05", "-1", "part 1 \"drawn\": the number -1", "0.02"),
        ("0.05", "[]", "part 1 \"drawn\": an empty list", "0.02"),
        (
            "\"w/1000\"",
            "\"w/0\"",
            "in \"w/0\": a division by zero",
            "divisor",
        ),
        (
            "\"w/1000\"",
            "\"-w\"",
            "with the profile, edge 2 of loop 0 and edge 3",
            "smaller",
        ),
        (
            "\"w/1000\"",
            "{ floor = \"0.1\" }",
            "join smoothly",
            "the same",
        ),
        (
            "\"floor\" = 0.1",
            "\"flor\" = 0.1",
            "no edge \"flor\"",
            "did you mean `floor`?",
        ),
        (
            "\"floor\" = 0.1",
            "\"vertex 0 of loop 0\" = 0.1",
            "is a vertex",
            "beside it",
        ),
        (
            "w = 4",
            "w = 4\ndrawn_profile = 1",
            "there is another",
            "rename it",
        ),
    ] {
        assert!(MODEL.contains(from), "{from}");
        let text = MODEL
            .replace(
                "dxf = \"washer.dxf\"",
                "loops = [{ circle = 5, at = [0, 0] }]",
            )
            .replacen(from, to, 1);
        let e = cspace_model::model::from_toml(&text, "m.toml").unwrap_err();
        assert!(e.to_string().contains(expected), "{e}");
        assert!(e.to_string().starts_with("m.toml:"), "{e}");
        assert!(
            e.help().unwrap_or_default().contains(help),
            "{e}: {:?}",
            e.help()
        );
    }
}

/// A side of an unequal tolerance that is not given is 0.
#[test]
fn unequal_tolerances_are_as_they_are_written() {
    let of = |tolerance: &str| {
        let part = "[[part]]\nname = \"a\"\nloops = [[[0, 0], [\"w\", 0], [0, 1]]]\n";
        let text = format!("[parameter]\nw = {{ value = 4, {tolerance} }}\n{part}");
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("model.toml");
        std::fs::write(&path, text).unwrap();
        let template = Template::read(&path, &Host::default()).unwrap();
        template.model(&Host::default()).unwrap().parameters[0].deviations
    };
    // Below and above.
    assert_eq!(of("tol = 0.25"), Some((0.25, 0.25)));
    assert_eq!(of("plus = 0.5"), Some((0.0, 0.5)));
    assert_eq!(of("minus = 0.5"), Some((0.5, 0.0)));
    assert_eq!(of("plus = 0.25, minus = 0.5"), Some((0.5, 0.25)));
    assert_eq!(of("limits = [3.5, 4.25]"), Some((0.5, 0.25)));
}
