//! The scene agrees with the library, and can be embedded in a page whatever its content.

use std::collections::BTreeSet;

use cspace::part::PartFeature;
use cspace::{Configuration, Coordinates, Options, PairClass, PairSpace, Part, Vertex};
use cspace_api::scene::{Opened, Scene, ScenePair, SceneRecord};
use cspace_model::{Document, Mechanism, PartEntry, SavedFile};
use serde_json::{Value, json};

fn model(name: &str) -> Mechanism {
    let path = format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    cspace_model::model::read(path).unwrap()
}

/// A sequence of numbers from 0 to 1 that looks random.
fn numbers() -> impl Iterator<Item = f64> {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    std::iter::from_fn(move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        Some((state >> 11) as f64 / (1_u64 << 53) as f64)
    })
}

/// Checks that the space in a pair's JSON is the pair's space: both classify many configurations equally.
#[track_caller]
fn is_the_space(pair: &Value, space: &PairSpace) {
    let read = SavedFile::from_json(pair["space"].as_str().unwrap(), "scene.json")
        .unwrap()
        .space;
    let size = space.fixed().size() + space.moving().size();
    let mut dice = numbers().map(|x| 2.0 * x - 1.0);
    let mut seen = BTreeSet::new();
    for _ in 0..400 {
        let [a, b, c] = [(); 3].map(|()| dice.next().unwrap());
        let at = match space {
            PairSpace::FixedAxes(_) => Coordinates::Axes {
                u: 3.0 * a,
                v: 3.0 * b,
            },
            _ => Coordinates::Planar(Configuration::new(size * a, size * b, 3.0 * c)),
        };
        let class = format!("{:?}", space.classify(at));
        assert_eq!(format!("{:?}", read.classify(at)), class);
        seen.insert(class);
    }
    assert!(
        seen.len() > 1 || space.class() == PairClass::Lower,
        "{seen:?}"
    );
}

#[test]
fn pairs_are_as_the_library_has_them() {
    let mut classes = BTreeSet::new();
    for name in [
        "peg_hole",
        "gears_on_shafts",
        "ratchet_mechanism",
        "cam_tappet",
    ] {
        let model = model(name);
        for entry in &model.pairs {
            let space = model.compute(entry, &Options::default()).unwrap();
            let pair = ScenePair::known(entry, &space, 0.25).unwrap();
            let pair = serde_json::to_value(&pair).unwrap();
            is_the_space(&pair, &space);
            classes.insert(pair["class"].as_str().unwrap().to_owned());
            assert_eq!(pair["class"], space.class().name());
            assert_eq!(pair["contact_distance"], space.contact_distance());
            assert_eq!(pair["resolution"], space.resolution());
            assert_eq!(pair["features"]["fixed"], space.features().fixed);
            assert_eq!(pair["seconds"], 0.25);
            let bands = space.bands().unwrap_or_default();
            assert_eq!(pair["bands"].as_array().unwrap().len(), bands.len());
            for (band, told) in bands.iter().zip(pair["bands"].as_array().unwrap()) {
                assert_eq!(told, &json!([band.lo, band.hi]));
            }
            let regions = space.regions();
            assert_eq!(pair["regions"].as_array().unwrap().len(), regions.len());
            for (region, told) in regions.iter().zip(pair["regions"].as_array().unwrap()) {
                assert_eq!(told["unbounded"], region.unbounded);
                let n = |i: usize| told["sample"][i].as_f64().unwrap();
                let at = match space {
                    PairSpace::FixedAxes(_) => Coordinates::Axes { u: n(0), v: n(1) },
                    _ => Coordinates::Planar(Configuration::new(n(0), n(1), n(2))),
                };
                assert_eq!(space.locate(at).unwrap(), cspace::Location::Free(region.id));
            }
        }
    }
    let all = ["fixed-axes", "general", "lower", "symmetric"].map(str::to_owned);
    assert_eq!(classes, BTreeSet::from(all));
}

#[test]
fn parts_and_joints_are_those_of_the_model() {
    let model = model("ratchet_mechanism");
    let pairs = model.pairs.clone();
    let scene = serde_json::to_value(Opened::model(model.clone(), pairs, false).scene()).unwrap();
    assert_eq!(
        (&scene["name"], &scene["unit"]),
        (&json!(model.name), &json!(model.unit))
    );
    for (entry, part) in model.parts.iter().zip(scene["parts"].as_array().unwrap()) {
        assert_eq!(part["name"], entry.part.name());
        // The very numbers.
        let loops: Vec<Vec<Vertex>> = serde_json::from_value(part["loops"].clone()).unwrap();
        let given: Vec<&[Vertex]> = entry.part.loops().iter().map(|l| l.vertices()).collect();
        assert_eq!(loops, given);
    }
    let kind = |i: usize| scene["parts"][i]["motion"]["type"].as_str().unwrap();
    assert_eq!(
        [0, 1, 2, 3, 4].map(kind),
        ["fixed", "revolute", "revolute", "planar", "revolute"]
    );
    assert_eq!(
        scene["parts"][1]["motion"]["center"],
        json!({ "x": 0.0, "y": -100.0 })
    );
    assert_eq!(scene["joints"][3]["parts"], json!([2, 3]));
    assert_eq!(scene["joints"][3]["at"], json!({ "x": 42.0, "y": 56.0 }));
    assert!(
        scene["pairs"]
            .as_array()
            .unwrap()
            .iter()
            .all(|p| p["space"].is_null())
    );
}

/// Names are found under what the features of patches are called without them.
#[test]
fn names_of_features_stand_for_those_of_patches() {
    let arc = |x: f64, y: f64, bulge: f64| Vertex::new(x, y, bulge);
    let hollow = [
        arc(-4.0, 0.0, 0.0),
        arc(4.0, 0.0, 0.0),
        arc(4.0, 4.0, 0.0),
        arc(2.0, 4.0, -1.0),
        arc(-2.0, 4.0, 0.0),
        arc(-4.0, 4.0, 0.0),
    ];
    // Listed clockwise: edges are travelled backwards.
    let coin = [arc(0.0, -1.0, -1.0), arc(0.0, 1.0, -1.0)];
    let mut fixed = Part::new("hollow", vec![hollow.to_vec()]).unwrap();
    let mut moving = Part::new("coin", vec![coin.to_vec()]).unwrap();
    let (loop_index, edge) = (0, |index| PartFeature::Edge {
        loop_index: 0,
        index,
    });
    for i in 0..6 {
        fixed = fixed
            .with_feature_name(edge(i), format!("side {i}"))
            .unwrap();
        let corner = PartFeature::Vertex {
            loop_index,
            index: i,
        };
        fixed = fixed
            .with_feature_name(corner, format!("corner {i}"))
            .unwrap();
    }
    moving = moving.with_feature_name(edge(1), "left half").unwrap();
    let mut model = Mechanism::new("named");
    model.parts = [fixed, moving].map(PartEntry::planar).to_vec();
    model.pairs = model.every_two();
    let space = model.compute(&model.pairs[0], &Options::default()).unwrap();
    let scene = Scene::of(&model, Vec::new(), Vec::new());
    let mut named = BTreeSet::new();
    let PairSpace::Planar(planar) = &space else {
        panic!("{space:?}")
    };
    for patch in planar.patches() {
        for (i, feature) in [(0, patch.fixed), (1, patch.moving)] {
            let plain = feature.to_string();
            let shown = scene.parts[i].feature_names.get(&plain).unwrap_or(&plain);
            assert_eq!(*shown, model.parts[i].part.feature_text(feature));
            named.extend((*shown != plain).then(|| plain.clone()));
        }
    }
    for kind in ["line", "concave arc 3", "convex arc 1", "vertex"] {
        assert!(
            named.iter().any(|n| n.starts_with(kind)),
            "{kind}: {named:?}"
        );
    }
}

#[test]
fn saved_spaces_are_scenes_of_two_parts() {
    for (name, pair) in [
        ("peg_hole", 0),
        ("gears_on_shafts", 0),
        ("ratchet_mechanism", 0),
        ("ratchet_mechanism", 5),
    ] {
        let model = model(name);
        let space = model
            .compute(&model.pairs[pair], &Options::default())
            .unwrap();
        let text = cspace_model::saved::with_labels(&space, Some("saved"), None);
        let Ok(Document::Space(file)) = cspace_model::read_from(text.as_bytes(), "saved.json")
        else {
            panic!("{name}");
        };
        let opened = Opened::saved(*file);
        opened.model.check().unwrap();
        // The parts are related as they were: what is computed of them is of the same class.
        let entry = opened.pairs[0];
        assert_eq!(
            opened
                .model
                .compute(&entry, &Options::default())
                .unwrap()
                .class(),
            space.class()
        );
        let scene = opened.scene();
        assert_eq!(
            (scene.name.as_str(), scene.parts.len(), scene.pairs.len()),
            ("saved", 2, 1)
        );
        assert_eq!(scene.pairs[0].class, space.class());
        assert_eq!(scene.parts[0].name, space.fixed().name());
    }
}

/// The limits of a lower pair are in its file alone.
#[test]
fn limits_of_a_saved_joint_are_kept() {
    let hinge = cspace::pair::Joint::Revolute {
        at: cspace::Point::new(1.0, 2.0),
    };
    let part = |name: &str| Part::circle(name, (0.0, 0.0), 1.0).unwrap();
    let pair = cspace::LowerPair::new(&part("a"), &part("b"), hinge, Some((-0.5, 0.25)));
    let opened = Opened::saved(SavedFile {
        space: PairSpace::Lower(Box::new(pair)),
        name: None,
        unit: None,
    });
    assert_eq!(opened.model.name, "a and b");
    let again = opened
        .model
        .compute(&opened.pairs[0], &Options::default())
        .unwrap();
    let PairSpace::Lower(again) = again else {
        panic!("{again:?}")
    };
    assert_eq!((again.joint(), again.limits()), (hinge, Some((-0.5, 0.25))));
}

/// The names of the fields of an interface in `scene.ts`.
fn fields(interface: &str) -> BTreeSet<String> {
    let source = include_str!("../../../cspace-cli/page/src/scene.ts");
    let (_, rest) = source
        .split_once(&format!("export interface {interface} {{\n"))
        .unwrap();
    let body = rest.split_once("\n}").unwrap().0;
    body.lines()
        .filter_map(|l| {
            l.strip_prefix("  ")?
                .split_once(':')
                .map(|f| f.0.to_owned())
        })
        .filter(|f| f.bytes().all(|b| b.is_ascii_lowercase() || b == b'_'))
        .collect()
}

#[test]
fn the_page_reads_the_fields_that_are_written() {
    let model = model("ratchet_mechanism");
    let entry = model.pairs[5];
    let space = model.compute(&entry, &Options::default()).unwrap();
    let pair = ScenePair::known(&entry, &space, 0.0).unwrap();
    let record = SceneRecord {
        name: String::new(),
        record: Value::Null,
    };
    let pairs = vec![entry];
    let mut opened = Opened::model(model, pairs, false);
    opened.records = vec![record];
    let scene = serde_json::to_value(opened.scene_with(vec![pair])).unwrap();
    let written = |value: &Value| -> BTreeSet<String> {
        value.as_object().unwrap().keys().cloned().collect()
    };
    for (interface, value) in [
        ("Scene", &scene),
        ("ScenePart", &scene["parts"][0]),
        ("SceneVertex", &scene["parts"][0]["loops"][0][0]),
        ("SceneJoint", &scene["joints"][0]),
        ("ScenePair", &scene["pairs"][0]),
        ("SceneRegion", &scene["pairs"][0]["regions"][0]),
        ("SceneRecord", &scene["records"][0]),
        ("SceneSource", &scene["source"]),
    ] {
        assert_eq!(fields(interface), written(value), "{interface}");
    }
}
