//! Parts as data: a name, and for every loop its vertices.

use serde::de::Error;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Part, Vertex};

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let loops: Vec<&[Vertex]> = self.loops().iter().map(|l| l.vertices()).collect();
        let mut part = to.serialize_struct("Part", 2)?;
        part.serialize_field("name", self.name())?;
        part.serialize_field("loops", &loops)?;
        part.end()
    }
}

/// What [`Part::new`] is given.
#[derive(Deserialize)]
#[serde(rename = "Part")]
struct Drawing {
    name: String,
    loops: Vec<Vec<Vertex>>,
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let Drawing { name, loops } = Drawing::deserialize(from)?;
        Self::new(name.clone(), loops).map_err(|e| Error::custom(format!("part {name:?}: {e}")))
    }
}
