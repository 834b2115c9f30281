"""Answers as records."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import answers
from ._animate import animate
from ._arrays import number
from ._errors import Error
from ._features import Feature
from ._optional import optional
from ._part import Part
from ._record import ByName, Fields, OfPair


# The parts with their poses n×3 at configurations of a pair.
Places = Callable[[str, str, NDArray[np.float64]], list[tuple[Part, NDArray[np.float64]]]]


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
class Region(Fields):
    """A free region: a free configuration in it, and whether it is caged, that is, ends everywhere.

    >>> space.regions[0].caged
    False
    """

    sample: tuple[float, ...]
    caged: bool


@dataclass(frozen=True)
class Patch(Fields):
    """A contact patch: the features that touch on it, the free region that it bounds, and its orientations in radians.

    >>> space.patches[0].fixed.kind
    'line'
    """

    fixed: Feature
    moving: Feature
    region: int | None
    orientations: tuple[float, float] | None


@dataclass(frozen=True, eq=False)
class Nearest(Fields):
    """The nearest configuration in contact: the number of its `patch`, the configuration `at`, and its `distance`, a length. Of n
    configurations they are arrays: n, n×3 (or n×2) and n; where there is no contact the patch is -1 and the distance infinite.

    >>> round(space.nearest((0, 6, 0)).distance, 9)
    4.0
    """

    patch: Any
    at: Any
    distance: Any


@dataclass(frozen=True, eq=False)
class ContactFunction(Fields):
    """The contact function of a patch: `value`, the distance of the two features along their common normal, a length, 0 in contact; its
    `gradient` and `hessian` by the coordinates; and where they touch in the fixed part's frame, `at`, with the outward unit `normal` of
    the fixed part. Of n configurations they are arrays: n, n×3, n×3×3, n×2 and n×2 (of parts on axes n×2 and n×2×2).

    >>> space.contact_function(0, (0, 6, 0)).gradient.shape
    (3,)
    """

    value: Any
    gradient: NDArray[np.float64]
    hessian: NDArray[np.float64]
    at: NDArray[np.float64]
    normal: NDArray[np.float64]


@dataclass(frozen=True)
class Crossing(Fields):
    """A contact that a motion comes through: its patch, the fraction of the displacement, the configuration, and whether the motion goes
    into blocked space there.

    >>> [crossing.enters for crossing in space.crossings((0, 6, 0), (0, -12, 0))]
    [True, False]
    """

    patch: int
    fraction: float
    at: tuple[float, ...]
    enters: bool


@dataclass(frozen=True, eq=False)
class Motion(Fields):
    """What becomes of a motion: its `outcome` is "free", "contact", "leaves" (its range) or "blocked" (from the beginning).

    `fraction` of the displacement is done, up to the configuration `at`; `touching` are the pairs of features that touch there, and `gap`, a
    length, is by how much the moving part was made smaller where the parts fit exactly. Of n motions they are arrays: n, n, n×3 (or
    n×2), and n, in which no gap is nan; `touching` is a list of n lists.

    >>> moved = space.move((0, 6, 0), (0, -8, 0))
    >>> moved.outcome, round(moved.fraction, 9)
    ('contact', 0.5)
    """

    outcome: Any
    fraction: Any
    at: Any
    touching: list[Any]
    gap: Any = None


@dataclass(frozen=True, eq=False)
class Play(Fields):
    """How far one coordinate goes from a configuration when it alone changes: from `lower` to `upper`, infinite where nothing stops it.

    `touching` are the pairs of features that stop it there, two lists of `FeaturePair`, and `gap` is as of `Motion`. Of n configurations
    `lower`, `upper` and `gap` are arrays, nan where the configuration is not free, and `touching` has n pairs of lists.

    >>> space.play((0, 6, 0))["y"].lower
    2.0
    """

    coordinate: str
    lower: Any
    upper: Any
    touching: Any
    gap: Any = None

    @property
    def length(self) -> Any:
        """The length of the whole range.

        >>> space.play((0, 6, 0))["y"].length
        inf
        """
        return self.upper - self.lower


class Check(ByName, answers.CheckAnswer):
    """The requirements of a model, measured.

    >>> model.check()["backlash"].met
    True
    """


class Tolerances(ByName, answers.TolerancesAnswer):
    """What tolerances do to the requirements of a model.

    >>> [round(end, 9) for end in model.tolerances()["backlash"].linear]
    [0.08, 0.12]
    """


class Plan(OfPair, answers.PlanAnswer):
    """A path of a pair, or that there is none: `verdict` is "path", "no-path" (proved), "from-blocked", "to-blocked" or "unknown".

    Rows of `path` are free as they stand: between two of them all coordinates change evenly. `legs`, the `path` of the command's JSON, are
    the same way in few rows, between which the point `about` of a moving part in the plane goes straight; on them `clearance` is the
    smallest distance of the parts, and on `path` nine tenths of it are left. Both are None where there is no path.

    >>> plan = space.plan((-6, 0, 0), (6, 0, 0))
    >>> plan.outcome, bool(plan), plan.path[0].tolist()
    ('path', True, [-6.0, 0.0, 0.0])
    """

    def __init__(self, values: Any = (), path: NDArray[np.float64] | None = None, places: Places | None = None) -> None:
        super().__init__(values)
        vars(self).update(_path=path, _places=places)

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
        """The configuration at a share of the path, from 0 to 1: each of `legs` counts alike.

        >>> space.plan((-6, 4, 0), (6, 4, 0)).at(1.0).tolist()
        [6.0, 4.0, 0.0]
        """
        found: NDArray[np.float64] = _along(self, np.array([number("share", share, 0.0, 1.0)]))[0]
        return found

    def sample(self, count: int) -> NDArray[np.float64]:
        """So many configurations from the start to the goal, at even shares of the path, as rows.

        >>> space.plan((-6, 4, 0), (6, 4, 0)).sample(100).shape
        (100, 3)
        """
        if not (hasattr(count, "__index__") and count.__index__() > 0):
            raise Error(f"`count` is {count!r} where a whole number of 1 or more is expected")
        return _along(self, np.linspace(0.0, 1.0, count.__index__()))

    def to_dataframe(self, rows: str | None = None) -> Any:
        """The rows of `path` as a pandas.DataFrame with the columns x, y and theta, or u and v; with `rows` as of `Record`.

        >>> list(space.plan((-6, 4, 0), (6, 4, 0)).to_dataframe())
        ['x', 'y', 'theta']
        """
        if rows is not None:
            return super().to_dataframe(rows)
        if self.path is None:
            raise Error(f"there is no path: the verdict is {self.verdict!r}")
        names = ["u", "v"] if self.path.shape[1] == 2 else ["x", "y", "theta"]
        return optional("pandas").DataFrame(self.path, columns=names)

    def animate(self, path: str | os.PathLike[str] | None = None, frames: int = 100, fps: float = 25.0) -> Any:
        """The two parts on their way, in so many `frames`: written to a .gif or .mp4 file, `fps` frames a second; without a path an animation
        of matplotlib, which a notebook shows by `.to_jshtml()`.

        >>> moving = space.plan((-6, 4, 0), (6, 4, 0)).animate("way.gif", frames=3)
        """
        places: Places | None = vars(self)["_places"]
        if places is None:
            raise Error("the parts of this plan are not known: ask a model or a space for it")
        rows = self.sample(frames)
        return animate(places(self.fixed, self.moving, rows), path, fps, ["" for _ in rows])


class Escape(OfPair, answers.EnergyAnswer):
    """The least energy that lets a part out: `answer.energy`, between `answer.least` and `answer.most`.

    >>> answer = cup.escape()
    >>> answer.outcome, answer.least <= 40 <= answer.most
    ('escapes', True)
    """


class Simulation(answers.SimulateAnswer):
    """The motion of a mechanism. `coordinates[part]` and `rates[part]` are arrays at the times `t`: n, or n×3 for a part that moves
    freely.

    >>> simulation = model.simulate(1.0, every=0.5)
    >>> simulation.outcome, simulation.t.tolist()
    ('done', [0.0, 0.5, 1.0])
    """

    def __init__(self, values: Any = (), places: Callable[[Any], dict[str, tuple[Part, Any]]] | None = None) -> None:
        super().__init__(values)
        vars(self)["_places"] = places

    @property
    def t(self) -> NDArray[np.float64]:
        """The times of the samples (s)."""
        return np.array([row["t"] for row in self["samples"]])

    @property
    def coordinates(self) -> dict[str, NDArray[np.float64]]:
        """The coordinates of each part that can move: radians of one that turns, a length of one that slides, (x, y, theta) of one in the
        plane."""
        return {part: np.array([row[part] for row in self["samples"]]) for part in self["parts"]}

    @property
    def rates(self) -> dict[str, NDArray[np.float64]]:
        """Their rates, per second."""
        return {part: np.array([row["rates"][part] for row in self["samples"]]) for part in self["parts"]}

    def to_dataframe(self, rows: str | None = None) -> Any:
        """The samples as a pandas.DataFrame with the columns of the command's CSV: t, and NAME.u of a part on an axis, NAME.x, NAME.y and
        NAME.theta of one in the plane; with `rows="events"` the events.

        >>> list(model.simulate(1.0).to_dataframe())
        ['t', 'cam.u', 'fork.u']
        """
        if rows is not None:
            return super().to_dataframe(rows)
        columns = {"t": self.t}
        for part, values in self.coordinates.items():
            names = ["u"] if values.ndim == 1 else ["x", "y", "theta"]
            columns |= {f"{part}.{name}": column for name, column in zip(names, np.atleast_2d(values.T))}
        return optional("pandas").DataFrame(columns)

    def animate(self, path: str | os.PathLike[str] | None = None, fps: float = 25.0) -> Any:
        """The parts in motion, a frame for each sample: written to a .gif or .mp4 file, `fps` frames a second; without a path an animation
        of matplotlib, which a notebook shows by `.to_jshtml()`. It runs as fast as the mechanism where samples are 1/`fps` apart.

        >>> moving = model.simulate(1.0, every=0.5).animate("motion.gif")
        """
        places: Callable[[Any], dict[str, tuple[Part, Any]]] | None = vars(self)["_places"]
        if places is None:
            raise Error("the parts of this motion are not known: ask a model for it")
        times = self.t
        drawn = [(part, np.broadcast_to(poses, (len(times), 3))) for part, poses in places(self.coordinates).values()]
        return animate(drawn, path, fps, [f"{t:.3f} s" for t in times])


class Table(dict[str, Any]):
    """Columns by name, as arrays of one length; `failures` has the reason for each row and column without a value.

    >>> cs.sweep(lambda a: 1 / a, a=[0, 2]).failures
    [(0, None, 'ZeroDivisionError: division by zero')]
    """

    def __init__(self, columns: dict[str, Any], failures: list[Any]) -> None:
        super().__init__(columns)
        self.failures = failures

    def to_dataframe(self) -> Any:
        """The columns as a pandas.DataFrame, with the reasons for values that are not there in a column "failure" where there are any.

        >>> cs.sweep(lambda a: 2 * a, a=[1, 2]).to_dataframe().shape
        (2, 2)
        """
        frame = optional("pandas").DataFrame(dict(self))
        if self.failures:
            reasons = {row: reason for row, _, reason in self.failures}
            frame["failure"] = [reasons.get(row) for row in range(len(frame))]
        return frame

    def __reduce__(self) -> Any:
        return Table, (dict(self), self.failures)

    def __repr__(self) -> str:
        failed = f", {len(self.failures)} failures, the first {self.failures[0]}" if self.failures else ""
        return f"Table({super().__repr__()}{failed})"
