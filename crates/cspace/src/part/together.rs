//! Several parts as one, and one of them again.

use std::ops::Range;

use super::{Part, PartError, PartFeature};

impl Part {
    /// Parts that move as one, each where it is drawn: the layers of all of them, in their order. They may overlap. Loops are numbered
    /// through all, and edges and vertices keep their names.
    ///
    /// # Errors
    /// As for [`layered`](Self::layered), and if two edges or vertices have one name.
    ///
    /// ```
    /// use cspace::Part;
    /// let rod = Part::rectangle("rod", (0.0, 0.0), 6.0, 1.0)?;
    /// let knob = Part::circle("knob", (3.0, 0.0), 1.0)?;
    /// let lever = Part::together("rod + knob", &[&rod, &knob])?;
    /// assert_eq!(lever.loops().len(), 2);
    /// assert_eq!(lever.of_layers("knob", 1..2), knob);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn together(name: impl Into<String>, parts: &[&Self]) -> Result<Self, PartError> {
        let layers = (parts.iter()).flat_map(|p| p.layers.iter().map(|l| (l.z(), p.outline(l))));
        let mut whole = Self::layered(name, layers)?;
        let mut before = 0;
        for part in parts {
            for (feature, name) in &part.names {
                whole = whole.with_feature_name(feature.in_loop(|l| l + before), name)?;
            }
            before += part.loops.len() as u32;
        }
        Ok(whole)
    }

    /// The part of some of its layers, whose loops are numbered from 0; edges and vertices keep their names.
    ///
    /// # Panics
    /// If there are no such layers.
    #[must_use]
    pub fn of_layers(&self, name: impl Into<String>, layers: Range<usize>) -> Self {
        let layers = &self.layers[layers];
        let first = layers.first().map_or(0, |l| l.loops.start);
        let end = layers.last().map_or(first, |l| l.loops.end);
        let stack = layers.iter().cloned().map(|mut layer| {
            layer.loops = layer.loops.start - first..layer.loops.end - first;
            layer
        });
        let mut part = Self::checked(
            name.into(),
            stack.collect(),
            self.loops[first..end].to_vec(),
        );
        let own = |f: &PartFeature| (first..end).contains(&(f.loop_index() as usize));
        part.names = (self.names.iter().filter(|(f, _)| own(f)))
            .map(|(f, name)| (f.in_loop(|l| l - first as u32), name.clone()))
            .collect();
        part
    }
}

impl PartFeature {
    /// The loop.
    pub const fn loop_index(self) -> u32 {
        let (Self::Edge { loop_index, .. } | Self::Vertex { loop_index, .. }) = self;
        loop_index
    }

    /// Edge or vertex of the loop that has another number.
    fn in_loop(self, number: impl Fn(u32) -> u32) -> Self {
        let loop_index = number(self.loop_index());
        match self {
            Self::Edge { index, .. } => Self::Edge { loop_index, index },
            Self::Vertex { index, .. } => Self::Vertex { loop_index, index },
        }
    }
}
