//! Parts whose contacts make a tree: which part hangs on which.

use std::collections::VecDeque;

use cspace::Axis;
use cspace::fixed_axes::SweptPlane;
use cspace::parallel;
use cspace_model::Mechanism;

use crate::modes::components::alone;
use crate::modes::error::ModesError;
use crate::modes::extent::Extent;
use crate::modes::plane::Plane;
use crate::modes::tree::turning::{MOST_TURNING, Turning};
use crate::modes::trio::{self, TrioPair, failed};

/// Some parts on axes, and the pairs of them that a model has.
#[derive(Debug)]
pub(crate) struct Parts {
    pub(crate) indices: Vec<usize>,
    pub(crate) names: Vec<String>,
    pub(crate) axes: Vec<Axis>,
    pub(crate) pairs: Vec<TrioPair>,
    pub(crate) turning: Turning,
}

/// A part with what hangs on it, each with the plane of both coordinates, swept along that of the part.
#[derive(Debug)]
pub(crate) struct Knot {
    pub(crate) coordinate: usize,
    pub(crate) x: Extent,
    pub(crate) below: Vec<(Plane, Knot)>,
}

impl Parts {
    pub(crate) fn of(mechanism: &Mechanism, indices: &[usize]) -> Result<Self, ModesError> {
        if indices.len() < 2 {
            return Err(ModesError::TooFew {
                parts: indices.len(),
            });
        }
        let axes: Vec<Axis> = (indices.iter())
            .map(|&part| trio::axis(mechanism, part))
            .collect::<Result<_, _>>()?;
        let names: Vec<String> = (indices.iter())
            .map(|&part| trio::name(mechanism, part))
            .collect();
        for (k, part) in indices.iter().enumerate() {
            if indices[..k].contains(part) {
                let part = names[k].clone();
                return Err(ModesError::Twice { part });
            }
        }
        trio::check_joints(mechanism, indices, &names)?;
        let n = indices.len();
        let two = (0..n).flat_map(|a| (a + 1..n).map(move |b| [a, b]));
        let mut listed = Vec::new();
        for pair in two {
            if let Some(entry) = trio::entry(mechanism, indices, pair) {
                trio::check_slides(entry.0.map(|k| (&names[k], &axes[k])))?;
                listed.push((pair, entry));
            }
        }
        let pairs = parallel::map(&listed, 1, |&(pair, entry)| {
            TrioPair::of(mechanism, pair, Some(entry))
        });
        Ok(Self {
            turning: Turning::of(&axes)?,
            indices: indices.to_vec(),
            names,
            axes,
            pairs: pairs.into_iter().collect::<Result<_, _>>()?,
        })
    }

    /// The axes with limits for slides that have none.
    fn limited_axes(&self) -> Vec<Axis> {
        let limited = |k: usize| trio::limited(k, &self.axes, &self.pairs);
        (0..self.axes.len()).map(limited).collect()
    }

    /// The parts that may touch a part.
    fn beside(&self, part: usize) -> impl Iterator<Item = usize> + '_ {
        let bound = self.pairs.iter().filter(|p| p.is_bound());
        bound.filter_map(move |pair| match pair.coordinates {
            [a, b] if a == part => Some(b),
            [a, b] if b == part => Some(a),
            _ => None,
        })
    }

    /// For each part on which it hangs. Of parts that touch each other that with the most others has the rest hanging on it;
    /// parts that touch none of these hang on the first one.
    fn hung(&self) -> Result<Vec<Option<usize>>, ModesError> {
        let n = self.axes.len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|&k| (core::cmp::Reverse(self.beside(k).count()), k));
        let mut on: Vec<Option<usize>> = vec![None; n];
        let mut known = vec![false; n];
        let first = order[0];
        for root in order {
            if known[root] {
                continue;
            }
            known[root] = true;
            on[root] = (root != first).then_some(first);
            let mut next = VecDeque::from([root]);
            while let Some(part) = next.pop_front() {
                // A part that touches no other hangs on one that it does not touch.
                let above = on[part].filter(|_| part != root);
                for other in self.beside(part) {
                    if Some(other) == above {
                        continue;
                    }
                    if known[other] {
                        return Err(self.cycle(&on, root, part, other));
                    }
                    known[other] = true;
                    on[other] = Some(part);
                    next.push_back(other);
                }
            }
        }
        Ok(on)
    }

    /// The cycle that two parts close which both hang on a root.
    fn cycle(&self, on: &[Option<usize>], root: usize, a: usize, b: usize) -> ModesError {
        let up = |mut part: usize| {
            let mut way = vec![part];
            while let (true, Some(above)) = (part != root, on[part]) {
                part = above;
                way.push(part);
            }
            way
        };
        let (a, b) = (up(a), up(b));
        let meet = a.iter().position(|p| b.contains(p)).unwrap_or(0);
        let from_b = b.iter().take_while(|p| **p != a[meet]);
        let around = a[..=meet].iter().rev().chain(from_b.collect::<Vec<_>>());
        ModesError::Cycle {
            parts: around.map(|&k| self.names[k].clone()).collect(),
        }
    }

    /// The tree of all parts.
    pub(crate) fn tree(&self, mechanism: &Mechanism) -> Result<Knot, ModesError> {
        let on = self.hung()?;
        let axes = self.limited_axes();
        let edges: Vec<(usize, usize)> = (on.iter().enumerate())
            .filter_map(|(part, on)| Some(((*on)?, part)))
            .collect();
        let planes = parallel::map(&edges, 1, |&(x, y)| self.plane(mechanism, &axes, x, y));
        let planes: Vec<Option<Plane>> = planes.into_iter().collect::<Result<_, _>>()?;
        let extents: Vec<Extent> = (0..axes.len())
            .map(|k| {
                let known = edges.iter().zip(&planes).filter_map(|(&(x, y), plane)| {
                    let plane = plane.as_ref()?;
                    match k {
                        k if k == x => Some(plane.x),
                        k if k == y => Some(plane.y),
                        _ => None,
                    }
                });
                known.reduce(|a, b| a.coarser(&b)).unwrap_or_else(|| {
                    let part = &mechanism.parts[self.indices[k]].part;
                    alone(&axes[k], trio::is_circle(&axes[k]), part.size())
                })
            })
            .collect();
        let mut planes: Vec<(usize, usize, Plane)> = (edges.iter().zip(planes))
            .map(|(&(x, y), plane)| {
                let plane = match plane {
                    Some(plane) => plane.with(extents[x], extents[y]),
                    None => Plane::free(extents[x], extents[y]),
                };
                (x, y, plane)
            })
            .collect();
        let root = on.iter().position(Option::is_none).unwrap_or(0);
        Ok(knot(root, &extents, &mut planes))
    }

    /// The plane of two coordinates, swept along x; `None` if nothing constrains it.
    fn plane(
        &self,
        mechanism: &Mechanism,
        axes: &[Axis],
        x: usize,
        y: usize,
    ) -> Result<Option<Plane>, ModesError> {
        let of = |pair: &&TrioPair| pair.role(x).is_some() && pair.role(y).is_some();
        let pair = self.pairs.iter().find(of).filter(|p| p.is_bound());
        let Some((pair, along)) = pair.and_then(|p| Some((p, p.role(x)?))) else {
            return Ok(None);
        };
        let [fixed, moving] = pair.coordinates;
        let part = |k: usize| (&mechanism.parts[self.indices[k]].part, axes[k]);
        let names = [fixed, moving].map(|k| self.names[k].as_str());
        SweptPlane::compute(part(fixed), part(moving), along)
            .map(|swept| Some(Plane::of(swept)))
            .map_err(|error| failed(names, error))
    }
}

fn knot(part: usize, extents: &[Extent], planes: &mut Vec<(usize, usize, Plane)>) -> Knot {
    let (own, others): (Vec<_>, Vec<_>) = planes.drain(..).partition(|(x, _, _)| *x == part);
    *planes = others;
    Knot {
        coordinate: part,
        x: extents[part],
        below: (own.into_iter())
            .map(|(_, y, plane)| (plane, knot(y, extents, planes)))
            .collect(),
    }
}

impl Turning {
    fn of(axes: &[Axis]) -> Result<Self, ModesError> {
        let turning: Vec<usize> = (0..axes.len())
            .filter(|&k| trio::is_circle(&axes[k]))
            .collect();
        if turning.len() > MOST_TURNING {
            return Err(ModesError::TooManyTurns {
                turning: turning.len(),
                limit: MOST_TURNING,
            });
        }
        Ok(Self(turning))
    }
}
