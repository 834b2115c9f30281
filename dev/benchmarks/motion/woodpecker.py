#!/usr/bin/env python3
"""The period of the woodpecker toy: Moreau's time stepping, Siconos and pymunk beside `cspace simulate`.

    dev/benchmarks/motion/run woodpecker
    dev/benchmarks/motion/run woodpecker --budget 20 --peers moreau siconos
    dev/benchmarks/motion/run woodpecker --glocker

The toy of models/woodpecker.toml comes into a cycle: each period is 0.31 times as far from the limit as the one before, on the other side. Every
program starts where the model starts and follows the toy for 1.6 s; its period is the mean of the last four. Peers begin with the step
`--first`, in seconds, and divide it by 4 while the run is expected to take less than `--budget` seconds.

- `moreau` is woodpecker.c: the equations of motion written out by hand from the model's dimensions, and the scheme of Moreau for them.
- `siconos` is its MoreauJeanOSI of the same equations, which it calls as a plug-in, with Lemke's method for the impulses.
- `pymunk` moves two bodies with a pivot and a rotary spring: the two sides of the sleeve's bore as boxes, the beak as a circle.

Peers count a period from one fall of the bird's angle through -0.3 to the next, cspace from one stroke of the beak to the next. Errors are relative,
against cspace over 4 s. That would hide an error of cspace; so the limit of each peer is printed as well: its periods, taken to be of
first order in the step, extrapolated from the two smallest steps to a step of 0.

Timed is processor time: of the peers that of the steps, of cspace that of the whole process. Below the runs of each peer stand the order at which its
error falls with the step, and the seconds that 1e-6 takes: measured where a run reached it, otherwise extrapolated from the last run.

With `--glocker` peers follow Glocker's own equations, linear in the angles, for 6 s. No model file has these. The period that is compared
with is the one in crates/cspace-motion/tests/dynamic.rs, by the code of cspace that goes from event to event.
"""

import argparse
import ctypes
import math
import os
import pathlib
import sys
import tempfile
import tomllib

import peers

os.environ["OPENBLAS_NUM_THREADS"] = "1"  # systems of four unknowns: threads would only wait for each other

LEVEL = -0.3  # rad
LAST = 4  # periods that the mean is taken of
WANTED = 1e-6
GLOCKER = 0.145976065  # s


class Toy:
    """The numbers of the model file, and the compiled equations."""

    def __init__(self, file, glocker, folder):
        model = tomllib.loads(file.read_text())
        pole, sleeve, bird = model["part"]
        self.model, self.bird = model, bird
        self.arm = model["joint"][0]["at"][0]
        self.body = bird["center_of_mass"][0] - self.arm
        self.pole = pole["loops"][0][1][0]
        self.left, self.right = sleeve["loops"]
        p, q = (complex(*vertex[:2]) for vertex in bird["loops"][0][:2])
        bulge = bird["loops"][0][0][2]
        centre = (p + q) / 2 + (q - p) / 2 * 1j * (1 - bulge * bulge) / (2 * bulge)
        self.beak, self.tip = centre - self.arm, abs(p - centre)
        corners = [self.right[0], self.right[-1], self.left[1], self.left[2]]
        self.friction = [model["friction"]] * 5
        self.restitution = [model["restitution"]] * 4 + [model["pair"][1]["restitution"]]
        self.masses, self.inertias = (sleeve["mass"], bird["mass"]), (sleeve["inertia"], bird["inertia"])
        self.stiffness, self.gravity = model["spring"][0]["stiffness"], -model["gravity"][1]
        self.q = [*sleeve["start"], bird["start"][2]]
        self.v = [*sleeve["rate"], bird["rate"][2]]
        if glocker:  # the sleeve lies on the pole
            self.q[2] = -(self.right[0][0] - self.pole) / abs(self.right[0][1])
        numbers = [*self.masses, *self.inertias, self.arm, self.body, self.stiffness, self.gravity, self.pole]
        numbers += [x for corner in corners for x in corner[:2]]
        numbers += [self.beak.real, self.beak.imag, self.tip, *self.friction, *self.restitution, float(glocker)]
        self.compiled, self.plugin = peers.compiled(pathlib.Path(__file__).with_suffix(".c"), folder, "toy", numbers)


class Crossings:
    """Times at which the bird's angle falls through the level."""

    def __init__(self, angle):
        self.angle, self.times = angle, []

    def add(self, end, step, angle):
        if self.angle > LEVEL >= angle:
            self.times.append(end - step * (LEVEL - angle) / (self.angle - angle))
        self.angle = angle


def by_moreau(toy, step, seconds):
    room = 1000
    double, state, list_of = ctypes.c_double, ctypes.c_double * 4, ctypes.c_double * room
    q, v, times = state(*toy.q), state(*toy.v), list_of()
    toy.compiled.moreau.argtypes = [double, ctypes.c_long, double, state, state, list_of, ctypes.c_int]
    found = toy.compiled.moreau(step, round(seconds / step), LEVEL, q, v, times, room)
    if found < 0:
        raise RuntimeError(f"moreau: the impulses of a step of {step:g} s do not converge; take another step")
    return times[:found]


def by_siconos(toy, step, seconds):
    import siconos.kernel as kernel
    import siconos.numerics as numerics

    plugin = toy.plugin
    body = kernel.LagrangianDS(toy.q, toy.v, f"{plugin[:-3]}:masses")
    body.setComputeFIntFunction(plugin, "forces")
    system = kernel.NonSmoothDynamicalSystem(0, seconds)
    system.insertDynamicalSystem(body)
    for k, (friction, restitution) in enumerate(zip(toy.friction, toy.restitution)):
        law = kernel.NewtonImpactFrictionNSL(restitution, 0, friction, 2)
        relation = kernel.LagrangianScleronomousR(f"{plugin[:-3]}:gap{k}", f"{plugin[:-3]}:rows{k}")
        system.link(kernel.Interaction(law, relation), body)
    impulses = kernel.FrictionContact(2, numerics.SICONOS_FRICTION_2D_LEMKE)
    steps = kernel.TimeStepping(system, kernel.TimeDiscretisation(0, step), kernel.MoreauJeanOSI(0.5), impulses)
    steps.setNewtonTolerance(1e-10)
    seen = Crossings(toy.q[3])
    for k in range(1, round(seconds / step) + 1):
        steps.computeOneStep()
        seen.add(k * step, step, body.q()[3])
        steps.nextStep()
    return seen.times


def by_pymunk(toy, step, seconds):
    import pymunk

    space = pymunk.Space()
    space.gravity = (0, -toy.gravity)
    # With 30 iterations the impulses of the wedged sleeve do not converge, and the period is 0.128 s for every step.
    space.iterations, space.collision_slop, space.collision_bias = 300, 1e-7, 0.0
    pole = pymunk.Poly(space.static_body, [(x, y) for x, y in toy.model["part"][0]["loops"][0]])
    pole.friction = pole.elasticity = 1  # those of two shapes are multiplied
    sleeve, bird = (pymunk.Body(mass, inertia) for mass, inertia in zip(toy.masses, toy.inertias))
    sleeve.position, sleeve.angle = tuple(toy.q[:2]), toy.q[2]
    sleeve.velocity, sleeve.angular_velocity = tuple(toy.v[:2]), toy.v[2]
    centre, angle = toy.arm + toy.body, toy.q[3]
    away = centre * complex(math.cos(angle), math.sin(angle))
    x, y, _ = toy.bird["start"]
    vx, vy, omega = toy.bird["rate"]
    bird.position, bird.angle = (x + away.real, y + away.imag), angle
    bird.velocity, bird.angular_velocity = (vx - omega * away.imag, vy + omega * away.real), omega
    right = [toy.right[0], toy.right[1], toy.right[-2], toy.right[-1]]
    walls = [pymunk.Poly(sleeve, [tuple(v[:2]) for v in loop]) for loop in (toy.left, right)]
    beak = pymunk.Circle(bird, toy.tip, (toy.beak.real - toy.body, toy.beak.imag))
    for shape, of in (*((wall, 0) for wall in walls), (beak, 4)):
        shape.friction, shape.elasticity = toy.friction[of], toy.restitution[of]
        shape.filter = pymunk.ShapeFilter(group=1)
    hinge = pymunk.PivotJoint(sleeve, bird, (toy.arm, 0), (-toy.body, 0))
    spring = pymunk.DampedRotarySpring(sleeve, bird, 0, toy.stiffness, 0)
    space.add(pole, sleeve, bird, *walls, beak, hinge, spring)
    seen = Crossings(angle)
    for k in range(1, round(seconds / step) + 1):
        space.step(step)
        seen.add(k * step, step, bird.angle)
    return seen.times


def by_cspace(program, file, seconds):
    answer, _ = peers.simulated(program, file, seconds)
    return [event["t"] for event in answer["events"] if event["kind"] == "impact" and event["moving"] == "bird"]


def period(times):
    """The mean of the last periods; not a number where there are too few, as the toy is stuck, or lost."""
    return (times[-1] - times[-1 - LAST]) / LAST if len(times) > LAST else math.nan


def timed(function, *arguments):
    begun = peers.spent()
    times = function(*arguments)
    return period(times), peers.spent() - begun


def refine(name, follow, options, reference):
    """Runs a peer with ever smaller steps; prints each, its order, its limit and what the wanted error takes."""
    step, runs, spent = options.first, [], 0.0
    while not runs or 4 * spent < options.budget:
        found, spent = timed(follow, step)
        runs.append((step, found, abs(found / reference - 1), spent))
        print(f"{name:<10}{step:>12.3g}{found:>16.10f}{runs[-1][2]:>12.2g}{spent:>12.2f}", flush=True)
        step /= 4
    words = peers.cost([(run[0], run[2], run[3]) for run in runs], WANTED)
    if len(runs) > 1:
        limit = runs[-1][1] + (runs[-1][1] - runs[-2][1]) / 3
        words += f"; limit {limit:.9f} s, {abs(limit / reference - 1):.1g} off"
    print(f"  {words}", flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cspace", default="cspace")
    parser.add_argument("--peers", nargs="+", choices=["moreau", "siconos", "pymunk"], default=["moreau", "siconos", "pymunk"])
    parser.add_argument("--first", type=float, default=2.56e-5)
    parser.add_argument("--budget", type=float, default=100.0)
    parser.add_argument("--glocker", action="store_true")
    options = parser.parse_args()
    file = pathlib.Path(__file__).resolve().parents[3] / "models" / "woodpecker.toml"
    seconds = 6.0 if options.glocker else 1.6
    print(f"{'program':<10}{'step, s':>12}{'period, s':>16}{'error':>12}{'seconds':>12}")
    reference = GLOCKER
    if not options.glocker:
        reference, _ = timed(by_cspace, options.cspace, str(file), 4.0)
        found, spent = timed(by_cspace, options.cspace, str(file), seconds)
        print(f"{'cspace':<10}{'':>12}{found:>16.10f}{abs(found / reference - 1):>12.2g}{spent:>12.2f}", flush=True)
    followed = {"moreau": by_moreau, "siconos": by_siconos, "pymunk": by_pymunk}
    with tempfile.TemporaryDirectory() as folder:
        toy = Toy(file, options.glocker, folder)
        for name in options.peers:
            if name == "pymunk" and options.glocker:
                continue  # bodies turn: it has no linear equations
            try:
                refine(name, lambda step: followed[name](toy, step, seconds), options, reference)
            except (ImportError, RuntimeError) as why:
                print(f"{name} is left out: {why}", file=sys.stderr)


if __name__ == "__main__":
    main()
