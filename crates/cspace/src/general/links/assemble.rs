//! From free cells to the contact graph: chains of cells become patches, and patches are copied from slab to slab.

use std::collections::BTreeSet;

use crate::contact::{ContactFunction, SlabMotion};
use crate::feature::{FeatureName, Outline};
use crate::parallel;

use crate::general::cells::cell::END;
use crate::general::limits::MOST_PATCHES;
use crate::general::links::chains::{Chain, Chains, Linker};
use crate::general::links::copies::Lifts;
use crate::general::links::neighbours::Links;
use crate::general::links::regions::{Copying, find_regions};
use crate::general::plan::Names;
use crate::general::verdict::doubt::doubts;
use crate::general::verdict::shells::Shells;
use crate::space::{
    Boundary, FreeRegion, Patch, SideLink, Surface, VerticalLink, Walk, Window, bands,
};

/// Everything the graph is made from.
pub(crate) struct Assembler<'a> {
    pub(crate) linker: Linker<'a>,
    pub(crate) shells: &'a Shells,
    /// Orientations that are in doubt in the slab that was computed.
    pub(crate) doubtful: &'a [(f64, f64)],
    pub(crate) window: Window,
    pub(crate) names: &'a Names,
}

/// The contact graph: all of a contact space that is found by computing.
pub(crate) struct Graph {
    pub(crate) critical_orientations: Vec<f64>,
    pub(crate) patches: Vec<Patch>,
    pub(crate) side_links: Vec<SideLink>,
    pub(crate) vertical_links: Vec<VerticalLink>,
    pub(crate) free_regions: Vec<FreeRegion>,
    pub(crate) computed_bands: u32,
    pub(crate) doubtful_orientations: Vec<(f64, f64)>,
    pub(crate) walk: Walk,
}

impl Assembler<'_> {
    /// Whether a patch would lie on a circle that was divided to make the part symmetric.
    pub(crate) fn divides_contacts(&self) -> bool {
        let Linker {
            geometry, cells, ..
        } = self.linker;
        (0u32..)
            .zip(cells)
            .filter(|&(i, _)| self.shells.free[i as usize])
            .any(|(i, _)| {
                let sheet = self.linker.sheet(i);
                let fixed = geometry.fixed.features[sheet.fixed as usize].name;
                let moving = geometry.moving.features[sheet.moving as usize].name;
                self.names.divides(fixed, moving)
            })
    }

    /// `None` if there are more patches than a contact space has room for.
    pub(crate) fn assemble(&self) -> Option<Graph> {
        let Linker {
            geometry, clusters, ..
        } = self.linker;
        let chains = self.linker.chains(self.shells);
        let steps = geometry.contacts.period.steps;
        let repeats = geometry.contacts.span.full;
        let lifts = Lifts::new(&chains.chains, self.window, steps, repeats, clusters);
        if lifts.len() > MOST_PATCHES {
            return None;
        }
        let mut patches = self.patches(&chains, &lifts);
        let links = Links {
            linker: self.linker,
            shells: self.shells,
            chains: &chains,
            lifts: &lifts,
        };
        let (side_links, vertical_links) =
            parallel::join(|| links.side(&patches), || links.vertical());
        let critical_orientations = lifts.critical_orientations(&chains.chains);
        let bands = bands(self.window, &critical_orientations).len();
        let doubtful_orientations = doubts(
            self.doubtful,
            &lifts,
            (&patches, &side_links),
            &critical_orientations,
            self.window,
        );
        let walk = Walk::new(patches.len(), &side_links, &vertical_links);
        let copying = if steps.slabs == 1 {
            Copying::None {
                shells: self.shells_of_patches(&chains, &lifts),
            }
        } else if self.window.full_turn {
            Copying::Slabs(steps)
        } else {
            Copying::Some
        };
        let surface = Surface {
            window: self.window,
            frame: &geometry.frame,
            critical_orientations: &critical_orientations,
            patches: &patches,
            side_links: &side_links,
            walk: &walk,
            doubtful: &doubtful_orientations,
        };
        let regions = find_regions(&surface, &vertical_links, &copying);
        for (patch, region) in patches.iter_mut().zip(regions.of_patches) {
            patch.region = region;
        }
        Some(Graph {
            computed_bands: lifts.computed_bands(&chains.chains, bands) as u32,
            critical_orientations,
            patches,
            side_links,
            vertical_links,
            free_regions: regions.regions,
            doubtful_orientations,
            walk,
        })
    }

    /// The shell of each patch, unless an end of the window cuts it: what hangs together beyond does not count.
    fn shells_of_patches(&self, chains: &Chains, lifts: &Lifts<'_>) -> Vec<Option<u32>> {
        let shell = |c: &Chain| self.shells.shell[c.first as usize];
        let cut: BTreeSet<u32> = ((0u32..).zip(&chains.chains))
            .filter(|&(i, c)| {
                let mut copies = lifts.patches(i).peekable();
                copies.peek().is_none() || copies.any(|(slabs, _)| !lifts.is_whole(c, slabs))
            })
            .map(|(_, c)| shell(c))
            .collect();
        let mut shells = vec![None; lifts.len()];
        for (i, c) in (0u32..).zip(&chains.chains) {
            for (_, number) in lifts.patches(i) {
                shells[number as usize] = Some(shell(c)).filter(|s| !cut.contains(s));
            }
        }
        shells
    }

    /// Every copy of every chain, those of a block of chains after those of the one before.
    fn patches(&self, chains: &Chains, lifts: &Lifts<'_>) -> Vec<Patch> {
        let geometry = self.linker.geometry;
        let period = &geometry.contacts.period;
        /// Chains whose first copies are held at a time, beside all patches.
        const BLOCK: usize = 1 << 14;
        let mut patches = Vec::with_capacity(lifts.len());
        let mut before = 0;
        for block in chains.chains.chunks(BLOCK) {
            let firsts = parallel::map(block, 256, |c| self.patch(c));
            let copies = (before..).take(block.len());
            let count: usize = copies.map(|c| lifts.patches(c).count()).sum();
            patches.resize(patches.len() + count, firsts[0]);
            // Slab by slab, so that features are carried on step by step.
            let mut fixed = Images::new(&geometry.fixed);
            let mut moving = Images::new(&geometry.moving);
            for slab in 0..i64::from(lifts.steps.slabs) {
                if slab > 0 {
                    fixed.carry(&period.fixed.features);
                    moving.carry(&period.moving.features);
                }
                let motion = lifts.steps.motion(slab);
                for (c, (chain, first)) in (before..).zip(block.iter().zip(&firsts)) {
                    let sheet = self.linker.sheet(chain.first);
                    for (slabs, number) in lifts.patches_in(c, slab) {
                        let mut patch = copied(first, &motion);
                        (patch.lo, patch.hi) = lifts.interval(chain, slabs);
                        patch.fixed = self.names.fixed(fixed.name(sheet.fixed));
                        patch.moving = self.names.moving(moving.name(sheet.moving));
                        patches[number as usize] = patch;
                    }
                }
            }
            before += block.len() as u32;
        }
        patches
    }

    /// The patch of a chain in the slab of its first cell.
    fn patch(&self, chain: &Chain) -> Patch {
        let linker = &self.linker;
        let cell = &linker.cells[chain.first as usize];
        let sheet = linker.sheet(chain.first);
        let geometry = linker.geometry;
        let bound = |bound: u32, spiral| {
            if bound == END {
                return Boundary::End { spiral };
            }
            let b = &linker.branches[bound as usize];
            let with: ContactFunction =
                geometry.contacts.sheets[b.other(cell.sheet) as usize].function();
            Boundary::Crossing {
                with,
                root: linker.own_root(b, cell.sheet),
            }
        };
        Patch {
            fixed: geometry.fixed.features[sheet.fixed as usize].name,
            moving: geometry.moving.features[sheet.moving as usize].name,
            function: sheet.function(),
            lo: chain.lo,
            hi: chain.hi,
            left: bound(cell.left, sheet.start),
            right: bound(cell.right, sheet.end),
            region: 0,
        }
    }
}

/// A patch's surface and bounds some slabs further.
fn copied(patch: &Patch, motion: &SlabMotion) -> Patch {
    let boundary = |b: Boundary| match b {
        Boundary::End { spiral } => Boundary::End {
            spiral: motion.spiral(spiral),
        },
        Boundary::Crossing { with, root } => Boundary::Crossing {
            with: motion.function(with),
            root,
        },
    };
    Patch {
        function: motion.function(patch.function),
        left: boundary(patch.left),
        right: boundary(patch.right),
        ..*patch
    }
}

/// Where the features of a part are after some slabs.
struct Images<'a> {
    outline: &'a Outline,
    at: Vec<u32>,
}

impl<'a> Images<'a> {
    fn new(outline: &'a Outline) -> Self {
        Self {
            outline,
            at: (0..outline.features.len() as u32).collect(),
        }
    }

    fn carry(&mut self, one_slab: &[u32]) {
        for i in &mut self.at {
            *i = one_slab[*i as usize];
        }
    }

    fn name(&self, feature: u32) -> FeatureName {
        self.outline.features[self.at[feature as usize] as usize].name
    }
}
