#!/usr/bin/env python3
"""Synthetic pressure traces for the twins of Louvigny 2008: python3 derive.py

The thesis (section 5) and the paper of 2009 computed torques and forces with pressures measured on a diesel engine, which they do not
print. This script looks for pressures that give back, at once, what they do print: for each of the four speeds
  - the average torques of the single (Table 27) and of the twins, short stroke (28, 30) and long (29, 31), to their last digit;
  - the variations of energy of the single (27), of the twins in phase (28, 29) and out of phase (30, 31), short and long stroke;
  - the peak of section 5.1: about 180 bar a dozen degrees after top dead centre at 2000 to 4000 rpm, a third less at 1000 rpm;
and at 4000 rpm with the long stroke, as the paper of 2009 prints them for one rod on its crankpin,
  - 65 kN radial at 7 deg, 36 kN tangential at 24 deg, both the largest of their kind, and 45 kN radial at top dead centre.

A trace is a first guess (polytropic compression and expansion, heat by two Wiebe functions, blow-down, gas exchange at two pressures)
times exp(d), d a periodic cubic spline with a knot every six degrees. The knots are found by least squares. Penalties keep the trace one
that a diesel engine might have:
  - compression with an exponent of 1.22 to 1.42, then no heat taken out and no fall before 8 deg, expansion with 1.00 to 1.45;
  - no pressure above the printed peak;
  - blow-down: falling, from 128 to 170 deg after top dead centre;
  - 0.8 to 4.5 bar in the gas exchange.

`python3 derive.py signs` fits the same numbers with the inertia torque left out or turned round, in some of the engines or in all: what
is left then shows which sign the thesis used. Writes pressure-*.csv and misfit.json beside itself; README.md shows the misfits. Needs
numpy and scipy.
"""

import json
import math
import sys
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import least_squares

HERE = Path(__file__).parent
STEP = 0.5  # deg
DEG = np.arange(-360.0, 360.0, STEP)
PSI = np.radians(DEG)
COUNT = len(DEG)
TURN, HALF_TURN = COUNT // 2, COUNT // 4
BORE = 0.0795
AREA = math.pi / 4 * BORE**2
ATMOSPHERE = 101325.0
SHORT = {"stroke": 0.0864, "rod": 0.136, "piston": 0.7172, "rod_mass": 0.7131}
LONG = {"stroke": 0.0955, "rod": 0.144, "piston": 0.7754, "rod_mass": 0.6287}
RATIO = 16.0  # compression ratio, assumed; of the short stroke: pressures are the same in both engines
HEAT_CAPACITY_RATIO = 1.33  # of what is called heat taken out

# rpm: variation of energy [J] of the single, the twin in phase and out of phase with the short stroke, of these twins with the long one.
ENERGIES = {
    1000: (1106.1, 935.8, 1726.7, 1036.2, 1900.4),
    2000: (2405.1, 1968.3, 3684.7, 2185.1, 4047.2),
    3000: (2342.9, 1874.9, 3349.4, 2100.2, 3698.3),
    4000: (2590.4, 1982.0, 3278.5, 2245.6, 3670.8),
}
NAMES = ["single", "twin in phase", "twin out of phase", "twin in phase, long stroke", "twin out of phase, long stroke"]
# Average torque of the twins with the short stroke [N m]: the middle of what the printed digits of single, twins and long stroke leave.
TORQUES = {1000: 71.085, 2000: 160.045, 3000: 145.82, 4000: 128.125}
PEAKS = {1000: 120.0, 2000: 180.0, 3000: 180.0, 4000: 180.0}
PEAK_ANGLE = 12.0

# First guess: intake and exhaust [bar], exponents, heat [J], share, start, length [deg] and shape of the first Wiebe function, start,
# length and shape of the second, exhaust opens and blow-down [deg].
GUESS = {
    1000: [1.1, 1.4, 1.36, 1.30, 900.0, 0.30, -3, 24, 1, 5, 30, 0.5, 138, 15],
    2000: [1.6, 2.0, 1.36, 1.28, 2050.0, 0.35, -6, 30, 1, 4, 60, 0.8, 142, 15],
    3000: [1.8, 2.2, 1.36, 1.28, 1900.0, 0.35, -8, 30, 1, 4, 60, 0.8, 140, 15],
    4000: [1.8, 2.4, 1.36, 1.28, 1750.0, 0.35, -10, 34, 1, 4, 60, 0.8, 138, 15],
}
CLOSED = -140.0  # intake closes [deg]
KNOTS = np.arange(-360.0, 361.0, 6.0)
BEND, SIZE = 10.0, 0.1  # springs on the second differences of the knots and on the knots themselves
PENALTY = 3.0

# The misfits that count as one. At 4000 rpm the forces go before the peak: README.md says why both cannot be.
TORQUE, FORCE = 0.02, 0.2
ENERGY = {1000: 0.1, 2000: 2.0, 3000: 2.0, 4000: 2.0}
BAR = {1000: 1.0, 2000: 1.0, 3000: 1.0, 4000: 8.0}


def motion(engine, psi):
    """Travel and acceleration per radian squared, and the rod's angle, of a centred slider-crank."""
    r, l = engine["stroke"] / 2, engine["rod"]
    s, c = np.sin(psi), np.cos(psi)
    q = np.sqrt(l * l - (r * s) ** 2)
    x = r * c + q
    a = -r * c - r * r * (c * c - s * s) / q - r**4 * s * s * c * c / q**3
    return x, a, np.arcsin(r * s / l)


def series(engine, psi):
    """Acceleration per radian squared as the thesis has it: orders 1, 2 and 4, powers of r/l to the fifth."""
    r = engine["stroke"] / 2
    k = r / engine["rod"]
    second, fourth = k + k**3 / 4 + 15 * k**5 / 128, -(k**3) / 4 - 3 * k**5 / 16
    return -r * (np.cos(psi) + second * np.cos(2 * psi) + fourth * np.cos(4 * psi))


def volume(engine, psi):
    top = engine["stroke"] / 2 + engine["rod"]
    return AREA * (top - motion(engine, psi)[0]) + AREA * engine["stroke"] / (RATIO - 1)


V = volume(SHORT, PSI)


def wiebe(psi_deg, start, duration, m):
    x = np.clip((psi_deg - start) / duration, 0.0, 1.0)
    return (1 - np.exp(-6.908 * x ** (m + 1))) / (1 - math.exp(-6.908))


def first_guess(rpm):
    """Absolute pressure [Pa] at the angles DEG, periodic."""
    p_in, p_ex, n_c, n_e, heat, share, s1, d1, m1, s2, d2, m2, opens, blow = GUESS[rpm]
    p_in, p_ex = p_in * 1e5, p_ex * 1e5
    burned = share * wiebe(DEG, s1, d1, m1) + (1 - share) * wiebe(DEG, s2, d2, m2)
    # The exponent goes from one to the other as the heat is released.
    n = n_c + (n_e - n_c) * burned
    p = np.empty_like(DEG)
    closed = int(round((CLOSED + 360) / STEP))
    opened = int(math.ceil((opens + 360) / STEP))
    p[closed] = p_in
    for i in range(closed, COUNT - 1):
        middle = (n[i] + n[i + 1]) / 2
        half = math.sqrt(V[i] * V[i + 1])
        heated = p[i] * (V[i] / half) ** middle + (middle - 1) * heat * (burned[i + 1] - burned[i]) / half
        p[i + 1] = heated * (half / V[i + 1]) ** middle
    # Blow-down: towards the exhaust pressure, faster as the valve opens.
    after = np.arange(opened, COUNT)
    turned = DEG[after] - opens
    p[after] = p_ex + (p[after] - p_ex) * np.exp(-((turned / blow) ** 2) / (1 + turned / blow))
    # Overlap around the gas-exchange dead centre (-360 and 360), then intake until the valve is closed.
    before = np.arange(0, closed)
    p[before] = p_in
    change = lambda deg: 0.5 * (1 + np.tanh(deg / 8.0))
    p[after] += (p_in - p_ex) * change(DEG[after] - 360)
    p[before] += (p_ex - p_in) * (1 - change(DEG[before] + 360))
    return p


def lever(engine):
    """Torque over pressure with the thesis's lever r sin(theta)."""
    return AREA * engine["stroke"] / 2 * np.sin(PSI)


def inertia_torque(engine, rpm):
    mass = engine["piston"] + engine["rod_mass"] / 3
    return mass * (math.pi / 30 * rpm) ** 2 * series(engine, PSI) * engine["stroke"] / 2 * np.sin(PSI)


def variation(torque):
    """Integral of |T - T_mean| over the samples, and its derivative by each sample.

    Straight lines between the samples, with what Euler and Maclaurin say they miss where the torque crosses its mean: h^2/6 |T'|.
    """
    here = torque - torque.mean()
    there = np.roll(here, -1)
    a, b = np.abs(here), np.abs(there)
    crosses = here * there < 0
    total = np.maximum(a + b, 1e-300)
    area = np.where(crosses, (a * a + b * b) / (2 * total), total / 2)
    by_a = np.where(crosses, (a * a + 2 * a * b - b * b) / (2 * total**2), 0.5)
    by_b = np.where(crosses, (b * b + 2 * a * b - a * a) / (2 * total**2), 0.5)
    slope = np.sign(here) * by_a + np.roll(np.sign(there) * by_b, 1)
    step = math.radians(STEP)
    missed = np.abs(there - here)[crosses].sum() / 6
    return (area.sum() + missed) * step, (slope - slope.mean()) * step


def energies(p, rpm, signs=(1, 1, 1)):
    """The five variations of energy [J] and their derivatives by the pressures; signs of the inertia torque in single, in phase, out of phase."""
    found = []
    for engine in (SHORT, LONG):
        arm, inertia = lever(engine), inertia_torque(engine, rpm)
        alone, together, apart = [(p - ATMOSPHERE) * arm + sign * inertia for sign in signs]
        if engine is SHORT:
            energy, slope = variation(alone)
            found.append((energy, slope * arm))
        energy, slope = variation(together[:TURN] + together[TURN:])
        found.append((energy, np.concatenate([slope, slope]) * arm))
        energy, slope = variation(apart + np.roll(apart, HALF_TURN))
        found.append((energy, (slope + np.roll(slope, -HALF_TURN)) * arm))
    return found


def rod_forces(engine, p, rpm):
    """Radial (towards the crank axis) and tangential force of the rod on its crankpin, its two end masses included [N]; shares of the pressure."""
    omega = math.pi / 30 * rpm
    _, a, beta = motion(engine, PSI)
    along = (p - ATMOSPHERE) * AREA + (engine["piston"] + engine["rod_mass"] / 3) * omega**2 * a
    inward, across = np.cos(PSI + beta) / np.cos(beta), np.sin(PSI + beta) / np.cos(beta)
    radial = along * inward - engine["rod_mass"] * 2 / 3 * engine["stroke"] / 2 * omega**2
    return radial, along * across, inward * AREA, across * AREA


def at(deg):
    return int(round((deg + 360) / STEP))


def unit(index, value=1.0):
    row = np.zeros(COUNT)
    row[index] = value
    return row


def aims(p, rpm, signs):
    """What the sources print: (printed, got, derivative by the pressures, misfit that counts as one)."""
    rows = [(TORQUES[rpm], 2 * np.mean((p - ATMOSPHERE) * lever(SHORT)), 2 * lever(SHORT) / COUNT, TORQUE)]
    rows += [(printed, got, slope, ENERGY[rpm]) for printed, (got, slope) in zip(ENERGIES[rpm], energies(p, rpm, signs))]

    def value_and_slope(values, shares, deg, printed, scale, weight, is_peak):
        i = at(deg)
        rows.append((printed, values[i] / scale, unit(i, shares[i] / scale), weight))
        if is_peak:
            slope = unit(i + 1, shares[i + 1] / scale) - unit(i - 1, shares[i - 1] / scale)
            rows.append((0.0, (values[i + 1] - values[i - 1]) / scale, slope, weight))

    value_and_slope(p, np.ones(COUNT), PEAK_ANGLE, PEAKS[rpm], 1e5, BAR[rpm], True)
    if rpm == 4000:
        radial, tangential, inward, across = rod_forces(LONG, p, rpm)
        value_and_slope(radial, inward, 7, 65.0, 1e3, FORCE, True)
        value_and_slope(tangential, across, 24, 36.0, 1e3, FORCE, True)
        value_and_slope(radial, inward, 0, 45.0, 1e3, FORCE, False)
    return rows


def spline():
    """Values at DEG and second differences by the knots of a periodic cubic spline."""
    count = len(KNOTS) - 1
    each = CubicSpline(KNOTS, np.vstack([np.eye(count), np.eye(count)[:1]]), bc_type="periodic")
    return each(DEG), each(KNOTS[:-1], 2) * (KNOTS[1] - KNOTS[0]) ** 2


VALUES, BENDS = spline()


def central(values):
    return (np.roll(values, -1, 0) - np.roll(values, 1, 0)) / 2


def fit(rpm, signs=(1, 1, 1)):
    """The trace of a speed [Pa]."""
    guess = np.log(first_guess(rpm))
    guess_slope, slopes, volume_slope = central(guess), central(VALUES), central(np.log(V))
    compression, expansion = (DEG > -130) & (DEG < -22), (DEG > 55) & (DEG < 128)
    burning, rising, falling = (DEG >= -22) & (DEG <= 55), (DEG >= -22) & (DEG <= 8), (DEG >= 128) & (DEG <= 170)
    exchange, top = (DEG > 185) | (DEG < -145), (DEG > -25) & (DEG < 45)
    highest = PEAKS[rpm] * 1e5

    def parts(x, scale):
        logarithm = guess + VALUES @ x
        p, slope = np.exp(logarithm), guess_slope + slopes @ x
        rows = aims(p, rpm, signs)
        # Energies first coarsely, then as finely as they are wanted.
        weights = np.array([row[3] * (scale if row[3] in (TORQUE, ENERGY[rpm]) else 1.0) for row in rows])
        misfits = [np.array([got - printed for printed, got, *_ in rows]) / weights]
        derivatives = [(np.array([row[2] for row in rows]) * p / weights[:, None]) @ VALUES]

        def penalty(where, excess, derivative, stiffness):
            over = excess[where] > 0
            misfits.append(np.where(over, excess[where] * stiffness, 0.0))
            derivatives.append(np.where(over[:, None], derivative[where] * stiffness, 0.0))

        stiff = 40 * PENALTY
        penalty(compression, slope + 1.42 * volume_slope, slopes, stiff)
        penalty(compression, -1.22 * volume_slope - slope, -slopes, stiff)
        penalty(expansion, slope + 1.0 * volume_slope, slopes, stiff)
        penalty(expansion, -1.45 * volume_slope - slope, -slopes, stiff)
        penalty(burning, -(HEAT_CAPACITY_RATIO * volume_slope + slope) - 0.002, -slopes, stiff)
        penalty(rising, -slope, -slopes, stiff)
        penalty(falling, slope, slopes, 4 * stiff)
        penalty(exchange, logarithm - math.log(4.5e5), VALUES, 3 * PENALTY)
        penalty(exchange, math.log(0.8e5) - logarithm, -VALUES, 3 * PENALTY)
        penalty(top, (p - highest) / 1e5 - 0.3, p[:, None] * VALUES / 1e5, 0.5 * PENALTY)
        misfits.extend([BEND * (BENDS @ x), SIZE * x])
        derivatives.extend([BEND * BENDS, SIZE * np.eye(len(x))])
        return np.concatenate(misfits), np.vstack(derivatives), p

    x = np.zeros(len(KNOTS) - 1)
    for scale in (10.0, 3.0, 1.0):
        found = least_squares(lambda x: parts(x, scale)[0], x, lambda x: parts(x, scale)[1], max_nfev=150)
        x = found.x
    return parts(x, 1.0)[2]


def peak(values, near):
    """Largest value and its angle, by the parabola through three samples."""
    i = int(np.argmax(np.where(near, values, -np.inf)))
    below, here, above = values[i - 1], values[i], values[i + 1]
    shift = (below - above) / (2 * (below - 2 * here + above))
    return here - (below - above) * shift / 4, DEG[i] + shift * STEP


def figures(p, rpm):
    """What the sources print, from the trace: (name, printed, got)."""
    rows = [("average torque, twins with short stroke [N m]", TORQUES[rpm], 2 * np.mean((p - ATMOSPHERE) * lever(SHORT)))]
    for name, printed, (got, _) in zip(NAMES, ENERGIES[rpm], energies(p, rpm)):
        rows.append((f"variation of energy, {name} [J]", printed, got))
    near = (DEG > -30) & (DEG < 90)
    bar, angle = peak(p / 1e5, near)
    rows += [("peak pressure [bar]", PEAKS[rpm], bar), ("angle of the peak [deg]", PEAK_ANGLE, angle)]
    if rpm == 4000:
        radial, tangential, *_ = rod_forces(LONG, p, rpm)
        force, angle = peak(radial, near)
        push, push_angle = peak(tangential, near)
        rows += [
            ("largest radial rod force, long stroke [kN]", 65.0, force / 1e3),
            ("its angle [deg]", 7.0, angle),
            ("largest tangential rod force, long stroke [kN]", 36.0, push / 1e3),
            ("its angle [deg]", 24.0, push_angle),
            ("radial rod force at top dead centre, long stroke [kN]", 45.0, radial[at(0)] / 1e3),
        ]
    return rows


def compare_signs():
    """The largest misfit of the five energies for the inertia torque as it is, without it, and turned round."""
    for rpm in ENERGIES:
        for signs in [(1, 1, 1), (0, 0, 0), (-1, -1, -1), (1, -1, 1), (1, 1, -1)]:
            p = fit(rpm, signs)
            misfits = [got - printed for printed, (got, _) in zip(ENERGIES[rpm], energies(p, rpm, signs))]
            print(rpm, signs, " ".join(f"{misfit:+7.1f}" for misfit in misfits), f"peak {p.max() / 1e5:.0f} bar", flush=True)


def main():
    misfits = {}
    for rpm in ENERGIES:
        p = fit(rpm)
        print(f"\n{rpm} rpm")
        rows = figures(p, rpm)
        for name, printed, got in rows:
            print(f"  {name:55s} {printed:9.2f} {got:9.2f} {got - printed:+8.2f}", flush=True)
        lines = [
            f"# SYNTHETIC pressure, {rpm} rpm at full load: derived by derive.py, not measured.",
            "# Angle from the firing top dead centre; absolute pressure.",
            "theta [deg],p [bar]",
        ]
        lines += [f"{deg:.1f},{bar:.5f}" for deg, bar in zip(np.append(DEG, 360.0), np.append(p, p[0]) / 1e5)]
        (HERE / f"pressure-{rpm}.csv").write_text("\n".join(lines) + "\n")
        misfits[rpm] = [
            {"quantity": name, "printed": printed, "synthetic": round(float(got), 3)} for name, printed, got in rows
        ]
    (HERE / "misfit.json").write_text(json.dumps(misfits, indent=2) + "\n")


if __name__ == "__main__":
    compare_signs() if sys.argv[1:] == ["signs"] else main()
