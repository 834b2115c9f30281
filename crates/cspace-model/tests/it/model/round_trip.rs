//! Models written as TOML are read back unchanged.

use cspace::pair::Joint;
use cspace::{Axis, Part, Point, Vector, Vertex};
use cspace_model::{JointEntry, Mechanism, PairEntry, PartEntry, model};

fn round_trip(model: &Mechanism) {
    let text = model::to_toml(model);
    let again = model::from_toml(&text, "m.toml").unwrap();
    assert_eq!(&again, model, "{text}");
    assert_eq!(model::to_toml(&again), text);
}

fn entry(name: &str, x: f64, axis: Option<Axis>) -> PartEntry {
    let third = 1.0 / 3.0;
    let outline = vec![
        Vertex::new(x, -1e-7, third),
        Vertex::line(x + 2.0, 0.1 + 0.2),
        Vertex::new(x + 1.0, 10.0 * third, -0.125),
    ];
    PartEntry {
        axis,
        ..PartEntry::planar(Part::new(name, vec![outline]).unwrap())
    }
}

#[test]
fn every_motion_joint_and_window() {
    let third = 1.0 / 3.0;
    let parts = vec![
        entry("a \"quoted\" \\ name", 0.0, Some(Axis::FIXED)),
        PartEntry {
            part: Part::new(
                "räder",
                vec![vec![
                    Vertex::new(third, 0.1, 1.0),
                    Vertex::new(1e4, 0.1 + 0.2, 1.0),
                ]],
            )
            .unwrap(),
            symmetry: Some(20),
            ..entry(
                "räder",
                1e4,
                Some(Axis::revolute(Point::new(third, -0.0)).within(-third, 1e-300)),
            )
        },
        entry(
            "slider",
            -5e5,
            Some(Axis::prismatic(Vector::new(third, -1e-9))),
        ),
        entry("free", 7.0, None),
    ];
    let joints = [
        Joint::Revolute {
            at: Point::new(third, 2.0),
        },
        Joint::Prismatic {
            direction: Vector::new(0.0, third),
            at: Point::ORIGIN,
        },
        Joint::Prismatic {
            direction: Vector::new(1.0, 0.0),
            at: Point::new(1e21, 3.0),
        },
    ]
    .into_iter()
    .zip([(2, 1), (3, 1), (3, 0)])
    .map(|(joint, parts)| JointEntry { joint, parts });
    round_trip(&Mechanism {
        name: "all of it".into(),
        unit: Some("mm".into()),
        parts,
        joints: joints.collect(),
        pairs: vec![
            PairEntry {
                fixed: 3,
                moving: 1,
                window: Some((-core::f64::consts::PI, core::f64::consts::PI)),
            },
            PairEntry {
                fixed: 0,
                moving: 2,
                window: None,
            },
        ],
        ..Mechanism::default()
    });
}

#[test]
fn pairs_that_a_file_without_pairs_stands_for_are_left_out() {
    let parts = vec![entry("a", 0.0, Some(Axis::FIXED)), entry("b", 0.0, None)];
    let pair = PairEntry {
        fixed: 0,
        moving: 1,
        window: None,
    };
    let model = Mechanism {
        name: "two".into(),
        parts,
        pairs: vec![pair],
        ..Mechanism::default()
    };
    assert!(!model::to_toml(&model).contains("[[pair]]"));
    round_trip(&model);
}

#[test]
fn the_shipped_models() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            round_trip(&model::read(&path).unwrap());
        }
    }
}

#[test]
fn names_of_features_are_kept() {
    let text = "[[part]]\nname = \"a\"\nloops = [[[0, 0], [4, 0, 0.5], [0, 4]]]\n\
        names = { \"arc 1 of loop 0\" = \"flank \\\"b\\\"\", \"vertex 1 of loop 0\" = \"toe\" }\n";
    let read = model::from_toml(text, "a.toml").unwrap();
    let again = model::to_toml(&read);
    assert_eq!(model::from_toml(&again, "b.toml").unwrap(), read);
    let names: Vec<String> = (read.parts[0].part.feature_names())
        .map(|(feature, name)| format!("{feature}: {name}"))
        .collect();
    assert_eq!(
        names,
        ["edge 1 of loop 0: flank \"b\"", "vertex 1 of loop 0: toe"]
    );
}
