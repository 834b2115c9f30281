//! Markdown as HTML, with links to where things are on the site.

use std::collections::BTreeSet;

use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, TagEnd, html};

/// Extensions of Markdown that GitHub renders, as far as they are text.
const WRITTEN: Options = (Options::ENABLE_TABLES)
    .union(Options::ENABLE_STRIKETHROUGH)
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_TASKLISTS);

/// The use of an address in a document: as the target of a link, or as the source of an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    Link,
    Image,
}

/// The first heading of the first level, as text.
pub(super) fn title(markdown: &str) -> Option<String> {
    let mut events = Parser::new_ext(markdown, WRITTEN);
    let level = |event: &Event<'_>| matches!(event, Event::Start(Tag::Heading { level, .. }) if *level as usize == 1);
    events.find(level)?;
    let heading = events.take_while(|e| !matches!(e, Event::End(TagEnd::Heading(_))));
    Some(heading.map(|e| plain(&e).to_owned()).collect())
}

/// The document as HTML. `lead` says where a link or an image leads; where it does not know, the text of the link remains, or what the
/// image is called. Headings are named as on GitHub, so that links find them. HTML in the document is shown as text.
pub(super) fn body(markdown: &str, lead: &mut dyn FnMut(&str, Use) -> Option<String>) -> String {
    let mut events: Vec<Event<'_>> = Vec::new();
    let mut names = BTreeSet::new();
    // Where the heading began that is not ended yet, and which links are kept, the outermost first.
    let mut heading = None;
    let mut kept = Vec::new();
    for mut event in Parser::new_ext(markdown, WRITTEN) {
        let led = match &mut event {
            Event::Start(Tag::Link { dest_url, .. }) => Some((dest_url, Use::Link)),
            Event::Start(Tag::Image { dest_url, .. }) => Some((dest_url, Use::Image)),
            _ => None,
        };
        if let Some((address, what)) = led {
            let place = lead(address, what);
            kept.push(place.is_some());
            let Some(place) = place else { continue };
            *address = place.into();
        }
        match &event {
            Event::End(TagEnd::Link | TagEnd::Image) if kept.pop() == Some(false) => continue,
            Event::Html(html) | Event::InlineHtml(html) => {
                if !html.trim_start().starts_with("<!--") {
                    events.push(Event::Text(html.clone()));
                }
                continue;
            }
            Event::Start(Tag::Heading { .. }) => heading = Some(events.len()),
            Event::End(TagEnd::Heading(_)) => {
                if let Some(begin) = heading.take() {
                    let text: String = events[begin..].iter().map(plain).collect();
                    if let Event::Start(Tag::Heading { id, .. }) = &mut events[begin] {
                        *id = Some(anchor(&text, &mut names));
                    }
                }
            }
            _ => {}
        }
        events.push(event);
    }
    let mut out = String::new();
    html::push_html(&mut out, events.into_iter());
    out
}

fn plain<'a>(event: &'a Event<'_>) -> &'a str {
    match event {
        Event::Text(text) | Event::Code(text) => text,
        Event::SoftBreak | Event::HardBreak => " ",
        _ => "",
    }
}

/// The anchor that GitHub gives a heading of this text; for repeated texts the second anchor ends in `-1`.
fn anchor(text: &str, names: &mut BTreeSet<String>) -> CowStr<'static> {
    let name: String = (text.trim().to_lowercase().chars())
        .filter(|c| c.is_alphanumeric() || "-_ ".contains(*c))
        .map(|c| if c == ' ' { '-' } else { c })
        .collect();
    let mut unique = name.clone();
    let mut number = 0;
    while !names.insert(unique.clone()) {
        number += 1;
        unique = format!("{name}-{number}");
    }
    unique.into()
}
