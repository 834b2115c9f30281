"""The adapter to OMPL: exact checks of states and motions, and plans."""

import math
import sys

import numpy as np
import pytest

import cspace as cs

pytest.importorskip("ompl")

from ompl import geometric, util  # noqa: E402

from cspace import ompl  # noqa: E402

STATUS = ompl.base.PlannerStatus


@pytest.fixture(autouse=True)
def quiet():
    util.setLogLevel(util.LogLevel.LOG_ERROR)
    util.RNG.setSeed(5)


def coin_and_bar():
    """A bar of 8 × 2, and a coin of radius 1 whose middle is the origin."""
    return cs.compute(cs.Part.rectangle(8, 2, name="bar"), cs.Part.circle(1, name="coin"))


def bar_and_bar(theta=None):
    return cs.compute(cs.Part.rectangle(8, 2, name="bar"), cs.Part.rectangle(6, 1, name="stick"), theta=theta)


def checkers(space):
    setup = geometric.SimpleSetup(ompl.state_space(space))
    si = setup.getSpaceInformation()
    states = setup.getStateSpace()

    def state(x, y, yaw):
        made = states.allocState()
        made.setX(x)
        made.setY(y)
        made.setYaw(yaw)
        return made

    # What owns the states goes with them.
    state.setup = setup
    return ompl.StateValidityChecker(si, space), ompl.MotionValidator(si, space), state


def test_states_are_valid_where_they_are_free_or_in_contact():
    states, _, state = checkers(coin_and_bar())
    assert states.isValid(state(0, 2.1, 0.4)) and states.isValid(state(0, 2, 0.4))
    assert not states.isValid(state(0, 1.999, 0.4))
    rng = np.random.default_rng(6)
    space = bar_and_bar()
    states, _, state = checkers(space)
    q = rng.uniform([-8, -8, -math.pi], [8, 8, math.pi], (500, 3))
    found = [states.isValid(state(*at)) for at in q.tolist()]
    assert found == (space.classify(q) != cs.BLOCKED).tolist() and 50 < sum(found) < 450


def test_motions_are_checked_exactly():
    _, motions, state = checkers(coin_and_bar())
    # Past the end of the bar, by a hair and less than a hair: no step would tell.
    for y, valid in ((1e-6, True), (-1e-6, False)):
        assert motions.checkMotion(state(-9, 2 + y, 0), state(9, 2 + y, 0)) is valid
    # A corner is cut that the ends are far from.
    tangent = math.sqrt(2)
    for off, valid in ((1e-6, True), (-1e-6, False)):
        middle = (4 + (1 + off) / tangent, 1 + (1 + off) / tangent)
        first, second = (middle[0] - 5, middle[1] + 5), (middle[0] + 5, middle[1] - 5)
        assert motions.checkMotion(state(*first, 0), state(*second, 0)) is valid
    # They begin and end in contact, and do not go through.
    assert motions.checkMotion(state(0, 2, 0), state(0, 5, 0)) and motions.checkMotion(state(0, 5, 0), state(0, 2, 0))
    assert motions.checkMotion(state(1, 5, 0), state(-2, 2, 0)) and motions.checkMotion(state(0, 2, 0), state(3, 2, 0))
    assert not motions.checkMotion(state(0, 2, 0), state(0, 1.9, 0))
    assert not motions.checkMotion(state(0, 5, 0), state(0, -5, 0))
    assert not motions.checkMotion(state(0, 0, 0), state(0, 5, 0))


def test_motions_turn_the_shorter_way():
    space = bar_and_bar()
    _, motions, state = checkers(space)
    # The stick above the bar: from 170 to -170 degrees it stays flat, and by 0 it would come through upright.
    at, low = 2.1, math.radians(170)
    assert motions.checkMotion(state(0, at, low), state(0, at, -low)) and motions.checkMotion(state(0, at, -low), state(0, at, low))
    assert not motions.checkMotion(state(0, at, low), state(0, at, 0.1))
    # As OMPL goes: configurations between, by its own interpolation.
    states = state.setup.getStateSpace()
    rng = np.random.default_rng(9)
    between, found = states.allocState(), []
    for first, second in rng.uniform([-8, -8, -math.pi], [8, 8, math.pi], (200, 2, 3)).tolist():
        a, b = state(*first), state(*second)
        q = []
        for share in np.linspace(0, 1, 400).tolist():
            states.interpolate(a, b, share, between)
            q.append((between.getX(), between.getY(), between.getYaw()))
        found.append((motions.checkMotion(a, b), bool((space.classify(np.array(q)) == cs.FREE).all())))
    # What is free is free at every step; what is not is found by steps, but where they pass a corner.
    assert all(sampled for exact, sampled in found if exact)
    assert sum(exact != sampled for exact, sampled in found) <= 2 and 20 < sum(exact for exact, _ in found) < 180


def test_windows_of_orientations():
    states, motions, state = checkers(bar_and_bar(theta=(3.0, 3.5)))
    assert states.isValid(state(0, 5, 3.1)) and states.isValid(state(0, 5, 3.4 - math.tau))
    assert not states.isValid(state(0, 5, 0)) and not states.isValid(state(0, 5, 2.9))
    assert motions.checkMotion(state(0, 5, 3.1), state(1, 5, 3.4 - math.tau))
    assert not motions.checkMotion(state(0, 5, 3.1), state(1, 5, 2.9))
    assert not motions.checkMotion(state(0, 5, 2.9), state(1, 5, 3.1))


def test_bounds():
    space = coin_and_bar()

    def of(states):
        box = states.getBounds()
        return [*box.low, *box.high]

    assert of(ompl.state_space(space, bounds=(0, 1, 2, 3))) == [0, 1, 2, 3]
    far = 2 * math.sqrt(2)
    assert of(ompl.state_space(space, (100, 0, 0))) == pytest.approx([-4 - far, -1 - far, 100, 1 + far])
    with pytest.raises(cs.Error, match="empty"):
        ompl.state_space(space, bounds=(0, 0, 0, 1))


def test_plans_are_paths():
    space = bar_and_bar()
    start, goal = (0, 3, 0.0), (0, -3, 3 * math.pi)
    for planner in (None, geometric.KPIECE1, geometric.PRM):
        found = ompl.plan(space, start, goal, seconds=20, planner=planner)
        assert found.status == STATUS.EXACT_SOLUTION and found.exact.verdict == "path"
        assert np.allclose(found.path[0], start) and np.allclose(found.path[-1][:2], goal[:2])
        assert math.isclose(math.remainder(found.path[-1][2] - goal[2], math.tau), 0, abs_tol=1e-9)
        for first, second in zip(found.path, found.path[1:]):
            assert abs(second[2] - first[2]) <= math.pi and space.move(first, second - first).outcome == "free"


def test_proofs_come_without_sampling(monkeypatch):
    def sampled(*_):
        raise AssertionError("a planner is asked")

    box = [(-5, -5), (5, -5), (5, 5), (-5, 5)]
    hole = [(-3, -3), (3, -3), (3, 3), (-3, 3)]
    space = cs.compute(cs.Part([box, hole], name="box"), cs.Part.circle(1, name="coin"))
    for start, goal, status, verdict in [
        ((0, 0, 0), (9, 0, 0), STATUS.INFEASIBLE, "no-path"),
        ((4, 0, 0), (9, 0, 0), STATUS.INVALID_START, "from-blocked"),
        ((9, 0, 0), (4, 0, 0), STATUS.INVALID_GOAL, "to-blocked"),
    ]:
        found = ompl.plan(space, start, goal, planner=sampled)
        assert (found.status, found.path, found.exact.verdict) == (status, None, verdict)
    with pytest.raises(AssertionError):
        ompl.plan(space, (0, 0, 0), (1, 1, 0), planner=sampled)


def test_pairs_on_axes_have_another_space(models):
    space = cs.Model.load(models / "cam_plate.toml").compute()
    for call in (lambda: ompl.state_space(space), lambda: ompl.plan(space, (0, 0), (1, 1))):
        with pytest.raises(cs.Error, match="the pair is fixed-axes"):
            call()


def test_ompl_that_is_missing_is_named(monkeypatch):
    for name in [name for name in sys.modules if name.split(".")[0] == "ompl"] + ["cspace.ompl"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "ompl", None)
    with pytest.raises(cs.Error, match="pip install ompl"):
        import cspace.ompl  # noqa: F401
