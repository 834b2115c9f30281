//! Parts as data: a name, for every loop its vertices, the layers if there are heights, and the names of edges and vertices.

use serde::de::Error;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::{Part, PartFeature, Vertex};

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let loops: Vec<&[Vertex]> = self.loops().iter().map(|l| l.vertices()).collect();
        let named = usize::from(!self.names.is_empty());
        let high = usize::from(self.has_heights());
        let mut part = to.serialize_struct("Part", 2 + named + high)?;
        part.serialize_field("name", self.name())?;
        part.serialize_field("loops", &loops)?;
        if high == 1 {
            let layers: Vec<Height> = (self.layers().iter())
                .map(|l| Height {
                    z: l.z(),
                    loops: l.loops().len(),
                })
                .collect();
            part.serialize_field("layers", &layers)?;
        }
        if named == 1 {
            part.serialize_field("names", &self.names)?;
        }
        part.end()
    }
}

/// A layer: its heights, and the number of its loops.
#[derive(Serialize, Deserialize)]
struct Height {
    z: Option<[f64; 2]>,
    loops: usize,
}

/// Arguments of [`Part::layered`] and [`Part::with_feature_name`].
#[derive(Deserialize)]
#[serde(rename = "Part")]
struct Drawing {
    name: String,
    loops: Vec<Vec<Vertex>>,
    #[serde(default)]
    layers: Vec<Height>,
    #[serde(default)]
    names: Vec<(PartFeature, String)>,
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let Drawing {
            name,
            loops,
            mut layers,
            names,
        } = Drawing::deserialize(from)?;
        if layers.is_empty() {
            let (z, loops) = (None, loops.len());
            layers.push(Height { z, loops });
        }
        if layers
            .iter()
            .try_fold(0, |n: usize, l| n.checked_add(l.loops))
            != Some(loops.len())
        {
            let message = format!("part {name:?}: its layers do not have as many loops as it has");
            return Err(Error::custom(message));
        }
        let mut loops = loops.into_iter();
        let layers = (layers.into_iter()).map(|l| (l.z, loops.by_ref().take(l.loops).collect()));
        let part = Self::layered(name.clone(), layers).and_then(|part| {
            (names.into_iter()).try_fold(part, |part, (feature, of)| {
                part.with_feature_name(feature, of)
            })
        });
        part.map_err(|e| Error::custom(format!("part {name:?}: {e}")))
    }
}
