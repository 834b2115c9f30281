//! Distances, overlap, offsets and proofs of parts with layers.

use cspace::{Configuration, ContactSpace, Coordinates, Options, Part, Silent, Vertex};
use cspace_model::model::from_toml;
use cspace_model::{Mechanism, compute_anew};
use cspace_oracle::shapes::{annulus, random_part, scaled, square};
use cspace_plan::legs::Scene;
use cspace_plan::proof::prove;
use cspace_plan::ranges::{self, Held, Verdict};
use cspace_plan::{grown, shrunk};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::proof::python;

type Outline = Vec<Vec<Vertex>>;

fn loops(part: &Part) -> Outline {
    part.loops().iter().map(|l| l.vertices().to_vec()).collect()
}

fn stack(layers: &[(f64, f64, &Part)]) -> Part {
    let layer = |&(lo, hi, part): &(f64, f64, &Part)| (Some([lo, hi]), loops(part));
    Part::layered("stack", layers.iter().map(layer)).unwrap()
}

/// Distances and overlap of stacks are the least, and any, of those of the layers that meet.
#[test]
fn a_scene_is_that_of_the_layers_that_meet() {
    let mut met = [0; 2];
    for case in 0..40 {
        let rng = &mut ChaCha8Rng::seed_from_u64(case);
        let plain = |rng: &mut ChaCha8Rng| {
            let size = rng.random_range(0.3..1.0);
            scaled(&random_part(rng.random_range(0..1_000_000), 5, 0.5), size)
        };
        let [a, b, c, d] = [0; 4].map(|_| plain(rng));
        let first = stack(&[(0.0, 1.0, &a), (1.0, 3.0, &b)]);
        let second = stack(&[(0.5, 1.0, &c), (2.0, 4.0, &d)]);
        let scene = Scene::new(&first, &second, None);
        let layers = [Scene::new(&a, &c, None), Scene::new(&b, &d, None)];
        for _ in 0..40 {
            let [x, y] = [0; 2].map(|_| rng.random_range(-2.5..2.5));
            let at = [x, y, rng.random_range(0.0..6.0)];
            let overlap = layers.iter().any(|l| l.overlaps(at));
            assert_eq!(scene.overlaps(at), overlap);
            let depth = 1e-6;
            let deep = layers.iter().any(|l| l.overlaps_deeply(at, depth));
            assert_eq!(scene.overlaps_deeply(at, depth), deep);
            let least = layers
                .iter()
                .map(|l| l.clearance(at))
                .fold(f64::INFINITY, f64::min);
            assert_eq!(scene.clearance(at), least);
            met[usize::from(overlap)] += 1;
        }
    }
    assert!(met.iter().all(|&n| n > 150), "{met:?}");
}

/// A block is caged by the upper layer of a stack alone, and the proof holds only as long as the two are at one height.
#[test]
fn a_cage_at_one_height_is_proved() {
    let cage = stack(&[(0.0, 1.0, &square(0.5)), (1.0, 2.0, &annulus(4.0, 2.0))]);
    let block = stack(&[(1.0, 1.5, &square(1.0)), (5.0, 6.0, &square(9.0))]);
    let space = ContactSpace::compute(&cage, &block, &Options::default()).unwrap();
    let at = |x: f64| Configuration::new(x, 0.0, 0.0);
    let proof = prove(&space, at(0.0), at(9.0), None, &Silent).unwrap();
    assert_eq!(proof.check(), Ok(()));
    let text = serde_json::to_string(&proof).unwrap();
    let mut moved = cspace_check::read(text.as_bytes()).unwrap();
    assert_eq!(moved, proof);
    moved.moving.layers[0].z = Some([2.0, 2.5]);
    let error = moved.check().unwrap_err();
    assert!(error.contains("different heights"), "{error}");
    let told = |proof, name| python(proof, name).unwrap_or_default();
    assert!(told(&proof, "layers").is_empty() || told(&proof, "layers").starts_with("proved"));
    let other = told(&moved, "moved-layers");
    assert!(
        other.is_empty() || other.contains("different heights"),
        "{other}"
    );
    moved.moving.layers[0].loops = 7;
    assert!(moved.check().unwrap_err().contains("not as many loops"));
    let below = stack(&[(0.0, 1.0, &square(1.0))]);
    let space = ContactSpace::compute(&cage, &below, &Options::default()).unwrap();
    assert!(prove(&space, at(2.0), at(9.0), None, &Silent).is_err());
    let connected = cspace::PairSpace::Planar(space.into());
    let [from, to] = [2.0, 9.0].map(|x| Coordinates::Planar(at(x)));
    assert_eq!(connected.connected(from, to), Ok(true));
}

/// Every layer is grown and shrunk on its own, and one that vanishes is left out.
#[test]
fn layers_are_grown_and_shrunk_one_by_one() {
    let part = stack(&[(0.0, 1.0, &square(4.0)), (1.0, 2.0, &square(1.0))]);
    let more = grown(&part, 0.5).unwrap();
    let area = |p: &Part, i: usize| p.layer(i).area();
    let disc = 0.25 * core::f64::consts::PI;
    assert!((area(&more, 0) - (16.0 + 8.0 + disc)).abs() < 1e-9);
    assert!((area(&more, 1) - (1.0 + 2.0 + disc)).abs() < 1e-9);
    let less = shrunk(&part, 0.75).unwrap().unwrap();
    assert_eq!(less.layers().len(), 1);
    assert_eq!(less.layers()[0].z(), Some([0.0, 1.0]));
    assert!((less.area() - 6.25).abs() < 1e-9);
}

fn shipped(name: &str) -> Mechanism {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/layers");
    let text = std::fs::read_to_string(format!("{folder}/{name}")).unwrap();
    from_toml(&text, name).unwrap()
}

fn over_ranges(mechanism: &Mechanism, pair: [usize; 2]) -> Verdict {
    let parts = pair.map(|i| &mechanism.parts[i]);
    let pair = ranges::Pair::new(parts, [0.0, 0.0]).unwrap();
    pair.over_ranges(f64::INFINITY, &compute_anew(&Silent))
        .unwrap()
}

/// The round end of the handle, of radius 37.5 about (810, 67.5), meets the ledge, whose face is 70 from the axis at 240°.
#[test]
fn the_handle_of_a_gate_stops_it() {
    let gate = shipped("gate.toml");
    let Verdict::Touches(held) = over_ranges(&gate, [0, 1]) else {
        panic!("the handle meets the ledge");
    };
    let (x, y, r, face) = (810.0_f64, 67.5_f64, 37.5, 70.0);
    let short = y.atan2(x) - ((face - r) / x.hypot(y)).asin();
    let expected = 240f64.to_radians() - short;
    assert!((held.reach[1].hi - expected).abs() < 1e-9, "{held:?}");
    let [stop] = &held.stopped[..] else {
        panic!("{held:?}");
    };
    assert!(stop.is_declared && stop.part == 1);
}

/// Both meshes of the train are one mesh, and the wheels that overlap as seen from above are no pair.
#[test]
fn a_compound_train_meshes_twice() {
    let train = shipped("compound_train.toml");
    let mesh = |pair| match over_ranges(&train, pair) {
        Verdict::Touches(Held {
            ratio: Some(ratio),
            backlash: Some(backlash),
            ..
        }) => (ratio, [backlash.least, backlash.most]),
        other => panic!("{other:?}"),
    };
    let (first, second) = (mesh([0, 1]), mesh([1, 2]));
    assert_eq!((first.0, second.0), ((-6, 5), (-6, 5)));
    for (a, b) in first.1.into_iter().zip(second.1) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    let pairs = ranges::Pairs::of(&train).near(f64::INFINITY);
    assert_eq!(pairs, [[0, 1], [1, 2]]);
}
