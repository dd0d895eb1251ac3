#!/usr/bin/env python3
"""Checks every row of textbook.json by adding unit vectors, as one does on paper.

A piston on axis b driven by a throw at a pulls with cos n(theta + a - b) along its axis in order n: half a unit vector
turning forward from n (a - b) + b, half a one turning backward from -n (a - b) + b. Couples are z times that, a quarter turn
on. Layouts come from descriptions.py; no dimension, no mass, no kernel.
"""

import json
import pathlib
import sys

import numpy as np
from descriptions import LAYOUTS


def vectors(row):
    """Forward and backward vector of a row's order, in units of F1 or F2 (times the lever)."""
    layout, order = LAYOUTS[row["template"]], row["order"]
    last = max(pin[1] for pin in layout.pins)
    total = np.zeros(2, complex)
    for axis, place, _ in layout.cylinders.values():
        angle, plane, side, *shaft = layout.pins[place]
        shaft = shaft[0] if shaft else 0
        a, b = np.radians(angle + layout.phases[shaft]), np.radians(axis)
        pair = np.array([np.exp(1j * (order * (a - b) + b)), np.exp(1j * (-order * (a - b) + b))]) / 2
        if layout.ratios[shaft] < 0:
            pair = pair[::-1]
        lever = {None: 1, "spacing": 1j * (plane - last / 2), "stagger": 1j * side / 2}[row.get("lever")]
        total += lever * pair
    return total


def main():
    """Prints rows that do not hold."""
    path = pathlib.Path(__file__).with_name("textbook.json")
    rows = json.loads(path.read_text(encoding="utf-8"))["rows"]
    wrong = 0
    for row in rows:
        forward, backward = vectors(row)
        value = {None: abs(forward) + abs(backward), "forward": abs(forward), "backward": abs(backward)}[row.get("part")]
        off = {
            None: 0,
            "forward": abs(backward),
            "backward": abs(forward),
            "along-x": abs(forward - np.conj(backward)),
            "along-y": abs(forward + np.conj(backward)),
        }[row.get("shape")]
        if not (abs(value - row["value"]) <= row.get("half_digit", 1e-12 * max(1, row["value"])) and off < 1e-12):
            print(f"{row['template']}, {row['load']} of order {row['order']}: {row['printed']}, but vectors give {value}, {off}")
            wrong += 1
    print(f"{len(rows)} rows, {wrong} wrong")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
