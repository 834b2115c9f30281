"""Exact configuration spaces of planar parts with curved boundaries.

>>> import cspace as cs
>>> box = cs.Part([[(0, 0), (10, 0), (10, 10), (0, 10)]], name="box")
>>> coin = cs.Part.circle(1)
>>> space = cs.compute(box, coin)
>>> space.classify([[5, 5, 0], [-1, 5, 0], [-3, 5, 0]]).tolist()
[1, 2, 0]

Configurations are (x, y, theta) of the moving part in the fixed part's frame, or (u, v) of two parts on axes. Angles are in radians, lengths
in the unit of the drawing.
"""

from . import _rust, answers, distributions
from ._classes import Class
from ._errors import Error, InternalError
from ._features import Feature, FeaturePair
from ._fit import Fit, Place, fit, write_dxf
from ._loops import Loops
from ._model import Model
from ._nest import inner_fit, nfp, separation
from ._part import Part
from ._progress import progress
from ._record import Record
from ._results import (
    Check,
    ContactFunction,
    Crossing,
    Escape,
    Motion,
    Nearest,
    Patch,
    Plan,
    Play,
    Region,
    Simulation,
    Table,
    Tolerances,
)
from ._rust import VERSION as __version__
from ._space import ContactSpace, compute
from ._sweep import monte_carlo, sweep

FREE, BLOCKED, CONTACT = Class

__all__ = [
    "BLOCKED",
    "CONTACT",
    "Check",
    "Class",
    "ContactFunction",
    "ContactSpace",
    "Crossing",
    "Error",
    "Escape",
    "FREE",
    "Feature",
    "FeaturePair",
    "Fit",
    "InternalError",
    "Loops",
    "Model",
    "Motion",
    "Nearest",
    "Part",
    "Patch",
    "Place",
    "Plan",
    "Play",
    "Record",
    "Region",
    "Simulation",
    "Table",
    "Tolerances",
    "__version__",
    "answers",
    "compute",
    "distributions",
    "fit",
    "inner_fit",
    "monte_carlo",
    "nfp",
    "progress",
    "separation",
    "set_threads",
    "simulate",
    "sweep",
    "write_dxf",
]


def set_threads(threads: int) -> None:
    """Uses so many threads from now on, at most 1024; 0 for one per processor. Results do not depend on it.

    >>> cs.set_threads(2)
    """
    if not (isinstance(threads, int) and 0 <= threads <= 1024):
        raise Error(f"`threads` is {threads!r} where a whole number from 0 to 1024 is expected")
    _rust.set_threads(threads)


def simulate(model: Model, time: float, every: float | None = None) -> Simulation:
    """The motion of a model's mechanism over `time` seconds: see `Model.simulate`.

    >>> cs.simulate(model, 1.0).outcome
    'done'
    """
    return model.simulate(time, every)
