//! Parts as polygons and paths of other crates, and back: their own areas and lengths judge.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use cspace::part::{circle_loop, rectangle_loop};
use cspace::{Edge, OutlineBuilder, Part, Point, Vector};
use kurbo::{ParamCurve, Shape};

/// A plate with rounded corners, a slot and a hole, in which an island lies.
fn plate() -> Part {
    let outline = OutlineBuilder::start([0.0, 0.0])
        .line_to([20.0, 0.0])
        .fillet(2.0)
        .line_to([20.0, 10.0])
        .arc_to([0.0, 10.0], 0.3)
        .close()
        .unwrap();
    let hole = circle_loop([12.0, 5.0], 3.0).unwrap();
    let island = rectangle_loop([12.0, 5.0], 2.0, 1.0).unwrap();
    let slot = Part::slot("slot", [4.0, 3.0], [4.0, 6.0], 1.0).unwrap();
    let slot = slot.loops()[0].vertices().to_vec();
    Part::new("plate", vec![outline, hole, island, slot]).unwrap()
}

#[test]
fn a_path_has_the_area_and_length_of_the_part() {
    let (part, tolerance) = (plate(), 1e-9);
    let path = part.to_bez_path(tolerance);
    let length: f64 = part.edges().map(|e| e.length()).sum();
    assert!((path.area() - part.area()).abs() < tolerance * length);
    assert!((path.perimeter(1e-10) - length).abs() < 1e-7);
    assert_eq!(path.subpaths().count(), part.loops().len());
}

#[test]
fn an_arc_becomes_an_edge_and_an_edge_an_arc() {
    for (k, sweep) in [0.1, 1.0, PI, 5.0, -0.1, -2.0, -6.0]
        .into_iter()
        .enumerate()
    {
        let start = 0.7 * k as f64;
        let arc = kurbo::Arc::new((3.0, -1.0), (2.5, 2.5), start, sweep, 0.4);
        let edge = Edge::try_from(arc).unwrap();
        let back = edge.to_arc().unwrap();
        let path = |arc: kurbo::Arc| arc.to_path(1e-12).segments().collect::<Vec<_>>();
        for (a, b) in path(arc).iter().zip(path(back)) {
            for t in [0.0, 0.5, 1.0] {
                assert!(a.eval(t).distance(b.eval(t)) < 1e-12, "{sweep}");
            }
        }
    }
    let ellipse = kurbo::Arc::new((0.0, 0.0), (2.0, 2.000001), 0.0, FRAC_PI_2, 0.0);
    let message = Edge::try_from(ellipse).unwrap_err().to_string();
    assert!(message.contains("2.000001"), "{message}");
    let circle = kurbo::Arc::new((0.0, 0.0), (2.0, 2.0), 0.0, TAU, 0.0);
    assert!(Edge::try_from(circle).is_err());
    assert!(
        Edge::between(Point::ORIGIN, Point::new(1.0, 0.0), 0.0)
            .to_arc()
            .is_none()
    );
}

#[test]
fn polygons_have_the_holes_and_islands_of_the_part() {
    let part = plate();
    let polygons = part.to_polygons(1e-6);
    let mut holes: Vec<usize> = polygons.iter().map(|p| p.interiors().len()).collect();
    holes.sort_unstable();
    assert_eq!(holes, [0, 2]);
    let back = Part::from_polygons("back", polygons).unwrap();
    let length: f64 = part.edges().map(|e| e.length()).sum();
    let lost = (part.area() - back.area()).abs();
    assert!(0.0 < lost && lost < 1e-6 * length, "{lost}");
}

#[test]
fn points_and_vectors_are_those_of_mint() {
    let (p, v) = (Point::new(1.0, 2.0), Vector::new(3.0, 4.0));
    let (mint_p, mint_v): (mint::Point2<f64>, mint::Vector2<f64>) = (p.into(), v.into());
    assert_eq!((mint_p.y, mint_v.x), (2.0, 3.0));
    assert_eq!((Point::from(mint_p), Vector::from(mint_v)), (p, v));
}
