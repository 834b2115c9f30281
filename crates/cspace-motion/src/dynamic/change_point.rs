//! Change points: configurations at which the joints of a mechanism that its drives lead do not tell how it goes on.
//!
//! ```text
//!          parallel                 A parallelogram whose cranks come to lie in line can go on as it was or crossed. The two ways are
//!   ________/________               curves through one configuration, and on each the rates are smooth: the motion keeps to its own.
//!          /crossed                 At a dead point there is one curve, which turns back, and no way on.
//! ```
//!
//! The determinant of the joints' equations is 0 there ([`Flow::fold`](super::flow::Flow::fold)), and they hardly tell accelerations near it.
//! So the motion is carried to the other side at once, by its Taylor polynomial of degree 2, and joints are closed there, where the
//! determinant is as large again. The polynomial is off by the cube of the way, and the other curve is as far as the way.

use super::CLOSED;
use super::motion::{Observer, Options};
use super::run::Run;
use super::world::{Acting, State, Step, World};

/// Determinants at which a change point is passed: the two ways are as far from each other, as a share of the size. Steps towards one halve
/// the determinant.
const NEAR: [f64; 2] = [1e-4, 1e-3];
/// Rates differ by no more than this share of the largest on both sides of a change point. Towards a dead point they grow without bound.
const SMOOTH: f64 = 0.1;

impl<W: World + ?Sized> Run<'_, W> {
    /// Goes through a change point ahead, if there is one near, no contact bears, and none is met.
    pub(super) fn go_through(
        &mut self,
        corner: Option<f64>,
        options: &Options,
        observer: &mut dyn Observer,
    ) -> bool {
        let world = self.flow.world;
        let is_near = |fold: f64| (NEAR[0]..=NEAR[1]).contains(&fold.abs());
        let Some((fold, rate)) = self.fold.filter(|(fold, _)| is_near(*fold)) else {
            return false;
        };
        let until = self.state.t - 2.0 * fold / rate;
        let last = corner.map_or(options.until, |corner| corner.min(options.until));
        if until <= self.state.t || until > last || !self.bearings.is_empty() {
            return false;
        }
        let from = self.state.clone();
        let pushed = |state: &State| self.flow.accelerations(state, &Vec::new());
        let Some(before) = pushed(&from) else {
            return false;
        };
        let along = |t: f64| {
            let h = t - from.t;
            State {
                t,
                q: &from.q + (&from.v + &before.x * (0.5 * h)) * h,
                v: &from.v + &before.x * h,
            }
        };
        let Some(to) = self.across(along(until), fold) else {
            return false;
        };
        let Some(after) = pushed(&to) else {
            return false;
        };
        let step = Step {
            from: &from,
            to: &to,
            bearing: &[],
        };
        if world.met(step) {
            return false;
        }
        world.taken(step);
        let acting = Acting::of(&before, &[]);
        let powers = [
            world.powers(&from, &acting),
            world.powers(&to, &Acting::of(&after, &[])),
        ];
        let half = 0.5 * (to.t - from.t);
        self.work.drives += half * (powers[0][0] + powers[1][0]);
        self.work.friction += half * (powers[0][1] + powers[1][1]);
        while observer.next() < until {
            let before = observer.next();
            observer.sample(&along(before), &acting);
            debug_assert!(observer.next() > before, "samples go on");
        }
        self.fold = Some((self.flow.fold(&to), rate));
        self.state = to;
        self.steps += 1;
        self.look();
        observer.step(&self.state);
        true
    }

    /// The state beside one, at which joints hold, if it is across a change point from this one.
    fn across(&self, near: State, fold: f64) -> Option<State> {
        let world = self.flow.world;
        let (there, open) = self.flow.projected(near, &Vec::new())?;
        let holds = world.joints(there.t, &there.q).values.amax() <= CLOSED * world.size();
        let near = open <= NEAR[1] * NEAR[1] * world.size();
        let change = world.reach(&(&there.v - &self.state.v));
        let smooth = change <= SMOOTH * world.reach(&self.state.v).max(self.fastest);
        // It is 0 in the middle.
        let is_opposite = (0.5..2.0).contains(&(-self.flow.fold(&there) / fold));
        (holds && near && smooth && is_opposite).then_some(there)
    }
}
