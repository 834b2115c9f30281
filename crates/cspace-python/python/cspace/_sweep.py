"""Any function over many values, here or on a cluster."""

import os
import pickle
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from ._arrays import table as _table
from ._errors import Error
from ._results import Table

# Rows that are sent to a worker together.
_TOGETHER = 64


@lru_cache(maxsize=4)
def _function(sent: bytes) -> Callable[..., Any]:
    """The function that was sent, read once in each worker."""
    function: Callable[..., Any] = pickle.loads(sent)
    return function


def _numbers(answer: Any) -> dict[str, float]:
    """What a function returns, as numbers by name."""
    record = answer if isinstance(answer, dict) else {"value": answer}
    return {str(key): float(value) for key, value in record.items()}


def _answers(
    function: Callable[..., Any], names: list[str], rows: list[tuple[Any, ...]]
) -> list[dict[str, float] | str]:
    """The answers of a function to some rows: numbers by name, or an error's text."""
    answers: list[dict[str, float] | str] = []
    for row in rows:
        try:
            answers.append(_numbers(function(**dict(zip(names, row)))))
        except Exception as error:  # noqa: BLE001  A failure is a record.
            answers.append(f"{type(error).__name__}: {error}")
    return answers


def _block(task: Any) -> tuple[int, list[dict[str, float] | str]]:
    """The number of a block and its answers, in a worker."""
    number, process, sent, names, rows = task
    if os.getpid() != process:
        # One thread a worker: workers are as many as processors.
        os.environ.setdefault("CSPACE_NUM_THREADS", "1")
    return number, _answers(_function(sent), names, rows)


def sweep(
    function: Callable[..., Any],
    map: Callable[..., Iterable[Any]] | None = None,
    rows: Mapping[str, Any] | None = None,
    **values: Any,
) -> Table:
    """`function(**row)` for every combination of `values`, the last changing first, or for `rows`, a dictionary of columns.

    `map` is any map(function, iterable): that of an executor of processes, of Dask (`client.get_executor().map`), of Ray
    (`ray.util.multiprocessing.Pool().map`); the built-in one without. The function is sent once with each block of rows, and kept by the
    workers. What it returns is a number, or a dictionary of numbers; what it raises is told in `failures`.

    >>> sweep(lambda a, b: a * b, a=[1, 2], b=[3, 4])["value"].tolist()
    [3.0, 4.0, 6.0, 8.0]
    """
    names, table = _table(rows, values)
    if map is None:
        answers = _answers(function, names, table)
    else:
        sent, process = pickle.dumps(function), os.getpid()
        blocks = range(0, len(table), _TOGETHER)
        tasks = [(i, process, sent, names, table[i : i + _TOGETHER]) for i in blocks]
        # Maps that do not keep the order are put in order.
        found = sorted(map(_block, tasks), key=lambda block: block[0])
        answers = [answer for _, block in found for answer in block]
    columns = {name: np.array([row[k] for row in table]) for k, name in enumerate(names)}
    failures = [(i, None, answer) for i, answer in enumerate(answers) if isinstance(answer, str)]
    records = [{} if isinstance(answer, str) else answer for answer in answers]
    for key in dict.fromkeys(key for record in records for key in record):
        if key in names:
            raise Error(f"the function returns {key!r}, which is also an argument")
        columns[key] = np.array([record.get(key, np.nan) for record in records])
    return Table(columns, failures)
