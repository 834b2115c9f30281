#!/usr/bin/env python3
"""A Geneva drive, turn for turn: pymunk, Box2D and Siconos beside `cspace simulate`.

    dev/benchmarks/motion/run geneva             # makes an environment with the peers, then this
    dev/benchmarks/motion/run geneva --turns 3 --steps 1e-3 1e-4

The wheel of models/geneva.toml turns by 60 deg for each turn of its driver. Two errors are printed, at worst of all turns but the first, in which
the wheel comes to where the driver leaves it: how far a turn is from 60 deg, and how far the wheel is from where it has to be
while the pin drives it. Where that is follows from a triangle: the pin's middle lies beside that of the slot by the play. A brake, stronger than the
wheel's inertia, holds the wheel where nothing pushes it, as in the kinematic mode of `cspace simulate`.

- `pymunk` moves convex polygons: outlines become chords that are nowhere farther from the arcs than `--chord`, cut into convex pieces by pymunk itself.
  The driver is a kinematic body of constant rate, the brake a motor. Settings are as pymunk has them, and in `tightened` contacts
  that may overlap by 1e-5 and not by 0.1, 30 iterations and not 10.
- `box2d` moves the same pieces, with 8 and 3 iterations. It is in single precision: in steps of 1e-5 s the driver itself is 1.7 deg too far
  after three turns.
- `siconos` has the arcs: its MoreauJeanOSI calls geneva.c for the gap between each circle of the driver and the wheel's outline. The
  driver turns by an inertia of 1e20, and the brake is a damper that stops the wheel within milliseconds.

Timed is processor time: of the peers that of the steps, without the making of their pieces; of cspace that of the whole process: reading the
model, the configuration space, the motion, printing. Below the runs of each peer stand the orders at which the two errors fall with the step, and the
seconds that 1e-9 deg take: measured where a run reached it, otherwise extrapolated from the last run by that order.
"""

import argparse
import itertools
import math
import os
import pathlib
import sys
import tempfile
import tomllib

import peers

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # systems of three unknowns: threads would only wait for each other

STEP = 60.0  # degrees of the wheel for a turn of the driver
CRANK, DISTANCE, PLAY = 30.0, 60.0, 0.1
WANTED = 1e-9  # degrees
MASS, INERTIA, BRAKE = 0.1, 0.5 * 0.1 * 50**2, 2e4  # of the wheel, kg and mm
BRAKED = 1e-3  # s in which Siconos's brake takes the wheel's rate to 1/e
PEERS = ["siconos", "pymunk", "tightened", "box2d"]
# When in a turn the wheel is looked at: seconds in which the pin drives it, and the end.
TIMES = [round(0.38 + 0.02 * k, 2) for k in range(13)] + [1.0]


def edges(loop):
    """The edges of a loop of vertices with bulges: both ends, the centre, the sweep of an arc in radians, 0 of a line."""
    for vertex, following in zip(loop, loop[1:] + loop[:1]):
        p, q = complex(*vertex[:2]), complex(*following[:2])
        bulge = vertex[2] if len(vertex) > 2 else 0
        centre = (p + q) / 2 + ((q - p) / 2 * 1j * (1 - bulge * bulge) / (2 * bulge) if bulge else 0)
        yield p, q, centre, 4 * math.atan(bulge)


def outline(loop, chord):
    """A loop of vertices with bulges as points, its arcs as chords within `chord` of them."""
    points = []
    for p, _, centre, sweep in edges(loop):
        points.append(p)
        if sweep == 0:
            continue
        radius = abs(p - centre)
        pieces = math.ceil(abs(sweep) / (2 * math.acos(max(0, 1 - chord / radius))))
        points += [centre + (p - centre) * complex(math.cos(a), math.sin(a))
                   for a in (sweep * k / pieces for k in range(1, pieces))]
    return points


def convex_pieces(points):
    """Counter-clockwise convex polygons that make up a polygon."""
    from pymunk import autogeometry

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
    import pymunk

    space = pymunk.Space()
    if tight:
        space.iterations, space.collision_slop, space.collision_bias = 30, 1e-5, 0.0
    bodies = {}
    for part in model["part"]:
        if part["name"] == "driver":
            body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
            body.angular_velocity = 2 * math.pi
        else:
            body = pymunk.Body(MASS, INERTIA)
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
    brake.max_force = BRAKE
    space.add(pymunk.PivotJoint(wheel, space.static_body, wheel.position), brake)
    return stepped(turns, step, lambda: space.step(step), lambda: wheel.angle)


def divided(piece, most):
    """A convex polygon as some of no more than so many corners."""
    while len(piece) > most:
        yield piece[:most]
        piece = [piece[0], *piece[most - 1:]]
    yield piece


def by_box2d(model, turns, step, chord):
    """The same by Box2D."""
    import Box2D

    world = Box2D.b2World(gravity=(0, 0), doSleep=False)
    bodies = {}
    for part in model["part"]:
        create = world.CreateKinematicBody if part["name"] == "driver" else world.CreateDynamicBody
        body = create(position=part["motion"]["center"])
        pieces, circles = shapes(part, chord)
        few = itertools.chain.from_iterable(divided(piece, Box2D.b2_maxPolygonVertices - 1) for piece in pieces)
        made = [Box2D.b2PolygonShape(vertices=piece) for piece in few]
        for shape in made:
            shape.radius = 0.0  # of its rim, which would take a tenth of the play
        made += [Box2D.b2CircleShape(radius=radius, pos=(centre.real, centre.imag)) for centre, radius in circles]
        for shape in made:
            body.CreateFixture(shape=shape, density=1.0, friction=0.0, restitution=0.0, groupIndex=-1 - len(bodies))
        bodies[part["name"]] = body
    bodies["driver"].angularVelocity = 2 * math.pi
    wheel = bodies["wheel"]
    wheel.massData = Box2D.b2MassData(mass=MASS, center=(0, 0), I=INERTIA)
    world.CreateRevoluteJoint(bodyA=world.CreateStaticBody(), bodyB=wheel, anchor=wheel.position,
                              enableMotor=True, motorSpeed=0.0, maxMotorTorque=BRAKE)
    return stepped(turns, step, lambda: world.Step(step, 8, 3), lambda: wheel.angle)


def stepped(turns, step, advance, angle):
    """The wheel's angles at the times of each turn, in degrees, and the seconds that took."""
    begun = peers.spent()
    angles = []
    each = round(1 / step)
    for _ in range(turns + 1):
        done = 0
        for when in TIMES:
            for _ in range(round(when * each) - done):
                advance()
            done = round(when * each)
            angles.append(math.degrees(angle()))
    return angles, peers.spent() - begun


def numbers(model):
    """The outlines of the model as geneva.c has them."""
    wheel, driver = model["part"]
    pieces, circles = [], []
    for p, q, centre, sweep in edges(wheel["loops"][0]):
        start = math.atan2((p - centre).imag, (p - centre).real)
        pieces.append([p.real, p.imag, q.real, q.imag, centre.real, centre.imag, start, sweep])
    for p, q, centre, sweep in [*list(edges(driver["loops"][0]))[:3], next(edges(driver["loops"][1]))]:
        whole = abs(sweep) < math.pi or len(circles) == 3  # the circle of a rounded corner lies within the driver, and so does the pin's
        middle = math.atan2((p - centre).imag, (p - centre).real) + sweep / 2
        place = centre - complex(*driver["motion"]["center"])
        circles.append([place.real, place.imag, abs(p - centre), middle, math.pi if whole else sweep / 2])
    all_pieces = [x for piece in pieces for x in piece] + [0.0] * 8 * (64 - len(pieces))
    return [float(len(pieces)), *all_pieces, *(x for circle in circles for x in circle), DISTANCE]


def by_siconos(plugin, turns, step):
    """The same by Siconos."""
    import numpy
    import siconos.kernel as kernel

    damping = numpy.diag([INERTIA / BRAKED, 0.0])
    body = kernel.LagrangianLinearTIDS([0, 0], [0, 2 * math.pi], numpy.diag([INERTIA, 1e20]), numpy.zeros((2, 2)), damping)
    system = kernel.NonSmoothDynamicalSystem(0, turns + 1)
    system.insertDynamicalSystem(body)
    for k in range(4):
        relation = kernel.LagrangianScleronomousR(f"{plugin[:-3]}:gap{k}", f"{plugin[:-3]}:rows{k}")
        system.link(kernel.Interaction(kernel.NewtonImpactNSL(0), relation), body)
    steps = kernel.TimeStepping(system, kernel.TimeDiscretisation(0, step), kernel.MoreauJeanOSI(0.5), kernel.LCP())
    steps.setNewtonTolerance(1e-10)

    def advance():
        steps.computeOneStep()
        steps.nextStep()

    return stepped(turns, step, advance, lambda: body.q()[0])


def by_cspace(program, file, turns):
    """The same."""
    answer, seconds = peers.simulated(program, file, turns + 1, "--every", "0.02")
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


def refine(name, follow, steps):
    """Runs a peer with each step, and prints what comes out."""
    runs = []
    for step in steps:
        angles, seconds = follow(step)
        runs.append((step, *errors(angles), seconds))
        print(f"{name:<10}{step:>10g}{runs[-1][1]:>14.3g}{runs[-1][2]:>14.3g}{seconds:>12.2f}", flush=True)
    turn, place = (peers.cost([(run[0], run[which], run[3]) for run in runs], WANTED) for which in (1, 2))
    print(f"  of a turn: {turn}; of the place: {place}", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cspace", default="cspace")
    parser.add_argument("--turns", type=int, default=2)
    parser.add_argument("--peers", nargs="+", choices=PEERS, default=PEERS)
    parser.add_argument("--steps", type=float, nargs="+", default=[1e-3, 1e-4, 1e-5])
    parser.add_argument("--chord", type=float, default=1e-2)
    options = parser.parse_args()
    file = pathlib.Path(__file__).resolve().parents[3] / "models" / "geneva.toml"
    model = tomllib.loads(file.read_text())
    print(f"{options.turns} turns after the first; errors in degrees")
    print(f"{'program':<10}{'step, s':>10}{'of a turn':>14}{'of the place':>14}{'seconds':>12}")
    angles, seconds = by_cspace(options.cspace, str(file), options.turns)
    turn, place = errors(angles)
    print(f"{'cspace':<10}{'':>10}{turn:>14.3g}{place:>14.3g}{seconds:>12.2f}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        _, plugin = peers.compiled(pathlib.Path(__file__).with_suffix(".c"), folder, "drive", numbers(model))
        followed = {
            "siconos": lambda step: by_siconos(plugin, options.turns, step),
            "pymunk": lambda step: by_pymunk(model, options.turns, step, options.chord, False),
            "tightened": lambda step: by_pymunk(model, options.turns, step, options.chord, True),
            "box2d": lambda step: by_box2d(model, options.turns, step, options.chord),
        }
        for name in options.peers:
            try:
                refine(name, followed[name], options.steps)
            except ImportError as missing:
                print(f"{name} is left out: {missing}", file=sys.stderr)


if __name__ == "__main__":
    main()
