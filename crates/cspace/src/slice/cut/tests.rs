//! Which curves are marked, and which orientations: those at which rounding may have its way.

use core::f64::consts::PI;

use super::*;
use crate::part::{Part, Vertex};

fn polygon(name: &str, corners: &[(f64, f64)]) -> Part {
    Part::new(name, vec![corners_of(corners)]).unwrap()
}

fn corners_of(corners: &[(f64, f64)]) -> Vec<Vertex> {
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn geometry(fixed: &Part, moving: &Part) -> Geometry {
    Geometry::new(fixed, moving, None, usize::MAX)
}

fn cut_at(geometry: &Geometry, theta: f64) -> Vec<Live> {
    let turn = Rotation::by(theta);
    let sheets = 0..geometry.contacts.sheets.len() as u32;
    let (mut live, ..) = live_curves(geometry, sheets, theta, turn);
    cut(&mut live, geometry, turn);
    live
}

/// Along the top of a block up to its end, and there against a wall that leans over: the wall's curve crosses that of the
/// top a way before its end, or that beyond it.
#[test]
fn crossings_at_the_end_of_a_curve_mark_it() {
    let theta = 0.3;
    let corners = [(-0.2, -0.1), (0.2, -0.1), (0.1, 0.3)];
    let moving = polygon("moving", &corners);
    // The lowest corner slides along the top; another meets the wall, which is a·p = reach.
    let a = Vector::from_angle(0.1);
    let turned = corners.map(|(x, y)| Rotation::by(theta) * Vector::new(x, y));
    let lowest = turned.iter().min_by(|v, w| v.y.total_cmp(&w.y)).unwrap();
    let furthest = turned.map(|v| a.dot(v)).into_iter().fold(0.0, f64::max);
    for (beyond, tied) in [
        (0.05, false),
        (1e-9, false),
        (1e-11, true),
        (0.0, true),
        (-1e-11, true),
        (-1e-9, false),
        (-0.05, false),
    ] {
        let end = Vector::new(1.0 + beyond, 1.0) - *lowest;
        let reach = a.dot(end) + furthest;
        let at = |y: f64| (reach - a.y * y) / a.x;
        let block = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let wall = [(at(-1.0), -1.0), (2.0, -1.0), (2.0, 1.8), (at(1.8), 1.8)];
        let fixed = Part::new("fixed", vec![corners_of(&block), corners_of(&wall)]).unwrap();
        let live = cut_at(&geometry(&fixed, &moving), theta);
        let count = live.iter().filter(|l| l.tied).count();
        // Both of them, and perhaps what follows around the end.
        assert_eq!(count > 0, tied, "{beyond}");
        assert!(count != 1, "{beyond}");
    }
}

/// Two discs that overlap by a little: the nearer to a tangency, the less their two crossings are known.
#[test]
fn curves_that_are_all_but_tangent_are_marked() {
    let disc = |x: f64, r: f64| vec![Vertex::new(x - r, 0.1, 1.0), Vertex::new(x + r, 0.1, 1.0)];
    let moving = Part::new("moving", vec![disc(0.0, 0.2)]).unwrap();
    for (overlap, tied) in [
        (0.1, false),
        (1e-4, false),
        (1e-9, false),
        (1e-12, true),
        (-1e-4, false),
    ] {
        // Round the moving disc goes at 0.5 from the centre of either; the sides of neither are near.
        let fixed = vec![
            disc(-0.5 + 0.5 * overlap, 0.3),
            disc(0.5 - 0.5 * overlap, 0.3),
        ];
        let fixed = Part::new("fixed", fixed).unwrap();
        // The joints of the halves are aside from where they cross.
        let live = cut_at(&geometry(&fixed, &moving), 0.5 * PI - 0.2);
        assert_eq!(live.iter().any(|l| l.tied), tied, "{overlap}");
        let cuts: usize = live.iter().map(|l| l.cuts.len()).sum();
        assert_eq!(cuts, if overlap > 0.0 { 4 } else { 0 }, "{overlap}");
    }
}

#[test]
fn orientations_at_which_curves_begin_or_end_are_told() {
    let fixed = polygon(
        "fixed",
        &[(-1.0, -0.9), (1.1, -1.0), (0.9, 1.0), (-0.8, 0.7)],
    );
    let moving = polygon("moving", &[(-0.2, -0.1), (0.2, -0.1), (0.1, 0.3)]);
    let geometry = geometry(&fixed, &moving);
    let all = &geometry.contacts.sheets;
    let told =
        |theta: f64| live_curves(&geometry, 0..all.len() as u32, theta, Rotation::by(theta)).2;
    let span = geometry.contacts.span;
    let mut ends: Vec<f64> = all.iter().flat_map(|s| [s.lo, s.hi]).collect();
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    assert!(ends.len() > 10);
    for pair in ends.windows(2) {
        assert!(!told(0.5 * (pair[0] + pair[1])));
        for theta in [pair[0], pair[0] - 1e-15, pair[0] + 1e-15] {
            // Where the turn is cut nothing begins.
            let within = span.lo + 1e-9 < theta && theta < span.hi - 1e-9;
            assert_eq!(told(theta), within, "{theta}");
        }
        assert!(!told(pair[0] + 1e-12));
    }
}

/// Of one curve: where it begins and ends is told, unless the turn is cut there; and there the lower end belongs to it.
#[test]
fn a_curve_alone_tells_where_it_begins_and_ends() {
    let fixed = polygon(
        "fixed",
        &[(-1.0, -0.9), (1.1, -1.0), (0.9, 1.0), (-0.8, 0.7)],
    );
    let moving = polygon("moving", &[(-0.2, -0.1), (0.2, -0.1), (0.1, 0.3)]);
    // The whole turn, and a window some thousand turns away, where orientations are known to less.
    let far = 1000.0 * PI;
    for window in [None, Some((far - 2.0, far + 2.0))] {
        let geometry = Geometry::new(&fixed, &moving, window, usize::MAX);
        let span = geometry.contacts.span;
        let (mut inner, mut wrapped) = (0, 0);
        for (i, s) in (0..).zip(&geometry.contacts.sheets) {
            let of = |theta: f64| {
                let (live, _, told) = live_curves(&geometry, i..i + 1, theta, Rotation::by(theta));
                (live.len(), told)
            };
            let length = s.hi - s.lo;
            assert!(!of(s.lo + 0.3 * length).1 && of(s.lo - 1e-9) == (0, false));
            let rounding = 2e-15 * s.lo.abs().max(1.0);
            for end in [s.lo, s.hi] {
                let cut = window.is_none() && (end == span.lo || end == span.hi);
                *(if cut { &mut wrapped } else { &mut inner }) += 1;
                for off in [-rounding, 0.0, rounding] {
                    assert_eq!(of(end + off).1, !cut, "{i} {end} {off}");
                }
                assert!(!of(end + 1e-9).1 && !of(end - 1e-9).1, "{i} {end}");
            }
            assert_eq!(of(s.hi).0, 0);
            if window.is_none() && s.lo == span.lo {
                assert_eq!(of(s.lo).0, of(s.lo + 1e-9).0);
                wrapped += of(s.lo).0;
            }
        }
        assert!(inner > 10 && (wrapped > 0) == window.is_none());
    }
}

/// Both bottom corners of a block in a flat valley, each on its side of it: the flatter it is, the less is known where their
/// curves cross.
#[test]
fn flat_crossings_are_known_to_less() {
    let moving = polygon("moving", &[(-0.2, -0.1), (0.2, -0.1), (0.1, 0.3)]);
    for rise in [0.3, 1e-2, 1e-4] {
        let valley = [
            (-1.0, -1.0),
            (1.0, -1.0),
            (1.0, rise),
            (0.0, 0.0),
            (-1.0, rise),
        ];
        let live = cut_at(&geometry(&polygon("valley", &valley), &moving), 0.0);
        let angle = 2.0 * f64::atan(rise);
        let lowest = (live.iter().enumerate())
            .flat_map(|(i, l)| l.cuts.iter().map(move |c| (i, c)))
            .find(|&(i, c)| live[i].curve.point(c.position).x.abs() < 1e-9)
            .unwrap()
            .1;
        // Across, a rounding is that much longer along.
        let along = ROUNDING / angle.sin();
        let bounds = along.max(TIED)..2.0 * along.max(TIED);
        assert!(bounds.contains(&lowest.error), "{rise}");
    }
}
