"""Functional mock-up units, checked and run by FMPy, against the command line's own numbers."""

from __future__ import annotations

import csv
import json
import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

fmpy = pytest.importorskip("fmpy")
validation = pytest.importorskip("fmpy.validation")
interpolate = pytest.importorskip("scipy.interpolate")

EXAMPLES = Path(__file__).parents[3] / "examples"


def lanchester(*arguments: str, folder: Path) -> str:
    program = os.environ.get("LANCHESTER_PROGRAM")
    if program is None:
        pytest.skip("LANCHESTER_PROGRAM names no program")
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def exported(name: str, version: int, folder: Path) -> str:
    return unit_of(EXAMPLES / f"{name}.toml", "loads", version, folder)


def unit_of(engine: Path, model: str, version: int, folder: Path) -> str:
    unit = folder / f"{engine.stem}-{model}-{version}.fmu"
    arguments = ("--model", model, "--fmi", str(version), "--output", str(unit))
    lanchester("export", "fmu", str(engine), *arguments, folder=folder)
    return str(unit)


def run(unit: str, speed: float, gas: bool, angles: int, outputs: list[str], **more: Any) -> Any:
    """Two revolutions."""
    time = 4.0 * np.pi / speed
    return fmpy.simulate_fmu(
        unit,
        start_values={"speed": speed, "gas": gas},
        stop_time=time,
        step_size=time / angles,
        output_interval=time / angles,
        output=outputs,
        **more,
    )


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("name", ["in-line-4-mounts", "v6-60", "single-gas"])
def test_units_are_valid_and_have_the_loads_of_the_closed_form(name: str, version: int, tmp_path: Path) -> None:
    unit = exported(name, version, tmp_path)
    assert validation.validate_fmu(unit) == []
    history = tmp_path / "history.csv"
    speed = 230.0
    lanchester(
        *("export", "history", str(EXAMPLES / f"{name}.toml"), "--speed", f"{speed} rad/s"),
        *("--samples", "180", "--output", str(history)),
        folder=tmp_path,
    )
    with history.open() as file:
        rows = list(csv.DictReader(file))
    columns = {
        "force_x": "shaking_force_x_N",
        "force_y": "shaking_force_y_N",
        "couple_x": "couple_x_Nm",
        "couple_y": "couple_y_Nm",
        "roll_moment": "roll_moment_Nm",
    }
    found = run(unit, speed, False, 360, list(columns))
    ours = {own: np.array([float(row[name]) for row in rows]) for own, name in columns.items()}
    forces = max(float(np.abs(ours[own]).max()) for own in ("force_x", "force_y"))
    for kind in [["force_x", "force_y"], ["couple_x", "couple_y"], ["roll_moment"]]:
        # A couple that is none is rounding of the forces.
        peak = max(1e-3 * forces, *(float(np.abs(ours[own]).max()) for own in kind))
        for own in kind:
            count = min(len(ours[own]), len(found))
            assert count >= 180
            error = float(np.abs(found[own][:count] - ours[own][:count]).max())
            assert error <= 1e-9 * peak, (own, error, peak)


@pytest.mark.parametrize("version", [2, 3])
def test_gas_and_mounts_are_those_of_torque_and_mounts(version: int, tmp_path: Path) -> None:
    unit = exported("in-line-4-mounts", version, tmp_path)
    engine = str(EXAMPLES / "in-line-4-mounts.toml")
    rpm = 2400.0
    speed = rpm * np.pi / 30.0
    outputs = ["torque", "crank_angle"] + [f"mount_{k}_force_{axis}" for k in (1, 2, 3) for axis in "xyz"]
    arguments = ("torque", engine, "--speed", f"{rpm} rpm", "--format", "json")
    torque = json.loads(lanchester(*arguments, folder=tmp_path))["torque"]
    wanted = np.array(torque["gas"]) + np.array(torque["inertia"])
    assert abs(torque["period"] - 4.0 * np.pi) < 1e-12
    found = run(unit, speed, True, len(wanted), outputs)
    error = np.abs(found["torque"][: len(wanted)] - wanted).max()
    assert error <= 1e-9 * np.abs(wanted).max(), error
    mounts = json.loads(lanchester("mounts", engine, "--speeds", f"{rpm} rpm", "--format", "json", folder=tmp_path))
    settled = mounts["response"]["speeds"][0]
    # The history of every component from its orders, f = Re SUM F e^(i n theta).
    for mount, peak in enumerate(settled["peaks"]):
        for place, axis in enumerate("xyz"):
            theirs = found[f"mount_{mount + 1}_force_{axis}"]
            own = sum(
                (complex(*order["forces"][mount][place]) * np.exp(1j * order["order"] * found["crank_angle"])).real
                for order in settled["orders"]
            )
            error = np.abs(theirs - own).max()
            assert error <= 1e-9 * peak["value"], (mount, axis, error)


def test_a_speed_that_changes_turns_the_crank_by_its_integral(tmp_path: Path) -> None:
    unit = exported("v6-60", 2, tmp_path)
    times = np.linspace(0.0, 0.1, 101)
    speeds = 100.0 + 2000.0 * times
    signal = np.array(list(zip(times, speeds)), dtype=[("time", np.float64), ("speed", np.float64)])
    found = fmpy.simulate_fmu(
        unit, stop_time=0.1, step_size=1e-3, output_interval=1e-3, input=signal, output=["crank_angle", "force_y"]
    )
    # The speed is held over a step.
    wanted = np.concatenate([[0.0], np.cumsum(speeds[:-1] * 1e-3)])
    assert np.abs(found["crank_angle"] - wanted).max() < 1e-9


def test_what_cannot_be_is_an_exception_of_the_host(tmp_path: Path) -> None:
    unit = exported("v6-60", 2, tmp_path)
    said: list[str] = []

    def keep(*words: Any) -> None:
        said.append(words[-1].decode() if isinstance(words[-1], bytes) else str(words[-1]))

    for start in ({"speed": -1.0}, {"gas": True}):
        with pytest.raises(Exception):  # noqa: B017, PT011
            fmpy.simulate_fmu(unit, start_values=start, stop_time=0.01, logger=keep)


def generator_set(folder: Path, *replaced: tuple[str, str]) -> Path:
    """The generator set without what runs it: it turns at 1600 rpm on its mounts, against the mean torque of its gas."""
    text = (EXAMPLES / "generator-set-3.toml").read_text().split("# The generator is bolted")[0]
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new)
    engine = folder / "generator.toml"
    engine.write_text(text)
    return engine


def samples(engine: Path, folder: Path, *arguments: str) -> dict[str, Any]:
    """Our own run: its series and its end."""
    run = json.loads(lanchester("simulate", str(engine), "--format", "json", *arguments, folder=folder))["run"]
    return {"end": run["end"], "tolerance": run["tolerances"]["relative"], **run["samples"]}


@pytest.mark.parametrize("version", [2, 3])
def test_the_crank_train_is_our_own_run(version: int, tmp_path: Path) -> None:
    engine = generator_set(tmp_path)
    unit = unit_of(engine, "crank-train", version, tmp_path)
    assert validation.validate_fmu(unit) == []
    end = 0.25
    outputs = ["crank_angle", "speed", "torque_load", "mount_1_force_x", "block_position_x", "block_spin_z"]
    found = fmpy.simulate_fmu(unit, stop_time=end, step_size=1e-3, output_interval=1e-3, output=outputs)
    assert len(found) == 251
    ours = samples(engine, tmp_path, "--for", f"{end} s")
    tolerance = 10.0 * ours["tolerance"]
    last = found[-1]
    assert abs(last["crank_angle"] / ours["end"][1] - 1.0) < tolerance
    assert abs(last["speed"] / ours["end"][2] - 1.0) < tolerance
    assert np.abs(found["torque_load"] / ours["load_torque"][0] - 1.0).max() < 1e-9
    # A cubic spline through samples a degree apart: it misses little of what a block does.
    for name, series in {
        "mount_1_force_x": [mount[0][0] for mount in ours["mounts"]],
        "block_position_x": [place[0] for place in ours["position"]],
        "block_spin_z": [spin[2] for spin in ours["spin"]],
    }.items():
        known = found["time"] <= ours["time"][-1]
        own = interpolate.CubicSpline(ours["time"], series)(found["time"][known])
        assert np.abs(found[name][known] - own).max() < 1e-6 * np.ptp(series), name


def test_events_governor_and_starter_run_within_a_unit(tmp_path: Path) -> None:
    engine = EXAMPLES / "generator-set-3.toml"
    unit = unit_of(engine, "crank-train", 2, tmp_path)
    end = 1.2
    found = fmpy.simulate_fmu(unit, stop_time=end, step_size=2e-3, output_interval=2e-3)
    # From rest a run at the tolerance of the file is itself ten times that off the truth.
    ours = samples(engine, tmp_path, "--for", f"{end} s", "--tolerance", "1e-12")
    assert found["speed"][0] == 0.0
    assert found["torque_starter"][0] > 50.0
    for name, own in (("crank_angle", ours["end"][1]), ("speed", ours["end"][2])):
        assert abs(found[name][-1] / own - 1.0) < 10.0 * 1e-9, name
    assert 0.0 < found["governor"][-1] <= 1.0


def test_a_torque_of_the_host_is_one_of_the_load(tmp_path: Path) -> None:
    engine = generator_set(tmp_path)
    unit = unit_of(engine, "crank-train", 3, tmp_path)
    names = [variable.name for variable in fmpy.read_model_description(unit).modelVariables]
    assert {"load_torque", "fuel", "start_speed"} <= set(names)
    # Times that are steps of the host to the last bit.
    at, end = 0.125, 0.25
    signal = np.array(
        [(0.0, 60.0), (at, 60.0), (at, 20.0), (1.0, 20.0)], dtype=[("time", float), ("load_torque", float)]
    )
    found = fmpy.simulate_fmu(
        unit, stop_time=end, step_size=2.0**-9, output_interval=2.0**-9, input=signal, start_values={"start_angle": 0.4}
    )
    event = ("--start", "0.4 rad", "--load", "60 N m", "--event", f"{at} s: load 20 N m")
    ours = samples(engine, tmp_path, "--for", f"{end} s", *event)
    assert abs(found["speed"][-1] / ours["end"][2] - 1.0) < 10.0 * ours["tolerance"]


def test_a_unit_that_cannot_be_refuses_with_its_reason(tmp_path: Path) -> None:
    engine = generator_set(tmp_path)
    unit = unit_of(engine, "crank-train", 2, tmp_path)
    said: list[str] = []

    def keep(*words: Any) -> None:
        said.append(words[-1].decode() if isinstance(words[-1], bytes) else str(words[-1]))

    for start in ({"load_torque": -1e300}, {"fuel": 2.0}, {"start_speed": -5.0}):
        with pytest.raises(Exception):  # noqa: B017, PT011
            fmpy.simulate_fmu(unit, start_values=start, stop_time=0.01, logger=keep)
    assert any("fuel must be from 0 to 1" in own for own in said), said
    assert any("crank angle" in own for own in said), said


def test_a_state_of_the_crank_train_comes_back_to_the_bit(tmp_path: Path) -> None:
    unit = unit_of(generator_set(tmp_path), "crank-train", 2, tmp_path)
    description = fmpy.read_model_description(unit)
    assert description.coSimulation.canGetAndSetFMUstate
    assert not description.coSimulation.canSerializeFMUstate
    outputs = [variable.valueReference for variable in description.modelVariables if variable.causality == "output"]
    folder = fmpy.extract(unit, unzipdir=tmp_path / "unit")
    fmu = fmpy.fmi2.FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="one",
    )
    fmu.instantiate()
    fmu.setupExperiment(startTime=0.0)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    fmu.doStep(0.0, 0.05)
    state = fmu.getFMUState()

    def go() -> list[float]:
        values: list[float] = []
        for k in range(20):
            fmu.doStep(0.05 + 0.003 * k, 0.003)
            values += fmu.getReal(outputs)
        return values

    first = go()
    fmu.setFMUState(state)
    assert go() == first
    fmu.freeFMUState(state)
    fmu.terminate()
    fmu.freeInstance()


def test_libcosim_runs_a_crank_train_with_a_second_unit(tmp_path: Path) -> None:
    """Its speed goes into the unit of the loads of the same engine, as one would wire them."""
    pytest.importorskip("libcosimpy")
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    engine = generator_set(tmp_path)
    units = {model: unit_of(engine, model, 2, tmp_path) for model in ("crank-train", "loads")}
    reference = {
        model: {own.name: own.valueReference for own in fmpy.read_model_description(unit).modelVariables}
        for model, unit in units.items()
    }
    # Nanoseconds.
    execution = CosimExecution.from_step_size(step_size=1_000_000)
    train, loads = [
        execution.add_local_slave(CosimLocalSlave(fmu_path=unit, instance_name=model.replace("-", "_")))
        for model, unit in units.items()
    ]
    wire = (train, reference["crank-train"]["speed"], loads, reference["loads"]["speed"])
    assert execution.connect_real_variables(*wire) == 0
    observer = CosimObserver.create_last_value()
    assert execution.add_observer(observer)
    assert execution.simulate_until(200_000_000)
    wanted = [reference["crank-train"][name] for name in ("crank_angle", "speed")]
    angle, speed = observer.last_real_values(train, wanted)
    ours = samples(engine, tmp_path, "--for", "0.2 s")
    assert abs(angle / ours["end"][1] - 1.0) < 10.0 * ours["tolerance"]
    assert abs(speed / ours["end"][2] - 1.0) < 10.0 * ours["tolerance"]
    [theirs] = observer.last_real_values(loads, [reference["loads"]["crank_angle"]])
    # It integrates the speed that it is given, held over each step.
    assert abs(theirs - angle) < 0.05, (theirs, angle)
