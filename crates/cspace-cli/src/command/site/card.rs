//! The cards of the gallery, one for each model.

use std::path::Path;

use cspace::PairClass;
use cspace_draw::{Labels, PartsPicture, PictureFormat, PictureOptions, parts};

use super::sources::stem;
use crate::args::Common;
use crate::command::draw::{as_drawn, assembly, at_configuration};
use crate::failure::Failure;
use crate::subject::{Chosen, Subject};

/// Nobody reads more characters than that on a card.
const LONGEST: usize = 200;

/// A model in the gallery.
#[derive(Debug)]
pub(super) struct Card {
    pub(super) name: String,
    /// A description of the model in one line.
    pub(super) line: String,
    /// The classes of its pairs, and how many pairs have each.
    pub(super) classes: Vec<(PairClass, usize)>,
    /// The names of files: its page, and the picture of its parts.
    pub(super) page: String,
    pub(super) picture: String,
}

impl Card {
    /// The card of a model with a page of this name, and the picture of its parts.
    pub(super) fn of(common: &Common, page: &str) -> Result<(Self, Vec<u8>), Failure> {
        let subject = Subject::open(common)?;
        let chosen = subject.pairs(common, None)?;
        let drawn = drawn(&subject, &chosen);
        let options = PictureOptions {
            unit: subject.unit().map(str::to_owned),
            labels: Labels::None,
            ..PictureOptions::default()
        };
        let picture = (PictureFormat::Svg)
            .write(&parts(&drawn, &options))
            .map_err(Failure::new)?;
        let named = || {
            let names: Vec<&str> = drawn.parts.iter().map(|p| p.part.name()).collect();
            names.join(", ")
        };
        let name = subject.name().filter(|name| !name.trim().is_empty());
        let card = Self {
            name: name.map_or_else(|| stem(&common.file), str::to_owned),
            line: first_words(&comment(&common.file).unwrap_or_else(named)),
            classes: classes(&chosen),
            page: page.to_owned(),
            picture: Path::new(page)
                .with_extension("svg")
                .to_string_lossy()
                .into_owned(),
        };
        Ok((card, picture))
    }
}

/// The parts of a model as they are drawn; of a saved space its two parts.
fn drawn<'a>(subject: &'a Subject, chosen: &'a [Chosen<'a>]) -> PartsPicture<'a> {
    match (subject, chosen) {
        (Subject::Saved(_), [pair, ..]) => at_configuration(pair, as_drawn(pair)),
        (Subject::Model { model, .. }, _) => assembly(model),
        _ => PartsPicture::default(),
    }
}

fn classes(chosen: &[Chosen<'_>]) -> Vec<(PairClass, usize)> {
    let mut classes: Vec<(PairClass, usize)> = Vec::new();
    for class in chosen.iter().map(Chosen::class_in_full) {
        match classes.iter_mut().find(|(known, _)| *known == class) {
            Some((_, count)) => *count += 1,
            None => classes.push((class, 1)),
        }
    }
    classes
}

/// The first paragraph of the comment that a TOML file begins with.
fn comment(file: &Path) -> Option<String> {
    let text = std::fs::read_to_string(file).ok()?;
    let lines = text.lines().map_while(|line| line.strip_prefix('#'));
    let paragraph: Vec<&str> = lines
        .map(str::trim)
        .skip_while(|line| line.is_empty())
        .take_while(|line| !line.is_empty())
        .collect();
    (!paragraph.is_empty()).then(|| paragraph.join(" "))
}

/// The text, or as many of its first words as a card has room for.
fn first_words(text: &str) -> String {
    let Some((end, _)) = text.char_indices().nth(LONGEST) else {
        return text.to_owned();
    };
    let words = text[..end].rsplit_once(' ').map_or(&text[..end], |w| w.0);
    format!("{words} …")
}
