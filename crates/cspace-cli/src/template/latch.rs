//! A bolt in a catch.

use clap::Args;

use super::page::{Page, STEEL, about, length, number};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct Latch {
    /// Diameter of the bolt's round head
    #[arg(long, value_name = "D", default_value_t = 10.0, value_parser = length)]
    head: f64,
    /// How thick the head is above its round
    #[arg(long, value_name = "L", default_value_t = 1.0, value_parser = length)]
    rim: f64,
    /// Width of the bolt's stem
    #[arg(long, value_name = "L", default_value_t = 4.0, value_parser = length)]
    stem: f64,
    /// Width of the catch's mouth
    #[arg(long, value_name = "L", default_value_t = 6.0, value_parser = length)]
    mouth: f64,
    /// Thickness of the catch's lips
    #[arg(long, value_name = "L", default_value_t = 4.0, value_parser = length)]
    lip: f64,
    /// How far the bolt moves along its stem, from the bottom of the pocket to the lips
    #[arg(long, value_name = "L", default_value_t = 2.0, value_parser = length)]
    play: f64,
    /// Room of the pocket on either side of the head, or of the mouth where that is wider
    #[arg(long, value_name = "L", default_value_t = 1.0, value_parser = length)]
    side: f64,
}

impl Latch {
    pub(super) fn text(&self) -> Result<String, Failure> {
        let Self {
            head,
            rim,
            stem,
            mouth,
            lip,
            play,
            side,
        } = *self;
        if stem >= mouth {
            return Err(Failure::new(format_args!(
                "the stem, {stem} wide, does not go through the mouth, {mouth} wide"
            ))
            .help("give a --stem less than --mouth"));
        }
        if stem >= head {
            return Err(Failure::new(format_args!(
                "the stem, {stem} wide, is no narrower than the head, {head} wide"
            ))
            .help("give a --stem less than --head"));
        }
        let pocket = 0.5 * head.max(mouth) + side;
        let bottom = -lip - play - rim - 0.5 * head;
        let (wall, foot) = (pocket + lip, bottom - lip);
        let upright = if head > mouth {
            format!(
                "The head is wider than the mouth by {}: upright it does not come out. `cspace compute` shows\nwhether it can be tilted out: with two regions of free space, one of them caged, it cannot.",
                about(head - mouth, 6)
            )
        } else {
            "The head is no wider than the mouth: the bolt comes out. To see it held, give a --head\nwider than --mouth.".to_owned()
        };
        let comment = format!(
            "\
A bolt with a round head of diameter {h} in a catch whose mouth is {m} wide.

{upright}

Drawn with the head half way between the bottom of the pocket and the lips: from (x, y, theta) =
(0, 0, 0) the bolt goes up or down by {p}, then its head is at the lips or on the bottom.

Written by: cspace new latch --head {h} --rim {r} --stem {s} --mouth {m} --lip {l} --play {pl} --side {si}
Ask it:     cspace compute FILE
            printf 'x,y,theta\\n0,0,0\\n0,{p},0\\n0,{pl},0\\n' | cspace classify FILE",
            h = number(head),
            m = number(mouth),
            p = about(0.5 * play, 6),
            r = number(rim),
            s = number(stem),
            l = number(lip),
            pl = number(play),
            si = number(side),
        );
        let mut page = Page::new(&comment, "bolt in a catch", wall.max(-foot));
        page.world("friction = 0.15\nrestitution = 0.3");
        page.parameters();
        page.parameter("head", head, "diameter of the bolt's round head");
        page.parameter("rim", rim, "thickness of the head above its round");
        page.parameter("stem", stem, "");
        page.parameter("mouth", mouth, "");
        page.parameter("lip", lip, "thickness of the catch's lips");
        page.parameter("play", play, "of the bolt along its stem");
        page.parameter("side", side, "room on either side of the head");
        page.derived("pocket", "max(head, mouth)/2 + side");
        page.derived("shoulder", "-lip - play/2");
        page.derived("bottom", "-lip - play - rim - head/2");
        page.part_with("The first part of a pair is fixed.", "catch", "", &[STEEL]);
        page.begin_loop("section");
        page.corner("-pocket - lip", "bottom - lip", "foot");
        page.corner("pocket + lip", "bottom - lip", "");
        page.corner("pocket + lip", "0", "face");
        page.corner("mouth/2", "0", "mouth");
        page.corner("mouth/2", "-lip", "lip");
        page.corner("pocket", "-lip", "pocket");
        page.corner("pocket", "bottom", "bottom");
        page.corner("-pocket", "bottom", "pocket");
        page.corner("-pocket", "-lip", "lip");
        page.corner("-mouth/2", "-lip", "mouth");
        page.corner("-mouth/2", "0", "face");
        page.corner("-pocket - lip", "0", "");
        page.end_loop();
        page.end_part();
        page.part_with("The second part moves.", "bolt", "", &[STEEL]);
        page.begin_loop("outline");
        page.corner("-head/2", "shoulder - rim", "head");
        page.bow("head/2", "shoulder - rim", "head/2", "a half circle");
        page.corner("head/2", "shoulder", "shoulder");
        page.corner("stem/2", "shoulder", "stem");
        page.corner("stem/2", "2*lip", "end");
        page.corner("-stem/2", "2*lip", "stem");
        page.corner("-stem/2", "shoulder", "shoulder");
        page.corner("-head/2", "shoulder", "");
        page.end_loop();
        page.end_part();
        page.requirement(
            "What `cspace check FILE` reports, also with --set mouth=10.",
            "name = \"held\"\nmeasure = \"caged\"",
        );
        page.mount(
            "`cspace simulate FILE --time 3`: a soft spring pulls at the bolt's end, askew. A bolt that is held comes to\nrest with its head at the lips, another comes out.",
            "bolt",
            [["0", "2*lip"], ["mouth/2", "2*lip + 5*head"]],
            "0.07*head^2",
            "0.001*head^2",
        );
        for (x, comment) in [
            ("-pocket - lip", "The catch stands on springs."),
            ("pocket + lip", ""),
        ] {
            let foot = [x, "bottom - lip"];
            let (stiffness, damping) = (
                "20*(pocket + lip)*(lip - bottom)",
                "0.04*(pocket + lip)*(lip - bottom)",
            );
            page.mount(comment, "catch", [foot, foot], stiffness, damping);
        }
        page.finish()
    }
}
