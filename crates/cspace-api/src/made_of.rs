//! Hashes of those parts of a model that a motion depends on, kept in its record: a motion goes on only with what it was made of.

use std::collections::BTreeMap;

use cspace_mechanism::Mechanism;
use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// So many bytes of a hash tell models apart that are not made to have the same.
const BYTES: usize = 8;

/// Hashes by what they are of. Neither the model's name nor its unit moves anything.
#[derive(Debug, Serialize)]
#[serde(transparent)]
pub struct MadeOf(BTreeMap<&'static str, String>);

impl MadeOf {
    /// Hashes of a model.
    ///
    /// # Errors
    /// If it cannot be written as JSON, which plain data always can.
    pub fn of(model: &Mechanism) -> serde_json::Result<Self> {
        let dynamics = &model.dynamics;
        let all = [
            ("parts", hash(&model.parts)?),
            ("joints", hash(&model.joints)?),
            ("pairs", hash(&model.pairs)?),
            ("masses", hash(&dynamics.parts)?),
            ("gravity", hash(&dynamics.gravity)?),
            (
                "friction",
                hash(&(dynamics.friction, dynamics.restitution, &dynamics.pairs))?,
            ),
            ("drives", hash(&dynamics.drives)?),
            ("loads", hash(&dynamics.loads)?),
            ("springs", hash(&dynamics.springs)?),
        ];
        Ok(Self(all.into()))
    }

    /// Names of the entries that differ in a record. Entries that an older record lacks count as the same.
    pub fn others(&self, told: &Value) -> Vec<&'static str> {
        let is_other = |&(what, hash): &(&&str, &String)| {
            let told = told.get(*what).and_then(Value::as_str);
            told.is_some_and(|told| told != hash)
        };
        let others = self.0.iter().filter(is_other);
        others.map(|(what, _)| in_words(what)).collect()
    }
}

/// Hash of data as it is written to JSON: the same numbers have the same hash.
fn hash(what: &impl Serialize) -> serde_json::Result<String> {
    let text = serde_json::to_vec(what)?;
    let digest = Sha256::digest(&text);
    let bytes = digest.iter().take(BYTES);
    Ok(bytes.map(|b| format!("{b:02x}")).collect())
}

fn in_words(what: &'static str) -> &'static str {
    match what {
        "parts" => "outlines or axes of parts",
        "masses" => "masses, starts or rates of parts",
        "friction" => "friction or restitution",
        what => what,
    }
}
