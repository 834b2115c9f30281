//! The documents of a site, made of a folder of Markdown files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::html::{self, CONTENTS, relative};
use super::markdown::{self, Use};
use super::names::Names;
use super::sources::{files_below, stem, unreadable};
use crate::failure::Failure;
use crate::output::Folder;

/// Files that become pages.
pub(super) struct Documents {
    /// The folder, and that in which it and its README are: what is elsewhere is not of the documents.
    folder: PathBuf,
    around: PathBuf,
    documents: Vec<Document>,
}

struct Document {
    file: PathBuf,
    text: String,
    title: String,
    /// The name of its page.
    page: String,
}

impl Documents {
    /// All Markdown files of a folder, and the README beside the folder.
    pub(super) fn find(folder: &Path, names: &mut Names) -> Result<Self, Failure> {
        let known = folder.canonicalize().map_err(|e| unreadable(folder, &e))?;
        if !known.is_dir() {
            return Err(
                Failure::new(format_args!("{}: is no folder", folder.display()))
                    .help("give a folder of .md files after --docs; nothing was written"),
            );
        }
        let around = known.parent().unwrap_or(&known).to_owned();
        names.take("docs/index", ".html");
        let mut documents = Vec::new();
        let readme = around.join("README.md");
        if readme.is_file() {
            documents.push(Document::read(readme, "README.html".to_owned())?);
        }
        for file in files_below(&known, "md")? {
            let name = format!("docs/{}", below(&file.with_extension(""), &known));
            documents.push(Document::read(file, names.take(&name, ".html"))?);
        }
        if documents.is_empty() {
            return Err(Failure::new(format_args!(
                "{}: there is no .md file in the folder",
                folder.display()
            ))
            .help("give another folder after --docs, or leave --docs out; nothing was written"));
        }
        Ok(Self {
            folder: known,
            around,
            documents,
        })
    }

    /// Writes the pages, and what is copied for them. `pages` are the models' pages by their files.
    pub(super) fn write(
        &self,
        mut pages: BTreeMap<PathBuf, String>,
        names: &mut Names,
        to: &mut Folder,
    ) -> Result<(), Failure> {
        for document in &self.documents {
            let file = document.file.canonicalize();
            pages.extend(file.map(|file| (file, document.page.clone())));
        }
        for document in &self.documents {
            let mut failed = None;
            let mut lead = |address: &str, what: Use| {
                let led = self.lead(document, address, what, (&mut pages, names, to));
                led.unwrap_or_else(|failure| {
                    failed = Some(failure);
                    None
                })
            };
            let body = markdown::body(&document.text, &mut lead);
            if let Some(failure) = failed {
                return Err(failure);
            }
            let main = format!("<article>\n{body}</article>\n");
            let page = html::page(&document.page, &document.title, true, &main);
            to.write(&document.page, page.as_bytes())?;
        }
        let list: String = (self.documents.iter())
            .map(|d| {
                let place = relative(CONTENTS, &d.page);
                format!(
                    "<li><a href=\"{place}\">{}</a></li>\n",
                    html::text(&d.title)
                )
            })
            .collect();
        let main = format!("<h1>Documents</h1>\n<ul>\n{list}</ul>\n");
        let contents = html::page(CONTENTS, "Documents", true, &main);
        to.write(CONTENTS, contents.as_bytes())
    }

    /// Where an address in a document leads on the site. What is not there yet is copied if it is of the documents; nowhere lead
    /// addresses of anything else on the disk, and of images elsewhere.
    fn lead(
        &self,
        from: &Document,
        address: &str,
        what: Use,
        (pages, names, to): (&mut BTreeMap<PathBuf, String>, &mut Names, &mut Folder),
    ) -> Result<Option<String>, Failure> {
        if let Some((scheme, _)) = address.split_once(':')
            && scheme
                .chars()
                .all(|c| c.is_ascii_alphanumeric() || "+-.".contains(c))
        {
            let is_fine = ["http", "https", "mailto"].contains(&&*scheme.to_ascii_lowercase());
            return Ok((is_fine && what == Use::Link).then(|| address.to_owned()));
        }
        if address.starts_with("//") {
            return Ok(None);
        }
        if address.starts_with('#') {
            return Ok(Some(address.to_owned()));
        }
        let (path, anchor) = match address.split_once('#') {
            Some((path, anchor)) => (path, format!("#{anchor}")),
            None => (address, String::new()),
        };
        let beside = from.file.parent().unwrap_or(&self.folder);
        let Ok(file) = beside.join(&*decoded(path)).canonicalize() else {
            return Ok(None);
        };
        let place = match pages.get(&file) {
            Some(place) => place.clone(),
            None => {
                let home = if file.starts_with(&self.folder) {
                    ("docs", &self.folder)
                } else if what == Use::Image && file.starts_with(&self.around) {
                    ("docs/beside", &self.around)
                } else {
                    return Ok(None);
                };
                if !file.is_file() {
                    return Ok(None);
                }
                let extension = (file.extension())
                    .map_or(String::new(), |e| format!(".{}", e.to_string_lossy()));
                let name = format!("{}/{}", home.0, below(&file.with_extension(""), home.1));
                let place = names.take(&name, &extension);
                to.copy(&place, &file)?;
                pages.insert(file, place.clone());
                place
            }
        };
        Ok(Some(format!("{}{anchor}", relative(&from.page, &place))))
    }
}

impl Document {
    fn read(file: PathBuf, page: String) -> Result<Self, Failure> {
        let text = std::fs::read_to_string(&file).map_err(|e| unreadable(&file, &e))?;
        let title = markdown::title(&text).unwrap_or_else(|| stem(&file));
        Ok(Self {
            file,
            text,
            title,
            page,
        })
    }
}

/// A path from a folder that it is in, with `/` between.
fn below(path: &Path, folder: &Path) -> String {
    let parts = path.strip_prefix(folder).unwrap_or(path).components();
    let names: Vec<_> = parts.map(|c| c.as_os_str().to_string_lossy()).collect();
    names.join("/")
}

/// The path of an address in which `%20` stands for a space, and so on.
fn decoded(path: &str) -> String {
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let [first, tail @ ..] = rest {
        let digit = |at: usize| tail.get(at).and_then(|c| char::from(*c).to_digit(16));
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.extend(u8::try_from(16 * high + low));
                rest = &tail[2..];
            }
            _ => {
                bytes.push(*first);
                rest = tail;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
