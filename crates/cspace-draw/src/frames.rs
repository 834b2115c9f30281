//! Parts at several times on one page, all at one scale.

use crate::colour::{INK, part as colours};
use crate::legend::{Legend, Sign};
use crate::options::PictureOptions;
use crate::page::Page;
use crate::parts::{PartsPicture, frame_of, seen_of_all};
use crate::plot::{fitting, text};
use crate::scene::{Anchor, Area, Dot, Scene};

/// Data of a picture of parts at several times.
#[derive(Debug, Clone, Default)]
pub struct FramesPicture<'a> {
    /// Caption and parts of each frame.
    pub frames: Vec<(String, PartsPicture<'a>)>,
}

/// Number of frames in a row.
const ACROSS: usize = 4;
/// Sizes in multiples of the letter size: width of the reference page, its margin, space above and below frames.
const WIDE: f64 = 100.0;
const MARGIN: f64 = 1.0;
const TOP: f64 = 2.8;
const CAPTION: f64 = 2.6;
/// A frame is at least as high as this share of its width, and at most.
const HIGH: (f64, f64) = (0.4, 1.5);

/// Draws a page of parts at several times, in rows, each with its caption below.
///
/// ```
/// use cspace::{Configuration, Part};
/// use cspace_draw::{FramesPicture, PartsPicture, PictureOptions, PlacedPart, frames, svg};
/// let plate = Part::rectangle("plate", (0.0, 0.0), 8.0, 4.0)?;
/// let at = |x| PartsPicture {
///     parts: vec![PlacedPart {
///         part: &plate,
///         assembly_from_part: Configuration::new(x, 0.0, 0.0),
///         axis: None,
///         number: 0,
///     }],
///     ..PartsPicture::default()
/// };
/// let picture = FramesPicture { frames: vec![("first".into(), at(0.0)), ("then".into(), at(9.0))] };
/// let drawn = svg(&frames(&picture, &PictureOptions::default()));
/// assert!(drawn.contains(">first</text>") && drawn.contains(">then</text>"));
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn frames(picture: &FramesPicture<'_>, options: &PictureOptions) -> Scene {
    const EM: f64 = 13.0;
    const LEAST: f64 = 5.0;
    let across = picture.frames.len().clamp(1, ACROSS);
    let rows = picture.frames.len().div_ceil(across) as f64;
    let [x, y] = seen_of_all(picture.frames.iter().map(|f| &f.1), options);
    // Frames of a page of one size of letters, and the height of all.
    let wide = (WIDE - 2.0 * MARGIN - (across - 1) as f64) / across as f64;
    let high = wide * ((y.1 - y.0) / (x.1 - x.0)).clamp(HIGH.0, HIGH.1);
    let legend = |em: f64| Legend::new(entries(picture), (WIDE - 2.0) * em, em);
    let natural = TOP + rows * (high + CAPTION) + legend(EM).height() / EM + 1.0;
    let (width, height, em) = match options.size {
        None => (WIDE * EM, natural * EM, EM),
        Some((width, height)) => {
            let em = (width / WIDE).min(height / natural).max(LEAST);
            (width, height, em)
        }
    };
    let mut page = Page::with(options, (width, height), legend(em));
    for (k, (said, parts)) in picture.frames.iter().enumerate() {
        let left = (MARGIN + (k % across) as f64 * (wide + 1.0)) * em;
        let top = (TOP + (k / across) as f64 * (high + CAPTION)) * em;
        let area = Area::new(left, top, wide * em, high * em);
        frame_of(&mut page.items, parts, area, [x, y], em);
        let base = Dot::new(left, area.hi.y + 1.3 * em);
        let said = fitting(said, em, wide * em);
        page.items.push(text(said, base, em, Anchor::Start, INK));
    }
    page.finished()
}

/// The parts of all frames by their colours.
fn entries(picture: &FramesPicture<'_>) -> Vec<(Sign, String)> {
    let mut known: Vec<(usize, String)> = (picture.frames.iter())
        .flat_map(|(_, parts)| &parts.parts)
        .map(|p| (p.number, p.part.name().to_owned()))
        .collect();
    known.sort();
    known.dedup();
    let entry = |(number, name): (usize, String)| {
        let (fill, edge) = colours(number);
        (Sign::Field(fill, edge), name)
    };
    known.into_iter().map(entry).collect()
}
