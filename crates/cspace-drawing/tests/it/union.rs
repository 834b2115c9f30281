//! Unions of outlines, against rays through what is given, and against differences.

use core::f64::consts::PI;

use cspace::{Dual, Part, PartError, Point, Real, Vertex};
use cspace_drawing::{UnionError, union};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Loops<T = f64> = Vec<Vec<Vertex<T>>>;

fn rectangle(x: [f64; 2], y: [f64; 2]) -> Vec<Vertex> {
    [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
        .map(|(x, y)| Vertex::line(x, y))
        .to_vec()
}

fn circle(x: f64, y: f64, r: f64) -> Vec<Vertex> {
    vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)]
}

fn united(outlines: &[Loops]) -> Part {
    Part::new("all", union(outlines).unwrap().loops).unwrap()
}

/// Whether an odd number of edges is met on the way to the right, by the formulas of lines and circles.
fn encloses(loops: &[Vec<Vertex>], p: Point) -> bool {
    let mut count = 0;
    for vertices in loops {
        for (i, a) in vertices.iter().enumerate() {
            let b = vertices[(i + 1) % vertices.len()];
            let chord_is_met =
                (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
            count += usize::from(chord_is_met);
            if a.bulge == 0.0 {
                continue;
            }
            // Between chord and arc: on the arc's side of the chord, in the circle; or not beyond both.
            let (dx, dy) = (b.x - a.x, b.y - a.y);
            let h = (1.0 - a.bulge * a.bulge) / (4.0 * a.bulge);
            let (cx, cy) = (0.5 * (a.x + b.x) - dy * h, 0.5 * (a.y + b.y) + dx * h);
            let radius = (a.x - cx).hypot(a.y - cy);
            let right = dx * (p.y - a.y) - dy * (p.x - a.x) < 0.0;
            let is_in_circle = (p.x - cx).hypot(p.y - cy) < radius;
            count += usize::from(is_in_circle && right == (a.bulge > 0.0));
        }
    }
    count % 2 == 1
}

/// A loop about a place; a star of lines and arcs, or one that crosses itself.
fn random_loop(rng: &mut ChaCha8Rng) -> Vec<Vertex> {
    let (x, y) = (rng.random_range(-3.0..3.0), rng.random_range(-3.0..3.0));
    let n: usize = rng.random_range(2..9);
    let crosses = rng.random_bool(0.03);
    (0..n)
        .map(|i| {
            let turn = if crosses {
                rng.random_range(0.0..n as f64)
            } else {
                i as f64
            };
            let angle = 2.0 * PI * turn / n as f64;
            let r = rng.random_range(0.5..2.5);
            let bulge = match rng.random_range(0..4) {
                0 => rng.random_range(-0.4..1.3),
                _ if n == 2 => rng.random_range(0.2..1.0),
                _ => 0.0,
            };
            Vertex::new(x + r * angle.cos(), y + r * angle.sin(), bulge)
        })
        .collect()
}

#[test]
fn random_unions_enclose_what_any_outline_does() {
    let mut rng = ChaCha8Rng::seed_from_u64(74);
    let (mut parts, mut loops) = (0, 0);
    for _ in 0..300 {
        let count = rng.random_range(1..6);
        let outlines: Vec<Loops> = (0..count)
            .map(|_| {
                (0..rng.random_range(1..4))
                    .map(|_| random_loop(&mut rng))
                    .collect()
            })
            .collect();
        let made = union(&outlines).unwrap();
        // Loops of an outline that cross touch in their crossings, and are no part; the loops are right all the same.
        parts += usize::from(Part::new("", made.loops.clone()).is_ok());
        loops += made.loops.len();
        for _ in 0..10_000 {
            let p = Point::new(rng.random_range(-6.0..6.0), rng.random_range(-6.0..6.0));
            let right = outlines.iter().any(|o| encloses(o, p));
            assert_eq!(encloses(&made.loops, p), right, "{p:?} {outlines:?}");
        }
    }
    assert!(parts > 80 && loops > 500, "{parts} {loops}");
}

/// Rectangles, plates with a rectangular hole, and discs, at whole numbers.
fn whole_outline(rng: &mut ChaCha8Rng) -> Loops {
    let mut corner = || (rng.random_range(-4..4), rng.random_range(1..4));
    let ((x, w), (y, h)) = (corner(), corner());
    let whole = |x: [i32; 2], y: [i32; 2]| rectangle(x.map(f64::from), y.map(f64::from));
    match rng.random_range(0..4) {
        0 => vec![circle(f64::from(x), f64::from(y), f64::from(w))],
        1 => vec![
            whole([x, x + w + 2], [y, y + h + 2]),
            whole([x + 1, x + w + 1], [y + 1, y + h + 1]),
        ],
        _ => vec![whole([x, x + w], [y, y + h])],
    }
}

#[test]
fn whole_numbers_make_outlines_that_touch_and_overlap() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut parts = 0;
    for _ in 0..1000 {
        let outlines: Vec<Loops> = (0..rng.random_range(1..7))
            .map(|_| whole_outline(&mut rng))
            .collect();
        let made = match union(&outlines) {
            Ok(made) => made.loops,
            Err(error) => panic!("{error} {outlines:?}"),
        };
        match Part::new("", made.clone()) {
            Ok(_) => parts += 1,
            // Outlines that touch in a point, or tangentially, which leaves a cusp.
            Err(PartError::Touching { .. } | PartError::Spike { .. }) => {}
            Err(error) => panic!("{error} {outlines:?}"),
        }
        for _ in 0..1000 {
            let p = Point::new(rng.random_range(-6.0..11.0), rng.random_range(-6.0..11.0));
            let right = outlines.iter().any(|o| encloses(o, p));
            assert_eq!(encloses(&made, p), right, "{p:?} {outlines:?} {made:?}");
        }
    }
    assert!(parts > 600, "{parts}");
}

#[test]
fn outlines_that_all_but_touch_are_right_or_refused() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let mut unclear = 0;
    for _ in 0..1000 {
        let mut outlines: Vec<Loops> = (0..rng.random_range(1..7))
            .map(|_| whole_outline(&mut rng))
            .collect();
        let off = 10f64.powf(rng.random_range(-16.0..-6.0));
        for v in outlines.iter_mut().flatten().flatten() {
            v.x += rng.random_range(-off..off);
            v.y += rng.random_range(-off..off);
        }
        let made = match union(&outlines) {
            Ok(made) => made.loops,
            Err(UnionError::Unclear) => {
                unclear += 1;
                continue;
            }
            Err(error) => panic!("{error} {outlines:?}"),
        };
        for _ in 0..1000 {
            let p = Point::new(rng.random_range(-6.0..11.0), rng.random_range(-6.0..11.0));
            let is_clear = [p.x, p.y]
                .into_iter()
                .all(|x: f64| (x - x.round()).abs() > 1e-5);
            let right = outlines.iter().any(|o| encloses(o, p));
            assert!(
                !is_clear || encloses(&made, p) == right,
                "{p:?} {outlines:?} {made:?}"
            );
        }
    }
    assert!(unclear < 10, "{unclear}");
}

#[test]
fn a_shared_edge_is_no_edge() {
    let all = united(&[
        vec![rectangle([0.0, 2.0], [0.0, 2.0])],
        vec![rectangle([2.0, 3.0], [0.5, 1.5])],
    ]);
    assert_eq!((all.loops().len(), all.area()), (1, 5.0));
    // Twice the same, and one that lies in another.
    let square = rectangle([0.0, 2.0], [0.0, 2.0]);
    let all = united(&[
        vec![square.clone()],
        vec![square.clone()],
        vec![rectangle([0.5, 2.0], [1.0, 2.0])],
    ]);
    assert_eq!((all.area(), all.edges().count()), (4.0, 4));
    // In one outline the same loop twice encloses nothing.
    assert_eq!(
        union(&[vec![square.clone(), square.clone()]]),
        Err(UnionError::Nothing)
    );
    // An arc in an arc: half a disc in the whole one.
    let half = vec![Vertex::new(3.0, 0.0, 1.0), Vertex::line(-3.0, 0.0)];
    let all = united(&[vec![circle(0.0, 0.0, 3.0)], vec![half]]);
    assert!((all.area() - 9.0 * PI).abs() < 1e-13);
    assert!(all.edges().all(|e| !e.is_line()));
    // Rounding of what is meant to be shared.
    let turned = |x: f64, y: f64| {
        let (sin, cos) = 0.3f64.sin_cos();
        Vertex::line(cos * x - sin * y, sin * x + cos * y)
    };
    let block = |x: [f64; 2]| {
        vec![
            turned(x[0], 0.0),
            turned(x[1], 0.0),
            turned(x[1], 1.0 / 3.0),
            turned(x[0], 1.0 / 3.0),
        ]
    };
    let row: Vec<Loops> = (0..10)
        .map(|i| vec![block([f64::from(i) * 0.1, f64::from(i + 1) * 0.1])])
        .collect();
    assert!((united(&row).area() - 1.0 / 3.0).abs() < 1e-12);
}

#[test]
fn vertices_that_are_given_stay_as_given() {
    let outlines = [
        vec![rectangle([0.1, 0.7], [0.3, 1.1])],
        vec![circle(0.7, 0.7, 0.2)],
    ];
    let made = union(&outlines).unwrap();
    let corners = made.loops[0]
        .iter()
        .filter(|v| outlines[0][0].iter().any(|w| v.point() == w.point()));
    assert_eq!((made.loops.len(), corners.count()), (1, 4));
    let names = &made.edges[0];
    assert_eq!(
        (names[0].outline, names[0].loop_index, names[0].vertex),
        (0, 0, 0)
    );
    let single = union(&outlines[..1]).unwrap();
    assert_eq!(single.loops, outlines[0]);
}

#[test]
fn outlines_that_touch_in_a_point_are_no_part() {
    let corner = [
        vec![rectangle([0.0, 1.0], [0.0, 1.0])],
        vec![rectangle([1.0, 2.0], [1.0, 2.0])],
    ];
    assert!(Part::new("", union(&corner).unwrap().loops).is_err());
}

/// A body with an eye, a bar across both, and a hole: by the length of the bar, the radius of the eye, and where its arc ends.
fn body<T: Real>([length, radius, bulge]: [T; 3]) -> Vec<Loops<T>> {
    let c = T::constant;
    let v = |x: T, y: f64, b: T| Vertex::new(x, c(y), b);
    let zero = c(0.0);
    vec![
        vec![vec![v(-radius, 0.5, c(1.0)), v(radius, 0.5, c(1.0))]],
        vec![vec![
            v(zero, -0.25, zero),
            v(length, -0.5, bulge),
            v(length, 0.5, zero),
            v(zero, 0.25, zero),
        ]],
        vec![
            vec![
                v(c(0.5), -2.0, c(0.3)),
                v(c(2.0), -2.0, zero),
                v(c(2.0), 2.0, zero),
                v(c(0.5), 2.0, zero),
            ],
            vec![
                v(c(1.0), -1.0, zero),
                v(c(1.5), -1.0, zero),
                v(c(1.5), 1.0, zero),
                v(c(1.0), 1.0, zero),
            ],
        ],
    ]
}

#[test]
fn derivatives_are_differences() {
    let at = [4.0, 1.25, 0.4];
    let step = 1e-6;
    for k in 0..3 {
        let there = |by: f64| {
            let mut at = at;
            at[k] += by;
            union(&body(at)).unwrap().loops
        };
        let mut dual = at.map(Dual::<1>::constant);
        dual[k] = Dual::variable(at[k], 0);
        let made = union(&body(dual)).unwrap();
        assert!(made.touches.is_empty() && made.loops.len() == 3);
        let (plain, after, before) = (there(0.0), there(step), there(-step));
        let mut moved = 0;
        for (l, vertices) in made.loops.iter().enumerate() {
            for (i, v) in vertices.iter().enumerate() {
                let [p, q, r] = [&plain, &after, &before].map(|of| of[l][i]);
                for (number, value, difference) in [
                    (v.x, p.x, q.x - r.x),
                    (v.y, p.y, q.y - r.y),
                    (v.bulge, p.bulge, q.bulge - r.bulge),
                ] {
                    assert!((number.value - value).abs() < 1e-14);
                    let difference = difference / (2.0 * step);
                    assert!(
                        (number.slope[0] - difference).abs() < 1e-8,
                        "{k} {l} {i} {number:?} {difference}"
                    );
                    moved += usize::from(difference.abs() > 0.01);
                }
            }
        }
        assert!(moved > 0, "{k}: {moved}");
    }
}
