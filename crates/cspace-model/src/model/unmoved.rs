//! Notes on parts without a motion beside parts on axes: most likely they stand still, and the file does not say so.

use cspace::{AxisMotion, PairClass};

use super::bodies::Bodies;
use super::error::ModelError;
use super::parts::each_part;
use super::scope::Result;
use super::table::Table;
use crate::mechanism::Mechanism;
use crate::shown::quoted;

/// So many parts are named.
const MOST: usize = 4;

/// Notes that an axis has no effect against a part of the same pair that has no motion: the pair is looked at in the plane.
///
/// A part whose motion is written, that is carried by a joint, or is subject to masses, springs or loads, is free by intention.
pub(super) fn unmoved(
    root: &Table<'_>,
    mechanism: &Mechanism,
    bodies: &Bodies,
) -> Result<Vec<ModelError>> {
    let dynamics = &mechanism.dynamics;
    let says = each_part(root, |_, table| Ok(table.has("motion")))?;
    let is_free = |i: usize| {
        let own = dynamics.part(i);
        let is_loaded = dynamics.loads.iter().any(|l| l.part == i)
            || (dynamics.springs.iter()).any(|s| s.part == i || s.other == Some(i));
        let is_carried = (mechanism.joints.iter()).any(|j| j.parts.0 == i || j.parts.1 == i);
        let moves = own.mass.is_some() || own.start.is_some() || own.rate.is_some();
        let is_said = bodies.of[i].iter().any(|&k| says[k]);
        !(is_said || is_carried || moves || is_loaded)
    };
    let turns = |i: usize| {
        let axis = mechanism.parts[i].axis;
        axis.is_some_and(|a| a.motion != AxisMotion::Fixed)
    };
    let name = |i: usize| quoted(mechanism.parts[i].part.name());
    let planar = |p: &&crate::mechanism::PairEntry| mechanism.pair_class(p) == PairClass::General;
    let both = (mechanism.pairs.iter().filter(planar))
        .flat_map(|p| [(p.fixed, p.moving), (p.moving, p.fixed)]);
    let mut found: Vec<(usize, usize)> = both.filter(|&(i, j)| is_free(i) && turns(j)).collect();
    found.sort_by_key(|f| f.0);
    found.dedup_by_key(|f| f.0);
    let mut notes = Vec::new();
    for &(free, moving) in found.iter().take(MOST) {
        let place = bodies.place(root, free, "name")?;
        let mut message = format!(
            "it has no `motion`, so it is free in the plane, and the axis of {} is not used against it: if it stands still, add motion = {{ type = \"fixed\" }} to it, else {{ type = \"planar\" }}",
            name(moving)
        );
        if let (true, more @ 1..) = (notes.len() + 1 == MOST, found.len() - MOST.min(found.len())) {
            message += &format!("; so are {more} more parts");
        }
        notes.push(ModelError::new(&place, message));
    }
    Ok(notes)
}
