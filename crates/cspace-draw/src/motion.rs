//! A mechanism in motion on one page: frames, coordinates and contacts over time, paths in planes of motions, words.

use cspace::{Axis, FixedAxesSpace};

use crate::colour::{BLOCKED, INK, MARK, kind, part as colours};
use crate::font;
use crate::legend::{Legend, Sign};
use crate::options::{Labels, PictureOptions};
use crate::page::Page;
use crate::parts::{PartsPicture, frame_of, seen_of_all};
use crate::plane::{axes, draw as draw_plane, seen};
use crate::plot::{Plot, fitting, text};
use crate::scene::{Anchor, Area, Dot, Item, Scene};
use crate::slice::{of_kinds, of_names};
use crate::timeline::{ContactRow, Timeline, Track};
use crate::view::turns_for_ever;

/// Data of a picture of a motion.
#[derive(Debug, Clone, Default)]
pub struct MotionPicture<'a> {
    /// Duration, in seconds.
    pub until: f64,
    /// The mechanism at some times.
    pub frames: Vec<MotionFrame<'a>>,
    /// Coordinates and what else is a number over time.
    pub tracks: Vec<Track>,
    /// The contacts of each pair.
    pub contacts: Vec<ContactRow>,
    /// Times of events, with their descriptions.
    pub events: Vec<(f64, String)>,
    /// Pairs with fixed axes, and their paths.
    pub planes: Vec<PlanePath<'a>>,
    /// Remarks on the motion.
    pub remarks: Vec<String>,
}

/// The mechanism at a time.
#[derive(Debug, Clone, Default)]
pub struct MotionFrame<'a> {
    /// Time, in seconds.
    pub time: f64,
    /// Caption of the frame.
    pub caption: String,
    /// The parts, and where they touch.
    pub parts: PartsPicture<'a>,
}

/// Plane of motions of a pair, and the path in it.
#[derive(Debug, Clone)]
pub struct PlanePath<'a> {
    /// The space of the pair.
    pub space: &'a FixedAxesSpace,
    /// Motions (u, v), joined by lines.
    pub path: Vec<(f64, f64)>,
}

/// Sizes in sizes of letters: of the page for which all is designed, frames, strips, planes, lines of text.
const WIDE: f64 = 100.0;
const MARGIN: f64 = 1.0;
const TOP: f64 = 2.8;
const HIGHEST_FRAME: f64 = 22.0;
const CAPTION: f64 = 2.6;
const STRIP: f64 = 6.5;
const LOW_STRIP: f64 = 4.6;
const PLANE: f64 = 30.0;
const LINE: f64 = 1.55;
/// Text narrower than this is hard to read.
const NARROW: f64 = 26.0;

/// Draws a page of a motion: the mechanism at some times, each with a letter that is repeated above the strips; the
/// coordinates of parts and the contacts of pairs over time; the planes of motions with the path in red, from a ring to
/// a dot; and the remarks.
///
/// ```
/// use cspace_draw::{MotionPicture, PictureOptions, Track, TrackCurve, motion, svg};
/// let curve = TrackCurve { points: vec![(0.0, 0.0), (1.0, 6.0)], ..TrackCurve::default() };
/// let track = Track { label: "wheel".into(), is_angle: true, curves: vec![curve], ..Track::default() };
/// let picture = MotionPicture { until: 1.0, tracks: vec![track], ..MotionPicture::default() };
/// let drawn = svg(&motion(&picture, &PictureOptions::default()));
/// assert!(drawn.contains(">wheel</text>") && drawn.contains(">time, s</text>"));
/// ```
pub fn motion(picture: &MotionPicture<'_>, options: &PictureOptions) -> Scene {
    let (layout, legend) = Layout::new(picture, options);
    let mut page = Page::with(options, (layout.width, layout.height), legend);
    let mut y = TOP * layout.em;
    y = layout.frames(&mut page.items, y);
    y = layout.timeline(&mut page.items, y);
    layout.planes(&mut page.items, y);
    page.finished()
}

struct Layout<'a> {
    picture: &'a MotionPicture<'a>,
    options: &'a PictureOptions,
    width: f64,
    height: f64,
    em: f64,
    /// Height of a strip, in letter sizes.
    strip: f64,
    letters: Vec<(f64, char)>,
}

impl<'a> Layout<'a> {
    fn new(picture: &'a MotionPicture<'a>, options: &'a PictureOptions) -> (Self, Legend) {
        /// Number of strips from which on they are lower.
        const MANY: usize = 6;
        const EM: f64 = 13.0;
        const LEAST: f64 = 5.0;
        let strip = match picture.tracks.len() > MANY {
            true => LOW_STRIP,
            false => STRIP,
        };
        let letters = (picture.frames.iter().zip('a'..='z'))
            .map(|(frame, letter)| (frame.time, letter))
            .collect();
        let entries = entries(picture);
        let mut legend = Legend::new(entries.clone(), (WIDE - 2.0) * EM, EM);
        let mut layout = Self {
            picture,
            options,
            width: WIDE * EM,
            height: 0.0,
            em: EM,
            strip,
            letters,
        };
        let natural = layout.natural(&legend);
        layout.height = natural * EM;
        if let Some((width, height)) = options.size {
            let em = (width / WIDE).min(height / natural).max(LEAST);
            (layout.width, layout.height, layout.em) = (width, height, em);
            legend = Legend::new(entries, width - 2.0 * em, em);
            // The remaining height goes to the strips.
            let more = height / em - layout.natural(&legend);
            let count = picture.tracks.len().max(1) as f64;
            layout.strip = (strip + more.max(0.0) / count).min(4.0 * strip);
        }
        (layout, legend)
    }

    fn timeline_of(&self) -> Timeline<'_> {
        Timeline {
            until: self.picture.until,
            tracks: &self.picture.tracks,
            rows: &self.picture.contacts,
            events: &self.picture.events,
            letters: &self.letters,
            em: self.em,
        }
    }

    /// The height of all of it, in sizes of letters.
    fn natural(&self, legend: &Legend) -> f64 {
        let legend = legend.height() / self.em + 1.0;
        let (_, frames) = self.frame_size();
        let frames = match self.picture.frames.is_empty() {
            true => 0.0,
            false => frames / self.em + CAPTION,
        };
        let (planes, remarks) = self.below();
        let below = match self.is_beside() {
            true => planes.max(remarks),
            false => planes + remarks,
        };
        TOP + frames + self.timeline_of().height(self.strip) + below + legend
    }

    /// The width and the height of a frame, in dots.
    fn frame_size(&self) -> (f64, f64) {
        let count = self.picture.frames.len().max(1) as f64;
        let wide = (self.width - 2.0 * MARGIN * self.em - (count - 1.0) * self.em) / count;
        let [x, y] = self.seen_of_frames();
        let high = wide * (y.1 - y.0) / (x.1 - x.0);
        (wide, high.clamp(6.0 * self.em, HIGHEST_FRAME * self.em))
    }

    /// Window of the assembly's plane that contains all frames.
    fn seen_of_frames(&self) -> [(f64, f64); 2] {
        seen_of_all(self.picture.frames.iter().map(|f| &f.parts), self.options)
    }

    fn frames(&self, items: &mut Vec<Item>, y: f64) -> f64 {
        let em = self.em;
        if self.picture.frames.is_empty() {
            return y;
        }
        let (wide, high) = self.frame_size();
        let [seen_x, seen_y] = self.seen_of_frames();
        for (k, frame) in self.picture.frames.iter().enumerate() {
            let x = MARGIN * em + k as f64 * (wide + em);
            let area = Area::new(x, y, wide, high);
            frame_of(items, &frame.parts, area, [seen_x, seen_y], em);
            let letter = self.letters.get(k).map_or(' ', |l| l.1);
            let base = Dot::new(x, area.hi.y + 1.3 * em);
            items.push(text(letter.to_string(), base, em, Anchor::Start, MARK));
            let beside = base.moved(1.2 * em, 0.0);
            let said = fitting(&frame.caption, 0.85 * em, wide - 1.4 * em);
            items.push(text(said, beside, 0.85 * em, Anchor::Start, INK));
        }
        y + high + CAPTION * em
    }

    fn timeline(&self, items: &mut Vec<Item>, y: f64) -> f64 {
        let timeline = self.timeline_of();
        timeline.draw(items, Dot::new(0.0, y), self.width, self.strip);
        y + timeline.height(self.strip) * self.em
    }

    /// Planes in a row, as many as fit.
    fn in_a_row(&self) -> usize {
        ((self.width / self.em - MARGIN) / (PLANE + Plot::LEFT + Plot::RIGHT)).floor() as usize
    }

    /// Whether the text has space beside the last planes.
    fn is_beside(&self) -> bool {
        self.text_width(true) >= NARROW * self.em
    }

    /// The width of the text, beside or below the planes.
    fn text_width(&self, beside: bool) -> f64 {
        let whole = self.width - 2.0 * MARGIN * self.em;
        let planes = self.picture.planes.len();
        if !beside || planes == 0 {
            return whole;
        }
        let each = (PLANE + Plot::LEFT + Plot::RIGHT) * self.em;
        if planes > self.in_a_row() {
            return 0.0;
        }
        whole - planes as f64 * each - 2.0 * self.em
    }

    /// The heights of planes and of text, in sizes of letters.
    fn below(&self) -> (f64, f64) {
        let rows = self.picture.planes.len().div_ceil(self.in_a_row().max(1));
        let planes = rows as f64 * (PLANE + Plot::BELOW + 1.0);
        let lines = self.lines().len() as f64;
        (planes, if lines > 0.0 { LINE * lines + 1.0 } else { 0.0 })
    }

    /// Remarks, broken into lines that fit.
    fn lines(&self) -> Vec<String> {
        let room = self.text_width(self.is_beside());
        let mut lines = Vec::new();
        for remark in &self.picture.remarks {
            let mut line = String::new();
            for word in remark.split(' ') {
                let longer = match line.is_empty() {
                    true => format!("• {word}"),
                    false => format!("{line} {word}"),
                };
                if font::width(&longer, self.em) > room && !line.is_empty() {
                    lines.push(line);
                    line = format!("   {word}");
                } else {
                    line = longer;
                }
            }
            lines.push(line);
        }
        lines
    }

    fn planes(&self, items: &mut Vec<Item>, y: f64) {
        let em = self.em;
        let each = (PLANE + Plot::LEFT + Plot::RIGHT) * em;
        let per_row = self.in_a_row().max(1);
        for (k, plane) in self.picture.planes.iter().enumerate() {
            let x = MARGIN * em + (k % per_row) as f64 * each + Plot::LEFT * em;
            let top = y + (k / per_row) as f64 * (PLANE + Plot::BELOW + 1.0) * em + 0.5 * em;
            let area = Area::new(x, top, PLANE * em, PLANE * em);
            let whole = plane.space.extent();
            let (u, v) = plane.space.axes();
            let plot = Plot {
                area,
                x: about(u, plane.path.iter().map(|p| p.0), seen(u, whole[0])),
                y: about(v, plane.path.iter().map(|p| p.1), seen(v, whole[1])),
                em,
            };
            draw_plane(items, plane.space, plot, Labels::None, &plane.path);
            plot.frame(items, &axes(plane.space, self.options));
        }
        let (planes, _) = self.below();
        let at = match self.is_beside() {
            true => {
                let count = self.picture.planes.len() as f64;
                let beside = if count > 0.0 { 2.0 * em } else { 0.0 };
                Dot::new(MARGIN * em + count * each + beside, y)
            }
            false => Dot::new(MARGIN * em, y + planes * em),
        };
        for (k, line) in self.lines().into_iter().enumerate() {
            let base = at.moved(0.0, LINE * em * (k as f64 + 1.0));
            items.push(text(line, base, em, Anchor::Start, INK));
        }
    }
}

/// Range in view of a part's coordinate: if the part turns a little only, the range of its motion and a margin;
/// otherwise all.
fn about(axis: Axis, way: impl Iterator<Item = f64>, all: (f64, f64)) -> (f64, f64) {
    /// Largest range that counts as little, as a share of all; a third of a turn is more than little.
    const LITTLE: f64 = 1.0 / 3.0;
    /// Margin on either side, as a share of the range, and its minimum in radians.
    const BESIDE: f64 = 0.4;
    const LEAST: f64 = 0.1;
    let (lo, hi) = way.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
        (lo.min(x), hi.max(x))
    });
    let wide = hi - lo;
    if !turns_for_ever(axis) || !(0.0..LITTLE * (all.1 - all.0)).contains(&wide) {
        return all;
    }
    let margin = (BESIDE * wide).max(LEAST);
    (lo - margin, hi + margin)
}

fn entries(picture: &MotionPicture<'_>) -> Vec<(Sign, String)> {
    let mut all: Vec<(Sign, String)> = Vec::new();
    if let Some(frame) = picture.frames.first() {
        all.extend(frame.parts.parts.iter().map(|p| {
            let (fill, edge) = colours(p.number);
            (Sign::Field(fill, edge), p.part.name().to_owned())
        }));
        all.push((Sign::Mark(MARK), "contact, or end of the way".to_owned()));
    }
    if !picture.planes.is_empty() {
        all.push((Sign::Field(BLOCKED, INK), "blocked".to_owned()));
        all.push((Sign::Line(MARK), "way in the plane".to_owned()));
        let patches = picture.planes.iter().flat_map(|p| p.space.patches());
        let kinds: Vec<usize> = patches.map(|p| kind(p.fixed, p.moving)).collect();
        all.extend(of_kinds(|k| kinds.contains(&k)));
    }
    if picture.contacts.iter().any(|r| !r.bars.is_empty()) {
        all.push(of_names());
    }
    if picture.contacts.iter().any(|r| !r.impacts.is_empty()) {
        all.push((Sign::Mark(MARK), "below a bar: impact".to_owned()));
    }
    all
}
