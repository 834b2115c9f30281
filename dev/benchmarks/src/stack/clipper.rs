//! Slices by Clipper2: Minkowski sums of all loops with all loops, and their union.

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use clipper2::{Clipper, FillRule, Path, Paths, PointInPolygonResult, PointScaler, minkowski_sum};
use cspace::{Configuration, Part, Point, Rotation};

use super::regions::Regions;
use super::{Found, Outcome, Stacker, slot};
use crate::polygons::{Ring, rings};

/// Clipper2 computes with integers: this many to a unit of length. The default, hundredths, would move corners by more than the chords
/// do.
#[derive(Debug, Default, Clone, Copy, PartialEq, Hash)]
struct Fine;

impl PointScaler for Fine {
    const MULTIPLIER: f64 = 1e7;
}

type Loops = Paths<Fine>;

/// A pair as Clipper2 has it.
pub(super) struct Clipped {
    fixed: Vec<Ring>,
    moving: Vec<Ring>,
    /// Faces of less area come from rounding.
    least_area: f64,
}

/// Slice: the blocked positions, and the bounded faces of free space, each a hole with the islands in it.
struct Layer {
    outer: Loops,
    faces: Vec<Loops>,
}

fn path(ring: &[Point]) -> Path<Fine> {
    let points: Vec<(f64, f64)> = ring.iter().map(|p| (p.x, p.y)).collect();
    points.into()
}

impl Clipped {
    pub(super) fn new(fixed: &Part, moving: &Part, chord: f64) -> Self {
        Self {
            fixed: rings(fixed, chord),
            moving: rings(moving, chord),
            least_area: chord * chord,
        }
    }

    /// The blocked positions at an orientation: the sum A ⊕ −R B.
    ///
    /// Clipper2 sums outlines, ∂A ⊕ −R ∂B. What lies within is added: A at a corner of each of B's loops, and −R B at a corner
    /// of each of A's.
    fn blocked(&self, theta: f64) -> Result<Loops, String> {
        let turn = Rotation::by(theta);
        let place = |r: &Ring| -> Ring {
            (r.iter())
                .map(|p| Point::ORIGIN + -(turn * p.to_vector()))
                .collect()
        };
        let moving: Vec<Ring> = self.moving.iter().map(place).collect();
        let at = |ring: &Ring, by: Point| -> Path<Fine> {
            let ring: Ring = ring.iter().map(|p| *p + by.to_vector()).collect();
            path(&ring)
        };
        let mut all = Vec::new();
        for a in &self.fixed {
            for b in &moving {
                let sum: Loops = minkowski_sum(path(b), Loops::new(vec![path(a)]), true);
                all.extend(sum.iter().cloned());
            }
        }
        for b in &moving {
            all.extend(self.fixed.iter().map(|a| at(a, b[0])));
        }
        for a in &self.fixed {
            all.extend(moving.iter().map(|b| at(b, a[0])));
        }
        let subject = Clipper::<_, Fine>::new().add_subject(Loops::new(all));
        let union = subject.add_clip(Loops::new(Vec::new()));
        union.union(FillRule::NonZero).map_err(|e| e.to_string())
    }

    fn layer(&self, theta: f64) -> Result<Layer, String> {
        let blocked = self.blocked(theta)?;
        let (mut solid, mut holes) = (Vec::new(), Vec::new());
        for l in blocked.iter() {
            if l.signed_area() > 0.0 {
                solid.push(l.clone());
            } else if l.signed_area() < -self.least_area {
                holes.push(l.clone());
            }
        }
        let mut faces: Vec<Vec<Path<Fine>>> = holes.iter().map(|h| vec![h.clone()]).collect();
        let mut outer = Vec::new();
        for s in solid {
            // The smallest hole around it.
            let around = (0..holes.len()).filter(|&i| holes[i].surrounds_path(&s));
            let area = |i: usize| holes[i].signed_area().abs();
            match around.min_by(|&i, &j| area(i).total_cmp(&area(j))) {
                Some(i) => faces[i].push(s),
                None => outer.push(s),
            }
        }
        Ok(Layer {
            outer: Loops::new(outer),
            faces: faces.into_iter().map(Loops::new).collect(),
        })
    }
}

/// Place of a position in a slice.
enum Place {
    Blocked,
    /// In the unbounded face.
    Open,
    Face(usize),
}

impl Layer {
    fn locate(&self, c: Configuration) -> Place {
        let within = |l: &Path<Fine>| {
            let place = l.is_point_inside(clipper2::Point::new(c.x, c.y));
            place == PointInPolygonResult::IsInside
        };
        for (i, face) in self.faces.iter().enumerate() {
            if face.iter().filter(|l| within(l)).count() % 2 == 1 {
                return Place::Face(i);
            }
        }
        if self.outer.iter().any(within) {
            Place::Blocked
        } else {
            Place::Open
        }
    }
}

/// Whether faces overlap, by the even-odd rule: a hole and its islands are faces in either direction.
fn overlap(a: &Loops, b: &Loops) -> Result<bool, String> {
    let (p, q) = (a.bounds(), b.bounds());
    let apart = p.max.x() < q.min.x()
        || q.max.x() < p.min.x()
        || p.max.y() < q.min.y()
        || q.max.y() < p.min.y();
    if apart {
        return Ok(false);
    }
    let both = Clipper::<_, Fine>::new().add_subject(a.clone());
    let common = both
        .add_clip(b.clone())
        .intersect(FillRule::EvenOdd)
        .map_err(|e| e.to_string())?;
    Ok(!common.is_empty())
}

/// Whether a face reaches beyond all blocked positions.
fn beyond(face: &Loops, outer: &Loops) -> Result<bool, String> {
    let rest = Clipper::<_, Fine>::new().add_subject(face.clone());
    let rest = rest
        .add_clip(outer.clone())
        .difference(FillRule::EvenOdd)
        .map_err(|e| e.to_string())?;
    Ok(!rest.is_empty())
}

impl Stacker for Clipped {
    fn name(&self) -> &'static str {
        "Clipper2"
    }

    fn run(
        &self,
        slices: usize,
        seconds: f64,
        working: Configuration,
    ) -> Result<Option<Outcome>, String> {
        let begin = Instant::now();
        let late = || begin.elapsed().as_secs_f64() > seconds;
        let mut regions = Regions::default();
        // The unbounded faces of all slices are one.
        let open = regions.add();
        let mut layers: Vec<(Layer, Vec<usize>)> = Vec::with_capacity(slices);
        for k in 0..slices {
            if late() {
                return Ok(None);
            }
            let layer = self.layer(-PI + (k as f64 + 0.5) * TAU / slices as f64)?;
            let names = layer.faces.iter().map(|_| regions.add()).collect();
            layers.push((layer, names));
        }
        let of_slices = begin.elapsed().as_secs_f64();
        for k in 0..slices {
            if late() {
                return Ok(None);
            }
            let (a, b) = (&layers[k], &layers[(k + 1) % slices]);
            for (f, &i) in a.0.faces.iter().zip(&a.1) {
                if beyond(f, &b.0.outer)? {
                    regions.join(open, i);
                }
                for (g, &j) in b.0.faces.iter().zip(&b.1) {
                    if overlap(f, g)? {
                        regions.join(i, j);
                    }
                }
            }
            for (g, &j) in b.0.faces.iter().zip(&b.1) {
                if beyond(g, &a.0.outer)? {
                    regions.join(open, j);
                }
            }
        }
        let (layer, names) = &layers[slot(working.theta, slices)];
        let place = match layer.locate(working) {
            Place::Blocked => Found::Blocked,
            Place::Open => Found::Open,
            Place::Face(i) if regions.are_joined(names[i], open) => Found::Open,
            Place::Face(_) => Found::Caged,
        };
        Ok(Some(Outcome {
            regions: regions.count(),
            working: place,
            seconds: begin.elapsed().as_secs_f64(),
            slice_seconds: of_slices / slices as f64,
        }))
    }
}
