//! The pictures that are tested.

use std::path::{Path, PathBuf};

use cspace::{Configuration, ContactSpace, FixedAxesSpace, Options, PairSpace, Point};
use cspace_draw::{
    ContactBar, ContactRow, MotionFrame, MotionPicture, PartsPicture, PictureOptions, PlacedPart,
    PlanePath, Scene, SlicesPicture, Track, TrackCurve, motion, parts, plane, slices,
};
use cspace_model::{Document, Mechanism};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub(crate) fn model(name: &str) -> Mechanism {
    match cspace_model::read(root().join("models").join(name)).unwrap() {
        Document::Model(model) => model.mechanism,
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
        PairSpace::Planar(space) => std::sync::Arc::unwrap_or_clone(space),
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

/// Half a turn of the driver, which takes the wheel on by a step in the middle of it, as a page; with an impact that is none.
pub(crate) fn page(space: &FixedAxesSpace) -> MotionPicture<'_> {
    // A smooth step stands for what the slot does.
    let wheel = |t: f64| -0.5 * (1.0 - (core::f64::consts::PI * t).cos());
    let times = (0..=40).map(|k| f64::from(k) / 40.0);
    let (u_axis, v_axis) = space.axes();
    let frame = |t: f64| {
        let placed = |part, assembly_from_part, axis, number| PlacedPart {
            part,
            assembly_from_part,
            axis: Some(axis),
            number,
        };
        let (u, v) = (
            u_axis.configuration(wheel(t)),
            v_axis.configuration(3.0 * t),
        );
        MotionFrame {
            time: t,
            caption: format!("{t:.2} s"),
            parts: PartsPicture {
                parts: vec![
                    placed(space.fixed(), u, u_axis, 0),
                    placed(space.moving(), v, v_axis, 1),
                ],
                without_origins: true,
                ..PartsPicture::default()
            },
        }
    };
    let track = |label: &str, is_angle, part, of: &dyn Fn(f64) -> f64| Track {
        label: label.to_owned(),
        unit: Some("W".to_owned()),
        is_angle,
        curves: vec![TrackCurve {
            points: times.clone().map(|t| (t, of(t))).collect(),
            part,
            title: label.to_owned(),
        }],
    };
    let bar = |from, to, features| ContactBar {
        from,
        to,
        features,
        label: "L0.3 | A1.0".to_owned(),
        title: format!("contact {features}"),
    };
    MotionPicture {
        until: 1.0,
        frames: [0.0, 0.25, 0.5, 0.75].map(frame).into(),
        tracks: vec![
            track("wheel", true, 0, &wheel),
            track("driver", true, 1, &|t| 3.0 * t),
            track("driver, power", false, 1, &|t| 40.0 * t * (1.0 - t)),
        ],
        contacts: vec![ContactRow {
            label: "wheel – driver".to_owned(),
            bars: vec![bar(0.0, 0.4, 0), bar(0.3, 0.7, 1), bar(0.99, 1.0, 2)],
            impacts: vec![(0.3, "impact".to_owned())],
        }],
        events: vec![(0.3, "touch".to_owned()), (0.4, "release".to_owned())],
        planes: vec![PlanePath {
            space,
            path: times.map(|t| (wheel(t), 3.0 * t)).collect(),
        }],
        remarks: vec!["the wheel turns 60 deg ".repeat(9).trim_end().to_owned()],
    }
}

/// One scene of every kind, by name.
pub(crate) fn all() -> Vec<(&'static str, Scene)> {
    let ratchet = planar_space("ratchet_pawl.toml");
    let snap = planar_space("snap_fastener.toml");
    let geneva = axes_space("geneva.toml");
    vec![
        ("motion", motion(&page(&geneva), &options("motion"))),
        ("mechanism", drawn(&model("ratchet_mechanism.toml"))),
        ("slice", beside(&ratchet, 0.1)),
        ("slices", several(&snap)),
        ("geneva", plane(&geneva, &options("geneva"))),
        (
            "tappet",
            plane(&axes_space("cam_tappet.toml"), &options("tappet")),
        ),
    ]
}
