//! Entities of other layers between the ends of open chains.

use std::collections::{HashSet, VecDeque};

use cspace::Point;
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::joined::{Chain, origin_of};
use crate::drawing::{Drawing, LayerReason, Origin};
use crate::shown;

/// The end of a link: twice the link's number, and one more for where it ends.
type LinkEnd = GeomWithData<[f64; 2], usize>;

/// A piece that is no part of an open chain, and may lie in the gap of one.
struct Link<'d> {
    ends: [Point; 2],
    origin: &'d Origin,
    /// Why it is left out; none of one that another outline has.
    reason: Option<LayerReason>,
}

/// The pieces of layers that are left out, and of closed outlines.
pub(super) struct Bridges<'d> {
    links: Vec<Link<'d>>,
    tree: RTree<LinkEnd>,
    /// Ends nearer than this are one.
    reach: f64,
    /// Number of links that may still be examined, for all gaps together: a file that is no drawing of parts may have
    /// any number of both.
    left: usize,
}

/// Entities that lie in a gap.
pub(super) struct Bridge<'d> {
    /// End of the gap.
    pub(super) to: Point,
    entities: Vec<(&'d Origin, Option<LayerReason>)>,
}

impl<'d> Bridges<'d> {
    pub(super) fn of(drawing: &'d Drawing, loops: &[Chain<'_>], reach: f64) -> Self {
        /// The most links that are looked at.
        const MOST: usize = 1_000_000;
        let mut links: Vec<Link<'d>> = Vec::new();
        for other in &drawing.elsewhere {
            let path = &other.entity.path;
            let mut start = path.start;
            for piece in &path.pieces {
                links.push(Link {
                    ends: [start, piece.end()],
                    origin: &other.entity.origin,
                    reason: Some(other.reason),
                });
                start = piece.end();
            }
        }
        links.extend(loops.iter().flat_map(|l| &l.pieces).map(|p| Link {
            ends: [p.start, p.end],
            origin: origin_of(drawing, p.entity),
            reason: None,
        }));
        let ends = links.iter().enumerate().flat_map(|(i, link)| {
            let [a, b] = link.ends.map(|p| [p.x, p.y]);
            [LinkEnd::new(a, 2 * i), LinkEnd::new(b, 2 * i + 1)]
        });
        Self {
            tree: RTree::bulk_load(ends.collect()),
            links,
            reach,
            left: MOST,
        }
    }

    /// Shortest sequence of pieces from the end of a chain to another end. Closed outlines on the chain's own layer are
    /// not used, for they are complete.
    pub(super) fn from(
        &mut self,
        start: Point,
        layer: &str,
        is_end: impl Fn(Point) -> bool,
    ) -> Option<Bridge<'d>> {
        /// The most links that are looked at for a gap.
        const MOST: usize = 256;
        let mut is_seen: HashSet<usize> = HashSet::new();
        // Each link that is reached, with the one before.
        let mut steps: Vec<(usize, Option<usize>)> = Vec::new();
        let mut next: VecDeque<(Point, Option<usize>)> = VecDeque::from([(start, None)]);
        while let Some((at, before)) = next.pop_front() {
            let near = (self.tree).locate_within_distance([at.x, at.y], self.reach * self.reach);
            for end in near {
                let (number, side) = (end.data / 2, end.data % 2);
                let link = &self.links[number];
                let is_own = link.reason.is_none() && *link.origin.layer == *layer;
                if is_own || !is_seen.insert(number) {
                    continue;
                }
                if self.left == 0 || is_seen.len() > MOST {
                    return None;
                }
                self.left -= 1;
                let to = link.ends[1 - side];
                steps.push((number, before));
                if is_end(to) {
                    return Some(self.bridge(to, &steps));
                }
                next.push_back((to, Some(steps.len() - 1)));
            }
        }
        None
    }

    fn bridge(&self, to: Point, steps: &[(usize, Option<usize>)]) -> Bridge<'d> {
        let mut entities: Vec<(&'d Origin, Option<LayerReason>)> = Vec::new();
        let mut at = steps.len().checked_sub(1);
        while let Some(step) = at {
            let (number, before) = steps[step];
            let link = &self.links[number];
            if !entities.iter().any(|(o, _)| core::ptr::eq(*o, link.origin)) {
                entities.push((link.origin, link.reason));
            }
            at = before;
        }
        entities.reverse();
        Bridge { to, entities }
    }
}

impl Bridge<'_> {
    /// Description of the entities in the gap from a point.
    pub(super) fn told(&self, from: Point) -> String {
        /// Largest number of entities that are named.
        const MOST: usize = 4;
        let named = self.entities.iter().take(MOST).map(|(origin, reason)| {
            let why = reason.map_or("which belongs to another outline", LayerReason::of_which);
            format!("{origin}, {why}")
        });
        let more = match self.entities.len().saturating_sub(MOST) {
            0 => String::new(),
            n => format!(" and {n} more"),
        };
        format!(
            "the gap from {} to {} is closed by {}{more}",
            shown::point(from),
            shown::point(self.to),
            named.collect::<Vec<_>>().join("; ")
        )
    }

    /// Advice on how to close the gap, one sentence for each layer and reason.
    pub(super) fn ways(&self, own: &str) -> Vec<String> {
        let mut ways: Vec<String> = Vec::new();
        for (origin, reason) in &self.entities {
            let way = match reason {
                Some(reason) => reason.way(own, &origin.layer),
                None => format!("draw what is in the gap on layer {} too", shown::start(own)),
            };
            if !ways.contains(&way) {
                ways.push(way);
            }
        }
        ways
    }
}
