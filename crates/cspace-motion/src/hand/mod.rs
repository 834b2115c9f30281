//! A mechanism that is moved by hand.

mod answer;
mod drag;
mod target;

use cspace::{Placement, Progress, Silent};
use cspace_model::{Compute, Mechanism, compute_anew};

use crate::assemble::assemble;
use crate::error::SimulateError;
use crate::exact_fit::{Gap, Room, overlaps};
use crate::kinematic::close;
use crate::pairs::Pairs;
use crate::simulate::check_ranges;
use crate::system::System;

pub use answer::{Dragged, Ending, Stopper};
pub use target::Target;

/// Parts may be moved by this much to make joints hold in a state that is set, relative to the size of the mechanism.
const MOST_ASSEMBLING: f64 = 10.0;

/// A mechanism that is moved by hand: one part is dragged at a time, and moves what it pushes.
///
/// All drives are released; contacts and joints are those of [`Simulation::kinematic`](crate::Simulation::kinematic), and loads, springs and
/// weights balance. There is no friction, in which a part that is dragged would stick. Where forces act, parts that the model drives hold as brakes do: no load moves them, and a part that is dragged does. What
/// nothing loads stays where it is until it is pushed.
///
/// Parts that overlap in a state that is set are left out of contact with each other until they are apart, so that they can be pulled apart.
/// Parts drawn flush touch, and do not overlap: of two that fit exactly one is smaller by a [gap](Self::gaps).
/// No other parts come to overlap by more than [`MovingPair::touch`](crate::MovingPair::touch).
///
/// A drag depends on the state, on what is smaller, and on the target alone. It uses neither clocks nor threads, and its steps are limited: what is too far away
/// for one call is reached by asking again.
///
/// ```
/// use cspace::Part;
/// use cspace_model::{Mechanism, PartEntry};
/// use cspace_motion::{Ending, Hand, Target};
/// // A slider, a block that it pushes, and a wall.
/// let mut mechanism = Mechanism::new("pushed to a wall");
/// mechanism.parts.push(PartEntry::prismatic(Part::rectangle("slider", (0.0, 0.0), 2.0, 2.0)?, (1.0, 0.0)));
/// mechanism.parts.push(PartEntry::planar(Part::rectangle("block", (4.0, 0.5), 2.0, 2.0)?));
/// mechanism.parts.push(PartEntry::fixed(Part::rectangle("wall", (9.0, 0.0), 2.0, 6.0)?));
/// mechanism.pairs = mechanism.every_two();
/// let mut hand = Hand::new(&mechanism)?;
/// // They are 2 apart.
/// let dragged = hand.drag(0, Target::Axis(2.5))?;
/// assert!(dragged.reached());
/// assert!((hand.state()[1] - 0.5).abs() < 1e-9);
/// // The block comes to the wall, 3 farther on than it was drawn.
/// let dragged = hand.drag(0, Target::Axis(7.0))?;
/// assert_eq!(dragged.ending, Ending::Stopped);
/// assert!((hand.state()[0] - 5.0).abs() < 1e-9);
/// // Nothing draws the block back.
/// hand.drag(0, Target::Axis(0.0))?;
/// assert!((hand.state()[1] - 3.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Hand {
    /// System without drives.
    system: System,
    pairs: Pairs,
    state: Vec<f64>,
    gaps: Vec<Gap>,
}

impl Hand {
    /// Computes the spaces of the pairs of a mechanism; its parts are placed at their start.
    ///
    /// # Errors
    /// If the mechanism is invalid, nothing in it can move, joints cannot hold, or a part is outside of its range or of
    /// the window of a pair.
    pub fn new(mechanism: &Mechanism) -> Result<Self, SimulateError> {
        Self::new_with(mechanism, &Silent)
    }

    /// As [`new`](Self::new), and reports the stages of each space to `progress`.
    ///
    /// # Errors
    /// As [`new`](Self::new), and errors returned by `progress`.
    pub fn new_with(mechanism: &Mechanism, progress: &dyn Progress) -> Result<Self, SimulateError> {
        mechanism.check()?;
        let compute = compute_anew(progress);
        Self::of_by(mechanism, Pairs::compute_by(mechanism, &compute)?, &compute)
    }

    /// Creates the hand from known spaces of the pairs ([`Pairs::of`]); pairs that are not among them never meet.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of(mechanism: &Mechanism, pairs: Pairs) -> Result<Self, SimulateError> {
        mechanism.check()?;
        Self::of_by(mechanism, pairs, &compute_anew(&Silent))
    }

    fn of_by(
        mechanism: &Mechanism,
        pairs: Pairs,
        compute: &Compute<'_>,
    ) -> Result<Self, SimulateError> {
        let driven = System::new(mechanism);
        if driven.count() == 0 {
            return Err(SimulateError::NothingMoves);
        }
        let Some(state) = assemble(&driven, &pairs) else {
            return Err(driven.open_joint(&driven.start()));
        };
        let system = System::released(mechanism);
        let mut hand = Self {
            system,
            pairs: pairs.smooth(),
            state: Vec::new(),
            gaps: Vec::new(),
        };
        // What fits exactly as it is drawn has room wherever it begins. What cannot be so is told where parts are put there.
        let drawn = vec![0.0; state.len()];
        if let Ok(Some(room)) = hand.room_at(&drawn) {
            hand.make(&room, compute)?;
        }
        hand.set_state_by(&state, compute)?;
        Ok(hand)
    }

    /// The coordinates of all parts.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// All coordinates, in the order of [`system`](Self::system).
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// Placement of a part in the assembly's frame; `None` if there is no part with the index.
    pub fn placement(&self, part: usize) -> Option<Placement<f64>> {
        let is_there = part < self.system.parts().len();
        is_there.then(|| self.system.placement(part, &self.state))
    }

    /// The parts that overlap each other, as they are listed in their pairs: they are left out of contact until they are apart.
    pub fn overlapping(&self) -> Vec<(usize, usize)> {
        let all = self.pairs.left_out().iter();
        all.map(|pair| (pair.fixed, pair.moving)).collect()
    }

    /// The parts that are smaller than drawn, because they fit exactly into another as they are drawn, or in a state that was set.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// Sets all coordinates; parts are moved by the shortest displacement to where joints hold. Contacts of pairs that
    /// overlap there are ignored; of two parts that fit exactly one is smaller by a gap from then on.
    ///
    /// # Errors
    /// If the number of coordinates is wrong or they are not finite, joints cannot hold there, a part is outside of
    /// its range or of the window of a pair, or one that fits exactly has edges too short to be smaller. Then nothing is moved.
    pub fn set_state(&mut self, state: &[f64]) -> Result<(), SimulateError> {
        self.set_state_by(state, &compute_anew(&Silent))
    }

    fn set_state_by(&mut self, state: &[f64], compute: &Compute<'_>) -> Result<(), SimulateError> {
        let (found, count) = (state.len(), self.system.count());
        if found != count {
            return Err(SimulateError::Count { found, count });
        }
        let mut q = state.to_vec();
        let room = MOST_ASSEMBLING * self.system.size();
        let is_finite = q.iter().all(|x| x.is_finite());
        if !is_finite || close(&self.system, &self.pairs, &[], 0.0, &mut q, room).is_none() {
            return Err(self.system.open_joint(state));
        }
        check_ranges(&self.system, &q)?;
        if let Some(room) = self.room_at(&q)? {
            self.make(&room, compute)?;
        }
        let found = overlaps(&self.system, self.pairs.all(), &q)?;
        let deep: Vec<_> = (found.deep.iter())
            .map(|(pair, _)| (pair.fixed, pair.moving))
            .collect();
        self.pairs
            .leave_out(|pair| deep.contains(&(pair.fixed, pair.moving)));
        self.state = q;
        Ok(())
    }

    /// The mechanism with room where parts fit exactly, if any do.
    fn room_at(&self, q: &[f64]) -> Result<Option<Room>, SimulateError> {
        let exact = overlaps(&self.system, self.pairs.all(), q)?.exact;
        let is_some = !exact.is_empty();
        is_some.then(|| Room::of(&self.system, &exact)).transpose()
    }

    /// Makes room.
    fn make(&mut self, room: &Room, compute: &Compute<'_>) -> Result<(), SimulateError> {
        room.put_in(&mut self.pairs, compute)?;
        self.system = self.system.reshaped(&room.mechanism);
        self.gaps.extend_from_slice(&room.gaps);
        Ok(())
    }
}
