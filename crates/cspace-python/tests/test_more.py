"""Contact functions, boundary curves, escapes, assemblies and random samples."""

import concurrent.futures
import json
import math
import multiprocessing
import os
import subprocess

import numpy as np
import pytest

import cspace as cs
from conftest import ROOT

BOX = cs.Part([[(0, 0), (10, 0), (10, 10), (0, 10)]], name="box")
COIN = cs.Part.circle(1)


def answer(command, *arguments):
    done = subprocess.run([command, *map(str, arguments), "--json"], capture_output=True, text=True)
    return json.loads(done.stdout)


def test_contact_functions_on_arrays():
    space = cs.compute(BOX, cs.Part.rectangle(2, 1))
    rng = np.random.default_rng(1)
    q = rng.uniform(-3, 13, (50, 3))
    for number in range(0, len(space.patches), 7):
        found = space.contact_function(number, q)
        assert found.value.shape == (50,) and found.hessian.shape == (50, 3, 3)
        h = 1e-6
        for k in range(3):
            up, down = q.copy(), q.copy()
            up[:, k] += h
            down[:, k] -= h
            slope = (space.contact_function(number, up).value - space.contact_function(number, down).value) / (2 * h)
            assert np.allclose(slope, found.gradient[:, k], atol=1e-7)
        one = space.contact_function(number, q[3])
        assert one.value == found.value[3] and np.array_equal(one.gradient, found.gradient[3])
        assert np.allclose(np.hypot(*found.normal.T), 1)
    with pytest.raises(cs.Error, match="no patch 999"):
        space.contact_function(999, q)


def test_boundary_curves_are_in_contact():
    space = cs.compute(BOX, COIN)
    for number, patch in enumerate(space.patches):
        lo, hi = patch.orientations
        thetas = np.linspace(lo, hi, 7)[1:-1]
        for ends in space.patch_ends(number, thetas):
            q = np.column_stack([ends, thetas])
            assert np.abs(space.contact_function(number, q).value).max() < 1e-9
            assert (space.classify(q) == cs.CONTACT).all()


def test_what_a_space_tells():
    space = cs.compute(BOX, COIN)
    assert space.features == (8, 2) and 0 < space.contact_distance < 1e-9
    assert space.least_clearance < 1e-8
    bands = cs.compute(BOX, BOX).bands
    assert all(lo < hi for lo, hi in bands) and sum(hi - lo for lo, hi in bands) == pytest.approx(2 * math.pi)
    assert space.connected([(-3, 0, 0), (5, 5, 0)], (20, 0, 1)).tolist() == [True, False]
    near = space.nearest((-3, 5, 0), 1.0)
    assert near.at[:2] == pytest.approx((-1, 5)) and near.distance == pytest.approx(2)
    assert space.nearest((-3, 5, 0), 1.0, near.patch).distance == pytest.approx(2)
    through = space.crossings((-5, 5, 0.3), (20, 0, 0))
    assert [(c.enters, round(c.at[0], 9)) for c in through] == [(True, -1), (False, 11)]


def test_pictures():
    assert cs.compute(BOX, COIN)._repr_svg_().startswith("<svg")
    cam = cs.Model.load(ROOT / "models/cam_tappet.toml")
    assert "<svg" in cam.compute()._repr_svg_()


def test_the_page_in_a_notebook():
    pytest.importorskip("IPython")
    space = cs.compute(BOX, COIN)
    try:
        cs._rust._require_page()
    except cs.Error as error:
        assert os.environ.get("CSPACE_PAGE") != "build" and "\nhelp: build" in str(error)
        with pytest.raises(cs.Error, match="built without its page"):
            space.view()
        pytest.skip(str(error))
    frame = space.view()
    assert frame.data.startswith("<iframe srcdoc=") and len(frame.data) > 100_000


def test_an_escape_is_the_commands(command):
    model = ROOT / "models/ball_in_c.toml"
    told = answer(command, "plan", model, "--energy", "--from", "0,0,0", "--gravity", "0,-9.81")["pairs"][0]
    found = cs.Model.load(model).escape((0, 0, 0), gravity=(0, -9.81))
    assert found.verdict == told["verdict"] and found.energy == told["energy"] and found.least == told["least"]


def test_an_assembly_is_the_commands(command):
    model = ROOT / "models/latch_box.toml"
    told = answer(command, "disassemble", model)
    found = cs.Model.load(model).disassemble()
    del told["seconds"], found["seconds"]
    assert found == told and found.units.length == "mm"


def product(a, b, seed):
    return {"product": a * b, "low": seed & 0xFFFF}


def test_samples_are_the_same_everywhere():
    given = {"a": cs.distributions.normal(1, 0.1), "b": cs.distributions.uniform(2, 3)}
    here = cs.monte_carlo(product, 200, seed=5, **given)
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as executor:
        there = cs.monte_carlo(product, 200, seed=5, map=executor.map, **given)
    assert all(np.array_equal(here[key], there[key]) for key in here) and len(set(here["low"])) > 150
    assert here["product"].mean() == pytest.approx(2.5, abs=0.1)
    # A name has its own numbers, whatever others there are.
    alone = cs.monte_carlo(lambda a: a, 200, seed=5, a=cs.distributions.normal(1, 0.1))
    assert np.array_equal(alone["a"], here["a"]) and not np.array_equal(here["a"], here["b"])
    assert not np.array_equal(cs.monte_carlo(lambda a: a, 200, seed=6, a=cs.distributions.normal(1, 0.1))["a"], here["a"])
    for wrong in (lambda: cs.distributions.normal(0, -1), lambda: cs.distributions.uniform(1, 0), lambda: cs.distributions.triangular(0, 3, 2)):
        with pytest.raises(cs.Error):
            wrong()


def test_slices_say_that_they_are_doubtful():
    model = cs.Model.load(ROOT / "tests/regression/half_disc_in_a_socket_of_its_radius.toml")
    space = model.compute(*list(model.parts)[:2])
    assert space.slice(1).doubtful and not space.slice(2).doubtful
