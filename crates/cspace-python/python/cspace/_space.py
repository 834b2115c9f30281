"""Configuration spaces."""

import dataclasses
import html
import math
import os
import tempfile
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _rust
from ._arrays import angle, number, position, window
from ._errors import Error
from ._loops import Loops
from ._optional import optional
from ._part import Part
from ._results import Contact, Crossing, Motion, Nearest, Patch, Plan, Play, Region

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# The side of a slice on which the parts overlap.
_BLOCKED = "#ebe5df"
_MOVING = "#f3d9a8"


class ContactSpace:
    """The configuration space of two parts: where the moving one is free, blocked or in contact.

    Configurations are (x, y, theta) of the moving part in the fixed part's frame, or (u, v) of two parts on axes; `q` is one of them, as a
    list, tuple or array, or an array n×3 or n×2 of many. One gives a number, many give an array.

    Parts that fit exactly at a configuration have no room there: `play`, `move` and `plan` take the moving part smaller by a `gap` all
    around, a millionth of the size, which their records tell.
    """

    __slots__ = ("_patches", "_regions", "_space")

    def __init__(self, space: _rust.ContactSpace) -> None:
        self._space = space
        self._patches: list[Patch] | None = None
        self._regions: list[Region] | None = None

    def classify(self, q: ArrayLike) -> Any:
        """0 (`cspace.FREE`) where the configuration is free, 1 (`BLOCKED`) where the parts overlap, 2 (`CONTACT`) in contact: an integer for
        one, an array of uint8 for many."""
        return self._space.classify(q)

    def clearance(self, q: ArrayLike) -> Any:
        """The smallest distance of the parts, a length: 0 in contact, nan where they overlap."""
        return self._space.clearance(q)

    def region(self, q: ArrayLike) -> Any:
        """The number of the free region, as in `regions`: of one configuration None where it is not free, of many -1 there."""
        return self._space.region(q)

    @property
    def fixed(self) -> Part:
        """The fixed part."""
        return Part._of(self._space.fixed)

    @property
    def moving(self) -> Part:
        """The moving part."""
        return Part._of(self._space.moving)

    @property
    def window(self) -> tuple[float, float] | None:
        """The orientations for which it is computed, radians; None for a full turn."""
        return self._space.window

    @property
    def pair_class(self) -> str:
        """The class of the pair: "lower", "fixed-axes", "symmetric" or "general"."""
        return self._space.pair_class

    @property
    def resolution(self) -> float:
        """Contacts are known to this, a length."""
        return self._space.resolution

    @property
    def least_clearance(self) -> float:
        """Clearances below this count as none, a length."""
        return _rust._measures(self._space)[1]

    @property
    def contact_distance(self) -> float:
        """Configurations nearer to contact than this are in contact for `classify`, a length."""
        return _rust._measures(self._space)[2]

    @property
    def features(self) -> tuple[int, int]:
        """How many lines, arcs and vertices the fixed and the moving part have."""
        return _rust._measures(self._space)[0]

    @property
    def bands(self) -> list[tuple[float, float]]:
        """The intervals between critical orientations, radians: within one nothing but lengths changes."""
        return _rust._bands(self._space)

    @property
    def regions(self) -> list[Region]:
        """The free regions, by their numbers."""
        if self._regions is None:
            self._regions = [Region(tuple(sample), caged) for sample, caged in self._space._regions()]
        return self._regions

    @property
    def patches(self) -> list[Patch]:
        """The contact patches, by their numbers."""
        if self._patches is None:
            self._patches = [Patch(*patch) for patch in self._space._patches()]
        return self._patches

    def links(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """Links between patches as four arrays: first patch, second patch, and the smallest and largest orientation at which they meet;
        nan on fixed axes."""
        return self._space.links()

    def contact(self, patch: int, q: ArrayLike) -> Contact:
        """The contact function of a patch at one configuration or at many, with derivatives and the place where its features touch."""
        return Contact(**_rust._evaluate(self._space, _patch(patch), q))

    def ends(self, patch: int, theta: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The boundary curves of a patch: the positions (x, y) at which it begins and ends at orientations, as two arrays n×2; nan where
        it does not exist. Blocked space is on the left of the way from the one to the other."""
        try:
            thetas = np.ascontiguousarray(np.atleast_1d(np.asarray(theta, dtype=np.float64)).ravel())
        except (TypeError, ValueError) as error:
            raise Error(f"`theta` is no array of numbers: {error}") from None
        return _rust._ends(self._space, _patch(patch), thetas)

    def connected(self, start: ArrayLike, goal: ArrayLike) -> Any:
        """Whether configurations are free and in one region with the configuration `goal`: true or false for one, an array for many."""
        return _rust._connected(self._space, start, goal)

    def contacts(self, q: ArrayLike, tolerance: float | None = None) -> list[tuple[int, float]]:
        """The patches no farther than `tolerance` from one configuration, with the distances; within the resolution without."""
        return self._space.contacts(q, None if tolerance is None else number("tolerance", tolerance, 0.0))

    def nearest(self, q: ArrayLike) -> Nearest | None:
        """The nearest configuration in contact, or None where there is no contact at all."""
        found = self._space._nearest(q)
        return None if found is None else Nearest(found[0], tuple(found[1]), found[2])

    def project(self, q: ArrayLike, length_per_radian: float, patch: int | None = None) -> Nearest | None:
        """The configuration in contact that is nearest to one configuration, where a radian counts as `length_per_radian`: of a patch, or
        of any."""
        if not number("length_per_radian", length_per_radian) > 0:
            raise Error(f"`length_per_radian` is {length_per_radian!r} where a positive length is expected")
        onto = None if patch is None else _patch(patch)
        found = _rust._projected(self._space, q, float(length_per_radian), onto)
        return None if found is None else Nearest(found[0], tuple(found[1]), found[2])

    def near_features(self, q: ArrayLike, within: float) -> list[tuple[str, str, float]]:
        """The pairs of features no farther than `within` apart at one configuration: their names on the fixed and the moving part, and
        their distance, negative where they overlap."""
        return self._space.near_features(q, number("within", within, 0.0))

    def move(self, start: ArrayLike, by: ArrayLike, about: tuple[float, float] = (0.0, 0.0)) -> Motion:
        """A motion of constant rates from `start` by the displacement `by`, up to its first contact. The point `about` of the moving part,
        in its frame, moves straight, and the part turns about it."""
        result, fraction, at, touching, gap = self._space._move(start, by, about)
        return Motion(result, fraction, tuple(at), touching, gap)

    def crossings(self, start: ArrayLike, by: ArrayLike) -> list[Crossing]:
        """Every contact that a motion of constant rates from `start` by the displacement `by` comes through, also where the parts
        overlap."""
        return [Crossing(patch, t, tuple(at), enters) for patch, t, at, enters in _rust._crossings(self._space, start, by)]

    def play(self, q: ArrayLike) -> dict[str, Play]:
        """For each coordinate how far it goes when it alone changes, as a dictionary of `Play`."""
        found, gap = self._space._play(q)
        return {name: Play(name, lower, upper, tuple(touching), gap) for name, (lower, upper), touching in found}

    def plan(
        self,
        start: ArrayLike,
        goal: ArrayLike | None = None,
        widest: bool = False,
        clearance: float | None = None,
        about: tuple[float, float] | None = None,
        prefer: str = "legs",
    ) -> Plan:
        """A path from `start` to `goal` through free space, or the proof that there is none. Without `goal`, out: until a line lies
        between the convex hulls of the parts.

        With `widest` no other path has more clearance; with `clearance` it has at least so much. Legs move the point `about` of the moving
        part straight, in its frame, and turn the part about it: without it, the part's origin, the middle of the part where that is drawn
        beside its origin, or another point about which the way has few legs. Rows of `path` are free as they stand, whatever the point is. `prefer` is what else makes a path good: few "legs", "clearance" all along, or "length".
        """
        if widest and clearance is not None:
            raise Error("`widest` and `clearance` are both given")
        least = None if clearance is None else number("clearance", clearance, 0.0)
        return Plan(*self._space._plan(start, goal, math.inf if widest else least, about, prefer))

    def slice(self, theta: float) -> Loops:
        """The boundary of free space at an orientation, as loops of (x, y, bulge) with the blocked side on the left."""
        vertices, doubtful = self._space.slice(angle("theta", theta))
        loops = Loops(vertices)
        loops.doubtful = doubtful
        return loops

    def plot(self, theta: float = 0.0, at: Sequence[float] | None = None, ax: "Axes | None" = None) -> "Axes":
        """Draws the slice at an orientation with matplotlib, on axes `ax` or on the current ones, which are returned.

        The free side is left as it is, the blocked side is filled. With `at`, a position (x, y), the two parts are drawn there.
        """
        if self.pair_class == "fixed-axes":
            raise Error(
                "two parts on axes have no slices in x and y: their space in u and v is written as a picture by the command, "
                "`space.save(\"space.json\")` and then `cspace slice space.json -o space.svg`"
            )
        ax = self.slice(theta).plot(ax, facecolor=_BLOCKED, zorder=1)
        if at is not None:
            x, y = position("at", at)
            self.fixed.plot(ax, alpha=0.8, zorder=2)
            self.moving.outline.moved(x, y, theta).plot(ax, facecolor=_MOVING, alpha=0.8, zorder=2)
            ax.plot([x], [y], color="black", marker="+", zorder=3)
        return ax

    def svg(self, theta: float = 0.0) -> str:
        """The slice at an orientation as SVG, as the command draws it; of two parts on axes the plane of their motions."""
        return _rust._svg(self._space, angle("theta", theta))

    def _repr_svg_(self) -> str | None:
        if self.pair_class == "lower":
            return None
        return self.svg(0.0 if self.window is None else sum(self.window) / 2)

    def view(self, height: int = 640) -> Any:
        """The page of the command for this space, which needs no server, as a frame in a Jupyter notebook."""
        display = optional("IPython.display", "ipython")
        _rust._require_page()
        with tempfile.TemporaryDirectory() as folder:
            space, page = os.path.join(folder, "space.json"), os.path.join(folder, "space.html")
            self.save(space)
            if _rust.command(["cspace", "export", space, "-o", page]) != 0:
                raise Error("the page could not be written")
            with open(page, encoding="utf-8") as file:
                text = html.escape(file.read(), quote=True)
        return display.HTML(f'<iframe srcdoc="{text}" width="100%" height="{height}" style="border:0"></iframe>')

    def mesh(self, tolerance: float = 1e-3) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """The contact surface as triangles: vertices n×3 (x, y, theta) on the surface, and faces m×3. `tolerance` is a share of the pair's
        size."""
        vertices, faces, _ = self._space.mesh(number("tolerance", tolerance))
        return vertices, faces

    def to_trimesh(self, tolerance: float = 1e-3) -> Any:
        """The contact surface as a trimesh.Trimesh in x, y and theta, with the vertices and faces of `mesh`.

        Its `face_attributes["patch"]` are the numbers of the patches that the faces are of.
        """
        trimesh = optional("trimesh")
        vertices, faces, patches = self._space.mesh(number("tolerance", tolerance))
        return trimesh.Trimesh(vertices, faces, face_attributes={"patch": patches}, process=False)

    def to_networkx(self) -> Any:
        """The patches and their links as a networkx.MultiDiGraph.

        Nodes are the numbers of the patches, with the fields of `Patch`. Edges go from the first patch of a link to the second, with the
        orientations `lo` and `hi` of the link.
        """
        graph = optional("networkx").MultiDiGraph()
        graph.add_nodes_from((i, dataclasses.asdict(patch)) for i, patch in enumerate(self.patches))
        links = (column.tolist() for column in self.links())
        graph.add_edges_from((first, second, {"lo": lo, "hi": hi}) for first, second, lo, hi in zip(*links))
        return graph

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the space as JSON, which the command reads in place of a model."""
        text = self._space.to_json()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def __repr__(self) -> str:
        return repr(self._space)

    def __reduce__(self) -> Any:
        return _restored, (self.fixed, self.moving, self._space._relation(), self.window, _rust.VERSION)


def _patch(given: Any) -> int:
    """The number of a patch."""
    if isinstance(given, bool) or not hasattr(given, "__index__"):
        raise Error(f"`patch` is {given!r} where the number of a patch is expected")
    return min(max(given.__index__(), -1), 2**62)


def _restored(
    fixed: Part, moving: Part, relation: str, theta: tuple[float, float] | None, _version: str
) -> ContactSpace:
    """A space that was sent: its parts, of which it is computed when it is first asked."""
    return ContactSpace(_rust.ContactSpace._restored(fixed._part, moving._part, relation, theta))


def compute(fixed: Part, moving: Part, theta: Sequence[float] | None = None) -> ContactSpace:
    """The configuration space of two parts that move freely in the plane; `theta` is a window of orientations (lo, hi), radians."""
    for name, part in (("fixed", fixed), ("moving", moving)):
        if not isinstance(part, Part):
            raise Error(f"`{name}` is {part!r}: give a Part")
    return ContactSpace(_rust.compute(fixed._part, moving._part, window(theta)))
