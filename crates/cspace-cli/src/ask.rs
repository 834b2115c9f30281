//! The subject of a command, and this program as the one that asks.

use std::fmt::Display;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use cspace::{Options, PairError, PairSpace, Part, Progress, Relation};
use cspace_api::{Error, Host, Pieces, Subject};
use cspace_model::Document;

use crate::args::{CacheArgs, Common, SetArgs, ThreadsArg};
use crate::cache;
use crate::failure::{Failure, note};
use crate::input;
use crate::interrupt::{self, catch_interrupts};
use crate::output;
use crate::progress::{Bar, Steps};
use crate::traces::{self, OTHER, quoted};

/// This program: remarks go to stderr, with a bar for long work, and spaces that took long are kept, but by default.
#[derive(Default)]
pub(crate) struct Terminal {
    /// Whether spaces are kept, and read where they were.
    keeps: bool,
}

impl Terminal {
    /// The program with what it was told about keeping spaces.
    pub(crate) fn new(cache: CacheArgs) -> Self {
        Self {
            keeps: !cache.no_cache,
        }
    }
}

impl Host for Terminal {
    fn begin(&self, title: &str) -> Box<dyn Progress + '_> {
        Box::new(Bar::new(title.to_owned()))
    }

    fn begin_pieces(&self, count: usize) -> Box<dyn Pieces + '_> {
        Box::new(Steps::new(count))
    }

    fn keep(&self) {
        interrupt::keep();
    }

    fn note(&self, text: &dyn Display) {
        note(text);
    }

    fn warn(&self, warning: &Error) {
        Failure::from(warning.clone()).warn();
    }

    fn option(&self, name: &str) -> String {
        format!("--{name}")
    }

    fn space(
        &self,
        parts: (&Part, &Part),
        relation: Relation,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<(PairSpace, bool), PairError> {
        cache::space(self.keeps, parts, relation, options, progress)
    }
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

/// Reads the file, and sets up what all commands need.
pub(crate) fn open(common: &Common) -> Result<(Subject, Terminal), Failure> {
    output::check(common.result.output.as_deref())?;
    let mut subject = read(&common.file, &common.values, common.threads)?;
    let host = Terminal::new(common.cache);
    if common.snap {
        subject.snap(&host)?;
    }
    Ok((subject, host))
}

/// Reads a file, and sets up what all commands need.
pub(crate) fn read(file: &Path, values: &SetArgs, threads: ThreadsArg) -> Result<Subject, Failure> {
    catch_interrupts();
    set_threads(threads)?;
    let (path, document) = input::document(file, values)?;
    Ok(Subject::of(path, document, None, values.set.clone()))
}

/// As [`read`], a model whose parameters may be given other values.
pub(crate) fn read_again(
    file: &Path,
    values: &SetArgs,
    threads: ThreadsArg,
) -> Result<Subject, Failure> {
    catch_interrupts();
    set_threads(threads)?;
    let (template, model) = input::template(file, values)?;
    let document = Document::Model(Box::new(model));
    let set = values.set.clone();
    Ok(Subject::of(
        file.to_owned(),
        document,
        Some(Arc::new(template)),
        set,
    ))
}

/// Says on stderr of which parts fewer lines and arcs could be made, and how.
pub(crate) fn tell_traces(subject: &Subject) {
    if let Subject::Model(file) = subject {
        let path = quoted(&file.path);
        traces::tell(&file.model.mechanism, |fit| {
            format!(
                "cspace draw {path} -o parts.dxf && cspace import parts.dxf --trace --fit {fit} -o {OTHER}"
            )
        });
    }
}
