"""Tables of cases: a row an engine, a column a key of the engine file."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Mapping
from os import PathLike
from typing import Any

from .errors import RequestError

__all__ = ["columns"]


def columns(table: str | PathLike[str] | Mapping[str, Any]) -> dict[str, list[Any]]:
    """The columns of a CSV file or a DataFrame by key, units of heads given to their numbers.

    >>> from lanchester.cases import columns
    >>> columns({"rod.length [mm]": [140, 150], "piston.mass": ["300 g", ""]})
    {'rod.length': ['140 mm', '150 mm'], 'piston.mass': ['300 g', None]}
    """
    found: dict[str, list[Any]] = {}
    for head, values in (_read(table) if isinstance(table, (str, PathLike)) else dict(table)).items():
        parts = re.fullmatch(r"\s*([^\[\s]+(?:\[\d+\][^\[\s]*)*)\s*(?:\[([^\]]+)\])?\s*", str(head))
        if parts is None:
            raise RequestError(f"`{head}` is no key of an engine file", "write a head like `rod.length [mm]` or `cylinder[1].piston.mass`")
        key, unit = parts[1], parts[2]
        if key in found:
            raise RequestError(f"two columns are of `{key}`", "leave one of them out")
        found[key] = [_value(value, unit, str(head), row) for row, value in enumerate(values)]
    return found


def _read(path: str | PathLike[str]) -> dict[str, list[str]]:
    try:
        with open(path, encoding="utf-8-sig", newline="") as file:
            rows = [row for row in csv.reader(file) if any(cell.strip() for cell in row)]
    except (OSError, UnicodeDecodeError) as error:
        raise RequestError(f"cannot read {path}: {error}", "give a table of cases as CSV in UTF-8") from error
    if not rows:
        raise RequestError(f"{path} is empty", "its first row has the keys, each further one is an engine")
    head, *body = rows
    for place, row in enumerate(body):
        if len(row) != len(head):
            raise RequestError(f"row {place + 1} of {path} has {len(row)} cells, its head has {len(head)}", "every row needs a cell for each key; it may be empty")
    if len(set(head)) < len(head):
        raise RequestError(f"two columns of {path} have one head", "leave one of them out")
    return {name: [row[place] for row in body] for place, name in enumerate(head)}


def _value(value: Any, unit: str | None, head: str, row: int) -> Any:
    if isinstance(value, str):
        value = value.strip()
    if value is None or value == "" or (isinstance(value, float) and math.isnan(value)):
        return None
    if unit is not None:
        if _number(value) is None:
            raise RequestError(f"row {row + 1} of `{head}` needs a number, got {value!r}", "the unit stands in the head")
        return f"{value} {unit}"
    if isinstance(value, str) and (number := _number(value)) is not None:
        return number
    return value


def _number(value: Any) -> int | float | None:
    for kind in (int, float):
        try:
            number = kind(value) if isinstance(value, str) else float(value)
        except (TypeError, ValueError):
            continue
        return number if math.isfinite(number) else None
    return None
