//! Plain shapes and outlines drawn edge by edge, checked by independent geometry: distances and steps along curves.

use core::f64::consts::{PI, TAU};

use cspace::part::{
    ArcError, ArcSize, Direction, Fillet, FilletError, OutlineBuilder, OutlineError, bulge_about,
    bulge_through, bulge_with_radius, circle_loop, fillet, polygon_loop, rectangle_loop,
};
use cspace::{Edge, Part, PartError, Point, Vector};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::cases;

fn edge(start: Point, end: Point, bulge: f64) -> Edge {
    Edge {
        start,
        end,
        bulge,
        index: 0,
    }
}

/// The edge that starts at the origin in a direction (radians) with a length and a sweep.
fn leaving(angle: f64, length: f64, sweep: f64) -> Edge {
    let half = 0.5 * sweep;
    let ratio = if half == 0.0 { 1.0 } else { half.sin() / half };
    let end = Point::ORIGIN + Vector::from_angle(angle + half) * (length * ratio);
    edge(Point::ORIGIN, end, (0.25 * sweep).tan())
}

/// The edge that arrives at the origin in a direction.
fn arriving(angle: f64, length: f64, sweep: f64) -> Edge {
    leaving(angle + PI, length, -sweep).reversed()
}

/// The centre of the circle of a radius on one side of the first edge that touches the second: the first one found in small steps back from
/// the corner.
fn searched(before: &Edge, after: &Edge, radius: f64, side: f64) -> Option<(Point, Point)> {
    const STEPS: u32 = 4000;
    let touching = |u: f64| {
        let foot = before.at(u);
        (foot, foot + before.direction_at(u).left() * (side * radius))
    };
    let gap = |u: f64| after.distance(touching(u).1) - radius;
    let mut last = 1.0;
    for k in 1..=STEPS {
        let u = 1.0 - f64::from(k) / f64::from(STEPS);
        if gap(u) >= 0.0 {
            let (mut lo, mut hi) = (u, last);
            for _ in 0..60 {
                let middle = 0.5 * (lo + hi);
                if gap(middle) >= 0.0 {
                    lo = middle;
                } else {
                    hi = middle;
                }
            }
            return Some(touching(lo));
        }
        last = u;
    }
    None
}

/// Checks that a fillet is tangent to both edges where it joins them, and that their remaining parts are parts of them.
fn check_joins(before: &Edge, after: &Edge, radius: f64, rounded: &Fillet) {
    let arc = rounded.arc;
    assert!((arc.radius() / radius - 1.0).abs() < 1e-7);
    assert!(arc.sweep().abs() < PI + 1e-7);
    assert!(before.distance(arc.start) < 1e-8 && after.distance(arc.end) < 1e-8);
    // Directions by differences along the curves.
    let step = 1e-4;
    let turned =
        |from: Point, at: Point, to: Point| ((at - from).unit().cross((to - at).unit())).abs();
    for (rest, at_end) in [(rounded.before, true), (rounded.after, false)] {
        let Some(rest) = rest else { continue };
        if rest.length() < 1e-2 {
            continue;
        }
        let (from, to) = if at_end {
            assert_eq!(rest.end, arc.start);
            (rest.at(1.0 - step), arc.at(step))
        } else {
            assert_eq!(rest.start, arc.end);
            (arc.at(1.0 - step), rest.at(step))
        };
        let at = if at_end { arc.start } else { arc.end };
        assert!(turned(from, at, to) < 1e-3, "{rest:?} {arc:?}");
        // The middle of the remaining part lies on the original edge.
        let whole = if at_end { before } else { after };
        assert!(whole.distance(rest.at(0.5)) < 1e-9);
    }
}

/// Number of random cases of each question.
const CASES: u64 = 2000;

fn point(rng: &mut ChaCha8Rng) -> Point {
    Point::new(rng.random_range(-10.0..10.0), rng.random_range(-10.0..10.0))
}

#[test]
fn an_arc_through_a_point_contains_it() {
    cases(CASES, |rng| {
        let [a, b, through] = [0; 3].map(|_| point(rng));
        let near = a
            .distance(b)
            .min(a.distance(through))
            .min(b.distance(through));
        if near <= 1e-2 {
            return;
        }
        let bulge = bulge_through(a, b, through).unwrap();
        if bulge.abs() >= 1e3 {
            return;
        }
        let arc = edge(a, b, bulge);
        let size = 1.0
            + if bulge == 0.0 {
                0.0
            } else {
                arc.radius().min(1e3)
            };
        assert!(arc.distance(through) < 1e-9 * size);
        // Traversed backwards it is the same arc.
        let back = bulge_through(b, a, through).unwrap();
        assert!((back + bulge).abs() <= 1e-9 * (1.0 + bulge * bulge));
    });
}

#[test]
fn by_centre_by_radius_and_through_agree() {
    cases(CASES, |rng| {
        let center = point(rng);
        let radius = rng.random_range(0.01..10.0);
        let from = rng.random_range(-PI..PI);
        let sweep: f64 = rng.random_range(0.01..6.27);
        let turns_left = rng.random_bool(0.5);
        if (sweep - PI).abs() <= 1e-6 {
            return;
        }
        let sign = if turns_left { 1.0 } else { -1.0 };
        let direction = if turns_left {
            Direction::CounterClockwise
        } else {
            Direction::Clockwise
        };
        let size = if sweep < PI {
            ArcSize::Short
        } else {
            ArcSize::Long
        };
        let at = |share: f64| center + Vector::from_angle(from + sign * sweep * share) * radius;
        let (a, b) = (at(0.0), at(1.0));
        let wanted: f64 = sign * (0.25 * sweep).tan();
        let near = |bulge: f64, tolerance: f64| (bulge.atan() - wanted.atan()).abs() < tolerance;
        let by_center = bulge_about(a, b, center, direction).unwrap();
        assert!(near(by_center, 1e-9));
        // Near half a turn the arc depends little on the radius.
        let by_radius = bulge_with_radius(a, b, radius, direction, size).unwrap();
        assert!(near(by_radius, 1e-6));
        assert!(near(bulge_through(a, b, at(0.37)).unwrap(), 1e-9));
        let arc = edge(a, b, by_center);
        assert!((arc.radius() / radius - 1.0).abs() < 1e-9);
        assert!(arc.distance(at(0.81)) < 1e-9 * radius);
    });
}

/// Between lines and arcs, in all combinations: the tangent circle nearest to the corner.
#[test]
fn a_fillet_is_the_tangent_circle_found_by_search() {
    cases(CASES, |rng| {
        let arrives = rng.random_range(-PI..PI);
        let turn = rng.random_range(0.05..3.0);
        let side = if rng.random_bool(0.5) { 1.0 } else { -1.0 };
        let lengths = [0; 2].map(|_| rng.random_range(0.5..4.0));
        let sweeps = [0; 2].map(|_| rng.random_range(-2.5..2.5));
        let kinds = rng.random_range(0..4);
        let radius = rng.random_range(0.01..1.5);
        let sweep = |which: i32, sweep: f64| if kinds & which != 0 { sweep } else { 0.0 };
        let before = arriving(arrives, lengths[0], sweep(1, sweeps[0]));
        let before = Edge {
            end: Point::ORIGIN,
            ..before
        };
        let after = leaving(arrives + side * turn, lengths[1], sweep(2, sweeps[1]));
        match fillet(&before, &after, radius) {
            Ok(rounded) => {
                check_joins(&before, &after, radius, &rounded);
                if let Some((foot, center)) = searched(&before, &after, radius, side) {
                    let off = rounded.arc.start.distance(foot);
                    assert!(off < 1e-6, "{rounded:?} {foot}");
                    assert!(rounded.arc.center().distance(center) < 1e-6);
                }
            }
            Err(FilletError::TooLarge {
                largest: Some(largest),
                ..
            }) => {
                assert!(0.0 < largest && largest < radius);
                let rounded = fillet(&before, &after, largest).unwrap();
                check_joins(&before, &after, largest, &rounded);
                assert!(fillet(&before, &after, largest * 1.001).is_err());
            }
            Err(error) => panic!("{error}"),
        }
    });
}

/// With a little of everything, the outline makes a part, and no fillet moves an edge.
#[test]
fn rounded_rectangles_have_the_area_known() {
    cases(CASES, |rng| {
        let [width, height] = [0; 2].map(|_| rng.random_range(0.1..10.0));
        let share: f64 = rng.random_range(0.01..1.0);
        let center = point(rng);
        let r = 0.5 * share * f64::min(width, height);
        let corner = |x: f64, y: f64| [center.x + x * 0.5 * width, center.y + y * 0.5 * height];
        let outline = OutlineBuilder::start(corner(-1.0, -1.0))
            .fillet(r)
            .line_to(corner(1.0, -1.0))
            .fillet(r)
            .line_to(corner(1.0, 1.0))
            .fillet(r)
            .line_to(corner(-1.0, 1.0))
            .fillet(r)
            .close()
            .unwrap();
        let part = Part::new("rounded", vec![outline]).unwrap();
        let area = width * height - (4.0 - PI) * r * r;
        assert!((part.area() / area - 1.0).abs() < 1e-8);
    });
}

/// The search itself is checked by a case that has a known solution.
#[test]
fn the_search_agrees_with_a_fillet_that_is_known() {
    // A line along the x axis and the unit circle about (0, 1) are tangent at the origin; with the line moved up by half, they have a
    // corner at −√3 / 2.
    let x = -0.75_f64.sqrt();
    let corner = Point::new(x, 0.0);
    let before = edge(Point::new(-4.0, 0.0), corner, 0.0);
    let top = Point::new(0.0, 1.5);
    let after = edge(
        corner,
        top,
        bulge_about(corner, top, [0.0, 0.5], Direction::Clockwise).unwrap(),
    );
    // A circle on the line outside the other: (1 + r)² = c² + (r − 1/2)².
    let r: f64 = 0.3;
    let c = -((1.0 + r) * (1.0 + r) - (r - 0.5) * (r - 0.5)).sqrt();
    let (foot, center) = searched(&before, &after, r, 1.0).unwrap();
    assert!(foot.distance(Point::new(c, 0.0)) < 1e-9);
    assert!(center.distance(Point::new(c, r)) < 1e-9);
    let rounded = fillet(&before, &after, r).unwrap();
    assert!(rounded.arc.start.distance(foot) < 1e-9);
    assert!(rounded.arc.center().distance(center) < 1e-9);
}

#[test]
fn flat_arcs_are_rounded_as_lines_are() {
    let at = Point::new;
    for bulge in [1e-3, 1e-6, 1e-9, -1e-9] {
        let before = edge(at(100.0, 50.0), at(104.0, 50.0), bulge);
        let after = edge(at(104.0, 50.0), at(104.0, 53.0), -bulge);
        let rounded = fillet(&before, &after, 1.0).unwrap();
        assert!(rounded.arc.start.distance(at(103.0, 50.0)) < 4.0 * bulge.abs() + 1e-13);
        let rest = rounded.before.unwrap();
        assert!((rest.radius() / before.radius() - 1.0).abs() < 1e-9);
    }
}

#[test]
fn a_slot_is_a_rectangle_rounded_by_half_its_height() {
    let outline = OutlineBuilder::start([0.0, -1.0])
        .fillet(1.0)
        .line_to([5.0, -1.0])
        .fillet(1.0)
        .line_to([5.0, 1.0])
        .fillet(1.0)
        .line_to([0.0, 1.0])
        .fillet(1.0)
        .close()
        .unwrap();
    // The short sides vanish.
    assert_eq!(outline.len(), 6);
    let part = Part::new("slot", vec![outline]).unwrap();
    let slot = Part::slot("slot", [1.0, 0.0], [4.0, 0.0], 1.0).unwrap();
    assert!((part.area() - slot.area()).abs() < 1e-12);
}

#[test]
fn an_arc_may_lead_back_to_the_start() {
    let half = OutlineBuilder::start([1.0, 0.0])
        .arc_through([-1.0, 0.0], [0.0, 1.0])
        .arc_to_radius([1.0, 0.0], 1.0, Direction::CounterClockwise, ArcSize::Short)
        .close()
        .unwrap();
    assert_eq!(half.len(), 2);
    assert!(half.iter().all(|v| v.bulge == 1.0));
    // The corner at the start is rounded from there.
    let drop = OutlineBuilder::start([2.0, 0.0])
        .line_to([0.0, 1.0])
        .arc_to_center([0.0, -1.0], [0.0, 0.0], Direction::CounterClockwise)
        .line_to([2.0, 0.0])
        .fillet(0.25)
        .close()
        .unwrap();
    assert_eq!(drop.len(), 4);
    assert!(Part::new("drop", vec![drop]).is_ok());
}

#[test]
fn what_cannot_be_drawn_is_told_with_its_vertex() {
    let start = || OutlineBuilder::start([0.0, 0.0]).line_to([4.0, 0.0]);
    let left = Direction::CounterClockwise;
    let told = |outline: OutlineBuilder| outline.close().unwrap_err().to_string();
    assert_eq!(
        told(
            start()
                .arc_to_radius([4.0, 4.0], 1.5, left, ArcSize::Short)
                .line_to([9.0, f64::NAN])
        ),
        "the arc from vertex 1 to 2: the radius 1.5 is too small, for the ends are 4.0 apart: give at least 2.0, or move the ends together"
    );
    assert_eq!(
        told(start().arc_to_center([4.0, 4.0], [4.0, 1.0], left)),
        "the arc from vertex 1 to 2: the centre is 1.0 from the arc's start and 3.0 from its end, which differ by more than 1e-6 of the longer: move the centre to where both are equal"
    );
    assert_eq!(
        told(start().arc_through([4.0, 4.0], [4.0, 5.0])),
        "the arc from vertex 1 to 2: no arc from (4.0, 0.0) to (4.0, 4.0) goes through (4.0, 5.0): give a point beside the line of the ends, or between them"
    );
    assert_eq!(
        told(start().fillet(5.0).line_to([4.0, 2.0])),
        "vertex 1: a fillet of radius 5.0 does not fit: give at most 2.0"
    );
    let cases = [
        (
            start().fillet(1.0).line_to([8.0, 0.0]).line_to([0.0, 4.0]),
            "vertex 1: there is no corner",
        ),
        (
            start().fillet(-1.0).line_to([0.0, 4.0]),
            "vertex 1: the fillet's radius is -1.0",
        ),
        (
            start().fillet(1.0).fillet(1.0).line_to([0.0, 4.0]),
            "vertex 1 has two fillets",
        ),
        (
            start().line_to([4.0, 0.0]),
            "vertex 1: the next vertex is at the same place",
        ),
        (start().line_to([f64::NAN, 0.0]), "vertex 2: a coordinate"),
        (
            start().arc_to([4.0, 4.0], f64::NAN),
            "vertex 1: a coordinate or bulge",
        ),
        (
            OutlineBuilder::start([f64::INFINITY, 0.0]),
            "vertex 0: a coordinate",
        ),
        (start(), "the outline has 2 vertices"),
        (
            OutlineBuilder::start([0.0, 0.0]),
            "the outline has 1 vertices",
        ),
        (
            start().arc_to_radius([4.0, 4.0], f64::NAN, left, ArcSize::Long),
            "the arc from vertex 1 to 2: the radius is NaN",
        ),
        (
            start()
                .fillet(2.0)
                .line_to([4.0, 2.0])
                .fillet(0.5)
                .line_to([0.0, 2.0]),
            "vertex 2: a fillet of a neighbouring corner takes all",
        ),
    ];
    for (outline, begins) in cases {
        let message = told(outline);
        assert!(message.starts_with(begins), "{message}");
    }
    let error = start().close().unwrap_err();
    assert_eq!(PartError::from(error).to_string(), error.to_string());
    assert!(matches!(error, OutlineError::TooFewVertices { count: 2 }));
}

#[test]
fn arithmetic_refuses_what_makes_no_arc() {
    let (o, left) = ([0.0, 0.0], Direction::CounterClockwise);
    assert_eq!(bulge_through(o, o, [1.0, 0.0]), Err(ArcError::NoChord));
    assert_eq!(bulge_about(o, o, [1.0, 0.0], left), Err(ArcError::NoChord));
    assert_eq!(
        bulge_about(o, [1.0, 0.0], [0.5, f64::NAN], left),
        Err(ArcError::NotFinite)
    );
    assert_eq!(
        bulge_through(o, [1.0, 0.0], [f64::INFINITY, 0.0]),
        Err(ArcError::NotFinite)
    );
    for through in [o, [1.0, 0.0], [-3.0, 0.0]] {
        let refused = bulge_through(o, [1.0, 0.0], through);
        assert!(
            matches!(refused, Err(ArcError::NotThrough { .. })),
            "{refused:?}"
        );
    }
    // A half circle whose ends and radius were rounded separately.
    let drawn = |chord: f64| bulge_with_radius(o, [chord, 0.0], 0.707, left, ArcSize::Long);
    assert!((drawn(1.413999).unwrap() - 1.0).abs() < 2e-3);
    assert_eq!(drawn(1.414001), Ok(1.0));
    assert!(matches!(
        drawn(1.414002),
        Err(ArcError::RadiusTooSmall { .. })
    ));
    // Numbers of any magnitude are accepted by these functions, though not in a part.
    for scale in [1e-200, 1e200, 1e308] {
        let (a, b, c) = ([-scale, 0.0], [scale, 0.0], [0.0, scale]);
        assert!(bulge_through(a, b, c).is_ok_and(|b| (b + 1.0).abs() < 1e-9) || scale > 1e300);
        let _ = bulge_about(a, b, [0.0, 0.0], left);
        let edges = (edge(a.into(), b.into(), 0.0), edge(b.into(), c.into(), 0.5));
        let _ = fillet(&edges.0, &edges.1, scale);
    }
}

#[test]
fn shapes_refuse_sizes_that_are_none() {
    let nan = f64::NAN;
    let bad = [
        Part::circle("p", (0.0, 0.0), 0.0),
        Part::circle("p", (0.0, 0.0), nan),
        Part::circle("p", (0.0, 0.0), f64::INFINITY),
        Part::circle("p", (nan, 0.0), 1.0),
        Part::circle("p", (1e20, 0.0), 1.0),
        Part::rectangle("p", (0.0, 0.0), -1.0, 1.0),
        Part::rectangle("p", (0.0, 0.0), 1.0, nan),
        Part::rectangle("p", (0.0, 0.0), 1.0, 1e-12),
        Part::rectangle("p", (0.0, nan), 1.0, 1.0),
        Part::slot("p", (0.0, 0.0), (0.0, 0.0), 1.0),
        Part::slot("p", (0.0, 0.0), (1.0, 0.0), 0.0),
        Part::slot("p", (0.0, 0.0), (1.0, nan), 1.0),
        Part::slot("p", (0.0, 0.0), (1e-12, 0.0), 1.0),
        Part::slot("p", (-1e308, 0.0), (1e308, 0.0), 1.0),
        Part::polygon("p", &[(0.0, 0.0), (1.0, 0.0)]),
        Part::polygon("p", &[[0.0, 0.0], [1.0, nan], [0.0, 1.0]]),
        Part::polygon::<Point>("p", &[]),
    ];
    for part in bad {
        let message = part.unwrap_err().to_string();
        assert!(
            ["give ", "move ", "choose "]
                .iter()
                .any(|help| message.contains(help)),
            "{message}"
        );
    }
}

#[test]
fn shapes_are_where_they_were_asked_for() {
    let bounds = |part: Part| {
        let b = part.bounds();
        [b.min.x, b.min.y, b.max.x, b.max.y]
    };
    let circle = Part::circle("c", [3.0, -1.0], 2.0).unwrap();
    assert_eq!(bounds(circle), [1.0, -3.0, 5.0, 1.0]);
    let rectangle = Part::rectangle("r", [3.0, -1.0], 4.0, 2.0).unwrap();
    assert_eq!(bounds(rectangle), [1.0, -2.0, 5.0, 0.0]);
    let slot = Part::slot("s", [0.0, 1.0], [0.0, -4.0], 1.0).unwrap();
    let found = bounds(slot);
    let wanted = [-1.0, -5.0, 1.0, 2.0];
    assert!(
        found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-15),
        "{found:?}"
    );
    let loops = vec![
        rectangle_loop([0.0, 0.0], 8.0, 8.0).unwrap(),
        circle_loop([0.0, 0.0], 3.0).unwrap(),
        polygon_loop(&[[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]]),
    ];
    let nested = Part::new("nested", loops).unwrap();
    assert!((nested.area() - (64.0 - 4.5 * TAU + 2.0)).abs() < 1e-12);
}
