//! The walls that a part is placed among, as one part: the outside of a container, and parts that are placed in it.
//!
//! Placed parts touch each other and the container, which loops of one outline may not. So those that touch are on different layers of the
//! one part, all at every height.

use cspace::part::polygon_loop;
use cspace::{Configuration, FeatureName, Part, Vertex};

use crate::legs::Scene;

use super::error::NestError;

/// Parts nearer than this share of their size are on different layers, and those that overlap by less touch: as much counts as fitting
/// for [`NoFit`](cspace::NoFit).
pub(super) const CLOSE: f64 = 1e-9;
/// The frame around the container is as wide as this many sizes of the part, which then is on one side of it.
const WIDTH: f64 = 2.0;

/// The owner of a feature of the walls.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// The container.
    Container,
    /// The placed part of this number, counted from 0.
    Placed(usize),
}

/// The walls as one part, and where its loops come from.
#[derive(Debug)]
pub(super) struct Walls {
    pub(super) part: Part,
    /// For every loop its owner, and its number there; of the frame around the container none.
    owners: Vec<Option<(Owner, u32)>>,
}

impl Walls {
    /// The walls of a container and of parts, placed in it by configurations.
    pub(super) fn new(
        container: &Part,
        placed: &[(&Part, Configuration)],
        moving: &Part,
    ) -> Result<Self, NestError> {
        let parts = [container, moving].into_iter();
        for part in parts.chain(placed.iter().map(|p| p.0)) {
            if !matches!(part.layers(), [layer] if layer.z().is_none()) {
                let part = part.name().to_owned();
                return Err(NestError::Layers { part });
            }
        }
        let mut all = vec![framed(container, WIDTH * moving.size())?];
        for (part, at) in placed {
            all.push(Part::new(part.name(), moved(part, *at))?);
        }
        let mut layers: Vec<Vec<usize>> = Vec::new();
        for i in 0..all.len() {
            let mut touched = Vec::new();
            for j in 0..i {
                if touch(&all[j], &all[i]).ok_or_else(|| NestError::overlap(j, i))? {
                    touched.push(j);
                }
            }
            let is_free = |layer: &&mut Vec<usize>| !layer.iter().any(|j| touched.contains(j));
            match layers.iter_mut().find(is_free) {
                Some(layer) => layer.push(i),
                None => layers.push(vec![i]),
            }
        }
        let (mut owners, mut stack) = (Vec::new(), Vec::new());
        for layer in layers {
            let mut loops = Vec::new();
            for i in layer {
                for (k, of) in (0..).zip(all[i].loops()) {
                    loops.push(of.vertices().to_vec());
                    owners.push(match (i, k) {
                        (0, 0) => None,
                        (0, _) => Some((Owner::Container, k - 1)),
                        _ => Some((Owner::Placed(i - 1), k)),
                    });
                }
            }
            stack.push((None, loops));
        }
        Ok(Self {
            part: Part::layered("walls", stack)?,
            owners,
        })
    }

    /// Whether a loop is of the container or a placed part.
    pub(super) fn has(&self, loop_index: usize) -> bool {
        self.owners.get(loop_index).is_some_and(Option::is_some)
    }

    /// The owner of a feature, and its name there; `None` of the frame around the container.
    pub(super) fn owner(&self, name: FeatureName) -> Option<(Owner, FeatureName)> {
        let &(owner, loop_index) = self.owners.get(name.loop_index as usize)?.as_ref()?;
        Some((owner, FeatureName { loop_index, ..name }))
    }
}

/// The loops of a part at a configuration.
fn moved(part: &Part, at: Configuration) -> Vec<Vec<Vertex>> {
    let vertex = |v: &Vertex| {
        let p = at.fixed_from_moving(v.point());
        Vertex::new(p.x, p.y, v.bulge)
    };
    let loops = part.loops().iter();
    loops
        .map(|l| l.vertices().iter().map(vertex).collect())
        .collect()
}

/// The outside of a container, up to a rectangle around it.
fn framed(container: &Part, width: f64) -> Result<Part, NestError> {
    let (lo, hi) = (container.bounds().min, container.bounds().max);
    let around = polygon_loop(&[
        (lo.x - width, lo.y - width),
        (hi.x + width, lo.y - width),
        (hi.x + width, hi.y + width),
        (lo.x - width, hi.y + width),
    ]);
    let loops = moved(container, Configuration::IDENTITY);
    let loops = [around].into_iter().chain(loops).collect();
    Ok(Part::new(container.name(), loops)?)
}

/// Whether two parts touch as they are drawn; `None` if they overlap.
fn touch(a: &Part, b: &Part) -> Option<bool> {
    const DRAWN: [f64; 3] = [0.0; 3];
    let close = CLOSE * a.size().max(b.size());
    if a.bounds().is_apart(b.bounds(), close) {
        return Some(false);
    }
    let scene = Scene::new(a, b, None);
    if scene.touches(DRAWN, close) {
        return Some(true);
    }
    (!scene.overlaps(DRAWN)).then_some(false)
}
