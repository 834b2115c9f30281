"""Errors: classes of Python, so that they can be sent between processes."""


class Error(ValueError):
    """What was given is wrong, or has no answer; the message says what to do.

    >>> cs.Part.circle(-1)
    Traceback (most recent call last):
    cspace._errors.Error: part 0 "circle", loop 0: ...
    """


class InternalError(RuntimeError):
    """A fault of the library itself, which its authors would like to know of.

    >>> issubclass(cs.InternalError, cs.Error)
    False
    """
