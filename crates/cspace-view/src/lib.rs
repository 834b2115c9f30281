//! A page that shows parts and their configuration spaces, served on loopback or written as one file.
//!
//! What is shown is a [`Scene`](cspace_scene::Scene). The [`Page`] with a scene in it is one HTML file that works offline: it has the
//! kernel in it, as WebAssembly, and computes what is edited itself. A [`Server`] serves it, and computes the pairs when they are
//! asked for. Another page shows the faces of an [`OpenedDrawing`](cspace_scene::OpenedDrawing), of which a model is made.

mod html;
mod page;
mod server;

pub use page::{Page, PageError, Pages};
pub use server::{ServeError, Server};
