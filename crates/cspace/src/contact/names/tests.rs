//! Names against the triples that they stand for.

use std::collections::BTreeSet;

use super::super::Permutation;
use super::super::twist::Steps;
use super::*;

const SIZES: Sizes = Sizes {
    fixed_features: 3,
    fixed_joints: 4,
    moving_features: 5,
    moving_joints: 2,
};

/// Every end: its name, and that of the end below as permutations say.
fn all(carried: &Carried) -> Vec<(u32, u32)> {
    let (f, m) = (&carried.fixed_back, &carried.moving_back);
    let mut all = Vec::new();
    for j in 0..SIZES.fixed_joints {
        for b in 0..SIZES.moving_features {
            let below = SIZES.fixed_joint(f.joints[j as usize], m.features[b as usize]);
            all.push((SIZES.fixed_joint(j, b), below));
        }
    }
    for a in 0..SIZES.fixed_features {
        for j in 0..SIZES.moving_joints {
            let below = SIZES.moving_joint(f.features[a as usize], m.joints[j as usize]);
            all.push((SIZES.moving_joint(a, j), below));
        }
    }
    for a in 0..SIZES.fixed_features {
        for b in 0..SIZES.moving_features {
            let below = SIZES.vertices(f.features[a as usize], m.features[b as usize]);
            all.push((SIZES.vertices(a, b), below));
        }
    }
    all
}

fn carried() -> Carried {
    let fixed = Permutation {
        features: vec![2, 0, 1],
        joints: vec![1, 2, 3, 0],
    };
    let moving = Permutation {
        features: vec![3, 4, 0, 1, 2],
        joints: vec![1, 0],
    };
    Carried {
        steps: Steps::NONE,
        fixed: fixed.clone(),
        moving: moving.clone(),
        fixed_back: fixed,
        moving_back: moving,
    }
}

#[test]
fn every_end_has_a_name_of_its_own_and_vertices_come_last() {
    let names: Vec<u32> = all(&carried()).into_iter().map(|n| n.0).collect();
    let distinct: BTreeSet<u32> = names.iter().copied().collect();
    assert_eq!(distinct.len(), names.len());
    let vertices = (SIZES.fixed_features * SIZES.moving_features) as usize;
    let (others, last) = names.split_at(names.len() - vertices);
    assert!(others.iter().all(|&n| n < SIZES.first_vertex()));
    assert!(last.iter().all(|&n| n >= SIZES.first_vertex()));
}

#[test]
fn names_below_are_those_of_the_features_below() {
    for (name, below) in all(&carried()) {
        assert_eq!(SIZES.name_below(name, &carried()), below);
    }
}
