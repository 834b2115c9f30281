"""Configurations as arrays."""

import itertools
import math
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import Error


def rows(q: Any, width: int, names: str) -> tuple[NDArray[np.float64], bool]:
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
    if width == 3:
        far = np.abs(array[:, 2]) > 2 * math.tau
        if far.any():
            angle("theta", array[int(np.argmax(far)), 2])
    return array, single


def window(theta: Sequence[float] | None) -> tuple[float, float] | None:
    """A window of orientations: two numbers, or None."""
    if theta is None:
        return None
    try:
        lo, hi = (float(x) for x in theta)
    except (TypeError, ValueError):
        raise Error(f"`theta` is {theta!r}: give two orientations (lo, hi) in radians") from None
    return lo, hi


def number(name: str, value: Any, least: float = -np.inf, most: float = np.inf) -> float:
    """A finite number, at least `least` and at most `most`."""
    try:
        # A text is none, though Python reads it.
        found = math.nan if isinstance(value, (str, bytes)) else float(value)
    except (TypeError, ValueError, OverflowError):
        raise Error(f"`{name}` is {value!r} where a number is expected") from None
    if not np.isfinite(found) or not least <= found <= most:
        bounds = "" if least == -np.inf else f" of {least:g} or more" if most == np.inf else f" from {least:g} to {most:g}"
        raise Error(f"`{name}` is {value!r} where a finite number{bounds} is expected")
    return found


def angle(name: str, value: Any) -> float:
    """An orientation in radians; one of more than two turns may be meant in degrees, which is said."""
    found = number(name, value)
    if abs(found) > 2 * math.tau:
        warnings.warn(
            f"`{name}` is {found:g}, which is more than two turns: orientations are in radians (math.radians makes them of degrees)",
            stacklevel=3,
        )
    return found


def position(name: str, place: Any) -> tuple[float, float]:
    """A position: two finite numbers."""
    x, y = _coordinates(name, place, "a position (x, y)", 2)
    return x, y


def configuration(name: str, at: Any) -> tuple[float, float, float]:
    """A configuration in the plane: three finite numbers."""
    x, y, theta = _coordinates(name, at, "a configuration (x, y, theta)", 3)
    return x, y, theta


def given(name: str, at: Any) -> list[float] | None:
    """A configuration or displacement of a pair, of two or three finite numbers, or None."""
    if at is None:
        return None
    try:
        count = len(at)
    except TypeError:
        count = 3
    forms = "one configuration (x, y, theta), or (u, v) of parts on axes"
    return _coordinates(name, at, forms, 2 if count == 2 else 3)


def pair_names(pair: Any) -> str | None:
    """The names of the fixed and of the moving part with a comma between, of a text of that form or of two names."""
    if pair is None or isinstance(pair, str):
        return pair
    if isinstance(pair, (list, tuple)) and len(pair) == 2 and all(isinstance(name, str) for name in pair):
        return ",".join(pair)
    raise Error(f'`pair` is {pair!r}: give the names of the fixed and of the moving part, such as ("plate", "pin")')


def _coordinates(name: str, given: Any, form: str, count: int) -> list[float]:
    try:
        found = [float(coordinate) for coordinate in given]
    except (TypeError, ValueError):
        found = []
    if len(found) != count:
        raise Error(f"`{name}` is {given!r}: give {form}")
    if not np.isfinite(found).all():
        raise Error(f"`{name}` is {given!r}, which is not finite")
    return found


def column(name: str, values: Any) -> NDArray[np.float64]:
    """Numbers that a parameter or coordinate takes."""
    try:
        return np.atleast_1d(np.asarray(values, dtype=np.float64))
    except (TypeError, ValueError) as error:
        raise Error(f"the values of {name} are no numbers: {error}") from None


def named(name: str, given: Mapping[str, Any] | None, keywords: Mapping[str, Any]) -> dict[str, Any]:
    """What is given by name in a dictionary, for any name, and as keyword arguments, for names that no argument has."""
    if given is None:
        return dict(keywords)
    if not (isinstance(given, Mapping) and all(isinstance(key, str) for key in given)):
        raise Error(f"`{name}` is {given!r}: give a dictionary by name, such as {{'{name}': 1}} for what is called {name}")
    twice = sorted(given.keys() & keywords.keys())
    if twice:
        raise Error(f"{twice[0]} is given twice: in `{name}` and by itself")
    return {**given, **keywords}


def table(rows: Mapping[str, Any] | None, values: Mapping[str, Any]) -> tuple[list[str], list[tuple[Any, ...]]]:
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
