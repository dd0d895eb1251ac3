"""Studies on a cluster: blocks of a study on any ``distributed.Client``, their tables in a folder.

It needs ``distributed`` where a client is given; without one the same blocks are computed here.

Every table is the one that ``lanchester explore`` or ``lanchester scatter`` writes with ``--part``, to the last byte, and :meth:`Blocks.merge` gives the table of the
single run. What is in the folder is not computed again: a call that was interrupted goes on when it is made again, from this client or another one.

>>> import lanchester, lanchester.dask, tempfile
>>> engine = lanchester.Engine.template("in-line-4")
>>> with tempfile.TemporaryDirectory() as folder:
...     found = lanchester.dask.explore(engine, folder, minimise="force order 2", throw_angles="every 90 deg", even_firing=True)
...     len(found.answer.front) > 0
True
"""

from __future__ import annotations

import time
import types
import uuid
import warnings
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any

from . import _blocks
from ._blocks import Study, Tables
from ._native import VERSION
from ._record import Result
from .engine import Engine, Variants
from .errors import LanchesterError, RequestError

__all__ = ["Blocks", "BlockError", "Plan", "Refusal", "explore", "map", "plan", "scatter"]

PARTS = 256
"""Tables of a study, where it has so many blocks, unless `parts` says otherwise."""

LONELY = 30.0
"""After so many seconds without a worker it is said that there is none [s]."""

NAMED = 8
"""So many stretches of blocks are named at most in a message."""

TRIES = 5
"""So often is a block computed whose worker or future got lost before it is given up."""


@dataclass(frozen=True)
class Refusal:
    """A block that a worker could not compute.

    >>> from lanchester.dask import Refusal
    >>> print(Refusal(3, 5, 40, "tcp://10.0.0.7:4000", "the package lanchester is missing"))
    blocks 4 to 5 of 40 on tcp://10.0.0.7:4000: the package lanchester is missing
    """

    first: int
    """Number of the first block, from 0."""
    end: int
    """Number of the block behind the last one."""
    of: int
    """Blocks of the study."""
    worker: str
    """Address of the worker; empty where it is not known."""
    reason: str
    """Why."""

    def __str__(self) -> str:
        what = f"block {self.end}" if self.end == self.first + 1 else f"blocks {self.first + 1} to {self.end}"
        return f"{what} of {self.of}{' on ' + self.worker if self.worker else ''}: {self.reason}"


class BlockError(LanchesterError):
    """Blocks that no worker could compute. What is done lies in the folder; the same call computes the others.

    >>> from lanchester.dask import BlockError, Refusal
    >>> print(BlockError([Refusal(0, 1, 2, "", "out of memory")]).message)
    1 stretch of blocks was not computed: block 1 of 2: out of memory
    """

    refusals: list[Refusal]
    """All of them."""

    def __init__(self, refusals: list[Refusal]) -> None:
        self.refusals = refusals
        count = len(refusals)
        shown = "; ".join(str(own) for own in refusals[:3]) + ("; ..." if count > 3 else "")
        super().__init__(
            f"{count} stretch{'es' if count > 1 else ''} of blocks {'were' if count > 1 else 'was'} not computed: {shown}",
            "mend what is in the way; the same call computes what is missing and nothing else",
        )


class Blocks:
    """A study that is done: a folder of Parquet tables, which pandas, polars, DuckDB and pyarrow read as one dataset.

    >>> import lanchester, lanchester.dask, tempfile
    >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": [0.14, 0.15]})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = lanchester.dask.map("loads", rods, "total.peaks.force.max.value", folder, samples=1)
    ...     len(found.to_dataframe())
    2
    """

    folder: Path
    """Where the tables are."""
    refusals: list[Refusal]
    """Blocks that a worker could not compute and another one did."""
    computed: list[tuple[int, int]]
    """Stretches of blocks that this call has computed; the others were there."""

    def __init__(self, tables: Tables, refusals: list[Refusal], computed: list[tuple[int, int]]) -> None:
        self._tables = tables
        self.folder = tables.folder
        self.refusals = refusals
        self.computed = computed
        self._answer: Result | None = None

    @property
    def files(self) -> list[Path]:
        """The tables in the order of their blocks.

        >>> import lanchester, lanchester.dask, tempfile
        >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": [0.14, 0.15]})
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     len(lanchester.dask.map("loads", rods, "speed", folder, samples=1).files)
        1
        """
        return [path for _, _, path in self._tables.done()]

    @property
    def answer(self) -> Any:
        """What the single run answers: an ``Exploration`` or a ``ScatterStudy``; ``None`` of a study of many engines, whose rows are its answer.

        >>> import lanchester, lanchester.dask, tempfile
        >>> engine = lanchester.Engine.template("in-line-4").with_(tolerances={"piston_mass": {"plus_minus": "2 g"}})
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     found = lanchester.dask.scatter(engine, folder, samples=2000)
        ...     found.answer.to_json() == engine.scatter(samples=2000).to_json()
        True
        """
        kind = self._tables.study.kind
        if kind is not None and self._answer is None:
            self._answer = self._joined(kind, None)
        return self._answer

    def merge(self, path: str | PathLike[str]) -> Path:
        """Writes the one table of the single run, with its bytes. A file that is there is left alone.

        >>> import lanchester, lanchester.dask, pathlib, tempfile
        >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": [0.14, 0.15]})
        >>> with tempfile.TemporaryDirectory() as place:
        ...     found = lanchester.dask.map("loads", rods, "speed", pathlib.Path(place) / "rods", samples=1)
        ...     found.merge(pathlib.Path(place) / "rods.parquet").name
        'rods.parquet'
        """
        if Path(path).resolve().parent == self.folder.resolve():
            raise RequestError(f"{path} would stand among the tables of the study", "choose another folder for the whole")
        answer = self._joined(self._tables.study.kind, path)
        self._answer = answer if self._answer is None else self._answer
        return Path(path)

    def _joined(self, kind: type[Result] | None, path: str | PathLike[str] | None) -> Result | None:
        study = self._tables.study
        answer = study.native.join(self.files, path)
        if answer is None or kind is None:
            return None
        return kind._made(answer, tuple(study.engines))

    def to_arrow(self) -> Any:
        """All rows as a table of pyarrow, which it needs.

        >>> import lanchester, lanchester.dask, tempfile
        >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": [0.14, 0.15]})
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     lanchester.dask.map("loads", rods, "speed", folder, samples=1).to_arrow().column_names
        ['case', 'rod.length', 'speed']
        """
        import pyarrow
        import pyarrow.parquet

        # The metadata are those of a part: they say nothing of all rows.
        tables = [pyarrow.parquet.read_table(path).replace_schema_metadata(None) for path in self.files]
        return pyarrow.concat_tables(tables)

    def to_dataframe(self) -> Any:
        """All rows as a pandas DataFrame. It needs pandas and pyarrow.

        >>> import lanchester, lanchester.dask, tempfile
        >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": [0.14, 0.15]})
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     list(lanchester.dask.map("loads", rods, "speed", folder, samples=1).to_dataframe()["rod.length"])
        [0.14, 0.15]
        """
        return self.to_arrow().to_pandas()

    def __repr__(self) -> str:
        return f"<Blocks of {self._tables.study.name} in {self.folder}: {self._tables.study.native.cases} cases, {self._tables.study.blocks} blocks>"


def explore(
    engine: Engine,
    folder: str | PathLike[str],
    *,
    client: Any = None,
    parts: int | None = None,
    shared: bool = False,
    rows: str = "judged",
    **options: Any,
) -> Blocks:
    """All layouts as :meth:`Engine.explore` finds them, block by block, with their rows in a folder of tables.

    `client`: a ``distributed.Client``; `parts`: so many tables, those of ``--part``; `shared`: workers write into the folder themselves, which they see
    under the same name; `rows`: ``"judged"`` for all layouts that are judged, ``"front"`` for the Pareto-optimal ones of :meth:`Blocks.merge` alone.

    >>> import lanchester, lanchester.dask, tempfile
    >>> engine = lanchester.Engine.template("in-line-4")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = lanchester.dask.explore(engine, folder, minimise="force order 2", throw_angles="every 90 deg")
    ...     len(found.to_dataframe()) == found.answer.counts.judged
    True
    """
    return _run(_layouts(engine, rows, options), folder, client, parts, shared)


def _layouts(engine: Engine, rows: str, options: Mapping[str, Any]) -> Study:
    _blocks.known("explore", options)
    even = options.get("even_firing")
    even = 0.0 if even is True else None if even is False else even
    return Study("explore", [engine], {**options, "even_firing": even, "rows": rows})


def scatter(
    engine: Engine,
    folder: str | PathLike[str],
    *,
    client: Any = None,
    parts: int | None = None,
    shared: bool = False,
    **options: Any,
) -> Blocks:
    """Engines of a production as :meth:`Engine.scatter` draws them, block by block, each a row in a folder of tables.

    >>> import lanchester, lanchester.dask, tempfile
    >>> engine = lanchester.Engine.template("in-line-4").with_(tolerances={"piston_mass": {"plus_minus": "2 g"}})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     len(lanchester.dask.scatter(engine, folder, samples=2000).to_dataframe())
    2000
    """
    _blocks.known("scatter", options)
    return _run(Study("scatter", [engine], options), folder, client, parts, shared)


def map(
    question: str,
    engines: Sequence[Engine] | Variants,
    pick: str | Sequence[str],
    folder: str | PathLike[str],
    *,
    client: Any = None,
    parts: int | None = None,
    shared: bool = False,
    **options: Any,
) -> Blocks:
    """One question about many engines as :func:`lanchester.map` asks it, block by block, each engine a row: parameter studies, sweeps of ``"simulate"``.

    The columns are the number of the case, the keys that differ, and the numbers at the paths of `pick`.

    >>> import lanchester, lanchester.dask, tempfile
    >>> rods = lanchester.Engine.template("single").variants({"rod.length": [0.14, 0.15]})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = lanchester.dask.map("simulate", rods, "run.audit.energy", folder, revolutions=1, imposed=True)
    ...     len(found.to_dataframe())
    2
    """
    _blocks.known(question, options)
    picks = [pick] if isinstance(pick, str) else list(pick)
    _blocks.check_paths(question, picks)
    return _run(Study(_blocks.kind_of(question), engines, options, picks), folder, client, parts, shared)


@dataclass(frozen=True)
class Plan:
    """What a study takes, from blocks of it that were computed here.

    >>> from lanchester.dask import Plan
    >>> plan = Plan(cases=10**9, blocks=30518, case_seconds=2e-6, case_bytes=20.0, cores=64, core_hour_price=0.05)
    >>> round(plan.hours, 4), plan.bytes, round(plan.cost, 4)
    (0.0087, 20000000000, 0.0278)
    """

    cases: int
    """Cases of the study."""
    blocks: int
    """Blocks of the study."""
    case_seconds: float
    """Seconds of one core for one case."""
    case_bytes: float
    """Bytes of the tables for one case."""
    cores: int
    """Cores of the cluster."""
    core_hour_price: float
    """Price of a core for an hour."""

    @property
    def core_hours(self) -> float:
        """Hours of one core.

        >>> from lanchester.dask import Plan
        >>> Plan(cases=3600, blocks=1, case_seconds=1.0, case_bytes=1.0, cores=2, core_hour_price=0.0).core_hours
        1.0
        """
        return self.cases * self.case_seconds / 3600

    @property
    def hours(self) -> float:
        """Hours on all cores.

        >>> from lanchester.dask import Plan
        >>> Plan(cases=3600, blocks=1, case_seconds=1.0, case_bytes=1.0, cores=2, core_hour_price=0.0).hours
        0.5
        """
        return self.core_hours / self.cores

    @property
    def bytes(self) -> int:
        """Bytes of all tables.

        >>> from lanchester.dask import Plan
        >>> Plan(cases=3600, blocks=1, case_seconds=1.0, case_bytes=2.0, cores=2, core_hour_price=0.0).bytes
        7200
        """
        return round(self.cases * self.case_bytes)

    @property
    def cost(self) -> float:
        """Price of all core hours.

        >>> from lanchester.dask import Plan
        >>> Plan(cases=3600, blocks=1, case_seconds=1.0, case_bytes=1.0, cores=2, core_hour_price=0.5).cost
        0.5
        """
        return self.core_hours * self.core_hour_price


def plan(engine: Engine, *, cores: int, core_hour_price: float = 0.0, samples: int = 4, rows: str = "judged", **options: Any) -> Plan:
    """What a search over layouts takes on `cores` cores, from `samples` of its blocks, spread over it, which are computed here.

    >>> import lanchester, lanchester.dask
    >>> engine = lanchester.Engine.template("in-line-4")
    >>> found = lanchester.dask.plan(engine, cores=64, minimise="force order 2", throw_angles="every 15 deg")
    >>> found.cases, found.hours > 0
    (110592, True)
    """
    for name, count in (("cores", cores), ("samples", samples)):
        if count < 1:
            raise RequestError(f"`{name}` needs a whole number from 1, got {count}", "a plan is for one core at least, from one block at least")
    study = _layouts(engine, rows, options)
    of = study.blocks
    places = sorted({number * of // samples for number in range(samples)} | {0})
    study.table(places[0], places[0] + 1)
    spent, size = 0.0, 0
    for place in places:
        began = time.process_time()
        table = study.table(place, place + 1)
        spent += time.process_time() - began
        size += len(table)
    # Blocks are equally many cases, but the last one.
    cases = study.native.cases if of == 1 else len(places) * (study.native.cases / of)
    return Plan(study.native.cases, of, spent / cases, size / cases, cores, core_hour_price)


def _run(study: Study, folder: str | PathLike[str], client: Any, parts: int | None, shared: bool) -> Blocks:
    if client is not None and not hasattr(client, "submit"):
        raise RequestError(f"`client` needs a client of Dask, got `{type(client).__name__}`", "give client=distributed.Client(...), or leave it out to compute here")
    if parts is not None and parts < 1:
        raise RequestError(f"`parts` needs a whole number from 1, got {parts}", "leave it out for its usual value")
    tables = Tables(folder, study)
    with tables.alone():
        missing = tables.missing(min(parts or PARTS, study.blocks))
        if client is None:
            for first, end in missing:
                _blocks.put(tables.folder, first, end, study.table(first, end))
            refusals: list[Refusal] = []
        else:
            refusals = _Cluster(client, study, tables.folder, shared).run(missing)
    return Blocks(tables, refusals, missing)


def _remote() -> Any:
    """What workers run. It is sent by its value, so that a worker without the package says so."""

    def lanchester_blocks(version: str, ask: bytes, first: int, end: int, folder: str | None) -> tuple[str, str, Any]:
        import distributed

        try:
            where = str(distributed.get_worker().address)
        except Exception:
            where = ""
        try:
            import lanchester
            from lanchester._blocks import compute
        except ImportError as error:
            return "refused", where, f"the package lanchester is missing ({error})"
        if lanchester.__version__ != version:
            return "refused", where, f"it has lanchester {lanchester.__version__}, the client has {version}"
        try:
            return "done", where, compute(ask, first, end, folder)
        except MemoryError:
            return "refused", where, "out of memory"
        except OSError as error:
            return "refused", where, str(error)
        except lanchester.LanchesterError as error:
            return "failed", where, str(error)

    code = lanchester_blocks.__code__
    return types.FunctionType(code, {"__name__": "__main__", "__builtins__": __builtins__}, code.co_name)


def _blocks_of(stretches: Sequence[tuple[int, int]], of: int) -> str:
    """Stretches of blocks in words, neighbours as one: "blocks 3 to 5 and 9 of 24 are"."""
    joined: list[list[int]] = []
    for first, end in sorted(stretches):
        if joined and joined[-1][1] == first:
            joined[-1][1] = end
        else:
            joined.append([first, end])
    count = sum(end - first for first, end in joined)
    if count == 0:
        return f"some of {of} blocks may be"
    names = [f"{end}" if end == first + 1 else f"{first + 1} to {end}" for first, end in joined]
    if len(names) > NAMED:
        names = [*names[:NAMED], f"{len(names) - NAMED} more stretches"]
    words = names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
    return f"block{'s' if count > 1 else ''} {words} of {of} {'are' if count > 1 else 'is'}"


class _Cluster:
    """A study on the workers of a client: as many blocks at a time as keep them busy."""

    def __init__(self, client: Any, study: Study, folder: Path, shared: bool) -> None:
        self.client = client
        self.study = study
        self.folder = folder
        self.shared = shared
        self.function = _remote()
        self.running: dict[Any, tuple[int, int]] = {}
        self.waiting: deque[tuple[int, int]] = deque()
        self.tries: dict[tuple[int, int], int] = {}
        self.unfit: set[str] = set()
        self.refusals: list[Refusal] = []
        self.given_up: list[Refusal] = []
        self.lonely: float | None = None
        # The same question of all blocks, but of a study of engines.
        self.ask = study.ask(0, study.blocks) if study.pick is None else None

    def run(self, missing: Sequence[tuple[int, int]]) -> list[Refusal]:
        import distributed

        self.waiting.extend(missing)
        try:
            while self.waiting or self.running:
                self._submit()
                try:
                    distributed.wait(list(self.running), timeout=1, return_when="FIRST_COMPLETED")
                except (TimeoutError, distributed.CancelledError):
                    self._lost()
                for future in [own for own in self.running if own.status != "pending"]:
                    # It counts as running until its table is there: what is missing is told where the scheduler dies meanwhile.
                    self._end(future, self.running[future])
                    del self.running[future]
        except LanchesterError:
            raise
        except Exception as error:
            # What Dask raises of a client that is closed is of many kinds: the state of the client tells.
            if self._is_there():
                raise
            raise self._gone(error) from error
        finally:
            if self.running and self._is_there():
                self.client.cancel(list(self.running), force=True)
        if self.given_up:
            raise BlockError(self.given_up)
        for own in self.refusals:
            warnings.warn(f"{own}; another worker has computed it", stacklevel=4)
        return self.refusals

    def _is_there(self) -> bool:
        """Whether the client still has a scheduler."""
        return getattr(self.client, "status", "running") == "running"

    def _gone(self, error: BaseException | None = None) -> LanchesterError:
        why = f" ({type(error).__name__}: {error})" if error is not None and str(error) else ""
        left = [*self.waiting, *self.running.values()]
        return LanchesterError(
            f"the client of the cluster is {getattr(self.client, 'status', 'gone')}: it was closed, or the scheduler has died{why}; "
            f"{_blocks_of(left, self.study.blocks)} missing in {self.folder}",
            "finished blocks stay: the same call with a new client goes on, and computes what is missing and nothing else",
        )

    def _submit(self) -> None:
        if not self._is_there():
            raise self._gone()
        threads = self.client.nthreads()
        self._alone(bool(threads))
        fit = [worker for worker in threads if worker not in self.unfit]
        if threads and not fit and self.waiting:
            # Nobody is left who could: what is told is why.
            reasons = {own.worker: own for own in self.refusals}
            told = next(iter(reasons.values()))
            self.given_up += [Refusal(first, end, self.study.blocks, told.worker, told.reason) for first, end in self.waiting]
            self.waiting.clear()
            return
        width = max(2, 2 * sum(threads[worker] for worker in fit))
        while self.waiting and len(self.running) < width:
            first, end = self.waiting.popleft()
            ask = self.study.ask(first, end) if self.ask is None else self.ask
            folder = str(self.folder.resolve()) if self.shared else None
            future = self.client.submit(
                self.function,
                VERSION,
                ask,
                first,
                end,
                folder,
                key=f"lanchester-{uuid.uuid4().hex}-{first}-{end}",
                workers=fit if self.unfit else None,
                pure=False,
            )
            self.running[future] = (first, end)

    def _alone(self, has_workers: bool) -> None:
        """Says once that nobody is there to compute: workers that wait in a queue come yet, those that are gone for good do not."""
        now = time.monotonic()
        if has_workers:
            self.lonely = None
        elif self.lonely is None:
            self.lonely = now
        elif self.lonely >= 0.0 and now - self.lonely > LONELY:
            count = len(self.waiting) + len(self.running)
            warnings.warn(f"the cluster has had no worker for {LONELY:.0f} s; {count} stretch{'es' if count > 1 else ''} of blocks wait for one, Ctrl-C stops the waiting", stacklevel=6)
            self.lonely = -1.0

    def _lost(self) -> None:
        """Submits again what waits for workers that are gone."""
        if not self.unfit:
            return
        known = set(self.client.nthreads()) - self.unfit
        if not known:
            return
        busy = {key for keys in self.client.processing().values() for key in keys}
        for future in [own for own in self.running if own.status == "pending" and own.key not in busy]:
            self.waiting.append(self.running.pop(future))
            self.client.cancel([future], force=True)

    def _end(self, future: Any, stretch: tuple[int, int]) -> None:
        first, end = stretch
        if future.status == "finished":
            import distributed

            try:
                how, worker, found = future.result()
            except distributed.CancelledError:
                # The cluster was restarted before the result came over.
                self._again(stretch, Refusal(first, end, self.study.blocks, "", f"the cluster has lost it {TRIES} times"))
                return
            if how == "done":
                if found is not None:
                    _blocks.put(self.folder, first, end, found)
                return
            refusal = Refusal(first, end, self.study.blocks, worker, found)
            if how == "refused":
                self.refusals.append(refusal)
                self.unfit.add(worker)
                self._again(stretch, refusal)
            else:
                self.given_up.append(refusal)
        elif future.status == "error":
            error = future.exception()
            worker = str(getattr(getattr(error, "last_worker", None), "address", ""))
            reason = f"{type(error).__name__}: {error}"
            if type(error).__name__ == "KilledWorker":
                reason = "its workers died one after another: out of memory, or killed"
            self.given_up.append(Refusal(first, end, self.study.blocks, worker, reason))
        else:
            # Cancelled or lost: the cluster was restarted.
            self._again(stretch, Refusal(first, end, self.study.blocks, "", f"the cluster has lost it {TRIES} times"))

    def _again(self, stretch: tuple[int, int], refusal: Refusal) -> None:
        self.tries[stretch] = self.tries.get(stretch, 0) + 1
        if self.tries[stretch] >= TRIES:
            self.given_up.append(refusal)
        else:
            self.waiting.append(stretch)
