"""An answer as plain values: what a pickle of a result holds, so that results travel between processes and lie in files."""

from __future__ import annotations

import re
import zlib
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import LanchesterError

if TYPE_CHECKING:
    from ._native import Answer
    from ._native import Engine as NativeEngine

__all__ = ["Kept"]

_STEP = re.compile(r"\.?([^.\[\]]+)|\[(\d+)\]")

MOST_CHOICES = 10_000
"""Choices that are tried at most, which a search offers to be adopted."""


class Kept:
    """What an answer says, by value; it answers as the answer itself does."""

    __slots__ = ("_figures", "_found", "_json", "_tables", "_text", "_values")

    def __init__(
        self,
        values: dict[str, Any],
        json: bytes,
        text: str,
        tables: list[Any],
        figures: list[tuple[str, str, str]],
        found: dict[int | None, Any],
    ) -> None:
        self._values = _fixed(values)
        self._json = json
        self._text = text
        self._tables = tables
        self._figures = figures
        self._found = found

    @staticmethod
    def of(answer: Answer) -> Kept:
        """All that an answer of the native module has."""
        json = zlib.compress(answer.json().encode(), 1)
        return Kept(answer.values(), json, answer.text(), answer.tables(), answer.figures(), _found(answer))

    def __reduce__(self) -> tuple[Any, ...]:
        return Kept, (self._values, self._json, self._text, self._tables, self._figures, self._found)

    def field(self, name: str) -> Any:
        if name not in self._values:
            raise AttributeError(f"there is no `{name}`; there are {', '.join(self._values)}")
        return self._values[name]

    def pick(self, path: str) -> Any:
        here: Any = self._values
        at = 0
        while at < len(path):
            step = _STEP.match(path, at)
            if step is None:
                raise AttributeError("it is no path")
            at = step.end()
            key, index = step.groups()
            try:
                here = here[key] if index is None else here[int(index)]
            except (IndexError, KeyError, TypeError):
                raise AttributeError(f"there is no {f'`{key}`' if index is None else f'[{index}]'}") from None
        return here

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

    def adopted(self, number: int | None = None) -> NativeEngine | None:
        from . import _native

        found = self._found.get(number, self._found.get(-1))
        if isinstance(found, LanchesterError):
            raise found
        return None if found is None else _native.Engine.of_text(found[0], "<text>", found[1])


def _found(answer: Answer) -> dict[int | None, Any]:
    """The engines that can be adopted by their numbers; behind -1 what any other number gets."""

    def engine(number: int | None) -> Any:
        try:
            found = answer.adopted(number)
        except LanchesterError as error:
            return error
        return None if found is None else (found.text, found.folder)

    first = engine(None)
    if first is None or isinstance(first, LanchesterError):
        return {None: first, -1: first}
    numbered = {number: engine(number) for number in range(2)}
    if numbered[0] == numbered[1]:
        # There is no choice.
        return {None: first, -1: first}
    found: dict[int | None, Any] = {None: first}
    for number in range(MOST_CHOICES):
        own = engine(number)
        if isinstance(own, LanchesterError):
            found[-1] = own
            break
        found[number] = own
    return found


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
