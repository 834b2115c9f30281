//! What the server computes: the pairs of the model as it was opened. It may take long, and is done on threads that may wait.

use std::sync::OnceLock;
use std::time::Instant;

use axum::body::Bytes;
use cspace::Silent;
use cspace_scene::Opened;

use crate::html::Place;
use crate::page::Page;

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
}

impl Work {
    pub(super) fn new(opened: Opened, page: &Page) -> Result<Self, serde_json::Error> {
        let html = page.served(&opened.scene())?;
        Ok(Self {
            page: html.into(),
            policy: page.policy(Place::Served),
            pairs: opened.pairs.iter().map(|_| OnceLock::new()).collect(),
            opened,
        })
    }

    /// A pair with its space, as JSON; computed when it is asked for the first time.
    pub(super) fn pair(&self, index: usize) -> Option<Bytes> {
        let known = self.pairs.get(index)?;
        Some(known.get_or_init(|| self.compute(index)).clone())
    }

    fn compute(&self, index: usize) -> Bytes {
        let begin = Instant::now();
        let pair = (self.opened).pair(index, &|| begin.elapsed().as_secs_f64(), &Silent);
        serde_json::to_vec(&pair).unwrap_or_default().into()
    }
}
