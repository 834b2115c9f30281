"""How often a bolt comes out of its catch, over random dimensions: the same function on one process, on all cores, or on a cluster.

    python latch_sweep.py --rows 1000
    python latch_sweep.py --rows 1000 --map processes
    python latch_sweep.py --rows 1000 --map joblib      # pip install joblib
    python latch_sweep.py --rows 1000 --map dask        # pip install distributed
    python latch_sweep.py --rows 1000 --map ray         # pip install ray

It prints how many hold, and the time that a row takes.
"""

import time

import maps
import numpy as np

import cspace as cs

LATCH = """
[parameter]
head = 10
mouth = 9.1
lip = 4
play = 2
shoulder = "-lip - play/2"
bottom = "-lip - play - 1 - head/2"
[[part]]
name = "catch"
loops = [[[-11, "bottom - lip"], [11, "bottom - lip"], [11, 0], ["mouth/2", 0], ["mouth/2", "-lip"], [7, "-lip"],
  [7, "bottom"], [-7, "bottom"], [-7, "-lip"], ["-mouth/2", "-lip"], ["-mouth/2", 0], [-11, 0]]]
[[part]]
name = "bolt"
loops = [[["-head/2", "shoulder - 1"], { arc_to = ["head/2", "shoulder - 1"], radius = "head/2" }, ["head/2", "shoulder"],
  [2, "shoulder"], [2, 8], [-2, 8], [-2, "shoulder"], ["-head/2", "shoulder"]]]
[[requirement]]
name = "held"
measure = "caged"
"""


class Held:
    """Whether the bolt is held; it is sent to workers with its model."""

    def __init__(self):
        self.model = cs.Model.loads(LATCH)

    def __call__(self, head, mouth):
        return self.model(head=head, mouth=mouth).check()["held"].value


def main():
    args = maps.arguments(__doc__, 200)
    values = {"head": cs.distributions.normal(10, 0.1), "mouth": cs.distributions.normal(9.1, 0.1)}
    held = Held()
    with maps.chosen(args.map, args.workers) as map:
        # Workers start with the first rows.
        cs.monte_carlo(held, 128, map=map, **values)
        begin = time.perf_counter()
        table = cs.monte_carlo(held, args.rows, seed=1, map=map, **values)
        seconds = time.perf_counter() - begin
    print(f"held: {np.nanmean(table['value']):.4f}, failures: {len(table.failures)}")
    print(f"{1e3 * seconds / args.rows:.3f} ms a row")


if __name__ == "__main__":
    main()
