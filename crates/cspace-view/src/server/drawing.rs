//! The routes of a drawing: its page, the model of picked faces, and that model's page once it is asked for.

use std::sync::{Arc, Mutex, PoisonError};

use axum::Router;
use axum::body::Bytes;
use axum::extract::{Request, State};
use axum::response::{IntoResponse, Response};
use axum::routing::{any, get, post};
use cspace::Mechanism;
use hyper::service::Service;
use hyper_util::service::TowerToHyperService;
use serde::{Deserialize, Serialize};

use super::ServeError;
use super::reply::{Fault, json, of_type};
use super::routes::{self, apart, html, nothing_here, parsed};
use super::work::Work;
use crate::html::Place;
use crate::page::{Page, Pages};
use cspace_scene::{Opened, OpenedDrawing, PickedPart};

/// A model as TOML, which is read back as it is.
fn toml(model: &Mechanism) -> Result<Bytes, Fault> {
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

/// The path of the model's page, below the drawing's.
const OPENED: &str = "opened/";

/// A drawing that is served, and the model that was made of it last.
#[derive(Debug)]
pub(super) struct Choice {
    drawing: OpenedDrawing,
    /// The page with the faces.
    page: Bytes,
    policy: String,
    /// The page of models.
    model_page: Page,
    /// The routes of the model that was opened last.
    opened: Mutex<Option<Router>>,
}

type Shared = State<Arc<Choice>>;

/// Parts made of picked faces.
#[derive(Debug, Deserialize)]
struct PickRequest {
    parts: Vec<PickedPart>,
}

/// Where the model is shown, seen from the drawing's page.
#[derive(Debug, Serialize)]
struct OpenAnswer {
    address: &'static str,
}

impl Choice {
    pub(super) fn new(drawing: OpenedDrawing, pages: Pages) -> Result<Self, ServeError> {
        let scene = drawing.scene()?;
        Ok(Self {
            page: pages.drawing.served(&scene)?.into(),
            policy: pages.drawing.policy(Place::Served),
            model_page: pages.model,
            opened: Mutex::new(None),
            drawing,
        })
    }

    fn model(&self, request: &PickRequest) -> Result<Mechanism, Fault> {
        let model = self.drawing.model(&request.parts);
        model.map_err(|e| Fault::senseless(e.to_string()).help(e.help()))
    }

    /// Shows the model of picked faces below a path, in place of one that was shown there before.
    fn open(&self, request: &PickRequest, base: &str) -> Result<(), Fault> {
        let model = self.model(request)?;
        // What cannot be saved is not shown.
        toml(&model)?;
        let pairs = model.pairs.clone();
        let work = Work::new(Opened::model(model, pairs, false), &self.model_page);
        let router = routes::router(base, work.map_err(Fault::internal)?);
        let mut opened = self.opened.lock().unwrap_or_else(PoisonError::into_inner);
        *opened = Some(router);
        Ok(())
    }

    /// The routes of the model that was opened last.
    fn opened(&self) -> Option<Router> {
        let opened = self.opened.lock().unwrap_or_else(PoisonError::into_inner);
        opened.clone()
    }
}

/// The routes of a drawing below a path.
pub(super) fn router(base: &str, choice: Choice) -> Router {
    let at = |path: &str| format!("{base}{path}");
    let below = at(OPENED);
    let router = Router::new()
        .route(&at(""), get(page))
        .route(&at("model"), post(model))
        .route(
            &at("open"),
            post(async move |State(choice): Shared, request: Request| {
                let picked: PickRequest = parsed(request).await?;
                apart(move || choice.open(&picked, &below)).await?;
                let answer = serde_json::to_vec(&OpenAnswer { address: OPENED });
                answer
                    .map(|bytes| json(bytes.into()))
                    .map_err(Fault::internal)
            }),
        )
        .route(&at(OPENED), any(opened))
        .route(&at(&format!("{OPENED}{{*rest}}")), any(opened));
    routes::complete(router, choice)
}

async fn page(State(choice): Shared) -> Response {
    html(choice.page.clone(), &choice.policy)
}

async fn model(State(choice): Shared, request: Request) -> Result<Response, Fault> {
    let picked: PickRequest = parsed(request).await?;
    let text = apart(move || toml(&choice.model(&picked)?)).await?;
    Ok(of_type("application/toml; charset=utf-8", text))
}

/// What is asked of the model's page.
async fn opened(State(choice): Shared, mut request: Request) -> Response {
    let Some(router) = choice.opened() else {
        return nothing_here().into_response();
    };
    // The path has been taken apart for the outer routes, and is again for the inner ones.
    request.extensions_mut().clear();
    match TowerToHyperService::new(router).call(request).await {
        Ok(response) => response,
        Err(never) => match never {},
    }
}
