//! Why loops make no part, in words of the drawing.

use cspace::PartError;

use crate::drawing::{Drawing, Problem};
use crate::fit::Outline;
use crate::nest::MOST_AROUND;

/// Problem of invalid loops, at the entities that drew them.
pub(super) fn no_part(drawing: &Drawing, error: &PartError, outlines: &[&Outline]) -> Problem {
    let entity = |l: usize, v: usize| {
        let entity = outlines.get(l).and_then(|o| o.entities.get(v));
        entity.map(|&e| drawing.entities[e as usize].origin.clone())
    };
    let place = |l: usize, v: usize| {
        let vertex = outlines.get(l).and_then(|o| o.vertices.get(v));
        vertex.map(|v| v.point())
    };
    let (ends, at, reason, help) = match *error {
        PartError::Crossing {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            at,
        } => (
            [(loop_index, edge_index), (other_loop, other_edge)],
            Some(at),
            "outlines cross here".to_owned(),
            "move them apart, or read their layers one by one with --layer".to_owned(),
        ),
        PartError::Touching {
            loop_index,
            edge_index,
            other_loop,
            other_edge,
            at,
        } => (
            [(loop_index, edge_index), (other_loop, other_edge)],
            Some(at),
            "outlines touch here".to_owned(),
            "move them apart, merge them, or read their layers one by one with --layer".to_owned(),
        ),
        ref other => {
            let (l, v) = place_of(other);
            let text = other.to_string();
            let (reason, help) = match text.rsplit_once(": ") {
                Some((reason, help)) => (reason.to_owned(), help.to_owned()),
                None => (text.clone(), String::new()),
            };
            ([(l, v); 2], place(l, v), reason, help)
        }
    };
    let [first, second] = ends.map(|(l, v)| entity(l, v));
    Problem {
        with: second
            .into_iter()
            .filter(|s| Some(s) != first.as_ref())
            .collect(),
        origin: first.unwrap_or_default(),
        at,
        to: None,
        reason,
        help,
    }
}

/// Problem: a loop is nested more deeply than parts allow.
pub(super) fn too_deep(drawing: &Drawing, outline: &Outline) -> Problem {
    let entity = outline.entities.first();
    Problem {
        origin: (entity.map(|&e| drawing.entities[e as usize].origin.clone())).unwrap_or_default(),
        with: Vec::new(),
        at: outline.vertices.first().map(|v| v.point()),
        to: None,
        reason: format!("more than {MOST_AROUND} outlines are around it"),
        help: "leave out what is no outline, or read some layers alone with --layer".to_owned(),
    }
}

/// The loop and vertex that an error about one place is of.
fn place_of(error: &PartError) -> (usize, usize) {
    match *error {
        PartError::TooFewVertices { loop_index, .. } => (loop_index, 0),
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
        | PartError::CoincidentVertices {
            loop_index,
            vertex_index,
            ..
        }
        | PartError::Spike {
            loop_index,
            vertex_index,
        } => (loop_index, vertex_index),
        _ => (0, 0),
    }
}
