//! Bodies: the parts of a file that `rigid` joints make one.

use cspace::Axis;

use super::error::ModelError;
use super::part_dynamics::read_part_dynamics;
use super::parts::each_part;
use super::place::Place;
use super::relations::read_welds;
use super::scope::Result;
use super::table::Table;
use crate::mechanism::{BodyError, DynamicsError, PartDynamics, PartEntry};
use crate::shown::quoted;

/// The parts of a mechanism, each of one or several parts of the file.
pub(super) struct Bodies {
    pub(super) parts: Vec<PartEntry>,
    /// For each, the parts of the file, by their numbers.
    pub(super) of: Vec<Vec<usize>>,
}

impl Bodies {
    /// Makes one of all parts that are joined rigidly, in the place of the first.
    pub(super) fn read(root: &Table<'_>, drawn: Vec<PartEntry>) -> Result<Self> {
        let welds = read_welds(root, &drawn)?;
        if welds.is_empty() {
            let of = (0..drawn.len()).map(|i| vec![i]).collect();
            return Ok(Self { parts: drawn, of });
        }
        let mut first: Vec<usize> = (0..drawn.len()).collect();
        for weld in &welds {
            let [a, b] = weld.parts.map(|i| first[i]);
            for f in first.iter_mut().filter(|f| **f == a.max(b)) {
                *f = a.min(b);
            }
        }
        let motions = each_part(root, |i, table| {
            Ok(table.has("motion").then_some(drawn[i].axis))
        })?;
        let mut bodies = Self {
            parts: Vec::new(),
            of: Vec::new(),
        };
        for i in (0..drawn.len()).filter(|&i| first[i] == i) {
            let of: Vec<usize> = (i..drawn.len()).filter(|&k| first[k] == i).collect();
            if let [_] = of[..] {
                bodies.parts.push(drawn[i].clone());
            } else {
                let weld = welds.iter().find(|w| of.contains(&w.parts[0]));
                let place = weld.map_or_else(|| root.place.clone(), |w| w.place.clone());
                bodies
                    .parts
                    .push(body(root, &place, &drawn, &of, &motions)?);
            }
            bodies.of.push(of);
        }
        Ok(bodies)
    }

    /// Masses and motions at the start, of each part of the mechanism.
    pub(super) fn dynamics(&self, root: &Table<'_>) -> Result<Vec<PartDynamics>> {
        let mut body = vec![0; self.of.iter().map(Vec::len).sum()];
        for (b, of) in self.of.iter().enumerate() {
            of.iter().for_each(|&i| body[i] = b);
        }
        let each = each_part(root, |i, table| {
            let entry = &self.parts[body[i]];
            let given = read_part_dynamics(table, entry.axis)?;
            (given.check(i, entry)).map_err(|e| fault(&table.place, &e))?;
            Ok(given)
        })?;
        let whole = |(entry, of): (&PartEntry, &Vec<usize>)| {
            if let [i] = of[..] {
                return Ok(each[i]);
            }
            let drawn = entry.drawn();
            let members: Vec<_> = drawn.iter().zip(of.iter().map(|&i| each[i])).collect();
            let names: Vec<&str> = drawn.iter().map(|p| p.name()).collect();
            PartDynamics::body(&members).map_err(|e| no_body(root, &root.place, &names, of, &e))
        };
        self.parts.iter().zip(&self.of).map(whole).collect()
    }

    /// The place of what a file says of a part of the mechanism with a key: where one of its members says it.
    pub(super) fn place(&self, root: &Table<'_>, part: usize, key: &str) -> Result<Place> {
        let places = each_part(root, |i, table| {
            let says = self.of[part].contains(&i) && table.has(key);
            Ok(says.then(|| table.place.clone()))
        })?;
        let first = root.place.key("part").item(self.of[part][0]);
        let first = first.called(format!(
            "part {} {}",
            self.of[part][0],
            quoted(self.parts[part].part.name())
        ));
        Ok(places.into_iter().flatten().next().unwrap_or(first))
    }
}

/// The body of some parts of the file.
fn body(
    root: &Table<'_>,
    place: &Place,
    drawn: &[PartEntry],
    of: &[usize],
    motions: &[Option<Option<Axis>>],
) -> Result<PartEntry> {
    let members: Vec<PartEntry> = of.iter().map(|&i| drawn[i].clone()).collect();
    let names: Vec<&str> = members.iter().map(|m| m.part.name()).collect();
    let refused = |e: BodyError| no_body(root, place, &names, of, &e);
    // That a part moves freely is a motion, too, where it is written.
    let mut says = (of.iter().enumerate()).filter_map(|(k, &i)| Some((k, motions[i]?)));
    if let Some((first, motion)) = says.next()
        && let Some((second, _)) = says.find(|(_, other)| *other != motion)
    {
        let key = "motion";
        return Err(refused(BodyError::Differ { key, first, second }));
    }
    let body = PartEntry::body(&members).map_err(refused)?;
    match drawn.iter().find(|p| p.part.name() == body.part.name()) {
        Some(other) => {
            let name = quoted(other.part.name());
            let message = format!("the parts are one body called {name}, as another part is");
            Err(ModelError::new(place, message).with_help("give that part another name"))
        }
        None => Ok(body),
    }
}

/// Error for parts that make no body, in the words of the file; `place` is that of a joint between two of them.
fn no_body(
    root: &Table<'_>,
    place: &Place,
    names: &[&str],
    of: &[usize],
    error: &BodyError,
) -> ModelError {
    match *error {
        BodyError::Differ { key, first, second } => {
            let [a, b] = [first, second].map(|k| format!("part {} {}", of[k], quoted(names[k])));
            let at = root.place.key("part").item(of[second]).called(&*b).key(key);
            let message = format!("`{key}` differs from that of {a}, and the two are one body");
            ModelError::new(&at, message).with_help(format!(
                "they are joined rigidly and move as one: give `{key}` of one of them, or the same of both, or remove the rigid joint"
            ))
        }
        BodyError::Outline(ref error) => {
            let body = quoted(&names.join(" + "));
            ModelError::new(place, format!("the parts make no body {body}: {error}"))
                .with_help("join fewer parts rigidly, or draw them as one part")
        }
    }
}

/// Error for a value of a part that can be read but is invalid, at its key in the file.
fn fault(part: &Place, error: &DynamicsError) -> ModelError {
    let message = format!("`{}`: {}", error.key, error.fault);
    ModelError::new(&part.key(error.key), message).with_help(error.fault.help())
}
