//! Sheets of small pairs, compared with their curves at several orientations.

use core::f64::consts::PI;

use super::super::carrier::SheetKind;
use super::*;
use crate::contact::{Curve, Geometry};
use crate::feature::FeatureKind;
use crate::feature::tolerance::SMALLEST_CIRCLE;
use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Part, Vertex};

/// A square turned by an angle, with corners rounded by tangent arcs.
fn rounded(name: &str, half: f64, radius: f64, turned: f64) -> Part {
    let turn = Rotation::by(turned);
    let outline = (0..4)
        .flat_map(|k| {
            let side = Rotation::by(f64::from(k) * 0.5 * PI);
            let inner = half - radius;
            // The arc about the corner's centre from the right to the top.
            [(half, inner, (PI / 8.0).tan()), (inner, half, 0.0)].map(|(x, y, bulge)| {
                let p = turn * (side * Point::new(x, y));
                Vertex::new(p.x, p.y, bulge)
            })
        })
        .collect();
    Part::new(name, vec![outline]).unwrap()
}

fn curve(sheet: &Sheet, theta: f64) -> Curve {
    sheet.curve(theta, Rotation::by(theta))
}

/// Whether one curve continues the other without a bend.
fn goes_on(before: &Curve, after: &Curve) -> bool {
    let bend = before.normal(before.end) - after.normal(after.start);
    before.end.distance(after.start) < 1e-12 && bend.length() < 1e-12
}

/// Between a line of one part and one of the other, against rounded corners, there is a circle at all orientations at which both exist, or
/// at some, or at none.
#[test]
fn lines_are_bridged_if_a_circle_is_always_between() {
    let geometry = Geometry::new(
        &rounded("fixed", 1.0, 0.3, 0.0),
        &rounded("moving", 0.4, 0.1, 0.2),
        None,
        usize::MAX,
    );
    let contacts = &geometry.contacts;
    let sheets = &contacts.sheets;
    let (mut bridged, mut at_times, mut never) = (0, 0, 0);
    for f in sheets
        .iter()
        .filter(|s| s.locus.carrier.kind == SheetKind::LineRound)
    {
        for g in sheets
            .iter()
            .filter(|s| s.locus.carrier.kind == SheetKind::RoundLine)
        {
            let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
            if hi - lo < 1e-3 {
                continue;
            }
            let at = [0.01, 0.3, 0.6, 0.99].map(|s| lo + s * (hi - lo));
            let between = at.map(|theta| {
                let (a, b) = (curve(f, theta), curve(g, theta));
                sheets.iter().any(|c| {
                    let there = c.is_circle() && c.lo < theta && theta < c.hi;
                    let c = curve(c, theta);
                    let way = |a: &Curve, b: &Curve| goes_on(a, &c) && goes_on(&c, b);
                    there && (way(&a, &b) || way(&b, &a))
                })
            });
            let always = between.iter().all(|&b| b);
            assert_eq!(contacts.bridged(f, g), always, "{f:?} {g:?}");
            assert_eq!(contacts.bridged(g, f), always, "{f:?} {g:?}");
            assert_eq!(contacts.may_cross(f, g), !always && !goes_on_ever(f, g, at));
            let some = between.iter().any(|&b| b);
            *(if always {
                &mut bridged
            } else if some {
                &mut at_times
            } else {
                &mut never
            }) += 1;
        }
    }
    assert!(bridged > 0 && never > 0, "{bridged} {at_times} {never}");
    // Pairs other than two lines of different kinds are not bridged.
    for f in sheets {
        let others = sheets.iter().filter(|g| {
            !f.is_line() || !g.is_line() || f.locus.carrier.kind == g.locus.carrier.kind
        });
        assert!(others.into_iter().all(|g| !contacts.bridged(f, g)), "{f:?}");
    }
}

/// Whether two curves follow each other smoothly.
fn goes_on_ever(f: &Sheet, g: &Sheet, at: [f64; 4]) -> bool {
    at.into_iter().any(|theta| {
        let (a, b) = (curve(f, theta), curve(g, theta));
        goes_on(&a, &b) || goes_on(&b, &a)
    })
}

/// Where two arcs follow each other, the circle of the first lies between a line and the circle of the second, which is a curve that must
/// be searched as any other.
#[test]
fn a_line_and_a_circle_are_not_bridged() {
    // Each corner is an eighth of a turn with one radius and then one with another.
    let (wide, tight) = (0.4, 0.2);
    let (mut at, mut way) = (Point::new(1.0, -0.3), Vector::new(0.0, 1.0));
    let mut outline = Vec::new();
    for _ in 0..4 {
        outline.push(Vertex::line(at.x, at.y));
        at += way;
        for radius in [wide, tight] {
            outline.push(Vertex::new(at.x, at.y, (PI / 16.0).tan()));
            let turned = Rotation::by(0.25 * PI) * way;
            at += (turned.right() - way.right()) * radius;
            way = turned;
        }
    }
    let fixed = Part::new("fixed", vec![outline]).unwrap();
    let moving = rounded("moving", 0.4, 0.1, 0.2);
    let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
    let contacts = &geometry.contacts;
    let mut between = 0;
    for f in contacts.sheets.iter().filter(|s| s.is_line()) {
        for g in contacts.sheets.iter().filter(|s| s.is_circle()) {
            let theta = 0.5 * (f.lo.max(g.lo) + f.hi.min(g.hi));
            if f.lo.max(g.lo) >= f.hi.min(g.hi) {
                continue;
            }
            let (a, b) = (curve(f, theta), curve(g, theta));
            between += usize::from(contacts.sheets.iter().any(|c| {
                let there = c.is_circle() && c.lo < theta && theta < c.hi;
                let c = curve(c, theta);
                there && goes_on(&a, &c) && goes_on(&c, &b)
            }));
            assert!(!contacts.bridged(f, g) && !contacts.bridged(g, f));
        }
    }
    assert!(between > 0);
}

/// Two parts with arcs of both kinds, small and large.
fn bulging() -> Geometry {
    let part = |name: &str, size: f64, bulges: [f64; 5]| {
        let corners = [
            (-1.0, -1.0),
            (1.0, -0.9),
            (1.1, 1.0),
            (0.3, 1.3),
            (-0.4, 1.2),
        ];
        let outline = corners
            .into_iter()
            .zip(bulges)
            .map(|((x, y), bulge)| Vertex::new(x * size, y * size, bulge))
            .collect();
        Part::new(name, vec![outline]).unwrap()
    };
    let fixed = part("fixed", 1.0, [4e-4, 0.3, 0.0, -2e-4, -0.4]);
    let moving = part("moving", 0.6, [2e-4, -0.2, 0.0, -1e-4, 0.25]);
    Geometry::new(&fixed, &moving, None, usize::MAX)
}

/// A line next to a concave arc is in its material.
#[test]
fn lines_touch_what_is_convex() {
    let geometry = bulging();
    let mut kinds = [0; 2];
    for s in geometry.contacts.sheets.iter().filter(|s| s.is_line()) {
        let (kind, round) = if s.locus.carrier.kind == SheetKind::LineRound {
            (0, &geometry.moving.features[s.moving as usize])
        } else {
            (1, &geometry.fixed.features[s.fixed as usize])
        };
        assert_ne!(round.name.kind, FeatureKind::ConcaveArc);
        kinds[kind] += 1;
    }
    assert!(kinds.into_iter().all(|n| n > 0));
}

/// Where two arcs touch, the distance of their centres is the sum of both radii, concave ones negative; and the curve's normal is that of
/// the fixed arc.
#[test]
fn centres_of_arcs_that_touch_are_their_radii_apart() {
    let geometry = bulging();
    let mut kinds = [0; 3];
    for s in geometry.contacts.sheets.iter().filter(|s| !s.is_line()) {
        let (a, b) = (
            &geometry.fixed.features[s.fixed as usize],
            &geometry.moving.features[s.moving as usize],
        );
        let theta = s.lo + 0.3 * (s.hi - s.lo);
        let c = curve(s, theta);
        let radius = a.radius + b.radius;
        for at in [-0.9, 0.0, 0.7] {
            let p = c.point(at * c.half);
            let center = p + (Rotation::by(theta) * b.center.to_vector());
            let apart = center - a.center;
            assert!((apart.length() - radius.abs()).abs() < 1e-9, "{a:?} {b:?}");
            let normal = apart.unit() * radius.signum();
            assert!((c.normal(p) - normal).length() < 1e-9, "{a:?} {b:?}");
        }
        if !a.is_vertex() && !b.is_vertex() {
            kinds[usize::from(a.near.is_some()) + usize::from(b.near.is_some())] += 1;
        }
    }
    assert!(kinds.into_iter().all(|n| n > 0), "{kinds:?}");
}

/// An arc in a fillet moves on a circle if it has play there, however little, and has no contact if it is too large.
#[test]
fn arcs_with_play_go_around_a_circle() {
    /// Much more than growth and perturbation.
    const LIMIT: f64 = SMALLEST_CIRCLE;
    for (radius, sweep) in [(0.5, 1.5), (0.5, 0.95 * PI)] {
        for play in [-10.0, -0.5, 0.5, 10.0] {
            let half = |r: f64| r * f64::sin(0.5 * sweep);
            let bulge = f64::tan(0.25 * sweep);
            let (outer, inner) = (half(radius), half(radius - 2.0 * play * LIMIT));
            let fixed = [
                (-1.0, -1.0, 0.0),
                (1.0, -1.0, 0.0),
                (1.0, -outer, -bulge),
                (1.0, outer, 0.0),
                (1.0, 1.0, 0.0),
                (-1.0, 1.0, 0.0),
            ];
            let moving = [(0.0, -inner, bulge), (0.0, inner, 0.0), (-0.6, 0.1, 0.0)];
            let part = |name: &str, corners: &[(f64, f64, f64)]| {
                let of = |&(x, y, b): &(f64, f64, f64)| Vertex::new(x, y, b);
                Part::new(name, vec![corners.iter().map(of).collect()]).unwrap()
            };
            let (fixed, moving) = (part("fixed", &fixed), part("moving", &moving));
            let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
            let contacts = &geometry.contacts;
            let of = |o: &Outline, kind| {
                let found = o.features.iter().position(|f| f.name.kind == kind);
                found.unwrap() as u32
            };
            let ia = of(&geometry.fixed, FeatureKind::ConcaveArc);
            let ib = of(&geometry.moving, FeatureKind::ConvexArc);
            let (a, b) = (
                &geometry.fixed.features[ia as usize],
                &geometry.moving.features[ib as usize],
            );
            // The pair is drawn at half the size, and grown a little.
            let less = -(a.radius + b.radius);
            assert!((less / LIMIT - play).abs() < 0.3, "{} {play}", less / LIMIT);
            let circles = contacts.sheets.iter();
            let circles = circles.filter(|s| (s.fixed, s.moving) == (ia, ib)).count();
            assert_eq!(circles > 0, play > 0.0, "{radius} {sweep} {play}");
        }
    }
}

/// For every curve of a pair: points on the curve are in its box, and those of a flat arc are no farther from the chord than its sheet
/// states; nor is the box of a flat arc much too large.
#[test]
fn curves_are_in_their_boxes() {
    let geometry = bulging();
    let mut flat_arcs = 0;
    for s in &geometry.contacts.sheets {
        let c = curve(s, s.lo + 0.3 * (s.hi - s.lo));
        let (lo, hi) = (c.bounds().min, c.bounds().max);
        let chord = (c.end - c.start).unit();
        let (mut off, mut inside) = (0.0_f64, f64::INFINITY);
        for k in -50..=50 {
            let p = c.point(c.half * f64::from(k) / 50.0);
            off = off.max(chord.cross(p - c.start).abs());
            for room in [p.x - lo.x, hi.x - p.x, p.y - lo.y, hi.y - p.y] {
                assert!(room > -1e-13, "{c:?} {room}");
                inside = inside.min(room);
            }
        }
        if s.is_flat_arc() {
            flat_arcs += 1;
            assert!(off <= s.height() + 1e-14, "{off} {}", s.height());
            assert!(inside <= 2.0 * off + 1e-13, "{off} {inside}");
        }
    }
    assert!(flat_arcs > 20, "{flat_arcs}");
}
