//! Files of `tests/regression`: what went wrong once.

#![allow(clippy::unwrap_used)]

use cspace::{Classification, Configuration, ContactSpace, Options, Part, Slicer};
use cspace_io::Model;

/// The two parts of a file of this project.
fn parts(file: &str) -> [Part; 2] {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let model = Model::read(format!("{folder}/{file}")).unwrap();
    [0, 1].map(|i| model.parts[i].part.clone())
}

/// An arc just fits a fillet, and what follows it smoothly does not: the contact curve of the two is a point.
#[test]
fn equal_radii_in_a_fillet() {
    let [fixed, moving] = parts("tests/regression/equal_radii_in_a_fillet.toml");
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

/// Orientations some roundings beside a critical one: patches that end there and that begin there are turns apart.
#[test]
fn disc_in_loose_hole_at_critical_orientations() {
    let [fixed, moving] = parts("tests/regression/disc_in_loose_hole.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = space.classifier();
    let quarter = core::f64::consts::FRAC_PI_2;
    let orientations = (-2..=2).flat_map(|k| {
        let theta = quarter * f64::from(k);
        (-5..=5).map(move |ulps| theta + f64::from(ulps) * f64::EPSILON)
    });
    for theta in orientations {
        for k in 0..400 {
            let (x, y) = (
                0.45 * f64::from(k % 20) - 4.3,
                0.45 * f64::from(k / 20) - 4.3,
            );
            // In the hole, or beyond the plate; the grid has no contacts.
            let expected = if x.hypot(y) < 0.5 {
                Classification::Free
            } else {
                Classification::Blocked
            };
            let at = Configuration { x, y, theta };
            assert_eq!(space.classify(at), Some(expected), "{at:?}");
            assert_eq!(classifier.classify(at), Some(expected), "{at:?}");
        }
    }
}

#[test]
fn rounded_peg_between_bars() {
    let [fixed, moving] = parts("tests/regression/rounded_peg_between_bars.json");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    for x in [0.0, 5.0] {
        let at = Configuration {
            x,
            y: 0.0,
            theta: 0.0,
        };
        assert_eq!(space.classify(at), Some(Classification::Free), "{at:?}");
    }
}

#[test]
fn windows_that_end_at_a_critical_orientation() {
    let [fixed, moving] = parts("models/paper/cam.toml");
    let hi = 30f64.to_radians();
    let options = Options {
        window: Some((0.0, hi)),
        ..Options::default()
    };
    let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
    let slice = Slicer::new(&fixed, &moving).slice(hi);
    assert_eq!(space.slice(hi).loops.len(), slice.loops.len());
}

/// No disc is found in so thin a ring; the disc that goes into it has one all the same.
#[test]
fn thin_ring() {
    let [ring, disc] = parts("tests/regression/thin_ring.toml");
    for (fixed, moving) in [(&ring, &disc), (&disc, &ring)] {
        let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
        let slicer = Slicer::new(fixed, moving);
        for k in 0..40 {
            let x = 0.05 * f64::from(k);
            let expected = if (0.25..1.2504).contains(&x) {
                Classification::Blocked
            } else {
                Classification::Free
            };
            if (x - 0.25).abs() < 1e-9 {
                continue;
            }
            let at = Configuration {
                x,
                y: 0.0,
                theta: 0.3,
            };
            assert_eq!(space.classify(at), Some(expected), "{at:?}");
            let free = slicer.slice(at.theta).is_free(at.position());
            assert_eq!(free, expected == Classification::Free, "{at:?}");
        }
    }
}

#[test]
fn disc_on_steps() {
    let [steps, disc] = parts("tests/regression/disc_on_steps.toml");
    for (fixed, moving) in [(&steps, &disc), (&disc, &steps)] {
        let space = ContactSpace::compute(fixed, moving, &Options::default()).unwrap();
        assert_eq!(space.statistics().conflicts, 0);
        let slicer = Slicer::new(fixed, moving);
        for band in space.bands() {
            let theta = 0.5 * (band.lo + band.hi);
            let (read, made) = (space.slice(theta), slicer.slice(theta));
            assert_eq!(read.loops.len(), 1, "{theta}");
            assert!(read.curves.iter().all(|c| c.next != u32::MAX), "{theta}");
            assert_eq!(read.curves.len(), made.curves.len(), "{theta}");
        }
    }
}

#[test]
fn pieces_in_line() {
    let [fixed, moving] = parts("tests/regression/pieces_in_line.toml");
    let space = ContactSpace::compute(&fixed, &moving, &Options::default()).unwrap();
    let classifier = space.classifier();
    // At -30 deg itself, where the order of the curves is not known.
    let theta = -core::f64::consts::FRAC_PI_6;
    for (x, y) in [
        (0.843_607_230_109_343_5, 1.874_950_606_564_892_2),
        (0.624_506_065_648_925_6, 1.922_356_679_531_538_3),
    ] {
        let at = Configuration { x, y, theta };
        assert_eq!(space.classify(at), Some(Classification::Blocked), "{at:?}");
        let blocked = classifier.classify(at);
        assert_eq!(blocked, Some(Classification::Blocked), "{at:?}");
    }
}
