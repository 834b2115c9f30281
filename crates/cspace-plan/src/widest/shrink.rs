//! A part shrunk by a distance: its places that are farther than that from its boundary.

use cspace::part::polygon_loop;
use cspace::{Part, PartError};

use super::grow::grown;

/// The part shrunk by a radius, in the model's unit of length: the complement of the complement grown, right to the
/// resolution of slices; `None` if nothing is left.
///
/// # Errors
/// If the radius is not positive and finite, or the outline is none that a part can have.
///
/// ```
/// use cspace::Part;
/// let square = Part::rectangle("square", (0.0, 0.0), 2.0, 2.0)?;
/// let shrunk = cspace_plan::shrunk(&square, 0.25)?.ok_or("some is left")?;
/// assert!((shrunk.area() - 2.25).abs() < 1e-9);
/// assert!(cspace_plan::shrunk(&square, 1.5)?.is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn shrunk(part: &Part, radius: f64) -> Result<Option<Part>, PartError> {
    let bounds = part.bounds();
    let around = bounds.diagonal();
    let (min, max) = (bounds.min, bounds.max);
    if radius > around {
        // To be told what is wrong with it.
        Part::circle("disc", (0.0, 0.0), radius)?;
        return Ok(None);
    }
    // A frame around the part, of which the part is the hole.
    let frame = polygon_loop(&[
        (min.x - around, min.y - around),
        (max.x + around, min.y - around),
        (max.x + around, max.y + around),
        (min.x - around, max.y + around),
    ]);
    part.by_layers(|layer| {
        let mut loops: Vec<_> = (layer.loops().iter())
            .map(|l| l.vertices().to_vec())
            .collect();
        loops.push(frame.clone());
        let outside = grown(&Part::new(part.name(), loops)?, radius)?;
        let inside = (outside.loops().iter())
            .filter(|l| l.vertices().iter().all(|v| bounds.contains(v.point())));
        Ok(inside.map(|l| l.vertices().to_vec()).collect())
    })
}
