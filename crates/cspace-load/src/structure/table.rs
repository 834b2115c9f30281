//! Pairs whose number of free regions is known, most of them.

use cspace::Part;
use cspace_oracle::shapes::notches::{corridor, half_round_notch, l_shape, sofa, v_slot_profile};
use cspace_oracle::shapes::{gear, plate, scaled, square};

use super::families::{Change, POWERS, noisy};
use super::{Specimen, TABLE};

/// The arms of the L and of the corridor, in tenths from the outer corner.
const ARM: i32 = 40;

/// How large sofas are, and how many free regions there are in the corridor and outside: one in which it goes round the corner,
/// and one for each arm in which it is the other way round. The smallest can turn in the corner.
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

pub(super) fn table() -> Vec<Specimen> {
    let notch = half_round_notch(2, 5, 5);
    let new = |name: &str, fixed: &Part, moving: &Part| Specimen::new(TABLE, name, fixed, moving);
    let mut all = vec![
        new("half-round notch in an L corridor", &corridor(ARM), &notch).expecting(2),
        new("half-round notch and an L", &l_shape(ARM), &notch).expecting(1),
    ];
    all.extend(SOFAS.map(|(scale, regions)| {
        let name = format!("sofa {scale} in its corridor");
        new(&name, &corridor(ARM), &sofa(scale)).expecting(regions)
    }));
    let profile = v_slot_profile();
    all.push(new("V-slot profile and itself", &profile, &profile));
    let hole = |side: f64, part: &Part, play: f64| plate(side, &[&scaled(part, 1.0 + play)]);
    let (block, wheel) = (square(2.0), gear(8, 1.0));
    for (play, of_block, of_wheel) in [(0.0, 1, 1), (1e-3, 5, 9)] {
        let name = |what: &str| match play {
            0.0 => format!("{what} in its own hole"),
            _ => format!("{what} in its own hole, play {play:e}"),
        };
        all.push(new(&name("square"), &hole(4.0, &block, play), &block).expecting(of_block));
        all.push(new(&name("gear"), &hole(14.0, &wheel, play), &wheel).expecting(of_wheel));
    }
    all
}

/// Sofas with noise that their passage does not notice.
pub(super) fn add_sofas(all: &mut Vec<Specimen>, seed: u64, times: u32) {
    let drawn = SOFAS.map(|(scale, regions)| {
        let name = format!("sofa {scale} in its corridor");
        Specimen::new("sofa", name, &corridor(ARM), &sofa(scale)).expecting(regions)
    });
    for power in POWERS {
        for (plain, (scale, _)) in drawn.iter().zip(SOFAS) {
            if 10f64.powi(-power) > HARMLESS * (1.0 - scale) {
                continue;
            }
            all.extend((0..times).map(|k| noisy(plain, Change::Noise(power, k), seed)));
        }
    }
}
