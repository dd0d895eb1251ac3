"""Figures of Matplotlib, which is not needed for anything else."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import TYPE_CHECKING, Any

import numpy as np

from . import results
from ._record import Result
from .errors import LanchesterError, RequestError

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FORWARD, BACKWARD, LIMIT = "#0b6e99", "#d9730d", "#777777"
DEGREE = pi / 180.0
RPM = 2.0 * pi / 60.0


def plot(result: Result) -> Figure:
    """What matters most of a result.

    >>> from lanchester import Engine, plots
    >>> plots.plot(Engine.template("single").loads()).axes[0].get_title() != ""
    True
    """
    draw = next((draw for kind, draw in _DRAWN.items() if isinstance(result, kind)), None)
    if draw is None:
        known = ", ".join(kind.__name__ for kind in _DRAWN)
        raise RequestError(f"there is no plot of {type(result).__name__}", f"`figures` has the report's pictures; plots are of {known}")
    try:
        from ._figure import ShownFigure
    except ImportError as error:
        raise LanchesterError("plots need Matplotlib, which is not installed", "pip install matplotlib") from error
    figure = ShownFigure(figsize=(9.0, 3.6), layout="constrained")
    draw(result, figure)
    return figure


def _size(values: Any) -> Any:
    return np.linalg.norm(np.asarray(values, dtype=np.float64), axis=-1)


def _noise(loads: results.Loads) -> dict[str, float]:
    """Below these a force [N] and a couple [N m] are rounding, by the rule of the tables: a billionth of the largest of the whole, of any part
    or cylinder; couples at least a centimetre times the force."""
    sets = [loads.total, *(part.loads for part in loads.parts), *(own.loads for own in loads.cylinders)]
    force, couple = (max(getattr(own.peaks, what).max.value for own in sets) for what in ("force", "couple"))
    return {"force": 1e-9 * force, "couple": 1e-9 * max(couple, 0.01 * force)}


def _clean(values: Any, noise: float) -> Any:
    return np.where(np.asarray(values) > noise, values, 0.0)


def _loads(loads: results.Loads, figure: Figure) -> None:
    noise = _noise(loads)
    left, middle, right = figure.subplots(1, 3, width_ratios=(1, 1, 1.4))
    orders = [order for order in loads.total.orders if 0 < order.order <= 6]
    at = np.array([order.order for order in orders])
    for axes, what, unit in ((left, "force", "N"), (middle, "couple", "N m")):
        for side, shift, colour in (("forward", -0.2, FORWARD), ("backward", 0.2, BACKWARD)):
            sizes = [_size(getattr(order, f"{what}_{side}")) for order in orders]
            axes.bar(at + shift, _clean(sizes, noise[what]), 0.4, color=colour, label=side)
        axes.set(title=f"{what.capitalize()} by order", xlabel="order", ylabel=f"{what} [{unit}]")
        if axes.dataLim.y1 == 0.0:
            axes.set_ylim(0.0, 1.0)
    left.legend(frameon=False)
    trace = loads.total.trace
    turn = np.asarray(trace.theta) / DEGREE
    right.plot(turn, _clean(np.hypot(trace.force_x, trace.force_y), noise["force"]), color=FORWARD, label="force [N]")
    right.plot(turn, _clean(np.hypot(trace.couple_x, trace.couple_y), noise["couple"]), color=BACKWARD, label="couple [N m]")
    right.set(title=f"{loads.engine}, {loads.speed / RPM:.0f} rpm", xlabel="crank angle [deg]")
    right.legend(frameon=False)


def _torque(report: results.TorqueReport, figure: Figure) -> None:
    axes = figure.subplots()
    torque = report.torque
    turn = np.asarray(torque.theta) / DEGREE
    gas, inertia = np.asarray(torque.gas), np.asarray(torque.inertia)
    if torque.with_gas:
        axes.plot(turn, gas, color=BACKWARD, label="gas")
    axes.plot(turn, inertia, color=FORWARD, label="inertia")
    if torque.with_gas:
        axes.plot(turn, gas + inertia, color="black", label="both")
    axes.set(title=f"Torque: {torque.engine}, {torque.speed / RPM:.0f} rpm", xlabel="crank angle [deg]", ylabel="torque [N m]")
    axes.legend(frameon=False)


def _bearings(found: results.Bearings, figure: Figure) -> None:
    axes = figure.subplots()
    turn = np.asarray(found.theta) / DEGREE
    for main in found.mains:
        axes.plot(turn, _size(main.journal_frame), label=f"main {main.main}")
    axes.set(title=f"Main bearings: {found.engine}, {found.speed / RPM:.0f} rpm", xlabel="crank angle [deg]", ylabel="load [N]")
    axes.legend(frameon=False, ncols=2)


def _mounts(found: results.MountStudy, figure: Figure) -> None:
    axes = figure.subplots()
    speeds = [own.speed / RPM for own in found.response.speeds]
    peaks = np.array([own.peaks.column("value") for own in found.response.speeds])
    for place, mount in enumerate(found.at_rest.mounts):
        axes.plot(speeds, peaks[:, place], marker="o" if len(speeds) < 5 else "", label=mount.name)
    axes.set(title=f"Forces at the mounts: {found.engine}", xlabel="speed [rpm]", ylabel="largest force [N]")
    axes.legend(frameon=False)


def _balance(found: results.Balance, figure: Figure) -> None:
    axes = figure.subplots()
    effects = [own for own in (found.consequences.rows if found.consequences else ()) if own.before or own.after]
    names = [f"{own.quantity} {_part(own.part)}".strip() for own in effects]
    ratio = np.array([own.after / own.before if own.before else np.nan for own in effects])
    axes.barh(np.arange(len(names)), ratio, color=[FORWARD if own <= 1 else BACKWARD for own in ratio])
    axes.set_yticks(np.arange(len(names)), names, fontsize=8)
    axes.axvline(1.0, color=LIMIT, linewidth=1)
    axes.invert_yaxis()
    axes.set(title="What the weights do: after over before", xlabel="after / before")


def _part(part: results.AffectedPart) -> str:
    return {"engine": "", "crankshaft": "", "main": f"main {part.main}", "bay": f"bay {part.bay}"}[part.kind]


def _compare(found: results.Comparison, figure: Figure) -> None:
    names = [own.engine for own in found.engines]
    for axes, what, unit in zip(figure.subplots(1, 3), ("force", "couple", "roll_moment"), ("N", "N m", "N m"), strict=True):
        axes.barh(np.arange(len(names)), found.engines.column(what), color=FORWARD)
        axes.set_yticks(np.arange(len(names)), names if what == "force" else [""] * len(names))
        axes.invert_yaxis()
        axes.set(title=what.replace("_", " ").capitalize(), xlabel=f"largest value [{unit}]")


def _scatter(found: results.ScatterStudy, figure: Figure) -> None:
    outputs = found.scatter.outputs
    for axes, own in zip(np.atleast_1d(figure.subplots(1, min(3, len(outputs)))), outputs, strict=False):
        axes.plot(own.percentiles.column("value"), 100 * own.percentiles.column("share"), ".", markersize=3, color=FORWARD)
        axes.axvline(own.nominal, color=LIMIT, linewidth=1)
        axes.set(title=str(own.output), xlabel="value (SI)", ylabel="engines that do not exceed it [%]")


def _sensitivity(found: results.Sensitivity, figure: Figure) -> None:
    axes = figure.subplots()
    output = found.outputs[0]
    names = [str(own.to_dict().get("quantity", place)) for place, own in enumerate(found.inputs)]
    below = np.array([np.nan if own.below is None else own.below for own in output.effects]) - output.nominal
    above = np.array([np.nan if own.above is None else own.above for own in output.effects]) - output.nominal
    width = np.nan_to_num(np.maximum(abs(below), abs(above)))
    rows = np.argsort(-width)[:12]
    axes.barh(np.arange(len(rows)), below[rows], color=FORWARD, label="lower end")
    axes.barh(np.arange(len(rows)), above[rows], color=BACKWARD, label="upper end")
    axes.set_yticks(np.arange(len(rows)), [names[row] for row in rows], fontsize=8)
    axes.invert_yaxis()
    axes.set(title=f"{output.name}: {output.nominal:.4g} {output.unit}", xlabel=f"change [{output.unit}]")
    axes.legend(frameon=False)


def _simulation(found: results.SimulationResult, figure: Figure) -> None:
    upper, lower = figure.subplots(2, 1, sharex=True)
    samples = found.run.samples
    upper.plot(samples.time, np.asarray(samples.speed) / RPM, color=FORWARD)
    upper.set(title=found.engine, ylabel="speed [rpm]")
    lower.plot(samples.time, samples.gas_torque, color=BACKWARD, label="gas")
    lower.plot(samples.time, samples.load_torque, color="black", label="load")
    lower.set(xlabel="time [s]", ylabel="torque [N m]")
    lower.legend(frameon=False)


def _layouts(found: results.Exploration, figure: Figure) -> None:
    axes = figure.subplots()
    first, second = (*found.objectives, found.objectives[0])[:2]
    sample = np.array([own.values for own in found.sample]).reshape(len(found.sample), -1)
    front = np.array([own.values for own in found.front]).reshape(len(found.front), -1)
    column = 1 if len(found.objectives) > 1 else 0
    if len(sample):
        axes.plot(sample[:, 0], sample[:, column], ".", color=LIMIT, markersize=3, label="judged layouts")
    axes.plot(front[:, 0], front[:, column], "o", color=BACKWARD, label="Pareto-optimal")
    axes.set(title=found.engine, xlabel=f"{first.name} [{first.unit}]", ylabel=f"{second.name} [{second.unit}]")
    axes.legend(frameon=False)


def _bending(found: results.Bending, figure: Figure) -> None:
    axes = figure.subplots()
    for case, style in zip(found.cases, ("-", "--"), strict=False):
        words = "with counterweights" if case.counterweights else "without counterweights"
        for own in case.crankshafts:
            for name, model, colour in (("free beam", own.free_beam, FORWARD), ("throw by throw", own.throw_by_throw, BACKWARD)):
                at = [1e3 * station.z for station in model.stations]
                axes.plot(at, [station.largest_moment.value for station in model.stations], style, color=colour, label=f"{name}, {words}")
    axes.set(title="Largest bending moment along the crankshaft", xlabel="z [mm]", ylabel="bending moment [N m]")
    axes.legend(frameon=False, fontsize=8)


def _films(found: results.BearingFilms, figure: Figure) -> None:
    axes = figure.subplots()
    several = len(set(found.films.column("cavitation"))) > 1
    for own in found.films:
        place = np.asarray(own.orbit.eccentricity)
        film = own.bearing.clearance - _size(place)
        turn = np.arange(len(film)) * found.period / len(film) / DEGREE
        label = f"{'main' if own.kind == 'main' else 'big end'} {own.number}{', ' + own.cavitation if several else ''}"
        axes.plot(turn, 1e6 * film, "-" if own.kind == "main" else "--", label=label)
    axes.set(title=f"Thinnest film: {found.engine}, {found.speed / RPM:.0f} rpm", xlabel="crank angle [deg]", ylabel="film [um]")
    axes.set_ylim(bottom=0.0)
    figure.legend(loc="outside right center", frameon=False, fontsize=8)


def _torsion(found: results.TorsionResult, figure: Figure) -> None:
    axes = figure.subplots()
    sweep, twist = found.sweep, found.sweep.twist
    speeds = np.asarray(sweep.speeds) / RPM
    orders = np.asarray(sweep.orders)
    by_order = [np.asarray(own) / DEGREE for own in twist.by_order]
    for place in sorted(range(len(by_order)), key=lambda place: -float(by_order[place].max(initial=0.0)))[:4]:
        axes.plot(speeds, by_order[place], linewidth=1, label=f"order {orders[place]:g}")
    axes.plot(speeds, np.asarray(twist.total) / DEGREE, color="black", label="all orders in true phase")
    axes.set(title=f"Twist between nose and flywheel: {found.engine}", xlabel="speed [rpm]", ylabel="amplitude [deg]")
    axes.legend(frameon=False, fontsize=8)


def _modes(found: results.CrankModes, figure: Figure) -> None:
    axes = figure.subplots()
    modes = found.modes.modes
    shares = np.array([np.asarray(own.shares)[:4] for own in modes])
    below = np.zeros(len(modes))
    for place, name in enumerate(("along x", "along y", "torsion", "axial")):
        axes.bar(np.arange(len(modes)), 100 * shares[:, place], bottom=below, label=name)
        below += 100 * shares[:, place]
    axes.set_xticks(np.arange(len(modes)), [f"{own.frequency:.4g} Hz" for own in modes], rotation=30, fontsize=8)
    axes.set(title=f"Natural modes: {found.sheet.engine}", xlabel=f"supports: {found.support}", ylabel="share of the kinetic energy [%]")
    figure.legend(loc="outside right center", frameon=False, fontsize=8)


def _fillets(axes: Any, names: list[str], values: Any, limit: float | None) -> None:
    axes.barh(np.arange(len(names)), values, color=FORWARD)
    axes.set_yticks(np.arange(len(names)), names, fontsize=7)
    axes.invert_yaxis()
    if limit is not None:
        axes.axvline(limit, color=BACKWARD, linewidth=1)


def _stress(found: results.StaticStress, figure: Figure) -> None:
    axes = figure.subplots()
    largest: dict[str, float] = {}
    for case in found.cases:
        for peak in case.result.peaks:
            if peak.stress is not None:
                largest[peak.name] = max(largest.get(peak.name, 0.0), peak.stress.von_mises)
    _fillets(axes, list(largest), 1e-6 * np.array(list(largest.values())), None)
    axes.set(title=f"Largest stress of every fillet: {found.sheet.engine}", xlabel="von Mises stress [MPa]")


def _fatigue(found: results.CrankFatigue, figure: Figure) -> None:
    axes = figure.subplots()
    least: dict[str, float] = {}
    for speed in found.speeds:
        for own in speed.fillets:
            safety = own.point.safety_of_all
            least[own.name] = min(least.get(own.name, np.inf), np.inf if safety is None else safety)
    names = [name for name, safety in least.items() if np.isfinite(safety)]
    _fillets(axes, names, [least[name] for name in names], 1.0)
    axes.set(title=f"Safety against fatigue: {found.sheet.engine}", xlabel="times that all stress may become larger [1]")


def _strength(found: results.CrankRule, figure: Figure) -> None:
    axes = figure.subplots()
    least: dict[str, float] = {}
    for speed in found.speeds:
        for throw in speed.throws:
            for web in throw.webs:
                for what, sheet in (("pin", web.pin_fillet), ("journal", web.journal_fillet)):
                    if sheet is not None:
                        name = f"web {web.web}, {what}"
                        least[name] = min(least.get(name, np.inf), sheet.safety)
    _fillets(axes, list(least), list(least.values()), found.acceptable)
    axes.set(title=f"Safety by the formulas of UR M53: {found.engine}", xlabel="safety Q [1]")


def _crosscheck(found: results.CrossCheck, figure: Figure) -> None:
    axes = figure.subplots()
    for place, condition in enumerate(found.conditions):
        rows = [own for own in condition.rows if own.scale > 0.0]
        difference = np.array([max(own.difference / own.scale, 1e-17) for own in rows])
        colours = [{"agrees": FORWARD, "disagrees": "#c1121f"}.get(own.verdict, LIMIT) for own in rows]
        axes.scatter(difference, np.full(len(rows), place), c=colours, s=14)
    axes.set_yticks(np.arange(len(found.conditions)), [own.condition for own in found.conditions])
    axes.set_xscale("log")
    axes.margins(y=0.2)
    axes.invert_yaxis()
    for colour, name in ((FORWARD, "agrees"), (LIMIT, "differs as it must"), ("#c1121f", "disagrees")):
        axes.scatter([], [], c=colour, s=14, label=name)
    axes.set(title=f"Two opinions: {found.engine}", xlabel="difference over the largest of its kind")
    axes.legend(frameon=False, fontsize=8)


_DRAWN: dict[type[Result], Callable[[Any, Figure], None]] = {
    results.Loads: _loads,
    results.TorqueReport: _torque,
    results.Bearings: _bearings,
    results.MountStudy: _mounts,
    results.Balance: _balance,
    results.Comparison: _compare,
    results.ScatterStudy: _scatter,
    results.Sensitivity: _sensitivity,
    results.SimulationResult: _simulation,
    results.Exploration: _layouts,
    results.Bending: _bending,
    results.BearingFilms: _films,
    results.TorsionResult: _torsion,
    results.CrossCheck: _crosscheck,
    results.StaticStress: _stress,
    results.CrankModes: _modes,
    results.CrankFatigue: _fatigue,
    results.CrankRule: _strength,
}
