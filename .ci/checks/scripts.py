"""Imports of the page, which is in TypeScript, and of the Python package. Imports of types alone count, and those within functions."""

import ast
import re
from pathlib import Path

from .circles import Imports, circles

PAGE = "crates/cspace-cli/page"
PACKAGE = "crates/cspace-python/python/cspace"

# Comments, and strings, in which nothing is a comment.
COMMENT = re.compile(r"""//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`)""", re.S)
IMPORT = re.compile(
    r"""^\s*(?:import|export)\b[^;"'`]*?\bfrom\s*["'](?P<from>\.[^"']*)
      | ^\s*import\s*["'](?P<only>\.[^"']*)
      | \bimport\s*\(\s*["'](?P<call>\.[^"']*)""",
    re.M | re.X,
)


def typescript_imports(root: Path) -> Imports:
    folders = [root / PAGE / folder for folder in ("src", "tools", "test")]
    files = {path.resolve(): path.relative_to(root).as_posix() for f in folders for path in sorted(f.rglob("*.ts"))}
    found: Imports = {}
    for path, name in files.items():
        of = found.setdefault(name, {})
        text = COMMENT.sub(lambda m: m[1] or "\n" * m[0].count("\n"), path.read_text(encoding="utf-8"))
        for match in IMPORT.finditer(text):
            to = match["from"] or match["only"] or match["call"]
            # A file is named by what it is compiled to. The kernel's glue is built, and imports nothing of the page.
            target = files.get((path.parent / re.sub(r"(\.js|\.ts)?$", ".ts", to, count=1)).resolve())
            if target and target != name:
                line = text.count("\n", 0, match.end()) + 1
                of.setdefault(target, f"{name}:{line}")
    return found


def python_imports(root: Path) -> Imports:
    base = root / PACKAGE
    package = base.name
    files = {}
    for path in sorted(base.rglob("*.py*")):
        if path.suffix in (".py", ".pyi"):
            *folders, stem = path.relative_to(base).with_suffix("").parts
            files[".".join((package, *folders, *([] if stem == "__init__" else [stem])))] = path
    found: Imports = {}
    for module, path in files.items():
        name = path.relative_to(root).as_posix()
        of = found.setdefault(name, {})
        # The package in which a relative import begins.
        home = module.split(".") if path.stem == "__init__" else module.split(".")[:-1]
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                named = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                start = home[: len(home) - node.level + 1] if node.level else []
                whole = ".".join((*start, *([node.module] if node.module else [])))
                # What is imported is a module, or a name of the module that it is imported from.
                named = [inner if (inner := f"{whole}.{a.name}") in files else whole for a in node.names]
            else:
                continue
            for to in named:
                if to in files and to != module:
                    of.setdefault(files[to].relative_to(root).as_posix(), f"{name}:{node.lineno}")
    return found


def typescript_imports_go_one_way(root: Path) -> tuple[int, list[str]]:
    imports = typescript_imports(root)
    return len(imports), circles(imports)


def python_imports_go_one_way(root: Path) -> tuple[int, list[str]]:
    imports = python_imports(root)
    return len(imports), circles(imports)
