//! Areas of shrunk parts, by formulas.

use core::f64::consts::PI;

use cspace::{Part, Vertex};
use cspace_plan::{grown, shrunk};

fn square(half: f64) -> Vec<Vertex> {
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
}

fn area(part: &Part, radius: f64) -> f64 {
    shrunk(part, radius).unwrap().map_or(0.0, |p| p.area())
}

/// Slices are right to some 10⁻¹¹ of the size, along some tens of lengths here.
fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-8, "{a} is not {b}");
}

#[test]
fn a_disc_becomes_a_smaller_disc() {
    let disc = Part::circle("disc", (3.0, -2.0), 2.0).unwrap();
    close(area(&disc, 0.5), PI * 2.25);
    close(area(&disc, 1.999), PI * 1e-6);
    assert_eq!(shrunk(&disc, 2.5), Ok(None));
}

#[test]
fn a_hole_becomes_larger_with_round_corners() {
    let frame = Part::new("frame", vec![square(3.0), square(1.0)]).unwrap();
    // Outside 6 − 2 r, inside 2 with r around and quarters of a disc at the corners.
    let r = 0.25;
    close(area(&frame, r), 5.5 * 5.5 - (4.0 + 8.0 * r + PI * r * r));
}

#[test]
fn an_island_in_a_hole_shrinks_too() {
    let island = Part::new("island", vec![square(5.0), square(3.0), square(1.0)]).unwrap();
    let r = 0.25;
    let frame = 9.5 * 9.5 - (36.0 + 24.0 * r + PI * r * r);
    close(area(&island, r), frame + 1.5 * 1.5);
    // The island goes first, then the sides of the frame, and its corners where (2 − r) √2 = r.
    let corners = shrunk(&island, 1.1).unwrap().unwrap();
    assert_eq!(corners.loops().len(), 4);
    assert_eq!(shrunk(&island, 1.2), Ok(None));
}

#[test]
fn a_bridge_breaks_and_two_pieces_are_left() {
    // Two squares of 4, joined by a bridge 0.4 wide.
    let dumbbell = Part::polygon(
        "dumbbell",
        &[
            (-5.0, -2.0),
            (-1.0, -2.0),
            (-1.0, -0.2),
            (1.0, -0.2),
            (1.0, -2.0),
            (5.0, -2.0),
            (5.0, 2.0),
            (1.0, 2.0),
            (1.0, 0.2),
            (-1.0, 0.2),
            (-1.0, 2.0),
            (-5.0, 2.0),
        ],
    )
    .unwrap();
    let shrunk = shrunk(&dumbbell, 0.5).unwrap().unwrap();
    assert_eq!(shrunk.loops().len(), 2);
    // Squares of 3, and a nook towards the bridge between the discs about its corners.
    let nook = {
        // Half the nook: from the side at height 0 up to the crossing of the disc, the area left of the disc.
        let (r, h) = (0.5_f64, 0.2_f64);
        let angle = (h / r).asin();
        2.0 * (h * r - 0.5 * (h * (r * r - h * h).sqrt() + r * r * angle))
    };
    close(shrunk.area(), 2.0 * (9.0 + nook));
}

#[test]
fn what_is_grown_and_shrunk_again_is_the_same_if_it_is_convex() {
    let plate = Part::rectangle("plate", (1.0, 2.0), 3.0, 2.0).unwrap();
    let back = shrunk(&grown(&plate, 0.3).unwrap(), 0.3).unwrap().unwrap();
    close(back.area(), 6.0);
}

#[test]
fn what_is_no_radius_is_refused() {
    let disc = Part::circle("disc", (0.0, 0.0), 1.0).unwrap();
    assert!(shrunk(&disc, 0.0).is_err());
    assert!(shrunk(&disc, -1.0).is_err());
    assert!(shrunk(&disc, f64::NAN).is_err());
    assert!(shrunk(&disc, f64::INFINITY).is_err());
}
