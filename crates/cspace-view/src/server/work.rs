//! What the server computes. All of it may take long, and is done on threads that may wait.

use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::Instant;

use axum::body::Bytes;
use cspace::space::Stage;
use cspace::{ComputeError, Mechanism, PairError, Progress};
use serde::{Deserialize, Serialize};

use super::newest::{Newest, Ticket};
use super::reply::Fault;
use crate::edit::{EditedPart, edited};
use crate::html::Place;
use crate::opened::Opened;
use crate::page::Page;
use crate::scene::{ScenePair, ScenePart};

/// What is served, and what has been computed of it.
#[derive(Debug)]
pub(super) struct Work {
    opened: Opened,
    /// The page with its scene.
    pub(super) page: Bytes,
    /// What it may load.
    pub(super) policy: String,
    /// The pairs as JSON, once they have been asked for.
    pairs: Vec<OnceLock<Bytes>>,
    pub(super) newest: Newest,
    /// Held while an edit is computed: one at a time, or they would keep each other back.
    computing: Mutex<()>,
}

/// Parts that replace those of the opened model.
#[derive(Debug, Deserialize)]
pub(super) struct EditRequest {
    #[serde(default)]
    pub(super) session: String,
    pub(super) sequence: u64,
    pub(super) pair: usize,
    pub(super) parts: Vec<EditedPart>,
}

/// The same for the model as a file.
#[derive(Debug, Deserialize)]
pub(super) struct ModelRequest {
    pub(super) parts: Vec<EditedPart>,
}

#[derive(Debug, Serialize)]
struct EditAnswer {
    sequence: u64,
    pair: ScenePair,
    parts: Vec<ScenePart>,
    /// Of the pair's space (s).
    seconds: f64,
    /// Since the request came (s).
    total_seconds: f64,
}

/// A model as TOML, which is read back as it is.
pub(super) fn toml(model: &Mechanism) -> Result<Bytes, Fault> {
    let text = cspace_io::model::to_toml(model);
    match cspace_io::model::from_toml(&text, "model.toml") {
        Ok(_) => Ok(text.into()),
        Err(error) => {
            let fault = Fault::senseless(error.to_string());
            Err(match error.help() {
                Some(help) => fault.help(help),
                None => fault,
            })
        }
    }
}

/// Nobody stops what is computed once.
struct ToTheEnd;

impl Progress for ToTheEnd {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        Ok(())
    }
}

impl Work {
    pub(super) fn new(opened: Opened, page: &Page) -> Result<Self, serde_json::Error> {
        let html = page.served(&opened.scene())?;
        Ok(Self {
            page: html.into(),
            policy: page.policy(Place::Served),
            pairs: opened.pairs.iter().map(|_| OnceLock::new()).collect(),
            newest: Newest::default(),
            computing: Mutex::new(()),
            opened,
        })
    }

    /// A pair with its space, as JSON; computed when it is asked for the first time.
    pub(super) fn pair(&self, index: usize) -> Option<Bytes> {
        let known = self.pairs.get(index)?;
        Some(known.get_or_init(|| self.compute(index)).clone())
    }

    fn compute(&self, index: usize) -> Bytes {
        let entry = &self.opened.pairs[index];
        let begin = Instant::now();
        let pair = match &self.opened.saved {
            Some(space) => ScenePair::known(entry, space, 0.0).map_err(|e| e.to_string()),
            None => (self.opened)
                .compute(&self.opened.model, entry, &ToTheEnd)
                .map_err(|e| e.to_string())
                .and_then(|space| {
                    let seconds = begin.elapsed().as_secs_f64();
                    ScenePair::known(entry, &space, seconds).map_err(|e| e.to_string())
                }),
        };
        let pair = pair.unwrap_or_else(|error| self.opened.unknown(entry).failed(error));
        serde_json::to_vec(&pair).unwrap_or_default().into()
    }

    /// The pair and the parts after an edit, as JSON.
    pub(super) fn edit(
        &self,
        edit: &EditRequest,
        ticket: &Ticket,
        begin: Instant,
    ) -> Result<Bytes, Fault> {
        let Some(entry) = self.opened.pairs.get(edit.pair) else {
            let pairs = self.opened.pairs.len();
            return Err(Fault::bad(format!(
                "there is no pair {}: there are {pairs}, counted from 0",
                edit.pair
            )));
        };
        let _alone = self
            .computing
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let current = || match ticket.is_superseded() {
            true => Err(Fault::superseded()),
            false => Ok(()),
        };
        current()?;
        let model = self.edited(&edit.parts)?;
        current()?;
        let computing = Instant::now();
        let space = self
            .opened
            .compute(&model, entry, ticket)
            .map_err(|error| match error {
                PairError::Compute(ComputeError::Interrupted) => Fault::superseded(),
                error => Fault::senseless(error.to_string()).help("undo the last change"),
            })?;
        let seconds = computing.elapsed().as_secs_f64();
        current()?;
        let pair = ScenePair::known(entry, &space, seconds).map_err(Fault::internal)?;
        let parts = edit
            .parts
            .iter()
            .map(|p| ScenePart::of(&model.parts[p.index]))
            .collect();
        let answer = EditAnswer {
            sequence: edit.sequence,
            pair,
            parts,
            seconds,
            total_seconds: begin.elapsed().as_secs_f64(),
        };
        serde_json::to_vec(&answer)
            .map(Bytes::from)
            .map_err(Fault::internal)
    }

    /// The edited model as TOML.
    pub(super) fn model(&self, request: &ModelRequest) -> Result<Bytes, Fault> {
        toml(&self.edited(&request.parts)?)
    }

    fn edited(&self, parts: &[EditedPart]) -> Result<Mechanism, Fault> {
        edited(&self.opened.model, parts).map_err(|e| Fault::senseless(e.to_string()))
    }
}
