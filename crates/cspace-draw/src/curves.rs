//! Quantities over one that is varied: strips one above the other, with places at which something changes.

use crate::colour::{INK, MARK, part};
use crate::options::{Labels, PictureOptions};
use crate::page::Page;
use crate::plot::{AxisLabel, Plot, haloed, text};
use crate::scene::{Anchor, Area, Dot, Item, Path, Scene};

/// Data of a picture of quantities over one that is varied.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CurvesPicture {
    /// Name of the varied quantity, with its unit.
    pub across: String,
    /// Whether the varied quantity is an angle, in radians.
    pub is_angle: bool,
    /// The quantities.
    pub strips: Vec<CurveStrip>,
    /// Values at which something changes.
    pub marks: Vec<f64>,
}

/// A quantity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CurveStrip {
    /// Name of the quantity, with its unit.
    pub label: String,
    /// Whether the quantity is an angle, in radians.
    pub is_angle: bool,
    /// The smallest and the largest value that is allowed.
    pub limits: Option<(f64, f64)>,
    /// Range of values in view; all of them if `None`.
    pub seen: Option<(f64, f64)>,
    /// Curves of the quantity.
    pub curves: Vec<Curve>,
}

/// Values of a quantity over the varied one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Label of the curve; empty for a single one.
    pub label: String,
    /// The values in order, none where there is no value.
    pub points: Vec<(f64, Option<f64>)>,
}

/// A picture of quantities over one that is varied: a strip for each, limits in grey, places at which something changes in red.
///
/// ```
/// use cspace_draw::{Curve, CurveStrip, CurvesPicture, PictureOptions, curves, svg};
/// let curve = Curve { points: vec![(0.1, Some(0.2)), (0.2, Some(0.4)), (0.3, None)], ..Curve::default() };
/// let strip = CurveStrip { label: "tilt".into(), is_angle: true, curves: vec![curve], ..CurveStrip::default() };
/// let picture = CurvesPicture { across: "play, mm".into(), strips: vec![strip], marks: vec![0.25], ..CurvesPicture::default() };
/// let drawn = svg(&curves(&picture, &PictureOptions::default()));
/// assert!(drawn.contains(">play, mm</text>") && drawn.contains(">tilt</text>"));
/// ```
pub fn curves(picture: &CurvesPicture, options: &PictureOptions) -> Scene {
    /// Width of the page, height of a strip, and space above and between, in dots.
    const WIDE: f64 = 900.0;
    const STRIP: f64 = 200.0;
    const ABOVE: f64 = 45.0;
    const BETWEEN: f64 = 26.0;
    const BELOW: f64 = 55.0;
    let count = picture.strips.len().max(1) as f64;
    let usual = (WIDE, ABOVE + BELOW + count * (STRIP + BETWEEN));
    let mut page = Page::of(options, usual, Vec::new());
    let (em, share) = (page.em, page.height / usual.1);
    let all = picture.strips.iter().flat_map(|s| &s.curves);
    let x = options
        .x
        .unwrap_or_else(|| range(all.flat_map(|c| &c.points).map(|p| p.0), 0.0));
    for (i, strip) in picture.strips.iter().enumerate() {
        let top = (ABOVE + i as f64 * (STRIP + BETWEEN)) * share;
        let left = (Plot::LEFT + 0.5) * em;
        let area = Area::new(
            left,
            top,
            page.width - left - 2.0 * Plot::RIGHT * em,
            STRIP * share,
        );
        let values = strip.curves.iter().flat_map(|c| &c.points);
        let values = values.filter_map(|p| p.1);
        let y = strip.seen.unwrap_or_else(|| range(values, 0.08));
        let plot = Plot { area, x, y, em };
        let labels = [
            AxisLabel::of(&picture.across, picture.is_angle),
            AxisLabel::of(&strip.label, strip.is_angle),
        ];
        let items = &mut page.items;
        let is_last = i + 1 == picture.strips.len();
        plot.grid(items, &labels);
        let mut inner = Vec::new();
        for at in strip.limits.iter().flat_map(|&(lo, hi)| [lo, hi]) {
            let path = Path::through([plot.place(x.0, at), plot.place(x.1, at)]);
            inner.push(Item::drawn(path, crate::colour::BLOCKED, 0.2 * em));
        }
        for &at in &picture.marks {
            let path = Path::through([plot.place(at, y.0), plot.place(at, y.1)]);
            inner.push(Item::drawn(path, MARK, 0.08 * em));
        }
        for (k, curve) in strip.curves.iter().enumerate() {
            draw(&mut inner, &plot, curve, k, em);
        }
        items.push(Item::Clipped { area, items: inner });
        let with = options.labels != Labels::None;
        plot.frame_with(items, &labels, [with && is_last, with]);
        if strip.curves.len() > 1 && with {
            for (k, curve) in strip.curves.iter().enumerate() {
                let last = curve.points.iter().rev().find_map(|p| Some((p.0, p.1?)));
                let Some((at, value)) = last else {
                    continue;
                };
                let beside = plot.place(at.min(x.1), value).moved(-0.4 * em, -0.3 * em);
                let colour = part(k).1;
                let words = text(curve.label.clone(), beside, 0.8 * em, Anchor::End, colour);
                items.push(haloed(words));
            }
        }
    }
    page.finished()
}

/// Range of some values, extended by a share `more` of its width on both sides.
fn range(values: impl Iterator<Item = f64>, more: f64) -> (f64, f64) {
    let (lo, hi) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
        (lo.min(x), hi.max(x))
    });
    if lo > hi {
        return (0.0, 1.0);
    }
    // One value alone has room about it.
    let wide = if hi - lo > 1e-9 * hi.abs().max(lo.abs()) {
        hi - lo
    } else {
        0.1 * hi.abs().max(1.0)
    };
    let pad = if hi - lo < wide {
        0.5 * wide
    } else {
        more * wide
    };
    (lo - pad, hi + pad)
}

/// The pieces of a curve between places without a value; a value alone is a dot.
fn draw(items: &mut Vec<Item>, plot: &Plot, curve: &Curve, number: usize, em: f64) {
    let colour = if number == 0 { INK } else { part(number).1 };
    let pieces = curve.points.split(|p| p.1.is_none());
    for piece in pieces.filter(|p| !p.is_empty()) {
        let dots = piece
            .iter()
            .filter_map(|&(at, value)| Some(plot.place(at, value?)));
        let mut dots: Vec<Dot> = dots.collect();
        if let [one] = dots[..] {
            let half = 0.15 * em;
            dots = vec![one.moved(-half, 0.0), one.moved(half, 0.0)];
            items.push(Item::drawn(Path::through(dots), colour, 2.0 * half));
        } else {
            items.push(Item::drawn(Path::through(dots), colour, 0.14 * em));
        }
    }
}
