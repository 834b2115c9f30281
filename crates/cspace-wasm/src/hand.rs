//! A whole mechanism, dragged by hand.

use cspace::Point;
use cspace_api::scene::{Edits, SceneSource};
use cspace_model::Mechanism;
use cspace_motion::{Dragged, Ending, Hand};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::model::told;
use crate::{fault, plain};

/// All parts of a model, with the spaces of its pairs: a dragged part pushes the parts in its way.
#[wasm_bindgen(js_name = Hand)]
pub struct MechanismHand {
    mechanism: Mechanism,
    hand: Hand,
}

/// Result of a drag.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Came {
    /// The coordinates of each part: none, [u], or [x, y, theta].
    parts: Vec<Vec<f64>>,
    reached: bool,
    /// Obstacles, in words; empty if the part reached its target.
    stopped: Vec<String>,
    /// Names of parts that overlap each other.
    overlapping: Vec<(String, String)>,
    /// Sentences on the parts that are smaller by a gap than drawn, because they fit exactly.
    gaps: Vec<String>,
    /// Names of parts that jumped to another balance of forces.
    snaps: Vec<String>,
}

#[wasm_bindgen(js_class = Hand)]
impl MechanismHand {
    /// Creates the edited mechanism of a scene's source; its parts are at their start.
    #[wasm_bindgen(constructor)]
    pub fn new(source: &str, edits: &str) -> Result<MechanismHand, JsError> {
        let source: SceneSource = serde_json::from_str(source).map_err(fault)?;
        let edits: Edits = serde_json::from_str(edits).map_err(fault)?;
        let opened = cspace_api::scene::Opened::from_source(&source).map_err(told)?;
        let mechanism = opened.edited(&edits).map_err(fault)?.mechanism;
        let hand = Hand::new(&mechanism).map_err(fault)?;
        Ok(Self { mechanism, hand })
    }

    /// Puts all parts elsewhere: the coordinates of all parts that move, in order, as [x, y, theta] or u.
    #[wasm_bindgen(js_name = setState, unchecked_return_type = "Came")]
    pub fn set_state(&mut self, state: &[f64]) -> Result<JsValue, JsError> {
        self.hand.set_state(state).map_err(fault)?;
        plain(&self.came(None))
    }

    /// Drags a point of a part, in the part's frame, towards a place in the assembly.
    #[wasm_bindgen(unchecked_return_type = "Came")]
    pub fn drag(&mut self, part: usize, of: &[f64], to: &[f64]) -> Result<JsValue, JsError> {
        let point = |c: &[f64]| match *c {
            [x, y] => Ok(Point::new(x, y)),
            _ => Err(fault("a point is [x, y]")),
        };
        let target = cspace_motion::Target::Point {
            of: point(of)?,
            to: point(to)?,
        };
        let dragged = self.hand.drag(part, target).map_err(fault)?;
        plain(&self.came(Some(&dragged)))
    }
}

impl MechanismHand {
    fn came(&self, dragged: Option<&Dragged>) -> Came {
        let name = |i: usize| self.mechanism.parts[i].part.name().to_owned();
        let state = self.hand.state();
        let all = self.hand.system().parts().iter();
        let overlapping = self.hand.overlapping();
        let stopped = dragged.map_or_else(Vec::new, |d| {
            let mut told: Vec<String> = d.stopped_by.iter().map(|s| s.what.to_string()).collect();
            if let Ending::Lost(why) = &d.ending {
                told.push(why.clone());
            }
            told
        });
        Came {
            parts: all.map(|part| state[part.indices()].to_vec()).collect(),
            reached: dragged.is_none_or(Dragged::reached),
            stopped,
            overlapping: overlapping
                .iter()
                .map(|&(a, b)| (name(a), name(b)))
                .collect(),
            gaps: (self.hand.gaps().iter())
                .map(|gap| gap.sentence(&self.mechanism))
                .collect(),
            snaps: dragged.map_or_else(Vec::new, |d| d.snaps.clone()),
        }
    }
}
