//! Every constant of type `f64` in the kernel has a comment of documentation, and there are at most [`MOST`] of them.

use std::path::Path;

use syn::visit::{self, Visit};
use syn::{Attribute, ImplItem, ItemConst, ItemImpl, ItemMod, Type};

use super::files;
use super::imports::only_for_tests;

/// Largest number of constants: a new one takes the place of an old one.
const MOST: usize = 240;

/// Constants found in a file: names, and whether they have a comment.
#[derive(Default)]
struct Constants(Vec<(String, bool)>);

fn is_explained(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("doc"))
}

fn is_number(of: &Type) -> bool {
    matches!(of, Type::Path(path) if path.path.is_ident("f64"))
}

impl<'ast> Visit<'ast> for Constants {
    fn visit_item_const(&mut self, item: &'ast ItemConst) {
        if is_number(&item.ty) {
            (self.0).push((item.ident.to_string(), is_explained(&item.attrs)));
        }
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        for inner in &item.items {
            if let ImplItem::Const(constant) = inner
                && is_number(&constant.ty)
            {
                // Those of a trait have their comment there.
                let explained = item.trait_.is_some() || is_explained(&constant.attrs);
                (self.0).push((constant.ident.to_string(), explained));
            }
        }
        visit::visit_item_impl(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if !only_for_tests(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }
}

#[test]
fn constants_are_explained_and_few() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../crates/cspace/src");
    let (mut count, mut bare) = (0, Vec::new());
    for file in files(&root)
        .into_iter()
        .filter(|f| !f.ends_with("tests.rs"))
    {
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
