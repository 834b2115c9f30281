//! A function of the coordinates of two parts, to first order.

/// Coordinates of two parts, at most.
pub(crate) const MOST: usize = 6;

/// The value of a function and its derivatives by the coordinates of the system it depends on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row {
    /// The value.
    pub value: f64,
    entries: [(usize, f64); MOST],
    count: usize,
}

impl Row {
    /// A value that depends on nothing yet.
    pub(crate) fn new(value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    pub(crate) fn push(&mut self, coordinate: usize, derivative: f64) {
        if let Some(entry) = self.entries.get_mut(self.count) {
            *entry = (coordinate, derivative);
            self.count += 1;
        }
    }

    /// The coordinates it depends on, each once, with the derivatives by them.
    pub fn entries(&self) -> &[(usize, f64)] {
        &self.entries[..self.count]
    }

    /// Rate of the value at given rates of all coordinates.
    pub fn rate(&self, rates: &[f64]) -> f64 {
        self.entries().iter().map(|&(i, d)| d * rates[i]).sum()
    }

    /// Adds what a force along the function does to the coordinates.
    pub(crate) fn push_on(&self, forces: &mut [f64], force: f64) {
        for &(i, d) in self.entries() {
            forces[i] += force * d;
        }
    }

    /// The sum with s times another, which depends on the same coordinates or on others; both together at most six.
    pub(crate) fn plus(&self, s: f64, other: &Self) -> Self {
        let mut sum = *self;
        sum.value += s * other.value;
        for &(i, d) in other.entries() {
            match sum.entries[..sum.count].iter_mut().find(|e| e.0 == i) {
                Some(entry) => entry.1 += s * d,
                None => sum.push(i, s * d),
            }
        }
        sum
    }
}
