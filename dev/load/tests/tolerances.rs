//! Every constant of type `f64` in the kernel has a comment of documentation, and there are at most [`MOST`] of them.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Attribute, ImplItemConst, ItemConst, ItemMod, Type};

/// Largest number of constants: a new one takes the place of an old one.
const MOST: usize = 240;

/// Constants found in a file: names, and whether they have a comment.
#[derive(Default)]
struct Constants(Vec<(String, bool)>);

fn has(attributes: &[Attribute], name: &str) -> bool {
    attributes.iter().any(|a| a.path().is_ident(name))
}

fn is_number(of: &Type) -> bool {
    matches!(of, Type::Path(path) if path.path.is_ident("f64"))
}

impl<'ast> Visit<'ast> for Constants {
    fn visit_item_const(&mut self, item: &'ast ItemConst) {
        if is_number(&item.ty) {
            (self.0).push((item.ident.to_string(), has(&item.attrs, "doc")));
        }
    }

    fn visit_impl_item_const(&mut self, item: &'ast ImplItemConst) {
        // Those of a trait have their comment there.
        if is_number(&item.ty) {
            self.0.push((item.ident.to_string(), true));
        }
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if !has(&item.attrs, "cfg") {
            visit::visit_item_mod(self, item);
        }
    }
}

fn files(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, all);
        } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
            all.push(path);
        }
    }
}

#[test]
fn constants_are_explained_and_few() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates/cspace/src");
    let mut all = Vec::new();
    files(&root, &mut all);
    all.sort();
    let (mut count, mut bare) = (0, Vec::new());
    for file in all {
        let text = std::fs::read_to_string(&file).unwrap();
        let mut found = Constants::default();
        found.visit_file(&syn::parse_file(&text).unwrap());
        count += found.0.len();
        let name = file.strip_prefix(&root).unwrap().display().to_string();
        let without = found.0.into_iter().filter(|(_, explained)| !explained);
        bare.extend(without.map(|(constant, _)| format!("{name}: {constant}")));
    }
    assert!(count > 50, "{count} constants are found");
    assert!(
        count <= MOST,
        "the kernel has {count} constants of type f64, and {MOST} are allowed: use an existing one"
    );
    assert!(bare.is_empty(), "without a comment:\n{}", bare.join("\n"));
}
