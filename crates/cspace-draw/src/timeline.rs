//! Timeline: strips below each other, with coordinates as curves and contacts as bars.

use crate::colour::{INK, MARK, bar, part as colours};
use crate::font;
use crate::line::simplified;
use crate::plot::{AxisLabel, Plot, fitting, haloed, text};
use crate::scene::{Anchor, Area, Colour, Dot, Item, Path, Stroke};

/// A strip: curves over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Track {
    /// Label of the strip.
    pub label: String,
    /// The unit of its numbers, if they have one; of angles it is degrees.
    pub unit: Option<String>,
    /// Whether the numbers are angles, in radians.
    pub is_angle: bool,
    /// The curves.
    pub curves: Vec<TrackCurve>,
}

/// A curve in a strip.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TrackCurve {
    /// Times and values, joined by lines.
    pub points: Vec<(f64, f64)>,
    /// The number of the part it is of, which chooses its colour.
    pub part: usize,
    /// Tooltip of the curve.
    pub title: String,
}

/// The contacts of a pair over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactRow {
    /// The pair.
    pub label: String,
    /// Contacts of the pair.
    pub bars: Vec<ContactBar>,
    /// Times of impacts, with their tooltips.
    pub impacts: Vec<(f64, String)>,
}

/// A contact from a time to a time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactBar {
    /// Begin of the contact.
    pub from: f64,
    /// End of the contact.
    pub to: f64,
    /// The number of its pair of features, which chooses its colour.
    pub features: usize,
    /// Label on the bar, written where there is room.
    pub label: String,
    /// Tooltip of the bar.
    pub title: String,
}

/// Strips below each other with one axis of time.
pub(crate) struct Timeline<'a> {
    pub(crate) until: f64,
    pub(crate) tracks: &'a [Track],
    pub(crate) rows: &'a [ContactRow],
    /// Times of events, with their descriptions.
    pub(crate) events: &'a [(f64, String)],
    /// Times that have a letter.
    pub(crate) letters: &'a [(f64, char)],
    pub(crate) em: f64,
}

/// Sizes are multiples of the letter size.
impl Timeline<'_> {
    /// Space at the left for names and numbers, at the right, above for letters, below for the axis.
    const LEFT: f64 = 16.0;
    const RIGHT: f64 = 1.2;
    const ABOVE: f64 = 1.6;
    const BELOW: f64 = 3.4;
    const BETWEEN: f64 = 0.7;
    const LANE: f64 = 1.25;
    /// Largest number of lanes: if more contacts are closed at once, the last are drawn over each other.
    const MOST_LANES: usize = 4;

    /// Total height with strips of a given height.
    pub(crate) fn height(&self, strip: f64) -> f64 {
        Self::ABOVE + self.inner(strip) + Self::BELOW
    }

    /// Height without the space above and below.
    fn inner(&self, strip: f64) -> f64 {
        let tracks = self.tracks.len() as f64 * (strip + Self::BETWEEN);
        let rows: f64 = self.rows.iter().map(Self::row_height).sum();
        tracks + rows
    }

    fn row_height(row: &ContactRow) -> f64 {
        Self::LANE * lanes(row).1 as f64 + Self::BETWEEN
    }

    /// Draws the timeline with its upper left corner at a place.
    pub(crate) fn draw(&self, items: &mut Vec<Item>, at: Dot, width: f64, strip: f64) {
        let em = self.em;
        let left = at.x + Self::LEFT * em;
        let wide = width - (Self::LEFT + Self::RIGHT) * em;
        let mut y = at.y + Self::ABOVE * em;
        let top = y;
        let plot = |y: f64, high: f64, range: (f64, f64)| Plot {
            area: Area::new(left, y, wide, high),
            x: (0.0, self.until),
            y: range,
            em,
        };
        self.letters(
            items,
            &plot(top, 0.0, (0.0, 1.0)),
            top + self.inner(strip) * em,
        );
        for track in self.tracks {
            let plot = plot(y, strip * em, range(track));
            self.track(items, track, &plot);
            y = plot.area.hi.y + Self::BETWEEN * em;
        }
        for row in self.rows {
            let high = Self::row_height(row) * em;
            self.row(items, row, &plot(y, high, (0.0, 1.0)));
            y += high;
        }
        let axis = plot(y, 0.0, (0.0, 1.0));
        axis.frame_with(items, &labels(false), [true, false]);
    }

    fn track(&self, items: &mut Vec<Item>, track: &Track, plot: &Plot) {
        let (area, em) = (plot.area, self.em);
        let labels = labels(track.is_angle);
        plot.grid(items, &labels);
        self.event_lines(items, plot);
        let mut inner = Vec::new();
        for curve in &track.curves {
            let line: Vec<Dot> = (curve.points.iter())
                .map(|&(t, value)| plot.place(t, value))
                .collect();
            inner.push(Item::Shape {
                path: Path::through(simplified(&line)),
                fill: None,
                stroke: Some(Stroke {
                    colour: colours(curve.part).1,
                    width: 0.16 * em,
                }),
                title: Some(curve.title.clone()),
            });
        }
        items.push(Item::Clipped { area, items: inner });
        plot.frame_with(items, &labels, [false, true]);
        let colour = match &track.curves[..] {
            [one] => colours(one.part).1,
            _ => INK,
        };
        let middle = 0.5 * (area.lo.y + area.hi.y);
        let unit = match (track.is_angle, &track.unit) {
            (true, _) => Some("degrees"),
            (false, unit) => unit.as_deref(),
        };
        let lines = [Some(track.label.as_str()), unit];
        let count = lines.iter().flatten().count() as f64;
        for (k, said) in lines.into_iter().flatten().enumerate() {
            let y = middle + 1.2 * em * (k as f64 - 0.5 * (count - 1.0)) + 0.35 * em;
            self.name(items, said, area.lo.x, y, colour);
        }
    }

    /// A name left of a strip, cut where it would leave the picture.
    fn name(&self, items: &mut Vec<Item>, said: &str, right: f64, y: f64, colour: Colour) {
        let (em, size) = (self.em, self.em);
        let room = (Self::LEFT - 5.2) * em;
        let at = Dot::new(right - (Self::LEFT - 1.0) * em, y);
        items.push(text(
            fitting(said, size, room),
            at,
            size,
            Anchor::Start,
            colour,
        ));
    }

    /// Lines at events; of very many only ticks at the top.
    fn event_lines(&self, items: &mut Vec<Item>, plot: &Plot) {
        const MOST: usize = 150;
        const LINE: Colour = Colour(0x9a, 0xa0, 0xa8);
        let area = plot.area;
        let foot = match self.events.len() > MOST {
            true => area.lo.y + 0.5 * self.em,
            false => area.hi.y,
        };
        for (t, said) in self.events {
            let x = plot.place(*t, 0.0).x;
            items.push(Item::Shape {
                path: Path::through([Dot::new(x, area.lo.y), Dot::new(x, foot)]),
                fill: None,
                stroke: Some(Stroke {
                    colour: LINE,
                    width: 0.05 * self.em,
                }),
                title: Some(said.clone()),
            });
        }
    }

    fn row(&self, items: &mut Vec<Item>, row: &ContactRow, plot: &Plot) {
        let (em, area) = (self.em, plot.area);
        let (of, count) = lanes(row);
        let middle = 0.5 * (area.lo.y + area.hi.y - Self::BETWEEN * em);
        self.name(items, &row.label, area.lo.x, middle + 0.35 * em, INK);
        let lane = |k: usize| area.lo.y + k as f64 * Self::LANE * em;
        let ground = Area::new(
            area.lo.x,
            area.lo.y,
            area.width(),
            Self::LANE * em * count as f64,
        );
        items.push(Item::filled(
            Path::rectangle(ground),
            Colour(0xf3, 0xf4, 0xf6),
        ));
        for (contact, k) in row.bars.iter().zip(of) {
            let (fill, ink) = bar(contact.features);
            let x = [contact.from, contact.to].map(|t| plot.place(t, 0.0).x);
            // Short contacts are visible, too.
            let wide = (x[1] - x[0]).max(0.12 * em);
            let field = Area::new(x[0], lane(k), wide, (Self::LANE - 0.1) * em);
            items.push(Item::Shape {
                path: Path::rectangle(field),
                fill: Some(fill),
                stroke: None,
                title: Some(contact.title.clone()),
            });
            let size = 0.8 * em;
            if font::width(&contact.label, size) + 0.6 * em < wide {
                let at = Dot::new(0.5 * (x[0] + x[1]), lane(k) + 0.88 * em);
                let said = contact.label.clone();
                items.push(text(said, at, size, Anchor::Middle, ink));
            }
        }
        for (t, said) in &row.impacts {
            let at = Dot::new(plot.place(*t, 0.0).x, ground.hi.y);
            let mut mark = Path::through([
                at,
                at.moved(-0.35 * em, 0.6 * em),
                at.moved(0.35 * em, 0.6 * em),
            ]);
            mark.steps.push(crate::scene::Step::Close);
            items.push(Item::Shape {
                path: mark,
                fill: Some(MARK),
                stroke: None,
                title: Some(said.clone()),
            });
        }
    }

    /// The letters of frames above the strips, with lines down to the axis that lie under all else.
    fn letters(&self, items: &mut Vec<Item>, axis: &Plot, foot: f64) {
        const LINE: Colour = Colour(0xea, 0x9a, 0xa6);
        let top = axis.area.lo.y;
        let em = self.em;
        let mut last = f64::NEG_INFINITY;
        for (t, letter) in self.letters {
            let x = axis.place(*t, 0.0).x;
            let line = Path::through([Dot::new(x, top), Dot::new(x, foot)]);
            items.push(Item::drawn(line, LINE, 0.08 * em));
            // Labels of adjacent moments stand beside each other.
            let at = x.max(last + 0.9 * em);
            last = at;
            let place = Dot::new(at, top - 0.4 * em);
            let said = text(letter.to_string(), place, em, Anchor::Middle, MARK);
            items.push(haloed(said));
        }
    }
}

/// Labels of the axes of a strip, whose name stands beside.
fn labels(is_angle: bool) -> [AxisLabel; 2] {
    [AxisLabel::of("time, s", false), AxisLabel::of("", is_angle)]
}

/// Range of values that a strip shows.
fn range(track: &Track) -> (f64, f64) {
    let values = track
        .curves
        .iter()
        .flat_map(|c| c.points.iter().map(|p| p.1));
    let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
        (lo.min(x), hi.max(x))
    });
    let (lo, hi) = if lo <= hi { (lo, hi) } else { (0.0, 0.0) };
    // A nearly constant curve is shown as constant: rounding is no motion.
    let least = if track.is_angle {
        1e-3
    } else {
        1e-6 * lo.abs().max(hi.abs()).max(1.0)
    };
    let margin = (0.08 * (hi - lo)).max(0.5 * (least - (hi - lo)));
    (lo - margin, hi + margin)
}

/// The lane of each bar, so that contacts of one time lie beside each other, and how many lanes there are.
fn lanes(row: &ContactRow) -> (Vec<usize>, usize) {
    let mut ends: Vec<f64> = Vec::new();
    let mut of = Vec::new();
    for contact in &row.bars {
        let free = ends.iter().position(|end| *end <= contact.from);
        let lane = free.unwrap_or(ends.len()).min(Timeline::MOST_LANES - 1);
        match ends.get_mut(lane) {
            Some(end) => *end = contact.to,
            None => ends.push(contact.to),
        }
        of.push(lane);
    }
    (of, ends.len().max(1))
}
