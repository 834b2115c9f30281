//! Pictures of slices.

use std::fmt::Write;

use cspace::{CurveGeometry, FeatureKind, Point, Slice, SliceCurve};

/// Slices to be drawn side by side, to one scale.
#[derive(Debug, Clone)]
pub struct Page<'a> {
    /// What is written above them.
    pub title: String,
    /// The size of the pair, in the model's unit: how much room is left about the slices.
    pub size: f64,
    /// The slices.
    pub slices: &'a [Slice],
}

/// Width and height of a picture, in pixels, for one slice and in a grid.
const WIDE: f64 = 720.0;
const SMALL: f64 = 300.0;
/// Room for the caption of a slice and for the title.
const CAPTION: f64 = 22.0;
const TITLE: f64 = 30.0;
const GAP: f64 = 12.0;
/// Height of a line of the legend.
const LINE: f64 = 13.0;

/// Colours of contact: moving feature on fixed line, moving line on fixed feature, two round features; and blocked.
const FIXED_LINE: &str = "#1f6fb4";
const MOVING_LINE: &str = "#c8541d";
const ROUND: &str = "#2b8a3e";
pub(super) const BLOCKED: &str = "#c9ccd1";

/// A picture of slices: free space white, blocked space grey, curves coloured by the kind of contact.
///
/// ```
/// use cspace::{Part, Slice, Vertex};
/// use cspace_io::write::svg;
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let slice = Slice::compute(&square("table", 2.0)?, &square("block", 1.0)?, 0.1);
/// let page = svg::Page { title: "block & table".into(), size: 4.0, slices: &[slice] };
/// let picture = svg::slices(&page);
/// assert!(picture.starts_with("<svg") && picture.contains("block &amp; table"));
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn slices(page: &Page<'_>) -> String {
    let n = page.slices.len();
    let columns = (1..=n).find(|c| c * c >= n).unwrap_or(1);
    let rows = n.div_ceil(columns).max(1);
    let side = if n <= 1 { WIDE } else { SMALL };
    let (width, height) = (
        GAP + columns as f64 * (side + GAP),
        TITLE + rows as f64 * (side + CAPTION + GAP) + LEGEND.len() as f64 * LINE + GAP,
    );
    let mut out = opened(&page.title, width, height, GAP);
    let view = View::of(page, side);
    for (i, slice) in page.slices.iter().enumerate() {
        let x = GAP + (i % columns) as f64 * (side + GAP);
        let y = TITLE + (i / columns) as f64 * (side + CAPTION + GAP);
        let _ = writeln!(out, r#"<g transform="translate({x} {y})">"#);
        draw(&mut out, slice, &view, side, i);
        out.push_str("</g>\n");
    }
    legend(&mut out, height - GAP - LEGEND.len() as f64 * LINE);
    out.push_str("</svg>\n");
    out
}

/// The beginning of a picture: its size, a white ground, the title.
pub(super) fn opened(title: &str, width: f64, height: f64, left: f64) -> String {
    let mut out = String::new();
    let _ = writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13" fill="none">"#
    );
    let _ = writeln!(
        out,
        r##"<rect width="100%" height="100%" fill="white"/><text x="{left}" y="22" font-size="16" fill="#222">{}</text>"##,
        escaped(title)
    );
    out
}

/// From the plane to a picture: the y axis points up in the one and down in the other.
struct View {
    center: Point,
    scale: f64,
    half: f64,
}

impl View {
    fn of(page: &Page<'_>, side: f64) -> Self {
        let (mut lo, mut hi) = (
            Point::new(f64::INFINITY, f64::INFINITY),
            Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
        );
        let curves = page.slices.iter().flat_map(|s| &s.curves);
        for p in curves.flat_map(|c| (0..=4).map(|k| c.geometry.point(0.25 * f64::from(k)))) {
            lo = Point::new(lo.x.min(p.x), lo.y.min(p.y));
            hi = Point::new(hi.x.max(p.x), hi.y.max(p.y));
        }
        if !(lo.is_finite() && hi.is_finite()) {
            (lo, hi) = (Point::ORIGIN, Point::ORIGIN);
        }
        let reach = (hi.x - lo.x).max(hi.y - lo.y) + 0.2 * page.size;
        Self {
            center: lo.midpoint(hi),
            scale: if reach > 0.0 { side / reach } else { 1.0 },
            half: 0.5 * side,
        }
    }

    fn place(&self, p: Point) -> (f64, f64) {
        (
            rounded(self.half + (p.x - self.center.x) * self.scale),
            rounded(self.half - (p.y - self.center.y) * self.scale),
        )
    }
}

/// To a thousandth of a pixel, so that files stay small.
pub(super) fn rounded(x: f64) -> f64 {
    (x * 1000.0).round() / 1000.0
}

fn draw(out: &mut String, slice: &Slice, view: &View, side: f64, index: usize) {
    // Blocked space is on the left of the loops, whichever way they go: even-odd of all loops together.
    let mut region = String::new();
    for l in &slice.loops {
        let curves = l.iter().map(|&c| &slice.curves[c as usize]);
        for (k, c) in curves.enumerate() {
            if k == 0 {
                let (x, y) = view.place(c.geometry.point(0.0));
                let _ = write!(region, "M{x} {y}");
            }
            append(&mut region, &c.geometry, view);
        }
        region.push('Z');
    }
    let _ = writeln!(
        out,
        r##"<clipPath id="c{index}"><rect width="{side}" height="{side}"/></clipPath><g clip-path="url(#c{index})"><path d="{region}" fill="{BLOCKED}" fill-rule="evenodd"/>"##
    );
    for (colour, name) in [(FIXED_LINE, 0), (MOVING_LINE, 1), (ROUND, 2)] {
        let mut path = String::new();
        for c in slice.curves.iter().filter(|c| kind(c) == name) {
            let (x, y) = view.place(c.geometry.point(0.0));
            let _ = write!(path, "M{x} {y}");
            append(&mut path, &c.geometry, view);
        }
        if !path.is_empty() {
            let _ = writeln!(
                out,
                r#"<path d="{path}" stroke="{colour}" stroke-width="1.4" stroke-linecap="round"/>"#
            );
        }
    }
    let _ = writeln!(
        out,
        r##"</g><rect width="{side}" height="{side}" stroke="#999"/><text x="4" y="{}" fill="#222">θ = {:.5} rad = {:.3}°</text>"##,
        side + 16.0,
        slice.theta,
        slice.theta.to_degrees()
    );
}

fn kind(c: &SliceCurve) -> u8 {
    if c.fixed.kind == FeatureKind::Line {
        0
    } else if c.moving.kind == FeatureKind::Line {
        1
    } else {
        2
    }
}

/// Appends a curve to a path that is at its start.
fn append(path: &mut String, geometry: &CurveGeometry, view: &View) {
    match *geometry {
        CurveGeometry::Segment { end, .. } => {
            let (x, y) = view.place(end);
            let _ = write!(path, "L{x} {y}");
        }
        CurveGeometry::FlatArc { start, end, bulge } => {
            // The radius, but no longer than numbers of a picture are: the height is far below a dot then.
            const LONGEST: f64 = 1e7;
            let radius = start.distance(end) * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
            let r = rounded((radius * view.scale).min(LONGEST)).max(0.001);
            let (x, y) = view.place(end);
            let clockwise = u8::from(bulge < 0.0);
            let _ = write!(path, "A{r} {r} 0 0 {clockwise} {x} {y}");
        }
        CurveGeometry::Arc { radius, sweep, .. } => {
            // An arc of SVG is told by its ends, which must not coincide: two halves, or three pieces.
            let pieces = if sweep.abs() > 3.0 { 3 } else { 1 };
            let r = rounded(radius * view.scale).max(0.001);
            for k in 1..=pieces {
                let (x, y) = view.place(geometry.point(f64::from(k) / f64::from(pieces)));
                let clockwise = u8::from(sweep < 0.0);
                let _ = write!(path, "A{r} {r} 0 0 {clockwise} {x} {y}");
            }
        }
    }
}

/// What the colours mean.
const LEGEND: [(&str, &str); 3] = [
    (FIXED_LINE, "line of the fixed part"),
    (MOVING_LINE, "line of the moving part"),
    (ROUND, "arcs and vertices"),
];

/// Below each other, since the entries do not fit beside each other below one small picture; `top` is where they begin.
fn legend(out: &mut String, top: f64) {
    let mut y = top;
    for (colour, text) in LEGEND {
        y += LINE;
        let _ = writeln!(
            out,
            r##"<path d="M{GAP} {0}h18" stroke="{colour}" stroke-width="3"/><text x="{1}" y="{y}" font-size="11" fill="#222">{text}</text>"##,
            y - 4.0,
            GAP + 24.0,
        );
    }
}

/// The text as XML takes it. Control characters, and the two that are no characters, have no place in XML, not even as
/// references: they are shown as Rust writes them.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {
                out.extend(c.escape_unicode());
            }
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{Page, slices};
    use cspace::{Part, Slice, Vertex};

    /// The numbers in quotes that follow each `before`.
    fn numbers(text: &str, before: &str) -> Vec<f64> {
        (text.split(before).skip(1))
            .filter_map(|rest| rest[..rest.find('"').unwrap()].parse().ok())
            .collect()
    }

    #[test]
    fn titles_are_text_whatever_they_say() {
        let page = |title: &str| Page {
            title: title.into(),
            size: 4.0,
            slices: &[],
        };
        let picture = slices(&page("</text><script>\u{1b}[2J\u{0}\n\u{9b}\u{ffff}&\"'"));
        let plain = slices(&page("plain"));
        // Lines and tags are those of a harmless title.
        assert_eq!(picture.lines().count(), plain.lines().count());
        assert_eq!(picture.matches('<').count(), plain.matches('<').count());
        assert!(picture.contains(
            "&lt;/text&gt;&lt;script&gt;\\u{1b}[2J\\u{0}\\u{a}\\u{9b}\\u{ffff}&amp;&quot;&#39;</text>"
        ));
        let control = |c: char| c.is_control() && c != '\n';
        assert!(!picture.contains(control) && !picture.contains('\u{ffff}'));
    }

    #[test]
    fn all_is_inside_the_page() {
        let square = |name: &str, r: f64| {
            let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
            let corners = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
            Part::new(name, vec![corners]).unwrap()
        };
        let (table, block) = (square("table", 2.0), square("block", 1.0));
        for n in [0, 1, 2, 5, 12] {
            let drawn: Vec<Slice> = (0..n)
                .map(|i| Slice::compute(&table, &block, 0.1 * f64::from(i)))
                .collect();
            let page = Page {
                title: "block in table".into(),
                size: 4.0,
                slices: &drawn,
            };
            let picture = slices(&page);
            let height = numbers(&picture, " height=\"")[0];
            // The legend is last, outside of any group.
            let legend = &picture[picture.find("line of the fixed part").unwrap() - 60..];
            let lines = numbers(legend, " y=\"");
            assert_eq!(lines.len(), 3, "{n}");
            assert!(lines.windows(2).all(|w| w[0] + 11.0 <= w[1]), "{n}");
            assert!(lines[2] + 4.0 <= height, "{n}: {lines:?} of {height}");
            // The slices' frames and captions end above it.
            let last = (picture.match_indices("<g transform=\"translate(").last()).map_or(
                0.0,
                |(at, m)| {
                    let place = &picture[at + m.len()..];
                    let y = &place[place.find(' ').unwrap() + 1..place.find(')').unwrap()];
                    y.parse::<f64>().unwrap()
                },
            );
            let side = if n == 1 { super::WIDE } else { super::SMALL };
            if n > 0 {
                assert!(lines[0] - 11.0 >= last + side + 16.0, "{n}: {lines:?}");
            }
        }
    }
}
