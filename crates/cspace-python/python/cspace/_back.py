"""Parts as shapes of build123d and CadQuery, with true lines and arcs. A part here is anything with a name and layers."""

from collections.abc import Callable, Iterator
from typing import Any

from . import _arcs
from ._errors import Error
from ._loops import Loops
from ._optional import optional

_Layers = list[tuple[tuple[float, float] | None, list[Any]]]


def _faces(loops: Loops) -> Iterator[tuple[list[Any], list[list[Any]]]]:
    """Each outermost loop, and each within a hole, with the holes right inside of it."""
    around = [
        {k for k, other in enumerate(loops) if k != i and Loops([other]).winding(*loop[0][:2])} for i, loop in enumerate(loops)
    ]
    for i, loop in enumerate(loops):
        if len(around[i]) % 2 == 0:
            yield loop, [hole for k, hole in enumerate(loops) if i in around[k] and len(around[k]) == len(around[i]) + 1]


def _layers(part: Any, face: Callable[[Any, Any], Any], line: Any, arc: Any, wire: Any) -> _Layers:
    """The faces of each layer, made of lines and arcs at its lowest height, or at 0."""

    def made(loop: Any, z: float) -> Any:
        pieces = []
        for start, end, bulge in Loops([loop])._edges():
            a, b, middle = ((p.real, p.imag, z) for p in (start, end, _arcs.at(start, end, bulge, 0.5)))
            pieces.append(arc(a, middle, b) if bulge else line(a, b))
        return wire(pieces)

    layers: _Layers = []
    for heights, loops in part.layers:
        z = 0.0 if heights is None else heights[0]
        layers.append(
            (heights, [face(made(o, z), [made(i, z) for i in inner]) for o, inner in _faces(Loops(loops))])
        )
    kinds = {heights is None for heights, _ in layers}
    if len(kinds) > 1:
        raise Error(f"some layers of {part.name!r} have heights and some are at every height: give all of them heights")
    return layers


def build123d(part: Any) -> Any:
    """A Sketch of a part that is at every height, and a Part of one with heights."""
    cad = optional("build123d")
    edge = cad.Edge
    layers = _layers(
        part, lambda outer, inner: cad.Face(outer, inner), edge.make_line, edge.make_three_point_arc, cad.Wire
    )
    if layers[0][0] is None:
        made = cad.Sketch(cad.Compound([face for _, faces in layers for face in faces]).wrapped)
    else:
        made = cad.Part() + [cad.Solid.extrude(f, (0, 0, z[1] - z[0])) for z, faces in layers if z for f in faces]
    made.label = part.name
    return made


def cadquery(part: Any) -> Any:
    """A Workplane with the faces of a part that is at every height, and with the solid of one with heights."""
    cad = optional("cadquery")

    def vector(make: Any) -> Any:
        return lambda *points: make(*(cad.Vector(*p) for p in points))

    layers = _layers(
        part,
        lambda outer, inner: cad.Face.makeFromWires(outer, inner),
        vector(cad.Edge.makeLine),
        vector(cad.Edge.makeThreePointArc),
        cad.Wire.assembleEdges,
    )
    if layers[0][0] is None:
        return cad.Workplane(obj=cad.Compound.makeCompound([face for _, faces in layers for face in faces]))
    solids = [cad.Solid.extrudeLinear(f, cad.Vector(0, 0, z[1] - z[0])) for z, faces in layers if z for f in faces]
    first, *others = solids
    return cad.Workplane(obj=first.fuse(*others) if others else first)
