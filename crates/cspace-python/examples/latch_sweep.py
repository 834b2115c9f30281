"""How often a bolt comes out of its catch, over random dimensions: the same function on one process, on all cores, or on a cluster.

    python latch_sweep.py --rows 1000
    python latch_sweep.py --rows 1000 --map processes
    python latch_sweep.py --rows 1000 --map dask        # pip install distributed
    python latch_sweep.py --rows 1000 --map ray         # pip install ray

It prints the yield, the time a row takes, and how many bytes are sent for one.
"""

import argparse
import concurrent.futures
import pickle
import time

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
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=200)
    parser.add_argument("--map", choices=["here", "processes", "dask", "ray"], default="here")
    parser.add_argument("--workers", type=int, default=None)
    args = parser.parse_args()
    rng = np.random.default_rng(1)
    rows = {"head": rng.normal(10, 0.1, args.rows), "mouth": rng.normal(9.1, 0.1, args.rows)}
    map, close = None, lambda: None
    if args.map == "here":
        cs.set_threads(1)
    elif args.map == "processes":
        executor = concurrent.futures.ProcessPoolExecutor(args.workers)
        map, close = executor.map, executor.shutdown
    elif args.map == "dask":
        from distributed import Client

        client = Client(n_workers=args.workers, threads_per_worker=1)
        map, close = client.get_executor().map, client.close
    else:
        from ray.util.multiprocessing import Pool

        pool = Pool(args.workers)
        map, close = pool.map, pool.close
    if map is not None:
        # Workers start with the first rows.
        cs.sweep(Held(), map=map, rows={name: column[:128] for name, column in rows.items()})
    begin = time.perf_counter()
    table = cs.sweep(Held(), map=map, rows=rows)
    seconds = time.perf_counter() - begin
    close()
    print(f"held: {np.nanmean(table['value']):.4f}, failures: {len(table.failures)}")
    print(f"{1e3 * seconds / args.rows:.3f} ms a row, function of {len(pickle.dumps(Held()))} bytes a block of 64 rows")


if __name__ == "__main__":
    main()
