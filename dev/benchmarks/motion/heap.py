#!/usr/bin/env python3
"""Discs and boxes that fall into a bin: pymunk and Box2D beside `cspace simulate`.

    dev/benchmarks/motion/run heap
    dev/benchmarks/motion/run heap --bodies 20 --seed 3 --steps 1e-4

Where they come to lie nobody knows, and programs differ, as the motion is chaotic. But bodies do not overlap, in the end each touches
another or the bin, and as nothing bounces and nothing drives them, the sum of kinetic and potential energy never rises. Printed are, of
frames 0.05 s apart, the deepest overlap of all and that of the last; how far the body that touches nothing in the last is from all others;
by how much the energy ever rises above what it was in a frame before, as a part of what is lost in all; and processor seconds for each
simulated second, of the peers those of the steps, of cspace those of the whole process. All but the seconds is computed here from shapes
and states, for all programs alike.

Siconos has no shapes of its own to find contacts of a heap with, and is left out.
"""

import argparse
import itertools
import math
import pathlib
import random
import sys
import tempfile

import peers
from worlds import GRAVITY, WORLDS, inertia, rectangle

FRICTION = 0.3
FRAME = 0.05  # s
BIN, WALL = 1.5, 1.0  # width within, thickness of its floor and sides, m
ACROSS = 3  # bodies in a row at the start
PITCH = 0.45  # of their places; no body is longer


def heap(count, seed):
    """Bodies as (shape, mass, place, angle), none of them near another."""
    dice = random.Random(seed)
    bodies = []
    for k in range(count):
        place = ((k % ACROSS - (ACROSS - 1) / 2) * PITCH, (k // ACROSS + 1) * PITCH)
        width, height = dice.uniform(0.2, 0.35), dice.uniform(0.15, 0.25)
        shape = rectangle(width, height) if k % 2 else height / 2
        mass = width * height if k % 2 else math.pi * height**2 / 4
        bodies.append((shape, mass, place, dice.uniform(0, math.pi)))
    return bodies


def sides(count):
    """The bin as three boxes that stand: their shapes and places."""
    height = (count // ACROSS + 3) * PITCH
    tall, flat = rectangle(WALL, height + WALL), rectangle(BIN + 2 * WALL, WALL)
    across, up = (BIN + WALL) / 2, (height - WALL) / 2
    return [(flat, (0, -WALL / 2)), (tall, (-across, up)), (tall, (across, up))]


def placed(shape, x, y, angle):
    """The corners of a shape where it lies, its radius, 0 of a polygon, and the normals of its edges."""
    if isinstance(shape, float):
        return [complex(x, y)], shape, []
    turn = complex(math.cos(angle), math.sin(angle))
    points = [complex(x, y) + turn * complex(*corner) for corner in shape]
    return points, 0.0, [1j * (q - p) / abs(q - p) for p, q in zip(points, points[1:] + points[:1])]


def apart(one, other):
    """How far two convex bodies are apart, less than 0 where they overlap: then by how far one has to be moved to be clear of the other."""
    (a, radius, normals), (b, radius_b, normals_b) = one, other
    axes = normals + normals_b
    if radius or radius_b:
        axes = axes + [(q - p) / abs(q - p) for p in a for q in b if p != q]
    gaps = []
    for axis in axes:
        along = [[(point * axis.conjugate()).real for point in points] for points in (a, b)]
        gaps.append(max(min(along[1]) - max(along[0]), min(along[0]) - max(along[1])))
    return max(gaps) - radius - radius_b


def nearest(bodies, fixed, states):
    """Of each body, how far it is from the nearest other."""
    stand = [placed(shape, *place, 0.0) for shape, place in fixed]
    fall = [placed(body[0], *state[:3]) for body, state in zip(bodies, states)]
    return [min(apart(one, other) for other in stand + fall if other is not one) for one in fall]


def energy(bodies, states):
    return sum(mass * ((vx * vx + vy * vy) / 2 + GRAVITY * y) + inertia(shape, mass) * omega * omega / 2
               for (shape, mass, *_), (_, y, _, vx, vy, omega) in zip(bodies, states))


def by_world(name, bodies, fixed, time, step):
    """The states of all bodies in each frame, and the seconds that took."""
    world = WORLDS[name](FRICTION)
    for shape, place in fixed:
        world.add(shape, 0, place)
    made = [world.add(*body) for body in bodies]
    frames = []
    begun = peers.spent()
    for _ in range(peers.whole(time, FRAME) + 1):
        frames.append([world.state(body) for body in made])
        for _ in range(peers.whole(FRAME, step)):
            world.step(step)
    return frames, peers.spent() - begun


def text_of(bodies, fixed):
    """The model file: bodies drawn about the origin, and put in place by `start`."""
    out = [f'unit = "m"\ngravity = [0, -{GRAVITY}]\nfriction = {FRICTION}\n']
    for k, (shape, place) in enumerate(fixed):
        corners = [[x + place[0], y + place[1]] for x, y in shape]
        out.append(f'[[part]]\nname = "side{k}"\nmotion = {{ type = "fixed" }}\nloops = [{corners}]\n')
    for k, (shape, mass, place, angle) in enumerate(bodies):
        loop = [[-shape, 0, 1], [shape, 0, 1]] if isinstance(shape, float) else [list(corner) for corner in shape]
        out.append(f'[[part]]\nname = "body{k}"\nmass = {mass}\nstart = {[*place, angle]}\nloops = [{loop}]\n')
    return "".join(out)


def by_cspace(program, bodies, fixed, time):
    """The same by cspace."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "heap.toml"
        file.write_text(text_of(bodies, fixed))
        answer, seconds = peers.simulated(program, file, time, "--every", str(FRAME), "--rates")
    if answer["status"] != "done":
        print(f"cspace: {answer['status']} at {answer['until']} s", file=sys.stderr)
    names = [f"body{k}" for k in range(len(bodies))]
    return [[(*sample[name], *sample["rates"][name]) for name in names] for sample in answer["samples"]], seconds


def told(name, bodies, fixed, frames, seconds):
    """Prints what the frames show."""
    near = [nearest(bodies, fixed, states) for states in frames]
    overlaps = [max(0.0, -min(gaps)) for gaps in near]
    energies = [energy(bodies, states) for states in frames]
    rise = max(now - least for now, least in zip(energies, itertools.accumulate(energies, min)))
    lost = energies[0] - energies[-1]
    cells = [1e3 * max(overlaps), 1e3 * overlaps[-1], 1e3 * max(0.0, *near[-1]), rise / lost, seconds / ((len(frames) - 1) * FRAME)]
    peers.row(name, *(f"{value:.2g}" for value in cells))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cspace", default="cspace")
    parser.add_argument("--peers", nargs="+", choices=WORLDS, default=[*WORLDS])
    parser.add_argument("--steps", type=float, nargs="+", default=[1 / 60, 1 / 240, 1e-3, 1e-4])
    parser.add_argument("--bodies", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--time", type=float, default=2.0)
    options = parser.parse_args()
    bodies, fixed = heap(options.bodies, options.seed), sides(options.bodies)
    peers.row(f"{options.bodies} bodies, {options.time:g} s", "overlap, mm", "at the end", "hovers, mm", "rise of energy", "s for 1 s")
    peers.row(*["---"] * 6)
    told("`cspace`", bodies, fixed, *by_cspace(options.cspace, bodies, fixed, options.time))
    for name in options.peers:
        try:
            for step in options.steps:
                told(f"{name}, {step:.3g} s", bodies, fixed, *by_world(name, bodies, fixed, options.time, step))
        except ImportError as missing:
            print(f"{name} is left out: {missing}", file=sys.stderr)


if __name__ == "__main__":
    main()
