"""Models."""

import json
import os
import sys
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _assembly, _rust, answers
from ._arrays import column, given, named, number, pair_names, position, table, window
from ._errors import Error
from ._optional import optional
from ._part import Part
from ._record import plain as _plain
from ._results import Check, Escape, Plan, Simulation, Table, Tolerances
from ._space import ContactSpace
from ._wires import JOIN

def _number(name: str, value: Any) -> float | None:
    """A finite number of 0 or more, or None."""
    return None if value is None else number(name, value, 0.0)


def _given(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """The arguments that are not None, as plain data."""
    return {name: _plain(value) for name, value in arguments.items() if value is not None}


_RELATIONS = {"=": "equal", "==": "equal", "<=": "at-most", ">=": "at-least"}


class Model:
    """A model of parts, with values for its parameters.

    `model(pin=6.02)` is the model with another value, as is `model({"pin": 6.02})`; values are numbers, or expressions such as "18deg".

    Docstrings are about the `model` of a cam in a fork whose parameter is `play`, in docs/python.md of the project, and about the `cup` with a
    disc in it:

    >>> cup = cs.Model.from_dict({"gravity": [0, -10], "part": [
    ...     {"name": "cup", "motion": {"type": "fixed"}, "loops": [[[-4, -1], [4, -1], [4, 4], [3, 4], [3, 0], [-3, 0], [-3, 4], [-4, 4]]]},
    ...     {"name": "disc", "mass": 1, "loops": [{"circle": 1, "at": [0, 1]}]}]})

    >>> round(model(play=0.2).check()["backlash"].value, 9)
    0.2
    """

    __slots__ = ("_model",)

    def __init__(self, model: _rust.Model) -> None:
        self._model = model

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "Model":
        """The model in a file, .toml or .json.

        >>> cs.Model.load("interlock.toml").unit
        'mm'
        """
        return cls(_rust.Model._load(os.path.abspath(path)))

    @classmethod
    def loads(cls, text: str, name: str = "model.toml") -> "Model":
        """The model in a text: TOML, or JSON where `name` ends in .json; errors call it by this name.

        >>> cs.Model.loads('part = [{ name = "coin", loops = [{ circle = 1, at = [0, 0] }] }]')
        Model("model": coin)
        """
        return cls(_rust.Model._loads(text, name, [], False))

    @classmethod
    def from_dict(cls, model: Mapping[str, Any], folder: str | os.PathLike[str] = ".") -> "Model":
        """The model in a dictionary with the keys of a model file; drawings are searched in `folder`. Errors say where in the model, such
        as "part 0, loop 0, vertex 2".

        >>> cs.Model.from_dict({"part": [{"name": "coin", "loops": [{"circle": 1, "at": [0, 0]}]}]}).parts["coin"].bounds
        (-1.0, -1.0, 1.0, 1.0)
        """
        if not isinstance(model, Mapping):
            raise Error(f"`model` is {model!r}: give a dictionary with the keys of a model file")
        try:
            text = json.dumps(_plain(dict(model)), allow_nan=False)
        except ValueError:
            raise Error("the model has a number that is not finite") from None
        except TypeError as error:
            raise Error(f"the model has something that is no number, text, list or dictionary: {error}") from None
        return cls(_rust.Model._loads(text, os.path.join(os.path.abspath(folder), "model.json"), [], True))

    def to_dict(self) -> dict[str, Any]:
        """The model as a dictionary with the keys of a model file, of which `from_dict` makes it again; expressions stay as they are, and
        parameters have the values that were set. TOML is read by Python 3.11 or later, or where tomli is installed.

        >>> model(play=0.2).to_dict()["parameter"]["play"]["value"]
        0.2
        """
        text, path, values, _ = self._model._source()
        if path.endswith(".json"):
            found: dict[str, Any] = json.loads(text)
        else:
            found = optional("tomllib" if sys.version_info >= (3, 11) else "tomli").loads(text)
        for name, value in values:
            given = found["parameter"][name]
            value = self.parameters[name] if _is_number(value) else value
            if isinstance(given, dict):
                given["value"] = value
            else:
                found["parameter"][name] = value
        return found

    def __call__(self, /, set: Mapping[str, float | str] | None = None, **parameters: float | str) -> "Model":
        """The model with other values for the `parameters`; in the dictionary `set` their names may be any.

        >>> model(play=0.2).parameters["play"]
        0.2
        """
        return Model(self._model(named("set", set, parameters)))

    @property
    def name(self) -> str:
        """The name.

        >>> model.name
        'model'
        """
        return self._model.name

    @property
    def unit(self) -> str | None:
        """The unit of length, if the model says one.

        >>> model.unit
        'mm'
        """
        return self._model.unit

    @property
    def parts(self) -> dict[str, Part]:
        """The parts by name.

        >>> list(model.parts)
        ['cam', 'fork']
        """
        return _Parts((name, Part._of(part)) for name, part in self._model.parts.items())

    @property
    def parameters(self) -> dict[str, float]:
        """The values of the parameters by name; angles in radians.

        >>> model.parameters
        {'play': 0.1}
        """
        return self._model.parameters

    @property
    def pairs(self) -> list[tuple[str, str]]:
        """The pairs, as names of the fixed and of the moving part.

        >>> model.pairs
        [('cam', 'fork')]
        """
        return self._model.pairs

    @property
    def requirements(self) -> list[str]:
        """The names of the requirements.

        >>> model.requirements
        ['backlash']
        """
        return self._model.requirements

    def compute(
        self, fixed: str | None = None, moving: str | None = None, theta: Sequence[float] | None = None
    ) -> ContactSpace:
        """The configuration space of two parts, by name; of the only pair without names. `theta` is a window of orientations, radians.

        >>> model.compute("cam", "fork").pair_class
        'fixed-axes'
        """
        return ContactSpace(self._model.compute(fixed, moving, window(theta)))

    def poses(self, coordinates: Mapping[str, ArrayLike] | None = None) -> dict[str, NDArray[np.float64]]:
        """Where the parts are: for each the pose (x, y, theta) that takes its drawing to the assembly. `coordinates` are those of parts by
        name, as a `Simulation` has them: a number for a part on an axis, (x, y, theta) for one in the plane; or arrays of n, n and n×3, which
        give n×3. Parts without coordinates are as drawn. Pivots and directions are in `model.info()`: the `motion` of its parts, and
        its joints.

        >>> [round(x, 9) for x in model.poses({"fork": 2.5})["fork"].tolist()]
        [2.5, 0.0, 0.0]
        >>> model.info().parts[0].motion["center"]
        (0.0, 0.0)
        """
        given = dict(coordinates or {})
        drawn: dict[str, NDArray[np.float64]] = {name: np.zeros(3) for name in self.parts}
        return {**drawn, **{name: self._posed(name, at) for name, at in given.items()}}

    def _posed(self, name: str, at: ArrayLike) -> NDArray[np.float64]:
        """The poses of a part at its coordinates."""
        moves = self._model._is_on_axis(name)
        if moves is False:
            raise Error(f"{name} does not move: it has no coordinates")
        form = "(x, y, theta) or an array n×3 of them" if moves is None else "a number or an array of n"
        try:
            found = np.asarray(at, dtype=np.float64)
        except (TypeError, ValueError):
            found = np.array(np.nan)
        if not np.isfinite(found).all() or (found.ndim > 1 if moves else found.shape[-1:] != (3,) or found.ndim > 2):
            raise Error(f"the coordinates of {name} are not {form}, all finite")
        if moves is None:
            return found
        rows: NDArray[np.float64] = self._model._poses(name, np.ascontiguousarray(found.ravel()))
        return rows.reshape(*found.shape, 3)

    def _places(self, fixed: str, moving: str, rows: NDArray[np.float64]) -> list[tuple[Part, NDArray[np.float64]]]:
        """The parts of a pair at its configurations."""
        parts = self.parts
        if rows.shape[1] == 3:
            return [(parts[fixed], np.zeros_like(rows)), (parts[moving], rows)]
        still = np.zeros((len(rows), 3))
        moved = [(name, column) for name, column in zip((fixed, moving), rows.T)]
        return [(parts[name], self._posed(name, column) if self._model._is_on_axis(name) else still) for name, column in moved]

    def _ask(self, question: str, **arguments: Any) -> dict[str, Any]:
        """The answer to a question, of whose arguments those that are None are left out."""
        answer: dict[str, Any] = self._model._ask(question, _given(arguments))
        return answer

    def _plan(self, **arguments: Any) -> Plan:
        """The answer to the question for a path, whose arguments are as of `_ask`."""
        answer, rows = self._model._plan(_given(arguments))
        return Plan(answer, rows, self._places)

    def info(self) -> answers.InfoAnswer:
        """The parts, joints and pairs of the model, with its masses, forces and drives.

        >>> model.info().parts[1].motion["type"]
        'prismatic'
        """
        return answers.InfoAnswer(self._ask("info"))

    def check(self, *requirements: str, sensitivities: bool = False) -> Check:
        """The requirements of these names, or all, measured; with `sensitivities` how much each changes with each parameter.

        >>> model.check()["backlash"].met
        True
        """
        return Check(self._ask("check", requirement=requirements, sensitivities=sensitivities))

    def tolerances(self, *requirements: str, samples: int = 0, seed: int = 0, proof: bool = True) -> Tolerances:
        """What tolerances of the parameters do to the requirements of these names, or to all. `samples` by chance give a yield; without
        `proof` extremes are left as they are found.

        >>> model.tolerances("backlash", samples=1000)["backlash"].monte_carlo.samples
        1000
        """
        for name, count in (("samples", samples), ("seed", seed)):
            if isinstance(count, bool) or not hasattr(count, "__index__") or not 0 <= count < 2**63:
                raise Error(f"`{name}` is {count!r} where a whole number from 0 up is expected")
        return Tolerances(
            self._ask("tolerances", requirement=requirements, samples=samples, seed=seed, no_proof=not proof)
        )

    def sweep(
        self,
        /,
        measures: str | Iterable[str] | None = None,
        rows: Mapping[str, Any] | None = None,
        vary: Mapping[str, Any] | None = None,
        **values: Any,
    ) -> Table:
        """The requirements `measures` (all without) for values of parameters or coordinates: of every combination of `values`, the last
        changing first, or of `rows`, a dictionary of columns. In the dictionary `vary` the names of what has values may be any.

        >>> model.sweep(play=[0.1, 0.2])["backlash"].round(9).tolist()
        [0.1, 0.2]
        """
        names, varied = table(rows, named("vary", vary, values))
        numbers = np.array([column(name, v) for name, v in zip(names, zip(*varied))])
        if not np.isfinite(numbers).all():
            raise Error("a value that is varied is not finite")
        measures = self.requirements if measures is None else [measures] if isinstance(measures, str) else list(measures)
        found = self._ask("sweep", rows={"names": names, "rows": numbers.T}, measure=measures)["rows"]
        columns = dict(zip(names, numbers))
        for name in measures:
            columns[name] = np.array([np.nan if row[name] is None else row[name] for row in found])
        failures = [(i, None, row["failure"]) for i, row in enumerate(found) if "failure" in row]
        if found and all(row[name] is None for row in found for name in measures):
            raise Error(f"no row has an answer; the first ends with {failures[0][2]}")
        return Table(columns, failures)

    def solve(
        self,
        /,
        requirement: str,
        relation: str,
        value: float | bool,
        samples: int = 65,
        vary: Mapping[str, Sequence[float]] | None = None,
        **ranges: Sequence[float],
    ) -> answers.SolveAnswer:
        """Values of parameters, each from lo to hi, at which a requirement is `=`, `<=` or `>=` a value. In the dictionary `vary` the names
        of what has `ranges` may be any.

        >>> round(model.solve("backlash", "=", 0.15, play=(0.01, 0.5)).solutions[0]["play"], 9)
        0.15
        """
        ranges = named("vary", vary, ranges)
        try:
            varied = [{"parameter": name, "lo": float(lo), "hi": float(hi)} for name, (lo, hi) in ranges.items()]
        except (TypeError, ValueError):
            raise Error("a range is not two numbers (lo, hi)") from None
        if not isinstance(value, (bool, int, float, np.bool_, np.integer, np.floating)) or value != value:
            raise Error(f"`value` is {value!r} where a number, true or false is expected")
        if not varied:
            raise Error("no parameter is varied: give a range, solve(..., play=(0.01, 0.5))")
        for name, (lo, hi) in ranges.items():
            if not lo < hi:
                raise Error(f"the range of {name} is empty")
        if relation not in _RELATIONS:
            raise Error(f"{relation!r} is not =, <= or >=")
        goal = {"requirement": requirement, "relation": _RELATIONS[relation], "value": value}
        return answers.SolveAnswer(self._ask("solve", vary=varied, so_that=goal, samples=samples))

    def play(
        self, at: ArrayLike | None = None, by: ArrayLike | None = None, pair: str | Sequence[str] | None = None, touch: float | None = None
    ) -> answers.PlayAnswer:
        """What touches at a configuration, as drawn without one, and how far the parts go from it in each direction; with the displacement
        `by` how far that leads. `pair` names the fixed and the moving part.

        >>> model.play(at=(0, 3)).pairs[0].outcome
        'free'
        """
        return answers.PlayAnswer(self._ask("play", at=given("at", at), by=given("by", by), pair=pair_names(pair), touch=_number("touch", touch)))

    def plan(
        self,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        pair: str | Sequence[str] | None = None,
        widest: bool = False,
        clearance: float | None = None,
        proof: bool = False,
        about: Sequence[float] | None = None,
        prefer: str = "legs",
    ) -> Plan:
        """A path of a pair from `start`, as drawn without one, to `goal`, or out, or that there is none; with `proof` a proof of that. The
        other arguments are as of `ContactSpace.plan`.

        >>> model.plan((0, 3), (0, 3.01)).outcome
        'path'
        """
        return self._plan(
            **{"from": given("start", start)},
            to=given("goal", goal),
            pair=pair_names(pair),
            widest=widest,
            clearance=_number("clearance", clearance),
            proof=proof,
            about=None if about is None else position("about", about),
            prefer=prefer,
        )

    def escape(
        self,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        pair: str | Sequence[str] | None = None,
        gravity: Sequence[float] | None = None,
    ) -> Escape:
        """The least energy with which the moving part of a pair leaves the place `start`, against gravity, loads and springs of the model:
        for good, or to `goal`. `gravity` (x, y) is in place of the model's.

        >>> cup.escape(gravity=(0, -5)).most < 21
        True
        """
        if gravity is not None:
            gravity = position("gravity", gravity)
        asked = self._ask(
            "escape",
            **{"from": given("start", start)},
            to=given("goal", goal),
            pair=pair_names(pair),
            gravity=gravity,
        )
        return Escape(asked)

    def disassemble(self, gap: float | None = None) -> answers.DisassembleAnswer:
        """Whether the parts of the model come apart, group by group, and in which order. Parts that touch as drawn are moved apart by
        `gap`.

        >>> cup.disassemble().outcome
        'apart'
        """
        return answers.DisassembleAnswer(self._ask("disassemble", gap=_number("gap", gap)))

    def clearance(
        self, pair: str | Sequence[str] | None = None, within: float | None = None, drawn: bool = False
    ) -> answers.ClearanceAnswer:
        """The smallest gap of every two parts, what stops them, or by how much they overlap, the worst first; of pairs nearer than `within`.
        Two parts on axes are looked at over all motions that their ranges allow, unless all are to be as `drawn`.

        >>> model.clearance().pairs[0].over
        'ranges'
        """
        return answers.ClearanceAnswer(
            self._ask("clearance", pair=pair_names(pair), within=_number("within", within), drawn=drawn)
        )

    def modes(self, parts: Sequence[str] | None = None, at: Sequence[float] = (0, 0, 0)) -> answers.ModesAnswer:
        """The operating modes of three parts, by name, whose coordinates are u, v and w in that order; of those that move on axes without
        names. More parts have coordinates q4, q5 and so on. `at` (u, v, w, ...), radians of a part that turns, is the configuration of
        which the mode is told; what is left out after w is 0.

        >>> cs.Model.load("interlock.toml").modes().outcome
        'done'
        """
        if parts is not None and (isinstance(parts, str) or len(parts) < 3):
            raise Error(f"`parts` is {parts!r} where three names or more are expected")
        if isinstance(at, (int, float)) or len(at) < 3:
            raise Error(f"`at` is {at!r} where three numbers (u, v, w) or more are expected")
        letters = [*"uvw", *(f"q{k}" for k in range(4, len(at) + 1))]
        where = ",".join(f"{letter}={number('at', t)!r}" for letter, t in zip(letters, at))
        return answers.ModesAnswer(self._ask("modes", parts=None if parts is None else ",".join(parts), at=where))

    def simulate(self, time: float, every: float | None = None, forces: bool = False) -> Simulation:
        """The motion of the mechanism over `time` seconds, with inertia if a part has a mass; samples are `every` seconds apart, and have
        rates.

        >>> model.simulate(1.0, every=0.5).coordinates["cam"].shape
        (3,)
        """
        every = _number("every", every)
        asked = self._ask("simulate", time=number("time", time), every=every, rates=True, forces=forces)
        return Simulation(asked, self._drawn)

    def _drawn(self, coordinates: Mapping[str, ArrayLike]) -> dict[str, tuple[Part, NDArray[np.float64]]]:
        """The parts and their poses."""
        parts = self.parts
        return {name: (parts[name], poses) for name, poses in self.poses(coordinates).items()}

    def __repr__(self) -> str:
        return repr(self._model)

    def __reduce__(self) -> Any:
        return _restored, self._model._source()

    @classmethod
    def from_assembly(
        cls,
        assembly: Any,
        tol: float = 1e-3,
        plane: Any = None,
        ground: str | None = None,
        motion: Mapping[str, Any] | None = None,
        join: float = JOIN,
    ) -> "Model":
        """The model of an assembly of build123d or CadQuery, or of a list of solids of these and FreeCAD, in mm: parts of layers as of
        `Part.from_solid`, drawn where they stand.

        They move in the world's horizontal plane, or in `plane`. The part `ground`, by default the first, is fixed. Of build123d's joints a
        RevoluteJoint or a LinearJoint to the ground is a motion, whose `range` is the joint's, from where the parts stand; one between two
        others is a joint, which has no range; parts of two RigidJoints are one body. Parts without joints, such as CadQuery's, are
        free (planar), unless `motion` says, by their names, how they move, as in a model file:

        >>> Model.from_assembly(hinge, motion={"leaf": {"type": "revolute", "center": [0, 0]}})  # doctest: +SKIP

        Parts are called by their labels, and numbered where several have the same. Curves other than lines and circles are followed within
        `tol`, and a warning says how near.
        """
        made, note = _assembly.model(assembly, tol, plane, ground, motion, join)
        if note is not None:
            warnings.warn(f"{note}: give a smaller `tol`", stacklevel=2)
        return cls.loads(json.dumps(made), "assembly.json")


class _Parts(dict[str, Part]):
    """Parts by name."""

    def __missing__(self, name: str) -> Part:
        raise Error(f"there is no part named {name!r}: the parts are {', '.join(self)}")


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _restored(text: str, path: str, values: list[tuple[str, str]], of_values: bool) -> Model:
    return Model(_rust.Model._loads(text, path, values, of_values))
