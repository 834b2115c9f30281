//! Paths, judged by distances and by brute force.

use cspace::Coordinates;
use cspace_oracle::{Oracle, effort};
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, Path, check};

/// Places at which brute force follows a path.
pub(crate) fn places() -> usize {
    effort(1_000, 10_000)
}

/// A path is free by the least distances along its legs, and at so many places by brute force.
pub(crate) fn is_free(scene: &Scene, oracle: &Oracle, path: &Path, places: usize, name: &str) {
    let scene = &scene.clone().with_about(path.about);
    let path = &path.configurations;
    let checked = check(scene, path).unwrap();
    let Checked::Free(narrow) = checked else {
        panic!("{name}: {checked:?}");
    };
    assert!(narrow.clearance >= 0.0, "{name}: {narrow:?}");
    let each = places / path.len().max(2) + 1;
    for leg in path.windows(2) {
        let [from, to] = [leg[0], leg[1]].map(|c| scene.numbers(c).unwrap());
        for i in 0..=each {
            let t = i as f64 / each as f64;
            let numbers = core::array::from_fn(|k| from[k] + (to[k] - from[k]) * t);
            let Coordinates::Planar(c) = scene.coordinates(numbers) else {
                unreachable!("a planar pair")
            };
            let judged = oracle.judge(c);
            assert!(!judged.overlap, "{name}: {c:?} {judged:?}");
        }
    }
}
