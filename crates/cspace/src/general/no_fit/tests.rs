use super::*;
use crate::geometry::Point;
use crate::part::{Vertex, circle_loop};
use core::f64::consts::{FRAC_PI_2, PI};

fn polygon(corners: &[(f64, f64)]) -> Part {
    Part::polygon("polygon", corners).unwrap()
}

/// A part redrawn at a configuration.
fn drawn_at(part: &Part, (x, y, theta): (f64, f64, f64)) -> Part {
    let at = Configuration::new(x, y, theta);
    let moved = Part::assembled("moved", &[(part, at)]);
    let loops = moved.loops().iter().map(|l| l.vertices().to_vec());
    Part::new("moved", loops.collect()).unwrap()
}

fn length(slice: &Slice) -> f64 {
    slice.curves.iter().map(|c| c.geometry.length()).sum()
}

fn is_at(slice: &Slice, p: (f64, f64)) -> bool {
    slice.curves.len() == 1 && {
        let g = slice.curves[0].geometry;
        g.length() == 0.0 && g.point(0.0).distance(Point::new(p.0, p.1)) < 1e-12
    }
}

/// Frames of the shape of the part, drawn anywhere: one position, at orientations that map the part to itself.
#[test]
fn what_fits_exactly_has_one_position() {
    let square = polygon(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]);
    let l = polygon(&[
        (0.0, 0.0),
        (3.0, 0.0),
        (3.0, 1.0),
        (1.0, 1.0),
        (1.0, 2.0),
        (0.0, 2.0),
    ]);
    let disc = Part::circle("disc", (0.0, 0.0), 0.7).unwrap();
    let pill = Part::slot("pill", (-1.0, 0.5), (2.0, 0.1), 0.4).unwrap();
    let gear = Part::new(
        "gear",
        vec![
            (0..9)
                .flat_map(|k| {
                    let at = |a: f64, r: f64| {
                        let a = (f64::from(k) + a) * core::f64::consts::TAU / 9.0;
                        (r * a.cos(), r * a.sin())
                    };
                    let ((a, b), (c, d)) = (at(0.0, 2.0), at(0.45, 2.5));
                    [Vertex::new(a, b, 0.2), Vertex::new(c, d, -0.3)]
                })
                .collect(),
        ],
    )
    .unwrap();
    for part in [&square, &l, &disc, &pill, &gear] {
        for (x, y, theta) in [
            (0.0, 0.0, 0.0),
            (0.0, 0.0, FRAC_PI_2),
            (5.0, -3.0, 0.4),
            (-70.0, 11.0, 2.9),
        ] {
            let frame = drawn_at(part, (x, y, theta));
            let fits = NoFit::within(&frame, part).at(theta);
            assert!(
                fits.curves.len() == 1 && fits.curves[0].geometry.length() == 0.0,
                "{} at {theta}: {fits:?}",
                part.name()
            );
            let p = fits.curves[0].geometry.point(0.0);
            assert!(p.distance(Point::new(x, y)) < 1e-11, "{p:?}");
            let other = NoFit::within(&frame, part).at(theta + 0.01);
            assert_eq!(
                other.loops.len(),
                usize::from(core::ptr::eq(part, &raw const disc))
            );
        }
    }
}

/// Slots of the part's own width, straight and round.
#[test]
fn slots_of_the_parts_width() {
    let disc = Part::circle("disc", (0.0, 0.0), 0.25).unwrap();
    let slot = Part::slot("slot", (-1.0, 0.5), (2.0, 1.5), 0.25).unwrap();
    for (turn, n) in [(0.0, 2), (1.1, 2)] {
        let fits = NoFit::within(&drawn_at(&slot, (0.0, 0.0, turn)), &disc).at(0.3);
        assert_eq!(fits.curves.len(), n, "{fits:?}");
        assert!((length(&fits) - 2.0 * 10.0_f64.sqrt()).abs() < 1e-11);
    }
    // Between circles of radii 2 and 2.5 about the origin, over a quarter turn.
    let bent = Part::new(
        "bent",
        vec![vec![
            Vertex::new(2.5, 0.0, (PI / 8.0).tan()),
            Vertex::new(0.0, 2.5, 1.0),
            Vertex::new(0.0, 2.0, -(PI / 8.0).tan()),
            Vertex::new(2.0, 0.0, 1.0),
        ]],
    )
    .unwrap();
    let fits = NoFit::within(&bent, &disc).at(0.0);
    assert_eq!(fits.curves.len(), 2, "{fits:?}");
    assert!(
        (length(&fits) - 2.25 * PI).abs() < 1e-10,
        "{}",
        length(&fits)
    );
    // A neck of the disc's width into a chamber.
    let keyhole = polygon(&[
        (0.0, 0.0),
        (3.0, 0.0),
        (3.0, 1.0),
        (5.0, 1.0),
        (5.0, 1.5),
        (3.0, 1.5),
        (3.0, 3.0),
        (0.0, 3.0),
    ]);
    let fits = NoFit::within(&keyhole, &disc).at(0.0);
    assert_eq!(fits.loops.len(), 1, "{fits:?}");
    // Expected length: around the chamber for a centre, except for the neck, whose corners are rounded, and along the neck twice.
    let around = 3.0 * 2.5 + 0.75 + 1.25 + 0.25 * PI + 2.0 * 1.75;
    assert!(
        (length(&fits) - around).abs() < 1e-9,
        "{} {fits:?}",
        length(&fits)
    );
}

/// Discs at a distance of exactly one diameter, and frames that two discs of a part touch from inside at one point each.
#[test]
fn what_touches_at_points() {
    let disc = |x: f64, r: f64| circle_loop(Point::new(x, 0.0), r).unwrap();
    let posts = Part::new("posts", vec![disc(-2.0, 1.0), disc(2.0, 1.0)]).unwrap();
    let ball = Part::circle("ball", (0.0, 0.0), 1.0).unwrap();
    let beside = NoFit::new(&posts, &ball).at(0.7);
    assert_eq!(beside.loops.len(), 2, "{beside:?}");
    assert!((length(&beside) - 8.0 * PI).abs() < 1e-10);
    // Holes of radius 1 about ±3, and a part of two discs of radius .5 whose centres are 5 apart: the outer rims touch.
    let sheet = Part::new(
        "sheet",
        vec![
            vec![
                Vertex::line(-9.0, -9.0),
                Vertex::line(9.0, -9.0),
                Vertex::line(9.0, 9.0),
                Vertex::line(-9.0, 9.0),
            ],
            disc(-3.0, 1.0),
            disc(3.0, 1.0),
        ],
    )
    .unwrap();
    let pair = Part::new("pair", vec![disc(-2.5, 0.5), disc(2.5, 0.5)]).unwrap();
    let fits = NoFit::new(&sheet, &pair).at(0.0);
    let lens: f64 = fits
        .loops
        .iter()
        .filter(|l| {
            l.iter().all(|&i| {
                fits.curves[i as usize]
                    .geometry
                    .point(0.0)
                    .distance(Point::ORIGIN)
                    < 0.6
            })
        })
        .map(|l| {
            l.iter()
                .map(|&i| fits.curves[i as usize].geometry.length())
                .sum::<f64>()
        })
        .sum();
    assert!(lens < 1e-9, "{lens} {fits:?}");
    let pair = Part::new("pair", vec![disc(-3.5, 0.5), disc(3.5, 0.5)]).unwrap();
    let fits = NoFit::new(&sheet, &pair).at(0.0);
    let here: Vec<_> = (fits.curves.iter())
        .filter(|c| c.geometry.point(0.0).distance(Point::ORIGIN) < 0.6)
        .collect();
    assert_eq!(here.len(), 1, "{here:?}");
    assert_eq!(here[0].geometry.length(), 0.0);
}

/// The blocked positions of convex parts have the area of both and twice the mixed area, by the perimeter where one is a disc.
#[test]
fn sums_of_convex_parts() {
    let triangle = polygon(&[(0.0, 0.0), (4.0, 1.0), (1.0, 3.0)]);
    let square = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let beside = NoFit::new(&square, &square).at(0.0);
    assert_eq!(beside.curves.len(), 4, "{beside:?}");
    assert_eq!(length(&beside), 8.0);
    for theta in [0.0, 0.3, 2.0, PI] {
        let sum = NoFit::new(&triangle, &square).at(theta);
        let perimeter: f64 = triangle.edges().map(|e| e.length()).sum();
        assert!((length(&sum) - perimeter - 4.0).abs() < 1e-12);
        let disc = Part::circle("disc", (1.0, 2.0), 0.5).unwrap();
        let sum = NoFit::new(&triangle, &disc).at(theta);
        assert!((length(&sum) - perimeter - PI).abs() < 1e-12);
        assert_eq!(sum.curves.len(), 6);
        let sum = NoFit::new(&disc, &disc).at(theta);
        assert_eq!(sum.curves.len(), 1, "{sum:?}");
        assert!((length(&sum) - 2.0 * PI).abs() < 1e-12);
    }
}

/// A part among others that touch.
#[test]
fn beside_parts_that_touch() {
    let square = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let at = |x: f64, y: f64| Configuration::new(x, y, 0.0);
    // Around a hole of the size of the part: a ring of eight.
    let ring: Vec<(&Part, Configuration)> = (0..9)
        .filter(|&k| k != 4)
        .map(|k| (&square, at(f64::from(k % 3), f64::from(k / 3))))
        .collect();
    let fits = NoFit::beside(&ring, &square).unwrap().at(0.0);
    assert_eq!(fits.loops.len(), 2, "{fits:?}");
    assert!(
        (length(&fits) - 16.0).abs() < 1e-12,
        "{} {fits:?}",
        length(&fits)
    );
    assert!(fits.curves.iter().any(|c| c.geometry.length() == 0.0
        && c.geometry.point(0.0).distance(Point::new(1.0, 1.0)) < 1e-12));
    let fits = NoFit::beside(&ring, &square).unwrap().at(FRAC_PI_2);
    assert_eq!(fits.loops.len(), 2, "{fits:?}");
    let two = [(&square, at(0.0, 0.0)), (&square, at(0.5, 0.5))];
    assert_eq!(
        NoFit::beside(&two, &square).map(|_| ()),
        Err(NoFitError::Overlap {
            first: 0,
            second: 1
        })
    );
    assert_eq!(
        NoFit::beside(&[], &square).map(|_| ()),
        Err(NoFitError::Nothing)
    );
}

/// With play, both methods agree, and a part that does not fit has no position.
#[test]
fn with_play_it_is_the_slice() {
    let plate = Part::new(
        "plate",
        vec![
            vec![
                Vertex::line(-5.0, -5.0),
                Vertex::line(5.0, -5.0),
                Vertex::line(5.0, 5.0),
                Vertex::line(-5.0, 5.0),
            ],
            circle_loop(Point::new(0.5, 0.0), 2.0).unwrap(),
        ],
    )
    .unwrap();
    let peg = Part::slot("peg", (-1.0, 0.0), (1.0, 0.2), 0.8).unwrap();
    for theta in [0.0, 0.7, -2.0] {
        let (exact, slice) = (
            NoFit::new(&plate, &peg).at(theta),
            Slice::compute(&plate, &peg, theta),
        );
        assert_eq!(exact.loops.len(), slice.loops.len());
        assert!((length(&exact) - length(&slice)).abs() < 1e-10);
    }
    let thick = Part::circle("thick", (0.0, 0.0), 2.001).unwrap();
    assert_eq!(NoFit::new(&plate, &thick).at(0.0).loops.len(), 1);
    assert!(NoFit::within(&peg, &thick).at(0.0).loops.is_empty());
    assert!(NoFit::within(&peg, &thick).at(f64::NAN).loops.is_empty());
    let exact = Part::circle("exact", (3.0, 1.0), 2.0).unwrap();
    let fits = NoFit::new(&plate, &exact).at(0.0);
    assert_eq!(fits.loops.len(), 2);
    let p = fits
        .curves
        .iter()
        .find(|c| c.geometry.length() == 0.0)
        .unwrap()
        .geometry
        .point(0.0);
    assert!(p.distance(Point::new(-2.5, -1.0)) < 1e-12 && !is_at(&fits, (0.0, 0.0)));
}

/// Two outlines of one part that overlap are not one outline by its even-odd rule.
#[test]
fn layers_of_one_part_stay_apart() {
    let square = |x: f64| Part::rectangle("", (x, 0.0), 4.0, 4.0).unwrap();
    let body = Part::together("body", &[&square(0.0), &square(3.0)]).unwrap();
    let placed = [
        (&body, Configuration::default()),
        (&square(9.0), Configuration::default()),
    ];
    assert_eq!(Part::assembled("all", &placed).layers().len(), 2);
}
