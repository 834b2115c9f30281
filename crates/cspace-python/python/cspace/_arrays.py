"""Configurations as arrays."""

import itertools

import numpy as np

from ._errors import Error


def rows(q, width, names):
    """The configurations in `q` as n×width float64, and whether they are one that is not in a list."""
    try:
        array = np.asarray(q)
        # Whole and real numbers, and lists of Python's.
        if array.dtype.kind not in "buifO" or np.ma.is_masked(q):
            raise TypeError(f"it holds {array.dtype}" if not np.ma.is_masked(q) else "some of them are masked")
        array = array.astype(np.float64, copy=False)
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


def window(theta):
    """A window of orientations: two numbers, or None."""
    if theta is None:
        return None
    try:
        lo, hi = (float(x) for x in theta)
    except (TypeError, ValueError):
        raise Error(f"`theta` is {theta!r}: give two orientations (lo, hi) in radians") from None
    return lo, hi


def column(name, values):
    """Numbers that a parameter or coordinate takes."""
    try:
        return np.atleast_1d(np.asarray(values, dtype=np.float64))
    except (TypeError, ValueError) as error:
        raise Error(f"the values of {name} are no numbers: {error}") from None


def table(rows, values):
    """Names and rows of what is varied: every combination of `values`, the last changing first, or the columns of `rows`."""
    if rows is not None and values:
        raise Error("`rows` and single values are both given")
    columns = {name: np.atleast_1d(v).tolist() for name, v in (values if rows is None else rows).items()}
    if not columns:
        raise Error("nothing is varied: give values, such as play=[0.1, 0.2]")
    if rows is None:
        return list(columns), list(itertools.product(*columns.values()))
    if len({len(column) for column in columns.values()}) > 1:
        raise Error("the columns of `rows` have different lengths")
    return list(columns), list(zip(*columns.values()))
