//! The pictures that are tested.

use std::path::{Path, PathBuf};

use cspace::{Configuration, ContactSpace, FixedAxesSpace, Mechanism, Options, PairSpace, Point};
use cspace_draw::{
    PartsPicture, PictureOptions, PlacedPart, Scene, SlicesPicture, parts, plane, slices,
};
use cspace_io::Document;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn model(name: &str) -> Mechanism {
    match cspace_io::read(root().join("models").join(name)).unwrap() {
        Document::Model(model) => *model,
        Document::Space(_) => panic!("{name} is a space"),
    }
}

pub(crate) fn options(title: &str) -> PictureOptions {
    PictureOptions {
        title: title.to_owned(),
        unit: Some("mm".to_owned()),
        ..PictureOptions::default()
    }
}

pub(crate) fn axes_space(name: &str) -> FixedAxesSpace {
    let model = model(name);
    let computed = model
        .pairs
        .iter()
        .map(|p| model.compute(p, &Options::default()).unwrap());
    let axes = |space| match space {
        PairSpace::FixedAxes(space) => Some(*space),
        _ => None,
    };
    computed.into_iter().find_map(axes).unwrap()
}

fn planar_space(name: &str) -> ContactSpace {
    let model = model(name);
    match model.compute(&model.pairs[0], &Options::default()).unwrap() {
        PairSpace::Planar(space) => *space,
        _ => panic!("{name} has no orientations"),
    }
}

fn drawn(model: &Mechanism) -> Scene {
    let picture = PartsPicture {
        parts: (model.parts.iter().enumerate())
            .map(|(number, entry)| PlacedPart {
                part: &entry.part,
                assembly_from_part: Configuration::default(),
                axis: entry.axis,
                number,
            })
            .collect(),
        joints: model.joints.clone(),
        ..PartsPicture::default()
    };
    parts(&picture, &options(&model.name))
}

fn beside(space: &ContactSpace, theta: f64) -> Scene {
    let at = space
        .nearest_contact(Configuration::new(0.0, 0.0, theta))
        .unwrap()
        .configuration;
    let placed = |part, assembly_from_part, number| PlacedPart {
        part,
        assembly_from_part,
        axis: None,
        number,
    };
    let picture = SlicesPicture {
        space,
        slices: &[space.slice(theta)],
        parts: Some((
            PartsPicture {
                parts: vec![
                    placed(space.fixed(), Configuration::default(), 0),
                    placed(space.moving(), at, 1),
                ],
                ..PartsPicture::default()
            },
            Point::new(at.x, at.y),
        )),
    };
    slices(&picture, &options("slice"))
}

fn several(space: &ContactSpace) -> Scene {
    let drawn: Vec<_> = [-1.0, 0.0, 0.5, 2.0].map(|t| space.slice(t)).to_vec();
    let picture = SlicesPicture {
        space,
        slices: &drawn,
        parts: None,
    };
    slices(&picture, &options("slices"))
}

/// One of every kind, by name.
pub(crate) fn all() -> Vec<(&'static str, Scene)> {
    let ratchet = planar_space("ratchet_pawl.toml");
    let snap = planar_space("snap_fastener.toml");
    vec![
        ("mechanism", drawn(&model("ratchet_mechanism.toml"))),
        ("slice", beside(&ratchet, 0.1)),
        ("slices", several(&snap)),
        (
            "geneva",
            plane(&axes_space("geneva.toml"), &options("geneva")),
        ),
        (
            "tappet",
            plane(&axes_space("cam_tappet.toml"), &options("tappet")),
        ),
    ]
}
