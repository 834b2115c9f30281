//! Check for vertices at one place.

use super::meeting::Meeting;
use super::outline::Outline;
use super::{PartError, Vertex};

/// Rejects two vertices nearer than the tolerance.
///
/// Vertices are sorted into square cells as wide as the tolerance, so that only adjacent cells need to be compared; a cell contains few
/// vertices before two of them are found to be near.
///
/// # Errors
/// The edges that start at the two vertices touch, or the two loops are equal.
pub(super) fn check_vertices(outline: &Outline, loops: &[Vec<Vertex>]) -> Result<(), PartError> {
    let tolerance = outline.tolerance();
    let cell = |c: f64| (c / tolerance).floor() as i64;
    let mut cells: Vec<(i64, i64, usize)> = outline
        .edges
        .iter()
        .map(|e| (cell(e.start.x), cell(e.start.y), e.index))
        .collect();
    cells.sort_unstable();
    // For each vertex, those after it in its own column, then the start of its range in the next column.
    let mut right = 0;
    for (k, &(x, y, a)) in cells.iter().enumerate() {
        while right < cells.len() && (cells[right].0, cells[right].1) < (x + 1, y - 1) {
            right += 1;
        }
        let own = cells[k + 1..]
            .iter()
            .take_while(|c| c.0 == x && c.1 <= y + 1);
        let next = cells[right..]
            .iter()
            .take_while(|c| c.0 == x + 1 && c.1 <= y + 1);
        for &(_, _, b) in own.chain(next) {
            let (p, q) = (outline.edges[a].start, outline.edges[b].start);
            if p.distance(q) <= tolerance {
                let (first, second) = (outline.name(a.min(b)), outline.name(a.max(b)));
                return Err(if is_repeated(loops, first, second) {
                    PartError::RepeatedLoop {
                        loop_index: first.0,
                        other_loop: second.0,
                    }
                } else {
                    outline.refuse(a, b, Meeting::Touching(p))
                });
            }
        }
    }
    Ok(())
}

/// Whether two loops are equal, in either direction, if the given vertices correspond.
fn is_repeated(loops: &[Vec<Vertex>], (a, i): (usize, usize), (b, j): (usize, usize)) -> bool {
    let (u, v) = (&loops[a], &loops[b]);
    let n = u.len();
    if a == b || v.len() != n {
        return false;
    }
    let forward = (0..n).all(|k| u[(i + k) % n] == v[(j + k) % n]);
    let backward = (0..n).all(|k| {
        let (from, to) = (u[(i + k) % n], v[(j + n - k) % n]);
        from.point() == to.point() && from.bulge == -v[(j + 2 * n - k - 1) % n].bulge
    });
    forward || backward
}
