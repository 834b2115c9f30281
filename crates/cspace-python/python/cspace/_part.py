"""Parts."""

import json
import math
import os

from . import _rust
from ._errors import Error


def _plain(value):
    """A value as JSON has it: arrays as lists."""
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value


def _read(name, unit=None, **keys):
    """The part of a model that has these keys."""
    keys = {key: _plain(value) for key, value in keys.items() if value is not None}
    model = {"part": [{"name": name, **keys}]}
    if unit is not None:
        model["unit"] = unit
    try:
        text = json.dumps(model, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise Error(f"the part {name!r} has something that is no finite number: {error}") from None
    return _rust.Part._from_json(text)


def _outline(loop):
    """A loop as the data of an SVG path, whose y points down."""
    data = [f"M{loop[0][0]:.9g} {-loop[0][1]:.9g}"]
    for (x, y, bulge), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
        if bulge == 0:
            data.append(f"L{x1:.9g} {-y1:.9g}")
        else:
            radius = math.hypot(x1 - x, y1 - y) * (1 + bulge * bulge) / (4 * abs(bulge))
            large, downward = int(abs(bulge) > 1), int(bulge < 0)
            data.append(f"A{radius:.9g} {radius:.9g} 0 {large} {downward} {x1:.9g} {-y1:.9g}")
    return "".join(data) + "Z"


class Part:
    """A rigid part: closed loops of line segments and circular arcs.

    `loops` are lists of vertices (x, y) or (x, y, bulge), n×2 or n×3 arrays, or entries as in a model file: `{"arc_to": [4, 0], "radius": 3}`,
    `{"fillet": 1}`; a circle is a loop, `{"circle": 2, "at": [0, 0]}`. The bulge of an edge is tan of a quarter of the angle by which it turns, positive to
    the left, 0 of a line. Holes are loops within others, in any direction.

    >>> plate = Part([[(0, 0), (40, 0), (40, 20), (0, 20)], {"circle": 3, "at": [10, 10]}], name="plate")
    >>> round(plate.area, 3)
    771.726
    """

    __slots__ = ("_part",)

    def __init__(self, loops, name="part"):
        loops = _plain(loops)
        if not isinstance(loops, list):
            raise Error("`loops` is no list of loops")
        if loops and isinstance(loops[0], list) and loops[0] and isinstance(loops[0][0], (int, float)):
            raise Error("`loops` is one loop: give a list of loops, Part([loop])")
        self._part = _read(name, loops=loops)

    @classmethod
    def _of(cls, part):
        self = cls.__new__(cls)
        self._part = part
        return self

    @classmethod
    def circle(cls, radius, center=(0.0, 0.0), name="circle"):
        """A disc."""
        return cls([{"circle": radius, "at": list(center)}], name=name)

    @classmethod
    def rectangle(cls, width, height, center=(0.0, 0.0), name="rectangle"):
        """A rectangle with sides along the axes."""
        try:
            x, y, a, b = *center, width / 2, height / 2
        except TypeError:
            raise Error("the width, the height or the center is no number") from None
        return cls([[(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)]], name=name)

    @classmethod
    def from_points(cls, points, name="part"):
        """A polygon: one loop of points, n×2."""
        points = _plain(points)
        if any(len(point) != 2 for point in points):
            raise Error("`points` are not n×2: with bulges, give Part([loop])")
        return cls([points], name=name)

    @classmethod
    def from_shapely(cls, polygon, name="part"):
        """A shapely Polygon or MultiPolygon, as it is: with straight sides."""
        polygons = getattr(polygon, "geoms", [polygon])
        if not all(hasattr(p, "exterior") for p in polygons):
            raise Error(f"`polygon` is {polygon!r}: give a Polygon or a MultiPolygon")
        rings = [ring for p in polygons for ring in (p.exterior, *p.interiors)]
        return cls([[point[:2] for point in list(ring.coords)[:-1]] for ring in rings], name=name)

    @classmethod
    def from_dxf(cls, path, name="part", unit=None, layer=None, hatches=None, pick=None, scale=None):
        """The outlines of a DXF drawing: of a `layer` or a list of them, with those of `hatches`, or the faces around the points `pick`.

        They are converted to `unit` where the drawing says its own, and multiplied by `scale`.
        """
        path = os.path.abspath(path)
        return cls._of(_read(name, unit, dxf=path, layer=layer, hatches=hatches, pick=pick, scale=scale))

    @classmethod
    def from_svg(cls, path, name="part", unit=None, id=None, pick=None, scale=None):
        """The outlines of an SVG drawing, or of its element `id`, or the faces around the points `pick`."""
        return cls._of(_read(name, unit, svg=os.path.abspath(path), id=id, pick=pick, scale=scale))

    def offset(self, distance):
        """The part with its outline moved outward by a distance, or inward by a negative one: exactly, corners rounded by arcs."""
        return Part._of(_read(self.name, loops=self.loops, offset=distance))

    @property
    def name(self):
        """The name."""
        return self._part.name

    @property
    def loops(self):
        """The loops as lists of (x, y, bulge): outer ones counter-clockwise, holes clockwise."""
        return self._part.loops

    @property
    def area(self):
        """The area."""
        return self._part.area

    @property
    def bounds(self):
        """The smallest x and y and the largest: (x, y, x, y)."""
        return self._part.bounds

    def contains(self, x, y):
        """Whether a point is in the part or on its outline."""
        return self._part.contains(x, y)

    def points(self, tolerance):
        """The loops in points that are on them, with chords no farther than `tolerance` from their arcs."""
        return self._part._points(tolerance)

    def to_shapely(self, tolerance):
        """A shapely geometry, whose sides are no farther than `tolerance` from the arcs."""
        from shapely.geometry import Polygon

        result = None
        # Loops within each other are holes: what is in an even number of them is outside.
        for loop in sorted((Polygon(points) for points in self.points(tolerance)), key=lambda p: -p.area):
            result = loop if result is None else result.symmetric_difference(loop)
        return result

    def _repr_svg_(self):
        x0, y0, x1, y1 = self.bounds
        width, height = x1 - x0, y1 - y0
        margin = 0.05 * max(width, height)
        path = "".join(_outline(loop) for loop in self.loops)
        box = f"{x0 - margin:.6g} {-y1 - margin:.6g} {width + 2 * margin:.6g} {height + 2 * margin:.6g}"
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="300">'
            f'<path d="{path}" fill="#cdd9e5" stroke="#24466b" fill-rule="evenodd" '
            f'stroke-width="{0.1 * margin:.3g}"/></svg>'
        )

    def __repr__(self):
        return repr(self._part)

    def __eq__(self, other):
        return isinstance(other, Part) and (self.name, self.loops) == (other.name, other.loops)

    def __hash__(self):
        return hash((self.name, tuple(map(tuple, self.loops))))

    def __reduce__(self):
        return Part, (self.loops, self.name)
