//! Parts as drawn or at a configuration: outlines, names, axes of motion, joints, what touches.

use cspace::pair::Joint;
use cspace::{Axis, AxisMotion, Point, Rotation, Vector};
use cspace_model::JointEntry;

use crate::colour::{INK, MARK, WHITE, part as colours};
use crate::feature_labels::{self, Fitting};
use crate::labels::Placed;
use crate::legend::{Legend, Sign};
use crate::options::{Labels, PictureOptions};
use crate::outline::{at_height, extent, of_edges, of_layers, of_part, place, points, with_margin};
use crate::page::Page;
use crate::placed_part::PlacedPart;
use crate::plot::{AxisLabel, Plot};
use crate::scene::{Area, Dot, Item, Path, Scene, Stroke};
use crate::ticks::brief;

/// How much of the way to the colour of its outline the highest layer of a part is filled.
const DARKER: f64 = 0.35;

/// Contact of two parts.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactMark {
    /// The point.
    pub at: Point,
    /// The outward normal of the part that is touched.
    pub normal: Vector,
    /// Names of the features that touch.
    pub label: String,
}

/// Something of a drawing that is in no part.
#[derive(Debug, Clone, PartialEq)]
pub struct UnusedPath {
    /// Start of the path.
    pub start: Point,
    /// End and bulge of each line or arc.
    pub edges: Vec<(Point, f64)>,
    /// Description of the path.
    pub label: String,
}

/// Data of a picture of parts.
#[derive(Debug, Clone, Default)]
pub struct PartsPicture<'a> {
    /// The parts, the last on top.
    pub parts: Vec<PlacedPart<'a>>,
    /// Parts at further positions of a motion: only outlines, below the parts.
    pub swept: Vec<PlacedPart<'a>>,
    /// The joints between them, in the assembly.
    pub joints: Vec<JointEntry>,
    /// Contacts of the parts.
    pub contacts: Vec<ContactMark>,
    /// The height, in the model's unit of length, at which parts are drawn: layers elsewhere are thin outlines. `None` is all heights.
    pub height: Option<f64>,
    /// Whether the parts are those of a drawing, which has no motions.
    pub is_drawing: bool,
    /// Paths of a drawing that are in no part, in red.
    pub unused: Vec<UnusedPath>,
    /// Places of a drawing where something is wrong, and what; marked in red.
    pub faults: Vec<(Point, String)>,
    /// Whether the origins of the parts' frames are omitted.
    pub without_origins: bool,
    /// Remarks below the picture, such as the configuration.
    pub remarks: Vec<String>,
}

/// Draws a picture of parts, to scale: names, frame origins, pivots, slides, joints, contacts; with all labels,
/// vertices numbered `loop.index`; with those of features, lines, arcs and convex vertices with their names in answers,
/// and below it the number of labels that do not fit.
///
/// ```
/// use cspace::{Configuration, Part};
/// use cspace_draw::{PartsPicture, PictureOptions, PlacedPart, parts, svg};
/// let plate = Part::rectangle("plate", (0.0, 0.0), 8.0, 4.0)?;
/// let picture = PartsPicture {
///     parts: vec![PlacedPart {
///         part: &plate,
///         assembly_from_part: Configuration::default(),
///         axis: None,
///         number: 0,
///     }],
///     ..PartsPicture::default()
/// };
/// let drawn = svg(&parts(&picture, &PictureOptions::default()));
/// assert!(drawn.contains(">plate</text>"));
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn parts(picture: &PartsPicture<'_>, options: &PictureOptions) -> Scene {
    /// In dots, if the user does not say.
    const USUAL: (f64, f64) = (960.0, 720.0);
    let (size, em) = options.sized(USUAL);
    let legend = |features: Option<Fitting>| {
        let said = features.map(|f| (Sign::Line(WHITE), f.to_string()));
        let entries = entries(picture, options).into_iter().chain(said).collect();
        Legend::new(entries, size.0 - 2.0 * em, em)
    };
    // There is room for the largest numbers before it is known which fit.
    let widest = (options.labels == Labels::Features).then_some(Fitting {
        all: 999_999,
        left_out: 999_999,
    });
    let mut page = Page::with(options, size, legend(widest));
    let area = page.area();
    let [x, y] = seen(picture);
    let plot = Plot::at_one_scale(area, options.x.unwrap_or(x), options.y.unwrap_or(y), em);
    let labels = AxisLabel::of_positions(options);
    plot.grid(&mut page.items, &labels);
    let mut inner = Vec::new();
    let fitting = draw(&mut inner, picture, &plot, options.labels);
    plot.scale_bar(&mut inner, options.unit.as_deref());
    page.items.push(Item::Clipped { area, items: inner });
    plot.frame(&mut page.items, &labels);
    page.legend = legend(fitting);
    page.finished()
}

/// A frame of parts, with an edge around it.
pub(crate) fn frame_of(
    items: &mut Vec<Item>,
    parts: &PartsPicture<'_>,
    area: Area,
    [x, y]: [(f64, f64); 2],
    em: f64,
) {
    // Signs on parts are smaller than those of a picture of the parts alone.
    let plot = Plot::at_one_scale(area, x, y, 0.6 * em);
    let mut inner = Vec::new();
    draw(&mut inner, parts, &plot, Labels::None);
    items.push(Item::Clipped { area, items: inner });
    items.push(Item::Shape {
        path: Path::rectangle(area),
        fill: None,
        stroke: Some(Stroke {
            colour: INK,
            width: 0.06 * em,
        }),
        title: None,
    });
}

/// Window of the plane that contains all frames.
pub(crate) fn seen_of_all<'p, 'a: 'p>(
    frames: impl Iterator<Item = &'p PartsPicture<'a>>,
    options: &PictureOptions,
) -> [(f64, f64); 2] {
    let all = frames.map(seen).reduce(|all, one| {
        core::array::from_fn(|k| (all[k].0.min(one[k].0), all[k].1.max(one[k].1)))
    });
    let all = all.unwrap_or([(0.0, 1.0); 2]);
    [options.x.unwrap_or(all[0]), options.y.unwrap_or(all[1])]
}

/// Window of the plane in view: the parts, the origin if it is near, pivots and contacts, and a margin.
pub(crate) fn seen(picture: &PartsPicture<'_>) -> [(f64, f64); 2] {
    let mut all: Vec<Point> = (picture.parts.iter().chain(&picture.swept))
        .flat_map(|p| points(p.part, p.assembly_from_part))
        .collect();
    for p in &picture.parts {
        if let Some(AxisMotion::Revolute { center }) = p.axis.map(|a| a.motion) {
            all.push(center);
        }
    }
    for path in &picture.unused {
        all.push(path.start);
        all.extend(path.edges.iter().map(|e| e.0));
    }
    all.extend(picture.faults.iter().map(|f| f.0));
    let [x, y] = extent(&all, 0.0);
    let size = (x.1 - x.0).max(y.1 - y.0);
    [with_margin(x, 0.06 * size), with_margin(y, 0.06 * size)]
}

/// Draws the parts with all their marks; returns which labels of features fit, if these are requested.
pub(crate) fn draw(
    items: &mut Vec<Item>,
    picture: &PartsPicture<'_>,
    plot: &Plot,
    labels: Labels,
) -> Option<Fitting> {
    let em = plot.em;
    let path = |p: &PlacedPart<'_>| of_part(p.part, p.assembly_from_part, plot);
    let elsewhere = picture.height.map(|_| &picture.parts);
    for p in picture.swept.iter().chain(elsewhere.into_iter().flatten()) {
        let colour = colours(p.number).1;
        items.push(Item::drawn(path(p), colour, 0.04 * em));
    }
    for p in &picture.parts {
        // Higher layers are darker.
        for (height, path) in of_layers(p.part, picture.height, p.assembly_from_part, plot) {
            let (fill, line) = colours(p.number);
            items.push(Item::filled(path, fill.towards(line, DARKER * height)));
        }
    }
    let is_there = |p: &PlacedPart<'_>| {
        let mut layers = p.part.layers().iter();
        picture.height.is_none_or(|z| layers.any(|l| l.is_at(z)))
    };
    // All outlines on top of all insides, so that parts that overlap are both seen.
    for p in picture.parts.iter().filter(|p| is_there(p)) {
        items.push(Item::Shape {
            path: at_height(p.part, picture.height, p.assembly_from_part, plot),
            fill: None,
            stroke: Some(Stroke {
                colour: colours(p.number).1,
                width: 0.11 * em,
            }),
            title: Some(p.part.name().to_owned()),
        });
    }
    for p in &picture.parts {
        if !picture.without_origins {
            frame_origin(items, p, plot);
        }
        motion(items, p, plot);
    }
    for joint in &picture.joints {
        joint_sign(items, &joint.joint, plot);
    }
    let mut placed = Placed::new(plot.area, labels == Labels::All);
    for p in &picture.parts {
        if let Some(AxisMotion::Revolute { center }) = p.axis.map(|a| a.motion) {
            let at = place(plot, center);
            placed.keep(Area::new(
                at.x - 0.6 * em,
                at.y - 0.6 * em,
                1.2 * em,
                1.2 * em,
            ));
        }
    }
    for contact in &picture.contacts {
        contact_sign(items, contact, plot, &mut placed);
    }
    faults(items, picture, plot, &mut placed);
    if labels == Labels::None {
        return None;
    }
    for (k, p) in picture.parts.iter().enumerate() {
        if !is_there(p) {
            continue;
        }
        let places = inside(p, &picture.parts[k + 1..], plot);
        let colour = colours(p.number).1;
        placed.put_in(items, p.part.name(), 1.1 * em, colour, places);
    }
    if labels == Labels::All {
        let mut numbers = Placed::new(plot.area, false);
        for p in &picture.parts {
            number_vertices(items, p, picture.height, plot, &mut numbers);
        }
    }
    (labels == Labels::Features)
        .then(|| feature_labels::label(items, &picture.parts, picture.height, plot, &mut placed))
}

/// Places for a part's name, the best first: far inside and under no part drawn later, else beside.
fn inside(p: &PlacedPart<'_>, later: &[PlacedPart<'_>], plot: &Plot) -> Vec<Dot> {
    /// Number of places tried across and up.
    const TRIED: u32 = 24;
    let outline = points(p.part, p.assembly_from_part);
    let [x, y] = extent(&outline, 0.0);
    let mut dots: Vec<Dot> = Vec::new();
    for part in core::iter::once(p).chain(later) {
        let outline = points(part.part, part.assembly_from_part);
        for (i, q) in outline.iter().enumerate() {
            // Long lines count along their length.
            let next = outline[(i + 1) % outline.len()];
            dots.extend((0..4).map(|k| place(plot, q.lerp(next, 0.25 * f64::from(k)))));
        }
    }
    let is_in = |part: &PlacedPart<'_>, at: Point| {
        let part_from_assembly = part.assembly_from_part.inverse();
        (part.part).contains(part_from_assembly.fixed_from_moving(at))
    };
    let mut found: Vec<(f64, Dot)> = Vec::new();
    for i in 1..TRIED {
        for j in 1..TRIED {
            let share =
                |(lo, hi): (f64, f64), k: u32| lo + (hi - lo) * f64::from(k) / f64::from(TRIED);
            let at = Point::new(share(x, i), share(y, j));
            if is_in(p, at) && !later.iter().any(|l| is_in(l, at)) {
                let dot = place(plot, at);
                // A name is wider than high: what is above and below is less in its way.
                let room = |d: &Dot| ((d.x - dot.x) * 0.5).hypot(d.y - dot.y);
                let room = dots.iter().map(room).fold(f64::INFINITY, f64::min);
                found.push((room, dot));
            }
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let above = place(plot, Point::new(0.5 * (x.0 + x.1), y.1)).moved(0.0, -plot.em);
    let below = place(plot, Point::new(0.5 * (x.0 + x.1), y.0)).moved(0.0, plot.em);
    let best = found
        .into_iter()
        .filter(|f| f.0 > 0.4 * plot.em)
        .map(|f| f.1);
    best.step_by(3).take(40).chain([above, below]).collect()
}

/// The origin of the part's frame: its x axis longer than its y axis.
fn frame_origin(items: &mut Vec<Item>, p: &PlacedPart<'_>, plot: &Plot) {
    let c = p.assembly_from_part;
    let origin = place(plot, Point::new(c.x, c.y));
    let (sin, cos) = c.theta.sin_cos();
    let mut path = Path::new();
    let em = plot.em;
    for (length, x, y) in [(1.5 * em, cos, -sin), (0.9 * em, -sin, -cos)] {
        path.line_through([origin, origin.moved(length * x, length * y)]);
    }
    items.push(Item::drawn(path, colours(p.number).1, 0.13 * em));
    items.push(Item::filled(
        Path::circle(origin, 0.15 * em),
        colours(p.number).1,
    ));
}

/// The pivot of a part that turns, the direction of one that slides.
fn motion(items: &mut Vec<Item>, p: &PlacedPart<'_>, plot: &Plot) {
    let em = plot.em;
    match p.axis.map(|a| a.motion) {
        Some(AxisMotion::Revolute { center }) => pivot(items, place(plot, center), em),
        Some(AxisMotion::Prismatic { direction }) => {
            let [x, y] = extent(&points(p.part, p.assembly_from_part), 0.0);
            let middle = Point::new(0.5 * (x.0 + x.1), 0.5 * (y.0 + y.1));
            slide(items, place(plot, middle), direction, em);
        }
        Some(AxisMotion::Fixed) | None => {}
    }
}

fn pivot(items: &mut Vec<Item>, at: Dot, em: f64) {
    items.push(Item::Shape {
        path: Path::circle(at, 0.55 * em),
        fill: Some(WHITE),
        stroke: Some(Stroke {
            colour: INK,
            width: 0.13 * em,
        }),
        title: None,
    });
    items.push(Item::filled(Path::circle(at, 0.18 * em), INK));
}

/// A double arrow.
fn slide(items: &mut Vec<Item>, at: Dot, direction: Vector, em: f64) {
    let d = direction.unit();
    let (dx, dy) = (1.9 * em * d.x, -1.9 * em * d.y);
    let mut path = Path::through([at.moved(-dx, -dy), at.moved(dx, dy)]);
    for side in [1.0, -1.0] {
        let tip = at.moved(side * dx, side * dy);
        let wing = |turn: f64| {
            let w = Rotation::by(turn) * Vector::new(-side * d.x, side * d.y);
            tip.moved(0.7 * em * w.x, 0.7 * em * w.y)
        };
        path.line_through([wing(0.45), tip, wing(-0.45)]);
    }
    items.push(Item::drawn(path.clone(), WHITE, 0.4 * em));
    items.push(Item::drawn(path, INK, 0.15 * em));
}

fn joint_sign(items: &mut Vec<Item>, joint: &Joint, plot: &Plot) {
    let em = plot.em;
    match *joint {
        Joint::Revolute { at } => pivot(items, place(plot, at), em),
        Joint::Prismatic { direction, at } => slide(items, place(plot, at), direction, em),
    }
}

fn contact_sign(items: &mut Vec<Item>, contact: &ContactMark, plot: &Plot, placed: &mut Placed) {
    let em = plot.em;
    let at = place(plot, contact.at);
    let n = contact.normal.unit();
    let tip = at.moved(2.6 * em * n.x, -2.6 * em * n.y);
    let wing = |turn: f64| {
        let w = Rotation::by(turn) * Vector::new(-n.x, n.y);
        tip.moved(0.7 * em * w.x, 0.7 * em * w.y)
    };
    let mut arrow = Path::through([at, tip]);
    arrow.line_through([wing(0.45), tip, wing(-0.45)]);
    items.push(Item::drawn(arrow.clone(), WHITE, 0.4 * em));
    items.push(Item::drawn(arrow, MARK, 0.15 * em));
    items.push(Item::Shape {
        path: Path::circle(at, 0.32 * em),
        fill: Some(MARK),
        stroke: None,
        title: Some(contact.label.clone()),
    });
    placed.keep(Area::new(at.x - 0.5 * em, at.y - 0.5 * em, em, em));
}

/// Draws the faults of a drawing.
fn faults(items: &mut Vec<Item>, picture: &PartsPicture<'_>, plot: &Plot, placed: &mut Placed) {
    let em = plot.em;
    for unused in &picture.unused {
        items.push(Item::Shape {
            path: of_edges(unused.start, &unused.edges, plot),
            fill: None,
            stroke: Some(Stroke {
                colour: MARK,
                width: 0.18 * em,
            }),
            title: Some(unused.label.clone()),
        });
    }
    for (p, label) in &picture.faults {
        let at = place(plot, *p);
        items.push(Item::Shape {
            path: Path::circle(at, 0.7 * em),
            fill: None,
            stroke: Some(Stroke {
                colour: MARK,
                width: 0.18 * em,
            }),
            title: Some(label.clone()),
        });
        placed.keep(Area::new(at.x - em, at.y - em, 2.0 * em, 2.0 * em));
    }
}

/// Vertices by loop and index, beside the corner where there is room.
fn number_vertices(
    items: &mut Vec<Item>,
    p: &PlacedPart<'_>,
    height: Option<f64>,
    plot: &Plot,
    placed: &mut Placed,
) {
    let em = plot.em;
    let size = 0.75 * em;
    let mut signs = Path::new();
    for (l, loop_) in p.part.loops().iter().enumerate() {
        if height.is_some_and(|z| !p.part.bounds_at(l, z)) {
            continue;
        }
        for (i, v) in loop_.vertices().iter().enumerate() {
            let at = place(plot, p.assembly_from_part.fixed_from_moving(v.point()));
            signs.steps.extend(Path::circle(at, 0.16 * em).steps);
            let around = [
                (0.9, -0.7),
                (-0.9, -0.7),
                (0.9, 0.8),
                (-0.9, 0.8),
                (0.0, -1.0),
                (0.0, 1.1),
                (1.6, 0.0),
                (-1.6, 0.0),
            ];
            let places = around.map(|(x, y)| at.moved(x * em, y * em));
            let said = format!("{l}.{i}");
            if !placed.put(items, &said, size, places) {
                Placed::new(plot.area, true).put(items, &said, size, places);
            }
        }
    }
    items.push(Item::filled(signs, colours(p.number).1));
}

/// Legend of the parts, and of the contacts.
pub(crate) fn entries(picture: &PartsPicture<'_>, options: &PictureOptions) -> Vec<(Sign, String)> {
    // A part at several places is listed once.
    let first = |i: usize| {
        !picture.parts[..i]
            .iter()
            .any(|q| q.number == picture.parts[i].number)
    };
    let mut all: Vec<(Sign, String)> = (picture.parts.iter().enumerate())
        .filter(|&(i, _)| first(i))
        .map(|(_, p)| {
            let (fill, edge) = colours(p.number);
            let said = match picture.is_drawing {
                true => p.part.name().to_owned(),
                false => format!("{}: {}", p.part.name(), moves(p.axis, options)),
            };
            (Sign::Field(fill, edge), said)
        })
        .collect();
    all.extend((picture.contacts.iter()).map(|c| (Sign::Mark(MARK), c.label.clone())));
    if !picture.unused.is_empty() {
        all.push((Sign::Line(MARK), "not used".to_owned()));
    }
    // One sentence for each kind of fault.
    let mut said: Vec<&str> = picture.faults.iter().map(|f| f.1.as_str()).collect();
    said.sort_unstable();
    said.dedup();
    all.extend(
        said.iter()
            .take(6)
            .map(|f| (Sign::Mark(MARK), (*f).to_owned())),
    );
    let plain = Sign::Line(WHITE);
    all.extend(picture.remarks.iter().map(|r| (plain, r.clone())));
    all
}

/// A motion in words.
fn moves(axis: Option<Axis>, options: &PictureOptions) -> String {
    let Some(axis) = axis else {
        return "moves freely".to_owned();
    };
    let round = brief;
    let degrees = |x: f64| format!("{}°", brief(x.to_degrees()));
    match axis.motion {
        AxisMotion::Fixed => "fixed".to_owned(),
        AxisMotion::Revolute { center } => {
            let range = axis.range.map_or(String::new(), |(lo, hi)| {
                format!(" from {} to {}", degrees(lo), degrees(hi))
            });
            format!(
                "turns about ({}, {}){range}",
                round(center.x),
                round(center.y)
            )
        }
        AxisMotion::Prismatic { direction } => {
            let range = axis.range.map_or(String::new(), |(lo, hi)| {
                format!(" from {} to {}", round(lo), options.length(&round(hi)))
            });
            format!(
                "slides along ({}, {}){range}",
                round(direction.x),
                round(direction.y)
            )
        }
    }
}
