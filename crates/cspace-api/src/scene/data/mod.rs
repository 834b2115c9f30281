//! The scene: all that the page shows, as data. `page/src/scene.ts` has the same types, and `docs/page.md` describes them.

mod joint;
mod pair;
mod part;

pub use joint::{JointKind, SceneJoint};
pub use pair::{Counts, ScenePair, SceneRegion};
pub use part::{SceneMotion, ScenePart};

use cspace_model::{Mechanism, PairEntry, View};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::scene::design::{SceneDesign, SceneText};

/// Value of `format`.
pub const FORMAT: &str = "cspace-scene";

/// The version that is written.
pub const VERSION: u32 = 1;

/// Data of a page. Angles are radians, lengths in the model's unit.
#[derive(Debug, Clone, Serialize)]
pub struct Scene {
    /// Always [`FORMAT`].
    pub format: &'static str,
    /// Always [`VERSION`].
    pub version: u32,
    /// Name of the model.
    pub name: String,
    /// The label of the unit of length.
    pub unit: Option<String>,
    /// The parts.
    pub parts: Vec<ScenePart>,
    /// The permanent connections.
    pub joints: Vec<SceneJoint>,
    /// The pairs that are shown.
    pub pairs: Vec<ScenePair>,
    /// First view.
    pub show: SceneShow,
    /// Recordings to be played.
    pub records: Vec<SceneRecord>,
    /// The parameters and requirements of the model, if it has any and its text is here.
    pub design: Option<SceneDesign>,
    /// Source from which the pairs are computed again once parts are edited; `None` for a model that cannot be written.
    pub source: Option<SceneSource>,
}

/// A model, and which of its pairs are shown: all that [`Opened`](crate::scene::Opened) has but for spaces and records.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneSource {
    /// The model as TOML, with all values as numbers.
    pub model: String,
    /// The pairs in the order of the scene, in their windows.
    pub pairs: Vec<PairEntry>,
    /// Whether the general method is used for pairs of any class.
    pub general: bool,
    /// The text with the parameters of the model.
    pub design: Option<SceneText>,
}

/// JSON printed by `cspace plan`, `cspace disassemble` or `cspace simulate`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneRecord {
    /// Name of the file.
    pub name: String,
    /// The answer.
    pub record: Value,
}

/// First view, as the model's `show` says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SceneShow {
    /// Index of the pair among those of the scene; `None` if the model names none, or it is not shown.
    pub pair: Option<usize>,
    /// The question that it answers.
    pub question: Option<String>,
    /// Part of the view that is large; `None` for the parts.
    pub view: Option<View>,
}

impl SceneShow {
    /// First view of a mechanism by these of its pairs.
    fn of(model: &Mechanism, pairs: &[ScenePair]) -> Self {
        let show = &model.show;
        let shown = |p: &ScenePair| show.pair == Some((p.fixed, p.moving));
        Self {
            pair: pairs.iter().position(shown),
            question: show.question.clone(),
            view: show.view,
        }
    }
}

impl Scene {
    /// The scene of a mechanism, with these of its pairs.
    pub fn of(model: &Mechanism, pairs: Vec<ScenePair>, records: Vec<SceneRecord>) -> Self {
        Self {
            format: FORMAT,
            version: VERSION,
            name: model.name.clone(),
            unit: model.unit.clone(),
            parts: model.parts.iter().map(ScenePart::of).collect(),
            joints: model.joints.iter().map(SceneJoint::of).collect(),
            show: SceneShow::of(model, &pairs),
            pairs,
            records,
            design: None,
            source: None,
        }
    }
}
