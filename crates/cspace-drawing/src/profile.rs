//! Outlines whose edges are off along their normals, as deviations of form are.
//!
//! Every edge stays what it is: a line, or an arc about its centre. About a vertex, an edge of curvature k there (positive where it turns
//! left, material on the left) and outward unit normal n, which is off by d outward, is where
//!
//! ```text
//! n·x + k (|x|² − d²) / 2 = d.
//! ```
//!
//! The two of a corner give the new vertex x.

use core::fmt;

use cspace::part::PartFeature;
use cspace::{Edge, Part, Real, Vector, Vertex};

use crate::corner::{Level, meeting};

/// Two edges join smoothly where they turn by less (radians): they have no corner that both determine.
const SMOOTH: f64 = 1e-3;

/// Reason why an outline with offset edges does not exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileError {
    /// Edges that join smoothly are off by different distances.
    Smooth {
        /// Both.
        edges: [PartFeature; 2],
    },
    /// An edge vanishes: an arc whose radius becomes 0, or a line between corners that pass each other.
    Gone {
        /// The edge.
        edge: PartFeature,
    },
    /// Edges do not meet any more, or touch each other at a cusp.
    Apart {
        /// Both.
        edges: [PartFeature; 2],
    },
}

impl ProfileError {
    /// Advice on how to correct the error.
    pub fn help(&self) -> &'static str {
        match self {
            Self::Smooth { .. } => {
                "give both the same profile, or a corner of more than 0.06 degrees"
            }
            Self::Gone { .. } => "give a smaller profile, or a longer edge",
            Self::Apart { .. } => "give a smaller profile, or both edges the same",
        }
    }
}

impl fmt::Display for ProfileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Smooth { edges: [a, b] } => write!(
                f,
                "{a} and {b} join smoothly, and are off by different distances"
            ),
            Self::Gone { edge } => write!(f, "{edge} vanishes"),
            Self::Apart { edges: [a, b] } => write!(f, "{a} and {b} do not meet"),
        }
    }
}

impl core::error::Error for ProfileError {}

/// Loops of a part whose edges are each displaced along their normals, out of the material, by the distance `off`.
/// `loops` are those of the part, in any type of numbers; the result has as many vertices. Corners stay corners, unlike
/// those of [`offset`](crate::offset()).
///
/// ```
/// use cspace::Part;
/// let plate = Part::rectangle("plate", (0.0, 0.0), 4.0, 2.0)?;
/// let loops = [plate.loops()[0].vertices().to_vec()];
/// let larger = Part::new("plate", cspace_drawing::profile(&plate, &loops, |_| 0.1)?)?;
/// assert!((larger.area() - 4.2 * 2.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If an edge vanishes, or adjacent edges do not meet any more, or join smoothly and are displaced by different
/// distances. Whether the result meets itself elsewhere is checked by [`Part::new`].
pub fn profile<T: Real>(
    part: &Part,
    loops: &[Vec<Vertex<T>>],
    off: impl Fn(PartFeature) -> T,
) -> Result<Vec<Vec<Vertex<T>>>, ProfileError> {
    let each = part.loops().iter().zip(loops).zip(0u32..);
    each.map(|((of, vertices), loop_index)| {
        let name = |i: usize| PartFeature::Edge {
            loop_index,
            index: i as u32,
        };
        off_loop(vertices, of.is_reversed(), &name, &|i| off(name(i)))
    })
    .collect()
}

fn off_loop<T: Real>(
    vertices: &[Vertex<T>],
    reversed: bool,
    name: &dyn Fn(usize) -> PartFeature,
    off: &dyn Fn(usize) -> T,
) -> Result<Vec<Vertex<T>>, ProfileError> {
    let count = vertices.len();
    // In order of travel, each with the material on its left.
    let edges: Vec<(Edge<T>, T)> = (0..count)
        .map(|index| {
            let (here, next) = (vertices[index], vertices[(index + 1) % count]);
            let (start, end, bulge) = match reversed {
                false => (here, next, here.bulge),
                true => (next, here, -here.bulge),
            };
            let edge = Edge {
                start: start.point(),
                end: end.point(),
                bulge,
                index,
            };
            (edge, off(index))
        })
        .collect();
    let moves: Vec<Vector<T>> = (0..count)
        .map(|v| {
            let before = (v + count - 1) % count;
            let [arrives, leaves] = if reversed { [v, before] } else { [before, v] };
            corner(&edges[arrives], &edges[leaves], || {
                [name(arrives), name(leaves)]
            })
        })
        .collect::<Result<_, _>>()?;
    let mut drawn = Vec::with_capacity(count);
    for (i, (edge, by)) in edges.iter().enumerate() {
        let [from, to] = [moves[i], moves[(i + 1) % count]];
        let (start, end) = if reversed { (to, from) } else { (from, to) };
        let bulge = new_bulge(edge, *by, start, end).ok_or(ProfileError::Gone { edge: name(i) })?;
        let at = vertices[i].point() + from;
        drawn.push(Vertex::new(
            at.x,
            at.y,
            if reversed { -bulge } else { bulge },
        ));
    }
    Ok(drawn)
}

/// Displacement of the vertex between two adjacent edges.
fn corner<T: Real>(
    (arrives, d): &(Edge<T>, T),
    (leaves, e): &(Edge<T>, T),
    names: impl Fn() -> [PartFeature; 2],
) -> Result<Vector<T>, ProfileError> {
    let [n, m] = [arrives.end_direction(), leaves.start_direction()].map(outward);
    let turn = n.cross(m);
    if turn.value().abs() <= SMOOTH {
        if n.dot(m).value() < 0.0 {
            return Err(ProfileError::Apart { edges: names() });
        }
        return match d.value() == e.value() {
            true => Ok((n + m) * (*d / (T::constant(1.0) + n.dot(m)))),
            false => Err(ProfileError::Smooth { edges: names() }),
        };
    }
    let level = |edge: &Edge<T>, normal: Vector<T>, by: T| {
        let half = edge.curvature() * T::constant(0.5);
        Level {
            normal,
            off: by + half * by * by,
            bend: -half,
        }
    };
    meeting(level(arrives, n, *d), level(leaves, m, *e))
        .ok_or_else(|| ProfileError::Apart { edges: names() })
}

/// The bulge of an edge that is off by a distance, with its ends off by these; `None` if it vanishes.
fn new_bulge<T: Real>(edge: &Edge<T>, by: T, start: Vector<T>, end: Vector<T>) -> Option<T> {
    let one = T::constant(1.0);
    let (k, b) = (edge.curvature(), edge.bulge);
    // The normal turns with the point at which it is.
    let turned = |direction: Vector<T>, x: Vector<T>| {
        let n = outward(direction);
        (k * n.cross(x)).atan2(one + k * n.dot(x))
    };
    let more = turned(edge.end_direction(), end) - turned(edge.start_direction(), start);
    let t = (more * T::constant(0.25)).tan();
    let bulge = (b + t) / (one - b * t);
    let chord = (edge.end - edge.start).dot(edge.end + end - (edge.start + start));
    let is_line = b.value() == 0.0;
    let kept = if is_line {
        chord.value() > 0.0
    } else {
        bulge.value() * b.value() > 0.0 && (one + k * by).value() > 0.0
    };
    kept.then_some(bulge)
}

/// The normal out of the material, which is on the left.
fn outward<T: Real>(direction: Vector<T>) -> Vector<T> {
    -direction.left()
}

#[cfg(test)]
mod tests {
    use cspace::part::{Direction, OutlineBuilder};
    use cspace::{Dual, Part};

    use super::*;

    fn bracket() -> Part {
        // Lines, a convex and a concave arc with corners, and a rounded corner; a round hole and a square one, drawn either way.
        let outline = OutlineBuilder::start([0.0, 0.0])
            .line_to([6.0, 0.0])
            .fillet(0.5)
            .line_to([6.5, 4.0])
            .arc_to([3.0, 5.0], 0.3)
            .arc_to([0.5, 4.0], -0.2)
            .close();
        let hole = OutlineBuilder::start([2.0, 2.0])
            .arc_to_center([1.0, 2.0], [1.5, 2.0], Direction::Clockwise)
            .arc_to_center([2.0, 2.0], [1.5, 2.0], Direction::Clockwise)
            .close();
        let square = OutlineBuilder::start([3.0, 1.0])
            .line_to([4.0, 1.0])
            .line_to([4.0, 2.0])
            .line_to([3.0, 2.0])
            .close();
        let loops = [outline, hole, square].map(Result::unwrap).to_vec();
        Part::new("bracket", loops).unwrap()
    }

    fn loops<T: Real>(part: &Part) -> Vec<Vec<Vertex<T>>> {
        let of = |v: &Vertex| {
            let [x, y, bulge] = [v.x, v.y, v.bulge].map(T::constant);
            Vertex::new(x, y, bulge)
        };
        let each = part.loops().iter();
        each.map(|l| l.vertices().iter().map(of).collect())
            .collect()
    }

    #[test]
    fn every_edge_is_at_its_distance() {
        let part = bracket();
        for by in [0.05, -0.05, 0.2, -0.1] {
            let off = |f: PartFeature| match f {
                // The square hole's edges are off by distances of their own.
                PartFeature::Edge {
                    loop_index: 2,
                    index,
                } => by * f64::from(index),
                _ => by,
            };
            let off_part = Part::new("off", profile(&part, &loops(&part), off).unwrap()).unwrap();
            for (l, (of, from)) in (0u32..).zip(off_part.loops().iter().zip(part.loops())) {
                for (edge, before) in of.edges().zip(from.edges()) {
                    assert_eq!(edge.index, before.index);
                    let d = off(PartFeature::Edge {
                        loop_index: l,
                        index: edge.index as u32,
                    });
                    if before.is_line() {
                        let n = outward(before.start_direction());
                        for p in [edge.start, edge.end] {
                            assert!((n.dot(p - before.start) - d).abs() < 1e-12);
                        }
                    } else {
                        let r = before.radius() + d * before.bulge.signum();
                        assert!((edge.radius() - r).abs() < 1e-11, "{l} {before:?}");
                        assert!(edge.center().distance(before.center()) < 1e-11);
                    }
                }
            }
        }
    }

    #[test]
    fn derivatives_are_differences() {
        let part = bracket();
        let step = 1e-6;
        for by in [0.0, 0.1] {
            let there = |d: f64| profile(&part, &loops(&part), |_| d).unwrap();
            let dual = profile(&part, &loops::<Dual<1>>(&part), |_| Dual {
                value: by,
                slope: [1.0],
            });
            let (after, before) = (there(by + step), there(by - step));
            for (l, outline) in dual.unwrap().iter().enumerate() {
                for (v, vertex) in outline.iter().enumerate() {
                    let (p, q) = (after[l][v], before[l][v]);
                    for (slope, difference) in [
                        (vertex.x.slope[0], p.x - q.x),
                        (vertex.y.slope[0], p.y - q.y),
                        (vertex.bulge.slope[0], p.bulge - q.bulge),
                    ] {
                        assert!((slope - difference / (2.0 * step)).abs() < 1e-8);
                    }
                }
            }
        }
    }

    #[test]
    fn what_is_no_outline_is_told() {
        let part = bracket();
        let of = |off: &dyn Fn(PartFeature) -> f64| profile(&part, &loops(&part), off);
        // The rounded corner of radius 0.5 goes.
        let gone = of(&|_| -0.6).unwrap_err();
        assert!(matches!(gone, ProfileError::Gone { .. }), "{gone}");
        assert!(gone.to_string().ends_with("vanishes"));
        // It is smooth: its line alone cannot be off.
        let alone = PartFeature::Edge {
            loop_index: 0,
            index: 0,
        };
        let smooth = of(&|f| f64::from(f == alone)).unwrap_err();
        assert!(matches!(smooth, ProfileError::Smooth { .. }), "{smooth}");
    }
}
