//! Required content of planes of motions, for any data.

use cspace::Classification;
use cspace_draw::{Area, Dot, Item, PictureOptions, Scene, Text, plane, png, svg};
use tiny_skia::Pixmap;

use crate::scenes::{axes_space, options};

const MODELS: [&str; 6] = [
    "gears_on_shafts.toml",
    "geneva.toml",
    "rack_pinion.toml",
    "cam_plate.toml",
    "escapement.toml",
    "cam_tappet.toml",
];

/// Labels within the plane: those with an outline.
fn labels(scene: &Scene) -> Vec<Text> {
    let inner = scene.items.iter().filter_map(|i| match i {
        Item::Clipped { items, .. } => Some(items),
        _ => None,
    });
    let texts = inner.flatten().filter_map(|i| match i {
        Item::Text(t) => Some(t.clone()),
        _ => None,
    });
    texts.collect()
}

#[test]
fn files_are_small_and_labels_apart() {
    for name in MODELS {
        let space = axes_space(name);
        let scene = plane(&space, &options(name));
        let bytes = svg(&scene).len();
        assert!(bytes < 200_000, "{name}: {bytes}");
        // Letters are at least a third as wide as high.
        let boxes: Vec<Area> = (labels(&scene).iter())
            .map(|t| {
                let wide = t.text.chars().count() as f64 * t.size / 3.0;
                Area::new(
                    t.at.x - 0.5 * wide,
                    t.at.y - 0.7 * t.size,
                    wide,
                    0.7 * t.size,
                )
            })
            .collect();
        for (i, a) in boxes.iter().enumerate() {
            assert!(
                !boxes[..i].iter().any(|b| a.meets(b)),
                "{name}: {i} lies on another"
            );
        }
    }
}

/// Free space has the colour of its region within a few dots, however thin the channel; space that is blocked by more
/// than the width of lines has not.
#[test]
fn free_space_is_seen_however_thin() {
    for name in MODELS {
        let space = axes_space(name);
        let still = [space.axes().0, space.axes().1].map(|a| a == cspace::Axis::FIXED);
        if still.contains(&true) {
            continue;
        }
        for side in [400.0, 900.0] {
            let full = PictureOptions {
                size: Some((side, side)),
                labels: cspace_draw::Labels::None,
                ..options(name)
            };
            let scene = plane(&space, &full);
            let area = scene
                .items
                .iter()
                .find_map(|i| match i {
                    Item::Clipped { area, .. } => Some(*area),
                    _ => None,
                })
                .unwrap();
            let map = Pixmap::decode_png(&png(&scene).unwrap()).unwrap();
            // The picture is linear in u and v; two configurations tell how.
            let seen = seen(&space);
            let place = |(u, v): (f64, f64)| {
                let share = |t: f64, (lo, hi): (f64, f64)| (t - lo) / (hi - lo);
                Dot::new(
                    area.lo.x + area.width() * share(u, seen[0]),
                    area.hi.y - area.height() * share(v, seen[1]),
                )
            };
            let is_ground = |x: i64, y: i64| {
                let p = map.pixel(x as u32, y as u32).unwrap();
                p.red().min(p.green()).min(p.blue()) > 170 && !(p.red() == 0xc9 && p.blue() == 0xd1)
            };
            let (mut asked, mut blocked) = (0, 0);
            for gap in space.free_gaps() {
                for share in [0.3, 0.7] {
                    let [a, b] = gap.ends(share);
                    let at = place((0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1)));
                    let inside = Area::new(
                        area.lo.x + 4.0,
                        area.lo.y + 4.0,
                        area.width() - 8.0,
                        area.height() - 8.0,
                    );
                    if !inside.holds(&Area { lo: at, hi: at }) {
                        continue;
                    }
                    asked += 1;
                    let (x, y) = (at.x as i64, at.y as i64);
                    let near = (-3..=3).any(|i| (-3..=3).any(|j| is_ground(x + i, y + j)));
                    assert!(near, "{name} {side}: {a:?} to {b:?} is not seen at {at:?}");
                }
            }
            assert!(asked > 0, "{name}");
            // Far inside of blocked space it is grey. Channels may be thinner than steps: places in them are listed.
            let cell = |d: Dot| ((d.x / 4.0).floor() as i64, (d.y / 4.0).floor() as i64);
            let mut free = std::collections::HashSet::new();
            for gap in space.free_gaps() {
                for k in 0..=64 {
                    let [a, b] = gap.ends(f64::from(k) / 64.0);
                    let middle = (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
                    // On a circle it may be seen a turn from where it is told.
                    let turns = [-1.0, 0.0, 1.0].map(|k| k * core::f64::consts::TAU);
                    for (u, v) in [a, b, middle] {
                        free.extend(turns.iter().flat_map(|du| {
                            turns.iter().map(move |dv| cell(place((u + du, v + dv))))
                        }));
                    }
                }
            }
            for i in 0..24 {
                for j in 0..24 {
                    let share =
                        |k: i32, (lo, hi): (f64, f64)| lo + (hi - lo) * (f64::from(k) + 0.5) / 24.0;
                    let (u, v) = (share(i, seen[0]), share(j, seen[1]));
                    let at = place((u, v));
                    let is_free = space.classify(u, v) != Some(Classification::Blocked);
                    let (x, y) = cell(at);
                    let mut around = (-1..=1).flat_map(|p| (-1..=1).map(move |q| (p, q)));
                    if is_free || around.any(|(p, q)| free.contains(&(x + p, y + q))) {
                        continue;
                    }
                    blocked += 1;
                    let is_seen = is_ground(at.x as i64, at.y as i64);
                    assert!(!is_seen, "{name} {side}: ({u}, {v}) looks free");
                }
            }
            assert!(blocked > 0 || side < 900.0, "{name}");
        }
    }
}

/// Default ranges of u and v in a picture: a turn from −180° to 180°, else the extent and a margin.
fn seen(space: &cspace::FixedAxesSpace) -> [(f64, f64); 2] {
    let (u, v) = space.axes();
    let whole = space.extent();
    let of = |axis: cspace::Axis, (lo, hi): (f64, f64)| {
        let turns = matches!(axis.motion, cspace::AxisMotion::Revolute { .. });
        if turns && axis.range.is_none() {
            (-core::f64::consts::PI, core::f64::consts::PI)
        } else {
            (lo - 0.02 * (hi - lo), hi + 0.02 * (hi - lo))
        }
    };
    [of(u, whole[0]), of(v, whole[1])]
}

/// A slide without limits goes on beyond the computed range: it is free there at any distance.
#[test]
fn slides_without_limits_go_on() {
    let wall = cspace::Part::rectangle("wall", (0.0, 0.0), 2.0, 2.0).unwrap();
    let slider = cspace::Part::rectangle("slider", (5.0, 0.0), 2.0, 2.0).unwrap();
    let slide = cspace::Axis::prismatic(cspace::Vector::new(1.0, 0.0));
    let space =
        cspace::FixedAxesSpace::compute(&wall, cspace::Axis::FIXED, &slider, slide).unwrap();
    for seen in [None, Some((-1e3, 2e3))] {
        let shown = PictureOptions {
            y: seen,
            ..options("slide")
        };
        let scene = plane(&space, &shown);
        let area = scene.items.iter().find_map(|i| match i {
            Item::Clipped { area, .. } => Some(*area),
            _ => None,
        });
        let area = area.unwrap();
        let map = Pixmap::decode_png(&png(&scene).unwrap()).unwrap();
        for (x, y) in [(0.01, 0.01), (0.99, 0.01), (0.01, 0.99), (0.99, 0.99)] {
            let at = area.lo.moved(x * area.width(), y * area.height());
            let p = map.pixel(at.x as u32, at.y as u32).unwrap();
            assert_ne!(
                (p.red(), p.green(), p.blue()),
                (0xc9, 0xcc, 0xd1),
                "{seen:?} {x} {y}"
            );
        }
    }
}
