"""Studies in blocks: a folder of tables, each a stretch of blocks, whole or not there. No cluster yet.

A study on a cluster is made of plain values on this side (:class:`Study`) and of :func:`compute` on the other one.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

from . import _native
from ._record import Record, Result, Variant
from .engine import _KINDS, Engine, Variants, _natives
from .errors import RequestError
from .sheet import WorkshopSheet
from . import results as _results
from .results import Exploration, ScatterStudy

__all__ = ["Study", "Tables", "compute"]

CASES = 16
"""Engines of a block of a study of many engines."""


class Study:
    """What is asked, as plain values that any process can hold."""

    def __init__(self, name: str, engines: Sequence[Engine] | Variants, options: Mapping[str, Any], pick: Sequence[str] | None = None) -> None:
        self.name = name
        self.pick = None if pick is None else list(pick)
        self.options = {key: value for key, value in options.items() if value is not None}
        self.engines = engines
        self.kind: type[Result] | None = {"explore": Exploration, "scatter": ScatterStudy}.get(name) if pick is None else None
        columns = engines.columns if isinstance(engines, Variants) else None
        self.native = _native.study(name, self._natives(), self.options, columns, self.pick)
        self.head = self.native.head()

    def _natives(self) -> list[_native.Engine]:
        if isinstance(self.engines, Variants):
            return [self.engines.engine._native]
        return _natives(self.engines)

    @property
    def blocks(self) -> int:
        return self.native.blocks

    def ask(self, first: int, end: int) -> bytes:
        """What another process needs to compute blocks `first` to `end`."""
        natives, columns, texts, start = self._natives(), None, None, 0
        if self.pick is not None:
            start, texts = first * CASES, self.native.texts
            if isinstance(self.engines, Variants):
                columns = {path: list(values[start : end * CASES]) for path, values in self.engines.columns.items()}
            else:
                natives = natives[start : end * CASES]
        engines = [(own.text, None if own.folder is None else str(own.folder)) for own in natives]
        return pickle.dumps((self.name, engines, self.options, columns, self.pick, start, texts, self.head, self.blocks))

    def table(self, first: int, end: int) -> bytes:
        """The table of blocks `first` to `end`, computed here."""
        return self.native.table(first, end)


@lru_cache(maxsize=2)
def _asked(ask: bytes) -> tuple[_native.Study, bool, dict[str, str], int]:
    name, engines, options, columns, pick, start, texts, head, of = pickle.loads(ask)
    natives = [_native.Engine.of_text(text, "<text>", folder) for text, folder in engines]
    return _native.study(name, natives, options, columns, pick, start, texts), pick is not None, head, of


def compute(ask: bytes, first: int, end: int, folder: str | None) -> bytes | None:
    """The table of blocks `first` to `end`: put into `folder`, or given back where there is none."""
    study, is_slice, head, of = _asked(ask)
    table = study.slice(head, first, end, of) if is_slice else study.table(first, end)
    if folder is None:
        return table
    put(Path(folder), first, end, table)
    return None


def put(folder: Path, first: int, end: int, table: bytes) -> Path:
    """Puts a table in its place: whole or not there."""
    place = folder / f"{first:020}-{end:020}.parquet"
    handle, name = tempfile.mkstemp(prefix=".new-", dir=folder)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(table)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(name, 0o644)
        os.replace(name, place)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(name)
        raise
    return place


class Tables:
    """The folder of a study: what is done, what is missing."""

    def __init__(self, folder: str | os.PathLike[str], study: Study) -> None:
        self.folder = Path(folder)
        self.study = study

    def done(self) -> list[tuple[int, int, Path]]:
        """The stretches of blocks that are there, in order, every byte verified."""
        found = []
        for path in sorted(self.folder.glob("*.parquet")):
            head, first, end, of = _native.held(path)
            if head != self.study.head or of != self.study.blocks:
                raise RequestError(
                    f"{path} belongs to another study",
                    "choose another folder, or go on with the same engine, arguments and version of lanchester",
                )
            found.append((first, end, path))
        found.sort()
        for (_, end, one), (first, _, other) in zip(found, found[1:], strict=False):
            if first < end:
                raise RequestError(f"{one} and {other} hold the same blocks", "remove one of them")
        return found

    def missing(self, parts: int) -> list[tuple[int, int]]:
        """What is to be computed, cut where `parts` parts of the study are cut."""
        cuts = {0}
        for number in range(1, parts + 1):
            stretch = self.study.native.part(number, parts)
            if stretch is not None:
                cuts.add(stretch[1])
        edges = sorted(cuts)
        gaps, at = [], 0
        for first, end, _ in self.done():
            gaps.append((at, first))
            at = end
        gaps.append((at, self.study.blocks))
        found = []
        for first, end in gaps:
            inside = [first, *(edge for edge in edges if first < edge < end), end]
            found += [pair for pair in zip(inside, inside[1:], strict=False) if pair[0] < pair[1]]
        return found

    @contextlib.contextmanager
    def alone(self) -> Iterator[None]:
        """Makes the folder, and keeps other clients out of it for a while."""
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise RequestError(f"cannot make the folder {self.folder}: {error}", "choose another place") from error
        # The lock dies with its process.
        with open(self.folder / ".lock", "w") as lock:
            try:
                import fcntl
            except ImportError:
                yield
                return
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError:
                raise RequestError(f"another client is at work on {self.folder}", "wait for it, or choose another folder") from None
            # Tables that a killed process has begun.
            for begun in self.folder.glob(".new-*"):
                begun.unlink(missing_ok=True)
            yield


def check_paths(question: str, paths: Sequence[str]) -> None:
    """Refuses a path that no answer to the question has, before anything is computed: as far as the types of results say what there is."""
    kind_of(question)
    for path in paths:
        here: Any = _KINDS[question][1]
        words = ""
        for step in _native.path_steps(path):
            if here is None or issubclass(here, Variant):
                break
            if isinstance(step, int):
                continue
            if step not in here._FIELDS:
                place = f" below `{words}`" if words else ""
                raise RequestError(f"`{path}`: there is no `{step}`{place}", f"there are {', '.join(here._FIELDS)}")
            words = f"{words}.{step}" if words else step
            here = _record_of(here, step)


def _record_of(kind: type[Record], field: str) -> type[Record] | None:
    """The class of a field's structures, where it has some."""
    getter = vars(kind)[field].fget if field in vars(kind) else None
    words = getattr(getter, "__annotations__", {}).get("return", "")
    named = [getattr(_results, word, None) for word in re.findall(r"\w+", str(words))]
    found = [own for own in named if isinstance(own, type) and issubclass(own, Record)]
    return found[0] if len(found) == 1 else None


def known(question: str, options: Mapping[str, Any], further: Sequence[str] = ()) -> None:
    """Refuses an argument that the question has not."""
    if question not in ("explore", "scatter"):
        kind_of(question)
    method = getattr(Engine, question)
    names = set(method.__kwdefaults__ or {}) | (set(method.__annotations__) - {"return"}) | set(further)
    for option in options:
        if option not in names:
            raise RequestError(f"`{question}` has no argument `{option}`", f"it has {', '.join(sorted(names))}")
        if isinstance(options[option], WorkshopSheet):
            raise RequestError(f"`{option}` is a sheet, and a study in blocks writes what it asks into its tables", "give numbers and texts, such as bobweight=\"1.7 kg\"")


def kind_of(question: str) -> str:
    """What the native module calls a question."""
    if question not in _KINDS:
        raise RequestError(f'there is no question "{question}" about many engines', f"there are {', '.join(_KINDS)}")
    return _KINDS[question][0]
