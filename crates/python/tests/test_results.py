"""Results: typed, whole, the same as the command line's."""

from __future__ import annotations

import copy
import gc
import json
import os
import pickle
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lanchester
from lanchester import Engine, Record, Records, RequestError, Result, WorkshopSheet, results
from lanchester._record import Variant
from lanchester.table import Table

ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples"
SHEETS = EXAMPLES / "workshop"
V8_PLANES = {"front": "-180 mm", "rear": "200 mm"}


def asked() -> dict[str, Result]:
    """One result of every kind that an engine of the gallery or an example gives in a moment."""
    four, single, twin = Engine.template("in-line-4"), Engine.template("single"), Engine.template("twin-360")
    mounted = Engine.read(EXAMPLES / "in-line-4-mounts.toml")
    production = Engine.read(EXAMPLES / "in-line-4-production.toml")
    weights = Engine.read(EXAMPLES / "in-line-3-counterweights.toml")
    whole = single.complete()
    # One fillet a web, and that a large one: the mesh is small.
    coarse = whole.with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": None})
    bare = coarse.with_({"crank.body.pin_fillet": None})
    eight = Engine.template("v8-crossplane")
    return {
        "loads": four.loads(),
        "bending": four.bending(),
        "inertias": whole.inertias(),
        "torque": mounted.torque(speeds=["1000 rpm", "2000 rpm", "3000 rpm"]),
        "bearings": mounted.bearings(),
        "mounts": mounted.mounts(steps=3, points=[(0.0, 0.0, 0.1)]),
        "balance": twin.balance(minimise="force", counterweights="throws"),
        "robust_balance": twin.with_(tolerances={"piston_mass": {"plus_minus": "4 g"}}).robust_balance(engines=20, minimise="force", counterweights="throws"),
        "arrangements": twin.arrangements(max_shafts=1),
        "counterweight": weights.counterweight(),
        "counterweight_check": weights.counterweight().adopt().counterweight_check(),
        "workshop": Engine.template("v6-60").workshop(),
        "explore": four.explore(minimise=["force order 2", "couple order 1"], throw_angles="every 90 deg", even_firing=True),
        "scatter": production.scatter(samples=2000),
        "sensitivity": four.sensitivity(vary="rod length = 10 %", only=True),
        "simulate": single.simulate(revolutions=1, imposed=True),
        "crosscheck": single.crosscheck(condition="a"),
        "bondgraph": single.bondgraph(revolutions=1, audit=True),
        "films": whole.films(),
        "torsion": whole.torsion(),
        "strength": whole.strength(),
        "modes": coarse.modes(6, size="20 mm", fillet_elements=2),
        "stress": coarse.stress(angle=0.0, size="20 mm", fillet_elements=2),
        "fatigue": coarse.fatigue(size="20 mm", fillet_elements=2, instants=24),
        "stress_cycle": coarse.stress_cycle(bearings=["rigid", "film"], speed="3000 rpm", size="30 mm", fillet_elements=2, modes=6, instants=72),
        "reduced_model": bare.reduced_model(6, size="20 mm", fillet_elements=2),
        "crank_unbalance": eight.crank_unbalance(planes=V8_PLANES, bobweight="1.5 kg"),
        "external_balance": eight.external_balance({"damper": ("-290 mm", "70 mm"), "flywheel": "330 mm"}, keep="70 %"),
        "assign_parts": four.assign_parts(pistons=["401.2 g", "399.8 g", "400.5 g", "400.9 g"]),
        "sheet bobweight": WorkshopSheet.read(SHEETS / "v8-bobweight.toml").bobweight(),
        "sheet internal": WorkshopSheet.read(SHEETS / "v8-slugs.toml").internal(),
        "sheet correct": WorkshopSheet.read(SHEETS / "two-plane-crank.toml").correct(),
        "sheet drill": WorkshopSheet.read(SHEETS / "machine-display.toml").drill(),
        "sheet grade": WorkshopSheet.read(SHEETS / "machine-display.toml").grade(),
        "compare": lanchester.compare([four, twin]),
    }


@pytest.fixture(scope="module")
def all_results() -> dict[str, Result]:
    return asked()


def walk(record: Record, values: dict[str, Any], path: str, seen: set[str]) -> None:
    """Every key of the JSON is a typed field that gives what the JSON has."""
    names = {name.removesuffix("_"): name for name in record._FIELDS}
    for key, value in values.items():
        name = names.get(key.replace("-", "_"))
        assert name is not None, f"{path}: {type(record).__name__} has no field for `{key}`"
        compare(getattr(record, name), value, f"{path}.{key}", seen)
    seen.add(type(record).__name__)


def compare(found: Any, value: Any, path: str, seen: set[str]) -> None:
    if isinstance(found, Variant) and isinstance(value, str):
        assert found.kind == value == found and not any(getattr(found, name) is not None for name in found._FIELDS[1:]), path  # type: ignore[attr-defined]
        seen.add(type(found).__name__)
    elif isinstance(found, Variant):
        # One variant with what is in it.
        [(key, content)] = value.items()
        assert found.kind == key and found == value and key in found and plain(found[key]) == content, path  # type: ignore[attr-defined]
        [name] = [name for name in found._FIELDS if name.removesuffix("_") == key.replace("-", "_").lower()]
        compare(getattr(found, name), content, f"{path}.{key}", seen)
        assert all(getattr(found, other) is None for other in found._FIELDS[1:] if other != name), path
        seen.add(type(found).__name__)
    elif isinstance(found, (list, tuple)) and isinstance(value, list):
        assert len(found) == len(value), path
        for place, (own, below) in enumerate(zip(found, value, strict=True)):
            compare(own, below, f"{path}[{place}]", seen)
    elif isinstance(found, Record):
        walk(found, value, path, seen)
    elif isinstance(found, Records):
        assert len(found) == len(value), path
        for place, (own, below) in enumerate(zip(found, value, strict=True)):
            compare(own, below, f"{path}[{place}]", seen)
    elif isinstance(found, np.ndarray):
        assert found.dtype == np.float64 and not (found.size and found.flags.writeable), path
        np.testing.assert_array_equal(found, np.array(value, dtype=np.float64).reshape(found.shape), err_msg=path)
    elif isinstance(found, float) and value is None:
        assert not np.isfinite(found), path
    else:
        assert plain(found) == value, path


def plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(own) for own in value]
    if isinstance(value, dict):
        return {key: plain(own) for key, own in value.items()}
    return value


def test_every_field_of_every_result_is_typed_and_is_that_of_its_json(all_results: dict[str, Result]) -> None:
    seen: set[str] = set()
    for name, result in all_results.items():
        walk(result, json.loads(result.to_json()), name, seen)
    assert len(seen) > 200, f"{len(seen)} structures were looked at"
    variants = {name for name in seen if issubclass(getattr(results, name), Variant)}
    assert len(variants) > 10, f"of the unions {sorted(variants)} were looked at"


def test_no_field_of_a_result_is_of_any_type() -> None:
    text = Path(results.__file__).read_text(encoding="utf-8")
    assert [line for line in text.splitlines() if "def " in line and "Any" in line] == []


def test_variants_are_told_apart_by_their_kind() -> None:
    task = Engine.template("twin-360").balance(minimise=["force order 1", "couple"], counterweights="throws").task
    [(_, by_order)], [(_, couple)] = task.stages[0].terms, task.stages[1].terms
    assert by_order.kind == "order" and by_order.order is not None and by_order.order[0] == "force" and by_order.order[1] == 1.0
    assert couple.kind == "peak" and couple.peak == "couple" and couple.order is None
    assert couple == {"peak": "couple"} and couple != by_order and len({couple, by_order}) == 2
    # As before.
    assert couple["peak"] == "couple" and "peak" in couple and "order" not in couple
    assert repr(by_order) == "Criterion('order', (Load('force'), 1.0))" and str(couple.peak) == "couple"
    with pytest.raises(KeyError):
        couple["order"]
    again = pickle.loads(pickle.dumps(by_order))
    assert again == by_order and again.kind == "order"


def test_every_result_has_words_tables_or_pictures(all_results: dict[str, Result]) -> None:
    for name, result in all_results.items():
        assert result.to_text() or result.tables or result.figures or name in ("counterweight", "inertias"), name
        assert repr(result).startswith(type(result).__name__), name
        assert result._repr_html_(), name


def test_every_structure_is_exported_and_described() -> None:
    for name in results.__all__:
        kind = getattr(results, name)
        assert kind.__doc__, name
        for field in kind._FIELDS:
            assert getattr(kind, field).__doc__, f"{name}.{field}"


PROGRAM = os.environ.get("LANCHESTER_PROGRAM")
COMMANDS: list[tuple[str, list[str], Any]] = [
    ("in-line-4.toml", ["loads", "--speed", "3000 rpm"], lambda engine: engine.loads("3000 rpm")),
    ("in-line-4.toml", ["loads", "--series", "power:4:5", "--grid", "360"], lambda engine: engine.loads(series="power:4:5", grid=360)),
    ("in-line-4-mounts.toml", ["torque"], lambda engine: engine.torque()),
    ("in-line-4-mounts.toml", ["bearings"], lambda engine: engine.bearings()),
    ("in-line-4-mounts.toml", ["mounts", "--steps", "5"], lambda engine: engine.mounts(steps=5)),
    ("in-line-3.toml", ["balance", "--minimise", "couple", "--limit", "force = 100 N"], lambda engine: engine.balance(minimise="couple", limit="force = 100 N")),
    ("twin-in-line-in-phase.toml", ["balance"], lambda engine: engine.balance()),
    ("in-line-4-production.toml", ["scatter", "--samples", "3000"], lambda engine: engine.scatter(samples=3000)),
    ("in-line-4.toml", ["sensitivity"], lambda engine: engine.sensitivity()),
    ("in-line-4.toml", ["crosscheck", "--condition", "a"], lambda engine: engine.crosscheck(condition="a")),
    (
        "generator-set-3.toml",
        ["simulate", "--imposed", "--inertia-only", "--start", "90 deg, 1200 rpm, as drawn", "--event", "540 deg: stop", "--point", "0.35 m, 0 m, 0.1 m"],
        lambda engine: engine.simulate(imposed=True, gas=False, start="90 deg, 1200 rpm, as drawn", events="540 deg: stop", points=[(0.35, 0, "100 mm")]),
    ),
    ("v6-60.toml", ["explore", "--even-firing"], lambda engine: engine.explore(even_firing=True)),
]


@pytest.mark.parametrize(("file", "command", "ask"), COMMANDS, ids=[" ".join([*command[1], command[0]]) for command in COMMANDS])
def test_json_is_that_of_the_command_line(file: str, command: list[str], ask: Any) -> None:
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    path = EXAMPLES / file
    line = [PROGRAM, command[0], str(path), *command[1:], "--format", "json"]
    printed = subprocess.run(line, capture_output=True, text=True, encoding="utf-8", check=False)
    assert printed.returncode in (0, 1), printed.stderr
    assert json.loads(ask(Engine.read(path)).to_json()) == json.loads(printed.stdout)


WORKSHOP: list[tuple[list[str], Any]] = [
    (["bobweight", "v8-bobweight.toml"], lambda: WorkshopSheet.read(SHEETS / "v8-bobweight.toml").bobweight()),
    (["internal", "v8-slugs.toml"], lambda: WorkshopSheet.read(SHEETS / "v8-slugs.toml").internal()),
    (["correct", "two-plane-crank.toml"], lambda: WorkshopSheet.read(SHEETS / "two-plane-crank.toml").correct()),
    (["correct", "machine-display.toml"], lambda: WorkshopSheet.read(SHEETS / "machine-display.toml").correct()),
    (["drill", "machine-display.toml"], lambda: WorkshopSheet.read(SHEETS / "machine-display.toml").drill()),
    (["grade", "machine-display.toml"], lambda: WorkshopSheet.read(SHEETS / "machine-display.toml").grade()),
    (["factor", "../v6-60.toml"], lambda: Engine.read(EXAMPLES / "v6-60.toml").workshop()),
    (["factor", "../single-gas.toml", "--wet-share", "60%", "--oil", "12 g"], lambda: Engine.read(EXAMPLES / "single-gas.toml").workshop(wet_share="60 %", oil=0.012)),
    (["factor", "../single-gas.toml", "--least-peak", "--angle", "170 deg"], lambda: Engine.read(EXAMPLES / "single-gas.toml").workshop(least_peak=True, angle="170 deg")),
    (["factor", "../single-gas.toml", "--axis-ratio", "1.5"], lambda: Engine.read(EXAMPLES / "single-gas.toml").workshop(axis_ratio=1.5)),
    (["factor", "../single-gas.toml", "--counterweight", "9000 g mm"], lambda: Engine.read(EXAMPLES / "single-gas.toml").workshop(counterweight="9000 g mm")),
    (["crank", "../in-line-4.toml"], lambda: Engine.read(EXAMPLES / "in-line-4.toml").crank_unbalance()),
    (
        ["crank", "../in-line-4.toml", "--planes", "front=-180 mm, rear=200 mm", "--bobweight", "1712 g"],
        lambda: Engine.read(EXAMPLES / "in-line-4.toml").crank_unbalance(planes={"front": -0.18, "rear": "200 mm"}, bobweight=1.712),
    ),
    (
        ["external", "../in-line-4.toml", "--planes", "damper=-290 mm @ 70 mm, flywheel=330 mm", "--keep", "70%", "--total-share", "40%"],
        lambda: Engine.read(EXAMPLES / "in-line-4.toml").external_balance({"damper": ("-290 mm", "70 mm"), "flywheel": 0.33}, keep=0.7, total_share="40 %"),
    ),
    (
        ["assign", "../in-line-4.toml", "--big-ends", "452 g, 455 g, 450 g, 451 g", "--small-ends", "160 g, 162 g, 161 g, 160 g", "--lever", "200 mm"],
        lambda: Engine.read(EXAMPLES / "in-line-4.toml").assign_parts(big_ends=["452 g", "455 g", "450 g", "451 g"], small_ends=["160 g", "162 g", "161 g", "160 g"], lever="200 mm"),
    ),
]


@pytest.mark.parametrize(("line", "ask"), WORKSHOP, ids=[" ".join(own[0]) for own in WORKSHOP])
def test_the_workshop_answers_as_on_the_command_line(line: list[str], ask: Any) -> None:
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    done = subprocess.run([PROGRAM, "workshop", *line, "--format", "json"], capture_output=True, text=True, encoding="utf-8", check=False, cwd=SHEETS)
    assert done.returncode in (0, 1), done.stderr
    found = ask()
    assert json.loads(found.to_json()) == json.loads(done.stdout)
    said = subprocess.run([PROGRAM, "workshop", *line], capture_output=True, text=True, encoding="utf-8", check=False, cwd=SHEETS).stdout
    assert found.to_text().split() == said.split()


def test_a_crank_in_its_bearings_is_that_of_the_command_line(tmp_path: Path) -> None:
    engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": None})
    file = engine.save(tmp_path / "single.toml")
    mesh: dict[str, Any] = {"size": "30 mm", "fillet_elements": 2}
    found = engine.stress_cycle(bearings=["bushing", "rigid"], speed=300.0, modes=6, damping="2 %", instants=72, cycles=4, surface_factor=0.8, **mesh)
    worst = {run.law: max(run.fillets, key=lambda own: own.peak) for run in found.runs}
    assert list(worst) == ["bushing", "rigid"] and all(run.outcome.kind in ("periodic", "not_periodic") for run in found.runs)
    assert len(found.runs[0].theta) == 144 and found.fatigue is not None and len(found.runs[0].fatigue) == len(found.runs[0].fillets) == 2
    curve = np.asarray(worst["rigid"].over_cycle)
    assert curve.max() == worst["rigid"].peak and abs(found.runs[1].theta[curve.argmax()]) < np.pi, "the largest stress is that of the firing"
    left, right = found.plot().axes
    assert [line.get_label() for line in left.lines] == ["bushing", "rigid"] and left.get_title().startswith("Stress of pin 1")
    assert "bushing" in [line.get_label() for line in right.lines] and right.get_xlabel() == "x [um]"
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    asked = ["--bearings", "bushing,rigid", "--speed", "300 rad/s", "--modes", "6", "--damping", "0.02", "--instants", "72", "--cycles", "4", "--surface-factor", "0.8"]
    line = [PROGRAM, "stress", "cycle", str(file), "--size", "30 mm", "--fillet-elements", "2", *asked, "--format", "json"]
    printed = json.loads(subprocess.run(line, capture_output=True, text=True, encoding="utf-8", check=False).stdout)
    own = json.loads(found.to_json())
    for run, told in zip(own["runs"], printed["runs"], strict=True):
        np.testing.assert_allclose([one["peak"] for one in run["fillets"]], [one["peak"] for one in told["fillets"]], rtol=1e-9)
        np.testing.assert_allclose(run["bearings"][0]["load"], told["bearings"][0]["load"], rtol=1e-9, atol=1e-6)
    assert {key for run in own["runs"] for key in run} == {key for run in printed["runs"] for key in run}


STRESS: list[tuple[list[str], dict[str, Any]]] = [
    (["--force", "1: -65 kN, 10.7 kN"], {"force": [(0, "-65 kN", 10.7e3)]}),
    (["--force", "1: -65 kN, 10.7 kN", "--pin-pressure", "uniform"], {"force": [(0, "-65 kN", 10.7e3)], "pin_pressure": "uniform"}),
    (["--angle", "24 deg", "--speed", "3000 rpm", "--support", "rings", "--ring-thickness", "6 mm"], {"angle": "24 deg", "speed": "3000 rpm", "support": "rings", "ring_thickness": 6e-3}),
    (
        ["--angle", "24 deg", "--speed", "3000 rpm", "--support", "springs", "--stiffness", "500 kN/mm : 300 kN/mm, 400 kN/mm"],
        {"angle": "24 deg", "speed": "3000 rpm", "support": "springs", "stiffness": [("500 kN/mm", 3e8), "400 kN/mm"]},
    ),
    (["--angle", "24 deg", "--speed", "3000 rpm", "--support", "film", "--pin-pressure", "film"], {"angle": "24 deg", "speed": "3000 rpm", "support": "film", "pin_pressure": "film"}),
    (["--angle", "24 deg", "--speed", "3000 rpm", "--loads", "simulation"], {"angle": "24 deg", "speed": "3000 rpm", "loads": "simulation"}),
]


@pytest.mark.parametrize(("line", "options"), STRESS, ids=[" ".join(own[0]) for own in STRESS])
def test_static_stress_takes_what_the_command_takes(tmp_path: Path, line: list[str], options: dict[str, Any]) -> None:
    engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": "5 mm", "crank.body.journal_fillet": None})
    found = engine.stress(size="30 mm", fillet_elements=2, **options)
    peaks = [peak.stress.von_mises for case in found.cases for peak in case.result.peaks if peak.stress is not None]
    assert len(found.cases) == 1 and max(peaks) > 1e6
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    file = engine.save(tmp_path / "single.toml")
    asked = [PROGRAM, "stress", "static", str(file), "--size", "30 mm", "--fillet-elements", "2", *line, "--format", "json"]
    printed = json.loads(subprocess.run(asked, capture_output=True, text=True, encoding="utf-8", check=True).stdout)
    told = [peak["stress"]["von_mises"] for case in printed["cases"] for peak in case["result"]["peaks"] if peak["stress"] is not None]
    np.testing.assert_allclose(peaks, told, rtol=1e-9)
    assert [case.name for case in found.cases] == [case["name"] for case in printed["cases"]]


def test_what_the_crankshaft_does_not_take_is_refused_with_words() -> None:
    single = Engine.template("single").complete()
    wrong: list[tuple[Any, str]] = [
        (lambda: single.stress(force=[(0, "1 kN")], loads="simulation"), "no effect on forces"),
        (lambda: single.stress(force=[(0,)]), "a throw and its forces"),  # type: ignore[list-item]
        (lambda: single.stress(case="first", angle=0.0), "beside `case`"),
        (lambda: single.stress(case="first"), "first"),
        (lambda: single.stress(stiffness="1 kN/mm"), "support=\"springs\""),
        (lambda: single.stress(support="springs"), "needs the stiffness"),
        (lambda: single.stress(support="springs", stiffness=[-1.0]), "0 or more"),
        (lambda: single.stress(ring_modulus="70 GPa"), "support=\"rings\""),
        (lambda: single.strength(torsion=True, torsional_vibration="10 N m"), "leave out one"),
        (lambda: single.strength(memory=1 << 30), "finite elements"),
        (lambda: single.bondgraph(joint_damping=0.1), "compliant joints"),
        (lambda: single.bondgraph(method="implicit"), "that of a run"),
    ]
    for ask, words in wrong:
        with pytest.raises(RequestError) as caught:
            ask()
        assert words in f"{caught.value} {caught.value.hint}", str(caught.value)


def test_a_graph_takes_what_the_command_takes() -> None:
    three = Engine.read(EXAMPLES / "three-cylinder.toml")
    fixed = three.bondgraph(block="fixed")
    assert "block_x" in three.bondgraph().graph and "block_x" not in fixed.graph and "mount" not in fixed.graph
    assert "Gas" in three.bondgraph(block="fixed", gas_states=True).graph
    compliant = three.bondgraph(block="fixed", joints="compliant", skirt_offset="-10 mm", imposed=True)
    assert len(compliant.graph) > len(fixed.graph) and "skirt" in compliant.graph
    loaded = Engine.template("single").bondgraph(load="20 N m", duration="5 ms", method="implicit")
    assert loaded.run is not None and [str(own) for own in loaded.run.methods] == ["implicit"] and "load" in loaded.graph
    rule = Engine.template("in-line-4").complete()
    with_it, without = rule.strength(torsion=True, speed="3000 rpm"), rule.strength(torsion=False, speed="3000 rpm")
    assert with_it.to_text() != without.to_text()


def test_a_reduced_model_is_matrices_that_numpy_and_the_command_line_share(tmp_path: Path) -> None:
    engine = Engine.template("single").complete().with_({"crank.body.pin_fillet": None, "crank.body.journal_fillet": None})
    found = engine.reduced_model(6, size="20 mm", fillet_elements=2)
    model = found.model
    size = 6 * len(model.points) + 6
    assert model.mass.shape == model.stiffness.shape == model.gyroscopic.shape == model.centrifugal.shape == (size, size)
    assert [name for name, _ in model.points] == ["MAIN_1", "MAIN_2", "PIN_1", "FLYWHEEL"] and model.points[0][1].shape == (3,)
    np.testing.assert_allclose(model.mass, model.mass.T, rtol=0, atol=1e-12 * float(np.abs(model.mass).max()))
    np.testing.assert_allclose(model.gyroscopic, -model.gyroscopic.T, rtol=0, atol=1e-12 * float(np.abs(model.gyroscopic).max()))
    # Six rigid motions without stiffness, then the frequencies that the result gives: the matrices are the model, not their transposes or a part.
    squares = np.sort(np.linalg.eigvals(np.linalg.solve(model.mass, model.stiffness)).real)
    hertz = np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi)
    told = np.asarray(found.frequencies)[:, 0]
    assert len(told) > 12
    np.testing.assert_allclose(hertz[6 : 6 + len(told)], told, rtol=1e-6)
    assert hertz[5] < 1e-3 * hertz[6]
    if PROGRAM is None:
        pytest.skip("LANCHESTER_PROGRAM names no program; `cargo xtask python` does")
    file, archive = engine.save(tmp_path / "single.toml"), tmp_path / "single.npz"
    line = [PROGRAM, "stress", "reduce", str(file), "--size", "20 mm", "--fillet-elements", "2", "--modes", "6", "--output", str(archive)]
    subprocess.run(line, capture_output=True, check=True)
    with np.load(archive) as written:
        for name, own in model.matrices().items():
            np.testing.assert_allclose(own, written[name], rtol=1e-7, atol=1e-9 * float(np.abs(written[name]).max()), err_msg=name)


def test_a_graph_without_a_run_says_how_to_get_one_and_its_run_is_drawn() -> None:
    single = Engine.template("single")
    without = single.bondgraph()
    assert without.run is None and without.figures[0].svg.startswith("<svg") and "<svg" in without._repr_html_()
    with pytest.raises(RequestError, match="no run to plot") as caught:
        without.plot()
    assert caught.value.hint is not None and "revolutions" in caught.value.hint
    found = single.bondgraph(duration="10 ms", samples=50, tolerance=1e-8)
    run = found.run
    assert run is not None and run.complete and len(run.time) == 51 and abs(run.time[-1] - 0.01) < 1e-12 and run.audit is None
    assert len(found.figures) > 1 and found.drawing in [picture.svg for picture in found.figures]
    states, powers = found.plot().axes
    series = {own.name: own for own in run.series}
    np.testing.assert_array_equal(states.lines[0].get_ydata(), series["theta"].values)
    assert states.get_ylabel() == f"states [{series['theta'].unit}]" and powers.get_ylabel() == "power [W]"
    np.testing.assert_array_equal(powers.lines[0].get_ydata(), series[f"{powers.lines[0].get_label()}.power"].values)
    with pytest.raises(RequestError, match="`samples` is that of a run"):
        single.bondgraph(samples=10)
    with pytest.raises(RequestError, match="more than one is given"):
        single.bondgraph(revolutions=1, periodic=True)
    with pytest.raises(RequestError, match="`tolerance` is outside"):
        single.bondgraph(revolutions=1, tolerance=0.5)


def test_paths_lead_to_single_values() -> None:
    loads = Engine.template("in-line-4").loads()
    assert loads.pick("total.orders[2].order") == 2.0
    assert loads.pick("total.trace.theta").shape == (720,)
    for wrong, words in [("total.orders.order", "index"), ("total.nothing", "there are"), ("total.orders[99]", "list of")]:
        with pytest.raises(RequestError, match=words):
            loads.pick(wrong)
    with pytest.raises(RequestError, match="no path"):
        loads.pick("total..orders")


def test_tables_go_to_pandas_polars_arrow_and_duckdb() -> None:
    import duckdb
    import polars

    table = Engine.template("in-line-4").loads().table("peaks")
    frame = table.to_dataframe()
    assert list(frame.columns) == table.to_arrow().column_names and len(frame) == len(table)
    assert any("[deg]" in name for name in frame.columns)
    same = polars.DataFrame(table)
    assert same.columns == list(frame.columns) and same.height == len(table)
    np.testing.assert_array_equal(same[:, -1].to_numpy(), frame.iloc[:, -1].to_numpy())
    connection = duckdb.connect()
    connection.register("peaks", table.to_arrow())
    [(count,)] = connection.execute("select count(*) from peaks").fetchall()
    assert count == len(table)
    with pytest.raises(RequestError, match="there is no table"):
        Engine.template("in-line-4").loads().table("nothing")


def test_plots_of_loads_show_rounding_as_nothing() -> None:
    # The sixth order is the first that the throws of a six leave; a twin of throws in line has no couple.
    for name, balanced in (("in-line-6", ("couple",)), ("twin-360", ("couple",)), ("twin-180", ())):
        by_order = dict(zip(("force", "couple"), Engine.template(name).loads().plot().axes, strict=False))
        for what, axes in by_order.items():
            highest = float(axes.dataLim.y1)
            assert (highest == 0.0) == (what in balanced), (name, what, highest)
            assert axes.get_ylim()[0] == 0.0 and axes.get_ylim()[1] >= highest


def test_every_plot_is_drawn(all_results: dict[str, Result], tmp_path: Path) -> None:
    from lanchester import plots

    kinds = {kind for kind in vars(results).values() if isinstance(kind, type) and issubclass(kind, Result) and kind is not Result}
    assert kinds == set(plots._DRAWN) == {type(result) for result in all_results.values()}
    for name, result in all_results.items():
        figure = result.plot()
        figure.savefig(tmp_path / f"{name}.png", dpi=40)
        # A notebook that has not imported pyplot shows it too.
        shown: Any = figure
        assert shown._repr_png_().startswith(b"\x89PNG"), name
        # Of a crankshaft outside the range of the formulas there are words alone.
        assert figure.axes and any(axes.has_data() or axes.texts for axes in figure.axes), name


def test_every_result_has_a_table_or_a_picture(all_results: dict[str, Result]) -> None:
    for name, result in all_results.items():
        assert result.tables or result.figures, name
    for name in ("films", "bondgraph", "modes", "stress", "counterweight"):
        assert all(picture.svg.startswith("<svg") for picture in all_results[name].figures), name
        page = all_results[name]._repr_html_()
        assert all_results[name].figures and ("<svg" in page or "<img" in page) and len(page) < 200_000, (name, len(page))
    for name in ("simulate", "robust_balance", "bondgraph"):
        assert all_results[name].tables, name


def test_tables_have_names_of_their_own_and_go_to_arrow(all_results: dict[str, Result]) -> None:
    for result in all_results.values():
        names = [table.name for table in result.tables]
        assert len(set(names)) == len(names), names
        for table in result.tables:
            assert result.table(table.name).title == table.title
            assert table.to_arrow().num_rows == len(table.to_dataframe()) == len(table), table.name
    assert len(all_results["sensitivity"].tables) > 1
    # Words and numbers in one column.
    mixed = Table("mixed", "Mixed", {"a": ["any", 50.0, None, 0.1]}, {"a": "%"})
    assert mixed.to_arrow().column("a [%]").to_pylist() == ["any", "50", None, "0.1"]
    assert mixed.to_dataframe()["a [%]"][1] == 50.0


def test_series_and_lists_are_tables(all_results: dict[str, Result]) -> None:
    import pyarrow

    loads, run = Engine.template("in-line-4").loads(), Engine.read(EXAMPLES / "generator-set-3.toml").simulate(duration="0.05 s").run
    frame = loads.total.trace.to_dataframe()
    assert frame.columns[0] == "theta [rad]" and len(frame) == len(loads.total.trace.theta)
    np.testing.assert_array_equal(frame["force_x [N]"], loads.total.trace.force_x)
    samples = run.samples.to_table()
    assert list(samples.columns)[:2] == ["time", "theta"] and len(samples) == len(run.samples.time)
    # Given sample by sample: mount, then axis.
    np.testing.assert_array_equal(samples["mounts_2_y"], [own[1, 1] for own in run.samples.mounts])
    assert samples.units["mounts_2_y"] == "N" and samples.units["position_x"] == "m"
    orders = loads.total.orders
    for own in (loads.total.trace, orders, loads):
        table = pyarrow.table(own)
        assert table.num_rows == len(own.to_table()) > 2
    assert "force_forward_re [N]" in pyarrow.table(orders).column_names
    with pytest.raises(RequestError, match="no series"):
        loads.total.peaks.to_table()


def strengthened(body: dict[str, Any]) -> Result:
    return Engine.template("in-line-4").complete().with_({f"crank.body.{key}": value for key, value in body.items()}).strength()


def test_plots_name_outputs_inputs_and_every_checked_place(all_results: dict[str, Result]) -> None:
    scatter = Engine.read(EXAMPLES / "in-line-4-production.toml").scatter(samples=500).plot()
    for axes in scatter.axes:
        assert axes.get_title() in all_results["scatter"].table("scatter")["load"] and "[N" in axes.get_xlabel()
    names = [label.get_text() for label in Engine.template("in-line-4").sensitivity().plot().axes[0].get_yticklabels()]
    assert names[0].startswith("crank radius, ±") and not any("{" in name for name in names)
    left, middle, force, couple = Engine.template("v6-90").loads().plot().axes
    assert force.get_ylabel() == "force [N]" and couple.get_ylabel() == "couple [N m]"
    assert left.get_legend() is None and middle.get_legend() is None
    bored = strengthened({"oil_hole.diameter": "6 mm"})
    places = [label.get_text() for label in bored.plot().axes[0].get_yticklabels()]
    assert "oil bore of pin 1" in places and set(bored.table("strength-safety")["place"]) <= set(places)


def test_a_plot_without_anything_to_draw_says_so() -> None:
    figure = strengthened({"pin_fillet": "0.5 mm", "journal_fillet": "0.5 mm"}).plot()
    assert "outside the range" in figure.axes[0].texts[0].get_text()


def test_results_travel_between_processes(all_results: dict[str, Result]) -> None:
    """By value: what comes out says the same, and gives the same engine."""
    assert copy.deepcopy(all_results["loads"]) is all_results["loads"]
    for name, result in all_results.items():
        again = pickle.loads(pickle.dumps(result))
        assert type(again) is type(result) and again.to_json() == result.to_json(), name
        assert again.to_text() == result.to_text(), name
        assert [own.svg for own in again.figures] == [own.svg for own in result.figures], name
        assert [(own.name, own.units) for own in again.tables] == [(own.name, own.units) for own in result.tables], name
        walk(again, json.loads(result.to_json()), name, set())
        assert pickle.loads(pickle.dumps(again)).to_json() == result.to_json(), name
    loads = pickle.loads(pickle.dumps(all_results["loads"]))
    assert loads.pick("total.orders[2].order") == 2.0 and not loads.total.trace.force_x.flags.writeable
    with pytest.raises(RequestError, match="there is no"):
        loads.pick("total.nothing")
    with pytest.raises(RequestError, match="finds nothing"):
        loads.adopt()
    for name, number in (("balance", None), ("explore", 0), ("explore", len(all_results["explore"].front) - 1)):  # type: ignore[attr-defined]
        again = pickle.loads(pickle.dumps(all_results[name]))
        assert again.adopt(number).text == all_results[name].adopt(number).text, name
    with pytest.raises(RequestError, match="counted from 0"):
        pickle.loads(pickle.dumps(all_results["explore"])).adopt(10_000)


def paths(value: Any, path: str = "") -> Iterator[str]:
    """Every path into a result, of long lists those of both ends."""
    if path:
        yield path
    if isinstance(value, dict):
        for key, below in value.items():
            yield from paths(below, f"{path}.{key}" if path else str(key))
    elif isinstance(value, list):
        for place in sorted({0, 1, len(value) - 1} & set(range(len(value)))):
            yield from paths(value[place], f"{path}[{place}]")


def said(result: Result, path: str) -> tuple[str, Any]:
    """What a path leads to with its type, or why it leads nowhere."""
    try:
        found = result.pick(path)
    except RequestError as error:
        return "refused", (error.message, error.hint)
    return type(found).__name__, plain(found)


def test_paths_lead_to_the_same_out_of_a_pickle(all_results: dict[str, Result]) -> None:
    looked_at = set()
    for name, result in all_results.items():
        again = pickle.loads(pickle.dumps(result))
        # Some dozens of each.
        found = list(paths(json.loads(result.to_json())))
        found = found[:: len(found) // 50 + 1]
        wrong = [f"{path}{more}" for path in found[::7] for more in (".nothing", "[99]", "[0]", "[0].nothing")]
        for path in [*found, *wrong, "", ".", "nothing", "[0]", "total..orders", "a[-1]", "a[+1]", "a[x]", "a[1", "a]b", "a[1]b", "a[\u0661]"]:
            kind, value = said(result, path)
            np.testing.assert_equal(said(again, path), (kind, value), err_msg=f"{name}: {path}")
            looked_at.add(kind)
    assert looked_at >= {"refused", "float", "int", "str", "bool", "ndarray", "dict", "list", "NoneType"}, looked_at
    loads = pickle.loads(pickle.dumps(all_results["loads"]))
    assert type(loads.pick("total.trace.force_x[3]")) is float
    with pytest.raises(RequestError, match=r"there is no \[99\] in a list of 4"):
        loads.pick("cylinders[99]")
    with pytest.raises(RequestError, match="`` is no path"):
        loads.pick("")


def test_choices_that_are_not_there_are_refused_by_their_number(all_results: dict[str, Result], monkeypatch: pytest.MonkeyPatch) -> None:
    search = Engine.template("in-line-3").explore(minimise=["force order 1", "couple order 1"], throw_angles="every 60 deg")
    many = len(search.front)
    assert many > 1
    monkeypatch.setattr("lanchester._kept.MOST_CHOICES", 1)
    short = pickle.loads(pickle.dumps(search))
    monkeypatch.undo()
    whole = pickle.loads(pickle.dumps(search))
    for result in (search, whole, short, pickle.loads(pickle.dumps(short))):
        for number in (-1, many, 99_999, 10**30):
            with pytest.raises(RequestError, match=f"there is no layout {number} on a front of {many}") as caught:
                result.adopt(number)
            assert caught.value.hint
        with pytest.raises(TypeError):
            result.adopt("first")  # type: ignore[arg-type]
        assert result.adopt().text == result.adopt(np.int64(0)).text == search.adopt(0).text  # type: ignore[arg-type]
    with pytest.raises(RequestError, match=f"choice 1 is not kept: a pickle has the first 1 of {many}"):
        short.adopt(1)
    # A balance is one.
    balance = all_results["balance"]
    for result in (balance, pickle.loads(pickle.dumps(balance))):
        for number in (-1, 1, 99_999):
            with pytest.raises(RequestError, match=f"there is no choice {number}: Balance finds one engine"):
                result.adopt(number)
        assert result.adopt(0) == balance.adopt()
    for result in (all_results["loads"], pickle.loads(pickle.dumps(all_results["loads"]))):
        with pytest.raises(RequestError, match="finds nothing"):
            result.adopt(-1)


def test_infeasible_limits_are_an_outcome() -> None:
    found = Engine.template("twin-360").balance(minimise="couple", limit="force = 0.001 N", counterweights="throws")
    assert found.outcome.kind == "infeasible" and found.outcome.reason
    with pytest.raises(RequestError, match="no weights"):
        found.adopt()
    with pytest.raises(RequestError, match="no weights"):
        pickle.loads(pickle.dumps(found)).adopt()


def test_what_is_found_can_be_adopted() -> None:
    weights = Engine.read(EXAMPLES / "in-line-3-counterweights.toml")
    assert weights.counterweight().adopt().counterweight_check().is_kept
    search = Engine.template("in-line-4").explore(minimise=["force order 2"], throw_angles="every 90 deg", even_firing=True)
    assert search.adopt(0).cylinders == 4
    with pytest.raises(RequestError, match="counted from 0"):
        search.adopt(10_000)
    with pytest.raises(RequestError, match="finds nothing"):
        Engine.template("single").loads().adopt()


def test_arrays_look_at_numbers_of_the_result_in_place() -> None:
    """No copy: the array owns nothing, holds what does, and outlives the result that it came from."""
    engine = Engine.template("single")
    trace = engine.loads(samples=720).total.trace
    force = trace.force_x
    wanted = force.tolist()
    assert not force.flags.owndata and not force.flags.writeable
    owner: Any = force.base
    while isinstance(owner, np.ndarray):
        owner = owner.base
    assert type(owner).__name__ == "Numbers"
    assert owner.__array_interface__["data"] == (force.__array_interface__["data"][0], True)
    # Rows are one array with one owner too.
    rows = engine.loads(samples=1).total.orders.column("force_forward")
    assert rows.ndim == 2
    del trace, owner
    gc.collect()
    engine.loads(samples=720)
    assert force.tolist() == wanted
    with pytest.raises(ValueError, match="read-only"):
        force[0] = 1.0
