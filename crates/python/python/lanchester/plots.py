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


def _legend_below(figure: Figure, axes: Any, count: int = 4) -> None:
    """A legend outside the axes, where no bar is."""
    figure.legend(*axes.get_legend_handles_labels(), loc="outside lower center", ncols=count, frameon=False, fontsize=8)


def _legend_beneath(axes: Any) -> None:
    """The same of one of several axes, one line an entry."""
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), frameon=False, fontsize=8)


def _said(axes: Any, words: str) -> None:
    """Words in the place of what cannot be drawn."""
    axes.set_axis_off()
    axes.text(0.5, 0.5, words, ha="center", va="center", wrap=True, transform=axes.transAxes)


def _bars(axes: Any, names: list[str], values: Any, colour: Any = FORWARD) -> None:
    """Bars with their names, the first on top."""
    axes.barh(np.arange(len(names)), values, color=colour)
    axes.set_yticks(np.arange(len(names)), names, fontsize=8)
    # One bar alone is no wall.
    axes.set_ylim(max(len(names), 4) - 0.5, -0.5)


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
    _legend_below(figure, left)
    trace = loads.total.trace
    turn = np.asarray(trace.theta) / DEGREE
    # Newtons and newton metres have an axis each, in the colour of its line.
    other = right.twinx()
    shown = (
        (right, np.hypot(trace.force_x, trace.force_y), "force", "N", FORWARD, "-"),
        (other, np.hypot(trace.couple_x, trace.couple_y), "couple", "N m", BACKWARD, "--"),
    )
    for axes, values, what, unit, colour, style in shown:
        clean = _clean(values, noise[what])
        axes.plot(turn, clean, style, color=colour)
        axes.set_ylim(0.0, 1.08 * float(np.max(clean, initial=0.0)) or 1.0)
        axes.set_ylabel(f"{what} [{unit}]", color=colour)
        axes.tick_params(axis="y", labelcolor=colour)
    right.set(title=f"{loads.engine}, {loads.speed / RPM:.0f} rpm", xlabel="crank angle [deg]")


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
    # The names and units of the table, whose rows are the outputs; what no engine has says nothing.
    table = found.table("scatter")
    rows = [(own, str(name), str(unit)) for own, name, unit in zip(outputs, table["load"], table["unit"], strict=True)]
    telling = [row for row in rows if row[0].most > 1e-9 * max(own.most for own in outputs)] or rows
    for axes, (own, name, unit) in zip(np.atleast_1d(figure.subplots(1, min(3, len(telling)), sharey=True)), telling, strict=False):
        axes.plot(own.percentiles.column("value"), 100 * own.percentiles.column("share"), ".", markersize=3, color=FORWARD)
        axes.axvline(own.nominal, color=LIMIT, linewidth=1, label="nominal")
        axes.set(title=name, xlabel=f"value [{unit}]")
        axes.label_outer()
    figure.axes[0].set_ylabel("engines that do not exceed it [%]")
    _legend_below(figure, figure.axes[0])


def _sensitivity(found: results.Sensitivity, figure: Figure) -> None:
    axes = figure.subplots()
    # A table for each output that an input changes, the strongest input first.
    if not found.tables:
        _said(axes, "No input changes an output.")
        return
    table = found.tables[0]
    output = next((own for own in found.outputs if table.title.lower().startswith(own.name.lower())), found.outputs[0])
    ends = [[_number(own) for own in table[head]][:12] for head in ("at the lower end", "at the upper end")]
    names = [f"{name}, ± {width}" for name, width in zip(table["input"], table["plus or minus"], strict=True)][:12]
    for values, colour, label in zip(ends, (FORWARD, BACKWARD), ("lower end", "upper end"), strict=True):
        axes.barh(np.arange(len(names)), np.array(values) - output.nominal, color=colour, label=label)
    axes.set_yticks(np.arange(len(names)), names, fontsize=8)
    axes.invert_yaxis()
    axes.set(title=table.title, xlabel=f"change [{output.unit}]")
    _legend_below(figure, axes)


def _number(value: Any) -> float:
    """A cell that is a number; NaN of words."""
    return float(value) if isinstance(value, float) else np.nan


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
    outside: set[str] = set()
    for speed in found.speeds:
        for throw in speed.throws:
            for name, sheet in _places(throw):
                if sheet is None:
                    outside.add(name)
                else:
                    least[name] = min(least.get(name, np.inf), sheet.safety)
    if not least:
        _said(axes, "Every place is outside the range of the formulas: there is no safety to draw. The table names what is out of range.")
        return
    figure.set_figheight(max(3.6, 0.6 + 0.16 * len(least)))
    _fillets(axes, list(least), list(least.values()), None)
    axes.axvline(found.acceptable, color=BACKWARD, linewidth=1, label=f"the rule: {found.acceptable:g}")
    left_out = f", without {len(outside)} outside its range" if outside else ""
    axes.set(title=f"Safety by the formulas of UR M53: {found.engine}", xlabel=f"least safety Q of every place{left_out} [1]")
    _legend_below(figure, axes)


def _places(throw: results.ThrowSheet) -> list[tuple[str, results.FilletSheet | None]]:
    """The checked places of a throw as the tables name them; outside the range of the formulas finite elements count, where there are some."""
    places: list[tuple[str, results.FilletSheet | None]] = []
    for web in throw.webs:
        pin, journal = (None, None) if web.by_elements is None else (web.by_elements.pin_fillet, web.by_elements.journal_fillet)
        places.append((f"pin {throw.throw} at web {web.web}", web.pin_fillet or pin))
        places.append((f"journal {web.journal} at web {web.web}", web.journal_fillet or journal))
    if throw.bore is not None:
        places.append((f"oil bore of pin {throw.throw}", throw.bore.stress))
    return places


def _robust(found: results.RobustAnswer, figure: Figure) -> None:
    axes = figure.subplots()
    values = {
        "no weights go below": found.lower_bound,
        "these weights": found.value,
        "weights that are best as it is meant": found.ordinary,
        "as it is meant, these weights": found.nominal,
        "as it is meant, its own best": found.ordinary_nominal,
    }
    _bars(axes, list(values), list(values.values()), [LIMIT, FORWARD, BACKWARD, FORWARD, BACKWARD])
    axes.set(title=f"{found.answer.engine}: {found.samples} engines within tolerances", xlabel=f"residual [{found.unit}]")


def _inertias(found: results.Inertias, figure: Figure) -> None:
    axes = figure.subplots()
    known = [(own.name, own.inertia.value * own.ratio**2) for own in found.bodies if own.inertia is not None]
    if not known:
        _said(axes, "The engine file gives no inertia.")
        return
    _bars(axes, [name for name, _ in known], [value for _, value in known])
    axes.set(title="Moments of inertia as seen at crankshaft 1", xlabel="inertia times speed ratio squared [kg m²]")


def _designs(found: results.CounterweightDesigns, figure: Figure) -> None:
    axes = figure.subplots()
    known = [own for own in found.weights if own.part_mass is not None]
    if not known:
        _said(axes, "No counterweight has a shape within these limits.")
        return
    _bars(axes, [own.name for own in known], [own.part_mass for own in known])
    axes.set(title=f"Counterweights with the best shape: {found.engine}", xlabel="mass of the part, with the disc of its web [kg]")


def _checked(found: results.CounterweightCheck, figure: Figure) -> None:
    axes = figure.subplots()
    weights = found.counterweights
    if not weights:
        _said(axes, "No counterweight is a part.")
        return
    _bars(axes, [own.name for own in weights], 1e6 * np.array([own.unbalance for own in weights]))
    wanted = [(place, 1e6 * own.wanted) for place, own in enumerate(weights) if own.wanted is not None]
    if wanted:
        axes.plot([own for _, own in wanted], [place for place, _ in wanted], "|", color=BACKWARD, markersize=16, label="as it should be")
        _legend_below(figure, axes)
    axes.set(title=f"Counterweights as parts: {found.engine}", xlabel="unbalance on the web [g mm]")


def _arrangements(found: results.Arrangements, figure: Figure) -> None:
    axes = figure.subplots()
    own = found.spacings[0]
    possible = [one for one in own.arrangements if one.possible and np.isfinite(one.residual)]
    if not possible:
        _said(axes, "No arrangement has a place and holds the limits.")
        return
    best = sorted(possible, key=lambda one: one.residual)[:12]
    figure.set_figheight(max(3.6, 1.2 + 0.25 * len(best)))
    _bars(axes, [one.label for one in best], [one.residual for one in best], [FORWARD if one.on_front else LIMIT for one in best])
    for colour, label in ((FORWARD, "Pareto-optimal"), (LIMIT, "another one is better in all")):
        axes.plot([], [], "s", color=colour, label=label)
    if found.limit is not None:
        axes.axvline(found.limit, color=BACKWARD, linewidth=1, label="good enough")
    _legend_below(figure, axes)
    unit = "N m" if found.criterion == "couple" else "N"
    axes.set(title=f"Arrangements: {found.engine} (with nothing added {own.baseline:.5g} {unit})", xlabel=f"peak of the {found.criterion} that is left [{unit}]")


def _factors(found: results.FactorAnswer, figure: Figure) -> None:
    axes = figure.subplots()
    throws = [own for own in found.throws if own.reciprocating_share is not None]
    if not throws:
        _said(axes, "Nothing reciprocates.")
        return
    _bars(axes, [f"throw {own.throw}" for own in throws], [100.0 * (own.reciprocating_share or 0.0) for own in throws])
    least = [(place, 100.0 * own.least_peak_share) for place, own in enumerate(throws) if own.least_peak_share is not None]
    if least:
        axes.plot([own for _, own in least], [place for place, _ in least], "|", color=BACKWARD, markersize=16, label="smallest peak of the first-order force")
        _legend_below(figure, axes)
    axes.set(title=f"Balance factors: {found.engine}", xlabel="share of the reciprocating mass that is balanced [%]")


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


def _cycle(found: results.CrankCycle, figure: Figure) -> None:
    figure.set_figheight(4.2)
    left, right = figure.subplots(1, 2, width_ratios=(1.7, 1))
    flexible = [run for run in found.runs if len(run.fillets)]
    if flexible:
        # One fillet in all laws: that with the largest stress of all.
        worst = max((fillet for run in flexible for fillet in run.fillets), key=lambda own: own.peak).name
        for run in flexible:
            [stress] = [np.asarray(own.over_cycle) for own in run.fillets if own.name == worst]
            left.plot(np.asarray(run.theta)[: len(stress)] / DEGREE, 1e-6 * stress[: len(run.theta)], label=run.law)
        left.set(title=f"Stress of {worst}", xlabel="crank angle [deg]", ylabel="von Mises stress [MPa]")
        left.set_ylim(bottom=0.0)
        left.legend(frameon=False, fontsize=8)
    else:
        _said(left, "No run has stress: the crankshaft is rigid, no fillet has a radius, or it was stopped.")
    moving = [(run, own) for run in found.runs for own in run.bearings if own.largest_eccentricity > 1e-12]
    if moving:
        # The journal or pin that comes furthest, in all laws.
        _, furthest = max(moving, key=lambda pair: pair[1].largest_eccentricity / (pair[1].clearance or np.inf))
        own_of = [(run, own) for run, own in moving if (own.kind, own.number) == (furthest.kind, furthest.number)]
        for run, own in own_of:
            orbit = 1e6 * np.asarray(own.orbit)
            right.plot(orbit[:, 0], orbit[:, 1], linewidth=1, label=run.law + (", rigid crankshaft" if run.crank == "rigid" else ""))
        clearance = next((own.clearance for _, own in own_of if own.clearance), None)
        if clearance is not None:
            turn = np.linspace(0.0, 2 * pi, 181)
            right.plot(1e6 * clearance * np.cos(turn), 1e6 * clearance * np.sin(turn), ":", color=LIMIT, label="clearance")
        name = f"{'main' if furthest.kind == 'main' else 'big end'} {furthest.number}"
        right.set(title=f"Orbit in {name}", xlabel="x [um]", ylabel="y [um]", aspect="equal")
        right.legend(frameon=False, fontsize=8)
    else:
        _said(right, "No journal moves in its bearing: the laws are rigid.")
    figure.suptitle(f"{found.sheet.engine}, {found.speed / RPM:.0f} rpm", fontsize=10)


def _reduced(found: results.ReducedCrank, figure: Figure) -> None:
    axes = figure.subplots()
    pairs = np.asarray(found.frequencies)[:12]
    at = np.arange(len(pairs))
    axes.plot(at, pairs[:, 0], "o", color=FORWARD, label="reduced model")
    axes.plot(at, pairs[:, 1], "x", color=BACKWARD, label="with a third of its modes left out")
    of_mesh = np.asarray(found.of_mesh)
    axes.plot(np.arange(len(of_mesh)), of_mesh, "_", color="black", markersize=16, label="mesh")
    axes.set_xticks(at, [str(number + 1) for number in at])
    axes.set(title=f"Free natural frequencies: {found.sheet.engine}", xlabel="mode", ylabel="frequency [Hz]")
    axes.legend(frameon=False)


def _graph(found: results.BondGraph, figure: Figure) -> None:
    run = found.run
    if run is None:
        raise RequestError("there is no run to plot", "ask for one: engine.bondgraph(revolutions=2).plot(); the drawing is in `figures`, and a notebook shows it")
    time = np.asarray(run.time)
    # States come first, then efforts and flows of bonds.
    bonds = next((place for place, own in enumerate(run.series) if own.name.endswith(".effort")), len(run.series))
    units: dict[str, list[results.Series]] = {}
    for own in run.series[:bonds]:
        units.setdefault(own.unit, []).append(own)
    powers = sorted((own for own in run.series if own.name.endswith(".power")), key=lambda own: -float(np.abs(own.values).max(initial=0.0)))
    shown = [(f"states [{unit}]", own[:6]) for unit, own in list(units.items())[:3]] + ([("power [W]", powers[:6])] if powers else [])
    if not shown:
        _said(figure.subplots(), "The graph has neither states nor bonds.")
        return
    figure.set_figheight(1.2 + 1.7 * len(shown))
    for axes, (label, series) in zip(np.atleast_1d(figure.subplots(len(shown), 1, sharex=True)), shown, strict=True):
        for own in series:
            axes.plot(time, own.values, linewidth=1, label=own.name.removesuffix(".power"))
        axes.set_ylabel(label)
        axes.legend(frameon=False, fontsize=7, loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.axes[0].set_title(f"Run of the bond graph: {found.engine}")
    figure.axes[-1].set_xlabel("time [s]")


def _arrow(axes: Any, unbalance: Any, label: str, colour: str) -> None:
    x, y = 1e6 * np.asarray(unbalance)
    axes.annotate("", (x, y), (0.0, 0.0), arrowprops={"arrowstyle": "->", "color": colour})
    axes.plot([x], [y], "o", color=colour, markersize=3, label=label)


def _around(axes: Any, title: str) -> None:
    """Axes for unbalances across a shaft."""
    axes.axhline(0.0, color=LIMIT, linewidth=0.5)
    axes.axvline(0.0, color=LIMIT, linewidth=0.5)
    most = max((abs(float(own)) for line in axes.lines for own in (*line.get_xdata(), *line.get_ydata()) if line.get_label()[0] != "_"), default=0.0)
    reach = 1.15 * most if most > 0.0 else 1.0
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set(title=title, xlabel="x [g mm]", ylabel="y [g mm]", aspect="equal")


COLOURS = ("#0b6e99", "#d9730d", "#4d7c0f", "#7e22ce", "#777777", "#c1121f")


def _unbalance(found: results.CrankWithBobweights, figure: Figure) -> None:
    axes = figure.subplots()
    figure.set_figheight(4.8)
    # A billionth of what cancels is rounding.
    noise = 1e-9 * max((float(_size(own.unbalance)) for own in (*found.throws, *found.counterweights)), default=0.0)
    for place, plane in enumerate(found.planes):
        shown = plane.unbalance if _size(plane.unbalance) > noise else np.zeros(2)
        _arrow(axes, shown, f"{plane.name}, z = {1e3 * plane.z:.0f} mm", COLOURS[place])
    _around(axes, f"Dynamic unbalance with bobweights: {found.engine}")
    _legend_below(figure, axes)


def _outside(found: results.ExternalBalance, figure: Figure) -> None:
    axes = figure.subplots()
    figure.set_figheight(4.8)
    for place, weight in enumerate(found.weights):
        _arrow(axes, weight.unbalance, f"{weight.name}, z = {1e3 * weight.z:.0f} mm", COLOURS[place])
    _around(axes, f"Weights outside: {found.engine}")
    _legend_below(figure, axes)


def _bobweights(found: results.BobweightAnswer, figure: Figure) -> None:
    axes = figure.subplots()
    _bars(axes, [own.pin for own in found.bobweights], [1e3 * own.mass for own in found.bobweights])
    axes.set(title=f"Bobweights: {found.name}", xlabel="mass [g]")


def _corrected(found: results.Correction, figure: Figure) -> None:
    axes = figure.subplots()
    figure.set_figheight(4.8)
    for place, plane in enumerate(found.planes):
        _arrow(axes, plane.unbalance, plane.plane, COLOURS[place % len(COLOURS)])
    _around(axes, f"Weights to add: {found.name}")
    _legend_below(figure, axes)


def _assigned(found: results.Assignment, figure: Figure) -> None:
    axes = figure.subplots()
    values = {"parts as they are numbered": found.as_numbered, "this assignment": found.residual, "no assignment leaves less": found.bound}
    _bars(axes, list(values), list(values.values()), [BACKWARD, FORWARD, LIMIT])
    axes.set(title="First order that the parts leave", xlabel="force, and couple over the lever [N]")


def _drilled(found: results.Drilling, figure: Figure) -> None:
    figure.set_figheight(4.8)
    turn = np.linspace(0.0, 2.0 * np.pi, 181)
    for axes, plane in zip(np.atleast_1d(figure.subplots(1, max(len(found.planes), 1))), found.planes, strict=True):
        _arrow(axes, plane.wanted, "to remove", LIMIT)
        for place, hole in enumerate(plane.holes):
            removed = hole.unbalance * np.array([np.cos(hole.angle), np.sin(hole.angle)])
            size = f"{1e3 * hole.diameter:g} mm, {1e3 * hole.depth:.1f} mm deep at {np.degrees(hole.angle):.0f} deg"
            _arrow(axes, removed, size, COLOURS[place % len(COLOURS)])
        _arrow(axes, plane.left, "left", BACKWARD)
        axes.plot(1e6 * plane.tolerance * np.cos(turn), 1e6 * plane.tolerance * np.sin(turn), ":", color=LIMIT, label="may be left")
        _around(axes, f"Holes in {plane.plane}")
        _legend_beneath(axes)


def _graded(found: results.Grade, figure: Figure) -> None:
    axes = figure.subplots()
    rows: list[tuple[str, float, Any]] = [("rotor", found.permissible, found.resultant)]
    rows += [(f"bearing, z = {1e3 * own.z:.0f} mm", own.permissible, own.measured) for own in found.bearings]
    rows += [(f"{own.name}, z = {1e3 * own.z:.0f} mm", own.permissible, own.measured) for own in found.planes]
    _bars(axes, [name for name, _, _ in rows], [1e6 * most for _, most, _ in rows], LIMIT)
    measured = [(place, 1e6 * float(_size(own))) for place, (_, _, own) in enumerate(rows) if own is not None]
    if measured:
        axes.plot([size for _, size in measured], [place for place, _ in measured], "o", color=FORWARD, label="measured")
        _legend_below(figure, axes)
    axes.set(title=f"Permissible residual unbalance, G {1e3 * found.grade:g}: {found.name}", xlabel="unbalance [g mm]")


def _inside(found: results.InternalBalance, figure: Figure) -> None:
    figure.set_figheight(4.8)
    for axes, plane in zip(np.atleast_1d(figure.subplots(1, max(len(found.planes), 1))), found.planes, strict=True):
        plan = plane.plan
        turn = np.linspace(0.0, 2.0 * np.pi, 181)
        axes.plot(1e3 * plan.slug.rim * np.cos(turn), 1e3 * plan.slug.rim * np.sin(turn), color=LIMIT, label="rim of the counterweight")
        for place, direction in enumerate(np.atleast_1d(plan.directions)):
            x = 1e3 * (plan.slug.radius * np.cos(direction) + 0.5 * plan.slug.diameter * np.cos(turn))
            y = 1e3 * (plan.slug.radius * np.sin(direction) + 0.5 * plan.slug.diameter * np.sin(turn))
            axes.fill(x, y, color=FORWARD, label=f"slugs, {1e3 * plan.length:.1f} mm long" if place == 0 else None)
        axes.set(title=f"{plane.name}, z = {1e3 * plane.z:.0f} mm", xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
        _legend_beneath(axes)


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
    results.RobustAnswer: _robust,
    results.Inertias: _inertias,
    results.CounterweightDesigns: _designs,
    results.CounterweightCheck: _checked,
    results.Arrangements: _arrangements,
    results.FactorAnswer: _factors,
    results.CrankCycle: _cycle,
    results.ReducedCrank: _reduced,
    results.BondGraph: _graph,
    results.CrankWithBobweights: _unbalance,
    results.ExternalBalance: _outside,
    results.BobweightAnswer: _bobweights,
    results.Correction: _corrected,
    results.Drilling: _drilled,
    results.Grade: _graded,
    results.InternalBalance: _inside,
    results.Assignment: _assigned,
}
