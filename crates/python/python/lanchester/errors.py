"""What is raised. One tree: what cannot be done is a :class:`LanchesterError`, whose text reads like the command line's. A wrong type is a plain ``TypeError``.

An outcome is no error: limits that no weights can hold, a run that was stopped, a search whose gap stays open are data of the result with their reason.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

__all__ = ["Diagnostic", "EngineFileError", "InternalError", "LanchesterError", "RequestError"]


def _again(kind: type[LanchesterError], args: tuple[Any, ...], fields: dict[str, Any]) -> LanchesterError:
    """An exception that another process has raised."""
    made = kind.__new__(kind)
    made.args = args
    made.__dict__.update(fields)
    return made


@dataclass(frozen=True)
class Diagnostic:
    """Something about an engine file that its author should know.

    >>> import lanchester
    >>> try:
    ...     lanchester.Engine.from_toml('name = "A"')
    ... except lanchester.EngineFileError as error:
    ...     error.diagnostics[0].code
    'E0202'
    """

    severity: Literal["error", "warning"]
    """Whether no engine can be made of the file, or something is probably not meant."""
    code: str
    """Stable code such as ``E0103``; the book lists them."""
    message: str
    """What was needed and what was got."""
    line: int
    """Line of the place, from 1."""
    column: int
    """Column of the place in characters, from 1."""
    place: str
    """The text at the place."""
    label: str
    """What stands at the place, a few words; may be empty."""
    hint: str | None
    """What to do."""


class LanchesterError(Exception):
    """Why there is no answer.

    >>> import lanchester
    >>> try:
    ...     lanchester.Engine.template("in-line-4").loads(speed="60 mm")
    ... except lanchester.LanchesterError as error:
    ...     print(error.message)
    `speed` needs a speed, got a length
    """

    message: str
    """What was needed and what was got."""
    hint: str | None
    """What to do."""

    def __init__(self, message: str, hint: str | None = None) -> None:
        self.message = message
        self.hint = hint
        super().__init__(f"{message}\nhint: {hint}" if hint else message)

    def __reduce__(self) -> tuple[Any, ...]:
        # As it is, to other processes too.
        return _again, (type(self), self.args, self.__dict__)


class EngineFileError(LanchesterError, ValueError):
    """The engine file has mistakes; all of them are in :attr:`diagnostics`.

    >>> import lanchester
    >>> try:
    ...     lanchester.Engine.template("in-line-4").with_(crank={"stroke": "80 kg"})
    ... except lanchester.EngineFileError as error:
    ...     first = error.diagnostics[0]
    >>> first.line > 0, first.place
    (True, '"80 kg"')
    """

    diagnostics: list[Diagnostic]
    """Every mistake and warning with its place."""

    def __init__(self, text: str, diagnostics: list[Diagnostic]) -> None:
        self.diagnostics = diagnostics
        super().__init__(text.rstrip("\n"))


class RequestError(LanchesterError, ValueError):
    """What is asked for cannot be done: an argument cannot be used, or the engine file says too little of something.

    >>> import lanchester
    >>> try:
    ...     lanchester.Engine.template("in-line-4").loads(orders=0)
    ... except lanchester.RequestError as error:
    ...     print(error)
    `orders` needs a whole number from 1 to 1000, got 0
    hint: leave `orders` out for its usual value
    """

    code: str
    """Type and variant of the error in the Rust crates, such as ``LoadError.Speed``; empty for an argument."""

    def __init__(self, message: str, hint: str | None = None, code: str = "") -> None:
        self.code = code
        super().__init__(message, hint)


class InternalError(LanchesterError, RuntimeError):
    """A fault of lanchester itself: please report it.

    >>> import lanchester
    >>> issubclass(lanchester.InternalError, lanchester.LanchesterError)
    True
    """

    def __init__(self, message: str) -> None:
        super().__init__(message, "this is a fault of lanchester itself, please report it")
