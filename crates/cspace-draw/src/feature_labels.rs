//! Labels of the features of parts, as answers call them, beside the features where they fit.

use cspace::{Edge, FeatureKind, FeatureName, Part, Point, Vector};

use crate::colour::part as colours;
use crate::font;
use crate::labels::Placed;
use crate::outline::place;
use crate::placed_part::PlacedPart;
use crate::plot::Plot;
use crate::scene::{Area, Dot, Item};

/// Number of features in a picture, and number of those without a label.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fitting {
    pub(crate) all: usize,
    pub(crate) left_out: usize,
}

impl core::fmt::Display for Fitting {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match (self.left_out, self.all) {
            (0, n) => write!(f, "labels of all {n} features"),
            (left, n) => write!(
                f,
                "labels of {left} of {n} features are left out: they do not fit"
            ),
        }
    }
}

/// Feature with its position in the picture, and the outward normal.
struct Labelled {
    said: String,
    colour: crate::scene::Colour,
    /// Places on it with the directions to the side of it, the best first.
    places: Vec<(Dot, Vector)>,
    /// Length in the picture.
    length: f64,
}

/// The places that outlines pass, in cells of a picture.
struct Passed {
    area: Area,
    cell: f64,
    columns: usize,
    is_passed: Vec<bool>,
}

/// Labels lines, arcs and convex vertices at a height, or all, the longest first, where a label lies on no other and on no outline.
pub(crate) fn label(
    items: &mut Vec<Item>,
    parts: &[PlacedPart<'_>],
    height: Option<f64>,
    plot: &Plot,
    placed: &mut Placed,
) -> Fitting {
    /// The size of the letters, in that of usual ones.
    const SIZE: f64 = 0.7;
    let em = plot.em;
    let size = SIZE * em;
    let passed = Passed::of(parts, plot);
    let mut all: Vec<Labelled> = parts
        .iter()
        .flat_map(|p| features(p, height, plot))
        .collect();
    all.sort_by(|a, b| b.length.total_cmp(&a.length));
    let mut left_out = 0;
    for feature in &all {
        let (w, h) = (font::width(&feature.said, size), size);
        let places = (feature.places.iter()).flat_map(|&(at, side)| {
            // As near as the box of the letters may be without lying on the feature.
            let away = 0.5 * (w * side.x.abs() + h * side.y.abs()) + 0.45 * em;
            [away, -away].map(|d| at.moved(d * side.x, d * side.y))
        });
        let free = places.filter(|at| {
            let area = Area::new(at.x - 0.5 * w, at.y - 0.5 * h, w, h);
            !passed.meets(&area)
        });
        if !placed.put_in(items, &feature.said, size, feature.colour, free) {
            left_out += 1;
        }
    }
    Fitting {
        all: all.len(),
        left_out,
    }
}

/// The features of a part that are in the picture.
fn features<'a>(
    p: &'a PlacedPart<'_>,
    height: Option<f64>,
    plot: &'a Plot,
) -> impl Iterator<Item = Labelled> + 'a {
    /// A corner that turns by less, in radians, is not seen as one.
    const SEEN: f64 = 0.05;
    let colour = colours(p.number).1;
    let dot = move |at: Point| place(plot, p.assembly_from_part.fixed_from_moving(at));
    let direction = move |d: Vector| {
        let (sin, cos) = p.assembly_from_part.theta.sin_cos();
        Vector::new(cos * d.x - sin * d.y, -(sin * d.x + cos * d.y))
    };
    let name = |part: &Part, kind, loop_index: usize, index: usize| {
        part.feature_text(FeatureName {
            kind,
            loop_index: loop_index as u32,
            index: index as u32,
        })
    };
    let all = p
        .part
        .loops()
        .iter()
        .enumerate()
        .filter(move |&(l, _)| height.is_none_or(|z| p.part.bounds_at(l, z)))
        .flat_map(move |(l, ring)| {
            let edges: Vec<Edge> = ring.edges().collect();
            let n = edges.len();
            let mut found = Vec::with_capacity(2 * n);
            for (i, edge) in edges.iter().enumerate() {
                let kind = FeatureKind::of_bulge(edge.bulge);
                let places =
                    [0.5, 0.3, 0.7].map(|t| (dot(edge.at(t)), direction(outward(edge, t))));
                found.push(Labelled {
                    said: name(p.part, kind, l, edge.index),
                    colour,
                    places: places.to_vec(),
                    length: edge.length() * plot.scale(),
                });
                let before = edges[(i + n - 1) % n];
                let (arriving, leaving) = (before.end_direction(), edge.start_direction());
                let turn = arriving.cross(leaving).atan2(arriving.dot(leaving));
                if turn > SEEN {
                    let index = ring.start_of(edge.index);
                    let out = (arriving - leaving).unit();
                    found.push(Labelled {
                        said: name(p.part, FeatureKind::Vertex, l, index),
                        colour,
                        places: vec![(dot(edge.start), direction(out))],
                        length: 0.0,
                    });
                }
            }
            found
        });
    all.filter(|f| f.places.iter().any(|(at, _)| is_in(&plot.area, *at)))
}

/// The direction out of the material at a share of an edge.
fn outward(edge: &Edge, t: f64) -> Vector {
    let d = (edge.end - edge.start).unit();
    let turn = (t - 0.5) * edge.sweep();
    let (sin, cos) = turn.sin_cos();
    Vector::new(cos * d.x - sin * d.y, cos * d.y + sin * d.x).right()
}

fn is_in(area: &Area, at: Dot) -> bool {
    area.holds(&Area::new(at.x, at.y, 0.0, 0.0))
}

impl Passed {
    fn of(parts: &[PlacedPart<'_>], plot: &Plot) -> Self {
        let cell = 0.25 * plot.em;
        let of = |length: f64| (length / cell).ceil().max(1.0) as usize;
        let (columns, rows) = (of(plot.area.width()), of(plot.area.height()));
        let mut passed = Self {
            area: plot.area,
            cell,
            columns,
            is_passed: vec![false; columns * rows],
        };
        for p in parts {
            for edge in p.part.edges() {
                passed.pass(&edge, p, plot);
            }
        }
        passed
    }

    /// Marks the cells of an edge.
    fn pass(&mut self, edge: &Edge, p: &PlacedPart<'_>, plot: &Plot) {
        /// Places on an edge that is much longer than the picture.
        const MOST: f64 = 1e5;
        let steps = (2.0 * edge.length() * plot.scale() / self.cell).ceil();
        let steps = steps.clamp(1.0, MOST) as u32;
        for k in 0..=steps {
            let at = edge.at(f64::from(k) / f64::from(steps));
            let at = place(plot, p.assembly_from_part.fixed_from_moving(at));
            if is_in(&self.area, at) {
                let (column, row) = self.cell_of(at);
                if let Some(is_passed) = self.is_passed.get_mut(row * self.columns + column) {
                    *is_passed = true;
                }
            }
        }
    }

    fn cell_of(&self, at: Dot) -> (usize, usize) {
        let of = |length: f64| (length / self.cell).max(0.0) as usize;
        let column = of(at.x - self.area.lo.x).min(self.columns - 1);
        (column, of(at.y - self.area.lo.y))
    }

    /// Whether an outline passes through a rectangle.
    fn meets(&self, area: &Area) -> bool {
        let ((x0, y0), (x1, y1)) = (self.cell_of(area.lo), self.cell_of(area.hi));
        (y0..=y1).any(|row| {
            let row = self.is_passed.get(row * self.columns..).unwrap_or(&[]);
            (row.iter().take(self.columns).skip(x0).take(x1 - x0 + 1)).any(|is_passed| *is_passed)
        })
    }
}
