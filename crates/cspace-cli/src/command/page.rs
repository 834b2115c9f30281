//! The page: what it shows, and the file that `cspace export` writes.

use std::path::{Path, PathBuf};
use std::time::Instant;

use cspace_api::scene::{Opened, ScenePair, SceneRecord};
use cspace_model::model::Template;
use cspace_model::{Host, PairEntry};

use crate::args::Common;
use crate::ask;
use crate::failure::Failure;
use crate::interrupt;
use crate::output;
use cspace_api::{Chosen, Subject, Which};

use crate::view::{Page, PageError};

/// The page that was bundled with the program, by [`Page::bundled`]; a failure with help if there is none.
pub(super) fn bundled(found: Result<Page, PageError>) -> Result<Page, Failure> {
    found.map_err(|e| Failure::new(&e).help(e.help()))
}

/// The scene of the page: a subject with these of its pairs. For a model in a file it includes the text, so that the page can change the
/// model's parameters.
pub(super) fn opened(
    subject: Subject,
    pairs: Vec<PairEntry>,
    (common, which): (&Common, &Which),
) -> Result<Opened, Failure> {
    Ok(match subject {
        Subject::Model(file) => {
            let opened = Opened::model(file.model.mechanism, pairs, which.named.general);
            // With arcs made tangent the model is another than its text says.
            if common.snap || common.file == Path::new(output::STANDARD) {
                return Ok(opened);
            }
            // It has been read once, and what is to be remarked was.
            let template = Template::read(&common.file, &Host::default())?;
            opened.with_text(template, common.values.set.clone())
        }
        Subject::Saved { file, .. } => Opened::saved(*file),
    })
}

/// The chosen pairs as the model has them; none of a saved space, whose pair is its own.
pub(super) fn entries(chosen: &[Chosen<'_>]) -> Vec<PairEntry> {
    chosen.iter().filter_map(Chosen::entry).collect()
}

/// The page as one file, with the spaces of all chosen pairs in it, and the unit of length. A pair that cannot be computed says so there
/// and in a warning; it is a failure if none can.
pub(super) fn file(
    page: &Page,
    common: &Common,
    which: &Which,
    with: &[PathBuf],
) -> Result<(Vec<u8>, Option<String>), Failure> {
    let (subject, host) = ask::open(common)?;
    let unit = subject.unit().map(str::to_owned);
    // Before anything is computed.
    for record in with {
        output::before_reading(record)?;
    }
    let chosen = subject.pairs(which, &host)?;
    let mut known = Vec::new();
    if !matches!(subject, Subject::Saved { .. }) {
        known = computed(&chosen)?;
    }
    let entries = entries(&chosen);
    let mut opened = opened(subject, entries, (common, which))?;
    opened.records = records(with, &opened)?;
    let pairs = match &opened.saved {
        Some(space) => {
            let pair = ScenePair::known(&opened.pairs[0], space, 0.0);
            vec![pair.map_err(Failure::new)?]
        }
        None => (opened.pairs.iter().zip(known))
            .map(|(entry, pair)| pair.unwrap_or_else(|error| opened.unknown(entry).failed(error)))
            .collect(),
    };
    let file = page.file(&opened.scene_with(pairs)).map_err(Failure::new)?;
    Ok((file.into_bytes(), unit))
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
                pairs.push(Ok(pair.map_err(Failure::new)?));
            }
            Err(failure) if interrupt::is_interrupted() => return Err(failure.into()),
            Err(failure) => {
                pairs.push(Err(failure.message.clone()));
                failures.push(failure);
            }
        }
    }
    if failures.len() == pairs.len() {
        let first = failures.into_iter().next();
        return first.map_or(Ok(pairs), |error| Err(error.into()));
    }
    (failures.iter()).for_each(|error| Failure::from(error.clone()).warn());
    Ok(pairs)
}

/// The records in these files, each of which is an answer about the parts that are shown.
pub(super) fn records(files: &[PathBuf], opened: &Opened) -> Result<Vec<SceneRecord>, Failure> {
    files.iter().map(|file| record(file, opened)).collect()
}

fn record(file: &Path, opened: &Opened) -> Result<SceneRecord, Failure> {
    let name = file.file_name().unwrap_or(file.as_os_str());
    Ok(SceneRecord {
        name: name.to_string_lossy().into_owned(),
        record: super::record::json(file, &opened.model, true)?,
    })
}
