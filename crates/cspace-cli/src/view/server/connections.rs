//! Connections: taken one after the other, dropped when nothing comes.

use core::convert::Infallible;
use core::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpListener;

use super::ServeError;

/// A connection without a complete request head within this time is dropped. A page on this machine sends it at once,
/// and connects again for its next request.
const PATIENCE: Duration = Duration::from_secs(20);

/// Pause after the system refused a connection: it has no more open files until some are closed.
const BACK_OFF: Duration = Duration::from_millis(100);

/// Answers on every connection until the process ends.
pub(super) async fn serve(listener: TcpListener, router: Router) -> Result<Infallible, ServeError> {
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(PATIENCE);
    loop {
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(BACK_OFF).await;
            continue;
        };
        // Small answers are sent at once, and not kept until there is more to send; without that it would only be slower.
        let _ = stream.set_nodelay(true);
        let service = TowerToHyperService::new(router.clone());
        let connection = http.serve_connection(TokioIo::new(stream), service);
        // A connection that ends early, or does not speak HTTP, is no concern of the others.
        tokio::spawn(async move { drop(connection.await) });
    }
}
