//! Texts that edits begin with.

use std::sync::LazyLock;

use cspace::pair::Joint;
use cspace::{
    Axis, ContactSpace, FixedAxesSpace, LowerPair, Options, PairSpace, Part, Point, Vector, Vertex,
};
use cspace_model::SavedFile;

/// Shipped models in which every key occurs.
const MODELS: [&str; 4] = [
    include_str!("../../../../models/ratchet_mechanism.toml"),
    include_str!("../../../../models/peg_hole.toml"),
    include_str!("../../../../models/gears_on_shafts.toml"),
    include_str!("../../../../models/paper/blocks.toml"),
];

/// Model as above, as JSON.
const JSON: &str = r#"{"name": "pin in a slot", "unit": "mm", "part": [
  {"name": "plate", "loops": [[[-3, -2], [3, -2], [3, 2], [-3, 2]], [[-1, 0.5, 1], [-1, -0.5], [1, -0.5, 1], [1, 0.5]]],
   "motion": {"type": "revolute", "center": [0, 1], "range": ["-90deg", 1.5]}, "symmetry": 2},
  {"name": "pin", "loops": [[[-0.4, 0, 1], [0.4, 0, 1]]], "motion": {"type": "prismatic", "direction": [1, 0]}}],
 "joint": [{"type": "revolute", "parts": ["plate", "pin"], "at": [0, 0]}],
 "pair": [{"fixed": "plate", "moving": "pin", "theta": ["-10deg", "10deg"]}]}
"#;

/// Texts that are edited.
pub(super) static BASES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut all: Vec<String> = MODELS.iter().map(|&m| m.to_owned()).collect();
    all.push(JSON.to_owned());
    all.extend(saved());
    all
});

/// A small space of each class.
fn saved() -> Vec<String> {
    let square = |r: f64| vec![[-r, -r], [r, -r], [r, r], [-r, r]];
    let loops = |r: f64| vec![square(r).iter().map(|&[x, y]| Vertex::line(x, y)).collect()];
    let (Ok(fixed), Ok(moving)) = (
        Part::new("fixed", loops(2.0)),
        Part::new("moving", loops(1.0)),
    ) else {
        return Vec::new();
    };
    let options = Options {
        window: Some((-0.1, 0.3)),
        ..Options::default()
    };
    let planar = ContactSpace::compute(&fixed, &moving, &options).map(std::sync::Arc::new);
    let axes = [
        Axis::revolute(Point::new(0.0, 0.0)).within(-0.4, 0.5),
        Axis::prismatic(Vector::new(1.0, 0.5)),
    ];
    let axes = FixedAxesSpace::compute(&fixed, axes[0], &moving, axes[1]).map(Box::new);
    let hinge = Joint::Revolute {
        at: Point::new(0.0, 0.0),
    };
    let lower = LowerPair::new(&fixed, &moving, hinge, None);
    let spaces = [
        planar.ok().map(PairSpace::Planar),
        axes.ok().map(PairSpace::FixedAxes),
        Some(PairSpace::Lower(Box::new(lower))),
    ];
    (spaces.into_iter().flatten())
        .map(|space| {
            let file = SavedFile {
                space,
                name: Some("squares".into()),
                unit: None,
            };
            file.to_json()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_them_are_read() {
        assert_eq!(BASES.len(), MODELS.len() + 4);
        for text in BASES.iter() {
            let model = cspace_model::model::from_toml(text, "m.toml").is_ok()
                || cspace_model::model::from_json(text, "m.json").is_ok();
            assert!(
                model || SavedFile::from_json(text, "s.json").is_ok(),
                "{text}"
            );
        }
    }
}
