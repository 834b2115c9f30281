#!/usr/bin/env python3
"""Writes python/cspace/_rust.pyi: what the compiled module has, for editors and type checkers.

    python crates/cspace-python/stubs.py

Names, parameters, defaults and docstrings are those of the module that is installed. It tells no types, so that all are Any.
"""

import inspect
import pathlib
import textwrap

from cspace import _rust

PATH = pathlib.Path(__file__).parent / "python/cspace/_rust.pyi"

HEAD = '''\
"""The compiled module. Written by stubs.py."""

from typing import Any
'''


def documented(head, value):
    """The lines of a definition, with its docstring."""
    doc = inspect.getdoc(value)
    if not doc:
        return [f"{head} ..."]
    # A quotation mark at the end is kept apart from those of the docstring.
    doc += "\n" * doc.endswith('"')
    return [head, *textwrap.indent(f'"""{doc}"""', "    ").splitlines()]


def parameter(given):
    """A parameter as it is written."""
    if given.name == "self":
        return "self"
    mark = {given.VAR_POSITIONAL: "*", given.VAR_KEYWORD: "**"}.get(given.kind, "")
    default = "" if given.default is given.empty else f" = {given.default!r}"
    return f"{mark}{given.name}: Any{default}"


def function(name, value):
    """The lines of a function or method; a signature's mark of parameters by position only is left out."""
    parameters = inspect.signature(value).parameters.values()
    return documented(f"def {name}({', '.join(map(parameter, parameters))}) -> Any:", value)


def member(name, value):
    """The lines of an attribute of a class."""
    if inspect.isgetsetdescriptor(value):
        return ["@property", *documented(f"def {name}(self) -> Any:", value)]
    if isinstance(value, staticmethod):
        return ["@staticmethod", *function(name, value.__func__)]
    return function(name, value)


def is_shown(name):
    return name == "__call__" or not name.startswith("__")


def of_class(name, value):
    lines = documented(f"class {name}:", value)
    for key, attribute in sorted(vars(value).items()):
        if is_shown(key):
            lines += ["", *textwrap.indent("\n".join(member(key, attribute)), "    ").splitlines()]
    return lines


def text():
    """The whole file."""
    parts = [HEAD.rstrip("\n").splitlines()]
    for name, value in sorted(vars(_rust).items()):
        if not is_shown(name):
            continue
        if inspect.isclass(value):
            parts.append(of_class(name, value))
        elif callable(value):
            parts.append(function(name, value))
        else:
            parts.append([f"{name}: {type(value).__name__}"])
    return "\n\n\n".join("\n".join(part) for part in parts) + "\n"


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")
