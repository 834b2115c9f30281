"""Processes, threads, interruption, pickles and errors."""

import concurrent.futures
import multiprocessing
import os
import pickle
import resource
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import cspace as cs


def tilt(model, play):
    return model(play=play).check()["tilt"].value


class Tilt:
    """A function that can be sent, with its model."""

    def __init__(self, model):
        self.model = model

    def __call__(self, play):
        if play == 0.2:
            raise cs.Error("this one fails")
        return tilt(self.model, play)


def test_everything_is_sent(peg):
    space = peg.compute()
    assert len(pickle.dumps(space)) < 5_000
    again = pickle.loads(pickle.dumps(space))
    assert "not computed yet" in repr(again)
    q = np.random.default_rng(2).uniform(-20, 20, (2_000, 3))
    assert (again.classify(q) == space.classify(q)).all()
    model = pickle.loads(pickle.dumps(peg(play=0.2)))
    assert model.parameters["play"] == 0.2 and model.pairs == peg.pairs
    for thing in (space.fixed, space.regions, space.patches, space.move((0, 40, 0), (0, -90, 0)), peg.check(), cs.Error("x")):
        again = pickle.loads(pickle.dumps(thing))
        assert repr(again) == repr(thing)


@pytest.mark.parametrize("method", ["fork", "spawn", "forkserver"])
def test_processes_work_after_the_parent_has_computed(method, peg):
    space = peg.compute()
    space.classify(np.zeros((10_000, 3)))
    play = [0.05, 0.1, 0.2, 0.15]
    expected = [tilt(peg, p) for p in play]
    context = multiprocessing.get_context(method)
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as executor:
        table = cs.sweep(Tilt(peg), map=executor.map, play=play)
    for found, want, p in zip(table["value"], expected, play):
        assert np.isnan(found) if p == 0.2 else found == want
    assert table.failures == [(2, None, "Error: this one fails")]
    with context.Pool(2) as pool:
        unordered = cs.sweep(Tilt(peg), map=pool.imap_unordered, play=play * 40)
        assert np.array_equal(unordered["value"], np.tile(table["value"], 40), equal_nan=True)
        q = np.random.default_rng(4).uniform(-20, 20, (600, 3))
        found = pool.map(space.classify, [q[:200], q[200:]])
        assert np.array_equal(np.concatenate(found), space.classify(q))
    here = cs.sweep(Tilt(peg), play=play)
    assert np.array_equal(here["value"], table["value"], equal_nan=True)


def test_an_odd_answer_is_a_failure():
    table = cs.sweep(lambda a: None if a == 2 else {"twice": 2 * a}, a=[1, 2, 3])
    assert np.array_equal(table["twice"], [2, np.nan, 6], equal_nan=True)
    assert [f[0] for f in table.failures] == [1]


def test_threads_overlap_and_release_the_interpreter(peg):
    """While one thread computes, another goes on."""
    space = peg.compute()
    q = np.random.default_rng(2).uniform(-20, 20, (2_000_000, 3))
    space.classify(q[:10])
    with concurrent.futures.ThreadPoolExecutor(1) as executor:
        job = executor.submit(space.classify, q)
        begin = last = time.monotonic()
        longest = 0
        while not job.done():
            now = time.monotonic()
            longest, last = max(longest, now - last), now
        whole = time.monotonic() - begin
    # With the interpreter held, nothing goes on here until the job is done.
    assert longest < 0.5 * whole


SLOW = """
import time, signal, sys
import cspace as cs
import math
def star(n, r, name):
    points = []
    for k in range(2 * n):
        a, s = math.pi * k / n, (r if k % 2 == 0 else 0.6 * r)
        points.append((s * math.cos(a), s * math.sin(a)))
    return cs.Part([points], name=name)
a, b = star(60, 10, "a"), star(61, 7, "b")
print("ready", flush=True)
try:
    cs.compute(a, b)
    print("done")
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_ctrl_c_is_heard():
    process = subprocess.Popen([sys.executable, "-c", SLOW], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.3)
    process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    assert process.stdout.readline() == "interrupted\n"
    # Not a measurement of speed: without hearing it, the computation takes many times as long.
    assert time.monotonic() - begin < 5
    process.kill()
    process.wait()


def test_memory_does_not_grow(peg):
    space = peg.compute()
    q = np.random.default_rng(2).uniform(-20, 20, (100, 3))

    def calls(n):
        for _ in range(n):
            space.classify((0.0, -15.0, 0.0))
            space.classify(q)
            with pytest.raises(cs.Error):
                space.classify("nonsense")

    calls(2_000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    calls(20_000)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 8_000


def test_errors_say_what_to_do(peg):
    space = peg.compute()
    for call, words in [
        (lambda: space.classify([[1, 2]]), "n×3"),
        (lambda: space.classify([1, 2]), "(x, y, theta)"),
        (lambda: space.classify(5), "a number"),
        (lambda: space.classify([["a", "b", "c"]]), "no array of numbers"),
        (lambda: space.classify([[0, 0, 0], [np.nan, 0, 0]]), "row 1"),
        (lambda: space.classify([np.nan, 0, 0]), "not finite"),
        (lambda: space.move([[0, 0, 0]] * 2, [[0, 1, 0]] * 3), "`start` has 2 rows and `by` 3"),
        (lambda: space.crossings([[0, 0, 0]] * 2, [0, 1, 0]), "`start` is several"),
        (lambda: cs.Part([[(0, 0), (1, 1)]]), "loop 0"),
        (lambda: cs.Part([(0, 0), (1, 0), (0, 1)]), "one loop"),
        (lambda: cs.Part([[(0, 0), (1, 0), ("x", 1)]]), "vertex 2"),
        (lambda: cs.Part([[(0, 0), (1, 0), (float("nan"), 1)]]), "not finite"),
        (lambda: cs.Model.load("/nowhere/model.toml"), "/nowhere/model.toml"),
        (lambda: cs.Model.loads("[[part]]\nnmae = 'a'\n"), "did you mean `name`?"),
        (lambda: peg(pgg=1), "did you mean `peg`?"),
        (lambda: peg(peg=float("inf")), "inf"),
        (lambda: peg.compute("slot", "peeg"), "slot, peg"),
        (lambda: peg.sweep(plya=[1]), "plya"),
        (lambda: peg.sweep(["tlit"], play=[1]), "tlit"),
        (lambda: peg.solve("tilt", "~", 1, play=(0, 1)), "~"),
        (lambda: peg.solve("tilt", "=", 1, play=(1, 0)), "empty"),
        (lambda: peg.simulate(-1), "the time"),
        (lambda: space.classify(np.zeros((2, 3), complex)), "complex"),
        (lambda: space.classify([["1", "2", "3"]]), "no array of numbers"),
        (lambda: space.mesh(-1), "`tolerance`"),
        (lambda: space.contacts((0, 20, 0), -1), "`tolerance`"),
        (lambda: space.plan((0, 20, 0), (0, 30, 0), clearance=np.nan), "`clearance`"),
        (lambda: cs.compute(None, space.moving), "give a Part"),
        (lambda: cs.compute(space.fixed, space.moving, theta=[0]), "(lo, hi)"),
        (lambda: cs.Part.from_points([(0, 0, 1), (1, 0, 0), (0, 1, 0)]), "n×2"),
        (lambda: cs.Part.from_points([1, 2]), "n×2"),
        (lambda: cs.Part.rectangle(1, 2, center=(1, 2, 3)), "(x, y)"),
        (lambda: cs.Part.circle(1, center=5), "center"),
        (lambda: peg.sweep(play=["x"]), "no numbers"),
        (lambda: peg.sweep(play=[0.1, np.nan]), "not finite"),
        (lambda: peg.sweep("tilt", u=[1]), "coordinate u"),
        (lambda: peg.solve("tilt", "=", "2", play=(0, 1)), "`value`"),
        (lambda: cs.sweep(abs, rows={"x": [1], "y": [1, 2]}), "different lengths"),
    ]:
        with pytest.raises(cs.Error) as caught:
            call()
        assert words in str(caught.value), (words, str(caught.value))
    assert issubclass(cs.Error, ValueError)


def test_threads_are_set_by_the_environment():
    code = "import cspace as cs; cs.compute(cs.Part.circle(1), cs.Part.circle(1))"
    run = lambda n: subprocess.run(  # noqa: E731
        [sys.executable, "-c", code], env={**os.environ, "CSPACE_NUM_THREADS": n}, capture_output=True, text=True
    )
    assert run("1").returncode == 0
    assert "CSPACE_NUM_THREADS" in run("many").stderr


def test_the_command_runs(command):
    def run(*args):
        return subprocess.run(args, capture_output=True, text=True)

    for args in (["--version"], ["new", "peg"], ["compute"], ["info", "/nowhere.toml"]):
        ours, theirs = run(sys.executable, "-m", "cspace", *args), run(command, *args)
        assert (ours.returncode, ours.stdout, ours.stderr) == (theirs.returncode, theirs.stdout, theirs.stderr)
