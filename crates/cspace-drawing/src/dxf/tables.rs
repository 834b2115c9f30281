//! Data of a DXF file on the drawing as a whole: its unit, its encoding, its layers.

use std::collections::HashMap;
use std::sync::Arc;

use super::entity::color;
use super::error::Result;
use super::groups::{Group, Groups};
use super::item::Given;
use super::names::{Names, folded};
use super::record::Record;
use crate::color::Color;
use crate::unit::Unit;

/// Layers by folded name.
#[derive(Default)]
pub(super) struct Layers(HashMap<String, Layer>);

/// Properties of what is drawn on a layer.
#[derive(Default)]
struct Layer {
    /// As the file spells it.
    name: Arc<str>,
    hidden: Option<Hidden>,
    color: Option<Color>,
    linetype: Option<Arc<str>>,
}

/// Why a layer is not drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hidden {
    /// Switched off: entities inserted on it are drawn all the same, if they are on visible layers.
    Off,
    /// Frozen: neither is.
    Frozen,
}

impl Layers {
    /// The names of all layers, as the file spells them.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.values().map(|layer| &*layer.name)
    }

    pub(super) fn hidden(&self, layer: &str) -> Option<Hidden> {
        self.get(layer)?.hidden
    }

    pub(super) fn color(&self, layer: &str) -> Option<Color> {
        self.get(layer)?.color
    }

    pub(super) fn linetype(&self, layer: &str) -> Option<Arc<str>> {
        self.get(layer)?.linetype.clone()
    }

    fn get(&self, layer: &str) -> Option<&Layer> {
        // Most drawings have none of their own.
        if self.0.is_empty() {
            return None;
        }
        self.0.get(&folded(layer))
    }
}

/// The variables of the header that matter.
#[derive(Default)]
pub(super) struct Header {
    pub(super) unit: Option<Unit>,
}

pub(super) fn read_header<'a>(groups: &mut Groups<'a>, names: &mut Names<'a>) -> Result<Header> {
    let mut header = Header::default();
    let mut variable: &[u8] = b"";
    while let Some(group) = groups.next()? {
        if group.begins(b"ENDSEC") {
            break;
        }
        match (group.code, variable) {
            (9, _) => variable = group.text(),
            (3, b"$DWGCODEPAGE") => names.set_code_page(group.text()),
            (70, b"$INSUNITS") => header.unit = Unit::of_dxf(group.integer()?),
            _ => {}
        }
    }
    Ok(header)
}

pub(super) fn read_tables<'a>(groups: &mut Groups<'a>, names: &mut Names<'a>) -> Result<Layers> {
    let mut layers = Layers::default();
    let mut layer: Vec<Group<'a>> = Vec::new();
    let mut in_layer = false;
    loop {
        let group = groups.next()?;
        let ends = group.is_none_or(|g| g.code == 0);
        if ends && in_layer {
            add(&mut layers, &layer, names)?;
        }
        let Some(group) = group else { break };
        if group.begins(b"ENDSEC") {
            break;
        }
        if ends {
            in_layer = group.text() == b"LAYER";
            layer.clear();
        } else if in_layer {
            layer.push(group);
        }
    }
    Ok(layers)
}

fn add<'a>(layers: &mut Layers, layer: &[Group<'a>], names: &mut Names<'a>) -> Result<()> {
    let mut name = None;
    let mut of = Layer::default();
    for group in layer {
        match group.code {
            2 => name = Some(names.get(group.text())),
            6 => of.linetype = Some(names.get(group.text())),
            70 if group.integer()? & 1 != 0 => of.hidden = Some(Hidden::Frozen),
            62 if group.integer()? < 0 => of.hidden = of.hidden.or(Some(Hidden::Off)),
            _ => {}
        }
    }
    if let Given::Own(color) = color(&Record::new(layer))? {
        of.color = Some(color);
    }
    if let Some(name) = name {
        let key = folded(&name);
        layers.0.insert(key, Layer { name, ..of });
    }
    Ok(())
}
