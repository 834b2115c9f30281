//! Entries of a loop: a vertex, an arc to the next vertex, or the rounding of a corner.

use cspace::part::{ArcSize, Direction, OutlineBuilder};
use cspace::{Point, Vertex};

use super::error::ModelError;
use super::keys::{Key, Keys};
use super::node::Node;
use super::place::Place;
use super::scope::{Result, Scalar, Scope};
use super::table::Table;
use super::value::Value;

/// Help text that lists the entries of a loop.
pub(super) const ENTRIES: &str = "an entry of a loop is a vertex [x, y] or [x, y, bulge], an arc { arc_to = [x, y], radius = r }, a rounded corner { fillet = r }, or a pattern { repeat = 20, about = [0, 0], path = [...] }";

#[rustfmt::skip]
pub(super) const ENTRY: Keys = Keys::new(
    ENTRIES,
    &[
        Key::new("arc_to", "point", "Where an arc ends that begins at the vertex before: a new vertex. With one of radius, through and center.").like("arc_to = [1.5, -2]"),
        Key::new("radius", "positive", "The arc's radius, at least half the distance of its ends."),
        Key::new("through", "point", "A point of the arc between its ends.").like("through = [1.5, -2]"),
        Key::new("center", "point", "The arc's centre, equally far from both ends.").like("center = [1.5, -2]"),
        Key::new("direction", "ccw|cw", "Which way an arc of a radius or about a centre turns: counter-clockwise, the default, or clockwise."),
        Key::new("large", "bool", "Whether an arc of a radius is the one of more than half a turn. Default: false."),
        Key::new("at", "point", "A vertex that a line leads to.").like("at = [1.5, -2]"),
        Key::new("fillet", "positive", "The radius of an arc that rounds the corner, tangent to both its edges: at this entry's vertex, or without one at the vertex before."),
    ],
);

/// Parsed entry of a loop.
#[derive(Debug, Clone, Copy)]
pub(super) enum Entry<T = f64> {
    /// A vertex; the bulge is of the edge that leaves it.
    Vertex(Vertex<T>),
    /// A vertex that an arc or a line leads to, the radius of its fillet, and the bulge of the edge that leaves it.
    To {
        to: Point<T>,
        arc: Option<Arc<T>>,
        fillet: Option<T>,
        bulge: T,
    },
    /// The vertex before has a fillet of this radius.
    Fillet(T),
}

/// Data of an arc besides its ends.
#[derive(Debug, Clone, Copy)]
pub(super) enum Arc<T = f64> {
    Radius(T, Direction, ArcSize),
    Through(Point<T>),
    Center(Point<T>, Direction),
}

impl<T: Scalar> Arc<T> {
    /// Draws the arc to a point.
    pub(super) fn draw(&self, pen: OutlineBuilder<T>, to: Point<T>) -> OutlineBuilder<T> {
        match *self {
            Self::Radius(radius, direction, size) => pen.arc_to_radius(to, radius, direction, size),
            Self::Through(through) => pen.arc_through(to, through),
            Self::Center(center, direction) => pen.arc_to_center(to, center, direction),
        }
    }
}

/// The entry in a value; `siblings` is the loop it is in.
pub(super) fn read_entry<T: Scalar>(
    node: &Node,
    place: impl Fn() -> Place,
    scope: &Scope,
    siblings: &[Node],
) -> Result<Entry<T>> {
    if matches!(node, Node::Table(_)) {
        let place = place();
        return read_table(Value { node, place, scope });
    }
    read_vertex(node, place, scope, siblings).map(Entry::Vertex)
}

/// A loop that is written where the list of loops belongs is a slip easily made.
fn vertex_help(siblings: &[Node], scope: &Scope) -> &'static str {
    let is_number = |n: &Node| matches!(scope.number(n, Place::default), Ok(Some(_)));
    if siblings.iter().all(is_number) {
        "a vertex is [x, y] or [x, y, bulge], a loop a list of vertices, and `loops` a list of loops: is a pair of brackets missing?"
    } else {
        "a vertex is [x, y] or [x, y, bulge]"
    }
}

/// The vertex in a value. There may be a million: only where one is wrong its place is asked for.
pub(super) fn read_vertex<T: Scalar>(
    node: &Node,
    place: impl Fn() -> Place,
    scope: &Scope,
    siblings: &[Node],
) -> Result<Vertex<T>> {
    let wrong = |message: String| {
        ModelError::new(&place(), message).with_help(vertex_help(siblings, scope))
    };
    let numbers = match node {
        Node::List(numbers) if (2..=3).contains(&numbers.len()) => numbers,
        _ => {
            let found = node.describe();
            return Err(wrong(format!("{found} where a vertex is expected")));
        }
    };
    let mut read = [T::constant(0.0); 3];
    for (i, (to, from)) in read.iter_mut().zip(numbers).enumerate() {
        let number = scope.number(from, || place().item(i))?;
        *to = T::of(number.ok_or_else(|| {
            let found = from.describe();
            wrong(format!("{found} where a number is expected"))
        })?);
    }
    if let Some(bad) = read.iter().map(|x| x.value()).find(|x| !x.is_finite()) {
        return Err(wrong(format!("{bad} is no finite number")));
    }
    Ok(Vertex::new(read[0], read[1], read[2]))
}

fn read_table<T: Scalar>(value: Value<'_>) -> Result<Entry<T>> {
    if let Some(circle) = value.get("circle") {
        let message = "a circle among the vertices of a loop";
        return Err(ModelError::new(&circle.place.itself(), message).with_help(
            "a circle is a loop of its own: loops = [ [...], { circle = r, at = [x, y] } ]",
        ));
    }
    let table = Table::new(value, &ENTRY)?;
    if table.has("arc_to") {
        let arc = match the_one(&table, ["radius", "through", "center"])? {
            "radius" => {
                let keys = ["arc_to", "radius", "direction", "large", "fillet"];
                table.only(&keys, "an arc of a radius")?;
                let size = if table.flag("large")? {
                    ArcSize::Long
                } else {
                    ArcSize::Short
                };
                let radius = table.number("radius")?.unwrap_or(T::constant(0.0));
                Arc::Radius(radius, direction(&table)?, size)
            }
            "through" => {
                table.only(&["arc_to", "through", "fillet"], "an arc through a point")?;
                Arc::Through(point(&table, "through")?)
            }
            _ => {
                let keys = ["arc_to", "center", "direction", "fillet"];
                table.only(&keys, "an arc about a centre")?;
                Arc::Center(point(&table, "center")?, direction(&table)?)
            }
        };
        return Ok(Entry::To {
            to: point(&table, "arc_to")?,
            arc: Some(arc),
            fillet: table.number("fillet")?,
            bulge: T::constant(0.0),
        });
    }
    if table.has("at") {
        table.only(&["at", "fillet"], "a vertex in braces")?;
        return Ok(Entry::To {
            to: point(&table, "at")?,
            arc: None,
            fillet: table.number("fillet")?,
            bulge: T::constant(0.0),
        });
    }
    // Anything else that belongs to an arc lacks where the arc ends.
    if let Some(key) = ["radius", "through", "center", "direction", "large"]
        .into_iter()
        .find(|key| table.has(key))
    {
        let message = format!("`{key}` is given without `arc_to`");
        return Err(table.error_at_key(key, message).with_help(
            "say where the arc ends: { arc_to = [x, y], radius = r }, or with through = [x, y] or center = [x, y]",
        ));
    }
    match table.number("fillet")? {
        Some(radius) => Ok(Entry::Fillet(radius)),
        None => Err(ModelError::new(&table.place, "an empty table").with_help(ENTRIES)),
    }
}

/// The one of three keys that is given.
fn the_one(table: &Table<'_>, keys: [&'static str; 3]) -> Result<&'static str> {
    let given: Vec<&str> = (keys.into_iter()).filter(|key| table.has(key)).collect();
    match given[..] {
        [one] => Ok(one),
        [] => Err(
            ModelError::new(&table.place, "`arc_to` is given without what arc it is")
                .with_help("add one of radius = r, through = [x, y] and center = [x, y]"),
        ),
        [first, second, ..] => {
            let message = format!("both `{first}` and `{second}` are given");
            Err(table.error_at_key(second, message).with_help(format!(
                "one of them says what arc it is: keep `{first}` or `{second}`, and remove the other"
            )))
        }
    }
}

fn point<T: Scalar>(table: &Table<'_>, key: &str) -> Result<Point<T>> {
    table.needed(key, table.point(key)?)
}

/// Direction of an arc; counter-clockwise by default.
fn direction(table: &Table<'_>) -> Result<Direction> {
    const HELP: &str = "give direction = \"ccw\" for counter-clockwise or \"cw\" for clockwise";
    const ALL: [(&str, Direction); 2] = [
        ("ccw", Direction::CounterClockwise),
        ("cw", Direction::Clockwise),
    ];
    let direction = table.choice("direction", "direction", &ALL, HELP)?;
    Ok(direction.unwrap_or(Direction::CounterClockwise))
}
