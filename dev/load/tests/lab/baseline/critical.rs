//! The search over all combinations of contacts against the critical orientations of the product.

use core::f64::consts::TAU;
use core::sync::atomic::{AtomicUsize, Ordering};

use cspace::{ContactSpace, Options, Part, Symmetry, Vertex};
use cspace_baseline::critical::{Criticalities, Known, search};
use cspace_baseline::paper;
use cspace_model::model;

/// Largest difference, in radians, of equal orientations: where contact curves become tangent, both methods know them
/// only to the square root of their rounding, and the product grows the fixed part by 2⁻⁴⁰.
const TOLERANCE: f64 = 4e-6;

fn parts(name: &str) -> (Part, Part) {
    let pair = paper::PAIRS.iter().find(|p| p.name == name).unwrap();
    let model = model::from_toml(pair.model, pair.name).unwrap();
    let part = |index: usize| model.parts[index].part.clone();
    (part(model.pairs[0].fixed), part(model.pairs[0].moving))
}

fn space(fixed: &Part, moving: &Part) -> ContactSpace {
    let options = Options {
        symmetry: Symmetry::Ignore,
        ..Options::default()
    };
    ContactSpace::compute(fixed, moving, &options).unwrap()
}

fn all(fixed: &Part, moving: &Part, known: Known) -> Criticalities {
    search(fixed, moving, known, &|| true).unwrap()
}

/// Orientations of the first list that are near none of the second.
fn lacking(of: &[f64], from: &[f64]) -> Vec<f64> {
    let near = |a: f64, b: f64| {
        let off = (a - b).abs();
        off.min(TAU - off) <= TOLERANCE
    };
    let missing = of.iter().filter(|&&t| !from.iter().any(|&c| near(t, c)));
    missing.copied().collect()
}

/// The product's critical orientations are all found, and hardly any others.
#[test]
fn finds_what_the_product_finds() {
    for name in ["cam", "blocks", "crank/slider"] {
        let (fixed, moving) = parts(name);
        let exact = space(&fixed, &moving);
        let found = all(&fixed, &moving, Known::Skipped);
        let critical = exact.critical_orientations();
        let missed = lacking(critical, &found.orientations);
        assert!(missed.is_empty(), "{name} {missed:?} {found:?}");
        let more = lacking(&found.orientations, critical);
        assert!(2 * more.len() <= critical.len(), "{name} {more:?}");
        assert!(found.overlap_tests < found.candidates, "{name}");
    }
}

/// Examining known orientations again finds nothing else, but needs more tests.
#[test]
fn skipping_known_orientations_loses_none() {
    for name in ["cam", "blocks"] {
        let (fixed, moving) = parts(name);
        let [skipped, examined] =
            [Known::Skipped, Known::Examined].map(|k| all(&fixed, &moving, k));
        assert!(lacking(&examined.orientations, &skipped.orientations).is_empty());
        assert!(lacking(&skipped.orientations, &examined.orientations).is_empty());
        assert_eq!(skipped.candidates, examined.candidates);
        assert_eq!(examined.skipped, 0);
        assert!(skipped.skipped > 0 && skipped.overlap_tests < examined.overlap_tests);
    }
}

/// A rectangle in a frame with little to spare: besides parallel sides, three corners meet three sides at the orientations at which the
/// rectangle just fits, known in closed form.
#[test]
fn jamming_in_a_channel_is_a_triple_contact_at_the_angle_that_trigonometry_gives() {
    let corners = |x: f64, y: f64| [(-x, -y), (x, -y), (x, y), (-x, y)];
    let ring = |x: f64, y: f64| {
        corners(x, y)
            .iter()
            .map(|&(x, y)| Vertex::line(x, y))
            .collect()
    };
    let frame = Part::new("frame", vec![ring(9.0, 7.0), ring(6.0, 4.0)]).unwrap();
    let block = Part::new("block", vec![ring(5.0, 3.0)]).unwrap();
    let found = all(&frame, &block, Known::Examined);
    // Height of the turned block: 10 sin θ + 6 cos θ = 8.
    let angle = (8.0_f64 / 10f64.hypot(6.0)).asin() - 6f64.atan2(10.0);
    for t in [angle, -angle] {
        assert!(
            lacking(&[t], &found.orientations).is_empty(),
            "{angle} {found:?}"
        );
    }
    let missed = lacking(
        space(&frame, &block).critical_orientations(),
        &found.orientations,
    );
    assert!(missed.is_empty(), "{missed:?}");
}

/// The result is the same on any number of threads.
#[test]
fn threads_do_not_matter() {
    let (fixed, moving) = parts("cam");
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| all(&fixed, &moving, Known::Skipped))
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn stops_when_told_to() {
    let (fixed, moving) = parts("chain gear");
    let asked = AtomicUsize::new(0);
    let go_on = || asked.fetch_add(1, Ordering::Relaxed) < 100;
    assert_eq!(search(&fixed, &moving, Known::Skipped, &go_on), None);
}
