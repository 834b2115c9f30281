//! A scene as PNG.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, Rect, Stroke, Transform,
};

use crate::arc::cubics;
use crate::colour::WHITE;
use crate::error::PictureError;
use crate::font::{self, Placed, halo};
use crate::scene::{Area, Colour, Dot, Item, Path, Scene, Step, Text};

/// The most dots of a picture with dots: 16 of those of a good screen.
const MOST_DOTS: f64 = 1.4e8;

/// Writes a picture as PNG, one pixel per dot of the scene.
///
/// # Errors
/// If it has no dots or more than 1.4·10⁸.
pub fn png(scene: &Scene) -> Result<Vec<u8>, PictureError> {
    let (width, height) = (scene.width.round(), scene.height.round());
    let sized = width >= 1.0 && height >= 1.0 && width * height <= MOST_DOTS;
    let too_large = || PictureError::Size {
        width: scene.width,
        height: scene.height,
    };
    let mut map = (sized
        .then(|| Pixmap::new(width as u32, height as u32))
        .flatten())
    .ok_or_else(too_large)?;
    map.fill(tiny_skia::Color::WHITE);
    draw(&mut map, &scene.items, None);
    map.encode_png()
        .map_err(|e| PictureError::Png(e.to_string()))
}

fn draw(map: &mut Pixmap, items: &[Item], clip: Option<&Mask>) {
    for item in items {
        match item {
            Item::Shape {
                path, fill, stroke, ..
            } => {
                let Some(path) = outline(path) else {
                    continue;
                };
                let whole = Transform::identity();
                if let Some(fill) = fill {
                    map.fill_path(&path, &paint(*fill), FillRule::EvenOdd, whole, clip);
                }
                if let Some(stroke) = stroke {
                    let line = line(stroke.width);
                    map.stroke_path(&path, &paint(stroke.colour), &line, whole, clip);
                }
            }
            Item::Text(text) => write(map, text, clip),
            Item::Clipped { area, items } => {
                let mask = mask(map, area);
                draw(map, items, mask.as_ref());
            }
        }
    }
}

fn line(width: f64) -> Stroke {
    Stroke {
        width: width as f32,
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        ..Stroke::default()
    }
}

fn paint(Colour(r, g, b): Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(r, g, b, 255);
    paint.anti_alias = true;
    paint
}

fn mask(map: &Pixmap, area: &Area) -> Option<Mask> {
    let mut mask = Mask::new(map.width(), map.height())?;
    let Area { lo, hi } = area;
    let inside = Rect::from_ltrb(lo.x as f32, lo.y as f32, hi.x as f32, hi.y as f32)?;
    let inside = PathBuilder::from_rect(inside);
    mask.fill_path(&inside, FillRule::Winding, true, Transform::identity());
    Some(mask)
}

fn outline(path: &Path) -> Option<tiny_skia::Path> {
    let mut out = PathBuilder::new();
    let mut at = Dot::new(0.0, 0.0);
    let mut began = at;
    for step in &path.steps {
        match *step {
            Step::Move(to) => {
                out.move_to(to.x as f32, to.y as f32);
                (at, began) = (to, to);
            }
            Step::Line(to) => {
                out.line_to(to.x as f32, to.y as f32);
                at = to;
            }
            Step::Arc { to, bulge } => {
                for [p, q, r] in cubics(at, to, bulge) {
                    let [p, q, r] = [p, q, r].map(|d| (d.x as f32, d.y as f32));
                    out.cubic_to(p.0, p.1, q.0, q.1, r.0, r.1);
                }
                at = to;
            }
            Step::Close => {
                out.close();
                at = began;
            }
        }
    }
    out.finish()
}

fn write(map: &mut Pixmap, text: &Text, clip: Option<&Mask>) {
    let mut letters = PathBuilder::new();
    let place = Placed::of(text);
    let at = |x: f64, y: f64| {
        let p = place.at(x, y);
        (p.x as f32, p.y as f32)
    };
    for stroke in font::outlines(&text.text, text.size) {
        match stroke {
            font::Stroke::Move(x, y) => {
                let (x, y) = at(x, y);
                letters.move_to(x, y);
            }
            font::Stroke::Line(x, y) => {
                let (x, y) = at(x, y);
                letters.line_to(x, y);
            }
            font::Stroke::Quad(a, b, x, y) => {
                let ((a, b), (x, y)) = (at(a, b), at(x, y));
                letters.quad_to(a, b, x, y);
            }
            font::Stroke::Cubic(a, b, c, d, x, y) => {
                let ((a, b), (c, d), (x, y)) = (at(a, b), at(c, d), at(x, y));
                letters.cubic_to(a, b, c, d, x, y);
            }
            font::Stroke::Close => letters.close(),
        }
    }
    let Some(letters) = letters.finish() else {
        return;
    };
    let whole = Transform::identity();
    if text.halo {
        let edge = line(halo(text.size));
        map.stroke_path(&letters, &paint(WHITE), &edge, whole, clip);
    }
    map.fill_path(
        &letters,
        &paint(text.colour),
        FillRule::Winding,
        whole,
        clip,
    );
}
