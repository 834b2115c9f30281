//! Cuts contact curves into sections that are monotone graphs y(x).

use super::build::{Builder, SectionEnd};
use super::condition::Condition;
use super::motion::brought_between;
use super::piece::{End, Name, Node, Pair, Piece};
use super::place::{decide, margin};
use super::tolerance::SHORT;
use core::f64::consts::TAU;

/// Distance by which rounding may put a node beyond a turning (radians or length).
const BEYOND: f64 = 1e-9;

/// A place at which y has an extremum.
#[derive(Debug, Clone, Copy)]
struct Around {
    x: f64,
    y: f64,
    index: u32,
}

impl Builder<'_> {
    /// Adds the contact of a pair whose condition depends on y.
    pub(super) fn add_graphs(&mut self, rep: &Pair, nodes: &[Node]) {
        let condition = rep.condition;
        let scene = self.scene;
        let (lo, hi) = scene.x.first_turn();
        // Places at which roots appear and disappear.
        let mut breaks = core::mem::take(&mut self.breaks);
        breaks.clear();
        condition.turnings(|x| {
            let x = scene.x.reduced(x);
            if lo < x && x < hi {
                breaks.push(x);
            }
        });
        breaks.sort_by(f64::total_cmp);
        let mut around: Option<Vec<Around>> = None;
        let ends = breaks.len() + 1;
        let interval = |k: usize| {
            let from = if k == 0 { lo } else { breaks[k - 1] };
            let to = if k + 1 == ends { hi } else { breaks[k] };
            (from, to)
        };
        let exists = |k: usize, root: u8| {
            let (from, to) = interval(k);
            condition.exists(0.5 * (from + to), root)
        };
        let mut marks: Vec<(f64, Option<&Node>)> = Vec::new();
        for i in 0..ends {
            let (from, to) = interval(i);
            if from >= to {
                continue;
            }
            for root in [0, 1] {
                if !exists(i, root) {
                    continue;
                }
                let rises = |x: f64, y: f64| condition.gradient(x, y).1 > 0.0;
                // Nodes on this root; rounding may have put one just beyond a turning.
                let below = i > 0 && !exists(i - 1, root);
                let above = i + 1 < ends && !exists(i + 1, root);
                marks.clear();
                for s in nodes {
                    let reach = (
                        if below { from - BEYOND } else { from },
                        if above { to + BEYOND } else { to },
                    );
                    if reach.0 <= s.x && s.x <= reach.1 && rises(s.x, s.y) == (root == 0) {
                        marks.push((brought_between(s.x, from, to), Some(s)));
                    }
                }
                marks.sort_by(|(x, s), (y, t)| {
                    let name = |s: &Option<&Node>| s.map(|s| (s.name, s.root));
                    x.total_cmp(y).then(name(s).cmp(&name(t)))
                });
                marks.insert(0, (from, None));
                marks.push((to, None));
                // A short section without neighbours is also tested.
                let alone = marks.len() == 2;
                let margins = |m: &[(f64, Option<&Node>)]| {
                    if m[1].0 - m[0].0 < SHORT && !alone {
                        return 0.0;
                    }
                    let x = 0.5 * (m[0].0 + m[1].0);
                    margin(scene, rep, x, condition.y(x, root))
                };
                let margins: Vec<f64> = marks.windows(2).map(margins).collect();
                let verdicts = decide(&margins, |k| marks[k].1.is_some());
                if !verdicts.contains(&true) {
                    continue;
                }
                let around = around.get_or_insert_with(|| self.around(&condition));
                let end_at = |k: usize| -> SectionEnd {
                    if let (x, Some(s)) = marks[k] {
                        return SectionEnd::at_node(s, x, (s.in_window, s.copy));
                    }
                    let last = k > 0;
                    let breaking = if last {
                        (i + 1 < ends).then_some(i)
                    } else {
                        i.checked_sub(1)
                    };
                    self.open_end(rep, root, marks[k].0, breaking, last)
                };
                let kept: Vec<(SectionEnd, SectionEnd)> = (0..verdicts.len())
                    .filter(|&k| verdicts[k])
                    .map(|k| (end_at(k), end_at(k + 1)))
                    .collect();
                for (start, end) in kept {
                    let mut from = start;
                    for a in around.iter() {
                        let inside = start.x < a.x && a.x < end.x;
                        if inside && rises(a.x, a.y) == (root == 0) {
                            let at = scene.repeats.split(&scene.x, a.x);
                            let name = Name::Same(0, a.index);
                            let to = SectionEnd {
                                root,
                                ..SectionEnd::between(a.x, at, a.y, name)
                            };
                            self.section(rep, root, &from, &to);
                            from = to;
                        }
                    }
                    self.section(rep, root, &from, &end);
                }
            }
        }
        self.breaks = breaks;
    }

    /// Extrema of y on the curves of a condition, by x.
    fn around(&self, condition: &Condition) -> Vec<Around> {
        let scene = self.scene;
        let mut around = Vec::new();
        let swapped = condition.swapped();
        if !swapped.is_vertical() {
            swapped.turnings(|y| {
                let x = scene.x.reduced(swapped.double_y(y));
                if x.is_finite() {
                    around.push(Around {
                        x,
                        y: scene.y.reduced(y),
                        index: 8 + around.len() as u32,
                    });
                }
            });
        }
        around.sort_by(|a, b| a.x.total_cmp(&b.x));
        around
    }

    /// An end of a root's interval at which no feature ends: a turning, the cut of a circle, or the window's end.
    fn open_end(
        &self,
        rep: &Pair,
        root: u8,
        x: f64,
        breaking: Option<usize>,
        last: bool,
    ) -> SectionEnd {
        let scene = self.scene;
        let condition = &rep.condition;
        let Some(k) = breaking else {
            if scene.x.repeats() {
                let fold = scene.repeats.fold;
                return self.seam(rep, root, if last { fold } else { 0 }, last);
            }
            let y = scene.y.reduced(condition.y(x, root));
            return SectionEnd::between(x, (x, 0), y, Name::Limit);
        };
        let (y0, y1) = (condition.y(x, 0), condition.y(x, 1));
        let y = if y0.is_finite() && y1.is_finite() {
            // A double root: the difference that rounding leaves between the two is halved.
            y0 + 0.5 * scene.y.difference(y1, y0)
        } else {
            condition.y(x, root)
        };
        let at = scene.repeats.split(&scene.x, x);
        SectionEnd::between(x, at, scene.y.reduced(y), Name::Turning(0, k as u32))
    }

    /// The end at which a curve leaves a copy of the window, or enters the next one. Both sides have exactly the same y.
    fn seam(&self, rep: &Pair, root: u8, number: u32, leaving: bool) -> SectionEnd {
        let scene = self.scene;
        let fold = scene.repeats.fold;
        let window = scene.repeats.window(&scene.x);
        let period = if window.is_circle() {
            window.hi - window.lo
        } else {
            TAU
        };
        let x = |n: u32| scene.x.lo + period * f64::from(n);
        let at = if leaving {
            (window.lo + period, number - 1)
        } else {
            (window.lo, number)
        };
        let y = scene.y.reduced(rep.condition.y(x(number % fold), root));
        let name = Name::Seam(rep.first, rep.second);
        SectionEnd {
            root,
            x_turn: if window.is_circle() {
                (number % fold) as i32
            } else {
                number as i32
            },
            ..SectionEnd::between(x(number), at, y, name)
        }
    }

    /// Adds a section of a curve over the full turn, cut to pieces in copies of the window.
    fn section(&mut self, rep: &Pair, root: u8, from: &SectionEnd, to: &SectionEnd) {
        for copy in from.copy..=to.copy {
            let start = if copy == from.copy {
                *from
            } else {
                self.seam(rep, root, copy, false)
            };
            let end = if copy == to.copy {
                *to
            } else {
                self.seam(rep, root, copy + 1, true)
            };
            self.instances(rep, root, copy, &start, &end);
        }
    }

    /// Adds a section in every turn of both coordinates, cut to the limits.
    fn instances(&mut self, rep: &Pair, root: u8, copy: u32, from: &SectionEnd, to: &SectionEnd) {
        let (x, y) = (self.scene.x, self.scene.y);
        let (before, pair) = self.instance(rep, copy);
        let down = if copy == 0 {
            0.0
        } else {
            self.scene.repeats.period() * f64::from(copy)
        };
        for turn in 0..x.turns() {
            let shift = TAU * f64::from(turn);
            let end = |of: &SectionEnd, raw: f64| -> End {
                let whole = if y.repeats() {
                    ((raw - of.y) / TAU).round() as i32
                } else {
                    0
                };
                End {
                    key: of.key(pair, turn),
                    x: of.at + shift,
                    base: of.y,
                    turns: whole,
                }
            };
            let condition = self.pairs[pair as usize].condition;
            let raw = |of: &SectionEnd| condition.y(of.x - down + shift, root);
            let piece = Piece {
                pair,
                root,
                vertical: false,
                turns: 0,
                start: end(from, raw(from)),
                end: end(to, raw(to)),
            };
            self.in_each_turn(piece);
        }
        self.keep_instance(before, copy);
    }
}

// Contacts that do not depend on y, such as a tooth against a stop: vertical pieces.

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
