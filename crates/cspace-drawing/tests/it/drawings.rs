//! The drawings of `tests/drawings` are made by `make.py` there with ezdxf, another program's reader and writer of DXF:
//! the expected results are computed from their dimensions.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cspace::Part;
use cspace_drawing::{Outlines, Settings, Source, read};
use serde_json::Value;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/drawings")
}

fn expected() -> BTreeMap<String, Value> {
    let text = std::fs::read_to_string(folder().join("expected.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn perimeter(part: &Part) -> f64 {
    part.edges().map(|e| e.length()).sum()
}

fn counts<'a>(kinds: impl Iterator<Item = &'a str>) -> BTreeMap<String, usize> {
    let mut counts = BTreeMap::new();
    for kind in kinds {
        *counts.entry(kind.to_owned()).or_default() += 1;
    }
    counts
}

fn check(name: &str, outlines: &Outlines, expected: &Value) {
    let within = expected["within"].as_f64().unwrap();
    let parts = expected["parts"].as_array().unwrap();
    if !parts.is_empty() {
        assert_eq!(outlines.parts.len(), parts.len(), "{name}: parts");
    }
    for (k, expected) in parts.iter().enumerate() {
        // Parts with names may come in any order.
        let named = expected["name"].as_str();
        let part = match named.and_then(|n| outlines.parts.iter().find(|p| p.name() == n)) {
            Some(part) => part,
            None => &outlines.parts[k],
        };
        let lines = part.edges().filter(|e| e.is_line()).count();
        let found = [
            ("area", part.area()),
            ("perimeter", perimeter(part)),
            ("loops", part.loops().len() as f64),
            ("lines", lines as f64),
            ("arcs", (part.edges().count() - lines) as f64),
        ];
        for (key, found) in found {
            let Some(wanted) = expected[key].as_f64() else {
                continue;
            };
            let is_measure = matches!(key, "area" | "perimeter");
            let slack = if is_measure { within * wanted } else { 0.0 };
            assert!(
                (found - wanted).abs() <= slack,
                "{name}: {key} {found}, not {wanted}"
            );
        }
        if let Some(wanted) = expected["name"].as_str() {
            assert_eq!(part.name(), wanted, "{name}");
        }
    }
    let removed = [
        ("duplicates", outlines.duplicates),
        ("overlaps", outlines.merged),
        ("tiny", outlines.tiny),
    ];
    for (key, found) in removed {
        if let Some(wanted) = expected["removed"][key].as_u64() {
            assert_eq!(found as u64, wanted, "{name}: {key}");
        }
    }
    if let Some(wanted) = expected["joined"].as_u64() {
        assert_eq!(outlines.joined.len() as u64, wanted, "{name}: joined");
    }
    assert_eq!(
        outlines.fitted.curves as u64,
        expected["fitted"].as_u64().unwrap_or(0),
        "{name}: fitted"
    );
    assert!(
        outlines.fitted.kink < 1e-9,
        "{name}: kink {}",
        outlines.fitted.kink
    );
    if let Some(unit) = expected["unit"].as_str() {
        assert_eq!(outlines.unit.map(|u| u.label()), Some(unit), "{name}: unit");
    }
    let ignored = counts(outlines.ignored.iter().map(|i| &*i.origin.kind));
    for (key, found) in [("ignored", &ignored), ("used", &outlines.used)] {
        if let Some(wanted) = expected[key].as_object() {
            let wanted: BTreeMap<String, usize> = (wanted.iter())
                .map(|(k, n)| (k.clone(), n.as_u64().unwrap() as usize))
                .collect();
            assert_eq!(*found, wanted, "{name}: {key}");
        }
    }
}

#[test]
fn drawings_are_read_as_they_were_made() {
    let expected = expected();
    assert!(expected.len() > 60);
    for (name, expected) in &expected {
        let settings = Settings {
            fit: expected["fit"].as_f64(),
            ..Settings::default()
        };
        let source = Source {
            hatches: expected["hatches"].as_bool().unwrap_or(false),
            ..Source::default()
        };
        let outlines = read(folder().join(name), &source)
            .and_then(|drawing| drawing.outlines(&settings))
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        check(name, &outlines, expected);
    }
}

/// An outline drawn in any unit gives an equal number of lines and arcs.
#[test]
fn scale_changes_lengths_alone() {
    for name in [
        "slot_r12.dxf",
        "ellipse.dxf",
        "blocks.dxf",
        "cam_points.csv",
        "shapes.svg",
    ] {
        let drawing = read(folder().join(name), &Source::default()).unwrap();
        let plain = drawing.outlines(&Settings::default()).unwrap();
        let scale = 25.4;
        let settings = Settings {
            scale,
            ..Settings::default()
        };
        let scaled = drawing.outlines(&settings).unwrap();
        for (a, b) in plain.parts.iter().zip(&scaled.parts) {
            assert_eq!(a.edges().count(), b.edges().count(), "{name}");
            let factor = b.area() / a.area();
            assert!(
                (factor / (scale * scale) - 1.0).abs() < 1e-4,
                "{name}: {factor}"
            );
        }
    }
}

#[test]
fn layers_are_read_alone() {
    let source = Source {
        layers: vec!["OUTLINE".to_owned()],
        ..Source::default()
    };
    let drawing = read(folder().join("layers.dxf"), &source).unwrap();
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    assert!((outlines.parts[0].area() - 1500.0).abs() < 1e-9);
    assert_eq!(outlines.ignored.len(), 3);
}

#[test]
fn an_element_is_read_alone() {
    let source = Source {
        ids: vec!["hole".to_owned()],
        ..Source::default()
    };
    let drawing = read(folder().join("used.svg"), &source).unwrap();
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    // The element is drawn where it is used, twice.
    assert_eq!(outlines.parts.len(), 2);
}

fn made(name: &str, content: &str) -> Outlines {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, content).unwrap();
    let drawing = read(&path, &Source::default()).unwrap();
    drawing.outlines(&Settings::default()).unwrap()
}

/// View boxes in frames of other proportions: evenly in the middle, at a side, filling the frame, or stretched.
#[test]
fn view_boxes_lie_as_they_are_told() {
    let bounds = |frame: &str, inner: &str| {
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" {frame}>{inner}\
             <rect width=\"5\" height=\"5\"/>{}</svg>",
            if inner.is_empty() { "" } else { "</svg>" }
        );
        let b = made("a.svg", &text).parts[0].bounds();
        [b.min.x, b.min.y, b.max.x, b.max.y]
    };
    let page = "width=\"20mm\" height=\"10mm\" viewBox=\"0 0 10 10\"";
    assert_eq!(bounds(page, ""), [0.0, 5.0, 5.0, 10.0]);
    let stretched = format!("{page} preserveAspectRatio=\"none\"");
    assert_eq!(bounds(&stretched, ""), [0.0, 5.0, 10.0, 10.0]);
    let outer = "width=\"100\" height=\"100\" viewBox=\"0 0 100 100\"";
    for (ratio, expected) in [
        ("xMidYMid", [5.0, 95.0, 10.0, 100.0]),
        ("xMinYMid", [0.0, 95.0, 5.0, 100.0]),
        ("xMaxYMin", [10.0, 95.0, 15.0, 100.0]),
        ("none", [0.0, 95.0, 10.0, 100.0]),
        ("xMinYMin slice", [0.0, 90.0, 10.0, 100.0]),
        ("xMinYMid slice", [0.0, 95.0, 10.0, 105.0]),
    ] {
        let inner = format!(
            "<svg width=\"20\" height=\"10\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"{ratio}\">"
        );
        assert_eq!(bounds(outer, &inner), expected, "{ratio}");
    }
}

/// The size that a fit is a share of is that of the loop: what else is in the drawing, far away, does not make it coarser.
#[test]
fn fits_are_as_fine_in_large_drawings() {
    let ellipses = |far: f64| {
        let ellipse = |x: f64| {
            format!(
                "0\nELLIPSE\n8\n0\n10\n{x}\n20\n0\n11\n1\n21\n0\n40\n0.5\n41\n0\n42\n6.283185307179586\n"
            )
        };
        let body: String = [0.0, far].map(ellipse).concat();
        made(
            "a.dxf",
            &format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n"),
        )
    };
    for far in [5.0, 5000.0] {
        let outlines = ellipses(far);
        assert_eq!(outlines.parts.len(), 2);
        assert!(outlines.fitted.deviation <= 1.001e-4 * 20.0_f64.sqrt());
        for part in &outlines.parts {
            let off = part.area() - std::f64::consts::FRAC_PI_2;
            assert!(off.abs() < 1e-3, "{far}: {off}");
        }
    }
}

/// If nothing is left, every reason is reported: a requested layer may be switched off.
#[test]
fn an_empty_drawing_says_why() {
    let text = "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nA\n70\n0\n62\n-7\n0\nENDTAB\n0\nENDSEC\n\
        0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\nB\n10\n0\n20\n0\n40\n1\n0\nCIRCLE\n8\nB\n10\n9\n20\n0\n40\n1\n\
        0\nCIRCLE\n8\nA\n10\n5\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n";
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dxf");
    std::fs::write(&path, text).unwrap();
    let source = Source {
        layers: vec!["A".to_owned()],
        ..Source::default()
    };
    let error = read(&path, &source)
        .and_then(|d| d.outlines(&Settings::default()))
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("2 because: its layer was not asked for"),
        "{error}"
    );
    assert!(
        error.contains("1 because: its layer is switched off"),
        "{error}"
    );
}

/// `S` after `Q`, and `T` after `C`, reflect no control point: they begin at the pen.
#[test]
fn smooth_curves_reflect_control_points_of_their_own_degree() {
    let area = |path: &str| {
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">\
             <path d=\"{path}\"/></svg>"
        );
        made("a.svg", &text).parts[0].area()
    };
    let same = |a: &str, b: &str| assert!((area(a) - area(b)).abs() < 1e-9, "{a}");
    let (quadratic, cubic) = ("M10 50 Q30 20 50 50", "M10 50 C20 20 40 20 50 50");
    let end = "L90 90 L10 90 Z";
    same(
        &format!("{quadratic} S80 80 90 50 {end}"),
        &format!("{quadratic} C50 50 80 80 90 50 {end}"),
    );
    same(
        &format!("{cubic} T90 50 {end}"),
        &format!("{cubic} Q50 50 90 50 {end}"),
    );
    same(
        &format!("{quadratic} T90 50 {end}"),
        &format!("{quadratic} Q70 80 90 50 {end}"),
    );
    same(
        &format!("{cubic} S80 80 90 50 {end}"),
        &format!("{cubic} C60 80 80 80 90 50 {end}"),
    );
}

/// Six picas are an inch, and 72 points are.
#[test]
fn lengths_have_their_units() {
    for (length, millimetres) in [
        ("6pc", 25.4),
        ("72pt", 25.4),
        ("1in", 25.4),
        ("96px", 25.4),
        ("96", 25.4),
        ("2.54cm", 25.4),
        ("25.4mm", 25.4),
    ] {
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\">\
             <rect width=\"{length}\" height=\"10\"/></svg>"
        );
        let bounds = made("a.svg", &text).parts[0].bounds();
        assert!(
            (bounds.max.x - bounds.min.x - millimetres).abs() < 1e-9,
            "{length}"
        );
    }
}

/// Columns and rows of a block go along its own axes, which are mirrored where it is seen from behind.
#[test]
fn columns_of_a_block_seen_from_behind_go_the_other_way() {
    let block = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\n0\n2\nB\n70\n0\n10\n0\n20\n0\n\
         0\nCIRCLE\n8\n0\n10\n0\n20\n0\n40\n1\n0\nENDBLK\n8\n0\n0\nENDSEC\n";
    for (z, least, most) in [(1, 4.0, 16.0), (-1, -16.0, -4.0)] {
        let insert = format!(
            "0\nSECTION\n2\nENTITIES\n0\nINSERT\n8\n0\n2\nB\n10\n5\n20\n0\n70\n2\n44\n10\n230\n{z}\n0\nENDSEC\n0\nEOF\n"
        );
        let parts = made("a.dxf", &format!("{block}{insert}")).parts;
        let bounds = parts.iter().map(Part::bounds);
        let (lo, hi) = bounds.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), b| {
            (lo.min(b.min.x), hi.max(b.max.x))
        });
        assert!(
            (lo - least).abs() < 1e-9 && (hi - most).abs() < 1e-9,
            "{z}: {lo} {hi}"
        );
    }
}

/// A layer that the drawing does not have is not left out silently beside others that it has.
#[test]
fn a_layer_that_is_not_there_is_refused() {
    let asked = |layers: &[&str]| {
        let source = Source {
            layers: layers.iter().map(|&l| l.to_owned()).collect(),
            ..Source::default()
        };
        read(folder().join("layers.dxf"), &source)
    };
    let error = asked(&["outline", "outlne"]).unwrap_err();
    assert_eq!(error.to_string(), "there is no layer \"outlne\"");
    assert!(error.help().contains("\"outline\""), "{}", error.help());
    // Names are not case-sensitive, and a layer that is there may be switched off.
    assert!(asked(&["OUTLINE", "0"]).is_ok());
}
