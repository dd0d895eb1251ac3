"""Writes the reference of the package for the book: docs/src/guide/python-reference.md and python-results.md, from signatures and docstrings.

`python reference.py functions` and `python reference.py results` print them; the package has to be installed. `cargo xtask python --write` puts them in their places.
"""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Callable, Iterator
from typing import Any

import lanchester
import lanchester.dask
import lanchester.results
from lanchester import Result, errors
from lanchester._record import Matrices, Variant

FUNCTIONS = """# Python: reference

Written by `cargo xtask python --write` from the docstrings of the package; [the guide](python.md) shows how its parts play together. `Quantity` is a float in SI units or a text with a unit.
Arrays are of NumPy, tables and data frames those of the libraries that are installed.
"""

RESULTS = """# Python: fields of results

Written by `cargo xtask python --write` from the Rust types: the result of each question first, then the structures within them by name. What they have in common, tables, pictures and plots, is in [the reference](python-reference.md#result).
SI units and radians; complex numbers are rows of real and imaginary part. `None` stands where there is nothing to say.
"""


def plain(text: str) -> str:
    """Words of a docstring as Markdown."""
    text = re.sub(r":(?:meth|class|func):`~?([^`]+)`", r"`\1`", text)
    text = re.sub(r"``([^`]+)``", r"`\1`", text)
    # Outside of code: what Markdown would take for something of its own.
    parts = re.split(r"(`[^`]*`)", text)
    parts[::2] = [re.sub(r"([\[\]<>*_|])", r"\\\1", part) for part in parts[::2]]
    return "".join(parts)


def cell(text: str) -> str:
    """Markdown within a table, where a bar ends a cell in code too."""
    parts = re.split(r"(`[^`]*`)", text)
    parts[1::2] = [part.replace("|", "\\|") for part in parts[1::2]]
    return "".join(parts)


def documented(own: Any) -> str:
    """The docstring: its words, then its example."""
    text = inspect.getdoc(own) or ""
    words, marker, example = text.partition(">>>")
    out = plain(words).strip() + "\n"
    if marker:
        out += f"\n```pycon\n{marker}{example.rstrip()}\n```\n"
    return out


def argument(own: inspect.Parameter) -> str:
    stars = "*" if own.kind == own.VAR_POSITIONAL else "**" if own.kind == own.VAR_KEYWORD else ""
    default = "" if own.default is own.empty else f" = {own.default!r}"
    return f"{stars}{own.name}: {own.annotation}{default}"


def signature(name: str, own: Any) -> str:
    """How it is called, an argument a line where there are many."""
    found = inspect.signature(own)
    given = [parameter for place, parameter in enumerate(found.parameters.values()) if parameter.name not in ("self", "cls") or place > 0]
    shown = [argument(parameter) for parameter in given]
    first = next((place for place, parameter in enumerate(given) if parameter.kind == parameter.KEYWORD_ONLY), None)
    if first is not None and not any(parameter.kind == parameter.VAR_POSITIONAL for parameter in given):
        shown.insert(first, "*")
    returns = "" if found.return_annotation is found.empty else f" -> {str(found.return_annotation).strip(chr(39))}"
    line = f"{name}({', '.join(shown)}){returns}"
    if len(line) <= 100:
        return line
    return f"{name}(\n" + "".join(f"    {own},\n" for own in shown) + f"){returns}"


def link(annotation: str) -> str:
    """A result leads to its fields."""
    kind = getattr(lanchester.results, annotation.strip("'"), None)
    return f"\nFields: [`{kind.__name__}`](python-results.md#{kind.__name__.lower()}).\n" if isinstance(kind, type) and issubclass(kind, Result) else ""


def members(kind: type) -> Iterator[tuple[str, Any]]:
    for name, own in vars(kind).items():
        if not name.startswith("_") and (callable(own) or isinstance(own, (property, staticmethod, classmethod))):
            yield name, own


def function(name: str, own: Any, level: str) -> str:
    called = getattr(own, "__func__", own)
    returns = str(getattr(called, "__annotations__", {}).get("return", ""))
    return f"\n{level} {name}\n\n```text\n{signature(name, called)}\n```\n\n{documented(called)}{link(returns)}"


def structure(kind: type, level: str, prefix: str) -> str:
    out = f"\n{level} {prefix}{kind.__name__}\n\n{documented(kind)}"
    for name, own in members(kind):
        of = f"{kind.__name__}.{name}"
        if isinstance(own, property):
            annotation = str(getattr(own.fget, "__annotations__", {}).get("return", "")).strip("'")
            out += f"\n{level}# {of}\n\n`{annotation}`\n\n{documented(own)}"
        else:
            out += function(of, own, level + "#")
    return out


def functions() -> str:
    own: list[Callable[..., Any]] = [lanchester.map, lanchester.compare, lanchester.adopt]
    kinds = [lanchester.Engine, lanchester.WorkshopSheet, lanchester.Variants]
    kinds += [lanchester.Result, lanchester.Record, Variant, Matrices, lanchester.Records, lanchester.Table, lanchester.Picture]
    out = FUNCTIONS + "\n## Functions\n" + "".join(function(f"lanchester.{one.__name__}", one, "###") for one in own)
    out += "".join(structure(kind, "##", "") for kind in kinds)
    out += "\n## Errors\n" + "".join(structure(getattr(errors, name), "###", "") for name in errors.__all__)
    cluster = lanchester.dask
    out += "\n## Clusters\n"
    for name in sorted(cluster.__all__, key=lambda name: not callable(getattr(cluster, name)) or isinstance(getattr(cluster, name), type)):
        one = getattr(cluster, name)
        out += structure(one, "###", "lanchester.dask.") if isinstance(one, type) else function(f"lanchester.dask.{name}", one, "###")
    return out


def results() -> str:
    kinds = [own for own in vars(lanchester.results).values() if isinstance(own, type) and issubclass(own, lanchester.Record) and own.__module__ == "lanchester.results"]
    kinds.sort(key=lambda kind: (not issubclass(kind, Result), kind.__name__))
    out = RESULTS
    for kind in kinds:
        out += f"\n## {kind.__name__}\n\n{plain(inspect.getdoc(kind) or '').strip()}\n"
        fields = [(name, getattr(kind, name)) for name in kind._FIELDS]
        if fields:
            out += "\n| field | type | meaning |\n|---|---|---|\n"
        for name, own in fields:
            annotation = str(own.fget.__annotations__["return"]).strip("'")
            words = " ".join(plain(inspect.getdoc(own) or "").split())
            out += f"| `{name}` | `{annotation.replace(' | ', ' or ')}` | {cell(words)} |\n"
    return out


if __name__ == "__main__":
    sys.stdout.write({"functions": functions, "results": results}[sys.argv[1]]())
