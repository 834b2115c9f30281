"""What the comparisons share: compiled equations, cspace's answer, processor time, and the order at which errors fall."""

import ctypes
import itertools
import json
import math
import os
import pathlib
import resource
import statistics
import subprocess


def compiled(source, folder, name, numbers):
    """Compiles `source` into a library in `folder`, writes the numbers into its global variable `name`; the library and its path."""
    path = str(pathlib.Path(folder) / f"{source.stem}.so")
    compiler = os.environ.get("CC", "cc")
    try:
        subprocess.run([compiler, "-O2", "-shared", "-fPIC", "-o", path, source, "-lm"], check=True)
    except FileNotFoundError:
        raise SystemExit(f"{source.name} needs a C compiler, and there is no {compiler}: install one, or set CC to its name") from None
    library = ctypes.CDLL(path)
    (ctypes.c_double * len(numbers)).in_dll(library, name)[:] = numbers
    return library, path


def spent():
    """Seconds of processor time so far, of this process and of the programs that it ran: others on the machine do not change them."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(of.ru_utime + of.ru_stime for of in used)


def simulated(program, file, time, *options):
    """What `cspace simulate` answers, and the seconds of the whole process."""
    begun = spent()
    command = [program, "simulate", str(file), "--time", str(time), *options, "--json"]
    answer = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True, text=True).stdout)
    return answer, spent() - begun


def row(*cells):
    print("| " + " | ".join(cells) + " |", flush=True)


def whole(time, step):
    """How many steps make up a time; a step that does not divide it ends the program."""
    count = round(time / step)
    if abs(count * step - time) > 1e-9 * time:
        raise SystemExit(f"steps of {step:g} s do not make up {time:g} s: give steps that divide it")
    return count


def cost(runs, wanted):
    """Of runs (step, error, seconds), the smallest step last: in words the order of the error, and the seconds that the wanted error takes.

    The order is the median of the slopes between every two runs, in logarithms: a run whose error vanishes by chance does not move it much. The seconds
    are those of the first run from which on all reached the error, or extrapolated from the last run by the order.
    """
    points = [(math.log(step), math.log(error)) for step, error, _ in runs if error > 0]
    if len(points) < 3:
        return "order unknown: that takes three steps"
    order = statistics.median((b[1] - a[1]) / (b[0] - a[0]) for a, b in itertools.combinations(points, 2))
    reached = list(itertools.takewhile(lambda run: run[1] <= wanted, reversed(runs)))
    if reached:
        return f"order {order:.2f}, {wanted:g} in {reached[-1][2]:.3g} s"
    if order < 0.5:
        return f"order {order:.2f}: {wanted:g} is out of reach"
    _, error, seconds = runs[-1]
    return f"order {order:.2f}, {wanted:g} in {seconds * (error / wanted) ** (1 / order):.3g} s (extrapolated)"
