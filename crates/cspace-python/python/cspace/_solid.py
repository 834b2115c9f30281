"""Solids of CAD cut by planes: at one height, or in layers between their horizontal faces."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _cad, _wires
from ._errors import Error
from ._optional import optional

# Heights are rounded to OCCT's size of a vertex, 1e-7: what one program computes in two ways is one height.
_DIGITS = 7

# What a section within a layer may not cross, in words.
_WHAT = {"ConicalSurface": "cone", "Cone": "cone", "ToroidalSurface": "torus", "Toroid": "torus", "SphericalSurface": "sphere"}

# The section by a plane is taken of a square so much larger than the solid.
_BEYOND = 4.0


@dataclass(frozen=True)
class _Face:
    """A face: its number, its surface, and the heights of its edges."""

    number: int
    surface: _cad.Surface
    lo: float
    hi: float

    def called(self) -> str:
        kind = self.surface.kind
        return f"face {self.number} ({_WHAT.get(kind, kind)}, from height {round(self.lo, _DIGITS):g} to {round(self.hi, _DIGITS):g})"

    def is_level(self, join: float) -> bool:
        return self.surface.is_plane and self.hi - self.lo <= 2 * join

    def is_upright(self, frame: _cad.Frame, join: float) -> bool:
        """Whether a point of it that goes up by its height stays within `join` above where it was."""
        axis = self.surface.axis
        if axis is None:
            return False
        axis = axis / np.linalg.norm(axis)
        lean = abs(axis @ frame.z) if self.surface.is_plane else np.linalg.norm(np.cross(axis, frame.z))
        return bool(lean * (self.hi - self.lo) <= join)


class Solid:
    """A solid that is cut across the normal of a plane."""

    def __init__(self, given: Any, plane: Any, join: float) -> None:
        found = list(_cad.shapes(given))
        if len(found) != 1 or not _cad.parts_of(found[0], "Solids"):
            raise Error(f"the {type(given).__name__} is not one solid\nhelp: Part.from_cad makes a part of planar faces")
        self.shape, self.join = found[0], join
        up = np.eye(3)
        self.frame = _cad.Frame.of(np.zeros(3), up[2], up[0]) if plane is None else _cad.Frame.given(plane)
        self.faces = []
        marks = []
        for i, face in enumerate(_cad.parts_of(self.shape, "Faces")):
            points = [mark for edge in _cad.parts_of(face, "Edges") for mark in _cad.curve(edge).marks]
            heights = [self.frame.height(point) for point in points]
            self.faces.append(_Face(i, _cad.surface(face), min(heights, default=0.0), max(heights, default=0.0)))
            marks += points
        self.marks = np.array(marks)

    def at(self, height: float) -> list[list[_wires.Edge]]:
        """The wires of its section at a height, at which it has no face."""
        for face in self.faces:
            if face.is_level(self.join) and abs(height - face.lo) <= 2 * self.join:
                raise Error(f"{face.called()} is at `z`, {height:g}\nhelp: give a height between horizontal faces")
        if not min(f.lo for f in self.faces) < height < max(f.hi for f in self.faces):
            raise Error(f"the solid is not at `z`, {height:g}")
        return self._cut(height)

    def layers(self) -> list[tuple[tuple[float, float], list[list[_wires.Edge]]]]:
        """The heights between neighbouring horizontal faces, with the wires of the section there, which is the same at all of them."""
        slanted = [f for f in self.faces if not f.is_level(self.join) and not f.is_upright(self.frame, self.join)]
        if slanted:
            more = f" and {len(slanted) - 1} more" if len(slanted) > 1 else ""
            raise Error(
                f"{slanted[0].called()}{more} is neither horizontal nor upright: the section changes there"
                "\nhelp: take off chamfers and fillets of horizontal edges, or give the `plane` in which the parts move; "
                "Part.from_solid gives the section at one height, `z`"
            )
        levels = sorted({round(f.lo, _DIGITS) for f in self.faces if f.is_level(self.join)})
        cut = [((lo, hi), self._cut((lo + hi) / 2)) for lo, hi in zip(levels, levels[1:])]
        return [(z, wires) for z, wires in cut if wires]

    def _cut(self, height: float) -> list[list[_wires.Edge]]:
        frame, middle = self.frame, np.mean(self.marks, axis=0)
        center = middle + (height - frame.height(middle)) * frame.z
        groups = [[_cad.curve(e) for e in _cad.parts_of(w, "Edges")] for w in self._sections(center)]
        if not groups:
            return []
        return _cad.wires_in(groups, frame, self.join, "the section")

    def _sections(self, center: Any) -> list[Any]:
        """The wires of the section through a point, cut by the program that the solid is of."""
        shape, normal = self.shape, self.frame.z.tolist()
        if hasattr(shape, "slice"):
            vector = type(shape.BoundBox.Center)
            return list(shape.slice(vector(*normal), float(center @ self.frame.z)))
        side = _BEYOND * float(np.linalg.norm(np.ptp(self.marks, axis=0)))
        if hasattr(shape, "geom_type"):
            cad = optional("build123d")
            sheet = cad.Face.make_rect(side, side, cad.Plane(center.tolist(), self.frame.x.tolist(), normal))
        else:
            cad = optional("cadquery")
            sheet = cad.Face.makePlane(side, side, cad.Vector(*center.tolist()), cad.Vector(*normal))
        cut = shape.intersect(sheet)
        pieces = list(cut) if isinstance(cut, (list, tuple)) else [] if cut is None else [cut]
        return [w for piece in pieces for f in _cad.parts_of(piece, "Faces") for w in _cad.parts_of(f, "Wires")]
