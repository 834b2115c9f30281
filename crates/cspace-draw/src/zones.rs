//! Contact zones: what is free and what is blocked within tolerances, and the bands between.

use cspace::{ContactSpace, FixedAxesSpace, Point, Slice};

use crate::colour::{BLOCKED, GRID, INK, MARK, WHITE, bar};
use crate::legend::Sign;
use crate::options::PictureOptions;
use crate::outline::{extent, with_margin};
use crate::page::Page;
use crate::plane::{axes, draw_all_curves, window};
use crate::plot::{AxisLabel, Plot};
use crate::scene::{Colour, Dot, Item, Path, Scene, Stroke};
use crate::slice::{draw_curves, reached};

/// The pair as it is drawn.
#[derive(Debug, Clone, Copy)]
pub enum Nominal<'a> {
    /// Plane of motions.
    Plane(&'a FixedAxesSpace),
    /// A slice of its space.
    Slice(&'a ContactSpace, &'a Slice),
}

/// A rectangle: the ranges of both coordinates.
type Cell = [(f64, f64); 2];

/// Data of a picture of contact zones.
#[derive(Debug, Clone)]
pub struct ZonesPicture<'a> {
    /// Nominal pair, whose contact curves are shown.
    pub nominal: Nominal<'a>,
    /// Cells that are free within all tolerances.
    pub free: &'a [Cell],
    /// Cells that are blocked within all tolerances.
    pub blocked: &'a [Cell],
    /// Bands between: what may touch there, and where.
    pub bands: Vec<(String, &'a [Cell])>,
    /// A configuration that is marked.
    pub mark: Option<(f64, f64)>,
}

impl Nominal<'_> {
    /// Ranges of both coordinates in view.
    pub fn window(&self, options: &PictureOptions) -> Cell {
        match self {
            Self::Plane(space) => window(space, options),
            Self::Slice(space, slice) => {
                let points: Vec<Point> = reached(slice).collect();
                let size = space.fixed().size().max(space.moving().size());
                // A square.
                let [x, y] = extent(&points, 0.0);
                let side = (x.1 - x.0).max(y.1 - y.0);
                let square = |(lo, hi): (f64, f64)| {
                    let more = 0.5 * (side - (hi - lo));
                    with_margin((lo, hi), more + 0.08 * size)
                };
                [
                    options.x.unwrap_or(square(x)),
                    options.y.unwrap_or(square(y)),
                ]
            }
        }
    }

    fn labels(&self, options: &PictureOptions) -> [AxisLabel; 2] {
        match self {
            Self::Plane(space) => axes(space, options),
            Self::Slice(..) => AxisLabel::of_positions(options),
        }
    }
}

/// A picture of contact zones: free space white, blocked space grey, and bands between in colours by what may touch there.
pub fn zones(picture: &ZonesPicture<'_>, options: &PictureOptions) -> Scene {
    /// Default width and height in dots.
    const USUAL: (f64, f64) = (920.0, 940.0);
    /// Largest number of bands that are named.
    const MOST: usize = 10;
    let mut said = vec![
        (
            Sign::Field(WHITE, INK),
            "free within all tolerances".to_owned(),
        ),
        (Sign::Field(BLOCKED, INK), "blocked within all".to_owned()),
    ];
    let named = picture.bands.iter().enumerate().take(MOST);
    said.extend(named.map(|(i, (name, _))| (Sign::Field(bar(i).0, INK), name.clone())));
    if picture.bands.len() > MOST {
        let more = picture.bands.len() - MOST;
        said.push((Sign::Field(GRID, INK), format!("and {more} more")));
    }
    let mut page = Page::of(options, USUAL, said);
    let (area, em) = (page.area(), page.em);
    let [x, y] = picture.nominal.window(options);
    let plot = match picture.nominal {
        Nominal::Plane(_) => Plot { area, x, y, em },
        Nominal::Slice(..) => Plot::at_one_scale(area, x, y, em),
    };
    let mut inner = vec![Item::filled(Path::rectangle(area), GRID)];
    inner.push(cells(picture.free, WHITE, &plot, None));
    inner.push(cells(picture.blocked, BLOCKED, &plot, None));
    for (i, (name, of)) in picture.bands.iter().enumerate() {
        inner.push(cells(of, bar(i).0, &plot, Some(name)));
    }
    match picture.nominal {
        Nominal::Plane(space) => draw_all_curves(&mut inner, space, &plot),
        Nominal::Slice(_, slice) => draw_curves(&mut inner, slice, &plot),
    }
    if let Some((x, y)) = picture.mark {
        inner.push(Item::Shape {
            path: Path::circle(plot.place(x, y), 0.42 * em),
            fill: None,
            stroke: Some(Stroke {
                colour: MARK,
                width: 0.18 * em,
            }),
            title: Some("where it is measured".to_owned()),
        });
    }
    page.items.push(Item::Clipped { area, items: inner });
    plot.frame(&mut page.items, &picture.nominal.labels(options));
    page.finished()
}

/// Cells in one colour; their sides, which must not be seen between them, are drawn too.
fn cells(all: &[Cell], colour: Colour, plot: &Plot, title: Option<&str>) -> Item {
    let mut path = Path::new();
    for [x, y] in all {
        let (a, b) = (plot.place(x.0, y.0), plot.place(x.1, y.1));
        path.line_through([a, Dot::new(b.x, a.y), b, Dot::new(a.x, b.y), a]);
    }
    Item::Shape {
        path,
        fill: Some(colour),
        stroke: Some(Stroke {
            colour,
            width: 0.04 * plot.em,
        }),
        title: title.map(str::to_owned),
    }
}
