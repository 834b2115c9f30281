//! Drawings with indirect descriptions: percentages, undeclared prefixes, outlines in hatches alone.

use core::f64::consts::PI;

use cspace::Part;
use cspace::part::Bounds;
use cspace_drawing::{Drawing, Format, Pick, Settings, Source, from_bytes, read};

fn svg(text: &str) -> Vec<Part> {
    let drawing = from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap();
    drawing.outlines(&Settings::default()).unwrap().parts
}

fn sides(part: &Part) -> [f64; 4] {
    let Bounds { min, max } = part.bounds();
    [min.x, min.y, max.x, max.y]
}

/// A page of 100 by 50 mm whose user units are half millimetres.
fn page(body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" \
         viewBox=\"0 0 200 100\">{body}</svg>"
    )
}

#[test]
fn percentages_are_of_the_view_box() {
    let part = &svg(&page("<rect width=\"100%\" height=\"100%\"/>"))[0];
    assert_eq!(sides(part), [0.0, 0.0, 100.0, 50.0]);
    let part = &svg(&page(
        "<rect x=\"10%\" y=\"20%\" width=\"50%\" height=\"50%\"/>",
    ))[0];
    assert_eq!(sides(part), [10.0, 15.0, 60.0, 40.0]);
    // A percentage of a radius is of the diagonal over √2.
    let part = &svg(&page("<circle cx=\"50%\" cy=\"50%\" r=\"10%\"/>"))[0];
    let radius = 5.0 * 2.5_f64.sqrt();
    assert!((part.area() - PI * radius * radius).abs() < 1e-12);
    assert!((part.bounds().center().x - 50.0).abs() < 1e-13);
    // Those of a rounded corner are of the sides.
    let part = &svg(&page(
        "<rect width=\"100%\" height=\"100%\" rx=\"5%\" ry=\"10%\"/>",
    ))[0];
    assert!((part.area() - (5000.0 - (4.0 - PI) * 25.0)).abs() < 1e-9);
}

#[test]
fn percentages_in_frames_are_of_these() {
    let rect = "<rect width=\"50%\" height=\"50%\"/>";
    let inner = "viewBox=\"0 0 20 10\"";
    for body in [
        format!("<svg x=\"50%\" width=\"50%\" height=\"50%\">{rect}</svg>"),
        format!("<svg x=\"50%\" width=\"50%\" height=\"50%\" {inner}>{rect}</svg>"),
        format!(
            "<symbol id=\"s\" {inner}>{rect}</symbol>\
             <use href=\"#s\" x=\"50%\" width=\"50%\" height=\"50%\"/>"
        ),
        // Without sides a frame is as large as the one around.
        format!(
            "<symbol id=\"s\" {inner}><rect width=\"25%\" height=\"25%\"/></symbol>\
             <use href=\"#s\" x=\"100\"/>"
        ),
    ] {
        let part = &svg(&page(&body))[0];
        assert_eq!(sides(part), [50.0, 37.5, 75.0, 50.0], "{body}");
    }
}

/// Errors if neither a side nor a view box gives the size of the page, and if the size of a font is unknown.
#[test]
fn lengths_of_nothing_known_are_told() {
    for body in ["<rect width=\"50%\" height=\"9\"/>", "<circle r=\"2em\"/>"] {
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{body}</svg>");
        let drawing = from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap();
        let error = drawing.outlines(&Settings::default()).unwrap_err();
        assert!(
            error.to_string().contains("no length that can be told"),
            "{error}"
        );
    }
}

#[test]
fn prefixes_need_not_be_declared() {
    let text = "<?xml version=\"1.0\"?>\n<!-- <svg> -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" \
        inkscape:version=\"1\">\n<sodipodi:namedview id=\"v\"/>\n\
        <g inkscape:groupmode=\"layer\" inkscape:label=\"cut\"><rect id=\"r\" width=\"4\" height=\"3\"/>\n\
        <use xlink:href=\"#r\" x=\"9\" odd:odd=\"1\"/></g></svg>";
    let parts = svg(text);
    assert_eq!(parts.len(), 2);
    assert!(parts.iter().all(|p| (p.area() - 12.0).abs() < 1e-15));
    let source = Source {
        layers: vec!["cut".to_owned()],
        ..Source::default()
    };
    let drawing = from_bytes(text.as_bytes(), Format::Svg, &source).unwrap();
    assert_eq!(drawing.entities.len(), 2);
    assert_eq!(drawing.entities[0].origin.line, 5);
    // What is wrong otherwise is told as ever.
    let error = from_bytes(b"<svg odd:a=\"1\"><g></svg>", Format::Svg, &source);
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("the file is no XML")
    );
}

#[test]
fn outlines_of_hatches_are_offered() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings/hatches.dxf");
    let drawing = read(path, &Source::default()).unwrap();
    assert_eq!((drawing.entities.len(), drawing.ignored.len()), (0, 8));
    let error = drawing.outlines(&Settings::default()).unwrap_err();
    assert!(error.help().starts_with("--hatches"), "{}", error.help());
    assert!(error.help().contains("the outlines of 8 hatches"));
}

/// A drawing of paths without fill, and of circles.
fn strokes(body: &str) -> Drawing {
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><g fill=\"none\" stroke=\"black\">{body}</g></svg>"
    );
    from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap()
}

fn path(d: &str) -> String {
    format!("<path d=\"{d}\"/>")
}

fn areas(parts: &[Part]) -> Vec<f64> {
    parts.iter().map(Part::area).collect()
}

/// A hole that touches the outline around it is no part beside it; a peg that touches its hole is.
#[test]
fn loops_that_touch_are_within_one_another() {
    let diamond = "M10 5 L8 7 L6 5 L8 3 Z";
    let circle = "<circle cx=\"30\" cy=\"5\" r=\"5\"/>";
    for (outer, hole, around) in [
        (path("M0 0H10V10H0Z"), path(diamond), 100.0 - 8.0),
        (circle.into(), path("M25 5L30 10L35 5L30 0Z"), f64::NAN),
    ] {
        let drawing = strokes(&format!("{outer}{hole}"));
        let settings = Settings::default();
        let reading = drawing.reading(&settings).unwrap();
        let error = reading.outlines().unwrap_err().to_string();
        assert!(error.contains("outlines touch here"), "{error}");
        let faces = reading.faces().unwrap();
        let areas: Vec<f64> = faces.faces.iter().map(|f| f.area).collect();
        match around.is_nan() {
            false => assert_eq!(areas, [around, 8.0]),
            true => {
                // A square in a circle of radius 5, and four segments of a quarter turn.
                assert_eq!(areas.len(), 5);
                assert!((areas[0] - 50.0).abs() < 1e-12);
                let segment = 25.0 * (PI / 4.0 - 0.5);
                assert!(areas[1..].iter().all(|a| (a - segment).abs() < 1e-12));
            }
        }
    }
    let frame = path("M0 0H10V10H0Z") + &path("M2 2H8V8H2Z");
    let drawing = strokes(&(frame + &path("M2 3H5V7H2Z")));
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    assert_eq!(areas(&outlines.parts), [64.0, 12.0]);
}

/// No hole of an outline that is left out becomes a part, whether the outline is open, a network, or crosses itself.
#[test]
fn holes_of_what_is_left_out_are_no_parts() {
    let partial = Settings {
        partial: true,
        ..Settings::default()
    };
    let hole = "<circle cx=\"5\" cy=\"5\" r=\"2\"/>";
    let beside = "<circle cx=\"50\" cy=\"5\" r=\"3\"/>";
    for frame in [
        path("M0 0H10V10H0V1"),
        path("M0 0H10V10H0Z M0 0") + &path("M5 -5V3") + &path("M0 0H10") + &path("M10 10L15 12"),
        path("M0 0H10V10H4") + &path("M4 10H0V0") + &path("M4 10V15"),
        path("M0 0H10V10H0V-5H-5V2H3V0Z"),
    ] {
        let drawing = strokes(&format!("{frame}{hole}{beside}"));
        let Ok(outlines) = drawing.outlines(&partial) else {
            panic!("{frame}")
        };
        let listed = (outlines.ignored.iter())
            .filter(|i| i.reason.contains("may be one part"))
            .count();
        match outlines.parts.len() {
            // A frame that is closed all the same has its hole.
            2 => assert!((outlines.parts[0].area() - (100.0 - 4.0 * PI)).abs() < 1e-9),
            1 => assert_eq!(listed, 1, "{frame}"),
            n => panic!("{n} parts: {frame}"),
        }
        let last = outlines.parts.last().unwrap();
        assert!((last.area() - 9.0 * PI).abs() < 1e-9);
    }
    // Centre lines enclose nothing.
    let lines = path("M-1 5H11") + &path("M5 -1V11");
    let drawing = strokes(&format!("{lines}{hole}{beside}"));
    assert_eq!(drawing.outlines(&partial).unwrap().parts.len(), 2);
    // Nor is a plate a part without a hole that is drawn, but crosses itself.
    let plate = path("M0 0H10V10H0Z") + &path("M2 2L4 4V2L2 4Z");
    let drawing = strokes(&format!("{plate}{beside}"));
    let outlines = drawing.outlines(&partial).unwrap();
    assert_eq!(outlines.parts.len(), 1);
    assert_eq!(outlines.used.get("path"), None);
}

/// A line there and back encloses nothing.
#[test]
fn spikes_are_taken_off_and_listed() {
    for (d, edges) in [
        ("M0 0H10V10H5V15V10H0Z", 5),
        ("M0 0H10V10H5V15V10V12V10H0Z", 5),
        ("M0 0H10V15V10H0Z", 4),
        ("M0 0H15H10V10H0Z", 4),
    ] {
        let outlines = strokes(&path(d)).outlines(&Settings::default()).unwrap();
        assert_eq!(areas(&outlines.parts), [100.0], "{d}");
        assert_eq!(outlines.parts[0].edges().count(), edges, "{d}");
        let spikes = (outlines.ignored.iter()).filter(|i| i.reason.contains("its spike"));
        assert!(spikes.count() > 0, "{d}");
    }
}

/// An outline with a gap bounds no face, and is told; lines that end freely beyond the faces that they bound are not.
#[test]
fn what_is_open_and_bounds_no_face_is_told() {
    let frame = "M-1 0H11M-1 10H11M0 -1V11M10 -1V11";
    let open = "M20 0H30V10H20V0.2";
    let dropped = |d: &str, join: Option<f64>| {
        let drawing = strokes(&path(d));
        let settings = Settings {
            join,
            ..Settings::default()
        };
        let faces = drawing.reading(&settings).unwrap().faces().unwrap();
        (faces.count, faces.dropped)
    };
    assert_eq!(dropped(frame, None), (1, Vec::new()));
    let (count, problems) = dropped(&format!("{frame}{open}"), None);
    assert_eq!((count, problems.len()), (1, 1));
    assert_eq!(problems[0].to.map(|p| p.x), Some(20.0));
    let told = "its ends are 0.2 from the nearest other ones";
    assert!(problems[0].reason.contains(told), "{}", problems[0].reason);
    assert_eq!(
        dropped(&format!("{frame}{open}"), Some(0.25)),
        (2, Vec::new())
    );
    // A line across closes it, too.
    assert_eq!(dropped("M0 0H10V10H0V1M-1 0.5H11M0 0V1", None).0, 2);
}

/// Faces between a half disc and the disc in it, which touches both of its sides, have two cusps each.
#[test]
fn a_picked_face_may_have_cusps() {
    let half = path("M-5 0A5 5 0 0 0 5 0Z");
    let drawing = strokes(&format!("{half}<circle cx=\"0\" cy=\"2.5\" r=\"2.5\"/>"));
    let settings = Settings::default();
    let reading = drawing.reading(&settings).unwrap();
    let faces = reading.faces().unwrap().faces;
    assert_eq!(faces.len(), 3);
    for face in &faces[1..] {
        let settings = Settings {
            picks: vec![Pick {
                name: None,
                at: vec![face.inside],
            }],
            ..Settings::default()
        };
        let outlines = drawing.outlines(&settings).unwrap();
        let off = outlines.parts[0].area() - 25.0 * PI / 8.0;
        assert!(off.abs() < 1e-5, "{off}");
        let tips = (outlines.ignored.iter()).filter(|i| i.reason.contains("cusp"));
        assert_eq!(tips.count(), 2);
    }
}
