//! A scene as SVG.

use std::fmt::Write;

use crate::arc::edge;
use crate::font::{FAMILY, halo};
use crate::scene::{Anchor, Area, Colour, Dot, Item, Path, Scene, Step, Text};

/// A picture as SVG: arcs as arcs, text as text.
pub fn svg(scene: &Scene) -> String {
    let mut out = String::new();
    let (w, h) = (Number(scene.width), Number(scene.height));
    let _ = writeln!(
        out,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" font-family="{FAMILY}" font-weight="300" fill="none" stroke-linecap="round" stroke-linejoin="round" fill-rule="evenodd">"#
    );
    let _ = writeln!(
        out,
        r##"<title>{}</title><rect width="100%" height="100%" fill="#ffffff"/>"##,
        escaped(&scene.title)
    );
    let mut clips = 0;
    items(&mut out, &scene.items, &mut clips);
    out.push_str("</svg>\n");
    out
}

fn items(out: &mut String, all: &[Item], clips: &mut usize) {
    for item in all {
        match item {
            Item::Shape {
                path,
                fill,
                stroke,
                title,
            } => {
                if path.steps.is_empty() {
                    continue;
                }
                out.push_str("<path d=\"");
                data(out, path);
                out.push('"');
                if let Some(fill) = fill {
                    let _ = write!(out, r#" fill="{}""#, Hex(*fill));
                }
                if let Some(stroke) = stroke {
                    let _ = write!(out, r#" stroke="{}""#, Hex(stroke.colour));
                    let _ = write!(out, r#" stroke-width="{}""#, Number(stroke.width));
                }
                match title {
                    None => out.push_str("/>\n"),
                    Some(title) => {
                        let _ = writeln!(out, "><title>{}</title></path>", escaped(title));
                    }
                }
            }
            Item::Text(text) => write_text(out, text),
            Item::Clipped { area, items: inner } => {
                let Area { lo, .. } = area;
                let _ = writeln!(
                    out,
                    r#"<clipPath id="c{clips}"><rect x="{}" y="{}" width="{}" height="{}"/></clipPath><g clip-path="url(#c{clips})">"#,
                    Number(lo.x),
                    Number(lo.y),
                    Number(area.width()),
                    Number(area.height())
                );
                *clips += 1;
                items(out, inner, clips);
                out.push_str("</g>\n");
            }
        }
    }
}

fn write_text(out: &mut String, text: &Text) {
    let Dot { x, y } = text.at;
    let (x, y) = (Number(x), Number(y));
    let _ = write!(out, r#"<text font-size="{}""#, Number(text.size));
    if text.upwards {
        let _ = write!(out, r#" transform="translate({x} {y}) rotate(-90)""#);
    } else {
        let _ = write!(out, r#" x="{x}" y="{y}""#);
    }
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => out.push_str(r#" text-anchor="middle""#),
        Anchor::End => out.push_str(r#" text-anchor="end""#),
    }
    let _ = write!(out, r#" fill="{}""#, Hex(text.colour));
    if text.halo {
        let width = Number(halo(text.size));
        let _ = write!(
            out,
            r##" stroke="#ffffff" stroke-width="{width}" paint-order="stroke""##
        );
    }
    let _ = writeln!(out, ">{}</text>", escaped(&text.text));
}

/// Steps of a path, relative to the place before: shorter than absolute ones. Coordinates are rounded, and each step is
/// relative to the rounded place, so that errors do not add up.
fn data(out: &mut String, path: &Path) {
    let mut at = Dot::new(0.0, 0.0);
    let mut began = at;
    for step in &path.steps {
        match *step {
            Step::Move(to) => {
                at = rounded(to);
                began = at;
                let _ = write!(out, "M{}{}", Number(at.x), Next(at.y));
            }
            Step::Line(to) => {
                let to = rounded(to);
                let _ = write!(out, "l{}{}", Number(to.x - at.x), Next(to.y - at.y));
                at = to;
            }
            Step::Arc { to, bulge } => {
                arc(out, at, to, bulge);
                at = rounded(to);
            }
            Step::Close => {
                out.push('z');
                at = began;
            }
        }
    }
}

fn arc(out: &mut String, from: Dot, to: Dot, bulge: f64) {
    /// Longer radii than that are straight lines, as far as can be seen.
    const LONGEST: f64 = 1e7;
    let end = rounded(to);
    let (dx, dy) = (Number(end.x - from.x), Next(end.y - from.y));
    let r = edge(from, to, bulge).radius();
    if !(r < LONGEST && r > 0.0) {
        let _ = write!(out, "l{dx}{dy}");
        return;
    }
    let (large, clockwise) = (u8::from(bulge.abs() > 1.0), u8::from(bulge > 0.0));
    let r = Number(r.max(0.005));
    let _ = write!(out, "a{r} {r} 0 {large} {clockwise} {dx}{dy}");
}

/// Rounds to a hundredth of a dot, so that files stay small.
fn rounded(p: Dot) -> Dot {
    Dot::new(hundredth(p.x), hundredth(p.y))
}

fn hundredth(x: f64) -> f64 {
    (x * 100.0).round() / 100.0
}

/// A number as short as can be.
struct Number(f64);

impl std::fmt::Display for Number {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        // Adding 0 makes −0 a 0.
        let text = (hundredth(self.0) + 0.0).to_string();
        match text.strip_prefix("0.") {
            Some(rest) => write!(f, ".{rest}"),
            None => match text.strip_prefix("-0.") {
                Some(rest) => write!(f, "-.{rest}"),
                None => f.write_str(&text),
            },
        }
    }
}

/// A number that follows another: a sign parts them as well as a space.
struct Next(f64);

impl std::fmt::Display for Next {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = Number(self.0).to_string();
        let space = if text.starts_with('-') { "" } else { " " };
        write!(f, "{space}{text}")
    }
}

struct Hex(Colour);

impl std::fmt::Display for Hex {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Colour(r, g, b) = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
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
    use super::*;

    #[test]
    fn titles_are_text_whatever_they_say() {
        let scene = |title: &str| Scene {
            width: 100.0,
            height: 50.0,
            title: title.into(),
            items: Vec::new(),
        };
        let picture = svg(&scene("</title><script>\u{1b}[2J\u{0}\n\u{9b}\u{ffff}&\"'"));
        let plain = svg(&scene("plain"));
        // Lines and tags are those of a harmless title.
        assert_eq!(picture.lines().count(), plain.lines().count());
        assert_eq!(picture.matches('<').count(), plain.matches('<').count());
        assert!(picture.contains(
            "&lt;/title&gt;&lt;script&gt;\\u{1b}[2J\\u{0}\\u{a}\\u{9b}\\u{ffff}&amp;&quot;&#39;</title>"
        ));
        let control = |c: char| c.is_control() && c != '\n';
        assert!(!picture.contains(control) && !picture.contains('\u{ffff}'));
    }

    #[test]
    fn errors_of_rounding_do_not_add_up() {
        let points = (0..1000).map(|i| Dot::new(0.004 * f64::from(i), 0.0));
        let mut text = String::new();
        data(&mut text, &Path::through(points));
        let steps = text.split('l').skip(1);
        let sum: f64 = steps
            .map(|s| s.split(' ').next().unwrap().parse::<f64>().unwrap())
            .sum();
        assert!((sum - 0.004 * 999.0).abs() < 0.011, "{sum}");
    }
}
