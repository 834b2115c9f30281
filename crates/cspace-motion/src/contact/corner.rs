//! Pairs of contacts of which one suffices, because their features meet at a convex corner.
//!
//! ```text
//!            | box
//!   _________|____       The box has come to the seam of two tiles that are level. Its corner touches the top of the next
//!    tile    |           tile, and the side of it, which ends there. Two convex corners overlap only where all of their
//!            | next      contacts do: while the one with the top is not overlapping, the side is no obstacle.
//! ```

use cspace::{FeatureId, FeatureKind, FeatureName, Part};

use crate::pairs::{MovingPair, Touch};

/// Whether two contacts of a pair at one place are of one feature of each part, or of two features that meet at a
/// convex corner: then the parts are apart there if either contact is open.
pub(crate) fn one_is_enough(pair: &MovingPair, a: &Touch, b: &Touch) -> bool {
    let of = |part: &Part, a: FeatureId, b: FeatureId| is_convex(part, a.name, b.name);
    of(pair.space.fixed(), a.features.0, b.features.0)
        && of(pair.space.moving(), a.features.1, b.features.1)
}

/// Whether two features of a part are one, or meet at a convex corner and nowhere else.
fn is_convex(part: &Part, a: FeatureName, b: FeatureName) -> bool {
    if a.loop_index != b.loop_index {
        return false;
    }
    if a.index == b.index && a.kind == b.kind {
        return true;
    }
    let Some(of) = part.loops().get(a.loop_index as usize) else {
        return false;
    };
    let count = of.vertices().len() as u32;
    let next = |i: u32| (i + 1) % count;
    let is_vertex = |name: FeatureName| name.kind == FeatureKind::Vertex;
    // Vertices are features only where they are convex, and each begins the edge of its number.
    match (is_vertex(a), is_vertex(b)) {
        (true, true) => false,
        (true, false) => a.index == b.index || a.index == next(b.index),
        (false, true) => a.index == b.index || b.index == next(a.index),
        (false, false) => {
            let (before, after) = match (next(a.index) == b.index, next(b.index) == a.index) {
                (true, false) => (a, b),
                (false, true) => (b, a),
                _ => return false,
            };
            let edge = |name: FeatureName| of.edge(name.index as usize);
            let edges = edge(before).zip(edge(after));
            edges.is_some_and(|(before, after)| {
                let (before, after) = if of.is_reversed() {
                    (after, before)
                } else {
                    (before, after)
                };
                before.end_direction().cross(after.start_direction()) >= 0.0
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use cspace::Vertex;

    use super::*;

    fn edge(loop_index: u32, index: u32) -> FeatureName {
        FeatureName {
            loop_index,
            kind: FeatureKind::Line,
            index,
        }
    }

    /// An L around an L, each drawn in either direction: what is a convex corner of the outline is none of the hole.
    #[test]
    fn corners_are_convex_however_loops_are_drawn() {
        let ell = [(0., 0.), (9., 0.), (9., 4.), (4., 4.), (4., 9.), (0., 9.)];
        let loops = |backwards: [bool; 2]| {
            let drawn = |scale: f64, shift: f64, backwards: bool| {
                let mut all: Vec<Vertex> = (ell.iter())
                    .map(|&(x, y)| Vertex::line(scale * x + shift, scale * y + shift))
                    .collect();
                if backwards {
                    all.reverse();
                }
                all
            };
            vec![drawn(1.0, 0.0, backwards[0]), drawn(0.5, 1.0, backwards[1])]
        };
        for backwards in [[false, false], [false, true], [true, false], [true, true]] {
            let part = Part::new("ell", loops(backwards)).unwrap();
            for (k, backwards) in backwards.into_iter().enumerate() {
                for corner in 0..6 {
                    // The edges before and after the vertex of this number as listed above.
                    let (before, after) = match backwards {
                        false => ((corner + 5) % 6, corner),
                        true => (5 - corner, (10 - corner) % 6),
                    };
                    let k = k as u32;
                    let expected = (corner != 3) == (k == 0);
                    for (a, b) in [(before, after), (after, before)] {
                        let found = is_convex(&part, edge(k, a), edge(k, b));
                        assert_eq!(found, expected, "{backwards} {k} {corner}");
                    }
                }
            }
        }
    }
}
