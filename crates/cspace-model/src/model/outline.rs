//! The outline of a part from the loops of a file.

use cspace::{Part, PartError};

use super::error::ModelError;
use super::loops::{DrawnLoop, read_loops};
use super::node::Node;
use super::place::Place;
use super::scope::{Result, Scope};

/// The part of a name whose loops are these values.
pub(super) fn read_outline(
    name: &str,
    place: &Place,
    nodes: &[Node],
    scope: &Scope,
) -> Result<Part> {
    let mut loops: Vec<(usize, DrawnLoop)> = Vec::with_capacity(nodes.len());
    for (i, node) in nodes.iter().enumerate() {
        loops.extend(
            read_loops(place, i, node, scope)?
                .into_iter()
                .map(|l| (i, l)),
        );
    }
    let vertices = loops
        .iter_mut()
        .map(|l| core::mem::take(&mut l.1.vertices))
        .collect();
    Part::new(name, vertices).map_err(|e| no_part(place, in_entries(e, &loops)))
}

/// The error, with loops, vertices and edges counted as the entries of the file are; the loops come each with its number in the file.
pub(super) fn in_entries(mut error: PartError, loops: &[(usize, DrawnLoop)]) -> PartError {
    for (loop_index, vertices) in places(&mut error).into_iter().flatten() {
        if let Some((number, drawn)) = loops.get(*loop_index) {
            for vertex in vertices.into_iter().flatten() {
                *vertex = drawn.entry(*vertex);
            }
            *loop_index = *number;
        }
    }
    error
}

/// Error for invalid loops, at the loop and vertex concerned.
pub(super) fn no_part(loops: &Place, mut error: PartError) -> ModelError {
    // Every message about a part ends in what to do, after its last colon.
    let text = error.to_string();
    let [first, _] = places(&mut error);
    let place = match first {
        None => loops.clone(),
        Some((l, [None, _])) => loops.item(*l),
        Some((l, [Some(v), _])) => loops.item(*l).item(*v),
    };
    match text.rsplit_once(": ") {
        Some((what, help)) => ModelError::new(&place, what).with_help(help),
        None => ModelError::new(&place, text),
    }
}

/// A loop of an error, and vertices or edges of it.
pub(super) type InLoop<'e> = (&'e mut usize, [Option<&'e mut usize>; 2]);

/// The places that an error is about, that at which it is told first.
pub(super) fn places(error: &mut PartError) -> [Option<InLoop<'_>>; 2] {
    match error {
        PartError::TooFewVertices { loop_index, .. } => [Some((loop_index, [None, None])), None],
        PartError::RepeatedLoop {
            loop_index,
            other_loop,
        } => [
            Some((other_loop, [None, None])),
            Some((loop_index, [None, None])),
        ],
        PartError::CoincidentVertices {
            loop_index,
            vertex_index,
            next_index,
        } => [
            Some((loop_index, [Some(vertex_index), Some(next_index)])),
            None,
        ],
        PartError::BadCoordinate {
            loop_index,
            vertex_index,
        }
        | PartError::CoordinateTooLarge {
            loop_index,
            vertex_index,
        }
        | PartError::BadBulge {
            loop_index,
            vertex_index,
            ..
        }
        | PartError::Spike {
            loop_index,
            vertex_index,
        } => [Some((loop_index, [Some(vertex_index), None])), None],
        PartError::Crossing {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            ..
        }
        | PartError::Touching {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            ..
        } => [
            Some((loop_index, [Some(edge_index), None])),
            Some((other_loop, [Some(other_edge), None])),
        ],
        _ => [None, None],
    }
}

#[cfg(test)]
mod tests {
    use super::{PartError, Place, no_part};
    use cspace::Point;

    #[test]
    fn every_error_of_a_part_says_what_to_do() {
        let (loop_index, vertex_index, edge_index) = (1, 2, 2);
        let (other_loop, other_edge, at) = (0, 3, Point::new(0.5, 0.25));
        let errors = [
            PartError::Empty,
            PartError::TooManyVertices { count: 9 },
            PartError::TooFewVertices {
                loop_index,
                count: 2,
            },
            PartError::BadCoordinate {
                loop_index,
                vertex_index,
            },
            PartError::CoordinateTooLarge {
                loop_index,
                vertex_index,
            },
            PartError::BadBulge {
                loop_index,
                vertex_index,
                bulge: f64::NAN,
            },
            PartError::TooSmall { size: 1e-300 },
            PartError::TooFar {
                size: 1.0,
                distance: 1e20,
            },
            PartError::CoincidentVertices {
                loop_index,
                vertex_index,
                next_index: 3,
            },
            PartError::Spike {
                loop_index,
                vertex_index,
            },
            PartError::Crossing {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at,
            },
            PartError::Touching {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at,
            },
            PartError::RepeatedLoop {
                loop_index,
                other_loop,
            },
        ];
        const VERBS: [&str; 7] = [
            "give ", "replace ", "choose ", "move ", "remove ", "draw ", "split ",
        ];
        for e in errors {
            let text = e.to_string();
            let error = no_part(&Place::default().key("loops"), e);
            let help = error.help().unwrap_or_default();
            assert!(VERBS.iter().any(|v| help.starts_with(v)), "{text}");
            assert_eq!(format!("{}: {help}", error.message()), text);
        }
    }
}
