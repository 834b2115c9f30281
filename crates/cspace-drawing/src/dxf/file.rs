//! The sections of a DXF file.

use std::collections::HashMap;

use super::entity::Reader;
use super::error::{DxfError, Result};
use super::groups::Groups;
use super::item::{Block, Item};
use super::names::{Names, folded};
use super::tables::{Layers, read_header, read_tables};
use crate::unit::Unit;

/// Content of a file, with its blocks separate.
pub(super) struct File {
    pub(super) unit: Option<Unit>,
    pub(super) layers: Layers,
    /// Blocks by folded name.
    pub(super) blocks: HashMap<String, Block>,
    pub(super) items: Vec<Item>,
}

pub(super) fn read(bytes: &[u8]) -> Result<File> {
    check_is_dxf(bytes)?;
    let mut file = File {
        unit: None,
        layers: Layers::default(),
        blocks: HashMap::new(),
        items: Vec::new(),
    };
    let mut groups = Groups::new(bytes);
    let mut names = Names::new();
    let mut has_entities = false;
    loop {
        let Some(group) = groups.next()? else {
            // Without a section of entities the file is no drawing; without its last line it may not be whole.
            let message = if has_entities {
                "the file ends without EOF"
            } else {
                "the file has no section ENTITIES"
            };
            let help = "is it whole? copy or export it again";
            return Err(DxfError::new(groups.line(), message, help));
        };
        if group.begins(b"EOF") {
            break;
        }
        if !group.begins(b"SECTION") {
            // Comments may stand between sections.
            if group.code == 999 {
                continue;
            }
            let message = format!("group {} where a section is expected", group.code);
            let help = "export the drawing again as DXF";
            return Err(DxfError::new(group.line, message, help));
        }
        let section = groups.next()?.filter(|g| g.code == 2);
        match section.map_or(&b""[..], |g| g.text()) {
            b"HEADER" => file.unit = read_header(&mut groups, &mut names)?.unit,
            b"TABLES" => file.layers = read_tables(&mut groups, &mut names)?,
            b"BLOCKS" => {
                let mut reader = Reader::new(&mut groups, &mut names);
                while let Some((name, block)) = reader.block()? {
                    file.blocks.insert(folded(&name), block);
                }
            }
            b"ENTITIES" => {
                has_entities = true;
                let mut reader = Reader::new(&mut groups, &mut names);
                file.items = reader.items(&[b"ENDSEC"])?;
            }
            _ => skip_section(&mut groups)?,
        }
    }
    if !has_entities {
        let help = "save the whole drawing, not its header or a part of it";
        let message = "the file has no section ENTITIES";
        return Err(DxfError::new(groups.line(), message, help));
    }
    Ok(file)
}

fn check_is_dxf(bytes: &[u8]) -> Result<()> {
    let wrong = |message: &str, help: &str| Err(DxfError::new(1, message, help));
    if bytes.trim_ascii().is_empty() {
        return wrong("the file is empty", "export the drawing again");
    }
    if bytes.starts_with(b"AC10") {
        return wrong(
            "it is a DWG file, not DXF",
            "save the drawing as DXF in the program that made it",
        );
    }
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return wrong(
            "it is in UTF-16",
            "save it in UTF-8, or export the drawing again as DXF",
        );
    }
    Ok(())
}

fn skip_section(groups: &mut Groups<'_>) -> Result<()> {
    while let Some(group) = groups.next()? {
        if group.begins(b"ENDSEC") {
            return Ok(());
        }
    }
    Err(DxfError::cut_off(groups.line()))
}
