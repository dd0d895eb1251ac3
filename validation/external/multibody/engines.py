"""Three engines by their numbers, and the closed position of their loops: what both programs start from. SI units, radians."""

import json
import math
from pathlib import Path

import numpy as np

# Gas on every piston: p = peak exp(sharpness (cos(own - shift) - 1)), own: angle since the cylinder fires, one turn a cycle.
GAS = {"peak": 4e6, "sharpness": 6.0, "shift": 0.2}


def rod(length, mass, centre, inertia):
    return {"length": length, "mass": mass, "centre": centre, "inertia": inertia}


def engine(name, speed, load, inertia, throws, cylinders, block):
    return {
        "name": name,
        "speed": speed,
        "load": load,
        "crank_inertia": inertia,
        "throws": throws,
        "cylinders": cylinders,
        "block": block,
    }


def throw(angle, radius, z, unbalance):
    return {"angle": math.radians(angle), "radius": radius, "z": z, "unbalance": unbalance}


def cylinder(own_throw, axis, offset, z, piston, own_rod, bore, firing):
    return {
        "throw": own_throw,
        "axis": math.radians(axis),
        "offset": offset,
        "z": z,
        "piston": piston,
        "rod": own_rod,
        "bore": bore,
        "firing": math.radians(firing),
    }


def engines():
    # The block with its crankshaft, without pistons and rods.
    def block(mass, centre, inertia, products):
        return {"mass": mass, "centre": centre, "inertia": inertia, "products": products}

    big = rod(0.150, 0.52, 0.046, 1.7e-3)
    small = rod(0.128, 0.41, 0.037, 1.05e-3)
    # Its top dead centre, where crankpin and rod lie in one line.
    top = math.degrees(math.asin(0.006 / (0.05 + 0.150)))
    single = engine(
        "single",
        300.0,
        60.0,
        0.12,
        [throw(0, 0.05, 0.01, -0.013)],
        [cylinder(0, 0, 0.006, 0.01, 0.64, big, 0.09, top)],
        block(40.0, [0.03, -0.01, 0.02], [1.1, 0.9, 0.7], [0.02, -0.03, 0.04]),
    )
    boxer = engine(
        "boxer twin",
        420.0,
        120.0,
        0.09,
        [throw(90, 0.04, -0.02, 0.011), throw(-90, 0.04, 0.02, 0.011)],
        [cylinder(0, 90, 0.0, -0.02, 0.51, small, 0.088, 0), cylinder(1, -90, 0.0, 0.02, 0.51, small, 0.088, 0)],
        block(55.0, [0.02, 0.0, 0.01], [1.6, 1.2, 1.4], [0.01, 0.03, -0.02]),
    )
    # Split pins: each pair of a bank angle of 90 deg has throws 30 deg apart, so that it fires evenly.
    throws, cylinders = [], []
    for pair, base in enumerate([0.0, 120.0, 240.0]):
        for bank in range(2):
            angle, axis = base + (-30.0 if bank else 0.0) + 45.0, (-45.0 if bank else 45.0)
            z = 0.1 * (pair - 1) + 0.012 * (2 * bank - 1)
            throws.append(throw(angle, 0.042, z, 0.017))
            cylinders.append(cylinder(2 * pair + bank, axis, 0.0, z, 0.47, big, 0.086, (axis - angle) % 360.0))
    six = engine(
        "V6 with split pins",
        500.0,
        330.0,
        0.2,
        throws,
        cylinders,
        block(140.0, [0.05, 0.01, 0.02], [7.0, 6.0, 4.0], [0.1, -0.2, 0.15]),
    )
    return [single, boxer, six]


def pressure(own):
    return GAS["peak"] * math.exp(GAS["sharpness"] * (math.cos(own - GAS["shift"]) - 1.0))


def gas_forces(given, theta):
    areas = [0.25 * math.pi * own["bore"] ** 2 for own in given["cylinders"]]
    return np.array([area * pressure(theta - own["firing"]) for area, own in zip(areas, given["cylinders"])])


def loop(given, index, theta):
    """Travel of the piston pin along its axis and absolute angle of the rod."""
    own = given["cylinders"][index]
    pin = given["throws"][own["throw"]]
    p = pin["radius"] * np.exp(1j * (pin["angle"] + theta))
    u = np.exp(1j * own["axis"])
    along, across = (p / u).real, (p / u).imag
    length = own["rod"]["length"]
    travel = along + math.sqrt(length**2 - (own["offset"] - across) ** 2)
    reach = u * (travel + 1j * own["offset"]) - p
    return travel, math.atan2(reach.imag, reach.real)


def first_moment(given):
    """SUM U e and SUM U z e of the crankshaft at angle 0."""
    turned = [own["unbalance"] * np.exp(1j * own["angle"]) for own in given["throws"]]
    return sum(turned), sum(u * own["z"] for u, own in zip(turned, given["throws"]))


def write(name, found):
    """One engine a line and one instant a line."""
    engines = found.pop("engines")
    lines = [f'"{key}": {json.dumps(value)}' for key, value in found.items()]
    each = []
    for own in engines:
        parts = []
        for key, value in own.items():
            rows = ",\n".join(json.dumps(row) for row in value) if isinstance(value, list) else json.dumps(value)
            parts.append(f'"{key}": ' + (f"[\n{rows}]" if isinstance(value, list) else rows))
        each.append("{" + ",\n".join(parts) + "}")
    lines.append('"engines": [\n' + ",\n".join(each) + "]")
    (Path(__file__).parent / name).write_text("{" + ",\n".join(lines) + "}\n")
