//! Lines and arcs of one chain, taken over for its copies: drawings repeat symbols turned, shifted and in other sizes.

use std::collections::HashMap;

use cspace::{Point, Vector, Vertex};

use crate::fit::{Outline, Sided};
use crate::join::{Chain, ROUND, Shape};

/// Smallest ratio of a fit's tolerance, scaled to the copy, to the requested one with which the fit is used again; the
/// ratio may not exceed 1. Tolerances are shares of boxes, and the box of a turned copy has another diagonal.
const LEAST_TOLERANCE: f64 = 0.7;

/// The form of a chain: what no turn, shift or change of size alters, as bits, and the points that go along.
struct Form {
    numbers: Vec<u64>,
    points: Vec<Point>,
}

/// A chain that was fitted.
struct Model {
    points: Vec<Point>,
    entities: Vec<u32>,
    fit: f64,
    outline: Outline,
}

/// The chains that were fitted, by what their copies have in common.
#[derive(Default)]
pub(super) struct Copies(HashMap<(Vec<u64>, Sided), Vec<Model>>);

impl Copies {
    /// Fit of a chain that is a copy of a fitted one.
    pub(super) fn of(&self, chain: &Chain<'_>, fit: f64, sided: Sided) -> Option<Outline> {
        let form = form(chain);
        let models = self.0.get(&(form.numbers, sided))?;
        models
            .iter()
            .find_map(|m| m.copied(chain, &form.points, fit))
    }

    /// Keeps a fit for copies of the chain.
    pub(super) fn keep(&mut self, chain: &Chain<'_>, fit: f64, sided: Sided, outline: &Outline) {
        let form = form(chain);
        self.0
            .entry((form.numbers, sided))
            .or_default()
            .push(Model {
                points: form.points,
                entities: chain.pieces.iter().map(|p| p.entity).collect(),
                fit,
                outline: outline.clone(),
            });
    }
}

impl Model {
    /// The lines and arcs, if the points of the model are turned, shifted and scaled to these, to rounding.
    fn copied(&self, chain: &Chain<'_>, points: &[Point], fit: f64) -> Option<Outline> {
        let from = *self.points.first()?;
        let to = *points.first()?;
        let far = (self.points.iter().enumerate())
            .max_by(|a, b| a.1.distance(from).total_cmp(&b.1.distance(from)))
            .map(|(i, _)| i)?;
        let (p, q) = (self.points[far] - from, points[far] - to);
        // The factor q / p of complex numbers.
        let square = p.length_squared();
        let (re, im) = (p.dot(q) / square, p.cross(q) / square);
        let scale = re.hypot(im);
        if !(LEAST_TOLERANCE * fit..=fit * (1.0 + ROUND)).contains(&(self.fit * scale)) {
            return None;
        }
        let map = |at: Point| {
            let v = at - from;
            to + Vector::new(re * v.x - im * v.y, im * v.x + re * v.y)
        };
        let near = ROUND * q.length();
        let is_copy = (self.points.iter().zip(points)).all(|(&a, &b)| map(a).distance(b) <= near);
        if !is_copy {
            return None;
        }
        let entity: HashMap<u32, u32> = (self.entities.iter().zip(&chain.pieces))
            .map(|(&model, piece)| (model, piece.entity))
            .collect();
        let vertices = self.outline.vertices.iter().map(|v| {
            let at = map(v.point());
            // Ends stay as they are drawn.
            let drawn = chain
                .pieces
                .iter()
                .map(|p| p.start)
                .find(|p| p.distance(at) <= near);
            let at = drawn.unwrap_or(at);
            Vertex::new(at.x, at.y, v.bulge)
        });
        let entities = |of: &[u32]| -> Option<Vec<u32>> {
            of.iter().map(|e| entity.get(e).copied()).collect()
        };
        Some(Outline {
            vertices: vertices.collect(),
            entities: entities(&self.outline.entities)?,
            curves: entities(&self.outline.curves)?,
            deviation: self.outline.deviation * scale,
            ..self.outline
        })
    }
}

fn form(chain: &Chain<'_>) -> Form {
    let mut numbers = Vec::new();
    let mut points = Vec::new();
    for piece in &chain.pieces {
        points.extend([piece.start, piece.end]);
        numbers.push(u64::from(piece.is_backward));
        match piece.shape {
            Shape::Edge(bulge) => numbers.push(bulge.to_bits()),
            Shape::Curve(curve) => {
                let (of_curve, at) = curve.form();
                numbers.extend(of_curve.iter().map(|x| x.to_bits()));
                numbers.push(at.len() as u64);
                points.extend(at);
            }
        }
    }
    Form { numbers, points }
}
