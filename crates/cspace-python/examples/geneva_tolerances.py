"""The play of a locked Geneva wheel over random dimensions, and how many wheels have too much or none.

    python geneva_tolerances.py --rows 1000
    python geneva_tolerances.py --rows 1000 --map processes

The model is that of `cspace new geneva`. Other maps are those of latch_sweep.py.
"""

import subprocess
import sys
import time

import maps
import numpy as np

import cspace as cs


class Play:
    """The play of the locked wheel in radians; it is sent to workers with its model."""

    def __init__(self):
        new = [sys.executable, "-m", "cspace", "new", "geneva"]
        self.model = cs.Model.loads(subprocess.run(new, capture_output=True, text=True, check=True).stdout)

    def __call__(self, **dimensions):
        pair = self.model(**dimensions).compute("driver", "wheel")
        return pair.play((0, 0))["v"].length


def main():
    args = maps.arguments(__doc__, 500)
    values = {"distance": cs.distributions.normal(60, 0.02), "disc": cs.distributions.normal(22.1, 0.02), "play": cs.distributions.triangular(0.05, 0.1, 0.15)}
    with maps.chosen(args.map, args.workers) as map:
        cs.monte_carlo(Play(), 128, map=map, **values)
        begin = time.perf_counter()
        table = cs.monte_carlo(Play(), args.rows, seed=1, map=map, **values)
        seconds = time.perf_counter() - begin
    play = np.degrees(table["value"])
    lo, middle, hi = np.nanpercentile(play, [5, 50, 95])
    print(f"play {lo:.3f} to {hi:.3f} deg in 9 of 10 wheels, {middle:.3f} in the middle one")
    print(f"above 0.35 deg: {np.mean(play > 0.35):.3f}, does not turn at all: {len(table.failures) / args.rows:.3f}")
    print(f"{1e3 * seconds / args.rows:.3f} ms a row")


if __name__ == "__main__":
    main()
