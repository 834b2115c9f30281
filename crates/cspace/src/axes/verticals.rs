//! Contact that does not depend on y, such as a tooth against a stop: vertical pieces.

use core::f64::consts::TAU;

use super::build::{Builder, Cut};
use super::extents::{decide, margin};
use super::names::{Name, Spot};
use super::piece::{End, Pair, Piece};

impl Builder<'_> {
    /// Adds the contact of a pair whose condition does not depend on y.
    pub(super) fn add_verticals(&mut self, rep: &Pair, spots: &[Spot]) {
        let scene = self.scene;
        let swapped = rep.condition.swapped();
        if swapped.is_vertical() {
            return;
        }
        for root in [0u8, 1] {
            if !swapped.exists(0.0, root) {
                continue;
            }
            let x = scene.x.reduced(swapped.y(0.0, root));
            if !(scene.x.lo..=scene.x.hi).contains(&x) && !scene.x.repeats() {
                continue;
            }
            let (at, copy) = scene.repeats.split(&scene.x, x);
            let mut cuts: Vec<Cut> = spots
                .iter()
                .filter(|s| {
                    let rises = swapped.gradient(s.y, s.x).1 > 0.0;
                    rises == (root == 0)
                })
                .map(|s| Cut {
                    x,
                    at,
                    copy,
                    y: s.y,
                    name: s.name,
                    root: s.root,
                    ends: true,
                    x_turn: 0,
                })
                .collect();
            cuts.sort_by(|a, b| a.y.total_cmp(&b.y).then(a.name.cmp(&b.name)));
            let repeats = scene.y.repeats();
            let (lo, hi) = if repeats {
                (scene.y.lo, scene.y.lo + TAU)
            } else {
                (scene.y.lo, scene.y.hi)
            };
            let end = |y: f64| Cut {
                x,
                at,
                copy,
                y,
                name: if repeats {
                    Name::Same(0, 2 + u32::from(root))
                } else {
                    Name::Limit
                },
                root: 0,
                ends: false,
                x_turn: 0,
            };
            cuts.insert(0, end(lo));
            cuts.push(end(hi));
            let n = cuts.len() - 1;
            let margins: Vec<f64> = (0..n)
                .map(|i| margin(scene, rep, x, 0.5 * (cuts[i].y + cuts[i + 1].y)))
                .collect();
            let verdicts = decide(&margins, |i| cuts[i].ends);
            for i in 0..n {
                if !verdicts[i] {
                    continue;
                }
                let (before, pair) = self.instance(rep, copy);
                for turn in 0..scene.x.turns() {
                    let end = |cut: &Cut| {
                        let closing = repeats && cut.y == hi && !cut.ends;
                        End {
                            key: cut.key(pair, turn),
                            x: at + TAU * f64::from(turn),
                            base: if closing { lo } else { cut.y },
                            turns: i32::from(closing),
                        }
                    };
                    let piece = Piece {
                        pair,
                        root,
                        vertical: true,
                        turns: 0,
                        start: end(&cuts[i]),
                        end: end(&cuts[i + 1]),
                    };
                    self.in_each_turn(piece);
                }
                self.keep_instance(before, copy);
            }
        }
    }
}
