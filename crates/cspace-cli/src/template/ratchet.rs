//! A ratchet wheel and its pawl.

use clap::Args;

use super::page::{Page, about, length, number, polar};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct Ratchet {
    /// Teeth of the wheel
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u32).range(6..=200))]
    teeth: u32,
    /// Radius of the wheel at the tips of its teeth
    #[arg(long, value_name = "R", default_value_t = 50.0, value_parser = length)]
    radius: f64,
    /// Height of the teeth
    #[arg(long, value_name = "L", default_value_t = 6.0, value_parser = length)]
    height: f64,
    /// Gap between the pawl and the tooth that it holds, as drawn
    #[arg(long, value_name = "L", default_value_t = 0.2, value_parser = length)]
    play: f64,
}

impl Ratchet {
    pub(super) fn text(&self) -> Result<String, Failure> {
        let Self {
            teeth,
            radius,
            height,
            play,
        } = *self;
        let pitch = 360.0 / f64::from(teeth);
        let along = 2.0 * radius * (0.5 * pitch).to_radians().sin();
        let most = (0.5 * along).min(0.2 * radius);
        if height > most {
            return Err(Failure::new(format_args!(
                "teeth of height {height} are too high for {teeth} of them on a radius of {radius}"
            ))
            .help(format_args!(
                "give a --height of at most {:.3}, or fewer --teeth",
                (1e3 * most).floor() / 1e3
            )));
        }
        if play > 0.2 * height {
            return Err(Failure::new(format_args!(
                "the play, {play}, leaves little of teeth of height {height}"
            ))
            .help("give a --play of at most a fifth of --height"));
        }
        let foot = radius - height;
        let fillet = 0.1 * height;
        // The pawl's nose lies along the back of the tooth before the one it holds, from the foot at the top to the tip.
        let (tip_x, tip_y) = polar(radius, 90.0 - pitch);
        let (dx, dy) = (
            tip_x / tip_x.hypot(tip_y - foot),
            (tip_y - foot) / tip_x.hypot(tip_y - foot),
        );
        // Clear of the fillet in the foot too.
        let gap = play + fillet;
        let under = |x: f64| foot + (x * dy + gap) / dx;
        let corner = (play, under(play));
        let reach = (tip_x + height).min(0.5 * radius);
        let heel = (reach, under(reach));
        let pivot = (0.9 * radius, 1.2 * radius);
        // Lifting takes the line from corner to heel out of the tips' circle.
        let length_under = (heel.0 - corner.0).hypot(heel.1 - corner.1);
        let out = radius + length_under * length_under / (4.0 * radius);
        let lift = |(x, y): (f64, f64)| {
            let (px, py) = pivot;
            let (a, d) = ((x - px).hypot(y - py), px.hypot(py));
            let now = (x * py - y * px).atan2(px * (x - px) + py * (y - py)).abs();
            let then = ((out * out - d * d - a * a) / (2.0 * a * d))
                .clamp(-1.0, 1.0)
                .acos();
            (now - then).to_degrees()
        };
        let lifted = lift(corner).max(lift(heel)).max(1.0).ceil() + 1.0;
        let held = (play / radius).asin().to_degrees();
        let comment = format!(
            "\
A ratchet wheel of {t} teeth and its pawl, each on its pivot.

The wheel, R{r} at the tips, has teeth {h} high with radial faces. Drawn with the pawl {p} from the
face of the tooth at the top: u is the wheel's turn, v the pawl's; a negative v lifts it.

  clockwise         the wheel turns by {held} deg, asin({p} / {r}), then the tooth is at the pawl
  counter-clockwise it lifts the pawl, tooth by tooth, {pitch} deg each
  lifted            at v = -{lifted} deg the wheel turns freely

Written by: cspace new ratchet --teeth {t} --radius {r} --height {h} --play {p}
Ask it:     cspace compute FILE
            printf 'u,v\\n-{less}deg,0\\n-{more}deg,0\\n' | cspace classify FILE",
            t = teeth,
            r = number(radius),
            h = number(height),
            p = number(play),
            held = about(held, 4),
            pitch = about(pitch, 4),
            lifted = number(lifted),
            less = about(0.9 * held, 6),
            more = about(1.1 * held, 6),
        );
        let mut page = Page::new(&comment, "ratchet and pawl", radius);
        page.parameters();
        page.parameter("teeth", f64::from(teeth), "");
        page.parameter("radius", radius, "of the wheel at the tips");
        page.parameter("height", height, "of a tooth");
        page.parameter(
            "play",
            play,
            "from the pawl to the face of the tooth it holds",
        );
        page.derived("foot", "radius - height");
        page.derived("tip_x", "radius*sin(360deg/teeth)");
        page.derived("tip_y", "radius*cos(360deg/teeth)");
        page.derived("rise", "(tip_y - foot)/tip_x");
        // Clear of the fillet in the foot too.
        page.derived("under", "foot + (play + height/10)*sqrt(1 + rise^2)");
        page.derived("reach", "min(tip_x + height, radius/2)");
        page.part(
            "Turns about the origin; a tooth is at the top.",
            "ratchet",
            "{ type = \"revolute\", center = [0, 0] }",
        );
        page.begin_loop("teeth");
        page.begin_repeat("teeth");
        page.corner("0", "foot", "face");
        page.rounding("height/10", "");
        page.corner("0", "radius", "back");
        page.end_repeat();
        page.end_loop();
        page.end_part();
        let motion = format!(
            "{{ type = \"revolute\", center = [\"0.9*radius\", \"1.2*radius\"], range = [\"-{}deg\", \"5deg\"] }}",
            number(lifted)
        );
        page.part(
            "Turns about its own pivot, from lifted to dropped.",
            "pawl",
            &motion,
        );
        page.begin_loop("outline");
        page.corner("play", "under + play*rise", "along the back of a tooth");
        page.corner("reach", "under + reach*rise", "belly");
        page.corner("0.9*radius", "1.04*radius", "boss");
        page.bow("0.9*radius", "1.36*radius", "0.16*radius", "");
        page.corner("play", "radius + height", "face, which holds the tooth");
        page.end_loop();
        page.end_part();
        page.driven(
            "The wheel turns counter-clockwise, a tooth a second.",
            "ratchet",
            "360deg/teeth",
        );
        page.load("The pawl lies on it.", "pawl", "torque = 1e7");
        page.requirement(
            "How far the wheel turns back until the pawl holds it.",
            "name = \"held\"\nmeasure = \"position\"\nalong = [\"-20deg\", 0]",
        );
        page.finish()
    }
}
