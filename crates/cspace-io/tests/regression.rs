//! Files of `tests/regression`: what went wrong once.

#![allow(clippy::unwrap_used)]

use cspace::{ContactSpace, Options, Slicer};
use cspace_io::Model;

/// An arc just fits a fillet, and what follows it smoothly does not: the contact curve of the two is a point.
#[test]
fn equal_radii_in_a_fillet() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/regression");
    let model = Model::read(format!("{folder}/equal_radii_in_a_fillet.toml")).unwrap();
    let [fixed, moving] = [0, 1].map(|i| model.parts[i].part.clone());
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let slicer = Slicer::new(&fixed, &moving);
    for band in space.bands() {
        let theta = 0.5 * (band.lo + band.hi);
        for slice in [space.slice(theta), slicer.slice(theta)] {
            assert!(!slice.loops.is_empty(), "{band:?}");
        }
    }
    assert_eq!(space.statistics().conflicts, 0);
}
