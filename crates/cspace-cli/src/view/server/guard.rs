//! Access control: only pages of this server, in a browser on this machine, get answers.
//!
//! A page of another site can send requests here. It cannot guess the token, and the browser reports its origin. A host
//! name that another site has redirected to this machine is detected by the host header.

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::header::{HOST, HeaderName, ORIGIN};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::reply::Fault;

/// Names by which the server may be addressed.
#[derive(Debug, Clone)]
pub(super) struct Names(Arc<Vec<String>>);

/// The port that addresses leave out.
const PLAIN_PORT: u16 = 80;

/// Headers of every answer: it is kept nowhere, shown in no frame, sends no referrer, and is taken for no other type of
/// content.
const HEADERS: [(&str, &str); 6] = [
    ("cache-control", "no-store"),
    ("referrer-policy", "no-referrer"),
    ("x-content-type-options", "nosniff"),
    ("x-frame-options", "DENY"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cross-origin-opener-policy", "same-origin"),
];

/// Content-Security-Policy of an answer that is no page.
const NO_PAGE: &str = "default-src 'none'; frame-ancestors 'none'";

impl Names {
    pub(super) fn of(port: u16) -> Self {
        let hosts = ["127.0.0.1", "localhost"];
        let mut names: Vec<String> = hosts.iter().map(|h| format!("{h}:{port}")).collect();
        if port == PLAIN_PORT {
            names.extend(hosts.map(str::to_owned));
        }
        Self(Arc::new(names))
    }

    /// Whether a request comes from a page of this server, or from no page.
    fn allow(&self, headers: &HeaderMap) -> bool {
        let known = |host: &[u8]| {
            self.0
                .iter()
                .any(|n| n.as_bytes().eq_ignore_ascii_case(host))
        };
        let mut hosts = headers.get_all(HOST).iter();
        let (host, more) = (hosts.next(), hosts.next());
        let host_is_known = host.is_some_and(|h| known(h.as_bytes())) && more.is_none();
        let own = |o: &HeaderValue| o.as_bytes().strip_prefix(b"http://").is_some_and(known);
        host_is_known && headers.get_all(ORIGIN).iter().all(own)
    }
}

/// Refuses requests from elsewhere, and gives every answer its headers.
pub(super) async fn guard(State(names): State<Names>, request: Request, next: Next) -> Response {
    let mut response = if names.allow(request.headers()) {
        next.run(request).await
    } else {
        let refusal = "the request does not come from a page of this server";
        Fault::new(StatusCode::FORBIDDEN, refusal).into_response()
    };
    let headers = response.headers_mut();
    for (name, value) in HEADERS {
        headers.insert(
            HeaderName::from_static(name),
            HeaderValue::from_static(value),
        );
    }
    (headers.entry("content-security-policy")).or_insert(HeaderValue::from_static(NO_PAGE));
    response
}
