//! Curves as drawings have them: whole turns that are not quite whole, corners within curves, corners tangent to their lines.

use core::f64::consts::{PI, TAU};

use cspace::part::Edge;
use cspace::{Part, Point};
use cspace_drawing::{DrawingError, Format, Outlines, Settings, Source, Traced, from_bytes};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn dxf(entities: &str) -> Result<Outlines, DrawingError> {
    let text = format!("0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
    from_bytes(text.as_bytes(), Format::Dxf, &Source::default())?.outlines(&Settings::default())
}

fn svg(path: &str) -> Result<Outlines, DrawingError> {
    svg_with(path, &Settings::default())
}

/// SVG with a stroke in a page of 100 by 100, in which lengths are those of the path.
fn svg_with(path: &str, settings: &Settings) -> Result<Outlines, DrawingError> {
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\">\
         <path fill=\"none\" stroke=\"black\" d=\"{path}\"/></svg>"
    );
    from_bytes(text.as_bytes(), Format::Svg, &Source::default())?.outlines(settings)
}

/// A closed polyline.
fn polygon(corners: &[(f64, f64)]) -> String {
    let vertices = corners
        .iter()
        .map(|(x, y)| format!("10\n{x:?}\n20\n{y:?}\n"));
    format!(
        "0\nLWPOLYLINE\n8\n0\n70\n1\n{}",
        vertices.collect::<String>()
    )
}

fn line(a: (f64, f64), b: (f64, f64)) -> String {
    format!(
        "0\nLINE\n8\n0\n10\n{:?}\n20\n{:?}\n11\n{:?}\n21\n{:?}\n",
        a.0, a.1, b.0, b.1
    )
}

fn arc(center: (f64, f64), radius: f64, from: f64, to: f64) -> String {
    let (x, y) = center;
    format!("0\nARC\n8\n0\n10\n{x:?}\n20\n{y:?}\n40\n{radius:?}\n50\n{from:?}\n51\n{to:?}\n")
}

fn ellipse(center: (f64, f64), major: (f64, f64), ratio: f64, from: f64, to: f64) -> String {
    let ((x, y), (u, v)) = (center, major);
    format!(
        "0\nELLIPSE\n8\n0\n10\n{x:?}\n20\n{y:?}\n11\n{u:?}\n21\n{v:?}\n40\n{ratio:?}\n41\n{from:?}\n42\n{to:?}\n"
    )
}

fn spline(degree: usize, knots: &[f64], control: &[(f64, f64)]) -> String {
    let knots: String = knots.iter().map(|k| format!("40\n{k:?}\n")).collect();
    let points = control
        .iter()
        .map(|(x, y)| format!("10\n{x:?}\n20\n{y:?}\n"));
    let points: String = points.collect();
    format!("0\nSPLINE\n8\n0\n70\n8\n71\n{degree}\n{knots}{points}")
}

fn area(outlines: &Outlines) -> f64 {
    outlines.parts.iter().map(Part::area).sum()
}

/// A hole drawn as an arc of a whole turn but for rounding, or but for a gap that is joined: as the arc of a DXF file, as a
/// polyline, as an ellipse. None is lost, alone or in a plate, whatever the size.
#[test]
fn whole_turns_are_circles() {
    for size in [1e-3, 1.0, 1e3] {
        let plate = 10.0 * size;
        let plate = polygon(&[
            (-plate, -plate),
            (plate, -plate),
            (plate, plate),
            (-plate, plate),
        ]);
        let r = 4.0 * size;
        let circle = PI * r * r;
        let check = |hole: &str, area_of_hole: f64, within: f64| {
            for (drawn, expected) in [
                (hole.to_owned(), area_of_hole),
                (format!("{plate}{hole}"), 400.0 * size * size - area_of_hole),
            ] {
                let outlines = dxf(&drawn).unwrap_or_else(|e| panic!("{hole}: {e}"));
                let off = (area(&outlines) - expected).abs() / circle;
                assert!(off < within, "{hole}: {off}");
                assert_eq!(outlines.tiny, 0, "{hole}");
            }
        };
        for (from, to) in [
            (0.0, 360.0001),
            (210.7, 570.7),
            (30.0, 30.0),
            (-90.0, 270.0),
        ] {
            check(&arc((0.0, 0.0), r, from, to), circle, 1e-12);
        }
        // In the plate ends within 2.8e-4 are one.
        for gap in [1e-14, 1e-11, 1e-8, 1e-6, 1e-5] {
            for from in [0.0, 90.0, 123.4] {
                let to = from + 360.0 - f64::to_degrees(gap);
                check(&arc((0.0, 0.0), r, from, to), circle, 1e-8);
            }
            if gap > 1e-9 {
                let (sin, cos) = gap.sin_cos();
                let bulge = ((TAU - gap) / 4.0).tan();
                let polyline = format!(
                    "0\nLWPOLYLINE\n8\n0\n70\n0\n10\n{r:?}\n20\n0\n42\n{bulge:?}\n10\n{:?}\n20\n{:?}\n",
                    r * cos,
                    -r * sin
                );
                // The ends say no better where the circle is.
                check(&polyline, circle, 1e-6);
            }
            check(
                &ellipse((0.0, 0.0), (r, 0.0), 0.5, 0.0, TAU - gap),
                circle / 2.0,
                1e-3,
            );
        }
        for to in [6.283_19, 6.283_185_31, 6.283_186, 6.2832] {
            check(
                &ellipse((0.0, 0.0), (r, 0.0), 0.5, 0.0, to),
                circle / 2.0,
                1e-3,
            );
            check(&ellipse((0.0, 0.0), (r, 0.0), 1.0, 0.0, to), circle, 1e-12);
        }
    }
    let path = svg("M0 0H20V10H0z M7 5A2 2 0 1 1 7 4.9999").unwrap();
    assert!((area(&path) - 200.0 + 4.0 * PI).abs() < 1e-8);
    // The larger part of a circle is no circle.
    let open = dxf(&arc((0.0, 0.0), 4.0, 0.0, 359.0))
        .unwrap_err()
        .to_string();
    assert!(open.contains("open"), "{open}");
}

/// A circle of radius 0 is a point: it is left out, and listed.
#[test]
fn a_circle_without_radius_is_listed() {
    let circle = "0\nCIRCLE\n8\n0\n10\n1\n20\n1\n40\n0\n";
    let plate = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)]);
    let outlines = dxf(&format!("{plate}{circle}")).unwrap();
    assert_eq!((outlines.parts.len(), outlines.ignored.len()), (1, 1));
    assert!(outlines.ignored[0].reason.contains("radius is 0"));
}

/// Corners within a spline, from 0.02 rad on, stay where they are: straight spans of any degree are lines.
#[test]
fn corners_within_splines_stay() {
    for degree in 1..=5 {
        for corner in [0.02, 0.1, 1.0, 2.5] {
            let end = (2.0 + 2.0 * f64::cos(corner), 2.0 * f64::sin(corner));
            let corners = [(0.0, 0.0), (2.0, 0.0), end];
            let n = degree as f64;
            let mut control = vec![corners[0]];
            for leg in corners.windows(2) {
                control.extend((1..=degree).map(|i| {
                    let s = i as f64 / n;
                    let along = |a: f64, b: f64| a + (b - a) * s;
                    (along(leg[0].0, leg[1].0), along(leg[0].1, leg[1].1))
                }));
            }
            let mut knots = vec![0.0; degree + 1];
            knots.extend(vec![1.0; degree]);
            knots.extend(vec![2.0; degree + 1]);
            let apex = (1.0, 5.0);
            let drawn = [
                spline(degree, &knots, &control),
                line(end, apex),
                line(apex, corners[0]),
            ];
            let outlines =
                dxf(&drawn.concat()).unwrap_or_else(|e| panic!("{degree} {corner}: {e}"));
            let all = [corners[0], corners[1], end, apex];
            let twice: f64 = (0..4)
                .map(|i| (all[i], all[(i + 1) % 4]))
                .map(|(p, q)| p.0 * q.1 - q.0 * p.1)
                .sum();
            assert!(
                (area(&outlines) - twice.abs() / 2.0).abs() < 1e-9,
                "{degree} {corner}"
            );
            assert_eq!(outlines.parts[0].edges().count(), 4, "{degree} {corner}");
        }
    }
}

/// Control points that are the same, more often than the degree, make spans of no length.
#[test]
fn spans_without_length_are_passed_over() {
    let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (0.0, 0.0)];
    let control: Vec<(f64, f64)> = corners.iter().flat_map(|&c| [c; 5]).collect();
    let inner = control.len() - 3;
    let mut knots = vec![0.0; 3];
    knots.extend((0..=inner).map(|k| k as f64));
    knots.extend(vec![inner as f64; 3]);
    let outlines = dxf(&spline(3, &knots, &control)).unwrap();
    assert!((area(&outlines) - 12.0).abs() < 1e-9);
    assert_eq!(outlines.parts[0].edges().count(), 4);
}

/// A cubic with a cusp, and ones that nearly have it: the cusp stays where it is, and the fit is as near as elsewhere.
#[test]
fn cusps_are_corners() {
    for off in [0.0, 1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0] {
        // Handles that cross make a cusp in the middle.
        let path = format!(
            "M20 20 C {} 60 {} 60 60 20 L60 10 L20 10 Z",
            60.0 - off,
            20.0 + off
        );
        let outlines = svg(&path).unwrap_or_else(|e| panic!("{off}: {e}"));
        // Green's theorem for the cubic, and the rectangle below it.
        let x = [20.0, 60.0 - off, 20.0 + off, 60.0];
        let y = [20.0, 60.0, 60.0, 20.0];
        let expected = bezier_integral(&x, &y) + 400.0;
        assert!(
            (area(&outlines) - expected).abs() < 0.3,
            "{off}: {}",
            area(&outlines)
        );
        let tip = Point::new(40.0, 50.0);
        let nearest = (outlines.parts[0].edges())
            .map(|e| e.start.distance(tip))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-3 + off, "{off}: {nearest}");
    }
}

/// ∫ (y − 20) dx along a cubic.
fn bezier_integral(x: &[f64; 4], y: &[f64; 4]) -> f64 {
    let n = 20_000;
    let at = |c: &[f64; 4], s: f64| {
        let t = 1.0 - s;
        t * t * t * c[0] + 3.0 * t * t * s * c[1] + 3.0 * t * s * s * c[2] + s * s * s * c[3]
    };
    (0..n)
        .map(|k| (f64::from(k) / f64::from(n), f64::from(k + 1) / f64::from(n)))
        .map(|(a, b)| (f64::midpoint(at(y, a), at(y, b)) - 20.0) * (at(x, b) - at(x, a)))
        .sum()
}

/// Largest distance of a curve from the outline, at many points of it.
fn deviation(part: &Part, at: impl Fn(f64) -> (f64, f64)) -> f64 {
    let edges: Vec<Edge> = part.edges().collect();
    (0..=2000)
        .map(|k| at(f64::from(k) / 2000.0))
        .map(|(x, y)| {
            let of = |e: &Edge| e.distance(Point::new(x, y));
            edges.iter().map(of).fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max)
}

/// Quarter ellipses that round a corner are fitted at the default, whatever their axes.
#[test]
fn quarter_ellipses_are_fitted() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    for _ in 0..60 {
        let [a, b]: [f64; 2] = core::array::from_fn(|_| rng.random_range(0.5..5.0));
        let scale = 10.0_f64.powf(rng.random_range(-3.0..3.0));
        let [a, b, far] = [a, b, 20.0].map(|x| x * scale);
        let drawn = [
            line((-far, 0.0), (0.0, 0.0)),
            ellipse((0.0, b), (a, 0.0), b / a, 1.5 * PI, TAU),
            line((a, b), (a, far)),
            line((a, far), (-far, far)),
            line((-far, far), (-far, 0.0)),
        ];
        let outlines = dxf(&drawn.concat()).unwrap_or_else(|e| panic!("{a} {b}: {e}"));
        let part = &outlines.parts[0];
        let off = deviation(part, |s| {
            let t = PI * (1.5 + s / 2.0);
            (a * t.cos(), b + b * t.sin())
        });
        assert!(off <= 1e-4 * part.size() * 1.001, "{a} {b}: {off}");
        assert!(outlines.fitted.kink < 1e-9);
    }
}

/// Cubics that round a corner of two lines are fitted at the default, whatever the corner and the handles.
#[test]
fn bezier_corners_are_fitted() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for _ in 0..60 {
        let turn: f64 = rng.random_range(0.3..2.8);
        let [r, q, k, l]: [f64; 4] = core::array::from_fn(|_| rng.random_range(0.2..0.95));
        let (sin, cos) = turn.sin_cos();
        let on = |x: f64| (50.0 + x * cos, 30.0 + x * sin);
        let (r, q) = (5.0 * r, 5.0 * q);
        let control = [
            (50.0 - r, 30.0),
            (50.0 - r * (1.0 - k), 30.0),
            on(q * (1.0 - l)),
            on(q),
        ];
        let far = on(20.0);
        let path = format!(
            "M30 30 L{:?} {:?} C{:?} {:?} {:?} {:?} {:?} {:?} L{:?} {:?} L30 {:?} Z",
            control[0].0,
            control[0].1,
            control[1].0,
            control[1].1,
            control[2].0,
            control[2].1,
            control[3].0,
            control[3].1,
            far.0,
            far.1,
            40.0 + 20.0 * sin
        );
        let outlines = svg(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let part = &outlines.parts[0];
        let off = deviation(part, |s| {
            let t = 1.0 - s;
            let w = [t * t * t, 3.0 * t * t * s, 3.0 * t * s * s, s * s * s];
            let sum = |of: fn(&(f64, f64)) -> f64| {
                w.iter().zip(&control).map(|(w, p)| w * of(p)).sum::<f64>()
            };
            // The page's y axis points down.
            (sum(|p| p.0), 100.0 - sum(|p| p.1))
        });
        assert!(off <= 1e-4 * part.size() * 1.001, "{path}: {off}");
        assert!(outlines.fitted.kink < 1e-9);
    }
}

/// A curve that is tangent to its neighbours but for a small kink at either end, as numbers of three digits make it.
#[test]
fn nearly_tangent_corners_are_fitted() {
    let settings = Settings {
        fit: Some(0.002),
        ..Settings::default()
    };
    let path = "M10 10 l.335 1.679 q.05.242.049.49 v.413 H5 V10 Z";
    let outlines = svg_with(path, &settings).unwrap();
    let off = deviation(&outlines.parts[0], |s| {
        let (x, y) = (
            2.0 * s * (1.0 - s) * 0.05 + s * s * 0.049,
            2.0 * s * (1.0 - s) * 0.242 + s * s * 0.49,
        );
        (10.335 + x, 100.0 - 11.679 - y)
    });
    assert!(off <= 0.002, "{off}");
}

/// A gap that is joined moves the whole curve a little: its end alone would be a corner that no piece passes.
#[test]
fn joined_curves_are_fitted() {
    let settings = Settings {
        join: Some(0.101),
        ..Settings::default()
    };
    let path = "M 10 10 C 20 10 30 10 30 20 C 30 30 20 30 10 30 L 10 10.1";
    let outlines = svg_with(path, &settings).unwrap();
    // Each quarter has 3/20 of its square beyond the diagonal, and the square's half; moved by the gap it is 1 larger or less.
    assert!((area(&outlines) - 349.0).abs() < 1.0, "{}", area(&outlines));
    assert_eq!(outlines.joined.len(), 1);
}

/// A cam traced with 1,000 points, with a square hole: if requested, the import replaces the trace by some arcs and
/// keeps the hole. Otherwise the part is unchanged, and the proposed fit equals the result of fitting.
#[test]
fn traces_become_few_pieces() {
    let n = 1000;
    let cam: Vec<(f64, f64)> = (0..n)
        .map(|k| TAU * f64::from(k) / f64::from(n))
        .map(|t| (t, 20.0 + 4.0 * (1.0 - t.cos()) + (2.0 * t).sin()))
        .map(|(t, r)| (r * t.cos(), r * t.sin()))
        .collect();
    let hole = [(-3.0, -3.0), (3.0, -3.0), (3.0, 3.0), (-3.0, 3.0)];
    let drawn = polygon(&cam) + &polygon(&hole);
    let plain = dxf(&drawn).unwrap();
    assert_eq!(plain.parts[0].edges().count(), 1004);
    let said = Traced::of(&plain.parts[0]).unwrap();
    let settings = Settings {
        trace: true,
        fit: Some(said.fit),
        ..Settings::default()
    };
    let text = format!("0\nSECTION\n2\nENTITIES\n{drawn}0\nENDSEC\n0\nEOF\n");
    let outlines = from_bytes(text.as_bytes(), Format::Dxf, &Source::default())
        .and_then(|d| d.outlines(&settings))
        .unwrap();
    let part = &outlines.parts[0];
    assert_eq!(part.edges().count(), said.pieces);
    assert!(said.pieces < 70, "{said:?}");
    assert_eq!(part.edges().filter(|e| e.is_line()).count(), 4);
    let off = (cam.iter())
        .map(|&(x, y)| {
            let of = |e: Edge| e.distance(Point::new(x, y));
            part.edges().map(of).fold(f64::INFINITY, f64::min)
        })
        .fold(0.0, f64::max);
    assert!(off <= said.fit, "{off} of {said:?}");
    assert!(Traced::of(part).is_none());
}

/// A leaf drawn once and used turned, in other sizes, mirrored and alone: each copy keeps its ends, and is within its own tolerance of the
/// curve that it is fitted to.
#[test]
fn copies_of_a_symbol_are_fitted_as_the_symbol() {
    // Places as (a, b) of z ↦ a z + b, or of the mirror image.
    let places: [(f64, f64, f64, f64, bool); 6] = [
        (0.0, 1.0, 20.0, 20.0, false),
        (30.0, 1.0, 60.0, 20.0, false),
        (90.0, 0.25, 20.0, 60.0, false),
        (137.0, 1.5, 60.0, 60.0, false),
        (0.0, 1.0, 30.0, 85.0, true),
        (200.0, 0.5, 85.0, 90.0, true),
    ];
    let uses: String = (places.iter())
        .map(|(turn, scale, x, y, is_mirrored)| {
            let y_scale = if *is_mirrored { -scale } else { *scale };
            format!("<use href=\"#leaf\" transform=\"translate({x} {y}) rotate({turn}) scale({scale} {y_scale})\"/>")
        })
        .collect();
    let text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\" fill=\"none\" stroke=\"black\">\
         <defs><path id=\"leaf\" d=\"M0 0C5 -8 15 -8 20 0L10 12Z\"/></defs>{uses}</svg>"
    );
    let drawing = from_bytes(text.as_bytes(), Format::Svg, &Source::default()).unwrap();
    let made = drawing.outlines(&Settings::default()).unwrap();
    assert_eq!(made.parts.len(), places.len());
    // A quarter turn and a quarter of the size have the tolerance of the first to the last bit, and are not fitted again: the bulges
    // are those of the first.
    let bulges = |at: (f64, f64)| {
        let is_there = |part: &&Part| part.edges().any(|e| e.start.distance(at.into()) < 1e-9);
        let part = made.parts.iter().find(is_there).unwrap();
        let mut bulges: Vec<u64> = part.edges().map(|e| e.bulge.to_bits()).collect();
        bulges.sort_unstable();
        bulges
    };
    assert_eq!(bulges((20.0, 80.0)), bulges((20.0, 40.0)));
    for (turn, scale, x, y, is_mirrored) in places {
        let (sin, cos) = turn.to_radians().sin_cos();
        // The y axis of a page points down.
        let place = |p: Point| {
            let q = Point::new(
                scale * p.x,
                if is_mirrored {
                    -scale * p.y
                } else {
                    scale * p.y
                },
            );
            Point::new(
                x + cos * q.x - sin * q.y,
                100.0 - (y + sin * q.x + cos * q.y),
            )
        };
        let ends = [(0.0, 0.0), (20.0, 0.0), (10.0, 12.0)].map(|p| place(p.into()));
        let part = (made.parts.iter())
            .find(|part| part.edges().any(|e| e.start.distance(ends[0]) < 1e-9))
            .unwrap();
        for end in ends {
            assert!(
                part.edges().any(|e| e.start.distance(end) < 1e-12),
                "{turn}"
            );
        }
        // 84 between the curve and its chord, 120 below it.
        assert!(
            (part.area() / (scale * scale) - 204.0).abs() < 0.1,
            "{turn}"
        );
        let fit = 1e-4 * part.size();
        for k in 0..=100 {
            let t = f64::from(k) / 100.0;
            let s = 1.0 - t;
            let on = Point::new(
                15.0 * t * s * s + 45.0 * t * t * s + 20.0 * t * t * t,
                -24.0 * t * s,
            );
            let off = part
                .edges()
                .map(|e| e.distance(place(on)))
                .fold(f64::INFINITY, f64::min);
            assert!(off <= fit, "{turn}: off by {off:e} at {t}");
        }
    }
}

/// The tolerance proposed for a trace is the error of its chords: for a circle in closed form. Outlines of few edges,
/// and drawings with corners, are no traces.
#[test]
fn traces_are_told_within_their_sagitta() {
    let circle = |n: u32, r: f64| -> Vec<(f64, f64)> {
        (0..n)
            .map(|k| TAU * f64::from(k) / f64::from(n))
            .map(|t| (r * t.cos(), r * t.sin()))
            .collect()
    };
    let said = |points: &[(f64, f64)]| Traced::of(&dxf(&polygon(points)).unwrap().parts[0]);
    for (n, r) in [(101, 3.0), (400, 10.0), (800, 50.0)] {
        let sagitta = r * (1.0 - (PI / f64::from(n)).cos());
        let traced = said(&circle(n, r)).unwrap();
        // A quarter more, rounded up to two digits.
        let share = traced.fit / sagitta;
        assert!((1.25..1.4).contains(&share), "{traced:?}");
        // The circle goes through the corners, and the middles of the chords are off it.
        assert!((traced.deviation / sagitta - 1.0).abs() < 0.1, "{traced:?}");
        assert!(traced.pieces <= 4);
    }
    assert!(said(&circle(100, 3.0)).is_none());
    // A comb has 400 edges and no curve.
    let comb: Vec<(f64, f64)> = (0..100)
        .map(f64::from)
        .flat_map(|x| [(x, 1.0), (x + 0.4, 1.0), (x + 0.5, 0.5), (x + 0.9, 0.5)])
        .collect();
    let closed = [&comb[..], &[(100.0, 0.0), (0.0, 0.0)]].concat();
    assert!(said(&closed).is_none());
}
