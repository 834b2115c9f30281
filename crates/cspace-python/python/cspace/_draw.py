"""Loops as pictures: SVG, and patches of matplotlib."""

from collections.abc import Iterable, Sequence
from typing import Any

from . import _arcs
from ._optional import optional

FILL, LINE = "#cdd9e5", "#24466b"
# The moving part, and the side of a slice on which the parts overlap.
MOVING, BLOCKED = "#f3d9a8", "#ebe5df"

Loops = Sequence[list[tuple[float, float, float]]]

# Shares of the size of what is drawn.
_MARGIN, _STROKE, _DOT = 0.05, 0.005, 0.01


def _is_point(loop: Any) -> bool:
    return all(vertex[:2] == loop[0][:2] for vertex in loop)


def _svg_path(loop: Any) -> str:
    """A loop as the data of an SVG path, whose y points down."""
    data = [f"M{loop[0][0]:.9g} {0.0 - loop[0][1]:.9g}"]
    for (x, y, bulge), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
        if bulge == 0:
            data.append(f"L{x1:.9g} {0.0 - y1:.9g}")
        else:
            radius = _arcs.radius(complex(x, y), complex(x1, y1), bulge)
            large, downward = int(abs(bulge) > 1), int(bulge < 0)
            data.append(f"A{radius:.9g} {radius:.9g} 0 {large} {downward} {x1:.9g} {0.0 - y1:.9g}")
    return "".join(data) + "Z"


def svg(drawn: Iterable[tuple[Loops, str]], bounds: tuple[float, float, float, float]) -> str:
    """Loops, filled with a colour, as an SVG document that shows the bounds (x, y, x, y): points as dots, slits as lines."""
    x0, y0, x1, y1 = bounds
    size = max(x1 - x0, y1 - y0) or 1.0
    margin = _MARGIN * size
    box = f"{x0 - margin:.6g} {0.0 - y1 - margin:.6g} {x1 - x0 + 2 * margin:.6g} {y1 - y0 + 2 * margin:.6g}"
    shapes = ""
    for loops, fill in drawn:
        path = "".join(_svg_path(loop) for loop in loops if not _is_point(loop))
        dots = "".join(
            f'<circle cx="{loop[0][0]:.9g}" cy="{0.0 - loop[0][1]:.9g}" r="{_DOT * size:.3g}" fill="{LINE}"/>'
            for loop in loops
            if _is_point(loop)
        )
        shapes += (
            f'<path d="{path}" fill="{fill}" stroke="{LINE}" stroke-width="{_STROKE * size:.3g}"/>{dots}'
        )
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}" width="300">{shapes}</svg>'


def bezier_path(loops: Loops) -> Any:
    """Loops as a path of matplotlib: lines, and arcs as cubic Béziers."""
    path = optional("matplotlib.path").Path
    places: list[complex] = []
    codes: list[int] = []
    for loop in loops:
        places.append(complex(*loop[0][:2]))
        codes.append(path.MOVETO)
        for (x, y, bulge), (x1, y1, _) in zip(loop, loop[1:] + loop[:1]):
            start, end = complex(x, y), complex(x1, y1)
            if bulge == 0:
                places.append(end)
                codes.append(path.LINETO)
            else:
                for curve in _arcs.beziers(start, end, bulge):
                    places += curve
                    codes += [path.CURVE4] * 3
        places.append(complex(*loop[0][:2]))
        codes.append(path.CLOSEPOLY)
    return path([(p.real, p.imag) for p in places], codes)


def plot(loops: Loops, ax: Any, style: dict[str, Any]) -> Any:
    """Draws loops on axes, or on the current ones; points as dots, slits as lines."""
    patch = optional("matplotlib.patches").PathPatch
    style = optional("matplotlib.cbook").normalize_kwargs(style, patch)
    if "color" not in style:
        style = {"facecolor": FILL, "edgecolor": LINE, **style}
    if ax is None:
        ax = optional("matplotlib.pyplot").gca()
    lines = [loop for loop in loops if not _is_point(loop)]
    if lines:
        ax.add_patch(patch(bezier_path(lines), **style))
    dots = [loop[0][:2] for loop in loops if _is_point(loop)]
    if dots:
        color = style.get("color", style.get("edgecolor"))
        ax.plot(*zip(*dots), linestyle="none", marker=".", color=color, zorder=style.get("zorder"))
    ax.autoscale_view()
    ax.set_aspect("equal")
    ax.set_xlabel("x")
    ax.set_ylabel("y")
    return ax
