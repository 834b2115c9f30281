//! Relevant styles of an element: whether it is drawn at all, and whether a style moves it.

use std::collections::HashMap;

use roxmltree::{Document, Node};

/// Rules of the style sheets in a file, by class (`.name`) or type of element (`name`).
#[derive(Default)]
pub(super) struct Sheet(HashMap<String, Vec<(String, String)>>);

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
        }
    }
}

impl Sheet {
    /// Collects the rules of all `style` elements. Only selectors of one class or one type are supported.
    pub(super) fn of(document: &Document<'_>) -> Self {
        let mut sheet = Self::default();
        let styles = document
            .descendants()
            .filter(|n| n.tag_name().name() == "style");
        for text in styles.filter_map(|n| n.text()) {
            for rule in text.split('}') {
                let Some((selectors, body)) = rule.split_once('{') else {
                    continue;
                };
                for selector in selectors.split(',') {
                    let rules = sheet.0.entry(selector.trim().to_owned()).or_default();
                    rules.extend(declarations(body).map(|(k, v)| (k.to_owned(), v.to_owned())));
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
        for name in ["fill", "stroke", "display", "visibility"] {
            if let Some(value) = node.attribute(name) {
                style.set(name, value);
            }
        }
        if !self.0.is_empty() {
            let classes = node.attribute("class").unwrap_or_default();
            let classes = classes.split_whitespace().map(|c| format!(".{c}"));
            for selector in [node.tag_name().name().to_owned()]
                .into_iter()
                .chain(classes)
            {
                for (name, value) in self.0.get(&selector).into_iter().flatten() {
                    style.set(name, value);
                }
            }
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
            "fill" if value != "inherit" => self.is_filled = is_some,
            "stroke" if value != "inherit" => self.is_stroked = is_some,
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
