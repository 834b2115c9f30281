//! A Geneva wheel and its driver.

use clap::Args;

use super::page::{Page, Turn, about, length, number, polar};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct Geneva {
    /// Slots of the wheel
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u32).range(3..=24))]
    slots: u32,
    /// Distance of the two shafts
    #[arg(long, value_name = "L", default_value_t = 60.0, value_parser = length)]
    distance: f64,
    /// Diameter of the driver's pin
    #[arg(long, value_name = "D", default_value_t = 8.0, value_parser = length)]
    pin: f64,
    /// Room of the pin on either side of it in a slot, and around the locking disc
    #[arg(long, value_name = "L", default_value_t = 0.1, value_parser = length)]
    play: f64,
}

/// What follows from the dimensions.
struct Layout {
    /// From one slot to the next, in degrees.
    step: f64,
    /// Radius of the pin's circle.
    crank: f64,
    wheel: f64,
    /// Radius of the locking disc, and of what is left of it towards the pin.
    disc: f64,
    hub: f64,
    /// Half the width of a slot.
    half: f64,
    /// Where the round bottom of a slot has its centre, from the wheel's.
    bottom: f64,
    /// Where a locking arc meets the rim, in degrees from its middle.
    lock: f64,
    /// Where a slot meets the rim, in degrees from its middle.
    slot: f64,
}

impl Geneva {
    fn layout(&self) -> Result<Layout, Failure> {
        let step = 360.0 / f64::from(self.slots);
        let (sin, cos) = (0.5 * step).to_radians().sin_cos();
        let (crank, wheel) = (self.distance * sin, self.distance * cos);
        let half = 0.5 * self.pin + self.play;
        let disc = 0.85 * (crank - 0.5 * self.pin);
        let bottom = self.distance - crank - self.play;
        let too_wide = |why: &str| {
            Failure::input(format_args!(
                "a pin of diameter {} with a play of {} is too wide: {why}",
                self.pin, self.play
            ))
            .help("give a smaller --pin or --play, a larger --distance, or fewer --slots")
        };
        let hub = self.distance - wheel - self.play;
        if disc <= hub || hub <= self.play {
            return Err(too_wide("it leaves no room for the locking disc"));
        }
        if bottom * sin <= half {
            return Err(too_wide("the slots run into each other"));
        }
        let reach = disc + self.play;
        let cos_lock = (self.distance * self.distance + wheel * wheel - reach * reach)
            / (2.0 * self.distance * wheel);
        let (lock, slot) = (
            cos_lock.clamp(-1.0, 1.0).acos().to_degrees(),
            (half / wheel).clamp(-1.0, 1.0).asin().to_degrees(),
        );
        // The rim between is rounded towards the slot, and must hold the fillet.
        let rim = (0.5 * step - lock - slot).to_radians() * wheel;
        if rim < 0.1 * self.pin {
            return Err(too_wide(
                "nothing is left of the rim between slots and locking arcs",
            ));
        }
        Ok(Layout {
            step,
            crank,
            wheel,
            disc,
            hub,
            half,
            bottom,
            lock,
            slot,
        })
    }

    pub(super) fn text(&self) -> Result<String, Failure> {
        let of = self.layout()?;
        let comment = format!(
            "\
A Geneva wheel of {n} slots and its driver, shafts {c} apart.

The pin runs on a circle R{crank} = {c} sin(180 deg / {n}), the wheel has R{wheel} = {c} cos(180 deg / {n}).
Drawn at dwell, the pin away from the wheel, the locking disc R{disc} in a locking arc of the wheel:
u is the driver's turn, v the wheel's. One turn of the driver steps the wheel by {step} deg the other
way, while the pin goes from {enter} deg to {leave} deg; the rest of the turn it dwells.

The crank's arm runs below the wheel and is not in this plane: disc and pin are loops apart.

Written by: cspace new geneva --slots {n} --distance {c} --pin {pin} --play {p}
Ask it:     cspace compute FILE
            printf 'u,v\\n0,0\\n180deg,-{mid}deg\\n360deg,-{step}deg\\n' | cspace classify FILE",
            n = self.slots,
            c = number(self.distance),
            pin = number(self.pin),
            p = number(self.play),
            crank = about(of.crank, 4),
            wheel = about(of.wheel, 4),
            disc = about(of.disc, 4),
            step = about(of.step, 6),
            mid = about(0.5 * of.step, 6),
            enter = about(90.0 + 0.5 * of.step, 4),
            leave = about(270.0 - 0.5 * of.step, 4),
        );
        let mut page = Page::new(&comment, "Geneva drive", self.distance);
        self.driver(&of, &mut page);
        self.wheel(&of, &mut page);
        page.finish()
    }

    fn driver(&self, of: &Layout, page: &mut Page) {
        let shaft = (self.distance, 0.0);
        let turns = format!("{{ type = \"revolute\", center = {} }}", page.point(shaft));
        page.part("Turns about its shaft.", "driver", &turns);
        // It locks until the pin enters a slot: then the end of its arc is on the line of the shafts. Towards the pin it is no
        // larger than the wheel, which comes no nearer to the shaft than its rim, lets it be.
        let horn = 90.0 - 0.5 * of.step;
        let at = |radius: f64, angle: f64| {
            let (x, y) = polar(radius, angle);
            (self.distance + x, y)
        };
        page.begin_loop("locking disc");
        page.vertex(at(of.disc, horn), "");
        page.arc_about(at(of.disc, -horn), shaft, Turn::Left, "locks");
        page.vertex(at(of.hub, -horn), "");
        page.arc_about(at(of.hub, horn), shaft, Turn::Left, "lets the wheel pass");
        page.end_loop();
        let pin = (self.distance + of.crank, 0.0);
        page.circle(0.5 * self.pin, pin, "pin");
        page.end_part();
    }

    fn wheel(&self, of: &Layout, page: &mut Page) {
        let turns = "{ type = \"revolute\", center = [0, 0] }";
        page.part(
            "Turns about the origin; a locking arc is at the driver.",
            "wheel",
            turns,
        );
        page.begin_loop("slots and locking arcs");
        let rim = |angle: f64| polar(of.wheel, angle);
        for k in 0..self.slots {
            let lock = f64::from(k) * of.step;
            let slot = lock + 0.5 * of.step;
            // A point along the slot and beside its middle.
            let (cos, sin) = polar(1.0, slot);
            let beside =
                |along: f64, side: f64| (along * cos - side * sin, along * sin + side * cos);
            if k == 0 {
                page.vertex(rim(lock - of.lock), "");
            } else {
                page.arc_about(rim(lock - of.lock), (0.0, 0.0), Turn::Left, "rim");
            }
            let arc = polar(self.distance, lock);
            page.arc_about(
                rim(lock + of.lock),
                arc,
                Turn::Right,
                &format!("locking arc {}", k + 1),
            );
            page.arc_about(rim(slot - of.slot), (0.0, 0.0), Turn::Left, "rim");
            page.fillet(0.05 * self.pin, "");
            page.vertex(beside(of.bottom, -of.half), &format!("slot {}", k + 1));
            let end = beside(of.bottom, of.half);
            page.arc_about(end, beside(of.bottom, 0.0), Turn::Right, "");
            page.vertex(rim(slot + of.slot), "");
            page.fillet(0.05 * self.pin, "");
        }
        page.arc_about(
            rim(-of.lock),
            (0.0, 0.0),
            Turn::Left,
            "rim, which closes the loop",
        );
        page.end_loop();
        page.end_part();
    }
}
