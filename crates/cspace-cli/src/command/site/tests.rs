//! A site whose models' pages are written by a stand-in, so that it is tested in programs without the page, too.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::*;

const PAGE: &str = "<!doctype html><title>a model</title>";

fn site(models: &[&Path], docs: Option<&Path>, output: &Path) -> Result<(), Failure> {
    let args = SiteArgs {
        cache: crate::args::CacheArgs { no_cache: true },
        models: models.iter().map(|m| m.to_path_buf()).collect(),
        output: output.to_owned(),
        docs: docs.map(Path::to_owned),
        threads: 0,
    };
    Site::begin(&args)?.write(&|common| {
        // The stand-in fails as the page does.
        crate::subject::Subject::open(common)?;
        Ok(PAGE.as_bytes().to_vec())
    })
}

fn write(file: PathBuf, text: &str) -> PathBuf {
    std::fs::create_dir_all(file.parent().unwrap()).unwrap();
    std::fs::write(&file, text).unwrap();
    file
}

fn read(file: PathBuf) -> String {
    std::fs::read_to_string(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display()))
}

/// All files of a folder, by their names below it.
fn files(folder: &Path, below: &str) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for entry in std::fs::read_dir(folder.join(below)).unwrap() {
        let entry = entry.unwrap();
        let name = format!("{below}{}", entry.file_name().to_str().unwrap());
        match entry.file_type().unwrap().is_dir() {
            true => all.extend(files(folder, &format!("{name}/"))),
            false => all.extend([name]),
        }
    }
    all
}

fn values<'a>(html: &'a str, before: &'a str) -> impl Iterator<Item = &'a str> {
    (html.split(before).skip(1)).map(|rest| rest.split_once('"').unwrap().0)
}

/// Asserts that every link of every page leads to a file of the site, and every anchor to a heading; returns the number of links.
#[track_caller]
fn all_links_lead(site: &Path) -> usize {
    let known = files(site, "");
    let mut count = 0;
    for page in known.iter().filter(|n| n.ends_with(".html")) {
        let html = read(site.join(page));
        for link in values(&html, "href=\"").chain(values(&html, "src=\"")) {
            if link.starts_with("http") || link == "data:," {
                continue;
            }
            count += 1;
            let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
            let mut place: Vec<&str> = page.split('/').collect();
            if !path.is_empty() {
                place.pop();
                for step in path.split('/') {
                    match step {
                        ".." => assert!(place.pop().is_some(), "{page}: {link} leads out"),
                        step => place.push(step),
                    }
                }
            }
            let place = place.join("/");
            assert!(known.contains(&place), "{page}: {link}: no {place}");
            if !anchor.is_empty() {
                let id = format!("id=\"{anchor}\"");
                assert!(read(site.join(place)).contains(&id), "{page}: {link}");
            }
        }
    }
    count
}

fn project(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(path)
}

const BLOCKS: &str = "# Two blocks.\n#\n# More.\nname = \"a < b\"\n[[part]]\nname = \"a\"\nloops = [[[0, 0], [2, 0], [2, 2], [0, 2]]]\n\
    [[part]]\nname = \"b\"\nloops = [[[3, 0], [4, 0], [4, 1], [3, 1]]]\n";

/// The project's own documents and models.
#[test]
fn every_link_leads_somewhere() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("site");
    let models = project("models");
    site(&[&models], Some(&project("docs")), &out).unwrap();
    let count = all_links_lead(&out);
    assert!(count > 300, "{count} links");
    let index = read(out.join("index.html"));
    let shipped = files(&models, "")
        .iter()
        .filter(|n| n.ends_with(".toml"))
        .count();
    assert_eq!(index.matches("<li>").count(), shipped + 1);
    // A card shows the beginning of the model's comment, and the classes of its pairs as in `cspace info`.
    assert!(index.contains("<h2>peg in hole</h2>"));
    assert!(index.contains(
        "Collared peg of diameter 10 and a blind hole of diameter 10.1, in section.</p>"
    ));
    let classes = "<span>lower × 4</span> <span>fixed-axes</span> <span>symmetric</span>";
    assert!(index.contains(classes), "{index}");
    // A folder's own models come before those below it.
    assert!(index.find("\"ratchet_pawl.html") < index.find("\"ratchet_pawl-2.html"));
    assert!(index.contains("<a href=\"ratchet_pawl-2.html\"><img src=\"ratchet_pawl-2.svg\" alt=\"\" loading=\"lazy\"><h2>ratchet"));
    // Links between documents, to a heading, to a model's page; a file that is copied.
    let readme = read(out.join("README.html"));
    for link in [
        "docs/model.html\"",
        "docs/limits.html#conflicts\"",
        "docs/contact-space.schema.json\"",
    ] {
        assert!(readme.contains(&format!("href=\"{link}")), "{link}");
    }
    assert!(!readme.contains("href=\"LICENSE"));
    let gallery = read(out.join("docs/gallery.html"));
    assert!(gallery.contains("href=\"../ball_in_c.html\""));
    assert_eq!(
        std::fs::read(out.join("docs/gallery/gears.png")).unwrap(),
        std::fs::read(project("docs/gallery/gears.png")).unwrap()
    );
}

/// Without models there are those of `cspace new`.
#[test]
fn templates_are_shown_by_themselves() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("site");
    std::fs::create_dir(&out).unwrap();
    site(&[], None, &out).unwrap();
    let names = [
        "latch",
        "cam",
        "gears",
        "geneva",
        "ratchet",
        "peg",
        "playground",
    ];
    for name in names {
        assert_eq!(read(out.join(format!("{name}.html"))), PAGE);
        assert!(read(out.join(format!("{name}.svg"))).starts_with("<svg"));
    }
    all_links_lead(&out);
    // A list of all files, the index, the style; nothing beside the site.
    assert_eq!(files(&out, "").len(), 2 * names.len() + 3);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn names_differ_in_more_than_case() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    for name in [
        "m/Peg.toml",
        "m/a/peg.toml",
        "m/b/PEG.toml",
        "m/index.toml",
        "m/two words.toml",
    ] {
        write(place(name), BLOCKS);
    }
    write(
        place("text/a.md"),
        "# A\n[b](<b b.md>) [b](b%20b.md) ![](B.SVG)",
    );
    write(place("text/b b.md"), "# B");
    write(place("text/B.SVG"), "<svg/>");
    write(place("text/A.MD"), "# A again");
    let out = place("site");
    site(
        &[&place("m"), &place("m/Peg.toml")],
        Some(&place("text")),
        &out,
    )
    .unwrap();
    let known = files(&out, "");
    let folded: BTreeSet<String> = known.iter().map(|n| n.to_lowercase()).collect();
    assert_eq!(known.len(), folded.len(), "{known:?}");
    for name in [
        "Peg.html",
        "peg-2.html",
        "PEG-3.html",
        "index-2.html",
        "two-words.html",
        "docs/B.SVG",
    ] {
        assert!(known.contains(name), "{name}: {known:?}");
    }
    // Each once, and the playground.
    assert_eq!(read(out.join("index.html")).matches("<li>").count(), 6);
    assert!(read(out.join("index.html")).contains("<h2>a &lt; b</h2></a>\n<p>Two blocks.</p>"));
    all_links_lead(&out);
}

/// Nothing of a document acts or is fetched from elsewhere.
#[test]
fn documents_are_text() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    write(place("secret.txt"), "nothing for others");
    let text = "# A `b` c?\n<script>alert(1)</script>\n<!-- unseen -->\n\n[bad](javascript:alert(1)) [out](../secret.txt) \
        [gone](no.md)\n![far](https://example.org/a.png) [far](https://example.org)\n\n## Twice\n## Twice\n[there](#twice-1)\n";
    write(place("text/a.md"), text);
    let model = write(place("m.toml"), BLOCKS);
    site(&[&model], Some(&place("text")), &place("site")).unwrap();
    let html = read(place("site/docs/a.html"));
    for words in [
        "<title>A b c?</title>",
        "id=\"a-b-c\"",
        "&lt;script&gt;",
        "bad out",
        "gone",
        "href=\"https://example.org\"",
        "id=\"twice-1\"",
    ] {
        assert!(html.contains(words), "{words}: {html}");
    }
    for words in [
        "<script",
        "unseen",
        "javascript",
        "a.png",
        "secret",
        "no.md",
    ] {
        assert!(!html.contains(words), "{words}: {html}");
    }
    all_links_lead(&place("site"));
}

/// Foreign files in the output folder are named in the error, and are kept.
#[test]
fn only_its_own_folder_is_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    let a = write(place("a.toml"), BLOCKS);
    let b = write(place("b.toml"), BLOCKS);
    let out = place("site");
    site(&[&a], None, &out).unwrap();
    site(&[&b], None, &out).unwrap();
    assert!(!out.join("a.html").exists() && out.join("b.html").exists());
    let mine = write(out.join("sub/CNAME"), "example.org");
    let refused = |out: &Path, words: &str| {
        let failure = site(&[&a], None, out).unwrap_err();
        assert_eq!(failure.code(), 2);
        assert!(failure.message().contains(words), "{}", failure.message());
    };
    refused(&out, "CNAME");
    assert!(mine.exists() && !out.join("a.html").exists());
    refused(mine.parent().unwrap(), "not empty");
    refused(&a, "is no folder");
    refused(&place("no/site"), "there is no directory");
    refused(Path::new("-"), "standard output");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
}

#[test]
fn what_cannot_be_computed_is_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    write(place("m/good.toml"), BLOCKS);
    write(place("m/bad.toml"), "[[part");
    let out = place("site");
    site(&[&place("m")], None, &out).unwrap();
    assert!(out.join("good.html").exists() && !out.join("bad.html").exists());
    assert_eq!(read(out.join("index.html")).matches("<li>").count(), 2);
    let before = files(&out, "");
    let failure = site(&[&place("m/bad.toml")], None, &out).unwrap_err();
    assert_eq!(failure.code(), 1);
    assert_eq!(files(&out, ""), before);
}
