//! A page with a scene in it, as HTML.

use serde::Serialize;

use crate::view::page::{Kernel, Page};
use cspace_api::scene::Scene;

/// Way in which a page is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    /// Opened from a file: it may send no requests.
    File,
    /// Opened from the server, to which it may send requests.
    Served,
}

impl Page {
    /// Writes one file with the scene in it, which loads nothing else: its policy forbids the network.
    ///
    /// # Errors
    /// If the scene cannot be written as JSON, which plain data always can.
    pub fn file(&self, scene: &Scene) -> Result<String, serde_json::Error> {
        self.with(r#"http-equiv="Content-Security-Policy""#, scene)
    }

    /// The page as the server has it, which sends the policy itself: that of a file is there for the file that the page saves.
    pub(crate) fn served(&self, scene: &impl Serialize) -> Result<String, serde_json::Error> {
        self.with(r#"name="policy""#, scene)
    }

    fn with(&self, key: &str, scene: &impl Serialize) -> Result<String, serde_json::Error> {
        // Nothing in the policy needs escaping.
        let policy = format!(r#"<meta {key} content="{}">"#, self.policy(Place::File));
        let scene = inline(&serde_json::to_string(scene)?);
        let [head, middle, between, tail] = &self.around;
        let (style, script) = (&self.style, &self.script);
        // Data that the script reads: browsers run neither.
        let kernel = self.kernel.map_or_else(String::new, |k| {
            let Kernel { worker, packed } = k;
            format!(
                r#"<script type="text/plain" id="worker">{worker}</script><script type="text/plain" id="kernel">{packed}</script>"#
            )
        });
        Ok([
            head,
            &policy,
            "<style>",
            style,
            "</style>",
            middle,
            r#"<script type="application/json" id="scene">"#,
            &scene,
            "</script>",
            between,
            &kernel,
            "<script>",
            script,
            "</script>",
            tail,
        ]
        .concat())
    }

    /// Content-Security-Policy of the page: it may load its own script by its hash, and nothing from elsewhere.
    pub(crate) fn policy(&self, place: Place) -> String {
        let asks = match place {
            Place::File => "",
            Place::Served => "; connect-src 'self'; frame-ancestors 'none'",
        };
        // The worker's script is in the page, from where it becomes a blob.
        let (compiles, works) = match self.kernel {
            Some(_) => (" 'wasm-unsafe-eval'", "; worker-src blob:"),
            None => ("", ""),
        };
        format!(
            "default-src 'none'; script-src 'sha256-{}'{compiles}; style-src 'unsafe-inline'; img-src data: blob:{works}; \
             base-uri 'none'; form-action 'none'{asks}",
            self.hash
        )
    }
}

/// JSON that can stand in a script element: `<` begins what could end it, and in JSON is nowhere but in texts.
fn inline(json: &str) -> String {
    json.replace('<', "\\u003c")
}
