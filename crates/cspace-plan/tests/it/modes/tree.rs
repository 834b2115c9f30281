//! Modes of parts whose contacts make a tree: beside the method for three parts, and beside grids that are flooded.

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::{Axis, AxisMotion, Classification, Part, Point, Vector};
use cspace_model::{Mechanism, PairEntry, PartEntry};
use cspace_oracle::effort;
use cspace_plan::modes::{ModePlace, Modes, ModesError, TreeModes};

use super::flood::{Dice, axis, star, stars};

fn pair(fixed: usize, moving: usize) -> PairEntry {
    PairEntry {
        fixed,
        moving,
        window: None,
    }
}

/// Three parts without one of their pairs, which makes a path: both methods have an answer.
#[test]
fn three_parts_have_the_modes_of_the_other_method() {
    let (mut several, mut around) = (0, 0);
    for seed in 100..effort(116, 300) {
        for missing in 0..3 {
            let mut mechanism = stars(seed);
            mechanism.pairs.remove(missing);
            let three = Modes::compute(&mechanism, [0, 1, 2]).unwrap();
            let tree = TreeModes::compute(&mechanism, &[0, 1, 2]).unwrap();
            assert_eq!((three.doubts(), tree.doubts()), (0, 0));
            let (a, b) = (three.list(), tree.list());
            assert_eq!(a.len(), b.len(), "{seed} {missing}: {a:?} {b:?}");
            several += usize::from(a.len() > 1);
            for mode in a {
                let Ok(ModePlace::Mode(k)) = tree.locate(&mode.sample) else {
                    panic!("{seed} {missing} {mode:?}");
                };
                let back = three.locate([0, 1, 2].map(|i| b[k].sample[i])).unwrap();
                assert_eq!(back, three.locate(mode.sample).unwrap());
                let turns: Vec<Vec<i64>> = mode.turns.iter().map(|t| t.to_vec()).collect();
                assert_eq!(turns, b[k].turns, "{seed} {missing} {k}");
                around += usize::from(!turns.is_empty());
                for i in 0..3 {
                    let ((lo, hi), (from, to)) = (mode.ranges[i], b[k].ranges[i]);
                    assert!(
                        (lo - from).abs() < 1e-7 && (hi - to).abs() < 1e-7,
                        "{seed} {missing} {k} {i}: {mode:?} {:?}",
                        b[k]
                    );
                    assert_eq!(mode.open[i], b[k].open[i]);
                }
            }
        }
    }
    assert!(several > 10 && around > 10, "{several} {around}");
}

/// Stars near each other as a tree: each but the first touches one that is earlier.
fn tree(seed: u64, n: usize, deep: bool) -> Mechanism {
    let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let mut mechanism = Mechanism::new("tree");
    let mut at = vec![(0.0, 0.0)];
    for k in 0..n {
        let on = if k > 1 && deep {
            (dice.roll() * k as f64) as usize
        } else {
            0
        };
        if k > 0 {
            let angle = dice.between(0.0, TAU);
            let (x, y) = at[on];
            let away = dice.between(3.0, 4.2);
            at.push((x + away * angle.cos(), y + away * angle.sin()));
            mechanism.pairs.push(pair(on, k));
        }
        let points = 2 + (dice.roll() * 3.0) as u32;
        let name = format!("part {k}");
        let part = star(&mut dice, &name, at[k], points, 0.9, 2.3);
        let kind = (dice.roll() * 4.0) as u32;
        let axis = axis(&mut dice, kind, at[k]);
        mechanism.parts.push(PartEntry::on(part, axis));
    }
    mechanism
}

/// Free configurations on a grid: in how many components they are, and in how many modes. Panics if a step that is free by the pairs'
/// spaces leads from one mode to another.
fn flooded(modes: &TreeModes, n: usize) -> (usize, usize) {
    let axes = modes.axes();
    let along: Vec<(f64, f64, bool)> = (axes.iter().enumerate())
        .map(|(k, axis)| {
            let circle = matches!(axis.motion, AxisMotion::Revolute { .. }) && axis.range.is_none();
            let offset = 0.237 + 0.031 * k as f64;
            let (lo, hi) = axis
                .range
                .unwrap_or(if circle { (-PI, PI) } else { (-8.0, 8.0) });
            let step = (hi - lo) / n as f64;
            (lo + offset * step, step, circle)
        })
        .collect();
    let d = along.len();
    let all = n.pow(d as u32);
    let place = |k: usize, i: usize| along[k].0 + along[k].1 * i as f64;
    let index = |number: usize, k: usize| number / n.pow(k as u32) % n;
    // What is free of each pair, and what of its steps along its first and its second coordinate.
    let tables: Vec<([usize; 2], Vec<[bool; 3]>)> = (modes.pairs().iter())
        .map(|pair| {
            let space = pair.space.as_ref().unwrap();
            let [a, b] = pair.coordinates;
            let step = |at: (f64, f64), rates: (f64, f64)| {
                let outcome = space.first_contact(at, rates, 1.0);
                matches!(outcome, Ok(AxesMotionOutcome::Free))
            };
            let fields = (0..n * n).map(|f| {
                let at = (place(a, f / n), place(b, f % n));
                let free = space.classify(at.0, at.1) == Some(Classification::Free);
                [
                    free,
                    free && step(at, (along[a].1, 0.0)),
                    free && step(at, (0.0, along[b].1)),
                ]
            });
            ([a, b], fields.collect())
        })
        .collect();
    let mode: Vec<Option<usize>> = (0..all)
        .map(|number| {
            let free = |(c, t): &([usize; 2], Vec<[bool; 3]>)| {
                t[index(number, c[0]) * n + index(number, c[1])][0]
            };
            if !tables.iter().all(free) {
                return None;
            }
            let at: Vec<f64> = (0..d).map(|k| place(k, index(number, k))).collect();
            match modes.locate(&at) {
                Ok(ModePlace::Mode(mode)) => Some(mode),
                other => panic!("{at:?} is free and {other:?}"),
            }
        })
        .collect();
    let mut above: Vec<usize> = (0..all).collect();
    fn root(above: &mut [usize], mut i: usize) -> usize {
        while above[i] != i {
            above[i] = above[above[i]];
            i = above[i];
        }
        i
    }
    for number in 0..all {
        let Some(own) = mode[number] else { continue };
        for (k, extent) in along.iter().enumerate() {
            let (i, unit) = (index(number, k), n.pow(k as u32));
            if i + 1 == n && !extent.2 {
                continue;
            }
            let next = number - i * unit + (i + 1) % n * unit;
            let passes = tables.iter().all(|([a, b], t)| {
                let field = &t[index(number, *a) * n + index(number, *b)];
                (k != *a || field[1]) && (k != *b || field[2])
            });
            if let (Some(other), true) = (mode[next], passes) {
                assert_eq!(own, other, "{number} goes on along {k}");
                let (a, b) = (root(&mut above, number), root(&mut above, next));
                above[a] = b;
            }
        }
    }
    let mut met = vec![false; modes.list().len()];
    let mut components = 0;
    for (number, own) in mode.iter().enumerate() {
        if let Some(own) = *own {
            met[own] = true;
            components += usize::from(root(&mut above, number) == number);
        }
    }
    (components, met.into_iter().filter(|m| *m).count())
}

#[test]
fn what_a_free_step_joins_is_one_mode_of_a_tree() {
    let (mut all, mut exact, mut several) = (0, 0, 0);
    for seed in 0..effort(3, 60) {
        for (n, deep, grid) in [(4, false, 22), (4, true, 22), (5, false, 12), (5, true, 12)] {
            let mechanism = tree(seed, n, deep);
            let parts: Vec<usize> = (0..n).collect();
            let modes = TreeModes::compute(&mechanism, &parts).unwrap();
            if modes.doubts() > 0 {
                continue;
            }
            let (components, met) = flooded(&modes, grid);
            assert!(components >= met && met <= modes.list().len());
            for (k, mode) in modes.list().iter().enumerate() {
                let place = modes.locate(&mode.sample);
                assert_eq!(place, Ok(ModePlace::Mode(k)), "{seed} {n} {deep} {mode:?}");
            }
            all += 1;
            exact += usize::from(components == modes.list().len());
            several += usize::from(met > 1);
        }
    }
    assert!(
        4 * exact >= all && several > 0,
        "{exact} of {all}, {several}"
    );
}

/// Parts in another order hang on each other in another way where as many touch several of them, and have the same modes.
#[test]
fn the_order_of_the_parts_of_a_tree_does_not_matter() {
    let (mut other, mut several) = (0, 0);
    for seed in 200..effort(212, 300) {
        for n in [2, 4, 5] {
            let mechanism = tree(seed, n, true);
            let modes = |parts: &[usize]| TreeModes::compute(&mechanism, parts).unwrap();
            let parts: Vec<usize> = (0..n).collect();
            let back: Vec<usize> = parts.iter().rev().copied().collect();
            let (a, b) = (modes(&parts), modes(&back));
            assert_eq!(a.list().len(), b.list().len(), "{seed} {n}");
            other += usize::from(a.hub() + b.hub() + 1 != n);
            several += usize::from(a.list().len() > 1);
            for mode in a.list() {
                let at: Vec<f64> = mode.sample.iter().rev().copied().collect();
                let Ok(ModePlace::Mode(k)) = b.locate(&at) else {
                    panic!("{seed} {n} {mode:?}");
                };
                let same = &b.list()[k];
                for i in 0..n {
                    let ((lo, hi), (from, to)) = (mode.ranges[i], same.ranges[n - 1 - i]);
                    assert!(
                        (lo - from).abs() < 1e-7 && (hi - to).abs() < 1e-7,
                        "{seed} {n} {i}: {mode:?} {same:?}"
                    );
                    assert_eq!(mode.around(i), same.around(n - 1 - i));
                }
                assert_eq!(mode.turns.len(), same.turns.len());
            }
        }
    }
    assert!(other > 5 && several > 10, "{other} {several}");
}

/// An eccentric cam with followers all around it, each of which slides towards it.
fn cam(followers: usize, least: f64) -> Mechanism {
    let mut mechanism = Mechanism::new("cam");
    let disc = Part::circle("cam", (2.0, 0.0), 6.0).unwrap();
    mechanism
        .parts
        .push(PartEntry::on(disc, Axis::revolute(Point::new(0.0, 0.0))));
    for k in 0..followers {
        let angle = TAU * k as f64 / followers as f64;
        let (sin, cos) = angle.sin_cos();
        let corner =
            |along: f64, across: f64| (along * cos - across * sin, along * sin + across * cos);
        let points = [
            corner(6.0, -0.5),
            corner(12.0, -0.5),
            corner(12.0, 0.5),
            corner(6.0, 0.5),
        ];
        let part = Part::polygon(format!("follower {k}"), &points).unwrap();
        let axis = Axis::prismatic(Vector::new(cos, sin)).within(-3.0, least);
        mechanism.parts.push(PartEntry::on(part, axis));
        mechanism.pairs.push(pair(0, k + 1));
    }
    mechanism
}

/// The disc is 8 from the axis where it is farthest: a follower that gives way by 2 lets it turn.
#[test]
fn a_cam_turns_if_all_its_followers_give_way() {
    for followers in 1..=8 {
        let parts: Vec<usize> = (0..=followers).collect();
        let modes = |most: f64| TreeModes::compute(&cam(followers, most), &parts).unwrap();
        let (stuck, turns) = (modes(1.99), modes(2.1));
        assert!(!stuck.list().iter().any(|m| m.around(0)), "{followers}");
        assert_eq!(stuck.list().len(), followers, "{followers}");
        assert_eq!(turns.list().len(), 1, "{followers}");
        assert!(turns.list()[0].around(0));
        assert_eq!(turns.list()[0].turns[0][0], 1);
    }
}

#[test]
fn a_cycle_is_told_with_its_parts() {
    let mut mechanism = cam(3, 2.1);
    let all: Vec<usize> = (0..4).collect();
    assert!(TreeModes::compute(&mechanism, &all).is_ok());
    // A ring of four discs, each of which touches the next.
    mechanism.parts.clear();
    mechanism.pairs.clear();
    let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)];
    for (k, at) in corners.into_iter().enumerate() {
        let disc = Part::circle(format!("disc {k}"), at, 1.0).unwrap();
        let along = Vector::new((k + 1) as f64 % 2.0, k as f64 % 2.0);
        let axis = Axis::prismatic(along).within(-3.0, 3.0);
        mechanism.parts.push(PartEntry::on(disc, axis));
        mechanism.pairs.push(pair(k, (k + 1) % 4));
    }
    let error = TreeModes::compute(&mechanism, &all).err();
    let Some(ModesError::Cycle { parts }) = error else {
        panic!("{error:?}");
    };
    let around: Vec<char> = parts.iter().filter_map(|p| p.chars().last()).collect();
    assert_eq!(around.len(), 4, "{parts:?}");
}
