//! Stabbing queries on intervals: which of them contain a place, for places in rising order.

/// Intervals, and those among them that may contain the current place.
#[derive(Debug)]
pub(crate) struct Covering {
    /// Ends and numbers, sorted by the lower ends.
    by_start: Vec<(f64, f64, usize)>,
    begun: usize,
    /// Numbers and upper ends of the current intervals, sorted by number.
    now: Vec<(usize, f64)>,
}

impl Covering {
    /// Covering by intervals given by their ends, numbered from 0.
    pub(crate) fn new(intervals: impl Iterator<Item = (f64, f64)>) -> Self {
        let mut by_start: Vec<_> = (0..).zip(intervals).map(|(i, (a, b))| (a, b, i)).collect();
        by_start.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
        Self {
            by_start,
            begun: 0,
            now: Vec::new(),
        }
    }

    /// Advances to a place. Places must come in rising order.
    pub(crate) fn go_to(&mut self, place: f64) {
        self.now.retain(|n| n.1 >= place);
        while let Some(&(start, end, i)) = self.by_start.get(self.begun) {
            if start > place {
                break;
            }
            if end >= place {
                let at = self.now.partition_point(|n| n.0 < i);
                self.now.insert(at, (i, end));
            }
            self.begun += 1;
        }
    }

    /// The numbers of the intervals that contain the current place, in rising order.
    pub(crate) fn here(&self) -> impl Iterator<Item = usize> + '_ {
        self.now.iter().map(|n| n.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_come_and_go() {
        let mut covering =
            Covering::new([(0.5, 2.0), (0.0, 1.0), (1.5, 1.75), (0.25, 9.0)].into_iter());
        let mut at = |place| {
            covering.go_to(place);
            covering.here().collect::<Vec<_>>()
        };
        assert!(at(-1.0).is_empty());
        assert_eq!(at(0.75), [0, 1, 3]);
        assert_eq!(at(1.6), [0, 2, 3]);
        assert_eq!(at(3.0), [3]);
        assert!(at(10.0).is_empty());
    }
}
