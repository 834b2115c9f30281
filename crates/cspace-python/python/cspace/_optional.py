"""Packages that are used where they are installed."""

import importlib
from types import ModuleType

from ._errors import Error


def optional(module: str, package: str | None = None) -> ModuleType:
    """A module of a package that need not be installed; `package` is its name on PyPI where it is another."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        package = package or module.split(".")[0]
        raise Error(f"{package} cannot be imported ({error}): pip install {package}") from error
