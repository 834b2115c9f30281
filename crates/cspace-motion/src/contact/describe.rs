//! Contacts and limits by name.

use crate::pairs::Pairs;
use crate::record::{End, What};
use crate::system::System;

use super::bound::Bound;

pub(crate) fn named(system: &System, pairs: &Pairs, bound: &Bound) -> What {
    let name = |i: usize| system.mechanism().parts[i].part.name().to_owned();
    match bound {
        Bound::Contact(touch) => {
            let pair = &pairs.list()[touch.pair];
            let (f, m) = touch.features;
            let features = [
                pair.space.fixed().feature_text(f.name),
                pair.space.moving().feature_text(m.name),
            ];
            What::Contact {
                fixed: name(pair.fixed),
                moving: name(pair.moving),
                features,
            }
        }
        Bound::Brake { part, .. } => What::Part { part: name(*part) },
        Bound::Limit { part, upper } => What::Limit {
            part: name(*part),
            limit: if *upper { End::Upper } else { End::Lower },
        },
    }
}
