//! Contact that does not depend on y, such as a tooth against a stop: vertical pieces.

use core::f64::consts::TAU;

use super::build::{Builder, SectionEnd};
use super::piece::{End, Name, Node, Pair, Piece};
use super::place::{decide, margin};

impl Builder<'_> {
    /// Adds the contact of a pair whose condition does not depend on y.
    pub(super) fn add_verticals(&mut self, rep: &Pair, nodes: &[Node]) {
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
            let mut section_ends: Vec<SectionEnd> = nodes
                .iter()
                .filter(|s| {
                    let rises = swapped.gradient(s.y, s.x).1 > 0.0;
                    rises == (root == 0)
                })
                .map(|s| SectionEnd::at_node(s, x, (at, copy)))
                .collect();
            section_ends.sort_by(|a, b| a.y.total_cmp(&b.y).then(a.name.cmp(&b.name)));
            let repeats = scene.y.repeats();
            let (lo, hi) = scene.y.first_turn();
            let name = if repeats {
                Name::Same(0, 2 + u32::from(root))
            } else {
                Name::Limit
            };
            section_ends.insert(0, SectionEnd::between(x, (at, copy), lo, name));
            section_ends.push(SectionEnd::between(x, (at, copy), hi, name));
            let n = section_ends.len() - 1;
            let margins: Vec<f64> = (0..n)
                .map(|i| {
                    margin(
                        scene,
                        rep,
                        x,
                        0.5 * (section_ends[i].y + section_ends[i + 1].y),
                    )
                })
                .collect();
            let verdicts = decide(&margins, |i| section_ends[i].ends);
            for i in 0..n {
                if !verdicts[i] {
                    continue;
                }
                let (before, pair) = self.instance(rep, copy);
                for turn in 0..scene.x.turns() {
                    let end = |of: &SectionEnd| {
                        let closing = repeats && of.y == hi && !of.ends;
                        End {
                            key: of.key(pair, turn),
                            x: at + TAU * f64::from(turn),
                            base: if closing { lo } else { of.y },
                            turns: i32::from(closing),
                        }
                    };
                    let piece = Piece {
                        pair,
                        root,
                        vertical: true,
                        turns: 0,
                        start: end(&section_ends[i]),
                        end: end(&section_ends[i + 1]),
                    };
                    self.in_each_turn(piece);
                }
                self.keep_instance(before, copy);
            }
        }
    }
}
