//! Words for angles, lengths and counts.

use cspace::Coordinates;
use cspace_io::shown;

/// `1 patch`, `2 patches`.
pub(crate) fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

/// An angle in radians with degrees after it.
pub(crate) fn angle(radians: f64) -> String {
    format!(
        "{:.6} rad ({:.4} deg)",
        shown::number(radians),
        shown::number(radians.to_degrees())
    )
}

/// An angle in degrees.
pub(crate) fn degrees(radians: f64) -> String {
    let shown = format!("{:.4}", shown::number(radians.to_degrees()));
    format!("{} deg", zero_without_sign(&shown))
}

/// A length, or a coordinate, to six digits after the point.
pub(crate) fn length(x: f64) -> String {
    zero_without_sign(&format!("{:.6}", shown::number(x))).to_owned()
}

/// A number of which nothing but a sign is left is shown without it.
fn zero_without_sign(shown: &str) -> &str {
    match shown.strip_prefix('-') {
        Some(digits) if digits.bytes().all(|b| matches!(b, b'0' | b'.')) => digits,
        _ => shown,
    }
}

/// The rotational symmetry of a part, by its fold about its own centre, and whether every rotation maps it to itself.
pub(crate) fn symmetry(fold: u32, is_round: bool) -> String {
    match fold {
        // Its fold is that of the arcs it is drawn with, and says nothing.
        _ if is_round => "round".to_owned(),
        0 | 1 => "none".to_owned(),
        fold => format!("{fold}-fold"),
    }
}

/// The point that the legs of a path of a planar part are about, if the part turns and it is not the origin.
pub(crate) fn about_point(
    path: &[Coordinates],
    about: Option<[f64; 2]>,
    unit: &str,
) -> Option<String> {
    let angle = |at: &Coordinates| match at {
        Coordinates::Planar(c) => c.theta,
        Coordinates::Axes { .. } => 0.0,
    };
    let turns = path.windows(2).any(|leg| angle(&leg[0]) != angle(&leg[1]));
    let [x, y] = about.filter(|&about| turns && about != [0.0; 2])?;
    Some(format!("x {}, y {}{unit}", length(x), length(y)))
}
