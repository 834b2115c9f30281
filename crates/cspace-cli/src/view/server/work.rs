//! Computations of the server: the pairs of the model as it was opened. They may take long, and are done on threads
//! that may wait.

use std::sync::OnceLock;
use std::time::Instant;

use axum::body::Bytes;
use cspace::Silent;
use cspace_api::scene::Opened;
use serde::Serialize;

use crate::view::html::Place;
use crate::view::page::Page;

/// A page with its scene.
#[derive(Debug, Clone)]
pub(super) struct ServedPage {
    pub(super) html: Bytes,
    /// Content-Security-Policy of the page.
    pub(super) policy: String,
}

impl ServedPage {
    pub(super) fn new(page: &Page, scene: &impl Serialize) -> Result<Self, serde_json::Error> {
        Ok(Self {
            html: page.served(scene)?.into(),
            policy: page.policy(Place::Served),
        })
    }
}

/// Model that is served, and its results so far.
#[derive(Debug)]
pub(super) struct Work {
    opened: Opened,
    pub(super) page: ServedPage,
    /// Pairs as JSON, once they have been requested.
    pairs: Vec<OnceLock<Bytes>>,
}

impl Work {
    pub(super) fn new(opened: Opened, page: &Page) -> Result<Self, serde_json::Error> {
        Ok(Self {
            page: ServedPage::new(page, &opened.scene())?,
            pairs: opened.pairs.iter().map(|_| OnceLock::new()).collect(),
            opened,
        })
    }

    /// Pair with its space, as JSON; computed on the first request.
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
