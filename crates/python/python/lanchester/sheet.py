"""The workshop sheet: balancing a real crank or rotor from what was weighed and measured.

A sheet is a text like an engine file; the book has a page on its tables. What is asked about an engine file with what the workshop has is a method of
:class:`lanchester.Engine`: `workshop` (balance factors), `crank_unbalance`, `external_balance` and `assign_parts`.
"""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

from . import _native
from ._record import Result
from .errors import Diagnostic
from .results import BobweightAnswer, Correction, Drilling, Grade, InternalBalance

__all__ = ["WorkshopSheet"]

Q = TypeVar("Q", bound=Result)


def _again(text: str, folder: Path | None) -> WorkshopSheet:
    """A sheet as it was, from a text and the place of the engine file that it names."""
    return WorkshopSheet(_native.Sheet.of_text(text, "<text>", folder))


class WorkshopSheet:
    """What a workshop has weighed and measured of one crank, rotor or engine, checked. Sheets do not change.

    >>> from lanchester import WorkshopSheet
    >>> sheet = WorkshopSheet.from_dict({
    ...     "name": "crankshaft 12",
    ...     "rotor": {"mass": "12 kg", "centre": "180 mm", "supports": ["0 mm", "400 mm"], "speed": "6000 rpm", "grade": "G 6.3"},
    ... })
    >>> round(1e6 * sheet.grade().permissible, 1)
    120.3
    """

    __slots__ = ("_native",)

    def __init__(self, native: _native.Sheet) -> None:
        self._native = native

    @staticmethod
    def read(path: str | PathLike[str]) -> WorkshopSheet:
        """The sheet of a file. The engine file that it names is read from its folder.

        >>> from lanchester import WorkshopSheet
        >>> import pathlib, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = pathlib.Path(folder) / "sheet.toml"
        ...     _ = path.write_text('name = "rotor 3"')
        ...     WorkshopSheet.read(path).name
        'rotor 3'
        """
        return WorkshopSheet(_native.Sheet.read(path))

    @staticmethod
    def from_toml(text: str, *, folder: str | PathLike[str] | None = None) -> WorkshopSheet:
        """The sheet of a text; `folder` is where the engine file is that it names.

        >>> from lanchester import WorkshopSheet
        >>> WorkshopSheet.from_toml('name = "rotor 3"').name
        'rotor 3'
        """
        return WorkshopSheet(_native.Sheet.of_text(text, "<text>", folder))

    @staticmethod
    def from_dict(values: Mapping[str, Any], *, folder: str | PathLike[str] | None = None) -> WorkshopSheet:
        """The sheet of plain values: the keys of a sheet, as dictionaries, lists, numbers and texts.

        Numbers are SI where the sheet has a unit. It is checked as a file is, and mistakes are shown in the sheet that the values make.

        >>> from lanchester import WorkshopSheet
        >>> sheet = WorkshopSheet.from_dict({"name": "rotor 3", "rotor": {"mass": 12.0}})
        >>> print(sheet.text.splitlines()[-1])
        mass = "12 kg"
        """
        return WorkshopSheet(_native.Sheet.of_values(dict(values), folder))

    @property
    def name(self) -> str:
        """What is balanced.

        >>> from lanchester import WorkshopSheet
        >>> WorkshopSheet.from_dict({"name": "rotor 3"}).name
        'rotor 3'
        """
        return self._native.name

    @property
    def text(self) -> str:
        """The text of its file.

        >>> from lanchester import WorkshopSheet
        >>> WorkshopSheet.from_toml('name = "rotor 3"').text
        'name = "rotor 3"'
        """
        return self._native.text

    @property
    def warnings(self) -> list[Diagnostic]:
        """What in it is probably not meant.

        >>> from lanchester import WorkshopSheet
        >>> WorkshopSheet.from_dict({"name": "rotor 3"}).warnings
        []
        """
        return self._native.warnings()

    def bobweight(self) -> BobweightAnswer:
        """Bobweight of every crankpin from the weighed parts, the share that is right for the layout, and how far the crank is then from the optimum.

        The sheet has a table ``[parts]``; where it names an `engine`, the bobweights are compared with the best weights at the ends of its crank.

        >>> from lanchester import WorkshopSheet
        >>> sheet = WorkshopSheet.from_dict({
        ...     "name": "V8",
        ...     "bobweight": {"reciprocating_share": "50 %", "rods": 2, "pins": 4},
        ...     "parts": {"big_end": "455 g", "small_end": "180 g", "piston": "620 g"},
        ... })
        >>> [round(1e3 * pin.mass) for pin in sheet.bobweight().bobweights]
        [1710, 1710, 1710, 1710]
        """
        return self._ask("sheet_bobweight", BobweightAnswer)

    def correct(self) -> Correction:
        """Where to add or remove how much: from vibration with trial weights (``[[run]]``), or from the display of a balancing machine (``[[display]]``).

        `next` says what to do then: try a weight, settle a doubt, correct, or nothing more.

        >>> from lanchester import WorkshopSheet
        >>> sheet = WorkshopSheet.from_dict({
        ...     "name": "flywheel",
        ...     "plane": [{"name": "rim", "z": "0 mm", "radius": "120 mm"}],
        ...     "display": [{"plane": "rim", "unbalance": "240 g mm", "angle": "30 deg"}],
        ... })
        >>> correction = sheet.correct()
        >>> correction.next.kind, f"{1e3 * correction.planes[0].placements[0].mass:.1f} g"
        ('correct', '2.0 g')
        """
        return self._ask("sheet_correct", Correction)

    def drill(self) -> Drilling:
        """Which holes to drill for the correction, how deep, and what they leave.

        >>> from lanchester import WorkshopSheet
        >>> drill = {"direction": "radial", "diameters": ["8 mm"], "max_depth": "25 mm", "density": "7.85 g/cm3"}
        >>> sheet = WorkshopSheet.from_dict({
        ...     "name": "flywheel",
        ...     "plane": [{"name": "rim", "z": "0 mm", "radius": "120 mm", "drill": drill}],
        ...     "display": [{"plane": "rim", "unbalance": "240 g mm", "angle": "30 deg"}],
        ... })
        >>> len(sheet.drill().planes[0].holes)
        1
        """
        return self._ask("sheet_drill", Drilling)

    def grade(self) -> Grade:
        """Permissible residual unbalance of a balance quality grade, allotted to bearings and correction planes.

        >>> from lanchester import WorkshopSheet
        >>> rotor = {"mass": "12 kg", "centre": "180 mm", "supports": ["0 mm", "400 mm"], "speed": "6000 rpm", "grade": "G 6.3"}
        >>> found = WorkshopSheet.from_dict({"name": "crankshaft 12", "rotor": rotor}).grade()
        >>> len(found.bearings)
        2
        """
        return self._ask("sheet_grade", Grade)

    def internal(self) -> InternalBalance:
        """Tungsten slugs, axes parallel to the shaft, that take over from weights on damper and flywheel.

        The sheet has tables ``[[external]]``, ``[slug]`` and two ``[[plane]]``.

        >>> from lanchester import WorkshopSheet
        >>> try:
        ...     WorkshopSheet.from_dict({"name": "V8"}).internal()
        ... except ValueError as error:
        ...     "[[external]]" in str(error)
        True
        """
        return self._ask("sheet_internal", InternalBalance)

    def _ask(self, name: str, kind: type[Q]) -> Q:
        return kind._made(_native.ask_sheet(name, self._native), ())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, WorkshopSheet) and (self.text, self._native.folder) == (other.text, other._native.folder)

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, tuple[str, Path | None]]:
        return _again, (self.text, self._native.folder)

    def __repr__(self) -> str:
        return f"<WorkshopSheet {self.name!r}>"
