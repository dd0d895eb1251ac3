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
        from matplotlib.figure import Figure
    except ImportError as error:
        raise LanchesterError("plots need Matplotlib, which is not installed", "pip install matplotlib") from error
    figure = Figure(figsize=(9.0, 3.6), layout="constrained")
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
}
