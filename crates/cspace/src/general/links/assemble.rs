//! Builds the contact graph from free cells: chains of cells become patches, and patches are copied to all periods.

use std::collections::BTreeSet;

use crate::contact::{ContactFunction, Geometry, SlabMotion};
use crate::feature::{FeatureName, Outline, PairFrame};
use crate::ids::RegionId;
use crate::parallel;

use crate::general::cells::cell::{Cell, END};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::limits::MOST_PATCHES;
use crate::general::links::chains::{Chain, Chains, Linker, Members};
use crate::general::links::copies::Lifts;
use crate::general::links::neighbours::Links;
use crate::general::links::regions::{Copying, find_regions};
use crate::general::plan::Names;
use crate::general::verdict::doubt::doubts;
use crate::general::verdict::shells::Shells;
use crate::slice::Slice;
use crate::space::{
    Boundary, FreeRegion, Patch, SideLink, Surface, VerticalLink, Walk, Window, bands,
};

/// Cells of one period with their classes. They are large, and each part is dropped when it is no longer needed.
pub(crate) struct Judged {
    pub(crate) clusters: Clusters,
    pub(crate) branches: Vec<Branch>,
    pub(crate) cells: Vec<Cell>,
    pub(crate) shells: Shells,
    /// Doubtful orientations of the period that was computed.
    pub(crate) doubtful: Vec<(f64, f64)>,
}

/// Makes the graph of judged cells.
pub(crate) struct Assembler<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) window: Window,
    pub(crate) names: &'a Names,
    pub(crate) judged: Judged,
}

/// Patches and links, before regions are assigned.
pub(crate) struct Linked {
    window: Window,
    critical_orientations: Vec<f64>,
    pub(crate) patches: Vec<Patch>,
    side_links: Vec<SideLink>,
    vertical_links: Vec<VerticalLink>,
    computed_bands: u32,
    doubtful_orientations: Vec<(f64, f64)>,
    copying: Copying,
}

/// The contact graph: the computed part of a contact space.
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
    fn linker(&self) -> Linker<'_> {
        Linker {
            geometry: self.geometry,
            clusters: &self.judged.clusters,
            branches: &self.judged.branches,
            cells: &self.judged.cells,
        }
    }

    /// Whether a patch would lie on a circle that was divided to make the part symmetric.
    pub(crate) fn divides_contacts(&self) -> bool {
        let (geometry, linker) = (self.geometry, self.linker());
        (0u32..)
            .zip(&self.judged.cells)
            .filter(|&(i, _)| self.judged.shells.free[i as usize])
            .any(|(i, _)| {
                let sheet = linker.sheet(i);
                let fixed = geometry.fixed.features[sheet.fixed as usize].name;
                let moving = geometry.moving.features[sheet.moving as usize].name;
                self.names.divides(fixed, moving)
            })
    }

    /// Chains of the free cells, after which there are no others; `None` if they make more patches than the limit.
    pub(crate) fn chains(&mut self) -> Option<Chains> {
        self.drop_blocked();
        let chains = self.linker().chains(&self.judged.shells);
        let lifts = self.lifts(&chains, &self.judged.clusters);
        (lifts.len() <= MOST_PATCHES).then_some(chains)
    }

    fn lifts<'c>(&self, chains: &Chains, clusters: &'c Clusters) -> Lifts<'c> {
        let contacts = &self.geometry.contacts;
        let (steps, repeats) = (contacts.period.steps, contacts.span.full);
        Lifts::new(&chains.chains, self.window, steps, repeats, clusters)
    }

    /// Copies and links the chains.
    pub(crate) fn link(mut self, mut chains: Chains) -> Linked {
        // Chains are made from contacts in the order in which they were found; links come in order of orientation.
        parallel::sort_by(&mut self.judged.shells.vertical, |a, b| a.at.cmp(&b.at));
        let steps = self.geometry.contacts.period.steps;
        let clusters = core::mem::take(&mut self.judged.clusters);
        let lifts = self.lifts(&chains, &clusters);
        let copying = if steps.slabs == 1 {
            Copying::None {
                shells: shells_of_patches(&self.judged.shells, &chains, &lifts),
            }
        } else if self.window.full_turn {
            Copying::Slabs(steps)
        } else {
            Copying::Some
        };
        let linker = Linker {
            clusters: &clusters,
            ..self.linker()
        };
        let links = Links {
            linker,
            shells: &self.judged.shells,
            chains: &chains,
            lifts: &lifts,
        };
        let (side_links, vertical_links) = parallel::join(|| links.side(), || links.vertical());
        self.judged.shells = Shells::default();
        chains.members = Members::default();
        let patches = self.patches(&chains, &lifts);
        (self.judged.cells, self.judged.branches) = (Vec::new(), Vec::new());
        let critical_orientations = lifts.critical_orientations(&chains.chains);
        let bands = bands(self.window, &critical_orientations).len();
        let doubtful_orientations = doubts(
            &self.judged.doubtful,
            &lifts,
            (&patches, &side_links),
            &critical_orientations,
            self.window,
        );
        Linked {
            window: self.window,
            computed_bands: lifts.computed_bands(&chains.chains, bands) as u32,
            critical_orientations,
            patches,
            side_links,
            vertical_links,
            doubtful_orientations,
            copying,
        }
    }

    /// Drops the cells that are blocked, which are the most, and their contacts: patches are made of free cells.
    fn drop_blocked(&mut self) {
        let shells = &mut self.judged.shells;
        let free = core::mem::take(&mut shells.free);
        let mut kept = 0;
        let moved: Vec<u32> = (free.iter())
            .map(|&free| {
                kept += u32::from(free);
                kept - u32::from(free)
            })
            .collect();
        let is_free = |cell: u32| free[cell as usize];
        let mut number = 0;
        self.judged.cells.retain(|_| {
            number += 1;
            is_free(number - 1)
        });
        self.judged.cells.shrink_to_fit();
        let mut shell = free.iter();
        shells.shell.retain(|_| shell.next() == Some(&true));
        shells.free = vec![true; kept as usize];
        shells.in_conflict = Vec::new();
        shells.vertical.retain_mut(|v| {
            let kept = is_free(v.lower) && is_free(v.upper);
            (v.lower, v.upper) = (moved[v.lower as usize], moved[v.upper as usize]);
            kept
        });
        shells.vertical.shrink_to_fit();
        shells.side.retain_mut(|s| {
            let kept = is_free(s.before) && is_free(s.after);
            (s.before, s.after) = (moved[s.before as usize], moved[s.after as usize]);
            kept
        });
        shells.side.shrink_to_fit();
    }

    /// Patches of all copies of all chains.
    fn patches(&self, chains: &Chains, lifts: &Lifts<'_>) -> Vec<Patch> {
        /// Minimum number of patches per thread.
        const PATCHES: usize = 256;
        let period = &self.geometry.contacts.period;
        let fixed = Images::new(&self.geometry.fixed, &period.fixed.features);
        let moving = Images::new(&self.geometry.moving, &period.moving.features);
        let turn = i64::from(lifts.steps.slabs);
        let motions: Vec<SlabMotion> = (0..turn).map(|slab| lifts.steps.motion(slab)).collect();
        let linker = self.linker();
        parallel::numbered(lifts.len(), PATCHES, |number| {
            let (chain, slabs) = lifts.chain_of(number as u32);
            let chain = &chains.chains[chain as usize];
            let slab = slabs.rem_euclid(turn) as usize;
            let mut patch = self.patch(&linker, chain);
            if slab > 0 {
                patch = copied(&patch, &motions[slab]);
            }
            (patch.lo, patch.hi) = lifts.interval(chain, slabs);
            let sheet = linker.sheet(chain.first);
            patch.fixed = self.names.fixed(fixed.name(sheet.fixed, slab));
            patch.moving = self.names.moving(moving.name(sheet.moving, slab));
            patch
        })
    }

    /// The patch of a chain in the period of its first cell.
    fn patch(&self, linker: &Linker<'_>, chain: &Chain) -> Patch {
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
            left: bound(cell.left, sheet.locus.start),
            right: bound(cell.right, sheet.locus.end),
            region: RegionId(0),
        }
    }
}

impl Linked {
    /// The slice at `theta`, an orientation of the window, with positions given at `asked`, which differs from it by whole turns.
    pub(crate) fn slice(&self, theta: f64, asked: f64, frame: &PairFrame) -> Slice {
        let walk = Walk::new(self.patches.len(), &self.side_links, &self.vertical_links);
        let surface = Surface {
            window: self.window,
            frame,
            critical_orientations: &self.critical_orientations,
            patches: &self.patches,
            side_links: &self.side_links,
            walk: &walk,
            doubtful: &self.doubtful_orientations,
        };
        surface.slice_of(theta, asked, 0..self.patches.len() as u32)
    }

    /// Completes the graph by critical orientations and regions.
    pub(crate) fn graph(self, frame: &PairFrame) -> Graph {
        let Self {
            window,
            critical_orientations,
            mut patches,
            side_links,
            vertical_links,
            computed_bands,
            doubtful_orientations,
            copying,
        } = self;
        let walk = Walk::new(patches.len(), &side_links, &vertical_links);
        let surface = Surface {
            window,
            frame,
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
        Graph {
            critical_orientations,
            patches,
            side_links,
            vertical_links,
            free_regions: regions.regions,
            computed_bands,
            doubtful_orientations,
            walk,
        }
    }
}

/// The shell of each patch, unless an end of the window cuts it: connections beyond the window do not count.
fn shells_of_patches(all: &Shells, chains: &Chains, lifts: &Lifts<'_>) -> Vec<Option<u32>> {
    let shell = |c: &Chain| all.shell[c.first as usize];
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

/// A patch moved up by some periods: its surface and bounds.
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

/// Images of the features of a part after some periods: each feature returns to itself after one cycle of the permutation.
struct Images<'a> {
    outline: &'a Outline,
    /// Cycles of the permutation, one after the other.
    rounds: Vec<u32>,
    /// For each feature, the beginning of its cycle, the cycle's length, and the feature's position in it.
    places: Vec<[u32; 3]>,
}

impl<'a> Images<'a> {
    /// Images from the permutation of the features by one period.
    fn new(outline: &'a Outline, one_slab: &[u32]) -> Self {
        const NONE: [u32; 3] = [u32::MAX; 3];
        let mut rounds = Vec::with_capacity(one_slab.len());
        let mut places = vec![NONE; one_slab.len()];
        for feature in 0..one_slab.len() as u32 {
            let first = rounds.len() as u32;
            let mut at = feature;
            while places[at as usize] == NONE {
                places[at as usize] = [first, 0, rounds.len() as u32 - first];
                rounds.push(at);
                at = one_slab[at as usize];
            }
            for member in &rounds[first as usize..] {
                places[*member as usize][1] = rounds.len() as u32 - first;
            }
        }
        Self {
            outline,
            rounds,
            places,
        }
    }

    fn name(&self, feature: u32, slabs: usize) -> FeatureName {
        let [first, length, at] = self.places[feature as usize].map(|v| v as usize);
        let image = self.rounds[first + (at + slabs) % length];
        self.outline.features[image as usize].name
    }
}
