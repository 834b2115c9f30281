//! The farthest configurations, compared with exact slices at many orientations, and with places known by hand.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use cspace::part::{circle_loop, polygon_loop};
use cspace::{
    Configuration, ContactSpace, CurveGeometry, NoFit, Options, Part, Point, Slice, Vector, Vertex,
};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::Case;

const DOWN: Vector = Vector { x: 0.0, y: -1.0 };

/// A loop around the origin with corners at random distances, about half of its edges arcs.
fn star(rng: &mut impl Rng, corners: u32, radius: (f64, f64), arcs: bool) -> Vec<Vertex> {
    (0..corners)
        .map(|k| {
            let angle = (f64::from(k) + rng.random_range(-0.3..0.3)) * TAU / f64::from(corners);
            let p = Vector::from_angle(angle) * rng.random_range(radius.0..radius.1);
            let bulge = match arcs && rng.random_bool(0.5) {
                true => rng.random_range(-0.25..0.25),
                false => 0.0,
            };
            Vertex::new(p.x, p.y, bulge)
        })
        .collect()
}

fn around(hole: &Part) -> Part {
    let wall = polygon_loop(&[(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)]);
    let loops = hole.loops().iter().map(|l| l.vertices().to_vec());
    Part::new("walls", [wall].into_iter().chain(loops).collect()).unwrap()
}

/// How far a point is at the places of a slice, each curve's ends and, where it has one, its point across the direction.
fn reach(slice: &Slice, direction: Vector, about: Point) -> f64 {
    let places = slice.curves.iter().flat_map(|c| {
        let across = match c.geometry {
            CurveGeometry::Arc { center, radius, .. } => center + direction * radius,
            _ => c.geometry.point(0.5),
        };
        let g = c.geometry;
        [g.point(0.0), g.point(1.0), g.nearest(across)]
    });
    let far = places.map(|p| {
        let at = Configuration::new(p.x, p.y, slice.theta);
        direction.dot(at.fixed_from_moving(about).to_vector())
    });
    far.fold(f64::NEG_INFINITY, f64::max)
}

/// No slice reaches farther, and slices beside the configuration reach as far but for what the orientation is off.
#[test]
fn no_slice_reaches_farther() {
    const CASES: u64 = 240;
    const TURNS: u32 = 150;
    let fits = (0..CASES).into_par_iter().filter(|&case| {
        let _case = Case(case);
        let mut rng = ChaCha8Rng::seed_from_u64(case);
        let arcs = case % 3 != 0;
        let corners = rng.random_range(4..8);
        let hole = loop {
            let outline = star(&mut rng, corners, (2.0, 4.0), arcs);
            let mut loops = vec![outline];
            if rng.random_bool(0.3) {
                let r = rng.random_range(0.1..0.5);
                loops.push(circle_loop(Point::new(rng.random_range(-0.6..0.6), 0.0), r).unwrap());
            }
            if let Ok(hole) = Part::new("hole", loops) {
                break hole;
            }
        };
        let part = loop {
            let corners = rng.random_range(3..6);
            let outline = star(&mut rng, corners, (0.3, 1.4), arcs);
            if let Ok(part) = Part::new("part", vec![outline]) {
                break part;
            }
        };
        let direction = Vector::from_angle(rng.random_range(0.0..TAU));
        let about = match case % 2 {
            0 => part.moments().centroid,
            _ => Point::new(rng.random_range(-2.0..2.0), rng.random_range(-2.0..2.0)),
        };
        let space = ContactSpace::compute(&around(&hole), &part, &Options::default()).unwrap();
        let fit = NoFit::within(&hole, &part);
        let Some(found) = space.farthest(direction, about) else {
            let is_free = |k| {
                !fit.at(f64::from(k) * TAU / f64::from(TURNS))
                    .loops
                    .is_empty()
            };
            assert!(!(0..TURNS).any(is_free));
            return false;
        };
        for k in 0..TURNS {
            let theta = (f64::from(k) + rng.random_range(0.0..1.0)) * TAU / f64::from(TURNS);
            let most = reach(&fit.at(theta), direction, about);
            assert!(most <= found.reach + 1e-9, "{most} > {found:?} at {theta}");
        }
        // Beside a tangency places move with the square root of the orientation.
        const BESIDE: f64 = 1e-7;
        let theta = found.configuration.theta;
        let beside = [-BESIDE, 0.0, BESIDE]
            .map(|off| reach(&fit.at(theta + off), direction, about))
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max);
        assert!(
            beside >= found.reach - 8.0 * BESIDE.sqrt(),
            "{beside} {found:?}"
        );
        let place = found.configuration.fixed_from_moving(about).to_vector();
        assert_eq!(direction.unit().dot(place), found.reach);
        assert!(!space.contacts(found.configuration, 1e-9).is_empty());
        true
    });
    let fits = fits.count();
    assert!(fits > 200, "{fits}");
}

fn sheet() -> Part {
    around(&Part::rectangle("hole", (0.0, 0.0), 8.0, 6.0).unwrap())
}

fn lowest(walls: &Part, part: &Part, about: Point, window: Option<(f64, f64)>) -> Configuration {
    let options = Options {
        window,
        ..Options::default()
    };
    let space = ContactSpace::compute(walls, part, &options).unwrap();
    space.farthest(DOWN, about).unwrap().configuration
}

fn assert_is(found: Configuration, (x, y, theta): (f64, f64, f64)) {
    let off = [found.x - x, found.y - y, found.theta - theta].map(f64::abs);
    assert!(
        off.into_iter().all(|o| o < 1e-8),
        "{found:?} {x} {y} {theta}"
    );
}

/// The lowest place, then the leftmost, then that with the least turn.
#[test]
fn bottom_then_left() {
    let bar = Part::rectangle("bar", (0.0, 0.0), 1.0, 3.0).unwrap();
    let square = Part::rectangle("square", (0.0, 0.0), 2.0, 2.0).unwrap();
    let disc = Part::circle("disc", (0.0, 0.0), 1.0).unwrap();
    let middle = Point::ORIGIN;
    let flat = lowest(&sheet(), &bar, middle, None);
    assert_is(flat, (-2.5, -2.5, flat.theta.signum() * FRAC_PI_2));
    assert_is(lowest(&sheet(), &square, middle, None), (-3.0, -2.0, 0.0));
    assert_is(lowest(&sheet(), &disc, middle, None), (-3.0, -2.0, 0.0));
    // With a window that ends before it is flat.
    let tilted = lowest(&sheet(), &bar, middle, Some((-0.5, 1.2)));
    let (sin, cos) = 1.2_f64.sin_cos();
    let half = (0.5 * cos + 1.5 * sin, 0.5 * sin + 1.5 * cos);
    assert_is(tilted, (-4.0 + half.0, -3.0 + half.1, 1.2));
}

/// A quarter of a disc about its corner, which is as low wherever the arc rolls on the floor: leftmost where the arc meets the wall, too.
#[test]
fn what_rolls_goes_to_the_left() {
    let b = (PI / 8.0).tan();
    let quarter = vec![
        Vertex::line(0.0, 0.0),
        Vertex::new(1.0, 0.0, b),
        Vertex::line(0.0, 1.0),
    ];
    let quarter = Part::new("quarter", vec![quarter]).unwrap();
    // Stood on by its corner it is lower: so the window lets it only roll, the floor's normal within the arc's.
    let window = Some((-PI + 0.1, -FRAC_PI_2 - 0.1));
    let found = lowest(&sheet(), &quarter, Point::ORIGIN, window);
    // The left end of the arc is farthest left where the turn is least or a side is upright; its corner is 1 above the floor.
    assert!((found.y + 2.0).abs() < 1e-8, "{found:?}");
    let left = |theta: f64| {
        let ends = [0.0, theta.cos(), -theta.sin()];
        let arc = if (theta..theta + FRAC_PI_2).contains(&-PI) {
            -1.0
        } else {
            0.0
        };
        -4.0 - ends.into_iter().fold(arc, f64::min)
    };
    let (lo, hi) = (-PI + 0.1, -FRAC_PI_2 - 0.1);
    let leftmost = (0..=1000)
        .map(|k| left(lo + (hi - lo) * f64::from(k) / 1000.0))
        .fold(f64::INFINITY, f64::min);
    assert!((found.x - leftmost).abs() < 1e-8, "{found:?} {leftmost}");
}

/// In a round bowl the top of a wave is inside an arc, and a rod across it is lowest level.
#[test]
fn inside_an_arc() {
    let bowl = around(&Part::circle("bowl", (0.5, 0.2), 3.0).unwrap());
    let disc = Part::circle("disc", (0.3, 0.0), 1.0).unwrap();
    let found = lowest(&bowl, &disc, Point::new(0.3, 0.0), None);
    let middle = found.fixed_from_moving(Point::new(0.3, 0.0));
    assert!(
        (middle.x - 0.5).abs() < 1e-5 && (middle.y + 1.8).abs() < 1e-8,
        "{middle:?}"
    );
    // Its lower corners are on the bowl, 2 to each side.
    let rod = Part::rectangle("rod", (0.0, 0.0), 4.0, 0.5).unwrap();
    let found = lowest(&bowl, &rod, Point::ORIGIN, Some((-FRAC_PI_4, FRAC_PI_4)));
    assert!(
        (found.y - (0.2 + 0.25 - 5.0_f64.sqrt())).abs() < 1e-8,
        "{found:?}"
    );
    assert!(found.theta.abs() < 1e-4);
}

#[test]
fn no_direction_and_no_room_have_no_place() {
    let space = |part: &Part| ContactSpace::compute(&sheet(), part, &Options::default()).unwrap();
    let square = Part::rectangle("square", (0.0, 0.0), 2.0, 2.0).unwrap();
    let far = Point::new(f64::NAN, 0.0);
    assert!(
        space(&square)
            .farthest(Vector::ZERO, Point::ORIGIN)
            .is_none()
    );
    assert!(space(&square).farthest(DOWN, far).is_none());
    let long = Part::rectangle("long", (0.0, 0.0), 11.0, 0.1).unwrap();
    assert!(space(&long).farthest(DOWN, Point::ORIGIN).is_none());
}
