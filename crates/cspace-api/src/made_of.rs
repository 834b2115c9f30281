//! Hashes of those parts of a model that a motion depends on, kept in its record: a motion goes on only with what it was made of.

use cspace_model::Mechanism;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};

/// So many bytes of a hash tell models apart that are not made to have the same.
const BYTES: usize = 8;

/// The first eight bytes of the SHA-256 of what is in a model, as hexadecimal digits. Neither the model's name nor its unit moves anything.
#[derive(Debug, Serialize, JsonSchema)]
pub struct MadeOf {
    /// Hash of outlines and axes of parts.
    pub parts: String,
    /// Hash of joints.
    pub joints: String,
    /// Hash of pairs.
    pub pairs: String,
    /// Hash of masses, starts and rates of parts.
    pub masses: String,
    /// Hash of gravity.
    pub gravity: String,
    /// Hash of friction and restitution.
    pub friction: String,
    /// Hash of drives.
    pub drives: String,
    /// Hash of loads.
    pub loads: String,
    /// Hash of springs.
    pub springs: String,
}

impl MadeOf {
    /// Hashes of a model.
    ///
    /// # Errors
    /// If it cannot be written as JSON, which plain data always can.
    pub fn of(model: &Mechanism) -> serde_json::Result<Self> {
        let dynamics = &model.dynamics;
        Ok(Self {
            parts: hash(&model.parts)?,
            joints: hash(&model.joints)?,
            pairs: hash(&model.pairs)?,
            masses: hash(&dynamics.parts)?,
            gravity: hash(&dynamics.gravity)?,
            friction: hash(&(dynamics.friction, dynamics.restitution, &dynamics.pairs))?,
            drives: hash(&dynamics.drives)?,
            loads: hash(&dynamics.loads)?,
            springs: hash(&dynamics.springs)?,
        })
    }

    /// Differences from a record, in words. Entries that an older record lacks count as the same.
    pub fn others(&self, told: &Value) -> Vec<&'static str> {
        let all = [
            ("parts", "outlines or axes of parts", &self.parts),
            ("joints", "joints", &self.joints),
            ("pairs", "pairs", &self.pairs),
            ("masses", "masses, starts or rates of parts", &self.masses),
            ("gravity", "gravity", &self.gravity),
            ("friction", "friction or restitution", &self.friction),
            ("drives", "drives", &self.drives),
            ("loads", "loads", &self.loads),
            ("springs", "springs", &self.springs),
        ];
        let is_other = |key: &str, hash: &String| {
            let told = told.get(key).and_then(Value::as_str);
            told.is_some_and(|told| told != hash)
        };
        (all.into_iter())
            .filter(|(key, _, hash)| is_other(key, hash))
            .map(|(_, words, _)| words)
            .collect()
    }
}

/// Hash of data as it is written to JSON: the same numbers have the same hash.
fn hash(what: &impl Serialize) -> serde_json::Result<String> {
    let text = serde_json::to_vec(what)?;
    let digest = Sha256::digest(&text);
    let bytes = digest.iter().take(BYTES);
    Ok(bytes.map(|b| format!("{b:02x}")).collect())
}
