//! Pairs of parts on fixed axes.

use core::f64::consts::{PI, TAU};

use cspace::{Axis, AxisMotion, Part, Point, Vector};
use rand::Rng;

use super::basic::{circle, rectangle, regular_polygon, square};
use super::fits::{peg, slotted_block};
use super::gear::{gear, pawl, rack, ratchet};
use super::pen::{Pen, bulge_of, bulge_through, circle_loop, part, polar, rectangle_loop};
use super::transform::{shifted, turned};

/// Two parts, drawn in the assembly's frame, and their axes.
#[derive(Debug, Clone)]
pub struct Mechanism {
    /// Name of the mechanism.
    pub name: String,
    /// The part whose coordinate is u.
    pub fixed: Part,
    /// Axis of this part.
    pub fixed_axis: Axis,
    /// The part whose coordinate is v.
    pub moving: Part,
    /// Axis of this part.
    pub moving_axis: Axis,
}

impl Mechanism {
    /// Random coordinates (u, v): within their ranges, a turn in either direction, or as far as parts of this size may
    /// meet.
    pub fn somewhere(&self, size: f64, rng: &mut impl Rng) -> (f64, f64) {
        let mut coordinate = |axis: &Axis| match (axis.motion, axis.range) {
            (AxisMotion::Fixed, _) => 0.0,
            (_, Some((lo, hi))) => rng.random_range(lo..hi),
            (AxisMotion::Revolute { .. }, None) => rng.random_range(-TAU..TAU),
            (AxisMotion::Prismatic { .. }, None) => size * rng.random_range(-1.5..1.5),
        };
        (coordinate(&self.fixed_axis), coordinate(&self.moving_axis))
    }
}

const O: Point = Point::ORIGIN;

fn mechanism(name: &str, a: Part, fixed_axis: Axis, b: Part, moving_axis: Axis) -> Mechanism {
    Mechanism {
        name: name.into(),
        fixed: a,
        fixed_axis,
        moving: b,
        moving_axis,
    }
}

/// An axis that turns about a point of the first axis.
fn about(x: f64) -> Axis {
    Axis::revolute(Point::new(x, 0.0))
}

fn along(x: f64, y: f64) -> Axis {
    Axis::prismatic(Vector::new(x, y))
}

/// Two gears in mesh, their pivots apart by half the sum of the teeth times the module and a little more.
pub fn gears(first: usize, second: usize) -> Mechanism {
    let apart = 0.5 * (first + second) as f64 + 0.05;
    mechanism(
        &format!("gears {first} and {second}"),
        gear(first, 1.0),
        about(0.0),
        shifted(&turned(&gear(second, 1.0), 0.3), apart, 0.0),
        about(apart),
    )
}

/// A cam about the origin: a circle of dwell, a rise to a smaller circle farther out, lines between, all smooth.
pub fn cam(base: f64, nose: f64, lift: f64) -> Part {
    // Two circles about (0, 0) and (lift, 0), joined by their outer tangents.
    let half = ((base - nose) / lift).acos();
    let at = |c: f64, r: f64, a: f64| polar(Point::new(c, 0.0), r, a);
    let [p, q, r, s] = [
        at(0.0, base, half),
        at(0.0, base, -half),
        at(lift, nose, -half),
        at(lift, nose, half),
    ];
    part(
        "cam",
        vec![
            Pen::at(p.x, p.y)
                .arc(q.x, q.y, bulge_of(TAU - 2.0 * half))
                .line(r.x, r.y)
                .arc(s.x, s.y, bulge_of(2.0 * half))
                .close(),
        ],
    )
}

/// A follower that comes down on a cam: flat, round or a knife, its lower end at (0, `height`).
fn follower(kind: &str, height: f64) -> Part {
    let h = height;
    let pen = match kind {
        "flat" => Pen::at(-1.5, h).line(1.5, h).line(1.5, h + 0.3),
        "round" => Pen::at(-0.4, h + 0.4)
            .arc(0.4, h + 0.4, 1.0)
            .line(0.4, h + 1.0),
        _ => Pen::at(-0.3, h + 0.5).line(0.0, h).line(0.3, h + 0.5),
    };
    let top = if kind == "flat" {
        (-1.5, h + 0.3)
    } else {
        (-0.4, h + 1.0)
    };
    let pen = if kind == "knife" {
        pen.line(0.3, h + 1.0).line(-0.3, h + 1.0)
    } else {
        pen.line(top.0, top.1)
    };
    part(format!("{kind} follower"), vec![pen.close()])
}

/// A wheel with `slots` radial slots about the origin, the first on the first axis, and a crank with one pin for it.
///
/// `play` is how much narrower than a slot the pin is, on both sides together.
pub fn geneva(slots: usize, play: f64) -> Mechanism {
    let half = PI / slots as f64;
    let apart = 4.0;
    let (crank, wheel) = (apart * half.sin(), apart * half.cos());
    let width = 0.5;
    let bottom = apart - crank - 0.5;
    let mut pen: Option<Pen> = None;
    for i in 0..slots {
        let angle = TAU * i as f64 / slots as f64;
        let side = (0.5 * width / wheel).asin();
        let along = (0.25 * width * width).mul_add(-1.0, wheel * wheel).sqrt();
        let local = |x: f64, y: f64| {
            let (s, c) = angle.sin_cos();
            Point::new(c * x - s * y, s * x + c * y)
        };
        let [p, q, r, s] = [
            local(along, -0.5 * width),
            local(bottom, -0.5 * width),
            local(bottom, 0.5 * width),
            local(along, 0.5 * width),
        ];
        let next = pen.take().map_or_else(
            || Pen::at(p.x, p.y),
            |pen| pen.arc(p.x, p.y, bulge_of(2.0 * half - 2.0 * side)),
        );
        pen = Some(next.line(q.x, q.y).arc(r.x, r.y, -1.0).line(s.x, s.y));
    }
    let side = (0.5 * width / wheel).asin();
    let wheel_part = pen.map_or_else(
        || square(1.0),
        |p| {
            part(
                "Geneva wheel",
                vec![p.close_arc(bulge_of(2.0 * half - 2.0 * side))],
            )
        },
    );
    let pin = circle_loop(Point::new(apart - crank, 0.0), 0.5 * (width - play));
    mechanism(
        &format!("Geneva wheel {slots}, play {play}"),
        wheel_part,
        about(0.0),
        part("crank pin", vec![pin]),
        about(apart),
    )
}

/// An escape wheel of `teeth` pointed teeth about the origin.
pub fn escape_wheel(teeth: usize) -> Part {
    let step = TAU / teeth as f64;
    let mut pen: Option<Pen> = None;
    for i in 0..teeth {
        let a = step * i as f64;
        let (root, tip) = (polar(O, 3.0, a), polar(O, 4.0, a + 0.35 * step));
        let next = pen
            .take()
            .map_or_else(|| Pen::at(root.x, root.y), |p| p.line(root.x, root.y));
        let back = polar(O, 3.0, a + 0.55 * step);
        pen = Some(next.line(tip.x, tip.y).line(back.x, back.y));
    }
    pen.map_or_else(|| square(1.0), |p| part("escape wheel", vec![p.close()]))
}

/// An anchor with two pallets about (0, 5.2), for an [`escape_wheel`].
pub fn anchor() -> Part {
    part(
        "anchor",
        vec![
            Pen::at(-3.0, 3.6)
                .line(-2.5, 2.7)
                .line(-2.2, 3.9)
                .through(Point::new(0.0, 4.6), Point::new(2.2, 3.9))
                .line(2.5, 2.7)
                .line(3.0, 3.6)
                .close_arc(bulge_through(
                    Point::new(3.0, 3.6),
                    Point::new(0.0, 5.5),
                    Point::new(-3.0, 3.6),
                )),
        ],
    )
}

/// Mechanisms for tests.
pub fn mechanisms() -> Vec<Mechanism> {
    let mut all = vec![
        mechanism(
            "squares that turn",
            square(2.0),
            about(0.0),
            shifted(&square(2.0), 2.2, 0.0),
            about(2.2),
        ),
        mechanism(
            "hexagon and triangle that turn",
            regular_polygon(6, 1.0),
            about(0.1),
            shifted(&regular_polygon(3, 1.0), 1.7, 0.0),
            about(1.6),
        ),
        mechanism(
            "disc off its axis and bar",
            circle(1.0),
            about(0.4),
            shifted(&rectangle(3.0, 0.4), 2.0, 0.0),
            about(2.5),
        ),
        gears(10, 9),
        gears(5, 7),
        {
            let m = gears(8, 8);
            Mechanism {
                name: "gears 8 with ranges".into(),
                fixed_axis: m.fixed_axis.within(-1.0, 2.0),
                moving_axis: m.moving_axis.within(-9.0, 4.0),
                ..m
            }
        },
        mechanism(
            "ratchet and pawl",
            ratchet(12),
            about(0.0),
            shifted(&turned(&pawl(), 2.2), 3.0, 1.0),
            Axis::revolute(Point::new(3.0, 1.0)),
        ),
        mechanism(
            "rack and pinion",
            gear(9, 1.0),
            about(0.0),
            shifted(&rack(5, 1.0), -6.0, -5.55),
            along(1.0, 0.0),
        ),
        mechanism(
            "pinion and rack",
            shifted(&rack(5, 1.0), -6.0, -5.55),
            along(2.0, 0.0),
            gear(9, 1.0),
            about(0.0),
        ),
        mechanism(
            "escapement",
            escape_wheel(12),
            about(0.0),
            anchor(),
            Axis::revolute(Point::new(0.0, 5.2)),
        ),
        geneva(4, 0.05),
        geneva(6, 0.0),
        mechanism(
            "wedges",
            part(
                "wedge",
                vec![Pen::at(0.0, 0.0).line(4.0, 0.0).line(4.0, 1.0).close()],
            ),
            along(1.0, 0.0),
            part(
                "block",
                vec![
                    Pen::at(1.0, 0.3)
                        .line(5.0, 1.3)
                        .line(5.0, 2.0)
                        .line(1.0, 2.0)
                        .close(),
                ],
            ),
            along(0.0, 1.0),
        ),
        mechanism(
            "blocks that slide",
            rectangle(2.0, 1.0),
            along(1.0, 0.0),
            shifted(&rectangle(1.0, 1.0), 0.5, 3.0),
            along(0.0, 1.0),
        ),
        mechanism(
            "blocks on one line",
            rectangle(2.0, 1.0),
            along(1.0, 0.0),
            shifted(&circle(0.7), 3.0, 0.4),
            along(-2.0, 0.0),
        ),
        mechanism(
            "discs that slide",
            circle(1.0),
            along(1.0, 0.3),
            shifted(&circle(0.7), 3.0, 0.4),
            along(-0.2, 1.0).within(-2.0, 1.5),
        ),
        mechanism(
            "peg and slot",
            slotted_block(3.0, 1.02, 1.0, 0.2),
            along(1.0, 0.0).within(-3.0, 3.0),
            shifted(&peg(1.0, 1.0), 0.0, 1.5),
            along(0.0, 1.0),
        ),
        mechanism(
            "peg and tight slot",
            slotted_block(3.0, 1.0, 1.0, 0.2),
            along(1.0, 0.0),
            shifted(&peg(1.0, 1.0), 0.0, 1.5),
            along(0.0, 1.0),
        ),
        mechanism(
            "concentric",
            part(
                "plate with window",
                vec![
                    rectangle_loop(Point::new(-3.0, -3.0), Point::new(3.0, 3.0)),
                    rectangle_loop(Point::new(-2.0, -1.5), Point::new(2.0, 1.5)),
                ],
            ),
            about(0.0),
            rectangle(2.5, 2.5),
            about(0.0),
        ),
        mechanism(
            "gear against a stop",
            gear(9, 1.0),
            about(0.0),
            shifted(&rectangle(1.0, 0.6), 4.6, 0.1),
            Axis::FIXED,
        ),
        mechanism(
            "a stop against a slider",
            rectangle(1.0, 0.6),
            Axis::FIXED,
            shifted(&circle(0.5), 3.0, 0.1),
            along(1.0, 0.0),
        ),
        mechanism(
            "never touching",
            square(1.0),
            about(0.0),
            shifted(&square(1.0), 5.0, 0.0),
            about(5.0),
        ),
        mechanism(
            "always blocked",
            square(3.0),
            about(0.0),
            shifted(&square(3.0), 1.0, 0.0),
            about(1.0),
        ),
    ];
    for kind in ["flat", "round", "knife"] {
        all.push(mechanism(
            &format!("cam and {kind} follower"),
            cam(1.0, 0.4, 1.2),
            about(0.0),
            follower(kind, 1.3),
            along(0.0, 1.0),
        ));
    }
    all.push(mechanism(
        "flat follower and cam",
        follower("flat", 1.3),
        along(0.0, 1.0),
        cam(1.0, 0.4, 1.2),
        about(0.0),
    ));
    all
}
