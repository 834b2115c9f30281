//! Names of parts.

use std::collections::{HashMap, HashSet};

use crate::drawing::{Drawing, Origin};
use crate::fit::Outline;

/// A part is called as the block that all of its outer loop is in, the layer, or the drawing; with a number where
/// several are called the same.
pub(super) fn names(
    drawing: &Drawing,
    one_part: Option<&str>,
    outlines: &[Outline],
    groups: &[Vec<usize>],
) -> Vec<String> {
    if let Some(name) = one_part {
        return vec![name.to_owned(); groups.len()];
    }
    let plain: Vec<String> = groups
        .iter()
        .map(|g| name(drawing, &outlines[g[0]]))
        .collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    for name in &plain {
        *counts.entry(name).or_default() += 1;
    }
    let mut taken: HashSet<String> = (counts.iter())
        .filter(|(_, n)| **n == 1)
        .map(|(name, _)| (*name).to_owned())
        .collect();
    let mut next: HashMap<&str, usize> = HashMap::new();
    (plain.iter())
        .map(|name| {
            if counts[name.as_str()] == 1 {
                return name.clone();
            }
            let number = next.entry(name).or_insert(0);
            loop {
                *number += 1;
                let numbered = format!("{name} {number}");
                if taken.insert(numbered.clone()) {
                    return numbered;
                }
            }
        })
        .collect()
}

fn name(drawing: &Drawing, outline: &Outline) -> String {
    let origins: Vec<&Origin> = (outline.entities.iter())
        .map(|&e| &drawing.entities[e as usize].origin)
        .collect();
    let Some((first, rest)) = origins.split_first() else {
        return drawing.name.clone();
    };
    let shared = |o: &Origin| {
        (first.blocks.iter().zip(o.blocks.iter()))
            .take_while(|(a, b)| a == b)
            .count()
    };
    let depth = rest
        .iter()
        .map(|o| shared(o))
        .min()
        .unwrap_or(first.blocks.len());
    // Names that begin with a star are made up by programs.
    let block = first.blocks[..depth]
        .iter()
        .rev()
        .find(|b| !b.starts_with('*'));
    let layer = (rest.iter().all(|o| o.layer == first.layer))
        .then_some(&first.layer)
        .filter(|l| !l.is_empty() && &***l != "0");
    let name = block.or(layer).map_or(drawing.name.as_str(), |n| n);
    // Model files have no control characters in names.
    let name: String = name.chars().filter(|c| !c.is_control()).collect();
    if name.trim().is_empty() {
        "part".to_owned()
    } else {
        name
    }
}
