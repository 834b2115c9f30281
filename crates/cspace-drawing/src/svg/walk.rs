//! The elements of an SVG file in document order, each with its transform.

use std::collections::HashMap;
use std::str::FromStr;
use std::sync::Arc;

use cspace::{Point, Vector};
use roxmltree::{Document, Node};
use svgtypes::{Transform, ViewBox};

use super::length::{physical, user_units};
use super::shapes::shape;
use super::style::{Sheet, Style};
use crate::affine::Affine;
use crate::drawing::{Drawing, Entity, Ignored, Origin, Problem, Unit};
use crate::error::DrawingError;
use crate::source::Source;

/// The most elements that are drawn, those that are used again included.
const MOST_ELEMENTS: usize = 2_000_000;

/// The deepest that elements are nested or used in one another.
const DEEPEST: usize = 200;

const XLINK: &str = "http://www.w3.org/1999/xlink";
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

pub(super) fn walk(document: &Document<'_>, source: &Source) -> Result<Drawing, DrawingError> {
    let root = document.root_element();
    let (map, unit) = page(root);
    let ids: HashMap<&str, Node<'_, '_>> = (document.descendants())
        .filter_map(|n| Some((n.attribute("id")?, n)))
        .collect();
    if let Some(id) = &source.id
        && !ids.contains_key(id.as_str())
    {
        let message = format!("no element has the id {id:?}");
        return Err(DrawingError::file(
            message,
            "check the id; ids are case-sensitive",
        ));
    }
    let mut walk = Walk {
        document,
        source,
        ids,
        sheet: Sheet::of(document),
        drawing: Drawing {
            unit,
            ..Drawing::default()
        },
        count: 0,
    };
    let ground = Ground {
        map,
        style: walk.sheet.style(root, &Style::default()),
        layer: Arc::from(""),
        names: Arc::from([]),
        is_chosen: source.id.is_none(),
        depth: 0,
    };
    walk.children(root, &ground)?;
    Ok(walk.drawing)
}

/// From the coordinates of the root's content to the drawing's, whose y axis points up; and the unit that the page is measured
/// in. The origin is the lower left corner of the page; of one whose view box does not begin at 0, 0, whoever drew it has
/// chosen the origin, and it stays.
fn page(root: Node<'_, '_>) -> (Affine, Option<Unit>) {
    let length = |name| root.attribute(name).and_then(physical);
    let (width, height) = (length("width"), length("height"));
    let unit = width.or(height).and_then(|l| l.1);
    let view = root
        .attribute("viewBox")
        .and_then(|v| ViewBox::from_str(v).ok());
    // Both sides in the unit of the first.
    let side = |l: Option<(f64, Option<Unit>)>| {
        let (number, own) = l?;
        let factor = match (own, unit) {
            (Some(own), Some(unit)) => own.millimetres() / unit.millimetres(),
            _ => 1.0,
        };
        Some(number * factor)
    };
    let (width, height) = (side(width), side(height));
    let Some(view) = view.filter(|v| v.w > 0.0 && v.h > 0.0) else {
        // User units are pixels.
        let scale = match (unit, root.attribute("viewBox")) {
            (Some(unit), _) => Unit::Pixel.millimetres() / unit.millimetres(),
            _ => 1.0,
        };
        let top = height.unwrap_or(0.0);
        let map = Affine {
            x: Vector::new(scale, 0.0),
            y: Vector::new(0.0, -scale),
            origin: Point::new(0.0, top),
        };
        return (map, unit);
    };
    let scales = [width.map(|w| w / view.w), height.map(|h| h / view.h)];
    let scale = (scales.into_iter().flatten())
        .filter(|s| *s > 0.0 && s.is_finite())
        .fold(f64::INFINITY, f64::min);
    let scale = if scale.is_finite() { scale } else { 1.0 };
    let map = Affine {
        x: Vector::new(scale, 0.0),
        y: Vector::new(0.0, -scale),
        origin: match (view.x, view.y) {
            (0.0, 0.0) => Point::new(0.0, view.h * scale),
            _ => Point::ORIGIN,
        },
    };
    (map, unit)
}

/// What an element is drawn on.
#[derive(Clone)]
struct Ground {
    map: Affine,
    style: Style,
    layer: Arc<str>,
    /// The names of the elements around, and of the element itself.
    names: Arc<[Arc<str>]>,
    /// Whether it is, or is within, the element that was asked for.
    is_chosen: bool,
    depth: usize,
}

struct Walk<'d, 'i> {
    document: &'d Document<'i>,
    source: &'d Source,
    ids: HashMap<&'d str, Node<'d, 'i>>,
    sheet: Sheet,
    drawing: Drawing,
    count: usize,
}

impl<'d, 'i> Walk<'d, 'i> {
    fn children(&mut self, node: Node<'d, 'i>, ground: &Ground) -> Result<(), DrawingError> {
        for child in node.children().filter(Node::is_element) {
            self.element(child, ground)?;
        }
        Ok(())
    }

    fn element(&mut self, node: Node<'d, 'i>, outer: &Ground) -> Result<(), DrawingError> {
        self.count += 1;
        if self.count > MOST_ELEMENTS {
            let message = format!("more than {MOST_ELEMENTS} elements are drawn");
            return Err(DrawingError::file(
                message,
                "remove what is no outline, or split the drawing",
            ));
        }
        if outer.depth > DEEPEST {
            let message =
                format!("elements are nested or used in one another more than {DEEPEST} deep");
            return Err(DrawingError::File {
                line: Some(self.line(node)),
                message,
                help: "ungroup the drawing, and check what `use` elements refer to".to_owned(),
            });
        }
        let name = node.tag_name().name();
        let mut ground = Ground {
            style: self.sheet.style(node, &outer.style),
            depth: outer.depth + 1,
            ..outer.clone()
        };
        if let Some(id) = node.attribute("id").filter(|id| is_name(id, name)) {
            let id = Arc::from(id);
            ground.names = ground.names.iter().cloned().chain([id]).collect();
        }
        ground.is_chosen |= node.attribute("id") == self.source.id.as_deref();
        if let Some(text) = node.attribute("transform") {
            match transform(text) {
                Ok(map) => ground.map = ground.map.after(&map),
                Err(reason) => {
                    let help = "export the drawing again, or remove the transform";
                    self.problem(
                        node,
                        &ground,
                        format!("its transform cannot be read: {reason}"),
                        help,
                    );
                    return Ok(());
                }
            }
        }
        match name {
            "g" | "a" | "switch" => {
                let is_layer = node.attribute((INKSCAPE, "groupmode")) == Some("layer");
                if let Some(label) = node.attribute((INKSCAPE, "label")).filter(|_| is_layer) {
                    ground.layer = Arc::from(label);
                }
                if !ground.style.is_absent {
                    return self.children(node, &ground);
                }
                self.ignore(node, &ground, "it is not displayed");
            }
            "svg" => {
                ground.map = ground.map.after(&frame(node, None));
                return self.children(node, &ground);
            }
            "use" => return self.used(node, &ground),
            "text" | "image" | "foreignObject" => {
                let reason = if name == "text" {
                    "a text"
                } else {
                    "no outline"
                };
                self.ignore(node, &ground, reason);
            }
            _ => self.drawn(node, &ground),
        }
        Ok(())
    }

    /// A shape, if it is one. What defines, describes or moves others is none.
    fn drawn(&mut self, node: Node<'d, 'i>, ground: &Ground) {
        let Some(paths) = shape(node, ground.style.is_filled) else {
            return;
        };
        let style = &ground.style;
        let left_out = if !ground.is_chosen {
            Some("it is not the element asked for")
        } else if style.is_absent {
            Some("it is not displayed")
        } else if style.is_hidden {
            Some("it is hidden")
        } else if !style.is_filled && !style.is_stroked {
            Some("it has neither fill nor stroke")
        } else if !self.source.layers.is_empty()
            && !self.source.layers.iter().any(|l| **l == *ground.layer)
        {
            Some("its layer was not asked for")
        } else {
            None
        };
        if let Some(reason) = left_out {
            self.ignore(node, ground, reason);
            return;
        }
        if !ground.map.is_usable() {
            let reason = "its transform leaves no area, or is beyond computing".to_owned();
            self.problem(node, ground, reason, "give it a transform of ordinary size");
            return;
        }
        let origin = self.origin(node, ground);
        match paths {
            Ok(paths) if paths.iter().all(|p| p.pieces.is_empty()) => {
                self.ignore(node, ground, "it draws nothing");
            }
            Ok(paths) => {
                for path in paths {
                    self.drawing.entities.push(Entity {
                        origin: origin.clone(),
                        path: path.mapped(&ground.map),
                    });
                }
            }
            Err(reason) => self.problem(
                node,
                ground,
                reason,
                "export the drawing again, or mend the element",
            ),
        }
    }

    /// What a `use` refers to, moved.
    fn used(&mut self, node: Node<'d, 'i>, ground: &Ground) -> Result<(), DrawingError> {
        let reference = node
            .attribute("href")
            .or_else(|| node.attribute((XLINK, "href")));
        let id = reference.and_then(|r| r.trim().strip_prefix('#'));
        let Some(&target) = id.and_then(|id| self.ids.get(id)) else {
            let shown: String = reference.unwrap_or_default().chars().take(60).collect();
            let reason = format!("it uses {shown:?}, which is not in the file");
            self.problem(
                node,
                ground,
                reason,
                "export the drawing with all that it uses",
            );
            return Ok(());
        };
        if node.ancestors().any(|a| a == target) {
            let reason = "it uses an element that it is in".to_owned();
            self.problem(node, ground, reason, "remove the `use` element");
            return Ok(());
        }
        let offset = |name| node.attribute(name).and_then(user_units).unwrap_or(0.0);
        let mut inner = ground.clone();
        inner.map = inner.map.after(&Affine {
            origin: Point::new(offset("x"), offset("y")),
            ..Affine::IDENTITY
        });
        if target.tag_name().name() == "symbol" {
            inner.map = inner.map.after(&frame(target, Some(node)));
            inner.style = self.sheet.style(target, &inner.style);
            inner.depth += 1;
            return self.children(target, &inner);
        }
        self.element(target, &inner)
    }

    fn origin(&self, node: Node<'_, '_>, ground: &Ground) -> Origin {
        Origin {
            kind: Arc::from(node.tag_name().name()),
            layer: Arc::clone(&ground.layer),
            handle: Arc::from(node.attribute("id").unwrap_or_default()),
            blocks: Arc::clone(&ground.names),
            line: self.line(node),
        }
    }

    fn line(&self, node: Node<'_, '_>) -> usize {
        self.document.text_pos_at(node.range().start).row as usize
    }

    fn ignore(&mut self, node: Node<'_, '_>, ground: &Ground, reason: &'static str) {
        let origin = self.origin(node, ground);
        self.drawing.ignored.push(Ignored {
            origin,
            reason: reason.into(),
        });
    }

    fn problem(&mut self, node: Node<'_, '_>, ground: &Ground, reason: String, help: &str) {
        let origin = self.origin(node, ground);
        if ground.is_chosen {
            self.drawing.problems.push(Problem {
                origin,
                with: Vec::new(),
                at: None,
                to: None,
                reason,
                help: help.to_owned(),
            });
        }
    }
}

/// Whether an id is a name that somebody gave: programs make theirs of the type and a number, `path123` or `rect3-5`.
fn is_name(id: &str, kind: &str) -> bool {
    let rest = id.strip_prefix(kind).unwrap_or(id);
    let rest = rest.strip_prefix("layer").unwrap_or(rest);
    rest.chars().any(char::is_alphabetic)
}

/// The map of a frame of its own: its corner, and its view box fitted into its sides. A symbol's sides are those of the
/// element that uses it.
fn frame(node: Node<'_, '_>, used_by: Option<Node<'_, '_>>) -> Affine {
    let own = |name| node.attribute(name).and_then(user_units);
    let side = |name| {
        let by = used_by.and_then(|n| n.attribute(name)).and_then(user_units);
        by.or_else(|| own(name))
    };
    let corner = match used_by {
        None => Vector::new(own("x").unwrap_or(0.0), own("y").unwrap_or(0.0)),
        Some(_) => Vector::ZERO,
    };
    let view = node
        .attribute("viewBox")
        .and_then(|v| ViewBox::from_str(v).ok());
    let Some(view) = view.filter(|v| v.w > 0.0 && v.h > 0.0) else {
        return Affine {
            origin: Point::ORIGIN + corner,
            ..Affine::IDENTITY
        };
    };
    let (width, height) = (side("width"), side("height"));
    let scale = [width.map(|w| w / view.w), height.map(|h| h / view.h)]
        .into_iter()
        .flatten()
        .fold(f64::INFINITY, f64::min);
    let scale = if scale.is_finite() && scale > 0.0 {
        scale
    } else {
        1.0
    };
    // In the middle of its frame, unless that is said otherwise, which outlines do not ask for.
    let rest = |side: Option<f64>, own: f64| side.map_or(0.0, |s| (s - own * scale) / 2.0);
    Affine {
        x: Vector::new(scale, 0.0),
        y: Vector::new(0.0, scale),
        origin: Point::new(
            corner.x + rest(width, view.w) - view.x * scale,
            corner.y + rest(height, view.h) - view.y * scale,
        ),
    }
}

fn transform(text: &str) -> Result<Affine, String> {
    let t = Transform::from_str(text).map_err(|e| e.to_string())?;
    Ok(Affine {
        x: Vector::new(t.a, t.b),
        y: Vector::new(t.c, t.d),
        origin: Point::new(t.e, t.f),
    })
}
