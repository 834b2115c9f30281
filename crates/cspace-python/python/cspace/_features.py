"""Features of parts: lines, arcs and vertices."""

from typing import Any, NamedTuple


class Feature(str):
    """A line, an arc or a vertex of a part: the name that answers call it by, a `str`, with its place in the drawing.

    `kind` is "line", "convex arc", "concave arc" or "vertex"; `loop` is the number of its loop, and `number` that of the vertex, or of the
    vertex at which the line or arc begins, both from 0.

    >>> cs.Part.rectangle(4, 2).feature("line 1 of loop 0").kind
    'line'
    """

    kind: str
    loop: int
    number: int

    def __new__(cls, name: str, kind: str, loop: int, number: int) -> "Feature":
        self = super().__new__(cls, name)
        self.kind, self.loop, self.number = kind, loop, number
        return self

    def __getnewargs__(self) -> Any:
        return str(self), self.kind, self.loop, self.number


class FeaturePair(NamedTuple):
    """Two features that touch or are near each other: of the fixed and of the moving part.

    >>> space.move((0, 6, 0), (0, -6, 0)).touching[0].fixed
    'line 2 of loop 0'
    """

    fixed: Feature
    moving: Feature


def pairs(told: list[Any]) -> list[FeaturePair]:
    """Pairs of features as they are read."""
    return [FeaturePair(Feature(*fixed), Feature(*moving)) for fixed, moving in told]
