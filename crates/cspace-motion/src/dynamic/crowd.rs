//! Events in so short a time that steps lead over them.
//!
//! Impacts that accumulate come nearer to each other, and are followed to their limit (`accumulate.rs`). Contacts that close and open in
//! turn, because each opens another, go on for as long as what drives them does: their events follow each other at the same distances.

use std::collections::VecDeque;

/// So many events within a share of the time that is simulated are a crowd, whatever their order.
const MOST: (usize, f64) = (300, 1e-4);
/// As are so many if they do not accumulate.
const EVEN: (usize, f64) = (64, 1e-4);
/// Events accumulate if the second half of them takes less than this share of the time of the first: impacts with a restitution of up to
/// 0.97, or where two contacts strike in turn, of 0.95.
const NEARER: f64 = 0.5;

/// The times of the last events.
#[derive(Debug, Default)]
pub(super) struct Crowd(VecDeque<f64>);

impl Crowd {
    /// Adds an event, in a simulation of a time; whether there is a crowd with it.
    pub(super) fn grows(&mut self, t: f64, span: f64) -> bool {
        self.0.push_front(t);
        self.0.truncate(MOST.0);
        let ago = |events: usize| self.0.get(events - 1).map(|past| t - past);
        let within =
            |(events, share): (usize, f64)| ago(events).filter(|&time| time < share * span);
        let is_even = |time: f64| ago(EVEN.0 / 2).is_some_and(|last| last > NEARER * (time - last));
        within(MOST).is_some() || within(EVEN).is_some_and(is_even)
    }
}

#[cfg(test)]
mod tests {
    use super::{Crowd, EVEN, MOST};

    /// The number of events with distances that fall by a ratio, at which there is a crowd in 1 s.
    fn crowded(first: f64, ratio: f64) -> Option<usize> {
        let (mut crowd, mut t, mut distance) = (Crowd::default(), 0.0, first);
        (1..=1000).find(|_| {
            t += distance;
            distance *= ratio;
            crowd.grows(t, 1.0)
        })
    }

    #[test]
    fn even_events_are_a_crowd_and_bounces_are_none() {
        assert_eq!(crowded(1e-8, 1.0), Some(EVEN.0));
        assert_eq!(crowded(1e-5, 1.0), None);
        // Bounces come to rest before there are that many.
        for restitution in [0.3, 0.6, 0.9, 0.97] {
            assert!(crowded(0.5, restitution).is_none_or(|n| n >= MOST.0));
        }
    }
}
