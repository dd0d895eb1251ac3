"""Tables of cases: a row an engine, a column a key of the engine file."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

from . import _native
from .errors import RequestError

__all__ = ["columns"]

MOST_FAULTS = 20
"""Cells that are named of those that cannot be used; what follows has often the same cause."""


class _Faults(list[str]):
    """Everything in a table that cannot be used."""

    def add(self, row: object, column: str | None, message: str) -> None:
        self.append(f"row {row}{'' if column is None else f', column {column}'}: {message}")

    def refuse(self, what: str) -> None:
        """Raises where there are any."""
        if not self:
            return
        lines = [f"{what} cannot be used as a table of cases", *self[:MOST_FAULTS]]
        if len(self) > MOST_FAULTS:
            lines.append(f"and {len(self) - MOST_FAULTS} more")
        raise RequestError("\n  ".join(lines), "a column is a key of the engine file, such as `rod.length [mm]` or `name`; an empty cell leaves the key as it is")


def columns(table: str | PathLike[str] | Mapping[str, Any]) -> dict[str, list[Any]]:
    """The columns of a CSV file or a DataFrame by key, units of heads given to their numbers.

    >>> from lanchester.cases import columns
    >>> columns({"rod.length [mm]": [140, 150], "piston.mass": ["300 g", ""]})
    {'rod.length': ['140 mm', '150 mm'], 'piston.mass': ['300 g', None]}
    """
    faults = _Faults()
    if isinstance(table, (str, PathLike)):
        what, (heads, rows, cells, commas) = str(table), _read(Path(table), faults)
        places = [_letters(place) for place in range(len(heads))]
        first: object = 1
    else:
        what = "the table"
        given = {own.name: own.to_list() for own in table.get_columns()} if hasattr(table, "get_columns") else dict(table)
        heads, cells = [str(head) for head in given], [list(values) for values in given.values()]
        rows = list(range(max((len(values) for values in cells), default=0)))
        places, first, commas = [""] * len(heads), "of heads", False
    found: dict[str, list[Any]] = {}
    for place, head, values in zip(places, heads, cells, strict=True):
        parts = re.fullmatch(r"\s*([^\[\s]+(?:\[\d+\][^\[\s]*)*)\s*(?:\[([^\]]+)\])?\s*", head)
        if parts is None:
            faults.add(first, place or None, f"`{head.strip()}` is no key of an engine file" if head.strip() else "a head is due")
            continue
        key, unit = parts[1], parts[2]
        if key in found:
            faults.add(first, place or None, f"two columns are of `{key}`")
            continue
        own = found[key] = []
        pointed = _native.decimal_points(key, unit is not None, [value.strip() for value in values]) if commas else [(value, None) for value in values]
        column = f"{place} ({head.strip()})" if place else f"`{head.strip()}`"
        for row, (value, fault) in zip(rows, pointed, strict=False):
            if fault is not None:
                faults.add(row, column, f"needs a value, got {fault}")
                continue
            try:
                own.append(_value(value, key, unit))
            except ValueError as error:
                faults.add(row, column, str(error))
    faults.refuse(what)
    return found


def _read(path: Path, faults: _Faults) -> tuple[list[str], list[int], list[list[str]], bool]:
    """Heads, numbers of the rows below as their user sees them, cells by column, and whether numbers may have decimal commas."""
    if path.suffix.lower() in (".xlsx", ".xls", ".ods"):
        raise RequestError(f"{path} is a workbook", 'give the DataFrame of pandas.read_excel("..."), or a CSV file')
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise RequestError(f"cannot read {path}: it is not UTF-8 text (byte {error.start})", "save the table as CSV in UTF-8") from None
    except OSError as error:
        raise RequestError(f"cannot read {path}: {error.strerror or error}", "give a table of cases as CSV in UTF-8") from error
    separator = _separator(text)
    (_, heads), *rows = list(_rows(text, separator)) or [(1, [])]
    if not heads:
        raise RequestError(f"{path} is empty", "its first row has the keys, each further one is an engine")
    if not rows:
        raise RequestError(f"{path} has no case", "every row below the keys is one")
    for number, row in rows:
        if len(row) > len(heads):
            faults.add(number, None, f"it has {len(row)} cells, the first row has {len(heads)}")
    # What a row leaves out at its end stays as the engine has it.
    cells = [[row[place] if place < len(row) else "" for _, row in rows] for place in range(len(heads))]
    # Where semicolons part the cells, the comma is left for the decimals.
    return heads, [number for number, _ in rows], cells, separator == ";"


def _separator(text: str) -> str:
    """Comma, semicolon or tab: what the first row has most of, outside of quotes; ties go to the comma."""
    head = re.split("[\r\n]", re.sub(r'"[^"]*("|$)', "", text.lstrip()), maxsplit=1)[0]
    return max(",;\t", key=head.count)


def _rows(text: str, separator: str) -> Iterator[tuple[int, list[str]]]:
    """The rows that are not empty, with the numbers of their lines."""
    reader = csv.reader(text.splitlines(keepends=True), delimiter=separator)
    before = 0
    for row in reader:
        number, before = before + 1, reader.line_num
        if any(cell.strip() for cell in row):
            yield number, row


def _letters(place: int) -> str:
    """A, B, ... AA, as spreadsheets count columns."""
    letters, rest = "", place + 1
    while rest > 0:
        rest, letter = divmod(rest - 1, 26)
        letters = chr(ord("A") + letter) + letters
    return letters


def _value(value: Any, key: str, unit: str | None) -> Any:
    if isinstance(value, str):
        value = value.strip()
    if value is None or (isinstance(value, str) and value == "") or type(value).__name__ in ("NAType", "NaTType"):
        return None
    if isinstance(value, float) and math.isnan(value):
        return None
    if unit is not None:
        if _number(value) is None:
            raise ValueError(f"needs a number [{unit}], got {value!r}: the unit stands in the head")
        return f"{value} {unit}"
    if key == "name":
        return str(value)
    if isinstance(value, str) and (number := _number(value)) is not None:
        return number
    # Columns with gaps hold counts as floats.
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _number(value: Any) -> int | float | None:
    for kind in (int, float):
        try:
            number = kind(value) if isinstance(value, str) else float(value)
        except (TypeError, ValueError):
            continue
        return number if math.isfinite(number) else None
    return None
