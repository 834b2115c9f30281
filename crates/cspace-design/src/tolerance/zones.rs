//! Contact zones: which configurations of a pair are free whatever is made within the tolerances, which are blocked, and the bands between
//! (Kyung and Sacks 2003).
//!
//! A window is divided into cells. A cell in which no features may touch in any drawing within the tolerances, by enclosures of all contact
//! functions, is free or blocked as a whole, as one configuration of one drawing tells; so is blocked a cell in which one point is inside both parts
//! in every drawing. The others are divided, down to the smallest, which are in a band of the contacts that may come about, as is what is free in
//! one drawing and blocked in another all over. A band is never too narrow, and too wide by some cells.

use std::sync::Arc;

use crate::drawn::{ConfigurationBox, DrawnContact, DrawnPair, Witness};
use cspace::{
    Configuration, Edge, Layer, Part, Point, Progress, Real, Relation, Vector, overlap_as_drawn,
    parallel,
};
use cspace_model::model::{Setting, Subject, Template};
use cspace_model::{Model, PairEntry};
use schemars::JsonSchema;
use serde::Serialize;

use super::Variations;
use super::study::Study;
use super::vary::{self, middle_and_half};
use crate::check::Interrupted;
use crate::drawing::{Enclosed, TOLD_APART, drawn_pair};

/// The zones of a pair in a window.
#[derive(Debug, Clone, Default, Serialize, JsonSchema)]
pub struct Zones {
    /// Free in every drawing within the tolerances.
    pub free: Vec<Cell>,
    /// Blocked in every drawing.
    pub blocked: Vec<Cell>,
    /// The others, by what may touch there.
    pub bands: Vec<ZoneBand>,
}

/// Where some features may touch.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ZoneBand {
    /// The features of the fixed and of the moving part, as messages call them.
    pub features: [String; 2],
    /// Cells; where several pairs of features may touch, each has the cell.
    pub cells: Vec<Cell>,
}

/// A rectangle: the ranges of both coordinates.
pub type Cell = [(f64, f64); 2];

/// The area of cells that do not overlap: of the one coordinate times the other.
///
/// ```
/// assert_eq!(cspace_design::area(&[[(0.0, 2.0), (0.0, 3.0)], [(2.0, 3.0), (0.0, 1.0)]]), 7.0);
/// ```
pub fn area(cells: &[Cell]) -> f64 {
    let area = |[u, v]: &Cell| (u.1 - u.0) * (v.1 - v.0);
    cells.iter().map(area).sum()
}

/// Why there are no zones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NoZones {
    /// The computation was interrupted.
    #[error("{Interrupted}")]
    Interrupted,
    /// The parts are connected.
    #[error("the parts are connected by a joint, or nothing is drawn within the tolerances")]
    NotDrawn,
}

impl From<Interrupted> for NoZones {
    fn from(_: Interrupted) -> Self {
        Self::Interrupted
    }
}

/// The first division of a window, and how often a cell is halved in both directions.
const COARSE: usize = 16;
const HALVINGS: u32 = 5;

/// Cells are not divided where there would be more to look at.
const MOST: usize = 40_000;

/// The zones of a pair over a window: of u and v, or of x and y at an orientation θ.
///
/// # Errors
/// If the pair is not drawn, or the progress ends the computation.
pub fn zones(
    template: &Template,
    set: &[Setting],
    model: &Model,
    (pair, window, theta): (PairEntry, Cell, f64),
    progress: &dyn Progress,
) -> Result<Zones, NoZones> {
    let variations = Variations::of(model);
    // A study of any requirement of the pair has the numbers of the drawing.
    let mut requirements = model.requirements.iter();
    let requirement = requirements.find(|r| matches!(r.subject, Subject::Pair(p, _) if p == pair));
    let requirement = requirement.ok_or(NoZones::NotDrawn)?.clone();
    let study = Study::new(template, set, (&variations, model, requirement), progress);
    let whole = variations.scaled(1.0);
    let drawn_in = |ranges: &[[f64; 2]]| Drawn::new(&study, pair, ranges);
    let drawn = drawn_in(&whole).ok_or(NoZones::NotDrawn)?;
    let pieces: Option<Vec<Drawn>> = divided(&whole).iter().map(|r| drawn_in(r)).collect();
    let corners = study.corners(1.0).into_iter();
    let point = |at: Vec<f64>| drawn_in(&at.iter().map(|x| [*x, *x]).collect::<Vec<_>>());
    let search = Search {
        study: &study,
        corners: corners.filter_map(point).collect(),
        witnesses: [0, 1].map(|part| {
            let deviation = drawn.of.deviation(part);
            let layers = drawn.layers[part].iter();
            let of = |(layer, part): &(Layer, Part)| {
                let found = witnesses(part, deviation).into_iter();
                found
                    .map(|(w, depth)| (w, depth, layer.clone()))
                    .collect::<Vec<_>>()
            };
            layers.flat_map(of).collect()
        }),
        parameters: variations.len(),
        is_planar: matches!(drawn.model.mechanism.relation(&pair), Relation::Planar),
        pieces: pieces.ok_or(NoZones::NotDrawn)?,
        drawn,
        theta,
    };
    search.all(window)
}

/// The tolerances in pieces: what is in doubt of all of them may be certain of each.
fn divided(whole: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    /// More parameters are not divided.
    const MOST: usize = 4;
    let mut all = vec![whole.to_vec()];
    let wide = (0..whole.len()).filter(|&k| whole[k][0] < whole[k][1]);
    for k in wide.take(MOST) {
        all = (all.iter())
            .flat_map(|ranges| vary::halves(ranges, k))
            .collect();
    }
    all
}

/// The pair as it is drawn within some of the tolerances.
struct Drawn {
    /// In their middle.
    model: Model,
    pair: PairEntry,
    of: DrawnPair<Enclosed>,
    /// The layers of both parts in the middle.
    layers: [Vec<(Layer, Part)>; 2],
}

impl Drawn {
    fn new(study: &Study<'_>, pair: PairEntry, ranges: &[[f64; 2]]) -> Option<Self> {
        let (middle, half) = middle_and_half(ranges);
        let (model, all) = study.enclosures(&middle, Some(&half))?;
        let of = drawn_pair(&model, pair, all.first())?.map(|x| x.value);
        let layers = [pair.fixed, pair.moving].map(|i| {
            let part = &model.mechanism.parts[i].part;
            let layers = part.layers().iter().enumerate();
            layers
                .map(|(i, layer)| (layer.clone(), part.layer(i).into_owned()))
                .collect()
        });
        Some(Self {
            model,
            pair,
            of,
            layers,
        })
    }

    fn part(&self, part: usize) -> &Part {
        let index = [self.pair.fixed, self.pair.moving][part];
        &self.model.mechanism.parts[index].part
    }

    /// Whether the parts in the middle overlap.
    fn overlap(&self, at: [f64; 3]) -> bool {
        let placed = self.of.placed(at.map(Real::constant));
        let [x, y] = placed.position.map(|p: Enclosed| p.mid);
        let theta = placed.sin.mid.atan2(placed.cos.mid);
        overlap_as_drawn(self.part(0), self.part(1), Configuration::new(x, y, theta))
    }
}

struct Search<'a> {
    study: &'a Study<'a>,
    /// Within all tolerances.
    drawn: Drawn,
    /// At corners of them.
    corners: Vec<Drawn>,
    /// Within pieces of them.
    pieces: Vec<Drawn>,
    /// Points inside both parts, how deep they are in every drawing, and in which layer.
    witnesses: [Vec<(Witness, f64, Layer)>; 2],
    /// How many parameters vary.
    parameters: usize,
    is_planar: bool,
    theta: f64,
}

/// Boxes of configurations.
type Region = ConfigurationBox<Enclosed>;

/// State of a cell.
#[derive(PartialEq)]
enum State {
    Free,
    Blocked,
    Band(Vec<DrawnContact>),
}

/// Points inside a part with their depths, in every drawing: its boundary may be off by so much.
fn witnesses(part: &Part, deviation: f64) -> Vec<(Witness, f64)> {
    /// The largest depth that is tried, relative to the part, and how often it is halved.
    const DEEPEST: f64 = 0.25;
    const HALVINGS: i32 = 8;
    /// Where along an edge.
    const ALONG: [f64; 5] = [0.5, 0.06, 0.94, 0.25, 0.75];
    const MOST: usize = 256;
    let mut found = Vec::new();
    let depths = (0..HALVINGS).map(|k| DEEPEST * part.size() * 0.5_f64.powi(k));
    for depth in depths {
        for edge in part.edges() {
            for along in ALONG {
                let at = edge.at(along) + inwards(&edge, along) * depth;
                if part.contains(at) {
                    let depth = distance(part, at) - deviation;
                    found.push((Witness::Inside([at.x, at.y]), depth));
                }
            }
        }
    }
    found.retain(|(_, depth)| *depth > 0.0);
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    let step = found.len().div_ceil(MOST).max(1);
    found.into_iter().step_by(step).collect()
}

/// The unit vector into the material, which is on the left of travel.
fn inwards(edge: &Edge, along: f64) -> Vector {
    let across = if edge.is_line() {
        -(edge.end - edge.start).right()
    } else {
        let towards = edge.center() - edge.at(along);
        if edge.bulge > 0.0 { towards } else { -towards }
    };
    across * (1.0 / across.length())
}

/// From a point to the boundary of a part.
fn distance(part: &Part, at: Point) -> f64 {
    let distances = part.edges().map(|edge| edge.distance(at));
    distances.fold(f64::INFINITY, f64::min)
}

/// Result of one look at a cell.
enum Looked {
    Is(State),
    /// Some contacts may come about, and it may help to divide.
    Doubtful(Vec<DrawnContact>),
}

/// Contacts that cells share.
type Shared = Arc<[DrawnContact]>;

impl Search<'_> {
    fn all(&self, window: Cell) -> Result<Zones, NoZones> {
        let part = |(lo, hi): (f64, f64), i: usize| {
            let at = |i: usize| lo + (hi - lo) * (i as f64 / COARSE as f64);
            (at(i), at(i + 1))
        };
        let coarse = (0..COARSE).flat_map(|j| (0..COARSE).map(move |i| (i, j)));
        let coarse: Vec<Cell> = coarse
            .map(|(i, j)| [part(window[0], i), part(window[1], j)])
            .collect();
        let mut found: Vec<(Cell, State)> = Vec::new();
        let mut open: Vec<(Cell, Option<Shared>)> = coarse.into_iter().map(|c| (c, None)).collect();
        for halvings in (0..=HALVINGS).rev() {
            let states = self.states(&open, |cell, known| self.look(cell, known))?;
            let mut doubtful = Vec::new();
            for ((cell, _), looked) in open.iter().zip(states) {
                match looked {
                    Looked::Is(state) => found.push((*cell, state)),
                    Looked::Doubtful(contacts) => {
                        doubtful.push((*cell, Some(Shared::from(contacts))));
                    }
                }
            }
            if halvings > 0 && 4 * doubtful.len() <= MOST {
                open = (doubtful.iter())
                    .flat_map(|(cell, known)| quarters(*cell).map(|c| (c, known.clone())))
                    .collect();
                continue;
            }
            // What is left is told by pieces of the tolerances, if there is not too much of it.
            let by_pieces = doubtful.len() * self.pieces.len() <= 2 * MOST;
            let last = |cell: Cell, known: &[DrawnContact]| {
                if by_pieces {
                    self.state_by_pieces(&self.within(cell), known)
                } else {
                    State::Band(known.to_vec())
                }
            };
            let states = self.states(&doubtful, |cell, known| {
                last(cell, known.unwrap_or_default())
            })?;
            found.extend(doubtful.iter().map(|d| d.0).zip(states));
            break;
        }
        let mut zones = Zones::default();
        let mut bands: Vec<(DrawnContact, Vec<Cell>)> = Vec::new();
        for (cell, state) in found {
            match state {
                State::Free => zones.free.push(cell),
                State::Blocked => zones.blocked.push(cell),
                State::Band(contacts) => {
                    for contact in contacts {
                        match bands.iter_mut().find(|b| b.0 == contact) {
                            Some(band) => band.1.push(cell),
                            None => bands.push((contact, vec![cell])),
                        }
                    }
                }
            }
        }
        bands.sort_by_key(|b| b.0);
        let bands = bands.into_iter().map(|(contact, cells)| {
            let [fixed, moving] = self.drawn.of.names(contact);
            ZoneBand {
                features: [
                    self.drawn.part(0).feature_text(fixed),
                    self.drawn.part(1).feature_text(moving),
                ],
                cells: joined(cells),
            }
        });
        zones.bands = bands.collect();
        (zones.bands).sort_by(|a, b| area(&b.cells).total_cmp(&area(&a.cells)));
        zones.free = joined(zones.free);
        zones.blocked = joined(zones.blocked);
        Ok(zones)
    }

    /// State of each cell, derived from that of one around it.
    fn states<S: Send>(
        &self,
        cells: &[(Cell, Option<Shared>)],
        of: impl Fn(Cell, Option<&[DrawnContact]>) -> S + Sync,
    ) -> Result<Vec<S>, Interrupted> {
        let state = |(cell, known): &(Cell, Option<Shared>)| {
            if self.study.goes_on() {
                Ok(of(*cell, known.as_deref()))
            } else {
                Err(Interrupted)
            }
        };
        parallel::map(cells, 1, state).into_iter().collect()
    }

    fn look(&self, cell: Cell, known: Option<&[DrawnContact]>) -> Looked {
        let within = self.within(cell);
        match self.state(&self.drawn, &within, known) {
            State::Band(contacts) if self.is_between(&within) => {
                // What may touch in the middle tells what the band is of.
                let middle = self.cell(within.middle, [0.0; 2]);
                Looked::Is(State::Band(
                    self.drawn.of.contacts_in(&middle, Some(&contacts)),
                ))
            }
            State::Band(contacts) => Looked::Doubtful(contacts),
            state => Looked::Is(state),
        }
    }

    fn within(&self, cell: Cell) -> Region {
        let third = if self.is_planar { self.theta } else { 0.0 };
        let half = |(lo, hi): (f64, f64)| 0.5 * (hi - lo);
        let middle = [mid(cell[0]), mid(cell[1]), third];
        self.cell(middle, cell.map(half))
    }

    /// A box about a configuration. Its coordinates are told apart from the parameters, where there are not too many of these.
    fn cell(&self, middle: [f64; 3], half: [f64; 2]) -> Region {
        let half = [half[0], half[1], 0.0];
        let first = self.parameters.max(TOLD_APART - 2);
        ConfigurationBox {
            middle,
            half,
            all: [0, 1, 2].map(|i| Enclosed::variable(middle[i], half[i], first + i)),
        }
    }

    /// Whether some drawing is free and another is blocked in the middle of a box and at its corners: to divide it tells no more.
    fn is_between(&self, within: &Region) -> bool {
        let ([x, y, z], [a, b, _]) = (within.middle, within.half);
        let signs = [
            (0.0, 0.0),
            (-1.0, -1.0),
            (1.0, -1.0),
            (-1.0, 1.0),
            (1.0, 1.0),
        ];
        signs.into_iter().all(|(i, j)| {
            let at = [x + i * a, y + j * b, z];
            let mut found = [false; 2];
            self.corners.iter().any(|drawn| {
                found[usize::from(drawn.overlap(at))] = true;
                found == [true; 2]
            })
        })
    }

    fn state(&self, drawn: &Drawn, within: &Region, among: Option<&[DrawnContact]>) -> State {
        let contacts = drawn.of.contacts_in(within, among);
        let overlap = drawn.overlap(within.middle);
        match (contacts.is_empty(), overlap) {
            (true, false) => State::Free,
            (true, true) => State::Blocked,
            (false, true) if self.is_inside_both(drawn, within) => State::Blocked,
            _ => State::Band(contacts),
        }
    }

    /// As [`state`](Self::state), of what is in doubt, by pieces of the tolerances.
    fn state_by_pieces(&self, within: &Region, among: &[DrawnContact]) -> State {
        let mut known: Option<State> = None;
        let mut contacts: Vec<DrawnContact> = Vec::new();
        let mut is_certain = true;
        for drawn in &self.pieces {
            match self.state(drawn, within, Some(among)) {
                State::Band(more) => {
                    is_certain = false;
                    contacts.extend(more);
                }
                state => {
                    is_certain &= known.as_ref().is_none_or(|known| *known == state);
                    known = Some(state);
                }
            }
        }
        match known {
            Some(known) if is_certain => known,
            // Free in one piece and blocked in another: something touches between.
            _ if contacts.is_empty() => State::Band(among.to_vec()),
            _ => {
                contacts.sort_unstable();
                contacts.dedup();
                State::Band(contacts)
            }
        }
    }

    /// Whether a point is inside both parts at all configurations of a box, in every drawing.
    fn is_inside_both(&self, drawn: &Drawn, within: &Region) -> bool {
        /// Number of points deepest in both parts that are tried.
        const TRIED: usize = 3;
        let placed = drawn.of.placed(within.middle.map(Real::constant));
        let mut inside = Vec::new();
        for (there, part) in [(placed.inverse(), 0), (placed, 1)] {
            let deep = (self.witnesses[part].iter()).map(|(w, depth, layer)| (*w, *depth, layer));
            let outline = drawn.of.outline(part);
            for (witness, depth, layer) in deep.chain(outline.map(|(w, l)| (w, f64::INFINITY, l))) {
                let [x, y] = there.point(drawn.of.place(part, witness));
                let at = Point::new(x.mid, y.mid);
                let meeting = drawn.layers[1 - part].iter().filter(|l| layer.meets(&l.0));
                for (_, other) in meeting.filter(|l| l.1.contains(at)) {
                    inside.push((depth.min(distance(other, at)), part, witness));
                }
            }
        }
        inside.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut best = inside.iter().take(TRIED);
        best.any(|&(_, part, witness)| !drawn.of.may_pass(within, part, witness))
    }
}

fn mid((lo, hi): (f64, f64)) -> f64 {
    0.5 * (lo + hi)
}

fn quarters([u, v]: Cell) -> [Cell; 4] {
    let ([a, b], [c, d]) = (halves(u), halves(v));
    [[a, c], [b, c], [a, d], [b, d]]
}

fn halves((lo, hi): (f64, f64)) -> [(f64, f64); 2] {
    let middle = mid((lo, hi));
    [(lo, middle), (middle, hi)]
}

/// Cells side by side joined, where they are of one height.
fn joined(mut cells: Vec<Cell>) -> Vec<Cell> {
    let key = |c: &Cell| (c[1], c[0]);
    cells.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        (a.0.0.total_cmp(&b.0.0))
            .then(a.0.1.total_cmp(&b.0.1))
            .then(a.1.0.total_cmp(&b.1.0))
    });
    let mut joined: Vec<Cell> = Vec::new();
    for cell in cells {
        match joined.last_mut() {
            Some(last) if last[1] == cell[1] && last[0].1 == cell[0].0 => last[0].1 = cell[0].1,
            _ => joined.push(cell),
        }
    }
    joined
}
