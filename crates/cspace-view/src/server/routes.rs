//! The routes. All are below the token; nothing else is there.

use std::sync::Arc;

use axum::Router;
use axum::body::{Bytes, to_bytes};
use axum::extract::rejection::PathRejection;
use axum::extract::{Path, Request, State};
use axum::http::{HeaderName, HeaderValue, StatusCode, header};
use axum::middleware::from_fn_with_state;
use axum::response::Response;
use axum::routing::get;
use serde::de::DeserializeOwned;
use tokio::task::spawn_blocking;
use tokio::time::timeout;

use super::connections::PATIENCE;
use super::guard::{Names, guard};
use super::reply::{Fault, json, of_type};
use super::work::Work;

/// The longest body read, in bytes: some hundred thousand vertices.
const LONGEST_BODY: usize = 8 << 20;

type Shared = State<Arc<Work>>;

/// The routes of a model below a path.
pub(super) fn router(base: &str, work: Work) -> Router {
    let at = |path: &str| format!("{base}{path}");
    let router = Router::new()
        .route(&at(""), get(page))
        .route(&at("pair/{index}"), get(pair));
    complete(router, work)
}

/// Routes with what is answered where there is none, and the state that they share.
pub(super) fn complete<S: Send + Sync + 'static>(router: Router<Arc<S>>, state: S) -> Router {
    router
        .method_not_allowed_fallback(async || other_method())
        .fallback(async || nothing_here())
        .with_state(Arc::new(state))
}

/// Routes that answer only pages of this server.
pub(super) fn guarded(router: Router, port: u16) -> Router {
    router.layer(from_fn_with_state(Names::of(port), guard))
}

fn other_method() -> Fault {
    Fault::new(
        StatusCode::METHOD_NOT_ALLOWED,
        "this is not done by that method",
    )
}

pub(super) fn nothing_here() -> Fault {
    Fault::new(StatusCode::NOT_FOUND, "there is nothing here")
}

async fn page(State(work): Shared) -> Response {
    html(work.page.clone(), &work.policy)
}

/// A page, with what it may load.
pub(super) fn html(page: Bytes, policy: &str) -> Response {
    let mut response = of_type("text/html; charset=utf-8", page);
    if let Ok(policy) = HeaderValue::from_str(policy) {
        let name = HeaderName::from_static("content-security-policy");
        response.headers_mut().insert(name, policy);
    }
    response
}

async fn pair(
    State(work): Shared,
    index: Result<Path<String>, PathRejection>,
) -> Result<Response, Fault> {
    let Path(text) = index.map_err(|_| nothing_here())?;
    // A pair has one address.
    let index = (text.parse::<usize>().ok())
        .filter(|i| i.to_string() == text)
        .ok_or_else(nothing_here)?;
    let found = apart(move || Ok(work.pair(index))).await?;
    found.map(json).ok_or_else(nothing_here)
}

/// Does what may take long on a thread of its own.
pub(super) async fn apart<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Fault> + Send + 'static,
) -> Result<T, Fault> {
    spawn_blocking(work).await.map_err(Fault::internal)?
}

/// What the body of a request says. One that is too long is not read, whether it says its length or not.
pub(super) async fn parsed<T: DeserializeOwned>(request: Request) -> Result<T, Fault> {
    let too_long = || {
        Fault::new(
            StatusCode::PAYLOAD_TOO_LARGE,
            format!("the body has more than {LONGEST_BODY} bytes"),
        )
        .help("give parts with fewer vertices")
    };
    let length = request.headers().get(header::CONTENT_LENGTH);
    let length = length.and_then(|l| l.to_str().ok()?.parse::<usize>().ok());
    if length.is_some_and(|l| l > LONGEST_BODY) {
        return Err(too_long());
    }
    let body = timeout(PATIENCE, to_bytes(request.into_body(), LONGEST_BODY));
    let body = body.await.map_err(|_| {
        let seconds = PATIENCE.as_secs();
        let message = format!("the body did not come within {seconds} s");
        Fault::new(StatusCode::REQUEST_TIMEOUT, message)
    })?;
    // If it is the connection that fails, nobody gets the answer.
    let bytes = body.map_err(|_| too_long())?;
    serde_json::from_slice(&bytes).map_err(|e| {
        Fault::bad(format!("the body is not what is expected: {e}"))
            .help("docs/page.md describes what is sent")
    })
}
