//! Arcs by radius, point and centre, rounded corners and circles: their geometry, and the messages for bad ones.

use core::f64::consts::PI;

use cspace::Vertex;
use cspace_model::{ModelError, model};

fn toml(loops: &str) -> String {
    format!("[[part]]\nname = \"p\"\nloops = {loops}\n")
}

/// Loops of a part; JSON must give the same.
#[track_caller]
fn loops(loops: &str) -> Vec<Vec<Vertex>> {
    let read = model::from_toml(&toml(loops), "m.toml").unwrap();
    let keys = [
        "arc_to",
        "at",
        "radius",
        "through",
        "center",
        "direction",
        "large",
        "fillet",
        "circle",
    ];
    let mut json = loops.replace(" = ", ": ");
    for key in keys {
        json = json.replace(&format!("{key}:"), &format!("\"{key}\":"));
    }
    let json = format!(r#"{{"part": [{{"name": "p", "loops": {json}}}]}}"#);
    let mut again = model::from_json(&json, "m.json").unwrap();
    again.name.clone_from(&read.name);
    assert_eq!(again, read);
    let part = &read.parts[0].part;
    part.loops().iter().map(|l| l.vertices().to_vec()).collect()
}

#[track_caller]
fn is(found: &[Vertex], expected: &[[f64; 3]]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (v, [x, y, bulge]) in found.iter().zip(expected) {
        let off = (v.x - x)
            .abs()
            .max((v.y - y).abs())
            .max((v.bulge - bulge).abs());
        assert!(off < 1e-14, "{v:?} is not {x}, {y}, {bulge}");
    }
}

/// Bulges are tan(sweep / 4), worked out here from the sweep.
#[test]
fn each_way_of_writing_an_arc_gives_its_bulge() {
    let quarter = (PI / 8.0).tan();
    let three_quarters = (3.0 * PI / 8.0).tan();
    for (arc, bulge) in [
        // From (4, 0) to (0, 4).
        ("radius = 4", quarter),
        ("radius = 4, direction = \"ccw\"", quarter),
        ("radius = 4, direction = \"cw\"", -quarter),
        ("radius = 4, large = true", three_quarters),
        ("radius = 4, large = false", quarter),
        (
            "radius = 4, large = true, direction = \"cw\"",
            -three_quarters,
        ),
        ("center = [0, 0]", quarter),
        ("center = [0, 0], direction = \"ccw\"", quarter),
        ("center = [4, 4], direction = \"cw\"", -quarter),
        ("center = [4, 4], direction = \"ccw\"", three_quarters),
        (
            "through = [2.8284271247461903, 2.8284271247461903]",
            quarter,
        ),
        (
            "through = [6.82842712474619, 6.82842712474619]",
            three_quarters,
        ),
        ("through = [2, 2]", 0.0),
    ] {
        let found = loops(&format!(
            "[[[4, 0], {{ arc_to = [0, 4], {arc} }}, [-20, 20], [-20, -20], [20, -20]]]"
        ));
        is(
            &found[0],
            &[
                [4.0, 0.0, bulge],
                [0.0, 4.0, 0.0],
                [-20.0, 20.0, 0.0],
                [-20.0, -20.0, 0.0],
                [20.0, -20.0, 0.0],
            ],
        );
    }
}

#[test]
fn an_arc_may_close_the_loop() {
    let half = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0]];
    is(
        &loops("[[[0, 0], { arc_to = [2, 0], radius = 1 }, { arc_to = [0, 0], radius = 1 }]]")[0],
        &half,
    );
    // By a bulge, as in a loop of vertices alone.
    is(
        &loops("[[[0, 0], { arc_to = [2, 0], radius = 1 }, [0, 3, -0.25]]]")[0],
        &[[0.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 3.0, -0.25]],
    );
    is(
        &loops("[[[0, 0, 1], { at = [2, 0] }, [0, 3]]]")[0],
        &[[0.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]],
    );
}

#[test]
fn a_circle_is_a_loop() {
    let found = loops("[[[0, 0], [9, 0], [9, 9], [0, 9]], { circle = 1.5, at = [4, 5] }]");
    is(&found[1], &[[2.5, 5.0, 1.0], [5.5, 5.0, 1.0]]);
}

/// A corner of 90 degrees loses the radius at either side.
#[test]
fn fillets_round_the_vertex_before_them() {
    let quarter = (PI / 8.0).tan();
    for middle in ["[4, 0], { fillet = 1 }", "{ at = [4, 0], fillet = 1 }"] {
        let found = loops(&format!("[[[0, 0], {middle}, [4, 3], [0, 3]]]"));
        is(
            &found[0],
            &[
                [0.0, 0.0, 0.0],
                [3.0, 0.0, quarter],
                [4.0, 1.0, 0.0],
                [4.0, 3.0, 0.0],
                [0.0, 3.0, 0.0],
            ],
        );
    }
    // At the first vertex: after it, and after the edge that comes back to it.
    let first = [
        [0.0, 1.0, quarter],
        [1.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 3.0, 0.0],
    ];
    is(
        &loops("[[[0, 0], { fillet = 1 }, [4, 0], [0, 3]]]")[0],
        &first,
    );
    is(
        &loops("[[[0, 0], [4, 0], [0, 3], [0, 0], { fillet = 1 }]]")[0],
        &first,
    );
    // Of a line and an arc: a quarter of a disc of radius 4 at (4, 0), the arc's end. The fillet of radius 1 touches
    // the line y = 0 and the circle from within: its centre is at height 1 and 3 from the origin.
    let found = &loops("[[[0, 0], [4, 0], { fillet = 1 }, { arc_to = [0, 4], radius = 4 }]]")[0];
    let x = 8_f64.sqrt();
    let touch = (4.0 / 3.0 * x, 4.0 / 3.0);
    let swept = PI / 2.0 + (1.0 / 3.0_f64).asin();
    let rest = PI / 2.0 - (1.0 / 3.0_f64).asin();
    is(
        found,
        &[
            [0.0, 0.0, 0.0],
            [x, 0.0, (swept / 4.0).tan()],
            [touch.0, touch.1, (rest / 4.0).tan()],
            [0.0, 4.0, 0.0],
        ],
    );
}

#[test]
fn what_is_written_again_is_vertices() {
    let text = toml(
        "[[[0, 0], [4, 0], { fillet = 1 }, { arc_to = [0, 4], radius = 4 }], { circle = 0.5, at = [1, 1] }]",
    );
    let read = model::from_toml(&text, "m.toml").unwrap();
    let written = model::to_toml(&read);
    assert!(!written.contains('{'), "{written}");
    assert_eq!(model::from_toml(&written, "m.toml").unwrap(), read);
}

fn error(loops: &str) -> ModelError {
    model::from_toml(&toml(loops), "m.toml").unwrap_err()
}

/// Errors have place, line and column, message and help.
#[test]
fn errors_name_the_entry_and_say_what_to_do() {
    for (loops, place, column, message, help) in [
        (
            "[[[0, 0], { arc_to = [4, 0], radius = 1.5 }, [0, 3]]]",
            "loop 0, entry 1",
            19,
            "the radius 1.5 is too small, for the ends are 4.0 apart",
            "give at least 2.0",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = -2 }, [0, 3]]]",
            "loop 0, entry 1",
            19,
            "the radius is -2.0",
            "give a positive number",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], center = [1, 0] }, [0, 3]]]",
            "loop 0, entry 1",
            19,
            "the centre is 1.0 from the arc's start and 3.0 from its end",
            "move the centre to where both are equal",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], through = [5, 0] }, [0, 3]]]",
            "loop 0, entry 1",
            19,
            "no arc from (0.0, 0.0) to (4.0, 0.0) goes through (5.0, 0.0)",
            "beside the line of the ends",
        ),
        (
            "[[[0, 0], [4, 0], { fillet = 9 }, [4, 3]]]",
            "loop 0, entry 2",
            27,
            "a fillet of radius 9.0 does not fit",
            "give at most 3.0",
        ),
        (
            "[[[0, 0], { at = [4, 0], fillet = 9 }, [4, 3]]]",
            "loop 0, entry 1",
            19,
            "a fillet of radius 9.0 does not fit",
            "give at most 3.0",
        ),
        (
            "[[[0, 0], [4, 0], [4, 3], [0, 0], { fillet = 9 }]]",
            "loop 0, entry 4",
            43,
            "a fillet of radius 9.0 does not fit",
            "give at most",
        ),
        (
            "[[[0, 0], [4, 0], { fillet = 1 }, { fillet = 0.5 }, [4, 3]]]",
            "loop 0, entry 3",
            43,
            "two fillets",
            "remove one of them",
        ),
        (
            "[[{ arc_to = [4, 0], radius = 2 }, [0, 0], [0, 3]]]",
            "loop 0, entry 0",
            11,
            "begins with an arc",
            "begin with a vertex [x, y]",
        ),
        (
            "[[{ fillet = 2 }, [0, 0], [4, 0], [0, 3]]]",
            "loop 0, entry 0",
            11,
            "no vertex before it",
            "after the vertex",
        ),
        (
            "[[[0, 0], [4, 0], { filet = 1 }, [4, 3]]]",
            "loop 0, entry 2",
            29,
            "unknown key \"filet\"",
            "did you mean `fillet`?",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], raduis = 2 }, [4, 3]]]",
            "loop 0, entry 1",
            38,
            "unknown key \"raduis\"",
            "did you mean `radius`?",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0] }, [4, 3]]]",
            "loop 0, entry 1",
            19,
            "without what arc it is",
            "add one of radius = r, through = [x, y] and center = [x, y]",
        ),
        (
            "[[[0, 0], { radius = 4 }, [4, 3]]]",
            "loop 0, entry 1",
            21,
            "`radius` is given without `arc_to`",
            "{ arc_to = [x, y], radius = r }",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = 4, center = [2, 0] }, [4, 3]]]",
            "loop 0, entry 1",
            50,
            "both `radius` and `center` are given",
            "remove the other",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], through = [2, 1], direction = \"cw\" }, [4, 3]]]",
            "loop 0, entry 1",
            56,
            "unknown key \"direction\"",
            "an arc through a point has the keys arc_to, through, fillet",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = 4, direction = \"cv\" }, [4, 3]]]",
            "loop 0, entry 1",
            62,
            "unknown direction \"cv\"",
            "did you mean `cw`?",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = 4, direction = \"left\" }, [4, 3]]]",
            "loop 0, entry 1",
            62,
            "unknown direction \"left\"",
            "\"ccw\" for counter-clockwise",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = 4, large = \"yes\" }, [4, 3]]]",
            "loop 0, entry 1",
            58,
            "`large` is the text \"yes\"",
            "large = true",
        ),
        (
            "[[[0, 0], { arc_to = [4], radius = 4 }, [4, 3]]]",
            "loop 0, entry 1",
            30,
            "`arc_to` is a list of one item",
            "arc_to = [1.5, -2]",
        ),
        (
            "[[[0, 0], { arc_to = [4, 0], radius = \"4°\" }, [4, 3]]]",
            "loop 0, entry 1",
            47,
            "`radius` is the text \"4°\"",
            "radius = 2.5",
        ),
        (
            "[[[0, 0, 0.5], { arc_to = [4, 0], radius = 4 }, [4, 3]]]",
            "loop 0, entry 1",
            24,
            "given twice",
            "write vertex 0 as [x, y]",
        ),
        (
            "[[[0, 0], {}, [4, 3]]]",
            "loop 0, entry 1",
            19,
            "an empty table",
            "an arc { arc_to = [x, y], radius = r }",
        ),
        (
            "[[[0, 0], [4, 0], { arc_to = [4, 0], radius = 4 }, [4, 3]]]",
            "loop 0, entry 2",
            27,
            "at the same place as the vertex before it",
            "remove one of them",
        ),
        (
            "[[[0, 0], { circle = 4, at = [0, 0] }, [4, 3]]]",
            "loop 0, entry 1",
            21,
            "a circle among the vertices",
            "a loop of its own",
        ),
        (
            "[{ circle = -4, at = [0, 0] }]",
            "loop 0",
            21,
            "the radius is -4.0",
            "give a positive number",
        ),
        (
            "[{ circle = 4 }]",
            "loop 0",
            10,
            "`at` is missing",
            "at = [0, 0]",
        ),
        (
            "[{ circel = 4, at = [0, 0] }]",
            "loop 0",
            12,
            "unknown key \"circel\"",
            "did you mean `circle`?",
        ),
        (
            "[{ arc_to = [4, 0], radius = 4 }]",
            "loop 0",
            12,
            "unknown key \"arc_to\"",
            "is a pair of brackets missing?",
        ),
        (
            "[[[0, 0], [4], { fillet = 1 }]]",
            "loop 0, vertex 1",
            19,
            "a list of one item where a vertex is expected",
            "a vertex is [x, y] or [x, y, bulge]",
        ),
    ] {
        let error = error(loops);
        let place = format!("part 0 \"p\", {place}");
        assert_eq!(error.place(), place, "{loops}: {error}");
        assert_eq!(
            (error.line(), error.column()),
            (Some(3), Some(column)),
            "{loops}: {error}"
        );
        assert!(error.message().contains(message), "{loops}: {error}");
        let said = error.help().unwrap_or_default();
        assert!(said.contains(help), "{loops}: {said}");
    }
}

/// Errors that are found once the loop is drawn count entries, not the vertices that fillets make.
#[test]
fn errors_of_the_whole_outline_name_entries() {
    let error = error(
        "[[[0, 0], { at = [8, 0], fillet = 1 }, { at = [8, 8], fillet = 1 }, [0, 8], [4, -4]]]",
    );
    let says = "loop 0, edge 0 crosses loop 0, edge 3 near";
    assert!(error.message().starts_with(says), "{error}");
    let near = "[[[0, 0], { at = [8, 0], fillet = 1 },\n [8, 8],\n [8, 8.0000000000001], [0, 8]]]";
    let error = model::from_toml(&toml(near), "m.toml").unwrap_err();
    assert_eq!(error.line(), Some(4), "{error}");
    let says = "loop 0, vertex 2: the next vertex, 3, is at the same place";
    assert_eq!(error.message(), says);
    // With a fillet as an entry of its own, the arc's end has that entry's number.
    let cut = "[[[0, 0], [8, 0],\n { fillet = 1 },\n [8, 8], [9, 4], [0, 4]]]";
    let error = model::from_toml(&toml(cut), "m.toml").unwrap_err();
    assert_eq!(error.line(), Some(4), "{error}");
    let says = "loop 0, edge 2 crosses loop 0, edge 4 near (8.0, 4.0)";
    assert_eq!(error.message(), says);
}

/// Any text gives a part with the requested arcs, or an error with its place and advice.
#[test]
fn any_entries_give_a_part_or_an_error() {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let (mut read, mut arcs) = (0, 0);
    for _ in 0..4000 {
        let count = random.random_range(2..7);
        let mut entries = Vec::new();
        let (mut radii, mut radii_are_given) = (vec![0.1, 8.0], true);
        for i in 0..count {
            // Around a circle, so that many do not cross.
            let at = |r: &mut ChaCha8Rng| {
                let angle = 2.0 * PI * (i as f64 + r.random_range(0.0..0.6)) / f64::from(count);
                (8.0 * angle.cos(), 8.0 * angle.sin())
            };
            let (x, y) = at(&mut random);
            let r: f64 = random.random_range(-0.5..12.0);
            radii.extend([r, r / 9.0]);
            let kind = random.random_range(0..12);
            radii_are_given &= ![0, 4].contains(&kind);
            entries.push(match kind {
                0 => format!("[{x}, {y}, {}]", r / 12.0),
                1 => format!("{{ arc_to = [{x}, {y}], radius = {r} }}"),
                2 => format!(
                    "{{ arc_to = [{x}, {y}], radius = {r}, direction = \"cw\", fillet = 0.1 }}"
                ),
                3 => format!("{{ arc_to = [{x}, {y}], radius = {r}, large = true }}"),
                4 => format!(
                    "{{ arc_to = [{x}, {y}], through = [{}, {}] }}",
                    1.1 * y,
                    -1.1 * x
                ),
                5 => format!("{{ arc_to = [{x}, {y}], center = [0, 0] }}"),
                6 => format!("{{ at = [{x}, {y}], fillet = {} }}", r / 9.0),
                7 => format!("[{x}, {y}], {{ fillet = {} }}", r / 9.0),
                _ => format!("[{x}, {y}]"),
            });
        }
        let text = toml(&format!("[[\n{}\n]]", entries.join(",\n")));
        match model::from_toml(&text, "m.toml") {
            Ok(model) => {
                read += 1;
                // Where all radii are given, every arc has one of them, whatever fillets leave of it.
                for edge in model.parts[0].part.edges() {
                    if edge.bulge != 0.0 && radii_are_given {
                        arcs += 1;
                        let is = |r: &f64| (edge.radius() - r).abs() < 1e-8 * r;
                        assert!(radii.iter().any(is), "{}: {text}", edge.radius());
                    }
                }
                let again = model::from_toml(&model::to_toml(&model), "m.toml").unwrap();
                assert_eq!(again.parts, model.parts);
            }
            Err(error) => {
                assert!(error.line() >= Some(3), "{error}\n{text}");
                assert!(error.place().starts_with("part 0 \"p\""), "{error}");
                assert!(
                    !error.help().unwrap_or_default().is_empty(),
                    "{error}\n{text}"
                );
            }
        }
    }
    assert!(read > 400 && arcs > 400, "{read} {arcs}");
}

/// The centre of every copy is turned too: four dents that are no half circles.
#[test]
fn centres_of_repeated_arcs_turn_with_their_copies() {
    let text = r#"[[{ repeat = 4, about = [0, 0], path = [[10, 0], { arc_to = [0, 10], center = [12, 12], direction = "cw" }] }]]"#;
    let read = model::from_toml(&toml(text), "m.toml").unwrap();
    let found = read.parts[0].part.loops()[0].vertices().to_vec();
    // From (-2, -12) to (-12, -2) about the centre.
    let dent = -(0.25 * (48.0_f64 / 148.0).acos()).tan();
    is(
        &found,
        &[
            [10.0, 0.0, dent],
            [0.0, 10.0, dent],
            [-10.0, 0.0, dent],
            [0.0, -10.0, dent],
        ],
    );
}
