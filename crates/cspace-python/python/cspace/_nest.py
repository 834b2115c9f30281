"""Where a part can be placed at given orientations: beside others, or within one, exact fits among the positions."""

from collections.abc import Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arrays, _rust
from ._arrays import number
from ._errors import Error
from ._loops import Loops
from ._part import Part


def _part(name: str, part: Any) -> Part:
    if not isinstance(part, Part):
        raise Error(f"`{name}` is {part!r}: give a Part")
    return part


def _placed(fixed: Any) -> list[tuple[Any, tuple[float, float, float]]]:
    """Parts with their configurations: one where it is drawn, or a list of pairs."""
    if isinstance(fixed, Part):
        return [(fixed._part, (0.0, 0.0, 0.0))]
    try:
        pairs = [(part, at) for part, at in fixed]
    except (TypeError, ValueError):
        raise Error("`fixed` is neither a Part nor a list of placed parts [(part, (x, y, theta)), ...]") from None
    return [(_part("fixed", part)._part, _arrays.configuration("fixed", at)) for part, at in pairs]


def _orientations(theta: ArrayLike) -> tuple[list[float], bool]:
    try:
        thetas = np.asarray(theta, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"`theta` is no number: {error}") from None
    if thetas.ndim > 1:
        raise Error("`theta` is an array of more than one dimension")
    if thetas.size:
        _arrays.angle("theta", thetas.flat[int(np.argmax(np.abs(thetas)))])
    return np.atleast_1d(thetas).tolist(), thetas.ndim == 0


def _spaced(moving: Part, spacing: float) -> Part:
    spacing = number("spacing", spacing, 0.0)
    if spacing > 1e6 * max(abs(side) for side in moving.bounds):
        raise Error(f"`spacing` is {spacing!r}, which is a million times the part")
    return moving.offset(spacing) if spacing else moving


def _answers(found: list[tuple[Any, bool]], single: bool, within: bool) -> Any:
    answers = []
    for vertices, doubtful in found:
        loops = Loops(vertices)
        loops.doubtful, loops.outside_blocked = doubtful, within
        answers.append(loops)
    return answers[0] if single else answers


Placed = Part | Sequence[tuple[Part, Sequence[float]]]


@overload
def nfp(fixed: Placed, moving: Part, theta: float = 0.0, spacing: float = 0.0) -> Loops: ...
@overload
def nfp(fixed: Placed, moving: Part, theta: Sequence[float] | NDArray[Any], spacing: float = 0.0) -> list[Loops]: ...
def nfp(fixed: Placed, moving: Part, theta: ArrayLike = 0.0, spacing: float = 0.0) -> Loops | list[Loops]:
    """The no-fit region: the boundary of the positions (x, y) at which `moving`, turned by `theta`, overlaps `fixed`.

    `fixed` is a part, or a list of placed parts [(part, (x, y, theta)), ...], which may touch each other. Beside the boundary, with the
    blocked side on its left, all is exact: what fits exactly has a loop of one vertex, or one that goes along a line or arc and back. With
    `spacing` the parts stay so far apart. One orientation gives `Loops`, an array of them a list. `loops.doubtful` says whether curves may
    be missing.

    >>> square = cs.Part.rectangle(2, 2, name="square")
    >>> cs.nfp(square, square)
    Loops(1 loop, 4 vertices)
    >>> cs.nfp(square, square).area
    16.0
    """
    thetas, single = _orientations(theta)
    grown = _spaced(_part("moving", moving), spacing)
    return _answers(_rust._beside(_placed(fixed), grown._part, thetas), single, False)


@overload
def inner_fit(container: Part, part: Part, theta: float = 0.0, spacing: float = 0.0) -> Loops: ...
@overload
def inner_fit(container: Part, part: Part, theta: Sequence[float] | NDArray[Any], spacing: float = 0.0) -> list[Loops]: ...
def inner_fit(container: Part, part: Part, theta: ArrayLike = 0.0, spacing: float = 0.0) -> Loops | list[Loops]:
    """The inner-fit region: the boundary of the positions (x, y) at which `part`, turned by `theta`, lies within `container` and outside
    of its holes; without loops it fits nowhere.

    Loops run around free positions clockwise, so that what is blocked is on their left; a part that fits exactly has a loop of one
    vertex. `theta`, `spacing` and what is returned are as of `nfp`.

    >>> cs.inner_fit(cs.Part.circle(200), cs.Part.circle(200))
    Loops(1 loop, 1 vertex)
    """
    thetas, single = _orientations(theta)
    grown = _spaced(_part("part", part), spacing)
    return _answers(_rust._within(_part("container", container)._part, grown._part, thetas), single, True)


def separation(fixed: Part, moving: Part, q: Sequence[float]) -> tuple[float, float]:
    """The shortest translation (dx, dy) of `moving` from the configuration `q` (x, y, theta) to a position beside `fixed` without overlap;
    zero where they do not overlap.

    >>> [round(d, 9) for d in cs.separation(cs.Part.rectangle(4, 2), cs.Part.circle(1), (0, 1.5, 0))]
    [0.0, 0.5]
    """
    at = _arrays.configuration("q", q)
    return _rust._separation(_part("fixed", fixed)._part, _part("moving", moving)._part, at)
