//! The plane of motions of a pair with fixed axes: which (u, v) are free.

use core::f64::consts::PI;

use cspace::fixed_axes::BranchForm;
use cspace::{Axis, AxisMotion, FixedAxesSpace, Location, PatchId, RegionId};

use crate::colour::{BLOCKED, INK, KINDS, MARK, WHITE, kind, region as ground};
use crate::labels::Placed;
use crate::legend::Sign;
use crate::line::{follow, simplified};
use crate::options::{Labels, PictureOptions};
use crate::page::Page;
use crate::plot::{AxisLabel, Plot};
use crate::scene::{Dot, Item, Path, Scene, Stroke};
use crate::slice::{of_kinds, of_names, short};
use crate::strips::{Strip, strips};
use crate::ticks::Quantity;
use crate::view::{View, turns_for_ever};

/// Draws the plane (u, v): free regions numbered and coloured in the order of the list, blocked space grey, contact
/// curves by kind. A full turn is shown from −180° to 180°, and curves in every visible period. Channels that are too
/// thin to be visible are drawn with a visible width.
pub fn plane(space: &FixedAxesSpace, options: &PictureOptions) -> Scene {
    /// In dots, if the user does not say.
    const USUAL: (f64, f64) = (920.0, 920.0);
    let mut page = Page::of(options, USUAL, entries(space, options));
    let [x, y] = window(space, options);
    let plot = Plot {
        area: page.area(),
        x,
        y,
        em: page.em,
    };
    draw(&mut page.items, space, plot, options.labels, &[]);
    plot.frame(&mut page.items, &axes(space, options));
    page.finished()
}

/// The plane with its free regions and contact curves, and a path in it, in the rectangle of a plot.
pub(crate) fn draw(
    items: &mut Vec<Item>,
    space: &FixedAxesSpace,
    plot: Plot,
    labels: Labels,
    path: &[(f64, f64)],
) {
    let Plot { area, em, .. } = plot;
    let view = View::of(space, plot);
    let mut inner = vec![Item::filled(Path::rectangle(area), BLOCKED)];
    let strips = strips(space, &view);
    for strip in &strips {
        inner.push(Item::Shape {
            path: strip.outline(),
            fill: Some(ground(strip.region)),
            // Neighbours share a side, which must not be seen.
            stroke: Some(Stroke {
                colour: ground(strip.region),
                width: 0.04 * em,
            }),
            title: None,
        });
    }
    let curves = curves(space, &view);
    draw_curves(&mut inner, space, &curves, em);
    channels(&mut inner, space, &view, &strips, em);
    if labels != Labels::None {
        let mut placed = Placed::new(area, labels == Labels::All);
        if space.regions().len() > 1 {
            number_regions(&mut inner, &strips, &mut placed, em);
        }
        name_curves(&mut inner, space, &curves, &mut placed, em);
    }
    along(&mut inner, &view, path);
    items.push(Item::Clipped { area, items: inner });
}

/// A path in every period that is seen, from a ring to a dot.
fn along(items: &mut Vec<Item>, view: &View, path: &[(f64, f64)]) {
    let em = view.plot.em;
    let range = |a: f64, b: f64| (a.min(b), a.max(b));
    // Lines by the periods by which they are moved: what goes on in the same is one line.
    let mut lines: Vec<((f64, f64), Vec<Dot>)> = Vec::new();
    let mut open: Vec<((f64, f64), Vec<Dot>)> = Vec::new();
    for leg in path.windows(2) {
        let (a, b) = (leg[0], leg[1]);
        let copies = view.copies(range(a.0, b.0), range(a.1, b.1));
        let ended = |o: &((f64, f64), Vec<Dot>)| !copies.contains(&o.0);
        lines.extend(open.extract_if(.., |o| ended(o)));
        for shift in copies {
            let at = |p: (f64, f64)| view.place((p.0 + shift.0, p.1 + shift.1));
            match open.iter_mut().find(|o| o.0 == shift) {
                Some((_, line)) => line.push(at(b)),
                None => open.push((shift, vec![at(a), at(b)])),
            }
        }
    }
    lines.extend(open);
    let mut drawn = Path::new();
    for (_, line) in &lines {
        drawn.line_through(simplified(line));
    }
    items.push(Item::drawn(drawn.clone(), WHITE, 0.5 * em));
    items.push(Item::drawn(drawn, MARK, 0.22 * em));
    let ends = [(path.first(), true), (path.last(), false)];
    for (end, is_start) in ends.into_iter().filter_map(|(p, s)| Some((*p?, s))) {
        for (du, dv) in view.copies((end.0, end.0), (end.1, end.1)) {
            let at = view.place((end.0 + du, end.1 + dv));
            items.push(Item::Shape {
                path: Path::circle(at, 0.42 * em),
                fill: Some(if is_start { WHITE } else { MARK }),
                stroke: Some(Stroke {
                    colour: MARK,
                    width: 0.18 * em,
                }),
                title: Some(if is_start { "start" } else { "end" }.to_owned()),
            });
        }
    }
}

/// Ranges of both coordinates in view.
pub(crate) fn window(space: &FixedAxesSpace, options: &PictureOptions) -> [(f64, f64); 2] {
    let (fixed, moving) = space.axes();
    let [u, v] = space.extent();
    [
        options.x.unwrap_or(seen(fixed, u)),
        options.y.unwrap_or(seen(moving, v)),
    ]
}

/// Labels of both coordinates.
pub(crate) fn axes(space: &FixedAxesSpace, options: &PictureOptions) -> [AxisLabel; 2] {
    let (fixed, moving) = space.axes();
    [
        axis("u", space.fixed().name(), fixed, options),
        axis("v", space.moving().name(), moving, options),
    ]
}

/// Range of a coordinate in view: for a full turn from −180° to 180°.
pub(crate) fn seen(axis: Axis, extent: (f64, f64)) -> (f64, f64) {
    if turns_for_ever(axis) {
        return (-PI, PI);
    }
    if axis.motion == AxisMotion::Fixed {
        return extent;
    }
    let margin = 0.02 * (extent.1 - extent.0);
    (extent.0 - margin, extent.1 + margin)
}

pub(crate) fn axis(name: &str, part: &str, axis: Axis, options: &PictureOptions) -> AxisLabel {
    let unit = options.unit.as_deref();
    match axis.motion {
        AxisMotion::Revolute { .. } => AxisLabel {
            text: format!("{name}: {part} turns, degrees"),
            quantity: Quantity::Angle,
        },
        AxisMotion::Prismatic { .. } => AxisLabel::length(&format!("{name}: {part} slides"), unit),
        AxisMotion::Fixed => AxisLabel::length(&format!("{name}: {part} does not move"), unit),
    }
}

/// A contact curve that is seen.
struct Curve {
    patch: PatchId,
    line: Vec<Dot>,
}

/// Draws all contact curves of a space, without names.
pub(crate) fn draw_all_curves(items: &mut Vec<Item>, space: &FixedAxesSpace, plot: &Plot) {
    let curves = curves(space, &View::of(space, *plot));
    draw_curves(items, space, &curves, plot.em);
}

/// Contact curves, in every visible period.
fn curves(space: &FixedAxesSpace, view: &View) -> Vec<Curve> {
    let (u_axis, v_axis) = space.axes();
    let still = [u_axis, v_axis].map(|a| a.motion == AxisMotion::Fixed);
    let mut all = Vec::new();
    for (patch, p) in (0..).map(PatchId).zip(space.patches()) {
        for i in p.branches.start as usize..p.branches.end as usize {
            let b = &space.branches()[i];
            let (from, to) = match b.form {
                BranchForm::VOfU => (b.start.0, b.end.0),
                BranchForm::UOfV => (b.start.1, b.end.1),
            };
            let range = |a: f64, b: f64| (a.min(b), a.max(b));
            let (u, v) = (range(b.start.0, b.end.0), range(b.start.1, b.end.1));
            // A fixed part has coordinate 0, with a visible strip around it.
            let u = if still[0] { view.plot.x } else { u };
            let v = if still[1] { view.plot.y } else { v };
            for (du, dv) in view.copies(u, v) {
                if still[0] || still[1] {
                    let (a, b) = (b.start, b.end);
                    let ends = match still {
                        [true, _] => [(view.plot.x.0, a.1 + dv), (view.plot.x.1, b.1 + dv)],
                        _ => [(a.0 + du, view.plot.y.0), (b.0 + du, view.plot.y.1)],
                    };
                    let line = ends.map(|e| view.place(e)).to_vec();
                    all.push(Curve { patch, line });
                    continue;
                }
                let at = |share: f64| {
                    let t = from + (to - from) * share;
                    let ((u, v), _) = space.branch_at(i, t)?;
                    Some(view.place((u + du, v + dv)))
                };
                for line in follow(at, view.plot.area) {
                    all.push(Curve { patch, line });
                }
            }
        }
    }
    all
}

/// Draws curves by kind, each with its features as a tooltip, unless there are too many.
fn draw_curves(items: &mut Vec<Item>, space: &FixedAxesSpace, curves: &[Curve], em: f64) {
    /// Number of curves from which on they are drawn together, so that the file stays small.
    const MOST_NAMED: usize = 300;
    let width = 0.11 * em;
    let of = |c: &Curve| {
        let p = &space.patches()[c.patch.index()];
        kind(p.fixed, p.moving)
    };
    for (k, (colour, _)) in KINDS.iter().enumerate() {
        let of_kind = curves.iter().filter(|c| of(c) == k);
        if curves.len() > MOST_NAMED {
            let mut path = Path::new();
            for c in of_kind {
                path.line_through(c.line.iter().copied());
            }
            items.push(Item::drawn(path, *colour, width));
            continue;
        }
        for c in of_kind {
            let p = &space.patches()[c.patch.index()];
            items.push(Item::Shape {
                path: Path::through(c.line.iter().copied()),
                fill: None,
                stroke: Some(Stroke {
                    colour: *colour,
                    width,
                }),
                title: Some(format!(
                    "{} of {}, {} of {}",
                    space.fixed().feature_text(p.fixed),
                    space.fixed().name(),
                    space.moving().feature_text(p.moving),
                    space.moving().name()
                )),
            });
        }
    }
}

/// Channels thinner than can be seen between their curves: a line of free space with an edge.
fn channels(items: &mut Vec<Item>, space: &FixedAxesSpace, view: &View, strips: &[Strip], em: f64) {
    let thin = (0.3 * em).max(3.0);
    let is_free = |at: Dot, region: RegionId| {
        let (u, v) = view.motions(at);
        space.locate(u, v) == Location::Free(region)
    };
    let mut path = Path::new();
    let mut by_region: Vec<(RegionId, Path)> = Vec::new();
    for strip in strips {
        let across = strip.thin_across(thin, |at| is_free(at, strip.region));
        for line in strip.thin(thin).into_iter().chain(across) {
            path.line_through(line.iter().copied());
            match by_region.iter_mut().find(|r| r.0 == strip.region) {
                Some((_, of_region)) => of_region.line_through(line),
                None => by_region.push((strip.region, Path::through(line))),
            }
        }
    }
    if path.steps.is_empty() {
        return;
    }
    /// Line width in dots that covers a whole dot, whatever its position between them.
    const COVERS: f64 = 1.8;
    let width = (0.14 * em).max(COVERS);
    items.push(Item::drawn(
        path,
        KINDS[2].0,
        width + (0.2 * em).max(COVERS),
    ));
    for (region, path) in by_region {
        items.push(Item::drawn(path, ground(region), width));
    }
}

/// The number of each region where it is widest, if it fits.
fn number_regions(items: &mut Vec<Item>, strips: &[Strip], placed: &mut Placed, em: f64) {
    let mut best: Vec<(RegionId, f64, Dot)> = Vec::new();
    for strip in strips {
        let Some((room, at)) = strip.widest() else {
            continue;
        };
        match best.iter_mut().find(|b| b.0 == strip.region) {
            Some(b) if b.1 >= room => {}
            Some(b) => *b = (strip.region, room, at),
            None => best.push((strip.region, room, at)),
        }
    }
    for (region, room, at) in best {
        if room > 1.3 * em || !placed.is_sparing() {
            placed.put(items, &region.to_string(), 1.1 * em, [at]);
        }
    }
}

/// Writes the names of the features that touch beside contact curves that are long enough.
fn name_curves(
    items: &mut Vec<Item>,
    space: &FixedAxesSpace,
    curves: &[Curve],
    placed: &mut Placed,
    em: f64,
) {
    let size = 0.72 * em;
    for c in curves {
        let p = &space.patches()[c.patch.index()];
        let said = format!(
            "{} | {}",
            short(space.fixed(), p.fixed),
            short(space.moving(), p.moving)
        );
        let long: f64 = c.line.windows(2).map(|w| w[0].distance(w[1])).sum();
        let wide = crate::font::width(&said, size);
        if long < 1.5 * wide && placed.is_sparing() {
            continue;
        }
        let middle = c.line[c.line.len() / 2];
        let places = [0.0, -1.0, 1.0].map(|k| middle.moved(0.0, 1.1 * k * size));
        placed.put(items, &said, size, places);
    }
}

fn entries(space: &FixedAxesSpace, options: &PictureOptions) -> Vec<(Sign, String)> {
    /// Number of regions from which on only their numbers are given.
    const MOST: usize = 8;
    let mut all = Vec::new();
    for (region, _) in (0..).map(RegionId).zip(space.regions()).take(MOST) {
        all.push((
            Sign::Field(ground(region), INK),
            format!("free, region {region}"),
        ));
    }
    all.push((Sign::Field(BLOCKED, INK), "blocked".to_owned()));
    all.extend(of_kinds(|k| {
        (space.patches().iter()).any(|p| kind(p.fixed, p.moving) == k)
    }));
    if options.labels != Labels::None && !space.patches().is_empty() {
        all.push(of_names());
    }
    all
}
