"""What is thrown."""

from __future__ import annotations


class FrondError(ValueError):
    """What is wrong, in a sentence that says what to do.

    Attributes
    ----------
    code : str
        A name that stays the same over versions, for programs: the codes are those of the JavaScript API, such as
        ``"bad-input"``, ``"no-attractor"`` or ``"too-many-maps"``.
    """

    code: str

    def __init__(self, message: str, code: str = "bad-input") -> None:
        super().__init__(message)
        self.code = code


def unreadable(what: str, why: str) -> FrondError:
    """The error about a value of the wrong form."""
    return FrondError(f"{what} cannot be read: {why}.")
