"""Who hears how far long work has come."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

_heard: ContextVar[Callable[[str, float, float | None], object] | None] = ContextVar("cspace.progress", default=None)


def heard() -> Callable[[str, float, float | None], object] | None:
    """What is called in this context, if anything."""
    return _heard.get()


@contextmanager
def progress(tell: Callable[[str, float, float | None], object]) -> Iterator[None]:
    """While the context lasts, `tell(stage, seconds, share)` is called as what is asked for comes on, some twenty times a second at most.

    `stage` is the name of what begins: a stage of a configuration space, such as "sheets" or "cells"; "pieces" or "rows" for many alike
    pieces, of which `share`, from 0 to 1, is done; it is None where that is not known. `seconds` have passed since the question. What
    `tell` raises ends the question, as Ctrl-C does.

    >>> stages = []
    >>> with progress(lambda stage, seconds, share: stages.append(stage)):
    ...     found = cs.compute(cs.Part.rectangle(4, 2), cs.Part.circle(1))
    >>> stages[0], stages[-1]
    ('sheets', 'graph')
    """
    token = _heard.set(tell)
    try:
        yield
    finally:
        _heard.reset(token)
