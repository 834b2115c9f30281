//! A scene as PDF.

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Finish, Pdf, Rect, Ref, TextStr};

use crate::arc::cubics;
use crate::colour::WHITE;
use crate::font::{self, Placed, halo};
use crate::scene::{Colour, Dot, Item, Path, Scene, Step, Text};

/// A picture as PDF of one page, a dot being a 96th of an inch as in browsers. Letters are outlines, so that the page looks
/// the same everywhere.
pub fn pdf(scene: &Scene) -> Vec<u8> {
    /// Points of PDF in a dot.
    const POINTS: f64 = 0.75;
    let (catalog, tree, page, content, info) = (
        Ref::new(1),
        Ref::new(2),
        Ref::new(3),
        Ref::new(4),
        Ref::new(5),
    );
    let (width, height) = (POINTS * scene.width, POINTS * scene.height);
    let mut out = Pdf::new();
    out.catalog(catalog).pages(tree);
    out.pages(tree).kids([page]).count(1);
    out.document_info(info).title(TextStr(&scene.title));
    let mut sheet = out.page(page);
    sheet.parent(tree).contents(content);
    sheet.media_box(Rect::new(0.0, 0.0, width as f32, height as f32));
    sheet.resources().finish();
    sheet.finish();
    let mut drawn = Content::new();
    // y of a page goes up, that of a scene down.
    let down = POINTS as f32;
    drawn.transform([down, 0.0, 0.0, -down, 0.0, height as f32]);
    drawn.set_line_cap(LineCapStyle::RoundCap);
    drawn.set_line_join(LineJoinStyle::RoundJoin);
    draw(&mut drawn, &scene.items);
    let drawn = miniz_oxide::deflate::compress_to_vec_zlib(&drawn.finish(), 6);
    out.stream(content, &drawn).filter(Filter::FlateDecode);
    out.finish()
}

fn draw(out: &mut Content, items: &[Item]) {
    for item in items {
        match item {
            Item::Shape {
                path, fill, stroke, ..
            } => {
                if path.steps.is_empty() {
                    continue;
                }
                if let Some(fill) = fill {
                    ink(out, *fill);
                }
                if let Some(stroke) = stroke {
                    pen(out, stroke.colour, stroke.width);
                }
                outline(out, path);
                match (fill, stroke) {
                    (Some(_), Some(_)) => out.fill_even_odd_and_stroke(),
                    (Some(_), None) => out.fill_even_odd(),
                    (None, Some(_)) => out.stroke(),
                    (None, None) => out.end_path(),
                };
            }
            Item::Text(text) => write(out, text),
            Item::Clipped { area, items } => {
                out.save_state();
                out.rect(
                    area.lo.x as f32,
                    area.lo.y as f32,
                    area.width() as f32,
                    area.height() as f32,
                );
                out.clip_nonzero().end_path();
                draw(out, items);
                out.restore_state();
            }
        }
    }
}

fn ink(out: &mut Content, Colour(r, g, b): Colour) {
    let [r, g, b] = [r, g, b].map(|c| f32::from(c) / 255.0);
    out.set_fill_rgb(r, g, b);
}

fn pen(out: &mut Content, Colour(r, g, b): Colour, width: f64) {
    let [r, g, b] = [r, g, b].map(|c| f32::from(c) / 255.0);
    out.set_stroke_rgb(r, g, b);
    out.set_line_width(width as f32);
}

/// Rounds to a thousandth of a dot, so that files stay small.
fn short(x: f64) -> f32 {
    ((x * 1000.0).round() / 1000.0) as f32
}

fn outline(out: &mut Content, path: &Path) {
    let mut at = Dot::new(0.0, 0.0);
    let mut began = at;
    for step in &path.steps {
        match *step {
            Step::Move(to) => {
                out.move_to(short(to.x), short(to.y));
                (at, began) = (to, to);
            }
            Step::Line(to) => {
                out.line_to(short(to.x), short(to.y));
                at = to;
            }
            Step::Arc { to, bulge } => {
                for [p, q, r] in cubics(at, to, bulge) {
                    cubic(out, p, q, r);
                }
                at = to;
            }
            Step::Close => {
                out.close_path();
                at = began;
            }
        }
    }
}

fn cubic(out: &mut Content, p: Dot, q: Dot, r: Dot) {
    out.cubic_to(
        short(p.x),
        short(p.y),
        short(q.x),
        short(q.y),
        short(r.x),
        short(r.y),
    );
}

fn write(out: &mut Content, text: &Text) {
    if text.halo {
        pen(out, WHITE, halo(text.size));
        letters(out, text);
        out.stroke();
    }
    ink(out, text.colour);
    letters(out, text);
    out.fill_nonzero();
}

fn letters(out: &mut Content, text: &Text) {
    let place = Placed::of(text);
    let mut at = Dot::new(0.0, 0.0);
    for stroke in font::outlines(&text.text, text.size) {
        match stroke {
            font::Stroke::Move(x, y) => {
                at = place.at(x, y);
                out.move_to(short(at.x), short(at.y));
            }
            font::Stroke::Line(x, y) => {
                at = place.at(x, y);
                out.line_to(short(at.x), short(at.y));
            }
            font::Stroke::Quad(a, b, x, y) => {
                // The cubic curve that is the same as one with one control point.
                let (c, end) = (place.at(a, b), place.at(x, y));
                let third = |p: Dot| Dot::new((p.x + 2.0 * c.x) / 3.0, (p.y + 2.0 * c.y) / 3.0);
                cubic(out, third(at), third(end), end);
                at = end;
            }
            font::Stroke::Cubic(a, b, c, d, x, y) => {
                let end = place.at(x, y);
                cubic(out, place.at(a, b), place.at(c, d), end);
                at = end;
            }
            font::Stroke::Close => {
                out.close_path();
            }
        }
    }
}
