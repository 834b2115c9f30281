//! Drawings whose faces are picked: the model, and that a scene has all that makes it.

use cspace::Point;
use cspace_api::scene::{DrawingSource, OpenedDrawing, PickError, PickedPart};
use cspace_drawing::{Format, Settings, Source, from_bytes};
use serde_json::Value;

/// A square of side 4 in which a circle of radius 0.5 is, divided by a line that goes beyond the square.
const SQUARE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -4 8 8" fill="none" stroke="black">
    <path d="M0 0h4v-4h-4z"/><circle cx="1" cy="-2" r="0.5"/><path d="M2.5 1v-6"/></svg>"#;

fn square() -> OpenedDrawing {
    OpenedDrawing::of_file("square.svg", SQUARE.into()).unwrap()
}

/// A part of the faces at points.
fn part(name: &str, at: &[(f64, f64)]) -> PickedPart {
    PickedPart {
        name: name.to_owned(),
        at: at.iter().map(|&(x, y)| Point::new(x, y)).collect(),
    }
}

/// The source as a page hands it back.
fn through_json(source: &DrawingSource) -> DrawingSource {
    serde_json::from_str(&serde_json::to_string(source).unwrap()).unwrap()
}

#[test]
fn picks_that_make_no_model_are_refused() {
    let left = part("left", &[(2.0, 2.0)]);
    for (picked, words, help) in [
        (vec![], "no face is picked", "click"),
        (vec![part("none", &[])], "no face is picked", "click"),
        (
            vec![part("beside", &[(9.0, 9.0)])],
            "no face is at",
            "nearest",
        ),
        (
            vec![left.clone(), part("again", &[(2.0, 3.0)])],
            "twice",
            "once",
        ),
        (
            vec![left.clone(), part("left", &[(3.0, 2.0)])],
            "name",
            "rename",
        ),
        (vec![part("", &[(3.0, 2.0)])], "name is empty", ""),
    ] {
        let error: PickError = square().toml(&picked).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.help().contains(help), "{error}: {}", error.help());
    }
}

/// Two squares that touch at a corner within a circle: what is between them and the circle touches itself there.
#[test]
fn faces_that_are_no_part_say_why() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="-8 -8 16 16" fill="none" stroke="black">
        <circle r="6"/><path d="M0 0h3v3h-3z"/><path d="M0 0h-3v-3h3z"/></svg>"#;
    let drawing = from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap();
    let settings = Settings::default();
    let found = drawing.reading(&settings).unwrap().faces().unwrap();
    let refused: Vec<bool> = found.faces.iter().map(|f| f.refusal.is_some()).collect();
    assert_eq!(refused, [true, false, false]);
}

/// Two layers with a square each, in inches, of which the command reads one in millimetres: each option changes the
/// model, and the scene's source makes an equal one to the last bit.
#[test]
fn the_source_has_every_option() {
    let square = |layer: &str, x: f64| {
        let corners = [(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 1.0), (x, 1.0)];
        let line = |i: usize| {
            let ((a, b), (c, d)) = (corners[i], corners[(i + 1) % 4]);
            // The ends miss each other by a little.
            format!(
                "0\nLINE\n8\n{layer}\n10\n{a}\n20\n{b}\n11\n{}\n21\n{d}\n",
                c + 1e-4
            )
        };
        (0..4).map(line).collect::<String>()
    };
    let text = format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{}{}0\nENDSEC\n0\nEOF\n",
        square("a", 0.0),
        square("b", 3.0)
    );
    let plain = OpenedDrawing::of_file("two.dxf", text.clone().into_bytes()).unwrap();
    assert_eq!(
        (plain.source.unit.as_deref(), plain.source.scale),
        (Some("in"), 1.0)
    );
    let source = DrawingSource {
        layers: vec!["b".to_owned()],
        unit: Some("mm".to_owned()),
        scale: 25.4,
        join: Some(0.1),
        fit: Some(1e-3),
        ..plain.source.clone()
    };
    let again = through_json(&source);
    assert_eq!(again, source);
    let opened = OpenedDrawing::from_source(again).unwrap();
    let scene = opened.scene().unwrap();
    assert_eq!(scene.count, 1, "the layer");
    assert!(
        (scene.faces[0].area / (25.4 * 25.4) - 1.0).abs() < 1e-3,
        "the scale"
    );
    let picked = [part("b", &[(25.4 * 3.5, 12.7)])];
    let model = opened.model(&picked).unwrap();
    assert_eq!(model.unit.as_deref(), Some("mm"));
    // What the command has of the same options.
    let options = Source {
        layers: vec!["b".to_owned()],
        ..Source::default()
    };
    let drawing = from_bytes(text.as_bytes(), Format::Dxf, &options).unwrap();
    let settings = Settings {
        scale: 25.4,
        join: Some(0.1),
        fit: Some(1e-3),
        picks: vec![cspace_drawing::Pick {
            name: Some("b".to_owned()),
            at: picked[0].at.clone(),
        }],
        ..Settings::default()
    };
    let parts = drawing.outlines(&settings).unwrap().parts;
    assert_eq!(model.parts[0].part.loops(), parts[0].loops());
    // With a smaller join the ends are apart, and enclose nothing.
    let apart = DrawingSource {
        join: Some(1e-9),
        ..source
    };
    assert_eq!(
        OpenedDrawing::from_source(apart)
            .unwrap()
            .scene()
            .unwrap()
            .count,
        0
    );
}

#[test]
fn the_id_of_a_drawing_is_in_its_source() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg"><circle id="a" r="2"/><circle id="b" cx="9" r="1"/></svg>"#;
    let plain = OpenedDrawing::of_file("two.svg", text.into()).unwrap();
    assert_eq!(plain.scene().unwrap().count, 2);
    let source = DrawingSource {
        ids: vec!["b".to_owned()],
        ..plain.source
    };
    let opened = OpenedDrawing::from_source(through_json(&source)).unwrap();
    assert_eq!(opened.scene().unwrap().count, 1);
}

#[test]
fn what_is_no_drawing_says_what_to_do() {
    for (file, data, words, help) in [
        ("plan.dwg", "AC1032", "DWG files are not read", "DXF"),
        ("plan.step", "", "not that of a drawing", ".dxf"),
        ("plan.dxf", "0\nSECTION\nx", "line ", ""),
    ] {
        let error = OpenedDrawing::of_file(file, data.into()).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.help().contains(help), "{}", error.help());
    }
    let points = OpenedDrawing::of_file("plan.csv", "0,0\n1,0\n0,1\n".into()).unwrap();
    let error = points.scene().unwrap_err();
    assert!(error.help().contains("cspace import"), "{}", error.help());
}

/// A ring, and a disc in its hole.
const COIN: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" fill="none" stroke="black">
    <circle r="2" id="disc"/><circle id="ring" r="5"/><circle r="3"/></svg>"#;

#[test]
fn parts_that_import_makes_are_known_by_their_faces() {
    let coin = OpenedDrawing::of_file("coin.svg", COIN.into()).unwrap();
    let scene = coin.scene().unwrap();
    let imported = coin.drawing.outlines(&Settings::default()).unwrap().parts;
    assert_eq!(
        (imported.len(), scene.parts.len(), scene.faces.len()),
        (2, 2, 3)
    );
    for (part, known) in imported.iter().zip(&scene.parts) {
        assert_eq!(part.name(), known.name);
        let picked = coin.model(&[PickedPart {
            name: known.name.clone(),
            at: vec![scene.faces[known.face].inside],
        }]);
        let picked = &picked.unwrap().parts[0].part;
        assert!((picked.area() / part.area() - 1.0).abs() < 1e-12);
        assert_eq!(picked.loops().len(), part.loops().len());
    }
    // Where import refuses a drawing no part is known, and none where a part is several faces.
    assert_eq!(square().scene().unwrap().parts, []);
    let crossing = r#"<svg xmlns="http://www.w3.org/2000/svg" fill="none" stroke="black">
        <circle r="2"/><circle cx="3" r="2"/><circle cx="9" r="1"/></svg>"#;
    let crossing = OpenedDrawing::of_file("crossing.svg", crossing.into()).unwrap();
    assert_eq!(
        crossing
            .drawing
            .outlines(&Settings::default())
            .unwrap()
            .parts
            .len(),
        3
    );
    assert_eq!(crossing.scene().unwrap().parts, []);
}

/// The keys of the page's types are those of the scene.
#[test]
fn the_page_knows_the_same_fields() {
    let types = include_str!("../../../cspace-cli/page/src/drawing/scene.ts");
    let fields = |name: &str| -> Vec<String> {
        let (_, rest) = types
            .split_once(&format!("export interface {name} {{"))
            .unwrap();
        let body = rest.split_once("\n}").unwrap().0;
        (body.lines().map(str::trim))
            .filter(|l| !l.starts_with("/*") && !l.starts_with('*'))
            .filter_map(|l| Some(l.split_once(':')?.0.to_owned()))
            .collect()
    };
    let keys =
        |value: &Value| -> Vec<String> { value.as_object().unwrap().keys().cloned().collect() };
    let sorted = |mut names: Vec<String>| {
        names.sort();
        names
    };
    let coin = OpenedDrawing::of_file("coin.svg", COIN.into()).unwrap();
    let scene = serde_json::to_value(coin.scene().unwrap()).unwrap();
    for (name, value) in [
        ("DrawingScene", &scene),
        ("DrawingSource", &scene["source"]),
        ("SceneFace", &scene["faces"][0]),
        ("ImportedPart", &scene["parts"][0]),
    ] {
        assert_eq!(sorted(fields(name)), sorted(keys(value)), "{name}");
    }
}
