//! Two parts, the moving one held in a box: as parts, by a disc on the one in a frame on the other, above both.

use core::f64::consts::{PI, TAU};

use cspace::part::polygon_loop;
use cspace::{Coordinates, Layer, Options, PairSpace, Part, PartError, Progress, Relation, Vertex};

use crate::legs::Coords;

use super::error::FitError;

/// A disc in a frame, beside half of the box, as a share of the parts' size.
const DISC: f64 = 0.1;

/// Two parts and a box of configurations, given by its middle and half of its extent in x, y and θ.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held<'a> {
    pub(super) parts: [&'a Part; 2],
    pub(super) middle: Coords,
    pub(super) half: Coords,
}

impl Held<'_> {
    /// A configuration in the box at which a moving part is free; `None` if there is none.
    pub(super) fn free(
        &self,
        moving: &Part,
        progress: &dyn Progress,
    ) -> Result<Option<Coords>, FitError> {
        let [x, y, theta] = self.middle;
        let [dx, dy, turn] = self.half;
        let radius = DISC * self.parts[0].size().max(self.parts[1].size());
        let around = |dx: f64, dy: f64| {
            polygon_loop(&[
                (x - dx, y - dy),
                (x + dx, y - dy),
                (x + dx, y + dy),
                (x - dx, y + dy),
            ])
        };
        let frame = vec![
            around(dx + 2.0 * radius, dy + 2.0 * radius),
            around(dx + radius, dy + radius),
        ];
        let disc = vec![vec![
            Vertex::new(radius, 0.0, 1.0),
            Vertex::new(-radius, 0.0, 1.0),
        ]];
        let heights = heights(self.parts[0], moving);
        let fixed = below(self.parts[0], heights, frame)?;
        let moving = below(moving, heights, disc)?;
        let options = Options {
            window: (turn < PI).then_some((theta - turn, theta + turn)),
            ..Options::default()
        };
        let space = PairSpace::compute_with(&fixed, &moving, Relation::Planar, &options, progress)?;
        // The disc does not come through the frame: a region is in the box or beyond it.
        let is_inside = |at: Coords| (at[0] - x).abs() <= dx && (at[1] - y).abs() <= dy;
        let samples = space.regions().into_iter().filter_map(|r| match r.sample {
            Coordinates::Planar(c) => {
                // In the turn that is nearest to the middle.
                let turns = ((theta - c.theta) / TAU).round();
                Some([c.x, c.y, c.theta + TAU * turns])
            }
            Coordinates::Axes { .. } => None,
        });
        let found = samples.into_iter().find(|&at| is_inside(at));
        match &space {
            PairSpace::Planar(planar) if found.is_none() && planar.statistics().conflicts > 0 => {
                Err(FitError::Doubtful)
            }
            _ => Ok(found),
        }
    }
}

/// The lowest and the highest place of two parts.
fn heights(a: &Part, b: &Part) -> [f64; 2] {
    let all = a.layers().iter().chain(b.layers()).filter_map(|l| l.z());
    all.reduce(|[lo, hi], [low, high]| [lo.min(low), hi.max(high)])
        .unwrap_or([0.0, 1.0])
}

/// A part within heights, with outlines above them.
fn below(part: &Part, [lo, hi]: [f64; 2], above: Vec<Vec<Vertex>>) -> Result<Part, PartError> {
    // What is at every height is at all that there are.
    let z = |layer: &Layer| Some(layer.z().unwrap_or([lo, hi]));
    let layers = (part.layers().iter()).map(|layer| (z(layer), part.outline(layer)));
    let high = hi - lo;
    let above = (Some([hi + high, hi + 2.0 * high]), above);
    Part::layered(part.name(), layers.chain([above]))
}
