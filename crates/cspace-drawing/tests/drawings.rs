//! The drawings of `tests/drawings`, which `make.py` there makes with ezdxf, another program's reader and writer of DXF: what is
//! to be found in each is computed from its dimensions.

#![allow(clippy::unwrap_used, clippy::panic, missing_docs)]

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
        let outlines = read(folder().join(name), &Source::default())
            .and_then(|drawing| drawing.outlines(&settings))
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        check(name, &outlines, expected);
    }
}

/// The same outline drawn in any unit is the same number of lines and arcs.
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
        id: Some("hole".to_owned()),
        ..Source::default()
    };
    let drawing = read(folder().join("used.svg"), &source).unwrap();
    let outlines = drawing.outlines(&Settings::default()).unwrap();
    // The element is drawn where it is used, twice.
    assert_eq!(outlines.parts.len(), 2);
}
