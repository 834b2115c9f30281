//! Pairs of sheets that can have points in common: three sheets meet only where every two of them do.

use crate::contact::Geometry;
use crate::grouped::starts;

use crate::general::events::trace::SheetMeeting;

/// Meetings of sheets: which pairs cross or touch, and when.
pub(crate) struct Meetings<'a> {
    geometry: &'a Geometry,
    meetings: &'a [SheetMeeting],
    /// Meetings in which sheet i is the first of the two: `meetings[start[i]..start[i + 1]]`.
    start: Vec<u32>,
}

impl<'a> Meetings<'a> {
    pub(crate) fn new(geometry: &'a Geometry, meetings: &'a [SheetMeeting]) -> Self {
        let sheets = geometry.contacts.sheets.len();
        let start = starts(sheets, meetings.iter().map(|e| e.first));
        Self {
            geometry,
            meetings,
            start,
        }
    }

    /// Whether two sheets may have a point in common between two clusters: three sheets meet only where every two do.
    ///
    /// Sheets that share an end or a carrier have points in common without crossing.
    pub(crate) fn may_meet(&self, f: u32, g: u32, from: u32, to: u32) -> bool {
        if f == g {
            return false;
        }
        let (first, second) = (f.min(g), f.max(g));
        let range = self.start[first as usize] as usize..self.start[first as usize + 1] as usize;
        let mine = &self.meetings[range];
        let at = mine.partition_point(|e| e.second < second);
        let met = mine[at..]
            .iter()
            .take_while(|e| e.second == second)
            .any(|e| e.from <= to && from <= e.to);
        if met {
            return true;
        }
        let contacts = &self.geometry.contacts;
        let shared = contacts.sheets[f as usize]
            .shared_ends(&contacts.sheets[g as usize], contacts.first_vertex_name);
        shared.tangent || shared.corners.contains(&true)
    }
}
