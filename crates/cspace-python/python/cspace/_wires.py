"""Closed wires of edges, as programs of CAD have them: put in order, and made to loops of lines and arcs.

Points are complex numbers, x + iy.
"""

import cmath
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from . import _rust
from ._arrays import number
from ._errors import Error

# OCCT draws a vertex as a ball with a radius of 1e-7 (Precision::Confusion), in which its edges end: two ends at one vertex are at most
# twice that apart. In the unit of the drawing.
JOIN = 2e-7

# Points of a curve that is known by its points alone: at first, and at most.
_FIRST, _LAST = 32, 8192

# The distance of an arc from a curve between its ends is a cubic's, which between 24 places, at which the module measures arcs on average,
# is 0.8 % larger than at one of them, and between 15 places 2 %. So much is added to what is measured.
_BETWEEN = 1.02

# Places at which a curve is measured between two of its points: more than 24 on an arc, of which there are not more than points.
_PLACES = 32

# A piece as the module reads it.
_Piece = dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Edge:
    """An edge of a wire, and the pieces that it is from its start to its end, and from its end to its start.

    Where a curve is known by its points alone, they are `at` shares of it from 0 to 1, and there are no pieces.
    """

    start: complex
    end: complex
    forth: Sequence[_Piece]
    back: Sequence[_Piece]
    at: Callable[[float], complex] | None = None

    def reversed(self) -> "Edge":
        """The edge from its end to its start."""
        at = self.at
        return Edge(self.end, self.start, self.back, self.forth, (lambda share: at(1 - share)) if at else None)

    def pieces(self, count: int) -> Sequence[_Piece]:
        """Its pieces; a curve that is known by its points is the spline through its ends and so many between, with as many pieces."""
        if self.at is None:
            return self.forth
        # The spline has no curvature at its ends. The points are closer there, so that this is felt no farther than elsewhere.
        shares = [(1 - math.cos(math.pi * k / count)) / 2 for k in range(1, count)]
        return through(self.start, self.end, [self.at(share) for share in shares]).forth


def _xy(point: complex) -> tuple[float, float]:
    return point.real, point.imag


def line(start: complex, end: complex) -> Edge:
    """A line."""
    return Edge(start, end, [{"line": {"to": _xy(end)}}], [{"line": {"to": _xy(start)}}])


def arc(start: complex, end: complex, bulge: float) -> Edge:
    """An arc; `bulge` is tan of a quarter of the angle by which it turns."""
    to = [{"arc": {"to": _xy(p), "bulge": b}} for p, b in ((end, bulge), (start, -bulge))]
    return Edge(start, end, to[:1], to[1:])


def circle(start: complex, opposite: complex) -> Edge:
    """The circle of two opposite points."""
    halves = [{"arc": {"to": _xy(p), "bulge": 1.0}} for p in (opposite, start)]
    return Edge(start, start, halves, halves)


def ellipse(center: complex, u: complex, v: complex, first: float, last: float) -> Edge:
    """The points center + cos t · u + sin t · v."""
    start, end = (center + math.cos(t) * u + math.sin(t) * v for t in (first, last))
    shape = {"center": _xy(center), "u": _xy(u), "v": _xy(v)}
    both = [{"ellipse": {**shape, "from": t, "to": s}} for t, s in ((first, last), (last, first))]
    return Edge(start, end, both[:1], both[1:])


def spline(
    start: complex, end: complex, degree: int, knots: list[float], poles: Sequence[complex], weights: list[float]
) -> Edge:
    """A B-spline between its first and its last inner knot, where it is at `start` and `end`."""
    shape = {"degree": degree, "knots": knots, "poles": list(map(_xy, poles)), "weights": weights}
    both = [{"spline": {**shape, "backward": backward}} for backward in (False, True)]
    return Edge(start, end, both[:1], both[1:])


def through(start: complex, end: complex, inner: list[complex]) -> Edge:
    """The cubic spline through points."""
    points, closed = list(map(_xy, [start, *inner, end])), start == end
    both = [{"through": {"points": p, "closed": closed}} for p in (points, points[::-1])]
    return Edge(start, end, both[:1], both[1:])


def read(given: Any, of: str, join: float) -> Edge:
    """The edge (start, end), (start, end, middle) or (start, end, points), which is called `of`."""
    try:
        start, end, *rest = given
        if len(rest) > 1:
            raise ValueError(f"it has {len(rest) + 2} entries")
        first, last = _point(start), _point(end)
        if not rest or rest[0] is None:
            return line(first, last)
        inner = list(rest[0])
        if inner and hasattr(inner[0], "__len__"):
            return through(first, last, [p for p in map(_point, inner) if p not in (first, last)])
        middle = _point(inner)
        if abs(last - first) <= join:
            return circle(first, middle)
        if middle in (first, last):
            raise ValueError("its middle point is at an end")
        # An angle on a circle is half of that at its centre.
        return arc(first, last, math.tan(cmath.phase((last - middle) / (middle - first)) / 2))
    except (TypeError, ValueError) as error:
        raise Error(
            f"{of} is no edge: {error}\nhelp: points are (x, y); give (start, end) of a line, (start, end, middle) of an arc, "
            "(start, end, [points]) of another curve"
        ) from None


def _point(given: Any) -> complex:
    x, y = given
    point = complex(float(x), float(y))
    if not cmath.isfinite(point):
        raise ValueError(f"the point ({x}, {y}) is not finite")
    return point


def made(wires: Iterable[Sequence[Edge]], tol: float, join: float, name: str) -> tuple[_rust.Part, float]:
    """The part of wires, and how far its lines and arcs are from the curves that they are fitted to."""
    tol, join = number("tol", tol, 0.0), number("join", join, 0.0)
    if not tol:
        raise Error("`tol` is 0: give the length by which lines and arcs may be off other curves")
    chains = [_ordered(wire, f"wire {i}", join) for i, wire in enumerate(wires)]
    if not chains:
        raise Error("there are no wires to make a part of")
    asked = [edge for wire in chains for edge in wire if edge.at]
    # Half is for the spline through points, where there is one. A fit may be off by more between its samples: then less is asked of it.
    share, count = 0.5 if asked else 1.0, _FIRST
    while True:
        told = [_told(wire, f"wire {i}", count) for i, wire in enumerate(chains)]
        places = count * _PLACES
        between = [_xy(edge.at((k + 0.5) / places)) for edge in asked if edge.at for k in range(places)]
        part, off = _rust._of_wires(told, between, join, share * tol, name)
        fitted = _BETWEEN * off
        if fitted <= tol:
            return part, fitted
        if count >= _LAST:
            raise Error(f"lines and arcs stay {fitted:.3g} off a curve, more than `tol`, {tol:g}: give a larger one")
        share, count = 0.9 * share, 2 * count


def _told(wire: Sequence[Edge], name: str, count: int) -> dict[str, Any]:
    """A wire as the module reads it: where its last edge is a line or an arc, it ends where it starts, and not just near."""
    edges, start = [piece for edge in wire for piece in edge.pieces(count)], _xy(wire[0].start)
    edges[-1] = {kind: {**shape, "to": start} if kind in ("line", "arc") else shape for kind, shape in edges[-1].items()}
    return {"name": name, "start": start, "edges": edges}


def _ordered(edges: Sequence[Edge], of: str, join: float) -> list[Edge]:
    """The edges end to end, in the direction of the first, which must come back to its start."""
    if not edges:
        raise Error(f"{of} has no edges")
    chain, left, last = [edges[0]], dict(enumerate(edges[1:], 1)), 0
    while left:
        here = chain[-1].end
        # In most wires the next in the list goes on.
        nearest = last + 1
        if nearest not in left or _reach(left[nearest], here) > join:
            nearest = min(left, key=lambda i: _reach(left[i], here))
        _join(_reach(left[nearest], here), here, f"edge {last} of {of}", f"edge {nearest}", join)
        edge = left.pop(nearest)
        chain.append(edge if abs(edge.start - here) <= abs(edge.end - here) else edge.reversed())
        last = nearest
    _join(abs(chain[-1].end - chain[0].start), chain[-1].end, f"edge {last} of {of}", "edge 0", join)
    return chain


def _reach(edge: Edge, here: complex) -> float:
    return min(abs(edge.start - here), abs(edge.end - here))


def _join(gap: float, at: complex, of: str, other: str, join: float) -> None:
    if not gap <= join:
        raise Error(
            f"{of} ends at ({at.real:.9g}, {at.imag:.9g}), {gap:.6g} from the nearest end that is left, of {other}: more than "
            f"`join`, {join:g}"
            "\nhelp: close the wire, or give a larger `join` if both ends are one"
        )
