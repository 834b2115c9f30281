//! Writing a model as JSON.

use serde_json::Value;

use super::to_toml;
use crate::mechanism::Mechanism;

/// The model as the text of a JSON file, of the same structure as [`to_toml`] writes. Reading it gives the same model.
///
/// ```
/// use cspace::Part;
/// use cspace_model::{Mechanism, PartEntry, model};
/// let mut mechanism = Mechanism::new("disc");
/// mechanism.parts.push(PartEntry::planar(Part::circle("disc", (0.0, 0.0), 0.5)?));
/// assert_eq!(model::from_json(&model::to_json(&mechanism), "disc.json")?, mechanism);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_json(mechanism: &Mechanism) -> String {
    // The TOML text is valid, and its values are those of JSON.
    let tree: Value = toml::from_str(&to_toml(mechanism)).unwrap_or_default();
    let mut text = serde_json::to_string_pretty(&tree).unwrap_or_default();
    text.push('\n');
    text
}
