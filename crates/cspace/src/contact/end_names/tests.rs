//! Names compared with the triples that they represent.

use std::collections::BTreeSet;

use super::super::Permutation;
use super::super::symmetry::Steps;
use super::*;

const NAMES: EndNames = EndNames {
    fixed_features: 3,
    fixed_joints: 4,
    moving_features: 5,
    moving_joints: 2,
};

/// Every end: its name, and that of the end below as permutations say.
fn all(period: &Period) -> Vec<(u32, u32)> {
    let (f, m) = (&period.fixed_back, &period.moving_back);
    let mut all = Vec::new();
    for j in 0..NAMES.fixed_joints {
        for b in 0..NAMES.moving_features {
            let below = NAMES.fixed_joint(f.joints[j as usize], m.features[b as usize]);
            all.push((NAMES.fixed_joint(j, b), below));
        }
    }
    for a in 0..NAMES.fixed_features {
        for j in 0..NAMES.moving_joints {
            let below = NAMES.moving_joint(f.features[a as usize], m.joints[j as usize]);
            all.push((NAMES.moving_joint(a, j), below));
        }
    }
    for a in 0..NAMES.fixed_features {
        for b in 0..NAMES.moving_features {
            let below = NAMES.vertices(f.features[a as usize], m.features[b as usize]);
            all.push((NAMES.vertices(a, b), below));
        }
    }
    all
}

fn period() -> Period {
    let fixed = Permutation {
        features: vec![2, 0, 1],
        joints: vec![1, 2, 3, 0],
    };
    let moving = Permutation {
        features: vec![3, 4, 0, 1, 2],
        joints: vec![1, 0],
    };
    Period {
        steps: Steps::NONE,
        fixed: fixed.clone(),
        moving: moving.clone(),
        fixed_back: fixed,
        moving_back: moving,
    }
}

#[test]
fn every_end_has_a_name_of_its_own_and_vertices_come_last() {
    let names: Vec<u32> = all(&period()).into_iter().map(|n| n.0).collect();
    let distinct: BTreeSet<u32> = names.iter().copied().collect();
    assert_eq!(distinct.len(), names.len());
    let vertices = (NAMES.fixed_features * NAMES.moving_features) as usize;
    let (others, last) = names.split_at(names.len() - vertices);
    assert!(others.iter().all(|&n| n < NAMES.first_vertex()));
    assert!(last.iter().all(|&n| n >= NAMES.first_vertex()));
}

#[test]
fn names_below_are_those_of_the_features_below() {
    for (name, below) in all(&period()) {
        assert_eq!(NAMES.name_below(name, &period()), below);
    }
}
