//! A page that shows parts and their configuration spaces, served on loopback or written as one file.
//!
//! A page shows a [`Scene`](cspace_api::scene::Scene). The [`Page`] with a scene in it is one HTML file that works offline:
//! it contains the kernel, as WebAssembly, and computes edited pairs itself. A [`Server`] serves it, and computes the
//! pairs when they are asked for. The page with a [`DrawingScene`](cspace_api::scene::DrawingScene) in it shows the faces of
//! a drawing, and makes a model of them.

mod html;
mod page;
mod server;

pub use page::{Page, PageError};
pub use server::{ServeError, Server};
