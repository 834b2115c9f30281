//! The routes. All are below the token; nothing else is there.

use std::sync::Arc;

use axum::Router;
use axum::extract::rejection::PathRejection;
use axum::extract::{Path, State};
use axum::http::{HeaderName, HeaderValue, StatusCode};
use axum::middleware::from_fn_with_state;
use axum::response::Response;
use axum::routing::get;
use tokio::task::spawn_blocking;

use super::guard::{Names, guard};
use super::reply::{Fault, json, of_type};
use super::work::{ServedPage, Work};

type Shared = State<Arc<Work>>;

/// The routes of a model below a path.
pub(super) fn of_model(base: &str, work: Work) -> Router {
    let pair_route = format!("{base}pair/{{index}}");
    let router = of_page(base, work.page.clone()).route(&pair_route, get(pair));
    complete(router.with_state(Arc::new(work)))
}

/// The one route of a drawing below a path: its page makes the model itself.
pub(super) fn of_drawing(base: &str, page: ServedPage) -> Router {
    complete(of_page(base, page).with_state(()))
}

/// The route of a page.
fn of_page<S: Clone + Send + Sync + 'static>(base: &str, page: ServedPage) -> Router<S> {
    Router::new().route(base, get(async move || html(&page)))
}

/// Adds the answers to requests without a route.
fn complete(router: Router) -> Router {
    router
        .method_not_allowed_fallback(async || other_method())
        .fallback(async || nothing_here())
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

fn nothing_here() -> Fault {
    Fault::new(StatusCode::NOT_FOUND, "there is nothing here")
}

/// Answer with a page and its policy.
fn html(page: &ServedPage) -> Response {
    let mut response = of_type("text/html; charset=utf-8", page.html.clone());
    if let Ok(policy) = HeaderValue::from_str(&page.policy) {
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
    // It may take long, and is done on a thread of its own.
    let found = spawn_blocking(move || work.pair(index)).await;
    found
        .map_err(Fault::internal)?
        .map(json)
        .ok_or_else(nothing_here)
}
