"""The command: `python -m cspace`, or `cspace` where the package is installed."""

import sys

from . import _step
from ._rust import command


def main() -> None:
    """Runs the command with the arguments of the process, and ends it with the command's exit code."""
    sys.stdout.flush()
    if any(map(_step.is_step, sys.argv[1:])):
        sys.exit(_step.run(sys.argv[1:]))
    sys.exit(command(["cspace", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
