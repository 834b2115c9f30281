//! A page that shows parts and their configuration spaces, served on loopback or written as one file.
//!
//! What is shown is a [`Scene`](cspace_scene::Scene). The [`Page`] with a scene in it is one HTML file that works offline: it has the
//! kernel in it, as WebAssembly, and computes what is edited itself. A [`Server`] serves it, and computes the pairs when they are
//! asked for. The page with a [`DrawingScene`](cspace_scene::DrawingScene) in it shows the faces of a drawing, and makes a model of them.

mod html;
mod page;
mod server;

pub use page::{Page, PageError};
pub use server::{ServeError, Server};
