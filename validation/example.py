"""Recomputes rows of the reference suite with a slider crank of its own: plain Python, nothing of Lanchester.

    lanchester validate --suite suite.json
    python3 validation/example.py suite.json

It takes the rows whose quantity is a force or couple of pistons, cranks, counterweights and balance shafts, computes each from the engine
in the suite, and compares it with the expected value: a row agrees within its uncertainty, half a unit of the last digit.
Exit status 1: a row does not agree, or there is none to compute.
"""

import json
import math
import sys
from typing import Any, Callable, Dict, List, Optional, Tuple

# Angles of a revolution for true extremes, where a row names no grid.
FINE = 7200

Loads = Tuple[float, float, float, float, float]


def coefficients(ratio: float, orders: int, powers: int) -> Dict[int, float]:
    """Of the acceleration over r w^2, by order: the literature's series in powers of r/l, truncated."""
    series = {
        1: {0: 1.0},
        2: {1: 1.0, 3: 1 / 4, 5: 15 / 128},
        4: {3: -1 / 4, 5: -3 / 16},
        6: {5: 9 / 128},
    }
    return {
        order: sum(factor * ratio**power for power, factor in terms.items() if power <= powers)
        for order, terms in series.items()
        if order <= orders
    }


def towards_crank(angle: float, radius: float, length: float, motion: Dict[str, Any]) -> float:
    """Acceleration of the piston towards the crank over w^2, at an angle of the crank after its top dead centre [m]."""
    if motion["kind"] == "series":
        terms = coefficients(radius / length, motion["orders"], motion["powers"])
        return radius * sum(factor * math.cos(order * angle) for order, factor in terms.items())
    sine, cosine = math.sin(angle), math.cos(angle)
    root = math.sqrt(length**2 - (radius * sine) ** 2)
    # s = r cos(a) + root, differentiated twice.
    return radius * cosine + radius**2 * (cosine**2 - sine**2) / root + radius**4 * (sine * cosine) ** 2 / root**3


def is_simple(engine: Dict[str, Any]) -> bool:
    """Whether its parts are those that this example knows."""
    rods = all(own["rod"]["joint"] == {"kind": "crankpin"} for own in engine["cylinders"])
    centred = all(own["offset"] == 0 and own["pin_offset"] == 0 for own in engine["cylinders"])
    one_crank = len(engine["crankshafts"]) == 1 and engine["crankshafts"][0]["ratio"] == "1"
    return rods and centred and one_crank and engine["rotation"] == "clockwise"


def loads(engine: Dict[str, Any], theta: float, motion: Dict[str, Any]) -> Loads:
    """F_x, F_y, M_x, M_y about the origin, and M_z of the balance shafts alone, at a crank angle."""
    speed = engine["speed"]["highest"]
    force_x = force_y = couple_x = couple_y = roll = 0.0

    def add(size: float, direction: float, x: float, y: float, z: float) -> None:
        nonlocal force_x, force_y, couple_x, couple_y, roll
        along_x, along_y = size * math.cos(direction), size * math.sin(direction)
        force_x += along_x
        force_y += along_y
        couple_x -= z * along_y
        couple_y += z * along_x
        roll += x * along_y - y * along_x

    for throw in engine["throws"]:
        direction = theta + throw["angle"] + throw["unbalance_offset"]
        add(throw["unbalance"] * speed**2, direction, 0, 0, throw["z"])
    for weight in engine["counterweights"]:
        add(weight["unbalance"] * speed**2, theta + weight["angle"], 0, 0, weight["z"])
    for cylinder in engine["cylinders"]:
        throw, rod = engine["throws"][cylinder["throw"]], cylinder["rod"]
        crank = theta + throw["angle"]
        add(rod["big_end_mass"] * throw["radius"] * speed**2, crank, 0, 0, cylinder["z"])
        mass = cylinder["piston_mass"] + rod["small_end_mass"]
        arm = towards_crank(crank - cylinder["angle"], throw["radius"], rod["length"], motion)
        add(mass * arm * speed**2, cylinder["angle"], 0, 0, cylinder["z"])
    for shaft in engine["shafts"]:
        ratio = float(shaft["ratio"])
        for weight in shaft["weights"]:
            size = weight["unbalance"] * (ratio * speed) ** 2
            add(size, ratio * theta + weight["phase"], shaft["x"], shaft["y"], weight["z"])
    return force_x, force_y, couple_x, couple_y, roll


Curve = List[Loads]
LARGEST: Dict[str, Callable[[Curve], float]] = {
    "Fx max": lambda curve: max(abs(own[0]) for own in curve),
    "Fy max": lambda curve: max(abs(own[1]) for own in curve),
    "Fres max": lambda curve: max(math.hypot(own[0], own[1]) for own in curve),
    "dFres": lambda curve: extent([math.hypot(own[0], own[1]) for own in curve]),
    "Mx max": lambda curve: max(abs(own[2]) for own in curve),
    "My max": lambda curve: max(abs(own[3]) for own in curve),
    "Mz max": lambda curve: max(abs(own[4]) for own in curve),
    "Mres max": lambda curve: max(math.hypot(*own[2:]) for own in curve),
    "dMres": lambda curve: extent([math.hypot(*own[2:]) for own in curve]),
    "Fx at 0 deg": lambda curve: curve[0][0],
}


def extent(values: List[float]) -> float:
    """Largest less smallest."""
    return max(values) - min(values)


COMPARED: Dict[str, Callable[[float, float], float]] = {
    "increase": lambda value, reference: 100 * (value / reference - 1),
    "decrease": lambda value, reference: 100 * (1 - value / reference),
    "error": lambda value, reference: 100 * abs(value / reference - 1),
    "ratio": lambda value, reference: 100 * value / reference,
}


class Suite:
    """Engines with the curves that were computed of them."""

    def __init__(self, data: Dict[str, Any]) -> None:
        assert data["format"] == "lanchester reference suite" and data["version"] == 1
        self.data = data
        self.curves: Dict[str, Curve] = {}

    def value(self, key: str, name: str, motion: Dict[str, Any], grid: Optional[int]) -> Optional[float]:
        """A quantity of an engine, in SI; None if it is not among those of this example."""
        engine = self.data["engines"][name]
        if key not in LARGEST or not is_simple(engine):
            return None
        count = grid or FINE
        own = f"{name} {motion} {count}"
        if own not in self.curves:
            angles = [2 * math.pi * step / count for step in range(count)]
            self.curves[own] = [loads(engine, theta, motion) for theta in angles]
        return LARGEST[key](self.curves[own])

    def row(self, row: Dict[str, Any]) -> Optional[float]:
        """Our value of a row in its unit; None if it is not among those of this example."""
        if row["engine"] is None or row["expected"] is None or any(row["about"]):
            return None
        value = self.value(row["key"], row["engine"], row["motion"], row["grid"])
        comparison = row["comparison"]
        if value is not None and comparison is not None:
            reference = self.value(comparison["key"], comparison["engine"], comparison["motion"], row["grid"])
            if reference is None or comparison["as_what"] not in COMPARED:
                return None
            # Nothing over nothing is no change.
            value = 0.0 if abs(reference) < 1e-6 else COMPARED[comparison["as_what"]](value, reference)
        if value is None:
            return None
        return value / float(math.prod(row["divided_by"].values()))


def main() -> int:
    """Compares every row that it can compute."""
    with open(sys.argv[1], encoding="utf-8") as file:
        suite = Suite(json.load(file))
    compared, wrong = 0, 0
    for row in suite.data["rows"]:
        value = suite.row(row)
        if value is None:
            continue
        compared += 1
        expected = row["expected"]
        if abs(value - expected["value"]) > expected["uncertainty"] * (1 + 1e-9):
            wrong += 1
            print(f"{row['id']}: {value:.6g} {row['unit']}, expected {expected['text']}")
    print(f"{compared} of {len(suite.data['rows'])} rows computed, {compared - wrong} agree")
    return 0 if compared > 0 and wrong == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
