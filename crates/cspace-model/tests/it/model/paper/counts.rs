//! Numbers of features and symmetries, as in Figure 5 of Sacks 1999.

use std::io::ErrorKind;
use std::process::Command;

use cspace::PairClass;
use cspace::{ContactSpace, Options, Part, Symmetry};

use super::helpers::{model, parts};

/// The pairs of Figure 5: features of both parts, and the fold of the symmetry.
const PAIRS: [(&str, usize, u32); 11] = [
    ("cam", 16, 1),
    ("fixture", 36, 1),
    ("fastener", 32, 1),
    ("ratchet_pawl", 96, 20),
    ("geneva", 61, 4),
    ("film_advance", 53, 3),
    ("crank_slider", 24, 1),
    ("blocks", 20, 1),
    ("chain_gear", 166, 14),
    ("tibia_femur", 52, 1),
    ("patella_femur", 24, 1),
];

/// Lines, arcs, and vertices at which the outline has a corner.
fn features(part: &Part) -> usize {
    let mut count = 0;
    for boundary in part.loops() {
        let edges: Vec<_> = boundary.edges().collect();
        for (i, edge) in edges.iter().enumerate() {
            let (before, after) = (
                edge.end_direction(),
                edges[(i + 1) % edges.len()].start_direction(),
            );
            let corner = before.cross(after).atan2(before.dot(after)).abs();
            assert!(!(1e-11..0.1).contains(&corner), "nearly smooth: {corner}");
            count += 1 + usize::from(corner > 0.1);
        }
    }
    count
}

#[test]
fn features_are_those_of_figure_5() {
    for (name, expected, _) in PAIRS {
        let (fixed, moving) = parts(name);
        assert_eq!(features(&fixed) + features(&moving), expected, "{name}");
    }
}

#[test]
fn symmetries_are_those_of_figure_5() {
    for (name, _, fold) in PAIRS {
        let (fixed, moving) = parts(name);
        let folds = [fixed.symmetry().fold(), moving.symmetry().fold()];
        // The link of the chain can be turned end for end.
        let other = if name == "chain_gear" { 2 } else { 1 };
        assert_eq!(folds.iter().max(), Some(&fold), "{name}");
        assert_eq!(folds.iter().min(), Some(&other), "{name}");
    }
}

#[test]
fn pairs_are_general() {
    for (name, ..) in PAIRS {
        let model = model(name);
        assert_eq!((model.parts.len(), model.pairs.len()), (2, 1), "{name}");
        assert!(model.parts.iter().all(|p| p.axis.is_none()));
        assert!(model.pairs[0].window.is_none(), "{name}");
        assert!(matches!(
            model.pair_class(&model.pairs[0]),
            PairClass::General | PairClass::Symmetric
        ));
    }
}

/// Over the whole turn, without a conflict, and with symmetry the same bands as without.
#[test]
fn bands_with_symmetry_are_those_without() {
    for (name, features, fold) in PAIRS {
        let (fixed, moving) = parts(name);
        let compute = |symmetry| {
            let options = Options {
                symmetry,
                ..Options::default()
            };
            ContactSpace::compute(&fixed, &moving, &options).unwrap()
        };
        let [with, without] = [Symmetry::Detect, Symmetry::Ignore].map(compute);
        for space in [&with, &without] {
            assert_eq!(space.statistics().conflicts, 0, "{name}");
            assert_eq!(
                (space.features().fixed + space.features().moving) as usize,
                features,
                "{name}"
            );
            assert!(space.window().full_turn, "{name}");
        }
        assert_eq!(with.symmetry().slabs, fold, "{name}");
        let bands = with.bands().len();
        assert_eq!(with.computed_bands() * fold as usize, bands, "{name}");
        assert_eq!(without.bands().len(), bands, "{name}");
        assert_eq!(with.free_regions().len(), without.free_regions().len());
    }
}

/// Files are identical to those drawn by the drawing programs. Passes if there is no Python.
#[test]
fn files_are_as_drawn() {
    for program in ["draw.py", "mechanisms.py", "weighed.py", "paper/draw.py"] {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
        let run = Command::new("python3")
            .arg("-B")
            .arg(format!("{folder}/{program}"))
            .arg("--check")
            .output();
        match run {
            Ok(output) => assert!(output.status.success(), "{output:?}"),
            Err(error) if error.kind() == ErrorKind::NotFound => return,
            Err(error) => panic!("{error}"),
        }
    }
}
