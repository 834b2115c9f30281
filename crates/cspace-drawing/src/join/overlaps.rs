//! Pieces that are drawn twice, lie within others, or overlap them.
//!
//! Lines are sorted by the line they lie on, arcs by their circle: what may overlap is found in n log n. On a line or
//! circle pieces are intervals, and a sweep along them finds those that share more than an end.

use core::f64::consts::TAU;
use std::collections::HashSet;

use cspace::{Edge, Point, Vector};

use super::joined::Joined;
use super::paths::remove_repeated;
use super::pieces::{End, Pieces, Shape, end, of_end};

/// The kind of arcs; lines are of kind 0 or 1, by their direction.
const CIRCLE: u8 = 2;

/// A piece on the line or circle it lies on.
struct Laid {
    piece: usize,
    /// Key of the line or circle: its kind and two or three lengths.
    kind: u8,
    key: [f64; 3],
    /// Interval: x of a flat line, y of a steep one, the angle on a circle; and whether the piece runs in the other direction.
    from: f64,
    to: f64,
    is_backward: bool,
    /// Interval parameter per unit of length: |cos| or |sin| of a line's angle to the x axis, 1/r on a circle.
    unit: f64,
}

impl Laid {
    /// Ends of the piece, the lower first.
    fn ends(&self) -> [End; 2] {
        let sides = if self.is_backward { [1, 0] } else { [0, 1] };
        sides.map(|side| end(self.piece, side))
    }

    /// Intervals of the piece, cut where the angle returns to zero.
    fn intervals(self) -> impl Iterator<Item = (f64, f64, usize)> {
        let goes_round = self.kind == CIRCLE && self.to > TAU;
        let first = (
            self.from,
            if goes_round { TAU } else { self.to },
            self.piece,
        );
        let second = goes_round.then_some((0.0, self.to - TAU, self.piece));
        [first].into_iter().chain(second)
    }
}

pub(super) fn merge(pieces: &mut Pieces<'_>, round: f64, joined: &mut Joined<'_>) {
    joined.duplicates += remove_repeated(pieces, round);
    same_curves(pieces, joined);
    let Some(middle) = middle(pieces) else { return };
    let mut laid: Vec<Laid> = (0..pieces.segments.len())
        .filter(|&i| !pieces.segments[i].is_removed)
        .filter_map(|i| lay(pieces, i, middle))
        .collect();
    laid.sort_by(|a, b| a.kind.cmp(&b.kind).then(a.key[0].total_cmp(&b.key[0])));
    // Lines of different direction, and circles about different points, come apart at each step.
    for group in laid.chunk_by_mut(|a, b| a.kind == b.kind && near(a, b, 0, round)) {
        group.sort_by(|a, b| a.key[1].total_cmp(&b.key[1]));
        for group in group.chunk_by_mut(|a, b| near(a, b, 1, round)) {
            group.sort_by(|a, b| a.key[2].total_cmp(&b.key[2]));
            for group in group.chunk_by_mut(|a, b| near(a, b, 2, round)) {
                if group.len() > 1 {
                    sweep(pieces, group, middle, round, joined);
                }
            }
        }
    }
}

/// Tolerance factor of keys of pieces whose places agree to rounding, which is enlarged in directions and centres.
const SLACK: f64 = 1e3;

fn near(a: &Laid, b: &Laid, key: usize, round: f64) -> bool {
    (b.key[key] - a.key[key]).abs() <= SLACK * round
}

fn middle(pieces: &Pieces<'_>) -> Option<Point> {
    let mut lo = Point::new(f64::INFINITY, f64::INFINITY);
    let mut hi = Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY);
    for p in pieces.segments.iter().flat_map(|s| s.ends) {
        lo = Point::new(lo.x.min(p.x), lo.y.min(p.y));
        hi = Point::new(hi.x.max(p.x), hi.y.max(p.y));
    }
    lo.is_finite().then(|| lo.midpoint(hi))
}

fn lay(pieces: &Pieces<'_>, piece: usize, middle: Point) -> Option<Laid> {
    let segment = &pieces.segments[piece];
    let Shape::Edge(bulge) = segment.shape else {
        return None;
    };
    let [p, q] = segment.ends.map(|p| p - middle);
    let chord = q - p;
    if bulge == 0.0 {
        // Directions are halves of a turn; they are cut where drawings have fewest lines.
        const CUT: f64 = 0.7265;
        let is_steep = chord.y.abs() > CUT * chord.x.abs();
        let is_backward = if is_steep {
            chord.y < 0.0
        } else {
            chord.x < 0.0
        };
        let along = if is_backward {
            -chord.unit()
        } else {
            chord.unit()
        };
        // Lines of a fine trace have different directions: lengths along these do not compare, x and y do.
        let (a, b) = if is_steep { (p.y, q.y) } else { (p.x, q.x) };
        let (slope, unit) = if is_steep {
            (along.x, along.y)
        } else {
            (along.y, along.x)
        };
        // A direction is as a length on the drawing's scale.
        let scale = p.length().max(q.length()).max(f64::MIN_POSITIVE);
        return Some(Laid {
            piece,
            kind: u8::from(is_steep),
            key: [slope * scale.min(chord.length() * 1e3), along.cross(p), 0.0],
            from: a.min(b),
            to: a.max(b),
            is_backward,
            unit,
        });
    }
    let arc = Edge::between(Point::ORIGIN + p, Point::ORIGIN + q, bulge);
    let center = arc.center() - Point::ORIGIN;
    let radius = (p - center).length();
    let is_backward = bulge < 0.0;
    let first = if is_backward { q } else { p };
    let from = (first - center).angle().rem_euclid(TAU);
    Some(Laid {
        piece,
        kind: CIRCLE,
        key: [center.x, center.y, radius],
        from,
        to: from + arc.sweep().abs(),
        is_backward,
        unit: 1.0 / radius,
    })
}

/// Merges what overlaps among pieces of about one line or circle.
fn sweep(
    pieces: &mut Pieces<'_>,
    group: &[Laid],
    middle: Point,
    round: f64,
    joined: &mut Joined<'_>,
) {
    loop {
        let mut intervals: Vec<(f64, f64, usize)> = (group.iter())
            .filter(|l| !pieces.segments[l.piece].is_removed)
            .filter_map(|l| lay(pieces, l.piece, middle))
            .flat_map(|l| l.intervals())
            .collect();
        intervals.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.total_cmp(&a.1)));
        // Two pieces that both go on at both ends are left alone: those are kept apart, for a path may go back and forth often.
        let mut loose: Vec<(f64, usize)> = Vec::new();
        let mut held: Vec<(f64, usize)> = Vec::new();
        let mut has_wrapped = false;
        let slack = round * group[0].unit;
        for &(from, to, piece) in &intervals {
            if pieces.segments[piece].is_removed {
                continue;
            }
            let reaches = |a: &(f64, usize)| a.0 > from + slack && !pieces.segments[a.1].is_removed;
            loose.retain(reaches);
            let mut others: Vec<usize> = loose.iter().map(|a| a.1).collect();
            let is_held = pieces.is_held(piece);
            if !is_held {
                held.retain(reaches);
                others.extend(held.iter().map(|a| a.1));
            }
            match is_held {
                true => held.push((to, piece)),
                false => loose.push((to, piece)),
            }
            others.retain(|&p| p != piece);
            for other in others {
                if !unite(pieces, [other, piece], middle, round, joined) {
                    continue;
                }
                // One of the two is gone or shorter, and the other reaches as far as both at most.
                let of_both = |a: &&mut (f64, usize)| a.1 == other || a.1 == piece;
                let reach = (loose.iter_mut().chain(&mut held).filter(of_both))
                    .fold(to, |reach, a| reach.max(a.0));
                for a in loose.iter_mut().chain(&mut held).filter(of_both) {
                    a.0 = reach;
                }
                // Its neighbours may be loose now.
                loose.extend(held.extract_if(.., |a| !pieces.is_held(a.1)));
                has_wrapped |= group[0].kind == CIRCLE;
                if pieces.segments[piece].is_removed {
                    break;
                }
            }
        }
        // On a circle what has grown may reach what was passed already.
        if !has_wrapped {
            return;
        }
    }
}

/// Whether two pieces lie on the same line or circle, to rounding.
fn is_same_line(pieces: &Pieces<'_>, a: &Laid, b: &Laid, round: f64) -> bool {
    let (long, short) = if (a.to - a.from) * b.unit >= (b.to - b.from) * a.unit {
        (a, b)
    } else {
        (b, a)
    };
    if long.kind == CIRCLE {
        let apart = (0..3).map(|k| (a.key[k] - b.key[k]).abs()).sum::<f64>();
        return apart <= 4.0 * round;
    }
    let [p, q] = pieces.segments[long.piece].ends;
    let along: Vector = (q - p).unit();
    (pieces.segments[short.piece].ends.iter()).all(|&e| along.cross(e - p).abs() <= 2.0 * round)
}

/// Makes one of two pieces if they overlap, or cuts one off where the other begins; whether anything has changed.
fn unite(
    pieces: &mut Pieces<'_>,
    [a, b]: [usize; 2],
    middle: Point,
    round: f64,
    joined: &mut Joined<'_>,
) -> bool {
    let (Some(first), Some(second)) = (lay(pieces, a, middle), lay(pieces, b, middle)) else {
        return false;
    };
    if !is_same_line(pieces, &first, &second, round) {
        return false;
    }
    let slack = round * first.unit;
    // Angles may be a turn apart.
    let turns: &[f64] = if first.kind == CIRCLE {
        &[0.0, TAU, -TAU]
    } else {
        &[0.0]
    };
    let (lo, hi) = (first.from, first.to);
    let Some((from, to)) = (turns.iter())
        .map(|t| (second.from + t, second.to + t))
        .find(|&(from, to)| hi > from + slack && lo < to - slack)
    else {
        return false;
    };
    let (a_ends, b_ends) = (first.ends(), second.ends());
    let holds = lo <= from + slack && hi >= to - slack;
    let is_held = from <= lo + slack && to >= hi - slack;
    if holds || is_held {
        let (kept, dropped) = if holds {
            (a_ends, b_ends)
        } else {
            (b_ends, a_ends)
        };
        // Where both end together the one that is kept is joined to what the other was joined to.
        let together = [(lo - from).abs() <= slack, (hi - to).abs() <= slack];
        // A piece that is joined within its path is kept if the other cannot replace it: paths side by side share an
        // edge, and each needs it.
        let is_needed = |side: usize| {
            let stands = together[side] && pieces.linked(kept[side]).is_none();
            pieces.linked(dropped[side]).is_some() && !stands
        };
        if is_needed(0) || is_needed(1) {
            return false;
        }
        let moved: Vec<(End, End)> = (0..2)
            .filter(|&side| together[side] && pieces.linked(kept[side]).is_none())
            .filter_map(|side| Some((kept[side], pieces.linked(dropped[side])?)))
            .collect();
        pieces.remove(of_end(dropped[0]).0);
        for (kept, other) in moved {
            pieces.link(kept, other);
        }
        joined.duplicates += 1;
        return true;
    }
    // Neither holds the other: the first grows, if nothing is joined to what it then covers.
    let (grown, by, covered) = if lo < from {
        (a_ends[1], b_ends[1], b_ends[0])
    } else {
        (a_ends[0], b_ends[0], b_ends[1])
    };
    let sweep = hi.max(to) - lo.min(from);
    let is_whole = first.kind == CIRCLE && sweep > TAU - slack;
    let (grown_is_linked, covered_is_linked) = (
        pieces.linked(grown).is_some(),
        pieces.linked(covered).is_some(),
    );
    match (grown_is_linked, covered_is_linked) {
        (false, false) if !is_whole => {}
        // One goes on in its path: what it covers of the other is cut off.
        (true, false) => {
            cut(pieces, covered, pieces.point(grown), middle);
            return true;
        }
        (false, true) => {
            cut(pieces, grown, pieces.point(covered), middle);
            return true;
        }
        _ => return false,
    }
    let link = pieces.linked(by);
    let to = pieces.point(by);
    pieces.remove(b);
    pieces.move_end(grown, to);
    if let Some(link) = link {
        pieces.link(grown, link);
    }
    if first.kind == CIRCLE {
        let bulge = (sweep / 4.0).tan();
        let signed = if first.is_backward { -bulge } else { bulge };
        pieces.segments[a].shape = Shape::Edge(signed);
    }
    joined.merged += 1;
    true
}

/// Cuts a line or an arc off at a point on it, on the side of an end.
fn cut(pieces: &mut Pieces<'_>, at: End, to: Point, middle: Point) {
    let (piece, side) = of_end(at);
    let Some(laid) = lay(pieces, piece, middle) else {
        return;
    };
    if laid.kind == CIRCLE {
        let center = middle + Vector::new(laid.key[0], laid.key[1]);
        let angle = (to - center).angle();
        let backward = laid.is_backward;
        let cuts_start = (side == 0) != backward;
        let sweep = if cuts_start {
            (laid.to - angle).rem_euclid(TAU)
        } else {
            (angle - laid.from).rem_euclid(TAU)
        };
        let bulge = (sweep / 4.0).tan();
        pieces.segments[piece].shape = Shape::Edge(if backward { -bulge } else { bulge });
    }
    pieces.move_end(at, to);
}

/// Removes curves that are drawn twice, equal to the last bit, in either direction.
fn same_curves(pieces: &mut Pieces<'_>, joined: &mut Joined<'_>) {
    let mut seen = HashSet::new();
    for i in 0..pieces.segments.len() {
        let segment = &pieces.segments[i];
        let Shape::Curve(curve) = segment.shape else {
            continue;
        };
        let spans = curve.spans();
        let bits = |p: Point| [p.x.to_bits(), p.y.to_bits()];
        let mut ends = segment.ends.map(bits);
        ends.sort_unstable();
        let inner = if spans % 2 == 0 {
            curve.at(spans / 2, 0.0).0
        } else {
            curve.at(spans / 2, 0.5).0
        };
        if !segment.is_removed && !seen.insert((ends, bits(inner), spans)) {
            pieces.remove(i);
            joined.duplicates += 1;
        }
    }
}
