"""Tables of results: columns with units, for pandas, polars, DuckDB and pyarrow."""

from __future__ import annotations

from typing import Any

__all__ = ["Table"]


class Table:
    """A table: columns by name, with units.

    It offers the Arrow C interface (``__arrow_c_stream__``) where pyarrow is installed, so that polars and DuckDB read it as it is.

    >>> from lanchester import Engine
    >>> table = Engine.template("in-line-4").loads().table("peaks")
    >>> len(table) > 3
    True
    """

    __slots__ = ("columns", "name", "note", "remark", "title", "units")

    columns: dict[str, Any]
    """Columns by their head: arrays of numbers, NaN where there is none, or lists."""
    name: str
    """Name: lower case, digits and hyphens."""
    note: str
    """How to read it; may be empty."""
    remark: str
    """What it leaves out; may be empty."""
    title: str
    """Title."""
    units: dict[str, str]
    """Units of the columns that have one."""

    def __init__(
        self, name: str, title: str, columns: dict[str, Any], units: dict[str, str], note: str = "", remark: str = ""
    ) -> None:
        self.name, self.title, self.columns, self.units = name, title, columns, units
        self.note, self.remark = note, remark

    @classmethod
    def _of(cls, name: str, title: str, columns: list[tuple[str, str, Any]], note: str, remark: str) -> Table:
        found: dict[str, Any] = {}
        units: dict[str, str] = {}
        for place, (head, unit, values) in enumerate(columns):
            own = head or f"column {place + 1}"
            while own in found:
                own += "'"
            found[own] = values
            if unit:
                units[own] = unit
        return cls(name, title, found, units, note, remark)

    def __len__(self) -> int:
        return min((len(values) for values in self.columns.values()), default=0)

    def __getitem__(self, name: str) -> Any:
        return self.columns[name]

    def _headed(self) -> dict[str, Any]:
        unit = {name: f" [{unit}]" for name, unit in self.units.items()}
        return {name + unit.get(name, ""): values for name, values in self.columns.items()}

    def to_dataframe(self) -> Any:
        """As a pandas DataFrame, with units in the heads. It needs pandas.

        >>> from lanchester import Engine
        >>> frame = Engine.template("in-line-4").loads().table("peaks").to_dataframe()
        >>> frame.attrs["title"] != ""
        True
        """
        import pandas

        frame = pandas.DataFrame(self._headed())
        frame.attrs["title"] = self.title
        return frame

    def to_arrow(self) -> Any:
        """As a table of pyarrow, with units in the heads. It needs pyarrow.

        >>> from lanchester import Engine
        >>> table = Engine.template("in-line-4").loads().table("peaks")
        >>> table.to_arrow().num_rows == len(table)
        True
        """
        import pyarrow

        return pyarrow.table({name: _of_one_kind(values) for name, values in self._headed().items()})

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def _repr_html_(self) -> str:
        heads = "".join(f"<th>{_escaped(name)}</th>" for name in self._headed())
        rows = zip(*(list(values) for values in self.columns.values()), strict=False)
        body = "".join("<tr>" + "".join(f"<td>{_escaped(_cell(own))}</td>" for own in row) + "</tr>" for row in rows)
        return f"<table><caption>{_escaped(self.title)}</caption><thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table>"

    def __repr__(self) -> str:
        return f"Table({self.name!r}, {len(self)} rows: {', '.join(self._headed())})"


def _of_one_kind(values: Any) -> Any:
    """A column for Arrow, which has one type a column: numbers among words become words."""
    if not isinstance(values, list):
        return values
    has_words = any(isinstance(own, str) for own in values)
    if has_words and not all(own is None or isinstance(own, str) for own in values):
        return [None if own is None else own if isinstance(own, str) else _text(own) for own in values]
    return values


def _text(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) and float(f"{value:g}") == value else str(value)


def _cell(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else "" if value is None else str(value)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
