//! The stack and its surface against the exact contact space.

use core::f64::consts::{FRAC_PI_2, SQRT_2};

use cspace::{Classification, Configuration, ContactSpace, Options, Part, Symmetry, Vertex};
use cspace_baseline::compare::{Errors, errors, missed_bands};
use cspace_baseline::{Stack, Surface, evenly, paper, with_bands};
use cspace_model::model;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

struct Both {
    space: ContactSpace,
    surface: Surface,
    errors: Errors,
}

fn both(pair: &paper::PaperPair, separation: f64) -> Both {
    let model = model::from_toml(pair.model, pair.name).unwrap();
    let [fixed, moving] =
        [model.pairs[0].fixed, model.pairs[0].moving].map(|i| &model.parts[i].part);
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    let space = ContactSpace::compute(fixed, moving, &options).unwrap();
    let orientations = with_bands(separation, &space.bands()).unwrap();
    let stack = Stack::new(fixed, moving, &orientations);
    let surface = Surface::new(&stack, 1e-3 * (fixed.size() + moving.size()));
    let errors = errors(&stack, &surface, &space);
    assert_eq!(errors.unknown, 0, "{}", pair.name);
    assert!(errors.boundary_lines > 0, "{} {errors:?}", pair.name);
    Both {
        space,
        surface,
        errors,
    }
}

/// Farther from contact than the largest gap and what arcs lose as straight pieces, both say the same.
#[test]
fn surface_and_space_agree_away_from_contact() {
    for pair in &paper::PAIRS {
        let Both {
            space,
            surface,
            errors,
        } = both(pair, 0.005);
        let clear = errors.largest_gap + surface.accuracy;
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let (mut free, mut blocked, mut open) = (0, 0, 0);
        while free + blocked < 400 {
            let theta = rng.random_range(-7.0..7.0);
            let slice = space.slice(theta);
            // About a place of contact.
            let curve = &slice.curves[rng.random_range(0..slice.curves.len())].geometry;
            let at = curve.point(rng.random_range(0.0..1.0));
            let reach = 8.0 * clear;
            let p = cspace::Point::new(
                at.x + rng.random_range(-reach..reach),
                at.y + rng.random_range(-reach..reach),
            );
            let distances = slice
                .curves
                .iter()
                .map(|c| c.geometry.nearest(p).distance(p));
            if distances.fold(f64::INFINITY, f64::min) <= clear {
                continue;
            }
            let c = Configuration::new(p.x, p.y, theta);
            let class = space.classify(c).unwrap();
            match surface.is_free(c) {
                None => open += 1,
                Some(true) => {
                    assert_eq!(class, Classification::Free, "{} {c:?}", pair.name);
                    free += 1;
                }
                Some(false) => {
                    assert_eq!(class, Classification::Blocked, "{} {c:?}", pair.name);
                    blocked += 1;
                }
            }
            assert!(open < 800, "{}: hardly any layer is closed", pair.name);
        }
        assert!(free > 50 && blocked > 50, "{}: {free} {blocked}", pair.name);
    }
}

/// All boundary curves of two convex polygons are ends of features: circles about a corner of the fixed part, as far away as a
/// corner of the moving part is from its origin. The chord of an angle h of a circle of radius r is r (1 − cos h/2) from it.
#[test]
fn gap_of_polygons_is_that_of_chords() {
    let rectangle = |name: &str, x: f64, y: f64| {
        let corners = [(-x, -y), (x, -y), (x, y), (-x, y)];
        let corners = corners.iter().map(|&(x, y)| Vertex::line(x, y));
        Part::new(name, vec![corners.collect()]).unwrap()
    };
    let (table, block) = (rectangle("table", 5.0, 3.0), rectangle("block", 4.0, 3.0));
    let space = ContactSpace::compute(&table, &block, &Options::default()).unwrap();
    assert_eq!(space.critical_orientations().len(), 4);
    let gap = |n: f64| {
        let orientations = with_bands(1.000_001 * FRAC_PI_2 / n, &space.bands()).unwrap();
        assert_eq!(orientations.len(), 4 * n as usize);
        let stack = Stack::new(&table, &block, &orientations);
        errors(&stack, &Surface::new(&stack, 1e-3), &space)
    };
    let [coarse, fine] = [100.0, 200.0].map(|n| {
        let found = gap(n);
        let chord = 5.0 * (1.0 - (0.5 * FRAC_PI_2 / n).cos());
        assert!((found.largest_gap - chord).abs() < 1e-9, "{n} {found:?}");
        assert_eq!(found.joined_across, 0);
        // The parts' sides align at four orientations.
        assert_eq!(found.open_layers, 4);
        found.largest_gap
    });
    assert!((coarse / fine - 4.0).abs() < 1e-3, "{coarse} {fine}");
}

/// Where two contact curves become tangent, their crossing moves with the square root of the orientation: half the
/// separation reduces the gap by no more than √2.
#[test]
fn gap_at_tangencies_goes_with_the_root_of_the_separation() {
    let pair = paper::PAIRS.iter().find(|p| p.name == "blocks").unwrap();
    let [coarse, fine] = [0.01, 0.005].map(|s| both(pair, s).errors.largest_gap);
    let ratio = coarse / fine;
    assert!((ratio - SQRT_2).abs() < 0.05, "{coarse} {fine}");
}

/// Slices far apart take pieces of contact for one that are not.
#[test]
fn wide_separations_join_what_is_separate() {
    let pair = paper::PAIRS.iter().find(|p| p.name == "cam").unwrap();
    let fine = both(pair, 0.005);
    assert_eq!(fine.errors.joined_across, 0, "{:?}", fine.errors);
    // With a slice in every band, each critical orientation lies in a layer of its own.
    let changes = fine.space.critical_orientations().len();
    assert_eq!(fine.errors.open_layers, changes, "{:?}", fine.errors);

    let plain = evenly(1.0).unwrap();
    let stack = Stack::new(fine.space.fixed(), fine.space.moving(), &plain);
    let coarse = errors(&stack, &Surface::new(&stack, 1.0), &fine.space);
    assert!(coarse.joined_across > 0, "{coarse:?}");
    assert!(missed_bands(&fine.space, &plain) >= changes - plain.len());
}

/// Within bands nothing is joined wrongly.
#[test]
fn layers_within_bands_are_closed() {
    for name in ["cam", "fixture", "patella/femur"] {
        let pair = paper::PAIRS.iter().find(|p| p.name == name).unwrap();
        let Both { space, surface, .. } = both(pair, 0.005);
        let critical = space.critical_orientations();
        let mut within = 0;
        for layer in &surface.layers {
            let (lo, hi) = layer.theta;
            let turn = core::f64::consts::TAU;
            let crossed = critical.iter().any(|&c| {
                let c = c + turn * ((lo - c) / turn).ceil();
                c <= hi
            });
            if !crossed {
                within += 1;
                assert!(layer.closed, "{name} {lo} {hi}");
            }
        }
        assert!(within > 1000, "{name} {within}");
    }
}
