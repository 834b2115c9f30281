//! Connected sets of cells that record their turns: around which circles a closed path within a set leads.

/// Turns of some coordinates.
pub(crate) type Turns<const N: usize> = [i32; N];

/// Disjoint sets of cells. Each cell has its turns relative to the root of its set; each set has the lattice of turns
/// of its closed paths.
#[derive(Debug)]
pub(crate) struct Sets<const N: usize> {
    /// Parent cell, and the turns of this one less those of the parent.
    above: Vec<(u32, Turns<N>)>,
    lattices: Vec<Lattice<N>>,
}

pub(crate) fn plus<const N: usize>(a: Turns<N>, b: Turns<N>) -> Turns<N> {
    core::array::from_fn(|k| a[k] + b[k])
}

pub(crate) fn less<const N: usize>(a: Turns<N>, b: Turns<N>) -> Turns<N> {
    core::array::from_fn(|k| a[k] - b[k])
}

impl<const N: usize> Sets<N> {
    pub(crate) fn new(n: usize) -> Self {
        Self {
            above: (0..n as u32).map(|i| (i, [0; N])).collect(),
            lattices: vec![Lattice { rows: Vec::new() }; n],
        }
    }

    /// The cell that stands for the set of `i`, and the turns of `i` seen from it.
    pub(crate) fn find(&mut self, i: u32) -> (u32, Turns<N>) {
        let (mut root, mut sum) = (i, [0; N]);
        while self.above[root as usize].0 != root {
            let (above, turns) = self.above[root as usize];
            sum = plus(sum, turns);
            root = above;
        }
        let (mut at, mut rest) = (i, sum);
        while self.above[at as usize].0 != root && at != root {
            let (above, turns) = self.above[at as usize];
            self.above[at as usize] = (root, rest);
            rest = less(rest, turns);
            at = above;
        }
        (root, sum)
    }

    /// Records that cell `b`, moved by some turns, is adjacent to cell `a`.
    pub(crate) fn link(&mut self, a: u32, b: u32, by: Turns<N>) {
        let ((root_a, turns_a), (root_b, turns_b)) = (self.find(a), self.find(b));
        // Turns of b seen from the cell that stands for a.
        let there = plus(turns_a, by);
        let between = less(there, turns_b);
        if root_a == root_b {
            self.lattices[root_a as usize].add(between.map(i64::from));
            return;
        }
        let (root, other, by) = if root_a < root_b {
            (root_a, root_b, between)
        } else {
            (root_b, root_a, less([0; N], between))
        };
        self.above[other as usize] = (root, by);
        let joined = core::mem::take(&mut self.lattices[other as usize].rows);
        for row in joined {
            self.lattices[root as usize].add(row);
        }
    }

    /// Lattice of turns of closed paths in the set with this root.
    pub(crate) fn lattice(&self, root: u32) -> &Lattice<N> {
        &self.lattices[root as usize]
    }
}

/// Lattice of all integer combinations of some vectors: no more than coordinates, in echelon form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lattice<const N: usize> {
    rows: Vec<[i64; N]>,
}

fn first<const N: usize>(row: &[i64; N]) -> Option<usize> {
    row.iter().position(|&x| x != 0)
}

impl<const N: usize> Lattice<N> {
    fn add(&mut self, mut row: [i64; N]) {
        while let Some(at) = first(&row) {
            let Some(known) = self.rows.iter_mut().find(|r| first(r) == Some(at)) else {
                self.rows.push(row);
                self.rows.sort_by_key(first);
                return;
            };
            // The step of Euclid: the smaller one stays.
            if row[at].abs() < known[at].abs() {
                core::mem::swap(&mut row, known);
            }
            let times = row[at].div_euclid(known[at]);
            for (x, k) in row.iter_mut().zip(known.iter()) {
                *x -= times * k;
            }
        }
    }

    /// Unique reduced rows: first entries positive, and entries above a first entry smaller and not negative.
    pub(crate) fn reduced(&self) -> Vec<[i64; N]> {
        let mut rows = self.rows.clone();
        for row in &mut rows {
            if first(row).is_some_and(|k| row[k] < 0) {
                *row = row.map(|x| -x);
            }
        }
        for i in 0..rows.len() {
            let Some(at) = first(&rows[i]) else { continue };
            let lower = rows[i];
            for upper in &mut rows[..i] {
                let times = upper[at].div_euclid(lower[at]);
                for (x, k) in upper.iter_mut().zip(lower) {
                    *x -= times * k;
                }
            }
        }
        rows
    }
}

/// The reduced form of what vectors stand for.
pub(crate) fn reduced<const N: usize>(vectors: impl Iterator<Item = [i64; N]>) -> Vec<[i64; N]> {
    let mut lattice = Lattice { rows: Vec::new() };
    vectors.for_each(|v| lattice.add(v));
    lattice.reduced()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lattices_do_not_depend_on_the_order_of_what_is_added() {
        let vectors = [[2, 3, 0], [4, 0, 6], [0, 6, -6], [6, 3, 6], [-2, -3, 0]];
        let mut known: Option<Vec<[i64; 3]>> = None;
        for from in 0..vectors.len() {
            let mut lattice = Lattice { rows: Vec::new() };
            for k in 0..vectors.len() {
                lattice.add(vectors[(from + 2 * k) % vectors.len()]);
            }
            let reduced = lattice.reduced();
            assert_eq!(reduced, *known.get_or_insert(reduced.clone()));
        }
        assert_eq!(known, Some(vec![[2, 3, 0], [0, 6, -6]]));
    }

    #[test]
    fn a_chain_that_closes_tells_its_turns() {
        let mut sets = Sets::new(4);
        sets.link(0, 1, [0, 0, 0]);
        sets.link(2, 3, [0, 1, 0]);
        sets.link(3, 1, [0, 0, -2]);
        // 2 is a turn of v below 3, and 3 two turns of w above 1.
        let (root, turns) = sets.find(2);
        assert_eq!((root, turns), (0, [0, -1, 2]));
        sets.link(2, 0, [1, 0, 0]);
        assert_eq!(sets.lattice(0).reduced(), vec![[1, -1, 2]]);
    }
}
