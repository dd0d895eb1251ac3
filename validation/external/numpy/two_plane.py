"""Influence coefficients and corrections of examples/workshop/two-plane-crank.toml by numpy.linalg.lstsq.

Writes two_plane.json beside this file. Independent of Lanchester: the sheet is read with tomllib, its conventions are
applied here, both least-squares problems are numpy's.
"""

import cmath
import json
import math
import tomllib
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
sheet = tomllib.loads((HERE / "../../../examples/workshop/two-plane-crank.toml").read_text())


def number(text):
    return float(text.split()[0])


assert sheet["rotor"]["phase"] == "lag"
sense = 1.0 if sheet["rotor"]["marks"] == sheet["rotor"]["rotation"] else -1.0
planes = [plane["name"] for plane in sheet["plane"]]
radius = {plane["name"]: number(plane["radius"]) for plane in sheet["plane"]}
sensors = [sensor["name"] for sensor in sheet["sensor"]]
# Sensors and keyphasor all stand at 0 deg, all detectors are rms, all readings velocities [mm/s]; unbalances in g mm.
left = np.zeros(len(planes), complex)
rows, readings = [], []
for run in sheet["run"]:
    during = left.copy()
    for weight in run.get("weights", []):
        amount = number(weight["unbalance"]) if "unbalance" in weight else number(weight["mass"]) * radius[weight["plane"]]
        sign = -1.0 if weight.get("action") == "removed" else 1.0
        u = cmath.rect(sign * amount, sense * math.radians(number(weight["angle"])))
        during[planes.index(weight["plane"])] += u
        if weight["kept"]:
            left[planes.index(weight["plane"])] += u
    rows.append([1.0, *during])
    by_sensor = {r["sensor"]: r for r in run["readings"]}
    readings.append(
        [cmath.rect(number(by_sensor[s]["velocity"]) * math.sqrt(2), -math.radians(number(by_sensor[s]["phase"]))) for s in sensors]
    )

rows, readings = np.array(rows), np.array(readings)
unknowns, _, _, _ = np.linalg.lstsq(rows, readings, rcond=None)
left_over = readings - rows @ unknowns
freedom = len(rows) - rows.shape[1]
influence = unknowns[1:].T
now = unknowns[0] + influence @ left
weights, _, _, _ = np.linalg.lstsq(influence, -now, rcond=None)
unit = influence / np.linalg.norm(influence, axis=0)


def pair(z):
    return [z.real, z.imag]


answer = {
    "tool": f"numpy {np.__version__}",
    "sheet": "examples/workshop/two-plane-crank.toml",
    "influence [mm/s per g mm, peak]": {
        p: {s: pair(influence[j, k]) for j, s in enumerate(sensors)} for k, p in enumerate(planes)
    },
    "scatter [mm/s, rms detector]": {
        s: float(np.sqrt(np.sum(np.abs(left_over[:, j]) ** 2) / freedom) / math.sqrt(2)) for j, s in enumerate(sensors)
    },
    # On the rotor: the sense of the marks.
    "weights [g mm]": {
        p: pair(weights[k] if sense > 0 else weights[k].conjugate()) for k, p in enumerate(planes)
    },
    "condition": float(np.linalg.cond(unit)),
}
(HERE / "two_plane.json").write_text(json.dumps(answer, indent=2) + "\n")
