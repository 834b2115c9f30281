//! The page that was bundled when the crate was built.

use sha2::{Digest, Sha256};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;

/// Why there is no page; empty if there is one.
const REASON: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/reason.txt"));
/// How to get one.
const HELP: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/help.txt"));
const INDEX: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/index.html"));
const STYLE: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/style.css"));
const SCRIPT: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/page.js"));
const WORKER: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/worker.js"));
const KERNEL: &str = include_str!(concat!(env!("OUT_DIR"), "/bundle/kernel.txt"));

/// Places of a page's style, scene and script.
const PLACES: [&str; 3] = ["<!--style-->", "<!--scene-->", "<!--script-->"];

/// The page without a scene.
#[derive(Debug, Clone)]
pub struct Page {
    /// Text before, between and after the places.
    pub(crate) around: [String; 4],
    pub(crate) style: String,
    pub(crate) script: String,
    /// The hash of the script, by which a policy allows it and no other.
    pub(crate) hash: String,
    /// Kernel with which the script computes.
    pub(crate) kernel: Option<Kernel>,
}

/// The kernel in a page.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kernel {
    /// The script of the worker that computes.
    pub(crate) worker: &'static str,
    /// The WebAssembly, compressed by gzip, in base 64.
    pub(crate) packed: &'static str,
}

/// Why there is no page.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PageError {
    /// The page was not bundled when the crate was built.
    #[error("this program was built without its page: {reason}")]
    NotBundled {
        /// Reason.
        reason: &'static str,
    },
    /// The template has not exactly one place for the style, then the scene, then the script.
    #[error("the page's template does not have {place} once, in the order style, scene, script")]
    Template {
        /// The place.
        place: &'static str,
    },
    /// Style or script would end early.
    #[error("the page's {what} has {text:?} in it, where a browser takes it to end")]
    Ends {
        /// Style or script.
        what: &'static str,
        /// Text that ends it.
        text: &'static str,
    },
}

impl PageError {
    /// Advice on how to correct the error.
    pub const fn help(&self) -> &'static str {
        match self {
            Self::NotBundled { .. } => HELP,
            _ => "change the page's sources, then build again",
        }
    }
}

impl Page {
    /// Returns the page that was bundled.
    ///
    /// # Errors
    /// If it was not bundled: it was left out, or what builds it was missing.
    pub fn bundled() -> Result<Self, PageError> {
        if !REASON.is_empty() {
            return Err(PageError::NotBundled { reason: REASON });
        }
        let mut page = Self::new(INDEX, STYLE, SCRIPT)?;
        check_ends("script of the worker", WORKER, SCRIPT_ENDS)?;
        page.kernel = Some(Kernel {
            worker: WORKER,
            packed: KERNEL,
        });
        Ok(page)
    }

    /// Creates a page from an HTML template, with one place each for style, scene and script, a style and a script.
    ///
    /// # Errors
    /// If the template has no such places, or style or script cannot stand in it.
    pub fn new(template: &str, style: &str, script: &str) -> Result<Self, PageError> {
        check_ends("style", style, &["</style"])?;
        check_ends("script", script, SCRIPT_ENDS)?;
        let mut rest = template;
        let mut around = [const { String::new() }; 4];
        for (place, before) in PLACES.into_iter().zip(&mut around) {
            let Some((head, tail)) = rest.split_once(place) else {
                return Err(PageError::Template { place });
            };
            head.clone_into(before);
            rest = tail;
        }
        if let Some(place) = PLACES.into_iter().find(|p| rest.contains(p)) {
            return Err(PageError::Template { place });
        }
        rest.clone_into(&mut around[3]);
        Ok(Self {
            around,
            style: style.to_owned(),
            script: script.to_owned(),
            hash: BASE64_STANDARD.encode(Sha256::digest(script)),
            kernel: None,
        })
    }
}

/// Texts at which a browser ends a script, or reads it differently.
const SCRIPT_ENDS: &[&str] = &["</script", "<!--"];

/// Checks that a source has no text that ends the element it stands in.
fn check_ends(what: &'static str, source: &str, ends: &[&'static str]) -> Result<(), PageError> {
    let source = source.to_ascii_lowercase();
    match ends.iter().find(|&&text| source.contains(text)) {
        Some(text) => Err(PageError::Ends { what, text }),
        None => Ok(()),
    }
}
