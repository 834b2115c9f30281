//! Curves as polylines that differ from them by less than can be seen.

use crate::scene::{Area, Dot};

/// Largest distance of a polyline from the curve, in dots.
pub(crate) const SEEN: f64 = 0.12;

/// Polylines of a curve given by fractions 0 to 1 along it, monotone in both directions of the picture: only visible
/// parts are followed closely, and parts far out of sight are left out.
pub(crate) fn follow(at: impl Fn(f64) -> Option<Dot>, area: Area) -> Vec<Vec<Dot>> {
    let (Some(from), Some(to)) = (at(0.0), at(1.0)) else {
        return Vec::new();
    };
    let mut lines = vec![vec![from]];
    // Ends of pieces to be looked at, the next on top.
    let mut ends = vec![(1.0, to, 0u32)];
    let mut last = (0.0, from);
    /// Largest number of halvings, which reaches the resolution of numbers.
    const DEEPEST: u32 = 40;
    /// A piece is halved so often in any case: a curve may cross its chord in the middle.
    const LEAST: u32 = 2;
    while let Some((share, end, depth)) = ends.pop() {
        let box_of = Area {
            lo: Dot::new(last.1.x.min(end.x) - 2.0, last.1.y.min(end.y) - 2.0),
            hi: Dot::new(last.1.x.max(end.x) + 2.0, last.1.y.max(end.y) + 2.0),
        };
        if !box_of.meets(&area) {
            last = (share, end);
            match lines.last_mut() {
                // A line begun out of sight is begun anew.
                Some(line) if line.len() == 1 => line[0] = end,
                _ => lines.push(vec![end]),
            }
            continue;
        }
        let middle = 0.5 * (last.0 + share);
        if depth < DEEPEST
            && let Some(at_middle) = at(middle)
            && (depth < LEAST || off(at_middle, last.1, end) > SEEN)
        {
            ends.push((share, end, depth + 1));
            ends.push((middle, at_middle, depth + 1));
            continue;
        }
        if let Some(line) = lines.last_mut() {
            line.push(end);
        }
        last = (share, end);
    }
    lines.retain(|l| l.len() > 1);
    for line in &mut lines {
        *line = simplified(line);
    }
    lines
}

/// Distance of a place from the line through two others.
pub(crate) fn off(p: Dot, a: Dot, b: Dot) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let length = dx.hypot(dy);
    if length == 0.0 {
        return p.distance(a);
    }
    ((p.x - a.x) * dy - (p.y - a.y) * dx).abs() / length
}

/// The line with as few of its points as say the same (Ramer, Douglas and Peucker).
pub(crate) fn simplified(line: &[Dot]) -> Vec<Dot> {
    if line.len() < 3 {
        return line.to_vec();
    }
    let mut keep = vec![false; line.len()];
    keep[0] = true;
    keep[line.len() - 1] = true;
    let mut pieces = vec![(0, line.len() - 1)];
    while let Some((a, b)) = pieces.pop() {
        let far = (a + 1..b)
            .map(|i| (i, off_piece(line[i], line[a], line[b])))
            .max_by(|p, q| p.1.total_cmp(&q.1));
        if let Some((i, distance)) = far
            && distance > SEEN
        {
            keep[i] = true;
            pieces.push((a, i));
            pieces.push((i, b));
        }
    }
    let kept = line.iter().zip(keep).filter(|k| k.1);
    kept.map(|k| *k.0).collect()
}

/// Distance of a place from a line segment.
fn off_piece(p: Dot, a: Dot, b: Dot) -> f64 {
    let (dx, dy) = (b.x - a.x, b.y - a.y);
    let length = dx * dx + dy * dy;
    let share = if length > 0.0 {
        (((p.x - a.x) * dx + (p.y - a.y) * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    p.distance(a.moved(share * dx, share * dy))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A quarter of a circle far larger than the picture: points of it that are seen are on the polyline.
    #[test]
    fn what_is_seen_is_followed() {
        let area = Area::new(0.0, 0.0, 100.0, 100.0);
        for radius in [10.0, 1e3, 1e6, 1e9] {
            let at = |s: f64| {
                let a = core::f64::consts::FRAC_PI_2 * s;
                // Its middle is in the middle of the picture.
                let half = core::f64::consts::FRAC_1_SQRT_2 * radius;
                Some(Dot::new(
                    50.0 + radius * a.cos() - half,
                    50.0 + radius * a.sin() - half,
                ))
            };
            let lines = follow(at, area);
            let points: usize = lines.iter().map(Vec::len).sum();
            assert!((2..200).contains(&points), "{radius}: {points}");
            let mut asked = 0;
            for k in -1000..=1000 {
                let share = 0.5 + f64::from(k) * 0.1 / radius.max(10.0);
                let Some(p) = at(share).filter(|p| {
                    (0.0..1.0).contains(&share)
                        && (0.0..100.0).contains(&p.x)
                        && (0.0..100.0).contains(&p.y)
                }) else {
                    continue;
                };
                asked += 1;
                let near = lines.iter().flat_map(|l| l.windows(2));
                let off = near
                    .map(|w| off_piece(p, w[0], w[1]))
                    .fold(f64::INFINITY, f64::min);
                assert!(off < 4.0 * SEEN, "{radius} {share}: {off}");
            }
            assert!(asked > 20);
        }
    }
}
