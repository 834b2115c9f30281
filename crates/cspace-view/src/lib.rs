//! A page that shows parts and their configuration spaces, served on loopback or written as one file.
//!
//! What is shown is a [`Scene`]; `docs/page.md` in the project's repository describes every field. It is made of what was
//! [`Opened`], a model or a saved space. The [`Page`] with a scene in it is one HTML file that works offline; a [`Server`]
//! serves it, computes the pairs when they are asked for, and again while parts are edited. Another page shows the faces of an
//! [`OpenedDrawing`], of which a model is made.

mod drawing;
mod edit;
mod html;
mod opened;
mod page;
pub mod scene;
mod server;

pub use drawing::{DrawingScene, OpenedDrawing, PickError, PickedPart, SceneFace};
pub use edit::{EditError, EditedPart, edited};
pub use opened::Opened;
pub use page::{Page, PageError, Pages};
pub use scene::{Scene, ScenePair, ScenePart, SceneRecord};
pub use server::{ServeError, Server};
