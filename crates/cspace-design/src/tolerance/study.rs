//! One requirement at one point of the tolerances: its value, what decides it, and its derivatives.

use cspace::{Ball, Configuration, Progress, Real, overlap_as_drawn, space::Stage};
use cspace_model::model::{Coordinate, Quantity, Requirement, Setting, Slopes, Subject, Template};
use cspace_model::{Host, Model, ModelError};

use crate::check::{Spaces, reason};
use crate::range::reach;
use crate::sensitivity::derivative;
use crate::value::{Unmeasured, Value};

use super::vary::{Variations, halves, middle_and_half};
use crate::drawing::{Contacts, Drawing, Enclosed, Hits, Slope, enclosed};

/// Largest number of parts of the tolerances that are examined for one requirement.
const MOST: usize = 4000;

/// A requirement of a model, and what varies.
pub(super) struct Study<'a> {
    pub(super) template: &'a Template,
    pub(super) set: &'a [Setting],
    pub(super) variations: &'a Variations,
    pub(super) nominal: &'a Model,
    pub(super) progress: &'a dyn Progress,
    pub(super) requirement: Requirement,
    /// How many parts of a box are looked at, at most.
    most: usize,
    /// Coordinates of the configuration at which it is measured, in place of the model's.
    held: Vec<(Coordinate, f64)>,
    /// Whether first contacts decide the quantity.
    is_drawn: bool,
    /// How long motions are followed then.
    pub(super) until: Vec<f64>,
    /// Knowledge of all points within the tolerances.
    pub(super) known: Known,
}

/// Knowledge that holds for all points of a box of tolerances.
pub(super) enum Known {
    /// Knowledge of each half, below and above a value of one parameter.
    Halves {
        /// The parameter.
        by: usize,
        /// Its deviation between them.
        at: f64,
        /// Knowledge of the two halves.
        both: Box<[Known; 2]>,
    },
    /// Knowledge of the whole box.
    Whole {
        /// Contacts that may come first.
        contacts: Contacts,
        /// Whether nothing touches where the motions begin.
        is_clear: bool,
    },
    /// Nothing.
    Nothing,
}

impl Known {
    /// The contacts that may be first at a point, and whether the parts do not touch where the motions begin.
    fn at(&self, deviations: &[f64]) -> Option<(&Contacts, bool)> {
        match self {
            Self::Halves { by, at, both } => {
                both[usize::from(deviations[*by] > *at)].at(deviations)
            }
            Self::Whole { contacts, is_clear } => Some((contacts, *is_clear)),
            Self::Nothing => None,
        }
    }
}

/// A requirement at a point.
#[derive(Debug, Clone)]
pub(super) struct Point {
    /// The value; yes and no are 1 and 0. Or why there is none.
    pub(super) value: Result<f64, Failure>,
    /// The first contacts, where they are found without a configuration space.
    pub(super) hits: Option<Hits>,
}

/// Why a requirement has no value at a point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Failure {
    /// In a word.
    pub(super) kind: &'static str,
    /// In words.
    pub(super) reason: String,
}

impl Failure {
    fn of(error: &Unmeasured) -> Self {
        let kind = match error {
            Unmeasured::Blocked => "jam",
            Unmeasured::Unlimited | Unmeasured::Endless => "unlimited",
            Unmeasured::NoContact | Unmeasured::Leaves => "no contact",
            Unmeasured::NoWay => "no way",
            Unmeasured::Undecided => "undecided",
            Unmeasured::Never | Unmeasured::NoAdvance | Unmeasured::EndsEarly { .. } => "motion",
            _ => "no value",
        };
        let reason = match error {
            Unmeasured::Blocked => "the parts overlap where it is measured".to_owned(),
            other => other.to_string(),
        };
        Self { kind, reason }
    }
}

impl<'a> Study<'a> {
    pub(super) fn new(
        template: &'a Template,
        set: &'a [Setting],
        (variations, nominal, requirement): (&'a Variations, &'a Model, Requirement),
        progress: &'a dyn Progress,
    ) -> Self {
        let mut study = Self {
            template,
            set,
            variations,
            nominal,
            progress,
            requirement,
            most: MOST,
            held: Vec::new(),
            is_drawn: false,
            until: Vec::new(),
            known: Known::Nothing,
        };
        let of = study.requirement_of(nominal);
        study.is_drawn = Drawing::<Ball>::new(nominal, of, None).is_some();
        study
    }

    /// As this, measured at other coordinates, at which the nominal model has its requirement too.
    pub(super) fn held_at(mut self, held: Vec<(Coordinate, f64)>) -> Self {
        self.held = held;
        // There are many places.
        self.most = MOST / 4;
        self
    }

    /// As this, with the spaces of the nominal model: they tell how long motions are followed.
    pub(super) fn on(mut self, spaces: &Spaces) -> Self {
        let nominal = self.nominal;
        let of = self.requirement_of(nominal);
        let drawing = Drawing::<Ball>::new(nominal, of, None);
        if let (Some(drawing), Some(space), Subject::Pair(_, quantity)) =
            (drawing, spaces.of(of), of.subject)
        {
            let until = match quantity {
                Quantity::Play { of, at } => reach(space, at, of),
                _ => 1.0,
            };
            self.until = vec![until; drawing.legs.len()];
        }
        self
    }

    /// The model with some values, measured where coordinates are held.
    fn read(&self, host: &Host<'_>) -> Result<Model, ModelError> {
        let mut model = self.template.model(host)?;
        let name = &self.requirement.name;
        for requirement in model.requirements.iter_mut().filter(|r| r.name == *name) {
            for &(of, value) in &self.held {
                requirement.subject.put(of, value);
            }
        }
        Ok(model)
    }

    /// Coordinates that are held do not depend on parameters.
    fn hold<T>(&self, slopes: &mut Slopes<T>) {
        if let Some(of) = slopes.requirements.get_mut(&self.requirement.name) {
            for (held, _) in &self.held {
                of.at[held.index()] = None;
            }
        }
    }

    /// The requirement with the numbers of a model.
    pub(super) fn requirement_of<'m>(&'m self, model: &'m Model) -> &'m Requirement {
        let mut all = model.requirements.iter();
        all.find(|r| r.name == self.requirement.name)
            .unwrap_or(&self.requirement)
    }

    /// Whether the user wants to go on.
    pub(super) fn goes_on(&self) -> bool {
        self.progress.stage(Stage::Graph).is_ok()
    }

    /// How many parts of a box may be looked at: fewer of large pairs, of which each takes longer.
    pub(super) fn most_boxes(&self) -> usize {
        /// Pairs of edges in all parts together.
        const WORK: usize = 200_000;
        const FEWEST: usize = 4;
        let Subject::Pair(pair, _) = self.requirement.subject else {
            return FEWEST;
        };
        let parts = &self.nominal.mechanism.parts;
        let edges = |i: usize| parts[i].part.edges().count();
        (WORK / (edges(pair.fixed) * edges(pair.moving)).max(1)).clamp(FEWEST, self.most)
    }

    /// Whether first contacts decide the quantity.
    pub(super) fn is_drawn(&self) -> bool {
        self.is_drawn
    }

    pub(super) fn settings(&self, deviations: &[f64]) -> Vec<Setting> {
        self.variations.settings(self.set, deviations)
    }

    pub(super) fn model(&self, deviations: &[f64]) -> Result<Model, Failure> {
        let set = self.settings(deviations);
        let host = Host {
            set: &set,
            ..Host::default()
        };
        self.read(&host).map_err(|error| Failure {
            kind: "no part",
            reason: reason(&error),
        })
    }

    /// The requirement at a point.
    pub(super) fn at(&self, deviations: &[f64]) -> Point {
        match self.model(deviations) {
            Err(failure) => Point {
                value: Err(failure),
                hits: None,
            },
            Ok(model) => self
                .drawn(&model, deviations)
                .unwrap_or_else(|| self.measured(model)),
        }
    }

    /// The requirement at a point, from first contacts alone; `None` where these are in doubt.
    fn drawn(&self, model: &Model, deviations: &[f64]) -> Option<Point> {
        if !self.is_drawn() {
            return None;
        }
        let requirement = self.requirement_of(model);
        let drawing = Drawing::<f64>::new(model, requirement, None)?;
        let share = self.variations.share(deviations);
        let known = if share <= 1.0 {
            self.known.at(deviations)
        } else {
            None
        };
        if known.is_none_or(|k| !k.1) && self.overlap(model, &drawing) {
            return None;
        }
        let hits = match known {
            Some((contacts, _)) => drawing.hits_among(contacts)?,
            None => {
                let enclosed = drawing.map(Ball::constant);
                enclosed.hits(&enclosed.encounters(&self.until, None))?
            }
        };
        Some(Point {
            value: Ok(drawing.value(&hits.contacts, &hits.times)),
            hits: Some(hits),
        })
    }

    /// Whether the parts overlap at a point where the motions begin.
    pub(super) fn overlaps(&self, deviations: &[f64]) -> bool {
        let Ok(model) = self.model(deviations) else {
            return false;
        };
        let drawing = Drawing::<f64>::new(&model, self.requirement_of(&model), None);
        drawing.is_some_and(|drawing| self.overlap(&model, &drawing))
    }

    /// As above, for a model.
    fn overlap(&self, model: &Model, drawing: &Drawing<f64>) -> bool {
        let Subject::Pair(pair, _) = self.requirement_of(model).subject else {
            return false;
        };
        let [fixed, moving] = [pair.fixed, pair.moving].map(|i| &model.mechanism.parts[i].part);
        let placed = drawing.pair.placed(drawing.legs[0].from);
        let [x, y] = placed.position;
        let theta = placed.sin.atan2(placed.cos);
        overlap_as_drawn(fixed, moving, Configuration::new(x, y, theta))
    }

    /// The requirement and the spaces that it alone is measured on in a model; `None` if the computation is ended.
    fn computed(&self, model: &mut Model) -> Option<(Requirement, Spaces)> {
        let requirement = self.requirement_of(model).clone();
        model.requirements = vec![requirement.clone()];
        let spaces = Spaces::compute(model, self.progress).ok()?;
        Some((requirement, spaces))
    }

    /// The requirement at a point, by a configuration space or a simulation of its own.
    fn measured(&self, mut model: Model) -> Point {
        let none = |failure| Point {
            value: Err(failure),
            hits: None,
        };
        let Some((requirement, spaces)) = self.computed(&mut model) else {
            return none(Failure {
                kind: "no value",
                reason: "the computation was interrupted".to_owned(),
            });
        };
        match spaces.with_room(spaces.check(&requirement)).measured {
            Err(error) => none(Failure::of(&error)),
            Ok(measured) => Point {
                value: Ok(match measured.value {
                    Value::Number(x) => x,
                    Value::Truth(is) => f64::from(is),
                }),
                hits: None,
            },
        }
    }

    /// The drawing by each parameter that varies, over a box about a point: numbers with their derivatives. `None` of a quantity that
    /// first contacts do not decide, or of a drawing that has no derivatives.
    pub(super) fn by_parameters(
        &self,
        deviations: &[f64],
        half: Option<&[f64]>,
    ) -> Option<Vec<Drawing<Slope>>> {
        let (model, mut all) = self.enclosures(deviations, half)?;
        let requirement = self.requirement_of(&model);
        all.iter_mut().for_each(|slopes| self.hold(slopes));
        (all.iter()
            .map(|slopes| Drawing::new(&model, requirement, Some(slopes))))
        .collect()
    }

    /// The model at a point, and its numbers over a box about that, with their derivatives by each parameter that varies.
    pub(super) fn enclosures(
        &self,
        deviations: &[f64],
        half: Option<&[f64]>,
    ) -> Option<(Model, Vec<Slopes<Slope>>)> {
        let set = self.settings(deviations);
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let model = self.read(&host).ok()?;
        let list = &self.variations.list;
        let ranges: Vec<(String, f64, f64)> = (half.iter().flat_map(|h| h.iter()).zip(list))
            .filter(|(r, _)| **r > 0.0)
            .map(|(&r, v)| (v.parameter.name.clone(), -r, r))
            .collect();
        let given = |name: &str, ranges: &[(String, f64, f64)]| {
            self.template.enclosures(&host, &model, name, ranges).ok()
        };
        let by: Option<Vec<_>> = list
            .iter()
            .map(|v| given(&v.parameter.name, &ranges))
            .collect();
        let (by, none) = (by?, vec![0.0; list.len()]);
        let half = half.unwrap_or(&none);
        // What depends on any of them, at the middle.
        let still: Vec<(String, f64, f64)> = (list.iter())
            .map(|v| (v.parameter.name.clone(), 0.0, 0.0))
            .collect();
        let middle = given(&list.first()?.parameter.name, &still)?;
        let all = enclosed(&middle, &by, half);
        Some((model, all))
    }

    /// The derivatives of the requirement by the parameters that vary, at a point where it has a value: those of its first contacts.
    pub(super) fn slopes(&self, deviations: &[f64], point: &Point) -> Option<Vec<f64>> {
        if let Some(hits) = &point.hits
            && let Some(drawings) = self.by_parameters(deviations, None)
        {
            return Some(drawings.iter().map(|d| d.derivative(hits)).collect());
        }
        self.by_contact_functions(deviations)
            .or_else(|| self.by_differences(deviations))
    }

    /// By the contact functions of a configuration space.
    fn by_contact_functions(&self, deviations: &[f64]) -> Option<Vec<f64>> {
        let set = self.settings(deviations);
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let mut model = self.read(&host).ok()?;
        let (requirement, spaces) = self.computed(&mut model)?;
        let measured = spaces.measure(&requirement).ok()?;
        let of = |name: &str| {
            let mut slopes = self.template.slopes(&host, &model, name).ok()?;
            self.hold(&mut slopes);
            let [below, above] = derivative(&spaces, &requirement, &measured, &slopes).ok()?;
            Some(0.5 * (below + above))
        };
        let list = self.variations.list.iter();
        list.map(|v| of(&v.parameter.name)).collect()
    }

    /// By differences over a thousandth of the tolerances, of what has no contact function: the motion of a mechanism, or a bottleneck.
    fn by_differences(&self, deviations: &[f64]) -> Option<Vec<f64>> {
        const STEP: f64 = 1e-3;
        let list = self.variations.list.iter().enumerate();
        list.map(|(k, v)| {
            let step = STEP * v.half();
            if step == 0.0 {
                return Some(0.0);
            }
            let ends = [-step, step].map(|by| {
                let mut moved = deviations.to_vec();
                moved[k] += by;
                self.at(&moved).value.ok()
            });
            let [Some(below), Some(above)] = ends else {
                return None;
            };
            Some((above - below) / (2.0 * step))
        })
        .collect()
    }

    /// Finds what is known of all points within the tolerances.
    pub(super) fn know(&mut self) {
        /// A box is halved so often, at most, until every contact comes about once at most.
        const HALVINGS: usize = 6;
        if self.is_drawn() {
            let halvings = HALVINGS.min(self.most_boxes().ilog2() as usize);
            self.known = self.known_in(&self.variations.scaled(1.0), halvings, None);
        }
    }

    /// Knowledge of a box, derived from that of one around it.
    fn known_in(&self, ranges: &[[f64; 2]], halvings: usize, around: Option<&Contacts>) -> Known {
        let known = self.known_of(ranges, around).unwrap_or(Known::Nothing);
        let around = match &known {
            Known::Whole { contacts, .. } => Some(contacts),
            _ => around,
        };
        let is_simple = |contacts: &Contacts| contacts.iter().flatten().all(|e| e.approaching);
        let is_enough =
            matches!(&known, Known::Whole { contacts, is_clear: true } if is_simple(contacts));
        let (_, half) = middle_and_half(ranges);
        let share = |k: usize| half[k] / self.variations.list[k].half();
        let widest = (0..half.len())
            .filter(|&k| half[k] > 0.0)
            .max_by(|&a, &b| share(a).total_cmp(&share(b)).then(b.cmp(&a)));
        match widest {
            Some(by) if !is_enough && halvings > 0 && self.goes_on() => Known::Halves {
                by,
                at: 0.5 * (ranges[by][0] + ranges[by][1]),
                both: Box::new(
                    halves(ranges, by).map(|half| self.known_in(&half, halvings - 1, around)),
                ),
            },
            _ => known,
        }
    }

    fn known_of(&self, ranges: &[[f64; 2]], around: Option<&Contacts>) -> Option<Known> {
        let (middle, half) = middle_and_half(ranges);
        let drawings = self.by_parameters(&middle, Some(&half))?;
        let plain: Drawing<Enclosed> = drawings.first()?.map(|x| x.value);
        let found = plain.encounters(&self.until, around);
        let is_bounded = (found.iter()).all(|e| e.complete && e.list.iter().any(|e| e.certain));
        is_bounded.then(|| Known::Whole {
            // Parts that touch nowhere in the box are apart in all of it, or overlap in all of it.
            is_clear: found.iter().flat_map(|e| &e.list).all(|e| e.lo > 0.0)
                && !self.overlaps(&middle),
            contacts: found.into_iter().map(|e| e.list).collect(),
        })
    }
}
