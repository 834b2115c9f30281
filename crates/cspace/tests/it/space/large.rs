//! Pairs of thousands of features: they are computed in time and memory in proportion to the result, or rejected.
//!
//! The largest are measured by hand, see the example `large` of `cspace-oracle`.

use core::f64::consts::TAU;

use cspace::{
    AxesError, Axis, Classification, ComputeError, Configuration, ContactSpace, FixedAxesSpace,
    Options, Part, Point, Vertex,
};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A round saw with uneven teeth, at most `depth` deep.
fn saw(name: &str, vertices: usize, radius: f64, depth: f64, seed: u64) -> Part {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let outline = (0..vertices).map(|i| {
        let (sin, cos) = (TAU * i as f64 / vertices as f64).sin_cos();
        let r = radius - rng.random_range(0.0..depth);
        Vertex::line(r * cos, r * sin)
    });
    Part::new(name, vec![outline.collect()]).unwrap()
}

fn triangle() -> Part {
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.3, 0.9)];
    let outline = corners.map(|(x, y)| Vertex::line(x, y));
    Part::new("wedge", vec![outline.to_vec()]).unwrap()
}

/// Places near the rim are classified correctly, according to an overlap test without contacts: corners inside the other part, or edges
/// that cross.
#[test]
fn thousands_of_teeth_are_told_right() {
    let (saw, wedge) = (saw("saw", 1500, 10.0, 0.3, 7), triangle());
    let space = ContactSpace::compute(&saw, &wedge, &Options::default()).unwrap();
    assert_eq!(space.statistics().conflicts, 0);
    assert_eq!(space.free_regions().len(), 1);
    // Without excluding certainly blocked places there are some ten times as many branches as patches.
    let (branches, patches) = (space.statistics().branches, space.patches().len() as u64);
    assert!(branches < 4 * patches, "{branches} {patches}");
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut seen = [0, 0];
    for _ in 0..300 {
        let (at, r) = (rng.random_range(0.0..TAU), rng.random_range(9.0..10.8));
        let theta = rng.random_range(-3.0..3.0);
        let c = Configuration::new(r * f64::cos(at), r * f64::sin(at), theta);
        let expected = overlap(&saw, &wedge, c);
        let told = space.classify(c);
        let right = if expected {
            Classification::Blocked
        } else {
            Classification::Free
        };
        assert_eq!(told, Some(right), "{c:?}");
        seen[usize::from(expected)] += 1;
    }
    assert!(seen.iter().all(|&n| n > 50), "{seen:?}");
}

/// Naive overlap test of polygons.
fn overlap(fixed: &Part, moving: &Part, c: Configuration) -> bool {
    let turn = cspace::Rotation::by(c.theta);
    let place = |p: Point| c.position() + (turn * p).to_vector();
    let back = |p: Point| turn.inverse() * (Point::ORIGIN + (p - c.position()));
    let crossing = moving.edges().any(|m| {
        let (a, b) = (place(m.start), place(m.end));
        fixed.edges().any(|f| {
            let side = |p: Point, q: Point, r| (q - p).cross(r - p) > 0.0;
            side(a, b, f.start) != side(a, b, f.end)
                && side(f.start, f.end, a) != side(f.start, f.end, b)
        })
    });
    crossing
        || moving.edges().any(|m| fixed.contains(place(m.start)))
        || fixed.edges().any(|f| moving.contains(back(f.start)))
}

/// A plate with hundreds of holes: a region in each, one outside.
#[test]
fn every_hole_of_a_plate_is_a_region() {
    let side = 20;
    let square = |x: f64, y: f64, r: f64| {
        [(-r, -r), (r, -r), (r, r), (-r, r)]
            .map(|(u, v)| Vertex::line(x + u, y + v))
            .to_vec()
    };
    let mut loops = vec![square(9.5, 9.5, 12.0)];
    for i in 0..side * side {
        loops.push(square(f64::from(i % side), f64::from(i / side), 0.3));
    }
    let plate = Part::new("plate", loops).unwrap();
    let peg = Part::new("peg", vec![square(0.0, 0.0, 0.2)]).unwrap();
    let space = ContactSpace::compute(&plate, &peg, &Options::default()).unwrap();
    assert_eq!(space.free_regions().len(), 1 + 400);
    for (i, region) in space.free_regions().iter().enumerate() {
        assert_eq!(region.unbounded, i == 0);
        assert_eq!(
            space.classify(region.sample),
            Some(Classification::Free),
            "{region:?}"
        );
    }
}

/// Parts with too many edges are refused before memory is spent.
#[test]
fn what_is_too_large_is_refused() {
    let compute = |fixed: &Part, moving: &Part| {
        ContactSpace::compute(fixed, moving, &Options::default()).map(|s| s.patches().len())
    };
    let many = saw("many", 3000, 10.0, 0.01, 3);
    assert_eq!(
        compute(&many, &many),
        Err(ComputeError::TooLarge {
            fixed: 3000,
            moving: 3000,
            limit: 1 << 23
        })
    );
    let few = saw("few", 16, 1.0, 0.1, 5);
    let more = saw("more", 8200, 10.0, 0.001, 4);
    let turn = Axis::revolute(Point::ORIGIN);
    assert_eq!(
        FixedAxesSpace::compute(&more, turn, &more, turn).err(),
        Some(AxesError::TooLarge {
            fixed: 8200,
            moving: 8200,
            limit: 1 << 26
        })
    );
    let huge = saw("huge", 300_000, 10.0, 1e-4, 5);
    assert_eq!(
        compute(&few, &huge),
        Err(ComputeError::TooManyEdges {
            part: "huge".into(),
            edges: 300_000,
            limit: 1 << 18
        })
    );
}
