use cspace::{Coordinates, PairSpace, PatchId, QueryError};
pub struct Slider;
pub struct Slid { pub at: Coordinates, pub stopped: Option<PatchId> }
impl Slider {
    pub fn new(_: &PairSpace) -> Self { Self }
    pub fn advance(&self, _: &PairSpace, _: Coordinates, to: Coordinates) -> Result<Slid, QueryError> { Ok(Slid { at: to, stopped: None }) }
    pub fn slide(&self, _: &PairSpace, _: Coordinates, to: Coordinates) -> Result<Slid, QueryError> { Ok(Slid { at: to, stopped: None }) }
}
