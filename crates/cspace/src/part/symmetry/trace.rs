//! Loops in the form used for symmetry, and the rotations that map them to each other.

use core::f64::consts::TAU;

use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Edge, Loop, Part};

use super::mapping::{Corresponding, LoopImage, SYMMETRIC};

/// A loop, about the part's centre, in order of travel.
#[derive(Debug, Clone)]
pub(super) enum Ring {
    /// One whole circle, however it was drawn: traversed counter-clockwise if the radius is positive.
    Circle { center: Vector, radius: f64 },
    /// Vertices, each with the bulge of the edge that starts there.
    Path(Vec<(Vector, f64)>),
}

/// All loops of a part about its centre.
#[derive(Debug)]
pub(super) struct Trace {
    pub(super) rings: Vec<Ring>,
    center: Point,
    /// Distance below which places are one, in the part's unit.
    pub(super) tolerance: f64,
    round: bool,
    /// The layer of each ring: a rotation leaves heights as they are.
    layers: Vec<usize>,
    /// Vertices of the paths, by their first coordinate: loop and place in it.
    by_x: Vec<(f64, u32, u32)>,
}

impl Trace {
    pub(super) fn new(part: &Part, by: Corresponding) -> Self {
        let tolerance = SYMMETRIC * part.size();
        let mid = part.bounds().center();
        let rings: Vec<Ring> = part
            .loops()
            .iter()
            .map(|l| {
                match by {
                    Corresponding::Outlines => circle(l, mid, tolerance),
                    Corresponding::Vertices => None,
                }
                .unwrap_or_else(|| path(l, mid))
            })
            .collect();
        // The images of one vertex under all rotations have the centre as their mean, and so have those of a circle.
        let (mut sum, mut count) = (Vector::ZERO, 0_usize);
        for ring in &rings {
            match ring {
                Ring::Circle { center, .. } => {
                    sum = sum + *center;
                    count += 1;
                }
                Ring::Path(vertices) => {
                    sum = vertices.iter().fold(sum, |s, v| s + v.0);
                    count += vertices.len();
                }
            }
        }
        let offset = sum * (1.0 / count.max(1) as f64);
        let center = mid + offset;
        let concentric = |r: &Ring| matches!(r, Ring::Circle { center, .. } if (*center - offset).length() <= tolerance);
        let round = rings.iter().all(concentric);
        let mut rings = rings;
        for (ring, l) in rings.iter_mut().zip(part.loops()) {
            match ring {
                // If there are only circles about the centre, only the arcs as drawn distinguish rotations.
                Ring::Circle { .. } if round => *ring = path(l, center),
                Ring::Circle { center, .. } => *center = *center - offset,
                Ring::Path(vertices) => vertices.iter_mut().for_each(|v| v.0 = v.0 - offset),
            }
        }
        let mut by_x: Vec<(f64, u32, u32)> = Vec::new();
        for (i, ring) in (0u32..).zip(&rings) {
            if let Ring::Path(vertices) = ring {
                by_x.extend((0u32..).zip(vertices).map(|(t, v)| (v.0.x, i, t)));
            }
        }
        by_x.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        Self {
            rings,
            center,
            tolerance,
            round,
            layers: (part.layers().iter().enumerate())
                .flat_map(|(i, layer)| layer.loops().map(move |_| i))
                .collect(),
            by_x,
        }
    }

    pub(super) fn center(&self) -> Point {
        self.center
    }

    pub(super) fn is_round(&self) -> bool {
        self.round
    }

    /// Whether a vector is the centre.
    pub(super) fn is_center(&self, v: Vector) -> bool {
        v.length() <= self.tolerance
    }

    /// The largest number of equal rotations that make a turn and map the loops to each other.
    ///
    /// The rotations that do so are the multiples of the smallest. So this number is the product of the largest powers
    /// of primes for which there is one.
    pub(super) fn fold(&self) -> u32 {
        let circles = self
            .rings
            .iter()
            .filter(|r| matches!(r, Ring::Circle { center, .. } if !self.is_center(*center)));
        // A rotation leaves only the centre where it is.
        let mut left = gcd(self.by_x.len() as u32, circles.count() as u32);
        let mut fold = 1;
        let mut prime = 2;
        while left > 1 {
            if u64::from(prime) * u64::from(prime) > u64::from(left) {
                prime = left;
            }
            let mut power = 1;
            while left.is_multiple_of(prime) {
                left /= prime;
                power *= prime;
                if self.images(power).is_none() {
                    power /= prime;
                    while left.is_multiple_of(prime) {
                        left /= prime;
                    }
                }
            }
            fold *= power;
            prime += 1;
        }
        fold
    }

    /// The images of all loops under a turn by 2π/`fold`, if it maps the loops to each other.
    pub(super) fn images(&self, fold: u32) -> Option<Vec<LoopImage>> {
        let turn = Rotation::by(TAU / f64::from(fold));
        let images: Vec<LoopImage> = (self.rings.iter().zip(&self.layers))
            .map(|(ring, layer)| self.image(ring, *layer, turn))
            .collect::<Option<_>>()?;
        let mut reached = vec![false; images.len()];
        for i in &images {
            reached[i.target as usize] = true;
        }
        reached.iter().all(|&r| r).then_some(images)
    }

    /// The image of a ring of a layer among the rings of that layer.
    fn image(&self, ring: &Ring, layer: usize, turn: Rotation) -> Option<LoopImage> {
        match ring {
            Ring::Circle { center, radius } => {
                let to = turn * *center;
                let same = |(r, l): (&Ring, &usize)| {
                    *l == layer
                        && matches!(r, Ring::Circle { center: c, radius: s }
                        if (*c - to).length() <= self.tolerance && (radius - s).abs() <= self.tolerance)
                };
                let target = self.rings.iter().zip(&self.layers).position(same)? as u32;
                // It has no vertices until it is redrawn.
                Some(LoopImage::new(target, 0, 0))
            }
            Ring::Path(vertices) => {
                let to = turn * vertices.first()?.0;
                let from = self.by_x.partition_point(|v| v.0 < to.x - self.tolerance);
                self.by_x[from..]
                    .iter()
                    .take_while(|v| v.0 <= to.x + self.tolerance)
                    .map(|&(_, target, shift)| LoopImage::new(target, shift, vertices.len() as u32))
                    .filter(|image| self.layers[image.target as usize] == layer)
                    .find(|&image| self.maps(vertices, turn, image))
            }
        }
    }

    /// Whether a rotation maps a path to another, vertex by vertex.
    fn maps(&self, vertices: &[(Vector, f64)], turn: Rotation, image: LoopImage) -> bool {
        let Ring::Path(to) = &self.rings[image.target as usize] else {
            return false;
        };
        let n = vertices.len();
        n == to.len()
            && (0..n).all(|t| {
                let (here, bulge) = vertices[t];
                let (there, other) = to[image.of(t).1];
                let chord = (vertices[(t + 1) % n].0 - here).length();
                // An arc leaves its chord by bulge · chord / 2.
                (turn * here - there).length() <= self.tolerance
                    && 0.5 * chord * (bulge - other).abs() <= self.tolerance
            })
    }
}

fn path(l: &Loop, center: Point) -> Ring {
    Ring::Path(l.edges().map(|e| (e.start - center, e.bulge)).collect())
}

/// The loop as one whole circle, if it is one.
fn circle(l: &Loop, mid: Point, tolerance: f64) -> Option<Ring> {
    if l.edges().any(|e| e.is_line()) {
        return None;
    }
    // The longest arc determines the circle best.
    let longest = l
        .edges()
        .max_by(|a, b| a.sweep().abs().total_cmp(&b.sweep().abs()))?;
    let (center, radius) = (longest.center(), longest.radius());
    let on_it = |e: Edge| {
        let off = |p: Point| (p.distance(center) - radius).abs();
        e.center().distance(center) <= tolerance
            && (e.radius() - radius).abs() <= tolerance
            && off(e.start).max(off(e.end)) <= tolerance
            && e.bulge.signum() == longest.bulge.signum()
    };
    let turned: f64 = l.edges().map(|e| e.sweep()).sum();
    (l.edges().all(on_it) && (turned.abs() - TAU).abs() < 1.0).then(|| Ring::Circle {
        center: center - mid,
        radius: radius * turned.signum(),
    })
}

pub(super) fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}
