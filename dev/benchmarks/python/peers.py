#!/usr/bin/env python3
"""The Python package beside what one would use instead, on a peg and its hole.

    pip install . shapely python-fcl ompl          # peers that are missing are left out
    python dev/benchmarks/python/peers.py
    python dev/benchmarks/python/peers.py --rows 2000 --runs 1 --limit 1

Two questions are asked of the pair with which docs/python.md begins, both parts with straight sides:

- Do the parts overlap in these configurations? cspace is asked with its space, which is computed once (told apart). shapely transforms
  the peg and intersects it with the plate, which is prepared: one by one, and with arrays of all polygons at once. fcl, the Flexible
  Collision Library, is for solids: the parts are extruded, the peg is a box and the plate is the three boxes it can be cut into, of which
  each is asked; its answers come one by one.
- Is there a path from outside into the hole? cspace plans exactly. OMPL's RRTConnect samples, with shapely (whether the peg overlaps at
  steps of about the play) and with cspace.ompl (exact motions).

Everything runs on one thread. The best of three runs is told for configurations, the median of --runs for paths.
"""

import argparse
import contextlib
import math
import statistics
import time

import numpy as np

import cspace as cs

WIDTH, HEIGHT = 10.0, 18.0
# The play of the peg in the hole that docs/python.md has.
PLAY = 0.1
START, GOAL = (0.0, 20.0, 0.0), (0.0, -15.0, 0.0)

# Peers that answer one by one are asked about no more, and take so long for each.
ONE_BY_ONE = 20_000
REPEATS = 3
THICKNESS = 1.0


def plate(play):
    """The corners of the plate, with a hole that is so much wider than the peg."""
    h = (WIDTH + play) / 2
    return [(0, -35), (30, -35), (30, 0), (h, 0), (h, -30), (-h, -30), (-h, 0), (-30, 0), (-30, -35)]


def pair(play):
    return cs.Part([plate(play)], name="plate"), cs.Part.rectangle(WIDTH, HEIGHT, name="peg")


def shapely_pair(play):
    import shapely

    fixed = shapely.Polygon(plate(play))
    shapely.prepare(fixed)
    return fixed, shapely.box(-WIDTH / 2, -HEIGHT / 2, WIDTH / 2, HEIGHT / 2)


def seconds(work):
    """The time of the best of some runs, and what it returns."""
    best = math.inf
    for _ in range(REPEATS):
        begin = time.perf_counter()
        found = work()
        best = min(best, time.perf_counter() - begin)
    return best, found


def configurations(rows):
    """About the hole, where a peg is free, blocked or nearly in contact; a half of them all but upright."""
    rng = np.random.default_rng(1)
    q = rng.uniform([-12, -30, -math.pi], [12, 25, math.pi], (rows, 3))
    q[::2, :] *= 0.005, 1, 0.002
    return q


def corners(q):
    """The corners of the peg in all configurations, n×4×2."""
    c, s = np.cos(q[:, 2]), np.sin(q[:, 2])
    turn = np.stack([c, -s, s, c], axis=1).reshape(-1, 2, 2)
    box = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * (WIDTH / 2, HEIGHT / 2)
    return box @ turn.transpose(0, 2, 1) + q[:, None, :2]


def by_cspace(space):
    yield "cspace, an array", lambda q: space.classify(q) == cs.BLOCKED, None

    def one_by_one(q):
        classify = space.classify
        return np.array([classify(at) == cs.BLOCKED for at in q.tolist()])

    yield "cspace, one by one", one_by_one, ONE_BY_ONE


def by_shapely(_):
    import shapely
    from shapely.affinity import affine_transform

    fixed, peg = shapely_pair(PLAY)

    def one_by_one(q):
        found = []
        for x, y, theta in q.tolist():
            c, s = math.cos(theta), math.sin(theta)
            found.append(fixed.intersects(affine_transform(peg, [c, -s, s, c, x, y])))
        return np.array(found)

    yield "shapely, arrays", lambda q: shapely.intersects(fixed, shapely.polygons(corners(q))), None
    yield "shapely, one by one", one_by_one, ONE_BY_ONE


def by_fcl(_):
    import fcl

    def box(x0, y0, x1, y1):
        middle = np.array([(x0 + x1) / 2, (y0 + y1) / 2, 0.0])
        return fcl.CollisionObject(fcl.Box(x1 - x0, y1 - y0, THICKNESS), fcl.Transform(middle))

    h = (WIDTH + PLAY) / 2
    pieces = [box(-30, -35, -h, 0), box(h, -35, 30, 0), box(-h, -35, h, -30)]
    peg = fcl.CollisionObject(fcl.Box(WIDTH, HEIGHT, THICKNESS), fcl.Transform())
    request = fcl.CollisionRequest()

    def one_by_one(q):
        found = []
        for x, y, theta in q.tolist():
            c, s = math.cos(theta), math.sin(theta)
            peg.setTransform(fcl.Transform(np.array([(c, -s, 0), (s, c, 0), (0, 0, 1)]), np.array([x, y, 0.0])))
            found.append(any(fcl.collide(piece, peg, request, fcl.CollisionResult()) for piece in pieces))
        return np.array(found)

    yield "fcl, one by one", one_by_one, ONE_BY_ONE


def classify(space, rows):
    q = configurations(rows)
    truth = space.classify(q) == cs.BLOCKED
    print(f"\n{rows} configurations, {truth.mean():.0%} of them blocked\n")
    print(f"{'':24} {'asked':>9} {'seconds':>9} {'µs each':>9} {'ratio':>8} {'other answers':>14}")
    own = None
    for peer in (by_cspace, by_shapely, by_fcl):
        try:
            for name, ask, most in peer(space):
                some = q[:most]
                took, found = seconds(lambda: ask(some))  # noqa: B023
                each = took / len(some)
                own = own or each
                others = int((found != truth[: len(some)]).sum())
                print(f"{name:24} {len(some):9} {took:9.3f} {1e6 * each:9.3f} {each / own:8.1f} {others:14}", flush=True)
        except ImportError as error:
            print(f"{peer.__name__[3:]:24} left out: {error}")


def by_rrtconnect(motions, space, play, limit):
    """Whether OMPL's RRTConnect finds a path: with the exact motions of cspace.ompl, or with steps that shapely checks."""
    import ompl.base
    import ompl.geometric
    import ompl.util

    ompl.util.setLogLevel(ompl.util.LogLevel.LOG_ERROR)
    from cspace.ompl import plan, state_space

    if motions == "cspace":
        return plan(space, START, GOAL, seconds=limit).path is not None
    from shapely.affinity import affine_transform

    fixed, peg = shapely_pair(play)

    def is_free(state):
        c, s = math.cos(state.getYaw()), math.sin(state.getYaw())
        return not fixed.intersects(affine_transform(peg, [c, -s, s, c, state.getX(), state.getY()]))

    states = state_space(space, START, GOAL)
    setup = ompl.geometric.SimpleSetup(states)
    setup.setStateValidityChecker(is_free)
    si = setup.getSpaceInformation()
    si.setStateValidityCheckingResolution(play / states.getMaximumExtent())
    ends = []
    for x, y, theta in (START, GOAL):
        state = states.allocState()
        state.setX(x)
        state.setY(y)
        state.setYaw(theta)
        ends.append(state)
    setup.setStartAndGoalStates(*ends)
    setup.setPlanner(ompl.geometric.RRTConnect(si))
    setup.solve(limit)
    return setup.haveExactSolutionPath()


def plan(play, runs, limit):
    print(f"\na path into the hole, with a play of {play:g}; OMPL is given {limit:g} seconds\n")
    space = cs.compute(*pair(play))
    print(f"{'':24} {'solved':>9} {'seconds':>9} {'ratio':>8}")
    own = None
    for name, solve in [
        ("cspace, exactly", lambda: space.plan(START, GOAL).verdict == "path"),
        ("RRTConnect with cspace", lambda: by_rrtconnect("cspace", space, play, limit)),
        ("RRTConnect with shapely", lambda: by_rrtconnect("shapely", space, play, limit)),
    ]:
        times, solved = [], 0
        try:
            for _ in range(runs):
                begin = time.perf_counter()
                solved += bool(solve())
                times.append(time.perf_counter() - begin)
        except (ImportError, cs.Error) as error:
            print(f"{name:24} left out: {error}")
            continue
        took = statistics.median(times)
        own = own or took
        print(f"{name:24} {solved:>4} of {runs:<2} {took:9.4f} {took / own:8.0f}", flush=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--rows", type=int, default=1_000_000, help="configurations")
    arguments.add_argument("--play", type=float, nargs="*", default=[2.0, 0.5, PLAY], help="of the peg that is planned for")
    arguments.add_argument("--runs", type=int, default=5, help="runs of each planner")
    arguments.add_argument("--limit", type=float, default=10.0, help="seconds for each run of OMPL")
    given = arguments.parse_args()
    cs.set_threads(1)
    took, space = seconds(lambda: cs.compute(*pair(PLAY)))
    print(f"cspace {cs.__version__}: {space!r}, computed in {1e3 * took:.1f} ms")
    classify(space, given.rows)
    for play in given.play:
        plan(play, given.runs, given.limit)


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        main()
