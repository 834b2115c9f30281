//! A function of the coordinates of two parts, to first order.

use cspace::Real;

/// Coordinates of two parts, at most.
pub(crate) const MOST: usize = 6;

/// The value of a function and its derivatives by the coordinates of the system it depends on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Row<T = f64> {
    /// The value.
    pub value: T,
    entries: [(usize, T); MOST],
    count: usize,
}

impl<T: Real> Row<T> {
    /// A value that depends on nothing yet.
    pub(crate) fn new(value: T) -> Self {
        Self {
            value,
            entries: [(0, T::constant(0.0)); MOST],
            count: 0,
        }
    }

    /// Adds to the derivative by a coordinate.
    pub(crate) fn push(&mut self, coordinate: usize, derivative: T) {
        let (known, rest) = self.entries.split_at_mut(self.count);
        if let Some(entry) = known.iter_mut().find(|e| e.0 == coordinate) {
            entry.1 = entry.1 + derivative;
        } else if let Some(entry) = rest.first_mut() {
            *entry = (coordinate, derivative);
            self.count += 1;
        }
    }

    /// The coordinates it depends on, each once, with the derivatives by them.
    pub fn entries(&self) -> &[(usize, T)] {
        &self.entries[..self.count]
    }

    /// Rate of the value at given rates of all coordinates.
    pub fn rate(&self, rates: &[f64]) -> f64 {
        let each = self.entries().iter();
        each.map(|&(i, d)| d.value() * rates[i]).sum()
    }

    /// Adds what a force along the function does to the coordinates.
    pub(crate) fn push_on(&self, forces: &mut [f64], force: f64) {
        for &(i, d) in self.entries() {
            forces[i] += force * d.value();
        }
    }

    /// The sum with s times another, which depends on the same coordinates or on others; both together at most six.
    pub(crate) fn plus(&self, s: T, other: &Self) -> Self {
        let mut sum = *self;
        sum.value = sum.value + s * other.value;
        for &(i, d) in other.entries() {
            sum.push(i, s * d);
        }
        sum
    }
}
