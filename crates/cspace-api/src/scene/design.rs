//! A model whose parameters may be given other values, and what the page shows of them.

use cspace_model::model::{Parameter, Setting, Template};
use cspace_model::{Host, Mechanism, Model, ModelError};
use serde::{Deserialize, Serialize};

/// The text of a model, as the page keeps it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SceneText {
    /// The text of the file.
    pub text: String,
    /// Name of the file; its extension determines whether it is JSON.
    pub file: String,
    /// Values that its parameters were given when it was opened.
    pub set: Vec<SceneSetting>,
}

/// A value for a parameter in place of the file's.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SceneSetting {
    /// The name of the parameter.
    pub name: String,
    /// A number, an angle such as `18deg`, or an expression of other parameters.
    pub value: String,
}

/// The parameters and requirements of a model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneDesign {
    /// By name.
    pub parameters: Vec<SceneParameter>,
    /// The names of the requirements.
    pub requirements: Vec<String>,
}

/// A number of the model that has a name.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneParameter {
    /// Name in expressions.
    pub name: String,
    /// Value; in radians if it is an angle.
    pub value: f64,
    /// The expression by which its value follows from other parameters.
    pub expression: Option<String>,
    /// Whether the value is written as an angle.
    pub is_angle: bool,
    /// Whether it is a number of copies: its values are whole numbers.
    pub is_count: bool,
    /// The values that a slider offers first.
    pub range: (f64, f64),
}

/// Model in the form of its text, with parameters that can be given other values.
#[derive(Debug)]
pub(crate) struct Design {
    template: Template,
    set: Vec<Setting>,
    /// The model as it was opened.
    opened: Model,
    /// The parameters that say how often something is repeated.
    counts: Vec<String>,
}

impl From<&SceneSetting> for Setting {
    fn from(setting: &SceneSetting) -> Self {
        Self {
            name: setting.name.clone(),
            value: setting.value.clone(),
        }
    }
}

impl Design {
    /// The design of a text; `None` of one that names drawings, which the page does not have.
    pub(crate) fn new(template: Template, set: Vec<Setting>) -> Option<Self> {
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let opened = template.model(&host).ok()?;
        if template.names_drawings() {
            return None;
        }
        // Numbers of copies are whole, and have no derivatives.
        let is_count = |p: &&Parameter| {
            let is_whole = p.value.fract() == 0.0 && p.value >= 1.0 && !p.is_angle;
            is_whole && template.slopes(&host, &opened, &p.name).is_err()
        };
        let counts = opened.parameters.iter().filter(is_count);
        Some(Self {
            counts: counts.map(|p| p.name.clone()).collect(),
            template,
            set,
            opened,
        })
    }

    /// Design carried by a scene.
    ///
    /// # Errors
    /// If its text is neither TOML nor JSON.
    pub(crate) fn from_text(text: &SceneText) -> Result<Option<Self>, ModelError> {
        let template = Template::from_text(text.text.clone(), &text.file)?;
        Ok(Self::new(
            template,
            text.set.iter().map(Into::into).collect(),
        ))
    }

    /// Text of the design for a scene.
    pub(crate) fn text(&self) -> SceneText {
        let file = self.template.path().file_name().unwrap_or_default();
        let set = self.set.iter().map(|s| SceneSetting {
            name: s.name.clone(),
            value: s.value.clone(),
        });
        SceneText {
            text: self.template.text().to_owned(),
            file: file.to_string_lossy().into_owned(),
            set: set.collect(),
        }
    }

    /// Values of parameters, with further ones: if a parameter has two, the last counts.
    pub(crate) fn settings(&self, further: &[SceneSetting]) -> Vec<Setting> {
        let further = further.iter().map(Setting::from);
        self.set.iter().cloned().chain(further).collect()
    }

    /// Text whose parameters are given values.
    pub(crate) const fn template(&self) -> &Template {
        &self.template
    }

    /// The text of a mechanism that differs by further values of parameters and by parts of these indices, where it can be written.
    pub(crate) fn text_of(
        &self,
        further: &[SceneSetting],
        drawn: &[usize],
        mechanism: &Mechanism,
    ) -> Option<String> {
        (self.template).text_of(&self.settings(further), drawn, mechanism)
    }

    /// Model with further values of its parameters.
    ///
    /// # Errors
    /// If the text is not a valid model with these values.
    pub(crate) fn model(&self, further: &[SceneSetting]) -> Result<Model, ModelError> {
        if further.is_empty() {
            return Ok(self.opened.clone());
        }
        let set = self.settings(further);
        self.template.model(&Host {
            set: &set,
            ..Host::default()
        })
    }

    /// Design of the model as it was opened, for the page.
    pub(crate) fn opened_scene(&self) -> Option<SceneDesign> {
        self.scene(&self.opened)
    }

    /// Design of a model, for the page; `None` of one that has neither parameters nor requirements.
    pub(crate) fn scene(&self, model: &Model) -> Option<SceneDesign> {
        if model.parameters.is_empty() && model.requirements.is_empty() {
            return None;
        }
        let largest = (model.mechanism.parts.iter()).fold(0.0_f64, |m, p| m.max(p.part.size()));
        let parameters = (model.parameters.iter())
            .map(|p| {
                let is_count = self.counts.contains(&p.name);
                SceneParameter {
                    name: p.name.clone(),
                    value: p.value,
                    expression: p.expression.clone(),
                    is_angle: p.is_angle,
                    is_count,
                    range: range(p, is_count, largest),
                }
            })
            .collect();
        Some(SceneDesign {
            parameters,
            requirements: model.requirements.iter().map(|r| r.name.clone()).collect(),
        })
    }
}

/// The values that a slider offers: about the value, or about nothing by a share of the largest part.
fn range(parameter: &Parameter, is_count: bool, largest: f64) -> (f64, f64) {
    /// Below and above, as a share of the value.
    const AROUND: f64 = 0.25;
    /// Largest deviation, as a multiple of the tolerance, for a parameter that is 0 and has a tolerance.
    const TOLERANCES: f64 = 10.0;
    /// Largest deviation for a length that is 0, as a share of the size of the largest part.
    const SHARE: f64 = 0.05;
    /// Largest deviation for an angle that is 0 (rad).
    const ANGLE: f64 = core::f64::consts::PI / 18.0;
    let value = parameter.value;
    if is_count {
        return ((0.5 * value).ceil().max(1.0), 2.0 * value);
    }
    let around = match parameter.deviations {
        _ if value != 0.0 => AROUND * value.abs(),
        Some((below, above)) if below.abs().max(above.abs()) > 0.0 => {
            TOLERANCES * below.abs().max(above.abs())
        }
        _ if parameter.is_angle => ANGLE,
        _ => SHARE * largest,
    };
    (value - around, value + around)
}
