"""Models."""

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from . import _rust
from ._arrays import column, number, position, table, window
from ._errors import Error
from ._part import Part
from ._results import Assembly, Checked, Escape, Modes, Pass, Simulation, Solved, Step, Table, Tolerances
from ._space import ContactSpace


class Model:
    """A model of parts, with values for its parameters.

    `model(pin=6.02)` is the model with another value; values are numbers, or expressions such as "18deg".
    """

    __slots__ = ("_model",)

    def __init__(self, model: _rust.Model) -> None:
        self._model = model

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Model":
        """The model in a file, .toml or .json."""
        return cls(_rust.Model._load(os.path.abspath(path)))

    @classmethod
    def loads(cls, text: str, name: str = "model.toml") -> "Model":
        """The model in a text: TOML, or JSON where `name` ends in .json; errors call it by this name."""
        return cls(_rust.Model._loads(text, name, []))

    def __call__(self, **parameters: float | str) -> "Model":
        return Model(self._model(**parameters))

    @property
    def name(self) -> str:
        """The name."""
        return self._model.name

    @property
    def unit(self) -> str | None:
        """The unit of length, if the model says one."""
        return self._model.unit

    @property
    def parts(self) -> dict[str, Part]:
        """The parts by name."""
        return {name: Part._of(part) for name, part in self._model.parts.items()}

    @property
    def parameters(self) -> dict[str, float]:
        """The values of the parameters by name; angles in radians."""
        return self._model.parameters

    @property
    def pairs(self) -> list[tuple[str, str]]:
        """The pairs, as names of the fixed and of the moving part."""
        return self._model.pairs

    @property
    def requirements(self) -> list[str]:
        """The names of the requirements."""
        return self._model.requirements

    def compute(
        self, fixed: str | None = None, moving: str | None = None, theta: Sequence[float] | None = None
    ) -> ContactSpace:
        """The configuration space of two parts, by name; of the only pair without names. `theta` is a window of orientations, radians."""
        return ContactSpace(self._model.compute(fixed, moving, window(theta)))

    def check(self, sensitivities: bool = False) -> dict[str, Checked]:
        """All requirements, measured, by name."""
        return {found["name"]: Checked(**found) for found in self._model._check(sensitivities)}

    def tolerances(self, requirement: str | None = None, samples: int = 0, seed: int = 0) -> Any:
        """What tolerances of the parameters do to a requirement; without one, a dictionary of all of them by name.

        >>> model.tolerances("dwell", samples=10_000).margin  # doctest: +SKIP
        """
        if requirement is not None and requirement not in self.requirements:
            raise Error(f"there is no requirement {requirement!r}: there are {', '.join(self.requirements)}")
        for name, number in (("samples", samples), ("seed", seed)):
            if isinstance(number, bool) or not isinstance(number, int) or not 0 <= number < 2**63:
                raise Error(f"`{name}` is {number!r} where a whole number from 0 up is expected")
        chosen = [] if requirement is None else [requirement]
        rows = self._model._tolerances(chosen, samples, seed)
        found = {row["requirement"]: Tolerances.of(row) for row in rows}
        return found if requirement is None else found[requirement]

    def sweep(
        self, measures: str | Iterable[str] | None = None, rows: Mapping[str, Any] | None = None, **values: Any
    ) -> Table:
        """The requirements `measures` (all without) for values of parameters or coordinates: of every combination of `values`, the last
        changing first, or of `rows`, a dictionary of columns.

        >>> model.sweep(play=np.linspace(0.05, 0.25, 5))  # doctest: +SKIP
        """
        names, varied = table(rows, values)
        numbers = np.array([column(name, v) for name, v in zip(names, zip(*varied))])
        if isinstance(measures, str):
            measures = [measures]
        measures = self.requirements if measures is None else list(measures)
        found = self._model._sweep(names, numbers.T.tolist(), measures)
        columns = dict(zip(names, numbers))
        failures = []
        for i, row in enumerate(found):
            for name, value in zip(measures, row):
                if isinstance(value, str):
                    failures.append((i, name, value))
        for k, name in enumerate(measures):
            columns[name] = np.array([np.nan if isinstance(row[k], str) else row[k] for row in found])
        if failures and len(failures) == len(found) * len(measures):
            raise Error(f"no row has an answer; the first ends with {failures[0][2]}")
        return Table(columns, failures)

    def solve(
        self, requirement: str, relation: str, value: float | bool, samples: int = 65, **ranges: Sequence[float]
    ) -> Solved:
        """Values of parameters, each from lo to hi, at which a requirement is as asked for.

        >>> model.solve("tilt", "=", 0.01, play=(0.01, 0.5))  # doctest: +SKIP
        """
        try:
            vary = [(name, float(lo), float(hi)) for name, (lo, hi) in ranges.items()]
        except (TypeError, ValueError):
            raise Error("a range is not two numbers (lo, hi)") from None
        if not isinstance(value, (bool, int, float)) or value != value:
            raise Error(f"`value` is {value!r} where a number, true or false is expected")
        if not vary:
            raise Error("no parameter is varied: give a range, solve(..., play=(0.01, 0.5))")
        for name, lo, hi in vary:
            if name not in self.parameters:
                raise Error(f"there is no parameter {name!r}: there are {', '.join(self.parameters)}")
            if not lo < hi:
                raise Error(f"the range of {name} is empty")
        if requirement not in self.requirements:
            raise Error(f"there is no requirement {requirement!r}: there are {', '.join(self.requirements)}")
        return Solved(**self._model._solve(vary, requirement, relation, value, samples))

    def escape(
        self,
        start: Any,
        goal: Any = None,
        fixed: str | None = None,
        moving: str | None = None,
        gravity: Sequence[float] | None = None,
    ) -> Escape:
        """The least energy with which the moving part of a pair leaves the place `start`, against gravity, loads and springs of the model:
        for good, or to `goal`. `gravity` (x, y) is in place of the model's; the only pair needs no names."""
        if fixed is None or moving is None:
            if len(self.pairs) != 1:
                raise Error("it is not said which pair is meant: give `fixed` and `moving`")
            fixed, moving = self.pairs[0]
        if gravity is not None:
            gravity = position("gravity", gravity)
        space = self.compute(fixed, moving)
        found = _rust._escape(self._model, (fixed, moving), space._space, start, goal, gravity)
        passes = [Pass(tuple(at), energy, touching) for at, energy, touching in found.pop("passes", [])]
        return Escape(passes=passes, **found)

    def assembly(self, gap: float | None = None) -> Assembly:
        """Whether the parts of the model come apart, group by group, and in which order. Parts that touch as drawn are moved apart by
        `gap`."""
        found = _rust._assembly(self._model, None if gap is None else number("gap", gap))
        return Assembly(steps=[Step(*step) for step in found.pop("steps")], **found)

    def modes(self, parts: Sequence[str] | None = None, at: Sequence[float] = (0, 0, 0)) -> Modes:
        """The operating modes of three parts, by name, whose coordinates are u, v and w in that order; of those that move on axes without
        names. `at` (u, v, w), radians of a part that turns, is the configuration of which the mode is told.

        >>> model.modes(at=(8, 0, 0)).requested["mode"]  # doctest: +SKIP
        """
        if parts is not None and (isinstance(parts, str) or len(parts) != 3):
            raise Error(f"`parts` is {parts!r} where three names are expected")
        if len(at) != 3:
            raise Error(f"`at` is {at!r} where three numbers (u, v, w) are expected")
        u, v, w = (number("at", t) for t in at)
        found = self._model._modes(None if parts is None else list(parts), (u, v, w))
        found.pop("seconds")
        return Modes(**found)

    def simulate(self, time: float, every: float | None = None) -> Simulation:
        """The motion of the mechanism over `time` seconds, with inertia if a part has a mass; samples are `every` seconds apart."""
        return Simulation(**self._model._simulate(number("time", time), None if every is None else number("every", every)))

    def __repr__(self) -> str:
        return repr(self._model)

    def __reduce__(self) -> Any:
        return _restored, self._model._source()


def _restored(text: str, path: str, values: list[tuple[str, str]]) -> Model:
    return Model(_rust.Model._loads(text, path, values))
