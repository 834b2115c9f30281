"""Answers as records."""

import copy
import dataclasses
import math
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ._errors import Error
from ._optional import optional

# The keys of answers that have rows, those first that tell most.
_ROWS = ("requirements", "rows", "solutions", "samples", "modes", "pairs", "parts")


class Fields:
    """What a space answers: a record of named fields. Of many configurations each field has as many values."""

    def to_dict(self) -> dict[str, Any]:
        """The fields as dictionaries, lists, numbers and texts, for `json.dumps`; what is not finite is None.

        >>> space.move((0, 6, 0), (0, 1, 0)).to_dict()
        {'outcome': 'free', 'fraction': 1.0, 'at': [0.0, 7.0, 0.0], 'touching': [], 'gap': None}
        """
        names = (field.name for field in dataclasses.fields(self))  # type: ignore[arg-type]
        return {name: _finite(plain(getattr(self, name))) for name in names}


class Record(dict[str, Any]):
    """An answer: a dictionary with the keys of the command's JSON, which are attributes, too. What an answer may leave out is None as an
    attribute. Configurations are arrays (x, y, theta) or (u, v), paths are arrays of them as rows. `units` tells the units.

    >>> answer = model.clearance()
    >>> answer.outcome, answer.units.length, answer["pairs"][0].outcome
    ('touches', 'mm', 'touches')
    """

    _read: ClassVar[dict[str, Callable[[Any], Any]]] = {}

    def __init__(self, values: Any = ()) -> None:
        super().__init__(values)
        for key, read in self._read.items():
            if key in self:
                self[key] = _each(read, self[key])

    def __getattr__(self, name: str) -> Any:
        if name in self:
            return self[name]
        if any(name in vars(of).get("__annotations__", ()) for of in type(self).__mro__):
            return None
        raise AttributeError(f"{type(self).__name__} has no {name!r}: it has {', '.join(self)}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"an answer is what it is: {type(self).__name__} takes no {name!r}")

    def copy(self) -> "Record":
        """Another record with the same values.

        >>> model.info().copy() == model.info()
        True
        """
        return copy.copy(self)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({super().__repr__()})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, dict) and plain(self) == plain(other)

    __hash__ = None  # type: ignore[assignment]

    def to_dict(self) -> dict[str, Any]:
        """The command's JSON: dictionaries, lists, numbers and texts, for `json.dumps`.

        >>> model.info().to_dict()["units"]["length"]
        'mm'
        """
        read = self._read
        return {key: _coordinates(one) if read.get(key) is configuration else plain(one) for key, one in self.items()}

    def to_dataframe(self, rows: str | None = None) -> Any:
        """The rows of the answer as a pandas.DataFrame: what it has of each requirement, pair or part, or the list under the key `rows`.

        >>> model.check().to_dataframe()[["name", "met"]].values.tolist()
        [['backlash', True]]
        """
        lists = [key for key, value in self.items() if isinstance(value, list)]
        found = next((key for key in ([rows] if rows else _ROWS) if key in lists), None)
        if found is None:
            raise Error(f"the answer has no rows{f' {rows!r}' if rows else ''}; its lists are: {', '.join(lists) or 'none'}")
        return optional("pandas").json_normalize(plain(self[found]))


class OfPair(Record):
    """An answer about one pair, whose keys are those of the answer, too."""

    def __missing__(self, key: str) -> Any:
        return super().__getitem__("pairs")[0][key]

    def __getattr__(self, name: str) -> Any:
        try:
            return super().__getattr__(name)
        except AttributeError:
            if name.startswith("__"):
                raise
            return getattr(super().__getitem__("pairs")[0], name)


class ByName(Record):
    """An answer about requirements: `answer["tilt"]` is what concerns the requirement of that name."""

    def __missing__(self, name: str) -> Any:
        rows = super().__getitem__("requirements")
        names = [row.get("name", row.get("requirement")) for row in rows]
        if name not in names:
            raise Error(f"there is no requirement {name!r} in the answer: there are {', '.join(names)}")
        return rows[names.index(name)]


def _each(read: Callable[[Any], Any], value: Any) -> Any:
    """What is read of a value, or of every value of a list."""
    if not isinstance(value, (list, tuple)):
        return value if value is None else read(value)
    rows = [_each(read, one) for one in value]
    # Configurations are rows.
    if rows and all(isinstance(row, np.ndarray) and row.ndim == 1 for row in rows):
        return np.array(rows)
    return rows


def plain(value: Any) -> Any:
    """A value without records, tuples, arrays and loops."""
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, dict):
        return {key: plain(one) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value.tolist() if hasattr(value, "tolist") else value


def _finite(value: Any) -> Any:
    """A plain value with None for numbers that are not finite, which JSON has no words for."""
    if isinstance(value, list):
        return [_finite(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _coordinates(value: Any) -> Any:
    """A configuration, or rows of them, as in JSON."""
    if value is None or (isinstance(value, list) and not value):
        return value
    if value.ndim == 2:
        return [_coordinates(row) for row in value]
    return dict(zip(("u", "v") if len(value) == 2 else ("x", "y", "theta"), value.tolist()))


def configuration(value: dict[str, float]) -> NDArray[np.float64]:
    """A configuration as an array (x, y, theta) or (u, v)."""
    return np.array([value[key] for key in (("u", "v") if "u" in value else ("x", "y", "theta"))])


def number_or_configuration(value: Any) -> Any:
    """A number as it is, and a configuration as an array."""
    return configuration(value) if isinstance(value, dict) else value


def each_of(read: Callable[[Any], Any]) -> Callable[[dict[str, Any]], dict[str, Any]]:
    """Reads a dictionary of records by name."""
    return lambda values: {key: _each(read, value) for key, value in values.items()}
