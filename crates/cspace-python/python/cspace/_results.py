"""Answers as records."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import number
from ._errors import Error


def _along(plan: "Plan", shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Configurations at shares of a path, on whose legs a point of the part goes straight."""
    if plan.legs is None:
        raise Error(f"there is no path: the verdict is {plan.verdict!r}")
    legs, places = plan.legs, shares * (len(plan.legs) - 1)

    def between(column: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.interp(places, np.arange(len(legs)), column)

    if plan.about is None:
        return np.column_stack([between(column) for column in legs.T])
    about = complex(*plan.about)
    points = legs[:, 0] + 1j * legs[:, 1] + np.exp(1j * legs[:, 2]) * about
    theta = between(legs[:, 2])
    at = between(points.real) + 1j * between(points.imag) - np.exp(1j * theta) * about
    return np.column_stack([at.real, at.imag, theta])


@dataclass(frozen=True)
class Region:
    """A free region: a free configuration in it, and whether it is caged, that is, ends everywhere."""

    sample: tuple[float, ...]
    caged: bool


@dataclass(frozen=True)
class Patch:
    """A contact patch: the features that touch on it, the free region that it bounds, and its orientations in radians."""

    fixed: str
    moving: str
    region: int | None
    orientations: tuple[float, float] | None


@dataclass(frozen=True)
class Nearest:
    """The nearest configuration in contact: its patch, the configuration, and its distance as a length."""

    patch: int
    at: tuple[float, ...]
    distance: float


@dataclass(frozen=True, eq=False)
class Contact:
    """The contact function of a patch: `value`, the distance of the two features along their common normal, a length, 0 in contact; its
    `gradient` and `hessian` by the coordinates; and where they touch in the fixed part's frame, `at`, with the outward unit `normal` of
    the fixed part. Of n configurations they are arrays: n, n×3, n×3×3, n×2 and n×2 (of parts on axes n×2 and n×2×2)."""

    value: Any
    gradient: NDArray[np.float64]
    hessian: NDArray[np.float64]
    at: NDArray[np.float64]
    normal: NDArray[np.float64]


@dataclass(frozen=True)
class Crossing:
    """A contact that a motion comes through: its patch, the fraction of the displacement, the configuration, and whether the motion goes
    into blocked space there."""

    patch: int
    fraction: float
    at: tuple[float, ...]
    enters: bool


@dataclass(frozen=True)
class Pass:
    """Where a way is highest: the configuration, its energy, and the features that touch."""

    at: tuple[float, ...]
    energy: float
    touching: list[Any]


@dataclass(frozen=True, eq=False)
class Escape:
    """How a part leaves a place against gravity, loads and springs.

    `verdict` is "escapes", "cage" (proved: no energy lets it out), "from-blocked" or "to-blocked". `energy` is what it takes; no way takes
    less than `least`, and the `path` takes `most`. `passes` are the highest places on it. `touching` are the features that hold it in a
    cage. With `unit_mass` energies are those of a mass of 1, since the model has none."""

    verdict: str
    unit_mass: bool
    energy: float | None = None
    least: float | None = None
    most: float | None = None
    path: NDArray[np.float64] | None = None
    passes: list[Pass] = field(default_factory=list)
    touching: list[Any] = field(default_factory=list)
    region: int | None = None


@dataclass(frozen=True, eq=False)
class Step:
    """A step of taking a mechanism apart: the parts that move together, those that stay, the path, and its smallest clearance.

    `kind` is "leaves", or "moves" of a part that makes room and stays among the others. Rows of `path` are (x, y, theta) to where the
    parts are before the step, of a part on an axis (0, v), and free as they stand: between two of them all coordinates change evenly.
    `legs` are the same way in few rows, between which the point `about` of the parts goes straight.
    """

    moving: list[str]
    staying: list[str]
    path: NDArray[np.float64]
    legs: NDArray[np.float64]
    clearance: float
    kind: str
    about: tuple[float, float]


@dataclass(frozen=True)
class Assembly:
    """Whether and how a mechanism comes apart: `verdict` is "apart", "locked" (proved: one of two parts encloses the
    other, however the others move) or "unknown". Parts that touch as drawn are `gap` apart. `locked` are the parts that stay together, and `why` names what moves, what stays
    and what touches."""

    verdict: str
    gap: float
    steps: list[Step]
    locked: list[str]
    why: list[Any]


@dataclass(frozen=True)
class Motion:
    """What becomes of a motion: "free", "contact", "leaves" (its range) or "blocked" (from the beginning).

    `fraction` of the displacement is done, up to the configuration `at`; `touching` are the features of the fixed and the moving part
    that touch there.
    """

    result: str
    fraction: float
    at: tuple[float, ...]
    touching: list[Any]
    gap: float | None = None


@dataclass(frozen=True)
class Play:
    """How far one coordinate goes from a configuration when it alone changes: from `lower` to `upper`, infinite where nothing stops it."""

    coordinate: str
    lower: float
    upper: float
    touching: tuple[Any, ...]
    gap: float | None = None

    @property
    def length(self) -> float:
        """The length of the whole range."""
        return self.upper - self.lower


@dataclass(frozen=True, eq=False)
class Plan:
    """The answer to the question for a path.

    `verdict` is "path", "no-path" (proved), "too-narrow", "from-blocked", "to-blocked" or "unknown". Rows of `path` are free as they
    stand: between two of them all coordinates change evenly. `legs` are the same way in few rows, between which the point `about` of a
    moving part in the plane goes straight; on them `clearance` is the smallest distance of the parts, and on `path` nine tenths of it are
    left. `bottleneck` is the clearance and the configuration where the widest path is narrowest. `touching` are the features of the fixed and the moving part that are nearest at the
    bottleneck, or that enclose a region which is not left.
    """

    verdict: str
    path: NDArray[np.float64] | None = None
    legs: NDArray[np.float64] | None = None
    about: tuple[float, float] | None = None
    clearance: float | None = None
    bottleneck: tuple[Any, ...] | None = None
    touching: list[Any] = field(default_factory=list)
    region: int | None = None
    depth: float | None = None
    doubtful: list[Any] = field(default_factory=list)
    gap: float | None = None

    def __bool__(self) -> bool:
        return self.verdict == "path"

    def at(self, share: float) -> NDArray[np.float64]:
        """The configuration at a share of the path, from 0 to 1: each of `legs` counts alike."""
        found: NDArray[np.float64] = _along(self, np.array([number("share", share, 0.0, 1.0)]))[0]
        return found

    def sample(self, count: int) -> NDArray[np.float64]:
        """So many configurations from the start to the goal, at even shares of the path, as rows."""
        if not (hasattr(count, "__index__") and count.__index__() > 0):
            raise Error(f"`count` is {count!r} where a whole number of 1 or more is expected")
        return _along(self, np.linspace(0.0, 1.0, count.__index__()))


@dataclass(frozen=True)
class Checked:
    """A requirement that was measured: `value` is a number in the model's unit, radians or seconds, true or false, or None with a
    `failure`; `met` is None of one that only measures, and where it is `undecided`: there may be a value, which could not be found.
    `sensitivities` are derivatives by parameters, for smaller and for larger values of each."""

    name: str
    measure: str
    value: Any
    limits: tuple[float, float] | None
    met: bool | None
    undecided: bool
    margin: float | None
    range: tuple[Any, ...] | None
    touching: list[Any]
    failure: str | None
    sensitivities: dict[str, Any]


@dataclass(frozen=True)
class Tolerances:
    """What tolerances do to a requirement, as in the answer of `cspace tolerances --json`: `linear` and `rss` are (lo, hi), `exact` has
    `lo` and `hi`, each with `value`, `at` and `certified`; `structure` is what changes, the first first; `margin` is the factor on all
    tolerances at which something `fails`, None if nothing does; `monte_carlo` is None without samples."""

    requirement: str
    nominal: Any
    sensitivities: dict[str, Any]
    linear: list[float] | None
    rss: list[float] | None
    exact: dict[str, Any] | None
    structure: list[Any]
    margin: float | None
    fails: str
    touching: list[Any]
    monte_carlo: dict[str, Any] | None = None

    @classmethod
    def of(cls, row: dict[str, Any]) -> "Tolerances":
        names = cls.__dataclass_fields__
        return cls(**{name: value for name, value in row.items() if name in names})


@dataclass(frozen=True)
class Modes:
    """The operating modes of three parts on axes, as in the answer of `cspace modes --json`: each of `modes` has the ranges of `u`, `v`
    and `w`, its `turns` and a `sample` in it; `requested` is where the configuration is that was asked for; `left_out` are pairs that are
    not considered. If there are `doubts`, modes are not to be relied upon."""

    parts: list[Any]
    pairs: list[Any]
    modes: list[Any]
    requested: dict[str, Any]
    left_out: list[Any]
    doubts: int


@dataclass(frozen=True)
class Solved:
    """Values of parameters that were asked for: `solutions`, `ranges` in which it is so, or the reason why there are `none`; in the ranges
    `undecided` nothing is known."""

    solutions: list[Any]
    ranges: list[Any]
    undecided: list[Any]
    none: str | None


@dataclass(frozen=True, eq=False)
class Simulation:
    """The motion of a mechanism: `coordinates[part]` and `rates[part]` at the times `t`, as arrays of n, or n×3 for a part that moves
    freely; `events` and `contacts` as dictionaries, `gaps` of parts that fit exactly at the start, the `period` if the motion repeats, and a `summary` in words."""

    t: NDArray[np.float64]
    coordinates: dict[str, Any]
    rates: dict[str, Any]
    status: str
    until: float
    reason: str | None
    events: list[Any]
    contacts: list[Any]
    gaps: list[Any]
    period: float | None
    summary: list[Any]


class Table(dict[str, Any]):
    """Columns by name, as arrays of one length; `failures` has the reason for each row and column without a value."""

    def __init__(self, columns: dict[str, Any], failures: list[Any]) -> None:
        super().__init__(columns)
        self.failures = failures

    def __reduce__(self) -> Any:
        return Table, (dict(self), self.failures)

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failures, the first {self.failures[0]}" if self.failures else ""
        return f"Table({super().__repr__()}{failed})"
