//! What the legs of a path do, in words.

use core::f64::consts::TAU;

use cspace::{AxisMotion, Coordinates, Vector};
use cspace_plan::legs::Scene;

/// What each leg of a path does: "up 6", "left 2.5", "turn 90° clockwise", "6.1 towards 32.5° while turning 12° counter-clockwise".
/// Lengths are in the model's unit, directions in the fixed part's frame; x is right, y is up. Of parts on axes "u by 30°", "v by 2.5".
pub fn legs_in_words(scene: &Scene, path: &[Coordinates]) -> Vec<String> {
    let places: Vec<_> = (path.iter().filter_map(|&at| scene.numbers(at).ok())).collect();
    (places.windows(2))
        .map(|leg| {
            let by: [f64; 3] = core::array::from_fn(|k| leg[1][k] - leg[0][k]);
            match scene.motions() {
                None => planar(by, scene.size()),
                Some((u, v)) => on_axes([(u, "u", by[0]), (v, "v", by[1])]),
            }
        })
        .collect()
}

/// Motions of less than this share of the parts' size are rounding.
const NOTHING: f64 = 1e-9;
/// Directions this near to that of an axis are it, radians.
const ALONG: f64 = 1e-6;

fn planar([x, y, turn]: [f64; 3], size: f64) -> String {
    let way = Vector::new(x, y);
    let length = way.length();
    let moves = (length > NOTHING * size).then(|| moved(way, length));
    let turns = (turn.abs() > NOTHING).then_some(turn);
    match (moves, turns) {
        (None, None) => "stay".to_owned(),
        (Some(moves), None) => moves,
        (None, Some(turn)) => format!("turn {}", turned(turn)),
        (Some(moves), Some(turn)) => format!("{moves} while turning {}", turned(turn)),
    }
}

fn moved(way: Vector, length: f64) -> String {
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
        Some((_, _, name)) => format!("{name} {}", rounded(length)),
        None => {
            let angle = way.angle().rem_euclid(TAU);
            format!(
                "{} towards {}\u{b0}",
                rounded(length),
                rounded(angle.to_degrees())
            )
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

fn on_axes(motions: [(AxisMotion, &str, f64); 2]) -> String {
    let moved = motions
        .into_iter()
        .filter(|m| m.2 != 0.0)
        .map(|(motion, name, by)| {
            let sign = if by > 0.0 { "+" } else { "\u{2212}" };
            match motion {
                AxisMotion::Revolute { .. } => {
                    format!("{name} by {sign}{}\u{b0}", rounded(by.to_degrees().abs()))
                }
                _ => format!("{name} by {sign}{}", rounded(by.abs())),
            }
        });
    let all: Vec<String> = moved.collect();
    if all.is_empty() {
        return "stay".to_owned();
    }
    all.join(", ")
}

/// A number as it is said: four digits.
fn rounded(x: f64) -> String {
    let digits = if x == 0.0 {
        0
    } else {
        (3 - x.log10().floor() as i32).clamp(0, 12)
    };
    let text = format!("{x:.*}", digits as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
