//! Parts of the faces into which all that is drawn divides the plane, for drawings whose curves cross, meet in threes or end freely.

use std::collections::HashSet;

use cspace::part::Bounds;
use cspace::{Edge, Part, PartError, Point, Vertex};

use super::making::{Making, OriginKey, checked, key};
use super::names::names;
use super::refusal::no_part;
use super::result::Outlines;
use crate::arrange::{self, around, boundary, split};
use crate::drawing::{Ignored, Problem, edge};
use crate::error::DrawingError;
use crate::fit::{Outline, Sided};
use crate::join::{Chain, ChainPiece, Shape};
use crate::nest::Ring;
use crate::shown;

/// Faces that are listed, at most: the largest.
const MOST_LISTED: usize = 1000;

/// A face of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct DrawnFace {
    /// A point inside, far from the boundary where that is simple to find, in few digits.
    pub inside: Point,
    /// The area, without what lies within.
    pub area: f64,
    /// The box.
    pub bounds: Bounds,
    /// Outer boundary, then the boundaries of the components within it; material on the left.
    pub loops: Vec<Vec<Vertex>>,
    /// Why the face alone is no part, such as that its boundary touches itself; it may be one together with others.
    pub refusal: Option<PartError>,
}

/// The faces of a drawing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DrawnFaces {
    /// The faces, the largest first; of very many the largest only.
    pub faces: Vec<DrawnFace>,
    /// The number of faces.
    pub count: usize,
    /// Drawn curves, as the ends of lines and arcs; for a closed one the last vertex equals the first.
    pub curves: Vec<Vec<Vertex>>,
    /// Problems of what bounds no face, such as an outline with a gap.
    pub dropped: Vec<Problem>,
}

/// Faces of the drawing.
struct Divided {
    faces: arrange::Faces,
    /// The entity of each edge, and its curve.
    entities: Vec<u32>,
    of: Vec<usize>,
    /// The curves; see [`DrawnFaces::curves`].
    curves: Vec<Vec<Vertex>>,
}

impl Making<'_> {
    /// The faces of all lines and arcs, curves fitted.
    fn divided(&mut self) -> Result<Divided, DrawingError> {
        let open = core::mem::take(&mut self.joined.open);
        let closed = core::mem::take(&mut self.joined.loops);
        let mut edges: Vec<Edge> = Vec::new();
        let (mut entities, mut of) = (Vec::new(), Vec::new());
        let mut curves = Vec::new();
        let chains =
            (closed.into_iter().map(|c| (c, false))).chain(open.into_iter().map(closed_by_a_line));
        for (chain, has_closing_line) in chains {
            let outline = match self.lines_and_arcs(&chain, self.fit_of(&chain), Sided::Both) {
                Ok(outline) => outline,
                Err(at) => {
                    self.refuse_fit(&chain, at);
                    continue;
                }
            };
            self.report.add(&outline);
            let n = outline.vertices.len();
            for i in 0..n - usize::from(has_closing_line) {
                let (from, to) = (outline.vertices[i], outline.vertices[(i + 1) % n]);
                edges.push(edge(from.point(), to.point(), from.bulge));
                entities.push(outline.entities[i]);
                of.push(curves.len());
            }
            let mut curve = outline.vertices;
            if !has_closing_line {
                curve.extend(curve.first().copied());
            }
            curves.push(curve);
        }
        let arrangement = split(&edges, self.join_within()).map_err(|_| {
            DrawingError::file(
                "what is drawn crosses itself too often to find the faces between",
                "read the layers of outlines alone with --layer",
            )
        })?;
        Ok(Divided {
            faces: arrange::Faces::of(arrangement),
            entities,
            of,
            curves,
        })
    }

    /// The faces, for a choice among them.
    pub(super) fn faces(mut self) -> Result<DrawnFaces, DrawingError> {
        let divided = self.divided()?;
        if divided.curves.is_empty() {
            return Err(self.nothing());
        }
        let faces = &divided.faces;
        let count = faces.faces.len();
        let listed = (0..count.min(MOST_LISTED)).filter_map(|face| {
            let loops: Vec<Vec<Vertex>> = (around(faces, face).iter())
                .map(|l| l.iter().map(vertex).collect())
                .collect();
            Some(DrawnFace {
                inside: in_few_digits(faces, face, faces.inside(face)?),
                area: faces.faces[face].area,
                bounds: faces.bounds(face),
                refusal: self.refusal(&loops),
                loops,
            })
        });
        Ok(DrawnFaces {
            faces: listed.collect(),
            count,
            dropped: self.dropped(&divided),
            curves: divided.curves,
        })
    }

    /// The problems of open curves that bound no face, and of what else bounds none.
    fn dropped(&self, divided: &Divided) -> Vec<Problem> {
        let faces = &divided.faces;
        let all = (0..faces.faces.len()).flat_map(|face| around(faces, face));
        let edges: Vec<usize> = all.flatten().map(|e| e.edge as usize).collect();
        let curves: HashSet<usize> = edges.iter().map(|&e| divided.of[e]).collect();
        let origin = |e: &usize| key(&self.drawing.entities[divided.entities[*e] as usize].origin);
        let origins: HashSet<OriginKey> = edges.iter().map(origin).collect();
        let bounds_none = |problem: &&Problem| {
            let ends = (problem.at, problem.to);
            let is_it = |curve: &Vec<Vertex>| {
                let [a, b] = [curve.first(), curve.last()].map(|v| v.map(|v| v.point()));
                ends.1.is_some() && (ends == (a, b) || ends == (b, a))
            };
            match divided.curves.iter().position(is_it) {
                Some(curve) => !curves.contains(&curve),
                None => core::iter::once(&problem.origin)
                    .chain(&problem.with)
                    .all(|origin| !origins.contains(&key(origin))),
            }
        };
        self.told.iter().filter(bounds_none).cloned().collect()
    }

    /// Why loops are no part, also without the tips of their cusps.
    fn refusal(&self, loops: &[Vec<Vertex>]) -> Option<PartError> {
        let mut blunted = Vec::with_capacity(loops.len());
        for vertices in loops {
            let mut outline = Outline {
                vertices: vertices.clone(),
                entities: vec![0; vertices.len()],
                ..Outline::default()
            };
            let fit = self.fit_within(|| Ring::of(vertices).size());
            if let Err(error) = checked(&mut outline, fit) {
                return Some(error);
            }
            blunted.push(outline.vertices);
        }
        Part::new("", blunted).err()
    }

    /// The parts of picked faces.
    pub(super) fn picked(mut self) -> Result<Outlines, DrawingError> {
        let divided = self.divided()?;
        let faces = &divided.faces;
        let mut outlines: Vec<Outline> = Vec::new();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut taken: HashSet<usize> = HashSet::new();
        for pick in &self.settings.picks {
            let mut chosen = Vec::new();
            for &at in &pick.at {
                let face = faces.at(at).ok_or_else(|| no_face(faces, at))?;
                if !taken.insert(face) {
                    return Err(DrawingError::file(
                        format!("the face at {} is picked twice", shown::point(at)),
                        "pick every face once",
                    ));
                }
                chosen.push(face);
            }
            let loops = boundary(faces, &chosen);
            groups.push((outlines.len()..outlines.len() + loops.len()).collect());
            outlines.extend(loops.iter().map(|l| {
                Outline {
                    vertices: l.iter().map(vertex).collect(),
                    entities: l
                        .iter()
                        .map(|e| divided.entities[e.edge as usize])
                        .collect(),
                    ..Outline::default()
                }
            }));
        }
        // Faces between tangent curves have cusps. What else is wrong is found with all loops of a part.
        let fits: Vec<f64> = (outlines.iter())
            .map(|o| self.fit_within(|| Ring::of(&o.vertices).size()))
            .collect();
        let tips: Vec<_> = (outlines.iter_mut().zip(&fits))
            .map(|(outline, &fit)| checked(outline, fit).unwrap_or_default())
            .collect();
        let one_part = self.settings.one_part.as_deref();
        let given = names(self.drawing, one_part, &outlines, &groups);
        let mut parts = Vec::with_capacity(groups.len());
        for ((pick, group), given) in self.settings.picks.iter().zip(&groups).zip(given) {
            let of: Vec<&Outline> = group.iter().map(|&i| &outlines[i]).collect();
            let loops = of.iter().map(|o| o.vertices.clone()).collect();
            let name = pick.name.clone().unwrap_or(given);
            let part = Part::new(name.clone(), loops).map_err(|error| {
                let mut problem = no_part(self.drawing, &error, &of);
                problem.reason = format!(
                    "the faces picked for {} are no part: {}",
                    shown::start(&name),
                    problem.reason
                );
                DrawingError::Entities(vec![problem])
            })?;
            parts.push(part);
        }
        self.list_other_entities(&outlines);
        for (tips, fit) in tips.iter().zip(fits) {
            self.tell_tips(tips, fit);
        }
        Ok(self.result(parts, &outlines, None))
    }

    /// Lists what bounds none of the picked faces.
    fn list_other_entities(&mut self, outlines: &[Outline]) {
        let used: HashSet<u32> = outlines.iter().flat_map(|o| &o.entities).copied().collect();
        let others = self.drawing.entities.iter().enumerate();
        let others = others.filter(|(i, _)| !used.contains(&(*i as u32)));
        self.ignored = self.drawing.ignored.clone();
        self.ignored.extend(others.map(|(_, entity)| Ignored {
            origin: entity.origin.clone(),
            reason: "it bounds none of the faces that are picked".into(),
        }));
    }
}

fn vertex(e: &arrange::BoundaryEdge) -> Vertex {
    Vertex::new(e.start.x, e.start.y, e.bulge)
}

/// An open chain with a line from its end to its start, and whether there is one: not if it ends where it starts.
fn closed_by_a_line(mut chain: Chain<'_>) -> (Chain<'_>, bool) {
    let (Some(first), Some(last)) = (chain.pieces.first(), chain.pieces.last()) else {
        return (chain, false);
    };
    let (start, end, entity) = (last.end, first.start, last.entity);
    let is_open = start != end;
    if is_open {
        chain.pieces.push(ChainPiece {
            start,
            end,
            shape: Shape::Edge(0.0),
            is_backward: false,
            entity,
        });
    }
    (chain, is_open)
}

/// The point with the fewest digits that is in the face well inside, as near to the point found as its room allows.
fn in_few_digits(faces: &arrange::Faces, face: usize, inside: Point) -> Point {
    /// Largest displacement of the point, as a share of its distance from the boundary.
    const SHARE: f64 = 0.5;
    let room = SHARE * faces.room(face, inside);
    let mut unit = 10.0_f64.powf(room.log10().floor() + 1.0);
    for _ in 0..3 {
        let round = |x: f64| {
            let rounded = (x / unit).round() * unit;
            // The number that is written with these digits, not a multiple of a power of ten with its rounding.
            let digits = (-unit.log10()).round().max(0.0) as usize;
            format!("{rounded:.digits$}").parse().unwrap_or(rounded)
        };
        let rounded = Point::new(round(inside.x), round(inside.y));
        if rounded.distance(inside) <= room && faces.at(rounded) == Some(face) {
            return rounded;
        }
        unit /= 10.0;
    }
    inside
}

/// Error: no face is at a point; it names the nearest one.
fn no_face(faces: &arrange::Faces, at: Point) -> DrawingError {
    let nearest = (0..faces.faces.len())
        .map(|face| (faces.room(face, at), face))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .and_then(|(_, face)| Some(in_few_digits(faces, face, faces.inside(face)?)));
    let message = format!("no face is at {}", shown::point(at));
    match nearest {
        Some(p) => DrawingError::file(
            message,
            format!(
                "pick a point within closed curves, such as {},{} in the nearest face",
                p.x, p.y
            ),
        ),
        None => DrawingError::file(
            message,
            "nothing that is drawn encloses a face: check the layers",
        ),
    }
}
