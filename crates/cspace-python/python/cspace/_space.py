"""Configuration spaces."""

from . import _rust
from ._arrays import window
from ._errors import Error
from ._part import Part
from ._results import Motion, Nearest, Patch, Plan, Play, Region


class ContactSpace:
    """The configuration space of two parts: where the moving one is free, blocked or in contact.

    Configurations are (x, y, theta) of the moving part in the fixed part's frame, or (u, v) of two parts on axes; `q` is one of them, as a
    list, tuple or array, or an array n×3 or n×2 of many. One gives a number, many give an array.
    """

    __slots__ = ("_space",)

    def __init__(self, space):
        self._space = space

    def classify(self, q):
        """0 (`cspace.FREE`) where the configuration is free, 1 (`BLOCKED`) where the parts overlap, 2 (`CONTACT`) in contact: an integer for
        one, an array of uint8 for many."""
        return self._space.classify(q)

    def clearance(self, q):
        """The smallest distance of the parts, a length: 0 in contact, nan where they overlap."""
        return self._space.clearance(q)

    def region(self, q):
        """The number of the free region, as in `regions`; -1 where the configuration is not free."""
        return self._space.region(q)

    @property
    def fixed(self):
        """The fixed part."""
        return Part._of(self._space.fixed)

    @property
    def moving(self):
        """The moving part."""
        return Part._of(self._space.moving)

    @property
    def window(self):
        """The orientations for which it is computed, radians; None for a full turn."""
        return self._space.window

    @property
    def pair_class(self):
        """The class of the pair: "lower", "fixed-axes", "symmetric" or "general"."""
        return self._space.pair_class

    @property
    def resolution(self):
        """Contacts are known to this, a length."""
        return self._space.resolution

    @property
    def regions(self):
        """The free regions, by their numbers."""
        return [Region(tuple(sample), caged) for sample, caged in self._space._regions()]

    @property
    def patches(self):
        """The contact patches, by their numbers."""
        return [Patch(*patch) for patch in self._space._patches()]

    def links(self):
        """Links between patches as four arrays: first patch, second patch, and the smallest and largest orientation at which they meet;
        nan on fixed axes."""
        return self._space.links()

    def contacts(self, q, tolerance=None):
        """The patches no farther than `tolerance` from one configuration, with the distances; within the resolution without."""
        return self._space.contacts(q, tolerance)

    def nearest(self, q):
        """The nearest configuration in contact, or None where there is no contact at all."""
        found = self._space._nearest(q)
        return found and Nearest(found[0], tuple(found[1]), found[2])

    def near_features(self, q, within):
        """The pairs of features no farther than `within` apart at one configuration: their names on the fixed and the moving part, and
        their distance, negative where they overlap."""
        return self._space.near_features(q, within)

    def move(self, start, by):
        """A motion of constant rates from `start` by the displacement `by`, up to its first contact."""
        result, fraction, at, touching = self._space._move(start, by)
        return Motion(result, fraction, tuple(at), touching)

    def play(self, q):
        """For each coordinate how far it goes when it alone changes, as a dictionary of `Play`."""
        return {
            name: Play(name, lower, upper, tuple(touching))
            for name, (lower, upper), touching in self._space._play(q)
        }

    def plan(self, start, goal, widest=False, clearance=None):
        """A path from `start` to `goal` through free space, or the proof that there is none.

        With `widest` no other path has more clearance; with `clearance` it has at least so much.
        """
        return Plan(**self._space._plan(start, goal, widest, clearance))

    def slice(self, theta):
        """The boundary of free space at an orientation, as loops of (x, y, bulge)."""
        return self._space.slice(theta)

    def mesh(self, tolerance=1e-3):
        """The contact surface as triangles: vertices n×3 (x, y, theta) on the surface, and faces m×3. `tolerance` is a share of the pair's
        size."""
        vertices, faces, _ = self._space.mesh(tolerance)
        return vertices, faces

    def save(self, path):
        """Writes the space as JSON, which the command reads in place of a model."""
        text = self._space.to_json()
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def __repr__(self):
        return repr(self._space)

    def __reduce__(self):
        return _restored, (self.fixed, self.moving, self._space._relation(), self.window, _rust.VERSION)


def _restored(fixed, moving, relation, theta, _version):
    """A space that was sent: its parts, of which it is computed when it is first asked."""
    return ContactSpace(_rust.ContactSpace._restored(fixed._part, moving._part, relation, theta))


def compute(fixed, moving, theta=None):
    """The configuration space of two parts that move freely in the plane; `theta` is a window of orientations (lo, hi), radians."""
    for name, part in (("fixed", fixed), ("moving", moving)):
        if not isinstance(part, Part):
            raise Error(f"`{name}` is {part!r}: give a Part")
    return ContactSpace(_rust.compute(fixed._part, moving._part, window(theta)))
