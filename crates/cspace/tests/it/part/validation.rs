//! Loops that make a part, and the errors for those that do not.

use core::f64::consts::{PI, TAU};

use cspace::part::tolerance::{MAX_VERTICES, RESOLUTION};
use cspace::{Part, PartError, Point, Vertex};

use crate::part::backwards;

type Loop = Vec<Vertex>;

fn polygon(corners: &[(f64, f64)]) -> Loop {
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn square(x: f64, y: f64, half: f64) -> Loop {
    polygon(&[
        (x - half, y - half),
        (x + half, y - half),
        (x + half, y + half),
        (x - half, y + half),
    ])
}

fn circle(x: f64, y: f64, r: f64) -> Loop {
    vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)]
}

fn make(loops: Vec<Loop>) -> Result<Part, PartError> {
    Part::new("part", loops)
}

fn error(loops: Vec<Loop>) -> PartError {
    make(loops).unwrap_err()
}

fn area_is(part: &Part, area: f64) {
    let found = part.area();
    assert!((found - area).abs() <= 1e-13 * area, "{found} for {area}");
}

// Rejected loops.

#[test]
fn no_loops() {
    assert_eq!(error(vec![]), PartError::Empty);
}

#[test]
fn too_few_vertices() {
    for count in [0, 1] {
        let few = circle(9.0, 0.0, 1.0)[..count].to_vec();
        let found = error(vec![circle(0.0, 0.0, 1.0), few]);
        let loop_index = 1;
        assert_eq!(found, PartError::TooFewVertices { loop_index, count });
    }
}

#[test]
fn two_lines_and_arcs_too_flat_to_be_arcs() {
    for bulge in [0.0, 1e-12, -1e-12, f64::MIN_POSITIVE] {
        let flat = vec![Vertex::new(0.0, 0.0, bulge), Vertex::line(1.0, 0.0)];
        let (loop_index, count) = (0, 2);
        assert_eq!(
            error(vec![flat]),
            PartError::TooFewVertices { loop_index, count }
        );
    }
}

#[test]
fn coordinates_that_are_not_numbers() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (x, y) in [(bad, 0.0), (0.0, bad)] {
            let mut loops = vec![square(0.0, 0.0, 1.0), square(5.0, 0.0, 1.0)];
            loops[1][2] = Vertex::line(x, y);
            let (loop_index, vertex_index) = (1, 2);
            assert_eq!(
                error(loops),
                PartError::BadCoordinate {
                    loop_index,
                    vertex_index
                }
            );
        }
    }
}

#[test]
fn bulges_that_give_no_arc() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e12, -1e300] {
        let mut shape = square(0.0, 0.0, 1.0);
        shape[3].bulge = bad;
        let found = error(vec![shape]);
        assert!(
            matches!(
                found,
                PartError::BadBulge {
                    loop_index: 0,
                    vertex_index: 3,
                    ..
                }
            ),
            "{found}"
        );
    }
}

#[test]
fn numbers_whose_squares_overflow() {
    let mut shape = square(0.0, 0.0, 1.0);
    shape[2].x = 1e151;
    let (loop_index, vertex_index) = (0, 2);
    let large = PartError::CoordinateTooLarge {
        loop_index,
        vertex_index,
    };
    assert_eq!(error(vec![shape]), large);

    let mut arc = square(0.0, 0.0, 1e149);
    arc[2].bulge = 1e4;
    assert_eq!(error(vec![arc]), large);
}

#[test]
fn parts_too_small_or_too_far() {
    let tiny = make(vec![square(0.0, 0.0, 1e-130)]);
    assert!(matches!(tiny, Err(PartError::TooSmall { .. })));
    let far = make(vec![square(1e12, 0.0, 1.0)]);
    assert!(matches!(far, Err(PartError::TooFar { .. })));
}

#[test]
fn neighbours_at_one_place() {
    let size = 2.0_f64.sqrt();
    for gap in [0.0, 0.9 * RESOLUTION * size] {
        let shape = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, gap)]);
        let found = error(vec![shape]);
        let next_index = 0;
        assert_eq!(
            found,
            PartError::CoincidentVertices {
                loop_index: 0,
                vertex_index: 4,
                next_index
            }
        );
    }
    let gap = 1.1 * RESOLUTION * size;
    let shape = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, gap)]);
    assert!(make(vec![shape]).is_ok());
}

#[test]
fn all_vertices_at_one_place() {
    let found = error(vec![polygon(&[(1.0, 1.0); 3])]);
    assert_eq!(
        found,
        PartError::CoincidentVertices {
            loop_index: 0,
            vertex_index: 0,
            next_index: 1
        }
    );
}

fn is_spike(shape: Loop, vertex_index: usize) {
    let loop_index = 1;
    let spike = PartError::Spike {
        loop_index,
        vertex_index,
    };
    assert_eq!(error(vec![square(50.0, 0.0, 1.0), shape]), spike);
}

#[test]
fn spikes_of_lines() {
    // Out and back by less, by as much, and by more.
    for x in [2.5, 2.0, 1.0] {
        let shape = polygon(&[(0.0, 0.0), (3.0, 0.0), (x, 0.0), (1.0, 2.0)]);
        is_spike(shape, 1);
    }
}

#[test]
fn spikes_of_arcs() {
    // Out on an arc and back on the same circle.
    let same = vec![
        Vertex::new(1.0, 0.0, (PI / 8.0).tan()),
        Vertex::new(0.0, 1.0, -(PI / 16.0).tan()),
        Vertex::line((PI / 4.0).cos(), (PI / 4.0).sin()),
        Vertex::line(-3.0, 0.0),
    ];
    is_spike(same, 1);
    // There and back on equal arcs: the first vertex found is where the second arc ends.
    let lens = vec![Vertex::new(0.0, 0.0, 0.5), Vertex::new(1.0, 0.0, -0.5)];
    let found = error(vec![lens]);
    assert!(matches!(found, PartError::Spike { loop_index: 0, .. }));
    // A line that ends at a half circle's tangent: a cusp.
    let cusp = vec![
        Vertex::new(0.0, 0.0, 1.0),
        Vertex::line(2.0, 0.0),
        Vertex::line(2.0, -3.0),
        Vertex::line(-2.0, -3.0),
    ];
    is_spike(cusp, 1);
}

#[test]
fn edges_of_one_loop_cross() {
    let bow = polygon(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    assert_eq!(
        error(vec![square(9.0, 9.0, 1.0), bow]),
        PartError::Crossing {
            loop_index: 1,
            edge_index: 0,
            other_loop: 1,
            other_edge: 2,
            at: Point::new(1.0, 1.0)
        }
    );
}

#[test]
fn consecutive_edges_cross_again() {
    // The arc leaves the end of the line and comes back through it.
    let shape = vec![
        Vertex::line(0.0, 0.0),
        Vertex::new(4.0, 0.0, 2.0),
        Vertex::line(3.0, -0.5),
        Vertex::line(2.0, -3.0),
    ];
    let found = error(vec![shape]);
    let PartError::Crossing { at, .. } = found else {
        panic!("{found}");
    };
    assert!(at.y.abs() < 1e-15 && at.x < 4.0, "{at:?}");
    assert!(matches!(
        found,
        PartError::Crossing {
            loop_index: 0,
            edge_index: 0,
            other_loop: 0,
            other_edge: 1,
            ..
        }
    ));
}

/// The two edges that meet, and whether they cross.
fn meeting(loops: Vec<Loop>) -> ([(usize, usize); 2], bool) {
    match error(loops) {
        PartError::Crossing {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            ..
        } => ([(loop_index, edge_index), (other_loop, other_edge)], true),
        PartError::Touching {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            ..
        } => ([(loop_index, edge_index), (other_loop, other_edge)], false),
        other => panic!("{other}"),
    }
}

#[test]
fn loops_cross() {
    let (edges, crossing) = meeting(vec![square(0.0, 0.0, 2.0), circle(2.0, 0.5, 1.0)]);
    assert!(crossing);
    assert_eq!(edges[0], (0, 1));
    assert_eq!(edges[1].0, 1);
    let (edges, crossing) = meeting(vec![circle(0.0, 0.0, 1.0), circle(1.5, 0.0, 1.0)]);
    assert!(crossing);
    assert_eq!([edges[0].0, edges[1].0], [0, 1]);
}

#[test]
fn a_vertex_touches_an_edge() {
    let wedge = polygon(&[(2.0, 0.5), (5.0, 0.0), (5.0, 1.0)]);
    let (edges, crossing) = meeting(vec![square(0.0, 0.0, 2.0), wedge]);
    assert!(!crossing);
    assert_eq!(edges[0], (0, 1));
    assert!(edges[1] == (1, 0) || edges[1] == (1, 2));
}

#[test]
fn a_vertex_touches_a_vertex() {
    let wedge = polygon(&[(5.0, 1.0), (2.0, 2.0), (5.0, 3.0)]);
    let (edges, crossing) = meeting(vec![square(0.0, 0.0, 2.0), wedge]);
    assert!(!crossing);
    assert_eq!(edges, [(0, 2), (1, 1)]);
    let eight = polygon(&[
        (0.0, 0.0),
        (-1.0, 1.0),
        (-1.0, -1.0),
        (0.0, 0.0),
        (1.0, 1.0),
        (1.0, -1.0),
    ]);
    assert_eq!(meeting(vec![eight]), ([(0, 0), (0, 3)], false));
}

#[test]
fn circles_touch() {
    for x in [2.0, 2.0 + 1e-11] {
        let (edges, crossing) = meeting(vec![circle(0.0, 0.0, 1.0), circle(x, 0.0, 1.0)]);
        assert!(!crossing);
        assert_eq!([edges[0].0, edges[1].0], [0, 1]);
    }
    // From within, and where neither has a vertex.
    let (sin, cos) = 1.0_f64.sin_cos();
    for r in [0.5, -0.5] {
        let inner = circle((1.0 - r) * cos, (1.0 - r) * sin, r);
        assert!(!meeting(vec![circle(0.0, 0.0, 1.0), inner]).1);
    }
    assert!(make(vec![circle(0.0, 0.0, 1.0), circle(2.0 + 1e-9, 0.0, 1.0)]).is_ok());
    assert!(make(vec![circle(0.0, 0.0, 1.0), circle(0.5 - 1e-9, 0.0, 0.5)]).is_ok());
}

#[test]
fn a_line_is_tangent_to_an_arc() {
    let block = polygon(&[(-3.0, 1.0), (3.0, 1.0), (3.0, 4.0), (-3.0, 4.0)]);
    let (edges, crossing) = meeting(vec![circle(0.0, 0.0, 1.0), block]);
    assert!(!crossing);
    assert_eq!(edges[1], (1, 0));
}

#[test]
fn arcs_of_one_circle_overlap() {
    let part = |from: f64, sweep: f64| {
        let at = |angle: f64, r: f64| (r * angle.cos(), r * angle.sin());
        let ((ax, ay), (bx, by)) = (at(from, 1.0), at(from + sweep, 1.0));
        let ((cx, cy), (dx, dy)) = (at(from + sweep, 3.0), at(from, 3.0));
        vec![
            Vertex::new(ax, ay, (sweep / 4.0).tan()),
            Vertex::line(bx, by),
            Vertex::line(cx, cy),
            Vertex::line(dx, dy),
        ]
    };
    assert!(make(vec![part(0.0, 1.0), part(2.0, 1.0)]).is_ok());
    // One disc on the same circle as the bays: overlaps all of its edge.
    let (edges, crossing) = meeting(vec![part(0.0, 1.0), circle(0.0, 0.0, 1.0)]);
    assert!(!crossing, "{edges:?}");
    // Two consecutive arcs of one circle that together pass a full turn.
    let sweep = 4.0_f64;
    let around = vec![
        Vertex::new(1.0, 0.0, 1.0_f64.tan()),
        Vertex::new(sweep.cos(), sweep.sin(), 1.0_f64.tan()),
        Vertex::line((2.0 * sweep).cos(), (2.0 * sweep).sin()),
        Vertex::line(3.0, 0.0),
    ];
    assert_eq!(meeting(vec![around]), ([(0, 0), (0, 1)], false));
}

#[test]
fn lines_overlap() {
    let (edges, crossing) = meeting(vec![square(0.0, 0.0, 1.0), square(2.0, 0.5, 1.0)]);
    assert!(!crossing);
    assert_eq!([edges[0].0, edges[1].0], [0, 1]);
}

#[test]
fn a_slit_thinner_than_the_resolution() {
    let slit = |w: f64| {
        polygon(&[
            (0.0, 0.0),
            (1.0, 0.0),
            (1.0, 0.5),
            (0.5, 0.5),
            (0.5, 0.5 + w),
            (1.0, 0.5 + w),
            (1.0, 1.0),
            (0.0, 1.0),
        ])
    };
    assert!(make(vec![slit(3e-11)]).is_ok());
    assert!(make(vec![slit(1.5e-11)]).is_err());
}

#[test]
fn loops_given_twice() {
    let mut shape = square(0.0, 0.0, 1.0);
    shape[1].bulge = 0.3;
    let mut turned = shape.clone();
    turned.rotate_left(3);
    for again in [shape.clone(), turned.clone(), backwards(&turned)] {
        let found = error(vec![circle(9.0, 0.0, 1.0), shape.clone(), again]);
        let (loop_index, other_loop) = (1, 2);
        assert_eq!(
            found,
            PartError::RepeatedLoop {
                loop_index,
                other_loop
            }
        );
    }
    let mut other = shape.clone();
    other[1].bulge = -0.3;
    assert!(matches!(
        error(vec![shape, other]),
        PartError::Touching { .. }
    ));
}

#[test]
fn more_vertices_than_are_checked() {
    let count = MAX_VERTICES + 1;
    let found = error(vec![vec![Vertex::line(0.0, 0.0); count]]);
    assert_eq!(found, PartError::TooManyVertices { count });
}

#[test]
fn messages_name_the_place_and_the_remedy() {
    let message = error(vec![square(0.0, 0.0, 2.0), circle(2.0, 0.5, 1.0)]).to_string();
    assert!(
        message.starts_with("loop 0, edge 1 crosses loop 1, edge "),
        "{message}"
    );
    assert!(message.contains("move"), "{message}");
}

// Accepted loops.

/// Checks the area, in both directions of every loop, and that material is on the left.
fn is_part(loops: Vec<Loop>, area: f64) {
    for mask in 0..1_u32 << loops.len().min(4) {
        let turned = loops.iter().enumerate().map(|(i, vertices)| {
            if mask >> i & 1 == 1 {
                backwards(vertices)
            } else {
                vertices.clone()
            }
        });
        let part = make(turned.collect()).unwrap();
        area_is(&part, area);
        let step = 1e-7 * part.size();
        for edge in part.edges() {
            for u in [0.25, 0.5, 0.75] {
                let (p, left) = (edge.at(u), edge.direction_at(u).left());
                assert!(part.contains(p + left * step), "{edge:?} {u}");
                assert!(!part.contains(p + left * -step), "{edge:?} {u}");
            }
        }
    }
}

#[test]
fn a_circle_of_two_half_circles() {
    is_part(vec![circle(1.0, 2.0, 3.0)], 9.0 * PI);
    let part = make(vec![circle(1.0, 2.0, 3.0)]).unwrap();
    let bounds = part.bounds();
    assert!(bounds.min.distance(Point::new(-2.0, -1.0)) < 1e-14);
    assert!(bounds.max.distance(Point::new(4.0, 5.0)) < 1e-14);
}

#[test]
fn arcs_of_nearly_a_full_turn() {
    for bulge in [50.0_f64, 1e5, 1e9] {
        let (radius, rest) = (
            (1.0 + bulge * bulge) / (4.0 * bulge),
            4.0 * (1.0 / bulge).atan(),
        );
        let area = 0.5 * radius * radius * (TAU - (rest - rest.sin()));
        let drop = vec![Vertex::new(0.0, 0.0, bulge), Vertex::line(1.0, 0.0)];
        if bulge == 50.0 {
            is_part(vec![drop], area);
        } else {
            area_is(&make(vec![drop]).unwrap(), area);
        }
    }
}

#[test]
fn an_annulus() {
    is_part(vec![circle(0.0, 0.0, 1.0), circle(0.0, 0.0, 2.0)], 3.0 * PI);
}

#[test]
fn an_island_in_a_hole_and_a_piece_beside() {
    let loops = vec![
        square(0.0, 0.0, 1.0),
        circle(0.0, 0.0, 2.0),
        square(0.0, 0.0, 3.0),
        circle(7.0, 0.0, 2.0),
    ];
    is_part(loops, 4.0 + 36.0 - 4.0 * PI + 4.0 * PI);
}

#[test]
fn a_lens_and_a_crescent() {
    let segment = |b: f64| {
        let (radius, sweep) = ((1.0 + b * b) / (2.0 * b), 4.0 * b.atan());
        0.5 * radius * radius * (sweep - sweep.sin())
    };
    let shape = |b, c| vec![Vertex::new(-1.0, 0.0, b), Vertex::new(1.0, 0.0, c)];
    is_part(vec![shape(0.5, 0.25)], segment(0.5) + segment(0.25));
    is_part(vec![shape(1.0, -0.5)], segment(1.0) - segment(0.5));
    is_part(vec![shape(3.0, -2.0)], segment(3.0) - segment(2.0));
    is_part(vec![shape(0.0, 0.7)], segment(0.7));
    let thin = make(vec![shape(0.5, -0.5 + 1e-9)]).unwrap();
    assert!(thin.area() > 0.0);
}

#[test]
fn rounded_corners_join_smoothly() {
    let b = (PI / 8.0).tan();
    let rounded = vec![
        Vertex::line(1.0, 0.0),
        Vertex::new(3.0, 0.0, b),
        Vertex::line(4.0, 1.0),
        Vertex::new(4.0, 3.0, b),
        Vertex::line(3.0, 4.0),
        Vertex::new(1.0, 4.0, b),
        Vertex::line(0.0, 3.0),
        Vertex::new(0.0, 1.0, b),
    ];
    is_part(vec![rounded], 12.0 + PI);
}

#[test]
fn far_from_the_origin() {
    for far in [1e6, 1e8] {
        let loops = vec![
            square(far, -far, 1.0),
            vec![
                Vertex::new(far - 0.5, -far, 1.0),
                Vertex::new(far + 0.5, -far, 1.0),
            ],
        ];
        area_is(&make(loops).unwrap(), 4.0 - 0.25 * PI);
    }
}

#[test]
fn tiny_and_huge() {
    for size in [1e-6, 1e-100, 1e100] {
        let loops = vec![square(0.0, 0.0, size), circle(0.0, 0.0, 0.5 * size)];
        let area = (4.0 - 0.25 * PI) * size * size;
        area_is(&make(loops).unwrap(), area);
    }
}

#[test]
fn nearly_flat_arcs() {
    for bulge in [1e-12, 2e-11, 1e-10, 1e-8] {
        for bulge in [bulge, -bulge] {
            let mut shape = square(0.0, 0.0, 1.0);
            for vertex in &mut shape {
                vertex.bulge = bulge;
            }
            let part = make(vec![shape]).unwrap();
            assert_eq!(part.edges().all(|e| e.is_line()), bulge.abs() < 1e-11);
            let area = 4.0 + 4.0 * 4.0 * bulge / 3.0;
            assert!((part.area() - area).abs() < 1e-11);
        }
    }
}

#[test]
fn two_thousand_holes_at_many_depths() {
    let mut loops = Vec::new();
    for i in 0..40 {
        for j in 0..50 {
            loops.push(circle(f64::from(i), f64::from(j), 0.4));
        }
    }
    let rings = 300;
    for k in 0..rings {
        loops.push(square(20.0, 25.0, 30.0 + f64::from(k)));
    }
    let part = make(loops).unwrap();
    let squares: f64 = (0..rings)
        .map(|k| {
            let side = 2.0 * (30.0 + f64::from(k));
            side * side * if k % 2 == 1 { 1.0 } else { -1.0 }
        })
        .sum();
    area_is(&part, squares + 2000.0 * PI * 0.16);
}

// Large and difficult loops.

fn star(n: usize, radius: impl Fn(usize) -> f64, bulge: f64) -> Loop {
    (0..n)
        .map(|i| {
            let angle = TAU * i as f64 / n as f64;
            let r = radius(i);
            Vertex::new(r * angle.cos(), r * angle.sin(), bulge)
        })
        .collect()
}

/// Pseudo-random numbers in [0, 1).
fn noise(i: usize) -> f64 {
    let x = (i as u64)
        .wrapping_add(1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    ((x ^ (x >> 27)) >> 11) as f64 / (1_u64 << 53) as f64
}

#[test]
fn many_vertices() {
    let n = 100_000;
    let smooth = star(n, |_| 1.0, (0.5 * PI / n as f64).tan());
    area_is(&make(vec![smooth]).unwrap(), PI);
    // Every edge long, and every box over many others.
    let spiky = star(n, |i| 0.5 + noise(i), 0.0);
    assert!(make(vec![spiky]).is_ok());
}

#[test]
fn long_slivers_side_by_side() {
    // A slanting comb: the boxes of all edges overlap.
    let n = 50_000;
    let mut comb: Loop = (0..2 * n)
        .map(|i| {
            let t = f64::from(i) / f64::from(n);
            let out = if i % 2 == 0 { 0.0 } else { 1.0 };
            Vertex::line(out + 0.3 * t, out - 0.3 * t)
        })
        .collect();
    comb.push(Vertex::line(2.0, -2.0));
    comb.push(Vertex::line(-1.0, -2.0));
    comb.push(Vertex::line(-1.0, 0.0));
    assert!(make(vec![comb.clone()]).is_ok());
    let last = comb.len() - 4;
    comb[last] = Vertex::line(0.5, 0.4);
    assert!(make(vec![comb]).is_err());
}

#[test]
fn a_star_of_crossing_edges() {
    let n = 100_001_u64;
    let crossing: Loop = (0..n)
        .map(|i| {
            let angle = TAU * (i * 50_000 % n) as f64 / n as f64;
            Vertex::line(angle.cos(), angle.sin())
        })
        .collect();
    assert!(matches!(
        make(vec![crossing]),
        Err(PartError::Crossing { .. })
    ));
}

/// Consecutive arcs of one circle meet nowhere else, whatever the rounding of their second crossing.
#[test]
fn a_hole_may_be_drawn_in_six_arcs() {
    let plate = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let plate = plate.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    let hole = [
        (
            0.6499999999999999,
            -0.08660254037844385,
            -0.2679491924311231,
        ),
        (
            0.5499999999999997,
            -0.08660254037844378,
            -0.26794919243112236,
        ),
        (
            0.4999999999999999,
            -6.257249085612409e-18,
            -0.26794919243112286,
        ),
        (
            0.5499999999999999,
            0.08660254037844387,
            -0.26794919243112236,
        ),
        (
            0.6499999999999998,
            0.08660254037844387,
            -0.26794919243112286,
        ),
        (
            0.6999999999999998,
            -1.8503717077085938e-17,
            -0.26794919243112264,
        ),
    ];
    let hole = hole.map(|(x, y, b)| Vertex::new(x, y, b)).to_vec();
    assert_eq!(Part::new("plate", vec![plate, hole]).err(), None);
}
