//! A part grown by a distance: all places within it.

use cspace::part::tolerance::RESOLUTION;
use cspace::{CurveGeometry, Part, PartError, Slice, Vertex};

/// The part grown by a radius, in the model's unit of length: the Minkowski sum with a disc. Its boundary is the slice of the part
/// and the disc: where the disc's centre touches the part from outside, right to the resolution of slices.
///
/// # Errors
/// If the radius is not positive and finite, or the grown outline is none that a part can have.
///
/// ```
/// use cspace::Part;
/// let square = Part::rectangle("square", (0.0, 0.0), 2.0, 2.0)?;
/// let grown = cspace_plan::grown(&square, 0.5)?;
/// // Its own area, four sides 0.5 wide, and a disc at the corners.
/// assert!((grown.area() - (4.0 + 4.0 + 0.25 * core::f64::consts::PI)).abs() < 1e-9);
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn grown(part: &Part, radius: f64) -> Result<Part, PartError> {
    let disc = Part::circle("disc", (0.0, 0.0), radius)?;
    let shortest = 2.0 * RESOLUTION * (part.size() + 2.0 * radius);
    let around = |layer: &Part| -> Result<Vec<Vec<Vertex>>, PartError> {
        let slice = Slice::compute(layer, &disc, 0.0);
        let outline = |l: &Vec<u32>| {
            let curves = l.iter().map(|&i| slice.curves[i as usize].geometry);
            outline(curves, shortest)
        };
        let loops = slice.loops.iter().map(outline);
        Ok(loops.filter(|l| l.len() > 1).collect())
    };
    part.by_layers(around)?.ok_or(PartError::Empty)
}

/// The vertices of a closed loop of curves; those shorter than a length are left out.
fn outline(curves: impl Iterator<Item = CurveGeometry>, shortest: f64) -> Vec<Vertex> {
    let mut vertices = Vec::new();
    for curve in curves {
        if curve.length() <= shortest {
            continue;
        }
        let mut vertex = |s: f64, bulge: f64| {
            let p = curve.point(s);
            vertices.push(Vertex::new(p.x, p.y, bulge));
        };
        match curve {
            CurveGeometry::Segment { .. } => vertex(0.0, 0.0),
            CurveGeometry::FlatArc { bulge, .. } => vertex(0.0, bulge),
            // In two halves: a full circle needs two vertices.
            CurveGeometry::Arc { sweep, .. } if sweep.abs() > core::f64::consts::PI => {
                vertex(0.0, (sweep / 8.0).tan());
                vertex(0.5, (sweep / 8.0).tan());
            }
            CurveGeometry::Arc { sweep, .. } => vertex(0.0, (sweep / 4.0).tan()),
        }
    }
    vertices
}
