"""Answers as records."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import answers
from ._arrays import number
from ._errors import Error
from ._record import ByName, OfPair


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


class Check(ByName, answers.CheckAnswer):
    """The requirements of a model, measured: `check["tilt"].value`."""


class Tolerances(ByName, answers.TolerancesAnswer):
    """What tolerances do to the requirements of a model: `tolerances["tilt"].margin`."""


class Plan(OfPair, answers.PlanAnswer):
    """A path of a pair, or that there is none: `verdict` is "path", "no-path" (proved), "from-blocked", "to-blocked" or "unknown".

    Rows of `path` are free as they stand: between two of them all coordinates change evenly. `legs`, the `path` of the command's JSON, are
    the same way in few rows, between which the point `about` of a moving part in the plane goes straight; on them `clearance` is the
    smallest distance of the parts, and on `path` nine tenths of it are left. Both are None where there is no path.
    """

    def __init__(self, values: Any = (), path: NDArray[np.float64] | None = None) -> None:
        super().__init__(values)
        vars(self)["_path"] = path

    @property
    def path(self) -> NDArray[np.float64] | None:
        """Configurations from the start to the goal, between which x, y and theta, or u and v, change evenly."""
        found: NDArray[np.float64] | None = vars(self)["_path"]
        return found

    @property
    def legs(self) -> NDArray[np.float64] | None:
        """Configurations from the start to the goal, between which the point `about` goes straight."""
        found: NDArray[np.float64] = self.pairs[0]["path"]
        return found if len(found) else None

    @property
    def touching(self) -> list[Any]:
        """The features of the fixed and the moving part that are nearest at the bottleneck, or that enclose a region which is not left."""
        if self.enclosed is not None:
            return list(self.enclosed.touching)
        return [self.bottleneck.touching] if self.bottleneck is not None and self.bottleneck.touching else []

    def __missing__(self, key: str) -> Any:
        return getattr(self, key) if key in ("path", "legs") else super().__missing__(key)

    def __bool__(self) -> bool:
        return bool(self.verdict == "path")

    def at(self, share: float) -> NDArray[np.float64]:
        """The configuration at a share of the path, from 0 to 1: each of `legs` counts alike."""
        found: NDArray[np.float64] = _along(self, np.array([number("share", share, 0.0, 1.0)]))[0]
        return found

    def sample(self, count: int) -> NDArray[np.float64]:
        """So many configurations from the start to the goal, at even shares of the path, as rows."""
        if not (hasattr(count, "__index__") and count.__index__() > 0):
            raise Error(f"`count` is {count!r} where a whole number of 1 or more is expected")
        return _along(self, np.linspace(0.0, 1.0, count.__index__()))


class Escape(OfPair, answers.EnergyAnswer):
    """The least energy that lets a part out: `answer.energy`, between `answer.least` and `answer.most`."""


class Simulation(answers.SimulateAnswer):
    """The motion of a mechanism. `coordinates[part]` and `rates[part]` are arrays at the times `t`: n, or n×3 for a part that moves
    freely."""

    @property
    def t(self) -> NDArray[np.float64]:
        """The times of the samples (s)."""
        return np.array([row["t"] for row in self["samples"]])

    @property
    def coordinates(self) -> dict[str, NDArray[np.float64]]:
        """The coordinates of each part that can move."""
        return {part: np.array([row[part] for row in self["samples"]]) for part in self["parts"]}

    @property
    def rates(self) -> dict[str, NDArray[np.float64]]:
        """Their rates."""
        return {part: np.array([row["rates"][part] for row in self["samples"]]) for part in self["parts"]}


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
