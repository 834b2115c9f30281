//! Drawings that say in roundabout ways what they draw: percentages, prefixes nobody declares, outlines in hatches alone.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

use core::f64::consts::PI;

use cspace::Part;
use cspace::part::Bounds;
use cspace_drawing::{Format, Settings, Source, from_bytes, read};

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

/// Where neither a side nor a view box says how large the page is, nor what size a font has.
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
