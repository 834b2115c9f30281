//! Contacts from touch to release.

use schemars::JsonSchema;
use serde::Serialize;

use crate::record::{EventKind, Record, What};

/// Contact from the instant at which two features meet to that at which the parts separate there. In between the
/// contact may pass on to adjacent features.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ContactInterval {
    /// The name of the pair's fixed part.
    pub fixed: String,
    /// The name of its moving part.
    pub moving: String,
    /// The features of the two that touch first.
    pub features: [String; 2],
    /// Beginning, in seconds.
    pub from: f64,
    /// End, in seconds; `None` if it lasts to the end of the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
}

impl ContactInterval {
    /// End of the contact, at the latest that of the motion.
    pub fn end(&self, until: f64) -> f64 {
        self.to.unwrap_or(until)
    }
}

/// The contacts of a record, by their beginnings.
pub(super) fn intervals(record: &Record) -> Vec<ContactInterval> {
    let mut all: Vec<ContactInterval> = Vec::new();
    // Contacts that have not ended.
    let mut open: Vec<usize> = Vec::new();
    for event in &record.events {
        let What::Contact {
            fixed,
            moving,
            features,
        } = &event.what
        else {
            continue;
        };
        let of_pair = |c: &ContactInterval| c.fixed == *fixed && c.moving == *moving;
        match event.kind {
            // A contact at which impacts have come to rest lasts; a touch may be reported for it as well.
            EventKind::Touch | EventKind::Rest => {
                let is_open = |c: &ContactInterval| of_pair(c) && c.features == *features;
                if !open.iter().any(|&i| is_open(&all[i])) {
                    open.push(all.len());
                    all.push(ContactInterval {
                        fixed: fixed.clone(),
                        moving: moving.clone(),
                        features: features.clone(),
                        from: event.t,
                        to: None,
                    });
                }
            }
            // The features are those of the end: the contact with most of them, the oldest of these.
            EventKind::Release => {
                let same = |c: &ContactInterval| {
                    let pairs = c.features.iter().zip(features);
                    pairs.filter(|(a, b)| a == b).count()
                };
                let of_this = open.iter().copied().filter(|&i| of_pair(&all[i])).rev();
                if let Some(best) = of_this.max_by_key(|&i| same(&all[i])) {
                    all[best].to = Some(event.t);
                    open.retain(|&i| i != best);
                }
            }
            EventKind::Impact
            | EventKind::Stick
            | EventKind::Slip
            | EventKind::Limit
            | EventKind::Snap
            | EventKind::Jam
            | EventKind::Choice
            | EventKind::Bridge => {}
        }
    }
    all
}

/// The times at which two parts touch anywhere, from and to, without gaps shorter than `near`.
pub(super) fn together(
    contacts: &[ContactInterval],
    [fixed, moving]: [&str; 2],
    until: f64,
    near: f64,
) -> Vec<(f64, f64)> {
    let mut joined: Vec<(f64, f64)> = Vec::new();
    let of_pair = contacts
        .iter()
        .filter(|c| c.fixed == fixed && c.moving == moving);
    // They are in order of their beginnings.
    for contact in of_pair {
        let (from, to) = (contact.from, contact.end(until));
        match joined.last_mut() {
            Some(last) if from <= last.1 + near => last.1 = last.1.max(to),
            _ => joined.push((from, to)),
        }
    }
    joined
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Event, Status};

    fn event(t: f64, kind: EventKind, features: [&str; 2]) -> Event {
        let what = What::Contact {
            fixed: "a".into(),
            moving: "b".into(),
            features: features.map(String::from),
        };
        Event::new(t, kind, what, None)
    }

    #[test]
    fn releases_end_the_contact_they_are_of() {
        use EventKind::{Impact, Release, Rest, Touch};
        let events = vec![
            event(0.0, Touch, ["line 1", "arc 1"]),
            event(0.5, Impact, ["line 9", "arc 9"]),
            event(1.0, Touch, ["line 2", "arc 2"]),
            event(2.0, Release, ["line 3", "arc 2"]),
            event(3.0, Release, ["line 7", "arc 7"]),
            event(4.0, Rest, ["line 1", "arc 1"]),
            event(4.0, Touch, ["line 2", "arc 1"]),
            event(5.0, Release, ["line 4", "arc 4"]),
        ];
        let record = Record {
            status: Status::Done,
            until: 6.0,
            reason: None,
            obstacles: Vec::new(),
            samples: Vec::new(),
            events,
            trace: Vec::new(),
            energy: None,
            open: 0.0,
        };
        let all = intervals(&record);
        let ends: Vec<(f64, Option<f64>)> = all.iter().map(|c| (c.from, c.to)).collect();
        let expected = [
            (0.0, Some(3.0)),
            (1.0, Some(2.0)),
            (4.0, Some(5.0)),
            (4.0, None),
        ];
        assert_eq!(ends, expected);
        let joined = together(&all, ["a", "b"], 6.0, 1e-9);
        assert_eq!(joined, [(0.0, 3.0), (4.0, 6.0)]);
    }
}
