//! Slices: positions of the moving part at one orientation, free and blocked.

use cspace::{
    ContactSpace, CurveGeometry, FeatureKind, FeatureName, Part, Point, RegionId, Slice, SliceCurve,
};

use crate::colour::{BLOCKED, INK, KINDS, WHITE, kind, region as ground};
use crate::labels::Placed;
use crate::legend::Sign;
use crate::options::{Labels, PictureOptions};
use crate::outline::{append, extent, place, with_margin};
use crate::page::Page;
use crate::parts::{PartsPicture, draw as draw_parts, entries as part_entries, seen};
use crate::plot::{AxisLabel, Plot, text};
use crate::scene::{Anchor, Area, Dot, Item, Path, Scene, Step};
use crate::ticks::brief;

/// Data of a picture of slices.
#[derive(Debug, Clone)]
pub struct SlicesPicture<'a> {
    /// The space they are of, which numbers their regions.
    pub space: &'a ContactSpace,
    /// The slices; more than one are shown in a grid, to one scale.
    pub slices: &'a [Slice],
    /// Beside a single slice, the parts to scale, at a position that is marked in the slice.
    pub parts: Option<(PartsPicture<'a>, Point)>,
}

/// A picture of slices: free regions numbered and coloured as they are listed, blocked space grey, contact curves by kind.
pub fn slices(picture: &SlicesPicture<'_>, options: &PictureOptions) -> Scene {
    match (picture.slices, &picture.parts) {
        ([slice], Some((parts, at))) => beside(picture, slice, parts, *at, options),
        _ => grid(picture, options),
    }
}

/// Draws one slice, and the parts beside it.
fn beside(
    picture: &SlicesPicture<'_>,
    slice: &Slice,
    parts: &PartsPicture<'_>,
    at: Point,
    options: &PictureOptions,
) -> Scene {
    /// In dots, if the user does not say.
    const USUAL: (f64, f64) = (1240.0, 760.0);
    let mut said = entries(picture, options);
    said.extend(part_entries(parts, options));
    let mut page = Page::of(options, USUAL, said);
    let Page {
        width, foot, em, ..
    } = page;
    let [sx, sy] = whole(picture, options, Some(at));
    let [px, py] = seen(parts);
    // Both at one scale, as wide as they show, unless one would be too small to see.
    let wide = |r: (f64, f64)| r.1 - r.0;
    let share = (wide(sx) / (wide(sx) + wide(px))).clamp(0.38, 0.62);
    let room = width - 2.0 * (Plot::LEFT + Plot::RIGHT) * em;
    let (top, bottom) = (4.2 * em, foot - Plot::BELOW * em);
    let left = Area {
        lo: Dot::new(Plot::LEFT * em, top),
        hi: Dot::new(Plot::LEFT * em + share * room, bottom),
    };
    let right = Area {
        lo: Dot::new(left.hi.x + (Plot::RIGHT + Plot::LEFT) * em, top),
        hi: Dot::new(width - Plot::RIGHT * em, bottom),
    };
    let plot = Plot::at_one_scale(left, sx, sy, em);
    let of_parts = Plot::at_one_scale(right, px, py, em);
    // The smaller scale of the two is that of both, where neither was asked for.
    let (plot, of_parts) = if options.x.is_some() || options.y.is_some() {
        (plot, of_parts)
    } else {
        let scale = plot.scale().min(of_parts.scale());
        (plot.at_scale(scale), of_parts.at_scale(scale))
    };
    let labels = AxisLabel::of_positions(options);
    let items = &mut page.items;
    let caption = |area: Area, said: String| {
        let above = Dot::new(area.lo.x, area.lo.y - 0.5 * em);
        text(said, above, em, Anchor::Start, INK)
    };
    items.push(caption(left, format!("slice at {}", orientation(slice))));
    panel(items, picture, slice, &plot, options.labels);
    mark(items, at, &plot);
    plot.frame(items, &labels);
    let (fixed, moving) = (picture.space.fixed().name(), picture.space.moving().name());
    let where_it_is = format!(
        "{moving} at x {}, y {} relative to {fixed}",
        brief(at.x),
        brief(at.y)
    );
    items.push(caption(right, where_it_is));
    of_parts.grid(items, &labels);
    let mut inner = Vec::new();
    draw_parts(&mut inner, parts, &of_parts, options.labels);
    of_parts.scale_bar(&mut inner, options.unit.as_deref());
    items.push(Item::Clipped {
        area: right,
        items: inner,
    });
    of_parts.frame(items, &labels);
    page.finished()
}

/// Slices in rows, all showing the same part of the plane.
fn grid(picture: &SlicesPicture<'_>, options: &PictureOptions) -> Scene {
    /// The side of a picture of one slice, and of one of several.
    const ONE: f64 = 720.0;
    const SMALL: f64 = 300.0;
    let n = picture.slices.len().max(1);
    let columns = (1..=n).find(|c| c * c >= n).unwrap_or(1);
    let rows = n.div_ceil(columns);
    let side = if n == 1 { ONE } else { SMALL };
    let usual = (
        columns as f64 * side + 100.0,
        rows as f64 * (side + 26.0) + 140.0,
    );
    let mut page = Page::of(options, usual, entries(picture, options));
    let Page {
        width, foot, em, ..
    } = page;
    let (gap, caption) = (1.6 * em, 1.7 * em);
    let left = Plot::LEFT * em;
    let cell = (
        (width - left - Plot::RIGHT * em + gap) / columns as f64 - gap,
        (foot - Plot::BELOW * em - 2.3 * em) / rows as f64 - caption,
    );
    let labels = AxisLabel::of_positions(options);
    let items = &mut page.items;
    let [seen_x, seen_y] = whole(picture, options, None);
    for (i, slice) in picture.slices.iter().enumerate() {
        let (column, row) = (i % columns, i / columns);
        let at = Dot::new(
            left + column as f64 * (cell.0 + gap),
            2.3 * em + caption + row as f64 * (cell.1 + caption),
        );
        let area = Area::new(at.x, at.y, cell.0.max(1.0), cell.1.max(1.0));
        let plot = Plot::at_one_scale(area, seen_x, seen_y, em);
        let above = at.moved(0.0, -0.45 * em);
        items.push(text(orientation(slice), above, em, Anchor::Start, INK));
        panel(items, picture, slice, &plot, options.labels);
        // Numbers are beside the first and below the last of each row and column.
        let last = i + columns >= picture.slices.len();
        plot.frame_with(items, &labels, [last, column == 0]);
    }
    page.finished()
}

/// Window of the plane that contains all slices.
fn whole(
    picture: &SlicesPicture<'_>,
    options: &PictureOptions,
    mark: Option<Point>,
) -> [(f64, f64); 2] {
    let mut points: Vec<Point> = picture.slices.iter().flat_map(reached).collect();
    points.extend(mark);
    let size = picture
        .space
        .fixed()
        .size()
        .max(picture.space.moving().size());
    let [x, y] = extent(&points, 0.0);
    [
        options.x.unwrap_or(with_margin(x, 0.08 * size)),
        options.y.unwrap_or(with_margin(y, 0.08 * size)),
    ]
}

/// Points of a slice between which it lies.
pub(crate) fn reached(slice: &Slice) -> impl Iterator<Item = Point> {
    (slice.curves.iter()).flat_map(|c| (0..=4).map(|k| c.geometry.point(0.25 * f64::from(k))))
}

fn orientation(slice: &Slice) -> String {
    let degrees = brief(slice.theta.to_degrees());
    let doubt = if slice.doubtful { " (doubtful)" } else { "" };
    format!("θ = {degrees}°{doubt}")
}

/// A slice without its frame.
fn panel(
    items: &mut Vec<Item>,
    picture: &SlicesPicture<'_>,
    slice: &Slice,
    plot: &Plot,
    labels: Labels,
) {
    let areas = areas(picture.space, slice, plot);
    let outside = areas.iter().rev().find(|a| !a.free_inside);
    let outside = outside.and_then(|a| a.region).unwrap_or(RegionId(0));
    let mut inner = vec![Item::filled(Path::rectangle(plot.area), ground(outside))];
    // Blocked space is on the left of the loops. From the largest to the smallest each covers what it is in.
    for area in &areas {
        let colour = match area.region {
            _ if !area.free_inside => BLOCKED,
            region => ground(region.unwrap_or(RegionId(0))),
        };
        inner.push(Item::filled(area.path.clone(), colour));
    }
    draw_curves(&mut inner, slice, plot);
    if labels != Labels::None {
        let mut placed = Placed::new(plot.area, labels == Labels::All);
        if picture.space.free_regions().len() > 1 {
            number_regions(&mut inner, &areas, outside, plot, &mut placed);
        }
        if labels == Labels::All || slice.curves.len() <= 60 {
            name_curves(&mut inner, picture.space, slice, plot, &mut placed);
        }
    }
    items.push(Item::Clipped {
        area: plot.area,
        items: inner,
    });
}

/// Contact curves by kind.
pub(crate) fn draw_curves(items: &mut Vec<Item>, slice: &Slice, plot: &Plot) {
    for (k, (colour, _)) in KINDS.iter().enumerate() {
        let mut path = Path::new();
        for c in slice.curves.iter().filter(|c| kind(c.fixed, c.moving) == k) {
            path.steps
                .push(Step::Move(place(plot, c.geometry.point(0.0))));
            append(&mut path, &c.geometry, plot);
        }
        items.push(Item::drawn(path, *colour, 0.13 * plot.em));
    }
}

/// Area enclosed by a loop.
struct Enclosed {
    path: Path,
    /// The loop as a polygon on the picture, for the places of labels.
    polygon: Vec<Dot>,
    free_inside: bool,
    /// The free region beside it.
    region: Option<RegionId>,
}

/// The loops of a slice, those that enclose more first.
fn areas(space: &ContactSpace, slice: &Slice, plot: &Plot) -> Vec<Enclosed> {
    let mut all: Vec<(f64, Enclosed)> = Vec::new();
    for l in &slice.loops {
        let curves: Vec<&SliceCurve> = l.iter().map(|&c| &slice.curves[c as usize]).collect();
        let Some(first) = curves.first() else {
            continue;
        };
        let mut path = Path::new();
        path.steps
            .push(Step::Move(place(plot, first.geometry.point(0.0))));
        let mut polygon = Vec::new();
        let mut area = 0.0;
        for c in &curves {
            append(&mut path, &c.geometry, plot);
            area += swept(&c.geometry, first.geometry.point(0.0));
            polygon.extend((0..8).map(|k| place(plot, c.geometry.point(f64::from(k) / 8.0))));
        }
        path.steps.push(Step::Close);
        let region = curves.iter().find_map(|c| {
            let patch = c.patch?;
            space.patches().get(patch.index()).map(|p| p.region)
        });
        all.push((
            area.abs(),
            Enclosed {
                path,
                polygon,
                free_inside: area < 0.0,
                region,
            },
        ));
    }
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    all.into_iter().map(|a| a.1).collect()
}

/// The area that the line from a point to a place sweeps while the place travels along a curve.
fn swept(geometry: &CurveGeometry, about: Point) -> f64 {
    let (start, end) = (geometry.point(0.0), geometry.point(1.0));
    let triangle = 0.5 * (start - about).cross(end - about);
    triangle
        + match *geometry {
            CurveGeometry::Segment { .. } => 0.0,
            CurveGeometry::Arc { radius, sweep, .. } => {
                0.5 * radius * radius * (sweep - sweep.sin())
            }
            // Area of a flat arc: two thirds of the chord times the height.
            CurveGeometry::FlatArc { bulge, .. } => start.distance(end).powi(2) * bulge / 3.0,
        }
}

/// The number of each free region, where there is most room for it.
fn number_regions(
    items: &mut Vec<Item>,
    areas: &[Enclosed],
    outside: RegionId,
    plot: &Plot,
    placed: &mut Placed,
) {
    /// Places that are tried, across and up.
    const TRIED: u32 = 40;
    let em = plot.em;
    let all: Vec<Dot> = areas
        .iter()
        .flat_map(|a| a.polygon.iter().copied())
        .collect();
    // For each loop that is free inside, and for what is outside of all, the best place and its room.
    let mut best: Vec<Option<(f64, Dot)>> = vec![None; areas.len() + 1];
    for i in 1..TRIED {
        for j in 1..TRIED {
            let share = |k: u32| f64::from(k) / f64::from(TRIED);
            let at = plot
                .area
                .lo
                .moved(plot.area.width() * share(i), plot.area.height() * share(j));
            let within = areas.iter().rposition(|a| holds(&a.polygon, at));
            let slot = match within {
                None => areas.len(),
                Some(k) if areas[k].free_inside => k,
                Some(_) => continue,
            };
            let border = (at.x - plot.area.lo.x)
                .min(plot.area.hi.x - at.x)
                .min(at.y - plot.area.lo.y)
                .min(plot.area.hi.y - at.y);
            let room = all.iter().map(|d| d.distance(at)).fold(border, f64::min);
            if best[slot].is_none_or(|b| room > b.0) {
                best[slot] = Some((room, at));
            }
        }
    }
    for (slot, found) in best.into_iter().enumerate() {
        let region = areas.get(slot).map_or(Some(outside), |a| a.region);
        if let (Some((room, at)), Some(region)) = (found, region)
            && room > 0.5 * em
        {
            placed.put(items, &region.to_string(), 1.1 * em, [at]);
        }
    }
}

/// Whether a polygon contains a place.
fn holds(polygon: &[Dot], at: Dot) -> bool {
    let mut inside = false;
    for (i, a) in polygon.iter().enumerate() {
        let b = polygon[(i + 1) % polygon.len()];
        if (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) * (b.x - a.x) / (b.y - a.y) {
            inside = !inside;
        }
    }
    inside
}

/// Writes the names of the features that touch beside contact curves that are long enough.
fn name_curves(
    items: &mut Vec<Item>,
    space: &ContactSpace,
    slice: &Slice,
    plot: &Plot,
    placed: &mut Placed,
) {
    let size = 0.72 * plot.em;
    for c in &slice.curves {
        let said = format!(
            "{} | {}",
            short(space.fixed(), c.fixed),
            short(space.moving(), c.moving)
        );
        let at = place(plot, c.geometry.point(0.5));
        let n = c.geometry.free_normal(0.5);
        let wide = crate::font::width(&said, size);
        let long = c.geometry.length() * plot.scale();
        if long < 0.8 * wide && placed.is_sparing() {
            continue;
        }
        // On the blocked side, which is of one colour.
        let away = |far: f64| at.moved(-far * n.x * 0.6 * wide, far * n.y * 1.1 * size);
        placed.put(items, &said, size, [away(1.0), away(-1.0)]);
    }
}

/// A feature in few letters: its name, if the part gives it one, or its kind, loop and index.
pub(crate) fn short(part: &Part, name: FeatureName) -> String {
    let kind = match name.kind {
        FeatureKind::Line => "L",
        FeatureKind::ConvexArc => "A",
        FeatureKind::ConcaveArc => "a",
        FeatureKind::Vertex => "V",
    };
    let text = part.feature_text(name);
    if text == name.to_string() {
        format!("{kind}{}.{}", name.loop_index, name.index)
    } else {
        text
    }
}

/// Legend of the names that [`short`] gives.
pub(crate) fn of_names() -> (Sign, String) {
    let said = "L line, A convex arc, a concave arc, V vertex; loop.index, fixed part first";
    (Sign::Line(WHITE), said.to_owned())
}

/// Legend of the kinds of contact curves that occur.
pub(crate) fn of_kinds(occurs: impl Fn(usize) -> bool) -> impl Iterator<Item = (Sign, String)> {
    let kinds = KINDS.iter().enumerate().filter(move |&(k, _)| occurs(k));
    kinds.map(|(_, (colour, said))| (Sign::Line(*colour), (*said).to_owned()))
}

/// The position at which the parts beside are shown.
fn mark(items: &mut Vec<Item>, at: Point, plot: &Plot) {
    let at = place(plot, at);
    let em = plot.em;
    let mut cross = Path::through([at.moved(-0.9 * em, 0.0), at.moved(0.9 * em, 0.0)]);
    cross.line_through([at.moved(0.0, -0.9 * em), at.moved(0.0, 0.9 * em)]);
    let signs = vec![
        Item::drawn(cross, INK, 0.1 * em),
        Item::filled(Path::circle(at, 0.28 * em), INK),
    ];
    items.push(Item::Clipped {
        area: plot.area,
        items: signs,
    });
}

/// Legend of the colours that occur.
fn entries(picture: &SlicesPicture<'_>, options: &PictureOptions) -> Vec<(Sign, String)> {
    let mut all = Vec::new();
    let regions = picture.space.free_regions();
    let mut shown: Vec<RegionId> = Vec::new();
    let curves = || picture.slices.iter().flat_map(|s| &s.curves);
    for patch in curves().filter_map(|c| c.patch) {
        let region = picture.space.patches()[patch.index()].region;
        if !shown.contains(&region) {
            shown.push(region);
        }
    }
    shown.sort_unstable();
    /// Number of regions from which on only their numbers are given.
    const MOST: usize = 8;
    for &region in shown.iter().take(MOST) {
        let is = match regions.get(region.index()).map(|r| r.unbounded) {
            Some(true) => "open",
            _ => "caged",
        };
        all.push((
            Sign::Field(ground(region), INK),
            format!("free, region {region}: {is}"),
        ));
    }
    all.push((Sign::Field(BLOCKED, INK), "blocked".to_owned()));
    all.extend(of_kinds(|k| curves().any(|c| kind(c.fixed, c.moving) == k)));
    if options.labels != Labels::None && curves().count() > 0 {
        all.push(of_names());
    }
    all
}
