"""Answers of the questions to a model. Written by answers.py from the schemas of the command's answers."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ._record import Record, configuration, each_of, number_or_configuration


class Allocated(Record):
    """The tolerance allocated to a parameter."""

    cost: float
    """The cost of the tolerance given."""
    factor: float
    """The tolerance allocated, relative to that given."""
    matters: bool
    """Whether it has an influence on what is required; otherwise the tolerance stays."""
    minus: float | None
    """How far the parameter may be below its value, if it is in no zone."""
    plus: float | None
    """How far it may be above its value, if it is in no zone."""
    position: float | None
    """The diameter of its zone, if it is a coordinate of a point in one."""


class Extreme(Record):
    """The smallest or the largest value within the tolerances."""

    at: dict[str, float]
    """The values of the parameters there, by their names."""
    certified: bool
    """Whether it is proved that nothing within the tolerances is beyond it."""
    failure: str | None
    """Why there is none."""
    gap: float | None
    """How much farther it might be at most, where it is not proved and that is known."""
    jumps: bool | None
    """True where the value jumps at the place and comes as near to this as one likes; left out otherwise."""
    value: float | None
    """The value; null where there is none."""


class Extremes(Record):
    """The smallest and the largest value within the tolerances."""

    hi: Extreme
    """The largest value."""
    lo: Extreme
    """The smallest value."""


class Histogram(Record):
    """Bars of equal width."""

    counts: list[int]
    """How many values are in each bar."""
    edges: list[float]
    """The edges of the bars."""


class Samples(Record):
    """Results of samples by chance."""

    above: float
    """The share above the limits."""
    below: float
    """The share below the limits."""
    computed: float
    """The share of samples that needed a configuration space of their own."""
    error: float
    """The standard error of that share."""
    failures: dict[str, float]
    """The shares without a value, by kind."""
    histogram: Histogram
    """How the values are distributed."""
    kurtosis: float | None
    """Their excess kurtosis."""
    mean: float | None
    """The mean of the values."""
    range: list[float] | None
    """The smallest and the largest value."""
    samples: int
    """The number of samples."""
    sigma: float | None
    """Their standard deviation."""
    skewness: float | None
    """Their skewness."""


class Sensitivity(Record):
    """The influence of a parameter on a value."""

    below: float | None
    """The derivative for smaller values of the parameter, where that differs."""
    derivative: float
    """The derivative of the value by the parameter; for larger values of the parameter where that differs."""
    variance_share: float
    """Its share of the variance, from 0 to 1."""
    worst_share: float
    """Its share of the linear worst case, from 0 to 1."""


class Change(Record):
    """A change of what touches, or of whether there is a value."""

    at: dict[str, float]
    """The values of the parameters at which it first happens, by their names."""
    features: list[list[str]]
    """Features of the fixed and of the moving part."""
    kind: Literal['contact', 'jam', 'region']
    """Its kind."""
    share: float
    """How many times the tolerances that is."""
    what: str
    """The state after it, in words."""


class Effect(Record):
    """The effect of the tolerances on a requirement."""

    equals: bool | None
    """The truth that is required; left out where none is."""
    exact: Extremes | None
    """The smallest and the largest value; null of yes and no."""
    fails: str
    """The failure at that factor, in words."""
    failure: str | None
    """Why it has no value as drawn."""
    interrupted: bool | None
    """True where the computation was interrupted: extremes, structure, margin and samples are not known then; left out otherwise."""
    limits: list[float] | None
    """The smallest and the largest value that is allowed; left out where there are none."""
    linear: list[float] | None
    """The linear worst cases; null of yes and no."""
    margin: float | None
    """The factor on all tolerances at which something fails; null if nothing does up to 16."""
    measure: str
    """The kind of the quantity."""
    monte_carlo: Samples | None
    """Results of samples by chance, if they are asked for."""
    nominal: float | bool | None
    """The value as drawn, in the model's unit, radians or seconds, or true or false; null where it has none."""
    outcome: Literal['holds', 'fails', 'jams', 'not-met', 'no-value', 'interrupted']
    """How it came out."""
    requirement: str
    """The name of the requirement."""
    rss: list[float] | None
    """The root of the sum of squares to both sides of the value in the middle of the tolerances; null of yes and no."""
    sensitivities: dict[str, Sensitivity]
    """Influence of each parameter with a tolerance on the value, by its name."""
    structure: list[Change]
    """Changes of what touches, the first first."""
    touching: list[list[str]]
    """The pairs of features, of the fixed and of the moving part, that determine the value as drawn."""


class Units(Record):
    """Units of the numbers of an answer."""

    angle: Literal['rad']
    """Unit of angles."""
    force: str | None
    """Unit of forces, kg times the unit of length per s²; `None` where that has no name."""
    length: str | None
    """Unit of lengths, as the model says; `None` if it says none."""
    time: Literal['s']
    """Unit of times."""


class AllocationAnswer(Record):
    """What `cspace tolerances --allocate --json` prints"""

    answer: Literal['tolerances']
    """The command."""
    cost: list[float]
    """Costs of the tolerances given, and of those allocated."""
    criterion: Literal['worst'] | float
    """`worst`, or the share of parts that is to meet the limits."""
    outcome: Literal['done']
    """How it came out; of several pairs the worst."""
    parameters: dict[str, Allocated]
    """The tolerance of each parameter that has one, by its name."""
    requirements: list[Effect]
    """The effect of the tolerances allocated on each requirement."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Station(Record):
    """A requirement where the coordinate has a value."""

    at: float
    """The value of the coordinate, in the model's unit or radians."""
    failure: str | None
    """Why it has no value as drawn."""
    hi: Extreme
    """The largest value within the tolerances."""
    lo: Extreme
    """The smallest value within the tolerances."""
    nominal: float | None
    """The value as drawn; null where there is none."""


class Band(Record):
    """A requirement along a coordinate."""

    along: str
    """The name of the coordinate."""
    measure: str
    """The kind of the quantity."""
    requirement: str
    """The name of the requirement."""
    stations: list[Station]
    """The requirement at each value of the coordinate."""


class AlongAnswer(Record):
    """What `cspace tolerances --along --json` prints"""

    answer: Literal['tolerances']
    """The command."""
    outcome: Literal['done']
    """How it came out; of several pairs the worst."""
    requirements: list[Band]
    """Each requirement that is a number measured at a configuration with the coordinate."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Requirement(Record):
    """A requirement, measured."""

    at: NDArray[np.float64] | None
    """Where a position is measured; where a clearance over ranges is smallest, a backlash or a fit largest, or a part is stopped first."""
    dimension: Literal['length', 'angle', 'time', 'number', 'truth']
    """The unit of the value."""
    equals: bool | None
    """The truth that is required."""
    failure: str | None
    """Why there is no value."""
    gap: float | None
    """The gap by which the moving part is smaller, where the parts fit exactly."""
    limits: list[float] | None
    """The smallest and the largest value that are allowed."""
    margin: float | None
    """How far the value is within its limits; negative outside."""
    measure: str
    """The kind of the quantity."""
    met: bool | None
    """Absent for a requirement without limits, and for one that is not decided."""
    name: str
    """The name of the requirement."""
    one_sided: dict[str, list[float]] | None
    """The derivatives for smaller and for larger values, where they differ."""
    outcome: Literal['met', 'measured', 'not-met', 'undecided', 'no-value']
    """How it came out."""
    pair: list[str] | None
    """The two parts that it is about, if it is about two."""
    part: str | None
    """The part that it is about, if it is about one."""
    range: list[float] | None
    """The two ends of a play; the least and the largest backlash; the values between which a fit is."""
    sensitivities: dict[str, float] | None
    """The derivatives by parameters; where they differ for smaller and larger values, that for larger ones."""
    touching: list[list[str]]
    """Features of the two parts that touch where the quantity ends."""
    undecided: bool | None
    """Whether the quantity may have a value, which could not be found."""
    value: float | bool | None
    """In the model's unit or radians, or true or false; none where it has no value."""


class CheckAnswer(Record):
    """What `cspace check --json` prints"""

    answer: Literal['check']
    """The command."""
    outcome: Literal['met', 'measured', 'not-met', 'undecided', 'no-value']
    """How it came out; of several pairs the worst."""
    requirements: list[Requirement]
    """In the order of the model."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Backlash(Record):
    """Play over a turn."""

    at: NDArray[np.float64]
    """A configuration at which it is the least, in its middle."""
    least: float
    """The least (rad)."""
    most: float
    """The largest (rad)."""


class Cycle(Record):
    """One cycle of the drives that move two parts."""

    drives: dict[str, float]
    """Where the driven parts are at the time that is told: angles (rad), or lengths in the model's unit."""
    halt: Literal['dead-point'] | dict[str, Any] | None
    """Reason why they go no farther."""
    halted: dict[str, float] | None
    """Where the drives are when the parts are halted."""
    poses: list[list[float]]
    """Configurations (x, y, θ) of the two parts at that time."""
    reached: float
    """The time up to which the parts go (s): the last, unless something halts them."""
    times: list[float]
    """Its first and last time (s)."""
    turns: dict[str, int] | None
    """Driven parts that turn round, with the number of their turns."""


class Stopped(Record):
    """End of a range, or of a turn, to which a part does not come."""

    at: NDArray[np.float64]
    """The configuration in which it has come farthest."""
    end: Literal['lo', 'hi']
    """The end to which it does not come."""
    of: float | None
    """How far it should go that way by its range; none if it has none."""
    part: str
    """The part."""
    touching: list[list[str]]
    """The features that touch there, of the first and of the second part."""


class ClearanceOfPair(Record):
    """The answer for one pair."""

    at: float | NDArray[np.float64] | None
    """When or where that is."""
    backlash: Backlash | None
    """Play of the second part while the first is held, over a turn of the first, where they turn only together; none where something within that play is passed on two sides."""
    cycle: Cycle | None
    """Over a cycle, what that is and how far the parts go through it."""
    depth: float | None
    """The length of the shortest translation of the second part that separates parts that overlap; none of others, and of parts with too many edges."""
    fixed: str
    """Name of the fixed part."""
    gap: float | None
    """The least distance, in the model's unit; 0 of boundaries that meet, none of parts that overlap or are joined."""
    least: float | None
    """Over their ranges and over a cycle, of parts that are clear: no configuration has a smaller distance than this, which is a billionth less than the gap, or 10⁻¹⁰ of the parts' size if that is more; less where no more was proved, 0 where nothing was."""
    moving: str
    """Name of the moving part."""
    offset: float | None
    """The smallest distance by which the second of two parts that overlap has to be made smaller all around so that they do not; none of others, over a motion, and where its edges are too small for it."""
    outcome: Literal['done', 'overlaps', 'stopped', 'undecided', 'meets', 'touches', 'meshes', 'clear', 'joined']
    """How it came out."""
    over: Literal['ranges', 'drawn', 'record', 'cycle']
    """The motions over which it is."""
    points: list[list[float]] | None
    """A point of each part in the assembly's frame: the nearest; of parts that overlap those that touch after the translation, the second where it is before."""
    ratio: float | None
    """Turns of the second part for a turn of the first, where they turn only together."""
    reach: dict[str, list[float | None]] | None
    """Over their ranges, of parts that touch: least and greatest motion of each part that moves, in the region in which the parts are drawn; none where it goes on without end."""
    room: float | None
    """Over their ranges, the gap by which the second part is smaller all around, where the parts fit exactly, so that there is room to move."""
    stopped: list[Stopped] | None
    """Ends of ranges, or of turns, to which parts do not come, and what stops them there."""
    touching: list[str] | None
    """The features of the two parts at these points."""


class ClearanceAnswer(Record):
    """What `cspace clearance --json` prints"""

    along: list[float] | None
    """The first and the last time of the motion (s)."""
    answer: Literal['clearance']
    """The command."""
    beyond: int
    """The number of pairs that are not listed, because their gap is `within` or more."""
    different_heights: int | None
    """The number of pairs that are not listed, because their parts are at different heights and never touch."""
    outcome: Literal['done', 'overlaps', 'stopped', 'undecided', 'meets', 'touches', 'meshes', 'clear', 'joined']
    """How it came out; of several pairs the worst."""
    pairs: list[ClearanceOfPair]
    """Pairs of parts, the worst first."""
    parts: int
    """The number of parts."""
    seconds: float
    """How long it took (s)."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""
    within: float | None
    """Pairs with a smaller gap are listed, in the model's unit; none if all are."""


class Drawn(Record):
    """How the parts are at zero motion."""

    clearance: float | None
    """How far the parts are apart where they are free; none if they are at different heights."""
    outcome: Literal['free', 'contact', 'exact-fit', 'blocked', 'outside']
    """In a word."""
    region: int | None
    """The number of the free region."""


class FeatureCount(Record):
    """Lines, arcs, and vertices that are not smooth joints, of two parts."""

    fixed: int
    """In the fixed part."""
    moving: int
    """In the moving part."""
    total: int
    """In both."""


class Links(Record):
    """How patches are linked."""

    side: int
    """Links at the left and right boundaries of patches."""
    vertical: int
    """Links across critical orientations."""


class FreeRegion(Record):
    """A connected component of free space over all orientations of the window."""

    patches: int
    """Number of patches on its boundary."""
    sample: NDArray[np.float64]
    """A configuration inside, away from contact."""
    unbounded: bool
    """Whether it reaches arbitrarily far positions. Exactly one region does."""


class AxesRegion(Record):
    """A connected component of free space."""

    around_u: bool
    """Whether the part called fixed can turn without end within the region."""
    around_v: bool
    """Whether the moving part can turn without end within the region."""
    open_u: list[Any]
    """Whether u is unbounded below its smallest and above its largest value: nothing touches there."""
    open_v: list[Any]
    """Whether v is unbounded below and above."""
    sample: list[Any]
    """A configuration (u, v) within it, between the smallest and largest u and v below."""
    u: list[Any]
    """Smallest and largest u, in radians or the model's unit of length; unrolled where the region extends past a turn."""
    v: list[Any]
    """Smallest and largest v."""


class StageSeconds(Record):
    """Seconds taken by each stage."""

    branches: float
    """Crossings followed over orientation."""
    candidates: float
    """Pairs of sheets that may cross."""
    cells: float
    """Cutting sheets into cells."""
    graph: float
    """Patches, links, regions."""
    pair_events: float
    """Orientations at which pairs change."""
    sheets: float
    """Features, sheets and their names."""
    shells: float
    """Deciding which cells bound free space."""
    total: float
    """All stages, and all of attempts that were not kept."""
    triple_events: float
    """Orientations at which three sheets meet."""


class Decisions(Record):
    """Numbers of decisions: how many were made, and how many of these needed a second method or were left to the resolution."""

    orientations: int
    """Orientations at which something may change."""
    overlaps: int
    """Pieces of curve that two cells share at an orientation."""
    overlaps_uncertain: int
    """Subset of `overlaps` that may be shorter than the errors of their ends: these do not join shells."""
    passings: int
    """Intervals of orientation in which two branches may pass each other: decided by the polynomial of three carriers."""
    passings_by_places: int
    """Subset of `passings` in which the sign of the polynomial cannot be determined: decided by the order of places before and after."""
    shells: int
    """Shells, each decided by one overlap test and by the bounds of its cells."""


class Counts(Record):
    """Counts of the computation of a space in x, y and theta."""

    branches: int
    """Crossings of two sheets; of large pairs, without those that are certainly in blocked space."""
    cells: int
    """Pieces of sheets."""
    clusters: int
    """Different orientations among all events."""
    conflicts: int
    """How often the computation contradicted itself; 0 in sound computations."""
    decisions: Decisions
    """Counts of decisions, by the certainty reached."""
    overlap_tests: int
    """Configurations tested for overlap."""
    pair_events: int
    """Orientations examined as possibly critical, from pairs of sheets."""
    pairs: int
    """Pairs of sheets whose boxes meet."""
    sheets: int
    """Sheets: feature pairs that can touch, by intervals in which their ends keep their identity."""
    triple_events: int
    """Orientations at which three sheets meet."""


class AxesStatistics(Record):
    """Counts of a computation."""

    conflicts: int
    """Conflicts that remained in every attempt: places at which tests and structure contradict each other, or the structure contradicts itself; 0 unless features lie closer than the resolution. If there are any, configurations are classified by intersecting the placed parts, and regions and patches are unreliable."""
    crossings: int
    """Crossings of pieces."""
    pairs: int
    """Pairs of features that touch somewhere."""
    pieces: int
    """Monotone pieces of their contact curves."""
    tests: int
    """Tests of overlap. A part that is symmetric about its pivot is tested in one period only."""


class PerPart(Record):
    """A number for each part."""

    fixed: int
    """For the fixed part."""
    moving: int
    """For the moving part."""


class Window(Record):
    """The orientations a contact space covers."""

    full_turn: bool
    """Whether these are all orientations: the last is then the first again."""
    hi: float
    """Last orientation, radians."""
    lo: float
    """First orientation, radians."""


class SummaryOfPair(Record):
    """The answer for one pair."""

    bands: int
    """How many bands the critical orientations make."""
    cached: bool | None
    """True where the space was computed before, and read; left out otherwise."""
    critical_orientations: list[float]
    """Orientations at which the structure of the slice changes, radians, ascending."""
    doubtful_orientations: list[list[Any]] | None
    """From where to where the patches are not relied upon alone, radians."""
    drawn: Drawn | None
    """How the parts are at zero motion; absent of a pair that never parts."""
    features: FeatureCount
    """Lines, arcs, and vertices that are not smooth joints."""
    fixed: str
    """Name of the fixed part."""
    free_regions: int
    """Connected components of free space."""
    least_clearance: float
    """A clearance below it counts as none, in the model's unit."""
    links: Links
    """How patches are linked."""
    model: str | None
    """The name of the model, where it is known."""
    motion: dict[str, Any] | None
    """How the parts move that have no orientations: on axes or by a joint."""
    moving: str
    """Name of the moving part."""
    outcome: Literal['done']
    """How it came out."""
    patches: int
    """Contact patches, or contact curves on fixed axes."""
    regions: list[FreeRegion] | list[AxesRegion]
    """The connected components of free space; their places in this list are their numbers."""
    resolution: float
    """How exact places are, in the model's unit of length."""
    seconds: StageSeconds | dict[str, Any]
    """How long it took this time: the stages, of a space that was computed, and their total."""
    slices: int
    """Bands that were computed, after symmetry."""
    statistics: Counts | AxesStatistics | None
    """Counts of the computation."""
    symmetry: PerPart
    """The largest fold of a rotation about its own centre that maps the part to itself; 1 for none."""
    window: Window | None
    """The orientations that were computed; absent of pairs without orientations."""


class ComputeAnswer(Record):
    """What `cspace compute --json` prints"""

    answer: Literal['compute']
    """The command."""
    outcome: Literal['done']
    """How it came out; of several pairs the worst."""
    pairs: list[SummaryOfPair]
    """The answer for each pair."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Enclosed(Record):
    """Parts that cannot leave."""

    doubtful: list[list[Any]]
    """Orientations at which the contact space is not relied upon, radians."""
    moving: list[str]
    """Parts that are enclosed."""
    patches: int
    """The number of contact patches that enclose it."""
    staying: list[str]
    """Parts that enclose them."""
    touching: list[list[str]]
    """The features of these: of what stays, and of what moves, each with its part."""


class Locked(Record):
    """Parts of which none goes out while the others stay."""

    parts: list[str]
    """The parts."""
    why: list[Enclosed]
    """Reasons: every division of the parts into two divides the sides of one of these."""


class Step(Record):
    """A motion of some parts while others stay."""

    about: list[float] | None
    """The point that legs move straight and turn the parts about, x and y in the assembly's frame as the parts are before the step; none on an axis."""
    clearance: float | None
    """The least distance along the path, in the model's unit."""
    kind: Literal['leaves', 'moves']
    """`leaves`: the parts go out of those that stay; `moves`: a part makes room and stays among the others."""
    moving: list[str]
    """The parts that move, as one."""
    onward: list[float] | None
    """Further straight motion, x and y, of parts that leave: so far they go to be out of the way of all that comes later and to have room to be taken apart, when the steps are played; in the frame of the path."""
    path: NDArray[np.float64]
    """Configurations joined by motions of constant rates. Of a part on an axis its motion v, with u = 0; of others where they are relative to where they are before the step: it begins at 0, 0, 0."""
    staying: list[str]
    """The parts that stay where they are."""
    words: list[str]
    """Description of each leg of the path in words."""


class Branch(Record):
    """Parts that go out of others in a step."""

    room: list[int] | None
    """The indices of the steps by which others make room for it, from 0; absent if nothing has to."""
    step: int
    """The index of the step, from 0."""
    tree: Tree | None
    """Tree of what comes out of it in turn, if it is more than one part."""


class Tree(Record):
    """Parts that come out of others."""

    left: list[str]
    """Parts that are left of them."""
    out: list[Branch]
    """Branches that go out of them, one after the other."""
    parts: list[str]
    """The parts."""


class Tried(Record):
    """Effort spent where nothing leaves the set."""

    aside: int
    """So many parts were moved aside at a time, at most."""
    places: int
    """To so many places, of one part or of two."""


class DisassembleAnswer(Record):
    """What `cspace disassemble --json` prints"""

    answer: Literal['disassemble']
    """The command."""
    gap: float
    """The gap between parts that touch as drawn, in the model's unit."""
    locked: Locked | None
    """If not all comes apart, the smallest set of parts that is known of which none goes out while the others stay; if the outcome is `locked`, two parts of which one encloses the other."""
    outcome: Literal['apart', 'locked', 'unknown']
    """How it came out; of several pairs the worst."""
    seconds: float
    """How long it took (s)."""
    spaces: int
    """The number of contact spaces that were computed."""
    steps: list[Step]
    """Motions, one after the other."""
    tree: Tree
    """Tree of what comes out of what."""
    tried: Tried | None
    """Effort that was spent where nothing goes out while the others stay; none if that was not needed."""
    units: Units
    """Units of the numbers."""
    verdict: Literal['apart', 'locked', 'unknown']
    """How it came out, as `outcome`."""
    version: Literal[1]
    """Version of the form of answers."""


class Overlap(Record):
    """Parts that overlap."""

    depth: float | None
    """How far it is to the nearest free configuration, in the model's unit; a radian counts the reach of the part that turns. None if there is none."""
    nearest: NDArray[np.float64] | None
    """The nearest free configuration, up to contact."""
    touching: list[str] | None
    """Features of the fixed and of the moving part; none where there are none."""


class EnergyEnclosed(Record):
    """Why there is no path: a region that contacts enclose."""

    patches: int
    """The number of contact patches that enclose it."""
    region: int
    """The region."""
    touching: list[list[str]]
    """The features of these patches, of the fixed and of the moving part."""


class Pass(Record):
    """A place at which a way may be highest."""

    at: NDArray[np.float64]
    """Its configuration."""
    energy: float
    """Its energy, counted from that at the start."""
    touching: list[list[str]]
    """The features that balance it, of the fixed and of the moving part."""


class EscapeOfPair(Record):
    """The answer for one pair."""

    blocked: Overlap | None
    """Overlap at the start or the goal."""
    enclosed: EnergyEnclosed | None
    """Enclosure of the region of the start."""
    energy: float | None
    """The least energy of a way: that of the one pass between the bounds, to rounding. None where there are several or none, where the bounds could not be brought together, and without a way."""
    fixed: str
    """Name of the fixed part."""
    gap: float | None
    """The gap by which the moving part is smaller all around, where the parts fit exactly at the start or the goal."""
    least: float | None
    """No way needs less; none without a way."""
    most: float | None
    """The path needs no more; none without one."""
    moving: str
    """Name of the moving part."""
    outcome: Literal['escapes', 'cage', 'from-blocked', 'to-blocked']
    """How it came out."""
    passes: list[Pass]
    """Places between the bounds where contacts balance the energy, the lowest first, and start or goal if their energy is between the bounds."""
    path: NDArray[np.float64]
    """Configurations joined by motions of constant rates, from the start to the goal or out; empty if there is no path. Angles go on beyond a turn."""
    seconds: float
    """How long the search took, without the contact space (s)."""
    unit_mass: bool
    """Whether energies are those of a mass of 1 kg, because the model has none."""
    verdict: Literal['escapes', 'cage', 'from-blocked', 'to-blocked']
    """How it came out, as `outcome`."""


class EnergyAnswer(Record):
    """What `cspace plan --energy --json` prints"""

    answer: Literal['plan']
    """The command."""
    outcome: Literal['escapes', 'cage', 'from-blocked', 'to-blocked']
    """How it came out; of several pairs the worst."""
    pairs: list[EscapeOfPair]
    """The answer for each pair."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class DriveInfo(Record):
    """A prescribed motion."""

    part: str
    """The part's name."""
    rate: float | None
    """Its rate, radians or lengths per second."""
    table: list[list[Any]] | None
    """Times and where the part is then: radians or lengths."""


class JointInfo(Record):
    """A permanent connection of two parts."""

    at: list[float]
    """The point that both parts turn about, or a point of the line of sliding."""
    direction: list[float] | None
    """The direction of a slide."""
    parts: list[str]
    """The names of the parts."""
    type: Literal['revolute', 'prismatic']
    """The kind."""


class LoadInfo(Record):
    """A constant force or torque."""

    at: list[float] | None
    """Where it acts, in the part's frame; at the centre of mass if this is missing."""
    force: list[float] | None
    """In the assembly's frame, kg·unit/s²."""
    part: str
    """The part's name."""
    torque: float | None
    """kg·unit²/s², counter-clockwise."""


class PairInfo(Record):
    """A pair of parts."""

    features: int
    """Lines, arcs, and vertices that are not smooth joints, of both parts."""
    fixed: str
    """Name of the fixed part."""
    friction: float | None
    """The coefficient of friction, where the pair has one of its own."""
    moving: str
    """Name of the moving part."""
    restitution: float | None
    """The coefficient of restitution, where the pair has one of its own."""
    theta: list[Any] | None
    """The first and the last orientation of its window, radians; left out without a window."""


class Parameter(Record):
    """A parameter of a model."""

    deviations: list[float] | None
    """How far below and above the value it may be, if the model says so; one is negative where the value is outside its limits."""
    expression: str | None
    """How the value is written, if it is an expression of other parameters."""
    name: str
    """Its name, as expressions write it."""
    set: bool
    """Whether the value is not that of the model, but was given."""
    used_by: list[str]
    """The parts and other entries in which numbers depend on it."""
    value: float
    """Its value; of an angle in radians."""


class InfoFeatureCount(Record):
    """Lines, arcs, and vertices that are not smooth joints."""

    arcs: int
    """Arcs."""
    lines: int
    """Line segments."""
    total: int
    """All of these."""
    vertices: int
    """Corners."""


class LayerInfo(Record):
    """A layer of a part."""

    area: float
    """Its area, in the square of the model's unit."""
    loops: int
    """Number of its loops."""
    z: list[float] | None
    """The lowest and the highest place, in the model's unit of length; none at every height."""


class MemberInfo(Record):
    """A part of the file that is joined rigidly to others."""

    loops: list[int]
    """The numbers of its first and its last loop."""
    name: str
    """Its name, which stands for all of them."""


class PartInfo(Record):
    """A part."""

    area: float
    """The area of its material."""
    bounds: list[float]
    """Least x and y, greatest x and y."""
    center_of_mass: list[float] | None
    """In the part's frame: as given, or of a part with a mass the centroid of its outline."""
    concave_arcs: int
    """Arcs with material outside."""
    convex_arcs: int
    """Arcs with material inside of their circle."""
    features: InfoFeatureCount
    """Lines, arcs, and vertices that are not smooth joints."""
    holes: int
    """Loops around holes."""
    inertia: float | None
    """The moment of inertia about the centre of mass, kg·unit², as given or from the outline."""
    layers: list[LayerInfo] | None
    """Its layers, if it has heights."""
    loops: int
    """Closed loops of the outline."""
    mass: float | None
    """Its mass in kg, where the model gives it a mass or a density."""
    members: list[MemberInfo] | None
    """The parts of the file that it is made of, if they are joined rigidly."""
    motion: dict[str, Any]
    """How it moves relative to the ground."""
    name: str
    """Its name."""
    radii: list[Any] | None
    """Least and greatest radius of its arcs."""
    rate: float | list[float] | None
    """How fast it moves at the start, where that is given, per second."""
    round: bool
    """Whether every rotation about its own centre maps it to itself."""
    size: float
    """The diagonal of its box."""
    start: float | list[float] | None
    """Where it is at the start, where that is given: x, y and theta, or how far along its axis."""
    symmetry: int
    """The largest fold of a rotation about its own centre that maps the part to itself; 1 for none."""


class SpringInfo(Record):
    """A spring, or a damper."""

    angle: float | None
    """The angle of a torsion spring at which it gives no torque, radians."""
    at: list[list[float]] | None
    """The points of a linear spring, each in its part's frame, of the ground in the assembly's."""
    damping: float
    """Force per rate of length, kg/s, or torque per angular velocity, kg·unit²/s."""
    length: float | None
    """The length of a linear spring at which it gives no force."""
    parts: list[str]
    """The names of two parts, or of one if the spring is against the ground."""
    stiffness: float
    """Force per length, kg/s², or torque per radian, kg·unit²/s²."""
    type: Literal['linear', 'torsion']
    """The kind."""


class InfoAnswer(Record):
    """What `cspace info --json` prints"""

    answer: Literal['info']
    """The command."""
    drives: list[DriveInfo] | None
    """Prescribed motions, where there are any."""
    friction: float | None
    """The coefficient of friction of pairs without one of their own, where it is not 0."""
    gravity: list[float] | None
    """The acceleration of what falls, unit/s², where there is any."""
    joints: list[JointInfo]
    """Permanent connections."""
    loads: list[LoadInfo] | None
    """Constant forces and torques, where there are any."""
    name: str
    """The name of the model."""
    outcome: Literal['done']
    """How it came out; of several pairs the worst."""
    pairs: list[PairInfo]
    """The pairs that are studied."""
    parameters: list[Parameter] | None
    """The model's parameters, by name; left out if it has none."""
    parts: list[PartInfo]
    """The parts."""
    restitution: float | None
    """The coefficient of restitution of pairs without one of their own, where it is not 0."""
    springs: list[SpringInfo] | None
    """Springs and dampers, where there are any."""
    unit: str | None
    """The model's label of the unit of length, if it has one."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Reach(Record):
    """Range of a coordinate that a mode reaches, in radians or the model's unit."""

    around: bool
    """Whether the part turns for ever in the mode, alone or with others."""
    hi: float | None
    """The maximum; none if there is none."""
    lo: float | None
    """The minimum; none if there is none."""


class PartCoordinates(Record):
    """A configuration of the parts, in radians or the model's unit."""

    more: list[float] | None
    """Motions of the fourth part and those after it, if there are such."""
    u: float
    """Motion of the first part."""
    v: float
    """Motion of the second part."""
    w: float
    """Motion of the third part."""


class Mode(Record):
    """A mode."""

    more: list[Reach] | None
    """Ranges of the coordinates of the fourth part and those after it, if there are such."""
    sample: PartCoordinates
    """A configuration in the mode."""
    turns: list[list[int]]
    """The turns of all coordinates by which motions within the mode come back to where they began: all are sums of whole multiples of these."""
    u: Reach
    """Range of u that the mode reaches."""
    v: Reach
    """Range of v that the mode reaches."""
    w: Reach
    """Range of w that the mode reaches."""


class Pair(Record):
    """Two of the parts."""

    coordinates: list[str]
    """The coordinates of the fixed and of the moving part."""
    fixed: str
    """The fixed part's name."""
    free_regions: int
    """The number of its free regions."""
    listed: bool
    """Whether the model has the pair; one that it does not have constrains nothing."""
    moving: str
    """The moving part's name."""
    patches: int
    """The number of contact patches of the pair's space."""


class Part(Record):
    """One of the parts."""

    coordinate: str
    """Name of its coordinate."""
    motion: Literal['revolute', 'prismatic']
    """How it moves."""
    name: str
    """Its name."""
    range: list[float] | None
    """Minimum and maximum coordinate, in radians or the model's unit; none without limits."""


class Requested(Record):
    """Where the configuration is that is asked about."""

    at: PartCoordinates
    """The configuration."""
    between: list[str]
    """The parts that touch or overlap, or the one whose range is left."""
    mode: int | None
    """The number of the mode, from 0, in the order of `modes`; none if it is in none."""
    result: Literal['free', 'contact', 'blocked', 'outside', 'closed']
    """How the parts are there."""


class ModesAnswer(Record):
    """What `cspace modes --json` prints"""

    answer: Literal['modes']
    """The command."""
    doubts: int
    """The number of places at which contacts coincide but for rounding; if there are any, the modes are not to be relied upon."""
    left_out: list[list[str]]
    """Pairs of the model of one of the parts and another part, which are not considered."""
    modes: list[Mode]
    """The modes: connected components of the free configurations."""
    outcome: Literal['done', 'blocked']
    """How it came out; of several pairs the worst."""
    pairs: list[Pair]
    """Pairs of the parts: of three parts those of u and v, of v and w, of u and w; of more those that the model has."""
    parts: list[Part]
    """The parts, whose coordinates are u, v, w, and of those after the third q4, q5 and so on."""
    requested: Requested
    """The configuration that is asked about."""
    seconds: float
    """How long it took (s)."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Bottleneck(Record):
    """The widest way."""

    at: NDArray[np.float64]
    """The configuration."""
    clearance: float
    """The clearance of the widest way that was found."""
    most: float | None
    """No path has more than this; at least the clearance of the path. None where the path starts or ends in contact: by another leg off the contact there may be more."""
    touching: list[str] | None
    """Features of the fixed and of the moving part; none where there are none."""


class Contact(Record):
    """A contact on a path that is given."""

    at: NDArray[np.float64]
    """The configuration."""
    fraction: float
    """How much of the leg is free, 0 to 1."""
    leg: int
    """The leg, counted from 0."""
    touching: list[str] | None
    """Features of the fixed and of the moving part; none where there are none."""


class PlanEnclosed(Record):
    """Why there is no path: a region that contacts enclose."""

    patches: int
    """The number of contact patches that enclose it."""
    region: int
    """The region."""
    touching: list[list[str]]
    """The features of these patches, of the fixed and of the moving part."""


class Place(Record):
    """A configuration with what is nearest there."""

    at: NDArray[np.float64]
    """The configuration."""
    touching: list[str] | None
    """Features of the fixed and of the moving part; none where there are none."""


class Layer(Record):
    """A layer of a part."""

    loops: int
    """How many loops it has."""
    z: list[float] | None
    """The lowest and the highest place; none for every height."""


class PlanPart(Record):
    """A part: closed loops of vertices x, y, bulge; the material is their even-odd inside, or that of the loops of each layer at its heights."""

    layers: list[Layer] | None
    """The layers, which have all loops one after another; none of a part that is one outline at every height."""
    loops: list[list[list[float]]]
    """The bulge tan(sweep/4) is of the edge that leaves the vertex; 0 for a line."""
    name: str
    """Name of the part."""


class Proof(Record):
    """A proof that no motion leads from start to goal. Angles are in radians."""

    depth: float
    """Approximate penetration of the parts on the surface; stated, not checked."""
    fixed: PlanPart
    """The fixed part."""
    goal: list[float]
    """Goal configuration x, y, θ."""
    moving: PlanPart
    """The moving part: at (x, y, θ) its point q is at (x, y) + `R_θ` q."""
    pivot: list[float]
    """A point of the moving part, in its frame."""
    start: list[float]
    """Start configuration x, y, θ."""
    triangles: list[list[int]]
    """Three vertices, the turns added to the θ of each, and a witness."""
    unit: str | None
    """The label of the unit of length."""
    version: Literal[1]
    """The version of the format: 1."""
    vertices: list[list[float]]
    """Position of the pivot, and θ."""
    window: list[float] | None
    """First and last orientation; none for all."""
    witnesses: list[list[float]]
    """Centre and radius of a disc of the moving part's material, in its frame, and of one of the fixed part's."""


class Regions(Record):
    """The free regions of start and goal, as `compute` lists them."""

    to: int | None
    """Region of the goal; none where the parts overlap."""


class Rest(Record):
    """A path without the part of its first leg on which the clearance rises off a contact, and of its last on which it falls to one."""

    clearance: float | None
    """The least distance of the parts along the rest, in the model's unit; none of a path of one configuration."""
    from_contact: bool
    """Whether the path starts in contact."""
    to_contact: bool
    """Whether it ends in contact."""


class Twin(Record):
    """A configuration in which the moving part covers what it covers at the goal."""

    at: NDArray[np.float64]
    """The configuration."""
    turn: float
    """The turn of the part by which it looks the same, radians."""


class PlanOfPair(Record):
    """The answer for one pair."""

    about: list[float] | None
    """x and y of the point of a planar part, in its frame, that legs move straight and about which they turn the part: its origin, the middle of a part that is drawn beside its origin, or what is asked for."""
    blocked: Overlap | None
    """Overlap at the start or the goal."""
    bottleneck: Bottleneck | None
    """Where the widest way is narrowest, if the widest is asked for, or more clearance than there is or was found."""
    clearance: float | None
    """The least distance of the parts along the path, in the model's unit; none without a path."""
    contact: Contact | None
    """Where a path that is given meets a contact."""
    doubtful: list[list[Any]] | None
    """Orientations at which the contact space is not relied upon, radians."""
    enclosed: PlanEnclosed | None
    """The enclosure that keeps start and goal apart: the smaller of the two regions."""
    fixed: str
    """Name of the fixed part."""
    gap: float | None
    """The gap by which the moving part is smaller all around, where the parts fit exactly at the start or the goal."""
    moving: str
    """Name of the moving part."""
    narrowest: Place | None
    """Where the path is narrowest."""
    outcome: Literal['path', 'no-path', 'blocked', 'from-blocked', 'to-blocked', 'unknown']
    """How it came out."""
    path: NDArray[np.float64]
    """Configurations joined by legs, from the start to the goal up to whole turns; empty if there is no path. On a leg the place of the point `about` of the moving part and the orientation have constant rates, or u and v. Angles go on beyond a turn."""
    proof: Proof | None
    """The proof that there is no path, if one is asked for."""
    regions: Regions
    """The free regions of start and goal."""
    rest: Rest | None
    """The clearance of a path that starts or ends in contact, off these contacts."""
    seconds: float
    """How long planning took, without the contact space (s)."""
    twin: Twin | None
    """Where there is no path to the goal: a configuration to which there is one, and in which the moving part, which is symmetric, covers the same place."""
    unproved: str | None
    """Why there is no proof, if one is asked for."""
    verdict: Literal['path', 'no-path', 'blocked', 'from-blocked', 'to-blocked', 'unknown']
    """How it came out, as `outcome`."""
    words: list[str] | None
    """Description of each leg in words: right, up, left and down are directions of the fixed part's frame."""


class PlanAnswer(Record):
    """What `cspace plan --json` prints"""

    answer: Literal['plan']
    """The command."""
    outcome: Literal['path', 'no-path', 'blocked', 'from-blocked', 'to-blocked', 'unknown']
    """How it came out; of several pairs the worst."""
    pairs: list[PlanOfPair]
    """The answer for each pair."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class Direction(Record):
    """How far the parts go in one direction."""

    direction: str
    """Its name."""
    distance: float | None
    """In the model's unit of length, or radians; none where nothing stops it."""
    stopped_by: Literal['contact', 'limit', 'nothing']
    """The end that it comes to."""
    touching: list[list[str]]
    """Features of the fixed and of the moving part that stop it."""


class Moved(Record):
    """How far a displacement at constant rates leads."""

    at: NDArray[np.float64]
    """The configuration that is reached."""
    fraction: float
    """The fraction of the displacement that is travelled."""
    result: str
    """The outcome in a word."""
    touching: list[list[str]]
    """Features of the fixed and of the moving part."""


class Near(Record):
    """Two features that touch, or nearly."""

    at: list[float]
    """The nearest point of the fixed part, in its frame."""
    distance: float
    """How far the features are apart; less than 0 by as much as they overlap."""
    features: list[str]
    """Features of the fixed and of the moving part."""
    normal: list[float]
    """The outward unit normal of the fixed part."""
    on_moving: list[float]
    """The nearest point of the moving part, in the fixed part's frame."""


class PlayOfPair(Record):
    """The answer for one pair."""

    at: NDArray[np.float64]
    """The configuration asked about."""
    clearance: float | None
    """The minimum distance of the parts."""
    directions: list[Direction]
    """How far the parts go."""
    fixed: str
    """Name of the fixed part."""
    gap: float | None
    """The gap by which the moving part is smaller, where the parts fit exactly."""
    motion: Moved | None
    """How far a displacement leads."""
    moving: str
    """Name of the moving part."""
    near: list[Near]
    """The features that touch, or nearly."""
    outcome: Literal['free', 'contact', 'exact-fit', 'joined', 'blocked']
    """How it came out."""
    region: int | None
    """The number of the free region."""


class PlayAnswer(Record):
    """What `cspace play --json` prints"""

    answer: Literal['play']
    """The command."""
    outcome: Literal['free', 'contact', 'exact-fit', 'joined', 'blocked']
    """How it came out; of several pairs the worst."""
    pairs: list[PlayOfPair]
    """The answer for each pair."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class ContactInterval(Record):
    """Contact from the instant at which two features meet to that at which the parts separate there. In between the contact may pass on to adjacent features."""

    features: list[str]
    """The features of the two that touch first."""
    fixed: str
    """The name of the pair's fixed part."""
    moving: str
    """The name of its moving part."""
    to: float | None
    """End, in seconds; `None` if it lasts to the end of the motion."""


class InCycle(Record):
    """Motion of a part in a cycle."""

    advance: float | list[float]
    """How far it has gone on after a cycle, 0 if it is back."""
    greatest: float | list[float]
    """The largest values in the last cycle."""
    least: float | list[float]
    """The smallest values in the last cycle."""
    ratio: float | None
    """Its advance by that of the driver: the ratio of transmission, or a length per radian."""


class Period(Record):
    """The cycle in which the motion repeats."""

    difference: float
    """How far two cycles are from each other at most, in the unit of length; angles count by the sizes of their parts."""
    driver: str | None
    """The first part that is driven to turn at a constant rate, to which ratios refer."""
    parts: dict[str, InCycle]
    """The motion of each part that can move in it, by its name."""
    period: float
    """How long it takes, in seconds."""
    since: float
    """The time from which on the motion repeats, in seconds."""


class Energy(Record):
    """Energy balance, in kg·unit²/s²: the energy at the end is that at the start plus the work of drives less the losses, but for `drift`."""

    drift: float
    """Remainder of the balance: the error of the integration."""
    drives: float
    """Work done by drives."""
    end: float
    """Energy at the end."""
    friction: float
    """Energy lost to friction and dampers."""
    impacts: float
    """Energy lost to impacts."""
    start: float
    """Kinetic energy, and the potential energy of weights, loads and springs, at the start."""


class Bridge(Record):
    """A time that steps lead over."""

    overlap: float
    """The largest overlap of parts in it, in the model's unit of length."""
    until: float
    """The end of the time, in seconds."""


class Choice(Record):
    """Motions that all agree with the laws of contact and friction, and the one that is taken: that with the least energy of the change, then with the least forces, then the first."""

    contacts: list[dict[str, Any]]
    """The contacts and limits concerned."""
    others: list[list[Literal['opens', 'sticks', 'slides', 'slides-back']]]
    """Conduct of each in the other motions."""
    taken: list[Literal['opens', 'sticks', 'slides', 'slides-back']]
    """Conduct of each in the motion that is taken."""


class Event(Record):
    """Something that happens."""

    at: list[float] | None
    """Position, in the assembly's frame; `None` for limits."""
    bridge: Bridge | None
    """Extent of a bridge."""
    choice: Choice | None
    """Possible motions, of a choice."""
    kind: Literal['impact', 'touch', 'release', 'stick', 'slip', 'rest', 'limit', 'snap', 'jam', 'choice', 'bridge']
    """Kind of the event."""
    t: float
    """Time, in seconds."""


class Gap(Record):
    """A part that is smaller than drawn, all around, because it fits exactly into another."""

    gap: float
    """How much smaller it is, in the model's unit of length."""
    part: str
    """Name of the part."""


class MadeOf(Record):
    """The first eight bytes of the SHA-256 of what is in a model, as hexadecimal digits. Neither the model's name nor its unit moves anything."""

    drives: str
    """Hash of drives."""
    friction: str
    """Hash of friction and restitution."""
    gravity: str
    """Hash of gravity."""
    joints: str
    """Hash of joints."""
    loads: str
    """Hash of loads."""
    masses: str
    """Hash of masses, starts and rates of parts."""
    pairs: str
    """Hash of pairs."""
    parts: str
    """Hash of outlines and axes of parts."""
    springs: str
    """Hash of springs."""


class Obstacle(Record):
    """A contact that forbids a motion, with its share of the proof."""

    multiplier: float
    """Multiplier: positive."""


class Peak(Record):
    """A value and its time."""

    t: float
    """Its time, in seconds."""
    value: float
    """The value."""


class ContactPeak(Record):
    """The largest normal force of two parts, all their contacts together, or at an end of a range."""

    force: Peak
    """The force."""


class DrivePeak(Record):
    """The largest force and power of a drive."""

    force: Peak
    """Torque, or force if the part slides: that of the largest magnitude."""
    part: str
    """The name of the driven part."""
    power: Peak
    """The largest power that the drive gives; below 0 where it only takes."""


class Peaks(Record):
    """The largest forces among the samples of a motion, in kg·unit/s²; torques in kg·unit²/s², powers in kg·unit²/s³."""

    contacts: list[ContactPeak]
    """The forces of each two parts that press on each other, and at each end of a range that is pressed on."""
    drives: list[DrivePeak]
    """The forces and powers of each drive."""


class ContactForce(Record):
    """The force at a contact."""

    at: list[float] | None
    """Position, in the assembly's frame; `None` for limits."""
    normal: float
    """Magnitude of the normal force between the parts, 0 or more."""
    tangential: float
    """The force of friction."""


class DriveForce(Record):
    """Force and power of a drive."""

    force: float
    """Torque, or force if the part slides."""
    part: str
    """The name of the driven part."""
    power: float
    """Power: force times rate, in kg·unit²/s³."""


class JointForce(Record):
    """Force in a joint: the force on the second of its parts."""

    force: list[float]
    """The force on the second part, in the assembly's frame."""
    parts: list[str]
    """The names of its two parts."""
    torque: float
    """The torque on the second part, about the joint's place in it."""


class Forces(Record):
    """The forces between parts at a time, in kg·unit/s², torques in kg·unit²/s²."""

    contacts: list[ContactForce]
    """Forces of all closed contacts and all ends of ranges that are reached."""
    drives: list[DriveForce]
    """Forces of the drives."""
    joints: list[JointForce]
    """Forces of the joints between two parts, in the order of the mechanism's pairs."""


class Row(Record):
    """All parts at a time."""

    forces: Forces | None
    """Forces, if they are asked for."""
    rates: dict[str, float | list[float]] | None
    """Rates, if they are asked for."""
    t: float
    """The time, in seconds."""


class SimulateAnswer(Record):
    """What `cspace simulate --json` prints"""

    answer: Literal['simulate']
    """The command."""
    contacts: list[ContactInterval]
    """Contacts from touch to release, in the order in which they begin."""
    cycle: Period | None
    """The cycle in which it repeats; left out where it does not."""
    energy: Energy | None
    """The balance of energy, of a motion with masses."""
    events: list[Event]
    """Events, in order of time."""
    gaps: list[Gap] | None
    """The parts that fit exactly into others at the start, and are smaller all around, so that there is room to move."""
    model: MadeOf | None
    """Hashes of all that the motion depends on, of a record that is kept: a motion goes on only with what it was made of."""
    obstacles: list[Obstacle] | None
    """Obstacles that jam it: the conditions that these functions do not decrease, each times its multiplier, add up to a contradiction."""
    outcome: Literal['done', 'jammed', 'undetermined', 'inconsistent', 'interrupted']
    """How it came out; of several pairs the worst."""
    parts: list[str]
    """Parts that can move."""
    peaks: Peaks | None
    """The largest forces, if forces are known."""
    reason: str | None
    """Why it ended before its time."""
    samples: list[Row]
    """All parts at even times, and where it ended."""
    seconds: float
    """How long it took to compute, in seconds."""
    states: list[list[float]] | None
    """All states that are known, in order of time, of a record that is kept."""
    status: Literal['done', 'jammed', 'undetermined', 'inconsistent', 'interrupted']
    """How it ended: `done` at the end of its time; `jammed` where what is driven cannot go on; `undetermined` where it cannot be told how it goes on; `inconsistent` where no accelerations and forces satisfy the laws of contact and friction; `interrupted` where the user wanted no more of it."""
    summary: list[str]
    """A summary of the motion, in sentences."""
    units: Units
    """Units of the numbers."""
    until: float
    """When it ended, in seconds."""
    version: Literal[1]
    """Version of the form of answers."""


class SolveAnswer(Record):
    """What `cspace solve --json` prints"""

    answer: Literal['solve']
    """The command."""
    none: str | None
    """Why there is no solution; null where there is one."""
    outcome: Literal['solved', 'undecided', 'none']
    """How it came out; of several pairs the worst."""
    ranges: list[list[float]] | None
    """With one parameter: the ranges in which it is so; left out where it is so at single values alone, or nowhere."""
    solutions: list[dict[str, float]]
    """Values of the parameters: of an equation in one parameter all that were found, otherwise the nearest."""
    undecided: list[list[float]] | None
    """With one parameter: the ranges in which the quantity may have a value, which could not be found; left out where there are none."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class SweepAnswer(Record):
    """What `cspace sweep --json` prints"""

    answer: Literal['sweep']
    """The command."""
    outcome: Literal['done', 'none', 'interrupted']
    """How it came out; of several pairs the worst."""
    rows: list[dict[str, float | bool | str | None]]
    """Values of what is varied and of what is measured, and `failure` where there is none; or where something changes, with the measure and what is so `before` and `after`: the value of each column, by its name."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


class TolerancesAnswer(Record):
    """What `cspace tolerances --json` prints"""

    answer: Literal['tolerances']
    """The command."""
    outcome: Literal['holds', 'fails', 'jams', 'not-met', 'no-value', 'interrupted']
    """How it came out; of several pairs the worst."""
    requirements: list[Effect]
    """The effect on each requirement, in the order of the model."""
    units: Units
    """Units of the numbers."""
    version: Literal[1]
    """Version of the form of answers."""


Extremes._read = {'hi': Extreme, 'lo': Extreme}
Samples._read = {'histogram': Histogram}
Effect._read = {'exact': Extremes, 'monte_carlo': Samples, 'sensitivities': each_of(Sensitivity), 'structure': Change}
AllocationAnswer._read = {'parameters': each_of(Allocated), 'requirements': Effect, 'units': Units}
Station._read = {'hi': Extreme, 'lo': Extreme}
Band._read = {'stations': Station}
AlongAnswer._read = {'requirements': Band, 'units': Units}
Requirement._read = {'at': configuration}
CheckAnswer._read = {'requirements': Requirement, 'units': Units}
Backlash._read = {'at': configuration}
Stopped._read = {'at': configuration}
ClearanceOfPair._read = {'at': number_or_configuration, 'backlash': Backlash, 'cycle': Cycle, 'stopped': Stopped}
ClearanceAnswer._read = {'pairs': ClearanceOfPair, 'units': Units}
FreeRegion._read = {'sample': configuration}
Counts._read = {'decisions': Decisions}
SummaryOfPair._read = {'drawn': Drawn, 'features': FeatureCount, 'links': Links, 'symmetry': PerPart, 'window': Window}
ComputeAnswer._read = {'pairs': SummaryOfPair, 'units': Units}
Locked._read = {'why': Enclosed}
Step._read = {'path': configuration}
Branch._read = {'tree': Tree}
Tree._read = {'out': Branch}
DisassembleAnswer._read = {'locked': Locked, 'steps': Step, 'tree': Tree, 'tried': Tried, 'units': Units}
Overlap._read = {'nearest': configuration}
Pass._read = {'at': configuration}
EscapeOfPair._read = {'blocked': Overlap, 'enclosed': EnergyEnclosed, 'passes': Pass, 'path': configuration}
EnergyAnswer._read = {'pairs': EscapeOfPair, 'units': Units}
PartInfo._read = {'features': InfoFeatureCount, 'layers': LayerInfo, 'members': MemberInfo}
InfoAnswer._read = {'drives': DriveInfo, 'joints': JointInfo, 'loads': LoadInfo, 'pairs': PairInfo, 'parameters': Parameter, 'parts': PartInfo, 'springs': SpringInfo, 'units': Units}
Mode._read = {'more': Reach, 'sample': PartCoordinates, 'u': Reach, 'v': Reach, 'w': Reach}
Requested._read = {'at': PartCoordinates}
ModesAnswer._read = {'modes': Mode, 'pairs': Pair, 'parts': Part, 'requested': Requested, 'units': Units}
Bottleneck._read = {'at': configuration}
Contact._read = {'at': configuration}
Place._read = {'at': configuration}
PlanPart._read = {'layers': Layer}
Proof._read = {'fixed': PlanPart, 'moving': PlanPart}
Twin._read = {'at': configuration}
PlanOfPair._read = {'blocked': Overlap, 'bottleneck': Bottleneck, 'contact': Contact, 'enclosed': PlanEnclosed, 'narrowest': Place, 'path': configuration, 'proof': Proof, 'regions': Regions, 'rest': Rest, 'twin': Twin}
PlanAnswer._read = {'pairs': PlanOfPair, 'units': Units}
Moved._read = {'at': configuration}
PlayOfPair._read = {'at': configuration, 'directions': Direction, 'motion': Moved, 'near': Near}
PlayAnswer._read = {'pairs': PlayOfPair, 'units': Units}
Period._read = {'parts': each_of(InCycle)}
Event._read = {'bridge': Bridge, 'choice': Choice}
ContactPeak._read = {'force': Peak}
DrivePeak._read = {'force': Peak, 'power': Peak}
Peaks._read = {'contacts': ContactPeak, 'drives': DrivePeak}
Forces._read = {'contacts': ContactForce, 'drives': DriveForce, 'joints': JointForce}
Row._read = {'forces': Forces}
SimulateAnswer._read = {'contacts': ContactInterval, 'cycle': Period, 'energy': Energy, 'events': Event, 'gaps': Gap, 'model': MadeOf, 'obstacles': Obstacle, 'peaks': Peaks, 'samples': Row, 'units': Units}
SolveAnswer._read = {'units': Units}
SweepAnswer._read = {'units': Units}
TolerancesAnswer._read = {'requirements': Effect, 'units': Units}
