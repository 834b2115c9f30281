//! Outlines as drawings that other programs read.

mod dxf;
mod svg;

use cspace::CurveGeometry;
use cspace::{Configuration, Edge, Layer, Part, Point, Slice, Vertex};

pub use dxf::{DxfVersion, dxf};
pub use svg::svg;

/// Closed loops of lines and arcs of one name: a part, or the boundary of free space in a slice.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// Name of the drawn part and of its layer.
    pub name: String,
    /// The loops.
    pub loops: Vec<Vec<Vertex>>,
}

impl Drawn {
    /// The layers of a part, as they are drawn: of one layer with the part's name, of several with their numbers behind it.
    pub fn part(part: &Part) -> Vec<Self> {
        let layers = part.layers().iter().enumerate();
        let of = |(i, layer): (usize, &Layer)| Self {
            name: match part.layers() {
                [_] => part.name().to_owned(),
                _ => format!("{} layer {i}", part.name()),
            },
            loops: part.outline(layer),
        };
        layers.map(of).collect()
    }

    /// Copy moved by a configuration: a point q goes to (x, y) + R q.
    #[must_use]
    pub fn moved(mut self, by: Configuration) -> Self {
        if by != Configuration::default() {
            for v in self.loops.iter_mut().flatten() {
                let p = by.fixed_from_moving(v.point());
                (v.x, v.y) = (p.x, p.y);
            }
        }
        self
    }

    /// The boundary of free space in a slice.
    pub fn slice(name: &str, slice: &Slice) -> Self {
        let vertex = |geometry: &CurveGeometry| {
            let at = geometry.point(0.0);
            let bulge = match *geometry {
                CurveGeometry::Segment { .. } => 0.0,
                CurveGeometry::Arc { sweep, .. } => (sweep / 4.0).tan(),
                CurveGeometry::FlatArc { bulge, .. } => bulge,
            };
            Vertex::new(at.x, at.y, bulge)
        };
        let of_loop = |indices: &Vec<u32>| -> Vec<Vertex> {
            let curves = indices.iter().map(|&i| &slice.curves[i as usize].geometry);
            let mut vertices: Vec<Vertex> = curves.clone().map(vertex).collect();
            // A whole circle is one curve of a slice, and two arcs of an outline.
            if let ([only], Some(CurveGeometry::Arc { sweep, .. })) =
                (&mut vertices[..], curves.clone().next())
            {
                only.bulge = (sweep / 8.0).tan();
                let bulge = only.bulge;
                let half: Option<Point> = curves.clone().next().map(|g| g.point(0.5));
                vertices.extend(half.map(|p| Vertex::new(p.x, p.y, bulge)));
            }
            vertices
        };
        Self {
            name: name.to_owned(),
            loops: slice.loops.iter().map(of_loop).collect(),
        }
    }

    /// The corners of the box of all vertices and the middles of arcs; of nothing the origin.
    fn extent(all: &[Self]) -> [Point; 2] {
        let mut lo = Point::new(f64::INFINITY, f64::INFINITY);
        let mut hi = Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY);
        for Edge {
            start: p,
            end: q,
            bulge,
            ..
        } in all.iter().flat_map(|d| &d.loops).flat_map(|l| edges(l))
        {
            // An arc is within its height of its chord.
            let high = 0.5 * bulge.abs() * p.distance(q)
                + if bulge.abs() > 1.0 {
                    p.distance(q)
                } else {
                    0.0
                };
            for at in [p, q] {
                lo = Point::new(lo.x.min(at.x - high), lo.y.min(at.y - high));
                hi = Point::new(hi.x.max(at.x + high), hi.y.max(at.y + high));
            }
        }
        if lo.is_finite() && hi.is_finite() {
            [lo, hi]
        } else {
            [Point::ORIGIN; 2]
        }
    }
}

/// The edges of a closed loop.
fn edges(vertices: &[Vertex]) -> impl Iterator<Item = Edge> {
    let ends = vertices.iter().cycle().skip(1);
    let pairs = vertices.iter().zip(ends);
    pairs.map(|(from, to)| Edge::between(from.point(), to.point(), from.bulge))
}
