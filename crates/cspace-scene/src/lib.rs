//! What a page shows of parts and their configuration spaces, as data.
//!
//! A [`Scene`] is all that the page is given; `docs/page.md` in the project's repository describes every field. It is made of what
//! was [`Opened`]: a model or a saved space. Parts of the model can be [`edited`], and a model can be made of the faces of an
//! [`OpenedDrawing`].

mod base_64;
mod drawing;
mod edit;
mod opened;
pub mod scene;

pub use drawing::{
    DrawingScene, DrawingSource, ImportedPart, OpenedDrawing, PickError, PickedPart, SceneFace,
    model_name,
};
pub use edit::{EditError, EditedPart, edited};
pub use opened::{EditAnswer, EditedPairError, Opened};
pub use scene::{Scene, ScenePair, ScenePart, SceneRecord, SceneSource};
