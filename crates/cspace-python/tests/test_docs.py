"""The programs in the documentation run as they stand, and print what is expected."""

import re

from conftest import ROOT

EXPECTED = """\
0.1000 sideways, 0.6376 degrees
path 0.0500
1.8 comes out
2.0 caged
[0.1 0.1 0.1 0.1 0.1]
0.20000000000000
[{'play': 0.15
of them have enough play 0
Loops(1 loop, 2 vertices) [(150.0, 150.0), (250.0, 150.0)]
(2.0, 2.0, 0)
"""


def test_the_page_runs(capsys):
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


def test_docstrings_run():
    import doctest

    import cspace
    from cspace import _loops, _part, _sweep

    for module in (cspace, _loops, _part, _sweep):
        found = doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE)
        assert found.failed == 0 and found.attempted > 0, module
