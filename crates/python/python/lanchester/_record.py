"""What all results have in common: fields by name, tables, pictures, JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

import numpy as np
import numpy.typing as npt

from ._kept import Kept
from .errors import LanchesterError, RequestError
from .table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure as MatplotlibFigure

    from ._native import Answer
    from .engine import Engine

FloatArray = npt.NDArray[np.float64]
R = TypeVar("R", bound="Record")


class _Lazy(dict[str, Any]):
    """Fields of an answer, each converted when it is first looked at."""

    def __init__(self, answer: Answer | Kept) -> None:
        self.answer = answer

    def __missing__(self, name: str) -> Any:
        try:
            value = self.answer.field(name)
        except AttributeError:
            # What has nothing to say is left out of a result, as it is of its JSON.
            value = None
        self[name] = value
        return value


class Record:
    """A structure of a result: its fields are attributes, with units in their descriptions; SI units and radians throughout.

    Arrays are read-only NumPy arrays; complex numbers are rows of real and imaginary part.

    >>> from lanchester import Engine
    >>> peak = Engine.template("in-line-4").loads().total.peaks.force.max
    >>> peak.value > 0
    True
    """

    __slots__ = ("_values",)
    _FIELDS: tuple[str, ...] = ()

    def __init__(self, values: Mapping[str, Any]) -> None:
        self._values = values

    def _get(self, name: str) -> Any:
        if isinstance(self._values, _Lazy):
            return self._values[name]
        return self._values.get(name)

    def _array(self, name: str) -> Any:
        value = self._get(name)
        return np.asarray(value, dtype=np.float64) if isinstance(value, list) else value

    def _rows(self, name: str) -> Any:
        value = self._get(name)
        return None if value is None else [np.asarray(row, dtype=np.float64) for row in value]

    def _list(self, name: str) -> Any:
        value = self._get(name)
        return [] if value is None else value

    def _of(self, name: str, kind: Callable[[Any], R]) -> Any:
        value = self._get(name)
        return None if value is None else kind(value)

    def _as(self, name: str, read: Callable[[Any], Any], nothing: Any) -> Any:
        value = self._get(name)
        return nothing if value is None else read(value)

    def _all(self, name: str, kind: type[R]) -> Records[R]:
        value = self._get(name)
        return Records([] if value is None else value, kind)

    def to_dict(self) -> dict[str, Any]:
        """All fields as plain values: dictionaries, lists, numbers and texts.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().total.orders[1].to_dict()["order"]
        1.0
        """
        plain: dict[str, Any] = _plain(dict(self._values))
        return plain

    def to_table(self) -> Table:
        """The fields that are series as a table: a trace over the angle, the samples of a run. A vector has a column for each component.

        >>> from lanchester import Engine
        >>> trace = Engine.template("in-line-4").loads().total.trace
        >>> len(trace.to_table()) == len(trace.theta)
        True
        """
        fields = {name: getattr(self, name) for name in self._FIELDS}
        lengths = [len(own) for own in fields.values() if isinstance(own, np.ndarray) and own.ndim in (1, 2)]
        count = max(lengths, key=lambda length: (lengths.count(length), length), default=0)
        if count == 0:
            raise RequestError(f"{type(self).__name__} has no series that make a table", "its fields are attributes, and `to_dict()` has them all")
        columns: dict[str, Any] = {}
        units: dict[str, str] = {}
        # What everything else is over comes first.
        first = ("time", "theta", "speeds")
        for name in sorted(fields, key=lambda name: first.index(name) if name in first else len(first)):
            value, unit = fields[name], _unit(type(self), name)
            if isinstance(value, np.ndarray) and value.ndim in (1, 2) and len(value) == count:
                _put(columns, units, name, value, unit)
            for place, own in enumerate(_parts(value, count), 1):
                _put(columns, units, f"{name}_{place}", own, unit)
        return Table(type(self).__name__, type(self).__name__, columns, units)

    def to_dataframe(self) -> Any:
        """The same as a pandas DataFrame, which needs pandas.

        >>> from lanchester import Engine
        >>> frame = Engine.template("in-line-4").loads().total.trace.to_dataframe()
        >>> "force_x [N]" in frame.columns
        True
        """
        return self.to_table().to_dataframe()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self.to_table().__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        shown = ", ".join(f"{name}={_short(getattr(self, name))}" for name in self._FIELDS[:8])
        more = ", ..." if len(self._FIELDS) > 8 else ""
        return f"{type(self).__name__}({shown}{more})"

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__()})


class Matrices(Record):
    """A structure with square matrices, which its JSON has row by row."""

    __slots__ = ()
    _SQUARE: tuple[str, ...] = ()

    def _square(self, name: str) -> Any:
        numbers = np.asarray(self._get(name), dtype=np.float64)
        size = round(len(numbers) ** 0.5)
        return numbers.reshape(size, size)

    def matrices(self) -> dict[str, FloatArray]:
        """All its matrices and vectors by name, as ``numpy.savez`` takes them.

        >>> from lanchester import Engine
        >>> engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": None, "crank.body.journal_fillet": None})
        >>> model = engine.reduced_model(4, size="20 mm", fillet_elements=2).model
        >>> model.matrices()["stiffness"].ndim
        2
        """
        found = {name: getattr(self, name) for name in self._FIELDS}
        return {name: own for name, own in found.items() if isinstance(own, np.ndarray)}


class Variant(Record):
    """One of several variants: `kind` says which it is, and the attribute of its name has what is in it; the others are None.

    It equals the word of its kind, and what is in it is found by its word too.

    >>> from lanchester import Engine
    >>> criterion = Engine.template("twin-360").balance(minimise="force order 1", counterweights="throws").task.stages[0].terms[0][1]
    >>> criterion.kind, criterion.order[0].kind, criterion.order[1]
    ('order', 'force', 1.0)
    >>> criterion.order[0] == "force", criterion.peak is None
    (True, True)
    """

    __slots__ = ()
    _values: Any

    def _kind(self) -> Any:
        return self._values if isinstance(self._values, str) else next(iter(self._values))

    def _get(self, name: str) -> Any:
        return None if isinstance(self._values, str) else self._values.get(name)

    def to_dict(self) -> dict[str, Any]:
        """Its kind as the key of what is in it, as plain values; of a word alone there is nothing in it.

        >>> from lanchester import Engine
        >>> Engine.template("twin-360").balance(minimise="force", counterweights="throws").task.stages[0].terms[0][1].to_dict()
        {'peak': 'force'}
        """
        plain: dict[str, Any] = {self._values: None} if isinstance(self._values, str) else _plain(self._values)
        return plain

    def __getitem__(self, kind: str) -> Any:
        if isinstance(self._values, str):
            raise KeyError(kind)
        return self._values[kind]

    def __contains__(self, kind: object) -> bool:
        return not isinstance(self._values, str) and kind in self._values

    def __eq__(self, other: object) -> bool:
        return bool(_plain(self._values) == _plain(other._values if isinstance(other, Variant) else other))

    def __hash__(self) -> int:
        return hash(self._kind())

    def __str__(self) -> str:
        return str(self._kind()) if isinstance(self._values, str) else repr(self)

    def __repr__(self) -> str:
        inside = next((_short(getattr(self, name)) for name in self._FIELDS[1:] if getattr(self, name) is not None), None)
        return f"{type(self).__name__}({self._kind()!r}{'' if inside is None else ', ' + inside})"


def one(value: Any) -> Any:
    """A value as it is."""
    return value


def an_array(value: Any) -> Any:
    """Numbers as an array."""
    return np.asarray(value, dtype=np.float64) if isinstance(value, list) else value


def optionally(read: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """What may be missing."""
    return lambda value: None if value is None else read(value)


def record(kind: type[R]) -> Callable[[Any], Records[R]]:
    """Structures of one kind."""
    return lambda values: Records(values, kind)


def row(*reads: Callable[[Any], Any]) -> Callable[[Any], tuple[Any, ...]]:
    """A row of values of several kinds."""
    return lambda values: tuple(read(value) for read, value in zip(reads, values, strict=True))


def every(read: Callable[[Any], Any]) -> Callable[[Any], list[Any]]:
    """A list of values of one kind."""
    return lambda values: [read(value) for value in values]


def _parts(value: Any, count: int) -> list[Any]:
    """The series of the parts of a field: given sample by sample, or part by part."""
    if not (isinstance(value, list) and value and all(isinstance(own, np.ndarray) and own.ndim in (1, 2) for own in value)):
        return []
    if len(value) == count and len({own.shape for own in value}) == 1:
        return list(np.swapaxes(np.asarray(value), 0, 1))
    return [own for own in value if len(own) == count]


_COMPONENTS = {2: ("re", "im"), 3: ("x", "y", "z"), 4: ("w", "x", "y", "z")}


def _put(columns: dict[str, Any], units: dict[str, str], name: str, values: Any, unit: str) -> None:
    """Puts values into a column, or each of their components into one of its own."""
    if values.ndim == 1:
        columns[name] = values
        if unit:
            units[name] = unit
        return
    names = _COMPONENTS.get(values.shape[1]) or tuple(str(place) for place in range(1, values.shape[1] + 1))
    for place, component in enumerate(names):
        _put(columns, units, f"{name}_{component}", values[:, place], unit)


def _unit(kind: type[Any], name: str) -> str:
    """The unit of a field by its description; empty where it has none, or several."""
    found = set(_UNIT.findall(getattr(kind, name).__doc__ or ""))
    return "" if len(found) != 1 else str(found.pop())


_UNIT = re.compile(r"\[((?:rad|deg|rpm|kg|N|J|W|Pa|Hz|K|m|s|1/)[A-Za-z0-9/^() ]*)\]")


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, dict):
        return {key: _plain(below) for key, below in value.items()}
    if isinstance(value, list):
        return [_plain(below) for below in value]
    return value


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"<array {'x'.join(map(str, value.shape))}>" if value.size > 3 else repr(value.tolist())
    if isinstance(value, Records):
        return f"<{len(value)} {value.kind.__name__}>"
    if isinstance(value, Record):
        return f"{type(value).__name__}(...)"
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


class Records(Sequence[R], Generic[R]):
    """Structures of one kind in their order; :meth:`column` is one field of all of them.

    >>> from lanchester import Engine
    >>> orders = Engine.template("in-line-4").loads().total.orders
    >>> orders.column("order")[:3]
    array([0., 1., 2.])
    """

    __slots__ = ("_all", "kind")

    def __init__(self, values: Sequence[Any], kind: type[R]) -> None:
        self._all = values
        self.kind = kind

    def __len__(self) -> int:
        return len(self._all)

    @overload
    def __getitem__(self, place: int) -> R: ...
    @overload
    def __getitem__(self, place: slice) -> Records[R]: ...
    def __getitem__(self, place: int | slice) -> R | Records[R]:
        if isinstance(place, slice):
            return Records(self._all[place], self.kind)
        return self.kind(self._all[place])

    def __iter__(self) -> Iterator[R]:
        return (self.kind(values) for values in self._all)

    def column(self, name: str) -> Any:
        """One field of all: an array where it is a number or an array of one shape, else a list.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().cylinders.column("cylinder")
        [1, 2, 3, 4]
        """
        if not hasattr(self.kind, name):
            raise AttributeError(f"{self.kind.__name__} has no `{name}`; it has {', '.join(self.kind._FIELDS)}")
        values = [getattr(own, name) for own in self]
        if values and all(isinstance(value, (float, np.ndarray)) for value in values):
            shapes = {np.shape(value) for value in values}
            return np.asarray(values, dtype=np.float64) if len(shapes) == 1 else values
        return values

    def to_table(self) -> Table:
        """The fields that are numbers, texts or truth values as a table; a vector has a column for each component.

        >>> from lanchester import Engine
        >>> "order" in Engine.template("in-line-4").loads().total.orders.to_table().columns
        True
        """
        columns: dict[str, Any] = {}
        units: dict[str, str] = {}
        for name in self.kind._FIELDS:
            values = self.column(name)
            unit = _unit(self.kind, name)
            if isinstance(values, np.ndarray):
                if values.ndim == 1 or (values.ndim == 2 and values.shape[1] <= 4):
                    _put(columns, units, name, values, unit)
            elif all(value is None or isinstance(value, (str, int, float, bool)) or (isinstance(value, Variant) and isinstance(value._values, str)) for value in values):
                columns[name] = [str(value) if isinstance(value, Variant) else value for value in values]
                if unit:
                    units[name] = unit
        return Table(self.kind.__name__, self.kind.__name__, columns, units)

    def to_dataframe(self) -> Any:
        """The same as a pandas DataFrame, which needs pandas.

        >>> from lanchester import Engine
        >>> frame = Engine.template("in-line-4").loads().total.orders.to_dataframe()
        >>> len(frame) == len(Engine.template("in-line-4").loads().total.orders)
        True
        """
        return self.to_table().to_dataframe()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self.to_table().__arrow_c_stream__(requested_schema)

    def __repr__(self) -> str:
        return f"[{', '.join(repr(own) for own in self)}]" if len(self) <= 3 else f"<{len(self)} {self.kind.__name__}>"


class Picture:
    """A drawing as SVG, as the report has it. A notebook shows it.

    >>> from lanchester import Engine
    >>> picture = Engine.template("in-line-4").loads().figures[0]
    >>> picture.svg.startswith("<svg")
    True
    """

    __slots__ = ("name", "svg", "title")

    def __init__(self, name: str, title: str, svg: str) -> None:
        self.name = name
        self.title = title
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"Picture({self.name!r}, {self.title!r})"


class Result(Record):
    """The answer to a question. It is what the command line prints with ``--format json``, field by field.

    >>> from lanchester import Engine
    >>> loads = Engine.template("in-line-4").loads()
    >>> [table.name for table in loads.tables][:2]
    ['findings', 'peaks']
    """

    __slots__ = ("_engines",)
    _engines: tuple[Engine, ...]

    @classmethod
    def _made(cls: type[Q], answer: Answer | Kept, engines: tuple[Engine, ...]) -> Q:
        made = cls(_Lazy(answer))
        made._engines = engines
        return made

    def __copy__(self: Q) -> Q:
        return self

    def __deepcopy__(self: Q, memo: dict[int, Any]) -> Q:
        # Results do not change.
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        if isinstance(self._values, _Lazy):
            kept = self._values.answer
            return _kept_again, (type(self), kept if isinstance(kept, Kept) else Kept.of(kept), self._engines)
        return type(self), (dict(self._values),)

    @property
    def _answer(self) -> Answer | Kept:
        if isinstance(self._values, _Lazy):
            return self._values.answer
        raise RequestError(
            f"this {type(self).__name__} is a part of another result",
            "ask the result that it is a part of for tables and pictures",
        )

    def to_dict(self) -> dict[str, Any]:
        """All fields as plain values.

        >>> from lanchester import Engine
        >>> sorted(Engine.template("in-line-4").loads().to_dict())[:3]
        ['cylinders', 'diagnosis', 'engine']
        """
        if not isinstance(self._values, _Lazy):
            return super().to_dict()
        found: dict[str, Any] = json.loads(self.to_json())
        return found

    def to_json(self) -> str:
        """The JSON that the command line prints.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().to_json()[:1]
        '{'
        """
        return self._answer.json()

    def to_text(self) -> str:
        """The words and tables that the command line prints; empty where it has none.

        >>> from lanchester import Engine
        >>> "rpm" in Engine.template("in-line-4").loads().to_text().splitlines()[0]
        True
        """
        return self._answer.text()

    def pick(self, path: str) -> Any:
        """What is at a path; nothing else is converted.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().pick("total.orders[1].order")
        1.0
        """
        try:
            return self._answer.pick(path)
        except AttributeError as error:
            raise RequestError(f"`{path}`: {error}", "`to_dict()` shows what there is") from None

    @property
    def tables(self) -> list[Table]:
        """The tables of the report. Where several are of one kind, the second has a name that ends in ``-2``.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().tables[1].name
        'peaks'
        """
        tables = [Table._of(*parts) for parts in self._answer.tables()]
        taken: set[str] = set()
        for table in tables:
            name, number = table.name, 2
            while table.name in taken:
                table.name = f"{name}-{number}"
                number += 1
            taken.add(table.name)
        return tables

    def table(self, name: str) -> Table:
        """One of the tables by its name.

        >>> from lanchester import Engine
        >>> len(Engine.template("in-line-4").loads().table("peaks").columns) > 1
        True
        """
        tables = self.tables
        for table in tables:
            if table.name == name:
                return table
        names = ", ".join(table.name for table in tables) or "no table at all"
        raise RequestError(f'there is no table "{name}" in {type(self).__name__}', f"there is {names}")

    def to_table(self, name: str | None = None) -> Table:
        """One of the tables, the first one where no name is given.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").loads().to_table("peaks").name
        'peaks'
        """
        if name is not None:
            return self.table(name)
        tables = self.tables if isinstance(self._values, _Lazy) else []
        if not tables:
            raise RequestError(f"{type(self).__name__} has no table", "its fields are attributes")
        return tables[0]

    def to_dataframe(self, name: str | None = None) -> Any:
        """One of the tables as a pandas DataFrame, the first one where no name is given. It needs pandas.

        >>> from lanchester import Engine
        >>> frame = Engine.template("in-line-4").loads().to_dataframe("peaks")
        >>> len(frame) > 3
        True
        """
        return self.to_table(name).to_dataframe()

    @property
    def figures(self) -> list[Picture]:
        """The pictures of the report.

        >>> from lanchester import Engine
        >>> len(Engine.template("in-line-4").loads().figures) > 2
        True
        """
        return [Picture(*parts) for parts in self._answer.figures()]

    def plot(self) -> MatplotlibFigure:
        """What matters most as a figure of Matplotlib, which must be installed.

        >>> from lanchester import Engine
        >>> figure = Engine.template("in-line-4").loads().plot()
        >>> len(figure.axes) > 0
        True
        """
        from . import plots

        return plots.plot(self)

    def adopt(self, number: int | None = None) -> Engine:
        """The engine with what was found: the weights of a balance, the shapes of counterweights, layout `number` of a search, from 0.

        >>> from lanchester import Engine
        >>> twin = Engine.template("twin-360")
        >>> twin.balance(minimise="force", counterweights="throws").adopt() != twin
        True
        """
        from .engine import adopt

        return adopt(self, number)

    def _repr_html_(self) -> str:
        pictures: list[str] = []
        for picture in self.figures[:2]:
            if sum(map(len, pictures)) + len(picture.svg) <= MOST_SVG:
                pictures.append(picture.svg)
        if not pictures and self.figures:
            # A mesh as SVG would fill the notebook's file.
            pictures = _drawn(self)
        tables = [table._repr_html_() for table in self.tables[: 1 if pictures else 2]]
        return "\n".join([*pictures, *tables]) or f"<pre>{_escaped(self.to_text() or repr(self))}</pre>"


Q = TypeVar("Q", bound=Result)


MOST_SVG = 150_000
"""Characters of SVG that a notebook is given at most for one result."""


def _drawn(result: Result) -> list[str]:
    """The plot of a result as an image for a page; none without Matplotlib."""
    from base64 import b64encode
    from io import BytesIO

    image = BytesIO()
    try:
        result.plot().savefig(image, format="png", dpi=80)
    except LanchesterError:
        return []
    return [f'<img alt="{_escaped(type(result).__name__)}" src="data:image/png;base64,{b64encode(image.getvalue()).decode()}"/>']


def _kept_again(kind: type[Q], kept: Kept, engines: tuple[Engine, ...]) -> Q:
    """A result out of a pickle."""
    return kind._made(kept, engines)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
