"""Arguments, errors, Ctrl-C, threads, many engines at once."""

from __future__ import annotations

import inspect
import math
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import lanchester
from lanchester import Engine, EngineFileError, InternalError, RequestError, Result, WorkshopSheet, _native
from lanchester.engine import _KINDS

FOUR = Engine.template("in-line-4")


def test_texts_with_units_and_numbers_are_the_same() -> None:
    assert FOUR.loads("3000 rpm").to_json() == FOUR.loads(3000 * 2 * np.pi / 60).to_json() == FOUR.loads(np.float64(3000 * 2 * np.pi / 60)).to_json()
    one = FOUR.loads(about=(0.0, 0.0, 0.1))
    assert one.to_json() == FOUR.loads(about=("0 mm", 0, "100 mm")).to_json() == FOUR.loads(about=np.array([0.0, 0.0, 0.1])).to_json()


WRONG: list[tuple[dict[str, Any], str]] = [
    ({"speed": "60 mm"}, "needs a speed, got a length"),
    ({"speed": "3000"}, "speed"),
    ({"speed": -1.0}, "above 0"),
    ({"speed": 0}, "above 0"),
    ({"speed": float("nan")}, "finite"),
    ({"speed": True}, "got `bool`"),
    ({"speed": [1.0]}, "got `list`"),
    ({"orders": 0}, "whole number from 1"),
    ({"orders": 1.5}, "whole number"),
    ({"orders": True}, "whole number"),
    ({"orders": 10**30}, "whole number"),
    ({"about": (1.0, 2.0)}, "three coordinates"),
    ({"about": "0 mm, 0 mm"}, "needs a list"),
    ({"about": 3.0}, "needs a list"),
    ({"series": "powers"}, "power:4:5"),
    ({"series": 3}, "needs a text"),
    ({"grid": 2}, "whole number from 4"),
    ({"samples": -5}, "whole number"),
]


@pytest.mark.parametrize(("options", "words"), WRONG, ids=[str(options) for options, _ in WRONG])
def test_wrong_arguments_are_refused_with_words(options: dict[str, Any], words: str) -> None:
    with pytest.raises(RequestError) as caught:
        FOUR.loads(**options)
    assert words in str(caught.value) and caught.value.hint, str(caught.value)


def test_arguments_that_cannot_be_used_have_a_code() -> None:
    for wrong, code in (({"orders": 1.5}, "Argument"), ({"speed": "60 mm"}, "Argument.Quantity")):
        with pytest.raises(RequestError) as caught:
            FOUR.loads(**wrong)  # type: ignore[arg-type]
        assert caught.value.code == code


def test_ranges_and_lists_may_be_texts() -> None:
    mounted = Engine.read(Path(__file__).parents[3] / "examples" / "in-line-4-mounts.toml")
    spread = mounted.mounts(speeds="1000 rpm .. 3000 rpm by 1000 rpm, 5000 rpm")
    # The values of a range are sums: the last digit may differ.
    np.testing.assert_allclose(spread.response.speeds.column("speed"), np.array([1000, 2000, 3000, 5000]) * np.pi / 30, rtol=1e-14)
    space: dict[str, Any] = {"minimise": "force order 2", "throw_angles": "every 180 deg"}
    one = Engine.template("v6-60").explore(bank_angle="60 deg .. 120 deg by 30 deg", rod_ratio="0.28 .. 0.3 by 0.02", **space)
    other = Engine.template("v6-60").explore(bank_angle=["60 deg", "90 deg", "120 deg"], rod_ratio=[0.28, 0.3], **space)
    assert one.counts.judged == other.counts.judged > 0 and len(one.front) == len(other.front)
    for own, same in zip(one.front, other.front, strict=True):
        np.testing.assert_allclose(own.values, same.values, rtol=1e-9, atol=1e-6)
    with pytest.raises(RequestError, match="needs the step of a range"):
        mounted.mounts(speeds="1000 rpm .. 3000 rpm")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_a_forked_process_computes() -> None:
    script = (
        "import multiprocessing, lanchester\n"
        "four = lanchester.Engine.template('in-line-4')\n"
        "rods = four.variants({'rod.length': [0.13 + 1e-3 * k for k in range(40)]})\n"
        "def mapped(place):\n"
        "    return float(lanchester.map('loads', rods, 'total.peaks.force.max.value', samples=1)['total.peaks.force.max.value'][place])\n"
        "def searched(place):\n"
        "    return four.explore(minimise='force order 2', throw_angles='every 90 deg').counts.judged\n"
        "before = mapped(3), searched(0)\n"
        "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
        "    assert pool.map_async(mapped, [3, 3]).get(timeout=100) == [before[0]] * 2\n"
        "    assert pool.map_async(searched, [0, 1]).get(timeout=100) == [before[1]] * 2\n"
        "assert (mapped(3), searched(0)) == before\n"
        "print('done')\n"
    )
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", script], capture_output=True, text=True, timeout=240, check=False)
    assert done.returncode == 0 and done.stdout == "done\n", done.stderr


def test_errors_of_the_crates_have_a_code() -> None:
    with pytest.raises(RequestError) as caught:
        FOUR.mounts()
    assert "." in caught.value.code and caught.value.message


def test_no_panic_crosses() -> None:
    with pytest.raises(InternalError, match="a panic for the test"):
        _native.panics()
    assert FOUR.loads().engine == FOUR.name


def test_ctrl_c_stops_a_search() -> None:
    script = (
        "import lanchester, signal\n"
        # A shell that puts the tests into the background has their interrupts ignored.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "engine = lanchester.Engine.template('in-line-4').with_(tolerances={'piston_mass': {'plus_minus': '2 g'}})\n"
        "print('ready', flush=True)\n"
        "try:\n"
        "    engine.scatter(samples=10**9)\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted', flush=True)\n"
    )
    process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "ready\n"
    time.sleep(0.7)
    process.send_signal(signal.SIGINT)
    began = time.monotonic()
    out, _ = process.communicate(timeout=60)
    assert out == "interrupted\n" and process.returncode == 0
    assert time.monotonic() - began < 30


def test_other_threads_run_meanwhile() -> None:
    engine = FOUR.with_(tolerances={"piston_mass": {"plus_minus": "2 g"}})
    ticks, done = 0, threading.Event()

    def count() -> None:
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    engine.scatter(samples=200_000)
    seen = ticks
    done.set()
    thread.join()
    assert seen > 2, "the interpreter's lock was held while the search ran"


def test_map_gives_what_single_calls_give() -> None:
    engines = [Engine.template(name) for name in Engine.templates()]
    many = lanchester.map("loads", engines, samples=36)
    for engine, loads in zip(engines, many, strict=True):
        assert loads.to_json() == engine.loads(samples=36).to_json()
    path = "total.peaks.force.max.value"
    picked = lanchester.map("loads", engines, path, samples=36)
    assert picked[path].tolist() == [loads.total.peaks.force.max.value for loads in many]


def test_variants_are_changed_copies() -> None:
    lengths = np.linspace(0.13, 0.17, 7)
    rods = FOUR.variants({"rod.length": lengths, "piston.mass": np.full(7, 0.35)})
    assert len(rods) == 7 and len(rods[2:4]) == 2
    assert rods[3].text == FOUR.with_({"rod.length": float(lengths[3]), "piston.mass": 0.35}).text
    path = "total.peaks.force.max.value"
    found = lanchester.map("loads", rods, [path, "speed"])
    np.testing.assert_array_equal(found[path], [engine.loads().total.peaks.force.max.value for engine in rods])
    assert found["speed"].tolist() == [FOUR.loads().speed] * 7


def test_wrong_maps_say_which_engine() -> None:
    with pytest.raises(EngineFileError, match="engine 1"):
        lanchester.map("loads", FOUR.variants({"rod.length": [0.15, -0.15]}), "speed")
    with pytest.raises(RequestError, match="one value for each"):
        FOUR.variants({"rod.length": [0.15, 0.16], "piston.mass": [0.3]})
    with pytest.raises(RequestError, match="need a key"):
        FOUR.variants({})
    with pytest.raises(RequestError, match="NaN"):
        lanchester.map("loads", FOUR.variants({"rod.length": [0.15, float("nan")]}), "speed")
    with pytest.raises(RequestError, match="no question"):
        lanchester.map("load", [FOUR])
    with pytest.raises(RequestError, match="no argument"):
        lanchester.map("loads", [FOUR], sped=3.0)
    with pytest.raises(RequestError, match="there are"):
        lanchester.map("loads", [FOUR], "total.peaks.nothing")
    for call in (lambda: lanchester.map("loads", FOUR), lambda: lanchester.compare(FOUR)):  # type: ignore[call-overload, arg-type]
        with pytest.raises(RequestError, match="a list of engines is needed"):
            call()
    for call in (lambda: lanchester.map("loads", [FOUR, "v6"]), lambda: lanchester.compare([FOUR, "v6"])):  # type: ignore[list-item]
        with pytest.raises(RequestError, match="got `str` at index 1"):
            call()
    assert lanchester.map("loads", []) == []


def test_map_asks_every_question_about_one_engine() -> None:
    """Every method that answers with a result, whole and as numbers."""
    kinds = {kind.__name__ for kind in Result.__subclasses__()}
    # Those about a workshop sheet have no engine.
    own = {name for name, member in vars(Engine).items() if inspect.isfunction(member) and member.__annotations__.get("return") in kinds}
    assert own - {"explore"} == set(_KINDS) and len(own) > 20
    whole = Engine.template("single").complete()
    pick = {"torsion": "modes[0].frequency", "films": "films[0].orbit.least_film", "strength": "speeds[0].throws[0].radial"}
    for name, path in pick.items():
        single = getattr(whole, name)()
        assert lanchester.map(name, [whole, whole], path)[path].tolist() == [single.pick(path)] * 2
        [again] = lanchester.map(name, [whole])
        assert again.to_json() == single.to_json()


def test_columns_of_variants_are_what_engineers_have() -> None:
    import pandas as pd

    wanted = FOUR.with_({"rod.length": "150 mm"}).text
    for values in (["150 mm"], np.array(["150 mm"]), pd.Series(["150 mm"], index=[7]), (own for own in ["150 mm"])):
        assert FOUR.variants({"rod.length": values})[0].text == wanted
    counts = FOUR.variants({"layout.cylinders": np.array([4, 4])})
    assert [own.text for own in counts] == [FOUR.text] * 2
    assert lanchester.map("loads", counts, "speed")["speed"].shape == (2,)
    gaps = FOUR.variants({"rod.length": np.ma.array([0.15, 0.15], mask=[False, True])})
    assert [own.text for own in gaps] == [FOUR.with_({"rod.length": 0.15}).text, FOUR.text]
    for wrong, words in [("150 mm", "one value for each"), (0.15, "one value for each"), (np.ones((2, 2)), "in one row")]:
        with pytest.raises(RequestError, match=words):
            FOUR.variants({"rod.length": wrong})


def test_indices_count_from_0_in_messages_too() -> None:
    whole = Engine.template("single").complete()
    for call in (
        lambda: lanchester.compare([FOUR, FOUR], reference=2),
        lambda: whole.modes(crankshaft=1),
        lambda: whole.stress(crankshaft=1),
        lambda: whole.strength(crankshaft=1),
    ):
        with pytest.raises(RequestError, match="needs an index from 0 to"):
            call()
    with pytest.raises(RequestError, match="got NaN"):
        whole.simulate(tolerance=math.nan)


SINGLE = Engine.template("single")
V8 = Engine.template("v8-crossplane")
PLANES = {"front": "-180 mm", "rear": "200 mm"}
SHEET = WorkshopSheet.read(Path(__file__).parents[3] / "examples" / "workshop" / "v8-bobweight.toml")


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: SINGLE.workshop(total_share=0.5, bobweight="1 kg"), "`total_share` and `bobweight` both give the balance factor"),
        (lambda: SINGLE.workshop(wet_share=0.5), "`oil` is not given"),
        (lambda: SINGLE.workshop(bobweight="1 mm"), "needs a mass, got a length"),
        (lambda: SINGLE.workshop(reciprocating_share="half"), "reciprocating_share"),
        (lambda: V8.crank_unbalance(planes={"front": 0.0}), "needs two planes, got 1"),
        (lambda: V8.crank_unbalance(planes={"front": 0.1, "rear": "0.1 m"}), "front"),
        (lambda: V8.crank_unbalance(planes={"front": "1 kg", "rear": 0.2}), "needs a length, got a mass"),
        (lambda: V8.crank_unbalance(planes={"front": (0.0, 0.1), "rear": 0.2}), "has no radii here"),  # type: ignore[dict-item]
        (lambda: V8.crank_unbalance(sheet="v8.toml"), "needs a WorkshopSheet, got `str`"),  # type: ignore[arg-type]
        (lambda: V8.crank_unbalance(sheet=SHEET, oil="10 g"), "the pins of the sheet have their own oil"),
        (lambda: V8.crank_unbalance(crankshaft=1), "needs an index from 0 to 0, got 1"),
        (lambda: V8.external_balance({"damper": (0.1, 0.2, 0.3), "flywheel": 0.3}, keep=0.5), "needs z, or z and radius, got 3 values"),  # type: ignore[dict-item]
        (lambda: V8.external_balance(PLANES, keep=1.5), "from 0 to 1, got 1.5"),
        (lambda: FOUR.assign_parts(), "nothing is weighed"),
        (lambda: FOUR.assign_parts(pistons=["400 g"] * 3), "`pistons` needs 4 masses, one for each cylinder, got 3"),
        (lambda: FOUR.assign_parts(pistons=[0.4, 0.4, 0.4, -0.4]), "needs masses above 0, got -0.4"),
        (lambda: SINGLE.stress_cycle(bearings="ball"), 'unknown value "ball" for `bearings`'),
        (lambda: SINGLE.stress_cycle(instants=100), "needs a multiple of 8, got 100"),
        (lambda: SINGLE.stress_cycle(damping=1.0), "from 0 to below 1, got 1"),
        (lambda: SINGLE.stress_cycle(size_factor=0.0), "above 0, got 0"),
        (lambda: SINGLE.stress_cycle(), "[crank.body]"),
        (lambda: SINGLE.reduced_model(501), "whole number from 0 to 500, got 501"),
    ],
)
def test_the_workshop_and_the_crankshaft_refuse_what_they_cannot_use(call: Any, words: str) -> None:
    with pytest.raises(RequestError) as caught:
        call()
    assert words in str(caught.value) and caught.value.hint, str(caught.value)


def test_sheets_are_checked_as_files_are(tmp_path: Path) -> None:
    with pytest.raises(EngineFileError) as caught:
        WorkshopSheet.from_toml('name = "rotor"\n\n[rotor]\nmass = "12 mm"\nweight = "1 kg"\n')
    assert [own.line for own in caught.value.diagnostics] and '"12 mm"' in [own.place for own in caught.value.diagnostics]
    with pytest.raises(RequestError, match="add .*run.* or .*display"):
        WorkshopSheet.from_dict({"name": "rotor"}).correct()
    with pytest.raises(RequestError, match="cannot read"):
        WorkshopSheet.read(tmp_path / "none.toml")
    named = WorkshopSheet.from_toml(SHEET.text)
    assert named != SHEET and named == WorkshopSheet.from_toml(SHEET.text)
    with pytest.raises(RequestError, match="comes from a text without a folder"):
        named.bobweight()
    again = pickle.loads(pickle.dumps(SHEET))
    assert again == SHEET and again.bobweight().to_json() == SHEET.bobweight().to_json()
    # Numbers are SI, texts have their unit.
    rotor = {"mass": 12.0, "centre": 0.18, "supports": [0.0, 0.4], "speed": 6000 * np.pi / 30, "grade": "G 6.3"}
    texts = {**rotor, "mass": "12 kg", "centre": "180 mm", "supports": ["0 mm", "400 mm"], "speed": "6000 rpm"}
    one, other = (WorkshopSheet.from_dict({"name": "crankshaft 12", "rotor": own}).grade() for own in (rotor, texts))
    # 6.3 mm/s over 6000 rpm, times 12 kg.
    assert math.isclose(one.permissible, 12 * 6.3e-3 / (200 * math.pi), rel_tol=1e-12) and math.isclose(one.permissible, other.permissible, rel_tol=1e-12)


def test_a_sheet_gives_the_bobweights_of_a_crank() -> None:
    alone = V8.crank_unbalance(planes=PLANES)
    of_sheet = V8.crank_unbalance(planes=PLANES, sheet=SHEET)
    mass = SHEET.bobweight().bobweights[0].mass
    given = V8.crank_unbalance(planes=PLANES, sheet=SHEET, bobweight=mass)
    assert of_sheet.to_json() != alone.to_json()
    for one, other in zip(of_sheet.throws, given.throws, strict=True):
        np.testing.assert_allclose(one.unbalance, other.unbalance, rtol=0, atol=1e-15)
    assert lanchester.map("crank_unbalance", [V8], sheet=SHEET, planes=PLANES)[0].to_json() == of_sheet.to_json()


def test_sizes_of_elements_without_elements_are_refused() -> None:
    whole = Engine.template("single").complete()
    with pytest.raises(RequestError, match="those of finite elements"):
        whole.strength(size="8 mm")
    with pytest.raises(RequestError, match="those of finite elements"):
        whole.strength(fillet_elements=8)


@pytest.mark.parametrize(
    ("ask", "after"),
    [
        ("lanchester.Engine.template('v6-60').sensitivity(sobol=1_000_000)", 1.5),
        ("lanchester.map('simulate', [lanchester.Engine.template('single').complete()] * 1000, revolutions=200)", 1.5),
        # Once it is meshed and reduced.
        (
            "lanchester.Engine.template('single').complete().with_({'crank.body.pin_fillet': None, 'crank.body.journal_fillet': None})"
            ".stress_cycle(size='30 mm', fillet_elements=2, instants=3600, cycles=1000, rigid_crankshaft=True)",
            6.0,
        ),
        ("lanchester.Engine.template('v8-crossplane').complete().bondgraph(duration='60 s')", 1.5),
    ],
    ids=["shares of the variance", "many runs", "a crank in its bearings", "a run of a bond graph"],
)
@pytest.mark.skipif(sys.platform == "win32", reason="Ctrl-C is another signal there")
def test_what_is_interrupted_does_not_go_on_behind(ask: str, after: float) -> None:
    """Once nobody waits any more the processors are left alone."""
    program = (
        "import lanchester, signal, threading, os, time\n"
        f"threading.Timer({after}, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
        f"try:\n    {ask}\n    print('finished')\nexcept KeyboardInterrupt:\n    print('interrupted')\n"
        "time.sleep(2.0)\nbefore = time.process_time()\ntime.sleep(0.5)\nprint(time.process_time() - before)\nos._exit(0)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=True)
    how, spent = done.stdout.split()
    assert how == "interrupted" and float(spent) < 0.2, done.stdout


def test_files_that_cannot_be_written_say_so(tmp_path: Path) -> None:
    with pytest.raises(RequestError, match="cannot write"):
        FOUR.save(tmp_path / "none" / "four.toml")


def public() -> list[tuple[str, Any]]:
    found: list[tuple[str, Any]] = []
    for name in lanchester.__all__:
        own = getattr(lanchester, name)
        if inspect.isclass(own) or inspect.isfunction(own):
            found.append((name, own))
        if inspect.isclass(own) and own.__module__.startswith("lanchester"):
            for below, member in vars(own).items():
                member = getattr(member, "__func__", member)
                if not below.startswith("_") and (inspect.isfunction(member) or isinstance(member, property)):
                    found.append((f"{name}.{below}", member))
    return found


def test_every_docstring_has_an_example() -> None:
    without = [name for name, own in public() if ">>>" not in (own.__doc__ or "")]
    assert not without, without
    assert len(public()) > 50


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"start": "soon"}, "a start is a crank angle"),
        ({"start": "90 deg, 800 rpm", "speed": "900 rpm"}, "both say the same"),
        ({"start": "90 deg", "start_angle": 0.1}, "both say the same"),
        ({"events": "stop"}, "a moment and what happens"),
        ({"events": ["1 s: misfire 9"]}, "no cylinder 9"),
        ({"points": [(0.0, 0.1)]}, "three coordinates"),
    ],
)
def test_a_run_refuses_what_it_cannot_read(given: dict[str, Any], words: str) -> None:
    with pytest.raises(RequestError, match=words):
        Engine.template("single").simulate(**given)


def test_a_run_starts_where_it_is_told_and_ends_at_its_event() -> None:
    run = Engine.template("single").simulate(start="90 deg, 1200 rpm", events=["540 deg: stop"], imposed=True, gas=False).run
    assert run.outcome.kind == "stopped"
    assert abs(run.samples.theta[0] - math.pi / 2) < 1e-12 and abs(run.samples.theta[-1] - math.pi / 2 - 3 * math.pi) < 1e-9
