//! `cspace import`, drawings in models, and drawings that are written.

use std::fs;

use serde_json::Value;

use crate::helpers::{cspace, fails, json, json_beside_notes, model, printed};

fn drawing(name: &str) -> String {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../cspace-drawing/tests/drawings"
    );
    format!("{folder}/{name}")
}

/// Two gears drawn by splines, each on its layer, as a generator exports them.
fn gears(folder: &std::path::Path) -> String {
    fs::copy(drawing("gear_pair.dxf"), folder.join("gears.dxf")).unwrap();
    let part = |name: &str, layer: &str, x: f64| {
        format!(
            "[[part]]\nname = \"{name}\"\ndxf = \"gears.dxf\"\nlayer = \"{layer}\"\nfit = 0.002\n\
             motion = {{ type = \"revolute\", center = [{x}, 0] }}\n"
        )
    };
    let text = format!(
        "unit = \"mm\"\n{}{}",
        part("gear", "GEAR", 0.0),
        part("mate", "MATE", 42.0)
    );
    let path = folder.join("gears.toml");
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// The gears turn each other: 24 teeth against 18, with the play that was drawn.
#[test]
fn gears_from_a_drawing_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let model = gears(folder.path());
    let info = json(&["info", &model]);
    assert_eq!(info["parts"][0]["symmetry"], 18);
    assert_eq!(info["parts"][1]["symmetry"], 24);
    let step = std::f64::consts::TAU / 18.0 / 7.0;
    let rows: Vec<Vec<f64>> = (0..20)
        .flat_map(|k| {
            let u = f64::from(k) * step;
            // Meshing; and ahead by twice the play.
            [vec![u, -0.75 * u], vec![u + 0.005, -0.75 * u]]
        })
        .collect();
    let classes = crate::helpers::classes(&[&model], "u,v", &rows);
    for pair in classes.chunks(2) {
        assert_eq!(pair, ["free", "blocked"]);
    }
}

#[test]
fn models_are_written_as_toml_and_json() {
    let folder = tempfile::tempdir().unwrap();
    let blocks = drawing("blocks.dxf");
    let answers: Vec<Value> = ["a.toml", "a.json"]
        .map(|name| {
            let path = folder.path().join(name);
            let path = path.to_str().unwrap();
            let report = json(&["import", &blocks, "--unit", "m", "-o", path]);
            assert_eq!(report["parts"].as_array().unwrap().len(), 4);
            assert_eq!(report["used"]["LWPOLYLINE"], 4);
            let mut info = json(&["info", path]);
            assert_eq!(info["parts"][1]["name"], "PAWL 2");
            assert_eq!(info["unit"], "m");
            info.as_object_mut().unwrap().remove("model");
            info
        })
        .into();
    assert_eq!(answers[0], answers[1]);
}

#[test]
fn what_was_done_is_printed() {
    let text = printed(&["import", &drawing("texts_and_dimensions.dxf")]);
    for words in [
        "4 lines, 0 arcs",
        "1 LWPOLYLINE",
        "left out",
        "1 MTEXT",
        "a text",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let text = printed(&["import", &drawing("overlapping.dxf")]);
    assert!(
        text.contains("2 merged with what they overlapped"),
        "{text}"
    );
}

fn open_chain(folder: &std::path::Path) -> String {
    let line = |x: f64, y: f64, to: f64| {
        format!("0\nLINE\n5\nA{x}\n8\nedge\n10\n{x}\n20\n{y}\n11\n{to}\n21\n{y}\n")
    };
    let text = format!(
        "0\nSECTION\n2\nENTITIES\n{}{}0\nCIRCLE\n8\nhole\n10\n5\n20\n5\n40\n2\n0\nENDSEC\n0\nEOF\n",
        line(0.0, 0.0, 10.0),
        line(1.0, 0.05, -5.0)
    );
    let path = folder.join("open.dxf");
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn what_cannot_be_used_is_told_or_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let path = open_chain(folder.path());
    fails(
        cspace(&["import", &path]),
        2,
        &[
            "open.dxf",
            "LINE A0",
            "layer \"edge\"",
            "line 5",
            "(0, 0)",
            "open",
            "2 things",
            "--partial",
        ],
    );
    // One object, however many things are wrong.
    let refused = cspace(&["import", &path, "--json"]).output().unwrap();
    let refused: Value = serde_json::from_slice(&refused.stdout).unwrap();
    let message = refused["error"]["message"].as_str().unwrap();
    assert!(message.contains("2 things cannot be used"), "{message}");
    let report = json(&["import", &path, "--partial"]);
    assert_eq!(report["parts"].as_array().unwrap().len(), 1);
    let handles: Vec<&str> = (report["ignored"].as_array().unwrap().iter())
        .map(|i| i["handle"].as_str().unwrap())
        .collect();
    assert_eq!(handles, ["A0", "A1"]);
    let picture = folder.path().join("open.svg");
    cspace(&["draw", &path, "-q", "-o", picture.to_str().unwrap()])
        .assert()
        .success();
    let picture = fs::read_to_string(picture).unwrap();
    assert!(picture.contains("not used") && picture.contains("LINE A0"));
}

#[test]
fn units_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(drawing("unit_in.dxf"), folder.path().join("pin.dxf")).unwrap();
    let path = folder.path().join("pin.toml");
    let with = |keys: &str| {
        let text = format!("unit = \"mm\"\n[[part]]\nname = \"pin\"\ndxf = \"pin.dxf\"\n{keys}");
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let area = |keys: &str| {
        json_beside_notes(&["info", &with(keys)])["parts"][0]["area"]
            .as_f64()
            .unwrap()
    };
    let inches = std::f64::consts::PI;
    let converted = inches * 25.4 * 25.4;
    assert!((area("") - converted).abs() < 1e-9);
    // A factor is the whole factor.
    assert!((area("scale = 1\n") - inches).abs() < 1e-12);
    assert!((area("scale = 2\n") - 4.0 * inches).abs() < 1e-12);
    let notes = |args: &[&str]| {
        let output = cspace(args).assert().success().get_output().clone();
        String::from_utf8(output.stderr).unwrap()
    };
    let note = notes(&["info", &with("")]);
    for words in [
        "pin.toml:4:",
        "part 0 \"pin\"",
        "\"in\"",
        "\"mm\"",
        "by 25.4",
    ] {
        assert!(note.contains(words), "{words}: {note}");
    }
    assert_eq!(notes(&["info", &with("scale = 25.4\n")]), "");
    let pin = drawing("unit_in.dxf");
    let imported = |args: &[&str]| {
        let report = json_beside_notes(&[&["import", &pin][..], args].concat());
        let area = report["parts"][0]["area"].as_f64().unwrap();
        (report["unit"].as_str().map(str::to_owned), area)
    };
    let mm = || Some("mm".to_owned());
    let (unit, area) = imported(&["--unit", "mm"]);
    assert!(unit == mm() && (area - converted).abs() < 1e-9);
    let (unit, area) = imported(&[]);
    assert!(unit.as_deref() == Some("in") && (area - inches).abs() < 1e-12);
    assert_eq!(imported(&["--unit", "mm", "--scale", "1"]), (mm(), area));
    assert_eq!(imported(&["--scale", "2"]).0, None);
    let note = notes(&["import", &pin, "--unit", "furlong"]);
    assert!(note.contains("no known unit"), "{note}");
    // Of two drawings the second is converted to the unit of the first.
    let both = json_beside_notes(&["import", &drawing("unit_mm.dxf"), &pin]);
    assert_eq!(both["unit"], "mm");
    let area = both["parts"][1]["area"].as_f64().unwrap();
    assert!((area - converted).abs() < 1e-9, "{both}");
    fails(
        cspace(&["import", &drawing("unit_mm.dxf"), &pin, "--scale", "2"]),
        2,
        &["\"mm\"", "\"in\"", "leave out --scale"],
    );
}

/// As in a model with the same `place`, before and after offsets, and of an outline that is written in the model itself.
#[test]
fn parts_are_put_elsewhere() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bar.svg");
    let body = "<path d=\"M0 0H10V4L0 1Z\"/>";
    let head = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 4\">";
    fs::write(&path, format!("{head}{body}</svg>")).unwrap();
    let path = path.to_str().unwrap();
    let imported = |args: &[&str]| {
        let report = json_beside_notes(&[&["import", path][..], args].concat());
        report["parts"][0]["bounds"].clone()
    };
    assert_eq!(
        imported(&["--place", "at=20,-3"]),
        serde_json::json!([20.0, -3.0, 30.0, 1.0])
    );
    assert_eq!(
        imported(&["--place", "turn=90deg"]),
        serde_json::json!([-4.0, 0.0, 0.0, 10.0])
    );
    let all = imported(&["--place", "at=20,-3,turn=90deg,mirror=x", "--offset", "1"]);
    assert_eq!(all, serde_json::json!([19.0, -4.0, 25.0, 8.0]));
    fails(
        cspace(&["import", path, "--place", "turn=up"]),
        2,
        &["--place", "\"up\" is no angle"],
    );
    fails(
        cspace(&["import", path, "--place", "20,-3"]),
        2,
        &["at=X,Y"],
    );
    let model = folder.path().join("bar.toml");
    let out = model.to_str().unwrap();
    printed(&[
        "import",
        path,
        "--place",
        "at=20,-3,turn=90deg,mirror=x",
        "-o",
        out,
    ]);
    let info = |keys: &str| {
        let text = format!("[[part]]\nname = \"bar\"\n{keys}\n");
        let model = folder.path().join("other.toml");
        fs::write(&model, text).unwrap();
        json_beside_notes(&["info", model.to_str().unwrap()])["parts"][0].clone()
    };
    let place = "place = { at = [20, -3], turn = \"90deg\", mirror = \"x\" }";
    let drawn = info(&format!("svg = \"bar.svg\"\n{place}"));
    assert_eq!(drawn, json_beside_notes(&["info", out])["parts"][0]);
    // The y axis of SVG points down.
    let loops = "loops = [[[0, 4], [10, 4], [10, 0], [0, 3]]]";
    let written = info(&format!("{loops}\n{place}"));
    assert_eq!(
        (&drawn["bounds"], &drawn["area"]),
        (&written["bounds"], &written["area"])
    );
}

/// A plate with a slot: as larger or smaller parts, and in pieces.
#[test]
fn parts_are_offset() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bar.svg");
    let body = "<path d=\"M0 0H10V4H6V3H4V4H0Z\"/>";
    fs::write(
        &path,
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 4\">{body}</svg>"),
    )
    .unwrap();
    let path = path.to_str().unwrap();
    let parts = |args: &[&str]| {
        let report = json_beside_notes(&[&["import", path][..], args].concat());
        report["parts"].as_array().unwrap().clone()
    };
    assert_eq!(parts(&["--offset", "0.1"])[0]["bounds"][2], 10.1);
    assert_eq!(parts(&["--offset=-0.5"])[0]["bounds"][2], 9.5);
    fails(
        cspace(&["import", path, "--offset", "-1.6"]),
        2,
        &[
            "part \"bar\"",
            "falls apart",
            "1 piece becomes 2",
            "near (",
            "--split",
        ],
    );
    fails(cspace(&["import", path, "--offset", "-3"]), 2, &["nothing"]);
    fails(cspace(&["import", path, "--split"]), 2, &["--offset"]);
    let pieces = parts(&["--offset", "-1.6", "--split"]);
    assert_eq!(pieces.len(), 2);
    assert_eq!(pieces[1]["name"], "bar 2");
    assert_eq!(
        parts(&["--offset", "-1.6", "--split", "--part", "one"]).len(),
        1
    );
    let model = folder.path().join("bar.toml");
    let with = |keys: &str| {
        let text = format!("[[part]]\nname = \"bar\"\nsvg = \"bar.svg\"\n{keys}\n");
        fs::write(&model, text).unwrap();
        model.to_str().unwrap().to_owned()
    };
    let info = json_beside_notes(&["info", &with("offset = -1.6\nsplit = true")]);
    let areas: f64 = pieces.iter().map(|p| p["area"].as_f64().unwrap()).sum();
    let area = info["parts"][0]["area"].as_f64().unwrap();
    assert!((area - areas).abs() < 1e-12);
    fails(
        cspace(&["info", &with("offset = -1.6")]),
        2,
        &["bar.toml:4:", "falls apart", "split = true"],
    );
    fails(
        cspace(&["info", &with("split = true")]),
        2,
        &["`split`", "offset"],
    );
}

/// Ignored entities are printed once for each kind as text, and listed one by one as JSON.
#[test]
fn kinds_are_printed_once() {
    let hatches = drawing("hatches.dxf");
    fails(
        cspace(&["import", &hatches]),
        2,
        &["no closed outline", "--hatches", "8 hatches"],
    );
    let report = json(&["import", &hatches, "--hatches"]);
    assert_eq!(report["parts"].as_array().unwrap().len(), 8);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kinds.dxf");
    let entity = |kind: &str, layer: &str| format!("0\n{kind}\n8\n{layer}\n10\n0\n20\n0\n");
    let texts = ["A", "B", "B"].map(|layer| entity("TEXT", layer)).concat();
    let solids = entity("3DSOLID", "A").repeat(40);
    let with = |body: &str| {
        let text = format!(
            "0\nSECTION\n2\nENTITIES\n{body}0\nCIRCLE\n8\nA\n10\n5\n20\n5\n40\n2\n0\nENDSEC\n0\nEOF\n"
        );
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let text = printed(&["import", &with(&texts)]);
    assert!(text.contains("3 TEXT on 2 layers: a text"), "{text}");
    let report = json(&["import", &with(&texts)]);
    assert_eq!(report["ignored"].as_array().unwrap().len(), 3);
    let output = cspace(&["import", &with(&solids)])
        .assert()
        .code(2)
        .get_output()
        .clone();
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(told.matches("3DSOLID").count(), 1, "{told}");
    assert!(
        told.contains("39 more of this kind") && told.contains("40 things"),
        "{told}"
    );
}

/// Outlines written as DXF are read again to the last bit; those written as SVG, to rounding.
#[test]
fn outlines_are_written_and_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for name in ["ratchet_mechanism", "geneva", "knee", "snap_fastener"] {
        let file = model(name);
        let mechanism = cspace_model::model::read(&file).unwrap();
        for (out, args) in [
            ("new.dxf", &[][..]),
            ("old.dxf", &["--dxf", "r12"]),
            ("plain.svg", &["--outlines"]),
        ] {
            let out = at(out);
            let args = [&["draw", &file, "-o", &out], args].concat();
            cspace(&args).assert().success();
            for entry in &mechanism.parts {
                let part = &entry.part;
                let (source, is_svg) = match out.ends_with("svg") {
                    true => (
                        cspace_drawing::Source {
                            ids: vec![part.name().to_owned()],
                            ..Default::default()
                        },
                        true,
                    ),
                    false => (
                        cspace_drawing::Source {
                            layers: vec![part.name().replace(' ', "_"), part.name().to_owned()],
                            ..Default::default()
                        },
                        false,
                    ),
                };
                let settings = cspace_drawing::Settings {
                    one_part: Some(part.name().to_owned()),
                    ..Default::default()
                };
                let again = cspace_drawing::read(&out, &source)
                    .and_then(|d| d.outlines(&settings))
                    .unwrap();
                let again = &again.parts[0];
                for (a, b) in part.loops().iter().zip(again.loops()) {
                    for (v, w) in a.vertices().iter().zip(b.vertices()) {
                        let apart = (v.x - w.x)
                            .abs()
                            .max((v.y - w.y).abs())
                            .max((v.bulge - w.bulge).abs());
                        assert!(
                            apart <= if is_svg { 1e-12 * part.size() } else { 0.0 },
                            "{name}: {v:?} {w:?}"
                        );
                    }
                }
                assert_eq!(part.loops().len(), again.loops().len());
            }
        }
    }
}

/// The boundary of free space of two discs is a circle, and so is its drawing.
#[test]
fn slices_are_written_as_dxf() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("discs.toml");
    let disc = |name: &str, r: f64| {
        format!("[[part]]\nname = \"{name}\"\nloops = [{{ circle = {r}, at = [0, 0] }}]\n")
    };
    fs::write(&model, disc("a", 3.0) + &disc("b", 2.0)).unwrap();
    let out = folder.path().join("slice.dxf");
    cspace(&[
        "slice",
        model.to_str().unwrap(),
        "--theta",
        "0.3",
        "-o",
        out.to_str().unwrap(),
    ])
    .assert()
    .success();
    let report = json(&["import", out.to_str().unwrap()]);
    let area = report["parts"][0]["area"].as_f64().unwrap();
    assert!(
        (area - 25.0 * std::f64::consts::PI).abs() < 1e-9,
        "{report}"
    );
}

#[test]
fn usage_is_checked() {
    let file = drawing("rings.dxf");
    let out = |name: &str| std::env::temp_dir().join(name).to_str().unwrap().to_owned();
    fails(cspace(&["import"]), 2, &["DRAWING"]);
    fails(
        cspace(&["import", &file, "-o", &out("a.txt")]),
        2,
        &[".toml or .json"],
    );
    fails(
        cspace(&["import", &file, "--join", "0"]),
        2,
        &["positive length"],
    );
    fails(
        cspace(&["import", "none.dxf"]),
        2,
        &["none.dxf", "cannot be read"],
    );
    fails(cspace(&["import", &file, "-o", &file]), 2, &["rings.dxf"]);
    fails(
        cspace(&["import", &file, "--id", "rings"]),
        2,
        &["--id is about SVG drawings", "leave out --id"],
    );
    fails(
        cspace(&["import", &drawing("shapes.svg"), "--layer", "a"]),
        2,
        &["--layer is about DXF drawings"],
    );
    fails(
        cspace(&["import", &file, "--layer", "none"]),
        2,
        &["there is no layer \"none\"", "Defpoints"],
    );
    fails(
        cspace(&["draw", &file, "-o", &out("a.dxf")]),
        2,
        &["import"],
    );
    fails(
        cspace(&["draw", &file, "--at", "0,0,0"]),
        2,
        &["--at", "drawing"],
    );
    fails(
        cspace(&["draw", &model("gears"), "--dxf", "r12", "-o", &out("a.svg")]),
        2,
        &["--dxf"],
    );
}

/// A trace of very many points is named with the command that makes few lines and arcs of it, and what it then gives is as said.
#[test]
fn traces_are_told_with_a_command_that_works() {
    let folder = tempfile::tempdir().unwrap();
    let n = 600;
    let points: String = (0..n)
        .map(|k| std::f64::consts::TAU * f64::from(k) / f64::from(n))
        .map(|t| (t, 20.0 + 4.0 * t.cos() + (2.0 * t).sin()))
        .map(|(t, r)| format!("10\n{:?}\n20\n{:?}\n", r * t.cos(), r * t.sin()))
        .collect();
    let text =
        format!("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n70\n1\n{points}0\nENDSEC\n0\nEOF\n");
    fs::write(folder.path().join("cam.dxf"), text).unwrap();
    let run = |args: &[&str]| cspace(args).current_dir(folder.path()).output().unwrap();
    let told = |args: &[&str]| String::from_utf8(run(args).stderr).unwrap();
    // The commands after "trace: ", each in words.
    let commands = |text: &str| -> Vec<Vec<String>> {
        let line = text.split("if it is a trace: ").nth(1).unwrap();
        let line = line.lines().next().unwrap();
        (line.split(" && "))
            .map(|c| c.split(' ').skip(1).map(str::to_owned).collect())
            .collect()
    };
    let imported = told(&["import", "cam.dxf", "-o", "cam.toml"]);
    assert!(imported.contains("has 600 edges"), "{imported}");
    let pieces: u64 = (imported.split("600 edges; ").nth(1))
        .and_then(|rest| rest.split(' ').next()?.parse().ok())
        .unwrap();
    for asked in [imported, told(&["info", "cam.toml"])] {
        for command in commands(&asked) {
            let words: Vec<&str> = command.iter().map(String::as_str).collect();
            let done = run(&words);
            assert!(done.status.success(), "{words:?}");
        }
        let path = folder.path().join("traced.toml");
        let info = json_beside_notes(&["info", path.to_str().unwrap()]);
        let features = &info["parts"][0]["features"];
        let edges = features["lines"].as_u64().unwrap() + features["arcs"].as_u64().unwrap();
        assert_eq!(edges, pieces);
        assert!(pieces < 60);
        fs::remove_file(path).unwrap();
    }
    assert_eq!(told(&["import", "cam.dxf", "--trace"]), "");
    // A model says the same.
    let model = |keys: &str| {
        let text = format!("[[part]]\nname = \"cam\"\ndxf = \"cam.dxf\"\n{keys}");
        fs::write(folder.path().join("model.toml"), text).unwrap();
        told(&["info", "model.toml"])
    };
    assert_eq!(model("trace = true\n"), "");
    assert!(model("").contains("has 600 edges"));
    assert!(model("trace = true\npick = [[20, 0]]\n").contains("both `pick` and `trace`"));
}

/// A plate with a notch, and a circle so far away that the notch is shorter than the ends that are joined: that is told, and the
/// proposed `--join` keeps it.
#[test]
fn short_edges_are_not_removed_without_a_word() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plate.dxf");
    let corners = [
        [0.0, 0.0],
        [50.0, 0.0],
        [50.0, 0.8],
        [50.8, 0.8],
        [50.8, 0.0],
        [100.0, 0.0],
        [100.0, 50.0],
        [0.0, 50.0],
    ];
    let lines: String = (corners.iter().zip(corners.iter().cycle().skip(1)))
        .map(|([x0, y0], [x1, y1])| {
            format!("0\nLINE\n8\n0\n10\n{x0}\n20\n{y0}\n11\n{x1}\n21\n{y1}\n")
        })
        .collect();
    let text = format!(
        "0\nSECTION\n2\nENTITIES\n{lines}0\nCIRCLE\n8\n0\n10\n1e5\n20\n1\n40\n0.5\n0\nENDSEC\n0\nEOF\n"
    );
    fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap();
    let told = cspace(&["import", path]).output().unwrap();
    let told = String::from_utf8(told.stderr).unwrap();
    assert!(told.contains("3 short pieces are removed"), "{told}");
    let join = told.split("such as --join ").nth(1).unwrap().trim();
    let plate = &json(&["import", path, "--join", join])["parts"][0];
    assert!((plate["area"].as_f64().unwrap() - (5000.0 - 0.64)).abs() < 1e-9);
}

/// Two blocks and a square that lacks a side, which is on another layer.
fn layers(folder: &std::path::Path) -> String {
    let square = |layer: &str, x: f64, sides: usize| -> String {
        let corners = [[x, 0.0], [x, 1.0], [x + 1.0, 1.0], [x + 1.0, 0.0], [x, 0.0]];
        (corners.windows(2).take(sides))
            .map(|c| {
                let [[x0, y0], [x1, y1]] = [c[0], c[1]];
                format!("0\nLINE\n8\n{layer}\n10\n{x0}\n20\n{y0}\n11\n{x1}\n21\n{y1}\n")
            })
            .collect()
    };
    let side = "0\nLINE\n5\n2F\n8\n0\n10\n8\n20\n0\n11\n7\n21\n0\n";
    let parts = square("pair", 0.0, 4) + &square("pair", 2.0, 4) + &square("third", 7.0, 3);
    let text = format!("0\nSECTION\n2\nENTITIES\n{parts}{side}0\nENDSEC\n0\nEOF\n");
    let path = folder.join("layers.dxf");
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn a_layer_that_closes_an_outline_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = layers(folder.path());
    fails(
        cspace(&["import", &path, "--layer", "third"]),
        2,
        &[
            "the gap from (7, 0) to (8, 0) is closed by LINE 2F on layer \"0\" (line",
            "add --layer \"0\"",
        ],
    );
    let report = json(&["import", &path, "--layer", "third", "--layer", "0"]);
    assert_eq!(report["parts"][0]["area"], 1.0);
}

#[test]
fn outlines_of_a_layer_are_one_part_or_several() {
    let folder = tempfile::tempdir().unwrap();
    let path = layers(folder.path());
    let report = json(&["import", &path]);
    assert_eq!(report["parts"].as_array().unwrap().len(), 3);
    let apart = serde_json::json!([{"layer": "pair", "parts": ["pair 1", "pair 2"]}]);
    assert_eq!(report["apart"], apart);
    let text = printed(&["import", &path]);
    assert!(
        text.contains("2 outlines on layer \"pair\" are a part each; --by-layer"),
        "{text}"
    );
    let report = json(&["import", &path, "--by-layer"]);
    let parts = report["parts"].as_array().unwrap();
    assert_eq!(parts.len(), 2);
    assert_eq!(parts[0]["name"], "pair");
    assert_eq!(parts[0]["loops"], 2);
    assert_eq!(parts[0]["area"], 2.0);
    assert_eq!(report["apart"], serde_json::json!([]));
    fails(
        cspace(&["import", &drawing("shapes.svg"), "--by-layer"]),
        2,
        &["--by-layer is about DXF drawings"],
    );
    fails(
        cspace(&["import", &path, "--by-layer", "--part", "all"]),
        2,
        &["--part"],
    );
}

/// Two rooms that share a wall, drawn as seven lines, with a pillar in one: nobody can tell which loops are meant.
#[test]
fn faces_are_listed_and_picked() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rooms.dxf");
    let line = |[x0, y0, x1, y1]: [i32; 4]| {
        format!("0\nLINE\n8\n0\n10\n{x0}\n20\n{y0}\n11\n{x1}\n21\n{y1}\n")
    };
    let walls = [
        [0, 0, 4, 0],
        [4, 0, 4, 3],
        [4, 3, 0, 3],
        [0, 3, 0, 0],
        [4, 0, 6, 0],
        [6, 0, 6, 3],
        [6, 3, 4, 3],
    ];
    let lines: String = walls.into_iter().map(line).collect();
    let text = format!(
        "0\nSECTION\n2\nENTITIES\n{lines}0\nCIRCLE\n8\n0\n10\n2\n20\n1\n40\n0.5\n0\nENDSEC\n0\nEOF\n"
    );
    fs::write(&path, &text).unwrap();
    let path = path.to_str().unwrap();
    let pillar = std::f64::consts::PI * 0.25;
    fails(
        cspace(&["import", path]),
        2,
        &[
            "3 faces are closed",
            "area 11.214602",
            "area 6.000000",
            "area 0.785398",
        ],
    );
    // A disc beside the rooms is a part without them; the pillar within them is not.
    let beside = folder.path().join("beside.dxf");
    let disc = "0\nCIRCLE\n8\n0\n10\n9\n20\n1\n40\n1\n0\nENDSEC";
    fs::write(&beside, text.replace("0\nENDSEC", disc)).unwrap();
    let beside = beside.to_str().unwrap();
    fails(
        cspace(&["import", beside]),
        2,
        &["4 faces are closed", "--partial, which gives 1 part"],
    );
    let discs = json(&["import", beside, "--partial"])["parts"].clone();
    assert_eq!(discs.as_array().unwrap().len(), 1);
    assert_eq!(discs[0]["bounds"], serde_json::json!([8.0, 0.0, 10.0, 2.0]));
    let parts = |picks: &[&str]| json(&[&["import", path][..], picks].concat())["parts"].clone();
    let area = |part: &Value| part["area"].as_f64().unwrap();
    let rooms = parts(&["--pick", "left=0.5,2.5", "--pick=5,1"]);
    assert_eq!(rooms.as_array().unwrap().len(), 2);
    assert_eq!(rooms[0]["name"], "left");
    assert_eq!(rooms[0]["loops"], 2);
    assert!((area(&rooms[0]) - (12.0 - pillar)).abs() < 1e-12);
    assert!((area(&rooms[1]) - 6.0).abs() < 1e-12);
    // Both rooms and the pillar are one rectangle; its sides are cut where the wall meets them.
    let whole = parts(&["--pick", "0.5,2.5;5,1;2,1"]);
    assert_eq!(whole[0]["loops"], 1);
    assert!((area(&whole[0]) - 18.0).abs() < 1e-12);
    fails(
        cspace(&["import", path, "--pick", "9,9"]),
        2,
        &["no face is at (9, 9)", "nearest face"],
    );
    fails(
        cspace(&["import", path, "--pick", "5,1", "--pick", "5,2"]),
        2,
        &["picked twice"],
    );
    fails(cspace(&["import", path, "--pick", "5"]), 2, &["X,Y"]);
    let model = folder.path().join("rooms.toml");
    fs::write(
        &model,
        "[[part]]\nname = \"room\"\ndxf = \"rooms.dxf\"\npick = [[0.5, 2.5]]\n",
    )
    .unwrap();
    let info = json(&["info", model.to_str().unwrap()]);
    assert!((area(&info["parts"][0]) - (12.0 - pillar)).abs() < 1e-12);
}
