#!/usr/bin/env python3
"""A Geneva drive, turn for turn: pymunk beside `cspace simulate`.

    dev/benchmarks/motion/run                    # makes an environment with pymunk, then this
    dev/benchmarks/motion/run --turns 3 --steps 1e-3 1e-4

The wheel of models/geneva.toml turns by 60 deg for each turn of its driver. Two errors are told, at worst of all turns but the first, in which
the wheel comes to where the driver leaves it: how far a turn is from 60 deg, and how far the wheel is from where it has to be
while the pin drives it. Where that is follows from a triangle: the pin's middle lies beside that of the slot by the play. pymunk moves convex polygons: outlines become chords that
are nowhere farther from the arcs than `--chord`, cut into convex pieces by pymunk itself. The driver is a kinematic body of constant
rate; a brake, stronger than the wheel's inertia, holds the wheel where nothing pushes it, as in the kinematic mode of `cspace simulate`. Settings are given as pymunk
has them, and tightened: contacts that may overlap by 1e-5 and not by 0.1, 30 iterations and not 10.

Timed is what a user waits for: of pymunk the steps, without the making of its pieces; of cspace the whole process: reading the
model, the configuration space, the motion, printing.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import time
import tomllib

import pymunk
from pymunk import autogeometry

STEP = 60.0  # degrees of the wheel for a turn of the driver
CRANK, DISTANCE, PLAY = 30.0, 60.0, 0.1
# When in a turn the wheel is looked at: seconds in which the pin drives it, and the end.
TIMES = [round(0.38 + 0.02 * k, 2) for k in range(13)] + [1.0]


def outline(loop, chord):
    """A loop of vertices with bulges as points, its arcs as chords within `chord` of them."""
    points = []
    for vertex, following in zip(loop, loop[1:] + loop[:1]):
        p, q = complex(*vertex[:2]), complex(*following[:2])
        points.append(p)
        bulge = vertex[2] if len(vertex) > 2 else 0
        if bulge == 0:
            continue
        sweep = 4 * math.atan(bulge)
        centre = (p + q) / 2 + (q - p) / 2 * 1j * (1 - bulge * bulge) / (2 * bulge)
        radius = abs(p - centre)
        pieces = math.ceil(abs(sweep) / (2 * math.acos(max(0, 1 - chord / radius))))
        points += [centre + (p - centre) * complex(math.cos(a), math.sin(a))
                   for a in (sweep * k / pieces for k in range(1, pieces))]
    return points


def convex_pieces(points):
    """Counter-clockwise convex polygons that make up a polygon."""
    area = sum((p.conjugate() * q).imag for p, q in zip(points, points[1:] + points[:1]))
    ordered = points if area > 0 else points[::-1]
    closed = [(p.real, p.imag) for p in ordered]
    return autogeometry.convex_decomposition(closed + closed[:1], 0)


def shapes(part, chord):
    """The pieces of a part, and its circles, about the centre that it turns about."""
    cx, cy = part["motion"]["center"]
    pieces, circles = [], []
    for loop in part["loops"]:
        if len(loop) == 2 and all(abs(v[2]) == 1 for v in loop):
            p, q = (complex(*v[:2]) for v in loop)
            circles.append(((p + q) / 2 - complex(cx, cy), abs(p - q) / 2))
            continue
        moved = [p - complex(cx, cy) for p in outline(loop, chord)]
        pieces += convex_pieces(moved)
    return pieces, circles


def by_pymunk(model, turns, step, chord, tight):
    """The wheel's angles at the times of each turn, in degrees, and the seconds that took."""
    space = pymunk.Space()
    if tight:
        space.iterations, space.collision_slop, space.collision_bias = 30, 1e-5, 0.0
    bodies = {}
    for part in model["part"]:
        if part["name"] == "driver":
            body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
            body.angular_velocity = 2 * math.pi
        else:
            body = pymunk.Body(0.1, 0.5 * 0.1 * 50**2)
        body.position = tuple(part["motion"]["center"])
        pieces, circles = shapes(part, chord)
        made = [pymunk.Poly(body, piece) for piece in pieces]
        made += [pymunk.Circle(body, radius, (centre.real, centre.imag)) for centre, radius in circles]
        for shape in made:
            shape.friction = shape.elasticity = 0
            shape.filter = pymunk.ShapeFilter(group=1 + len(bodies))
        space.add(body, *made)
        bodies[part["name"]] = body
    wheel = bodies["wheel"]
    brake = pymunk.SimpleMotor(wheel, space.static_body, 0)
    brake.max_force = 2e4
    space.add(pymunk.PivotJoint(wheel, space.static_body, wheel.position), brake)
    begun = time.perf_counter()
    angles = []
    each = round(1 / step)
    for _ in range(turns + 1):
        done = 0
        for when in TIMES:
            for _ in range(round(when * each) - done):
                space.step(step)
            done = round(when * each)
            angles.append(math.degrees(wheel.angle))
    return angles, time.perf_counter() - begun


def by_cspace(program, file, turns):
    """The same."""
    begun = time.perf_counter()
    command = [program, "simulate", file, "--time", str(turns + 1), "--every", "0.02", "--format", "json"]
    answer = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    seconds = time.perf_counter() - begun
    samples = answer["samples"]
    return [math.degrees(samples[round(50 * (turn + when))]["wheel"]) for turn in range(turns + 1) for when in TIMES], seconds


def errors(angles):
    """How far the worst turn after the first is from a step, and how far the wheel is from its place while it is driven."""
    ends = angles[len(TIMES) - 1::len(TIMES)]
    turn = max(abs(abs(b - a) - STEP) for a, b in zip(ends, ends[1:]))
    place = 0.0
    for i, angle in enumerate(angles[len(TIMES):]):
        when = TIMES[i % len(TIMES)]
        if when == 1.0:
            continue
        pin = DISTANCE + CRANK * complex(math.cos(2 * math.pi * when), math.sin(2 * math.pi * when))
        slot = math.degrees(math.atan2(pin.imag, pin.real) + math.asin(PLAY / abs(pin)))
        place = max(place, abs((angle - (slot - STEP / 2) + STEP / 2) % STEP - STEP / 2))
    return turn, place


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cspace", default="cspace")
    parser.add_argument("--turns", type=int, default=2)
    parser.add_argument("--steps", type=float, nargs="+", default=[1e-3, 1e-4, 1e-5])
    parser.add_argument("--chord", type=float, default=1e-2)
    options = parser.parse_args()
    file = pathlib.Path(__file__).resolve().parents[3] / "models" / "geneva.toml"
    model = tomllib.loads(file.read_text())
    print(f"{options.turns} turns after the first; errors in degrees")
    print(f"{'program':<22}{'step, s':>10}{'of a turn':>14}{'of the place':>14}{'seconds':>12}")
    for tight in (False, True):
        for step in options.steps:
            angles, seconds = by_pymunk(model, options.turns, step, options.chord, tight)
            name = f"pymunk{' tightened' if tight else ''}"
            turn, place = errors(angles)
            print(f"{name:<22}{step:>10g}{turn:>14.3g}{place:>14.3g}{seconds:>12.3f}", flush=True)
    angles, seconds = by_cspace(options.cspace, str(file), options.turns)
    turn, place = errors(angles)
    print(f"{'cspace':<22}{'':>10}{turn:>14.3g}{place:>14.3g}{seconds:>12.3f}")
    print(f"pymunk {pymunk.version}, Python {sys.version.split()[0]}", file=sys.stderr)


if __name__ == "__main__":
    main()
