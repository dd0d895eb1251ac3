#!/usr/bin/env python3
"""Synthetic pressure traces for the twins of Louvigny 2008: python3 derive.py

The thesis (section 5) and the paper of 2009 computed torques and forces with pressures measured on a diesel engine, which they do not
print. This script looks for pressures that give back, at once, what they do print: for each of the four speeds
  - the average torque and the variation of energy of the single (Table 27) and of the twins in phase (28) and out of phase (30), short stroke;
  - the peak of section 5.1: about 180 bar a dozen degrees after top dead centre at 2000 to 4000 rpm, a third less at 1000 rpm;
and at 4000 rpm with the long stroke, as the paper of 2009 prints them for one rod on its crankpin,
  - 65 kN radial at 7 deg, 36 kN tangential at 24 deg, both the largest of their kind, and 45 kN radial at top dead centre.

Each trace is a compression and an expansion with polytropic exponents, heat by two Wiebe functions, blow-down and a gas exchange at
two pressures. Its parameters are found by least squares, with weak springs that hold them near usual values. Writes pressure-*.csv and
misfit.json beside itself; README.md shows the misfits. Needs numpy and scipy.
"""

import json
import math
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

HERE = Path(__file__).parent
STEP = 0.5  # deg
DEG = np.arange(-360.0, 360.0 + STEP / 2, STEP)
PSI = np.radians(DEG)
BORE = 0.0795
AREA = math.pi / 4 * BORE**2
ATMOSPHERE = 101325.0
SHORT = {"stroke": 0.0864, "rod": 0.136, "piston": 0.7172, "rod_mass": 0.7131}
LONG = {"stroke": 0.0955, "rod": 0.144, "piston": 0.7754, "rod_mass": 0.6287}
RATIO = 16.0  # compression ratio, assumed; of the short stroke: pressures are the same in both engines

# rpm: mean torque [N m], variation of energy [J] of the single, of the twin in phase (one turn) and out of phase (two turns).
TABLES = {
    1000: (35.5, 1106.1, 935.8, 1726.7),
    2000: (80.0, 2405.1, 1968.3, 3684.7),
    3000: (72.9, 2342.9, 1874.9, 3349.4),
    4000: (64.1, 2590.4, 1982.0, 3278.5),
}
PEAKS = {1000: (120.0, 12.0), 2000: (180.0, 12.0), 3000: (180.0, 12.0), 4000: (180.0, 12.0)}


def motion(engine, psi):
    """Travel, velocity and acceleration per radian, and the rod's angle, of a centred slider-crank."""
    r, l = engine["stroke"] / 2, engine["rod"]
    s, c = np.sin(psi), np.cos(psi)
    q = np.sqrt(l * l - (r * s) ** 2)
    x = r * c + q
    v = -r * s - r * r * s * c / q
    a = -r * c - r * r * (c * c - s * s) / q - r**4 * s * s * c * c / q**3
    return x, v, a, np.arcsin(r * s / l)


def volume(engine, psi):
    x = motion(engine, psi)[0]
    top = engine["stroke"] / 2 + engine["rod"]
    return AREA * (top - x) + AREA * engine["stroke"] / (RATIO - 1)


V = volume(SHORT, PSI)


def wiebe(psi_deg, start, duration, m):
    x = np.clip((psi_deg - start) / duration, 0.0, 1.0)
    return (1 - np.exp(-6.908 * x ** (m + 1))) / (1 - math.exp(-6.908))


NAMES = ["intake", "exhaust", "compression", "expansion", "heat", "share", "start1", "length1", "m1", "start2", "length2", "m2", "opens", "blow_down"]
#        bar       bar        -              -            J       -        deg       deg        -     deg       deg        -     deg      deg
USUAL = {
    1000: [1.1, 1.2, 1.35, 1.28, 1000.0, 0.4, -4.0, 22.0, 1.0, 0.0, 60.0, 0.8, 130.0, 15.0],
    2000: [2.0, 2.2, 1.35, 1.28, 2000.0, 0.4, -6.0, 24.0, 1.0, 0.0, 60.0, 0.8, 128.0, 18.0],
    3000: [2.2, 2.6, 1.35, 1.28, 1900.0, 0.4, -8.0, 26.0, 1.0, 0.0, 60.0, 0.8, 124.0, 22.0],
    4000: [2.2, 2.9, 1.35, 1.28, 1800.0, 0.4, -10.0, 30.0, 1.0, 0.0, 60.0, 0.8, 120.0, 26.0],
}
SPRING = [0.5, 0.5, 0.04, 0.06, 500.0, 0.3, 8.0, 15.0, 1.0, 10.0, 30.0, 0.8, 12.0, 10.0]
LOW = [0.7, 0.9, 1.22, 1.15, 200.0, 0.02, -30.0, 5.0, 0.2, -20.0, 15.0, 0.1, 95.0, 4.0]
HIGH = [4.0, 5.0, 1.42, 1.50, 4500.0, 0.98, 12.0, 80.0, 5.0, 40.0, 130.0, 4.0, 150.0, 60.0]
CLOSED = -140.0  # intake closes [deg]


def pressure(parameters):
    """Absolute pressure [Pa] at the angles DEG, periodic."""
    p_in, p_ex, n_c, n_e, heat, share, s1, d1, m1, s2, d2, m2, opens, blow = parameters
    p_in, p_ex = p_in * 1e5, p_ex * 1e5
    burned = share * wiebe(DEG, s1, d1, m1) + (1 - share) * wiebe(DEG, s2, d2, m2)
    # The exponent goes from one to the other as the heat is released.
    n = n_c + (n_e - n_c) * burned
    p = np.empty_like(DEG)
    closed = int(round((CLOSED + 360) / STEP))
    opened = int(math.ceil((opens + 360) / STEP))
    p[closed] = p_in
    for i in range(closed, len(DEG) - 1):
        middle = (n[i] + n[i + 1]) / 2
        half = math.sqrt(V[i] * V[i + 1])
        heated = p[i] * (V[i] / half) ** middle + (middle - 1) * heat * (burned[i + 1] - burned[i]) / half
        p[i + 1] = heated * (half / V[i + 1]) ** middle
    # Blow-down: towards the exhaust pressure, faster as the valve opens.
    after = np.arange(opened, len(DEG))
    turned = DEG[after] - opens
    fallen = np.exp(-((turned / blow) ** 2) / (1 + turned / blow))
    p[after] = p_ex + (p[after] - p_ex) * fallen
    # Overlap around the gas-exchange dead centre (-360 and 360), then intake until the valve is closed.
    before = np.arange(0, closed)
    p[before] = p_in
    change = lambda deg: 0.5 * (1 + np.tanh(deg / 8.0))
    p[after] += (p_in - p_ex) * change(DEG[after] - 360)
    p[before] += (p_ex - p_in) * (1 - change(DEG[before] + 360))
    return p


def torques(engine, p, rpm):
    """Torque with the thesis's lever r sin(theta), gauge pressure and inertia of the oscillating mass."""
    omega = math.pi / 30 * rpm
    mass = engine["piston"] + engine["rod_mass"] / 3
    force = (p - ATMOSPHERE) * AREA + mass * omega**2 * motion(engine, PSI)[2]
    return force * engine["stroke"] / 2 * np.sin(PSI)


def variation(torque, turns):
    """Integral of |T - T_mean| over so many turns; the last sample repeats the first."""
    count = int(round(360 * turns / STEP))
    part = torque[:count]
    return np.sum(np.abs(part - part.mean())) * math.radians(STEP)


def rod_forces(engine, p, rpm):
    """Radial (towards the crank axis) and tangential force of the rod on its crankpin, its two end masses included."""
    omega = math.pi / 30 * rpm
    _, _, a, beta = motion(engine, PSI)
    along = (p - ATMOSPHERE) * AREA + (engine["piston"] + engine["rod_mass"] / 3) * omega**2 * a
    rod = along / np.cos(beta)
    radial = rod * np.cos(PSI + beta) - engine["rod_mass"] * 2 / 3 * engine["stroke"] / 2 * omega**2
    return radial, rod * np.sin(PSI + beta)


def peak(values, deg=DEG):
    """Largest value and its angle, by the parabola through three samples."""
    i = int(np.argmax(values))
    below, here, above = values[i - 1], values[i], values[i + 1]
    shift = (below - above) / (2 * (below - 2 * here + above))
    return here - (below - above) * shift / 4, deg[i] + shift * STEP


def energies(p, rpm):
    """Variations of energy of the single, of the twin in phase over one turn and out of phase over two [J], short stroke."""
    cycle = torques(SHORT, p, rpm)[:-1]
    turn = int(round(360 / STEP))
    together, apart = cycle[:turn] + cycle[turn:], cycle + np.roll(cycle, turn // 2)
    return variation(cycle, 2), variation(together, 1), variation(apart, 2)


def figures(parameters, rpm):
    """What the sources print, from the trace: (name, printed, got, its weight: the misfit that counts as one)."""
    p = pressure(parameters)
    torque = torques(SHORT, p, rpm)
    alone, together, apart = energies(p, rpm)
    mean, single, in_phase, out = TABLES[rpm]
    bar, at = peak(p / 1e5)
    wanted_bar, wanted_at = PEAKS[rpm]
    rows = [
        ("mean torque, single [N m]", mean, torque[:-1].mean(), 0.1),
        ("variation of energy, single [J]", single, alone, 0.002 * single),
        ("variation of energy, twin in phase [J]", in_phase, together, 0.03 * in_phase),
        ("variation of energy, twin out of phase [J]", out, apart, 0.03 * out),
        ("peak pressure [bar]", wanted_bar, bar, 5.0),
        ("angle of the peak [deg]", wanted_at, at, 2.0),
    ]
    if rpm == 4000:
        radial, tangential = rod_forces(LONG, p, rpm)
        near = (DEG > -30) & (DEG < 90)
        force, angle = peak(np.where(near, radial, -1e9))
        push, push_angle = peak(np.where(near, tangential, -1e9))
        rows += [
            ("largest radial rod force, long stroke [kN]", 65.0, force / 1e3, 1.0),
            ("its angle [deg]", 7.0, angle, 1.5),
            ("largest tangential rod force, long stroke [kN]", 36.0, push / 1e3, 1.0),
            ("its angle [deg]", 24.0, push_angle, 1.5),
            ("radial rod force at top dead centre, long stroke [kN]", 45.0, float(np.interp(0, DEG, radial)) / 1e3, 1.0),
        ]
    return rows


def fit(rpm):
    usual = np.array(USUAL[rpm])

    def residuals(parameters):
        rows = figures(parameters, rpm)
        misfit = [(got - printed) / tolerance for _, printed, got, tolerance in rows]
        springs = 0.1 * (parameters - usual) / np.array(SPRING)
        return np.concatenate([misfit, springs])

    best = None
    random = np.random.default_rng(rpm)
    for attempt in range(16 if rpm == 4000 else 6):
        start = usual if attempt == 0 else usual + 1.0 * np.array(SPRING) * random.standard_normal(len(usual))
        start = np.clip(start, np.array(LOW) + 1e-6, np.array(HIGH) - 1e-6)
        found = least_squares(residuals, start, bounds=(LOW, HIGH), x_scale=SPRING, max_nfev=120)
        if best is None or found.cost < best.cost:
            best = found
    return best


def main():
    misfits = {}
    for rpm in TABLES:
        found = fit(rpm)
        rows = figures(found.x, rpm)
        print(f"\n{rpm} rpm, cost {found.cost:.3g}")
        for name, value in zip(NAMES, found.x):
            print(f"    {name:12s} {value:10.4f}")
        for name, printed, got, _ in rows:
            print(f"  {name:55s} {printed:9.2f} {got:9.2f} {got - printed:+8.2f}")
        p = pressure(found.x) / 1e5
        lines = [
            f"# SYNTHETIC pressure, {rpm} rpm at full load: derived by derive.py, not measured.",
            "# Angle from the firing top dead centre; absolute pressure.",
            "theta [deg],p [bar]",
        ]
        # The last sample repeats the first.
        p[-1] = p[0] = (p[0] + p[-1]) / 2
        lines += [f"{deg:.1f},{bar:.5f}" for deg, bar in zip(DEG, p)]
        (HERE / f"pressure-{rpm}.csv").write_text("\n".join(lines) + "\n")
        misfits[rpm] = {
            "parameters": {name: round(float(value), 6) for name, value in zip(NAMES, found.x)},
            "figures": [
                {"quantity": name, "printed": printed, "synthetic": round(float(got), 3)}
                for name, printed, got, _ in rows
            ],
        }
    (HERE / "misfit.json").write_text(json.dumps(misfits, indent=2) + "\n")


if __name__ == "__main__":
    main()
