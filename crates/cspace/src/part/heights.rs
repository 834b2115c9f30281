//! Which layers and loops of two parts meet at some height.

use std::borrow::Cow;

use super::layer::{Heights, Layer, meet};
use super::{Edge, Loop, Part, Vertex};

impl Part {
    /// The layers, in the order given; a part made by [`Part::new`] has one, at every height.
    pub fn layers(&self) -> &[Layer] {
        &self.layers
    }

    /// Whether the part has heights: it is made of layers, or of one that is not at every height.
    pub fn has_heights(&self) -> bool {
        self.layers.len() > 1 || self.layers.iter().any(|l| l.z.is_some())
    }

    /// One layer as a part at the same heights; its loops are numbered from 0, and edges and vertices have no names.
    pub fn layer(&self, index: usize) -> Cow<'_, Self> {
        let [_, _, ..] = self.layers[..] else {
            return Cow::Borrowed(self);
        };
        let loops: Vec<Loop> = self.loops[self.layers[index].loops()].to_vec();
        Cow::Owned(Self::checked(
            self.name.clone(),
            vec![Layer {
                z: self.layers[index].z,
                loops: 0..loops.len(),
            }],
            loops,
        ))
    }

    /// The vertices of the loops of one of the part's layers, as they were given.
    pub fn outline(&self, layer: &Layer) -> Vec<Vec<Vertex>> {
        let loops = self.loops[layer.loops()].iter();
        loops.map(|l| l.vertices().to_vec()).collect()
    }

    /// The layer to which a loop belongs.
    pub fn layer_of(&self, loop_index: usize) -> usize {
        (self.layers).partition_point(|layer| layer.loops.end <= loop_index)
    }

    /// Whether a loop bounds the part at a height. Loops that several layers have alike, such as a bore, are one, wherever it is asked for.
    pub fn bounds_at(&self, loop_index: usize, height: f64) -> bool {
        let own = &self.loops[loop_index];
        let mut there = self.layers.iter().filter(|layer| layer.is_at(height));
        there.any(|layer| self.loops[layer.loops()].contains(own))
    }

    /// Whether two parts are at a common height: others never touch.
    pub fn meets(&self, other: &Self) -> bool {
        (self.layers.iter()).any(|a| other.layers.iter().any(|b| a.meets(b)))
    }

    /// The pairs of layers of two parts that meet.
    pub fn meeting_layers(&self, other: &Self) -> Vec<(usize, usize)> {
        let of = |i: usize| {
            let meets = move |j: &usize| self.layers[i].meets(&other.layers[*j]);
            (0..other.layers.len()).filter(meets).map(move |j| (i, j))
        };
        (0..self.layers.len()).flat_map(of).collect()
    }

    /// The pairs of layers of two parts that meet, as parts: what holds of the two parts holds of any of these, or of all.
    pub fn meeting<'a>(&'a self, other: &'a Self) -> Vec<(Cow<'a, Self>, Cow<'a, Self>)> {
        let layers = self.meeting_layers(other).into_iter();
        layers
            .map(|(i, j)| (self.layer(i), other.layer(j)))
            .collect()
    }

    /// All edges, each with the share of its layer in the height of the stack: all heights at which there is material.
    pub(super) fn weighted_edges(&self) -> impl Iterator<Item = (Edge, f64)> {
        let mut heights: Vec<[f64; 2]> = self.layers.iter().filter_map(|l| l.z).collect();
        heights.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut stack, mut top) = (0.0, f64::NEG_INFINITY);
        for [lo, hi] in heights {
            stack += (hi - lo.max(top)).max(0.0);
            top = top.max(hi);
        }
        self.layers.iter().flat_map(move |layer| {
            let share = layer.z.map_or(1.0, |[lo, hi]| (hi - lo) / stack);
            let edges = self.loops[layer.loops()].iter().flat_map(Loop::edges);
            edges.map(move |e| (e, share))
        })
    }

    /// For every loop, the first one that is drawn alike and has its material on the same side: a bore through several layers is one bore.
    pub(crate) fn drawn_first(&self) -> Vec<usize> {
        let first = |l: usize| (0..l).find(|&k| self.loops[k] == self.loops[l]);
        match self.layers.len() {
            1 => (0..self.loops.len()).collect(),
            _ => (0..self.loops.len())
                .map(|l| first(l).unwrap_or(l))
                .collect(),
        }
    }
}

/// For every loop of a part, the heights at which it is a boundary: those of all loops drawn like it at the first of them, and none at the
/// others. `None` if the part is at every height.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LoopHeights(Option<Vec<Vec<Heights>>>);

impl LoopHeights {
    pub(crate) fn of(part: &Part) -> Self {
        if !part.has_heights() {
            return Self(None);
        }
        let mut heights = vec![Vec::new(); part.loops.len()];
        let first = part.drawn_first();
        for layer in &part.layers {
            for l in layer.loops() {
                heights[first[l]].push(layer.z);
            }
        }
        Self(Some(heights))
    }

    fn at(&self, l: usize) -> &[Heights] {
        (self.0.as_ref()).map_or(&[None], |heights| &heights[l])
    }

    fn count(&self) -> usize {
        self.0.as_ref().map_or(1, Vec::len)
    }
}

/// The loops of two parts that meet at some height.
#[derive(Debug)]
pub(crate) struct MeetingLoops {
    /// For every loop of the first part, for every one of the second; `None` if all meet.
    meet: Option<Vec<Vec<bool>>>,
}

impl MeetingLoops {
    pub(crate) fn of(first: &LoopHeights, second: &LoopHeights) -> Self {
        let any = |a: usize, b: usize| {
            let heights = second.at(b);
            (first.at(a).iter()).any(|&a| heights.iter().any(|&b| meet(a, b)))
        };
        let row = |a: usize| (0..second.count()).map(|b| any(a, b)).collect();
        let has_heights = first.0.is_some() || second.0.is_some();
        Self {
            meet: has_heights.then(|| (0..first.count()).map(row).collect()),
        }
    }

    /// Whether features of two loops can touch.
    pub(crate) fn hold(&self, first: u32, second: u32) -> bool {
        (self.meet.as_ref()).is_none_or(|meet| {
            let row = &meet[(first as usize).min(meet.len() - 1)];
            row[(second as usize).min(row.len() - 1)]
        })
    }
}
