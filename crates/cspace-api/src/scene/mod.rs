//! Data shown by a page: parts and their configuration spaces.
//!
//! A [`Scene`] is all data that the page is given; `docs/page.md` in the project's repository describes every field. It
//! is made from a model or a saved space that was [`Opened`]. Parameters of the model can be given other values and
//! parts can be [`edited`]; a model can be made from the faces of an [`OpenedDrawing`].

mod base_64;
pub mod data;
mod design;
mod drawing;
mod edit;
mod opened;

pub use data::{Scene, ScenePair, ScenePart, SceneRecord, SceneSource};
pub use design::{SceneDesign, SceneParameter, SceneSetting, SceneText};
pub use drawing::{
    DrawingScene, DrawingSource, ImportedPart, OpenedDrawing, PickError, PickedPart, SceneFace,
    model_name,
};
pub use edit::{EditError, EditedPart, Edits, edited};
pub use opened::{EditAnswer, EditedPairError, Opened};
