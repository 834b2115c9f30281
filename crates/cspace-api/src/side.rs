//! Where on its part a feature is, in words: a side, a wall, a round, a corner.

use core::f64::consts::PI;

use cspace::{Edge, FeatureKind, FeatureName, Loop, Part, Point, Vector};

use cspace_plan::farthest;

use crate::rounded::rounded;

/// Lengths that differ by less than this share of the part's size are the same: drawings have six digits and more.
const SAME: f64 = 1e-6;
/// Edges whose directions differ by less than this sine join smoothly: drawings have six digits and more.
const SMOOTH: f64 = 1e-5;
/// A direction within this of that of an axis is called by it alone, radians.
const ALONG: f64 = PI / 6.0;

/// Where on a part a feature is: "left side" if nothing of the part is farther left, "left wall of a recess, at 3, -2" if something is,
/// "left wall of the hole about 0, 0", "circle of radius 2 about 0, 0", also of a vertex on it, "corner at 1, 2". Directions and places are those of the part as
/// it is drawn, in its own frame. There is none of a feature that the part does not have.
///
/// ```
/// use cspace::{FeatureKind, FeatureName, Part};
/// let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0)?;
/// let lines = [0, 1, 2, 3].map(|index| FeatureName { kind: FeatureKind::Line, loop_index: 0, index });
/// let sides = lines.map(|line| cspace_api::place_on_part(&block, line).unwrap_or_default());
/// assert_eq!(sides, ["bottom side", "right side", "top side", "left side"]);
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn place_on_part(part: &Part, feature: FeatureName) -> Option<String> {
    let outline = part.loops().get(feature.loop_index as usize)?;
    let index = feature.index as usize;
    if feature.kind == FeatureKind::Vertex {
        let at = outline.vertices().get(index)?.point();
        let [before, after] = beside(outline, index)?;
        let (into, out) = (before.end_direction(), after.start_direction());
        // Where edges join smoothly is no corner: it is on the one that is round.
        let is_smooth =
            into.dot(out) > 0.0 && into.cross(out).abs() <= SMOOTH * into.length() * out.length();
        return Some(match [before, after].iter().find(|edge| !edge.is_line()) {
            Some(edge) if is_smooth => arc(part, outline, edge),
            _ => format!("corner at {}", place(at)),
        });
    }
    let edge = outline.edges().find(|edge| edge.index == index)?;
    Some(match edge.is_line() {
        true => line(part, outline, &edge),
        false => arc(part, outline, &edge),
    })
}

/// The edges that end and begin at a vertex.
fn beside(outline: &Loop, index: usize) -> Option<[Edge; 2]> {
    let edges: Vec<Edge> = outline.edges().collect();
    let after = edges.iter().position(|edge| edge.index == index)?;
    let before = after.checked_sub(1).unwrap_or(edges.len() - 1);
    Some([edges[before], edges[after]])
}

fn line(part: &Part, outline: &Loop, edge: &Edge) -> String {
    let outward = (edge.end - edge.start).right().unit();
    let reach = edge.start.to_vector().dot(outward);
    if reach >= farthest(part, outward) - SAME * part.size() {
        return format!("{} side", direction(outward));
    }
    // What looks to the right is left of the space that it bounds.
    let wall = direction(-outward);
    match outline.signed_area() < 0.0 {
        true => format!("{wall} wall of the hole about {}", place(middle(outline))),
        false => {
            let at = place(edge.start.midpoint(edge.end));
            format!("{wall} wall of a recess, at {at}")
        }
    }
}

fn arc(part: &Part, outline: &Loop, edge: &Edge) -> String {
    let (center, radius) = (edge.center(), edge.radius());
    let near = SAME * part.size();
    let is_circle = outline.edges().all(|other| {
        !other.is_line()
            && other.center().distance(center) < near
            && (other.radius() - radius).abs() < near
    });
    let name = match (is_circle, edge.bulge > 0.0) {
        (true, true) => "circle",
        (true, false) => "hole",
        (false, true) => "round",
        (false, false) => "hollow",
    };
    format!(
        "{name} of radius {} about {}",
        rounded(radius),
        place(center)
    )
}

fn middle(outline: &Loop) -> Point {
    let bounds = outline.edges().map(|edge| edge.bounds());
    let all = bounds.reduce(cspace::part::Bounds::union);
    all.map_or(Point::ORIGIN, |bounds| bounds.center())
}

fn place(at: Point) -> String {
    format!("{}, {}", rounded(at.x), rounded(at.y))
}

/// A direction by the axes that it is near to.
fn direction(way: Vector) -> &'static str {
    let steep = way.y.abs().atan2(way.x.abs());
    if steep <= ALONG {
        return if way.x > 0.0 { "right" } else { "left" };
    }
    if steep >= 0.5 * PI - ALONG {
        return if way.y > 0.0 { "top" } else { "bottom" };
    }
    match (way.x > 0.0, way.y > 0.0) {
        (true, true) => "upper right",
        (false, true) => "upper left",
        (false, false) => "lower left",
        (true, false) => "lower right",
    }
}

#[cfg(test)]
mod tests;
