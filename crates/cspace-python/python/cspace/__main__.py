"""The command: `python -m cspace`, or `cspace` where the package is installed."""

import sys

from ._rust import command


def main() -> None:
    """Runs the command with the arguments of the process, and ends it with the command's exit code."""
    sys.stdout.flush()
    sys.exit(command(["cspace", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
