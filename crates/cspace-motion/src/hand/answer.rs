//! Result of a drag.

use crate::record::What;

/// Reason for the end of a drag.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending {
    /// The part has reached its target.
    Reached,
    /// Contacts or ends of ranges keep it from there; a planar part is as near as it comes by sliding along them.
    Stopped,
    /// Joints keep it from there, by themselves or with contacts.
    Held,
    /// The steps of one call are used up; another call goes on. If loads come to a balance only after many trials,
    /// further calls may not help: then choose another target, or remove these loads from the model.
    Unfinished,
    /// The continuation of the motion is not determined, for this reason. Parts are at the configuration where it
    /// ended.
    Lost(String),
}

/// A contact or an end of a range that keeps a part from where it is dragged to.
#[derive(Debug, Clone, PartialEq)]
pub struct Stopper {
    /// Contact or end of a range.
    pub what: What,
    /// Position, in the assembly's frame; `None` for ends of ranges.
    pub at: Option<[f64; 2]>,
}

/// Result of a drag.
#[derive(Debug, Clone, PartialEq)]
pub struct Dragged {
    /// Reason for the end.
    pub ending: Ending,
    /// Contacts and ends of ranges that keep the part from its target: all of the chain of parts up to a fixed one.
    pub stopped_by: Vec<Stopper>,
    /// The parts that overlapped each other before and still do, as [`Hand::overlapping`](crate::Hand::overlapping).
    pub overlapping: Vec<(usize, usize)>,
    /// Names of parts that jumped to another balance of forces, in order: of those that move together the one that
    /// moves farthest.
    pub snaps: Vec<String>,
    /// All coordinates during the drag, from its beginning to its end.
    pub way: Vec<Vec<f64>>,
}

impl Dragged {
    /// Whether the part has reached its target.
    pub fn reached(&self) -> bool {
        self.ending == Ending::Reached
    }
}
