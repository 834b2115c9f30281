//! No file imports a file that imports it, directly or indirectly: data flows in one direction.
//!
//! Imports are read from the source: `use` declarations and paths that begin with `crate`, `self` or `super`. A name
//! that a module only re-exports counts as an import of the file that defines it, and a re-export is no import.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Attribute, File, Item, UseTree, Visibility};

/// The names of the modules from the root of a crate to a file.
type Module = Vec<String>;

/// Names that a file defines and hands on, and names that it uses.
#[derive(Default)]
struct Source {
    file: PathBuf,
    defined: BTreeSet<String>,
    /// Names handed on, with the path they come from; `*` for all of a module.
    handed_on: Vec<(String, Vec<String>)>,
    named: Vec<Vec<String>>,
}

pub(crate) fn only_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|a| {
        let tokens = quote_of(a);
        a.path().is_ident("cfg")
            && tokens
                .split(|c: char| !c.is_alphanumeric())
                .any(|w| w == "test")
    })
}

fn quote_of(a: &Attribute) -> String {
    match &a.meta {
        syn::Meta::List(list) => list.tokens.to_string(),
        _ => String::new(),
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Mod(x) => &x.attrs,
        Item::Use(x) => &x.attrs,
        Item::Fn(x) => &x.attrs,
        Item::Impl(x) => &x.attrs,
        Item::Const(x) => &x.attrs,
        Item::Struct(x) => &x.attrs,
        Item::Enum(x) => &x.attrs,
        _ => &[],
    }
}

fn name_of(item: &Item) -> Option<String> {
    Some(match item {
        Item::Fn(x) => x.sig.ident.to_string(),
        Item::Const(x) => x.ident.to_string(),
        Item::Static(x) => x.ident.to_string(),
        Item::Struct(x) => x.ident.to_string(),
        Item::Enum(x) => x.ident.to_string(),
        Item::Trait(x) => x.ident.to_string(),
        Item::Type(x) => x.ident.to_string(),
        Item::Union(x) => x.ident.to_string(),
        _ => return None,
    })
}

/// Paths of a `use` declaration, each with the resulting name.
fn leaves(tree: &UseTree, before: &[String], out: &mut Vec<(String, Vec<String>)>) {
    let with = |name: String| [before, &[name]].concat();
    match tree {
        UseTree::Path(p) => leaves(&p.tree, &with(p.ident.to_string()), out),
        UseTree::Name(n) if n.ident == "self" => {
            out.push((before.last().cloned().unwrap_or_default(), before.to_vec()));
        }
        UseTree::Name(n) => out.push((n.ident.to_string(), with(n.ident.to_string()))),
        UseTree::Rename(r) => out.push((r.rename.to_string(), with(r.ident.to_string()))),
        UseTree::Glob(_) => out.push(("*".into(), before.to_vec())),
        UseTree::Group(g) => g.items.iter().for_each(|t| leaves(t, before, out)),
    }
}

struct Paths<'a>(&'a mut Vec<Vec<String>>);

impl<'ast> Visit<'ast> for Paths<'_> {
    fn visit_path(&mut self, path: &'ast syn::Path) {
        let segments: Vec<_> = path.segments.iter().map(|s| s.ident.to_string()).collect();
        if matches!(segments[0].as_str(), "crate" | "super" | "self") && segments.len() > 1 {
            self.0.push(segments);
        }
        visit::visit_path(self, path);
    }

    fn visit_item(&mut self, item: &'ast Item) {
        if !only_for_tests(attributes(item)) {
            visit::visit_item(self, item);
        }
    }
}

fn read(file: &Path) -> Source {
    let text = std::fs::read_to_string(file).unwrap();
    let parsed: File = syn::parse_file(&text).unwrap();
    let mut source = Source {
        file: file.to_path_buf(),
        ..Source::default()
    };
    for item in &parsed.items {
        if only_for_tests(attributes(item)) {
            continue;
        }
        source.defined.extend(name_of(item));
        if let Item::Use(u) = item {
            let mut all = Vec::new();
            leaves(&u.tree, &[], &mut all);
            if matches!(u.vis, Visibility::Inherited) {
                source.named.extend(all.into_iter().map(|l| l.1));
            } else {
                source.handed_on.extend(all);
            }
        }
    }
    Paths(&mut source.named).visit_file(&parsed);
    source
}

/// The sources of a crate by their modules.
fn crate_sources(root: &Path) -> BTreeMap<Module, Source> {
    let mut all = BTreeMap::new();
    let mut folders = vec![(root.to_path_buf(), Module::new())];
    while let Some((folder, module)) = folders.pop() {
        for entry in std::fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let inside = || [module.as_slice(), std::slice::from_ref(&stem)].concat();
            if path.is_dir() {
                if stem != "bin" {
                    folders.push((path.clone(), inside()));
                }
            } else if path.extension().is_some_and(|e| e == "rs") && stem != "tests" {
                let root_file = ["mod", "lib", "main"].contains(&stem.as_str());
                let at = if root_file { module.clone() } else { inside() };
                all.insert(at, read(&path));
            }
        }
    }
    all
}

/// The module whose file defines what a path names, seen from a module; none if it is of another crate.
fn resolved(
    sources: &BTreeMap<Module, Source>,
    from: &Module,
    path: &[String],
    depth: usize,
) -> Option<Module> {
    let mut at = from.clone();
    let mut rest = path;
    let mut moved = false;
    while let Some(first) = rest.first() {
        match first.as_str() {
            "crate" => at.clear(),
            "self" => {}
            "super" => {
                at.pop();
            }
            _ => break,
        }
        moved = true;
        rest = &rest[1..];
    }
    if !moved {
        let child = [from.as_slice(), &path[..1]].concat();
        if !sources.contains_key(&child) {
            return None;
        }
    }
    while let Some(name) = rest.first() {
        let child = [at.as_slice(), std::slice::from_ref(name)].concat();
        if sources.contains_key(&child) {
            at = child;
            rest = &rest[1..];
            continue;
        }
        let source = sources.get(&at)?;
        if source.defined.contains(name) || depth > 8 {
            break;
        }
        let handed = |(n, _): &&(String, Vec<String>)| n == name;
        if let Some((_, to)) = source.handed_on.iter().find(handed) {
            return resolved(sources, &at, to, depth + 1);
        }
        let of_all = source
            .handed_on
            .iter()
            .filter(|(n, _)| n == "*")
            .find_map(|(_, to)| {
                let module = resolved(sources, &at, to, depth + 1)?;
                sources[&module].defined.contains(name).then_some(module)
            });
        return Some(of_all.unwrap_or(at));
    }
    Some(at)
}

/// For every file the files it imports.
fn imports(sources: &BTreeMap<Module, Source>) -> BTreeMap<Module, BTreeSet<Module>> {
    let of = |module: &Module, source: &Source| {
        (source.named.iter())
            .filter_map(|path| resolved(sources, module, path, 0))
            .filter(|to| to != module)
            .collect()
    };
    (sources.iter())
        .map(|(module, source)| (module.clone(), of(module, source)))
        .collect()
}

/// Cycle of imports from a file back to itself, if there is one.
fn circle(imports: &BTreeMap<Module, BTreeSet<Module>>, start: &Module) -> Option<Vec<Module>> {
    let mut came_from: BTreeMap<&Module, &Module> = BTreeMap::new();
    let mut queue = std::collections::VecDeque::from([start]);
    while let Some(at) = queue.pop_front() {
        for to in imports.get(at).into_iter().flatten() {
            if to == start {
                let mut way = vec![start.clone(), at.clone()];
                let mut last = at;
                while let Some(&before) = came_from.get(last) {
                    way.push(before.clone());
                    last = before;
                }
                way.reverse();
                return Some(way);
            }
            if !came_from.contains_key(to) {
                came_from.insert(to, at);
                queue.push_back(to);
            }
        }
    }
    None
}

fn crates() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut all = Vec::new();
    for group in ["crates", "dev"] {
        let Ok(entries) = std::fs::read_dir(root.join(group)) else {
            continue;
        };
        let sources = entries.map(|e| e.unwrap().path().join("src"));
        all.extend(sources.filter(|s| s.is_dir()));
    }
    all.sort();
    all
}

#[test]
fn no_file_imports_a_file_that_imports_it() {
    let mut found = Vec::new();
    let mut files = 0;
    for root in crates() {
        let sources = crate_sources(&root);
        let imports = imports(&sources);
        files += sources.len();
        for module in sources.keys() {
            if let Some(way) = circle(&imports, module) {
                let names = way
                    .iter()
                    .map(|m| sources[m].file.strip_prefix(&root).unwrap());
                let names: Vec<_> = names.map(|p| p.display().to_string()).collect();
                found.push(format!("{}: {}", root.display(), names.join(" → ")));
            }
        }
    }
    assert!(files > 100, "only {files} files were read");
    assert!(
        found.is_empty(),
        "circles of imports:\n{}",
        found.join("\n")
    );
}

/// The check sees a circle through a module that hands a name on.
/// Double-double arithmetic is chosen in one place: outside of the formulas, the kernel names the numbers in which it decides, not their kind.
#[test]
fn double_double_is_named_only_where_formulas_are() {
    const NAMED: [&str; 3] = ["number", "feature", "contact"];
    let root = (crates().into_iter())
        .find(|c| c.ends_with("crates/cspace/src"))
        .unwrap();
    let sources = crate_sources(&root);
    let names = |s: &Source| {
        let mut paths = s.named.iter().chain(s.handed_on.iter().map(|h| &h.1));
        paths.any(|p| p.iter().any(|name| name == "Dd"))
    };
    let naming = |within: bool| -> Vec<&Module> {
        let naming = sources.iter().filter(|(_, s)| names(s)).map(|s| s.0);
        let is_within = |m: &&Module| m.first().is_some_and(|f| NAMED.contains(&f.as_str()));
        naming.filter(|m| is_within(m) == within).collect()
    };
    assert!(naming(true).len() > 10);
    assert!(naming(false).is_empty(), "named in {:?}", naming(false));
}

#[test]
fn a_circle_through_a_name_handed_on_is_found() {
    let source = |defined: &str, handed_on: &[(&str, &str)], named: &[&str]| {
        let path = |p: &str| p.split("::").map(str::to_owned).collect::<Vec<_>>();
        Source {
            file: PathBuf::new(),
            defined: [defined.to_owned()].into(),
            handed_on: handed_on
                .iter()
                .map(|(n, p)| ((*n).to_owned(), path(p)))
                .collect(),
            named: named.iter().map(|p| path(p)).collect(),
        }
    };
    let module = |p: &str| {
        p.split("::")
            .filter(|s| !s.is_empty())
            .map(str::to_owned)
            .collect::<Module>()
    };
    let mut sources: BTreeMap<Module, Source> = [
        (module(""), source("", &[], &[])),
        (module("a"), source("", &[("Part", "part::Part")], &[])),
        (
            module("a::part"),
            source("Part", &[], &["super::pair::Pair"]),
        ),
        (module("a::pair"), source("Pair", &[], &["crate::a::Part"])),
    ]
    .into();
    let part = module("a::part");
    assert!(circle(&imports(&sources), &part).is_some());
    sources.get_mut(&module("a::pair")).unwrap().named.clear();
    assert!(circle(&imports(&sources), &part).is_none());
}
