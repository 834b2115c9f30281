//! The page: what it shows, and the file that `cspace export` writes.

use std::path::{Path, PathBuf};
use std::time::Instant;

use cspace::PairEntry;
use cspace_io::shown;
use cspace_view::{Opened, Page, PageError, Scene, ScenePair, SceneRecord};
use serde_json::Value;

use crate::args::ExportArgs;
use crate::failure::Failure;
use crate::output;
use crate::progress;
use crate::subject::{Chosen, Subject};

/// The largest record read, in bytes: some million samples.
const LARGEST_RECORD: u64 = 1 << 27;

/// The page that was bundled with the program.
pub(super) fn bundled() -> Result<Page, Failure> {
    Page::bundled().map_err(|e: PageError| Failure::work(&e).help(e.help()))
}

/// What is shown of a subject: these of its pairs.
pub(super) fn opened(subject: Subject, pairs: Vec<PairEntry>, general: bool) -> Opened {
    match subject {
        Subject::Model { model, .. } => Opened::model(*model, pairs, general),
        Subject::Saved(file) => Opened::saved(*file),
    }
}

/// The chosen pairs as the model has them; none of a saved space, whose pair is its own.
pub(super) fn entries(chosen: &[Chosen<'_>]) -> Vec<PairEntry> {
    chosen.iter().filter_map(Chosen::entry).collect()
}

/// The page as one file, with the spaces of all chosen pairs in it. A pair that cannot be computed says so there and in a
/// warning; it is a failure if none can.
pub(super) fn file(args: &ExportArgs) -> Result<Vec<u8>, Failure> {
    let common = &args.common;
    let page = bundled()?;
    for record in &args.with {
        output::check_apart(common.result.output.as_deref(), record)?;
    }
    let subject = Subject::open(common)?;
    let chosen = subject.pairs(common, args.window.theta)?;
    let mut known = Vec::new();
    if !matches!(subject, Subject::Saved(_)) {
        known = computed(&chosen)?;
    }
    let entries = entries(&chosen);
    let opened = opened(subject, entries, common.general);
    let records = records(&args.with, &opened)?;
    let pairs = match &opened.saved {
        Some(space) => {
            let pair = ScenePair::known(&opened.pairs[0], space, 0.0);
            vec![pair.map_err(Failure::work)?]
        }
        None => (opened.pairs.iter().zip(known))
            .map(|(entry, pair)| pair.unwrap_or_else(|error| opened.unknown(entry).failed(error)))
            .collect(),
    };
    let scene = Scene::of(&opened.model, pairs, records);
    page.file(&scene)
        .map(String::into_bytes)
        .map_err(Failure::work)
}

/// All pairs with their spaces, or why they have none.
fn computed(chosen: &[Chosen<'_>]) -> Result<Vec<Result<ScenePair, String>>, Failure> {
    let mut pairs = Vec::new();
    let mut failures = Vec::new();
    for pair in chosen {
        let Some(entry) = pair.entry() else { continue };
        let begin = Instant::now();
        match pair.space() {
            Ok(space) => {
                let seconds = begin.elapsed().as_secs_f64();
                let pair = ScenePair::known(&entry, &space, seconds);
                pairs.push(Ok(pair.map_err(Failure::work)?));
            }
            Err(failure) if progress::is_interrupted() => return Err(failure),
            Err(failure) => {
                pairs.push(Err(failure.message().to_owned()));
                failures.push(failure);
            }
        }
    }
    if failures.len() == pairs.len() {
        let worst = failures
            .into_iter()
            .reduce(|a, b| if b.is_worse_than(&a) { b } else { a });
        return worst.map_or(Ok(pairs), Err);
    }
    failures.iter().for_each(Failure::warn);
    Ok(pairs)
}

/// The records in these files, each of which is an answer about the parts that are shown.
pub(super) fn records(files: &[PathBuf], opened: &Opened) -> Result<Vec<SceneRecord>, Failure> {
    files.iter().map(|file| record(file, opened)).collect()
}

fn record(file: &Path, opened: &Opened) -> Result<SceneRecord, Failure> {
    const HELP: &str = "give what `cspace plan` or `cspace simulate` writes with -o OUT.json";
    let wrong = |what: &str| Failure::input(format_args!("{}: {what}", file.display())).help(HELP);
    let meta = std::fs::metadata(file).map_err(|e| wrong(&format!("it cannot be read: {e}")))?;
    if !meta.is_file() {
        return Err(wrong("it is no regular file"));
    }
    if meta.len() > LARGEST_RECORD {
        return Err(wrong(&format!(
            "it is too large: at most {LARGEST_RECORD} bytes are read"
        )));
    }
    let bytes = std::fs::read(file).map_err(|e| wrong(&format!("it cannot be read: {e}")))?;
    let record: Value =
        serde_json::from_slice(&bytes).map_err(|e| wrong(&format!("it is no JSON: {e}")))?;
    let is_plan = record["verdict"].is_string() && record["path"].is_array();
    let is_motion = record["status"].is_string() && record["samples"].is_array();
    if !is_plan && !is_motion {
        return Err(wrong("it is no answer of `plan` or `simulate`"));
    }
    let parts = record["parts"].as_array().into_iter().flatten();
    for name in parts.filter_map(Value::as_str) {
        if opened.model.part_index(name).is_none() {
            let name = shown::quoted(name);
            let what = format!("it moves a part {name}, which the model does not have");
            return Err(wrong(&what).help("give a record of the same model"));
        }
    }
    let name = file.file_name().unwrap_or(file.as_os_str());
    Ok(SceneRecord {
        name: name.to_string_lossy().into_owned(),
        record,
    })
}
