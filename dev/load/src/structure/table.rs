//! Pairs whose number of free regions is known, most of them.

use cspace::Part;
use cspace_oracle::shapes::notches::{corridor, half_round_notch, l_shape, sofa, v_slot_profile};
use cspace_oracle::shapes::{gear, plate, regular_polygon, scaled};

use super::families::{Change, POWERS, noisy};
use super::{Specimen, TABLE};

/// The arms of the L and of the corridor, in tenths from the outer corner.
const ARM: i32 = 40;

/// Sizes of sofas, with the number of free regions in the corridor and outside: one in which it goes round the corner,
/// and one for each arm in which it has the opposite orientation. The smallest can turn in the corner.
const SOFAS: [(f64, usize); 9] = [
    (0.5, 3),
    (0.7, 4),
    (0.9, 4),
    (0.95, 4),
    (0.99, 4),
    (0.999, 4),
    (0.9999, 4),
    (0.99999, 4),
    (0.999999, 4),
];

/// Noise of a share of a sofa's play that its passage does not notice, with room to spare.
const HARMLESS: f64 = 1e-2;

/// Excess of a hole's size over its content, as a share; other holes fit exactly.
const PLAY: f64 = 1e-3;

pub(super) fn table() -> Vec<Specimen> {
    let notch = half_round_notch(2, 5, 5);
    let new = |name: &str, fixed: &Part, moving: &Part| Specimen::new(TABLE, name, fixed, moving);
    let mut all = vec![
        new("half-round notch in an L corridor", &corridor(ARM), &notch).expecting(2),
        new("half-round notch and an L", &l_shape(ARM), &notch).expecting(1),
    ];
    all.extend(sofas(TABLE));
    let profile = v_slot_profile();
    all.push(new("V-slot profile and itself", &profile, &profile));
    let hole = |side: f64, part: &Part, play: f64| plate(side, &[&scaled(part, 1.0 + play)]);
    let wheel = gear(8, 1.0);
    all.push(new("gear in its own hole", &hole(14.0, &wheel, 0.0), &wheel).expecting(1));
    for (what, corners) in [("square", 4), ("hexagon", 6)] {
        let polygon = regular_polygon(corners, 1.0);
        let hole = |play| hole(4.0, &polygon, play);
        let name = format!("{what} in its own hole");
        all.push(new(&name, &hole(0.0), &polygon).expecting(1));
        let name = format!("{name}, play {PLAY:e}");
        all.push(new(&name, &hole(PLAY), &polygon).expecting(1 + corners));
    }
    all
}

fn sofas(family: &'static str) -> [Specimen; 9] {
    SOFAS.map(|(scale, regions)| {
        let name = format!("sofa {scale} in its corridor");
        Specimen::new(family, name, &corridor(ARM), &sofa(scale)).expecting(regions)
    })
}

/// Sofas with noise that their passage does not notice.
pub(super) fn add_sofas(all: &mut Vec<Specimen>, seed: u64, times: u32) {
    let drawn = sofas("sofa");
    for power in POWERS {
        for (plain, (scale, _)) in drawn.iter().zip(SOFAS) {
            if 10f64.powi(-power) > HARMLESS * (1.0 - scale) {
                continue;
            }
            all.extend((0..times).map(|k| noisy(plain, Change::Noise(power, k), seed)));
        }
    }
}
