//! Two spur gears with involute teeth.

use clap::Args;

use super::page::{Page, Turn, about, length, number, polar};
use crate::angle;
use crate::failure::Failure;

/// Addendum, and dedendum, in modules.
const ADDENDUM: f64 = 1.0;
const DEDENDUM: f64 = 1.25;
/// Radius of the fillets in the roots, in modules; less than the room above the other gear's tips.
const FILLET: f64 = 0.2;
/// Arcs to a flank.
const ARCS: u32 = 2;

#[derive(Debug, Args)]
pub(crate) struct Gears {
    /// Teeth of the gear
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(6..=200))]
    gear: u32,
    /// Teeth of the pinion
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(6..=200))]
    pinion: u32,
    /// Module: the pitch diameter by the number of teeth
    #[arg(long, value_name = "L", default_value_t = 4.0, value_parser = length)]
    module: f64,
    /// Pressure angle, in radians or such as 20deg
    #[arg(long, value_name = "ANGLE", default_value = "25deg", value_parser = pressure)]
    pressure_angle: f64,
    /// How much wider a space is than a tooth on the pitch circle
    #[arg(long, value_name = "L", default_value_t = 0.2, value_parser = length)]
    backlash: f64,
}

/// A pressure angle that gears have.
fn pressure(text: &str) -> Result<f64, String> {
    let angle = angle::parse(text)?;
    let degrees = angle.to_degrees();
    if (10.0..=35.0).contains(&degrees) {
        Ok(angle)
    } else {
        Err(format!(
            "{} is {} deg: give an angle from 10deg to 35deg",
            text.trim(),
            about(degrees, 3)
        ))
    }
}

/// One gear of a pair.
struct Wheel {
    teeth: u32,
    pitch: f64,
    base: f64,
    tip: f64,
    /// Where the other gear's tips begin to touch its flanks.
    low: f64,
    pressure: f64,
    backlash: f64,
}

impl Wheel {
    /// The angle of a flank from the middle of its tooth at a radius, in degrees.
    fn half(&self, radius: f64) -> f64 {
        let involute = |radius: f64| {
            let t = self.roll(radius);
            t - t.atan()
        };
        let quarter = core::f64::consts::FRAC_PI_2 / f64::from(self.teeth);
        let half =
            quarter - self.backlash / (4.0 * self.pitch) + involute(self.pitch) - involute(radius);
        half.to_degrees()
    }

    /// The tangent of the pressure angle at a radius.
    fn roll(&self, radius: f64) -> f64 {
        ((radius - self.base) * (radius + self.base))
            .max(0.0)
            .sqrt()
            / self.base
    }

    /// The radii at the ends and in the middle of the arcs of a flank, outwards.
    fn radii(&self) -> Vec<f64> {
        let (low, high) = (self.roll(self.low), self.roll(self.tip));
        let count = 2 * ARCS;
        let radius = |i: u32| {
            let t = low + (high - low) * f64::from(i) / f64::from(count);
            self.base * t.hypot(1.0)
        };
        (0..=count).map(radius).collect()
    }

    /// The teeth, the first with its middle at an angle in degrees.
    fn draw(&self, page: &mut Page, center: (f64, f64), first: f64, module: f64) {
        let root = self.pitch - DEDENDUM * module;
        let step = 360.0 / f64::from(self.teeth);
        let radii = self.radii();
        let at = |radius: f64, angle: f64| {
            let (x, y) = polar(radius, angle);
            (center.0 + x, center.1 + y)
        };
        page.begin_loop(&format!("{} teeth", self.teeth));
        let foot = self.half(self.low);
        for k in 0..self.teeth {
            let middle = first + f64::from(k) * step;
            if k == 0 {
                page.vertex(at(root, middle - foot), "root");
            } else {
                page.arc_about(at(root, middle - foot), center, Turn::Left, "root");
            }
            page.fillet(FILLET * module, "");
            page.vertex(at(self.low, middle - foot), &format!("tooth {}", k + 1));
            for arc in radii.windows(3).step_by(2) {
                let flank = |r: f64| at(r, middle - self.half(r));
                page.arc_through(flank(arc[2]), flank(arc[1]), "flank");
            }
            page.arc_about(
                at(self.tip, middle + self.half(self.tip)),
                center,
                Turn::Left,
                "tip",
            );
            let inwards: Vec<f64> = radii.iter().rev().copied().collect();
            for arc in inwards.windows(3).step_by(2) {
                let flank = |r: f64| at(r, middle + self.half(r));
                page.arc_through(flank(arc[2]), flank(arc[1]), "flank");
            }
            page.vertex(at(root, middle + foot), "");
            page.fillet(FILLET * module, "");
        }
        page.arc_about(
            at(root, first - foot),
            center,
            Turn::Left,
            "root, which closes the loop",
        );
        page.end_loop();
    }
}

impl Gears {
    /// Both gears, for this distance of their shafts.
    fn wheels(&self, distance: f64) -> Result<[Wheel; 2], Failure> {
        let wheel = |teeth: u32, other: u32| {
            let (sin, cos) = self.pressure_angle.sin_cos();
            let pitch = |teeth: u32| 0.5 * self.module * f64::from(teeth);
            let (base, tip) = (pitch(teeth) * cos, pitch(teeth) + ADDENDUM * self.module);
            let (other_base, other_tip) =
                (pitch(other) * cos, pitch(other) + ADDENDUM * self.module);
            // What is left of the line of action when the other gear's tip comes to it.
            let left =
                distance * sin - ((other_tip - other_base) * (other_tip + other_base)).sqrt();
            let wheel = Wheel {
                teeth,
                pitch: pitch(teeth),
                base,
                tip,
                low: base.hypot(left.max(0.0)),
                pressure: self.pressure_angle,
                backlash: self.backlash,
            };
            if left < 0.0 {
                return Err(Failure::new(format_args!(
                    "the tips of {other} teeth would cut into the feet of {teeth} teeth at a pressure angle of {} deg",
                    about(wheel.pressure.to_degrees(), 3)
                ))
                .help("give more teeth to the smaller of --gear and --pinion, or a larger --pressure-angle"));
            }
            if wheel.half(wheel.tip) <= 0.0 {
                return Err(Failure::new(format_args!(
                    "{teeth} teeth at a pressure angle of {} deg come to a point below their tips",
                    about(wheel.pressure.to_degrees(), 3)
                ))
                .help("give more teeth, a smaller --pressure-angle, or less --backlash"));
            }
            Ok(wheel)
        };
        Ok([
            wheel(self.gear, self.pinion)?,
            wheel(self.pinion, self.gear)?,
        ])
    }

    pub(super) fn text(&self) -> Result<String, Failure> {
        if self.backlash > 0.25 * self.module {
            return Err(Failure::new(format_args!(
                "a backlash of {} leaves thin teeth of module {}",
                self.backlash, self.module
            ))
            .help("give a --backlash of at most a quarter of --module"));
        }
        let distance = 0.5 * self.module * f64::from(self.gear + self.pinion);
        let [gear, pinion] = self.wheels(distance)?;
        let turn = (self.backlash / pinion.pitch).to_degrees();
        let comment = format!(
            "\
A gear of {g} teeth and a pinion of {p}, each on its shaft, {d} apart.

Module {m}, pressure angle {a} deg, addendum 1 and dedendum 1.25 modules. Drawn with a tooth of the
gear in the middle of a space of the pinion: u is the gear's turn, v the pinion's,

  v = -{g}/{p} u,   give or take half the backlash, {turn} deg of the pinion.

Each flank is two arcs through points of the involute and at most 0.003 modules off it between them;
the backlash of {b} differs by as much from place to place. It is measured on the pitch circles,
R{gr} and R{pr}.

Written by: cspace new gears --gear {g} --pinion {p} --module {m} --pressure-angle {a}deg --backlash {b}
Ask it:     cspace compute FILE
            printf 'u,v\\n0,0\\n{p}deg,-{g}deg\\n{p}deg,0\\n' | cspace classify FILE",
            g = self.gear,
            p = self.pinion,
            d = number(distance),
            m = number(self.module),
            a = number(self.pressure_angle.to_degrees()),
            turn = about(0.5 * turn, 4),
            b = number(self.backlash),
            gr = number(gear.pitch),
            pr = number(pinion.pitch),
        );
        let mut page = Page::new(&comment, "gears", 2.0 * distance);
        let turns = "{ type = \"revolute\", center = [0, 0] }";
        page.part(
            "Turns about the origin; a tooth points at the pinion.",
            "gear",
            turns,
        );
        gear.draw(&mut page, (0.0, 0.0), 0.0, self.module);
        page.end_part();
        let center = (distance, 0.0);
        let turns = format!("{{ type = \"revolute\", center = {} }}", page.point(center));
        page.part(
            "Turns about its own shaft; a space is at the gear.",
            "pinion",
            &turns,
        );
        let first = 180.0 + 180.0 / f64::from(self.pinion);
        pinion.draw(&mut page, center, first, self.module);
        page.end_part();
        page.driven(
            "The gear turns once a second and takes the pinion along.",
            "gear",
            "360deg",
        );
        page.requirement(
            "The backlash: how far the pinion turns while the gear stands still.",
            "name = \"backlash\"\nmeasure = \"play\"\nof = \"v\"",
        );
        page.finish()
    }
}
