"""How dimensions vary, for `cspace.monte_carlo`.

>>> cs.distributions.normal(10, 0.02).draw(np.random.default_rng(1), 2).round(3).tolist()
[10.007, 10.016]
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._arrays import number
from ._errors import Error


@dataclass(frozen=True)
class Distribution:
    """How a number varies: made by `normal`, `uniform` or `triangular`.

    >>> cs.distributions.uniform(0, 1)
    Distribution(kind='uniform', parameters=(0.0, 1.0))
    """

    kind: str
    parameters: tuple[float, ...]

    def draw(self, rng: np.random.Generator, count: int) -> NDArray[np.float64]:
        """So many numbers, as an array.

        >>> cs.distributions.uniform(2, 3).draw(np.random.default_rng(1), 5).shape
        (5,)
        """
        return np.asarray(getattr(rng, self.kind)(*self.parameters, size=count))


def normal(mean: float, sigma: float) -> Distribution:
    """A normal distribution with the standard deviation `sigma`.

    >>> cs.distributions.normal(10, 0.02).kind
    'normal'
    """
    return Distribution("normal", (number("mean", mean), number("sigma", sigma, 0.0)))


def uniform(lo: float, hi: float) -> Distribution:
    """All numbers from `lo` to `hi` alike.

    >>> cs.distributions.uniform(9.98, 10.02).parameters
    (9.98, 10.02)
    """
    lo, hi = number("lo", lo), number("hi", hi)
    if not lo <= hi:
        raise Error(f"`lo` is {lo!r} and `hi` is {hi!r}: the range is empty")
    return Distribution("uniform", (lo, hi))


def triangular(lo: float, mode: float, hi: float) -> Distribution:
    """Numbers from `lo` to `hi`, most often near `mode`.

    >>> cs.distributions.triangular(9.98, 10, 10.05).parameters
    (9.98, 10.0, 10.05)
    """
    lo, mode, hi = number("lo", lo), number("mode", mode), number("hi", hi)
    if not (lo <= mode <= hi and lo < hi):
        raise Error(f"{lo!r}, {mode!r} and {hi!r} are not in ascending order")
    return Distribution("triangular", (lo, mode, hi))
