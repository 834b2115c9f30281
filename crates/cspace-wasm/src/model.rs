//! A model, as JavaScript has it: its pairs are computed, also once its parts are edited, and it is planned and set in motion.

use core::f64::consts::TAU;

use cspace::{AxisMotion, Coordinates, Silent};
use cspace_api::check::Requirement;
use cspace_api::disassemble::Disassembly;
use cspace_api::scene::{Edits, Opened, SceneSetting};
use cspace_api::template::{TEMPLATES, Template};
use cspace_api::{plan, simulate, solve};
use cspace_design::{ContactGoal, Span};
use cspace_model::model::{Coordinate, Template as Text};
use cspace_model::{DriveMotion, Mechanism};
use cspace_motion::{Record, Report, Settings, Simulation, Way};
use cspace_plan::assembly::Assembly;
use cspace_plan::{Clearance, Planner, Wishes};
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::fault;

/// Model with the pairs that are shown.
#[wasm_bindgen]
pub struct Model {
    opened: Opened,
}

/// A contact that is dragged: it is where a straight motion first meets a contact.
#[derive(Deserialize)]
struct ContactDrag {
    /// Start of the motion, [x, y, theta] or [u, v], and its displacement.
    from: Vec<f64>,
    along: Vec<f64>,
    /// Coordinate that is to have the value at the contact.
    of: Of,
    value: f64,
    /// Parameters that may change: name, from, to.
    spans: Vec<(String, f64, f64)>,
}

/// A coordinate.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Of {
    X,
    Y,
    U,
    V,
}

impl From<Of> for Coordinate {
    fn from(of: Of) -> Self {
        match of {
            Of::X => Self::X,
            Of::Y => Self::Y,
            Of::U => Self::U,
            Of::V => Self::V,
        }
    }
}

/// Where free regions of a pair open, close, join or part as a parameter goes through a range.
#[derive(Serialize)]
struct RegionChange {
    at: f64,
    /// How many there are below and above, and how many of them are caged; null where there is no space.
    below: Option<[usize; 2]>,
    above: Option<[usize; 2]>,
}

/// Values of parameters, or the reason why there are none.
#[derive(Serialize)]
struct ContactAnswer {
    set: Vec<SceneSetting>,
    none: Option<String>,
}

/// Seconds since any moment.
fn seconds() -> f64 {
    js_sys::Date::now() / 1e3
}

fn parsed(edits: &str) -> Result<Edits, JsError> {
    serde_json::from_str(edits).map_err(fault)
}

fn json(answer: &impl Serialize) -> Result<String, JsError> {
    serde_json::to_string(answer).map_err(fault)
}

/// A configuration as JavaScript has it: [x, y, theta], or [u, v].
pub(crate) fn coordinates(c: &[f64]) -> Result<Coordinates, JsError> {
    match *c {
        [u, v] => Ok(Coordinates::Axes { u, v }),
        [x, y, theta] => Ok(Coordinates::Planar(cspace::Configuration::new(x, y, theta))),
        _ => Err(fault("a configuration is [x, y, theta] or [u, v]")),
    }
}

#[wasm_bindgen]
impl Model {
    /// Reads the model from the JSON of a scene's `source`.
    #[wasm_bindgen(js_name = fromSource)]
    pub fn from_source(source: &str) -> Result<Model, JsError> {
        let source = serde_json::from_str(source).map_err(fault)?;
        let opened = Opened::from_source(&source).map_err(told)?;
        Ok(Self { opened })
    }

    /// A model file or a saved space: TOML or JSON, as the command reads it; `name` is the file's.
    pub fn read(text: &str, name: &str) -> Result<Model, JsError> {
        let opened = match cspace_model::read_from(text.as_bytes(), name).map_err(told)? {
            cspace_model::Document::Model(model) => {
                let pairs = model.mechanism.pairs.clone();
                let template = Text::from_text(text.to_owned(), name).map_err(told)?;
                Opened::model(model.mechanism, pairs, false).with_text(template, Vec::new())
            }
            cspace_model::Document::Space(file) => Opened::saved(*file),
        };
        Ok(Self { opened })
    }

    /// A model without parts.
    pub fn blank(name: &str, unit: Option<String>) -> Model {
        let opened = Opened::blank(name, unit);
        Self { opened }
    }

    /// The models to begin with, as JSON: of each the name of its file, what it is a model of, and its text.
    pub fn templates() -> Result<String, JsError> {
        let of = |t: &Template| (format!("{}.toml", t.name), t.title(), t.text);
        json(&TEMPLATES.iter().map(of).collect::<Vec<_>>())
    }

    /// The scene, without the spaces of its pairs, as JSON.
    pub fn scene(&self) -> Result<String, JsError> {
        json(&self.opened.scene())
    }

    /// A pair with its space, as JSON: a `ScenePair`.
    pub fn pair(&self, index: usize) -> Result<String, JsError> {
        let pair = self.opened.pair(index, &seconds, &Silent);
        json(&pair.ok_or_else(|| fault(format_args!("there is no pair {index}")))?)
    }

    /// A pair with its space after an edit, as JSON: an `EditAnswer`. Edits are JSON: `{"set": [{"name", "value"}], "parts": [{"index", "loops",
    /// "motion", "offset"}]}`.
    pub fn edit(&self, pair: usize, edits: &str) -> Result<String, JsError> {
        let edits = parsed(edits)?;
        let answer = (self.opened).edited_pair(pair, &edits, &seconds, &Silent);
        json(&answer.map_err(fault)?)
    }

    /// The edited model as TOML, and whether that has all that its file has beside what is edited, not only numbers: as JSON.
    pub fn toml(&self, edits: &str) -> Result<String, JsError> {
        json(&self.opened.edited_text(&parsed(edits)?).map_err(fault)?)
    }

    /// Answer of `cspace check --json` for the edited model.
    pub fn check(&self, edits: &str) -> Result<String, JsError> {
        let model = self.opened.edited(&parsed(edits)?).map_err(fault)?;
        let checked = cspace_design::check(&model);
        let rows: Vec<Requirement> = (checked.iter())
            .map(|c| Requirement::new(&model, c, None))
            .collect();
        json(&rows)
    }

    /// Answer of `cspace solve --json` for the edited model; the question is that of the command, as JSON.
    pub fn solve(&self, edits: &str, question: &str) -> Result<String, JsError> {
        let edits = parsed(edits)?;
        let question: solve::Question = serde_json::from_str(question).map_err(fault)?;
        let (template, set) = self.opened.template(&edits).map_err(fault)?;
        let (vary, goal) = (&question.vary, &question.so_that);
        let samples = question.samples as usize;
        let found = cspace_design::solve(template, &set, vary, goal, samples, &Silent);
        json(&solve::Solutions::of(vary, found))
    }

    /// Where the number of a pair's free regions, or of those that are caged, changes as a parameter of the edited model goes from one
    /// value to another, as JSON: `[{"at", "below": [regions, caged] or null, "above"}]`.
    #[wasm_bindgen(js_name = regionChanges)]
    pub fn region_changes(
        &self,
        pair: usize,
        edits: &str,
        parameter: &str,
        lo: f64,
        hi: f64,
    ) -> Result<String, JsError> {
        let edits = parsed(edits)?;
        let regions = |at: f64| {
            let mut edits = edits.clone();
            edits.set.push(SceneSetting {
                name: parameter.to_owned(),
                value: format!("{at:?}"),
            });
            let (_, space) = (self.opened).edited_space(pair, &edits, &Silent).ok()?;
            let regions = space.regions();
            let caged = regions.iter().filter(|r| !r.unbounded).count();
            Some([regions.len(), caged])
        };
        let steps = cspace_design::steps_in((lo, hi), solve::SAMPLES as usize, &regions);
        let changes = steps.into_iter().map(|step| RegionChange {
            at: step.at,
            below: step.below,
            above: step.above,
        });
        json(&changes.collect::<Vec<_>>())
    }

    /// Finds values of parameters that move a contact of a pair to where it is dragged, with the smallest change
    /// relative to the ranges. `dragged` is a `ContactDrag`, and the answer `{"set": [{"name", "value"}], "none": why
    /// there are none}`.
    #[wasm_bindgen(js_name = putContact)]
    pub fn put_contact(&self, pair: usize, edits: &str, dragged: &str) -> Result<String, JsError> {
        let edits = parsed(edits)?;
        let dragged: ContactDrag = serde_json::from_str(dragged).map_err(fault)?;
        let model = self.opened.edited(&edits).map_err(fault)?.mechanism;
        let (template, set) = self.opened.template(&edits).map_err(fault)?;
        let spans: Vec<Span> = (dragged.spans.into_iter())
            .map(|(parameter, lo, hi)| Span { parameter, lo, hi })
            .collect();
        let goal = ContactGoal {
            pair: self.opened.entry(pair, &model).map_err(fault)?,
            from: coordinates(&dragged.from)?,
            along: coordinates(&dragged.along)?,
            of: dragged.of.into(),
            value: dragged.value,
        };
        let solved = cspace_design::put_contact(template, &set, &spans, &goal, &Silent);
        let values = solved.solutions.into_iter().next().unwrap_or_default();
        let found = spans.into_iter().zip(values);
        json(&ContactAnswer {
            set: found
                .map(|(span, value)| SceneSetting {
                    name: span.parameter,
                    value: format!("{value:?}"),
                })
                .collect(),
            none: solved.none,
        })
    }

    /// Answer of `cspace plan --json` for a pair of the edited model: a path from one configuration to another,
    /// or to free space outside where `to` is empty, if requested the widest; or the reason why there is none.
    pub fn plan(
        &self,
        pair: usize,
        edits: &str,
        from: &[f64],
        to: &[f64],
        widest: bool,
    ) -> Result<String, JsError> {
        let edits = parsed(edits)?;
        let space = (self.opened).edited_space(pair, &edits, &Silent);
        let space = space.map_err(fault)?.1;
        let unit = self.opened.model.unit.as_deref();
        let begin = seconds();
        let wishes = Wishes {
            clearance: if widest {
                Clearance::Widest
            } else {
                Clearance::Half
            },
            ..Wishes::default()
        };
        let planner = Planner::new(&space).map_err(fault)?;
        let from = coordinates(from)?;
        let goal = match to {
            [] => None,
            to => Some(coordinates(to)?),
        };
        let answer = match goal {
            None => (planner.plan_out(from, &wishes, &Silent)).map(|out| out.1),
            Some(goal) => planner.plan_with(from, goal, &wishes, &Silent),
        };
        let answer = answer.map_err(fault)?;
        json(&plan::Plan::planned(
            &space,
            (planner.scene(), unit),
            goal,
            answer,
            seconds() - begin,
        ))
    }

    /// Answer of `cspace disassemble --json` for the edited model: how its parts come apart.
    pub fn disassemble(&self, edits: &str) -> Result<String, JsError> {
        let model = (self.opened.edited(&parsed(edits)?).map_err(fault)?).mechanism;
        let begin = seconds();
        let assembly = Assembly::new(&model, None).map_err(fault)?;
        let taken = assembly.take_apart_with(&Silent).map_err(fault)?;
        json(&Disassembly::of(
            &model,
            &assembly,
            taken,
            seconds() - begin,
        ))
    }

    /// Answer of `cspace simulate --json` for the edited mechanism, with states between samples: its motion
    /// while the slowest drive makes a turn, with masses if it has any.
    pub fn simulate(&self, edits: &str) -> Result<String, JsError> {
        let model = (self.opened.edited(&parsed(edits)?).map_err(fault)?).mechanism;
        let has_masses = model.has_masses();
        if !has_masses && model.dynamics.drives.is_empty() && !cspace_motion::has_forces(&model) {
            return Err(fault(
                "nothing moves: the model has no drives, loads or springs",
            ));
        }
        let begin = seconds();
        let way = match has_masses {
            true => Way::Dynamic,
            false => Way::Kinematic,
        };
        let settings = Settings {
            time: turn(&model),
            every: None,
        };
        let simulation = Simulation::new_with(&model, &Silent).map_err(fault)?;
        let record = simulation
            .kept_with(way, &settings, &Silent)
            .map_err(fault)?;
        let told = answer(&model, &simulation, &record, seconds() - begin);
        json(&told.map_err(fault)?)
    }
}

/// Duration of one turn of the slowest drive that turns evenly (s).
fn turn(model: &Mechanism) -> f64 {
    /// Default without such a drive.
    const USUAL: f64 = 2.0;
    let drives = model.dynamics.drives.iter();
    let times = drives.filter_map(|drive| {
        match (&drive.motion, model.parts.get(drive.part)?.axis?.motion) {
            (&DriveMotion::Rate(rate), AxisMotion::Revolute { .. }) if rate != 0.0 => {
                Some(TAU / rate.abs())
            }
            (DriveMotion::Table(points), _) => points.last().map(|p| p.0),
            _ => None,
        }
    });
    times.reduce(f64::max).unwrap_or(USUAL)
}

fn answer(
    model: &Mechanism,
    simulation: &Simulation,
    record: &Record,
    seconds: f64,
) -> serde_json::Result<simulate::Motion> {
    let report = Report::of(simulation, record);
    let reported = simulate::Reported {
        rates: false,
        forces: true,
        states: true,
    };
    simulate::Motion::of(model, simulation, (record, &report), reported, seconds)
}

/// An error of a model, and what to do.
pub(crate) fn told(error: cspace_model::ModelError) -> JsError {
    match error.help() {
        Some(help) => fault(format_args!("{error} ({help})")),
        None => fault(error),
    }
}
