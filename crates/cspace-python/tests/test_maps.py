"""The maps of processes, joblib, Dask and Ray, as the examples use them: the same table to the last bit, and what a task costs.

The long tier installs all of them, and prints what it measures:

    .ci/long maps
"""

import importlib.util
import os
import pickle
import sys
import time

import numpy as np
import pytest

import cspace as cs
from conftest import ROOT

EXAMPLES = str(ROOT / "crates/cspace-python/examples")
sys.path.insert(0, EXAMPLES)
import latch_sweep  # noqa: E402
import maps  # noqa: E402

IS_LONG = bool(os.environ.get("CSPACE_LONG"))
VALUES = {"head": cs.distributions.normal(10, 0.1), "mouth": cs.distributions.normal(9.1, 0.1)}
PACKAGES = {"processes": "concurrent.futures", "joblib": "joblib", "dask": "distributed", "ray": "ray"}


def timed(map, rows):
    """The table of so many rows by a map, the seconds it takes, and the bytes that are sent for a task and back."""
    sent = []

    def counted(function, tasks):
        for task, answer in zip(tasks, map(function, tasks)):
            sent.append(len(pickle.dumps(task)) + len(pickle.dumps(answer)))
            yield answer

    held = latch_sweep.Held()
    # Workers start with the first rows.
    cs.monte_carlo(held, 256, seed=9, map=map, **VALUES)
    begin = time.perf_counter()
    table = cs.monte_carlo(held, rows, seed=1, map=counted, **VALUES)
    return table, time.perf_counter() - begin, np.mean(sent)


@pytest.mark.parametrize("name", PACKAGES)
def test_a_table_is_the_same_by_every_map(name, monkeypatch):
    # Workers import the example, too.
    monkeypatch.setenv("PYTHONPATH", EXAMPLES)
    if not IS_LONG:
        pytest.importorskip(PACKAGES[name])
    importlib.import_module(PACKAGES[name])
    rows = 2048 if IS_LONG else 256
    # As the workers: one thread.
    cs.set_threads(1)
    begin = time.perf_counter()
    here = cs.monte_carlo(latch_sweep.Held(), rows, seed=1, **VALUES)
    alone = time.perf_counter() - begin
    cs.set_threads(0)
    assert 0.05 < np.mean(here["value"]) < 0.999 and not here.failures
    with maps.chosen(name, 2) as map:
        table, seconds, size = timed(map, rows)
        # A hundred tasks that compute nothing, of a function without a name.
        begin = time.perf_counter()
        lambdas = cs.sweep(lambda a: 2 * a, map=map, a=np.arange(6400.0)) if importlib.util.find_spec("cloudpickle") else None
        task = 1e3 * (time.perf_counter() - begin) / 100
    assert list(table) == list(here) and all(table[key].tobytes() == here[key].tobytes() for key in here)
    assert lambdas is None or lambdas["value"].tolist() == (2 * np.arange(6400.0)).tolist()
    # A task is 64 rows with their function: its bytes do not grow with what is computed.
    assert size < 20_000
    print(f"\n{name}: {alone / (2 * seconds):.2f} efficient on two processes, {size:.0f} bytes and {task:.2f} ms a task of 64 rows")
    print(f"{1e3 * alone / rows:.2f} ms a row on one process")
