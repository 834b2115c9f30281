//! Result of a drag.

use crate::record::What;

/// How a drag ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// The part is where it was dragged to.
    Reached,
    /// Contacts or ends of ranges keep it from there; a planar part is as near as it comes by sliding along them.
    Stopped,
    /// Joints keep it from there, by themselves or with contacts.
    Held,
    /// The steps of one call are used up; another call goes on. Where loads come to a balance only after many trials it may come no farther: then
    /// the target is to be another, or the model without these loads.
    Unfinished,
    /// It cannot be told how the motion goes on, for this reason. Parts are where that is.
    Lost(String),
}

/// A contact or an end of a range that keeps a part from where it is dragged to.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopper {
    /// Which.
    pub what: What,
    /// Where, in the assembly's frame; ends of ranges are nowhere.
    pub at: Option<[f64; 2]>,
}

/// Result of a drag.
#[derive(Debug, Clone, PartialEq)]
pub struct Dragged {
    /// How it ended.
    pub ending: Ending,
    /// Contacts and ends of ranges that keep the part from its target: all of the chain of parts up to a fixed one.
    pub stopped_by: Vec<Stopper>,
    /// The parts that overlapped each other before and still do, as [`Hand::overlapping`](crate::Hand::overlapping).
    pub overlapping: Vec<(usize, usize)>,
    /// The names of parts that went at once to where forces balance, in order: of those that go together the one that goes farthest.
    pub snaps: Vec<String>,
    /// All coordinates on the way, from where it began to where it ended.
    pub way: Vec<Vec<f64>>,
}

impl Dragged {
    /// Whether the part is where it was dragged to.
    pub fn reached(&self) -> bool {
        self.ending == Ending::Reached
    }
}
