//! Models to begin with, drawn from their dimensions.

mod cam;
mod gears;
mod geneva;
mod latch;
mod page;
mod peg;
mod ratchet;

use clap::Subcommand;

use crate::failure::Failure;

/// A model that `cspace new` can write, with its dimensions as options.
#[derive(Debug, Subcommand)]
pub(crate) enum Template {
    /// A bolt in a catch: does it come out?
    #[command(allow_negative_numbers = true)]
    Latch(latch::Latch),
    /// A cam on its shaft and a flat follower in its guide: the lift
    #[command(allow_negative_numbers = true)]
    Cam(cam::Cam),
    /// Two spur gears on their shafts: do they turn, and with what backlash?
    #[command(allow_negative_numbers = true)]
    Gears(gears::Gears),
    /// A Geneva wheel and its driver: step and dwell
    #[command(allow_negative_numbers = true)]
    Geneva(geneva::Geneva),
    /// A ratchet wheel and its pawl on their pivots: which way does it turn?
    #[command(allow_negative_numbers = true)]
    Ratchet(ratchet::Ratchet),
    /// A peg and a chamfered hole: how far may it be off and tilted?
    #[command(allow_negative_numbers = true)]
    Peg(peg::Peg),
}

impl Template {
    /// The model as the text of a TOML file.
    pub(crate) fn text(&self) -> Result<String, Failure> {
        match self {
            Self::Latch(latch) => latch.text(),
            Self::Cam(cam) => cam.text(),
            Self::Gears(gears) => gears.text(),
            Self::Geneva(geneva) => geneva.text(),
            Self::Ratchet(ratchet) => ratchet.text(),
            Self::Peg(peg) => peg.text(),
        }
    }
}
