//! `cspace site`.

mod card;
mod documents;
mod html;
mod index;
mod markdown;
mod names;
mod sources;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::path::PathBuf;

use cspace_view::Page;

use super::page;
use crate::args::{Common, SiteArgs};
use crate::failure::Failure;
use crate::interrupt::{self, catch_interrupts};
use crate::output::Folder;
use crate::progress::Steps;
use crate::template::Template;
use card::Card;
use documents::Documents;
use names::Names;
use sources::Source;

const STYLE: &str = include_str!("style.css");

/// The model of `cspace new` that the playground begins with.
const PLAYGROUND: &str = "peg";

pub(crate) fn run(args: &SiteArgs) -> Result<(), Failure> {
    catch_interrupts();
    let site = Site::begin(args)?;
    let page = page::bundled(Page::bundled())?;
    site.write(&|common| page::file(&page, common, None, &[]))
}

/// Makes the page of a model.
type MakePage<'a> = &'a dyn Fn(&Common) -> Result<Vec<u8>, Failure>;

/// The contents of a site: models, playground and documents, with the folder to write and the names taken in it.
struct Site<'a> {
    args: &'a SiteArgs,
    sources: Vec<Source>,
    playground: Source,
    documents: Option<Documents>,
    folder: Folder,
    names: Names,
}

impl<'a> Site<'a> {
    /// Finds all that the site is to show, before anything is computed.
    fn begin(args: &'a SiteArgs) -> Result<Self, Failure> {
        let sources = sources::find(&args.models)?;
        let mut names = Names::default();
        for taken in ["index", "README"] {
            names.take(taken, ".html");
        }
        let docs = args.docs.as_deref();
        let documents = docs
            .map(|docs| Documents::find(docs, &mut names))
            .transpose()?;
        let playground = Template::named(PLAYGROUND)
            .ok_or_else(|| Failure::work("there is no model to begin with"))?;
        Ok(Self {
            args,
            sources,
            playground: Source::template("playground", playground),
            documents,
            folder: Folder::begin(&args.output)?,
            names,
        })
    }

    /// Writes all of it.
    fn write(self, page: MakePage<'_>) -> Result<(), Failure> {
        let Self {
            args,
            sources,
            playground,
            documents,
            mut folder,
            mut names,
        } = self;
        let steps = Steps::new(sources.len() + 1);
        let blank = names.take(&playground.stem(), ".html");
        let (mut cards, mut pages) = (Vec::new(), BTreeMap::new());
        for source in &sources {
            let name = names.take(&source.stem(), ".html");
            let added = steps.step(&source.stem(), || {
                add(source, &name, args, page, &mut folder)
            });
            match added {
                Ok((card, file)) => {
                    cards.push(card);
                    pages.extend(file.canonicalize().map(|file| (file, name)));
                }
                Err(failure) if interrupt::is_interrupted() => return Err(failure),
                Err(failure) => failure.warn(),
            }
        }
        if cards.is_empty() {
            return Err(Failure::work(format_args!(
                "{}: not one model could be computed",
                folder.place().display()
            ))
            .help("`cspace compute MODEL` shows why; nothing was written"));
        }
        let (blank, _) = steps.step("playground", || {
            add(&playground, &blank, args, page, &mut folder)
        })?;
        let index = index::page(&cards, &blank, documents.is_some());
        folder.write("index.html", index.as_bytes())?;
        folder.write("style.css", STYLE.as_bytes())?;
        if let Some(documents) = documents {
            documents.write(pages, &mut names, &mut folder)?;
        }
        folder.finish()
    }
}

/// Writes the page of a model under a name, and its picture; its card, and the file that was read.
fn add(
    source: &Source,
    name: &str,
    args: &SiteArgs,
    page: MakePage<'_>,
    folder: &mut Folder,
) -> Result<(Card, PathBuf), Failure> {
    let file = match source {
        Source::File(file) => file.clone(),
        Source::Text(stem, text) => folder.lay_aside(&format!("{stem}.toml"), text.as_bytes())?,
    };
    let common = args.common(file);
    let (card, picture) = Card::of(&common, name)?;
    let bytes = page(&common)?;
    folder.write(name, &bytes)?;
    folder.write(&card.picture, &picture)?;
    Ok((card, common.file))
}
