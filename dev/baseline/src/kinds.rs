//! Kinds of critical orientations of the exact contact space.

use core::f64::consts::{PI, TAU};

use cspace::{
    Boundary, Configuration, ContactSpace, FeatureKind, FeatureName, Part, PatchId, PatchRef,
    SideLink, Vector,
};

/// Largest difference (radians) of equal orientations: the space stores one number per event, but the angles of normals
/// are computed here anew.
const SAME: f64 = 1e-9;

/// A patch narrower than this share of the parts' size, where it begins or ends, begins or ends in a point: its width grows with
/// the root of the orientation beside a tangency.
const POINT: f64 = 1e-5;

/// Contact curves that cross at an angle with a smaller sine are tangent there.
const TANGENT: f64 = 1e-3;

/// Kinds of events at one critical orientation. Several can happen at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Kinds {
    /// One contact: a normal at the end of a feature opposes one of the other part. Sides are parallel, or the end of an arc
    /// reaches a side or an arc's end.
    pub aligned: bool,
    /// Two contacts: the end of a feature touches while another pair does.
    pub end: bool,
    /// Two contacts whose curves become tangent: a passage opens or closes between them, or one begins to reach beyond the other.
    pub tangent: bool,
    /// Three contacts at the same time.
    pub triple: bool,
}

/// Kinds of each critical orientation of a space, in their order, determined by the patches that begin or end there.
///
/// A patch that begins or ends with a positive width does so because its features' normals cease to oppose each other,
/// or because its neighbour changes. A patch begins or ends in a point where its two boundaries meet: the end of a
/// feature and another contact, or two other contacts, or the same other contact twice, which is then tangent.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// for (_, kinds) in cspace_baseline::kinds::of(&space) {
///     assert!(kinds.aligned && !kinds.end && !kinds.tangent && !kinds.triple);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn of(space: &ContactSpace) -> Vec<(f64, Kinds)> {
    let critical = space.critical_orientations();
    let mut kinds = vec![Kinds::default(); critical.len()];
    let index = |theta: f64| {
        let at = critical.partition_point(|&c| c < theta);
        let near = [at, at.wrapping_sub(1), 0, critical.len().wrapping_sub(1)];
        near.into_iter()
            .find(|&i| critical.get(i).is_some_and(|c| off(*c, theta) <= SAME))
    };
    for i in (0..space.patches().len() as u32).map(PatchId) {
        let Some(patch) = space.patch(i) else {
            continue;
        };
        let (lo, hi) = (patch.data().lo, patch.data().hi);
        for theta in [lo, hi] {
            // Beyond π, or at an end of the window.
            let turned = theta - TAU * ((theta + PI) / TAU).floor();
            if let Some(at) = index(turned) {
                add(&mut kinds[at], space, i, patch, theta);
            }
        }
    }
    critical.iter().copied().zip(kinds).collect()
}

/// Difference of two orientations, around the turn.
fn off(a: f64, b: f64) -> f64 {
    let off = a - b;
    (off - TAU * (off / TAU).round()).abs()
}

/// Adds the kinds of criticality for which a patch begins or ends at an orientation.
fn add(kinds: &mut Kinds, space: &ContactSpace, id: PatchId, patch: PatchRef<'_>, theta: f64) {
    let data = patch.data();
    let normals = [
        normals(space.fixed(), data.fixed),
        normals(space.moving(), data.moving),
    ];
    let aligned =
        (normals[0].iter()).any(|a| normals[1].iter().any(|b| off(a - b - PI, theta) <= SAME));
    kinds.aligned |= aligned;
    let (left, right) = (patch.left().at(theta), patch.right().at(theta));
    let size = space.fixed().size().max(space.moving().size());
    let crossings = [&data.left, &data.right].map(|b| match b {
        Boundary::Crossing { with, .. } => Some(with),
        Boundary::End { .. } => None,
    });
    if left.position().distance(right.position()) <= POINT * size {
        match crossings {
            [Some(f), Some(g)] if f == g => kinds.tangent = true,
            [Some(_), Some(_)] => kinds.triple = true,
            [None, None] => {}
            _ if aligned => {}
            _ => kinds.end = true,
        }
    } else if !aligned {
        let before = neighbour(space.links_before(id), theta, |l| l.before);
        let after = neighbour(space.links_after(id), theta, |l| l.after);
        kinds.tangent |= crossings[0].is_some() && is_tangent(space, patch, before, left);
        kinds.tangent |= crossings[1].is_some() && is_tangent(space, patch, after, right);
    }
}

/// The patch at the other side of a boundary, at an orientation at which the patch begins or ends.
fn neighbour<'a>(
    mut links: impl Iterator<Item = &'a SideLink>,
    theta: f64,
    other: fn(&SideLink) -> PatchId,
) -> Option<PatchId> {
    links
        .find(|l| off(l.lo, theta) <= SAME || off(l.hi, theta) <= SAME)
        .map(other)
}

fn is_tangent(
    space: &ContactSpace,
    patch: PatchRef<'_>,
    other: Option<PatchId>,
    at: Configuration,
) -> bool {
    let Some(other) = other.and_then(|i| space.patch(i)) else {
        return false;
    };
    let [n, m] = [patch, other].map(|p| {
        let [x, y, _] = p.gradient(at);
        Vector::new(x, y)
    });
    n.cross(m).abs() <= TANGENT
}

/// The angles of the outward normals at the ends of a feature.
fn normals(part: &Part, name: FeatureName) -> Vec<f64> {
    let Some(l) = part.loops().get(name.loop_index as usize) else {
        return Vec::new();
    };
    let index = name.index as usize;
    let angle = |direction: Vector| direction.right().angle();
    if name.kind == FeatureKind::Vertex {
        let Some(corner) = l.vertices().get(index).map(|v| v.point()) else {
            return Vec::new();
        };
        let at = |e: cspace::Edge| {
            let from = (e.start == corner).then(|| angle(e.start_direction()));
            from.or_else(|| (e.end == corner).then(|| angle(e.end_direction())))
        };
        return l.edges().filter_map(at).collect();
    }
    (l.edges().filter(|e| e.index == index))
        .flat_map(|e| [angle(e.start_direction()), angle(e.end_direction())])
        .collect()
}
