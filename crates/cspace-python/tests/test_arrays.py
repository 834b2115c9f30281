"""Arrays of configurations: each row is answered as it is alone, for every question and class of pair, and long work is heard of."""

import json
import os
import pickle
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import cspace as cs
from conftest import ROOT

GRIPPER = cs.Part(
    [[(-6, -6), (6, -6), (6, 6), (-6, 6), (-6, 1.9), (-4, 1.9), (-4, 4), (4, 4), (4, -4), (-4, -4), (-4, -1.9), (-6, -1.9)]],
    name="gripper",
)


def planar():
    space = cs.compute(GRIPPER, cs.Part([[(-1.5, -1, 0.3), (1.5, -1), (1, 1.2), (-1, 1)]], name="key"))
    return space, np.random.default_rng(3).uniform([-9, -9, -3], [9, 9, 3], (300, 3))


def on_axes():
    space = cs.Model.load(ROOT / "models/cam_plate.toml").compute()
    return space, np.random.default_rng(4).uniform([-5, -5], [90, 25], (300, 2))


def slot():
    """A pair that fits exactly at some of its configurations."""
    space = cs.compute(
        cs.Part([[(-9, -9), (9, -9), (9, 0), (5, 0), (5, -5), (-5, -5), (-5, 0), (-9, 0)]], name="slot"), cs.Part.rectangle(10, 10, name="key")
    )
    return space, np.array([(0, 0, 0), (0, 20, 0.3), (0, 3, 0), (2, 1, 0), (9, 9, 0)], dtype=float)


@pytest.mark.parametrize("scene", [planar, on_axes, slot])
def test_rows_are_answered_as_they_are_alone(scene):
    space, q = scene()
    by = np.random.default_rng(5).uniform(-9, 9, q.shape)
    plays, moves = space.play(q), space.move(q, by)
    nearest, turned = space.nearest(q), space.nearest(q, 3.0)
    rows, patches, distances = space.contacts(q, 2.0)
    free = classes = 0
    for i, row in enumerate(q):
        classes += space.classify(row) == space.classify(q)[i]
        if plays[next(iter(plays))].lower[i] == plays[next(iter(plays))].lower[i]:
            free += 1
            for name, play in space.play(row).items():
                of = plays[name]
                assert (of.lower[i], of.upper[i]) == (play.lower, play.upper) and list(of.touching[i]) == list(play.touching)
                assert of.gap[i] == play.gap or (play.gap is None and np.isnan(of.gap[i]))
        else:
            with pytest.raises(cs.Error, match="overlap"):
                space.play(row)
        moved = space.move(row, by[i])
        assert (moves.outcome[i], moves.fraction[i], tuple(moves.at[i])) == (moved.outcome, moved.fraction, moved.at)
        assert moves.touching[i] == moved.touching and (moves.gap[i] == moved.gap or np.isnan(moves.gap[i]))
        for many, one in ((nearest, space.nearest(row)), (turned, space.nearest(row, 3.0))):
            if one is None:
                assert many.patch[i] == -1 and many.distance[i] == np.inf and np.isnan(many.at[i]).all()
            else:
                assert (many.patch[i], tuple(many.at[i]), many.distance[i]) == (one.patch, one.at, one.distance)
        there = rows == i
        assert list(zip(patches[there].tolist(), distances[there].tolist())) == space.contacts(row, 2.0)
    assert classes == len(q) and 0 < free
    onto = space.nearest(q[:7], 3.0, patch=2)
    assert onto.patch.tolist() == [2] * len(q[:7]) and onto.at[3].tolist() == list(space.nearest(q[3], 3.0, 2).at)


def test_one_displacement_goes_with_many_starts():
    space, q = planar()
    free = q[space.classify(q) == cs.FREE][:20]
    by = (0.0, -9.0, 0.5)
    together = space.move(free, by)
    assert together.fraction.tolist() == space.move(free, np.tile(by, (len(free), 1))).fraction.tolist()
    fan = np.random.default_rng(6).uniform(-9, 9, (20, 3))
    assert space.move(free[0], fan).fraction.tolist() == [space.move(free[0], one).fraction for one in fan]
    about = space.move(free, by, about=(1, 0))
    assert about.at[3].tolist() == list(space.move(free[3], by, about=(1, 0)).at)
    assert len(space.move(q[:0], by).outcome) == 0 and space.play(q[:0])["x"].lower.shape == (0,)


def test_records_are_plain_data(tmp_path):
    space, q = planar()
    free = q[space.classify(q) == cs.FREE]
    told = [space.play(free[0])["x"], space.play(free)["x"], space.move(free[0], (0, -9, 0)), space.move(free, (0, -9, 0))]
    told += [space.nearest(q), space.nearest(q[0]), space.patches[0], space.regions[0], space.contact_function(0, q)]
    told += space.crossings(q[0], (0, 30, 0))[:1]
    for record in told:
        again = json.loads(json.dumps(record.to_dict(), allow_nan=False))
        assert again == record.to_dict() and list(again) == list(vars(record))


def test_features_are_names_with_a_place():
    space, _ = planar()
    for patch in space.patches[::50]:
        for part, feature in ((space.fixed, patch.fixed), (space.moving, patch.moving)):
            assert feature == f"{feature.kind} {feature.number} of loop {feature.loop}" == part.feature(str(feature))
            assert part.feature(feature).kind == feature.kind == pickle.loads(pickle.dumps(feature)).kind
    with pytest.raises(cs.Error, match='gripper has no feature "line 99 of loop 0"\nhelp'):
        space.fixed.feature("line 99 of loop 0")


def test_classes_print_their_names():
    space, _ = planar()
    found = space.classify((20, 0, 0))
    assert found is cs.FREE and found == 0 and str(found) == f"{found}" == "free" and found.name == "FREE"
    assert json.dumps([cs.FREE, cs.CONTACT]) == "[0, 2]" and space.classify([(20, 0, 0)]).dtype == np.uint8


QUESTIONS = """
import sys, threading
import numpy as np
import cspace as cs
sys.path.insert(0, sys.argv[1])
from test_arrays import planar
space, _ = planar()
q = np.random.default_rng(3).uniform([-9, -9, -3], [9, 9, 3], (3_000_000, 3))
asked = {
    "classify": lambda: space.classify(np.tile(q, (40, 1))), "clearance": lambda: space.clearance(q), "region": lambda: space.region(np.tile(q, (40, 1))),
    "play": lambda: space.play(q), "move": lambda: space.move(q, (1, 2, 3)), "nearest": lambda: space.nearest(q),
    "metric": lambda: space.nearest(q, 3.0), "contacts": lambda: space.contacts(q, 0.1), "connected": lambda: space.connected(q, (20, 0, 0)),
    "contact_function": lambda: space.contact_function(0, np.tile(q, (20, 1))),
}[sys.argv[2]]
space.classify(q[:200])
print("ready", flush=True)
try:
    asked()
    print("done", flush=True)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals")
@pytest.mark.parametrize("question", ["clearance", "play", "move", "nearest", "metric", "contacts"])
def test_ctrl_c_ends_arrays(question):
    process = subprocess.Popen(
        [sys.executable, "-c", QUESTIONS, os.path.dirname(__file__), question], stdout=subprocess.PIPE, text=True, stderr=subprocess.DEVNULL
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    assert process.stdout.readline() == "interrupted\n"
    # Not a measurement of speed: all rows take many times as long.
    assert time.monotonic() - begin < 3
    process.kill()
    process.wait()


def test_long_work_is_heard_of():
    heard = []
    with cs.progress(lambda *told: heard.append(told)):
        space, q = planar()
        assert [stage for stage, _, _ in heard] == [
            "sheets", "candidates", "pair-events", "branches", "triple-events", "cells", "shells", "graph",
        ]  # fmt: skip
        seconds = [at for _, at, _ in heard]
        assert seconds == sorted(seconds) and seconds[0] >= 0 and all(share is None for _, _, share in heard)
        heard.clear()
        space.clearance(np.tile(q, (30, 1)))
    shares = [share for stage, _, share in heard if stage == "rows"]
    assert len(shares) > 2 and shares == sorted(shares) and shares[-1] == 1
    heard.clear()
    space.clearance(q)
    assert heard == []


def test_who_hears_may_end_it(peg):
    def enough(stage, seconds, share):
        raise RuntimeError(f"enough at {stage}")

    with cs.progress(enough), pytest.raises(RuntimeError, match="enough at sheets"):
        cs.compute(GRIPPER, GRIPPER)
    heard = []
    with cs.progress(lambda stage, seconds, share: heard.append((stage, share))):
        cs.Model.load(ROOT / "models/tolerances/geneva_lock.toml").tolerances("dwell", samples=3000)
    assert ("pieces", 1) in heard or any(stage == "pieces" and 0 < share <= 1 for stage, share in heard)
