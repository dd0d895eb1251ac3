#!/usr/bin/env python3
"""Independent evidence for the optima: the gallery's engines by point masses, the optimum by another solver.

    python3 validation/optima/derive.py            # writes validation/optima/optima.json

Needs what validation/layouts/derive.py needs, and cvxpy with the solver ECOS. The loads come from the second derivation
of the gallery (`../layouts/mechanics.py`: every mass a point on the solved linkage). A free weight at plane z on an axis
x, y, turning at `ratio`, pulls with F = ratio^2 w^2 U e^{i ratio theta}, M = i z F, M_z = x F_y - y F_x. The peak over the
cycle is minimised on the angles found to matter: 360 to begin with, then the highest of a fine grid, until nothing higher
is found.
"""

import datetime
import json
import pathlib
import sys
import tomllib

import cvxpy as cp
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "layouts"))

from derive import TEMPLATES  # noqa: E402
from descriptions import LAYOUTS  # noqa: E402
from dimensions import top_speed  # noqa: E402
from mechanics import Motion, loads  # noqa: E402

FINE = 28800  # angles of a revolution on which the peak is judged
LOADS = ("force", "couple", "roll moment")


def weight(ratio, z, x=0.0, y=0.0, most=None):
    """A free weight."""
    return {"ratio": ratio, "x": x, "y": y, "z": z, "most": most}


def cases():
    """Engine, free weights (in addition to what the template has), what is minimised, limits."""
    one = [weight(1, 0.0)]
    two = [weight(1, -0.1), weight(1, 0.1)]
    shaft = [weight(-1, -0.12, 0.02, 0.09), weight(-1, 0.12, 0.02, 0.09)]
    second = [weight(n, z, 0.0, s * 0.1) for n, s in ((2, 1), (-2, -1)) for z in (-0.1, 0.1)]
    yield "single", one, "force", {}
    yield "single", one, "force", {"roll moment": 60.0}
    yield "single", one + [weight(-1, 0.0, 0.0, 0.1)], "force", {}
    yield "single", [weight(1, 0.0, most=0.002)], "force", {}
    for twin in ("twin-180", "twin-270", "twin-360"):
        yield twin, two, "force", {}
    for twin in ("twin-180", "twin-270"):
        yield twin, two, "couple", {}
    yield "twin-270", two + shaft, "couple", {}
    yield "boxer-2", two, "couple", {}
    yield "v2-45", one, "force", {}
    yield "v2-60-split", two, "couple", {}
    yield "in-line-3", two, "couple", {}
    yield "in-line-3", two + shaft, "couple", {}
    yield "in-line-3", two + second, "couple", {}
    yield "in-line-4", second, "force", {}
    yield "in-line-4", second, "roll moment", {}
    yield "in-line-5", two + shaft, "couple", {}
    yield "v4-90", two, "couple", {}
    yield "v6-60", two + shaft, "couple", {}
    yield "v6-90", two + shaft, "couple", {}
    yield "v6-90-odd", two + shaft + second, "couple", {}
    yield "v8-crossplane", two, "couple", {}
    yield "radial-5", one, "force", {}
    yield "w12-broad-arrow", two + second, "force", {}
    yield "in-line-4", second, "force", {"roll moment": 200.0}
    yield "in-line-4", second, "roll moment", {"force": 1000.0}


def engine(template):
    """Loads of a template on its grid, speed, and angle."""
    document = tomllib.loads((TEMPLATES / f"{template}.toml").read_text(encoding="utf-8"))
    machine = LAYOUTS[template].machine(document)
    speed = float(top_speed(document["speed"]))
    motion = Motion(machine)
    result = loads(motion, speed)
    spectra = {}
    for name, signal in (("force", result.force), ("couple", result.couple), ("roll moment", result.roll_moment)):
        coefficients = np.fft.fft(signal.astype(np.clongdouble)) / motion.count
        order = np.rint(np.fft.fftfreq(motion.count, 1 / motion.count)).astype(int)
        keep = np.abs(coefficients) > 1e-16 * np.abs(signal).max()
        spectra[name] = (order[keep], coefficients[keep].astype(complex))
    assert machine.revolutions == 1
    return spectra, speed


def at(spectrum, theta):
    """A load at these angles from its spectrum."""
    order, value = spectrum
    return np.exp(1j * np.outer(theta, order)) @ value


def columns(weights, speed, theta, load):
    """What each weight of 1 kg m does to the load, by its real and imaginary part: complex, angles x 2 weights."""
    result = []
    for w in weights:
        force = w["ratio"] ** 2 * speed**2 * np.exp(1j * w["ratio"] * theta)
        for part in (1, 1j):
            f = part * force
            result.append({
                "force": f,
                "couple": 1j * w["z"] * f,
                "roll moment": (w["x"] * f.imag - w["y"] * f.real) + 0j,
            }[load])
    return np.stack(result, axis=1)


def solve(spectra, speed, weights, minimise, limits):
    """The smallest peak, with its weights."""
    scale = max(np.abs(at(spectra[minimise], np.arange(720) * np.pi / 360)).max(), 1e-9)
    fine = np.arange(FINE) * 2 * np.pi / FINE
    judged = {load: (at(spectra[load], fine), columns(weights, speed, fine, load)) for load in [minimise, *limits]}
    angles = {load: set(range(0, FINE, FINE // 360)) for load in judged}
    unit = scale / np.abs(judged[minimise][1]).max()
    peak = None
    for _ in range(12):
        u, t = cp.Variable(2 * len(weights)), cp.Variable()
        constraints = []
        for load, (base, matrix) in judged.items():
            rows = sorted(angles[load])
            g0, g = base[rows], matrix[rows] * unit
            most = t * scale if load == minimise else limits[load]
            stacked = cp.vstack([g0.real + g.real @ u, g0.imag + g.imag @ u])
            constraints.append(cp.norm(stacked / scale, axis=0) <= most / scale)
        for k, w in enumerate(weights):
            if w["most"] is not None:
                constraints.append(cp.norm(u[2 * k : 2 * k + 2]) <= w["most"] / unit)
        problem = cp.Problem(cp.Minimize(t), constraints)
        problem.solve(solver=cp.ECOS, abstol=1e-11, reltol=1e-11, feastol=1e-11, max_iters=200)
        if problem.status == "infeasible":
            return None
        bound = problem.value * scale
        done = True
        for load, (base, matrix) in judged.items():
            size = np.abs(base + matrix @ (u.value * unit))
            limit = bound if load == minimise else limits[load]
            hills = (size >= np.roll(size, 1)) & (size >= np.roll(size, -1)) & (size > limit * (1 + 1e-10))
            new = set(np.flatnonzero(hills)) - angles[load]
            done &= not new
            angles[load] |= new
        peak = np.abs(judged[minimise][0] + judged[minimise][1] @ (u.value * unit)).max()
        if done:
            break
    return {"value": float(bound), "peak": float(peak), "unbalances": [
        [float(v) for v in u.value[2 * k : 2 * k + 2] * unit] for k in range(len(weights))]}


def main():
    """Writes every case."""
    known, rows = {}, []
    for template, weights, minimise, limits in cases():
        known.setdefault(template, engine(template))
        spectra, speed = known[template]
        before = float(np.abs(at(spectra[minimise], np.arange(FINE) * 2 * np.pi / FINE)).max())
        found = solve(spectra, speed, weights, minimise, limits)
        rows.append({"template": template, "weights": weights, "minimise": minimise, "limits": limits,
                     "before": before, "found": found})
        print(template, minimise, limits, f"{before:.6g} ->", found and f"{found['value']:.9g} {found['peak']:.9g}")
    document = {
        "script": "validation/optima/derive.py",
        "solver": f"ECOS through cvxpy {cp.__version__}",
        "numpy": np.__version__,
        "date": datetime.date.today().isoformat(),
        "cases": rows,
    }
    (HERE / "optima.json").write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
