//! The frame of those pages of a site that are not models': the gallery and the documents.

use std::fmt::Write;

/// Text that HTML takes for nothing else, also within quotes.
pub(super) fn text(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            _ => out.push(c),
        }
    }
    out
}

/// A page of this name with the content `main`, and with links to the gallery and the documents.
pub(super) fn page(name: &str, title: &str, has_documents: bool, main: &str) -> String {
    let place = |to: &str| relative(name, to);
    let mut ways = format!(r#"<a href="{}">Models</a>"#, place("index.html"));
    if has_documents {
        let _ = write!(ways, r#" <a href="{}">Documents</a>"#, place(CONTENTS));
    }
    // The empty icon keeps browsers from asking for one.
    format!(
        r#"<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{}">
</head>
<body>
<nav>{ways}</nav>
<main>
{main}</main>
</body>
</html>
"#,
        text(title),
        place("style.css")
    )
}

/// The page that lists all documents.
pub(super) const CONTENTS: &str = "docs/index.html";

/// How a page leads to a file of the site: both are named from the site's folder.
pub(super) fn relative(page: &str, file: &str) -> String {
    let (mut from, mut to) = (page, file);
    while let (Some((a, rest_from)), Some((b, rest_to))) =
        (from.split_once('/'), to.split_once('/'))
    {
        if a != b {
            break;
        }
        (from, to) = (rest_from, rest_to);
    }
    format!("{}{to}", "../".repeat(from.matches('/').count()))
}
