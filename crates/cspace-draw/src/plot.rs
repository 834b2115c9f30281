//! A rectangle of a picture with two axes, and where coordinates are in it.

use crate::colour::{GRID, INK, WHITE};
use crate::font;
use crate::options::PictureOptions;
use crate::scene::{Anchor, Area, Colour, Dot, Item, Path, Text};
use crate::ticks::{Quantity, number, step, ticks};

/// Two coordinates, the second upwards, in a rectangle of a picture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plot {
    pub(crate) area: Area,
    pub(crate) x: (f64, f64),
    pub(crate) y: (f64, f64),
    /// The size of letters.
    pub(crate) em: f64,
}

/// Label and quantity of an axis.
#[derive(Debug, Clone)]
pub(crate) struct AxisLabel {
    pub(crate) text: String,
    pub(crate) quantity: Quantity,
}

impl AxisLabel {
    pub(crate) fn of(text: &str, is_angle: bool) -> Self {
        Self {
            text: text.to_owned(),
            quantity: match is_angle {
                true => Quantity::Angle,
                false => Quantity::Length,
            },
        }
    }

    pub(crate) fn length(name: &str, unit: Option<&str>) -> Self {
        Self {
            text: unit.map_or(name.to_owned(), |u| format!("{name}, {u}")),
            quantity: Quantity::Length,
        }
    }

    /// Labels of x and y.
    pub(crate) fn of_positions(options: &PictureOptions) -> [Self; 2] {
        ["x", "y"].map(|name| Self::length(name, options.unit.as_deref()))
    }
}

impl Plot {
    /// Room about the rectangle for numbers and labels, in sizes of letters: left and below, right and above.
    pub(crate) const LEFT: f64 = 5.2;
    pub(crate) const BELOW: f64 = 3.4;
    pub(crate) const RIGHT: f64 = 1.2;

    /// Both coordinates at one scale: the one with room to spare shows more.
    pub(crate) fn at_one_scale(area: Area, x: (f64, f64), y: (f64, f64), em: f64) -> Self {
        let scale = ((x.1 - x.0) / area.width()).max((y.1 - y.0) / area.height());
        let wide = |(lo, hi): (f64, f64), dots: f64| {
            let (middle, half) = (0.5 * (lo + hi), 0.5 * scale * dots);
            (middle - half, middle + half)
        };
        Self {
            area,
            x: wide(x, area.width()),
            y: wide(y, area.height()),
            em,
        }
    }

    /// Position of coordinates in the picture.
    pub(crate) fn place(&self, x: f64, y: f64) -> Dot {
        let share = |t: f64, (lo, hi): (f64, f64)| (t - lo) / (hi - lo);
        Dot::new(
            self.area.lo.x + self.area.width() * share(x, self.x),
            self.area.hi.y - self.area.height() * share(y, self.y),
        )
    }

    /// Dots of a unit of the first coordinate.
    pub(crate) fn scale(&self) -> f64 {
        self.area.width() / (self.x.1 - self.x.0)
    }

    /// The coordinates that a dot is wide and high.
    pub(crate) fn dot(&self) -> (f64, f64) {
        (
            (self.x.1 - self.x.0) / self.area.width(),
            (self.y.1 - self.y.0) / self.area.height(),
        )
    }

    /// Grey lines at round numbers, to lie under everything.
    pub(crate) fn grid(&self, items: &mut Vec<Item>, labels: &[AxisLabel; 2]) {
        let (mut path, area) = (Path::new(), self.area);
        let [across, up] = self.ticks(labels);
        for (at, _) in across {
            let x = self.place(at, 0.0).x;
            path.line_through([Dot::new(x, area.lo.y), Dot::new(x, area.hi.y)]);
        }
        for (at, _) in up {
            let y = self.place(0.0, at).y;
            path.line_through([Dot::new(area.lo.x, y), Dot::new(area.hi.x, y)]);
        }
        items.push(Item::drawn(path, GRID, 0.06 * self.em));
    }

    fn ticks(&self, [x, y]: &[AxisLabel; 2]) -> [Vec<(f64, String)>; 2] {
        // A number is some four letters wide, and half as much apart from the next.
        let most = |dots: f64, letters: f64| (dots / (letters * self.em)).clamp(2.0, 12.0);
        /// Height of a strip below which numbers are closer together.
        const LOW: f64 = 10.0;
        let apart = match self.area.height() < LOW * self.em {
            true => 1.8,
            false => 3.0,
        };
        [
            ticks(self.x, most(self.area.width(), 4.5), x.quantity),
            ticks(self.y, most(self.area.height(), apart), y.quantity),
        ]
    }

    /// Copy with a smaller scale, about the same middle.
    pub(crate) fn at_scale(&self, scale: f64) -> Self {
        let grown = self.scale() / scale;
        let wide = |(lo, hi): (f64, f64)| {
            let (middle, half) = (0.5 * (lo + hi), 0.5 * grown * (hi - lo));
            (middle - half, middle + half)
        };
        Self {
            x: wide(self.x),
            y: wide(self.y),
            ..*self
        }
    }

    /// The frame with its ticks, numbers and labels.
    pub(crate) fn frame(&self, items: &mut Vec<Item>, labels: &[AxisLabel; 2]) {
        self.frame_with(items, labels, [true, true]);
    }

    /// The frame and its ticks, with numbers and labels of those axes alone that are to have them.
    pub(crate) fn frame_with(
        &self,
        items: &mut Vec<Item>,
        labels: &[AxisLabel; 2],
        [with_x, with_y]: [bool; 2],
    ) {
        let (area, em) = (self.area, self.em);
        let mut lines = Path::rectangle(area);
        let [across, up] = self.ticks(labels);
        let tick = 0.35 * em;
        let mut numbers = Vec::new();
        for (at, number) in across {
            let x = self.place(at, 0.0).x;
            lines.line_through([Dot::new(x, area.hi.y), Dot::new(x, area.hi.y + tick)]);
            let below = Dot::new(x, area.hi.y + tick + em);
            let half = 0.5 * font::width(&number, 0.85 * em);
            // A label that would reach below a neighbour's axis is left out.
            let beyond = (area.lo.x - (x - half)).max(x + half - area.hi.x);
            if with_x && beyond < 0.7 * em {
                numbers.push(text(number, below, 0.85 * em, Anchor::Middle, INK));
            }
        }
        for (at, number) in up {
            let y = self.place(0.0, at).y;
            lines.line_through([Dot::new(area.lo.x - tick, y), Dot::new(area.lo.x, y)]);
            let left = Dot::new(area.lo.x - 1.6 * tick, y + 0.3 * em);
            if with_y {
                numbers.push(text(number, left, 0.85 * em, Anchor::End, INK));
            }
        }
        items.push(Item::drawn(lines, INK, 0.08 * em));
        items.extend(numbers);
        let [x, y] = labels;
        let room = |length: f64| length + 2.0 * Self::RIGHT * em;
        let below = Dot::new(0.5 * (area.lo.x + area.hi.x), area.hi.y + 2.7 * em);
        if with_x {
            let x = fitting(&x.text, em, room(area.width()));
            items.push(text(x, below, em, Anchor::Middle, INK));
        }
        let left = Dot::new(area.lo.x - 4.1 * em, 0.5 * (area.lo.y + area.hi.y));
        let y = fitting(&y.text, em, room(area.height()));
        let mut upwards = text(y, left, em, Anchor::Middle, INK);
        if let Item::Text(t) = &mut upwards {
            t.upwards = true;
        }
        if with_y {
            items.push(upwards);
        }
    }

    /// A bar in the lower right corner that is a round length long.
    pub(crate) fn scale_bar(&self, items: &mut Vec<Item>, unit: Option<&str>) {
        let length = step(0.12 * (self.x.1 - self.x.0), Quantity::Length);
        let decimals = (-length.log10() - 1e-9).ceil().clamp(0.0, 17.0) as usize;
        let dots = length * self.scale();
        let end = self.area.hi.moved(-self.em, -self.em);
        let start = end.moved(-dots, 0.0);
        let tick = 0.35 * self.em;
        let mut bar = Path::through([start.moved(0.0, -tick), start, end, end.moved(0.0, -tick)]);
        bar.steps.dedup();
        let label = number(length, decimals);
        let label = unit.map_or(label.clone(), |u| format!("{label} {u}"));
        items.push(Item::drawn(bar.clone(), WHITE, 0.4 * self.em));
        items.push(Item::drawn(bar, INK, 0.13 * self.em));
        let above = Dot::new(0.5 * (start.x + end.x), start.y - 0.7 * tick);
        items.push(haloed(text(
            label,
            above,
            0.85 * self.em,
            Anchor::Middle,
            INK,
        )));
    }
}

/// A line of text.
pub(crate) fn text(text: String, at: Dot, size: f64, anchor: Anchor, colour: Colour) -> Item {
    Item::Text(Text {
        text,
        at,
        size,
        colour,
        anchor,
        upwards: false,
        halo: false,
    })
}

/// Copy of a text with a white outline.
pub(crate) fn haloed(item: Item) -> Item {
    match item {
        Item::Text(t) => Item::Text(Text { halo: true, ..t }),
        other => other,
    }
}

/// A line of text, cut where it would be longer than there is room.
pub(crate) fn fitting(text: &str, size: f64, room: f64) -> String {
    let mut shown = text.to_owned();
    while font::width(&shown, size) > room && shown.pop().is_some() {}
    if shown.len() < text.len() {
        shown.pop();
        shown.push('…');
    }
    shown
}

/// The title at the top, cut where it would leave the picture.
pub(crate) fn title(items: &mut Vec<Item>, title: &str, width: f64, em: f64) {
    let size = 1.25 * em;
    items.push(text(
        fitting(title, size, width - 2.0 * em),
        Dot::new(em, 1.7 * em),
        size,
        Anchor::Start,
        INK,
    ));
}
