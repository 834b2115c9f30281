"""The programs in the documentation run as they stand, and print what is expected."""

import doctest
import importlib
import inspect
import pathlib
import pkgutil
import re
import shutil

import numpy as np
import pytest

import cspace as cs
from conftest import CAM, ROOT

# Modules that need another package, or run when they are imported: test_ompl.py and test_animations.py try them.
ELSEWHERE = ("__main__", "_rust", "_widget", "ompl")

EXPECTED = """\
0.1000 sideways, 0.6376 degrees
path 0.0500
6 of 24 meet the plate, the first after 16.56
line 0 of loop 0 is a line at (-5.0, -9.0)
1.8 comes out
2.0 caged
[0.1 0.1 0.1 0.1 0.1]
0.20000000000000
[{'play': 0.15
the fork goes from -2.95 to 3.00, the cam turns by 3.1416
of them have enough play 0
roof [9. 0. 0.] 9.000 flush, 0 None
drop [19.107  1.857 -0.381] 5.385 flush, 1 None
Loops(1 loop, 2 vertices) [(150.0, 150.0), (250.0, 150.0)]
(2.0, 2.0, 0)
"""


def test_the_page_runs(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    programs = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert len(programs) >= 4
    names = {}
    for program in programs:
        exec(compile(program, "docs/python.md", "exec"), names)
    printed = capsys.readouterr().out
    for line in EXPECTED.splitlines():
        assert line in printed, printed


def test_the_readme_runs(capsys, monkeypatch):
    monkeypatch.chdir(ROOT)
    (program,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    exec(compile(program, "README.md", "exec"), {})
    classes, clearance = capsys.readouterr().out.split("\n", 1)
    assert classes == "[0 1]" and abs(float(clearance) - 0.5) < 1e-9


# Why a public name has no example that runs.
WITHOUT = {
    "answers": "records of the command's answers, written from their schemas, which `Record` shows",
    "FREE": "a member of `Class`",
    "BLOCKED": "a member of `Class`",
    "CONTACT": "a member of `Class`",
    "__version__": "a text",
}


def public():
    """Every public class, function, method and property by its name."""
    for name in cs.__all__:
        found = getattr(cs, name)
        if name in WITHOUT:
            continue
        if inspect.ismodule(found):
            yield name, found
            for inner, value in vars(found).items():
                if getattr(value, "__module__", None) == found.__name__ and not inner.startswith("_"):
                    yield f"{name}.{inner}", value
            continue
        yield name, found
        if not inspect.isclass(found):
            continue
        for attribute, value in vars(found).items():
            is_told = isinstance(value, (property, classmethod, staticmethod)) or inspect.isfunction(value)
            if is_told and not attribute.startswith("_"):
                yield f"{name}.{attribute}", value


def cup():
    """The second model of docstrings, as that of the class makes it."""
    (example, *_) = [e for e in doctest.DocTestParser().get_examples(cs.Model.__doc__) if e.source.startswith("cup =")]
    names = {"cs": cs}
    exec(example.source, names)
    return names["cup"]


def test_every_public_name_has_an_example():
    names = dict(public())
    assert {"ContactSpace.move", "Part.moved", "distributions.normal", "Record.to_dict", "progress"} <= names.keys()
    without = [name for name, found in names.items() if ">>>" not in (inspect.getdoc(found) or "") and not is_told_by_class(name)]
    assert without == []


def is_told_by_class(name):
    """Whether it is a property of a record, whose example is that of its class."""
    of = getattr(cs, name.split(".")[0])
    return "." in name and inspect.isclass(of) and issubclass(of, cs.Record) and isinstance(vars(of)[name.split(".")[1]], property)


# Examples that do not run here, and why.
SKIPPED = {
    "ContactSpace.view": "the page is not in every build",
    "Part.from_cad": "build123d need not be installed: test_build123d.py",
    "Part.from_solid": "build123d need not be installed: test_build123d.py",
    "Part.to_build123d": "build123d need not be installed: test_build123d.py",
    "Part.to_cadquery": "CadQuery need not be installed: test_cadquery.py",
    "Model.from_assembly": "build123d need not be installed: test_build123d.py",
}


def test_docstrings_run(tmp_path, monkeypatch):
    for package in ("matplotlib", "PIL", "pandas", "shapely", "trimesh", "networkx", "anywidget"):
        pytest.importorskip(package)
    monkeypatch.setenv("MPLBACKEND", "agg")
    assert {name for name, found in public() if "+SKIP" in (inspect.getdoc(found) or "")} == SKIPPED.keys()
    # The files that examples name.
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "models/shift_interlock.toml", "interlock.toml")
    shutil.copy(ROOT / "crates/cspace-drawing/tests/drawings/slot_r2000.dxf", "plate.dxf")
    pathlib.Path("plate.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"><rect id="outline" x="1" y="1" width="4" height="4"/></svg>')
    modules = [importlib.import_module(f"cspace.{found.name}") for found in pkgutil.iter_modules(cs.__path__) if found.name not in ELSEWHERE]
    space = cs.compute(cs.Part.rectangle(4, 2, name="table"), cs.Part.circle(1, name="coin"))
    names = {"cs": cs, "np": np, "space": space, "model": cs.Model.loads(CAM), "cup": cup()}
    tried = failed = 0
    for module in [cs, *modules]:
        found = doctest.testmod(module, extraglobs=names, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
        failed += found.failed
        tried += found.attempted
    assert failed == 0 and tried > 100
