//! The library for JavaScript: what the page and the npm package `cspace` compute with.
//!
//! A [`Pair`](pair::Pair) is a configuration space that was computed, and answers questions about it. A [`Model`](model::Model) is a
//! model, of whose pairs spaces are computed, also once its parts are edited; it is planned and set in motion. A [`MechanismHand`](hand::MechanismHand) drags all of its parts. Types for TypeScript are in `types.ts`, and come with
//! what the compiler writes. A [`Drawing`](drawing::Drawing) shows its faces, of which a model is made.

mod drawing;
mod drawn;
mod hand;
mod model;
mod pair;
mod plane;
mod surface;

use wasm_bindgen::prelude::*;

/// TypeScript types of the answers.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.ts");

/// An error for JavaScript, which says what is wrong.
fn fault(error: impl core::fmt::Display) -> JsError {
    JsError::new(&error.to_string())
}

/// An answer as plain JavaScript data.
fn plain(answer: &impl serde::Serialize) -> Result<JsValue, JsError> {
    let plainly = serde_wasm_bindgen::Serializer::json_compatible();
    answer.serialize(&plainly).map_err(fault)
}
