//! The gallery.

use super::card::Card;
use super::html;

/// The gallery's page: a card for each model, and one to start from blank.
pub(super) fn page(cards: &[Card], blank: &Card, has_documents: bool) -> String {
    let models: String = cards.iter().map(card).collect();
    let blank = Card {
        name: "Start from blank".to_owned(),
        line: "A peg and its hole, to be edited: drag vertices, add and remove them, and see what becomes free.".to_owned(),
        classes: Vec::new(),
        page: blank.page.clone(),
        picture: blank.picture.clone(),
    };
    let main = format!(
        "<h1>Models</h1>\n<p>Each has a page to drag its parts on, with its configuration spaces.</p>\n\
         <ul class=\"cards\">\n{models}{}</ul>\n",
        card(&blank)
    );
    html::page("index.html", "Models", has_documents, &main)
}

fn card(card: &Card) -> String {
    let count = |n: &usize| match n {
        1 => String::new(),
        n => format!(" × {n}"),
    };
    let classes: Vec<String> = (card.classes.iter())
        .map(|(class, n)| format!("<span>{class}{}</span>", count(n)))
        .collect();
    let classes = match classes.is_empty() {
        true => String::new(),
        false => format!("\n<p class=\"classes\">{}</p>", classes.join(" ")),
    };
    format!(
        "<li><a href=\"{}\"><img src=\"{}\" alt=\"\" loading=\"lazy\"><h2>{}</h2></a>\n<p>{}</p>{classes}</li>\n",
        card.page,
        card.picture,
        html::text(&card.name),
        html::text(&card.line)
    )
}
