//! Outlines that overlap: `union = [ [loop, loop], [loop] ]`, of which a part is what any of them encloses.

use cspace::{Part, PartError, Vertex};
use cspace_drawing::{Union, UnitedEdge};

use super::error::ModelError;
use super::loops::{DrawnLoop, read_loops};
use super::node::Node;
use super::outline::{in_entries, no_part, places};
use super::place::Place;
use super::scope::{Result, Scalar};
use super::value::Value;

/// How they are written.
pub(super) const UNION: &str = "union = [ [loop, loop], [loop] ], each entry a list of loops";

/// The loops of all entries.
pub(super) struct Entries<T> {
    /// For each entry its loops, each with its number in the file.
    entries: Vec<Vec<(usize, DrawnLoop<T>)>>,
    place: Place,
}

impl<T: Scalar> Entries<T> {
    /// The value of the key `union`.
    pub(super) fn read(union: &Value<'_>) -> Result<Self> {
        let expected = |value: &Value<'_>, what: &str| {
            let found = value.node.describe();
            let error = value.error(format!("{found} where {what} is expected"));
            error.with_help(format!(
                "give it as {UNION}: is a pair of brackets missing?"
            ))
        };
        let items = union.items().filter(|items| !items.is_empty());
        let items = items.ok_or_else(|| expected(union, "a list of outlines"))?;
        let mut entries = Vec::with_capacity(items.len());
        for (e, item) in items.into_iter().enumerate() {
            let item = item.further(&entry(e));
            let Node::List(nodes) = item.node else {
                return Err(expected(&item, "a list of loops"));
            };
            // A list of vertices is a loop, and no list of loops.
            if nodes.is_empty() || nodes.iter().any(is_vertex) {
                return Err(expected(&item, "a list of loops"));
            }
            let mut loops = Vec::with_capacity(nodes.len());
            for (i, node) in nodes.iter().enumerate() {
                let drawn = read_loops(&item.place, i, node, item.scope)?;
                loops.extend(drawn.into_iter().map(|l| (i, l)));
            }
            entries.push(loops);
        }
        let place = union.place.clone();
        Ok(Self { entries, place })
    }

    /// The outline of what any entry encloses.
    pub(super) fn united(&self) -> Result<Union<T>> {
        let loops = |entry: &Vec<(usize, DrawnLoop<T>)>| {
            entry.iter().map(|(_, l)| l.vertices.clone()).collect()
        };
        let outlines: Vec<Vec<Vec<Vertex<T>>>> = self.entries.iter().map(loops).collect();
        cspace_drawing::union(&outlines).map_err(|e| {
            let place = self.place.clone().further("union");
            ModelError::new(&place, e.to_string()).with_help(e.help())
        })
    }

    /// An edge in the words of the file, and its place.
    pub(super) fn edge(&self, edge: UnitedEdge) -> (String, Place) {
        let (number, drawn) = &self.entries[edge.outline][edge.loop_index];
        let vertex = drawn.entry(edge.vertex);
        let words = format!("{}, loop {number}, edge {vertex}", entry(edge.outline));
        let place = self.place.item(edge.outline).item(*number).item(vertex);
        (words, place)
    }
}

impl Entries<f64> {
    /// The part of this name.
    pub(super) fn part(&self, name: &str) -> Result<Part> {
        for (e, loops) in self.entries.iter().enumerate() {
            let place = self.place.item(e).further(&entry(e));
            for one in loops {
                check(&place, one)?;
            }
        }
        let made = self.united()?;
        Part::new(name, made.loops.clone()).map_err(|e| self.no_part(e, &made))
    }

    /// Error for a union that is no outline of a part, at an edge concerned.
    fn no_part(&self, mut error: PartError, made: &Union) -> ModelError {
        let text = match &error {
            PartError::Touching { at, .. } | PartError::Crossing { at, .. } => {
                format!(
                    "what the entries enclose touches itself near ({:?}, {:?})",
                    at.x, at.y
                )
            }
            PartError::Spike { .. } => "what the entries enclose has a cusp".to_owned(),
            other => format!("what the entries enclose is no outline: {other}"),
        };
        let edges: Vec<UnitedEdge> = (places(&mut error).into_iter().flatten())
            .filter_map(|(l, [v, _])| made.edges.get(*l)?.get(*v?).copied())
            .collect();
        let Some(&first) = edges.first() else {
            return ModelError::new(&self.place.clone().further("union"), text);
        };
        let (words, place) = self.edge(first);
        let other = edges
            .get(1)
            .map(|e| format!(", where {} is", self.edge(*e).0));
        let message = format!("{text}{}", other.unwrap_or_default());
        ModelError::new(&place.further(&words), message)
            .with_help("let the outlines overlap there, or keep them apart")
    }
}

/// Checks a loop alone: it may cross and touch others and itself.
fn check(entry: &Place, (number, drawn): &(usize, DrawnLoop)) -> Result<()> {
    match Part::new("", vec![drawn.vertices.clone()]) {
        Ok(_)
        | Err(PartError::Crossing { .. } | PartError::Touching { .. } | PartError::Spike { .. }) => {
            Ok(())
        }
        Err(error) => {
            let error = in_entries(error, core::slice::from_ref(&(*number, drawn.clone())));
            Err(no_part(entry, error))
        }
    }
}

fn entry(number: usize) -> String {
    format!("union entry {number}")
}

/// Whether a value is a vertex, and no loop.
fn is_vertex(node: &Node) -> bool {
    match node {
        Node::List(items) => (items.first())
            .is_some_and(|n| matches!(n, Node::Integer(_) | Node::Number(_) | Node::Text(_))),
        _ => false,
    }
}
