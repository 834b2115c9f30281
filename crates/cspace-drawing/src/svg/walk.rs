//! The elements of an SVG file in document order, each with its transform.

use std::collections::HashMap;
use std::str::FromStr;
use std::sync::Arc;

use cspace::part::Bounds;
use cspace::{Point, Vector};
use roxmltree::{Document, Node};
use svgtypes::{Transform, ViewBox};

use super::fill::bounds;
use super::frame::{frame, page};
use super::length::View;
use super::shapes::shape;
use super::style::{Sheet, Style};
use super::xml::{INKSCAPE, XLINK};
use crate::affine::Affine;
use crate::drawing::{Drawing, Ignored, Origin, Problem};
use crate::error::DrawingError;
use crate::source::{OTHER_COLOR, Source};

/// The most elements that are drawn, those that are used again included.
const MOST_ELEMENTS: usize = 2_000_000;

/// The deepest that elements are nested or used in one another.
const DEEPEST: usize = 200;

/// Why a loop of a path is left out.
const INSIDE: &str = "a loop inside of what its path fills: by its fill-rule it is no hole";

/// Advice for an element that cannot be read.
const MEND: &str = "export the drawing again, or mend the element";

pub(super) fn walk(document: &Document<'_>, source: &Source) -> Result<Drawing, DrawingError> {
    let root = document.root_element();
    let (map, unit, view) = page(root);
    let ids: HashMap<&str, Node<'_, '_>> = (document.descendants())
        .filter_map(|n| Some((n.attribute("id")?, n)))
        .collect();
    if let Some(id) = source.ids.iter().find(|id| !ids.contains_key(id.as_str())) {
        let message = format!("no element has the id {id:?}");
        return Err(DrawingError::file(
            message,
            "check the id; ids are case-sensitive",
        ));
    }
    let breaks = document.input_text().match_indices('\n');
    let mut walk = Walk {
        lines: breaks.map(|(at, _)| at + 1).collect(),
        source,
        ids,
        sheet: Sheet::of(document),
        drawing: Drawing {
            unit,
            page: paper(root, &map, view),
            ..Drawing::default()
        },
        count: 0,
    };
    let ground = Ground {
        map,
        view,
        style: walk.sheet.style(root, &Style::default()),
        layer: Arc::from(""),
        names: Arc::from([]),
        is_chosen: source.ids.is_empty(),
        depth: 0,
    };
    for selector in core::mem::take(&mut walk.sheet.unfollowed) {
        let shown: String = selector.chars().take(60).collect();
        walk.drawing.unfollowed.push(Ignored {
            origin: Origin {
                kind: Arc::from("style"),
                ..Origin::default()
            },
            reason: format!("its rule for {shown:?} is not followed").into(),
        });
    }
    walk.children(root, &ground)?;
    Ok(walk.drawing)
}

/// Drawing context of an element.
#[derive(Clone)]
struct Ground {
    map: Affine,
    /// View that percentages refer to.
    view: View,
    style: Style,
    layer: Arc<str>,
    /// The names of the elements around, and of the element itself.
    names: Arc<[Arc<str>]>,
    /// Whether the element is, or is within, the requested one.
    is_chosen: bool,
    depth: usize,
}

struct Walk<'d, 'i> {
    /// Offsets of the lines in the file.
    lines: Vec<usize>,
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
        ground.is_chosen |= node
            .attribute("id")
            .is_some_and(|id| self.source.ids.iter().any(|i| i == id));
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
        if ground.style.moves {
            self.problem(
                node,
                &ground,
                "it is moved by a style sheet, which is not followed".to_owned(),
                "give it a transform attribute, or export the drawing as plain SVG",
            );
            return Ok(());
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
                return self.framed(node, None, &ground);
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

    /// Adds an element that is a shape. Elements that define, describe or move others are ignored.
    fn drawn(&mut self, node: Node<'d, 'i>, ground: &Ground) {
        let Some(paths) = shape(node, ground.view, ground.style.is_filled) else {
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
        } else if !self.is_of_color(style) {
            Some(OTHER_COLOR)
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
                if let Some(what) = style.unfollowed {
                    self.drawing.unfollowed.push(Ignored {
                        origin: origin.clone(),
                        reason: what.into(),
                    });
                }
                let fills = style.is_filled && !style.is_even_odd && paths.len() > 1;
                let bounds = match fills {
                    true => bounds(&paths),
                    false => vec![true; paths.len()],
                };
                for (path, bounds) in paths.into_iter().zip(bounds) {
                    if !bounds {
                        self.ignore(node, ground, INSIDE);
                        continue;
                    }
                    self.drawing.add(origin.clone(), path.mapped(&ground.map));
                }
            }
            Err(reason) => self.problem(node, ground, reason, MEND),
        }
    }

    /// Whether a style has one of the colours asked for: of the stroke, or of the fill where there is no stroke.
    fn is_of_color(&self, style: &Style) -> bool {
        let own = match style.is_stroked {
            true => style.stroke,
            false => style.fill,
        };
        let asked = &self.source.colors;
        asked.is_empty() || asked.iter().any(|a| own.is_some_and(|own| a.is(own)))
    }

    /// Draws the target of a `use` element, moved.
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
        let offset = |name| Ok(ground.view.length(node, name)?.unwrap_or(0.0));
        let offset: Result<[f64; 2], String> = offset("x").and_then(|x| Ok([x, offset("y")?]));
        let [x, y] = match offset {
            Ok(offset) => offset,
            Err(reason) => {
                self.problem(node, ground, reason, MEND);
                return Ok(());
            }
        };
        let mut inner = ground.clone();
        inner.map = inner.map.after(&Affine {
            origin: Point::new(x, y),
            ..Affine::IDENTITY
        });
        if target.tag_name().name() == "symbol" {
            inner.style = self.sheet.style(target, &inner.style);
            inner.depth += 1;
            return self.framed(target, Some(node), &inner);
        }
        self.element(target, &inner)
    }

    /// The children of an element that is a frame of its own.
    fn framed(
        &mut self,
        node: Node<'d, 'i>,
        used_by: Option<Node<'d, 'i>>,
        ground: &Ground,
    ) -> Result<(), DrawingError> {
        match frame(node, used_by, ground.view) {
            Ok((map, view)) => {
                let inner = Ground {
                    map: ground.map.after(&map),
                    view,
                    ..ground.clone()
                };
                self.children(node, &inner)
            }
            Err(reason) => {
                self.problem(used_by.unwrap_or(node), ground, reason, MEND);
                Ok(())
            }
        }
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
        let at = node.range().start;
        1 + self.lines.partition_point(|&begin| begin <= at)
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

/// The page in the drawing's coordinates, where the file names its size.
fn paper(root: Node<'_, '_>, map: &Affine, view: View) -> Option<Bounds> {
    let given = root
        .attribute("viewBox")
        .and_then(|v| ViewBox::from_str(v).ok());
    let (x, y) = given.map_or((0.0, 0.0), |v| (v.x, v.y));
    let [near, far] = [(x, y), (x + view.width?, y + view.height?)].map(|p| map.point(p.into()));
    Some(Bounds::of(near, far))
}

/// Whether an id is a name given by a person: programs use the type and a number, `path123` or `rect3-5`.
fn is_name(id: &str, kind: &str) -> bool {
    let rest = id.strip_prefix(kind).unwrap_or(id);
    let rest = rest.strip_prefix("layer").unwrap_or(rest);
    rest.chars().any(char::is_alphabetic)
}

fn transform(text: &str) -> Result<Affine, String> {
    let t = Transform::from_str(text).map_err(|e| e.to_string())?;
    Ok(Affine {
        x: Vector::new(t.a, t.b),
        y: Vector::new(t.c, t.d),
        origin: Point::new(t.e, t.f),
    })
}
