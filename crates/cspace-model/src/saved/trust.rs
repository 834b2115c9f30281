//! Check of whether a saved space is unchanged: the data of a changed file are not used, but computed again.
//!
//! Data can refer to existing items and fit the parts without being the space of these parts: no check of that kind is
//! cheaper than the computation. So a file has a checksum of its data, and where it is missing or differs, the space is
//! computed from the parts in the file, in its window and by its method. It guards against edits and damage, not
//! against forgery.

use std::io;

use cspace::fixed_axes::FixedAxesSpace;
use cspace::pair::PairData;
use cspace::{ContactSpace, Options, PairError, PairSpace, Symmetry};

/// The space itself if the checksum is that of its data, or else the space of its parts.
pub(super) fn trusted(space: PairSpace, told: Option<&str>) -> Result<PairSpace, PairError> {
    if told.is_some_and(|told| told == checksum(&space.data())) {
        return Ok(space);
    }
    Ok(match space {
        PairSpace::Planar(space) => {
            let window = space.window();
            let options = Options {
                window: (!window.full_turn).then_some((window.lo, window.hi)),
                symmetry: if space.symmetry().is_any() {
                    Symmetry::Detect
                } else {
                    Symmetry::Ignore
                },
            };
            let computed = ContactSpace::compute(space.fixed(), space.moving(), &options)?;
            PairSpace::Planar(std::sync::Arc::new(computed))
        }
        PairSpace::FixedAxes(space) => {
            let (a, b) = space.axes();
            let computed = FixedAxesSpace::compute(space.fixed(), a, space.moving(), b)?;
            PairSpace::FixedAxes(Box::new(computed))
        }
        // All of it follows from the joint whenever it is read.
        PairSpace::Lower(pair) => PairSpace::Lower(pair),
    })
}

/// 16 hexadecimal digits that all numbers and names of the data go into, in the order of their fields.
pub(super) fn checksum(data: &PairData<'_>) -> String {
    let mut sum = Sum(FNV_OFFSET);
    // Writing plain data into a number cannot fail.
    let _ = serde_json::to_writer(&mut sum, data);
    format!("{:016x}", sum.0)
}

/// The hash FNV-1a of 64 bits.
struct Sum(u64);

/// Initial value of the FNV-1a hash.
const FNV_OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
/// Multiplier of the FNV-1a hash.
const FNV_PRIME: u64 = 0x0100_0000_01b3;

impl io::Write for Sum {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(FNV_PRIME);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
