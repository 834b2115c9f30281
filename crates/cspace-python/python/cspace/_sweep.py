"""Any function over many values, here or on a cluster."""

import itertools
import os
import pickle
from functools import lru_cache

import numpy as np

from ._errors import Error
from ._results import Table

# Rows that are sent to a worker together.
_TOGETHER = 64


@lru_cache(maxsize=4)
def _function(sent):
    """The function that was sent, read once in each worker."""
    return pickle.loads(sent)


def _answers(function, names, rows):
    """The answers of a function to some rows: what it returns, or an error's text."""
    answers = []
    for row in rows:
        try:
            answers.append((True, function(**dict(zip(names, row)))))
        except Exception as error:  # noqa: BLE001  A failure is a record.
            answers.append((False, f"{type(error).__name__}: {error}"))
    return answers


def _block(task):
    """The answers in a worker."""
    sent, names, rows = task
    # One thread a worker: workers are as many as processors.
    os.environ.setdefault("CSPACE_NUM_THREADS", "1")
    return _answers(_function(sent), names, rows)


def sweep(function, map=None, rows=None, **values):
    """`function(**row)` for every combination of `values`, the last changing first, or for `rows`, a dictionary of columns.

    `map` is any map(function, iterable) in order: that of an executor of processes, of Dask (`client.get_executor().map`), of Ray
    (`ray.util.multiprocessing.Pool().map`); the built-in one without. The function is sent once with each block of rows, and kept by the
    workers. What it returns is a number, or a dictionary of numbers; what it raises is told in `failures`.

    >>> sweep(lambda a, b: a * b, a=[1, 2], b=[3, 4])["value"].tolist()
    [3.0, 4.0, 6.0, 8.0]
    """
    if rows is not None and values:
        raise Error("`rows` and values of single arguments are both given")
    if rows is None:
        names = list(values)
        table = list(itertools.product(*(np.atleast_1d(v).tolist() for v in values.values())))
    else:
        names = list(rows)
        table = list(zip(*(np.asarray(v).tolist() for v in rows.values()), strict=True))
    if not names:
        raise Error("nothing is varied: give values of an argument")
    if map is None:
        answers = _answers(function, names, table)
    else:
        sent = pickle.dumps(function)
        blocks = (table[i : i + _TOGETHER] for i in range(0, len(table), _TOGETHER))
        tasks = [(sent, names, block) for block in blocks]
        answers = [answer for block in map(_block, tasks) for answer in block]
    columns = {name: np.array([row[k] for row in table]) for k, name in enumerate(names)}
    failures = [(i, None, why) for i, (good, why) in enumerate(answers) if not good]
    records = [answer if isinstance(answer, dict) else {"value": answer} if good else {} for good, answer in answers]
    keys = dict.fromkeys(key for record in records for key in record)
    for key in keys:
        columns[key] = np.array([float(record.get(key, np.nan)) for record in records])
    return Table(columns, failures)
