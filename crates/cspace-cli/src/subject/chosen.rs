//! Properties of a pair that are known before its space is computed.

use cspace::Vector;
use cspace::{Axis, AxisMotion, PairClass, PairError, PairSpace, Part, Relation};
use cspace_model::{Mechanism, PairEntry};

use super::{Chosen, Subject};
use crate::args::AboutArg;
use crate::failure::Failure;

impl Chosen<'_> {
    fn part(&self, of: impl Fn(&PairEntry) -> usize, saved: impl Fn(&PairSpace) -> &Part) -> &Part {
        match (self.subject, &self.pair) {
            (Subject::Model { model, .. }, Some(pair)) => &model.parts[of(pair)].part,
            (Subject::Saved(file), _) => saved(&file.space),
            (Subject::Model { model, .. }, None) => &model.parts[0].part,
        }
    }

    pub(crate) fn fixed(&self) -> &Part {
        self.part(|p| p.fixed, PairSpace::fixed)
    }

    pub(crate) fn moving(&self) -> &Part {
        self.part(|p| p.moving, PairSpace::moving)
    }

    /// The file of the model with a colon, to begin a message with; empty if the space was read.
    pub(super) fn file(&self) -> String {
        match self.subject {
            Subject::Model { path, .. } => format!("{}: ", path.display()),
            Subject::Saved(_) => String::new(),
        }
    }

    /// As `--pair` takes them.
    pub(crate) fn names(&self) -> String {
        format!("{},{}", self.fixed().name(), self.moving().name())
    }

    /// The model, and the pair in it; none if the space was read.
    pub(crate) fn in_model(&self) -> Option<(&Mechanism, &PairEntry)> {
        match (self.subject, &self.pair) {
            (Subject::Model { model, .. }, Some(pair)) => Some((model, pair)),
            _ => None,
        }
    }

    /// The pair as its model has it, in the window that was asked for; none if the space was read.
    pub(crate) fn entry(&self) -> Option<PairEntry> {
        self.pair
    }

    /// The point that `--about` gives; parts on axes move as these let them, whatever point is given.
    pub(crate) fn about(&self, given: &AboutArg) -> Result<Option<Vector>, Failure> {
        if given.about.is_some() && self.is_on_axes() {
            return Err(Failure::new(format_args!(
                "--about: the parts of the pair {} move on axes",
                self.names()
            ))
            .help("leave it out, or compute x, y and theta with --general"));
        }
        Ok(given.vector())
    }

    /// The label of the unit of length, with a space before it; empty if the model has none.
    pub(crate) fn unit(&self) -> String {
        let unit = self.subject.unit();
        unit.map_or(String::new(), |u| format!(" {u}"))
    }

    /// The label of the unit of length, if the model has one.
    pub(crate) fn unit_label(&self) -> Option<&str> {
        self.subject.unit()
    }

    /// The name of the model, if it is known.
    pub(crate) fn model_name(&self) -> Option<&str> {
        self.subject.name()
    }

    /// The title of a picture: the model, the parts of the pair, and the unit of length.
    pub(crate) fn title(&self) -> String {
        let model = (self.model_name()).map_or(String::new(), |name| format!("{name}: "));
        let unit = (self.subject.unit()).map_or(String::new(), |u| format!(", lengths in {u}"));
        format!(
            "{model}{} relative to {}{unit}",
            self.moving().name(),
            self.fixed().name()
        )
    }

    /// The configuration space as a file that every command reads in place of the model.
    pub(crate) fn as_file(&self) -> Result<String, Failure> {
        let space = self.space()?;
        let (name, unit) = (self.subject.name(), self.subject.unit());
        Ok(cspace_model::saved::with_labels(&space, name, unit))
    }

    /// How the parts are related in their model.
    pub(super) fn relation(&self) -> Option<Relation> {
        match (self.subject, &self.pair) {
            (Subject::Model { model, .. }, Some(pair)) => Some(model.relation(pair)),
            _ => None,
        }
    }

    /// The class of the pair in its model, or of the saved space.
    pub(crate) fn class(&self) -> PairClass {
        match (self.subject, &self.pair) {
            (Subject::Model { model, .. }, Some(pair)) => model.pair_class(pair),
            (Subject::Saved(file), _) => file.space.class(),
            _ => PairClass::General,
        }
    }

    /// The class by motions and joints, or of the saved space; a general pair with a symmetric part is symmetric, unless the
    /// general method is asked for.
    pub(crate) fn class_in_full(&self) -> PairClass {
        let symmetric = |part: &Part| part.symmetry().fold() > 1;
        match self.class() {
            _ if self.general => PairClass::General,
            PairClass::General
                if !self.is_saved() && (symmetric(self.fixed()) || symmetric(self.moving())) =>
            {
                PairClass::Symmetric
            }
            class => class,
        }
    }

    /// Whether the coordinates of a pair with fixed axes are angles.
    pub(crate) fn turns(&self) -> (bool, bool) {
        let turns = |axis: &Axis| matches!(axis.motion, AxisMotion::Revolute { .. });
        self.axes()
            .map_or((false, false), |(a, b)| (turns(&a), turns(&b)))
    }

    /// Whether the general method is asked for.
    pub(crate) fn is_general(&self) -> bool {
        self.general
    }

    /// Whether the contact space was read from the file, not computed.
    pub(crate) fn is_saved(&self) -> bool {
        matches!(self.subject, Subject::Saved(_))
    }

    /// The window of orientations, if there is one.
    pub(crate) fn window(&self) -> Option<(f64, f64)> {
        match self.subject {
            Subject::Model { .. } => self.pair.and_then(|p| p.window),
            Subject::Saved(file) => match &file.space {
                PairSpace::Planar(space) => {
                    let w = space.window();
                    (!w.full_turn).then_some((w.lo, w.hi))
                }
                _ => None,
            },
        }
    }

    /// Whether the pair has slices at orientations.
    pub(crate) fn is_planar(&self) -> bool {
        let by_class = matches!(self.class(), PairClass::General | PairClass::Symmetric);
        by_class || (self.general && !self.is_saved())
    }

    /// Refuses a window of orientations where orientation is no coordinate.
    pub(crate) fn check_window(&self) -> Result<(), Failure> {
        match self.window() {
            Some(_) if !self.is_planar() => Err(self.failure(&PairError::Window {
                class: self.class(),
            })),
            _ => Ok(()),
        }
    }

    /// The axes of a pair with fixed axes.
    pub(crate) fn axes(&self) -> Option<(Axis, Axis)> {
        match (self.relation(), self.subject) {
            (Some(Relation::Axes { fixed, moving }), _) => Some((fixed, moving)),
            (None, Subject::Saved(file)) => match &file.space {
                PairSpace::FixedAxes(space) => Some(space.axes()),
                _ => None,
            },
            _ => None,
        }
    }
}
