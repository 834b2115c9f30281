"""Parts that move, drawn with matplotlib: true outlines, placed anew in each frame."""

import os
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _draw
from ._arrays import number
from ._errors import Error
from ._optional import optional
from ._part import Part

# Writers of matplotlib by the extension of the file, and what they need.
_WRITERS = {".gif": ("pillow", "pip install pillow"), ".mp4": ("ffmpeg", "install the program ffmpeg")}
_FACES = (_draw.FILL, _draw.MOVING, "#cfe3cf", "#e5cdd9", "#d9d3ea")
# What is left free around the parts, as a share of what they cover.
_MARGIN = 0.05


def _writer(path: str, fps: float) -> Any:
    end = os.path.splitext(path)[1].lower()
    if end not in _WRITERS:
        raise Error(f"{path!r} is no animation: give a file that ends in {' or '.join(_WRITERS)}")
    name, advice = _WRITERS[end]
    writers = optional("matplotlib.animation").writers
    if not writers.is_available(name):
        raise Error(f"matplotlib cannot write {end} here: {advice}")
    return writers[name](fps=fps)


def _covered(part: Part, poses: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The smallest and the largest x and y that the box of a part comes to."""
    x0, y0, x1, y1 = part.bounds
    corners = np.array([complex(x, y) for x in (x0, x1) for y in (y0, y1)])
    places = poses[:, 0] + 1j * poses[:, 1] + np.exp(1j * poses[:, 2]) * corners[:, None]
    return np.array([places.real.min(), places.imag.min()]), np.array([places.real.max(), places.imag.max()])


def animate(
    parts: Sequence[tuple[Part, NDArray[np.float64]]], path: str | os.PathLike[str] | None, fps: float, titles: Sequence[str]
) -> Any:
    """The parts at their poses n×3 (x, y, theta), one frame for each, as an animation of matplotlib, or in a file."""
    fps = number("fps", fps)
    if not fps > 0:
        raise Error(f"`fps` is {fps!r} where a number of frames per second is expected")
    count = len(titles)
    if not count:
        raise Error("there is nothing to animate: no configurations")
    pyplot, transforms = optional("matplotlib.pyplot"), optional("matplotlib.transforms")
    writer = None if path is None else _writer(os.fspath(path), fps)
    figure, ax = pyplot.subplots()
    patches = []
    for i, (part, _) in enumerate(parts):
        patch = optional("matplotlib.patches").PathPatch(
            _draw.bezier_path(part.outline), facecolor=_FACES[i % len(_FACES)], edgecolor=_draw.LINE, alpha=0.9
        )
        patches.append(ax.add_patch(patch))
    covered = [_covered(part, poses) for part, poses in parts]
    low = np.min([lo for lo, _ in covered], axis=0)
    high = np.max([hi for _, hi in covered], axis=0)
    margin = _MARGIN * (high - low).max()
    ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin), aspect="equal")

    def show(k: int) -> list[Any]:
        for patch, (_, poses) in zip(patches, parts):
            x, y, theta = poses[k]
            patch.set_transform(transforms.Affine2D().rotate(theta).translate(x, y) + ax.transData)
        return [*patches, ax.set_title(titles[k])]

    moving = optional("matplotlib.animation").FuncAnimation(figure, show, frames=count, interval=1000 / fps)
    if path is None:
        return moving
    try:
        moving.save(os.fspath(path), writer=writer)
    finally:
        pyplot.close(figure)
    return moving
