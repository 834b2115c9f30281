//! Region diagrams: what of the planes of three pairs each mode of three parts reaches.

use cspace::{Axis, FixedAxesSpace};

use crate::colour::{BLOCKED, INK, MARK, WHITE, bar};
use crate::legend::Sign;
use crate::options::PictureOptions;
use crate::page::Page;
use crate::plane::{axis, draw_all_curves, seen};
use crate::plot::{Plot, text};
use crate::scene::{Anchor, Area, Colour, Dot, Item, Path, Scene, Stroke};
use crate::strips::strips;
use crate::view::View;

/// The plane of two of three coordinates.
#[derive(Debug, Clone, Copy)]
pub struct ModePlane<'a> {
    /// Names of the coordinates.
    pub coordinates: [&'a str; 2],
    /// The parts whose coordinates they are.
    pub parts: [&'a str; 2],
    /// Axes of these parts.
    pub axes: [Axis; 2],
    /// Minimum and maximum of both.
    pub extents: [(f64, f64); 2],
    /// Configuration space of the two parts; `None` for a pair that constrains nothing.
    pub space: Option<&'a FixedAxesSpace>,
}

impl ModePlane<'_> {
    /// Ranges of both coordinates in view.
    pub fn window(&self) -> [(f64, f64); 2] {
        [0, 1].map(|k| seen(self.axes[k], self.extents[k]))
    }
}

/// Configurations of a plane that a mode reaches: fields of a grid over its window, those of the smallest first
/// coordinate first.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeFields {
    /// Fields along the first and along the second coordinate.
    pub fields: [usize; 2],
    /// Flags of the fields that are reached.
    pub reached: Vec<bool>,
}

/// A mode in a picture.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeRow {
    /// Caption of the mode.
    pub name: String,
    /// Fields that it reaches in each plane.
    pub planes: [ModeFields; 3],
    /// A configuration in each plane that is marked.
    pub mark: Option<[(f64, f64); 3]>,
}

/// The modes of three parts.
#[derive(Debug, Clone)]
pub struct ModesPicture<'a> {
    /// The planes of the pairs.
    pub planes: [ModePlane<'a>; 3],
    /// The modes, each in a row of its own.
    pub modes: Vec<ModeRow>,
}

/// A region diagram: for each mode a row with the planes of the three pairs, free space white, blocked space grey, what the mode
/// reaches in its colour.
pub fn modes(picture: &ModesPicture<'_>, options: &PictureOptions) -> Scene {
    /// Default width, and height of a row, in dots.
    const USUAL: (f64, f64) = (1100.0, 350.0);
    let rows = picture.modes.len().max(1);
    let usual = (USUAL.0, USUAL.1 * rows as f64 + 80.0);
    let mut said = vec![
        (Sign::Field(WHITE, INK), "free in the pair".to_owned()),
        (Sign::Field(BLOCKED, INK), "blocked".to_owned()),
    ];
    for (k, mode) in picture.modes.iter().enumerate() {
        said.push((Sign::Field(bar(k).0, INK), mode.name.clone()));
    }
    if picture.modes.iter().any(|m| m.mark.is_some()) {
        said.push((Sign::Mark(MARK), "the requested configuration".to_owned()));
    }
    let mut page = Page::of(options, usual, said);
    let em = page.em;
    let top = 2.4 * em;
    let size = (page.width / 3.0, (page.foot - top) / rows as f64);
    let empty = ModeRow {
        name: "no mode".to_owned(),
        planes: [0; 3].map(|_| ModeFields {
            fields: [0, 0],
            reached: Vec::new(),
        }),
        mark: None,
    };
    let shown = if picture.modes.is_empty() {
        core::slice::from_ref(&empty)
    } else {
        &picture.modes[..]
    };
    for (row, mode) in shown.iter().enumerate() {
        let upper = top + size.1 * row as f64;
        for (column, plane) in picture.planes.iter().enumerate() {
            let left = size.0 * column as f64;
            let area = Area {
                lo: Dot::new(left + Plot::LEFT * em, upper + 1.6 * em),
                hi: Dot::new(
                    left + size.0 - Plot::RIGHT * em,
                    upper + size.1 - Plot::BELOW * em,
                ),
            };
            let [x, y] = plane.window();
            let plot = Plot { area, x, y, em };
            let mark = mode.mark.map(|m| m[column]);
            draw(
                &mut page.items,
                plane,
                plot,
                (&mode.planes[column], bar(row).0),
                mark,
            );
            let labels =
                [0, 1].map(|k| axis(plane.coordinates[k], plane.parts[k], plane.axes[k], options));
            plot.frame(&mut page.items, &labels);
        }
        let at = Dot::new(Plot::LEFT * em, upper + 1.1 * em);
        page.items
            .push(text(mode.name.clone(), at, em, Anchor::Start, INK));
    }
    page.finished()
}

fn draw(
    items: &mut Vec<Item>,
    plane: &ModePlane<'_>,
    plot: Plot,
    (fields, colour): (&ModeFields, Colour),
    mark: Option<(f64, f64)>,
) {
    let mut inner = Vec::new();
    match plane.space {
        None => inner.push(Item::filled(Path::rectangle(plot.area), WHITE)),
        Some(space) => {
            inner.push(Item::filled(Path::rectangle(plot.area), BLOCKED));
            let view = View::of(space, plot);
            for strip in strips(space, &view) {
                inner.push(Item::Shape {
                    path: strip.outline(),
                    fill: Some(WHITE),
                    stroke: Some(Stroke {
                        colour: WHITE,
                        width: 0.04 * plot.em,
                    }),
                    title: None,
                });
            }
        }
    }
    inner.push(Item::filled(rectangles(fields, &plot), colour));
    if let Some(space) = plane.space {
        draw_all_curves(&mut inner, space, &plot);
    }
    if let Some((x, y)) = mark {
        inner.push(Item::Shape {
            path: Path::circle(plot.place(x, y), 0.4 * plot.em),
            fill: Some(MARK),
            stroke: Some(Stroke {
                colour: WHITE,
                width: 0.12 * plot.em,
            }),
            title: Some("the requested configuration".to_owned()),
        });
    }
    items.push(Item::Clipped {
        area: plot.area,
        items: inner,
    });
}

/// The fields that are reached as rectangles, which do not overlap: runs along the second coordinate, as many fields wide as they
/// stay the same.
fn rectangles(fields: &ModeFields, plot: &Plot) -> Path {
    let [n, m] = fields.fields;
    let runs = |i: usize| -> Vec<(usize, usize)> {
        let column = &fields.reached[i * m..(i + 1) * m];
        let mut runs: Vec<(usize, usize)> = Vec::new();
        for j in (0..m).filter(|&j| column[j]) {
            match runs.last_mut() {
                Some(last) if last.1 == j => last.1 = j + 1,
                _ => runs.push((j, j + 1)),
            }
        }
        runs
    };
    let mut path = Path::new();
    let mut open: Vec<(usize, (usize, usize))> = Vec::new();
    for i in 0..=n {
        let here = if i < n { runs(i) } else { Vec::new() };
        open.retain(|&(from, run)| {
            let goes_on = here.contains(&run);
            if !goes_on {
                let x = |k: usize| plot.x.0 + (plot.x.1 - plot.x.0) * k as f64 / n as f64;
                let y = |k: usize| plot.y.0 + (plot.y.1 - plot.y.0) * k as f64 / m as f64;
                let (a, b) = (plot.place(x(from), y(run.0)), plot.place(x(i), y(run.1)));
                path.line_through([a, Dot::new(b.x, a.y), b, Dot::new(a.x, b.y), a]);
            }
            goes_on
        });
        for run in here {
            if open.iter().all(|o| o.1 != run) {
                open.push((i, run));
            }
        }
    }
    path
}
