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

from ._errors import Error, InternalError
from ._results import (
    Check,
    Contact,
    Crossing,
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
from ._loops import Loops
from ._model import Model
from ._nest import inner_fit, least_separation, nfp
from ._part import Part
from ._record import Record
from . import _rust, answers
from ._rust import VERSION as __version__
from ._space import ContactSpace, compute
from ._sweep import monte_carlo, normal, sweep, triangular, uniform

FREE, BLOCKED, CONTACT = 0, 1, 2

__all__ = [
    "BLOCKED",
    "CONTACT",
    "Check",
    "Contact",
    "ContactSpace",
    "Crossing",
    "Error",
    "FREE",
    "InternalError",
    "Loops",
    "Model",
    "Motion",
    "Nearest",
    "Part",
    "Patch",
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
    "inner_fit",
    "least_separation",
    "monte_carlo",
    "nfp",
    "normal",
    "set_threads",
    "simulate",
    "sweep",
    "triangular",
    "uniform",
]


def set_threads(threads: int) -> None:
    """Uses so many threads from now on, at most 1024; 0 for one per processor. Results do not depend on it."""
    if not (isinstance(threads, int) and 0 <= threads <= 1024):
        raise Error(f"`threads` is {threads!r} where a whole number from 0 to 1024 is expected")
    _rust.set_threads(threads)


def simulate(model: Model, time: float, every: float | None = None) -> Simulation:
    """The motion of a model's mechanism over `time` seconds: see `Model.simulate`."""
    return model.simulate(time, every)
