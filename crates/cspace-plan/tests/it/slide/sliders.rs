//! Parts that slide without limits, and a part that does not move.

use cspace::{Axis, Coordinates, Options, PairSpace, Part, Relation, Vector};
use cspace_plan::slide::{advance, slide};

/// A slider that is dragged to the right and half as fast upwards comes with its top under the bottom of a wall, which is from −12 to −8 and
/// from −2 to 4: its middle is at (−8, −4) then.
#[test]
fn a_slider_without_limits_stops_at_a_wall() {
    let slider = Part::rectangle("slider", (0.0, 0.0), 6.0, 4.0).unwrap();
    let wall = Part::rectangle("wall", (-10.0, 1.0), 4.0, 6.0).unwrap();
    let relation = Relation::Axes {
        fixed: Axis::prismatic(Vector::new(1.0, 0.5)),
        moving: Axis::FIXED,
    };
    let space = PairSpace::compute(&slider, &wall, relation, &Options::default()).unwrap();
    let at = |u| Coordinates::Axes { u, v: 0.0 };
    for from in [-40.0, -15.862642878602557, -20.0] {
        let stopped = advance(&space, at(from), at(7.2997692913281575)).unwrap();
        let slid = slide(&space, at(from), at(7.2997692913281575)).unwrap();
        assert!(stopped.stopped.is_some() && slid.stopped.is_some());
        let Coordinates::Axes { u, .. } = slid.at else {
            panic!("on axes");
        };
        assert!((u + 4.0 * 5f64.sqrt()).abs() < 1e-9, "{u}");
    }
}
