//! The XML of a file, also of one that uses prefixes without declaring them, as what is cut out of another file does.

use roxmltree::{Document, Error, ParsingOptions};

/// The namespaces that the reader looks at, by the prefixes in use for them.
const KNOWN: [(&str, &str); 3] = [
    ("svg", "http://www.w3.org/2000/svg"),
    ("xlink", XLINK),
    ("inkscape", INKSCAPE),
];

pub(super) const XLINK: &str = "http://www.w3.org/1999/xlink";
pub(super) const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

/// The most prefixes that are declared for a file: programs add some, and each costs a look at all of the file.
const MOST: usize = 32;

/// Largest number of elements in a file, including those of its own entities.
const MOST_NODES: u32 = 4_000_000;

/// The document that a text is.
///
/// # Errors
/// Describes the error in the XML.
pub(super) fn parse(text: &str) -> Result<Document<'_>, Error> {
    // Some programs declare entities for their namespaces; the reader bounds what they expand to.
    let options = ParsingOptions {
        allow_dtd: true,
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options)
}

/// Declares in the root element every prefix that no element declares; `None` if there is none to declare. The numbers
/// of lines do not change.
pub(super) fn declared(text: &str) -> Option<String> {
    let at = after_root_name(text)?;
    let mut declarations = String::new();
    for _ in 0..MOST {
        let whole = [&text[..at], &declarations, &text[at..]].concat();
        match parse(&whole) {
            Err(Error::UnknownNamespace(prefix, _)) => {
                let known = KNOWN.iter().find(|k| k.0 == prefix);
                let name = known.map_or_else(|| format!("undeclared:{prefix}"), |k| k.1.to_owned());
                declarations += &format!(" xmlns:{prefix}=\"{name}\"");
            }
            _ if declarations.is_empty() => return None,
            _ => return Some(whole),
        }
    }
    None
}

/// The text with no hyphens in comments, of as many lines. A mark of a comment in a text of another kind (CDATA) is taken for one.
pub(super) fn with_plain_comments(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(begin) = rest.find("<!--") {
        let (before, comment) = rest.split_at(begin + 4);
        let end = comment.find("-->").unwrap_or(comment.len());
        plain += before;
        plain += &comment[..end].replace('-', " ");
        rest = &comment[end..];
    }
    plain + rest
}

/// The place after the name of the root element, past declarations, comments and a document type.
fn after_root_name(text: &str) -> Option<usize> {
    let mut rest = text;
    loop {
        rest = &rest[rest.find('<')?..];
        let length = if rest.starts_with("<?") {
            past(rest, "?>")
        } else if rest.starts_with("<!--") {
            past(rest, "-->")
        } else if rest.starts_with("<!") {
            document_type(rest)
        } else {
            let end = rest.find(|c: char| c.is_whitespace() || matches!(c, '/' | '>'))?;
            return Some(text.len() - rest.len() + end);
        };
        rest = &rest[length?..];
    }
}

fn past(text: &str, mark: &str) -> Option<usize> {
    Some(text.find(mark)? + mark.len())
}

/// The length of a document type, whose own declarations are in brackets. Texts in quotes and comments may have any character.
fn document_type(text: &str) -> Option<usize> {
    let mut at = 1;
    let mut depth = 0_usize;
    loop {
        let rest = &text[at..];
        let next = rest.find(['"', '\'', '[', ']', '>', '<'])?;
        let rest = &rest[next..];
        at += next
            + match rest.as_bytes()[0] {
                b'"' => 1 + past(&rest[1..], "\"")?,
                b'\'' => 1 + past(&rest[1..], "'")?,
                b'<' if rest.starts_with("<!--") => past(rest, "-->")?,
                b'>' if depth == 0 => return Some(at + next + 1),
                b'[' => {
                    depth += 1;
                    1
                }
                b']' => {
                    depth = depth.saturating_sub(1);
                    1
                }
                _ => 1,
            };
    }
}

#[cfg(test)]
mod tests {
    use super::after_root_name;

    #[test]
    fn the_root_is_found_past_whatever_is_before_it() {
        for (before, name) in [
            ("", "svg"),
            ("<?xml version=\"1.0\"?>\n", "svg"),
            ("<!-- <svg> -->", "svg:svg"),
            (
                "<!DOCTYPE svg [ <!ENTITY a \"]>\"> <!-- ' --> <!ENTITY b 'x'> ]>\n<!-- -->",
                "svg",
            ),
        ] {
            for after in [" width=\"1\"/>", "/>", ">", "\n>"] {
                let text = format!("{before}<{name}{after}");
                let expected = before.len() + 1 + name.len();
                assert_eq!(after_root_name(&text), Some(expected), "{text}");
            }
        }
        assert_eq!(
            ["", "no markup", "<svg", "<!DOCTYPE"].map(after_root_name),
            [None; 4]
        );
    }
}
