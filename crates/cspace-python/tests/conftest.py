"""What tests have in common."""

import os
import pathlib
import re

import pytest

import cspace as cs

ROOT = pathlib.Path(__file__).parents[3]

# The model that the documentation of requirements begins with.
PEG = re.search(r"```toml peg.toml\n(.*?)```", (ROOT / "docs/design.md").read_text(encoding="utf-8"), re.DOTALL)[1]


# The model that docstrings are about: that of the cam in docs/python.md, with a tolerance, limits and a drive.
CAM = re.search(r'Model.loads\("""\n(.*?)"""\)', (ROOT / "docs/python.md").read_text(encoding="utf-8"), re.DOTALL)[1]


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
