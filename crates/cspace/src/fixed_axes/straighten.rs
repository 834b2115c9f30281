//! Arcs that are all but straight, taken for their chords.
//!
//! Where a line touches an arc of radius r, or a large arc another, the place is told by the angle between them, and so known
//! to some ε r, which is more than the arc is off its chord, b c / 2 for the bulge b and the chord c with r = c / 4b, if b² is
//! less than some ε.

use crate::part::{Part, Vertex};

/// Arcs with bulges below this, sweeps of less than 2·10⁻⁷ rad, are taken for lines: √(9 ε).
const STRAIGHT: f64 = 4.5e-8;

/// The part with such arcs straight, and how far that is from the part as drawn, in the model's unit of length. `None` if
/// there are no such arcs, or if nothing but them kept its loops apart.
pub(super) fn straightened(part: &Part) -> Option<(Part, f64)> {
    let is_straight = |bulge: f64| bulge != 0.0 && bulge.abs() < STRAIGHT;
    let deviation = (part.edges())
        .filter(|e| is_straight(e.bulge))
        .map(|e| 0.5 * e.bulge.abs() * e.start.distance(e.end))
        .reduce(f64::max)?;
    let vertex = |v: &Vertex| {
        let bulge = if is_straight(v.bulge) { 0.0 } else { v.bulge };
        Vertex::new(v.x, v.y, bulge)
    };
    let loops = part.loops().iter();
    let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
    let straight = Part::new(part.name(), loops.collect()).ok()?;
    Some((straight, deviation))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn only_arcs_that_rounding_makes_straight_are() {
        let part = |bulge: f64| {
            let corners = [(0.0, 0.0, bulge), (2.0, 0.0, 0.0), (1.0, 2.0, 0.0)];
            let corners = corners.map(|(x, y, b)| Vertex::new(x, y, b));
            Part::new("part", vec![corners.to_vec()]).unwrap()
        };
        assert!(straightened(&part(0.0)).is_none());
        assert!(straightened(&part(-1e-7)).is_none());
        let (straight, deviation) = straightened(&part(-1e-8)).unwrap();
        assert_eq!(straight, part(0.0));
        // The height of the arc above its chord.
        assert!((deviation - 1e-8).abs() < 1e-20);
    }
}
