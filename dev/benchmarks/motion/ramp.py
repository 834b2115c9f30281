#!/usr/bin/env python3
"""A block on a rough incline: pymunk, Box2D and Siconos beside `cspace simulate`, and beside the formula.

    dev/benchmarks/motion/run ramp
    dev/benchmarks/motion/run ramp --steps 1e-3 1e-5 --peers Siconos

The block lies on the incline as drawn and is let go. With a friction of 0.3 it slides by s = g/2 (sin a - mu cos a) t^2; with one just above
tan a it stays where it is. Printed, for each step, is by how much it is off after --time, along the incline, and the processor seconds: of
the peers those of the steps, of cspace those of the whole process.

Siconos has no shapes: its MoreauJeanOSI is given the gaps of the block's two lower corners, linear in its place along and above the incline and in
its angle: what is left out is of the angle's square, which stays below 1e-5.
"""

import argparse
import math
import os
import pathlib
import sys
import tempfile

import peers
from worlds import GRAVITY, WORLDS, rectangle

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # systems of three unknowns: threads would only wait for each other

ANGLE = math.radians(30)
LENGTH, DEPTH = 40.0, 1.0  # of the incline, m
WIDTH, HEIGHT, MASS = 1.0, 0.5, 1.0  # of the block
CASES = {"slides": 0.3, "holds": math.tan(ANGLE) * 1.001}  # friction


def turned(x, y):
    """A point along and above the incline in the frame of the ground."""
    point = complex(x, y) * complex(math.cos(ANGLE), -math.sin(ANGLE))
    return point.real, point.imag


def along(x, y):
    return x * math.cos(ANGLE) - y * math.sin(ANGLE)


def exact(friction, time):
    return max(0.0, math.sin(ANGLE) - friction * math.cos(ANGLE)) * GRAVITY / 2 * time**2


def by_world(name, friction, time, step):
    """How far the block has come along the incline, and the seconds that took."""
    world = WORLDS[name](friction)
    world.add(rectangle(LENGTH, DEPTH), 0, turned(0, -DEPTH / 2), -ANGLE)
    block = world.add(rectangle(WIDTH, HEIGHT), MASS, turned(0, HEIGHT / 2), -ANGLE)
    begin = along(*world.state(block)[:2])
    begun = peers.spent()
    for _ in range(peers.whole(time, step)):
        world.step(step)
    return along(*world.state(block)[:2]) - begin, peers.spent() - begun


def by_siconos(friction, time, step):
    """The same by Siconos."""
    import numpy
    import siconos.kernel as kernel
    import siconos.numerics as numerics

    inertia = MASS * (WIDTH**2 + HEIGHT**2) / 12
    body = kernel.LagrangianLinearTIDS([0, 0, 0], [0, 0, 0], numpy.diag([MASS, MASS, inertia]))
    weight = MASS * GRAVITY
    body.setFExtPtr([weight * math.sin(ANGLE), -weight * math.cos(ANGLE), 0])
    system = kernel.NonSmoothDynamicalSystem(0, time)
    system.insertDynamicalSystem(body)
    for x in (-WIDTH / 2, WIDTH / 2):
        law = kernel.NewtonImpactFrictionNSL(0, 0, friction, 2)
        relation = kernel.LagrangianLinearTIR([[0, 1, x], [1, 0, HEIGHT / 2]])
        system.link(kernel.Interaction(law, relation), body)
    impulses = kernel.FrictionContact(2, numerics.SICONOS_FRICTION_2D_LEMKE)
    steps = kernel.TimeStepping(system, kernel.TimeDiscretisation(0, step), kernel.MoreauJeanOSI(0.5), impulses)
    begun = peers.spent()
    for _ in range(peers.whole(time, step)):
        steps.computeOneStep()
        steps.nextStep()
    return body.q()[0], peers.spent() - begun


def by_cspace(program, friction, time):
    """The same by cspace."""
    incline = [(-LENGTH / 2, -DEPTH), (LENGTH / 2, -DEPTH), (LENGTH / 2, 0), (-LENGTH / 2, 0)]
    block = [(-WIDTH / 2, 0), (WIDTH / 2, 0), (WIDTH / 2, HEIGHT), (-WIDTH / 2, HEIGHT)]
    corners = [[list(turned(*corner)) for corner in loop] for loop in (incline, block)]
    text = f"""unit = "m"
gravity = [0, -{GRAVITY}]
friction = {friction}
part = [
  {{ name = "incline", motion = {{ type = "fixed" }}, loops = [{corners[0]}] }},
  {{ name = "block", mass = {MASS}, loops = [{corners[1]}] }},
]
"""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "ramp.toml"
        file.write_text(text)
        answer, seconds = peers.simulated(program, file, time)
    return along(*answer["samples"][-1]["block"][:2]), seconds


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cspace", default="cspace")
    parser.add_argument("--peers", nargs="+", choices=["Siconos", *WORLDS], default=["Siconos", *WORLDS])
    parser.add_argument("--steps", type=float, nargs="+", default=[1 / 60, 1 / 240, 1e-3, 1e-4])
    parser.add_argument("--time", type=float, default=2.0)
    options = parser.parse_args()
    peers.row("after", *(f"{case}, m, friction {friction:.5f}" for case, friction in CASES.items()))
    peers.row(*["---"] * (1 + len(CASES)))
    peers.row("formula", *(f"{exact(friction, options.time):.12g}" for friction in CASES.values()))

    def told(name, follow):
        cells = []
        for friction in CASES.values():
            place, seconds = follow(friction)
            cells.append(f"{place - exact(friction, options.time):.2g} off in {seconds:.2g} s")
        peers.row(name, *cells)

    told("`cspace`", lambda friction: by_cspace(options.cspace, friction, options.time))
    for name in options.peers:
        try:
            for step in options.steps:
                follow = by_siconos if name == "Siconos" else lambda *given: by_world(name, *given)  # noqa: B023
                told(f"{name}, {step:.3g} s", lambda friction: follow(friction, options.time, step))  # noqa: B023
        except ImportError as missing:
            print(f"{name} is left out: {missing}", file=sys.stderr)


if __name__ == "__main__":
    main()
