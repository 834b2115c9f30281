//! Clashes: which parts of an assembly overlap, touch, or come near each other, as they are drawn and over a motion.
//!
//! Boxes first: parts whose boxes are farther apart than is asked for are not looked at. Of the others the distance of the boundaries
//! is found by branch and bound ([`legs`](crate::legs)), and of those that overlap or touch the *depth*: the length of the shortest
//! translation of the second part, at the orientation that it has, after which the two do not overlap. It is read off the slice of
//! the pair at that orientation, so no contact space is computed.
//!
//! ```
//! use cspace::Part;
//! use cspace_model::{Mechanism, PartEntry};
//! use cspace_plan::clash::{Assembly, Question, State};
//! let mut mechanism = Mechanism::new("three discs");
//! for (name, x) in [("a", 0.0), ("b", 1.5), ("c", 4.0)] {
//!     mechanism.parts.push(PartEntry::planar(Part::circle(name, [x, 0.0], 1.0)?));
//! }
//! let found = Assembly::new(&mechanism).drawn(&Question::default());
//! let told: Vec<_> = found.pairs.iter().map(|p| (p.parts, p.state)).collect();
//! assert_eq!(told, [([0, 1], State::Overlap), ([1, 2], State::Clear), ([0, 2], State::Clear)]);
//! assert!((found.pairs[0].depth.ok_or("no depth")? - 0.5).abs() < 1e-9);
//! assert!((found.pairs[1].gap.ok_or("no gap")? - 0.5).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod along;
mod answer;
mod broad;
mod course;
mod depth;
mod pair;

use cspace::Configuration;
use cspace::part::Bounds;
use cspace_model::Mechanism;

use crate::legs::{Body, Coords};
pub use answer::{Clash, Clashes, Question, Sample, State};
pub(crate) use broad::{Boxed, near};
pub use course::{Course, Leg, Passage};
pub(crate) use depth::depth;
use pair::Pair;

/// Parts nearer than this share of the larger one's size touch, and so do parts that overlap by less: a little more than
/// contacts are known to, 7·10⁻¹² of the size.
pub(crate) const TOUCHING: f64 = 1e-11;

/// The parts of a mechanism, prepared for questions.
#[derive(Debug)]
pub struct Assembly<'a> {
    bodies: Vec<Body<'a>>,
    joined: Vec<[usize; 2]>,
}

impl<'a> Assembly<'a> {
    /// Prepares the parts of a mechanism.
    pub fn new(mechanism: &'a Mechanism) -> Self {
        Self {
            bodies: mechanism.parts.iter().map(Body::new).collect(),
            joined: (mechanism.joints.iter())
                .map(|j| [j.parts.0.min(j.parts.1), j.parts.0.max(j.parts.1)])
                .collect(),
        }
    }

    /// Clashes of the parts as they are drawn, at zero motion.
    pub fn drawn(&self, question: &Question) -> Clashes {
        self.drawn_but(question, |_| false)
    }

    /// As [`drawn`](Self::drawn), without the pairs that are passed over, which are not counted either; they are given by the numbers of their
    /// parts.
    pub fn drawn_but(
        &self,
        question: &Question,
        is_passed_over: impl Fn([usize; 2]) -> bool,
    ) -> Clashes {
        let boxes = self.bodies.iter().map(|b| b.part().bounds()).collect();
        self.all(question, boxes, is_passed_over, |pair| {
            drawn(pair, [[0.0; 3]; 2], question.within)
        })
    }

    /// Two parts at motions on their axes; none if they are clear of each other by as much as is asked for.
    pub fn on_axes(&self, parts: [usize; 2], at: [f64; 2], question: &Question) -> Option<Clash> {
        let at = at.map(|t| [t, 0.0, 0.0]);
        drawn(&self.pair(parts, question.touch), at, question.within)
    }

    /// Where a part is at coordinates of a passage.
    pub fn configuration(&self, part: usize, at: Coords) -> Configuration {
        self.bodies[part].configuration(at)
    }

    /// Two parts over a motion that is known at every time; none if they are clear of each other by as much as is asked for all along. The
    /// smallest gap is bounded, not sampled, and right to 10⁻¹² of the parts' size, or to what is told as the least.
    ///
    /// Parts that touch at the start are looked at for overlap at the course's own times alone.
    pub fn over(
        &self,
        parts: [usize; 2],
        course: &mut dyn Course,
        question: &Question,
    ) -> Option<Passage> {
        course::passage(&self.pair(parts, question.touch), course, question.within)
    }

    /// Clashes of the parts over a motion that is given by samples in order of time: between two of them every
    /// coordinate changes at a constant rate.
    ///
    /// The gap is the minimum over all of the motion, samples and intervals between them, right to a millionth. Overlap and its depth are
    /// those at samples; boundaries that meet between two samples, at which the parts are apart, are reported.
    ///
    /// Parts beyond the coordinates that a sample has are where they are drawn.
    pub fn along(&self, samples: &[Sample], question: &Question) -> Clashes {
        let at = |s: &Sample, i: usize| s.parts.get(i).copied().unwrap_or_default();
        let boxes = (self.bodies.iter().enumerate())
            .map(|(i, body)| {
                (samples.iter())
                    .map(|s| body.around(at(s, i)))
                    .reduce(Bounds::union)
                    .unwrap_or_else(|| body.part().bounds())
            })
            .collect();
        self.all(
            question,
            boxes,
            |_| false,
            |pair| {
                let way = samples
                    .iter()
                    .map(|s| (s.time, pair.parts.map(|i| at(s, i))));
                along::along(pair, way, question.within)
            },
        )
    }

    /// Parts that a joint connects, which are apart as drawn, and come to overlap over a motion as in [`along`](Self::along): where they first
    /// touch. Motions do not test them for contact.
    pub fn joined_that_meet(&self, samples: &[Sample]) -> Vec<Clash> {
        let mut joined = self.joined.clone();
        joined.sort_unstable();
        joined.dedup();
        let at = |s: &Sample, i: usize| s.parts.get(i).copied().unwrap_or_default();
        (joined.into_iter())
            .filter_map(|parts| {
                let pair = self.pair(parts, None);
                let is_apart = pair.there([[0.0; 3]; 2], pair.touch).is_none();
                let way = samples.iter().map(|s| (s.time, parts.map(|i| at(s, i))));
                is_apart.then(|| along::first(&pair, way)).flatten()
            })
            .collect()
    }

    fn pair(&self, parts: [usize; 2], touch: Option<f64>) -> Pair<'_> {
        let bodies = parts.map(|i| &self.bodies[i]);
        let size = bodies[0].size().max(bodies[1].size());
        Pair {
            parts,
            bodies,
            touch: touch.unwrap_or(TOUCHING * size),
        }
    }

    /// Looks at every pair that is asked about and whose boxes are near.
    fn all(
        &self,
        question: &Question,
        boxes: Vec<Bounds>,
        is_passed_over: impl Fn([usize; 2]) -> bool,
        look: impl Fn(&Pair<'_>) -> Option<Clash>,
    ) -> Clashes {
        let n = self.bodies.len();
        let (mut asked, count) = match question.pair {
            Some(one) => (vec![one], usize::from(!is_passed_over(one))),
            None => {
                let boxed = Boxed::new(boxes);
                let all = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
                (
                    near(&boxed, question.within),
                    all.filter(|&pair| !is_passed_over(pair)).count(),
                )
            }
        };
        asked.retain(|&pair| !is_passed_over(pair));
        let mut joined = Vec::new();
        let mut pairs = Vec::new();
        for parts in asked {
            let [a, b] = parts;
            if self.joined.contains(&[a.min(b), a.max(b)]) {
                joined.push(parts);
                continue;
            }
            pairs.extend(look(&self.pair(parts, question.touch)));
        }
        // Those that are joined are listed wherever they are.
        if question.pair.is_none() {
            joined = self.joined.clone();
            joined.sort_unstable();
            joined.dedup();
        }
        pairs.extend(joined.into_iter().map(|parts| Clash {
            parts,
            state: State::Joined,
            gap: None,
            depth: None,
            offset: None,
            points: None,
            features: None,
            time: None,
        }));
        pairs.sort_by(|a, b| {
            let deeper = |c: &Clash| c.depth.map_or(f64::INFINITY, |d| d);
            let gap = |c: &Clash| c.gap.unwrap_or(0.0);
            (a.state.cmp(&b.state))
                .then(deeper(b).total_cmp(&deeper(a)))
                .then(gap(a).total_cmp(&gap(b)))
                .then(a.parts.cmp(&b.parts))
        });
        Clashes {
            beyond: count - pairs.len(),
            pairs,
        }
    }
}

/// Two parts at a place, with all that is told of those that overlap; none if they are clear by `within` or more.
fn drawn(pair: &Pair<'_>, at: [[f64; 3]; 2], within: f64) -> Option<Clash> {
    let mut found = pair.there(at, within)?;
    // Parts that have too many edges for the depth have too many for the offset.
    if found.depth.is_some() {
        found.offset = pair.offset(at);
    }
    Some(found)
}
