//! Relevant styles of an element: whether it is drawn at all, and whether a style moves it.

use roxmltree::{Document, Node};

use crate::color::Color;

/// Rules of the style sheets in a file.
#[derive(Default)]
pub(super) struct Sheet {
    rules: Vec<(Selector, Vec<(String, String)>)>,
    /// Selectors that are not followed, of rules that say how or whether something is drawn.
    pub(super) unfollowed: Vec<String>,
}

/// The elements that a rule is of: of a type, of an id and of classes.
#[derive(Default)]
struct Selector {
    kind: Option<String>,
    ids: Vec<String>,
    classes: Vec<String>,
}

impl Selector {
    /// Reads `type`, `.class`, `#id`, `*` and what is of several of them, as `path.cut`; none of any other.
    fn of(text: &str) -> Option<Self> {
        let is_mark = |c: char| matches!(c, '.' | '#');
        let is_name = |name: &str| {
            let fits = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_');
            !name.is_empty() && name.chars().all(fits)
        };
        let (kind, mut rest) = text.split_at(text.find(is_mark).unwrap_or(text.len()));
        let mut selector = Self::default();
        match kind {
            "" | "*" => {}
            kind if is_name(kind) => selector.kind = Some(kind.to_owned()),
            _ => return None,
        }
        while let Some(mark) = rest.chars().next() {
            let end = rest[1..].find(is_mark).map_or(rest.len(), |at| at + 1);
            let name = &rest[1..end];
            if !is_name(name) {
                return None;
            }
            match mark {
                '.' => selector.classes.push(name.to_owned()),
                _ => selector.ids.push(name.to_owned()),
            }
            rest = &rest[end..];
        }
        (!text.is_empty()).then_some(selector)
    }

    fn selects(&self, node: Node<'_, '_>) -> bool {
        let classes = node.attribute("class").unwrap_or_default();
        let has = |class: &String| classes.split_whitespace().any(|c| c == class);
        let is_kind = |kind: &String| node.tag_name().name() == kind;
        self.kind.as_ref().is_none_or(is_kind)
            && self.ids.iter().all(|id| node.attribute("id") == Some(id))
            && self.classes.iter().all(has)
    }

    /// How much it says: ids count more than classes, and these more than types.
    fn weight(&self) -> [usize; 3] {
        let kinds = usize::from(self.kind.is_some());
        [self.ids.len(), self.classes.len(), kinds]
    }
}

/// A style sheet without its comments.
fn without_comments(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, comment)) = rest.split_once("/*") {
        plain += before;
        plain.push(' ');
        rest = comment.split_once("*/").map_or("", |c| c.1);
    }
    plain + rest
}

/// Whether a property says how or whether something is drawn.
fn is_style(name: &str) -> bool {
    STYLES.contains(&name) || matches!(name, "transform" | "translate" | "rotate" | "scale")
}

/// Style of an element, from its own attributes and those of the elements around it.
#[derive(Debug, Clone)]
pub(super) struct Style {
    pub(super) is_filled: bool,
    pub(super) is_stroked: bool,
    pub(super) is_hidden: bool,
    /// Whether neither the element nor its content is drawn.
    pub(super) is_absent: bool,
    /// Whether a style moves the element, as its attribute `transform` would.
    pub(super) moves: bool,
    /// Whether loops within one another fill by the rule *evenodd*, and not by *nonzero*.
    pub(super) is_even_odd: bool,
    pub(super) fill: Option<Color>,
    pub(super) stroke: Option<Color>,
    /// Property of the element, or of one around it, that is not followed.
    pub(super) unfollowed: Option<&'static str>,
}

impl Default for Style {
    /// Default style: filled.
    fn default() -> Self {
        Self {
            is_filled: true,
            is_stroked: false,
            is_hidden: false,
            is_absent: false,
            moves: false,
            is_even_odd: false,
            fill: Color::of_svg("black"),
            stroke: None,
            unfollowed: None,
        }
    }
}

/// The attributes that are styles too.
const STYLES: [&str; 7] = [
    "fill",
    "fill-rule",
    "stroke",
    "display",
    "visibility",
    "clip-path",
    "mask",
];

impl Sheet {
    /// Collects the rules of all `style` elements. Selectors of one type, and of any classes and ids, are followed.
    pub(super) fn of(document: &Document<'_>) -> Self {
        let mut sheet = Self::default();
        let styles = document
            .descendants()
            .filter(|n| n.tag_name().name() == "style");
        for text in styles.filter_map(|n| n.text()) {
            let text = without_comments(text);
            for rule in text.split('}') {
                let Some((selectors, body)) = rule.split_once('{') else {
                    continue;
                };
                for selector in selectors.split(',') {
                    let rules = declarations(body).map(|(k, v)| (k.to_owned(), v.to_owned()));
                    let selector = selector.trim();
                    match Selector::of(selector) {
                        Some(of) => sheet.rules.push((of, rules.collect())),
                        None if declarations(body).any(|d| is_style(d.0)) => {
                            sheet.unfollowed.push(selector.to_owned());
                        }
                        None => {}
                    }
                }
            }
        }
        sheet
    }

    /// Style of an element within a surrounding style. Declarations nearer to the element come last, and win.
    pub(super) fn style(&self, node: Node<'_, '_>, outer: &Style) -> Style {
        let mut style = Style {
            moves: false,
            ..outer.clone()
        };
        for name in STYLES {
            if let Some(value) = node.attribute(name) {
                style.set(name, value);
            }
        }
        let mut rules: Vec<_> = self.rules.iter().filter(|r| r.0.selects(node)).collect();
        // Of two the one that says more; of equal ones the later.
        rules.sort_by_key(|r| r.0.weight());
        for (name, value) in rules.iter().flat_map(|r| &r.1) {
            style.set(name, value);
        }
        for (name, value) in declarations(node.attribute("style").unwrap_or_default()) {
            style.set(name, value);
        }
        style
    }
}

impl Style {
    fn set(&mut self, name: &str, value: &str) {
        let is_some = !matches!(value, "none" | "transparent");
        match name {
            "fill" if value != "inherit" => {
                self.is_filled = is_some;
                self.fill = Color::of_svg(value);
            }
            "fill-rule" if value != "inherit" => self.is_even_odd = value == "evenodd",
            "stroke" if value != "inherit" => {
                self.is_stroked = is_some;
                self.stroke = Color::of_svg(value);
            }
            "clip-path" if is_some => {
                self.unfollowed = Some("its clip path is not followed: all of it is read");
            }
            "mask" if is_some => {
                self.unfollowed = Some("its mask is not followed: all of it is read");
            }
            "visibility" if value != "inherit" => self.is_hidden = value != "visible",
            "transform" | "translate" | "rotate" | "scale" => self.moves = is_some,
            "display" if value == "none" => self.is_absent = true,
            _ => {}
        }
    }
}

fn declarations(text: &str) -> impl Iterator<Item = (&str, &str)> {
    (text.split(';'))
        .filter_map(|d| d.split_once(':'))
        .map(|(name, value)| {
            (
                name.trim(),
                value.trim().trim_end_matches("!important").trim(),
            )
        })
}
