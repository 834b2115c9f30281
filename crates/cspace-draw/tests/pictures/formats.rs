//! A picture looks the same in every format: PDF as its operators say, PNG, and SVG as another program draws it, which
//! `.ci/others` asks.

use cspace_draw::{Item, Scene, pdf, png, svg};
use tiny_skia::{FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, Stroke, Transform};

use crate::scenes::all;

/// Largest share of dots that may differ by more than an edge that is drawn slightly differently.
const DIFFERENT: f64 = 1e-3;

/// Copy without text, which programs lay out in their own ways.
fn without_text(scene: &Scene) -> Scene {
    fn shapes(items: &[Item]) -> Vec<Item> {
        (items.iter())
            .filter_map(|i| match i {
                Item::Text(_) => None,
                Item::Clipped { area, items } => Some(Item::Clipped {
                    area: *area,
                    items: shapes(items),
                }),
                shape => Some(shape.clone()),
            })
            .collect()
    }
    Scene {
        items: shapes(&scene.items),
        ..scene.clone()
    }
}

/// The share of dots that differ by more than a quarter of black and white.
fn different(a: &Pixmap, b: &Pixmap) -> f64 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    let far = |(p, q): (&[u8], &[u8])| p.iter().zip(q).any(|(x, y)| x.abs_diff(*y) > 64);
    let pairs = a.data().chunks(4).zip(b.data().chunks(4));
    let total = a.width() as usize * a.height() as usize;
    pairs.filter(|p| far(*p)).count() as f64 / total as f64
}

#[test]
fn svg_and_png_are_left_for_another_program_to_compare() {
    let folder = cspace_oracle::kept::folder("pictures").unwrap();
    for (name, scene) in all() {
        let scene = without_text(&scene);
        std::fs::write(folder.join(format!("{name}.svg")), svg(&scene)).unwrap();
        std::fs::write(folder.join(format!("{name}.png")), png(&scene).unwrap()).unwrap();
    }
}

#[test]
fn pdf_and_png_are_the_same() {
    for (name, scene) in all() {
        // With its text, which is outlines in both.
        let ours = Pixmap::decode_png(&png(&scene).unwrap()).unwrap();
        let theirs = drawn(&pdf(&scene), ours.width(), ours.height());
        let share = different(&ours, &theirs);
        assert!(share < DIFFERENT, "{name}: {share}");
    }
}

/// Draws the page of a PDF by the operators that pictures have; three quarters of a point to a dot.
fn drawn(file: &[u8], width: u32, height: u32) -> Pixmap {
    let find = |what: &[u8]| file.windows(what.len()).position(|w| w == what).unwrap();
    let (from, to) = (find(b"stream") + 7, find(b"endstream"));
    let text = miniz_oxide::inflate::decompress_to_vec_zlib(&file[from..to]).unwrap();
    let text = String::from_utf8(text).unwrap();
    let mut map = Pixmap::new(width, height).unwrap();
    map.fill(tiny_skia::Color::WHITE);
    let points = Transform::from_scale(1.0 / 0.75, -1.0 / 0.75);
    let mut whole = points.post_translate(0.0, height as f32);
    let mut numbers: Vec<f32> = Vec::new();
    let mut path = PathBuilder::new();
    let (mut ink, mut pen) = (Paint::default(), Paint::default());
    let mut line = Stroke {
        line_cap: LineCap::Round,
        line_join: LineJoin::Round,
        ..Stroke::default()
    };
    let mut clips: Vec<Option<Mask>> = vec![None];
    for word in text.split_ascii_whitespace() {
        if let Ok(x) = word.parse::<f32>() {
            numbers.push(x);
            continue;
        }
        let n = std::mem::take(&mut numbers);
        let colour = |n: &[f32]| {
            let mut paint = Paint::default();
            paint.set_color(tiny_skia::Color::from_rgba(n[0], n[1], n[2], 1.0).unwrap());
            paint
        };
        let clip = clips.last().unwrap().clone();
        let mut take = || std::mem::take(&mut path).finish();
        match word {
            "cm" => {
                whole = whole.pre_concat(Transform::from_row(n[0], n[1], n[2], n[3], n[4], n[5]));
            }
            "J" | "j" => {}
            "q" => clips.push(clip),
            "Q" => drop(clips.pop()),
            "w" => line.width = n[0],
            "rg" => ink = colour(&n),
            "RG" => pen = colour(&n),
            "m" => path.move_to(n[0], n[1]),
            "l" => path.line_to(n[0], n[1]),
            "c" => path.cubic_to(n[0], n[1], n[2], n[3], n[4], n[5]),
            "h" => path.close(),
            "re" => path.push_rect(tiny_skia::Rect::from_xywh(n[0], n[1], n[2], n[3]).unwrap()),
            "W" => {
                let mut mask = Mask::new(width, height).unwrap();
                if let Some(p) = path.clone().finish() {
                    mask.fill_path(&p, FillRule::Winding, true, whole);
                }
                *clips.last_mut().unwrap() = Some(mask);
            }
            "n" => drop(take()),
            "f*" | "f" | "S" | "B*" => {
                let rule = if word == "f" {
                    FillRule::Winding
                } else {
                    FillRule::EvenOdd
                };
                let Some(p) = take() else {
                    continue;
                };
                if word != "S" {
                    map.fill_path(&p, &ink, rule, whole, clip.as_ref());
                }
                if word == "S" || word == "B*" {
                    map.stroke_path(&p, &pen, &line, whole, clip.as_ref());
                }
            }
            other => panic!("operator {other}"),
        }
    }
    map
}
