//! Tracks: the straight lines that an engineer would move a part along.
//!
//! ```text
//!      ┆     ┆            A first way is free, but turns and bends as the surface does that it follows. Tracks are lines in few
//!   ┄┄┄┼┄┄┄┄┄┼┄┄ goal     directions, those of the parts' edges and of the axes, through the places of that way and through the
//!      ┆     ┆            middles of the gaps it passes. Legs go along tracks and turn on the spot where tracks cross, at few
//!  start┄┄┄┄┄┼┄┄          orientations.
//!      ┆     ┆
//! ```

use core::f64::consts::TAU;

use cspace::part::Bounds;
use cspace::{Edge, Point, Rotation, Vector};

use crate::farthest::farthest;
use crate::legs::{Coords, Scene};

/// Tracks have so many directions at most.
const DIRECTIONS: usize = 4;
/// In each direction there are so many tracks at most.
const ABREAST: usize = 24;
/// Tracks around the fixed part pass it at this share of the parts' size.
const AROUND: f64 = 0.05;
/// Legs do not turn at more orientations than this.
const ORIENTATIONS: usize = 8;
/// Directions that differ by less are one: sines of angles.
const SAME_DIRECTION: f64 = 1e-9;
/// Orientations that differ by less are one, radians.
const SAME_ANGLE: f64 = 1e-9;
/// The middles of gaps are sought at so many places of a way at most.
const CENTRED_AT: usize = 16;
/// A point this near to a track is on it, as a share of the way's extent.
const ON_TRACK: f64 = 1e-9;
/// Tracks nearer to each other than this share of the way's extent are one.
const SAME_TRACK: f64 = 1e-6;
/// An orientation this near to one at which lines of the two parts are parallel gives way to that, radians.
const ALIGNED: f64 = 0.2;
/// The middle of a gap is found to this share of the clearance there, in so many steps at most.
const CENTRED: f64 = 1e-7;
const STEPS: usize = 64;
/// Where the clearance still grows at this share of the parts' size from a place, there is no gap.
const OPEN: f64 = 0.5;

/// Tracks through the places of a way.
#[derive(Debug)]
pub(super) struct Tracks {
    /// Orientations, radians: those of the first and of the last place first.
    pub(super) angles: Vec<f64>,
    /// Where tracks cross: the first and the last place first.
    pub(super) points: Vec<Point>,
    /// The tracks.
    pub(super) tracks: Vec<Track>,
    /// The points on each track, in order.
    pub(super) lines: Vec<Vec<u32>>,
    /// For each point the tracks through it, with where it is on them.
    pub(super) through: Vec<Vec<(u32, u32)>>,
}

/// A track: the points p with direction × p = offset.
#[derive(Debug, Clone, Copy)]
pub(super) struct Track {
    pub(super) direction: Vector,
    offset: f64,
}

impl Track {
    /// The point at a coordinate along it.
    pub(super) fn point(&self, along: f64) -> Point {
        Point::ORIGIN + self.direction * along + self.direction.left() * self.offset
    }

    /// The coordinate of a point along it.
    pub(super) fn along(&self, p: Point) -> f64 {
        self.direction.dot(p.to_vector())
    }
}

impl Tracks {
    /// The tracks of a way, given by its places and by those of them at which it bends.
    pub(super) fn new(scene: &Scene, places: &[Coords], bends: &[Coords]) -> Self {
        let within = within(places);
        let directions = directions(scene, bends);
        let angles = angles(scene, bends);
        let extent = extent(bends).max(f64::MIN_POSITIVE);
        let (fixed, _) = scene.parts();
        let beside = scene.levers()[2] + AROUND * scene.size();
        let mut tracks: Vec<Track> = Vec::new();
        for &direction in &directions {
            let mut offsets: Vec<f64> = Vec::new();
            let mut add = |p: Point| {
                let at = [p.x, p.y, 0.0];
                let inside = scene.within_limits(at);
                if inside[..2] != at[..2] {
                    return;
                }
                let offset = direction.cross(p.to_vector());
                let known = |o: &f64| (o - offset).abs() <= SAME_TRACK * extent;
                if offsets.len() < ABREAST && !offsets.iter().any(known) {
                    offsets.push(offset);
                }
            };
            let place = |at: &Coords| Point::new(at[0], at[1]);
            bends.first().map(place).map(&mut add);
            bends.last().map(place).map(&mut add);
            if scene.motions().is_none() {
                // Around the fixed part, at any orientation.
                for side in [direction.left(), -direction.left()] {
                    add(Point::ORIGIN + side * (farthest(fixed, side) + beside));
                }
            }
            for &at in &within {
                centred(scene, at, direction.left()).map(&mut add);
            }
            for at in bends {
                add(place(at));
            }
            tracks.extend(
                offsets
                    .into_iter()
                    .map(|offset| Track { direction, offset }),
            );
        }
        let ends = [bends.first(), bends.last()];
        let first = ends.into_iter().flatten().map(|c| Point::new(c[0], c[1]));
        let around = around(scene, bends);
        Self::crossed(tracks, angles, first.collect(), around, extent)
    }

    fn crossed(
        tracks: Vec<Track>,
        angles: Vec<f64>,
        mut points: Vec<Point>,
        around: Bounds,
        extent: f64,
    ) -> Self {
        let same = ON_TRACK * extent;
        let mut through: Vec<Vec<(u32, u32)>> = vec![Vec::new(); points.len()];
        let mut lines: Vec<Vec<u32>> = vec![Vec::new(); tracks.len()];
        let on = |points: &[Point], t: &Track| -> Vec<u32> {
            (0u32..)
                .zip(points)
                .filter(|(_, p)| (t.direction.cross(p.to_vector()) - t.offset).abs() <= same)
                .map(|(i, _)| i)
                .collect()
        };
        for (a, s) in tracks.iter().enumerate() {
            for t in &tracks[a + 1..] {
                let sine = s.direction.cross(t.direction);
                if sine.abs() <= SAME_DIRECTION {
                    continue;
                }
                // The point p with s × p and t × p as the offsets say.
                let v = (t.direction * s.offset - s.direction * t.offset) * (1.0 / sine);
                let p = Point::ORIGIN + v;
                // Tracks at a small angle cross far away.
                if around.contains(p) && !points.iter().any(|q| q.distance(p) <= 4.0 * same) {
                    points.push(p);
                    through.push(Vec::new());
                }
            }
        }
        for (k, track) in (0u32..).zip(&tracks) {
            let mut along = on(&points, track);
            let place = |i: &u32| track.along(points[*i as usize]);
            along.sort_by(|a, b| place(a).total_cmp(&place(b)));
            for (where_on, &i) in (0u32..).zip(&along) {
                through[i as usize].push((k, where_on));
            }
            lines[k as usize] = along;
        }
        Self {
            angles,
            points,
            tracks,
            lines,
            through,
        }
    }
}

/// Places of a way and the middles of its legs, but for its ends: evenly so many at most.
fn within(places: &[Coords]) -> Vec<Coords> {
    let middle = |leg: &[Coords]| core::array::from_fn(|k| 0.5 * (leg[0][k] + leg[1][k]));
    let all: Vec<Coords> = (places.windows(2))
        .flat_map(|leg| [middle(leg), leg[1]])
        .collect();
    let inner = &all[..all.len().saturating_sub(1)];
    let count = inner.len().min(CENTRED_AT);
    (0..count).map(|i| inner[i * inner.len() / count]).collect()
}

/// Where tracks cross that are used: no farther from the places of a way, and from the fixed part, than the parts' size.
fn around(scene: &Scene, places: &[Coords]) -> Bounds {
    let by = Vector::new(scene.size(), scene.size());
    let fixed = scene.parts().0.bounds();
    let points = places.iter().map(|at| Point::new(at[0], at[1]));
    let within = points.fold(fixed, |all, p| all.union(Bounds::of(p, p)));
    Bounds {
        min: within.min - by,
        max: within.max + by,
    }
}

/// How far the places of a way are apart, along x and y.
fn extent(places: &[Coords]) -> f64 {
    (0..2)
        .map(|k| {
            let (lo, hi) = places
                .iter()
                .map(|p| p[k])
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
                    (lo.min(x), hi.max(x))
                });
            hi - lo
        })
        .fold(0.0, f64::max)
}

/// The directions of the axes and of the lines of both parts, as the moving part is at the ends of the way, and across them: those with
/// the longest lines.
fn directions(scene: &Scene, bends: &[Coords]) -> Vec<Vector> {
    let mut found = vec![Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)];
    if scene.motions().is_some() {
        return found;
    }
    let (fixed, moving) = scene.parts();
    let ends = [bends.first(), bends.last()];
    let turns = (ends.into_iter().flatten()).map(|at| Rotation::by(at[2]));
    let of = |e: Edge, turn: Rotation| (e.is_line(), turn * (e.end - e.start));
    let still = Rotation::by(0.0);
    let mut chords: Vec<Vector> = (fixed.edges().map(|e| of(e, still)))
        .chain(turns.flat_map(|turn| moving.edges().map(move |e| of(e, turn))))
        .filter(|chord| chord.0)
        .map(|chord| chord.1)
        .collect();
    chords.sort_by(|a, b| b.length().total_cmp(&a.length()));
    for chord in chords {
        let unit = chord.unit();
        for d in [unit, unit.left()] {
            if found.len() < DIRECTIONS && !found.iter().any(|f| f.cross(d).abs() < SAME_DIRECTION)
            {
                found.push(d);
            }
        }
    }
    found
}

/// The orientations of a way's ends, and of its bends, aligned with the fixed part where that is near.
fn angles(scene: &Scene, bends: &[Coords]) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    let mut add = |angle: f64| {
        let known = |a: &f64| (a - angle).abs() <= SAME_ANGLE;
        if found.len() < ORIENTATIONS && !found.iter().any(known) {
            found.push(angle);
        }
    };
    let (Some(first), Some(last)) = (bends.first(), bends.last()) else {
        return found;
    };
    add(first[2]);
    // The goal's orientation, as the way has come to it and with as little turning as can be.
    add(first[2] + (last[2] - first[2]) - TAU * ((last[2] - first[2]) / TAU).round());
    add(last[2]);
    if scene.motions().is_none() {
        let aligned = alignments(scene);
        for at in bends {
            if let Some(&angle) = aligned_near(&aligned, at[2]).first() {
                add(angle);
            }
        }
        for at in bends {
            add(at[2]);
        }
    }
    let (lo, hi) = scene.limits()[2];
    found.retain(|a| (lo..=hi).contains(a) || *a == first[2] || *a == last[2]);
    found
}

/// The orientations of those aligned that are near another, as often around as that, the nearest first; radians.
pub(super) fn aligned_near(aligned: &[f64], at: f64) -> Vec<f64> {
    let mut near: Vec<f64> = (aligned.iter())
        .map(|a| a + TAU * ((at - a) / TAU).round())
        .filter(|a| (a - at).abs() < ALIGNED)
        .collect();
    near.sort_by(|a, b| (a - at).abs().total_cmp(&(b - at).abs()));
    near
}

/// The orientations at which the longest lines of the two parts are parallel, radians in a turn.
pub(super) fn alignments(scene: &Scene) -> Vec<f64> {
    /// So many lines of each part are looked at.
    const LONGEST: usize = 4;
    let (fixed, moving) = scene.parts();
    let longest = |edges: Vec<Edge>| -> Vec<f64> {
        let mut chords: Vec<Vector> = (edges.into_iter().filter(Edge::is_line))
            .map(|e| e.end - e.start)
            .collect();
        chords.sort_by(|a, b| b.length().total_cmp(&a.length()));
        let mut angles: Vec<f64> = Vec::new();
        for chord in chords {
            let angle = chord.angle().rem_euclid(core::f64::consts::PI);
            if angles.len() < LONGEST && !angles.iter().any(|a| (a - angle).abs() < SAME_ANGLE) {
                angles.push(angle);
            }
        }
        angles
    };
    let own = longest(moving.edges().collect());
    let half = core::f64::consts::PI;
    (longest(fixed.edges().collect()).iter())
        .flat_map(|f| own.iter().flat_map(move |m| [f - m, f - m + half]))
        .collect()
}

/// From a place the middle of the gap across a direction: where the clearance is largest, as far as it only grows. `None` where there is
/// no gap.
fn centred(scene: &Scene, at: Coords, across: Vector) -> Option<Point> {
    /// The golden section.
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let clearance = |s: f64| scene.clearance([at[0] + across.x * s, at[1] + across.y * s, at[2]]);
    let here = clearance(0.0);
    // The side on which it grows, then by steps that double until it grows no more.
    let mut step = 0.5 * here;
    let side = if clearance(step) >= clearance(-step) {
        1.0
    } else {
        -1.0
    };
    let (mut lo, mut best, mut hi) = (-side * step, 0.0, side * step);
    let mut height = here;
    loop {
        let there = clearance(hi);
        if there <= height || hi == best {
            break;
        }
        if hi.abs() > OPEN * scene.size() {
            return None;
        }
        (lo, best, height) = (best, hi, there);
        step *= 2.0;
        hi = best + side * step;
    }
    // Between these there is one summit, whose sides are straight where lines bound the gap.
    let (mut a, mut b) = (lo.min(hi), lo.max(hi));
    let (mut s, mut t) = (b - SECTION * (b - a), a + SECTION * (b - a));
    let (mut at_s, mut at_t) = (clearance(s), clearance(t));
    for _ in 0..STEPS {
        if b - a <= CENTRED * height {
            break;
        }
        if at_s >= at_t {
            (b, t, at_t) = (t, s, at_s);
            s = b - SECTION * (b - a);
            at_s = clearance(s);
        } else {
            (a, s, at_s) = (s, t, at_t);
            t = a + SECTION * (b - a);
            at_t = clearance(t);
        }
    }
    let middle = 0.5 * (a + b);
    Some(Point::new(
        at[0] + across.x * middle,
        at[1] + across.y * middle,
    ))
}
