//! Redraws a part that is symmetric up to rounding as the nearest exactly symmetric part.

use core::f64::consts::TAU;

use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Loop, Part, Vertex};

use super::mapping::LoopImage;
use super::trace::{Ring, Trace};

/// Edge and vertex, as drawn, from which an edge of the symmetric part comes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Drawn {
    pub(crate) edge: u32,
    pub(crate) vertex: u32,
}

/// A part redrawn about the origin, so that turning by 2π/fold maps it to itself up to rounding.
///
/// Every vertex and bulge is the mean of its images under the rotation and all its powers. Whole circles are divided
/// where any of their images was; all other loops keep their vertices. Loops are in the given order, and each is in order
/// of travel.
#[derive(Debug, Clone)]
pub(crate) struct Symmetrized {
    pub(crate) part: Part,
    pub(crate) fold: u32,
    /// The centre of symmetry in the frame of the part as drawn.
    pub(crate) center: Point,
    /// Image of each loop under a turn by 2π/fold.
    pub(crate) images: Vec<LoopImage>,
    /// For each loop, for each edge in order of travel, its origin in the drawing.
    pub(crate) drawn: Vec<Vec<Drawn>>,
    /// For each loop, whether it is a circle that has more arcs than were drawn.
    pub(crate) divided: Vec<bool>,
    /// Number of additional arcs.
    pub(crate) added: usize,
    /// Largest displacement, in the part's unit of length.
    pub(crate) deviation: f64,
}

/// Data for redrawing a part by a fold.
struct Redraw<'a> {
    trace: &'a Trace,
    fold: u32,
    images: Vec<LoopImage>,
    loops: Vec<Vec<Vertex>>,
    drawn: Vec<Vec<Drawn>>,
    deviation: f64,
}

impl Symmetrized {
    /// Redraws the part; `None` if the result is not a part, which only details near the resolution can bring about.
    pub(super) fn new(part: &Part, trace: &Trace, fold: u32) -> Option<Self> {
        let images = trace.images(fold)?;
        let loops = part.loops();
        let mut redraw = Redraw {
            trace,
            fold,
            images,
            loops: vec![Vec::new(); loops.len()],
            drawn: vec![Vec::new(); loops.len()],
            deviation: 0.0,
        };
        redraw.paths();
        redraw.circles(loops, trace.center());
        for ((l, ring), drawn) in loops.iter().zip(&trace.rings).zip(&mut redraw.drawn) {
            if matches!(ring, Ring::Path(_)) {
                *drawn = l.edges().map(|e| drawn_as(l, e.index)).collect();
            }
        }
        let Redraw {
            images,
            loops: vertices,
            drawn,
            deviation,
            ..
        } = redraw;
        let more = |(v, l): (&Vec<Vertex>, &Loop)| v.len().checked_sub(l.vertices().len());
        let more: Vec<usize> = vertices
            .iter()
            .zip(loops)
            .map(more)
            .collect::<Option<_>>()?;
        let redrawn = part.redrawn(vertices).ok()?;
        // Drawn in order of travel, no loop is traversed backwards.
        let sound =
            redrawn.loops().iter().all(|l| !l.is_reversed()) && deviation <= 2.0 * trace.tolerance;
        sound.then(|| Self {
            part: redrawn,
            fold,
            center: trace.center(),
            images,
            drawn,
            divided: more.iter().map(|&m| m > 0).collect(),
            added: more.iter().sum(),
            deviation,
        })
    }
}

fn drawn_as(l: &Loop, index: usize) -> Drawn {
    Drawn {
        edge: index as u32,
        vertex: l.start_of(index) as u32,
    }
}

impl Redraw<'_> {
    /// The rotation by some steps.
    fn turn(&self, steps: u32) -> Rotation {
        Rotation::by(TAU * f64::from(steps % self.fold) / f64::from(self.fold))
    }

    fn paths(&mut self) {
        let trace = self.trace;
        let mut done: Vec<Vec<bool>> = Vec::with_capacity(trace.rings.len());
        for (ring, to) in trace.rings.iter().zip(&mut self.loops) {
            let n = match ring {
                Ring::Path(vertices) => vertices.len(),
                Ring::Circle { .. } => 0,
            };
            *to = vec![Vertex::default(); n];
            done.push(vec![false; n]);
        }
        for (first, ring) in trace.rings.iter().enumerate() {
            let Ring::Path(vertices) = ring else { continue };
            for start in 0..vertices.len() {
                if done[first][start] {
                    continue;
                }
                let orbit = self.orbit(first, start);
                let at = |(l, t): (usize, usize)| match &trace.rings[l] {
                    Ring::Path(v) => (v[t].0, v[t].1, v[(t + 1) % v.len()].0),
                    Ring::Circle { .. } => (Vector::ZERO, 0.0, Vector::ZERO),
                };
                let share = 1.0 / f64::from(self.fold);
                let (mut mean, mut bulge) = (Vector::ZERO, 0.0);
                for (&place, steps) in orbit.iter().zip(0u32..) {
                    let (v, b, _) = at(place);
                    mean = mean + self.turn(steps).inverse() * v * share;
                    bulge += b * share;
                }
                for (&place, steps) in orbit.iter().zip(0u32..) {
                    let v = self.turn(steps) * mean;
                    let (was, b, next) = at(place);
                    let sagitta = 0.5 * (next - was).length() * (b - bulge).abs();
                    self.deviation = self.deviation.max((was - v).length()).max(sagitta);
                    self.loops[place.0][place.1] = Vertex::new(v.x, v.y, bulge);
                    done[place.0][place.1] = true;
                }
            }
        }
    }

    /// The images of a vertex under the rotation and its powers.
    fn orbit(&self, first: usize, start: usize) -> Vec<(usize, usize)> {
        let image = |&(l, t): &(usize, usize)| Some(self.images[l].of(t));
        core::iter::successors(Some((first, start)), image)
            .take(self.fold as usize)
            .collect()
    }

    fn circles(&mut self, loops: &[Loop], center: Point) {
        let trace = self.trace;
        for (first, ring) in trace.rings.iter().enumerate() {
            let Ring::Circle { center: c, .. } = ring else {
                continue;
            };
            if !self.loops[first].is_empty() {
                continue;
            }
            // The loops that are images of this one; for a circle about the centre, itself every time.
            let own = trace.is_center(*c);
            let next = |l: usize| self.images[l].target as usize;
            let others = core::iter::successors(Some(next(first)), |&l| Some(next(l)));
            let mut orbit = vec![first];
            if !own {
                orbit.extend(others.take_while(|&l| l != first));
            }
            self.circle_orbit(loops, center, &orbit, own);
        }
    }

    fn circle_orbit(&mut self, loops: &[Loop], center: Point, orbit: &[usize], own: bool) {
        let trace = self.trace;
        let share = 1.0 / orbit.len() as f64;
        let step = TAU / f64::from(self.fold);
        let (mut mean, mut radius) = (Vector::ZERO, 0.0);
        for (&l, steps) in orbit.iter().zip(0u32..) {
            if let Ring::Circle {
                center: c,
                radius: r,
            } = &trace.rings[l]
            {
                mean = mean + self.turn(steps).inverse() * *c * share;
                radius += r * share;
            }
        }
        if own {
            mean = Vector::ZERO;
        }
        // Angles at which any of them is divided, relative to the first; about the centre, modulo the rotation.
        let period = if own { step } else { TAU };
        let mut angles: Vec<f64> = Vec::new();
        for (&l, steps) in orbit.iter().zip(0u32..) {
            if let Ring::Circle {
                center: c,
                radius: r,
            } = &trace.rings[l]
            {
                let moved = (self.turn(steps) * mean - *c).length() + (radius - r).abs();
                self.deviation = self.deviation.max(moved);
                angles.extend(loops[l].edges().map(|e| {
                    let a = (e.start - center - *c).angle() - step * f64::from(steps);
                    a - period * (a / period).floor()
                }));
            }
        }
        angles.sort_by(f64::total_cmp);
        let same = trace.tolerance / radius.abs();
        angles.dedup_by(|b, a| *b - *a <= same);
        if angles.len() > 1 && angles[0] + period - angles[angles.len() - 1] <= same {
            angles.pop();
        }
        let joints: Vec<f64> = if own {
            (0..self.fold)
                .flat_map(|j| angles.iter().map(move |a| a + step * f64::from(j)))
                .collect()
        } else {
            angles.clone()
        };
        let ccw = radius > 0.0;
        let n = joints.len();
        for (&l, steps) in orbit.iter().zip(0u32..) {
            self.images[l].count = n as u32;
            let at = self.turn(steps) * mean;
            let drawn: Vec<_> = loops[l].edges().collect();
            let Ring::Circle { center: c, .. } = &trace.rings[l] else {
                continue;
            };
            for t in 0..n {
                let i = if ccw { t } else { n - 1 - t };
                let from = joints[i] + step * f64::from(steps);
                let sweep = if ccw {
                    joints[(i + 1) % n] - joints[i] + if i + 1 == n { TAU } else { 0.0 }
                } else {
                    joints[(i + n - 1) % n] - joints[i] - if i == 0 { TAU } else { 0.0 }
                };
                let v = at + Vector::from_angle(from) * radius.abs();
                self.loops[l].push(Vertex::new(v.x, v.y, (0.25 * sweep).tan()));
                // The arc as drawn that contains its middle.
                let middle = from + 0.5 * sweep;
                let holds = |e: &&crate::part::Edge| {
                    let start = (e.start - center - *c).angle();
                    let along = (middle - start) * e.sweep().signum();
                    along - TAU * (along / TAU).floor() <= e.sweep().abs()
                };
                let edge = drawn.iter().find(holds).or(drawn.first());
                self.drawn[l].push(edge.map_or(Drawn { edge: 0, vertex: 0 }, |e| {
                    drawn_as(&loops[l], e.index)
                }));
            }
        }
        if own {
            // In order of travel: forwards or backwards by the joints of one step.
            let by = angles.len();
            self.images[orbit[0]].shift = if ccw { by } else { n - by } as u32;
        }
    }
}
