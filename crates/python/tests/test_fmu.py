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

EXAMPLES = Path(__file__).parents[3] / "examples"


def lanchester(*arguments: str, folder: Path) -> str:
    program = os.environ.get("LANCHESTER_PROGRAM")
    if program is None:
        pytest.skip("LANCHESTER_PROGRAM names no program")
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def exported(name: str, version: int, folder: Path) -> str:
    unit = folder / f"{name}-{version}.fmu"
    engine = EXAMPLES / f"{name}.toml"
    lanchester("export", "fmu", str(engine), "--fmi", str(version), "--output", str(unit), folder=folder)
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
    peaks = mounts["response"]["speeds"][0]["peaks"]
    for number, peak in enumerate(peaks, 1):
        size = np.sqrt(sum(found[f"mount_{number}_force_{axis}"] ** 2 for axis in "xyz"))
        # Samples every degree lie a little beside the peak, and never above it.
        assert size.max() <= peak["value"] * (1 + 1e-9)
        assert size.max() >= peak["value"] * (1 - 2e-3)


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
