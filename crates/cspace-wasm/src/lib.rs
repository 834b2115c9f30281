//! Library for JavaScript: the kernel of the page and of the npm package `cspace`.
//!
//! A [`Pair`](pair::Pair) is a computed configuration space that answers queries. A [`Model`](model::Model) computes
//! the spaces of its pairs, also after its parts are edited, and plans and simulates motions. A
//! [`MechanismHand`](hand::MechanismHand) drags all of its parts. A [`Drawing`](drawing::Drawing) shows its faces, from
//! which a model is made. Types for TypeScript are in `types.ts`, and are added to the compiler's output.

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

/// Error for JavaScript, with a message.
fn fault(error: impl core::fmt::Display) -> JsError {
    JsError::new(&error.to_string())
}

/// An answer as plain JavaScript data.
fn plain(answer: &impl serde::Serialize) -> Result<JsValue, JsError> {
    let plainly = serde_wasm_bindgen::Serializer::json_compatible();
    answer.serialize(&plainly).map_err(fault)
}
