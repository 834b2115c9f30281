//! Bodies of the fuzz targets.
//!
//! A [`Target`] makes an input of bytes, asks the library, and judges the answer by something that shares no code with it. The
//! same function is run in two ways: by libFuzzer, which looks for bytes that reach new code (folder `dev/fuzz` of the
//! repository), and by the tests of this crate, which run it on the kept inputs and on some thousand random ones.
//!
//! | target | input | judged by |
//! |---|---|---|
//! | `model_reader` | text, or a shipped model with edits | written and read again it is the same; errors are one line of text |
//! | `dxf_reader`, `svg_reader`, `points_reader` | bytes, or a drawing with edits | parts written as DXF are read again as they were; errors say what to do |
//! | `predicates` | numbers that favour ties | exact arithmetic on dyadic rationals |
//! | `slice` | two parts and an orientation | brute force on positions, and an area with certain bounds |
//! | `pipeline` | two parts, perhaps of a family | brute force on configurations, slices from scratch, closedness |
//!
//! ```
//! let target = cspace_fuzz::target("model_reader").ok_or("no such target")?;
//! let found = (target.run)(b"[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n");
//! assert!(found? > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod area;
mod axes;
pub mod draw;
mod drawing;
pub mod exact;
mod finding;
mod pipeline;
mod predicates;
mod reader;
mod slice;

pub use finding::Finding;

/// Fuzz target.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Name, also that of its program and of its folders of inputs.
    pub name: &'static str,
    /// Runs it on bytes: how many answers of the library were judged, 0 where the bytes mean nothing.
    pub run: fn(&[u8]) -> Result<u64, Finding>,
}

/// Fuzz targets.
pub const TARGETS: [Target; 7] = [
    Target {
        name: "model_reader",
        run: reader::run,
    },
    Target {
        name: "predicates",
        run: predicates::run,
    },
    Target {
        name: "slice",
        run: slice::run,
    },
    Target {
        name: "pipeline",
        run: pipeline::run,
    },
    Target {
        name: "dxf_reader",
        run: drawing::dxf_reader,
    },
    Target {
        name: "svg_reader",
        run: drawing::svg_reader,
    },
    Target {
        name: "points_reader",
        run: drawing::points_reader,
    },
];

/// The target of a name.
pub fn target(name: &str) -> Option<&'static Target> {
    TARGETS.iter().find(|t| t.name == name)
}

/// Runs a target on bytes.
///
/// # Panics
/// If there is a finding, so that libFuzzer records it. The message has the finding and, if there is one, its model.
#[allow(clippy::panic)]
pub fn fuzz(name: &str, data: &[u8]) {
    match target(name).map(|t| (t.run)(data)) {
        Some(Ok(_)) => {}
        Some(Err(finding)) => panic!("{finding}"),
        None => panic!("no target {name}"),
    }
}
