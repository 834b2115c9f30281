//! Slips: statements in a model that are allowed, but most likely not meant.

use core::f64::consts::TAU;

use cspace::{Axis, AxisMotion, Edge, Part, Relation, Vector};

use crate::mechanism::{Mechanism, PartEntry};
use crate::shown;

/// Something in a model that is most likely a slip.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slip {
    /// The part, loop and vertex, or the pair.
    pub place: String,
    /// Description of the slip.
    pub message: String,
    /// Advice on how to correct it.
    pub help: String,
}

/// Largest difference (radians) of two directions that are meant to be equal: a thousandth of a radian is less than any
/// intended corner, and more than the error of three digits in a drawing.
const NEARLY_TANGENT: f64 = 1e-3;

/// Largest difference (radians) of two directions that are equal in the computation as well.
const TANGENT: f64 = 1.0 / (1_u64 << 26) as f64;

/// A bulge beyond this with so few decimals is rarely that of an arc, which would turn by more than 4 atan 2 ≈ 254°: it
/// is more likely a radius or a height.
const LARGE_BULGE: f64 = 2.0;
const DIGITS: f64 = 1000.0;

/// Ratio of the sizes of two parts beyond which they are rarely drawn in one unit.
const UNLIKE_SIZES: f64 = 1000.0;

/// Finds statements in a model that are most likely not meant.
///
/// - An angle of more than a turn that is a whole number of radians: degrees without `deg`.
/// - A line and an arc that meet with directions that miss each other by less than 0.001 rad.
/// - A bulge beyond 2 with few digits.
/// - Of parts on axes, one that lies in the material of the other at zero motion.
/// - Two parts of which one is a thousand times as large as the other.
///
/// ```
/// let text = r#"
/// [[part]]
/// name = "arm"
/// loops = [[[0, 0], [4, 0], [4, 1], [0, 1]]]
/// motion = { type = "revolute", center = [0, 0], range = [-90, 90] }
/// "#;
/// let model = cspace_model::model::from_toml(text, "arm.toml")?;
/// let slips = cspace_model::model::slips(&model);
/// assert_eq!(slips[0].to_string(), "part 0 \"arm\", motion: the range is from -90 to 90 radians, more than a turn");
/// assert_eq!(slips[0].help, "for degrees write \"-90deg\" and \"90deg\"");
/// # Ok::<(), cspace_model::ModelError>(())
/// ```
pub fn slips(mechanism: &Mechanism) -> Vec<Slip> {
    let mut found = Vec::new();
    for (i, entry) in mechanism.parts.iter().enumerate() {
        let part = format!("part {i} {}", shown::quoted(entry.part.name()));
        range(entry.axis, &part, &mut found);
        outline(&entry.part, &part, &mut found);
    }
    for pair in &mechanism.pairs {
        let [a, b] = [pair.fixed, pair.moving].map(|i| &mechanism.parts[i]);
        // Parts that move freely are drawn anywhere, and those of a joint lie on each other.
        let assembled = matches!(mechanism.relation(pair), Relation::Axes { .. });
        two(a, b, assembled, &mut found);
    }
    found
}

impl core::fmt::Display for Slip {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{}: {}", self.place, self.message)
    }
}

/// Whether an angle was most likely written in degrees without their unit.
fn is_degrees(angle: f64) -> bool {
    angle.abs() > TAU && angle.fract() == 0.0
}

fn range(axis: Option<Axis>, part: &str, found: &mut Vec<Slip>) {
    if let Some(Axis {
        motion: AxisMotion::Revolute { .. },
        range: Some((lo, hi)),
    }) = axis
        && (is_degrees(lo) || is_degrees(hi))
    {
        found.push(Slip {
            place: format!("{part}, motion"),
            message: format!("the range is from {lo} to {hi} radians, more than a turn"),
            help: format!("for degrees write \"{lo}deg\" and \"{hi}deg\""),
        });
    }
}

/// The angle between two directions, radians.
fn turn(d: Vector, e: Vector) -> f64 {
    d.cross(e).atan2(d.dot(e)).abs()
}

/// Whether two directions are most likely meant to be equal, and are not.
pub(super) fn is_nearly_tangent(d: Vector, e: Vector) -> bool {
    (TANGENT..NEARLY_TANGENT).contains(&turn(d, e))
}

fn outline(part: &Part, name: &str, found: &mut Vec<Slip>) {
    for (l, outline) in part.loops().iter().enumerate() {
        for (v, vertex) in outline.vertices().iter().enumerate() {
            if vertex.bulge.abs() > LARGE_BULGE && (DIGITS * vertex.bulge).fract() == 0.0 {
                let sweep = 4.0 * vertex.bulge.atan().to_degrees();
                found.push(Slip {
                    place: format!("{name}, loop {l}, vertex {v}"),
                    message: format!(
                        "the bulge {} is an arc of {sweep:.1} degrees",
                        shown::number(vertex.bulge)
                    ),
                    help: "a bulge is the tangent of a quarter of the arc's angle, not its radius or height; draw large arcs in two pieces".into(),
                });
            }
        }
        let edges: Vec<Edge> = outline.edges().collect();
        let next = edges.iter().cycle().skip(1);
        for (before, after) in edges.iter().zip(next) {
            let (d, e) = (before.end_direction(), after.start_direction());
            let mixed = before.is_line() != after.is_line();
            if mixed && is_nearly_tangent(d, e) {
                let turn = turn(d, e);
                let vertex = outline.start_of(after.index);
                found.push(Slip {
                    place: format!("{name}, loop {l}, vertex {vertex}"),
                    message: format!("a line and an arc miss tangency by {turn:.1e} rad"),
                    help: "give more digits, draw the arc as { fillet = r }, or let --snap make it tangent".into(),
                });
            }
        }
    }
}

fn two(a: &PartEntry, b: &PartEntry, assembled: bool, found: &mut Vec<Slip>) {
    let place = format!(
        "parts {} and {}",
        shown::quoted(a.part.name()),
        shown::quoted(b.part.name())
    );
    let (small, large) = if a.part.size() < b.part.size() {
        (a, b)
    } else {
        (b, a)
    };
    let ratio = large.part.size() / small.part.size();
    if ratio > UNLIKE_SIZES {
        found.push(Slip {
            place: place.clone(),
            message: format!("one is {ratio:.0} times as large as the other"),
            help: "draw both in one unit of length".into(),
        });
    } else if assembled
        && (large.part.meeting(&small.part).iter()).any(|(large, small)| encloses(large, small))
    {
        found.push(Slip {
            place,
            message: format!(
                "{} lies in the material of {} as drawn",
                shown::quoted(small.part.name()),
                shown::quoted(large.part.name())
            ),
            help: "give the larger part a second loop where its hole is, or draw the smaller one elsewhere".into(),
        });
    }
}

/// Whether a part lies in another's material at zero motion: all its vertices do, and no edges come between.
fn encloses(large: &Part, small: &Part) -> bool {
    let (outer, inner) = (large.bounds(), small.bounds());
    let within = outer.min.x < inner.min.x
        && outer.min.y < inner.min.y
        && outer.max.x > inner.max.x
        && outer.max.y > inner.max.y;
    within
        && small
            .loops()
            .iter()
            .flat_map(|l| l.vertices())
            .all(|v| large.contains(v.point()))
        && !large
            .loops()
            .iter()
            .flat_map(|l| l.vertices())
            .any(|v| small.contains(v.point()))
}
