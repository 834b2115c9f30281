"""The compiled module. Written by stubs.py."""

from typing import Any


class ContactSpace:
    """The configuration space of two parts: where the moving one is free, blocked or in contact."""

    def _features_within(self, q: Any, within: Any) -> Any:
        """The features that touch, or are no farther than `within` apart: pairs of features, and of each its number and the distance."""

    @staticmethod
    def _loaded(text: Any, file: Any) -> Any:
        """The space in a text that was saved; `file` is its name in errors."""

    def _move(self, start: Any, by: Any, about: Any) -> Any:
        """Motions of constant rates from `start` by the displacements `by`, of which one may go with many: arrays of what becomes of them, how
        much of it is done, where they end, and the gaps that were taken, nan without; pairs of features, and the numbers of those that touch
        there. And whether one was asked about."""

    def _nearest(self, q: Any, length_per_radian: Any, patch: Any) -> Any:
        """The nearest configurations in contact, of a patch or of any, at the same orientation or with a radian that counts as a length:
        arrays of the patches, -1 where there is none, of the configurations, and how far they are. And whether one was asked about."""

    def _patches(self) -> Any:
        """The contact patches: pairs of features, and for each patch the number of its pair, the region and the orientations it bounds, if
        any."""

    def _plan(self, start: Any, goal: Any = None, clearance: Any = None, about: Any = None, prefer: Any = 'legs') -> Any:
        """A path from `start` to `goal` through free space, or out where there is none, or that there is none: the answer, and the rows of the
        path. An infinite clearance asks for the widest path."""

    def _play(self, q: Any) -> Any:
        """For each coordinate how far it goes down and up from free configurations when it alone changes, infinite where nothing stops it, nan
        where of many one is not free, as arrays n×2, and for each row the numbers of the pairs that touch at the two ends. With the gaps
        that were taken, nan without, the pairs of features, and whether one was asked about."""

    def _poses(self, q: Any) -> Any:
        """Where the fixed and the moving part are at configurations: rows (x, y, theta) for each."""

    def _regions(self) -> Any:
        """The free regions: for each a free configuration, and whether it is caged, that is, ends everywhere."""

    def _relation(self) -> Any: ...

    @staticmethod
    def _restored(fixed: Any, moving: Any, relation: Any, window: Any, unit: Any) -> Any:
        """The pair of a sent space, which computes it when it is first asked."""

    def classify(self, q: Any) -> Any:
        """0 where the configuration is free, 1 where the parts overlap, 2 in contact: an integer for one configuration, an array of uint8 for
        rows."""

    def clearance(self, q: Any) -> Any:
        """The smallest distance of the parts: 0 in contact, nan where they overlap."""

    def contacts(self, q: Any, tolerance: Any = None) -> Any:
        """The patches no farther than `tolerance` from configurations: of one their numbers and distances, of many arrays of the rows, the
        numbers and the distances."""

    @property
    def fixed(self) -> Any:
        """The fixed part."""

    def links(self) -> Any:
        """Links between patches as arrays: first patch, second patch, and the smallest and largest orientation of the link (nan on fixed
        axes)."""

    def mesh(self, tolerance: Any = 0.001) -> Any:
        """The contact surface as triangles: vertices n×3 (x, y, theta), faces m×3, and the patch of each face."""

    @property
    def moving(self) -> Any:
        """The moving part."""

    @property
    def pair_class(self) -> Any:
        """The class of the pair: lower, fixed-axes, symmetric or general."""

    def region(self, q: Any) -> Any:
        """The number of the free region; where the configuration is not free None of one, and -1 of many."""

    @property
    def resolution(self) -> Any:
        """Contacts are known to this, a length."""

    def slice(self, theta: Any) -> Any:
        """The boundary of free space at an orientation, as loops of (x, y, bulge), and whether it is in doubt."""

    def to_json(self) -> Any:
        """The space as the JSON that the command saves and reads."""

    @property
    def unit(self) -> Any:
        """The label of the unit of length, if the model has one."""

    @property
    def window(self) -> Any: ...


class Fit:
    """A part, and what it is to be placed among."""

    @staticmethod
    def _of(container: Any, placed: Any, part: Any, moving: Any, window: Any, orientations: Any) -> Any:
        """The part `moving` is `part`, or that grown by a spacing."""

    def fits(self) -> Any:
        """Whether the part fits somewhere."""

    def lowest(self, direction: Any, about: Any = None) -> Any:
        """The place at which a point of the part is farthest in a direction: the centroid without one."""

    def space(self) -> Any:
        """The space of the walls and the part; none of single orientations."""

    def tightest(self) -> Any:
        """The place at which most of the outline lies flush."""


class Model:
    """A model of parts, with values for its parameters."""

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Call self as a function."""

    def _ask(self, kind: Any, arguments: Any) -> Any:
        """The answer to a question of this kind, as what the command prints as JSON."""

    def _is_on_axis(self, part: Any) -> Any:
        """The axis of a part, if it moves on one or not at all."""

    @staticmethod
    def _load(path: Any) -> Any:
        """The model in a file: .toml or .json."""

    @staticmethod
    def _loads(text: Any, path: Any, set: Any, of_values: Any) -> Any:
        """The model in a text, TOML unless the extension of `path` is .json; errors in one that was written for values name no place in it."""

    def _plan(self, arguments: Any) -> Any:
        """The answer to the question for a path of a pair, and the rows of the path."""

    def _poses(self, part: Any, coordinates: Any) -> Any:
        """Where a part on an axis is for its coordinates: rows (x, y, theta)."""

    def _source(self) -> Any:
        """The source of the model: the text, the path, the values that are set, and whether the text was written for values."""

    def compute(self, fixed: Any = None, moving: Any = None, theta: Any = None) -> Any:
        """The configuration space of two parts, by name; of the only pair without names. `theta` is a window of orientations."""

    @property
    def name(self) -> Any:
        """The name."""

    @property
    def pairs(self) -> Any:
        """The pairs: names of the fixed and of the moving part."""

    @property
    def parameters(self) -> Any:
        """The values of the parameters by name; angles in radians."""

    @property
    def parts(self) -> Any:
        """The parts by name."""

    @property
    def requirements(self) -> Any:
        """The names of the requirements."""

    @property
    def unit(self) -> Any:
        """The unit of length, if the model says one."""


class Part:
    """A rigid part: closed loops of line segments and circular arcs."""

    def _feature(self, name: Any) -> Any:
        """A feature by its name: the name, the kind, and the numbers of its loop and in it."""

    @staticmethod
    def _from_json(text: Any) -> Any:
        """The part in a model's JSON, of which it is the only one."""

    def _points(self, tolerance: Any) -> Any:
        """The outline in points no farther than `tolerance` from it: for each loop a list of (x, y)."""

    @staticmethod
    def _received(text: Any) -> Any:
        """The part that was sent."""

    def _redrawn(self, loops: Any) -> Any:
        """The part with its vertices elsewhere: as many loops of as many, whose features keep their names."""

    def _sent(self) -> Any:
        """The part as it is sent, with its heights and the names of its features."""

    @property
    def area(self) -> Any:
        """The area."""

    @property
    def bounds(self) -> Any:
        """The smallest and the largest x and y: (x, y, x, y)."""

    @property
    def centroid(self) -> Any:
        """The centroid of the area: (x, y)."""

    def contains(self, x: Any, y: Any) -> Any:
        """Whether a point is in the part or on its outline."""

    @property
    def layers(self) -> Any:
        """The layers: for each its heights (lowest, highest), or None at every height, and its loops."""

    @property
    def loops(self) -> Any:
        """The loops as lists of vertices (x, y, bulge): outer ones counter-clockwise, holes clockwise. The bulge is that of the edge to
        the next vertex, tan of a quarter of the angle it turns by, positive to the left and 0 of a line."""

    @property
    def name(self) -> Any:
        """The name."""


VERSION: str


def _bands(space: Any) -> Any:
    """The bands: the orientations between which nothing but lengths changes."""


def _beside(placed: Any, moving: Any, thetas: Any) -> Any:
    """Beside parts, each placed by a configuration, for every orientation."""


def _connected(space: Any, start: Any, goal: Any) -> Any:
    """Whether two configurations are free and in one region; `goal` is one configuration."""


def _crossings(space: Any, start: Any, by: Any) -> Any:
    """The contacts that a motion of constant rates from `start` by `by` comes through: for each its patch, the fraction of the displacement,
    the configuration, and whether it goes into blocked space there."""


def _dxf(placed: Any, unit: Any = None) -> Any:
    """The text of a DXF file with parts, each placed by a configuration and on a layer of its own."""


def _ends(space: Any, patch: Any, thetas: Any) -> Any:
    """Where a patch begins and ends at orientations: two arrays n×2 of positions, nan where it does not exist."""


def _evaluate(space: Any, patch: Any, q: Any) -> Any:
    """The contact function of a patch at configurations: value, gradient and Hessian by the coordinates."""


def _measures(space: Any) -> Any:
    """How many features the parts have, below which clearance there is none, and how near to a contact is in contact."""


def _of_wires(wires: Any, places: Any, join: Any, tol: Any, name: Any) -> Any:
    """The part of wires, whose ends within `join` of each other are one, and the largest distance of its lines and arcs from the curves
    that they are fitted to within `tol`, and from `places`."""


def _require_page() -> Any:
    """Raises an error that says how to get the page of the command, if this package was built without it."""


def _separation(fixed: Any, moving: Any, at: Any) -> Any:
    """The shortest translation that separates two parts."""


def _svg(space: Any, theta: Any) -> Any:
    """A slice at an orientation, or the plane of two motions, as SVG."""


def _within(container: Any, moving: Any, thetas: Any) -> Any:
    """Within a part, for every orientation."""


def command(arguments: Any) -> Any:
    """Runs the command with its arguments, of which the first is its name, and returns its exit code."""


def compute(fixed: Any, moving: Any, theta: Any = None) -> Any:
    """The configuration space of two parts that move freely in the plane; `theta` is a window of orientations."""


def set_threads(threads: Any) -> Any:
    """Uses so many threads from now on; 0 for one per processor. Results do not depend on it."""
