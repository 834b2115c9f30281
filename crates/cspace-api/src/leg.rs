//! Descriptions of the legs of a path in words.

use core::f64::consts::TAU;

use cspace::{AxisMotion, Coordinates, Vector};
use cspace_plan::legs::Scene;

use crate::rounded::rounded;

/// Describes each leg of a path: "up 6 mm", "left 2.5 mm", "turn 90° clockwise", "6.1 mm towards 32.5° while turning 12°
/// counter-clockwise". Directions are those of the fixed part's frame: x is right, y is up. Of parts on axes "u by +30°, v by −2.5 mm".
/// Without a unit lengths are numbers.
///
/// ```
/// use cspace::{Configuration, Coordinates, Part};
/// use cspace_plan::legs::Scene;
/// let disc = |name| Part::circle(name, (0.0, 0.0), 1.0);
/// let scene = Scene::new(&disc("table")?, &disc("coin")?, None);
/// let at = |x, y, theta| Coordinates::Planar(Configuration::new(x, y, theta));
/// let legs = cspace_api::legs_in_words(&scene, &[at(4.0, 0.0, 0.0), at(4.0, 2.5, 0.0), at(4.0, 2.5, 1.0)], Some("mm"));
/// assert_eq!(legs, ["up 2.5 mm", "turn 57.3\u{b0} counter-clockwise"]);
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn legs_in_words(scene: &Scene, path: &[Coordinates], unit: Option<&str>) -> Vec<String> {
    let unit = unit.map_or(String::new(), |u| format!(" {u}"));
    let places: Vec<_> = (path.iter().filter_map(|&at| scene.numbers(at).ok())).collect();
    (places.windows(2))
        .map(|leg| {
            let by: [f64; 3] = core::array::from_fn(|k| leg[1][k] - leg[0][k]);
            match scene.motions() {
                None => planar(by, scene.size(), &unit),
                Some((u, v)) => on_axes([(u, "u", by[0]), (v, "v", by[1])], &unit),
            }
        })
        .collect()
}

/// Motions of less than this share of the parts' size are rounding.
const NOTHING: f64 = 1e-9;
/// Directions this near to that of an axis are it, radians.
const ALONG: f64 = 1e-6;

fn planar([x, y, turn]: [f64; 3], size: f64, unit: &str) -> String {
    let way = Vector::new(x, y);
    let length = way.length();
    let moves = (length > NOTHING * size).then(|| moved(way, length, unit));
    let turns = (turn.abs() > NOTHING).then_some(turn);
    match (moves, turns) {
        (None, None) => "stay".to_owned(),
        (Some(moves), None) => moves,
        (None, Some(turn)) => format!("turn {}", turned(turn)),
        (Some(moves), Some(turn)) => format!("{moves} while turning {}", turned(turn)),
    }
}

fn moved(way: Vector, length: f64, unit: &str) -> String {
    let long = format!("{}{unit}", rounded(length));
    let names = [
        (1.0, 0.0, "right"),
        (0.0, 1.0, "up"),
        (-1.0, 0.0, "left"),
        (0.0, -1.0, "down"),
    ];
    let along = names.iter().find(|(x, y, _)| {
        let axis = Vector::new(*x, *y);
        axis.dot(way) > 0.0 && axis.cross(way).abs() < ALONG * length
    });
    match along {
        Some((_, _, name)) => format!("{name} {long}"),
        None => {
            let angle = way.angle().rem_euclid(TAU);
            format!("{long} towards {}\u{b0}", rounded(angle.to_degrees()))
        }
    }
}

fn turned(turn: f64) -> String {
    let angle = rounded(turn.to_degrees().abs());
    let way = if turn > 0.0 {
        "counter-clockwise"
    } else {
        "clockwise"
    };
    format!("{angle}\u{b0} {way}")
}

fn on_axes(motions: [(AxisMotion, &str, f64); 2], unit: &str) -> String {
    let moved = motions
        .into_iter()
        .filter(|m| m.2 != 0.0)
        .map(|(motion, name, by)| {
            let sign = if by > 0.0 { "+" } else { "\u{2212}" };
            match motion {
                AxisMotion::Revolute { .. } => {
                    format!("{name} by {sign}{}\u{b0}", rounded(by.to_degrees().abs()))
                }
                _ => format!("{name} by {sign}{}{unit}", rounded(by.abs())),
            }
        });
    let all: Vec<String> = moved.collect();
    if all.is_empty() {
        return "stay".to_owned();
    }
    all.join(", ")
}

/// Describes the motion of a part on an axis: "turns +75° about (0, 40)", "slides 12 mm along (1, 0)". A part that slides
/// back does so along the opposite direction.
///
/// ```
/// use cspace::AxisMotion;
/// let door = AxisMotion::Revolute { center: (0.0, 40.0).into() };
/// assert_eq!(cspace_api::motion_in_words(door, -1.5, None), "turns \u{2212}85.94\u{b0} about (0, 40)");
/// let bolt = AxisMotion::Prismatic { direction: (2.0, 0.0).into() };
/// assert_eq!(cspace_api::motion_in_words(bolt, -12.0, Some("mm")), "slides 12 mm along (-1, 0)");
/// ```
pub fn motion_in_words(motion: AxisMotion, by: f64, unit: Option<&str>) -> String {
    let two = |x: f64, y: f64| format!("({}, {})", rounded(x), rounded(y));
    match motion {
        AxisMotion::Fixed => "stays".to_owned(),
        AxisMotion::Revolute { center } => {
            let sign = if by < 0.0 { "\u{2212}" } else { "+" };
            let angle = rounded(by.to_degrees().abs());
            format!(
                "turns {sign}{angle}\u{b0} about {}",
                two(center.x, center.y)
            )
        }
        AxisMotion::Prismatic { direction } => {
            let way = direction.unit() * by.signum();
            let unit = unit.map_or(String::new(), |u| format!(" {u}"));
            let far = rounded(by.abs());
            format!("slides {far}{unit} along {}", two(way.x, way.y))
        }
    }
}
