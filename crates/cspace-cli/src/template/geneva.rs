//! A Geneva wheel and its driver.

use clap::Args;

use super::page::{Page, Turn, about, length, number};
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

/// Derived dimensions that the comment of the model states.
struct Layout {
    /// From one slot to the next, in degrees.
    step: f64,
    /// Radius of the pin's circle.
    crank: f64,
    wheel: f64,
    /// Radius of the locking disc.
    disc: f64,
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
            Failure::new(format_args!(
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
        page.parameters();
        page.parameter("slots", f64::from(self.slots), "of the wheel");
        page.parameter("distance", self.distance, "of the shafts");
        page.parameter("pin", self.pin, "its diameter");
        page.parameter(
            "play",
            self.play,
            "of the pin on either side, and around the locking disc",
        );
        page.derived("step", "360deg/slots");
        page.derived("crank", "distance*sin(step/2)");
        page.derived("rim", "distance*cos(step/2)");
        page.derived("disc", "0.85*(crank - pin/2)");
        page.derived("hub", "distance - rim - play");
        page.derived("half", "pin/2 + play");
        page.derived("bottom", "distance - crank - play");
        page.derived("end_x", "bottom*cos(step/2)");
        page.derived("end_y", "bottom*sin(step/2)");
        page.derived("side_x", "half*sin(step/2)");
        page.derived("side_y", "half*cos(step/2)");
        page.derived(
            "lock",
            "acos((distance^2 + rim^2 - (disc + play)^2)/(2*distance*rim))",
        );
        page.derived("slot", "asin(half/rim)");
        driver(&mut page);
        wheel(&mut page);
        page.driven("The driver turns once a second.", "driver", "360deg");
        page.requirement(
            "How far the wheel turns while it is locked.",
            "name = \"play in the lock\"\nmeasure = \"play\"\nof = \"v\"",
        );
        page.requirement(
            "How far a turn of the driver turns the wheel.",
            "name = \"step\"\nmeasure = \"stroke\"\npart = \"wheel\"\ntime = 2",
        );
        page.finish()
    }
}

fn driver(page: &mut Page) {
    let turns = "{ type = \"revolute\", center = [\"distance\", 0] }";
    page.part("Turns about its shaft.", "driver", turns);
    // It locks until the pin enters a slot: then the end of its arc is on the line of the shafts. Towards the pin it is no
    // larger than the wheel, which comes no nearer to the shaft than its rim, lets it be.
    let shaft = ["distance", "0"];
    page.begin_loop("locking disc");
    page.corner("distance + disc*sin(step/2)", "disc*cos(step/2)", "");
    let to = ["distance + disc*sin(step/2)", "-disc*cos(step/2)"];
    page.turn(to, shaft, Turn::Left, "locks");
    page.corner("distance + hub*sin(step/2)", "-hub*cos(step/2)", "");
    let to = ["distance + hub*sin(step/2)", "hub*cos(step/2)"];
    page.turn(to, shaft, Turn::Left, "passes");
    page.end_loop();
    page.circle("pin/2", ["distance + crank", "0"], "pin");
    page.end_part();
}

fn wheel(page: &mut Page) {
    let turns = "{ type = \"revolute\", center = [0, 0] }";
    page.part(
        "Turns about the origin; a locking arc is at the driver.",
        "wheel",
        turns,
    );
    let rim = |angle: &str| {
        let [x, y] = ["cos", "sin"].map(|f| format!("rim*{f}({angle})"));
        (x, y)
    };
    let center = ["0", "0"];
    page.begin_loop("slots and locking arcs");
    page.begin_repeat("slots");
    let (x, y) = rim("lock");
    page.corner(&x, &format!("-{y}"), "");
    page.turn([&x, &y], ["distance", "0"], Turn::Right, "locking arc");
    let (x, y) = rim("step/2 - slot");
    page.turn([&x, &y], center, Turn::Left, "rim");
    page.rounding("pin/20", "");
    page.corner("end_x + side_x", "end_y - side_y", "slot");
    let to = ["end_x - side_x", "end_y + side_y"];
    page.turn(to, ["end_x", "end_y"], Turn::Right, "");
    let (x, y) = rim("step/2 + slot");
    page.corner(&x, &y, "");
    page.rounding("pin/20", "");
    let (x, y) = rim("step - lock");
    page.turn([&x, &y], center, Turn::Left, "rim");
    page.end_repeat();
    page.end_loop();
    page.end_part();
}
