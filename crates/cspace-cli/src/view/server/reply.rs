//! Answers of the server.

use axum::body::Bytes;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::{IntoResponse, Response};
use serde::Serialize;

/// Error as JSON, with its message.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Fault {
    #[serde(skip)]
    status: StatusCode,
    error: String,
}

impl Fault {
    pub(super) fn new(status: StatusCode, error: impl Into<String>) -> Self {
        Self {
            status,
            error: error.into(),
        }
    }

    /// The program is wrong.
    pub(super) fn internal(error: impl core::fmt::Display) -> Self {
        Self::new(StatusCode::INTERNAL_SERVER_ERROR, error.to_string())
    }
}

impl IntoResponse for Fault {
    fn into_response(self) -> Response {
        let bytes = serde_json::to_vec(&self).unwrap_or_default();
        (self.status, json(bytes.into())).into_response()
    }
}

/// Bytes that are JSON.
pub(super) fn json(bytes: Bytes) -> Response {
    of_type("application/json", bytes)
}

/// Bytes of a type.
pub(super) fn of_type(kind: &'static str, bytes: Bytes) -> Response {
    let kind = HeaderValue::from_static(kind);
    ([(header::CONTENT_TYPE, kind)], bytes).into_response()
}
