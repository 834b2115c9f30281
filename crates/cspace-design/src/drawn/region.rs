//! Contacts that are possible in a box of configurations, for all drawings that the numbers enclose.

use cspace::{Dual, FeatureShape, Layer, Placement, contact_function, touching_place};

use super::{DrawnContact, DrawnEdge, DrawnPair, Enclosure, OfCircle, within_ends};

/// A box of configurations, (x, y, θ) or (u, v, 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConfigurationBox<T> {
    /// The middle.
    pub middle: [f64; 3],
    /// Half widths; 0 for a coordinate that is held.
    pub half: [f64; 3],
    /// The whole box, in numbers that enclose each coordinate.
    pub all: [T; 3],
}

/// A place of a part that can prove that the parts overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Witness {
    /// A point that is inside the part in every drawing.
    Inside([f64; 2]),
    /// The vertex at which an edge starts, by the number of the edge.
    Vertex(u32),
    /// The middle of an edge, by its number.
    Middle(u32),
}

impl<T: Enclosure> DrawnPair<T> {
    /// The contacts that may occur in a box of configurations, in any of the enclosed drawings, among those possible in a larger box. If
    /// there are none, no two boundaries touch in the box: the parts are apart in all of it and in all drawings, or overlap in all.
    pub fn contacts_in(
        &self,
        within: &ConfigurationBox<T>,
        among: Option<&[DrawnContact]>,
    ) -> Vec<DrawnContact> {
        let at = within.all;
        let may = |contact: &DrawnContact| self.may_touch(*contact, within);
        if let Some(among) = among {
            return among.iter().copied().filter(may).collect();
        }
        let facing = self.facing(at);
        let [fixed, moving] = self.discs();
        let mut found = Vec::new();
        for (i, f) in (0u32..).zip(&fixed) {
            for (j, m) in (0u32..).zip(&moving) {
                if !f.apart(m, &facing).is_certain() {
                    found.extend(self.contacts(i, j).filter(may));
                }
            }
        }
        found
    }

    /// Places on the outline of a part: its vertices and the middles of its edges, each with its layer.
    pub fn outline(&self, part: usize) -> impl Iterator<Item = (Witness, &Layer)> {
        (0..).zip(&self.edges[part]).flat_map(|(i, edge)| {
            [Witness::Vertex(i), Witness::Middle(i)].map(|witness| (witness, &edge.layer))
        })
    }

    /// Position of a place of a part, in the part's frame.
    pub fn place(&self, part: usize, of: Witness) -> [T; 2] {
        let [x, y] = self.held(part, of);
        match self.axes.map(|axes| axes[part].origin()) {
            Some(origin) => [x + origin[0], y + origin[1]],
            None => [x, y],
        }
    }

    /// As [`place`](Self::place), in the frame in which features are stored.
    fn held(&self, part: usize, of: Witness) -> [T; 2] {
        let edge = |edge: u32| match self.edges[part][edge as usize].shape {
            FeatureShape::Edge { start, end, bulge } => (start, end, bulge),
            FeatureShape::Vertex { at } => (at, at, T::constant(0.0)),
        };
        match of {
            Witness::Vertex(i) => edge(i).0,
            Witness::Middle(i) => {
                let (start, end, bulge) = edge(i);
                let half = T::constant(0.5);
                let [x, y] = [end[0] - start[0], end[1] - start[1]];
                [
                    half * (start[0] + end[0] + bulge * y),
                    half * (start[1] + end[1] - bulge * x),
                ]
            }
            Witness::Inside(point) => {
                let [x, y] = point.map(T::constant);
                match self.axes.map(|axes| axes[part].origin()) {
                    Some(origin) => [x - origin[0], y - origin[1]],
                    None => [x, y],
                }
            }
        }
    }

    /// Whether the boundary of the other part may pass through a place of one part, at some configurations in some of the drawings. If it
    /// does not, and the place is inside the other part at one of them, the parts overlap at all these configurations in all drawings.
    pub fn may_pass(&self, within: &ConfigurationBox<T>, part: usize, of: Witness) -> bool {
        let at = within.all;
        let [x, y] = self.held(part, of);
        let facing = self.facing(at);
        let there = if part == 1 { facing } else { facing.inverse() };
        let point = FeatureShape::Vertex {
            at: there.point([x, y]),
        };
        let still = Placement::identity();
        self.edges[1 - part].iter().any(|edge| {
            let gap = contact_function(&edge.shape, &point, &still).ball();
            let is_on = || {
                let place = touching_place(&edge.shape, &point, &still).on_fixed;
                let within = within_ends(&edge.shape, place);
                edge.circle == OfCircle::Whole || within.into_iter().all(|x| x.ball().sign() >= 0)
            };
            gap.sign() == 0 && edge.circle != OfCircle::Other && is_on()
        })
    }

    /// Largest deviation of a part's boundary, in any of the drawings, from that of the middle one. A place of an edge is start + z chord
    /// with |z| and |1 − z| at most max(1, |b|) for its bulge b, and z moves with b by at most as much.
    pub fn deviation(&self, part: usize) -> f64 {
        let origin = self.axes.map(|axes| axes[part].origin());
        let place = |[x, y]: [T; 2]| match origin {
            Some(origin) => [x + origin[0], y + origin[1]],
            None => [x, y],
        };
        let off = |p: [T; 2]| place(p).map(T::spread).into_iter().fold(0.0, f64::hypot);
        let of = |edge: &DrawnEdge<T>| match edge.shape {
            FeatureShape::Vertex { at } => off(at),
            FeatureShape::Edge { start, end, bulge } => {
                let largest = bulge.abs().ball().ends()[1].max(1.0);
                let chord = (end[0] - start[0]).hypot(end[1] - start[1]);
                let bent = chord.ball().ends()[1] * bulge.spread();
                largest * (off(start) + off(end) + bent)
            }
        };
        self.edges[part].iter().map(of).fold(0.0, f64::max)
    }

    /// Whether a contact function may be 0 in a box, at a place on both features. By the mean value theorem it differs from its value in
    /// the middle by at most Σ |∂f| half.
    fn may_touch(&self, contact: DrawnContact, within: &ConfigurationBox<T>) -> bool {
        let at = within.all;
        let constant = |x: T| Dual::<3, T> {
            value: x,
            slope: [T::constant(0.0); 3],
        };
        let moved: [Dual<3, T>; 3] = core::array::from_fn(|i| Dual::variable(at[i], i));
        let anywhere = self.gap(contact, moved, constant);
        if anywhere.value.ball().sign() != 0 {
            return false;
        }
        let middle = self
            .gap(contact, within.middle.map(T::constant), |x| x)
            .ball();
        let rise = (0..3).map(|i| {
            let slope = anywhere.slope[i].ball();
            // Zero times an unknown number is zero.
            if within.half[i] == 0.0 {
                0.0
            } else {
                (slope.mid.abs() + slope.radius) * within.half[i]
            }
        });
        let rise: f64 = rise.sum();
        if middle.mid.abs() > (middle.radius + rise) * (1.0 + 1e-9) {
            return false;
        }
        let on = self.within(contact, at);
        on.into_iter().flatten().all(|x| x.ball().sign() >= 0)
    }
}
