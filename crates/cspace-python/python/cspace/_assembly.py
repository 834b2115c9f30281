"""Mechanisms of CAD assemblies: parts where they stand, and the joints between them.

build123d's joints are read; CadQuery has constraints in their place, which are no motions, and its parts come without.
"""

import copy
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _cad
from ._errors import Error
from ._part import Part
from ._solid import Solid

_Matrix = NDArray[np.float64]


def _matrix(location: Any) -> _Matrix:
    """The 4×4 matrix of a Location of build123d or CadQuery, or of a Placement of FreeCAD."""
    if hasattr(location, "toMatrix"):
        return np.array(location.toMatrix().A, dtype=float).reshape(4, 4)
    moved = location.wrapped.Transformation()
    return np.array([[moved.Value(r, c) for c in range(1, 5)] for r in range(1, 4)] + [[0.0, 0.0, 0.0, 1.0]])


@dataclass(frozen=True)
class _Placed:
    """A part of an assembly: its name and shape, and what takes the shape's coordinates, and those of its joints, to the assembly's."""

    name: str
    shape: Any
    of_shape: _Matrix
    of_joints: _Matrix


def _placed(assembly: Any) -> Iterator[_Placed]:
    """The parts of an assembly, or of a list of shapes."""
    here = np.eye(4)
    if isinstance(assembly, (list, tuple)):
        for i, shape in enumerate(assembly):
            yield from _leaves(shape, f"part {i}")
    elif hasattr(assembly, "traverse"):
        for shape, name, location, _ in assembly:
            # Names begin with that of the whole assembly.
            yield _Placed(name.partition("/")[2] or name, shape, _matrix(location), here)
    else:
        yield from _leaves(assembly, "part")


def _leaves(node: Any, number: str) -> Iterator[_Placed]:
    children = list(getattr(node, "children", ()))
    if children and any(joint.connected_to for joint in node.joints.values()):
        raise Error(f"a joint is of {node.label or number!r}, which is an assembly itself\nhelp: give the joint to one of its parts")
    for i, child in enumerate(children):
        yield from _leaves(child, f"{number}.{i}" if number != "part" else f"part {i}")
    if not children:
        name = getattr(node, "label", None) or getattr(node, "Label", None) or number
        joints = shape = np.eye(4)
        if hasattr(node, "global_location"):
            # Coordinates of the shape include its own place, but not that of the assemblies that it is in.
            joints = _matrix(node.global_location)
            shape = joints @ np.linalg.inv(_matrix(node.location))
        yield _Placed(name, node, shape, joints)


def _named(parts: list[_Placed]) -> list[_Placed]:
    """The parts with names of their own: those that are called the same are numbered."""
    seen: dict[str, int] = {}
    named = []
    for part in parts:
        seen[part.name] = count = seen.get(part.name, 0) + 1
        named.append(part if count == 1 else _Placed(f"{part.name} {count}", part.shape, part.of_shape, part.of_joints))
    return named


@dataclass(frozen=True)
class _Joint:
    """A joint in the plane: what the second part does beside the first, and between which limits."""

    called: str
    parts: tuple[str, str]
    keys: dict[str, Any]
    limits: tuple[float, float] | None = None

    def motion(self, moving: str) -> dict[str, Any]:
        """The motion of one of its parts while the other stands still."""
        keys = dict(self.keys)
        if "at" in keys:
            keys["center"] = keys.pop("at")
        if self.limits is not None:
            lo, hi = self.limits
            keys["range"] = [lo, hi] if moving == self.parts[1] else [-hi, -lo]
        return keys


class _Reader:
    """The joints of parts, in a plane in which they are `size` large."""

    def __init__(self, parts: list[_Placed], frame: _cad.Frame, size: float, join: float) -> None:
        self.frame, self.size, self.join = frame, size, join
        self.parts = {id(part.shape): part for part in parts}

    def joints(self) -> Iterator[_Joint]:
        """The joints that connect two of the parts."""
        for part in self.parts.values():
            for joint in getattr(part.shape, "joints", {}).values():
                if joint.connected_to is not None:
                    yield self._joint(joint, joint.connected_to)

    def _joint(self, first: Any, second: Any) -> _Joint:
        # A rigid one has only a place.
        if type(first).__name__ == "RigidJoint":
            first, second = second, first
        kinds = type(first).__name__, type(second).__name__
        a, b = self._part(first), self._part(second)
        called = f"the joint {first.label!r} of {a.name!r} and {b.name!r}"
        parts = a.name, b.name
        if kinds == ("RigidJoint", "RigidJoint"):
            return _Joint(called, parts, {"type": "rigid"})
        if kinds not in (("RevoluteJoint", "RigidJoint"), ("LinearJoint", "RigidJoint")):
            raise Error(
                f"{called} is a {' on a '.join(kinds)}, which is no joint in a plane\nhelp: revolute, linear and rigid ones are"
            )
        turns = kinds[0] == "RevoluteJoint"
        axis = first.relative_axis
        point, along = _cad.xyz(axis.position), _cad.xyz(axis.direction)
        at, ahead = (a.of_joints @ [*point, 1.0])[:3], a.of_joints[:3, :3] @ along
        off = float(np.linalg.norm(np.cross(ahead, self.frame.z)) if turns else abs(ahead @ self.frame.z))
        if off * self.size > self.join:
            wanted = "normal to" if turns else "in"
            tilt = math.degrees(math.asin(min(off, 1.0)))
            raise Error(
                f"{called} has an axis that is not {wanted} the plane of the mechanism: it is {tilt:.6g}° off"
                "\nhelp: give the plane in which the parts move as `plane`"
            )
        span, passed = self._passed(first, second, a, b, turns, called)
        place = self.frame.at(at)
        keys: dict[str, Any] = {"type": "revolute", "at": [place.real, place.imag]}
        sign = math.copysign(1, ahead @ self.frame.z)
        if not turns:
            way, sign = self.frame.along(ahead), 1.0
            keys = {"type": "prismatic", "direction": [way.real, way.imag]}
        if math.isinf(span) or turns and span >= math.tau:
            return _Joint(called, parts, keys)
        limits = -passed, span - passed
        return _Joint(called, parts, keys, limits if sign > 0 else (-limits[1], -limits[0]))

    def _part(self, joint: Any) -> _Placed:
        try:
            return self.parts[id(joint.parent)]
        except KeyError:
            raise Error(f"the joint {joint.label!r} is of a part that is not in the assembly") from None

    def _passed(self, first: Any, second: Any, a: _Placed, b: _Placed, turns: bool, called: str) -> tuple[float, float]:
        """How far a joint goes from its lower to its upper limit, and how far it has gone as the parts stand."""
        lo, hi = (first.angular_range if turns else first.linear_range)[:]
        if math.isinf(lo) != math.isinf(hi):
            raise Error(f"{called} has the range ({lo:g}, {hi:g})\nhelp: give it two finite limits, or (-inf, inf)")
        base = 0.0 if math.isinf(lo) else lo
        # The place of the second part beside the first is asked of the joint; a copy of it, for it keeps what it was asked.
        asked = copy.copy(first).relative_to(second, **{"angle" if turns else "position": base})
        moved = np.linalg.inv(a.of_joints) @ b.of_joints @ np.linalg.inv(_matrix(asked))
        axis = first.relative_axis
        point, along = _cad.xyz(axis.position), _cad.xyz(axis.direction)
        spin = moved[:3, :3]
        if turns:
            wound = np.array([spin[2, 1] - spin[1, 2], spin[0, 2] - spin[2, 0], spin[1, 0] - spin[0, 1]])
            passed = math.atan2(wound @ along / 2, (np.trace(spin) - 1) / 2)
            span = math.radians(hi - lo)
            # The turn that is nearest to the middle of the range.
            passed += math.tau * round((span / 2 - passed) / math.tau)
            slip = np.linalg.norm((moved @ [*point, 1.0])[:3] - point) + self.size * np.linalg.norm(spin @ along - along)
        else:
            passed, span = float(moved[:3, 3] @ along), hi - lo
            slip = np.linalg.norm(moved[:3, 3] - passed * along) + self.size * np.linalg.norm(spin - np.eye(3))
        reach = self.size if turns else 1.0
        beyond = 0.0 if turns and span >= math.tau else max(-passed, passed - span) * reach
        if slip > self.join or beyond > self.join:
            raise Error(f"{called} is not where its parts are\nhelp: connect them again, within the joint's range")
        return span, min(max(passed, 0.0), span)


def model(
    assembly: Any, tol: float, plane: Any, ground: str | None, motion: Mapping[str, Any] | None, join: float
) -> tuple[dict[str, Any], str | None]:
    """The model of an assembly, as in a model file, and what is to be known of its curves, if there are some."""
    up = np.eye(3)
    frame = _cad.Frame.of(np.zeros(3), up[2], up[0]) if plane is None else _cad.Frame.given(plane)
    placed = _named(list(_placed(assembly)))
    if not placed:
        raise Error("the assembly has no parts")
    names = [part.name for part in placed]
    for name in [*([] if ground is None else [ground]), *(motion or {})]:
        if name not in names:
            raise Error(f"there is no part named {name!r}\nhelp: the parts are {', '.join(names)}")
    parts, marks = {}, []
    for part in placed:
        back = np.linalg.inv(part.of_shape)
        own = (back @ [*frame.origin, 1.0])[:3], back[:3, :3] @ frame.x, back[:3, :3] @ frame.z
        try:
            cut = Solid(part.shape, own, join)
            parts[part.name] = Part._layered(cut, tol, part.name)
        except Error as error:
            raise Error(f"{part.name}: {error}") from None
        marks.append(cut.marks @ part.of_shape[:3, :3].T + part.of_shape[:3, 3])
    size = float(np.linalg.norm(np.ptp(np.concatenate(marks), axis=0)))
    joints = list(_Reader(placed, frame, size, join).joints())
    still = {ground or names[0]}
    while more := {n for j in joints if j.keys["type"] == "rigid" and still & {*j.parts} for n in j.parts} - still:
        still |= more
    motions: dict[str, Any] = {name: {"type": "fixed"} for name in still}
    kept = []
    for joint in joints:
        moving = [name for name in joint.parts if name not in still]
        if joint.keys["type"] == "rigid" or len(moving) == 2:
            if joint.limits is not None:
                raise Error(
                    f"{joint.called} has a range, and neither part stands still: a model has ranges of motions beside the ground"
                    "\nhelp: give it (0, 360) or (-inf, inf)"
                )
            kept.append({**joint.keys, "parts": list(joint.parts)})
        elif moving:
            if motions.get(moving[0], joint.motion(moving[0])) != joint.motion(moving[0]):
                raise Error(f"{joint.called} is not the only one of {moving[0]!r} to the ground: what moves it cannot be told")
            motions[moving[0]] = joint.motion(moving[0])
    motions.update(motion or {})
    free = {"type": "planar"}
    bodies = {name for joint in kept for name in joint["parts"]}
    entries = []
    for name, solid in parts.items():
        entry: dict[str, Any] = {"name": name, "layers": [{"z": z, "loops": loops} for z, loops in solid.layers]}
        # A part that a joint holds moves as the joint says.
        if name in motions or name not in bodies:
            entry["motion"] = motions.get(name, free)
        entries.append(entry)
    label = getattr(assembly, "label", None) or getattr(assembly, "name", None) or "assembly"
    made = {"name": label, "unit": "mm", "part": entries, **({"joint": kept} if kept else {})}
    fitted = {name: off for name, part in parts.items() if (off := part.fitted)}
    if not fitted:
        return made, None
    return made, (
        f"{', '.join(fitted)}: curves that are no lines or circles are followed within {max(fitted.values()):.2g} mm; "
        "gaps and overlaps of less than twice that are not told apart"
    )
