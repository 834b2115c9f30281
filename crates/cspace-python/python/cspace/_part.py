"""Parts."""

import json
import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from . import _back, _cad, _rust, _wires
from ._arrays import number, position
from ._errors import Error
from ._features import Feature
from ._loops import Loops, outline
from ._optional import optional
from ._record import plain
from ._solid import Solid

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def _read(name: str, unit: str | None = None, **keys: Any) -> _rust.Part:
    """The part of a model that has these keys."""
    keys = {key: plain(value) for key, value in keys.items() if value is not None}
    model: dict[str, Any] = {"part": [{"name": name, **keys}]}
    if unit is not None:
        model["unit"] = unit
    try:
        text = json.dumps(model, allow_nan=False)
    except ValueError:
        raise Error(f"the part {name!r} has a number that is not finite") from None
    except TypeError as error:
        raise Error(f"the part {name!r} has something that is no number: {error}") from None
    return _rust.Part._from_json(text)


def _distance(distance: Any) -> float:
    """A distance by which an outline moves."""
    # Squares of larger ones are no numbers.
    most = 1e150
    found = number("distance", distance)
    if abs(found) > most:
        raise Error(f"`distance` is {distance!r}, which is too large")
    return found


class Part:
    """A rigid part: closed loops of line segments and circular arcs.

    `loops` are lists of vertices (x, y) or (x, y, bulge), n×2 or n×3 arrays, or entries as in a model file: `{"arc_to": [4, 0], "radius": 3}`,
    `{"fillet": 1}`; a circle is a loop, `{"circle": 2, "at": [0, 0]}`. The bulge of an edge is tan of a quarter of the angle by which it turns, positive to
    the left, 0 of a line. Holes are loops within others, in any direction. `z` are the lowest and the highest place of the part, which is at every
    height without it; `Part.stack` makes one part of several at different heights.

    >>> plate = cs.Part([[(0, 0), (40, 0), (40, 20), (0, 20)], {"circle": 3, "at": [10, 10]}], name="plate")
    >>> round(plate.area, 3)
    771.726
    """

    __slots__ = ("_fitted", "_part")
    _fitted: float

    def __init__(self, loops: Any, name: str = "part", z: Sequence[float] | None = None) -> None:
        loops = plain(loops)
        if not isinstance(loops, list):
            raise Error("`loops` is no list of loops")
        if loops and isinstance(loops[0], list) and loops[0] and isinstance(loops[0][0], (int, float)):
            raise Error("`loops` is one loop: give a list of loops, Part([loop])")
        self._part = _read(name, loops=loops, z=z)

    @classmethod
    def _of(cls, part: _rust.Part) -> "Part":
        self = cls.__new__(cls)
        self._part = part
        return self

    @classmethod
    def stack(cls, parts: Sequence["Part"], name: str = "stack") -> "Part":
        """One part that is made of others as its layers.

        >>> wheel = cs.Part([{"circle": 9, "at": [0, 0]}], z=(0, 4))
        >>> pinion = cs.Part([{"circle": 2, "at": [0, 0]}], z=(4, 10))
        >>> [z for z, _ in cs.Part.stack([wheel, pinion], name="arbor").layers]
        [(0.0, 4.0), (4.0, 10.0)]
        """
        return cls._of(_read(name, layers=[layer for part in parts for layer in part._stack()]))

    @classmethod
    def circle(cls, radius: float, center: Sequence[float] = (0.0, 0.0), name: str = "circle") -> "Part":
        """A disc.

        >>> cs.Part.circle(2, center=(1, 0)).bounds
        (-1.0, -2.0, 3.0, 2.0)
        """
        return cls([{"circle": number("radius", radius), "at": position("center", center)}], name=name)

    @classmethod
    def rectangle(
        cls, width: float, height: float, center: Sequence[float] = (0.0, 0.0), name: str = "rectangle"
    ) -> "Part":
        """A rectangle with sides along the axes.

        >>> cs.Part.rectangle(4, 2).area
        8.0
        """
        for side, length in (("width", width), ("height", height)):
            if not number(side, length) > 0:
                raise Error(f"`{side}` is {length!r} where a length of more than 0 is expected")
        (x, y), a, b = position("center", center), float(width) / 2, float(height) / 2
        return cls([[(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)]], name=name)

    @classmethod
    def from_points(cls, points: ArrayLike, name: str = "part") -> "Part":
        """A polygon: one loop of points, n×2; the first may be repeated at the end.

        >>> cs.Part.from_points([(0, 0), (4, 0), (0, 3), (0, 0)]).area
        6.0
        """
        given = plain(points)
        if not isinstance(given, list) or any(not isinstance(point, list) or len(point) != 2 for point in given):
            raise Error("`points` are not n×2: with bulges, give Part([loop])")
        if len(given) > 1 and given[0] == given[-1]:
            given = given[:-1]
        return cls([given], name=name)

    @classmethod
    def from_shapely(cls, polygon: Any, name: str = "part") -> "Part":
        """A shapely Polygon or MultiPolygon, as it is: with straight sides.

        >>> cs.Part.from_shapely(cs.Part.rectangle(4, 2).to_shapely(0.01)).area
        8.0
        """
        polygons = getattr(polygon, "geoms", [polygon])
        if not all(hasattr(p, "exterior") for p in polygons):
            raise Error(f"`polygon` is {polygon!r}: give a Polygon or a MultiPolygon")
        rings = [ring for p in polygons for ring in (p.exterior, *p.interiors)]
        return cls([[point[:2] for point in list(ring.coords)[:-1]] for ring in rings], name=name)

    @classmethod
    def from_dxf(
        cls,
        path: str | os.PathLike[str],
        name: str = "part",
        unit: str | None = None,
        layer: str | Sequence[str] | None = None,
        hatches: Any = None,
        pick: Any = None,
        scale: float | None = None,
    ) -> "Part":
        """The outlines of a DXF drawing: of a `layer` or a list of them, with those of `hatches`, or the faces around the points `pick`.

        They are converted to `unit` where the drawing says its own, and multiplied by `scale`.

        >>> cs.Part.from_dxf("plate.dxf", name="plate").name
        'plate'
        """
        path = os.path.abspath(path)
        return cls._of(_read(name, unit, dxf=path, layer=layer, hatches=hatches, pick=pick, scale=scale))

    @classmethod
    def from_svg(
        cls,
        path: str | os.PathLike[str],
        name: str = "part",
        unit: str | None = None,
        id: str | None = None,
        pick: Any = None,
        scale: float | None = None,
    ) -> "Part":
        """The outlines of an SVG drawing, or of its element `id`, or the faces around the points `pick`.

        >>> cs.Part.from_svg("plate.svg", id="outline", scale=1).bounds
        (1.0, -5.0, 5.0, -1.0)
        """
        return cls._of(_read(name, unit, svg=os.path.abspath(path), id=id, pick=pick, scale=scale))

    def offset(self, distance: float) -> "Part":
        """The part with its outline moved outward by a distance, or inward by a negative one: exactly, corners rounded by arcs.

        >>> cs.Part.rectangle(4, 2).offset(1).bounds
        (-3.0, -2.0, 3.0, 2.0)
        """
        return Part._of(_read(self.name, layers=self._stack(), offset=_distance(distance)))

    def moved(self, x: float, y: float, theta: float = 0.0) -> "Part":
        """The part turned about its origin by `theta`, radians, and then moved by x and y: as it is in the configuration (x, y, theta).

        >>> cs.Part.rectangle(4, 2).moved(10, 0, np.pi / 2).bounds
        (9.0, -2.0, 11.0, 2.0)
        """
        return self._redrawn(Loops(self.loops).moved(x, y, theta).tolist())

    def mirrored(self, direction: Sequence[float], origin: Sequence[float] = (0.0, 0.0)) -> "Part":
        """The mirror image of the part in the line through `origin` along `direction`: in the x axis (1, 0), in the y axis (0, 1).

        >>> cs.Part.rectangle(4, 2, center=(5, 0)).mirrored((0, 1)).bounds
        (-7.0, -1.0, -3.0, 1.0)
        """
        along, through = complex(*position("direction", direction)), complex(*position("origin", origin))
        if along == 0:
            raise Error("`direction` is (0, 0), which is no direction")
        # The square of the unit direction, without a root, so that the diagonals are as exact as the axes.
        unit = along / max(abs(along.real), abs(along.imag))
        turn = unit * unit / (unit.real**2 + unit.imag**2)
        images = [[(through + turn * (complex(x, y) - through).conjugate(), -bulge) for x, y, bulge in loop] for loop in self.loops]
        return self._redrawn([[(image.real, image.imag, bulge) for image, bulge in loop] for loop in images])

    def scaled(self, factor: float, origin: Sequence[float] = (0.0, 0.0)) -> "Part":
        """The part as many times as large, seen from `origin`, which stays; its heights stay, too.

        >>> cs.Part.circle(2).scaled(1.5).bounds
        (-3.0, -3.0, 3.0, 3.0)
        """
        (u, v), factor = position("origin", origin), number("factor", factor)
        if not factor > 0:
            raise Error(f"`factor` is {factor!r} where a number of more than 0 is expected: `mirrored` makes the mirror image")
        return self._redrawn([[(u + factor * (x - u), v + factor * (y - v), b) for x, y, b in loop] for loop in self.loops])

    def _redrawn(self, loops: list[list[tuple[float, float, float]]]) -> "Part":
        return Part._of(self._part._redrawn(loops))

    def feature(self, name: str) -> Feature:
        """A line, an arc or a vertex by the name that answers call it by: with its kind and its place in the drawing.

        >>> cs.Part.circle(2).feature("convex arc 1 of loop 0").number
        1
        """
        return Feature(*self._part._feature(name))

    def _stack(self) -> list[dict[str, Any]]:
        """The layers as in a model file."""
        return [{"loops": loops} if z is None else {"z": z, "loops": loops} for z, loops in self.layers]

    @property
    def name(self) -> str:
        """The name.

        >>> cs.Part.circle(2, name="coin").name
        'coin'
        """
        return self._part.name

    @property
    def loops(self) -> list[list[tuple[float, float, float]]]:
        """The loops as lists of (x, y, bulge), in the directions in which they were given.

        >>> cs.Part.circle(2).loops
        [[(-2.0, 0.0, 1.0), (2.0, 0.0, 1.0)]]
        """
        return self._part.loops

    @property
    def layers(self) -> list[tuple[tuple[float, float] | None, list[list[tuple[float, float, float]]]]]:
        """The layers: for each its heights (lowest, highest), or None at every height, and its loops.

        >>> cs.Part.circle(2).layers[0][0] is None
        True
        """
        return [(None if z is None else (z[0], z[1]), loops) for z, loops in self._part.layers]

    @property
    def outline(self) -> Loops:
        """The loops with the material of their layer on the left: outer ones counter-clockwise, holes clockwise.

        >>> cs.Part.rectangle(4, 2).outline
        Loops(1 loop, 4 vertices)
        """
        return Loops([loop for _, loops in self.layers for loop in outline(Loops(loops))])

    @property
    def area(self) -> float:
        """The area.

        >>> cs.Part.rectangle(4, 2).area
        8.0
        """
        return self._part.area

    @property
    def centroid(self) -> tuple[float, float]:
        """The centroid (x, y) of the area.

        >>> cs.Part.rectangle(4, 2, center=(5, 0)).centroid
        (5.0, 0.0)
        """
        return self._part.centroid

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest x and y and the largest: (x, y, x, y).

        >>> cs.Part.rectangle(4, 2).bounds
        (-2.0, -1.0, 2.0, 1.0)
        """
        return self._part.bounds

    def contains(self, x: float, y: float) -> bool:
        """Whether a point is in the part or on its outline.

        >>> cs.Part.circle(2).contains(2, 0)
        True
        """
        return self._part.contains(x, y)

    def points(self, tolerance: float) -> list[list[tuple[float, float]]]:
        """The loops in points that are on them, with chords no farther than `tolerance` from their arcs.

        >>> len(cs.Part.circle(2).points(0.01)[0])
        32
        """
        return self._part._points(tolerance)

    def to_shapely(self, tolerance: float) -> Any:
        """A shapely geometry, whose sides are no farther than `tolerance` from the arcs.

        >>> round(cs.Part.circle(2).to_shapely(1e-6).area, 3)
        12.566
        """
        polygon = optional("shapely.geometry").Polygon
        points, whole = iter(self.points(tolerance)), None
        for _, loops in self.layers:
            layer = None
            # Loops within each other are holes: what is in an even number of them is outside.
            for loop in sorted((polygon(next(points)) for _ in loops), key=lambda p: -p.area):
                layer = loop if layer is None else layer.symmetric_difference(loop)
            whole = layer if whole is None else whole.union(layer)
        return whole

    def plot(self, ax: "Axes | None" = None, **style: Any) -> "Axes":
        """Draws the part with matplotlib, arcs as arcs, on axes `ax` or on the current ones, which are returned.

        `style` is that of a patch of matplotlib, such as facecolor, edgecolor or alpha.

        >>> ax = cs.Part.circle(2).plot(facecolor="gold")
        """
        return self.outline.plot(ax, **style)

    def _repr_svg_(self) -> str:
        return self.outline._repr_svg_()

    def __repr__(self) -> str:
        told = repr(self._part)
        return f"{told[:-1]}; within {self.fitted:.2g} of its curves)" if self.fitted else told

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Part) and self._part._sent() == other._part._sent()

    def __hash__(self) -> int:
        return hash(self._part._sent())

    def __reduce__(self) -> Any:
        return _received, (self._part._sent(),)

    # From and to programs of CAD.

    @classmethod
    def from_edges(cls, wires: Any, tol: float = 1e-3, name: str = "part", join: float = _wires.JOIN) -> "Part":
        """The part that closed wires bound, each a list of edges in any order and direction.

        An edge is (start, end) of a line, (start, end, middle) of an arc through a point between, (start, end, [points]) of the cubic
        spline through points; points are (x, y). An arc whose ends are one is the circle with `middle` opposite. Splines become lines
        and arcs within `tol`, tangent to each other; `Part.fitted` is how far they are. Ends are one within `join`: by default twice
        OCCT's size of a vertex, 1e-7. Lengths are in the drawing's unit.

        >>> slot = [((0, 0), (9, 0)), ((9, 4), (9, 0), (11, 2)), ((0, 4), (9, 4)), ((0, 4), (0, 0), (-2, 2))]
        >>> round(Part.from_edges([slot]).area, 6)
        48.566371
        """
        try:
            plain = [list(wire) for wire in wires]
        except TypeError:
            raise Error(f"`wires` is {wires!r}: give a list of wires, each a list of edges") from None
        edges = [[_wires.read(e, f"edge {k} of wire {i}", join) for k, e in enumerate(w)] for i, w in enumerate(plain)]
        return cls._fit(edges, tol, join, name)

    @classmethod
    def from_cad(
        cls, shape: Any, tol: float = 1e-3, name: str = "part", plane: Any = None, join: float = _wires.JOIN
    ) -> "Part":
        """The part of a planar face, wire or sketch, or of several in one plane, of build123d, CadQuery or FreeCAD.

        Lines and circles are taken exactly, other curves become lines and arcs within `tol`. A shape is seen from above, if its plane is
        upright from the front, and if it faces sideways from the right. Its x axis is the world's, as far as that is in its plane (its y
        axis where the plane faces right more than anything); its origin is the world's, moved along the normal. `plane` gives another
        frame: a Plane, or (origin, x direction, normal), each (x, y, z). `join` is as of `from_edges`.

        >>> Part.from_cad(build123d.SlotOverall(40, 10), name="slot")  # doctest: +SKIP
        """
        return cls._fit(_cad.wires(shape, plane, join), tol, join, name)

    @classmethod
    def from_solid(
        cls,
        solid: Any,
        z: float | None = None,
        tol: float = 1e-3,
        name: str = "part",
        plane: Any = None,
        join: float = _wires.JOIN,
    ) -> "Part":
        """The part that is the section of a solid at the height `z`; without `z` its layers between horizontal faces, each at its heights.

        A solid has layers if all its faces are horizontal or upright: planes, cylinders and extrusions. Heights are measured along
        the world's z, or along the normal of `plane` from its origin. `tol`, `plane` and `join` are as of `from_cad`.

        >>> Part.from_solid(build123d.Box(10, 20, 4), name="block").layers  # doctest: +SKIP
        """
        cut = Solid(solid, plane, join)
        return cls._layered(cut, tol, name) if z is None else cls._fit(cut.at(number("z", z)), tol, join, name)

    @classmethod
    def _layered(cls, cut: Solid, tol: float, name: str) -> "Part":
        parts = [(z, cls._fit(wires, tol, cut.join, name)) for z, wires in cut.layers()]
        self = cls._of(_read(name, layers=[{"z": z, "loops": part.loops} for z, part in parts]))
        self._fitted = max(part.fitted or 0.0 for _, part in parts)
        return self

    @classmethod
    def _fit(cls, wires: Any, tol: float, join: float, name: str) -> "Part":
        part, fitted = _wires.made(wires, tol, join, name)
        self = cls._of(part)
        self._fitted = fitted
        return self

    @property
    def fitted(self) -> float | None:
        """Of a part made of edges or CAD, how far its lines and arcs are from the curves, measured at many of their points: 0.0 where all
        are lines and circles. None of other parts, and of those made of it.

        >>> Part.from_edges([[((0, 0), (4, 0)), ((4, 0), (0, 3)), ((0, 3), (0, 0))]]).fitted
        0.0
        """
        return getattr(self, "_fitted", None)

    def to_build123d(self) -> Any:
        """The part in build123d, with true arcs: a Sketch at z = 0, or of a part with heights the Part that its layers are.

        >>> Part.rectangle(4, 2).to_build123d().area  # doctest: +SKIP
        8.0
        """
        return _back.build123d(self)

    def to_cadquery(self) -> Any:
        """The part in CadQuery, with true arcs: a Workplane with its faces at z = 0, or with the solid that the layers of a part with
        heights are.

        >>> Part.rectangle(4, 2).to_cadquery().val().Area()  # doctest: +SKIP
        8.0
        """
        return _back.cadquery(self)


def _received(sent: str) -> Part:
    return Part._of(_rust.Part._received(sent))
