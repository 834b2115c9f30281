"""Paths as they are read: rows, places along them, and what is said of what is no path."""

import concurrent.futures
import importlib.util
import math
import pathlib
import pickle
import warnings

import numpy as np
import pytest

import cspace as cs


ROOT = pathlib.Path(__file__).parents[3]


@pytest.fixture(scope="module")
def space():
    return cs.compute(cs.Part.rectangle(10, 10, name="box"), cs.Part.rectangle(2, 1, name="bar"))


def straight(rows, places):
    """Places between rows, with all coordinates at constant rates."""
    return np.concatenate([np.linspace(a, b, places) for a, b in zip(rows, rows[1:])])


def test_rows_are_free_as_they_stand(space):
    rng = np.random.default_rng(1)
    turned = 0
    for _ in range(40):
        start, goal = (np.append(rng.uniform(-12, 12, 2), rng.uniform(-3, 3)) for _ in range(2))
        plan = space.plan(start, goal)
        if not plan:
            continue
        turned += plan.about != [0, 0]
        assert (space.classify(straight(plan.path, 60)) != cs.BLOCKED).all()
        assert np.allclose(plan.path[0], start) and np.allclose(plan.path[-1], plan.legs[-1])
        assert (space.classify(plan.sample(300)) != cs.BLOCKED).all()
    assert turned


def test_places_along_a_path(space):
    plan = space.plan((-7.117, -5.704, -0.0889), (6.0088, -5.2702, 2.8844), about=(0, 3))
    ends = plan.sample(2)
    assert np.allclose(ends, plan.legs[[0, -1]], rtol=0, atol=1e-12)
    assert np.allclose(plan.at(1 / (len(plan.legs) - 1)), plan.legs[1], rtol=0, atol=1e-12)

    def point(q):
        return q[:2] + 3 * np.array([-math.sin(q[2]), math.cos(q[2])])

    # In the middle of the first leg the point that legs are about is half way.
    middle = plan.at(0.5 / (len(plan.legs) - 1))
    assert np.allclose(point(middle), (point(plan.legs[0]) + point(plan.legs[1])) / 2, rtol=0, atol=1e-12)
    for wrong in (lambda: plan.at(1.5), lambda: plan.sample(0), lambda: space.plan((0, 0, 0), (20, 0, 0)).sample(5)):
        with pytest.raises(cs.Error):
            wrong()


def test_records_with_arrays_are_compared_as_objects(space):
    contact = space.contact_function(0, (-8, 0, 0))
    assert contact == contact and len({contact, contact}) == 1 and contact != space.contact_function(0, (-8, 0, 0))


def test_a_model_and_a_space_plan_alike(space):
    """One kind of answer: the command's, whose path is there in rows and in legs, with its places."""
    text = """
[[part]]
name = "box"
loops = [[[-5, -5], [5, -5], [5, 5], [-5, 5]]]
[[part]]
name = "bar"
loops = [[[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]]]
"""
    model, ends = cs.Model.loads(text), ((-8, 1, 0), (8, 0, 2.0))
    for wishes in ({}, {"about": (0, 3)}, {"widest": True}, {"prefer": "length"}):
        of_space, of_model = space.plan(*ends, **wishes), model.plan(*ends, **wishes)
        for plan in (of_space, of_model):
            assert type(plan) is cs.Plan and plan and plan.outcome == plan.verdict == plan["verdict"] == "path"
            assert plan["path"] is plan.path and plan["legs"] is plan.legs and len(plan.path) >= len(plan.legs)
            assert (space.classify(straight(plan.path, 60)) != cs.BLOCKED).all()
            assert np.array_equal(plan.sample(len(plan.legs)), plan.legs) or np.allclose(plan.sample(len(plan.legs)), plan.legs)
            again = pickle.loads(pickle.dumps(plan))
            assert again == plan and np.array_equal(again.path, plan.path)
            told = plan.to_dict()["pairs"][0]
            assert [list(row.values()) for row in told["path"]] == plan.legs.tolist()
        assert np.array_equal(of_space.path, of_model.path) and of_space.about == of_model.about
        assert of_space.clearance == of_model.clearance and of_space.bottleneck == of_model.bottleneck
    for blocked in (space.plan((0, 0, 0), (9, 0, 0)), model.plan((0, 0, 0), (9, 0, 0))):
        assert blocked.verdict == "from-blocked" and not blocked and blocked.path is None and blocked.legs is None
        assert blocked.blocked.depth > 0 and blocked.touching == []


def test_what_is_blocked_is_in_no_region(space):
    assert space.region((0, 0, 0)) is None and space.region((9, 0, 0)) == 0
    assert space.region([(0, 0, 0), (9, 0, 0)]).tolist() == [-1, 0]


def test_a_part_contains_its_outline():
    square, circle = cs.Part.rectangle(10, 10), cs.Part.circle(5)
    for x, y in [(5, 5), (-5, -5), (5, -5), (-5, 5), (5, 0), (-5, 0), (0, 5), (0, -5), (3, 5), (5, 3)]:
        assert square.contains(x, y) and not square.contains(1.0000001 * x, 1.0000001 * y)
    for x, y in [(5, 0), (0, 5), (-5, 0), (0, -5), (3, 4), (-3, -4)]:
        assert circle.contains(x, y) and not circle.contains(1.0000001 * x, 1.0000001 * y)
    assert cs.Part([[(0, 0), (4, 0), (0, 3)]]).contains(2, 1.5)


def test_degrees_are_suspected(space):
    for ask in (
        lambda: space.classify((9, 0, 90)),
        lambda: space.classify([(9, 0, 0), (9, 0, 90)]),
        lambda: space.slice(90),
        lambda: space.plan((9, 0, 0), (9, 1, 90)),
        lambda: cs.nfp(space.fixed, space.moving, 90),
    ):
        with pytest.warns(UserWarning, match="radians"):
            ask()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        space.classify((9, 0, 4 * math.pi))


def test_slips_in_a_function_are_raised():
    with pytest.raises(AttributeError):
        cs.sweep(lambda a: a.foo, a=[1, 2])
    with pytest.raises(TypeError):
        cs.sweep(lambda b: b, a=[1, 2])
    for nothing in (lambda a: None, lambda a: "3", lambda a: (a, a), lambda a: 1 / (a - a)):
        with pytest.raises(cs.Error, match="no row has an answer"):
            cs.sweep(nothing, a=[1, 2])
    table = cs.sweep(lambda a: 1 / a, a=[0, 1])
    assert "ZeroDivisionError" in repr(table) and table["value"][1] == 1


def test_loops_keep_their_kind():
    loops = cs.inner_fit(cs.Part.rectangle(9, 9), cs.Part.circle(1))
    assert type(loops[:]) is cs.Loops and loops[:].outside_blocked and loops[:] == loops
    assert not hasattr(loops, "append") and cs.Part(loops).area == pytest.approx(49)


def test_a_closed_ring_of_points():
    ring = [(0, 0), (4, 0), (0, 3), (0, 0)]
    assert cs.Part.from_points(ring).area == 6


def test_bounds_that_stay_apart_have_no_energy():
    text = """
gravity = [0, -9810]
[[part]]
name = "cup"
loops = [[[-4, -1], [4, -1], [4, 4], [3, 4], [3, 0], [-3, 0], [-3, 4], [-4, 4]]]
[[part]]
name = "disc"
loops = [{ circle = 1, at = [0, 0] }]
mass = 0.01
[[spring]]
parts = ["cup"]
at = [[-4, -1], [-4, -1]]
stiffness = 1e4
length = 0
"""
    found = cs.Model.loads(text).escape((0, 1, 0))
    known = 0.01 * 9810 * 4
    assert found.least <= known <= found.most and found.energy in (None, pytest.approx(known))


def test_an_exact_fit_has_a_way_with_a_gap():
    slot = cs.Part([[(-9, -9), (9, -9), (9, 0), (5, 0), (5, -5), (-5, -5), (-5, 0), (-9, 0)]], name="slot")
    space = cs.compute(slot, cs.Part.rectangle(10, 10, name="key"))
    assert space.classify((0, 0, 0)) == cs.BLOCKED
    plan, play = space.plan((0, 0, 0)), space.play((0, 0, 0))
    assert plan and 0 < plan.gap < 1e-4 and 0 < play["x"].length < 4 * plan.gap and play["x"].gap == plan.gap
    assert space.move((0, 0, 0), (0, 20, 0)).outcome == "free" and space.plan((9, 9, 0), (30, 0, 0)).gap is None


def test_functions_without_a_name_are_sent_or_refused():
    with concurrent.futures.ThreadPoolExecutor(1) as executor:
        def sweep():
            return cs.sweep(lambda a: 2 * a, map=executor.map, a=[1, 2])

        if importlib.util.find_spec("cloudpickle"):
            assert sweep()["value"].tolist() == [2, 4]
        else:
            with pytest.raises(cs.Error, match="cloudpickle"):
                sweep()
    assert cs.sweep(lambda a: 2 * a, map=map, a=[1, 2])["value"].tolist() == [2, 4]


def test_nothing_to_vary_is_told(space):
    model = cs.Model.load(ROOT / "models/peg_hole.toml")
    with pytest.raises(cs.Error, match="no requirements"):
        model.tolerances()
    assert space.patches is space.patches and space.regions is space.regions
