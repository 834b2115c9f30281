//! Places in containers, among placed parts: known ones, and random ones held against slices at many orientations.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::{Configuration, CurveGeometry, NoFit, Part, Point, Silent, Slice, Vector, Vertex};
use cspace_plan::nest::{Nest, NestError, Orientations, Owner, Place};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const DOWN: Vector = Vector { x: 0.0, y: -1.0 };

fn nest(container: &Part, placed: &[(&Part, Configuration)], part: &Part) -> Nest {
    Nest::new(container, placed, part, Orientations::All, &Silent).unwrap()
}

fn assert_at(place: &Place, (x, y, theta): (f64, f64, f64)) {
    let off = [place.at.x - x, place.at.y - y, place.at.theta - theta];
    assert!(off.iter().all(|o| o.abs() < 1e-9), "{place:?}");
}

fn at(x: f64, y: f64, theta: f64) -> Configuration {
    Configuration::new(x, y, theta)
}

/// A part with corners at random distances, every third edge an arc.
fn random(rng: &mut impl Rng) -> Part {
    loop {
        let corners = rng.random_range(3..7);
        let vertex = |k: u32| {
            let angle = (f64::from(k) + rng.random_range(-0.3..0.3)) * TAU / f64::from(corners);
            let p = Vector::from_angle(angle) * rng.random_range(0.4..1.5);
            let bulge = if k % 3 == 1 {
                rng.random_range(-0.3..0.5)
            } else {
                0.0
            };
            Vertex::new(p.x, p.y, bulge)
        };
        if let Ok(part) = Part::new("part", vec![(0..corners).map(vertex).collect()]) {
            return part;
        }
    }
}

/// The positions beside placed parts and the outside of a sheet; a part whose origin is in it is within where that is.
fn positions(sheet: &Part, placed: &[(&Part, Configuration)], part: &Part) -> NoFit {
    let wide = Part::rectangle("wide", (0.0, 0.0), 40.0, 40.0).unwrap();
    let loops = [&wide, sheet].map(|p| p.loops()[0].vertices().to_vec());
    let outside = Part::new("outside", loops.to_vec()).unwrap();
    let placed = [&[(&outside, Configuration::IDENTITY)], placed].concat();
    NoFit::beside(&placed, part).unwrap()
}

/// The height of the lowest place of a point: at the curves' ends and, of an arc, at its point across the direction.
fn lowest_of(slice: &Slice, sheet: &Part, about: Point) -> f64 {
    let places = slice.curves.iter().flat_map(|c| {
        let across = match c.geometry {
            CurveGeometry::Arc { center, radius, .. } => center + DOWN * radius,
            _ => c.geometry.point(0.5),
        };
        let g = c.geometry;
        [g.point(0.0), g.point(1.0), g.nearest(across)]
    });
    let inside = places.filter(|p| sheet.contains(*p));
    let height = inside.map(|p| at(p.x, p.y, slice.theta).fixed_from_moving(about).y);
    height.fold(f64::INFINITY, f64::min)
}

/// Parts placed one after the other, each as low as it gets, overlap nothing, and no orientation has a lower place.
#[test]
fn parts_are_placed_one_after_the_other() {
    let mut placed_in_all = 0;
    for seed in 0..12 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let sheet = Part::rectangle("sheet", (2.5, 3.0), 5.0, 6.0).unwrap();
        let parts: Vec<Part> = (0..6).map(|_| random(&mut rng)).collect();
        let mut placed: Vec<(&Part, Configuration)> = Vec::new();
        for part in &parts {
            let about = part.moments().centroid;
            let nest = nest(&sheet, &placed, part);
            let Some(found) = nest.lowest(DOWN, about) else {
                assert!(!nest.fits());
                continue;
            };
            let low = found.at.fixed_from_moving(about).y;
            let positions = positions(&sheet, &placed, part);
            for k in 0..120 {
                let theta = (f64::from(k) + rng.random_range(0.0..1.0)) * TAU / 120.0;
                let other = lowest_of(&positions.at(theta), &sheet, about);
                assert!(
                    other >= low - 1e-8,
                    "seed {seed}: {other} at {theta} {found:?}"
                );
            }
            assert!(found.touching.len() >= 2, "seed {seed}: {found:?}");
            for (other, there) in &placed {
                let relative = there.inverse().compose(found.at);
                let scene = cspace_plan::legs::Scene::new(other, part, None);
                let off = [relative.x, relative.y, relative.theta];
                assert!(!scene.overlaps_deeply(off, 1e-8), "seed {seed}: {found:?}");
            }
            placed.push((part, found.at));
            placed_in_all += 1;
        }
    }
    assert!(placed_in_all > 50, "{placed_in_all}");
}

/// Where a part lies flush it is turned by the angle of the edges, and touches to rounding.
#[test]
fn flush_is_exact() {
    let sheet = Part::rectangle("sheet", (5.0, 5.0), 10.0, 10.0).unwrap();
    let bar = Part::rectangle("bar", (0.0, 0.0), 4.0, 1.0).unwrap();
    let first = nest(&sheet, &[], &bar).lowest(DOWN, Point::ORIGIN).unwrap();
    assert_eq!(first.at, at(2.0, 0.5, 0.0));
    assert!((first.length - 5.0).abs() < 1e-12);
    let (owner, ..) = first.touching[0];
    assert_eq!(owner, Owner::Container);
    let placed = [(&bar, first.at)];
    let second = nest(&sheet, &placed, &bar)
        .lowest(DOWN, Point::ORIGIN)
        .unwrap();
    assert_eq!(second.at, at(6.0, 0.5, 0.0));
    let is_beside = |t: &(Owner, _, _)| t.0 == Owner::Placed(0);
    assert!(second.touching.iter().any(is_beside), "{second:?}");
}

/// A notch of the part's own shape, off the axes, is filled: higher than what is lowest, and the longest.
#[test]
fn the_tightest_fills_a_notch() {
    let (sin, cos) = 0.3_f64.sin_cos();
    // A notch 2 wide and 1 deep in the top of a block, all turned by 0.3.
    let corners = [
        (-3.0, 0.0),
        (3.0, 0.0),
        (3.0, 3.0),
        (1.0, 3.0),
        (1.0, 2.0),
        (-1.0, 2.0),
        (-1.0, 3.0),
        (-3.0, 3.0),
    ];
    let turned = corners.map(|(x, y)| (cos * x - sin * y, sin * x + cos * y));
    let block = Part::polygon("block", &turned).unwrap();
    let sheet = Part::rectangle("sheet", (0.0, 3.0), 12.0, 10.0).unwrap();
    let key = Part::rectangle("key", (0.0, 0.0), 2.0, 1.0).unwrap();
    let nest = nest(&sheet, &[(&block, Configuration::IDENTITY)], &key);
    let tight = nest.tightest(Point::ORIGIN).unwrap();
    assert!((tight.length - 4.0).abs() < 1e-9, "{tight:?}");
    let middle = Point::new(-2.5 * sin, 2.5 * cos);
    assert_at(&tight, (middle.x, middle.y, 0.3));
    assert!(nest.lowest(DOWN, Point::ORIGIN).unwrap().at.y < middle.y);
}

/// A disc's half in a round notch of its radius.
#[test]
fn arcs_nest_in_arcs() {
    let bump = |x: f64, bulge: f64| {
        vec![
            Vertex::line(-2.0, 0.0),
            Vertex::line(2.0, 0.0),
            Vertex::line(2.0, 2.0),
            Vertex::new(x, 2.0, bulge),
            Vertex::line(-x, 2.0),
            Vertex::line(-2.0, 2.0),
        ]
    };
    let holder = Part::new("holder", vec![bump(1.0, -1.0)]).unwrap();
    let half = vec![Vertex::new(-1.0, 0.0, 1.0), Vertex::line(1.0, 0.0)];
    let half = Part::new("half", vec![half]).unwrap();
    let sheet = Part::rectangle("sheet", (0.0, 3.0), 8.0, 6.0).unwrap();
    let tight = nest(&sheet, &[(&holder, Configuration::IDENTITY)], &half)
        .tightest(Point::ORIGIN)
        .unwrap();
    assert!((tight.length - PI).abs() < 1e-9, "{tight:?}");
    assert_at(&tight, (0.0, 2.0, 0.0));
}

/// No place at the orientations of edges has a greater length than the tightest: places all along the boundaries of the positions.
#[test]
fn nowhere_is_it_tighter() {
    let corners = |of: &Part| -> Vec<f64> {
        of.edges()
            .filter(|e| e.is_line())
            .map(|e| (e.end - e.start).angle())
            .collect()
    };
    for seed in 0..20 {
        let mut rng = ChaCha8Rng::seed_from_u64(100 + seed);
        let (sheet, other, part) = (
            Part::rectangle("sheet", (0.0, 0.0), 6.0, 6.0).unwrap(),
            random(&mut rng),
            random(&mut rng),
        );
        let placed = [(&other, at(0.3, -0.4, rng.random_range(0.0..TAU)))];
        let found = nest(&sheet, &placed, &part)
            .tightest(Point::ORIGIN)
            .unwrap();
        let moved = |of: &Part, c: Configuration| -> Vec<cspace::Edge> {
            of.edges()
                .map(|e| e.placed(|p| c.fixed_from_moving(p)))
                .collect()
        };
        let walls: Vec<(cspace::Edge, bool)> = (moved(&sheet, Configuration::IDENTITY)
            .into_iter()
            .map(|e| (e, true)))
        .chain(moved(&other, placed[0].1).into_iter().map(|e| (e, false)))
        .collect();
        // Points of the outline that are on a wall's line, within it, by sampling.
        let length = |c: Configuration| -> f64 {
            const PIECES: u32 = 400;
            let on = |p: Point| {
                walls
                    .iter()
                    .any(|(w, _)| w.is_line() && w.distance(p) < 1e-8)
            };
            (moved(&part, c).iter().filter(|e| e.is_line()))
                .map(|e| {
                    let hits =
                        (0..PIECES).filter(|k| on(e.at((f64::from(*k) + 0.5) / f64::from(PIECES))));
                    e.length() * hits.count() as f64 / f64::from(PIECES)
                })
                .sum()
        };
        assert!(
            (length(found.at) - found.length).abs() < 0.02 * found.length,
            "{seed} {found:?}"
        );
        let angles: Vec<f64> = (corners(&sheet).into_iter())
            .chain(corners(&other).into_iter().map(|a| a + placed[0].1.theta))
            .flat_map(|a| corners(&part).into_iter().map(move |b| a + PI - b))
            .chain(
                corners(&sheet)
                    .into_iter()
                    .flat_map(|a| corners(&part).into_iter().map(move |b| a - b)),
            )
            .collect();
        let positions = positions(&sheet, &placed, &part);
        for theta in angles {
            for c in positions.at(theta).curves {
                for k in 0..=12 {
                    let p = c.geometry.point(f64::from(k) / 12.0);
                    if sheet.contains(p) {
                        let other = length(at(p.x, p.y, theta));
                        assert!(
                            other <= 1.02 * found.length + 1e-9,
                            "{seed}: {other} {found:?}"
                        );
                    }
                }
            }
        }
    }
}

/// Only at single orientations, or in a window.
#[test]
fn orientations_are_limited() {
    let sheet = Part::rectangle("sheet", (2.0, 2.0), 4.0, 4.0).unwrap();
    let bar = Part::rectangle("bar", (0.0, 0.0), 3.0, 1.0).unwrap();
    let at_these = |thetas: Vec<f64>| {
        let these = Orientations::These(thetas);
        Nest::new(&sheet, &[], &bar, these, &Silent).unwrap()
    };
    let upright = at_these(vec![0.3, FRAC_PI_2]);
    let place = upright.tightest(Point::ORIGIN).unwrap();
    assert_at(&place, (0.5, 1.5, FRAC_PI_2));
    assert!((place.length - 4.0).abs() < 1e-9 && upright.space().is_none());
    let place = upright.lowest(DOWN, Point::ORIGIN).unwrap();
    let half = |theta: f64| 1.5 * theta.sin() + 0.5 * theta.cos();
    assert!(
        (place.at.y - half(0.3)).abs() < 1e-9 && place.at.theta == 0.3,
        "{place:?}"
    );
    let window = Orientations::Window(0.2, 1.0);
    let tilted = Nest::new(&sheet, &[], &bar, window, &Silent).unwrap();
    let place = tilted.lowest(DOWN, Point::ORIGIN).unwrap();
    assert!((place.at.y - half(0.2)).abs() < 1e-9, "{place:?}");
    assert!(!at_these(vec![]).fits() && upright.fits());
}

#[test]
fn what_fits_exactly_fits() {
    let sheet = Part::rectangle("sheet", (1.0, 0.5), 2.0, 1.0).unwrap();
    let same = Part::rectangle("same", (0.0, 0.0), 1.0, 2.0).unwrap();
    let found = nest(&sheet, &[], &same);
    assert!(found.fits());
    let place = found.lowest(DOWN, Point::ORIGIN).unwrap();
    assert!((place.at.theta.abs() - FRAC_PI_2).abs() < 1e-12 && (place.length - 6.0).abs() < 1e-9);
    let larger = Part::rectangle("larger", (0.0, 0.0), 1.0, 2.001).unwrap();
    let found = nest(&sheet, &[], &larger);
    assert!(!found.fits());
    assert_eq!(found.lowest(DOWN, Point::ORIGIN), None);
    assert_eq!(found.tightest(Point::ORIGIN), None);
    let disc = Part::circle("disc", (0.0, 0.0), 0.5).unwrap();
    let place = nest(&sheet, &[], &disc)
        .lowest(DOWN, Point::ORIGIN)
        .unwrap();
    assert_at(&place, (0.5, 0.5, 0.0));
    let triangle = Part::polygon("triangle", &[(0.0, 0.0), (3.0, 0.5), (1.0, 2.0)]).unwrap();
    assert!(nest(&triangle, &[], &triangle).fits());
}

#[test]
fn placed_parts_overlap_neither_each_other_nor_the_outside() {
    let sheet = Part::rectangle("sheet", (0.0, 0.0), 4.0, 4.0).unwrap();
    let tile = Part::rectangle("tile", (0.0, 0.0), 1.0, 1.0).unwrap();
    let of = |placed: &[(&Part, Configuration)]| {
        Nest::new(&sheet, placed, &tile, Orientations::All, &Silent)
            .map(|_| ())
            .unwrap_err()
    };
    let here = (&tile, Configuration::IDENTITY);
    let error = of(&[here, (&tile, at(0.9, 0.0, 0.0))]);
    assert_eq!(
        error,
        NestError::Overlap {
            first: 0,
            second: 1
        }
    );
    let error = of(&[here, (&tile, at(1.6, 0.0, 0.0))]);
    assert_eq!(error, NestError::Outside { number: 1 });
    let high = Part::layered(
        "high",
        [(Some([0.0, 1.0]), vec![tile.loops()[0].vertices().to_vec()])],
    )
    .unwrap();
    assert!(matches!(
        of(&[(&high, Configuration::IDENTITY)]),
        NestError::Layers { .. }
    ));
}
