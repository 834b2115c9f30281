"""Classes of configurations."""

from enum import IntEnum


class Class(IntEnum):
    """How the parts are at a configuration: FREE 0, BLOCKED 1 (they overlap), CONTACT 2. Its text is the command's word.

    >>> print(cs.CONTACT, cs.Class(1), cs.FREE == 0)
    contact blocked True
    """

    FREE = 0
    BLOCKED = 1
    CONTACT = 2

    def __str__(self) -> str:
        return self.name.lower()

    def __format__(self, spec: str) -> str:
        return format(str(self), spec)
