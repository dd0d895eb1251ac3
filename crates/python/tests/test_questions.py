"""Arguments, errors, Ctrl-C, threads, many engines at once."""

from __future__ import annotations

import inspect
import math
import signal
import subprocess
import sys
import threading
import time
from typing import Any

import numpy as np
import pytest

import lanchester
from lanchester import Engine, EngineFileError, InternalError, RequestError, _native

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
    assert lanchester.map("loads", []) == []


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
