"""Configurations as arrays."""

import numpy as np

from ._errors import Error


def rows(q, width, names):
    """The configurations in `q` as n×width float64, and whether they are one that is not in a list."""
    try:
        array = np.asarray(q, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"`q` is no array of numbers: {error}") from None
    single = array.ndim == 1
    if array.ndim not in (1, 2) or array.shape[-1] != width:
        shape = "×".join(map(str, array.shape)) or "a number"
        raise Error(
            f"`q` has the shape {shape}: give one configuration ({names}) or an array n×{width} of them"
        )
    array = np.ascontiguousarray(array)
    if single:
        array = array.reshape(1, width)
    return array, single
