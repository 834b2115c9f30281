//! Outlines of parts and contact curves as paths.

use cspace::part::Loop;
use cspace::{Configuration, CurveGeometry, Layer, Part, Point};

use crate::plot::Plot;
use crate::scene::{Dot, Path, Step};

/// The loops of a part where it is placed.
pub(crate) fn of_part(part: &Part, assembly_from_part: Configuration, plot: &Plot) -> Path {
    of_loops(part.loops(), assembly_from_part, plot)
}

/// The loops that a part has at a height, where it is placed; all without a height.
pub(crate) fn at_height(
    part: &Part,
    height: Option<f64>,
    assembly_from_part: Configuration,
    plot: &Plot,
) -> Path {
    let mut path = Path::new();
    for layer in part.layers().iter().filter(|l| is_at(l, height)) {
        let loops = &part.loops()[layer.loops()];
        path.steps
            .extend(of_loops(loops, assembly_from_part, plot).steps);
    }
    path
}

fn is_at(layer: &Layer, height: Option<f64>) -> bool {
    height.is_none_or(|z| layer.is_at(z))
}

/// The layers of a part at a height, or all, where it is placed, the lowest first, each with how high it is in the stack: from 0 of the lowest to 1.
pub(crate) fn of_layers(
    part: &Part,
    height: Option<f64>,
    assembly_from_part: Configuration,
    plot: &Plot,
) -> Vec<(f64, Path)> {
    let low = |layer: &Layer| layer.z().map_or(f64::NEG_INFINITY, |z| z[0]);
    let mut layers: Vec<&Layer> = part.layers().iter().collect();
    layers.sort_by(|a, b| low(a).total_cmp(&low(b)));
    let most = (layers.len() - 1).max(1) as f64;
    let path = |layer: &Layer| of_loops(&part.loops()[layer.loops()], assembly_from_part, plot);
    let numbered = layers.into_iter().enumerate();
    numbered
        .filter(|(_, layer)| is_at(layer, height))
        .map(|(i, layer)| (i as f64 / most, path(layer)))
        .collect()
}

fn of_loops(loops: &[Loop], assembly_from_part: Configuration, plot: &Plot) -> Path {
    let mut path = Path::new();
    let at = |p: Point| place(plot, assembly_from_part.fixed_from_moving(p));
    for l in loops {
        let vertices = l.vertices();
        for (i, v) in vertices.iter().enumerate() {
            if i == 0 {
                path.steps.push(Step::Move(at(v.point())));
            }
            let next = vertices[(i + 1) % vertices.len()];
            path.steps.push(step(at(next.point()), v.bulge));
        }
        path.steps.push(Step::Close);
    }
    path
}

/// Lines and arcs from a point on, each by its end and bulge.
pub(crate) fn of_edges(start: Point, edges: &[(Point, f64)], plot: &Plot) -> Path {
    let mut path = Path::new();
    path.steps.push(Step::Move(place(plot, start)));
    let steps = edges
        .iter()
        .map(|&(to, bulge)| step(place(plot, to), bulge));
    path.steps.extend(steps);
    path
}

/// Appends a curve to a path that is at its start.
pub(crate) fn append(path: &mut Path, geometry: &CurveGeometry, plot: &Plot) {
    match *geometry {
        CurveGeometry::Segment { end, .. } => path.steps.push(Step::Line(place(plot, end))),
        CurveGeometry::FlatArc { end, bulge, .. } => path.steps.push(step(place(plot, end), bulge)),
        CurveGeometry::Arc { sweep, .. } => {
            // An arc by its ends must not be a whole turn.
            let pieces = if sweep.abs() > 3.0 { 3 } else { 1 };
            let bulge = (0.25 * sweep / f64::from(pieces)).tan();
            for k in 1..=pieces {
                let end = geometry.point(f64::from(k) / f64::from(pieces));
                path.steps.push(step(place(plot, end), bulge));
            }
        }
    }
}

/// Position of a point of the plane.
pub(crate) fn place(plot: &Plot, p: Point) -> Dot {
    plot.place(p.x, p.y)
}

/// A line or an arc; y is upwards in the plane and downwards on a picture, which turns an arc about.
fn step(to: Dot, bulge: f64) -> Step {
    if bulge == 0.0 {
        Step::Line(to)
    } else {
        Step::Arc { to, bulge: -bulge }
    }
}

/// Points along a part's outline, for the places of labels and the extent of pictures.
pub(crate) fn points(part: &Part, assembly_from_part: Configuration) -> Vec<Point> {
    /// Number of points per edge.
    const POINTS: u32 = 8;
    let mut all = Vec::new();
    for edge in part.edges() {
        let shares = if edge.is_line() { 1 } else { POINTS };
        for k in 0..shares {
            let share = f64::from(k) / f64::from(shares);
            let p = if edge.is_line() {
                edge.start
            } else {
                let arm = edge.start - edge.center();
                edge.center() + cspace::Rotation::by(share * edge.sweep()) * arm
            };
            all.push(assembly_from_part.fixed_from_moving(p));
        }
    }
    all
}

/// The least rectangle about points: ranges of x and y. One that is empty or flat is as wide as `least`.
pub(crate) fn extent(points: &[Point], least: f64) -> [(f64, f64); 2] {
    let range = |of: fn(&Point) -> f64| {
        let lo = points.iter().map(of).fold(f64::INFINITY, f64::min);
        let hi = points.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
        let (lo, hi) = if lo <= hi { (lo, hi) } else { (0.0, 0.0) };
        let more = (0.5 * (least - (hi - lo))).max(0.0);
        (lo - more, hi + more)
    };
    [range(|p| p.x), range(|p| p.y)]
}

/// A range with a share of it added at both ends.
pub(crate) fn with_margin((lo, hi): (f64, f64), margin: f64) -> (f64, f64) {
    (lo - margin, hi + margin)
}
