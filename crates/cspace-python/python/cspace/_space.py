"""Configuration spaces."""

import dataclasses
import html
import math
import os
import tempfile
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _draw, _rust
from ._arrays import angle, number, position, window
from ._classes import Class
from ._errors import Error
from ._features import FeaturePair, pairs
from ._loops import Loops
from ._optional import optional
from ._part import Part
from ._results import ContactFunction, Crossing, Motion, Nearest, Patch, Plan, Play, Region

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_CLASSES = tuple(Class)


class ContactSpace:
    """The configuration space of two parts: where the moving one is free, blocked or in contact.

    Configurations are (x, y, theta) of the moving part in the fixed part's frame, or (u, v) of two parts on axes; `q` is one of them, as a
    list, tuple or array, or an array n×3 or n×2 of many. One gives a number, many give an array.

    Parts that fit exactly at a configuration have no room there: `play`, `move` and `plan` take the moving part smaller by a `gap` all
    around, a millionth of the size, which their records tell.

    Docstrings are about the space of a disc of radius 1 beside a table of 4 x 2:

    >>> space = cs.compute(cs.Part.rectangle(4, 2, name="table"), cs.Part.circle(1, name="coin"))
    >>> space.clearance((0, 6, 0))
    4.0
    """

    __slots__ = ("_patches", "_regions", "_space")

    def __init__(self, space: _rust.ContactSpace) -> None:
        self._space = space
        self._patches: list[Patch] | None = None
        self._regions: list[Region] | None = None

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> "ContactSpace":
        """The space in a file that `save` or the command, `cspace export`, has written: read, not computed again.

        >>> space.save("space.json")
        >>> len(cs.ContactSpace.load("space.json").patches)
        32
        """
        with open(path, encoding="utf-8") as file:
            return cls(_rust.ContactSpace._loaded(file.read(), os.fspath(path)))

    @overload
    def classify(self, q: Sequence[float]) -> Class: ...
    @overload
    def classify(self, q: Sequence[Sequence[float]]) -> NDArray[np.uint8]: ...
    @overload
    def classify(self, q: ArrayLike) -> Any: ...
    def classify(self, q: Any) -> Any:
        """`cspace.FREE` (0) where the configuration is free, `BLOCKED` (1) where the parts overlap, `CONTACT` (2) in contact: a `Class` for
        one, an array of uint8 for many.

        >>> space.classify((0, 6, 0)), space.classify([(0, 6, 0), (0, 0, 0)]).tolist()
        (<Class.FREE: 0>, [0, 1])
        """
        found = self._space.classify(q)
        return _CLASSES[found] if isinstance(found, int) else found

    @overload
    def clearance(self, q: Sequence[float]) -> float: ...
    @overload
    def clearance(self, q: Sequence[Sequence[float]]) -> NDArray[np.float64]: ...
    @overload
    def clearance(self, q: ArrayLike) -> Any: ...
    def clearance(self, q: Any) -> Any:
        """The smallest distance of the parts, a length: 0 in contact, nan where they overlap; an array of n for many.

        >>> space.clearance([(0, 6, 0), (0, 0, 0)]).tolist()
        [4.0, nan]
        """
        return self._space.clearance(q)

    @overload
    def region(self, q: Sequence[float]) -> int | None: ...
    @overload
    def region(self, q: Sequence[Sequence[float]]) -> NDArray[np.int64]: ...
    @overload
    def region(self, q: ArrayLike) -> Any: ...
    def region(self, q: Any) -> Any:
        """The number of the free region, as in `regions`: of one configuration None where it is not free, of many -1 there.

        >>> space.region((0, 6, 0)), space.region((0, 0, 0))
        (0, None)
        """
        return self._space.region(q)

    def poses(self, q: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Where the fixed and the moving part are: two poses (x, y, theta) that take their drawings to the assembly, or two arrays n×3.

        >>> [pose.tolist() for pose in space.poses((0, 6, 0))]
        [[0.0, 0.0, 0.0], [0.0, 6.0, 0.0]]
        """
        fixed, moving = self._space._poses(q)
        return (fixed[0], moving[0]) if np.ndim(q) == 1 else (fixed, moving)

    def _places(self, _fixed: str, _moving: str, rows: NDArray[np.float64]) -> list[tuple[Part, NDArray[np.float64]]]:
        """The parts at configurations."""
        return list(zip((self.fixed, self.moving), self.poses(rows)))

    @property
    def fixed(self) -> Part:
        """The fixed part.

        >>> space.fixed.name
        'table'
        """
        return Part._of(self._space.fixed)

    @property
    def moving(self) -> Part:
        """The moving part.

        >>> space.moving.name
        'coin'
        """
        return Part._of(self._space.moving)

    @property
    def unit(self) -> str | None:
        """The unit of lengths, where the model says one.

        >>> model.compute().unit
        'mm'
        """
        return self._space.unit

    @property
    def window(self) -> tuple[float, float] | None:
        """The orientations for which it is computed, radians; None for a full turn.

        >>> space.window is None
        True
        """
        return self._space.window

    @property
    def pair_class(self) -> str:
        """The class of the pair: "lower", "fixed-axes", "symmetric" or "general".

        >>> space.pair_class
        'symmetric'
        """
        return self._space.pair_class

    @property
    def resolution(self) -> float:
        """Contacts are known to this, a length.

        >>> space.resolution < 1e-9
        True
        """
        return self._space.resolution

    @property
    def least_clearance(self) -> float:
        """Clearances below this count as none, a length.

        >>> space.least_clearance < 1e-8
        True
        """
        return _rust._measures(self._space)[1]

    @property
    def contact_distance(self) -> float:
        """Configurations nearer to contact than this are in contact for `classify`, a length.

        >>> space.contact_distance < 1e-8
        True
        """
        return _rust._measures(self._space)[2]

    @property
    def features(self) -> tuple[int, int]:
        """How many lines, arcs and vertices the fixed and the moving part have.

        >>> space.features
        (8, 2)
        """
        return _rust._measures(self._space)[0]

    @property
    def bands(self) -> list[tuple[float, float]]:
        """The intervals between critical orientations, radians: within one nothing but lengths changes.

        >>> len(space.bands)
        4
        """
        return _rust._bands(self._space)

    @property
    def regions(self) -> list[Region]:
        """The free regions, by their numbers.

        >>> len(space.regions)
        1
        """
        if self._regions is None:
            self._regions = [Region(tuple(sample), caged) for sample, caged in self._space._regions()]
        return self._regions

    @property
    def patches(self) -> list[Patch]:
        """The contact patches, by their numbers.

        >>> len(space.patches)
        32
        """
        if self._patches is None:
            told, patches = self._space._patches()
            features = pairs(told)
            self._patches = [Patch(features[k].fixed, features[k].moving, region, orientations) for k, region, orientations in patches]
        return self._patches

    def links(self) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
        """Links between patches as four arrays: first patch, second patch, and the smallest and largest orientation at which they meet;
        nan on fixed axes.

        >>> first, second, lo, hi = space.links()
        >>> len(first) == len(lo)
        True
        """
        return self._space.links()

    def contact_function(self, patch: int, q: ArrayLike) -> ContactFunction:
        """The contact function of a patch at one configuration or at many, with derivatives and the place where its features touch.

        >>> space.contact_function(0, (0, 6, 0)).normal.shape
        (2,)
        """
        return ContactFunction(**_rust._evaluate(self._space, _patch(patch), q))

    def patch_ends(self, patch: int, theta: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The boundary curves of a patch: the positions (x, y) at which it begins and ends at orientations, as two arrays n×2; nan where
        it does not exist. Blocked space is on the left of the way from the one to the other.

        >>> begins, ends = space.patch_ends(0, [0.0, 0.1])
        >>> begins.shape
        (2, 2)
        """
        try:
            thetas = np.ascontiguousarray(np.atleast_1d(np.asarray(theta, dtype=np.float64)).ravel())
        except (TypeError, ValueError) as error:
            raise Error(f"`theta` is no array of numbers: {error}") from None
        return _rust._ends(self._space, _patch(patch), thetas)

    def connected(self, start: ArrayLike, goal: ArrayLike) -> Any:
        """Whether configurations are free and in one region with the configuration `goal`: true or false for one, an array for many.

        >>> space.connected([(0, 6, 0), (0, 0, 0)], (0, -6, 0)).tolist()
        [True, False]
        """
        return _rust._connected(self._space, start, goal)

    @overload
    def contacts(self, q: Sequence[float], tolerance: float | None = None) -> list[tuple[int, float]]: ...
    @overload
    def contacts(self, q: ArrayLike, tolerance: float | None = None) -> Any: ...
    def contacts(self, q: Any, tolerance: float | None = None) -> Any:
        """The patches no farther than `tolerance`, a length, from a configuration, with the distances; within the resolution without. Of many
        configurations three arrays: the number of the row, that of the patch, and the distance, of which a row has any number.

        >>> rows, patches, distances = space.contacts([(0, 6, 0), (0, 2, 0)])
        >>> rows.tolist(), patches.tolist() == [patch for patch, _ in space.contacts((0, 2, 0))]
        ([1], True)
        """
        return self._space.contacts(q, None if tolerance is None else number("tolerance", tolerance, 0.0))

    def nearest(self, q: ArrayLike, length_per_radian: float | None = None, patch: int | None = None) -> Nearest | None:
        """The nearest configuration in contact, or None where there is no contact at all: at the same orientation, or of parts on axes by
        the motion of the moving part alone. With `length_per_radian`, the length that a radian counts as, every coordinate may change, and
        `patch` may say on which patch it is. Many configurations have a `Nearest` of arrays.

        >>> space.nearest([(0, 6, 0), (0, 7, 0)]).distance.round(9).tolist()
        [4.0, 5.0]
        """
        if length_per_radian is not None and not number("length_per_radian", length_per_radian) > 0:
            raise Error(f"`length_per_radian` is {length_per_radian!r} where a positive length is expected")
        if length_per_radian is None and patch is not None:
            raise Error("`patch` is given without `length_per_radian`: give the length that a radian counts as")
        (patches, places, distances), is_one = self._space._nearest(
            q, None if length_per_radian is None else float(length_per_radian), None if patch is None else _patch(patch)
        )
        if not is_one:
            return Nearest(patches, places, distances)
        return None if patches[0] < 0 else Nearest(int(patches[0]), tuple(places[0].tolist()), float(distances[0]))

    def features_within(self, q: ArrayLike, within: float) -> list[tuple[FeaturePair, float]]:
        """The pairs of features no farther than `within`, a length, apart at one configuration, with their distance, negative where they
        overlap; the nearest first.

        >>> space.features_within((0, 2.5, 0), 1)
        [(FeaturePair(fixed='line 2 of loop 0', moving='convex arc 0 of loop 0'), 0.5)]
        """
        told, distances = self._space._features_within(q, number("within", within, 0.0))
        return list(zip(pairs(told), distances))

    def move(self, start: ArrayLike, by: ArrayLike, about: tuple[float, float] = (0.0, 0.0)) -> Motion:
        """A motion of constant rates from `start` by the displacement `by`, up to its first contact. The point `about` of the moving part,
        in its frame, moves straight, and the part turns about it. Either may be an array of n, one goes with many: then the `Motion`
        is of arrays.

        >>> space.move([(0, 6, 0), (9, 6, 0)], (0, -8, 0)).outcome.tolist()
        ['contact', 'free']
        """
        (outcomes, fractions, places, gaps), (told, numbers), is_one = self._space._move(start, by, position("about", about))
        features = pairs(told)
        touching = [[features[k] for k in row] for row in numbers]
        if not is_one:
            return Motion(np.array(outcomes, dtype="U7"), fractions, places, touching, gaps)
        return Motion(outcomes[0], float(fractions[0]), tuple(places[0].tolist()), touching[0], _gap(gaps))

    def crossings(self, start: ArrayLike, by: ArrayLike) -> list[Crossing]:
        """Every contact that a motion of constant rates from `start` by the displacement `by` comes through, also where the parts
        overlap.

        >>> [crossing.fraction for crossing in space.crossings((0, 6, 0), (0, -12, 0))]  # doctest: +ELLIPSIS
        [0.333..., 0.666...]
        """
        return [Crossing(patch, t, tuple(at), enters) for patch, t, at, enters in _rust._crossings(self._space, start, by)]

    def play(self, q: ArrayLike) -> dict[str, Play]:
        """For each coordinate how far it goes when it alone changes, as a dictionary of `Play`; of many configurations each is of arrays.

        >>> space.play((0, 6, 0))["x"].length, space.play([(0, 6, 0), (0, 7, 0)])["y"].lower.tolist()
        (inf, [2.0, 2.0])
        """
        found, gaps, told, is_one = self._space._play(q)
        features = pairs(told)

        def names(row: list[int]) -> list[FeaturePair]:
            return [features[k] for k in row]

        plays = {}
        for name, ends, numbers in found:
            touching = [(names(low), names(high)) for low, high in numbers]
            if is_one:
                plays[name] = Play(name, float(ends[0, 0]), float(ends[0, 1]), touching[0], _gap(gaps))
            else:
                plays[name] = Play(name, ends[:, 0], ends[:, 1], touching, gaps)
        return plays

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

        >>> space.plan((-6, 0, 0), (6, 0, 0)).outcome
        'path'
        """
        if widest and clearance is not None:
            raise Error("`widest` and `clearance` are both given")
        least = None if clearance is None else number("clearance", clearance, 0.0)
        answer, rows = self._space._plan(start, goal, math.inf if widest else least, about, prefer)
        return Plan(answer, rows, self._places)

    def slice(self, theta: float) -> Loops:
        """The boundary of free space at an orientation, as loops of (x, y, bulge) with the blocked side on the left.

        >>> space.slice(0)
        Loops(1 loop, 10 vertices)
        """
        vertices, doubtful = self._space.slice(angle("theta", theta))
        loops = Loops(vertices)
        loops.doubtful = doubtful
        return loops

    def plot(self, theta: float = 0.0, at: Sequence[float] | None = None, ax: "Axes | None" = None) -> "Axes":
        """Draws the slice at an orientation with matplotlib, on axes `ax` or on the current ones, which are returned.

        The free side is left as it is, the blocked side is filled. With `at`, a position (x, y), the two parts are drawn there.

        >>> ax = space.plot(0.3, at=(0, 2))
        """
        if self.pair_class == "fixed-axes":
            raise Error(
                "two parts on axes have no slices in x and y: their space in u and v is written as a picture by the command, "
                "`space.save(\"space.json\")` and then `cspace slice space.json -o space.svg`"
            )
        ax = self.slice(theta).plot(ax, facecolor=_draw.BLOCKED, zorder=1)
        if at is not None:
            x, y = position("at", at)
            self.fixed.plot(ax, alpha=0.8, zorder=2)
            self.moving.outline.moved(x, y, theta).plot(ax, facecolor=_draw.MOVING, alpha=0.8, zorder=2)
            ax.plot([x], [y], color="black", marker="+", zorder=3)
        return ax

    def svg(self, theta: float = 0.0) -> str:
        """The slice at an orientation as SVG, as the command draws it; of two parts on axes the plane of their motions.

        >>> space.svg(0.3).startswith("<svg")
        True
        """
        return _rust._svg(self._space, angle("theta", theta))

    def _repr_svg_(self) -> str | None:
        if self.pair_class == "lower":
            return None
        return self.svg(0.0 if self.window is None else sum(self.window) / 2)

    def view(self, height: int = 640) -> Any:
        """The page of the command for this space, which needs no server, as a frame in a Jupyter notebook.

        >>> space.view()  # doctest: +SKIP
        """
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

    def widget(self) -> Any:
        """A view for notebooks: the slice at an orientation that a slider sets, and at the position that is clicked how the parts are and
        how far they go. It is computed here, and needs anywidget.

        >>> print(space.widget().told)
        x = 0, y = 0: blocked
        """
        return optional("cspace._widget", "anywidget").View(self)

    def mesh(self, tolerance: float = 1e-3) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """The contact surface as triangles: vertices n×3 (x, y, theta) on the surface, and faces m×3. `tolerance` is a share of the pair's
        size.

        >>> vertices, faces = space.mesh()
        >>> vertices.shape[1], faces.shape[1]
        (3, 3)
        """
        vertices, faces, _ = self._space.mesh(number("tolerance", tolerance))
        return vertices, faces

    def to_trimesh(self, tolerance: float = 1e-3) -> Any:
        """The contact surface as a trimesh.Trimesh in x, y and theta, with the vertices and faces of `mesh`.

        Its `face_attributes["patch"]` are the numbers of the patches that the faces are of.

        >>> space.to_trimesh().face_attributes["patch"].shape == (len(space.mesh()[1]),)
        True
        """
        trimesh = optional("trimesh")
        vertices, faces, patches = self._space.mesh(number("tolerance", tolerance))
        return trimesh.Trimesh(vertices, faces, face_attributes={"patch": patches}, process=False)

    def to_networkx(self) -> Any:
        """The patches and their links as a networkx.MultiDiGraph.

        Nodes are the numbers of the patches, with the fields of `Patch`. Edges go from the first patch of a link to the second, with the
        orientations `lo` and `hi` of the link.

        >>> space.to_networkx().number_of_nodes() == len(space.patches)
        True
        """
        graph = optional("networkx").MultiDiGraph()
        graph.add_nodes_from((i, dataclasses.asdict(patch)) for i, patch in enumerate(self.patches))
        links = (column.tolist() for column in self.links())
        graph.add_edges_from((first, second, {"lo": lo, "hi": hi}) for first, second, lo, hi in zip(*links))
        return graph

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the space as JSON, which the command reads in place of a model.

        >>> space.save("space.json")
        """
        text = self._space.to_json()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def __repr__(self) -> str:
        return repr(self._space)

    def __reduce__(self) -> Any:
        return _restored, (self.fixed, self.moving, self._space._relation(), self.window, self.unit)


def _patch(given: Any) -> int:
    """The number of a patch."""
    if isinstance(given, bool) or not hasattr(given, "__index__"):
        raise Error(f"`patch` is {given!r} where the number of a patch is expected")
    return min(max(given.__index__(), -1), 2**62)


def _gap(gaps: NDArray[np.float64]) -> float | None:
    """The gap that was taken for one configuration, or None."""
    return None if np.isnan(gaps[0]) else float(gaps[0])


def _restored(
    fixed: Part, moving: Part, relation: str, theta: tuple[float, float] | None, unit: str | None
) -> ContactSpace:
    """A space that was sent: its parts, of which it is computed when it is first asked."""
    return ContactSpace(_rust.ContactSpace._restored(fixed._part, moving._part, relation, theta, unit))


def compute(fixed: Part, moving: Part, theta: Sequence[float] | None = None) -> ContactSpace:
    """The configuration space of two parts that move freely in the plane; `theta` is a window of orientations (lo, hi), radians.

    >>> cs.compute(cs.Part.rectangle(4, 2), cs.Part.circle(1))
    ContactSpace("rectangle", "circle", symmetric, 32 patches, 1 free regions)
    """
    for name, part in (("fixed", fixed), ("moving", moving)):
        if not isinstance(part, Part):
            raise Error(f"`{name}` is {part!r}: give a Part")
    return ContactSpace(_rust.compute(fixed._part, moving._part, window(theta)))
