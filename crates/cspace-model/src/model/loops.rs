//! A loop from its entries.

use cspace::part::{OutlineBuilder, OutlineError, circle_loop};
use cspace::{Point, Vertex};

use super::entry::{ENTRIES, Entry, read_vertex};
use super::error::ModelError;
use super::keys::{Key, Keys};
use super::node::Node;
use super::pattern::{Item, Pattern, written_out};
use super::place::Place;
use super::scope::{Result, Scalar, Scope};
use super::table::Table;
use super::value::Value;

/// How often a loop is repeated.
const REPEATED: Key = Key::new(
    "pattern",
    "pattern",
    "How often the loop is repeated, turned about a point by equal parts of a turn.",
);

#[rustfmt::skip]
pub(super) const CIRCLE: Keys = Keys::new(
    "a circle is { circle = r, at = [x, y] }",
    &[
        Key::new("circle", "positive", "The radius.").like("circle = 2.5, the radius"),
        Key::new("at", "point", "The centre.").like("at = [0, 0], the centre"),
        REPEATED,
    ],
);

/// How loops in braces are written.
const BRACES: &str = "a loop in braces is { circle = r, at = [x, y] } or { path = [...] }, with pattern = { count = 6, about = [0, 0] }";

#[rustfmt::skip]
pub(super) const PATH: Keys = Keys::new(
    BRACES,
    &[Key::new("path", "entries", "The entries."), REPEATED],
);

/// The vertices of a loop.
#[derive(Clone)]
pub(super) struct DrawnLoop<T = f64> {
    pub(super) vertices: Vec<Vertex<T>>,
    /// For every vertex the entry it comes from; none where that is its own number.
    entries: Option<Vec<usize>>,
}

impl<T> DrawnLoop<T> {
    /// The entry that a vertex, or the edge that leaves it, comes from.
    pub(super) fn entry(&self, vertex: usize) -> usize {
        let entries = self.entries.as_ref();
        entries
            .and_then(|e| e.get(vertex).copied())
            .unwrap_or(vertex)
    }
}

/// Reads the loops of a value: several if it is a pattern.
pub(super) fn read_loops<T: Scalar>(
    loops: &Place,
    index: usize,
    node: &Node,
    scope: &Scope,
) -> Result<Vec<DrawnLoop<T>>> {
    let place = || loops.item(index).further(&format!("loop {index}"));
    let value = || Value {
        node,
        place: place(),
        scope,
    };
    match node {
        Node::List(nodes) if nodes.iter().any(|n| matches!(n, Node::Table(_))) => {
            let drawn = Sketch::new(place()).draw(nodes, scope)?;
            Ok(vec![drawn])
        }
        Node::List(nodes) => Ok(vec![read_vertices(place, nodes, scope)?]),
        Node::Table(entries) if entries.contains_key("path") => {
            let table = Table::new(value(), &PATH)?;
            let path = table.nodes("path", BRACES)?.unwrap_or_default();
            let drawn = Sketch::new(table.place.key("path")).draw(path, scope)?;
            repeated(&table, drawn)
        }
        Node::Table(_) => read_circle(value()),
        _ => {
            let message = format!("{} where a list of vertices is expected", node.describe());
            Err(ModelError::new(&place(), message)
                .with_help("a loop is a list of vertices, [[x, y, bulge], [x, y], ...], or { circle = r, at = [x, y] }"))
        }
    }
}

/// Copies of a loop according to the pattern in its table.
fn repeated<T: Scalar>(table: &Table<'_>, drawn: DrawnLoop<T>) -> Result<Vec<DrawnLoop<T>>> {
    let pattern = Pattern::read(table)?;
    if pattern.count == 1 {
        return Ok(vec![drawn]);
    }
    let copies = pattern.copies(&drawn.vertices, table)?;
    let copy = |vertices| DrawnLoop {
        vertices,
        entries: drawn.entries.clone(),
    };
    Ok(copies.into_iter().map(copy).collect())
}

/// Reads a loop of vertices alone.
fn read_vertices<T: Scalar>(
    place: impl Fn() -> Place,
    nodes: &[Node],
    scope: &Scope,
) -> Result<DrawnLoop<T>> {
    let vertex = |(i, node)| {
        let place = || place().item(i).further(&format!("vertex {i}"));
        read_vertex(node, place, scope, nodes)
    };
    Ok(DrawnLoop {
        vertices: nodes
            .iter()
            .enumerate()
            .map(vertex)
            .collect::<Result<_>>()?,
        entries: None,
    })
}

fn read_circle<T: Scalar>(value: Value<'_>) -> Result<Vec<DrawnLoop<T>>> {
    let table = Table::new(value, &CIRCLE).map_err(|e| match e.help() {
        Some(help) if help.starts_with("did you mean") => e,
        _ => e.with_help(
            "a loop in braces is a circle, { circle = r, at = [x, y] }; arcs and fillets are entries of a loop in brackets: is a pair of brackets missing?",
        ),
    })?;
    let radius: T = table.needed("circle", table.number("circle")?)?;
    let center: Point<T> = table.needed("at", table.point("at")?)?;
    let vertices = circle_loop(center, radius).map_err(|_| {
        let error = table.error("circle", format!("the radius is {:?}", radius.value()));
        error.with_help("give a positive number")
    })?;
    let drawn = DrawnLoop {
        vertices,
        entries: None,
    };
    repeated(&table, drawn)
}

/// A loop while it is drawn.
struct Sketch<T> {
    place: Place,
    /// Builder of the outline; `None` before the first vertex.
    pen: Option<OutlineBuilder<T>>,
    /// First vertex.
    start: Point<T>,
    /// The bulge of the edge that leaves the last vertex.
    bulge: T,
    /// For every vertex drawn the entry it comes from.
    entries: Vec<usize>,
    /// For every vertex drawn the entry that rounds it, if there is one.
    fillets: Vec<Option<usize>>,
    /// Kind of each entry, for messages.
    names: Vec<&'static str>,
}

impl<T: Scalar> Sketch<T> {
    fn new(place: Place) -> Self {
        Self {
            place,
            pen: None,
            start: Point::new(T::constant(0.0), T::constant(0.0)),
            bulge: T::constant(0.0),
            entries: Vec::new(),
            fillets: Vec::new(),
            names: Vec::new(),
        }
    }

    fn draw(mut self, nodes: &[Node], scope: &Scope) -> Result<DrawnLoop<T>> {
        let name = |n: &Node| {
            if matches!(n, Node::Table(_)) {
                "entry"
            } else {
                "vertex"
            }
        };
        self.names = nodes.iter().map(name).collect();
        for Item { entry, from } in written_out(nodes, &|i| self.at(i), scope)? {
            self.pen = Some(self.add(from, &entry)?);
        }
        let Some(mut pen) = self.pen.take() else {
            return Err(ModelError::new(&self.place, "an empty list").with_help(ENTRIES));
        };
        if self.bulge.value() != 0.0 {
            pen = pen.arc_to(self.start, self.bulge);
        }
        let drawn = pen.close_numbered().map_err(|e| self.refused(&e))?;
        let mut before = None;
        let entries = drawn.iter().map(|&(_, number)| {
            // A fillet makes two vertices of one: its own entry stands for the second.
            let is_second = before.replace(number) == Some(number);
            let fillet = self.fillets.get(number).copied().flatten();
            let entry = self.entries.get(number).copied();
            fillet.filter(|_| is_second).or(entry).unwrap_or_default()
        });
        Ok(DrawnLoop {
            entries: Some(entries.collect()),
            vertices: drawn.iter().map(|(v, _)| *v).collect(),
        })
    }

    /// The pen once an entry is drawn.
    fn add(&mut self, i: usize, entry: &Entry<T>) -> Result<OutlineBuilder<T>> {
        let (to, arc, fillet, leaves) = match entry {
            Entry::Vertex(v) => (v.point(), None, None, v.bulge),
            Entry::To {
                to,
                arc,
                fillet,
                bulge,
            } => (*to, arc.as_ref(), *fillet, *bulge),
            Entry::Fillet(radius) => {
                let Some(pen) = self.pen.take() else {
                    let message = "a fillet, but no vertex before it";
                    return Err(ModelError::new(&self.at(i), message)
                        .with_help("put { fillet = r } after the vertex that it rounds, or write { at = [x, y], fillet = r }"));
                };
                return Ok(self.fillet(i, pen, *radius));
            }
        };
        let bulge = core::mem::replace(&mut self.bulge, T::constant(0.0));
        let pen = match (self.pen.take(), arc) {
            (None, Some(_)) => {
                let message = "the loop begins with an arc, which has no vertex to start from";
                return Err(ModelError::new(&self.at(i), message).with_help(
                    "begin with a vertex [x, y]; an arc may end there to close the loop",
                ));
            }
            (None, None) => {
                self.start = to;
                OutlineBuilder::start(to)
            }
            (Some(_), Some(_)) if bulge.value() != 0.0 => {
                let before = self.entries.last().copied().unwrap_or_default();
                let message = format!(
                    "the arc is given twice, here and by the bulge of vertex {before}, which it leaves"
                );
                return Err(ModelError::new(&self.at(i), message)
                    .with_help(format!("write vertex {before} as [x, y], without a bulge")));
            }
            (Some(pen), Some(arc)) => arc.draw(pen, to),
            (Some(pen), None) => pen.arc_to(to, bulge),
        };
        self.entries.push(i);
        self.fillets.push(None);
        self.bulge = leaves;
        Ok(match fillet {
            Some(radius) => self.fillet(i, pen, radius),
            None => pen,
        })
    }

    fn fillet(&mut self, i: usize, pen: OutlineBuilder<T>, radius: T) -> OutlineBuilder<T> {
        if let Some(entry) = self.fillets.last_mut() {
            *entry = Some(i);
        }
        pen.fillet(radius)
    }

    fn at(&self, entry: usize) -> Place {
        let name = self.names.get(entry).copied().unwrap_or("entry");
        self.place.item(entry).further(&format!("{name} {entry}"))
    }

    /// Error for an outline that cannot be drawn, at the entry that causes it.
    fn refused(&self, error: &OutlineError) -> ModelError {
        let entry = |vertex: usize| {
            let last = self.entries.last().copied().unwrap_or_default();
            self.at(self.entries.get(vertex).copied().unwrap_or(last))
        };
        let (place, text) = match error {
            OutlineError::Arc {
                vertex_index,
                error,
            } => (entry(vertex_index + 1), error.to_string()),
            OutlineError::Fillet {
                vertex_index,
                error,
            } => (self.rounded(*vertex_index), error.to_string()),
            OutlineError::TwoFillets { vertex_index } => (
                self.rounded(*vertex_index),
                "the corner has two fillets: remove one of them".to_owned(),
            ),
            OutlineError::NoEdge { vertex_index } => (
                entry(vertex_index + 1),
                "it is at the same place as the vertex before it: remove one of them, or draw a full circle as { circle = r, at = [x, y] }".to_owned(),
            ),
            other => (self.place.clone(), other.to_string()),
        };
        // Every message about an outline ends in what to do, after its last colon.
        match text.rsplit_once(": ") {
            Some((what, help)) => ModelError::new(&place, what).with_help(help),
            None => ModelError::new(&place, text),
        }
    }

    /// The entry that rounds a vertex.
    fn rounded(&self, vertex: usize) -> Place {
        let of = |fillet: Option<&Option<usize>>| fillet.copied().flatten();
        // An edge that closes the loop ends at the first vertex, and a fillet after it is that vertex's.
        let entry = of(self.fillets.get(vertex)).or_else(|| of(self.fillets.last()));
        match entry {
            Some(entry) => self.at(entry),
            None => self.place.clone(),
        }
    }
}
