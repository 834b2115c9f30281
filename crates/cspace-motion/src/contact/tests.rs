#![allow(clippy::unwrap_used)]

use cspace::{Classification, Configuration, Part, Vertex};
use cspace_model::{Mechanism, PartDynamics, PartEntry, PartPosition};

use super::path::Path;
use super::watch::{Met, Watch};
use crate::Simulation;

/// A table 18 wide with a spike 0.01 wide in its middle.
fn table(height: f64) -> Part {
    let corners = [
        (-9.0, -2.0),
        (9.0, -2.0),
        (9.0, 0.0),
        (0.005, 0.0),
        (0.0, height),
        (-0.005, 0.0),
        (-9.0, 0.0),
    ];
    let corners = corners.map(|(x, y)| Vertex::line(x, y)).to_vec();
    Part::new("table", vec![corners]).unwrap()
}

fn simulation(parts: Vec<PartEntry>, start: Option<PartPosition>) -> Simulation {
    let mut mechanism = Mechanism::new("disc and table");
    mechanism.parts = parts;
    mechanism.pairs = mechanism.every_two();
    let moved = PartDynamics {
        start,
        ..Default::default()
    };
    mechanism.dynamics.parts = vec![PartDynamics::default(), moved];
    Simulation::new(&mechanism).unwrap()
}

/// A disc of radius 1 that lies on a table, lifted over a spike or through it.
#[test]
fn what_begins_in_contact_meets_what_is_in_its_way() {
    let disc = Part::circle("disc", (0.0, 0.0), 1.0).unwrap();
    let parts = vec![PartEntry::fixed(table(0.6)), PartEntry::planar(disc)];
    let start = PartPosition::Planar(Configuration::new(-3.0, 1.0, 0.0));
    let simulation = simulation(parts, Some(start));
    let from = simulation.start().to_vec();
    assert_eq!(
        simulation.pairs().list()[0].classify(simulation.system(), &from),
        Ok(Classification::Contact)
    );
    let mut watch = Watch::new(simulation.system(), simulation.pairs());
    for (height, met) in [(1.0 + 1e-3, Some(Met::Contact)), (2.5, None)] {
        let to = vec![3.0, height, 0.0];
        let rates: Vec<f64> = from.iter().zip(&to).map(|(a, b)| b - a).collect();
        let path = Path::new((&from, &rates), (&to, &rates), 1.0);
        assert_eq!(watch.check(&[], &path), met, "{height}");
    }
}

/// Result for a disc of radius 1 that passes over the tip of a spike of height 2. The disc's centre goes from 0.05
/// before the tip to 0.05 past it on a parabola that is 3 + `gap` high above the tip and higher by `bulge` at its ends.
/// `place` maps the centre's coordinates and rates to those of the simulation.
fn over_the_tip(
    simulation: &Simulation,
    [bulge, gap]: [f64; 2],
    place: impl Fn([f64; 2]) -> Vec<f64>,
) -> Option<Met> {
    let high = 3.0 + gap + bulge;
    let (from, to) = (place([-0.05, high]), place([0.05, high]));
    let (down, up) = (place([0.1, -4.0 * bulge]), place([0.1, 4.0 * bulge]));
    let path = Path::new((&from, &down), (&to, &up), 1.0);
    Watch::new(simulation.system(), simulation.pairs()).check(&[], &path)
}

/// A disc that passes over a tip touches it by a hundred millionth, or misses it by as much; the chord of the path is
/// farther away from the tip.
#[test]
fn a_contact_within_a_step_is_met_however_shallow() {
    let disc = Part::circle("disc", (0.0, 0.0), 1.0).unwrap();
    let parts = vec![
        PartEntry::fixed(table(2.0)),
        PartEntry::planar(disc.clone()),
    ];
    let start = PartPosition::Planar(Configuration::new(-0.05, 4.0, 0.0));
    let planar = simulation(parts, Some(start));
    // The table slides along x, against the disc that slides along y.
    let parts = vec![
        PartEntry::prismatic(table(2.0), (1.0, 0.0)),
        PartEntry::prismatic(disc, (0.0, 1.0)),
    ];
    let axes = simulation(parts, Some(PartPosition::Axis(5.0)));
    for bulge in [2e-7, 5e-6, 1e-3] {
        for (gap, met) in [(-1e-8, Some(Met::Contact)), (1e-8, None)] {
            let of_planar = over_the_tip(&planar, [bulge, gap], |[x, y]| vec![x, y, 0.0]);
            assert_eq!(of_planar, met, "planar, {bulge} {gap}");
            let of_axes = over_the_tip(&axes, [bulge, gap], |[x, y]| vec![-x, y]);
            assert_eq!(of_axes, met, "axes, {bulge} {gap}");
        }
    }
}
