//! Content of a page: a model, or a saved space.

use cspace::pair::Joint;
use cspace::{Axis, Options, PairClass, PairError, PairSpace, Progress, Relation, Symmetry};
use cspace_model::model::{Setting, Template};
use cspace_model::{Mechanism, Model, ModelError, PairEntry, PartEntry, SavedFile, shown};
use serde::Serialize;

use crate::scene::data::{Scene, ScenePair, ScenePart, SceneRecord, SceneSource};
use crate::scene::design::{Design, SceneDesign};
use crate::scene::edit::{EditError, Edits, edited};

/// A mechanism, and which of its pairs are shown.
#[derive(Debug)]
pub struct Opened {
    /// The mechanism. Of a saved space it has its two parts, related as they are there.
    pub model: Mechanism,
    /// The pairs that are shown, in their windows.
    pub pairs: Vec<PairEntry>,
    /// Whether the general method is used for pairs of any class.
    pub general: bool,
    /// The space of the one pair, if it was read.
    pub saved: Option<PairSpace>,
    /// Recordings to be played.
    pub records: Vec<SceneRecord>,
    design: Option<Design>,
}

/// A pair of an edited model, and the parts.
#[derive(Debug, Clone, Serialize)]
pub struct EditAnswer {
    /// The pair with its space.
    pub pair: ScenePair,
    /// Parts of the model.
    pub parts: Vec<ScenePart>,
    /// The parameters of the model, if it has any.
    pub design: Option<SceneDesign>,
}

/// Why an edited pair has no space.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum EditedPairError {
    /// There is no such pair.
    #[error("there is no pair {index}: there are {pairs}, counted from 0")]
    NoPair {
        /// The index.
        index: usize,
        /// Number of pairs.
        pairs: usize,
    },
    /// The edited parts are invalid.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// Values for parameters of a model that has none, or whose text is not here.
    #[error("the model has no parameters here")]
    NoParameters,
    /// A part was edited, and does not follow parameters any more.
    #[error("the part {} was edited by hand and follows no parameter; undo its edits first", shown::quoted(.0))]
    Drawn(String),
    /// The model has other parts with the new values of its parameters.
    #[error("with these values the model has other parts")]
    OtherParts,
    /// The space cannot be computed.
    #[error(transparent)]
    Pair(#[from] PairError),
    /// The model cannot be read with these values, or not be written.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The space cannot be written as JSON.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl Opened {
    /// A model with these of its pairs.
    pub fn model(model: Mechanism, pairs: Vec<PairEntry>, general: bool) -> Self {
        Self {
            model,
            pairs,
            general,
            saved: None,
            records: Vec::new(),
            design: None,
        }
    }

    /// A model without parts, to which the page adds some.
    pub fn blank(name: impl Into<String>, unit: Option<String>) -> Self {
        let model = Mechanism {
            unit,
            ..Mechanism::new(name)
        };
        Self::model(model, Vec::new(), false)
    }

    /// Adds the text that the model was read from, and the values given to its parameters: the page offers sliders for
    /// them.
    pub fn with_text(mut self, template: Template, set: Vec<Setting>) -> Self {
        self.design = Design::new(template, set);
        self
    }

    /// A saved space.
    pub fn saved(file: SavedFile) -> Self {
        let space = file.space;
        let (fixed, moving) = (space.fixed(), space.moving());
        let both = || format!("{} and {}", fixed.name(), moving.name());
        let mut model = Mechanism::new(file.name.unwrap_or_else(both));
        model.unit = file.unit;
        let parts = [fixed, moving].map(Clone::clone);
        model.parts = (parts.into_iter().zip(axes(&space)))
            .map(|(part, axis)| PartEntry {
                axis,
                ..PartEntry::planar(part)
            })
            .collect();
        if let PairSpace::Lower(pair) = &space {
            model.joints.push(cspace_model::JointEntry {
                joint: pair.joint(),
                parts: (0, 1),
            });
        }
        let window = match &space {
            PairSpace::Planar(space) if !space.window().full_turn => {
                let window = space.window();
                Some((window.lo, window.hi))
            }
            _ => None,
        };
        let pair = PairEntry {
            fixed: 0,
            moving: 1,
            window,
        };
        model.pairs = vec![pair];
        Self {
            model,
            pairs: vec![pair],
            // A space computed without symmetry is computed without it again.
            general: space.class() == PairClass::General,
            saved: Some(space),
            records: Vec::new(),
            design: None,
        }
    }

    /// Opens the source stored in a scene.
    ///
    /// # Errors
    /// If the text is not a valid model.
    pub fn from_source(source: &SceneSource) -> Result<Self, ModelError> {
        let model = cspace_model::model::from_toml(&source.model, "the model of this page")?;
        let opened = Self::model(model, source.pairs.clone(), source.general);
        let design = match &source.design {
            Some(text) => Design::from_text(text)?,
            None => None,
        };
        Ok(Self { design, ..opened })
    }

    /// Source of the scene, if the model can be written and read again.
    fn source(&self) -> Option<SceneSource> {
        let model = cspace_model::model::to_toml(&self.model);
        cspace_model::model::from_toml(&model, "model.toml").ok()?;
        Some(SceneSource {
            model,
            pairs: self.pairs.clone(),
            general: self.general,
            design: self.design.as_ref().map(Design::text),
        })
    }

    /// The scene, without the spaces of its pairs.
    pub fn scene(&self) -> Scene {
        self.scene_with(self.pairs.iter().map(|p| self.unknown(p)).collect())
    }

    /// The scene with these pairs, one for each that is shown.
    pub fn scene_with(&self, pairs: Vec<ScenePair>) -> Scene {
        Scene {
            source: self.source(),
            design: self.design.as_ref().and_then(Design::opened_scene),
            ..Scene::of(&self.model, pairs, self.records.clone())
        }
    }

    /// A pair with its space, or with the reason why it has none; `clock` returns a time in seconds, from which the
    /// duration of the computation is determined.
    pub fn pair(
        &self,
        index: usize,
        clock: &dyn Fn() -> f64,
        progress: &dyn Progress,
    ) -> Option<ScenePair> {
        let entry = self.pairs.get(index)?;
        let begin = clock();
        let pair = match &self.saved {
            Some(space) => ScenePair::known(entry, space, 0.0).map_err(|e| e.to_string()),
            None => (self
                .compute(&self.model, entry, progress)
                .map_err(|e| e.to_string()))
            .and_then(|space| {
                ScenePair::known(entry, &space, clock() - begin).map_err(|e| e.to_string())
            }),
        };
        Some(pair.unwrap_or_else(|error| self.unknown(entry).failed(error)))
    }

    /// Model with the values and parts of an edit, and its requirements.
    ///
    /// # Errors
    /// If there are no such parameters, the text is not a valid model with these values, or the parts are invalid.
    pub fn edited(&self, edits: &Edits) -> Result<Model, EditedPairError> {
        let mut model = match &self.design {
            Some(design) => design.model(&edits.set)?,
            None if !edits.set.is_empty() => return Err(EditedPairError::NoParameters),
            None => Model {
                mechanism: self.model.clone(),
                parameters: Vec::new(),
                requirements: Vec::new(),
                on_pairs: Vec::new(),
            },
        };
        let known = self.model.parts.iter().map(|p| p.part.name());
        if !known.eq(model.mechanism.parts.iter().map(|p| p.part.name())) {
            return Err(EditedPairError::OtherParts);
        }
        // As it was opened it may have been changed since it was read.
        let base = match edits.set.is_empty() {
            true => &self.model,
            false => &model.mechanism,
        };
        let mut mechanism = edited(base, &edits.parts)?;
        mechanism.name.clone_from(&self.model.name);
        model.mechanism = mechanism;
        Ok(model)
    }

    /// Text of the model with its parameters, and the values that they are given.
    ///
    /// # Errors
    /// If the text is not available, or parts were edited, which do not follow parameters.
    pub fn template(&self, edits: &Edits) -> Result<(&Template, Vec<Setting>), EditedPairError> {
        if let Some(part) = edits.parts.first() {
            let name = self.model.parts.get(part.index).map(|p| p.part.name());
            return Err(EditedPairError::Drawn(name.unwrap_or_default().to_owned()));
        }
        let design = (self.design.as_ref()).ok_or(EditedPairError::NoParameters)?;
        Ok((design.template(), design.settings(&edits.set)))
    }

    /// Pair of an edited model, with the window that follows from the model's parameters.
    ///
    /// # Errors
    /// If there is no such pair.
    pub fn entry(&self, index: usize, model: &Mechanism) -> Result<PairEntry, EditedPairError> {
        let pairs = self.pairs.len();
        let entry = (self.pairs.get(index)).ok_or(EditedPairError::NoPair { index, pairs })?;
        let of_file = self.model.pairs.iter().position(|p| p == entry);
        let now = of_file.and_then(|i| model.pairs.get(i));
        Ok(*now.unwrap_or(entry))
    }

    /// Edited mechanism, and the space of one of its pairs.
    ///
    /// # Errors
    /// If there is no such pair, the edit is invalid, or the space cannot be computed.
    pub fn edited_space(
        &self,
        index: usize,
        edits: &Edits,
        progress: &dyn Progress,
    ) -> Result<(Mechanism, PairSpace), EditedPairError> {
        let model = self.edited(edits)?.mechanism;
        let space = self.compute(&model, &self.entry(index, &model)?, progress)?;
        Ok((model, space))
    }

    /// Pair after an edit; `clock` as for [`pair`](Self::pair).
    ///
    /// # Errors
    /// If there is no such pair, the edit is invalid, or the space cannot be computed.
    pub fn edited_pair(
        &self,
        index: usize,
        edits: &Edits,
        clock: &dyn Fn() -> f64,
        progress: &dyn Progress,
    ) -> Result<EditAnswer, EditedPairError> {
        let begin = clock();
        let model = self.edited(edits)?;
        let entry = self.entry(index, &model.mechanism)?;
        let space = self.compute(&model.mechanism, &entry, progress)?;
        Ok(EditAnswer {
            pair: ScenePair::known(&entry, &space, clock() - begin)?,
            parts: model.mechanism.parts.iter().map(ScenePart::of).collect(),
            design: self.design.as_ref().and_then(|d| d.scene(&model)),
        })
    }

    /// A pair without its space.
    pub fn unknown(&self, pair: &PairEntry) -> ScenePair {
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &self.model.parts[i].part);
        let class = match &self.saved {
            Some(space) => space.class(),
            None if self.general => PairClass::General,
            None => self.model.pair_class(pair),
        };
        ScenePair::unknown(pair, class, fixed, moving)
    }

    /// Edited model as TOML that is read back unchanged, and whether it is the text of its file, with other values, and numbers for outlines
    /// that were edited. It is only numbers where that text is not here, is no TOML, or would be another model.
    ///
    /// # Errors
    /// If the edit is invalid, or the written model is refused by the reader.
    pub fn edited_text(&self, edits: &Edits) -> Result<(String, bool), EditedPairError> {
        let mechanism = self.edited(edits)?.mechanism;
        let drawn: Vec<usize> = edits.parts.iter().map(|p| p.index).collect();
        if let Some(design) = &self.design
            && let Some(text) = design.text_of(&edits.set, &drawn, &mechanism)
        {
            return Ok((text, true));
        }
        let text = cspace_model::model::to_toml(&mechanism);
        cspace_model::model::from_toml(&text, "model.toml")?;
        Ok((text, false))
    }

    /// Computes the space of a pair of a mechanism that has the same parts, perhaps with other outlines and motions.
    fn compute(
        &self,
        model: &Mechanism,
        pair: &PairEntry,
        progress: &dyn Progress,
    ) -> Result<PairSpace, PairError> {
        let relation = if self.general {
            Relation::Planar
        } else {
            model.relation(pair)
        };
        let options = Options {
            window: pair.window,
            symmetry: if self.general {
                Symmetry::Ignore
            } else {
                Symmetry::Detect
            },
        };
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &model.parts[i].part);
        PairSpace::compute_with(fixed, moving, relation, &options, progress)
    }
}

/// Axes of the parts of a saved space relative to the ground, as far as they are known.
fn axes(space: &PairSpace) -> [Option<Axis>; 2] {
    match space {
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            [Some(fixed), Some(moving)]
        }
        // The limits of a joint are those of axes.
        PairSpace::Lower(pair) => {
            let axis = match pair.joint() {
                Joint::Revolute { at } => Axis::revolute(at),
                Joint::Prismatic { direction, .. } => Axis::prismatic(direction),
            };
            match pair.limits() {
                Some((lo, hi)) => [Some(Axis::FIXED), Some(axis.within(lo, hi))],
                None => [None; 2],
            }
        }
        PairSpace::Planar(_) => [None; 2],
    }
}
