"""An answer as plain values: what a pickle of a result holds, so that results travel between processes and lie in files."""

from __future__ import annotations

import zlib
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import LanchesterError, RequestError

if TYPE_CHECKING:
    from ._native import Answer
    from ._native import Engine as NativeEngine

__all__ = ["Kept"]

MOST_CHOICES = 10_000
"""Engines that are kept at most of those which a search offers to be adopted."""


class Kept:
    """What an answer says, by value; it answers as the answer itself does."""

    __slots__ = ("_choices", "_figures", "_found", "_json", "_tables", "_text", "_values")

    def __init__(
        self,
        values: dict[str, Any],
        json: bytes,
        text: str,
        tables: list[Any],
        figures: list[tuple[str, str, str]],
        choices: int | None,
        found: list[Any],
    ) -> None:
        self._values = _fixed(values)
        self._json = json
        self._text = text
        self._tables = tables
        self._figures = figures
        self._choices = choices
        self._found = found

    @staticmethod
    def of(answer: Answer) -> Kept:
        """All that an answer of the native module has."""
        json = zlib.compress(answer.json().encode(), 1)
        choices = answer.choices()
        found = [_found(answer, number) for number in range(min(choices or 0, MOST_CHOICES))]
        return Kept(answer.values(), json, answer.text(), answer.tables(), answer.figures(), choices, found)

    def __reduce__(self) -> tuple[Any, ...]:
        return Kept, (self._values, self._json, self._text, self._tables, self._figures, self._choices, self._found)

    def field(self, name: str) -> Any:
        return _select(self._values, [name])

    def pick(self, path: str) -> Any:
        from . import _native

        return _select(self._values, _native.path_steps(path))

    def values(self) -> Any:
        return self._values

    def json(self) -> str:
        return zlib.decompress(self._json).decode()

    def text(self) -> str:
        return self._text

    def tables(self) -> list[Any]:
        return self._tables

    def figures(self) -> list[tuple[str, str, str]]:
        return self._figures

    def choices(self) -> int | None:
        return self._choices

    def adopted(self, number: int) -> NativeEngine | None:
        from . import _native

        if self._choices is None:
            return None
        if number >= len(self._found):
            raise RequestError(f"choice {number} is not kept: a pickle has the first {len(self._found)} of {self._choices}", "adopt it from the search itself")
        found = self._found[number]
        if isinstance(found, LanchesterError):
            raise found
        return _native.Engine.of_text(found[0], "<text>", found[1])


def _found(answer: Answer, number: int) -> Any:
    """The text and folder of an engine that can be adopted, or why it cannot."""
    try:
        found = answer.adopted(number)
    except LanchesterError as error:
        return error
    return None if found is None else (found.text, found.folder)


def _select(here: Any, steps: list[str | int]) -> Any:
    """What is at the end of a path; in the words of an answer where there is nothing."""
    for step in steps:
        what = f"`{step}`" if isinstance(step, str) else f"[{step}]"
        if isinstance(here, dict) and here:
            # Numbers that are keys are texts in paths.
            keys = {str(key): key for key in here}
            if isinstance(step, int):
                raise AttributeError(f"{what} needs a list; there are {', '.join(keys)}")
            if step not in keys:
                raise AttributeError(f"there is no {what}; there are {', '.join(keys)}")
            here = here[keys[step]]
        elif isinstance(here, (dict, list, np.ndarray)):
            if isinstance(step, str):
                raise AttributeError(f"{what} needs an index such as [0] before it: it is a list of {len(here)}")
            if step >= len(here):
                raise AttributeError(f"there is no {what} in a list of {len(here)}")
            here = here[step]
        else:
            raise AttributeError(f"no {what} below a plain value")
    return here.item() if isinstance(here, np.generic) else here


def _fixed(value: Any) -> Any:
    """The same; arrays that came out of a pickle are read-only as they were."""
    if isinstance(value, np.ndarray):
        value.flags.writeable = False
    elif isinstance(value, dict):
        for own in value.values():
            _fixed(own)
    elif isinstance(value, list):
        for own in value:
            _fixed(own)
    return value
