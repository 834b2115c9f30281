"""Where a part goes in a container among placed parts, at any orientation."""

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _rust
from ._arrays import angle, column, configuration, position
from ._arrays import window as window_of
from ._errors import Error
from ._features import Feature
from ._nest import _part, _spaced
from ._part import Part
from ._results import Region
from ._space import ContactSpace


def _placed(name: str, placed: Any) -> list[tuple[Part, tuple[float, float, float]]]:
    """Parts with their configurations, a part by itself as it is drawn."""
    if isinstance(placed, Part) or not hasattr(placed, "__iter__"):
        raise Error(f"`{name}` is {placed!r}: give a list of parts, or of placed parts [(part, (x, y, theta)), ...]")
    pairs = []
    for one in placed:
        if isinstance(one, Part):
            one = (one, (0.0, 0.0, 0.0))
        if not isinstance(one, (tuple, list)) or len(one) != 2:
            raise Error(f"`{name}` has {one!r}: give a part, or a placed part (part, (x, y, theta))")
        pairs.append((_part(name, one[0]), configuration(name, one[1])))
    return pairs


@dataclass(frozen=True)
class Place:
    """A place of a part in a container.

    `touching` has what touches there: the number of the placed part, or None of the container, its feature, and the part's. `length` is
    how much of the part's outline lies flush. `part` is the part as drawn there.

    >>> place = cs.fit(cs.Part.rectangle(8, 8), [], cs.Part.rectangle(3, 1)).lowest()
    >>> place.length, place.part.bounds, len(place.touching)
    (4.0, (-4.0, -4.0, -1.0, -3.0), 4)
    """

    at: tuple[float, float, float]
    touching: tuple[tuple[int | None, Feature, Feature], ...]
    length: float
    part: Part


class Fit:
    """A part in a container beside placed parts, over all orientations: true if it fits somewhere, with room or exactly.

    >>> tray, tile = cs.Part.rectangle(4, 2), cs.Part.rectangle(2, 1)
    >>> last = cs.fit(tray, [(tile, (-1, -0.5, 0)), (tile, (1, -0.5, 0)), (tile, (1, 0.5, 0))], tile)
    >>> bool(last), [round(x, 9) for x in last.lowest().at]
    (True, [-1.0, 0.5, 0.0])
    """

    __slots__ = ("_fit", "_space", "part")

    def __init__(self, found: _rust.Fit, part: Part) -> None:
        space = found.space()
        self._fit, self._space, self.part = found, None if space is None else ContactSpace(space), part

    @property
    def space(self) -> ContactSpace:
        """The space of the walls, as one fixed part, and the part: what is outside of the container, up to a frame around it, and the placed
        parts, on layers where they touch. With `spacing` the part in it is larger. There is none of single `orientations`.

        >>> cs.fit(cs.Part.rectangle(8, 8), [], cs.Part.circle(1)).space.classify((0, 0, 0))
        <Class.FREE: 0>
        """
        if self._space is None:
            raise Error("there is no space of single orientations: leave `orientations` out")
        return self._space

    def __bool__(self) -> bool:
        return self._fit.fits()

    @property
    def regions(self) -> list[Region]:
        """The free regions within the container. An exact fit has no room, and no region.

        >>> len(cs.fit(cs.Part.rectangle(8, 8), [], cs.Part.circle(1)).regions)
        1
        """
        return [region for region in self.space.regions if region.caged]

    def lowest(self, direction: Sequence[float] = (0.0, -1.0), about: Sequence[float] | None = None) -> Place | None:
        """The place at which a point of the part is farthest in a direction, over all orientations; None where it fits nowhere.

        The point is `about`, in the part's frame, or its centroid. Of places that are as far, to the resolution, it is the farthest to the
        right of the direction, and then the one with the least turn: for the default the lowest, and of these the leftmost.

        >>> cs.fit(cs.Part.rectangle(8, 8), [], cs.Part.circle(1)).lowest().at
        (-3.0, -3.0, 0.0)
        """
        x, y = position("direction", direction)
        if not (x or y):
            raise Error("`direction` has no length: (0, -1) is down")
        return self._place(self._fit.lowest((x, y), None if about is None else position("about", about)))

    def tightest(self) -> Place | None:
        """The place at which the greatest length of the part's outline lies flush on the container and the placed parts: line on line, or
        arc in an arc of the same radius. Of several it is the lowest, and then the leftmost. Where nothing can lie flush it is the lowest
        place; None where the part fits nowhere.

        With `spacing` it is the outline at that distance that lies flush.

        >>> cs.fit(cs.Part.rectangle(8, 8), [], cs.Part.rectangle(3, 1)).tightest().length
        4.0
        """
        return self._place(self._fit.tightest())

    def _place(self, found: Any) -> Place | None:
        if found is None:
            return None
        at, touching, length = found
        contacts = tuple((owner, Feature(*wall), Feature(*own)) for owner, wall, own in touching)
        return Place(at, contacts, length, self.part.moved(*at))

    def __repr__(self) -> str:
        return f"Fit({self.part.name!r}, {'fits' if self else 'does not fit'})"


def fit(
    container: Part,
    placed: Any,
    part: Part,
    spacing: float = 0.0,
    window: Sequence[float] | None = None,
    orientations: ArrayLike | None = None,
) -> Fit:
    """Where a part goes in a container, outside of its holes and beside placed parts: at any orientation, at those of a `window` (lo, hi), or
    at single `orientations`, in radians.

    `placed` is a list of parts as they are drawn, or of placed parts (part, (x, y, theta)); they may touch each other and the container.
    With `spacing` the part stays so far from them, and from the container.

    >>> bool(cs.fit(cs.Part.rectangle(8, 8), [cs.Part.circle(3.5)], cs.Part.circle(1)))
    False
    """
    if window is not None and orientations is not None:
        raise Error("`window` and `orientations` are both given")
    these = None
    if orientations is not None:
        these = [angle("orientations", theta) for theta in column("orientations", orientations).ravel().tolist()]
        if not these:
            raise Error("`orientations` is empty: give angles in radians, or leave it out")
    pairs = [(one._part, at) for one, at in _placed("placed", placed)]
    grown = _spaced(_part("part", part), spacing)
    outer = _part("container", container)._part
    return Fit(_rust.Fit._of(outer, pairs, part._part, grown._part, window_of(window), these), part)


def write_dxf(path: str | os.PathLike[str], parts: Any, unit: str | None = None) -> None:
    """Writes parts as a DXF file, arcs as arcs, each on a layer of its own: a list of parts as drawn, or of placed parts
    (part, (x, y, theta)). `unit` is the drawing's, such as "mm".

    >>> cs.write_dxf("two.dxf", [cs.Part.circle(2), (cs.Part.rectangle(4, 2, name="plate"), (9, 0, 0))], unit="mm")
    >>> cs.Part.from_dxf("two.dxf", layer="plate").bounds
    (7.0, -1.0, 11.0, 1.0)
    """
    text = _rust._dxf([(one._part, at) for one, at in _placed("parts", parts)], unit)
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(text)
