//! Entries of a loop: a vertex, an arc to the next vertex, or the rounding of a corner.

use cspace::part::{ArcSize, Direction, OutlineBuilder};
use cspace::{Point, Vertex};

use super::error::ModelError;
use super::node::Node;
use super::place::Place;
use super::suggest::nearest;
use super::table::{Result, Scalar, Table, number};
use crate::shown::quoted;

/// Help text that lists the entries of a loop.
pub(super) const ENTRIES: &str = "an entry of a loop is a vertex [x, y] or [x, y, bulge], an arc { arc_to = [x, y], radius = r }, a rounded corner { fillet = r }, or a pattern { repeat = 20, about = [0, 0], path = [...] }";

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
    place: Place,
    node: &Node,
    siblings: &[Node],
) -> Result<Entry<T>> {
    if matches!(node, Node::Table(_)) {
        return read_table(place, node);
    }
    match read_vertex(node) {
        Ok(vertex) => Ok(Entry::Vertex(vertex)),
        Err(message) => Err(ModelError::new(&place, message).with_help(vertex_help(siblings))),
    }
}

/// A loop that is written where the list of loops belongs is a slip easily made.
fn vertex_help(siblings: &[Node]) -> &'static str {
    if siblings.iter().all(|v| number(v).is_some()) {
        "a vertex is [x, y] or [x, y, bulge], a loop a list of vertices, and `loops` a list of loops: is a pair of brackets missing?"
    } else {
        "a vertex is [x, y] or [x, y, bulge]"
    }
}

pub(super) fn read_vertex<T: Scalar>(node: &Node) -> core::result::Result<Vertex<T>, String> {
    let numbers = match node {
        Node::List(numbers) if (2..=3).contains(&numbers.len()) => numbers,
        _ => return Err(format!("{} where a vertex is expected", node.describe())),
    };
    let mut read = [T::constant(0.0); 3];
    for (to, from) in read.iter_mut().zip(numbers) {
        *to = T::read(from)
            .ok_or_else(|| format!("{} where a number is expected", from.describe()))?;
    }
    if let Some(bad) = read.iter().map(|x| x.value()).find(|x| !x.is_finite()) {
        return Err(format!("{bad} is no finite number"));
    }
    Ok(Vertex::new(read[0], read[1], read[2]))
}

fn read_table<T: Scalar>(place: Place, node: &Node) -> Result<Entry<T>> {
    const KEYS: [&str; 8] = [
        "arc_to",
        "radius",
        "through",
        "center",
        "direction",
        "large",
        "at",
        "fillet",
    ];
    if let Node::Table(entries) = node
        && entries.contains_key("circle")
    {
        let message = "a circle among the vertices of a loop";
        return Err(
            ModelError::new(&place.key("circle").itself(), message).with_help(
                "a circle is a loop of its own: loops = [ [...], { circle = r, at = [x, y] } ]",
            ),
        );
    }
    let table = Table::new(node, place.clone(), &KEYS, ENTRIES)?;
    let only = |keys: &[&str], what: &str| {
        let help = format!("{what} has the keys {}", keys.join(", "));
        Table::new(node, place.clone(), keys, &help).map_err(|e| e.with_help(help.as_str()))
    };
    if table.get("arc_to").is_some() {
        let (table, arc) = match the_one(&table, ["radius", "through", "center"])? {
            "radius" => {
                let keys = ["arc_to", "radius", "direction", "large", "fillet"];
                let table = only(&keys, "an arc of a radius")?;
                let size = if table.flag("large")? {
                    ArcSize::Long
                } else {
                    ArcSize::Short
                };
                let radius = table.number("radius")?.unwrap_or(T::constant(0.0));
                let arc = Arc::Radius(radius, direction(&table)?, size);
                (table, arc)
            }
            "through" => {
                let table = only(&["arc_to", "through", "fillet"], "an arc through a point")?;
                let through = point(&table, "through")?;
                (table, Arc::Through(through))
            }
            _ => {
                let keys = ["arc_to", "center", "direction", "fillet"];
                let table = only(&keys, "an arc about a centre")?;
                let arc = Arc::Center(point(&table, "center")?, direction(&table)?);
                (table, arc)
            }
        };
        return Ok(Entry::To {
            to: point(&table, "arc_to")?,
            arc: Some(arc),
            fillet: table.number("fillet")?,
            bulge: T::constant(0.0),
        });
    }
    if table.get("at").is_some() {
        let table = only(&["at", "fillet"], "a vertex in braces")?;
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
        .find(|key| table.get(key).is_some())
    {
        let message = format!("`{key}` is given without `arc_to`");
        return Err(ModelError::new(&place.key(key).itself(), message).with_help(
            "say where the arc ends: { arc_to = [x, y], radius = r }, or with through = [x, y] or center = [x, y]",
        ));
    }
    match table.number("fillet")? {
        Some(radius) => Ok(Entry::Fillet(radius)),
        None => Err(ModelError::new(&place, "an empty table").with_help(ENTRIES)),
    }
}

/// The one of three keys that is given.
fn the_one(table: &Table<'_>, keys: [&'static str; 3]) -> Result<&'static str> {
    let given: Vec<&str> = (keys.into_iter())
        .filter(|key| table.get(key).is_some())
        .collect();
    match given[..] {
        [one] => Ok(one),
        [] => Err(
            ModelError::new(&table.place, "`arc_to` is given without what arc it is")
                .with_help("add one of radius = r, through = [x, y] and center = [x, y]"),
        ),
        [first, second, ..] => {
            let message = format!("both `{first}` and `{second}` are given");
            Err(
                ModelError::new(&table.place.key(second).itself(), message).with_help(format!(
                    "one of them says what arc it is: keep `{first}` or `{second}`, and remove the other"
                )),
            )
        }
    }
}

fn point<T: Scalar>(table: &Table<'_>, key: &str) -> Result<Point<T>> {
    (table.place_at(key)?).ok_or_else(|| table.missing(key, &format!("{key} = [1.5, -2]")))
}

/// Direction of an arc; counter-clockwise by default.
fn direction(table: &Table<'_>) -> Result<Direction> {
    const NAMES: [&str; 2] = ["ccw", "cw"];
    match table.text("direction")? {
        None | Some("ccw") => Ok(Direction::CounterClockwise),
        Some("cw") => Ok(Direction::Clockwise),
        Some(other) => {
            let error = table.error("direction", format!("unknown direction {}", quoted(other)));
            Err(error.with_help(match nearest(other, NAMES) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => "give direction = \"ccw\" for counter-clockwise or \"cw\" for clockwise"
                    .to_owned(),
            }))
        }
    }
}
