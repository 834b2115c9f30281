//! Server of the page, on this machine alone.
//!
//! Its address contains a secret token, and requests must name this machine as their host (`guard.rs`). It knows the
//! routes in `routes.rs` and no others, reads and writes no files, and computes on threads of its own (`work.rs`).

mod connections;
mod guard;
mod reply;
mod routes;
mod work;

use core::convert::Infallible;
use std::io::ErrorKind;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};

use axum::Router;
use cspace_api::scene::{DrawingScene, Opened};

use crate::view::page::Page;
use work::{ServedPage, Work};

/// A server that has an address and does not answer yet.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    token: String,
    router: Router,
}

/// Why the page cannot be served.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ServeError {
    /// The port is taken.
    #[error("port {port} of this machine is in use")]
    PortInUse {
        /// The port.
        port: u16,
    },
    /// The port cannot be had for another reason.
    #[error("port {port} of this machine cannot be listened to: {error}")]
    Port {
        /// The port.
        port: u16,
        /// Why.
        error: std::io::Error,
    },
    /// The system gives no random numbers.
    #[error("the system gives no random numbers: {0}")]
    Random(getrandom::Error),
    /// The server cannot go on.
    #[error("the server cannot go on: {0}")]
    Input(#[from] std::io::Error),
    /// The scene is no JSON.
    #[error("the scene cannot be written: {0}")]
    Scene(#[from] serde_json::Error),
}

impl Server {
    /// Binds a port of this machine, any free one if it is 0, for a page that shows the opened model or space.
    ///
    /// # Errors
    /// If the port is not available, or the system provides no random numbers.
    pub fn bind(opened: Opened, page: &Page, port: u16) -> Result<Self, ServeError> {
        let work = Work::new(opened, page)?;
        Self::of(port, |base| routes::of_model(base, work))
    }

    /// Binds a port of this machine, any free one if it is 0, for a page that shows the faces of a drawing. The page
    /// makes the model of picked faces itself.
    ///
    /// # Errors
    /// If the port is not available, or the system provides no random numbers.
    pub fn bind_drawing(
        drawing: &DrawingScene,
        page: &Page,
        port: u16,
    ) -> Result<Self, ServeError> {
        let page = ServedPage::new(page, drawing)?;
        Self::of(port, |base| routes::of_drawing(base, page))
    }

    /// Creates a server of the routes below a path.
    fn of(port: u16, router: impl FnOnce(&str) -> Router) -> Result<Self, ServeError> {
        let taken = TcpListener::bind((Ipv4Addr::LOCALHOST, port));
        let listener = taken.map_err(|error| match error.kind() {
            ErrorKind::AddrInUse => ServeError::PortInUse { port },
            _ => ServeError::Port { port, error },
        })?;
        let (address, token) = (listener.local_addr()?, token()?);
        let router = routes::guarded(router(&format!("/{token}/")), address.port());
        Ok(Self {
            listener,
            address,
            token,
            router,
        })
    }

    /// The page's address. Whoever knows it may ask the server.
    pub fn url(&self) -> String {
        format!("http://{}/{}/", self.address, self.token)
    }

    /// Answers requests until the process ends.
    ///
    /// # Errors
    /// If the system refuses to start the server.
    pub fn run(self) -> Result<Infallible, ServeError> {
        /// Number of threads: requests are few, and long computations are done by other threads.
        const THREADS: usize = 2;
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(THREADS)
            .enable_io()
            .enable_time()
            .build()?;
        runtime.block_on(async {
            self.listener.set_nonblocking(true)?;
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            connections::serve(listener, self.router).await
        })
    }
}

/// 128 random bits in hexadecimal digits.
fn token() -> Result<String, ServeError> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(ServeError::Random)?;
    Ok(bytes.iter().map(|b| format!("{b:02x}")).collect())
}
