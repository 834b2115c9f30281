//! Areas and features of the drawn shapes, known by hand.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::Part;
use cspace_oracle::judge::area;
use cspace_oracle::shapes::notches::*;
use cspace_oracle::shapes::*;

#[track_caller]
fn has_area(p: &Part, expected: f64) {
    assert!(
        (area(p) - expected).abs() < 1e-12 * expected.max(1.0),
        "{}: {}",
        p.name(),
        area(p)
    );
    for q in [
        turned(p, 1.0),
        mirrored(p),
        shifted(p, 3.0, -4.0),
        backwards(p),
    ] {
        assert!(
            (area(&q) - expected).abs() < 1e-11 * expected.max(1.0),
            "{}",
            q.name()
        );
    }
    assert!((area(&scaled(p, 3.0)) - 9.0 * expected).abs() < 1e-11 * expected.max(1.0));
}

#[test]
fn areas() {
    has_area(&rectangle(3.0, 2.0), 6.0);
    has_area(&square(2.0), 4.0);
    has_area(&regular_polygon(6, 1.0), 1.5 * 3f64.sqrt());
    has_area(&circle(2.0), 4.0 * PI);
    has_area(&annulus(2.0, 1.0), 3.0 * PI);
    has_area(&half_disc(2.0), 2.0 * PI);
    let flat = 10f64.to_radians();
    has_area(
        &flatted_disc(1.0, 2.0 * PI - flat),
        PI - 0.5 * (flat - flat.sin()),
    );
    has_area(&rounded_rectangle(3.0, 2.0, 0.5), 6.0 - 1.0 + PI * 0.25);
    // A bulge of 1 is a half circle.
    has_area(&lens(1.0, 1.0), PI);
    let quarter = (PI / 8.0).tan();
    has_area(&lens(1.0, quarter), 2.0 * (FRAC_PI_2 - 1.0));
    has_area(&crescent(1.0, 1.0, quarter), FRAC_PI_2 - (FRAC_PI_2 - 1.0));
    has_area(&ring_sector(2.0, 1.0, 0.0, 1.0), 1.5);
    has_area(&c_shape(2.0, 1.0, 0.5), 1.5 * (2.0 * PI - 1.0));
    has_area(&peg(1.0, 3.0), 3.0);
    has_area(&rounded_peg(2.0, 3.0), 4.0 + FRAC_PI_2);
    has_area(&slotted_block(4.0, 1.0, 2.0, 0.0), 16.0 - 2.0);
    has_area(&slotted_block(4.0, 1.0, 2.0, 0.5), 16.0 - 2.0 - 0.25);
    has_area(&socket(1.0), 8.0 - FRAC_PI_2);
    has_area(&plate(4.0, &[&square(2.0), &circle(0.5)]), 12.0 + 0.25 * PI);
    has_area(&three_holes(1.0, 0.25), 8.0 - 3.0 * PI / 16.0);
    has_area(&three_pegs(1.0, 0.25), 3.0 * PI / 16.0);
    // Half a disc, a bar, and a tip.
    has_area(&pawl(), 0.08 * PI + 1.6 + 0.5);
}

fn edges(p: &Part) -> usize {
    p.loops().iter().map(|l| l.vertices().len()).sum()
}

#[test]
fn areas_of_notched_blocks_and_what_they_hook_into() {
    has_area(&half_round_notch(2, 5, 5), 0.5 - 0.02 * PI);
    has_area(&u_notch(5, 5, 10, 15), 3.0 - 0.5 - 0.125 * PI);
    has_area(&v_notch(5, 5, 10, 10), 2.0 - 0.25);
    has_area(&t_slot(5, 10, 10, 20, 20, 30), 12.0 - 1.0 - 2.0);
    has_area(&dovetail(5, 10, 10, 20, 20), 8.0 - 1.5);
    has_area(&l_shape(40), 7.0);
    has_area(&corridor(40), 36.0 - 7.0);
    has_area(&u_shape(10), 3.0 + 4.0);
    has_area(&t_shape(4, 10, 5), 0.8 + 1.0);
    has_area(&comb(4, 10, 10), 7.0 + 8.0);
    has_area(&sofa(1.0), FRAC_PI_2 + 2.0 / PI);
    // A fillet takes (1 − π/4) r² of each right angle, and gives it at the concave ones.
    let taken = (1.0 - 0.25 * PI) * 0.01;
    has_area(&filleted(&rectangle(3.0, 2.0), 0.1), 6.0 - 4.0 * taken);
    has_area(&filleted(&l_shape(40), 0.1), 7.0 - 4.0 * taken);
    assert!(v_slot_profile().edges().count() > 100);
}

#[test]
fn wheels() {
    for teeth in [9, 10, 12, 24, 26] {
        let g = gear(teeth, 1.0);
        assert_eq!(edges(&g), 4 * teeth);
        let vertices = g.loops()[0].vertices();
        let pitch = 0.5 * teeth as f64;
        for tooth in vertices.chunks(4) {
            // Flank, tip, flank, root: the tips and roots about the wheel's centre, the flanks convex.
            assert!(tooth.iter().all(|v| v.bulge > 0.0));
            for (v, r) in tooth.iter().zip([-1.25, 1.0, 1.0, -1.25]) {
                assert!((v.x.hypot(v.y) - pitch - r).abs() < 1e-12);
            }
        }
    }
    for teeth in [6, 8, 20, 40] {
        let r = ratchet(teeth);
        assert_eq!(edges(&r), 2 * teeth);
        let v = r.loops()[0].vertices();
        assert!((v[1].point().distance(v[3].point()) - 1.0).abs() < 1e-12);
        assert!((v[0].point().distance(v[1].point()) - 0.5).abs() < 1e-12);
    }
    assert_eq!(edges(&rack(4, 1.0)), 4 + 16);
    assert!((area(&gear(10, 2.0)) / area(&gear(10, 1.0)) - 4.0).abs() < 1e-12);
}

#[test]
fn the_maze_is_a_plate_less_its_corridor() {
    let chamber = PI - (PI / 6.0 - 3f64.sqrt() / 4.0);
    // Down, right, up, right with one rounded corner, and down to the chamber.
    let neck = 2.5 + 0.75f64.sqrt();
    let corridor = 9.0 + 2.0 + 8.0 + 3.0 - (0.25 - PI / 16.0) + (8.0 - neck);
    has_area(&maze(), 100.0 - corridor - chamber);
}

#[test]
fn random_parts_are_the_same_each_time() {
    for seed in 0..20 {
        let arcs = 0.1 * (seed % 11) as f64;
        assert_eq!(random_part(seed, 9, arcs), random_part(seed, 9, arcs));
        assert_ne!(random_part(seed, 9, arcs), random_part(seed + 1, 9, arcs));
        assert_eq!(edges(&random_part(seed, 9, arcs)), 9);
        assert_eq!(random_ring(seed, 8, arcs).loops().len(), 2);
        assert_eq!(random_pieces(seed, 3, 5, arcs).loops().len(), 3);
        assert!(area(&random_ring(seed, 8, arcs)) > 0.1);
    }
    assert!(random_part(1, 12, 0.0).edges().all(|e| e.is_line()));
    assert!(!random_part(1, 12, 1.0).edges().any(|e| e.is_line()));
}
