//! What a command works on: a model file or a saved contact space, and the pairs in it.

use core::f64::consts::TAU;
use std::path::{Path, PathBuf};

use cspace::{
    AxesError, Axis, AxisMotion, ComputeError, ContactSpace, Options, PairClass, PairError,
    PairSpace, Part, Relation, Slice, Symmetry,
};
use cspace_io::{Document, Model, Pair, SavedFile, shown};

use crate::args::Common;
use crate::failure::{Failure, note};
use crate::output;
use crate::progress::{Bar, catch_interrupts};

/// The file a command was given.
pub(crate) enum Subject {
    /// A model, of which pairs are computed.
    Model {
        /// Where it was read from.
        path: PathBuf,
        /// What it says.
        model: Box<Model>,
    },
    /// A configuration space that was computed before.
    Saved(Box<SavedFile>),
}

/// A pair of a subject.
pub(crate) struct Chosen<'a> {
    subject: &'a Subject,
    pair: Option<Pair>,
    /// Whether symmetry is to be ignored.
    general: bool,
}

/// Sets the number of threads of all computations; 0 or none for one per processor.
pub(crate) fn set_threads(threads: Option<u16>) -> Result<(), Failure> {
    let Some(threads) = threads else {
        return Ok(());
    };
    rayon::ThreadPoolBuilder::new()
        .num_threads(usize::from(threads))
        .build_global()
        .map_err(|e| {
            Failure::work(format_args!("--threads {threads}: {e}")).help("give a smaller number")
        })
}

impl Subject {
    /// What the model is called.
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
        output::check(common.result.output.as_deref())?;
        catch_interrupts();
        set_threads(common.result.threads)?;
        let path = common.file.clone();
        Ok(match cspace_io::read(&path)? {
            Document::Model(model) => Self::Model { path, model },
            Document::Space(file) => Self::Saved(file),
        })
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
        Failure::input(format_args!(
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
                "leave out --theta, or add a second [[part]]: orientations are those of a pair",
            ));
        }
        let mut without = Vec::new();
        for chosen in pairs.iter_mut().filter(|c| !c.is_planar()) {
            without.push(format!("{} ({})", chosen.names(), chosen.class()));
            if let (Self::Model { model, .. }, Some(pair)) = (self, &mut chosen.pair) {
                // What the file itself says of it remains, and is refused.
                let same = |p: &&Pair| (p.fixed, p.moving) == (pair.fixed, pair.moving);
                pair.window = model.pairs.iter().find(same).and_then(|p| p.window);
            }
        }
        if !without.is_empty() {
            note(format_args!(
                "--theta is not used for pairs without orientations: {}",
                without.join("; ")
            ));
        }
        Ok(pairs)
    }

    /// The pair that was named, or all of the file, in the window if there is one.
    fn all(&self, common: &Common, window: Option<(f64, f64)>) -> Result<Vec<Chosen<'_>>, Failure> {
        let (path, model) = match self {
            Self::Model { path, model } => (path, model),
            Self::Saved(file) => {
                let space = &file.space;
                if window.is_some() {
                    return Err(Failure::input(format_args!(
                        "{}: the file is a saved contact space, its orientations are given",
                        common.file.display()
                    ))
                    .help("leave out --theta, or give the model file"));
                }
                let (fixed, moving) = (space.fixed().name(), space.moving().name());
                let name = format!("{fixed},{moving}");
                let is_it = |names: &String| {
                    names.match_indices(',').any(|(at, _)| {
                        names[..at].trim() == fixed && names[at + 1..].trim() == moving
                    })
                };
                if common.pair.as_ref().is_some_and(|p| !is_it(p)) {
                    return Err(Failure::input(format_args!(
                        "{}: the file is the saved contact space of the pair {name}",
                        common.file.display()
                    ))
                    .help("leave out --pair, or give the model file"));
                }
                if common.general && space.class() != PairClass::General {
                    return Err(Failure::input(format_args!(
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
                pair: Some(Pair {
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
                Err(Failure::input(format_args!(
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

impl Chosen<'_> {
    fn part(&self, of: impl Fn(&Pair) -> usize, saved: impl Fn(&PairSpace) -> &Part) -> &Part {
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

    /// As `--pair` takes them.
    pub(crate) fn names(&self) -> String {
        format!("{},{}", self.fixed().name(), self.moving().name())
    }

    /// The label of the unit of length, with a space before it; empty if the model has none.
    pub(crate) fn unit(&self) -> String {
        let unit = self.subject.unit();
        unit.map_or(String::new(), |u| format!(" {u}"))
    }

    /// The same without the space, if the model has one.
    pub(crate) fn unit_label(&self) -> Option<&str> {
        self.subject.unit()
    }

    /// What the model is called, if that is known.
    pub(crate) fn model_name(&self) -> Option<&str> {
        self.subject.name()
    }

    /// What a picture is called: the model, its parts, the unit of lengths.
    pub(crate) fn title(&self) -> String {
        let model = (self.model_name()).map_or(String::new(), |name| format!("{name}: "));
        let unit = (self.subject.unit()).map_or(String::new(), |u| format!(", lengths in {u}"));
        format!(
            "{model}{} in {}{unit}",
            self.moving().name(),
            self.fixed().name()
        )
    }

    /// The configuration space as a file that every command reads in place of the model.
    pub(crate) fn as_file(&self) -> Result<String, Failure> {
        let space = self.space()?;
        let (name, unit) = (self.subject.name(), self.subject.unit());
        Ok(cspace_io::saved::with_labels(&space, name, unit))
    }

    /// How the parts are related in their model.
    fn relation(&self) -> Option<Relation> {
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

    /// The slice of a planar pair at one orientation; of a model that slice alone is computed.
    pub(crate) fn slice(&self, theta: f64) -> Result<Slice, Failure> {
        if let Some((lo, hi)) = self.window() {
            let turned = theta + TAU * ((lo - theta) / TAU).ceil();
            if turned > hi {
                return Err(Failure::input(format_args!(
                    "--theta {}: outside the orientations from {} to {} of the pair {}",
                    shown::number(theta),
                    shown::number(lo),
                    shown::number(hi),
                    self.names()
                ))
                .help("choose an orientation inside"));
            }
        }
        Ok(match self.subject {
            Subject::Saved(file) => match &file.space {
                PairSpace::Planar(space) => space.slice(theta),
                _ => return Err(self.no_orientation("a slice")),
            },
            Subject::Model { .. } => Slice::compute(self.fixed(), self.moving(), theta),
        })
    }

    /// That something is made of orientations, and the pair has none.
    pub(crate) fn no_orientation(&self, what: &str) -> Failure {
        let class = self.class();
        let failure = Failure::work(format_args!(
            "pair {}: {what} needs a pair with orientations, and this is a {class} pair",
            self.names()
        ));
        if self.is_saved() {
            failure.help("give the model with --general, which computes it in x, y and theta")
        } else {
            failure.help("with --general it is computed in x, y and theta")
        }
    }

    /// The contact space of a planar pair.
    pub(crate) fn contact_space(&self, what: &str) -> Result<ContactSpace, Failure> {
        if !self.is_planar() {
            return Err(self.no_orientation(what));
        }
        match self.space()? {
            Space::Computed(PairSpace::Planar(space)) => Ok(*space),
            Space::Saved(PairSpace::Planar(space)) => Ok((**space).clone()),
            _ => Err(self.no_orientation(what)),
        }
    }

    /// The configuration space.
    pub(crate) fn space(&self) -> Result<Space<'_>, Failure> {
        if let Subject::Saved(file) = self.subject {
            return Ok(Space::Saved(&file.space));
        }
        let relation = match self.relation() {
            Some(relation) if !self.general => relation,
            _ => Relation::Planar,
        };
        let options = Options {
            window: self.pair.and_then(|p| p.window),
            symmetry: if self.general {
                Symmetry::Ignore
            } else {
                Symmetry::Detect
            },
        };
        let bar = Bar::new(self.names());
        bar.watch(|bar| {
            PairSpace::compute_with(self.fixed(), self.moving(), relation, &options, bar)
        })
        .map(Space::Computed)
        .map_err(|e| self.failure(&e))
    }

    fn failure(&self, error: &PairError) -> Failure {
        let failure = |make: fn(core::fmt::Arguments<'_>) -> Failure| {
            make(format_args!("pair {}: {error}", self.names()))
        };
        let input = || failure(|a| Failure::input(a));
        let work = || failure(|a| Failure::work(a));
        match error {
            PairError::Compute(ComputeError::Window { .. }) => {
                input().help("give --theta LO,HI with LO < HI, at most a turn apart")
            }
            PairError::Compute(ComputeError::TooLarge { .. }) => {
                work().help("split a part, or replace runs of short lines by arcs")
            }
            PairError::Window { .. } => input().help(
                "leave the window out, or name a pair that has orientations with --pair; limit the motion with `range`, or compute all of x, y and theta with --general",
            ),
            PairError::Axes(AxesError::TooFar { .. }) => {
                input().help("draw the pivot nearer to the parts, or use --general")
            }
            PairError::Axes(_) => input().help("change the part's motion in the model"),
            _ => work(),
        }
    }
}

/// A configuration space that was read, or computed.
pub(crate) enum Space<'a> {
    /// Read.
    Saved(&'a PairSpace),
    /// Computed.
    Computed(PairSpace),
}

impl core::ops::Deref for Space<'_> {
    type Target = PairSpace;

    fn deref(&self) -> &PairSpace {
        match self {
            Self::Saved(space) => space,
            Self::Computed(space) => space,
        }
    }
}

/// The pair with the parts of these names; its window is that of the file where it lists the pair, either way around.
fn named_pair(path: &Path, model: &Model, names: &str) -> Result<Pair, Failure> {
    let known = || {
        let list: Vec<&str> = model.parts.iter().map(|p| p.part.name()).collect();
        format!("the parts are {}", list.join(", "))
    };
    if !names.contains(',') {
        return Err(Failure::input(format_args!(
            "--pair {names}: two names are needed, with a comma between"
        ))
        .help(known()));
    }
    // Names may have commas in them: whichever comma separates two of them.
    let found = names.match_indices(',').find_map(|(at, _)| {
        let fixed = model.part_index(names[..at].trim())?;
        let moving = model.part_index(names[at + 1..].trim())?;
        Some((fixed, moving))
    });
    let Some((fixed, moving)) = found else {
        let missing = names
            .split(',')
            .map(str::trim)
            .find(|n| model.part_index(n).is_none())
            .unwrap_or(names);
        return Err(Failure::input(format_args!(
            "{}: there is no part {missing:?}",
            path.display()
        ))
        .help(known()));
    };
    if fixed == moving {
        return Err(Failure::input(format_args!(
            "--pair {names}: a pair is of two different parts"
        ))
        .help(known()));
    }
    let listed = |fixed, moving| {
        (model.pairs.iter())
            .find(|p| p.fixed == fixed && p.moving == moving)
            .copied()
    };
    let exchanged = |p: Pair| p.window.map(|(lo, hi)| (-hi, -lo));
    Ok(listed(fixed, moving).unwrap_or(Pair {
        fixed,
        moving,
        window: listed(moving, fixed).and_then(exchanged),
    }))
}
