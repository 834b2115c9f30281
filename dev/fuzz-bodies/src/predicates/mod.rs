//! Predicates for signs, roots and meetings, against exact arithmetic.

mod ball;
mod capped;
mod events;
mod loops;
mod polynomial;
mod trig;

use crate::Finding;
use crate::draw::Bytes;

/// The first byte chooses the predicate, the others are its arguments.
pub(crate) fn run(data: &[u8]) -> Result<u64, Finding> {
    let mut bytes = Bytes::new(data);
    match bytes.below(6) {
        0 => trig::run(&mut bytes),
        1 => events::run(&mut bytes),
        2 => polynomial::run(&mut bytes),
        3 => ball::run(&mut bytes),
        4 => ball::run_jet(&mut bytes),
        _ => loops::run(&mut bytes),
    }
}
