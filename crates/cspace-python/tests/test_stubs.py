"""Types: what stubs.py writes is what is there, and a type checker understands the package."""

import ast
import importlib.util
import pathlib
import subprocess
import sys

import pytest

import cspace as cs

SCRIPT = pathlib.Path(__file__).parents[1] / "stubs.py"

PROGRAM = """\
import cspace as cs
space: cs.ContactSpace = cs.compute(cs.Part.rectangle(4, 2), cs.Part.circle(1.0))
length: float = space.slice(0.3).length + space.play((0, 5, 0))["y"].length
verdict: str = space.plan([0, 5, 0], [0, -5, 0], widest=True).verdict
loops: cs.Loops = space.fixed.outline.moved(1, 2, theta=0.5)
apart: float = space.clearance((0, 5, 0)) + space.clearance([[0.0, 5.0, 0.0]]).max()
found: cs.Class = space.classify((0, 5, 0))
region: int | None = space.region([0.0, 5.0, 0.0])
one: cs.Loops = cs.nfp(space.fixed, space.moving, 0.5)
many: list[cs.Loops] = cs.inner_fit(space.fixed, space.moving, [0.0, 0.5])
pair: cs.FeaturePair = space.features_within((0, 5, 0), 9.0)[0][0]
number: int = pair.fixed.number
"""

WRONG = """\
import cspace as cs
space = cs.compute(cs.Part.circle("one"), cs.Part.circle(1.0))
space.fixed.outline.area()
space.mover((0, 0, 0), (1, 0, 0))
space.plan((0, 0, 0), (1, 0, 0), widest="yes").path.shape
"""


def stubs():
    spec = importlib.util.spec_from_file_location("stubs", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def checked(*arguments):
    pytest.importorskip("mypy")
    done = subprocess.run([sys.executable, "-m", "mypy", *arguments], capture_output=True, text=True)
    return done.stdout + done.stderr


def test_the_stub_is_that_of_the_module():
    made = stubs()
    assert made.PATH.read_text(encoding="utf-8") == made.text(), "run: python crates/cspace-python/stubs.py"
    classes = {node.name: node for node in ast.parse(made.text()).body if isinstance(node, ast.ClassDef)}
    methods = {node.name for node in classes["ContactSpace"].body if isinstance(node, ast.FunctionDef)}
    assert {"classify", "_move", "slice", "window"} <= methods
    assert "    def contacts(self, q: Any, tolerance: Any = None) -> Any:" in made.text().splitlines()


def test_the_answers_are_those_of_the_schemas():
    spec = importlib.util.spec_from_file_location("answers", SCRIPT.with_name("answers.py"))
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    assert made.PATH.read_text(encoding="utf-8") == made.text(), "run: python crates/cspace-python/answers.py"


def test_a_docstring_may_end_with_a_quotation_mark():
    made = stubs()

    def said():
        """It is called "it\""""

    lines = made.documented("def said() -> Any:", said)
    assert ast.get_docstring(ast.parse("\n".join(lines)).body[0]).strip() == said.__doc__


def test_every_public_function_has_types():
    for path in pathlib.Path(cs.__file__).parent.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.FunctionDef) or node.name.startswith("_repr"):
                continue
            given = [*node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg]
            untyped = [a.arg for a in given if a and a.annotation is None and a.arg not in ("self", "cls")]
            assert node.returns is not None and not untyped, (path.name, node.name, untyped)


def test_programs_are_checked(tmp_path):
    assert (pathlib.Path(cs.__file__).parent / "py.typed").exists()
    (tmp_path / "program.py").write_text(PROGRAM)
    found = checked("--strict", "--cache-dir", str(tmp_path / "cache"), str(tmp_path / "program.py"))
    assert found.startswith("Success"), found
    (tmp_path / "wrong.py").write_text(WRONG)
    found = checked("--cache-dir", str(tmp_path / "cache"), str(tmp_path / "wrong.py"))
    for line, words in [(2, "[arg-type]"), (3, '"float" not callable'), (4, 'maybe "move"'), (5, '"widest"'), (5, "[union-attr]")]:
        assert any(f"wrong.py:{line}:" in told and words in told for told in found.splitlines()), found


def test_the_package_is_checked(tmp_path):
    found = checked("--cache-dir", str(tmp_path), "-p", "cspace")
    assert found.startswith("Success"), found
