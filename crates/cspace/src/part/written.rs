//! Parts as data: a name, for every loop its vertices, and the names of edges and vertices.

use serde::de::Error;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Part, PartFeature, Vertex};

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let loops: Vec<&[Vertex]> = self.loops().iter().map(|l| l.vertices()).collect();
        let named = usize::from(!self.names.is_empty());
        let mut part = to.serialize_struct("Part", 2 + named)?;
        part.serialize_field("name", self.name())?;
        part.serialize_field("loops", &loops)?;
        if named == 1 {
            part.serialize_field("names", &self.names)?;
        }
        part.end()
    }
}

/// Arguments of [`Part::new`] and [`Part::with_feature_name`].
#[derive(Deserialize)]
#[serde(rename = "Part")]
struct Drawing {
    name: String,
    loops: Vec<Vec<Vertex>>,
    #[serde(default)]
    names: Vec<(PartFeature, String)>,
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let Drawing { name, loops, names } = Drawing::deserialize(from)?;
        let part = Self::new(name.clone(), loops).and_then(|part| {
            (names.into_iter()).try_fold(part, |part, (feature, of)| {
                part.with_feature_name(feature, of)
            })
        });
        part.map_err(|e| Error::custom(format!("part {name:?}: {e}")))
    }
}
