//! Properties of a pair that are known before its space is computed.

use cspace::Vector;
use cspace::{Axis, AxisMotion, PairClass, PairError, PairSpace, Part, Relation};
use cspace_model::{Mechanism, PairEntry};

use super::{Chosen, Subject};
use crate::error::Error;
use crate::host::Host;

impl<'a> Chosen<'a> {
    /// The program that asks.
    pub fn host(&self) -> &'a dyn Host {
        self.host
    }

    /// How the asker writes the option of this name.
    pub fn option(&self, name: &str) -> String {
        self.host.option(name)
    }

    fn part(&self, of: impl Fn(&PairEntry) -> usize, saved: impl Fn(&PairSpace) -> &Part) -> &Part {
        match (self.subject, &self.pair) {
            (Subject::Model(file), Some(pair)) => &file.model.mechanism.parts[of(pair)].part,
            (Subject::Saved { file, .. }, _) => saved(&file.space),
            (Subject::Model(file), None) => &file.model.mechanism.parts[0].part,
        }
    }

    /// The fixed part.
    pub fn fixed(&self) -> &Part {
        self.part(|p| p.fixed, PairSpace::fixed)
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        self.part(|p| p.moving, PairSpace::moving)
    }

    /// The file of the model with a colon, to begin a message with; empty if the space was read.
    pub(super) fn file(&self) -> String {
        match self.subject {
            Subject::Model(file) => format!("{}: ", file.path.display()),
            Subject::Saved { .. } => String::new(),
        }
    }

    /// As `--pair` takes them.
    pub fn names(&self) -> String {
        format!("{},{}", self.fixed().name(), self.moving().name())
    }

    /// The model, and the pair in it; none if the space was read.
    pub fn in_model(&self) -> Option<(&Mechanism, &PairEntry)> {
        match (self.subject, &self.pair) {
            (Subject::Model(file), Some(pair)) => Some((&file.model.mechanism, pair)),
            _ => None,
        }
    }

    /// The pair as its model has it, in the window that was asked for; none if the space was read.
    pub fn entry(&self) -> Option<PairEntry> {
        self.pair
    }

    /// The point of the moving part that is given; parts on axes move as these let them, whatever point is given.
    ///
    /// # Errors
    /// If one is given for parts on axes.
    pub fn about(&self, given: Option<[f64; 2]>) -> Result<Option<Vector>, Error> {
        if given.is_some() && self.is_on_axes() {
            return Err(Error::new(format_args!(
                "{}: the parts of the pair {} move on axes",
                self.option("about"),
                self.names()
            ))
            .help(format_args!(
                "leave it out, or compute x, y and theta with {}",
                self.option("general")
            )));
        }
        Ok(given.map(|[x, y]| Vector::new(x, y)))
    }

    /// The label of the unit of length, with a space before it; empty if the model has none.
    pub fn unit(&self) -> String {
        let unit = self.subject.unit();
        unit.map_or(String::new(), |u| format!(" {u}"))
    }

    /// The label of the unit of length, if the model has one.
    pub fn unit_label(&self) -> Option<&str> {
        self.subject.unit()
    }

    /// The name of the model, if it is known.
    pub fn model_name(&self) -> Option<&str> {
        self.subject.name()
    }

    /// The title of a picture: the model, the parts of the pair, and the unit of length.
    pub fn title(&self) -> String {
        let model = (self.model_name()).map_or(String::new(), |name| format!("{name}: "));
        let unit = (self.subject.unit()).map_or(String::new(), |u| format!(", lengths in {u}"));
        format!(
            "{model}{} relative to {}{unit}",
            self.moving().name(),
            self.fixed().name()
        )
    }

    /// The configuration space as a file that every command reads in place of the model.
    ///
    /// # Errors
    /// As the message says.
    pub fn as_file(&self) -> Result<String, Error> {
        let space = self.space()?;
        let (name, unit) = (self.subject.name(), self.subject.unit());
        Ok(cspace_model::saved::with_labels(&space, name, unit))
    }

    /// How the parts are related in their model.
    pub(super) fn relation(&self) -> Option<Relation> {
        match (self.subject, &self.pair) {
            (Subject::Model(file), Some(pair)) => Some(file.model.mechanism.relation(pair)),
            _ => None,
        }
    }

    /// The class of the pair in its model, or of the saved space.
    pub fn class(&self) -> PairClass {
        match (self.subject, &self.pair) {
            (Subject::Model(file), Some(pair)) => file.model.mechanism.pair_class(pair),
            (Subject::Saved { file, .. }, _) => file.space.class(),
            _ => PairClass::General,
        }
    }

    /// The class by motions and joints, or of the saved space; a general pair with a symmetric part is symmetric, unless the
    /// general method is asked for.
    pub fn class_in_full(&self) -> PairClass {
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
    pub fn turns(&self) -> (bool, bool) {
        let turns = |axis: &Axis| matches!(axis.motion, AxisMotion::Revolute { .. });
        self.axes()
            .map_or((false, false), |(a, b)| (turns(&a), turns(&b)))
    }

    /// Whether the general method is asked for.
    pub fn is_general(&self) -> bool {
        self.general
    }

    /// Whether the contact space was read from the file, not computed.
    pub fn is_saved(&self) -> bool {
        matches!(self.subject, Subject::Saved { .. })
    }

    /// The window of orientations, if there is one.
    pub fn window(&self) -> Option<(f64, f64)> {
        match self.subject {
            Subject::Model(_) => self.pair.and_then(|p| p.window),
            Subject::Saved { file, .. } => match &file.space {
                PairSpace::Planar(space) => {
                    let w = space.window();
                    (!w.full_turn).then_some((w.lo, w.hi))
                }
                _ => None,
            },
        }
    }

    /// Whether the pair has slices at orientations.
    pub fn is_planar(&self) -> bool {
        let by_class = matches!(self.class(), PairClass::General | PairClass::Symmetric);
        by_class || (self.general && !self.is_saved())
    }

    /// Refuses a window of orientations where orientation is no coordinate.
    ///
    /// # Errors
    /// As the message says.
    pub fn check_window(&self) -> Result<(), Error> {
        match self.window() {
            Some(_) if !self.is_planar() => Err(self.failure(&PairError::Window {
                class: self.class(),
            })),
            _ => Ok(()),
        }
    }

    /// The axes of a pair with fixed axes.
    pub fn axes(&self) -> Option<(Axis, Axis)> {
        match (self.relation(), self.subject) {
            (Some(Relation::Axes { fixed, moving }), _) => Some((fixed, moving)),
            (None, Subject::Saved { file, .. }) => match &file.space {
                PairSpace::FixedAxes(space) => Some(space.axes()),
                _ => None,
            },
            _ => None,
        }
    }
}
