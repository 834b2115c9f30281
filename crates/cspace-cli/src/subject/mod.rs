//! The subject of a command: a model file or a saved contact space, and the pairs in it.

mod chosen;
mod named;
mod place;
mod space;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use cspace::PairClass;
use cspace_answers::{Outcome, PairAnswer};
use cspace_model::model::Parameter;
use cspace_model::{Document, Mechanism, Model, PairEntry, SavedFile};

use crate::args::{Common, SetArgs, ThreadsArg};
use crate::failure::{Failure, note, warning};
use crate::input;
use crate::interrupt::catch_interrupts;
use crate::output;

use crate::traces::{self, OTHER, quoted};
use crate::wording::count;
pub(crate) use cspace_design::{FeaturePair, pair_of, texts, touching};
pub(crate) use named::named_pair;
pub(crate) use place::{placed, placed_by_name};
pub(crate) use space::Space;

/// The file a command was given.
pub(crate) enum Subject {
    /// A model, of which pairs are computed.
    Model {
        /// Where it was read from.
        path: PathBuf,
        /// The mechanism that the file describes.
        model: Box<Mechanism>,
        /// The names of its numbers.
        parameters: Vec<Parameter>,
    },
    /// A configuration space that was computed before.
    Saved(Box<SavedFile>),
}

/// A pair of a subject.
pub(crate) struct Chosen<'a> {
    subject: &'a Subject,
    pair: Option<PairEntry>,
    /// Whether symmetry is to be ignored.
    general: bool,
    /// Whether its space may be one that was kept, and is kept.
    keeps: bool,
}

/// Sets the number of threads of all computations; 0 for one per processor.
pub(crate) fn set_threads(ThreadsArg { threads }: ThreadsArg) -> Result<(), Failure> {
    /// It is done once, however many files are read.
    static DONE: AtomicBool = AtomicBool::new(false);
    if DONE.swap(true, Ordering::Relaxed) {
        return Ok(());
    }
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(threads))
        .build_global()
        .map_err(|e| {
            Failure::new(format_args!("--threads {threads}: {e}")).help("give a smaller number")
        })
}

/// Reads a model of which all parts are wanted; `why` says so of a file that has none.
pub(crate) fn read_model(
    file: &Path,
    values: &SetArgs,
    why: &str,
) -> Result<(PathBuf, Box<Mechanism>), Failure> {
    let (path, document) = input::document(file, values)?;
    match document {
        Document::Model(model) => Ok((path, Box::new(model.mechanism))),
        Document::Space(_) => Err(Failure::new(format_args!(
            "{}: the file is a saved contact space of two parts",
            path.display()
        ))
        .help(format_args!("give the model file: {why}"))),
    }
}

/// The model with arcs tangent to lines, and a note of what was moved.
fn snapped(path: &Path, model: &Mechanism) -> Box<Mechanism> {
    let (snapped, done) = cspace_model::model::snap(model);
    for what in done {
        note(format_args!(
            "{}: part {}: {} made tangent, points moved by at most {:.1e}",
            path.display(),
            cspace_model::shown::quoted(&what.part),
            count(what.joints, "joint", "joints"),
            what.moved
        ));
    }
    Box::new(snapped)
}

impl Chosen<'_> {
    /// Answer about the pair, with its names.
    pub(crate) fn answer<T>(&self, outcome: Outcome, content: T) -> PairAnswer<T> {
        PairAnswer {
            fixed: self.fixed().name().to_owned(),
            moving: self.moving().name().to_owned(),
            outcome,
            content,
        }
    }
}

impl Subject {
    /// The name of the model.
    pub(crate) fn name(&self) -> Option<&str> {
        match self {
            Self::Model { model, .. } => Some(&model.name),
            Self::Saved(file) => file.name.as_deref(),
        }
    }

    /// The model's label of the unit of length.
    pub(crate) fn unit(&self) -> Option<&str> {
        match self {
            Self::Model { model, .. } => model.unit.as_deref(),
            Self::Saved(file) => file.unit.as_deref(),
        }
    }

    /// Reads the file, and sets up what all commands need.
    pub(crate) fn open(common: &Common) -> Result<Self, Failure> {
        let output = common.result.output.as_deref();
        output::check(output)?;
        catch_interrupts();
        set_threads(common.threads)?;
        let (path, document) = input::document(&common.file, &common.values)?;
        Ok(match document {
            Document::Model(read) => {
                let Model {
                    mechanism,
                    parameters,
                    ..
                } = *read;
                let model = if common.snap {
                    snapped(&path, &mechanism)
                } else {
                    Box::new(mechanism)
                };
                Self::Model {
                    path,
                    model,
                    parameters,
                }
            }
            Document::Space(_) if common.snap => {
                return Err(Failure::new(format_args!(
                    "{}: --snap is about models, and the file is a saved contact space",
                    path.display()
                ))
                .help("leave out --snap, or give the model file"));
            }
            Document::Space(file) => Self::Saved(file),
        })
    }

    /// Says on stderr what in a model is most likely not meant.
    pub(crate) fn warn(&self) {
        /// Maximum number of warnings.
        const MOST: usize = 8;
        let Self::Model { path, model, .. } = self else {
            return;
        };
        let slips = cspace_model::model::slips(model);
        for slip in slips.iter().take(MOST) {
            warning(format_args!("{}: {slip}", path.display()), &slip.help);
        }
        if slips.len() > MOST {
            note(format_args!(
                "{} more warnings like these",
                slips.len() - MOST
            ));
        }
    }

    /// Says on stderr of which parts fewer lines and arcs could be made, and how.
    pub(crate) fn tell_traces(&self) {
        if let Self::Model { path, model, .. } = self {
            let file = quoted(path);
            traces::tell(model, |fit| {
                format!(
                    "cspace draw {file} -o parts.dxf && cspace import parts.dxf --trace --fit {fit} -o {OTHER}"
                )
            });
        }
    }

    /// The pairs asked for: the one that was named, or all of the file, of which there must be one.
    ///
    /// A window is for those that have orientations. It is an error only of a pair that was named to have none.
    pub(crate) fn pairs(
        &self,
        common: &Common,
        window: Option<(f64, f64)>,
    ) -> Result<Vec<Chosen<'_>>, Failure> {
        let pairs = self.pairs_if_any(common, window)?;
        if pairs.is_empty() {
            return Err(self.one_part(common));
        }
        Ok(pairs)
    }

    fn one_part(&self, common: &Common) -> Failure {
        Failure::new(format_args!(
            "{}: the model has one part, and a contact space is of two",
            common.file.display()
        ))
        .help("add a second [[part]]; `cspace info` shows a part alone")
    }

    /// As [`pairs`](Self::pairs); none if the model has one part, of which no window may be asked for.
    pub(crate) fn pairs_if_any(
        &self,
        common: &Common,
        window: Option<(f64, f64)>,
    ) -> Result<Vec<Chosen<'_>>, Failure> {
        let mut pairs = self.all(common, window)?;
        if window.is_none() || common.pair.is_some() {
            return Ok(pairs);
        }
        if pairs.is_empty() {
            return Err(self.one_part(common).help(
                "leave out --window, or add a second [[part]]: orientations are those of a pair",
            ));
        }
        let mut without = Vec::new();
        for chosen in pairs.iter_mut().filter(|c| !c.is_planar()) {
            without.push(format!("{} ({})", chosen.names(), chosen.class()));
            if let (Self::Model { model, .. }, Some(pair)) = (self, &mut chosen.pair) {
                // What the file itself says of it remains, and is refused.
                let same = |p: &&PairEntry| (p.fixed, p.moving) == (pair.fixed, pair.moving);
                pair.window = model.pairs.iter().find(same).and_then(|p| p.window);
            }
        }
        if !without.is_empty() {
            note(format_args!(
                "--window is not used for pairs without orientations: {}",
                without.join("; ")
            ));
        }
        Ok(pairs)
    }

    /// The pair that was named, or all of the file, in the window if there is one.
    fn all(&self, common: &Common, window: Option<(f64, f64)>) -> Result<Vec<Chosen<'_>>, Failure> {
        let (path, model) = match self {
            Self::Model { path, model, .. } => (path, model),
            Self::Saved(file) => {
                let space = &file.space;
                if window.is_some() {
                    return Err(Failure::new(format_args!(
                        "{}: the file is a saved contact space, its orientations are given",
                        common.file.display()
                    ))
                    .help("leave out --window, or give the model file"));
                }
                let (fixed, moving) = (space.fixed().name(), space.moving().name());
                let name = format!("{fixed},{moving}");
                let is_it = |names: &String| {
                    names.match_indices(',').any(|(at, _)| {
                        names[..at].trim() == fixed && names[at + 1..].trim() == moving
                    })
                };
                if common.pair.as_ref().is_some_and(|p| !is_it(p)) {
                    return Err(Failure::new(format_args!(
                        "{}: the file is the saved contact space of the pair {name}",
                        common.file.display()
                    ))
                    .help("leave out --pair, or give the model file"));
                }
                if common.general && space.class() != PairClass::General {
                    return Err(Failure::new(format_args!(
                        "{}: the file is the saved configuration space of a {} pair, and nothing is computed again",
                        common.file.display(),
                        space.class()
                    ))
                    .help("leave out --general, or give the model file"));
                }
                return Ok(vec![Chosen {
                    subject: self,
                    pair: None,
                    general: common.general,
                    keeps: false,
                }]);
            }
        };
        let pairs = match &common.pair {
            Some(names) => vec![named_pair(path, model, names)?],
            None => model.pairs.clone(),
        };
        Ok(pairs
            .into_iter()
            .map(|pair| Chosen {
                subject: self,
                general: common.general,
                keeps: !common.cache.no_cache,
                pair: Some(PairEntry {
                    window: window.or(pair.window),
                    ..pair
                }),
            })
            .collect())
    }

    /// The one pair that was named, or that the file has.
    pub(crate) fn one_pair(
        &self,
        common: &Common,
        window: Option<(f64, f64)>,
    ) -> Result<Chosen<'_>, Failure> {
        let mut pairs = self.all(common, window)?;
        match (pairs.pop(), pairs.len()) {
            (None, _) => Err(self.one_part(common)),
            (Some(pair), 0) => Ok(pair),
            (last, _) => {
                let names: Vec<String> = pairs.iter().chain(&last).map(Chosen::names).collect();
                Err(Failure::new(format_args!(
                    "{}: the file has {} pairs, and this command takes one",
                    common.file.display(),
                    names.len()
                ))
                .help(format_args!(
                    "name one of them: {}",
                    names
                        .iter()
                        .map(|n| format!("--pair {n}"))
                        .collect::<Vec<_>>()
                        .join(", ")
                )))
            }
        }
    }
}
