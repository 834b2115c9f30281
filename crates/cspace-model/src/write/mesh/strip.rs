//! A patch between two rows.

use super::level::Row;

/// Triangles between a lower and an upper row, as indices into the rows: counter-clockwise seen from the right of
/// travel.
///
/// Each step advances in the row that is behind, by share of the length.
pub(super) fn zip(lower: &Row, upper: &Row, mut emit: impl FnMut([(bool, usize); 3])) {
    let (low, high) = (&lower.vertices, &upper.vertices);
    let (mut i, mut j) = (0, 0);
    let share = |row: &[(u32, f64)], at: usize| row.get(at).map(|v| v.1);
    loop {
        let along_low = match (share(low, i + 1), share(high, j + 1)) {
            (None, None) => return,
            (Some(_), None) => true,
            (None, Some(_)) => false,
            // The next edge across is the one whose ends are nearest in share.
            (Some(next_low), Some(next_high)) => {
                (next_low - high[j].1).abs() <= (next_high - low[i].1).abs()
            }
        };
        if along_low {
            emit([(false, i), (false, i + 1), (true, j)]);
            i += 1;
        } else {
            emit([(false, i), (true, j + 1), (true, j)]);
            j += 1;
        }
    }
}
