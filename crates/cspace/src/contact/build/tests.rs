//! Sheets of small pairs, against what their curves are at one orientation and another.

use super::*;
use crate::contact::{Curve, Geometry};
use crate::geometry::Rotation;
use crate::part::{Part, Vertex};

/// A square turned by an angle, with corners rounded by arcs that go on smoothly.
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

/// Whether one curve goes on into the other without a bend.
fn goes_on(before: &Curve, after: &Curve) -> bool {
    let bend = before.normal(before.end) - after.normal(after.start);
    before.end.distance(after.start) < 1e-12 && bend.length() < 1e-12
}

/// Between a line of one part and one of the other, against rounded corners, there is a circle at all orientations at
/// which both are there, or at some, or at none.
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
    for f in sheets.iter().filter(|s| s.kind == SheetKind::LineRound) {
        for g in sheets.iter().filter(|s| s.kind == SheetKind::RoundLine) {
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
    // What is not a line of either part is computed.
    for f in sheets {
        let others = sheets
            .iter()
            .filter(|g| !f.is_line() || !g.is_line() || f.kind == g.kind);
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

/// Where two arcs follow each other the circle of the first lies between a line and that of the second, which is a curve to
/// be computed as any other.
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
