"""The engine, and every question about it.

Quantities are floats in SI units (m, kg, s, rad, rad/s, N, Pa) or texts with units such as ``"80 mm"``, ``"4000 rpm"``, ``"50 %"``, wherever the engine file
accepts them. Indices count from 0 as everywhere in Python; cylinders and throws are numbered from 1 as in the engine file.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from operator import index
from os import PathLike
from pathlib import Path
from typing import Any, Literal, TypeVar, overload

import numpy as np

from . import _native
from ._record import FloatArray, Picture, Result
from .errors import Diagnostic, RequestError
from .results import (
    Arrangements,
    Assignment,
    Balance,
    Bearings,
    BearingFilms,
    Bending,
    BondGraph,
    Comparison,
    CounterweightCheck,
    CounterweightDesigns,
    CrankCycle,
    CrankFatigue,
    CrankModes,
    CrankRule,
    CrankWithBobweights,
    CrossCheck,
    Exploration,
    ExternalBalance,
    FactorAnswer,
    Inertias,
    Loads,
    MountStudy,
    ReducedCrank,
    RobustAnswer,
    ScatterStudy,
    Sensitivity,
    SimulationResult,
    StaticStress,
    TorqueReport,
    TorsionResult,
)
from .sheet import WorkshopSheet

__all__ = ["Engine", "Quantity", "Variants", "adopt", "compare", "map"]

Quantity = float | str
"""A float in SI units, or a text with a unit."""

Q = TypeVar("Q", bound=Result)
Limits = str | Sequence[str]
Quantities = Quantity | Sequence[Quantity] | FloatArray
Stiffnesses = Quantity | Sequence[Quantity | tuple[Quantity, Quantity]] | FloatArray


def _again(text: str, folder: Path | None) -> Engine:
    """An engine as it was, from a text and the place of the files that it names."""
    return Engine(_native.Engine.of_text(text, "<text>", folder))


def _put(path: str | PathLike[str], content: bytes, overwrite: bool) -> Path:
    """Writes a file."""
    place = Path(path)
    try:
        with place.open("wb" if overwrite else "xb") as file:
            file.write(content)
    except FileExistsError:
        raise RequestError(f"{place} exists and is not overwritten", "choose another name, or add overwrite=True") from None
    except OSError as error:
        raise RequestError(f"cannot write {place}: {error.strerror or error}", "choose a folder that is there and can be written to") from error
    return place


def _sheet(sheet: WorkshopSheet | None) -> _native.Sheet | None:
    """The sheet as Rust holds it."""
    if sheet is not None and not isinstance(sheet, WorkshopSheet):
        raise RequestError(f"`sheet` needs a WorkshopSheet, got `{type(sheet).__name__}`", 'read it by WorkshopSheet.read("...")')
    return None if sheet is None else sheet._native


def _natives(engines: Sequence[Engine]) -> list[_native.Engine]:
    """The engines as Rust holds them."""
    if isinstance(engines, Engine):
        raise RequestError("a list of engines is needed, got one engine", "write [engine], or `engine.variants(...)`")
    found = []
    for place, engine in enumerate(engines):
        if not isinstance(engine, Engine):
            raise RequestError(f"engines are needed, got `{type(engine).__name__}` at index {place}", 'make one by Engine.read("...") or Engine.template("...")')
        found.append(engine._native)
    return found


class Engine:
    """An engine: what an engine file says, checked.

    Engines do not change; :meth:`with_` makes changed copies.

    >>> from lanchester import Engine
    >>> engine = Engine.template("in-line-4")
    >>> engine.cylinders
    4
    """

    __slots__ = ("_native",)

    def __init__(self, native: _native.Engine) -> None:
        self._native = native

    # Where engines come from.

    @staticmethod
    def read(path: str | PathLike[str]) -> Engine:
        """The engine of a file. Files that it names are read from its folder.

        >>> from lanchester import Engine
        >>> import pathlib, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Engine.template("single").save(pathlib.Path(folder) / "single.toml")
        ...     Engine.read(path).cylinders
        1
        """
        return Engine(_native.Engine.read(path))

    @staticmethod
    def from_toml(text: str, *, folder: str | PathLike[str] | None = None) -> Engine:
        """The engine of a text; `folder` is where files are that it names.

        >>> from lanchester import Engine
        >>> Engine.from_toml(Engine.template("single").text).cylinders
        1
        """
        return Engine(_native.Engine.of_text(text, "<text>", folder))

    @staticmethod
    def from_dict(values: Mapping[str, Any], *, folder: str | PathLike[str] | None = None) -> Engine:
        """The engine of plain values: the keys of the engine file, as dictionaries, lists, numbers and texts.

        Numbers are SI where the file has a unit. It is checked as a file is, and mistakes are shown in the file that the values make.

        >>> from lanchester import Engine
        >>> engine = Engine.from_dict({
        ...     "name": "single", "speed": "6000 rpm",
        ...     "layout": {"type": "in-line", "cylinders": 1},
        ...     "crank": {"stroke": 0.06}, "piston": {"mass": 0.3}, "rod": {"length": 0.1, "mass": 0.25},
        ... })
        >>> print(engine.text.splitlines()[4])
        stroke = "60 mm"
        """
        return Engine(_native.Engine.of_values(dict(values), folder))

    @staticmethod
    def template(name: str) -> Engine:
        """An engine of the gallery.

        >>> from lanchester import Engine
        >>> Engine.template("v6-60").cylinders
        6
        """
        return Engine(_native.Engine.template(name))

    @staticmethod
    def templates() -> dict[str, str]:
        """The gallery: names with titles.

        >>> from lanchester import Engine
        >>> "in-line-4" in Engine.templates()
        True
        """
        return dict(_native.Engine.templates())

    # What it is.

    @property
    def name(self) -> str:
        """Its name.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").with_(name="mine").name
        'mine'
        """
        return self._native.name

    @property
    def text(self) -> str:
        """The text of its file.

        >>> from lanchester import Engine
        >>> "[crank]" in Engine.template("in-line-4").text
        True
        """
        return self._native.text

    @property
    def warnings(self) -> list[Diagnostic]:
        """What in its file is probably not meant.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").warnings
        []
        """
        return self._native.warnings()

    @property
    def cylinders(self) -> int:
        """Number of its cylinders.

        >>> from lanchester import Engine
        >>> Engine.template("v8-crossplane").cylinders
        8
        """
        return self._native.summary()[2]

    @property
    def speed_range(self) -> tuple[float, float]:
        """Lowest and highest speed of crankshaft 1 [rad/s].

        >>> from lanchester import Engine
        >>> lowest, highest = Engine.template("in-line-4").speed_range
        >>> lowest <= highest
        True
        """
        lowest, highest, _, _ = self._native.summary()
        return lowest, highest

    @property
    def drawing(self) -> Picture:
        """Its drawing.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").drawing.svg[:4]
        '<svg'
        """
        return Picture("drawing", self.name, self._native.summary()[3])

    def expanded(self) -> str:
        """The general form of its file: every throw and cylinder by itself.

        >>> from lanchester import Engine
        >>> Engine.template("in-line-4").expanded().count("[[cylinder]]")
        4
        """
        return self._native.expanded()

    def save(self, path: str | PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes its file; a file that is there is left alone unless `overwrite` says otherwise.

        >>> from lanchester import Engine
        >>> import pathlib, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Engine.template("single").save(pathlib.Path(folder) / "single.toml")
        ...     path.name
        'single.toml'
        """
        return _put(path, self.text.encode(), overwrite)

    def save_solids(
        self,
        path: str | PathLike[str],
        *,
        weight: Limits = (),
        shaft: Limits = (),
        crankshaft: int = 0,
        facet: Quantity | None = None,
        overwrite: bool = False,
    ) -> Path:
        """Writes its parts for CAD; the ending of the name says how: step, stl or glb for solids, dxf or svg for the outline of one part.

        Default: the first crankshaft with its counterweights and the balance shafts around it, without ``[crank.body]`` the counterweights alone.
        `weight`: only these counterweights; `shaft`: only these balance shafts; `facet` [m]: largest distance between a true arc and the facets of
        STL and glTF, else 0.01 mm.

        >>> import lanchester
        >>> try:
        ...     lanchester.Engine.template("in-line-4").save_solids("crankshaft.obj")
        ... except lanchester.RequestError as error:
        ...     error.message != ""
        True
        """
        place = Path(path)
        options = {"weight": weight, "shaft": shaft, "crankshaft": crankshaft, "facet": facet}
        content = self._native.solids(place.suffix.lower().removeprefix("."), options)
        return _put(place, content, overwrite)

    def with_(self, changes: Mapping[str, Any] | None = None, /, **tables: Any) -> Engine:
        """A copy with other values of keys of the engine file; comments and order are preserved.

        Keywords are keys and tables of the file, `changes` has paths such as ``"counterweight[1].unbalance"`` (indices from 0 count entries of the file). A dictionary
        changes the keys that it names, ``None`` takes a key out, a list of dictionaries replaces a list of tables.

        >>> from lanchester import Engine
        >>> engine = Engine.template("in-line-4")
        >>> longer = engine.with_(rod={"length": 0.16}, speed="5000 rpm")
        >>> lighter = engine.with_({"piston.mass": "0.3 kg"})
        >>> round(longer.speed_range[1], 3)
        523.599
        """
        return Engine(self._native.with_changes({**(changes or {}), **tables}))

    def complete(self, *sections: str, kind: str | None = None) -> Engine:
        """A copy with typical values for what the engine file leaves out: commented, named as typical, scaled to the engine. What the file says is kept.

        `sections`: those alone, such as ``"gas"``, ``"flywheel"``, ``"mount"``, ``"crank.body"``; all that are missing where none is named, but those that this layout cannot
        have. `kind` of engine that the values are taken for, such as ``"car-petrol"``; what its numbers say where it is left out. Typical values are usual practice and
        no measurement: replace them by the numbers of the real engine.

        Raises `RequestError` where a section is unknown or named and not to be had for this engine, `EngineFileError` where the typical values do not fit what the file says.

        >>> from lanchester import Engine
        >>> engine = Engine.template("in-line-4").complete("gas", "friction")
        >>> "# Typical values" in engine.text
        True
        >>> engine.torque().torque.with_gas
        True
        """
        return Engine(self._native.completed(list(sections), kind)[0])

    def variants(self, columns: Mapping[str, Any]) -> Variants:
        """Copies with other numbers: for every path an array of SI numbers, one for each copy. They are made when they are looked at.

        >>> from lanchester import Engine
        >>> import numpy as np
        >>> rods = Engine.template("in-line-4").variants({"rod.length": np.linspace(0.13, 0.17, 5)})
        >>> len(rods)
        5
        """
        return Variants(self, columns)

    def cases(self, table: str | PathLike[str] | Mapping[str, Any]) -> Variants:
        """Copies by a table as engineers keep it: a CSV file, or a pandas DataFrame; a row a copy, a column a key of the engine file.

        A head may have a unit behind the key, ``rod.length [mm]``; without one a number is SI, and a text has its unit. An empty cell leaves the key as it is.

        >>> from lanchester import Engine
        >>> import pathlib, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = pathlib.Path(folder) / "cases.csv"
        ...     _ = path.write_text("rod.length [mm],piston.mass\\n140,0.3 kg\\n150,\\n")
        ...     len(Engine.template("in-line-4").cases(path))
        2
        """
        from .cases import columns

        return Variants(self, columns(table))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Engine) and self._native == other._native

    def __hash__(self) -> int:
        return hash(self._native)

    def __reduce__(self) -> tuple[Any, tuple[str, Path | None]]:
        return _again, (self.text, self._native.folder)

    def __repr__(self) -> str:
        lowest, highest, cylinders, _ = self._native.summary()
        return f"<Engine {self.name!r}: {cylinders} cylinders, {lowest:.1f} to {highest:.1f} rad/s>"

    def _repr_html_(self) -> str:
        return self.drawing.svg

    def _ask(self, name: str, kind: type[Q], options: dict[str, Any]) -> Q:
        return kind._made(_native.ask_all(name, [self._native], options), (self,))

    # What shakes it.

    def loads(
        self,
        speed: Quantity | None = None,
        *,
        about: Sequence[Quantity] | FloatArray | None = None,
        series: str = "exact",
        orders: int | None = None,
        samples: int | None = None,
        grid: int | None = None,
        bending_share: Quantity | None = None,
    ) -> Loads:
        """Shaking forces, couples, roll moment and shaft torque of inertia, over the cycle and by order; `internal`: shear and bending inside the crankshafts.

        `speed` of crankshaft 1 [rad/s], the highest where it is left out; `about`: point of the couples [m]; `series`: ``"exact"``,
        ``"orders:N"`` or ``"power:N:P"``, a truncation of the literature; `orders`: highest order listed; `samples`: angles of a trace in one
        revolution; `grid`: take extremes on a grid of so many angles instead of the continuous cycle; `bending_share`: share of the reciprocating
        forces that counts in `internal`, which is computed when it is looked at.

        >>> from lanchester import Engine
        >>> loads = Engine.template("in-line-4").loads("6000 rpm")
        >>> first, second = loads.total.orders[1], loads.total.orders[2]
        >>> bool(abs(first.force_forward).max() < 1e-9 * abs(second.force_forward).max())
        True
        """
        options = {"speed": speed, "about": about, "series": series, "orders": orders, "samples": samples, "grid": grid, "bending_share": bending_share}
        return self._ask("loads", Loads, options)

    def bending(
        self,
        speed: Quantity | None = None,
        *,
        series: str = "exact",
        reciprocating_share: Quantity | None = None,
        samples: int | None = None,
    ) -> Bending:
        """Shear forces and bending moments inside the crankshafts, and what the main bearings carry of them.

        >>> from lanchester import Engine
        >>> len(Engine.template("in-line-4").bending().cases) > 0
        True
        """
        options = {"speed": speed, "series": series, "reciprocating_share": reciprocating_share, "samples": samples}
        return self._ask("bending", Bending, options)

    def torque(
        self,
        speed: Quantity | None = None,
        *,
        speeds: Quantities = (),
        lever: Literal["exact", "sine"] = "exact",
        orders: int | None = None,
        samples: int | None = None,
        fmep: Quantity | None = None,
        flywheel: Quantity | None = None,
        crankshaft_inertia: Quantity | None = None,
        fluctuation: Quantity | None = None,
    ) -> TorqueReport:
        """Torque of gas and inertia: over the cycle, by order, work, firing, fluctuation of the speed, flywheel, power.

        `speeds` [rad/s] make a power curve; `fmep` [Pa]; `flywheel` and `crankshaft_inertia` [kg m^2]; `fluctuation` [1] that a flywheel is to keep.

        >>> from lanchester import Engine
        >>> torque = Engine.template("in-line-4").torque("3000 rpm")
        >>> len(torque.tables) > 2
        True
        """
        options = {
            "speed": speed,
            "speeds": speeds,
            "lever": lever,
            "orders": orders,
            "samples": samples,
            "fmep": fmep,
            "flywheel": flywheel,
            "crankshaft_inertia": crankshaft_inertia,
            "fluctuation": fluctuation,
        }
        return self._ask("torque", TorqueReport, options)

    def bearings(
        self,
        speed: Quantity | None = None,
        *,
        part: Literal["all", "gas", "inertia"] | None = None,
        samples: int | None = None,
    ) -> Bearings:
        """What pistons, pins and main bearings carry over the cycle, with counterweights and without.

        >>> from lanchester import Engine
        >>> bearings = Engine.template("in-line-4").bearings("4000 rpm")
        >>> len(bearings.mains) > 0
        True
        """
        return self._ask("bearings", Bearings, {"speed": speed, "part": part, "samples": samples})

    def films(
        self,
        speed: Quantity | None = None,
        *,
        part: Literal["all", "gas", "inertia"] | None = None,
        samples: int | None = None,
        cavitation: Limits = (),
        grooves: bool | None = None,
        dynamic: bool = False,
    ) -> BearingFilms:
        """Oil films of the main and crankpin bearings: orbit, smallest film, largest pressure. The file gives width, clearance and oil.

        `cavitation`: ``"reynolds"``, ``"gumbel"``, ``"full"``, ``"mass-conserving"``, or several; by default that of the file, else gumbel. `grooves`: with those of
        the file and their supply pressure, which takes seconds a bearing; by default where ``"mass-conserving"`` is asked for. `dynamic`: the crankshaft as a rigid body
        with its mass that floats in the films of its mains, which share its loads.

        >>> from lanchester import Engine
        >>> found = Engine.template("single").complete().films("3000 rpm")
        >>> found.films[0].kind, found.films[0].orbit.outcome
        ('main', 'periodic')
        """
        options = {
            "speed": speed,
            "part": part,
            "samples": samples,
            "cavitation": cavitation,
            "grooves": grooves,
            "dynamic": dynamic,
        }
        return self._ask("films", BearingFilms, options)

    def torsion(
        self,
        speeds: Quantities = (),
        *,
        highest_order: float | None = None,
        gas: bool = True,
        tune: Literal["damper", "damping", "stiffness", "both"] | None = None,
        aim: Literal["twist", "stress"] | None = None,
        check: Quantity | None = None,
        throws: Literal["ker-wilson", "free", "held"] | None = None,
        size: Quantity | None = None,
    ) -> TorsionResult:
        """Torsional vibration of the crankshaft with what it drives: chain, modes, critical speeds, forced twist and stress over speed. The file has a
        flywheel, and a section ``[crank.body]`` or stiffnesses in ``[torsion]``.

        `speeds`: of crankshaft 1 [rad/s], rising; 201 over the range of the engine without them. `highest_order`: 12 where nobody says. `gas`: whether that
        of the file acts. `tune`: what of the damper is found, so that twist, or with ``aim="stress"`` stress, stays least over the speeds. `check`: speed
        of a check in the time domain. `throws`: ``"free"`` or ``"held"`` takes the stiffness of throws from a mesh whose journals are free to move aside or
        held in their middles, of elements of `size` (10 mm); else Ker Wilson's lengths count.

        >>> from lanchester import Engine
        >>> found = Engine.template("in-line-4").complete().torsion()
        >>> 2e3 < found.modes[0].frequency < 5e3
        True
        """
        options = {
            "speeds": speeds,
            "highest_order": highest_order,
            "gas": gas,
            "tune": tune,
            "aim": aim,
            "check": check,
            "throws": throws,
            "size": size,
        }
        return self._ask("torsion", TorsionResult, options)

    def mounts(
        self,
        speeds: Quantities = (),
        *,
        steps: int | None = None,
        orders: int | None = None,
        gas: bool = True,
        points: Sequence[Sequence[Quantity]] = (),
        rotors: Literal["both", "couple", "roll", "none"] = "both",
    ) -> MountStudy:
        """The block on its mounts: at rest, its rigid-body modes, forces by order over the speeds, motion of `points` [m].

        `speeds` [rad/s]; without them `steps` speeds over the range of the engine. `rotors`: what acts of all that turns
        in the block, its gyroscopic couple, that its inertia does not follow the roll, both or neither.

        >>> from lanchester import Engine
        >>> found = Engine.template("in-line-4").complete().mounts("3000 rpm")
        >>> len(found.modes.modes)
        6
        """
        options = {
            "speeds": speeds,
            "steps": steps,
            "orders": orders,
            "gas": gas,
            "points": points,
            "rotors": rotors,
        }
        return self._ask("mounts", MountStudy, options)

    def inertias(self) -> Inertias:
        """Inertia of everything that turns, each with its origin.

        >>> from lanchester import Engine
        >>> len(Engine.template("in-line-4").inertias().bodies) > 0
        True
        """
        return self._ask("inertias", Inertias, {})

    # What is done about it.

    def balance(
        self,
        *,
        minimise: Limits = (),
        limit: Limits = (),
        counterweights: Literal["none", "file", "throws", "webs"] | None = None,
        shaft: Limits = (),
        give_up: Limits = (),
        cancel: Limits = (),
        budget: str | None = None,
        min_unbalance: str | None = None,
        max_unbalance: str | None = None,
        weight_step: str | None = None,
        equal_parts: bool = False,
        optional: bool = False,
        max_optional: int | None = None,
        speed: Limits = (),
        at_least: Limits = (),
        maximise: Limits = (),
        gap: Quantity | None = None,
        max_nodes: int | None = None,
        time_limit: Quantity | None = None,
    ) -> Balance:
        """The best counterweights and balance shafts that the devices allow, with the proof that nothing is better.

        Without arguments it is what the section ``[balance]`` of the file asks. `minimise`: objectives in order of priority, such as ``"force"`` or
        ``"couple"``; `limit`: ``"force = 100 N"``; `shaft`: ``"-1 @ 0 mm, 100 mm @ -30 mm, 30 mm"`` (ratio @ x, y of the axis @ planes); `cancel`:
        ``"couple order 1"``; `at_least`: ``"main-bearing film = 2 um"`` and `maximise`: ``"least film"`` move weights by a local search after the proof. ``result.adopt()`` is the engine with what was found. That limits cannot be met is an outcome, not an exception.

        >>> from lanchester import Engine
        >>> twin = Engine.template("twin-360")
        >>> found = twin.balance(minimise="force", counterweights="throws")
        >>> found.outcome.kind
        'optimal'
        >>> before, after = twin.loads(), found.adopt().loads()
        >>> after.total.peaks.force.max.value < before.total.peaks.force.max.value
        True
        """
        options = {
            "minimise": minimise,
            "limit": limit,
            "counterweights": counterweights,
            "shaft": shaft,
            "give_up": give_up,
            "cancel": cancel,
            "budget": budget,
            "min_unbalance": min_unbalance,
            "max_unbalance": max_unbalance,
            "weight_step": weight_step,
            "equal_parts": equal_parts,
            "optional": optional,
            "max_optional": max_optional,
            "speed": speed,
            "at_least": at_least,
            "maximise": maximise,
            "gap": gap,
            "max_nodes": max_nodes,
            "time_limit": time_limit,
        }
        return self._ask("balance", Balance, options)

    def robust_balance(
        self,
        *,
        engines: int | None = None,
        worst_share: Quantity | None = None,
        seed: int | None = None,
        minimise: Limits = (),
        limit: Limits = (),
        counterweights: Literal["none", "file", "throws", "webs"] | None = None,
        shaft: Limits = (),
    ) -> RobustAnswer:
        """The best weights for engines drawn within the tolerances of the file: their worst, or the mean of a share of the worst ones.

        >>> from lanchester import Engine
        >>> engine = Engine.template("twin-360").with_(tolerances={"piston_mass": {"plus_minus": "4 g"}})
        >>> found = engine.robust_balance(engines=20, minimise="force", counterweights="throws")
        >>> found.to_text() != ""
        True
        """
        options = {
            "engines": engines,
            "worst_share": worst_share,
            "seed": seed,
            "minimise": minimise,
            "limit": limit,
            "counterweights": counterweights,
            "shaft": shaft,
        }
        return self._ask("robust_balance", RobustAnswer, options)

    def arrangements(
        self,
        *,
        minimise: Literal["force", "couple", "mount force"] | None = None,
        limit: Limits = (),
        max_shafts: int | None = None,
        drive: Literal["gears", "chain"] | None = None,
        mount_spacing: Quantity | None = None,
    ) -> Arrangements:
        """Which arrangement: crank weights and up to four shafts of either order, each with its best weights, a drive and a place.

        >>> from lanchester import Engine
        >>> found = Engine.template("twin-360").arrangements(minimise="force", max_shafts=1)
        >>> len(found.spacings[0].arrangements) > 1
        True
        """
        options = {
            "minimise": minimise,
            "limit": limit,
            "max_shafts": max_shafts,
            "drive": drive,
            "mount_spacing": mount_spacing,
        }
        return self._ask("arrangements", Arrangements, options)

    def counterweight(self, weight: Limits = (), *, unbalance: Quantity | None = None) -> CounterweightDesigns:
        """The best shape for every counterweight on a web, with proof. The file has a section ``[counterweight_design]``.

        `weight`: names of counterweights; `unbalance` [kg m] where it is not that of the weight. ``result.adopt()`` is the engine with the shapes.

        >>> from lanchester import Engine
        >>> found = Engine.template("single").complete().counterweight()
        >>> [weight.name for weight in found.weights]
        ['web 1', 'web 2']
        """
        return self._ask("counterweight_design", CounterweightDesigns, {"weight": weight, "unbalance": unbalance})

    def counterweight_check(self) -> CounterweightCheck:
        """Crankshaft and counterweights as parts, and their clearances over the cycle.

        >>> from lanchester import Engine
        >>> Engine.template("single").complete().counterweight_check().is_kept
        True
        """
        return self._ask("counterweight_check", CounterweightCheck, {})

    # The workshop: what a sheet of weighed and measured parts answers is in `WorkshopSheet`.

    def workshop(
        self,
        *,
        reciprocating_share: Quantity | None = None,
        wet_share: Quantity | None = None,
        total_share: Quantity | None = None,
        bobweight: Quantity | None = None,
        bobweight_share: Quantity | None = None,
        counterweight: Quantity | None = None,
        axis_ratio: float | None = None,
        least_peak: bool = False,
        oil: Quantity | None = None,
        angle: Quantity | None = None,
    ) -> FactorAnswer:
        """Balance factor of every throw by every definition, and the first-order force that it leaves.

        Without a factor it is that of the counterweights of the file; else one of them: `reciprocating_share`, the share of the reciprocating mass beyond the rotating mass;
        `wet_share`, the same with the oil counted as rotating; `total_share` of rotating and reciprocating mass together; `bobweight` at each crankpin [kg], or as
        `bobweight_share` of all masses at the pin; `counterweight`, its part opposite each throw [kg m]; `axis_ratio`, first-order force along the cylinders over that across
        them; `least_peak`, the factor with the smallest peak. `oil`: mass of the oil in a hollow pin [kg]; `angle`: direction of the counterweight from the throw [rad].

        >>> from lanchester import Engine
        >>> found = Engine.template("single").workshop(reciprocating_share="60 %", oil="12 g")
        >>> f"{1e3 * found.throws[0].bobweight:.0f} g"
        '634 g'
        """
        options = {
            "reciprocating_share": reciprocating_share,
            "wet_share": wet_share,
            "total_share": total_share,
            "bobweight": bobweight,
            "bobweight_share": bobweight_share,
            "counterweight": counterweight,
            "axis_ratio": axis_ratio,
            "least_peak": least_peak,
            "oil": oil,
            "angle": angle,
        }
        return self._ask("balance_factor", FactorAnswer, options)

    def crank_unbalance(
        self,
        *,
        planes: Mapping[str, Quantity] | None = None,
        sheet: WorkshopSheet | None = None,
        reciprocating_share: Quantity | None = None,
        wet_share: Quantity | None = None,
        total_share: Quantity | None = None,
        bobweight: Quantity | None = None,
        bobweight_share: Quantity | None = None,
        counterweight: Quantity | None = None,
        axis_ratio: float | None = None,
        least_peak: bool = False,
        oil: Quantity | None = None,
        crankshaft: int = 0,
    ) -> CrankWithBobweights:
        """Static, couple and dynamic unbalance of a crank that carries its bobweights; with a sheet that knows the crank as a body the tilt of its principal axis.

        `planes`: two, by name with their z [m]; default: those of the sheet, or the outermost webs. The bobweights are those of the `sheet`, else what one of the factors
        of `workshop` says, else 50 % of the reciprocating mass. This engine counts, whatever the sheet names.

        >>> from lanchester import Engine
        >>> found = Engine.template("v8-crossplane").crank_unbalance(planes={"front": "-180 mm", "rear": "200 mm"})
        >>> [plane.name for plane in found.planes]
        ['front', 'rear']
        """
        options = {
            "planes": None if planes is None else dict(planes),
            "sheet": _sheet(sheet),
            "reciprocating_share": reciprocating_share,
            "wet_share": wet_share,
            "total_share": total_share,
            "bobweight": bobweight,
            "bobweight_share": bobweight_share,
            "counterweight": counterweight,
            "axis_ratio": axis_ratio,
            "least_peak": least_peak,
            "oil": oil,
            "crankshaft": crankshaft,
        }
        return self._ask("crank_unbalance", CrankWithBobweights, options)

    def external_balance(
        self,
        planes: Mapping[str, Quantity | tuple[Quantity, Quantity]],
        *,
        keep: Quantity = 1.0,
        sheet: WorkshopSheet | None = None,
        reciprocating_share: Quantity | None = None,
        wet_share: Quantity | None = None,
        total_share: Quantity | None = None,
        bobweight: Quantity | None = None,
        bobweight_share: Quantity | None = None,
        counterweight: Quantity | None = None,
        axis_ratio: float | None = None,
        least_peak: bool = False,
        oil: Quantity | None = None,
        crankshaft: int = 0,
    ) -> ExternalBalance:
        """Weights that damper and flywheel must carry where the counterweights inside are too light.

        `planes`: two outside, by name with their z [m], or with z and the radius of the weight [m], for its mass; `keep`: share of every counterweight of the file that
        stays. Bobweights as in `crank_unbalance`.

        >>> from lanchester import Engine
        >>> found = Engine.template("v8-crossplane").external_balance({"damper": ("-290 mm", "70 mm"), "flywheel": ("330 mm", "110 mm")}, keep="70 %")
        >>> all(own.mass > 0 for own in found.masses)
        True
        """
        options = {
            "planes": dict(planes),
            "keep": keep,
            "sheet": _sheet(sheet),
            "reciprocating_share": reciprocating_share,
            "wet_share": wet_share,
            "total_share": total_share,
            "bobweight": bobweight,
            "bobweight_share": bobweight_share,
            "counterweight": counterweight,
            "axis_ratio": axis_ratio,
            "least_peak": least_peak,
            "oil": oil,
            "crankshaft": crankshaft,
        }
        return self._ask("external_balance", ExternalBalance, options)

    def assign_parts(
        self,
        *,
        pistons: Quantities = (),
        big_ends: Quantities = (),
        small_ends: Quantities = (),
        lever: Quantity | None = None,
        speed: Quantity | None = None,
    ) -> Assignment:
        """Which of the weighed pistons and rods belongs into which cylinder, so that the first order is least.

        `pistons` with pin, rings and clips, `big_ends` and `small_ends` of the rods: masses [kg], one for each cylinder, in the order in which they are numbered; those of the
        file where none are weighed. A couple counts as its forces over `lever` [m]; default: the distance of the outer mounts, else of the outer cylinders. Up to eight
        cylinders all assignments are gone through; beyond, `bound` says what could be left to gain.

        >>> from lanchester import Engine
        >>> found = Engine.template("in-line-4").assign_parts(pistons=["401.2 g", "399.8 g", "400.5 g", "400.9 g"])
        >>> found.proved, sorted(found.pistons), found.residual < found.as_numbered
        (True, [1, 2, 3, 4], True)
        """
        options = {"pistons": pistons, "big_ends": big_ends, "small_ends": small_ends, "lever": lever, "speed": speed}
        return self._ask("assign_parts", Assignment, options)

    # Many engines.

    def explore(
        self,
        *,
        minimise: Limits = (),
        limit: Limits = (),
        even_firing: Quantity | bool | None = None,
        cylinders: int | None = None,
        in_line: bool = False,
        bank_angle: Quantities = (),
        split_angle: Quantities = (),
        stagger: Quantities = (),
        spacing: Quantities = (),
        rod_ratio: float | str | Sequence[float] | FloatArray = (),
        throw_angles: Quantities = (),
        counterweights: Limits = (),
        without_firing: bool = False,
        bearing_room: Quantity | None = None,
        pin_overlap: Quantity | None = None,
        web_distance: Quantity | None = None,
        web_thickness: Quantity | None = None,
        pin_diameter: Quantity | None = None,
        ends: Quantity | None = None,
        speed: Quantity | None = None,
        max_cases: int | None = None,
        max_on_front: int | None = None,
    ) -> Exploration:
        """All layouts that the parts of this engine can make: the Pareto-optimal ones, and what became of all others.

        An engine that is not one bank, or two alike, on one crankshaft (VR, W, radial, geared crankshafts) keeps its cylinders, rods and pins where they
        are, unless `in_line` or `bank_angle` is given.

        Angles [rad] and lengths [m] are lists of what is looked at; `throw_angles` may be ``"every 30 deg"``; `even_firing`: ``True`` for layouts
        that fire evenly alone, or the tolerance of their intervals [rad]. ``result.adopt(n)`` is layout `n` of the front, from 0, as an engine.

        >>> from lanchester import Engine
        >>> found = Engine.template("in-line-4").explore(minimise=["force order 2", "couple order 1"], throw_angles="every 90 deg", even_firing=True)
        >>> len(found.front) > 0
        True
        """
        options = {
            "minimise": minimise,
            "limit": limit,
            "even_firing": 0.0 if even_firing is True else None if even_firing is False else even_firing,
            "cylinders": cylinders,
            "in_line": in_line,
            "bank_angle": bank_angle,
            "split_angle": split_angle,
            "stagger": stagger,
            "spacing": spacing,
            "rod_ratio": rod_ratio,
            "throw_angles": throw_angles,
            "counterweights": counterweights,
            "without_firing": without_firing,
            "bearing_room": bearing_room,
            "pin_overlap": pin_overlap,
            "web_distance": web_distance,
            "web_thickness": web_thickness,
            "pin_diameter": pin_diameter,
            "ends": ends,
            "speed": speed,
            "max_cases": max_cases,
            "max_on_front": max_on_front,
        }
        return self._ask("explore", Exploration, options)

    def scatter(
        self,
        *,
        samples: int | None = None,
        seed: int | None = None,
        speed: Quantity | None = None,
        orders_only: bool = False,
        limit: Limits = (),
        capability: float | None = None,
    ) -> ScatterStudy:
        """What the tolerances of the file make of forces and couples: scatter, guaranteed upper bound, capability, which to tighten.

        >>> from lanchester import Engine
        >>> engine = Engine.template("in-line-4").with_(tolerances={"piston_mass": {"plus_minus": "2 g"}})
        >>> found = engine.scatter(samples=2000)
        >>> found.scatter.outputs[0].most <= found.worst_cases[0].bound
        True
        """
        options = {
            "samples": samples,
            "seed": seed,
            "speed": speed,
            "orders_only": orders_only,
            "limit": limit,
            "capability": capability,
        }
        return self._ask("scatter", ScatterStudy, options)

    def sensitivity(
        self,
        *,
        output: Limits = (),
        vary: Limits = (),
        only: bool = False,
        each: bool = False,
        speed: Quantity | None = None,
        weights: Literal["fixed", "follow"] = "fixed",
        sobol: int | None = None,
        seed: int | None = None,
    ) -> Sensitivity:
        """What matters most: exact derivatives, one input at a time over its range, shares of the variance.

        `vary`: ``"rod length = 10 %"``; `only`: nothing else varies; `each`: every part by itself; `sobol`: draws for the shares of the variance.

        >>> from lanchester import Engine
        >>> found = Engine.template("in-line-4").sensitivity(vary="rod length = 10 %", only=True)
        >>> len(found.inputs)
        1
        """
        options = {
            "output": output,
            "vary": vary,
            "only": only,
            "each": each,
            "speed": speed,
            "weights": weights,
            "sobol": sobol,
            "seed": seed,
        }
        return self._ask("sensitivity", Sensitivity, options)

    # Second opinions.

    def simulate(
        self,
        *,
        speed: Quantity | None = None,
        revolutions: float | None = None,
        duration: Quantity | None = None,
        periodic: bool = False,
        imposed: bool | None = None,
        on_mounts: bool | None = None,
        gravity: bool | None = None,
        gas: bool | None = None,
        load: Quantity | None = None,
        load_on_block: bool = False,
        misfire: int | Sequence[int] = (),
        step: Quantity | None = None,
        tolerance: float | None = None,
        start_angle: Quantity | None = None,
        start: str | None = None,
        events: str | Sequence[str] = (),
        points: Sequence[Sequence[Quantity]] = (),
        long: bool = False,
    ) -> SimulationResult:
        """The rigid crank train in time, on its mounts, at free or imposed speed. What is left out is as the file says.

        `speed` at the start [rad/s]; `duration` [s]; `load` [N m] or ``"none"``; `misfire`: numbers of cylinders from 1; `step` between samples [rad]; `start_angle` of the crank
        [rad]; `start`: crank angle, speed and place of the block (``"equilibrium"``, ``"as drawn"``) at the start in words, any of them; `events` on the way besides those of the file, each a moment
        and what happens; `points` of the block [m] whose motion and orbit is asked for.

        >>> from lanchester import Engine
        >>> run = Engine.template("single").simulate(revolutions=1, imposed=True, gravity=False)
        >>> run.run.outcome.kind
        'complete'
        >>> run = Engine.template("single").simulate(start="90 deg, 1200 rpm", events="540 deg: stop", imposed=True, gas=False)
        >>> run.run.outcome.kind, f"{run.run.samples.theta[0]:.6f} rad"
        ('stopped', '1.570796 rad')
        """
        options = {
            "speed": speed,
            "revolutions": revolutions,
            "duration": duration,
            "periodic": periodic,
            "imposed": imposed,
            "on_mounts": on_mounts,
            "gravity": gravity,
            "gas": gas,
            "load": load,
            "load_on_block": load_on_block,
            "misfire": misfire,
            "step": step,
            "tolerance": tolerance,
            "start_angle": start_angle,
            "start": start,
            "events": events,
            "points": points,
            "long": long,
        }
        return self._ask("simulate", SimulationResult, options)

    def crosscheck(
        self,
        *,
        speed: Quantity | None = None,
        condition: Limits = (),
        orders: int | None = None,
        bar: float | None = None,
    ) -> CrossCheck:
        """The closed form against a simulation of the same engine as rigid bodies and its bond graph.

        `condition`: ``"a"`` like for like, ``"b"`` free speed, ``"c"`` moving block, ``"d"`` all free, ``"e"`` crankshaft by finite elements; all but the last where it is left out.

        >>> from lanchester import Engine
        >>> check = Engine.template("single").crosscheck(condition="a")
        >>> len(check.conditions)
        1
        """
        options = {"speed": speed, "condition": condition, "orders": orders, "bar": bar}
        return self._ask("crosscheck", CrossCheck, options)

    def bondgraph(
        self,
        *,
        speed: Quantity | None = None,
        gas: bool = True,
        gravity: bool = True,
        imposed: bool | None = None,
        revolutions: float | None = None,
        duration: Quantity | None = None,
        periodic: bool = False,
        samples: int | None = None,
        tolerance: float | None = None,
        audit: bool = False,
        method: Literal["explicit", "implicit"] | None = None,
        block: Literal["fixed", "plane", "space", "held"] | None = None,
        joints: Literal["ideal", "compliant"] | None = None,
        joint_stiffness: Quantity | None = None,
        skirt_stiffness: Quantity | None = None,
        skirt_offset: Quantity | None = None,
        joint_damping: float | None = None,
        load: Quantity | None = None,
        load_on_block: bool = False,
        gas_states: bool = False,
    ) -> BondGraph:
        """The bond graph of the engine: graph file, causality, equations, Modelica, drawing, and where it is asked for a run.

        `block`: fixed, moving in the plane across the crank or in space, or held still by sources; `joints` ideal, or compliant pins (`joint_stiffness` [N/m]) and skirts
        (`skirt_stiffness` [N/m], `skirt_offset` [m] from the pin to their middle) with a damping ratio; `load`: a constant torque [N m] or ``"none"``; `gas_states`: the gas as
        states of the graph, with valves and heat release.

        `revolutions` at the start speed, `duration` [s] or `periodic` ask for a run, whose series `run` has and `plot()` draws; `samples` over it; `tolerance` of its steps;
        `audit`: the energy through every bond beside it.

        >>> from lanchester import Engine
        >>> found = Engine.template("single").bondgraph(revolutions=1, audit=True)
        >>> "[" in found.graph, found.run.complete, found.run.audit.whole < 1e-6
        (True, True, True)
        """
        options = {
            "speed": speed,
            "gas": gas,
            "gravity": gravity,
            "imposed": imposed,
            "revolutions": revolutions,
            "duration": duration,
            "periodic": periodic,
            "samples": samples,
            "tolerance": tolerance,
            "audit": audit,
            "method": method,
            "block": block,
            "joints": joints,
            "joint_stiffness": joint_stiffness,
            "skirt_stiffness": skirt_stiffness,
            "skirt_offset": skirt_offset,
            "joint_damping": joint_damping,
            "load": load,
            "load_on_block": load_on_block,
            "gas_states": gas_states,
        }
        return self._ask("bondgraph", BondGraph, options)

    # The crankshaft as a body.

    def stress(
        self,
        *,
        speed: Quantities = (),
        angle: Quantities = (),
        gas: bool = True,
        loads: Literal["closed-form", "simulation"] | None = None,
        force: Sequence[tuple[int, Quantity] | tuple[int, Quantity, Quantity]] = (),
        case: str | None = None,
        pin_pressure: Literal["cosine", "uniform", "film"] | None = None,
        support: Literal["clamped-ends", "journals", "springs", "rings", "film", "free"] | None = None,
        stiffness: Stiffnesses = (),
        ring_thickness: Quantity | None = None,
        ring_modulus: Quantity | None = None,
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        converge: bool = False,
        submodel: int | None = None,
        submodel_elements: int | None = None,
        memory: int | None = None,
        double: bool = False,
    ) -> StaticStress:
        """Static stress of the crankshaft by finite elements: every fillet, pin and journal. The file has a section ``[crank.body]``.

        `loads`: the closed form at constant speed, or the run that `simulate` makes of the file. `force`: forces of your own, each the index of a throw, its radial [N]
        (positive away from the axis) and its tangential force [N]. `case`: one of the file's static cases. `pin_pressure`: over the 180 degrees of
        a pin that its force presses, with the cosine or even; or as the oil films of its big ends press at that crank angle. ``support="film"``: each load rests in the oil
        films of the main bearings. `stiffness` [N/m] of ``support="springs"``: one for all journals, or
        one for each, a pair of x and y where they differ. `ring_thickness` [m], `ring_modulus` [Pa] of ``support="rings"``. `converge`: three meshes, every number with its band.

        `angle` [rad], one or several, else the angles of the largest forces; `size` of the elements [m]; `submodel`: index of a throw whose bay, between the main
        journals beside it, is solved again with more elements across its fillets (`submodel_elements`, else 6 as a rule); `memory` [byte].

        >>> from lanchester import Engine
        >>> engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": "5 mm"})
        >>> found = engine.stress(angle=0.0, size="20 mm", fillet_elements=2)
        >>> max(peak.stress.von_mises for peak in found.cases[0].result.peaks) > 0
        True
        """
        options = {
            "speed": speed,
            "angle": angle,
            "gas": gas,
            "loads": loads,
            "force": force,
            "case": case,
            "pin_pressure": pin_pressure,
            "support": support,
            "stiffness": stiffness,
            "ring_thickness": ring_thickness,
            "ring_modulus": ring_modulus,
            "crankshaft": crankshaft,
            "size": size,
            "fillet_elements": fillet_elements,
            "converge": converge,
            "submodel": submodel,
            "submodel_elements": submodel_elements,
            "memory": memory,
            "double": double,
        }
        return self._ask("stress_static", StaticStress, options)

    def modes(
        self,
        count: int | None = None,
        *,
        support: Literal["clamped-ends", "journals", "springs", "free"] | None = None,
        stiffness: Stiffnesses = (),
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        converge: bool = False,
        check_count: bool = False,
        memory: int | None = None,
    ) -> CrankModes:
        """Natural frequencies of the crankshaft at rest. The file has a section ``[crank.body]``.

        `stiffness` as in `stress`; `converge`: three meshes, every frequency with its band; `check_count`: a second factor counts the modes, `modes.count` says whether any is
        missing.

        >>> from lanchester import Engine
        >>> engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": None})
        >>> found = engine.modes(2, size="20 mm", fillet_elements=2)
        >>> found.modes.modes[0].frequency > 100
        True
        """
        options = {
            "count": count,
            "support": support,
            "stiffness": stiffness,
            "crankshaft": crankshaft,
            "size": size,
            "fillet_elements": fillet_elements,
            "converge": converge,
            "check_count": check_count,
            "memory": memory,
        }
        return self._ask("stress_modes", CrankModes, options)

    def fatigue(
        self,
        *,
        speed: Quantities = (),
        gas: bool = True,
        surface_factor: float | None = None,
        size_factor: float | None = None,
        gradient_factor: float | None = None,
        instants: int | None = None,
        support: Literal["clamped-ends", "journals", "springs", "free"] | None = None,
        stiffness: Stiffnesses = (),
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        memory: int | None = None,
        double: bool = False,
    ) -> CrankFatigue:
        """Safety of every fillet over the cycle by finite elements and Findley's criterion.

        >>> import lanchester
        >>> try:
        ...     lanchester.Engine.template("single").fatigue()
        ... except lanchester.RequestError as error:
        ...     error.code
        'StressError.NoFatigueLimit'
        """
        options = {
            "speed": speed,
            "gas": gas,
            "surface_factor": surface_factor,
            "size_factor": size_factor,
            "gradient_factor": gradient_factor,
            "instants": instants,
            "support": support,
            "stiffness": stiffness,
            "crankshaft": crankshaft,
            "size": size,
            "fillet_elements": fillet_elements,
            "memory": memory,
            "double": double,
        }
        return self._ask("stress_fatigue", CrankFatigue, options)

    def stress_cycle(
        self,
        *,
        bearings: Limits = (),
        rigid_crankshaft: bool = False,
        tilt: bool = False,
        speed: Quantity | None = None,
        free: bool = False,
        gas: bool = True,
        modes: int | None = None,
        reduction: Literal["free-interface", "craig-bampton"] | None = None,
        damping: Quantity | None = None,
        instants: int | None = None,
        cycles: int | None = None,
        surface_factor: float | None = None,
        size_factor: float | None = None,
        gradient_factor: float | None = None,
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        memory: int | None = None,
    ) -> CrankCycle:
        """The flexible crankshaft turning in its bearings over the cycle, laws of the bearings side by side: stress and safety of every fillet, orbits, least film, loads of
        the mains. The file has a section ``[crank.body]``.

        `bearings`: ``"rigid"`` (no clearance and no yield), ``"contact"`` (clearance, then a spring with a damper), ``"bushing"`` (springs with dampers), ``"film"`` (an oil
        film), ``"file"`` (each as the file says), or several; the first four by default. `rigid_crankshaft`: every law with a rigid crankshaft too; `tilt`: films feel how the
        journals tilt in them (Guembel's, some ten times the time); `speed`: mean of crankshaft 1 [rad/s]; `free`: the flywheel turns as gas, inertia and a constant load make it; `modes` that are kept, of the free crankshaft or, with
        ``reduction="craig-bampton"``, of one whose bearings are held; `damping` of every mode over the critical
        one [1], else that of the material; `instants` of a revolution, a multiple of 8; most `cycles` of a law; `surface_factor` and so on as in `fatigue`.

        Ctrl-C ends it. That a law does not repeat, or breaks off, is an outcome: `runs[...].outcome`.

        >>> from lanchester import Engine
        >>> engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": None})
        >>> found = engine.stress_cycle(bearings="rigid", speed="3000 rpm", size="30 mm", fillet_elements=2, modes=6, instants=72)
        >>> found.runs[0].law, found.runs[0].outcome.kind
        ('rigid', 'periodic')
        >>> max(fillet.peak for fillet in found.runs[0].fillets) > 1e7
        True
        """
        options = {
            "bearings": bearings,
            "rigid_crankshaft": rigid_crankshaft,
            "tilt": tilt,
            "speed": speed,
            "free": free,
            "gas": gas,
            "modes": modes,
            "reduction": reduction,
            "damping": damping,
            "instants": instants,
            "cycles": cycles,
            "surface_factor": surface_factor,
            "size_factor": size_factor,
            "gradient_factor": gradient_factor,
            "crankshaft": crankshaft,
            "size": size,
            "fillet_elements": fillet_elements,
            "memory": memory,
        }
        return self._ask("stress_cycle", CrankCycle, options)

    def reduced_model(
        self,
        modes: int | None = None,
        *,
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        memory: int | None = None,
    ) -> ReducedCrank:
        """The crankshaft reduced to its bearing surfaces and a few modes (Craig and Bampton), as square NumPy matrices for a multibody program.

        `modes` with all bearing surfaces fixed that are kept, 20 where it is left out. `model` has `stiffness`, `mass`, `gyroscopic`, `centrifugal` and the loads of rotation; the
        order of the coordinates is in its description. ``numpy.savez("crank.npz", **found.model.matrices())`` writes what the command line's ``.npz`` holds.

        >>> from lanchester import Engine
        >>> engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": None, "crank.body.journal_fillet": None})
        >>> found = engine.reduced_model(4, size="20 mm", fillet_elements=2)
        >>> found.model.mass.shape == found.model.stiffness.shape == (6 * len(found.model.points) + 4,) * 2
        True
        """
        options = {"modes": modes, "crankshaft": crankshaft, "size": size, "fillet_elements": fillet_elements, "memory": memory}
        return self._ask("stress_reduce", ReducedCrank, options)

    def strength(
        self,
        *,
        speed: Quantities = (),
        gas: bool = True,
        torsional_vibration: Quantities = (),
        torsion: bool | None = None,
        finite_elements: bool = False,
        crankshaft: int = 0,
        size: Quantity | None = None,
        fillet_elements: int | None = None,
        memory: int | None = None,
    ) -> CrankRule:
        """Strength by the formulas of IACS UR M53, throw by throw.

        `torsional_vibration`: amplitude of the torque [N m], one for all throws or one for each; 0 leaves it out. Without it that of the engine's own
        chain counts, where the file has one: `torsion=True` asks for it, False leaves it out. `finite_elements`: stress concentration factors by
        finite elements beside those of the formulas, each throw meshed with elements of `size` [m] and `fillet_elements` across a fillet, an even
        number from 6 on.

        >>> from lanchester import Engine
        >>> rule = Engine.template("single").complete().strength()
        >>> rule.acceptable
        1.15
        """
        options = {
            "speed": speed,
            "gas": gas,
            "torsional_vibration": torsional_vibration,
            "torsion": torsion,
            "finite_elements": finite_elements,
            "crankshaft": crankshaft,
            "size": size,
            "fillet_elements": fillet_elements,
            "memory": memory,
        }
        return self._ask("stress_rule", CrankRule, options)


def _column(path: str, values: Any) -> Any:
    """The values of a key, one for each engine: an array of floats, or a list of whatever an engine file holds."""
    if isinstance(values, (str, bytes, Mapping)) or not hasattr(values, "__iter__"):
        raise RequestError(f"`{path}` needs one value for each engine, got {values!r}", "give a list or an array of one dimension; a value that all have goes into `with_`")
    if hasattr(values, "to_numpy"):
        values = values.to_numpy()
    if not isinstance(values, np.ndarray):
        return list(values)
    if values.ndim != 1:
        raise RequestError(f"`{path}` needs numbers in one row, got an array of {values.ndim} dimensions", "give a list or an array of one dimension")
    # Counts, texts and gaps are no floats.
    return values if values.dtype.kind == "f" and not isinstance(values, np.ma.MaskedArray) else values.tolist()


class Variants(Sequence[Engine]):
    """Copies of an engine with other values, made when they are looked at.

    >>> from lanchester import Engine
    >>> rods = Engine.template("single").variants({"rod.length": [0.1, 0.12]})
    >>> rods[1].text != rods[0].text
    True
    """

    __slots__ = ("columns", "engine")

    engine: Engine
    """The engine."""
    columns: dict[str, Any]
    """By path one value for each copy: SI numbers or texts with units."""

    def __init__(self, engine: Engine, columns: Mapping[str, Any]) -> None:
        if not columns:
            raise RequestError("variants need a key that varies", 'write variants({"rod.length": [0.14, 0.15]})')
        self.engine = engine
        self.columns = {path: _column(path, values) for path, values in columns.items()}
        lengths = {path: len(values) for path, values in self.columns.items()}
        if len(set(lengths.values())) > 1:
            named = ", ".join(f"`{path}` has {count}" for path, count in lengths.items())
            raise RequestError(f"every key needs one value for each engine: {named}", "give arrays of one length")

    def __len__(self) -> int:
        return len(next(iter(self.columns.values())))

    @overload
    def __getitem__(self, place: int) -> Engine: ...
    @overload
    def __getitem__(self, place: slice) -> Variants: ...
    def __getitem__(self, place: int | slice) -> Engine | Variants:
        if isinstance(place, slice):
            return Variants(self.engine, {path: values[place] for path, values in self.columns.items()})
        row = {path: values[place] for path, values in self.columns.items()}
        return self.engine.with_({path: value for path, value in row.items() if value is not None})

    def __iter__(self) -> Iterator[Engine]:
        return (self[place] for place in range(len(self)))


_KINDS: dict[str, tuple[str, type[Result]]] = {
    "loads": ("loads", Loads),
    "bending": ("bending", Bending),
    "torque": ("torque", TorqueReport),
    "bearings": ("bearings", Bearings),
    "films": ("films", BearingFilms),
    "torsion": ("torsion", TorsionResult),
    "mounts": ("mounts", MountStudy),
    "inertias": ("inertias", Inertias),
    "balance": ("balance", Balance),
    "robust_balance": ("robust_balance", RobustAnswer),
    "arrangements": ("arrangements", Arrangements),
    "counterweight": ("counterweight_design", CounterweightDesigns),
    "counterweight_check": ("counterweight_check", CounterweightCheck),
    "workshop": ("balance_factor", FactorAnswer),
    "crank_unbalance": ("crank_unbalance", CrankWithBobweights),
    "external_balance": ("external_balance", ExternalBalance),
    "assign_parts": ("assign_parts", Assignment),
    "scatter": ("scatter", ScatterStudy),
    "sensitivity": ("sensitivity", Sensitivity),
    "simulate": ("simulate", SimulationResult),
    "crosscheck": ("crosscheck", CrossCheck),
    "bondgraph": ("bondgraph", BondGraph),
    "stress": ("stress_static", StaticStress),
    "modes": ("stress_modes", CrankModes),
    "fatigue": ("stress_fatigue", CrankFatigue),
    "stress_cycle": ("stress_cycle", CrankCycle),
    "reduced_model": ("stress_reduce", ReducedCrank),
    "strength": ("stress_rule", CrankRule),
}


@overload
def map(question: str, engines: Sequence[Engine], pick: str | Sequence[str], **options: Any) -> dict[str, FloatArray]: ...
@overload
def map(question: Literal["loads"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Loads]: ...
@overload
def map(question: Literal["bending"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Bending]: ...
@overload
def map(question: Literal["torque"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[TorqueReport]: ...
@overload
def map(question: Literal["bearings"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Bearings]: ...
@overload
def map(question: Literal["films"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[BearingFilms]: ...
@overload
def map(question: Literal["torsion"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[TorsionResult]: ...
@overload
def map(question: Literal["mounts"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[MountStudy]: ...
@overload
def map(question: Literal["inertias"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Inertias]: ...
@overload
def map(question: Literal["balance"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Balance]: ...
@overload
def map(question: Literal["robust_balance"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[RobustAnswer]: ...
@overload
def map(question: Literal["arrangements"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Arrangements]: ...
@overload
def map(question: Literal["counterweight"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CounterweightDesigns]: ...
@overload
def map(question: Literal["counterweight_check"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CounterweightCheck]: ...
@overload
def map(question: Literal["workshop"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[FactorAnswer]: ...
@overload
def map(question: Literal["crank_unbalance"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrankWithBobweights]: ...
@overload
def map(question: Literal["external_balance"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[ExternalBalance]: ...
@overload
def map(question: Literal["assign_parts"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Assignment]: ...
@overload
def map(question: Literal["scatter"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[ScatterStudy]: ...
@overload
def map(question: Literal["sensitivity"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Sensitivity]: ...
@overload
def map(question: Literal["simulate"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[SimulationResult]: ...
@overload
def map(question: Literal["crosscheck"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrossCheck]: ...
@overload
def map(question: Literal["bondgraph"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[BondGraph]: ...
@overload
def map(question: Literal["stress"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[StaticStress]: ...
@overload
def map(question: Literal["modes"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrankModes]: ...
@overload
def map(question: Literal["fatigue"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrankFatigue]: ...
@overload
def map(question: Literal["stress_cycle"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrankCycle]: ...
@overload
def map(question: Literal["reduced_model"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[ReducedCrank]: ...
@overload
def map(question: Literal["strength"], engines: Sequence[Engine], pick: None = None, **options: Any) -> list[CrankRule]: ...
@overload
def map(question: str, engines: Sequence[Engine], pick: None = None, **options: Any) -> list[Any]: ...
def map(
    question: str,
    engines: Sequence[Engine],
    pick: str | Sequence[str] | None = None,
    **options: Any,
) -> dict[str, FloatArray] | list[Any]:
    """One question about many engines in one call, on all processors.

    `question` is the name of a method of :class:`Engine`, `options` are its arguments. Without `pick` it returns the results; with paths of numbers
    in them, such as ``"total.peaks.force.max.value"``, a dictionary of arrays, one for each path: of 1e5 engines nothing else is kept.

    >>> import lanchester
    >>> import numpy as np
    >>> rods = lanchester.Engine.template("in-line-4").variants({"rod.length": np.linspace(0.13, 0.17, 5)})
    >>> found = lanchester.map("loads", rods, "total.peaks.force.max.value")
    >>> bool(np.all(np.diff(found["total.peaks.force.max.value"]) < 0))
    True
    """
    if question not in _KINDS:
        raise RequestError(f'`map` knows no question "{question}"', f"it knows {', '.join(_KINDS)}")
    name, kind = _KINDS[question]
    known = set(getattr(Engine, question).__kwdefaults__ or {}) | set(getattr(Engine, question).__annotations__)
    unknown = [option for option in options if option not in known]
    if unknown:
        raise RequestError(f"`{question}` has no argument `{unknown[0]}`", f"it has {', '.join(sorted(known - {'return'}))}")
    options = {option: _sheet(value) if isinstance(value, WorkshopSheet) else value for option, value in options.items()}
    if isinstance(engines, Variants):
        natives, columns = [engines.engine._native], engines.columns
    else:
        engines = engines if isinstance(engines, Engine) else list(engines)
        natives, columns = _natives(engines), None
    paths = [pick] if isinstance(pick, str) else pick
    found: Any = _native.map(name, natives, options, columns, None if paths is None else list(paths))
    if paths is not None:
        picked: dict[str, FloatArray] = found
        return picked
    if isinstance(engines, Variants):
        return [kind._made(answer, (engines.engine,)) for answer in found]
    return [kind._made(answer, (engine,)) for answer, engine in zip(found, engines, strict=True)]


def compare(
    engines: Sequence[Engine],
    *,
    equal: Literal["displacement", "power"] | None = None,
    hold: Literal["speed", "piston-speed"] | None = None,
    speed: Quantity | None = None,
    reference: int = 0,
    share: Quantity | None = None,
    mount_spacing: Quantity | None = None,
    fluctuation: Quantity | None = None,
    arrangements: int | Sequence[int] = (),
    optimum: bool = False,
    finite_elements: bool = False,
) -> Comparison:
    """Engines side by side: as they are, or as similar engines of one displacement or one power.

    `reference`: index of the engine that the others are compared with; `arrangements`: numbers 1 to 9 of the twin thesis; `optimum`: each with its best weights too; `finite_elements`:
    safeties of the fillets too, which takes from seconds to minutes an engine.

    >>> import lanchester
    >>> engines = [lanchester.Engine.template(name) for name in ("in-line-4", "boxer-4")]
    >>> found = lanchester.compare(engines)
    >>> len(found.table("comparison")) > 1
    True
    """
    options = {
        "equal": equal,
        "hold": hold,
        "speed": speed,
        "reference": reference,
        "share": share,
        "mount_spacing": mount_spacing,
        "fluctuation": fluctuation,
        "arrangements": arrangements,
        "optimum": optimum,
        "finite_elements": finite_elements,
    }
    engines = engines if isinstance(engines, Engine) else list(engines)
    answer = _native.ask_all("compare", _natives(engines), options)
    return Comparison._made(answer, tuple(engines))


def adopt(result: Result, number: int | None = None) -> Engine:
    """The engine with what a result found: the weights of a balance, the shapes of counterweights, layout `number` of a search.

    >>> import lanchester
    >>> twin = lanchester.Engine.template("twin-360")
    >>> lanchester.adopt(twin.balance(minimise="force", counterweights="throws")) != twin
    True
    """
    answer = result._answer
    choices, place = answer.choices(), 0 if number is None else index(number)
    if choices is not None and not 0 <= place < choices:
        if hasattr(result, "front"):
            raise RequestError(f"there is no layout {place} on a front of {choices}", "they are counted from 0, as in `front`")
        raise RequestError(f"there is no choice {place}: {type(result).__name__} finds one engine", "leave the number out")
    found = None if choices is None else answer.adopted(place)
    if found is None:
        raise RequestError(f"{type(result).__name__} finds nothing that an engine could adopt", "`balance`, `counterweight` and `explore` do")
    return Engine(found)
