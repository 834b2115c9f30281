//! Words for angles, lengths and counts.

use std::sync::atomic::{AtomicUsize, Ordering};

use cspace::Coordinates;
use cspace_model::shown;

/// Words for parts that touch, and whose contact space has no room there.
pub(crate) const EXACT_FIT: &str = "exact-fit: the parts touch, and have no room to move";

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

/// Digits of a length after the point: six, more in a model whose parts are small in its unit, and fewer where they are large.
static DIGITS: AtomicUsize = AtomicUsize::new(USUAL_DIGITS);
const USUAL_DIGITS: usize = 6;

/// Lengths are told to a millionth of parts of this size, or of a tenth of the unit where that is larger; of large parts to 10⁻¹⁰ of their
/// size, which is more than the resolution of their space and what their growth moves.
pub(crate) fn tell_lengths_of(size: f64) {
    /// The sizes between which six digits do.
    const USUAL: [f64; 2] = [0.1, 1e4];
    /// No length has more.
    const MOST: usize = 18;
    if !(size > 0.0 && size.is_finite()) {
        return;
    }
    let more = (USUAL[0] / size).log10().ceil().max(0.0) as usize;
    let fewer = (size / USUAL[1]).log10().ceil().max(0.0) as usize;
    let digits = (USUAL_DIGITS + more).saturating_sub(fewer).min(MOST);
    DIGITS.store(digits, Ordering::Relaxed);
}

/// A length, or a coordinate, to as many digits after the point as [`tell_lengths_of`] asks for.
pub(crate) fn length(x: f64) -> String {
    decimals(x, DIGITS.load(Ordering::Relaxed))
}

/// Digits after the point of numbers that are told beside each other, the largest of them with seven digits.
pub(crate) fn digits_beside(largest: f64) -> usize {
    /// Digits after the first, and most digits after the point.
    const DIGITS: [i32; 2] = [6, 17];
    let lead = match largest {
        0.0 => 0,
        largest => largest.abs().log10().floor() as i32,
    };
    (DIGITS[0] - lead).clamp(0, DIGITS[1]) as usize
}

/// A number with so many digits after the point.
pub(crate) fn decimals(x: f64, digits: usize) -> String {
    zero_without_sign(&format!("{:.digits$}", shown::number(x))).to_owned()
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
