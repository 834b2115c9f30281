#!/usr/bin/env python3
"""A peg into a hole: the RRTConnect of OMPL beside `cspace plan`.

    dev/benchmarks/ompl/run                 # makes an environment with ompl and shapely, then this
    dev/benchmarks/ompl/run --runs 5 --limit 30

A peg 1 wide and 2 long goes into a hole 1.5 deep, which is `play` wider. Where `play` is negative it is to go through a neck that is
narrower than the peg, into a chamber in which it fits: there is no way. OMPL plans in SE(2) and asks shapely
whether the polygons overlap; motions are asked at steps that move no corner by more than the play. Every path of both is judged by
`cspace plan --verify`. What is timed of cspace is the whole process: reading the model, the contact space, the path, printing.
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import tempfile
import time

import ompl.base as ob
import ompl.geometric as og
import ompl.util as ou
from shapely.affinity import affine_transform
from shapely.geometry import Polygon
from shapely.prepared import prep

WIDTH, LENGTH, DEPTH = 1.0, 2.0, 1.5
START = (3.0, 2.0, 1.0)


def goal(play):
    return (0.0, -1.2 if play > 0 else -2.8, 0.0)


def outlines(play):
    """The block and the peg, whose origin is the middle of its end; the hole's mouth has its middle at the origin."""
    h = 0.5 * (WIDTH + play)
    hole = [(-h, 0), (-h, -DEPTH), (h, -DEPTH), (h, 0)]
    chamber = [(-h, 0), (-h, -0.5), (-0.8, -0.5), (-0.8, -3), (0.8, -3), (0.8, -0.5), (h, -0.5), (h, 0)]
    block = [(-4, 0), *(hole if play > 0 else chamber), (4, 0), (4, -4), (-4, -4)]
    w = 0.5 * WIDTH
    return block, [(-w, 0), (w, 0), (w, LENGTH), (-w, LENGTH)]


def model(folder, play):
    block, peg = outlines(play)
    path = folder / f"peg_{play}.json"
    parts = [{"name": n, "loops": [p]} for n, p in (("block", block), ("peg", peg))]
    path.write_text(json.dumps({"name": "peg and hole", "part": parts}))
    return path


def by_ompl(play, limit):
    """Seconds, whether it is solved, the configurations of the path, and how many configurations were asked."""
    block, peg = (Polygon(p) for p in outlines(play))
    blocked = prep(block)
    asked = 0

    def is_free(state):
        nonlocal asked
        asked += 1
        c, s = math.cos(state.getYaw()), math.sin(state.getYaw())
        return not blocked.intersects(affine_transform(peg, [c, -s, s, c, state.getX(), state.getY()]))

    space = ob.SE2StateSpace()
    bounds = ob.RealVectorBounds(2)
    bounds.setLow(-5)
    bounds.setHigh(5)
    space.setBounds(bounds)
    setup = og.SimpleSetup(space)
    setup.setStateValidityChecker(is_free)
    information = setup.getSpaceInformation()
    information.setStateValidityCheckingResolution(abs(play) / space.getMaximumExtent())

    def state(at):
        # Freed by the space that made it, with the program.
        made = space.allocState()
        made.setX(at[0])
        made.setY(at[1])
        made.setYaw(at[2])
        return made

    setup.setStartAndGoalStates(state(START), state(goal(play)))
    setup.setPlanner(og.RRTConnect(information))
    begin = time.perf_counter()
    setup.solve(limit)
    seconds = time.perf_counter() - begin
    solved = setup.haveExactSolutionPath()
    path = []
    if solved:
        found = setup.getSolutionPath()
        path = [(s.getX(), s.getY(), s.getYaw()) for s in found.getStates()]
    return seconds, solved, path, asked


def asked_of(cspace, file, *options):
    begin = time.perf_counter()
    done = subprocess.run(
        [cspace, "plan", str(file), *options, "--threads", "1", "--json"],
        capture_output=True, text=True)
    return time.perf_counter() - begin, json.loads(done.stdout)["pairs"][0]


def check(cspace, file, folder, path):
    """The verdict of `cspace plan --verify`. Angles run on: OMPL turns the nearer way around."""
    rows, last = ["x,y,theta"], None
    for x, y, theta in path:
        if last is not None:
            theta += 2 * math.pi * round((last - theta) / (2 * math.pi))
        last = theta
        rows.append(f"{x!r},{y!r},{theta!r}")
    csv = folder / "path.csv"
    csv.write_text("\n".join(rows) + "\n")
    return asked_of(cspace, file, "--verify", str(csv))[1]["verdict"]


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--cspace", default="cspace")
    arguments.add_argument("--runs", type=int, default=15)
    arguments.add_argument("--limit", type=float, default=10.0, help="seconds for each run of OMPL")
    arguments.add_argument("--play", type=float, nargs="*", default=[0.1, 0.02, 0.005, -0.005])
    given = arguments.parse_args()
    ou.setLogLevel(ou.LogLevel.LOG_ERROR)
    ou.RNG.setSeed(1)
    print(f"{'play':>8} {'cspace':>10} {'median s':>9} {'planning s':>11} {'OMPL solved':>12} {'median s':>9} {'paths right':>12} {'ratio':>7}")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for play in given.play:
            file = model(folder, play)
            ends = ["--" + n + "=" + ",".join(map(str, at)) for n, at in (("from", START), ("to", goal(play)))]
            runs, right, solved = [], 0, 0
            own, planning = [], []
            for _ in range(given.runs):
                seconds, answer = asked_of(given.cspace, file, *ends)
                own.append(seconds)
                planning.append(answer["seconds"])
                verdict = answer["verdict"]
                if verdict == "path":
                    path = [(c["x"], c["y"], c["theta"]) for c in answer["path"]]
                    assert check(given.cspace, file, folder, path) == "path"
                else:
                    assert play < 0 and verdict == "no-path", verdict
                seconds, is_solved, path, _ = by_ompl(play, given.limit)
                runs.append(seconds)
                if is_solved:
                    solved += 1
                    right += check(given.cspace, file, folder, path) == "path"
            a, b = statistics.median(own), statistics.median(runs)
            print(f"{play:8} {verdict:>10} {a:9.4f} {statistics.median(planning):11.4f} "
                  f"{solved:>8} / {given.runs} {b:9.3f} {right:>12} {b / a:7.0f}", flush=True)


if __name__ == "__main__":
    main()
