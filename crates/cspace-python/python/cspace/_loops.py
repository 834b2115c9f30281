"""Loops: outlines, and the boundary of free space at an orientation."""

import cmath
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from . import _arcs, _draw
from ._arrays import angle, number
from ._errors import Error

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Loops(Sequence[list[tuple[float, float, float]]]):
    """A sequence of closed loops, each a list of vertices (x, y, bulge).

    The bulge of the edge to the next vertex is tan of a quarter of the angle by which it turns, positive to the left, 0 of a line. What
    is blocked, or material, is on the left. A loop of one vertex is a point, and a loop of two with bulge 0 a slit, which is travelled
    there and back.

    >>> cs.Loops([[(-1, 0, 1), (1, 0, 1)], [(5, 5, 0)]])
    Loops(2 loops, 3 vertices)
    """

    #: Whether curves may be missing, or not there: of a slice or a no-fit region.
    doubtful: bool = False

    #: Whether what is outside of all loops is blocked: of an inner-fit region.
    outside_blocked: bool = False

    def __init__(self, loops: Any = ()) -> None:
        self._loops = [_vertices(i, loop) for i, loop in enumerate(loops)]

    def __len__(self) -> int:
        return len(self._loops)

    def __getitem__(self, index: Any) -> Any:
        if not isinstance(index, slice):
            return self._loops[index]
        some = Loops(self._loops[index])
        some.doubtful, some.outside_blocked = self.doubtful, self.outside_blocked
        return some

    def __eq__(self, other: object) -> bool:
        return self._loops == (other._loops if isinstance(other, Loops) else other)

    __hash__ = None  # type: ignore[assignment]

    def tolist(self) -> list[list[tuple[float, float, float]]]:
        """The loops as a list of lists of vertices.

        >>> cs.Loops([[(0, 0, 0)]]).tolist()
        [[(0.0, 0.0, 0.0)]]
        """
        return [list(loop) for loop in self._loops]

    def _edges(self) -> Iterator[tuple[complex, complex, float]]:
        for loop in self:
            yield from _edges(loop)

    def winding(self, x: float, y: float) -> int:
        """How often the loops go around a point that is on none of them, counter-clockwise.

        >>> cs.Part.circle(2).outline.winding(1, 1)
        1
        """
        eye = complex(x, y)
        return round(math.fsum(_arcs.seen(*edge, eye) for edge in self._edges()) / (2 * math.pi))

    def distance(self, x: float, y: float) -> float:
        """The distance of a point from the nearest edge; infinite without loops.

        >>> cs.Part.circle(2).outline.distance(5, 0)
        3.0
        """
        eye = complex(number("x", x), number("y", y))
        return min((_arcs.distance(*edge, eye) for edge in self._edges()), default=math.inf)

    def blocks(self, x: float, y: float, tolerance: float = 0.0) -> bool:
        """Whether a position is on the blocked side, farther than `tolerance` from the boundary.

        >>> cs.nfp(cs.Part.circle(2), cs.Part.circle(1)).blocks(2.9, 0)
        True
        """
        if self.distance(x, y) <= number("tolerance", tolerance, 0.0):
            return False
        around = self.winding(x, y)
        return around >= 0 if self.outside_blocked else around > 0

    @property
    def area(self) -> float:
        """The area on the left, exactly: loops that run clockwise count negative.

        >>> round(cs.Part.circle(2).outline.area, 6)
        12.566371
        """
        terms = []
        for loop in self:
            # As seen from a vertex, so that loops far from the origin lose nothing.
            origin = complex(*loop[0][:2])
            for start, end, bulge in _edges(loop):
                terms.append(((start - origin).conjugate() * (end - origin)).imag / 2)
                terms.append(_arcs.area_beside(start, end, bulge))
        return math.fsum(terms)

    @property
    def length(self) -> float:
        """The length of all edges, along the arcs; of a slit twice its length.

        >>> cs.Part.rectangle(4, 2).outline.length
        12.0
        """
        return math.fsum(_arcs.length(*edge) for edge in self._edges())

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """The smallest x and y and the largest, of the arcs too: (x, y, x, y).

        >>> cs.Part.rectangle(4, 2).outline.bounds
        (-2.0, -1.0, 2.0, 1.0)
        """
        points = [point for edge in self._edges() for point in (edge[0], *_arcs.axis_points(*edge))]
        if not points:
            raise Error("there are no loops, which have bounds")
        x, y = [p.real for p in points], [p.imag for p in points]
        return min(x), min(y), max(x), max(y)

    def points(self, tolerance: float) -> list[list[tuple[float, float]]]:
        """The loops in points that are on them, with chords no farther than `tolerance` from their arcs.

        >>> [len(loop) for loop in cs.Part.circle(2).outline.points(0.01)]
        [32]
        """
        if not 0 < number("tolerance", tolerance) < math.inf:
            raise Error(f"`tolerance` is {tolerance!r}: give a positive length")
        return [
            [(p.real, p.imag) for edge in _edges(loop) for p in _arcs.chords(*edge, tolerance)] for loop in self
        ]

    def moved(self, x: float, y: float, theta: float = 0.0) -> "Loops":
        """The loops turned about the origin by `theta`, and then moved by x and y: those of a part in a configuration.

        >>> cs.Part.rectangle(4, 2).outline.moved(1, 0).bounds
        (-1.0, -1.0, 3.0, 1.0)
        """
        turned, by = cmath.rect(1, angle("theta", theta)), complex(number("x", x), number("y", y))
        places = [[(by + turned * complex(*v[:2]), v[2]) for v in loop] for loop in self]
        moved = Loops([(p.real, p.imag, bulge) for p, bulge in loop] for loop in places)
        moved.doubtful, moved.outside_blocked = self.doubtful, self.outside_blocked
        return moved

    def plot(self, ax: "Axes | None" = None, **style: Any) -> "Axes":
        """Draws the loops with matplotlib, arcs as arcs, on axes `ax` or on the current ones, which are returned.

        `style` is that of a patch of matplotlib, such as facecolor, edgecolor or alpha.

        >>> ax = space.slice(0).plot(facecolor="white")
        """
        return _draw.plot(self, ax, style)

    def _repr_svg_(self) -> str:
        return _draw.svg([(self, _draw.FILL)], self.bounds if self else (0.0, 0.0, 0.0, 0.0))

    def __repr__(self) -> str:
        vertices = sum(map(len, self))
        plural = "s" if len(self) != 1 else "", "vertex" if vertices == 1 else "vertices"
        doubt = ", doubtful" if self.doubtful else ""
        return f"Loops({len(self)} loop{plural[0]}, {vertices} {plural[1]}{doubt})"


def outline(loops: Loops) -> Loops:
    """Loops that neither meet nor cross, in any direction, as those of a part: with the material on the left."""
    alone = [Loops([loop]) for loop in loops]
    turned = []
    for one in alone:
        ((x, y, _), *_) = one[0]
        depth = sum(other.winding(x, y) != 0 for other in alone if other is not one)
        is_right = (one.area > 0) == (depth % 2 == 0)
        turned.append(one[0] if is_right else _reversed(one[0]))
    return Loops(turned)


def _reversed(loop: list[tuple[float, float, float]]) -> list[tuple[float, float, float]]:
    """A loop that is travelled backwards: the bulge of an edge is at the vertex where it ended."""
    return [(x, y, -before[2]) for (x, y, _), before in zip(loop[::-1], loop[-2::-1] + loop[-1:])]


def _vertices(number: int, loop: Any) -> list[tuple[float, float, float]]:
    """A loop that was given, as a list of vertices."""
    try:
        vertices = [(float(x), float(y), float(bulge)) for x, y, bulge in loop]
    except (TypeError, ValueError) as error:
        raise Error(f"loop {number} is no list of vertices (x, y, bulge): {error}") from None
    if not vertices:
        raise Error(f"loop {number} has no vertices")
    return vertices


def _edges(loop: list[tuple[float, float, float]]) -> Iterator[tuple[complex, complex, float]]:
    for (x, y, bulge), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
        yield complex(x, y), complex(x1, y1), bulge
