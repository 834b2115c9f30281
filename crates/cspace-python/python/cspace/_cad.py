"""Faces, wires and sketches of build123d, CadQuery and FreeCAD, read by their interfaces: none of the three is imported.

build123d and CadQuery hand out OCCT's own curves and surfaces, FreeCAD its names for them.
"""

import cmath
import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _wires
from ._errors import Error

_Vector = NDArray[np.float64]

_AXES = np.eye(3)


def xyz(point: Any) -> _Vector:
    """The coordinates of a point or of a vector: attributes of FreeCAD, build123d and CadQuery, methods of OCCT; or three numbers."""
    for names in ("XYZ", "xyz"):
        if hasattr(point, names[0]):
            return np.array([float(c() if callable(c) else c) for c in (getattr(point, name) for name in names)])
    return np.array([float(c) for c in point])


@dataclass(frozen=True)
class Frame:
    """A plane in space: its origin, and orthonormal axes."""

    origin: _Vector
    x: _Vector
    y: _Vector
    z: _Vector

    @classmethod
    def of(cls, origin: _Vector, normal: _Vector, x: _Vector) -> "Frame":
        """The frame of a normal and of a direction whose part in the plane is its x axis."""
        lengths = float(np.linalg.norm(normal)), float(np.linalg.norm(np.cross(normal, x)))
        if not all(lengths):
            raise Error("the normal of the plane is zero, or along its x axis")
        z = normal / lengths[0]
        y = np.cross(z, x) / np.linalg.norm(np.cross(z, x))
        return cls(origin, np.cross(y, z), y, z)

    @classmethod
    def given(cls, plane: Any) -> "Frame":
        """The frame of a Plane of build123d or CadQuery, or of (origin, x direction, normal)."""
        for names in (("origin", "x_dir", "z_dir"), ("origin", "xDir", "zDir")):
            if hasattr(plane, names[1]):
                origin, x, z = (xyz(getattr(plane, name)) for name in names)
                return cls.of(origin, z, x)
        try:
            origin, x, z = map(xyz, plane)
        except (TypeError, ValueError):
            raise Error(f"`plane` is {plane!r}: give a Plane, or (origin, x direction, normal)") from None
        return cls.of(origin, z, x)

    @classmethod
    def seen(cls, point: _Vector, normal: _Vector) -> "Frame":
        """The frame of a plane through a point, as drawings show it: from above, from the front or from the right.

        Its origin is the world's, moved along the normal into the plane; its x axis is the world's, or its y axis if seen from the right.
        """
        # What an axis is turned by in rounding is no other view.
        steep = np.abs(normal) > 1e-9
        side = normal[2] if steep[2] else -normal[1] if steep[1] else normal[0]
        normal = normal * np.sign(side)
        is_right = abs(normal[0]) > max(abs(normal[1]), abs(normal[2]))
        return cls.of(normal * (normal @ point), normal, _AXES[1] if is_right else _AXES[0])

    def at(self, point: _Vector) -> complex:
        """A point as seen along the normal."""
        return self.along(point - self.origin)

    def along(self, vector: _Vector) -> complex:
        """A vector as seen along the normal."""
        return complex(vector @ self.x, vector @ self.y)

    def height(self, point: _Vector) -> float:
        """How high a point is above the plane."""
        return float((point - self.origin) @ self.z)


@dataclass(frozen=True)
class Curve:
    """A curve in space between two parameters: a line, the points center + cos t · u + sin t · v, or a B-spline; or its points alone."""

    first: float
    last: float
    at: Callable[[float], _Vector]
    kind: str = "other"
    is_round: bool = False
    center: _Vector | None = None
    u: _Vector | None = None
    v: _Vector | None = None
    degree: int = 0
    knots: tuple[float, ...] = ()
    poles: tuple[_Vector, ...] = ()
    weights: tuple[float, ...] = ()

    @property
    def marks(self) -> list[_Vector]:
        """Points that are in the plane of the curve, and in no other unless it is a line."""
        ends = [self.at(self.first), self.at(self.last)]
        if self.center is not None and self.u is not None and self.v is not None:
            return [*ends, self.center + self.u, self.center + self.v, self.center]
        if self.kind == "other":
            # Half a Chebyshev grid: not the symmetric places at which a curve may cross a plane.
            shares = [(1 - math.cos(math.pi * k / 16)) / 2 for k in range(17)]
            return [self.at(self.first + s * (self.last - self.first)) for s in shares]
        return [*ends, *self.poles]

    def edge(self, frame: Frame, join: float) -> _wires.Edge:
        """The curve in a plane that it is in."""
        start, end = frame.at(self.at(self.first)), frame.at(self.at(self.last))
        if self.kind == "line":
            return _wires.line(start, end)
        if self.center is not None and self.u is not None and self.v is not None:
            center, u, v = frame.at(self.center), frame.along(self.u), frame.along(self.v)
            if not self.is_round:
                return _wires.ellipse(center, u, v, self.first, self.last)
            turn = (self.last - self.first) * math.copysign(1, (u.conjugate() * v).imag)
            if abs(turn) > math.pi and abs(end - start) <= join:
                return _wires.circle(start, 2 * center - start)
            return _wires.arc(start, end, math.tan(turn / 4))
        if self.poles:
            poles = [frame.at(pole) for pole in self.poles]
            return _wires.spline(start, end, self.degree, list(self.knots), poles, list(self.weights))
        if abs(end - start) <= join:
            end = start
        return _wires.Edge(
            start, end, (), (), lambda share: frame.at(self.at(self.first + share * (self.last - self.first)))
        )


def curve(edge: Any) -> Curve:
    """The curve of an edge."""
    adaptor = getattr(edge, "geom_adaptor", None) or getattr(edge, "_geomAdaptor", None)
    return _of_occt(adaptor()) if adaptor else _of_freecad(edge)


def _of_occt(adaptor: Any) -> Curve:
    kind = adaptor.GetType().name.removeprefix("GeomAbs_")
    first, last = adaptor.FirstParameter(), adaptor.LastParameter()

    def at(t: float) -> _Vector:
        return xyz(adaptor.Value(t))

    if kind == "Line":
        return Curve(first, last, at, "line")
    if kind in ("Circle", "Ellipse"):
        conic = getattr(adaptor, kind)()
        radii = [conic.Radius()] * 2 if kind == "Circle" else [conic.MajorRadius(), conic.MinorRadius()]
        axes = conic.Position()
        return _conic(first, last, at, kind, conic.Location(), radii, [axes.XDirection(), axes.YDirection()])
    if kind in ("BSplineCurve", "BezierCurve"):
        # A copy: the shape keeps its own, from which only a piece may be taken.
        copy = getattr(adaptor, kind.removesuffix("Curve"))().Copy()
        copy.Segment(first, last)
        count, knots = copy.NbPoles(), [(0.0, copy.Degree() + 1), (1.0, copy.Degree() + 1)]
        if kind == "BSplineCurve":
            knots = [(copy.Knot(i), copy.Multiplicity(i)) for i in range(1, copy.NbKnots() + 1)]
        poles = [copy.Pole(i) for i in range(1, count + 1)]
        return _spline(first, last, at, copy.Degree(), knots, poles, [copy.Weight(i) for i in range(1, count + 1)])
    return Curve(first, last, at)


def _of_freecad(edge: Any) -> Curve:
    if not hasattr(edge, "ParameterRange"):
        raise Error(f"{edge!r} is no edge of build123d, CadQuery or FreeCAD")
    drawn = edge.Curve
    kind = drawn.TypeId.removeprefix("Part::Geom")
    first, last = edge.ParameterRange

    def at(t: float) -> _Vector:
        return xyz(edge.valueAt(t))

    if kind in ("Line", "LineSegment"):
        return Curve(first, last, at, "line")
    if kind in ("Circle", "Ellipse"):
        radii = [drawn.Radius] * 2 if kind == "Circle" else [drawn.MajorRadius, drawn.MinorRadius]
        return _conic(first, last, at, kind, drawn.Center, radii, [drawn.XAxis, drawn.YAxis])
    if kind in ("BSplineCurve", "BezierCurve"):
        copy = drawn.copy()
        copy.segment(first, last)
        knots = [(0.0, copy.Degree + 1), (1.0, copy.Degree + 1)]
        if kind == "BSplineCurve":
            knots = list(zip(copy.getKnots(), copy.getMultiplicities()))
        return _spline(first, last, at, copy.Degree, knots, copy.getPoles(), copy.getWeights())
    return Curve(first, last, at)


def _conic(
    first: float, last: float, at: Callable[[float], _Vector], kind: str, center: Any, radii: list[float], axes: list[Any]
) -> Curve:
    u, v = (radius * xyz(axis) for radius, axis in zip(radii, axes))
    return Curve(first, last, at, kind, is_round=kind == "Circle", center=xyz(center), u=u, v=v)


def _spline(
    first: float,
    last: float,
    at: Callable[[float], _Vector],
    degree: int,
    knots: list[tuple[float, int]],
    poles: Iterable[Any],
    weights: Iterable[float],
) -> Curve:
    flat = tuple(float(knot) for knot, times in knots for _ in range(times))
    return Curve(
        first, last, at, "spline", degree=degree, knots=flat, poles=tuple(map(xyz, poles)), weights=tuple(map(float, weights))
    )


# Surfaces by their names in OCCT, without "Geom_", and in FreeCAD, without "Part::Geom".
_PLANE, _CYLINDER = ("Plane",), ("CylindricalSurface", "Cylinder")
_EXTRUSION = ("SurfaceOfLinearExtrusion", "SurfaceOfExtrusion")


@dataclass(frozen=True)
class Surface:
    """A surface: its name, and the normal of a plane, the axis of a cylinder or the direction of an extrusion."""

    kind: str
    axis: _Vector | None = None

    @property
    def is_plane(self) -> bool:
        """Whether it is a plane, which its axis is normal to."""
        return self.kind in _PLANE


def surface(face: Any) -> Surface:
    """The surface of a face."""
    adaptor = getattr(face, "geom_adaptor", None) or getattr(face, "_geomAdaptor", None)
    if adaptor is None:
        found = face.Surface
        kind = found.TypeId.removeprefix("Part::Geom")
        axis = found.Direction if kind in _EXTRUSION else getattr(found, "Axis", None)
        return Surface(kind, None if axis is None else xyz(axis))
    found = adaptor()
    kind = found.DynamicType().Name().removeprefix("Geom_")
    while kind == "RectangularTrimmedSurface":
        found = found.BasisSurface()
        kind = found.DynamicType().Name().removeprefix("Geom_")
    if kind in _EXTRUSION:
        return Surface(kind, xyz(found.Direction()))
    if kind in _PLANE or kind in _CYLINDER:
        axis = (found.Pln() if kind in _PLANE else found.Cylinder()).Axis().Direction()
        return Surface(kind, xyz(axis))
    return Surface(kind)


def parts_of(shape: Any, kind: str) -> list[Any]:
    """The faces, wires, edges or solids of a shape, by the name of their kind: "Faces"."""
    found = getattr(shape, kind, None)
    if found is None:
        found = getattr(shape, kind.lower(), None)
    return list(found() if callable(found) else found or ())


def shapes(given: Any) -> Iterator[Any]:
    """The shapes of what is given: of a builder, a Workplane, a Sketch or a document's object, and of a list of these."""
    if isinstance(given, (list, tuple)):
        for item in given:
            yield from shapes(item)
    elif hasattr(given, "Shape"):
        yield given.Shape
    elif callable(getattr(given, "vals", None)):
        # A Sketch of CadQuery has its faces beside what is selected, which may be places alone.
        found = [value for value in given.vals() if hasattr(value, "Edges")]
        yield from shapes(found or [getattr(given, "_faces", None)])
    elif hasattr(given, "edges") or hasattr(given, "Edges"):
        yield next((getattr(given, name) for name in ("part", "sketch", "line") if hasattr(given, name)), given)
    else:
        raise Error(f"{given!r} is no shape of build123d, CadQuery or FreeCAD")


def _wires_of(shape: Any) -> list[Any]:
    return parts_of(shape, "Wires") or [shape]


def frame_of(curves: list[Curve], join: float) -> Frame:
    """The plane that curves are in."""
    marks = np.array([mark for curve in curves for mark in curve.marks])
    if np.ptp(marks[:, 2]) <= 2 * join:
        return Frame.of(np.zeros(3), _AXES[2], _AXES[0])
    # The three places that are farthest apart tell the plane best.
    base = marks[0]
    arm = max(marks - base, key=np.linalg.norm)
    normal = max(np.cross(arm, marks - base), key=np.linalg.norm)
    if not np.linalg.norm(normal) > join * np.linalg.norm(arm):
        raise Error("the edges lie on one line")
    return Frame.seen(base, normal / np.linalg.norm(normal))


def wires_in(groups: list[list[Curve]], frame: Frame, join: float, what: str) -> list[list[_wires.Edge]]:
    """The edges of wires in a plane, in which they must be but for what is parallel to it and one height."""
    heights = np.array([frame.height(mark) for wire in groups for curve in wire for mark in curve.marks])
    if np.ptp(heights) > 2 * join:
        raise Error(
            f"{what} is not in one plane: it is {np.ptp(heights):.6g} high along ({', '.join(f'{c:.6g}' for c in frame.z)})"
            "\nhelp: give a planar face, wire or sketch; `plane` names the plane, and Part.from_solid cuts a solid"
        )
    return [[curve.edge(frame, join) for curve in wire] for wire in groups]


def wires(given: Any, plane: Any, join: float) -> list[list[_wires.Edge]]:
    """The wires of planar faces, wires and sketches, in their plane."""
    groups: list[list[Curve]] = []
    for shape in shapes(given):
        if parts_of(shape, "Solids"):
            raise Error(f"the {type(shape).__name__} is a solid\nhelp: Part.from_solid makes a part of a section or of layers")
        faces = parts_of(shape, "Faces")
        for i, face in enumerate(faces):
            kind = surface(face).kind
            if kind not in _PLANE:
                raise Error(f"face {i} is no plane but a {kind}\nhelp: give planar faces, or Part.from_solid a solid")
        for wire in [wire for face in faces or [shape] for wire in _wires_of(face)]:
            groups.append([curve(edge) for edge in parts_of(wire, "Edges") or [wire]])
    if not groups:
        raise Error(f"the {type(given).__name__} has no wires")
    frame = Frame.given(plane) if plane is not None else frame_of([c for wire in groups for c in wire], join)
    return wires_in(groups, frame, join, "the shape")
