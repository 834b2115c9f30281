//! Outlines of one layer that are apart from each other: a part each, or one of all.

use std::collections::HashMap;
use std::sync::Arc;

use super::result::Apart;
use crate::drawing::{Drawing, Origin};
use crate::fit::Outline;

/// Origin of the first entity in a group's outermost loop.
fn origin<'d>(drawing: &'d Drawing, outlines: &[Outline], group: &[usize]) -> Option<&'d Origin> {
    let outer = outlines.get(*group.first()?)?;
    let entity = outer.entities.first()?;
    Some(&drawing.entities[*entity as usize].origin)
}

/// The groups whose outermost loops are on one layer made one, in the order of the first of each.
pub(super) fn by_layer(
    drawing: &Drawing,
    outlines: &[Outline],
    groups: Vec<Vec<usize>>,
) -> Vec<Vec<usize>> {
    let mut merged: Vec<Vec<usize>> = Vec::new();
    let mut places: HashMap<Arc<str>, usize> = HashMap::new();
    for group in groups {
        let layer = origin(drawing, outlines, &group).map(|o| Arc::clone(&o.layer));
        let at = *places
            .entry(layer.unwrap_or_default())
            .or_insert(merged.len());
        match merged.get_mut(at) {
            Some(of_layer) => of_layer.extend(group),
            None => merged.push(group),
        }
    }
    merged
}

/// Layers that contain several parts; entities in a block are not counted, because the block is a part.
pub(super) fn apart(
    drawing: &Drawing,
    outlines: &[Outline],
    groups: &[Vec<usize>],
    names: &[String],
) -> Vec<Apart> {
    let mut layers: Vec<Apart> = Vec::new();
    let mut places: HashMap<Arc<str>, usize> = HashMap::new();
    for (group, name) in groups.iter().zip(names) {
        let Some(origin) = origin(drawing, outlines, group) else {
            continue;
        };
        // Names that begin with a star are made up by programs.
        if origin.blocks.iter().any(|b| !b.starts_with('*')) {
            continue;
        }
        let at = *places
            .entry(Arc::clone(&origin.layer))
            .or_insert(layers.len());
        match layers.get_mut(at) {
            Some(of_layer) => of_layer.parts.push(name.clone()),
            None => layers.push(Apart {
                layer: Arc::clone(&origin.layer),
                parts: vec![name.clone()],
            }),
        }
    }
    layers.retain(|l| l.parts.len() > 1);
    layers
}
