"""The maps that `cspace.sweep` and `cspace.monte_carlo` take: here, on all processors, on a cluster."""

import argparse
import concurrent.futures
import contextlib

import cspace as cs


def arguments(description, rows):
    """The arguments of an example: how many rows, and where they are computed."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=rows)
    parser.add_argument("--map", choices=["here", "processes", "joblib", "dask", "ray"], default="here")
    parser.add_argument("--workers", type=int, default=None)
    return parser.parse_args()


@contextlib.contextmanager
def chosen(name, workers):
    """The map of a name; None for one process."""
    if name == "here":
        cs.set_threads(1)
        yield None
    elif name == "processes":
        with concurrent.futures.ProcessPoolExecutor(workers) as executor:
            yield executor.map
    elif name == "joblib":
        from joblib import Parallel, delayed

        with Parallel(workers or -1) as parallel:
            yield lambda function, tasks: parallel(delayed(function)(task) for task in tasks)
    elif name == "dask":
        from distributed import Client

        with Client(n_workers=workers, threads_per_worker=1) as client:
            yield client.get_executor().map
    else:
        from ray.util.multiprocessing import Pool

        with Pool(workers) as pool:
            yield pool.map
