"""What tests have in common."""

import os
import pathlib

import pytest

import cspace as cs

ROOT = pathlib.Path(__file__).parents[3]

PEG = """
name = "peg in its slot"
[parameter]
peg = 10
play = 0.1
high = 18
[[part]]
name = "slot"
loops = [[{ mirror = "y", path = [[0, -35], [30, -35], [30, 0], ["(peg + play)/2", 0], ["(peg + play)/2", -30]] }]]
[[part]]
name = "peg"
loops = [[["-peg/2", "-high/2"], ["peg/2", "-high/2"], ["peg/2", "high/2"], ["-peg/2", "high/2"]]]
[[requirement]]
name = "tilt"
measure = "play"
of = "theta"
at = { y = -15 }
limits = ["0deg", "0.7deg"]
[[requirement]]
name = "comes out"
measure = "connected"
at = { y = -15 }
to = [0, 50, 0]
equals = true
"""


@pytest.fixture
def peg():
    return cs.Model.loads(PEG)


@pytest.fixture
def models():
    return ROOT / "models"


@pytest.fixture
def command():
    """The command, if it has been built: what it prints is compared with."""
    for folder in ("debug", "release"):
        path = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / folder / "cspace"
        if path.exists():
            return str(path)
    pytest.skip("the command is not built")
