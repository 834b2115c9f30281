//! Required content of a motion's page.

use cspace_draw::{Anchor, Dot, Item, PictureOptions, Scene, Step, Text, motion, svg};

use crate::scenes::{axes_space, options, page};

fn texts(items: &[Item], found: &mut Vec<Text>) {
    for item in items {
        match item {
            Item::Text(t) => found.push(t.clone()),
            Item::Clipped { items, .. } => texts(items, found),
            Item::Shape { .. } => {}
        }
    }
}

fn all_texts(scene: &Scene) -> Vec<Text> {
    let mut found = Vec::new();
    texts(&scene.items, &mut found);
    found
}

/// Corners of the shape with a given tooltip.
fn shape(items: &[Item], said: &str) -> Option<Vec<Dot>> {
    items.iter().find_map(|item| match item {
        Item::Shape { path, title, .. } if title.as_deref() == Some(said) => {
            let corners = path.steps.iter().filter_map(|s| match s {
                Step::Move(d) | Step::Line(d) => Some(*d),
                _ => None,
            });
            Some(corners.collect())
        }
        Item::Clipped { items, .. } => shape(items, said),
        _ => None,
    })
}

/// A bar begins and ends below the times of its contact, simultaneous bars lie in lanes of their own, and short ones
/// are visible.
#[test]
fn bars_are_below_their_times() {
    let space = axes_space("geneva.toml");
    let scene = motion(&page(&space), &options("motion"));
    let times = all_texts(&scene);
    let tick = |number: &str| {
        let ticks = times
            .iter()
            .filter(|t| t.anchor == Anchor::Middle && t.text == number);
        ticks.map(|t| t.at.x).next().unwrap()
    };
    let at = |t: f64| tick("0.0") + t * (tick("1.0") - tick("0.0"));
    let corners = |k: usize| shape(&scene.items, &format!("contact {k}")).unwrap();
    for (k, (from, to)) in [(0.0, 0.4), (0.3, 0.7)].into_iter().enumerate() {
        let bar = corners(k);
        assert!((bar[0].x - at(from)).abs() < 0.01 && (bar[1].x - at(to)).abs() < 0.01);
    }
    let (first, second, short) = (corners(0), corners(1), corners(2));
    assert!(second[0].y >= first[2].y, "they lie on each other");
    assert!(
        (short[0].y - first[0].y).abs() < 0.01,
        "the first lane is free again"
    );
    assert!(short[1].x - short[0].x > 1.0);
    assert!((shape(&scene.items, "impact").unwrap()[0].x - at(0.3)).abs() < 0.01);
}

/// A page of any size contains all text, without letters over its edges.
#[test]
fn pages_of_any_size_hold_their_text() {
    let space = axes_space("geneva.toml");
    let picture = page(&space);
    for size in [
        None,
        Some((800.0, 1200.0)),
        Some((2400.0, 1000.0)),
        Some((600.0, 600.0)),
    ] {
        let options = PictureOptions {
            size,
            ..options("motion")
        };
        let scene = motion(&picture, &options);
        assert!(size.is_none_or(|s| s == (scene.width, scene.height)));
        let said = all_texts(&scene);
        for text in said.iter().filter(|_| size != Some((600.0, 600.0))) {
            let inside = (0.0..=scene.width).contains(&text.at.x)
                && (0.0..=scene.height).contains(&text.at.y);
            assert!(inside, "{size:?}: {text:?}");
        }
        let words: usize = said.iter().map(|t| t.text.matches("turns").count()).sum();
        // Nine times in the remark, twice at the axes of the plane.
        assert_eq!(words, 11, "{size:?}");
    }
}

/// An empty motion still gives a page.
#[test]
fn nothing_is_drawn_of_nothing() {
    let picture = cspace_draw::MotionPicture {
        until: 1.0,
        ..Default::default()
    };
    let drawn = svg(&motion(&picture, &PictureOptions::default()));
    assert!(drawn.contains(">time, s</text>") && !drawn.contains("NaN"));
}
