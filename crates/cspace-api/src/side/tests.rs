//! Features of plain parts, called as one would.

use cspace::{FeatureKind, FeatureName, Part, PartError, Vertex};

use super::place_on_part;

fn named(part: &Part, kind: FeatureKind, loop_index: u32, index: u32) -> String {
    let name = FeatureName {
        kind,
        loop_index,
        index,
    };
    place_on_part(part, name).unwrap_or_default()
}

fn polygon(corners: &[(f64, f64)]) -> Vec<Vertex> {
    let corners = corners.iter();
    corners.map(|&(x, y)| Vertex::line(x, y)).collect()
}

#[test]
fn sides_by_their_normals() -> Result<(), PartError> {
    use FeatureKind::Line;
    // In either direction of the loop.
    let kite = [(3.0, 0.0), (0.0, 3.0), (-3.0, 0.0), (0.0, -3.0)];
    let part = Part::new("kite", vec![polygon(&kite)])?;
    let sides = [0, 1, 2, 3].map(|i| named(&part, Line, 0, i));
    assert_eq!(
        sides,
        [
            "upper right side",
            "upper left side",
            "lower left side",
            "lower right side"
        ]
    );
    let mut back = kite;
    back.reverse();
    let part = Part::new("kite", vec![polygon(&back)])?;
    assert_eq!(named(&part, Line, 0, 0), "lower left side");
    // A third of a right angle off an axis is still its side.
    let wedge = Part::polygon("wedge", &[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0)])?;
    assert_eq!(named(&wedge, Line, 0, 2), "top side");
    Ok(())
}

#[test]
fn walls_of_slots_and_holes() -> Result<(), PartError> {
    use FeatureKind::{Line, Vertex as Corner};
    let slot = [
        (-10.0, -10.0),
        (10.0, -10.0),
        (10.0, 5.0),
        (3.0, 5.0),
        (3.0, -5.0),
        (-3.0, -5.0),
        (-3.0, 5.0),
        (-10.0, 5.0),
    ];
    let hole = [(-9.0, -9.0), (-5.0, -9.0), (-5.0, -7.0), (-9.0, -7.0)];
    let part = Part::new("block", vec![polygon(&slot), polygon(&hole)])?;
    let walls = [3, 4, 5].map(|i| named(&part, Line, 0, i));
    assert_eq!(
        walls,
        [
            "right wall of a recess, at 3, 0",
            "bottom wall of a recess, at 0, -5",
            "left wall of a recess, at -3, 0"
        ]
    );
    assert_eq!(named(&part, Line, 0, 2), "top side");
    assert_eq!(named(&part, Line, 0, 6), "top side");
    let walls = [0, 1, 2, 3].map(|i| named(&part, Line, 1, i));
    let sides = ["bottom", "right", "top", "left"];
    assert_eq!(
        walls,
        sides.map(|side| format!("{side} wall of the hole about -7, -8"))
    );
    assert_eq!(named(&part, Corner, 0, 2), "corner at 10, 5");
    assert_eq!(named(&part, Line, 2, 0), "");
    assert_eq!(named(&part, Line, 0, 8), "");
    Ok(())
}

#[test]
fn circles_holes_and_rounds() -> Result<(), PartError> {
    use FeatureKind::{ConcaveArc, ConvexArc, Line};
    let circle = |x: f64, r: f64| vec![Vertex::new(x - r, 0.0, 1.0), Vertex::new(x + r, 0.0, 1.0)];
    let ring = Part::new("ring", vec![circle(1.0, 5.0), circle(2.0, 1.5)])?;
    let outside = named(&ring, ConvexArc, 0, 1);
    assert_eq!(outside, "circle of radius 5 about 1, 0");
    assert_eq!(named(&ring, FeatureKind::Vertex, 0, 0), outside);
    let inside = named(&ring, ConcaveArc, 1, 0);
    assert_eq!(inside, "hole of radius 1.5 about 2, 0");
    // A plate with a half round to the right, beyond its straight side, and a half round hollow at the top.
    let plate = vec![
        Vertex::line(-4.0, -2.0),
        Vertex::new(4.0, -2.0, 1.0),
        Vertex::line(4.0, 2.0),
        Vertex::new(1.0, 2.0, -1.0),
        Vertex::line(-1.0, 2.0),
        Vertex::line(-4.0, 2.0),
    ];
    let plate = Part::new("plate", vec![plate])?;
    let round = named(&plate, ConvexArc, 0, 1);
    assert_eq!(round, "round of radius 2 about 4, 0");
    let hollow = named(&plate, ConcaveArc, 0, 3);
    assert_eq!(hollow, "hollow of radius 1 about 0, 2");
    assert_eq!(named(&plate, Line, 0, 2), "top side");
    // What an arc stands out over is no side.
    let nose = vec![
        Vertex::line(-4.0, -2.0),
        Vertex::line(4.0, -2.0),
        Vertex::line(4.0, -1.0),
        Vertex::new(4.0, -0.5, 1.0),
        Vertex::line(4.0, 0.5),
        Vertex::line(4.0, 2.0),
        Vertex::line(-4.0, 2.0),
    ];
    let nose = Part::new("nose", vec![nose])?;
    let beside = named(&nose, Line, 0, 4);
    assert_eq!(beside, "left wall of a recess, at 4, 1.25");
    Ok(())
}
