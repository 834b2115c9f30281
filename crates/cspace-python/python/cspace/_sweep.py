"""Any function over many values, here or on a cluster."""

import builtins
import importlib
import inspect
import os
import pickle
import sys
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from ._arrays import named, number
from ._arrays import table as _table
from ._errors import Error
from ._results import Table
from .distributions import Distribution

# Rows that are sent to a worker together.
_TOGETHER = 64


@lru_cache(maxsize=4)
def _function(sent: bytes) -> Callable[..., Any]:
    """The function that was sent, read once in each worker."""
    function: Callable[..., Any] = pickle.loads(sent)
    return function


def _pickler() -> Any:
    """Cloudpickle where it is installed, or comes with a package that is in use; else pickle. It sends functions without a name, and those of a
    notebook or a program itself, which workers cannot import."""
    for name in ("cloudpickle", "joblib.externals.cloudpickle", "ray.cloudpickle"):
        package = name.partition(".")[0]
        if package in ("cloudpickle", *sys.modules):
            try:
                return importlib.import_module(name)
            except ImportError:
                continue
    return pickle


def _sent(function: Callable[..., Any]) -> bytes:
    """A function as workers receive it."""
    try:
        sent: bytes = _pickler().dumps(function)
    except (AttributeError, TypeError, pickle.PicklingError) as error:
        raise Error(
            f"`function` cannot be sent to workers ({error}): define it with a name in a module, or install cloudpickle"
        ) from None
    return sent


def _numbers(answer: Any) -> dict[str, float]:
    """What a function returns, as numbers by name."""
    record = answer if isinstance(answer, dict) else {"value": answer}
    for key, value in record.items():
        if isinstance(value, str):
            raise TypeError(f"the function returns the text {value!r} for {key!r}: give a number")
    return {str(key): float(value) for key, value in record.items()}


def _answers(
    function: Callable[..., Any], names: list[str], rows: list[tuple[Any, ...]]
) -> list[dict[str, float] | str]:
    """The answers of a function to some rows: numbers by name, or an error's text."""
    answers: list[dict[str, float] | str] = []
    for row in rows:
        try:
            answer = function(**dict(zip(names, row)))
        except (AttributeError, NameError, TypeError):
            # A slip of the one who wrote the function, in every row alike.
            raise
        except Exception as error:  # noqa: BLE001  A failure is a record.
            answers.append(f"{type(error).__name__}: {error}")
            continue
        try:
            answers.append(_numbers(answer))
        except (TypeError, ValueError) as error:
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
    vary: Mapping[str, Any] | None = None,
    **values: Any,
) -> Table:
    """`function(**row)` for every combination of `values`, the last changing first, or for `rows`, a dictionary of columns. In the
    dictionary `vary` the names of what has values may be any.

    `map` is any map(function, iterable): that of an executor of processes, of joblib (`lambda f, rows: Parallel(2)(delayed(f)(row) for row in
    rows)`), of Dask (`client.get_executor().map`), of Ray (`ray.util.multiprocessing.Pool().map`); the built-in one without. The function is sent once with each block of rows, and kept by the
    workers. What it returns is a number, or a dictionary of numbers; what it raises is told in `failures`,
    unless it is a TypeError, AttributeError or NameError, or all rows fail.

    >>> cs.sweep(lambda a, b: a * b, a=[1, 2], b=[3, 4])["value"].tolist()
    [3.0, 4.0, 6.0, 8.0]
    """
    if not callable(function):
        raise Error(f"`function` is {function!r}, which cannot be called")
    names, table = _table(rows, named("vary", vary, values))
    if map is None or map is builtins.map:
        answers = _answers(function, names, table)
    else:
        sent, process = _sent(function), os.getpid()
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
    if records and len(failures) == len(records):
        raise Error(f"no row has an answer; the first ends with {failures[0][2]}")
    return Table(columns, failures)


def monte_carlo(
    function: Callable[..., Any],
    samples: int,
    seed: int = 0,
    map: Callable[..., Iterable[Any]] | None = None,
    vary: Mapping[str, Any] | None = None,
    **values: Any,
) -> Table:
    """`function(**row)` for `samples` rows of random `values`: each is of `cspace.distributions`, or frozen of `scipy.stats`, or a number
    that stays. In the dictionary `vary` the names of what has values may be any.

    The rows depend on the seed alone: they are the same on one process and on a cluster, and each name has its own numbers whatever
    others there are. A function with an argument `seed` is given another whole number for each row. `map` and what is returned are as of
    `sweep`.

    >>> table = cs.monte_carlo(lambda a, b: a + b, 1000, seed=7, a=cs.distributions.normal(1, 0.1), b=2)
    >>> round(float(table["value"].mean()), 1)
    3.0
    """
    if not (hasattr(samples, "__index__") and samples.__index__() > 0):
        raise Error(f"`samples` is {samples!r} where a number of rows is expected")
    if not (hasattr(seed, "__index__") and seed.__index__() >= 0):
        raise Error(f"`seed` is {seed!r} where a whole number of 0 or more is expected")
    if not callable(function):
        raise Error(f"`function` is {function!r}, which cannot be called")
    rows: dict[str, Any] = {}
    for name, value in named("vary", vary, values).items():
        # Of its own: the name is part of the seed.
        rng = np.random.default_rng([seed, *name.encode()])
        if isinstance(value, Distribution):
            rows[name] = value.draw(rng, samples)
        elif callable(getattr(value, "rvs", None)):
            rows[name] = np.asarray(value.rvs(size=samples, random_state=rng), dtype=np.float64)
        else:
            rows[name] = np.full(samples, number(name, value))
    try:
        takes_seed = "seed" in inspect.signature(function).parameters
    except (TypeError, ValueError):
        takes_seed = False
    if takes_seed and "seed" not in rows:
        rows["seed"] = np.random.default_rng([seed]).integers(0, 2**63, samples)
    return sweep(function, map=map, rows=rows)
