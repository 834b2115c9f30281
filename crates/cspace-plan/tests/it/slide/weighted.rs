//! Configurations as vectors of which all coordinates count alike: the way in which sliding takes the nearest one to a goal.

use core::f64::consts::PI;

use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, PairSpace, Part, Point, Rotation, Vector,
};
use rand::Rng;
use rand_chacha::ChaCha8Rng;

pub(crate) struct Weighted<'a> {
    space: &'a PairSpace,
    /// For planar pairs: the middle of each part, and how far the moving part's vertices are from its own.
    middles: [Point; 2],
    radius: f64,
    /// Lengths are counted in units of 1 / scale.
    scale: f64,
}

fn far(part: &Part, from: Point) -> f64 {
    let vertices = part.loops().iter().flat_map(|l| l.vertices());
    let away = vertices.map(|v| Point::new(v.x, v.y).distance(from));
    away.fold(0.0, f64::max)
}

impl<'a> Weighted<'a> {
    pub(crate) fn new(space: &'a PairSpace) -> Self {
        let frame = match space {
            PairSpace::Planar(planar) => planar.data().frame,
            PairSpace::FixedAxes(axes) => axes.frame(),
            PairSpace::Lower(_) => panic!("parts that are joined do not slide"),
        };
        let (middles, scale) = ([frame.fixed_center, frame.moving_center], frame.scale);
        Self {
            space,
            radius: far(space.moving(), middles[1]) * scale,
            middles,
            scale,
        }
    }

    fn axes(&self) -> Option<[Axis; 2]> {
        match self.space {
            PairSpace::FixedAxes(space) => Some(space.axes().into()),
            _ => None,
        }
    }

    fn units(&self) -> [f64; 2] {
        self.axes().map_or([1.0; 2], |axes| {
            axes.map(|a| match a.motion {
                AxisMotion::Prismatic { .. } => 1.0 / self.scale,
                _ => 1.0,
            })
        })
    }

    pub(crate) fn vector(&self, at: Coordinates) -> [f64; 3] {
        match at {
            Coordinates::Planar(c) => {
                let p = c.position() + Rotation::by(c.theta) * self.middles[1].to_vector();
                [p.x * self.scale, p.y * self.scale, c.theta * self.radius]
            }
            Coordinates::Axes { u, v } => {
                let [a, b] = self.units();
                [u / a, v / b, 0.0]
            }
        }
    }

    pub(crate) fn configuration(&self, [a, b, c]: [f64; 3]) -> Coordinates {
        if self.axes().is_some() {
            let [u, v] = self.units();
            return Coordinates::Axes { u: a * u, v: b * v };
        }
        let theta = c / self.radius;
        let p = Vector::new(a, b) * (1.0 / self.scale)
            - Rotation::by(theta) * self.middles[1].to_vector();
        Coordinates::Planar(Configuration::new(p.x, p.y, theta))
    }

    /// The distance of two configurations.
    pub(crate) fn apart(&self, a: Coordinates, b: Coordinates) -> f64 {
        let (a, b) = (self.vector(a), self.vector(b));
        (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
    }

    /// Some configuration that the parts can have, with both near enough to touch, more or less.
    pub(crate) fn anywhere(&self, rng: &mut ChaCha8Rng) -> Coordinates {
        let mut along = |lo: f64, hi: f64| lo + (hi - lo) * rng.random::<f64>();
        let reach = far(self.space.fixed(), self.middles[0]) + self.radius / self.scale;
        if let Some(axes) = self.axes() {
            let [u, v] = axes.map(|axis| match (axis.motion, axis.range) {
                (AxisMotion::Fixed, _) => 0.0,
                (_, Some((lo, hi))) => along(lo, hi),
                (AxisMotion::Revolute { .. }, None) => along(-PI, PI),
                (AxisMotion::Prismatic { .. }, None) => along(-2.0 * reach, 2.0 * reach),
            });
            return Coordinates::Axes { u, v };
        }
        let (lo, hi) = self.window();
        let theta = along(lo, hi);
        let by = Vector::new(along(-reach, reach), along(-reach, reach)) * 1.1;
        let p = self.middles[0] + by - Rotation::by(theta) * self.middles[1].to_vector();
        Coordinates::Planar(Configuration::new(p.x, p.y, theta))
    }

    fn window(&self) -> (f64, f64) {
        match self.space {
            PairSpace::Planar(space) => (space.window().lo, space.window().hi),
            _ => (-PI, PI),
        }
    }

    /// Brought into the window.
    pub(crate) fn within(&self, at: Coordinates) -> Coordinates {
        match (self.space, at) {
            (PairSpace::Planar(space), Coordinates::Planar(c)) if !space.window().full_turn => {
                let (lo, hi) = self.window();
                Coordinates::Planar(Configuration::new(c.x, c.y, c.theta.clamp(lo, hi)))
            }
            _ => at,
        }
    }

    /// Which coordinates can change.
    pub(crate) fn moves(&self) -> [bool; 3] {
        match self.axes() {
            Some(axes) => {
                let [a, b] = axes.map(|a| a.motion != AxisMotion::Fixed);
                [a, b, false]
            }
            None => [true; 3],
        }
    }
}
