//! The subject of a question: a model, or a configuration space that was computed before; and the pairs in it.

mod chosen;
mod found;
mod named;
mod place;
mod space;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use cspace::{PairClass, PairSpace};
use cspace_model::model::{Setting, Template};
use cspace_model::{Document, Host as ReadHost, Mechanism, Model, PairEntry, SavedFile, shown};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;
use crate::frame::{Answer, Content, PairAnswer, Pairs};
use crate::host::Host;

pub use found::Source;
pub use named::named_pair;
pub use space::Space;

use found::Found;

/// The subject of a question.
#[derive(Debug)]
pub enum Subject {
    /// A model, of which pairs are computed.
    Model(Box<ModelFile>),
    /// A configuration space that was computed before.
    Saved {
        /// Where it was read from, for messages.
        path: PathBuf,
        /// The space, and what is known of its model.
        file: Box<SavedFile>,
    },
}

/// A model as it was read.
#[derive(Debug)]
pub struct ModelFile {
    /// Where it was read from, for messages.
    pub path: PathBuf,
    /// The model.
    pub model: Model,
    /// Its text, for questions that give its parameters other values; `None` where it cannot be read again.
    pub template: Option<Arc<Template>>,
    /// The values that parameters are given.
    pub set: Vec<Setting>,
}

impl ModelFile {
    /// An error about the file.
    pub(crate) fn error(&self, message: impl Display) -> Error {
        Error::in_file(&self.path, message)
    }

    /// The model's text with the values that parameters are given.
    ///
    /// # Errors
    /// If the text is not known.
    pub(crate) fn template(&self) -> Result<(&Template, ReadHost<'_>), Error> {
        let host = ReadHost {
            set: &self.set,
            ..ReadHost::default()
        };
        let template = (self.template.as_deref())
            .ok_or_else(|| self.error("the model is read several times, which cannot be done"));
        Ok((
            template.map_err(|e| e.help("give the name of a file"))?,
            host,
        ))
    }
}

/// The pair that a question is about, and how it is computed.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Which {
    /// The pair by its name.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub named: Named,
    /// Compute only these orientations: two angles, in radians or such as 18deg, at most 1e6 rad from 0.
    #[cfg_attr(feature = "command", arg(long, value_name = "LO,HI", value_parser = crate::given::window, allow_hyphen_values = true))]
    pub window: Option<(f64, f64)>,
}

/// A pair by its name, and how it is computed.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Named {
    /// The pair: names of its fixed and its moving part, with a comma between.
    #[cfg_attr(feature = "command", arg(long, value_name = "FIXED,MOVING"))]
    pub pair: Option<String>,
    /// Use the general method whatever the class of the pair
    ///
    /// The symmetry of parts is not used then.
    #[cfg_attr(feature = "command", arg(long, hide_short_help = true))]
    pub general: bool,
}

impl From<Named> for Which {
    fn from(named: Named) -> Self {
        Self {
            named,
            window: None,
        }
    }
}

/// A pair of a subject.
pub struct Chosen<'a> {
    subject: &'a Subject,
    host: &'a dyn Host,
    pair: Option<PairEntry>,
    /// Whether symmetry is to be ignored.
    general: bool,
    /// Its space, once it is computed.
    known: OnceLock<Found>,
}

impl Chosen<'_> {
    /// Answer about the pair, with its names.
    pub fn answer<T: Content>(&self, outcome: T::Outcome, content: T) -> PairAnswer<T> {
        PairAnswer {
            fixed: self.fixed().name().to_owned(),
            moving: self.moving().name().to_owned(),
            outcome,
            content,
        }
    }
}

/// The answer about pairs, each of which is asked.
pub(crate) fn about<T: Content>(
    pairs: &[Chosen<'_>],
    of: impl Fn(&Chosen<'_>) -> Result<PairAnswer<T>, Error>,
) -> Result<Answer<Pairs<T>>, Error> {
    let unit = pairs.first().and_then(Chosen::unit_label);
    let answers = pairs.iter().map(of).collect::<Result<_, Error>>()?;
    Ok(Answer::of_pairs(unit, answers))
}

impl Subject {
    /// The subject that a file holds; of a model with the values that its parameters are given, and with its text if it can be read again.
    pub fn of(
        path: PathBuf,
        document: Document,
        template: Option<Arc<Template>>,
        set: Vec<Setting>,
    ) -> Self {
        match document {
            Document::Model(model) => Self::Model(Box::new(ModelFile {
                path,
                model: *model,
                template,
                set,
            })),
            Document::Space(file) => Self::Saved { path, file },
        }
    }

    /// The name of the model.
    pub fn name(&self) -> Option<&str> {
        match self {
            Self::Model(file) => Some(&file.model.mechanism.name),
            Self::Saved { file, .. } => file.name.as_deref(),
        }
    }

    /// The model's label of the unit of length.
    pub fn unit(&self) -> Option<&str> {
        match self {
            Self::Model(file) => file.model.mechanism.unit.as_deref(),
            Self::Saved { file, .. } => file.unit.as_deref(),
        }
    }

    /// Where it was read from, for messages.
    pub fn path(&self) -> &Path {
        match self {
            Self::Model(file) => &file.path,
            Self::Saved { path, .. } => path,
        }
    }

    /// An error about the file.
    pub(crate) fn error(&self, message: impl Display) -> Error {
        Error::in_file(self.path(), message)
    }

    /// The model, for a question that needs all of it; `why` says so of a saved space.
    ///
    /// # Errors
    /// If it is the space of two parts.
    pub fn model(&self, why: &str) -> Result<&ModelFile, Error> {
        match self {
            Self::Model(file) => Ok(file),
            Self::Saved { .. } => Err(self
                .error("the file is a saved contact space of two parts")
                .help(format_args!("give the model file: {why}"))),
        }
    }

    /// Makes lines and arcs of a model tangent that miss tangency by a little, and notes what was moved.
    ///
    /// # Errors
    /// If it is a saved space.
    pub fn snap(&mut self, host: &dyn Host) -> Result<(), Error> {
        let Self::Model(file) = self else {
            let option = host.option("snap");
            return Err(self
                .error(format_args!(
                    "{option} is about models, and the file is a saved contact space"
                ))
                .help(format_args!("leave out {option}, or give the model file")));
        };
        let (snapped, done) = cspace_model::model::snap(&file.model.mechanism);
        for what in done {
            host.note(&format_args!(
                "{}: part {}: {} {} made tangent, points moved by at most {:.1e}",
                file.path.display(),
                shown::quoted(&what.part),
                what.joints,
                if what.joints == 1 { "joint" } else { "joints" },
                what.moved
            ));
        }
        file.model.mechanism = snapped;
        Ok(())
    }

    /// Warns of what in a model is most likely not meant.
    pub fn warn(&self, host: &dyn Host) {
        /// Maximum number of warnings.
        const MOST: usize = 8;
        let Self::Model(file) = self else {
            return;
        };
        let path = file.path.display();
        let slips = cspace_model::model::slips(&file.model.mechanism);
        for slip in slips.iter().take(MOST) {
            host.warn(&Error::new(format_args!("{path}: {slip}")).help(&slip.help));
        }
        if slips.len() > MOST {
            host.note(&format_args!(
                "{} more warnings like these",
                slips.len() - MOST
            ));
        }
    }

    /// Notes of what should be known by who asks about pairs of a model.
    pub(crate) fn note_on_pairs(&self, host: &dyn Host) {
        if let Self::Model(file) = self {
            file.model.on_pairs.iter().for_each(|note| host.note(note));
        }
    }

    /// The pairs asked for: the one that was named, or all of the file, of which there must be one.
    ///
    /// A window is for those that have orientations. It is an error only of a pair that was named to have none.
    ///
    /// # Errors
    /// If there is no such pair.
    pub fn pairs<'a>(
        &'a self,
        which: &Which,
        host: &'a dyn Host,
    ) -> Result<Vec<Chosen<'a>>, Error> {
        let pairs = self.pairs_if_any(which, host)?;
        if pairs.is_empty() {
            return Err(self.one_part());
        }
        Ok(pairs)
    }

    fn one_part(&self) -> Error {
        self.error("the model has one part, and a contact space is of two")
            .help("add a second [[part]]; `cspace info` shows a part alone")
    }

    /// As [`pairs`](Self::pairs); none if the model has one part, of which no window may be asked for.
    ///
    /// # Errors
    /// As [`pairs`](Self::pairs).
    pub fn pairs_if_any<'a>(
        &'a self,
        which: &Which,
        host: &'a dyn Host,
    ) -> Result<Vec<Chosen<'a>>, Error> {
        let mut pairs = self.all(which, host)?;
        if which.window.is_none() || which.named.pair.is_some() {
            return Ok(pairs);
        }
        let option = host.option("window");
        if pairs.is_empty() {
            return Err(self.one_part().help(format_args!(
                "leave out {option}, or add a second [[part]]: orientations are those of a pair"
            )));
        }
        let mut without = Vec::new();
        for chosen in pairs.iter_mut().filter(|c| !c.is_planar()) {
            without.push(format!("{} ({})", chosen.names(), chosen.class()));
            if let (Self::Model(file), Some(pair)) = (self, &mut chosen.pair) {
                // What the file itself says of it remains, and is refused.
                let same = |p: &&PairEntry| (p.fixed, p.moving) == (pair.fixed, pair.moving);
                let listed = file.model.mechanism.pairs.iter().find(same);
                pair.window = listed.and_then(|p| p.window);
            }
        }
        if !without.is_empty() {
            host.note(&format_args!(
                "{option} is not used for pairs without orientations: {}",
                without.join("; ")
            ));
        }
        Ok(pairs)
    }

    /// The pair that was named, or all of the file, in the window if there is one.
    fn all<'a>(&'a self, which: &Which, host: &'a dyn Host) -> Result<Vec<Chosen<'a>>, Error> {
        let (path, model) = match self {
            Self::Model(file) => (&file.path, &file.model.mechanism),
            Self::Saved { file, .. } => {
                self.is_saved_pair(&file.space, which, host)?;
                return Ok(vec![Chosen {
                    subject: self,
                    host,
                    pair: None,
                    general: which.named.general,
                    known: OnceLock::new(),
                }]);
            }
        };
        self.note_on_pairs(host);
        let pairs = match &which.named.pair {
            Some(names) => vec![named_pair(path, model, names, host)?],
            None => model.pairs.clone(),
        };
        let chosen = |pair| self.pair_of(pair, which, host);
        Ok(pairs.into_iter().map(chosen).collect())
    }

    /// A pair of the model, in the window that was asked for if there is one.
    pub(crate) fn pair_of<'a>(
        &'a self,
        pair: PairEntry,
        which: &Which,
        host: &'a dyn Host,
    ) -> Chosen<'a> {
        Chosen {
            subject: self,
            host,
            general: which.named.general,
            known: OnceLock::new(),
            pair: Some(PairEntry {
                window: which.window.or(pair.window),
                ..pair
            }),
        }
    }

    /// The one pair that was named, or that the file has.
    ///
    /// # Errors
    /// If there are several, or none.
    pub fn one_pair<'a>(&'a self, which: &Which, host: &'a dyn Host) -> Result<Chosen<'a>, Error> {
        let mut pairs = self.all(which, host)?;
        match (pairs.pop(), pairs.len()) {
            (None, _) => Err(self.one_part()),
            (Some(pair), 0) => Ok(pair),
            (last, _) => {
                let option = host.option("pair");
                let names: Vec<String> = (pairs.iter().chain(&last))
                    .map(|pair| format!("{option} {}", pair.names()))
                    .collect();
                Err(self
                    .error(format_args!(
                        "the file has {} pairs, and this question is about one",
                        names.len()
                    ))
                    .help(format_args!("name one of them: {}", names.join(", "))))
            }
        }
    }

    /// Refuses what cannot be asked of a space that was computed before.
    fn is_saved_pair(
        &self,
        space: &PairSpace,
        which: &Which,
        host: &dyn Host,
    ) -> Result<(), Error> {
        let refused = |message: String, option: &str| {
            let option = host.option(option);
            Err(self
                .error(format_args!("the file is the saved {message}"))
                .help(format_args!("leave out {option}, or give the model file")))
        };
        if which.window.is_some() {
            let message = "contact space of a pair, whose orientations are given";
            return refused(message.to_owned(), "window");
        }
        let (fixed, moving) = (space.fixed().name(), space.moving().name());
        let is_it = |names: &String| {
            (names.match_indices(','))
                .any(|(at, _)| names[..at].trim() == fixed && names[at + 1..].trim() == moving)
        };
        if which.named.pair.as_ref().is_some_and(|p| !is_it(p)) {
            let message = format!("contact space of the pair {fixed},{moving}");
            return refused(message, "pair");
        }
        if which.named.general && space.class() != PairClass::General {
            let class = space.class();
            let message =
                format!("configuration space of a {class} pair, and nothing is computed again");
            return refused(message, "general");
        }
        Ok(())
    }
}

/// The help for an unknown parameter: the names of the model's parameters.
pub(crate) fn parameters_of(model: &Model) -> String {
    let known: Vec<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
    match known.is_empty() {
        true => "the model has no parameters: add them under [parameter]".to_owned(),
        false => format!("its parameters are {}", known.join(", ")),
    }
}

/// The help for an unknown requirement: the names of the model's requirements.
pub(crate) fn requirements_of(model: &Model) -> String {
    let known: Vec<&str> = model.requirements.iter().map(|r| r.name.as_str()).collect();
    match known.is_empty() {
        true => "say what is measured in [[requirement]] tables: see docs/design.md".to_owned(),
        false => format!("its requirements are {}", known.join(", ")),
    }
}

/// A name that is varied and was varied before.
pub(crate) fn varied_twice(name: &str) -> Error {
    Error::new(format_args!("{} is varied twice", shown::quoted(name))).help("name it once")
}

/// Notes of an answer about parts as drawn that some of them start elsewhere.
pub(crate) fn tell_starts(model: &Mechanism, host: &dyn Host) {
    let starts = model.parts.iter().zip(&model.dynamics.parts);
    let names: Vec<String> = starts
        .filter(|(_, dynamics)| dynamics.start.is_some())
        .map(|(part, _)| shown::quoted(part.part.name()))
        .collect();
    if let [first, rest @ ..] = &names[..] {
        let more = match rest.len() {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        host.note(&format_args!(
            "parts are where they are drawn, and not where motions start: {first}{more} has a `start`"
        ));
    }
}
