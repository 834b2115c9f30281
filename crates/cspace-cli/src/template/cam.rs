//! A cam of two arcs and two lines, and a flat follower.

use clap::Args;

use super::page::{Page, Turn, about, length, number};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct Cam {
    /// Radius of the base circle, on which the follower dwells
    #[arg(long, value_name = "R", default_value_t = 20.0, value_parser = length)]
    base: f64,
    /// How far the nose lifts the follower
    #[arg(long, value_name = "L", default_value_t = 8.0, value_parser = length)]
    lift: f64,
    /// Radius of the nose, at most that of the base circle
    #[arg(long, value_name = "R", default_value_t = 6.0, value_parser = length)]
    nose: f64,
    /// Width of the follower's flat face
    #[arg(long, value_name = "L", default_value_t = 40.0, value_parser = length)]
    face: f64,
}

impl Cam {
    pub(super) fn text(&self) -> Result<String, Failure> {
        let Self {
            base,
            lift,
            nose,
            face,
        } = *self;
        if nose > base {
            return Err(Failure::new(format_args!(
                "the nose has a larger radius, {nose}, than the base circle, {base}"
            ))
            .help("give a --nose of at most --base"));
        }
        // The nose's centre is as far below the axis; the flanks are tangent to both circles.
        let down = base + lift - nose;
        let aside = ((down - (base - nose)) * (down + (base - nose))).sqrt();
        let (nx, ny) = (aside / down, (nose - base) / down);
        if 0.5 * face < aside {
            return Err(Failure::new(format_args!(
                "the face, {face} wide, is too narrow: the cam touches it up to {aside:.3} beside the middle"
            ))
            .help(format_args!("give a --face of at least {:.3}", (2e3 * aside).ceil() / 1e3)));
        }
        let comment = format!(
            "\
A cam on its shaft and a flat follower in its guide.

The cam has a base circle R{b} and a nose R{n}, joined by straight flanks tangent to both. Drawn with
its nose down and the follower on the base circle: u is the cam's turn, v the follower's lift,

  v = max(0, -{a} cos u - {c}),   at most {l}, at u = 180 deg,

for the face stands on the higher of base circle and nose, whose centre is {a} from the axis.

Written by: cspace new cam --base {b} --lift {l} --nose {n} --face {f}
Ask it:     cspace compute FILE
            printf 'u,v\\n180deg,{below}\\n180deg,{l}\\n180deg,{above}\\n' | cspace classify FILE",
            b = number(base),
            n = number(nose),
            l = number(lift),
            f = number(face),
            a = about(down, 6),
            c = about(base - nose, 6),
            below = number(0.5 * lift),
            above = number(1.5 * lift),
        );
        let mut page = Page::new(&comment, "cam and follower", base + lift + face);
        let turns = "{ type = \"revolute\", center = [0, 0] }";
        page.part("Turns about the origin.", "cam", turns);
        page.begin_loop("profile");
        page.vertex((nose * nx, nose * ny - down), "flank");
        page.vertex((base * nx, base * ny), "");
        page.arc_about(
            (-base * nx, base * ny),
            (0.0, 0.0),
            Turn::Left,
            "base circle",
        );
        page.vertex((-nose * nx, nose * ny - down), "flank");
        let to = (nose * nx, nose * ny - down);
        page.arc_about(to, (0.0, -down), Turn::Left, "nose, which closes the loop");
        page.end_loop();
        page.end_part();
        let slides = format!(
            "{{ type = \"prismatic\", direction = [0, 1], range = [{}, {}] }}",
            number(-0.5 * lift),
            number(2.0 * lift)
        );
        page.part("Slides up and down.", "follower", &slides);
        let (half, thick, stem) = (0.5 * face, 0.1 * face, 0.1 * face);
        page.begin_loop("outline");
        page.vertex((-half, base), "flat face");
        page.vertex((half, base), "");
        page.vertex((half, base + thick), "head");
        page.vertex((stem, base + thick), "stem");
        page.fillet(0.5 * stem, "");
        page.vertex((stem, base + face), "");
        page.vertex((-stem, base + face), "stem");
        page.vertex((-stem, base + thick), "head");
        page.fillet(0.5 * stem, "");
        page.vertex((-half, base + thick), "");
        page.end_loop();
        page.end_part();
        page.driven("The cam turns once a second.", "cam", "360deg");
        page.load("The follower lies on it.", "follower", "force = [0, -1e6]");
        page.requirement(
            "How high the nose lifts the follower.",
            &format!("name = \"lift\"\nmeasure = \"position\"\nat = {{ u = \"180deg\", v = {} }}\nalong = [0, {}]", number(2.0 * lift), number(-2.0 * lift)),
        );
        page.finish()
    }
}
