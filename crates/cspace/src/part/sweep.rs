//! Finds edges that meet, and the side of each loop on which the material lies, in one sweep.
//!
//! A line moves over the part; the pieces of boundary that it cuts are kept in order along it (Shamos and Hoey, 1976). Until the first
//! meeting that order changes only at vertices, and two pieces that meet are neighbours before they do, so that only neighbours are
//! compared: the time grows as n log n for any edges, and the sweep stops at the first meeting.

use core::cmp::Ordering;

use crate::geometry::{Point, Rotation, Vector};
use crate::parallel;

use super::meeting::meeting;
use super::outline::Outline;
use super::status::Status;
use super::{Edge, PartError};

/// The directions in which the line moves, in radians from the first axis.
///
/// Not multiples of a round angle, so that edges are seldom parallel to the line; and far from parallel to each other, so that edges nearly
/// parallel to the line in one sweep are not in the other. For such an edge, the touch of a vertex just beyond the end of its span could be
/// missed.
const DIRECTIONS: [f64; 2] = [0.739_085_133_2, 1.851_937_051_9];

/// Number of edges from which the two sweeps run in parallel; below it, passing one to another thread takes longer than the sweep.
const PARALLEL_EDGES: usize = 1000;

/// Whether each loop has its material on the right of the direction given.
///
/// # Errors
/// Two edges that are not neighbours cross or touch.
pub(super) fn check_meetings(outline: &Outline) -> Result<Vec<bool>, PartError> {
    let [first, second] = DIRECTIONS.map(|direction| move || sweep(outline, direction));
    if outline.edges.len() < PARALLEL_EDGES {
        first()?;
        return second();
    }
    let (first, second) = parallel::join(first, second);
    first.and(second)
}

/// A piece of an edge on which the line's coordinate increases.
struct Piece {
    /// The piece in the direction of increase; `index` is the edge's.
    curve: Edge,
    /// The angle of the direction in which it starts.
    angle: f64,
    /// Number of the vertex, or of the split, at which it starts.
    from: usize,
    /// Whether the edge is given in the direction of increase.
    forward: bool,
}

/// Event: the line starts or stops to cut a piece.
struct Event {
    at: Point,
    starts: bool,
    piece: u32,
}

impl Event {
    fn order(&self, other: &Self) -> Ordering {
        along(self.at, other.at)
            .then(self.starts.cmp(&other.starts))
            .then(self.piece.cmp(&other.piece))
    }
}

/// The order in which the line meets points.
fn along(p: Point, q: Point) -> Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

fn sweep(outline: &Outline, direction: f64) -> Result<Vec<bool>, PartError> {
    let pieces = cut(outline, direction);
    let mut events: Vec<Event> = pieces
        .iter()
        .zip(0..)
        .flat_map(|(piece, number)| {
            [(piece.curve.start, true), (piece.curve.end, false)].map(|(at, starts)| Event {
                at,
                starts,
                piece: number,
            })
        })
        .collect();
    events.sort_unstable_by(Event::order);

    let mut status = Status::new(pieces.len());
    let mut material_above = vec![false; pieces.len()];
    for event in &events {
        let piece = event.piece;
        if event.starts {
            status.insert(piece, |other| {
                is_above(&pieces[piece as usize], &pieces[other as usize])
            });
        }
        let (below, above) = status.neighbours(piece);
        if event.starts {
            compare(outline, &pieces, below, Some(piece))?;
            compare(outline, &pieces, Some(piece), above)?;
            let material_below = below.is_some_and(|b| material_above[b as usize]);
            material_above[piece as usize] = !material_below;
            // Of two pieces that start at one vertex the upper may have come first.
            if let Some(twin) =
                above.filter(|&a| pieces[a as usize].from == pieces[piece as usize].from)
            {
                material_above[twin as usize] = material_below;
            }
        } else {
            compare(outline, &pieces, below, above)?;
            status.remove(piece);
        }
    }
    Ok(sides(outline, &pieces, &material_above))
}

/// Whether each loop has its material on the right, by its first edge.
fn sides(outline: &Outline, pieces: &[Piece], material_above: &[bool]) -> Vec<bool> {
    // Pieces are listed by edge.
    outline
        .first
        .iter()
        .map(|&edge| {
            let number = pieces.partition_point(|piece| piece.curve.index < edge);
            pieces[number].forward != material_above[number]
        })
        .collect()
}

/// Rejects neighbours along the line that meet.
fn compare(
    outline: &Outline,
    pieces: &[Piece],
    below: Option<u32>,
    above: Option<u32>,
) -> Result<(), PartError> {
    let (Some(below), Some(above)) = (below, above) else {
        return Ok(());
    };
    let (a, b) = (
        pieces[below as usize].curve.index,
        pieces[above as usize].curve.index,
    );
    if outline.are_neighbours(a, b) || outline.are_apart(a, b) {
        return Ok(());
    }
    meeting(&outline.edges[a], &outline.edges[b], outline.tolerance())
        .map_or(Ok(()), |met| Err(outline.refuse(a, b, met)))
}

/// Whether a piece starts above another one, which the line cuts there.
fn is_above(piece: &Piece, other: &Piece) -> bool {
    if piece.from == other.from {
        return piece.angle > other.angle;
    }
    let (p, curve) = (piece.curve.start, &other.curve);
    let beside_chord = (curve.end - curve.start).cross(p - curve.start);
    // A piece that turns left lies below its chord, one that turns right above; between chord and
    // piece, and beyond the piece, its circle decides.
    if curve.bulge > 0.0 {
        beside_chord >= 0.0 || curve.level(p) > 0.0
    } else {
        beside_chord > 0.0 && curve.level(p) > 0.0
    }
}

/// Cuts the edges where they are parallel to the line that moves in `direction`, and turns them so
/// that it moves along the first axis.
fn cut(outline: &Outline, direction: f64) -> Vec<Piece> {
    let turn = Rotation::by(direction).inverse();
    let up = turn.inverse() * Vector::new(0.0, 1.0);
    let mut pieces = Vec::with_capacity(outline.edges.len());
    let mut splits = outline.edges.len();
    for edge in &outline.edges {
        let mut stops = [0.0, 1.0, 1.0, 1.0];
        // A shorter piece could not be distinguished from a point.
        let shortest = outline.tolerance() / edge.length();
        let cuts = [up, -up].map(|way| {
            edge.fraction_heading(way)
                .filter(|u| (shortest..1.0 - shortest).contains(u))
        });
        for (stop, u) in stops[1..3].iter_mut().zip(cuts) {
            *stop = u.unwrap_or(1.0);
        }
        if stops[1] > stops[2] {
            stops.swap(1, 2);
        }
        let mut from = edge.index;
        let mut start = edge.start;
        for span in stops.windows(2).filter(|span| span[0] < span[1]) {
            let last = span[1] == 1.0;
            let end = if last { edge.end } else { edge.at(span[1]) };
            let to = if last {
                outline.after(edge.index)
            } else {
                splits
            };
            splits += usize::from(!last);
            let whole = last && span[0] == 0.0;
            let bulge = if whole {
                edge.bulge
            } else {
                (0.25 * (span[1] - span[0]) * edge.sweep()).tan()
            };
            let curve = Edge {
                start: Point::ORIGIN + turn * start.to_vector(),
                end: Point::ORIGIN + turn * end.to_vector(),
                bulge,
                index: edge.index,
            };
            let forward = along(curve.start, curve.end) == Ordering::Less;
            let (curve, from_here, heading) = if forward {
                (curve, from, direction_at(edge, span[0]))
            } else {
                (curve.reversed(), to, -direction_at(edge, span[1]))
            };
            pieces.push(Piece {
                curve,
                angle: (turn * heading).angle(),
                from: from_here,
                forward,
            });
            (from, start) = (to, end);
        }
    }
    pieces
}

/// The direction of travel, as accurate as the ends give it.
fn direction_at(edge: &Edge, u: f64) -> Vector {
    if u == 0.0 {
        edge.start_direction()
    } else if u == 1.0 {
        edge.end_direction()
    } else {
        edge.direction_at(u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::part::check::{check_extent, check_numbers};
    use crate::part::corner::check_corners;
    use crate::part::nearness::check_vertices;
    use crate::part::tolerance::RESOLUTION;
    use crate::part::{Part, Vertex};

    /// Pseudo-random numbers below a bound.
    struct Noise(u64);

    impl Noise {
        fn below(&mut self, bound: u64) -> u64 {
            self.0 = self
                .0
                .wrapping_mul(0x5851_f42d_4c95_7f2d)
                .wrapping_add(0x1405_7b7e_f767_814f);
            (self.0 >> 33) % bound
        }
    }

    const BULGES: [f64; 12] = [
        0.0, 0.0, 0.0, 1.0, -1.0, 0.5, -0.5, 0.1, -0.1, 1e-3, -3.0, 1e-9,
    ];

    /// Loops with vertices on a small grid, some off it by about the resolution: they touch,
    /// overlap and just miss each other in every way.
    fn on_a_grid(noise: &mut Noise) -> Vec<Vec<Vertex>> {
        let (loops, wide) = (1 + noise.below(3), 4 + noise.below(6));
        let off = [0.0, 0.0, 0.0, 1e-12, 5e-11, 1e-9];
        (0..loops)
            .map(|_| {
                (0..2 + noise.below(5))
                    .map(|_| {
                        let mut at = || noise.below(wide) as f64 + off[noise.below(6) as usize];
                        let (x, y) = (at(), at());
                        Vertex::new(x, y, BULGES[noise.below(12) as usize])
                    })
                    .collect()
            })
            .collect()
    }

    #[test]
    fn finds_a_meeting_exactly_when_some_two_edges_meet() {
        let mut noise = Noise(1);
        let (mut made, mut refused) = (0, 0);
        for _ in 0..30_000 {
            let mut loops = on_a_grid(&mut noise);
            let Ok(bounds) = check_numbers(&mut loops).and_then(|()| check_extent(&loops)) else {
                continue;
            };
            let outline = Outline::new(&loops, 0, bounds);
            if check_corners(&outline)
                .and_then(|()| check_vertices(&outline, &loops))
                .is_err()
            {
                continue;
            }
            let count = outline.edges.len();
            let met = (0..count).any(|a| {
                (0..a).any(|b| {
                    !outline.are_neighbours(a, b)
                        && meeting(&outline.edges[a], &outline.edges[b], outline.tolerance())
                            .is_some()
                })
            });
            let swept = check_meetings(&outline);
            assert_eq!(swept.is_err(), met, "{loops:?} {swept:?}");
            if met {
                refused += 1;
                continue;
            }
            made += 1;
            let part = Part::new("grid", loops.clone());
            let step = 0.2 * RESOLUTION * bounds.diagonal();
            for edge in part
                .iter()
                .flat_map(Part::edges)
                .filter(|e| e.length() > 0.1)
            {
                let (p, left) = (edge.at(0.47), edge.direction_at(0.47).left());
                let inside = part.iter().any(|part| part.contains(p + left * step));
                let beyond = part.iter().any(|part| part.contains(p + left * -step));
                assert!(inside && !beyond, "{loops:?} {edge:?}");
            }
        }
        assert!(made > 1000 && refused > 1000, "{made} {refused}");
    }
}
