//! Entries of a loop that are written once: `{ repeat = 20, about = [0, 0], path = [...] }` and `{ mirror = "y", path = [...] }`; and
//! `pattern = { count = 6, about = [0, 0] }` of a loop.

use core::f64::consts::TAU;

use cspace::{Point, Rotation, Vector, Vertex};
use cspace_drawing::Mirror;

use super::entry::{Arc, Entry, read_entry};
use super::error::ModelError;
use super::keys::{Key, Keys};
use super::node::Node;
use super::place::Place;
use super::placement::AXES;
use super::scope::{Result, Scalar, Scope};
use super::table::Table;
use super::value::Value;

/// How paths are written that stand for many entries.
const COPIED: &str = "give a path that is repeated, { repeat = 20, about = [0, 0], path = [...] }, or mirrored, { mirror = \"y\", path = [...] }";

#[rustfmt::skip]
pub(super) const COPIES: Keys = Keys::new(
    COPIED,
    &[
        Key::new("path", "entries", "Entries that are repeated or mirrored."),
        Key::new("repeat", "count", "How many copies of the path there are, each turned about a point by one part of a turn more."),
        Key::new("about", "point", "The point about which copies are turned.").like("about = [0, 0], the point it turns about"),
        Key::new("mirror", "x|y", "The axis through [0, 0] at which the path is mirrored: x turns y around, y turns x around."),
    ],
);

#[rustfmt::skip]
pub(super) const PATTERN: Keys = Keys::new(
    "give it as pattern = { count = 6, about = [0, 0] }",
    &[
        Key::new("count", "count", "How many loops there are.").needed("count = 6"),
        Key::new("about", "point", "The point about which they are turned.").needed("about = [0, 0]"),
    ],
);

/// The most entries that patterns may make of a loop, and loops that they may make of one.
const MOST: usize = 1_000_000;

/// Ends of a path and its copies nearer than this are one place, relative to the largest coordinate: turned points are rounded.
const ONE_PLACE: f64 = 1e-9;

/// An entry, and the number of the one in the file that it comes from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Item<T = f64> {
    pub(super) entry: Entry<T>,
    pub(super) from: usize,
}

/// The entries of a loop, with patterns written out; `place` gives the place of each.
pub(super) fn written_out<T: Scalar>(
    nodes: &[Node],
    place: &dyn Fn(usize) -> Place,
    scope: &Scope,
) -> Result<Vec<Item<T>>> {
    let mut items = entries(nodes, place, scope)?;
    if nodes.iter().any(is_pattern) {
        close(&mut items);
    }
    Ok(items)
}

/// The entries of a loop or path.
fn entries<T: Scalar>(
    nodes: &[Node],
    place: &dyn Fn(usize) -> Place,
    scope: &Scope,
) -> Result<Vec<Item<T>>> {
    let mut items = Vec::with_capacity(nodes.len());
    for (from, node) in nodes.iter().enumerate() {
        if !is_pattern(node) {
            let entry = read_entry(node, || place(from), scope, nodes)?;
            items.push(Item { entry, from });
            continue;
        }
        let place = place(from);
        for (begins, entry) in copies(Value { node, place, scope })? {
            if begins {
                join(&mut items, Item { entry, from });
            } else {
                items.push(Item { entry, from });
            }
        }
    }
    Ok(items)
}

fn is_pattern(node: &Node) -> bool {
    matches!(node, Node::Table(entries) if entries.contains_key("path"))
}

/// The entries of a pattern, each with whether a copy of the path begins with it.
fn copies<T: Scalar>(value: Value<'_>) -> Result<Vec<(bool, Entry<T>)>> {
    let table = Table::new(value, &COPIES)?;
    let path = table.nodes("path", COPIED)?.unwrap_or_default();
    let path_place = table.place.key("path");
    let inner = |i: usize| {
        path_place
            .item(i)
            .further(&format!("entry {i} of its path"))
    };
    let path: Vec<Entry<T>> = entries(path, &inner, table.scope)?
        .iter()
        .map(|item| item.entry)
        .collect();
    if path.is_empty() {
        return Err(table.error("path", "the path is empty").with_help(COPIED));
    }
    let reflection = table.choice("mirror", "axis", &Mirror::ALL, AXES)?;
    match (table.count("repeat")?, reflection) {
        (Some(count), None) => {
            let about = table.needed("about", table.point("about")?)?;
            let count = count as usize;
            too_many(&table, "repeat", count, path.len())?;
            Ok((0..count)
                .flat_map(|k| {
                    let turn = turn(k, count);
                    let copy = path
                        .iter()
                        .map(move |e| e.mapped(&|p| about + turn * (p - about)));
                    copy.enumerate().map(|(i, entry)| (i == 0, entry))
                })
                .collect())
        }
        (None, Some(mirror)) => {
            if table.has("about") {
                let error = table.error_at_key("about", "`about` is given without `repeat`");
                return Err(
                    error.with_help("a path is mirrored at an axis through [0, 0]: remove `about`")
                );
            }
            too_many(&table, "mirror", 2, path.len())?;
            mirrored(&path, mirror).ok_or_else(|| {
                table
                    .error(
                        "path",
                        "the path that is mirrored begins with an arc or a fillet",
                    )
                    .with_help("begin it with a vertex [x, y]")
            })
        }
        (None, None) => {
            let message = "a path that is neither repeated nor mirrored";
            Err(ModelError::new(&table.place, message).with_help(COPIED))
        }
        (Some(_), Some(_)) => Err(table
            .error_at_key("mirror", "both `repeat` and `mirror` are given")
            .with_help("put one pattern into the path of the other")),
    }
}

fn too_many(table: &Table<'_>, key: &str, count: usize, length: usize) -> Result<()> {
    match count.checked_mul(length) {
        Some(all) if all <= MOST => Ok(()),
        _ => Err(table
            .error(key, format!("more than {MOST} entries"))
            .with_help("give a smaller number, or a shorter path")),
    }
}

/// Rotation of copy k of `count`: exact for quarter turns.
fn turn<T: Scalar>(k: usize, count: usize) -> Rotation<T> {
    let quarters = (4 * k) / count;
    let rest = (4 * k) % count;
    let within = Rotation::by(TAU / 4.0 * rest as f64 / count as f64);
    let Rotation { cos, sin } = (0..quarters % 4).fold(within, |turn, _| Rotation {
        cos: -turn.sin,
        sin: turn.cos,
    });
    Rotation {
        cos: T::constant(cos),
        sin: T::constant(sin),
    }
}

/// A corner of a path: where it is, its fillet, and the edge that leaves it.
struct Corner<T> {
    at: Point<T>,
    fillet: Option<T>,
    bulge: T,
    arc: Option<Arc<T>>,
}

/// A path and its mirror image, travelled back. `None` if the path has no vertex to begin with.
///
/// Mirroring and travelling back each exchange left and right: bulges and directions of arcs stay.
fn mirrored<T: Scalar>(path: &[Entry<T>], mirror: Mirror) -> Option<Vec<(bool, Entry<T>)>> {
    let zero = T::constant(0.0);
    let mut corners: Vec<Corner<T>> = Vec::with_capacity(path.len());
    for entry in path {
        let (at, arc, fillet, bulge) = match *entry {
            Entry::Vertex(v) => (v.point(), None, None, v.bulge),
            Entry::To {
                to,
                arc,
                fillet,
                bulge,
            } => (to, arc, fillet, bulge),
            Entry::Fillet(radius) => {
                corners.last_mut()?.fillet = Some(radius);
                continue;
            }
        };
        if arc.is_some() {
            corners.last_mut()?.arc = arc;
        }
        corners.push(Corner {
            at,
            fillet,
            bulge,
            arc: None,
        });
    }
    let last = corners.len().checked_sub(1)?;
    let mut all: Vec<(bool, Entry<T>)> = (path.iter().enumerate())
        .map(|(i, entry)| (i == 0, *entry))
        .collect();
    for (k, corner) in corners.iter().enumerate().rev() {
        let before = k.checked_sub(1).map(|b| &corners[b]);
        let arc = corner
            .arc
            .filter(|_| k < last)
            .map(|arc| arc.mapped(&|p| mirror.point(p)));
        let bulge = before.filter(|b| b.arc.is_none()).map_or(zero, |b| b.bulge);
        let to = mirror.point(corner.at);
        // A corner on the axis is its own image, and has its fillet already.
        let fillet = corner.fillet.filter(|_| !is_one(to, corner.at));
        let entry = Entry::To {
            to,
            arc,
            fillet,
            bulge,
        };
        all.push((k == last, entry));
    }
    Some(all)
}

/// Adds the beginning of a copy: where it is at the last corner already, the two are one.
fn join<T: Scalar>(items: &mut Vec<Item<T>>, next: Item<T>) {
    let corner = items
        .iter_mut()
        .rev()
        .find(|item| item.entry.at().is_some());
    let (Some(corner), Some(to)) = (corner, next.entry.at()) else {
        items.push(next);
        return;
    };
    let one = corner.entry.at().is_some_and(|at| is_one(at, to));
    match next.entry {
        Entry::Vertex(v) if one => corner.entry.leave_by(v.bulge),
        Entry::To {
            arc: None,
            fillet,
            bulge,
            ..
        } if one => {
            corner.entry.leave_by(bulge);
            if let Some(radius) = fillet {
                items.push(Item {
                    entry: Entry::Fillet(radius),
                    ..next
                });
            }
        }
        _ => items.push(next),
    }
}

/// Lets a loop end where it begins, if it does so but for rounding.
fn close<T: Scalar>(items: &mut [Item<T>]) {
    let first = items.iter().find_map(|item| item.entry.at());
    let corner = items
        .iter_mut()
        .rev()
        .find(|item| item.entry.at().is_some());
    if let (Some(first), Some(corner)) = (first, corner)
        && corner.entry.at().is_some_and(|at| is_one(at, first))
    {
        corner.entry.put(first);
    }
}

fn is_one<T: Scalar>(p: Point<T>, q: Point<T>) -> bool {
    let [p, q] = [p, q].map(|p| p.map(T::value));
    let largest = [p.x, p.y, q.x, q.y]
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max);
    p.distance(q) <= ONE_PLACE * largest
}

impl<T: Scalar> Entry<T> {
    /// Position of its vertex; `None` for a fillet.
    fn at(&self) -> Option<Point<T>> {
        match self {
            Self::Vertex(v) => Some(v.point()),
            Self::To { to, .. } => Some(*to),
            Self::Fillet(_) => None,
        }
    }

    /// Moves its vertex.
    fn put(&mut self, at: Point<T>) {
        match self {
            Self::Vertex(v) => *v = Vertex::new(at.x, at.y, v.bulge),
            Self::To { to, .. } => *to = at,
            Self::Fillet(_) => {}
        }
    }

    /// Gives the edge that leaves its vertex a bulge.
    fn leave_by(&mut self, by: T) {
        match self {
            Self::Vertex(v) => v.bulge = by,
            Self::To { bulge, .. } => *bulge = by,
            Self::Fillet(_) => {}
        }
    }

    /// The entry with all its points mapped by a motion.
    fn mapped(&self, map: &impl Fn(Point<T>) -> Point<T>) -> Self {
        match *self {
            Self::Vertex(v) => {
                let at = map(v.point());
                Self::Vertex(Vertex::new(at.x, at.y, v.bulge))
            }
            Self::To {
                to,
                arc,
                fillet,
                bulge,
            } => Self::To {
                to: map(to),
                arc: arc.map(|arc| arc.mapped(map)),
                fillet,
                bulge,
            },
            Self::Fillet(radius) => Self::Fillet(radius),
        }
    }
}

impl<T: Scalar> Arc<T> {
    fn mapped(self, map: &impl Fn(Point<T>) -> Point<T>) -> Self {
        match self {
            Self::Radius(..) => self,
            Self::Through(through) => Self::Through(map(through)),
            Self::Center(center, direction) => Self::Center(map(center), direction),
        }
    }
}

/// Repetition of a loop about a point.
pub(super) struct Pattern<T> {
    pub(super) count: usize,
    about: Point<T>,
}

impl<T: Scalar> Pattern<T> {
    /// Reads the key `pattern`; a single copy if there is none.
    pub(super) fn read(table: &Table<'_>) -> Result<Self> {
        let Some(value) = table.get("pattern") else {
            return Ok(Self {
                count: 1,
                about: Point::new(T::constant(0.0), T::constant(0.0)),
            });
        };
        let table = Table::new(value.further("pattern"), &PATTERN)?;
        let count = table.needed("count", table.count("count")?)?;
        let about = table.needed("about", table.point("about")?)?;
        Ok(Self {
            count: count as usize,
            about,
        })
    }

    /// The vertices of all copies.
    pub(super) fn copies(
        &self,
        vertices: &[Vertex<T>],
        table: &Table<'_>,
    ) -> Result<Vec<Vec<Vertex<T>>>> {
        too_many(table, "pattern", self.count, vertices.len())?;
        let copy = |k: usize| {
            let turn = turn(k, self.count);
            let turned = |v: &Vertex<T>| {
                let from: Vector<T> = v.point() - self.about;
                let at = self.about + turn * from;
                Vertex::new(at.x, at.y, v.bulge)
            };
            vertices.iter().map(turned).collect()
        };
        Ok((0..self.count).map(copy).collect())
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use crate::ModelError;
    use crate::model::from_toml;
    use cspace::Part;

    fn part(loops: &str) -> Result<Part, ModelError> {
        let text = format!("[[part]]\nname = \"a\"\nloops = [{loops}]\n");
        from_toml(&text, "m.toml").map(|m| m.parts[0].part.clone())
    }

    fn lines(part: &Part) -> (usize, usize) {
        let edges = || part.loops().iter().flat_map(|l| l.edges());
        (edges().count(), edges().filter(|e| e.is_line()).count())
    }

    #[test]
    fn a_path_that_is_repeated_is_joined() {
        // Twenty teeth: a line out, an arc back to where the next one begins.
        let tooth = "[10, 0], [\"12*cos(18deg)\", \"12*sin(18deg)\"]";
        let ratchet = part(&format!(
            "[{{ repeat = 20, about = [0, 0], path = [{tooth}] }}]"
        ))
        .unwrap();
        assert_eq!(lines(&ratchet), (40, 40));
        assert_eq!(ratchet.symmetry().fold(), 20);
        let area = 20.0 * 0.5 * 10.0 * 12.0 * (18f64).to_radians().sin();
        assert!(
            (ratchet.area() - area).abs() < 1e-9 * area,
            "{}",
            ratchet.area()
        );
        // Where a copy ends the next begins: a circle of arcs, one for each copy.
        let circle = part(
            "[{ repeat = 5, about = [1, 2], path = [[4, 2, \"tan(18deg)\"], [\"1 + 3*cos(72deg)\", \"2 + 3*sin(72deg)\"]] }]",
        );
        let circle = circle.unwrap();
        assert_eq!(lines(&circle), (5, 0));
        assert!((circle.area() - 9.0 * PI).abs() < 1e-9);
    }

    #[test]
    fn arcs_and_fillets_are_repeated() {
        let path = "[3, -1], { arc_to = [3, 1], radius = 2 }, { fillet = 0.2 }";
        let flower = part(&format!(
            "[{{ repeat = 4, about = [0, 0], path = [{path}] }}]"
        ))
        .unwrap();
        assert_eq!(flower.symmetry().fold(), 4);
        // An arc, a line and a fillet for each.
        assert_eq!(lines(&flower), (12, 4));
        let through = path.replace(
            "radius = 2",
            "through = [\"1 + sqrt(3)*0 + 2.2679491924311228\", 0]",
        );
        let again = part(&format!(
            "[{{ repeat = 4, about = [0, 0], path = [{through}] }}]"
        ))
        .unwrap();
        assert!((again.area() - flower.area()).abs() < 1e-9);
    }

    #[test]
    fn a_path_that_is_mirrored_is_travelled_back() {
        // Half a keyhole from axis to axis.
        let half = "[0, -1], [2, -1], { fillet = 0.25 }, { arc_to = [2, 1], radius = 3 }, [1, 1, -0.3], [1, 4], { at = [0, 5], fillet = 0.5 }";
        let whole = part(&format!("[{{ mirror = \"y\", path = [{half}] }}]")).unwrap();
        let bounds = whole.bounds();
        assert!((bounds.min.x + bounds.max.x).abs() < 1e-12);
        // The left half alone, drawn by hand, has half the area.
        let closed =
            part(&format!("[{half}]").replace("{ at = [0, 5], fillet = 0.5 }", "[0, 5]")).unwrap();
        let sharp = part(
            &format!("[{{ mirror = \"y\", path = [{half}] }}]")
                .replace("{ at = [0, 5], fillet = 0.5 }", "[0, 5]"),
        );
        assert!((sharp.unwrap().area() - 2.0 * closed.area()).abs() < 1e-9);
        // At the other axis the same outline lies on its side.
        let swapped = "[-1, 0], [-1, 2], { fillet = 0.25 }, { arc_to = [1, 2], radius = 3, direction = \"cw\" }, [1, 1, 0.3], [4, 1], { at = [5, 0], fillet = 0.5 }";
        let other = part(&format!("[{{ mirror = \"x\", path = [{swapped}] }}]")).unwrap();
        assert!((other.area() - whole.area()).abs() < 1e-9);
    }

    #[test]
    fn patterns_are_nested() {
        // A tooth with two like flanks, eight times.
        let tooth = "{ mirror = \"y\", path = [[-1, 5], [-0.5, 6]] }";
        let gear = part(&format!(
            "[{{ repeat = 8, about = [0, 0], path = [{tooth}] }}]"
        ));
        assert!(gear.is_err(), "it is drawn clockwise");
        let tooth = "{ mirror = \"y\", path = [[1, 5], [0.5, 6]] }";
        let gear = part(&format!(
            "[{{ repeat = 8, about = [0, 0], path = [{tooth}] }}]"
        ))
        .unwrap();
        assert_eq!(gear.symmetry().fold(), 8);
        assert_eq!(lines(&gear), (32, 32));
    }

    #[test]
    fn loops_are_repeated() {
        let plate = part(
            "{ circle = 10, at = [0, 0] }, { circle = 1, at = [7, 0], pattern = { count = 6, about = [0, 0] } }, { path = [[3, -1], [5, -1], [5, 1], [3, 1]], pattern = { count = 3, about = [0, 0] } }",
        )
        .unwrap();
        assert_eq!(plate.loops().len(), 10);
        assert!((plate.area() - (94.0 * PI - 12.0)).abs() < 1e-9);
        assert_eq!(plate.symmetry().fold(), 3);
    }

    #[test]
    fn what_is_wrong_is_told_where_it_is() {
        for (loops, place, message, help) in [
            (
                "[{ repeat = 3, path = [[1, 0]] }]",
                "loop 0, entry 0",
                "`about` is missing",
                "about = [0, 0]",
            ),
            (
                "[{ path = [[1, 0]] }]",
                "loop 0, entry 0",
                "neither repeated nor mirrored",
                "repeat = 20",
            ),
            (
                "[{ repeat = 3, mirror = \"x\", about = [0, 0], path = [[1, 0]] }]",
                "entry 0",
                "both",
                "into the path",
            ),
            (
                "[{ mirror = \"z\", path = [[1, 0]] }]",
                "entry 0",
                "unknown axis \"z\"",
                "did you mean `x`?",
            ),
            (
                "[{ mirror = \"x\", path = [{ fillet = 1 }] }]",
                "entry 0",
                "begins with an arc or a fillet",
                "[x, y]",
            ),
            (
                "[{ repeat = 3, about = [0, 0], path = [] }]",
                "entry 0",
                "the path is empty",
                "repeat",
            ),
            (
                "[{ repeat = 1000000, about = [0, 0], path = [[1, 0], [2, 0]] }]",
                "entry 0",
                "more than 1000000",
                "smaller",
            ),
            (
                "[{ repeat = 0, about = [0, 0], path = [[1, 0]] }]",
                "entry 0",
                "where a whole number",
                "1 to",
            ),
            (
                "[[0, 0], { repeat = 3, about = [0, 0], path = [[1, 0], [1]] }]",
                "entry 1, entry 1 of its path",
                "where a vertex",
                "[x, y]",
            ),
            (
                "{ circle = 1, at = [5, 0], pattern = { count = 90, about = [0, 0] } }",
                "part 0",
                "cross",
                "",
            ),
            (
                "{ circle = 1, at = [5, 0], pattern = { cuont = 9, about = [0, 0] } }",
                "loop 0, pattern",
                "unknown key",
                "count",
            ),
        ] {
            let e = part(loops).unwrap_err();
            assert!(e.place().contains(place), "{loops}: {e}");
            assert!(e.message().contains(message), "{loops}: {e}");
            assert!(
                e.help().unwrap_or_default().contains(help),
                "{loops}: {e}: {:?}",
                e.help()
            );
        }
    }
}
