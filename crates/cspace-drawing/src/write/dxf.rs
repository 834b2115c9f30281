//! DXF of R12 and R2000.

use std::collections::HashSet;
use std::fmt::Write as _;

use super::Drawn;
use crate::unit::Unit;

/// A version of DXF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DxfVersion {
    /// R12 (AC1009), which every program reads: a POLYLINE of vertices for each loop, and names in the characters A to Z, 0 to 9,
    /// `-`, `_` and `$`.
    R12,
    /// R2000 (AC1015): a LWPOLYLINE for each loop.
    #[default]
    R2000,
}

/// Outlines as the text of a DXF file: each loop a closed polyline with bulges, on a layer of its outline's name.
///
/// Reading it gives the same loops, to the last bit: numbers have as many digits as that takes.
///
/// ```
/// use cspace::Part;
/// use cspace_drawing::{Drawn, DxfVersion, Settings, Source, dxf, read};
/// let slot = Part::slot("slot", (0.0, 0.0), (4.0, 0.0), 1.0)?;
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("slot.dxf");
/// std::fs::write(&path, dxf(&Drawn::part(&slot), None, DxfVersion::R2000))?;
/// let again = read(&path, &Source::default())?.outlines(&Settings::default())?;
/// assert_eq!(again.parts[0], slot);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn dxf(drawn: &[Drawn], unit: Option<Unit>, version: DxfVersion) -> String {
    let layers = layers(drawn, version);
    let mut out = Out {
        text: String::new(),
        handle: 0x40,
        version,
    };
    out.header(drawn, unit);
    out.tables(&layers);
    out.blocks();
    out.start("ENTITIES");
    for (drawn, layer) in drawn.iter().zip(&layers) {
        for vertices in &drawn.loops {
            out.polyline(vertices, layer);
        }
    }
    out.end();
    if version == DxfVersion::R2000 {
        out.objects();
    }
    out.group(0, "EOF");
    out.text
}

/// The name of each outline in characters that the version has for layers, no two alike.
fn layers(drawn: &[Drawn], version: DxfVersion) -> Vec<String> {
    let mut taken = HashSet::new();
    (drawn.iter())
        .map(|d| {
            let allowed = |c: char| match version {
                DxfVersion::R12 => c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '$'),
                DxfVersion::R2000 => !c.is_control() && !"<>/\\\":;?*|,=`".contains(c),
            };
            let plain: String = d
                .name
                .chars()
                .map(|c| if allowed(c) { c } else { '_' })
                .collect();
            let plain = match version {
                DxfVersion::R12 => plain.to_ascii_uppercase().chars().take(31).collect(),
                DxfVersion::R2000 => plain.trim().to_owned(),
            };
            let plain = if plain.is_empty() {
                "PART".to_owned()
            } else {
                plain
            };
            let mut name = plain.clone();
            let mut number = 1;
            while !taken.insert(name.to_lowercase()) {
                number += 1;
                name = format!("{}_{number}", plain.chars().take(26).collect::<String>());
            }
            name
        })
        .collect()
}

struct Out {
    text: String,
    /// The next handle; those below are of tables.
    handle: u32,
    version: DxfVersion,
}

/// Handles of what entities refer to.
const MODEL_SPACE: &str = "1F";
const PAPER_SPACE: &str = "1B";

impl Out {
    fn group(&mut self, code: u16, value: impl core::fmt::Display) {
        // A String takes everything.
        let _ = writeln!(self.text, "{code}\n{value}");
    }

    /// Text that may have any characters: those beyond ASCII are escaped.
    fn name(&mut self, code: u16, name: &str) {
        let mut plain = String::new();
        for c in name.chars() {
            if c.is_ascii() {
                plain.push(c);
            } else {
                let mut units = [0; 2];
                for unit in c.encode_utf16(&mut units) {
                    let _ = write!(plain, "\\U+{unit:04X}");
                }
            }
        }
        self.group(code, plain);
    }

    /// The fewest digits that are read back as the same number.
    fn real(&mut self, code: u16, x: f64) {
        self.group(code, format_args!("{x:?}"));
    }

    fn point(&mut self, x: f64, y: f64) {
        self.real(10, x);
        self.real(20, y);
    }

    fn is_new(&self) -> bool {
        self.version == DxfVersion::R2000
    }

    fn start(&mut self, section: &str) {
        self.group(0, "SECTION");
        self.group(2, section);
    }

    fn end(&mut self) {
        self.group(0, "ENDSEC");
    }

    /// Writes the marks that R2000 requires of every object: its handle, its owner, and its classes.
    fn mark(&mut self, handle: &str, owner: &str, classes: &[&str]) {
        if self.is_new() {
            self.group(5, handle);
            self.group(330, owner);
            for class in classes {
                self.group(100, class);
            }
        }
    }

    fn next_handle(&mut self) -> String {
        self.handle += 1;
        format!("{:X}", self.handle - 1)
    }

    fn header(&mut self, drawn: &[Drawn], unit: Option<Unit>) {
        let [lo, hi] = Drawn::extent(drawn);
        self.start("HEADER");
        self.group(9, "$ACADVER");
        self.group(1, if self.is_new() { "AC1015" } else { "AC1009" });
        for (name, p) in [("$EXTMIN", lo), ("$EXTMAX", hi)] {
            self.group(9, name);
            self.point(p.x, p.y);
            self.real(30, 0.0);
        }
        if self.is_new() {
            let edges = drawn.iter().map(|d| d.loops.len()).sum::<usize>();
            self.group(9, "$HANDSEED");
            self.group(5, format_args!("{:X}", 0x1000 + edges + 2 * drawn.len()));
            self.group(9, "$INSUNITS");
            self.group(70, unit.map_or(0, Unit::dxf));
        }
        self.end();
    }

    fn table(&mut self, name: &str, handle: &str, entries: usize) {
        self.group(0, "TABLE");
        self.group(2, name);
        self.mark(handle, "0", &["AcDbSymbolTable"]);
        self.group(70, entries);
        if name == "DIMSTYLE" && self.is_new() {
            self.group(100, "AcDbDimStyleTable");
        }
    }

    fn entry(&mut self, kind: &str, class: &str, handle: &str, owner: &str, name: &str) {
        self.group(0, kind);
        self.mark(handle, owner, &["AcDbSymbolTableRecord", class]);
        self.name(2, name);
    }

    fn tables(&mut self, layers: &[String]) {
        self.start("TABLES");
        if self.is_new() {
            self.table("VPORT", "8", 0);
            self.group(0, "ENDTAB");
        }
        let types: &[&str] = if self.is_new() {
            &["ByBlock", "ByLayer", "Continuous"]
        } else {
            &["CONTINUOUS"]
        };
        self.table("LTYPE", "5", types.len());
        for (i, name) in types.iter().enumerate() {
            let handle = format!("{:X}", 0x14 + i);
            self.entry("LTYPE", "AcDbLinetypeTableRecord", &handle, "5", name);
            self.group(70, 0);
            self.group(3, "");
            self.group(72, 65);
            self.group(73, 0);
            self.real(40, 0.0);
        }
        self.group(0, "ENDTAB");
        self.table("LAYER", "2", layers.len() + 1);
        let plain = if self.is_new() {
            "Continuous"
        } else {
            "CONTINUOUS"
        };
        for (i, layer) in ["0"]
            .into_iter()
            .chain(layers.iter().map(String::as_str))
            .enumerate()
        {
            if i > 0 && layer == "0" {
                continue;
            }
            let handle = if i == 0 {
                "10".to_owned()
            } else {
                self.next_handle()
            };
            self.entry("LAYER", "AcDbLayerTableRecord", &handle, "2", layer);
            self.group(70, 0);
            self.group(62, 7);
            self.group(6, plain);
            if self.is_new() {
                self.group(390, "F");
            }
        }
        self.group(0, "ENDTAB");
        self.table("STYLE", "3", 0);
        self.group(0, "ENDTAB");
        if self.is_new() {
            self.table("VIEW", "6", 0);
            self.group(0, "ENDTAB");
            self.table("UCS", "7", 0);
            self.group(0, "ENDTAB");
            self.table("APPID", "9", 1);
            self.entry("APPID", "AcDbRegAppTableRecord", "12", "9", "ACAD");
            self.group(70, 0);
            self.group(0, "ENDTAB");
            self.table("DIMSTYLE", "A", 0);
            self.group(0, "ENDTAB");
            self.table("BLOCK_RECORD", "1", 2);
            for (handle, name) in [(MODEL_SPACE, "*Model_Space"), (PAPER_SPACE, "*Paper_Space")] {
                self.entry("BLOCK_RECORD", "AcDbBlockTableRecord", handle, "1", name);
            }
            self.group(0, "ENDTAB");
        }
        self.end();
    }

    fn blocks(&mut self) {
        self.start("BLOCKS");
        if self.is_new() {
            let spaces = [
                (MODEL_SPACE, "*Model_Space", "20", "21"),
                (PAPER_SPACE, "*Paper_Space", "1C", "1D"),
            ];
            for (owner, name, begin, end) in spaces {
                self.group(0, "BLOCK");
                self.mark(begin, owner, &["AcDbEntity"]);
                self.group(8, "0");
                self.group(100, "AcDbBlockBegin");
                self.group(2, name);
                self.group(70, 0);
                self.point(0.0, 0.0);
                self.real(30, 0.0);
                self.group(3, name);
                self.group(1, "");
                self.group(0, "ENDBLK");
                self.mark(end, owner, &["AcDbEntity"]);
                self.group(8, "0");
                self.group(100, "AcDbBlockEnd");
            }
        }
        self.end();
    }

    fn polyline(&mut self, vertices: &[cspace::Vertex], layer: &str) {
        const CLOSED: u16 = 1;
        if self.is_new() {
            let handle = self.next_handle();
            self.group(0, "LWPOLYLINE");
            self.mark(&handle, MODEL_SPACE, &["AcDbEntity"]);
            self.name(8, layer);
            self.group(100, "AcDbPolyline");
            self.group(90, vertices.len());
            self.group(70, CLOSED);
            for v in vertices {
                self.point(v.x, v.y);
                if v.bulge != 0.0 {
                    self.real(42, v.bulge);
                }
            }
            return;
        }
        self.group(0, "POLYLINE");
        self.name(8, layer);
        self.group(66, 1);
        self.point(0.0, 0.0);
        self.real(30, 0.0);
        self.group(70, CLOSED);
        for v in vertices {
            self.group(0, "VERTEX");
            self.name(8, layer);
            self.point(v.x, v.y);
            self.real(30, 0.0);
            if v.bulge != 0.0 {
                self.real(42, v.bulge);
            }
        }
        self.group(0, "SEQEND");
        self.name(8, layer);
    }

    /// The dictionaries that a file of R2000 must have.
    fn objects(&mut self) {
        self.start("OBJECTS");
        self.group(0, "DICTIONARY");
        self.mark("C", "0", &["AcDbDictionary"]);
        self.group(3, "ACAD_GROUP");
        self.group(350, "D");
        self.group(3, "ACAD_PLOTSTYLENAME");
        self.group(350, "E");
        self.group(0, "DICTIONARY");
        self.mark("D", "C", &["AcDbDictionary"]);
        self.group(0, "ACDBDICTIONARYWDFLT");
        self.mark("E", "C", &["AcDbDictionary"]);
        self.group(3, "Normal");
        self.group(350, "F");
        self.group(100, "AcDbDictionaryWithDefault");
        self.group(340, "F");
        self.group(0, "ACDBPLACEHOLDER");
        self.mark("F", "E", &[]);
        self.end();
    }
}
