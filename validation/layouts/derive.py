#!/usr/bin/env python3
"""Independent evidence for the gallery of layouts.

    python3 validation/layouts/derive.py            # write validation/layouts/<template>.json for every template
    python3 validation/layouts/derive.py v8-cross   # only these

Needs Python >= 3.11 and numpy >= 2 on a machine whose long double is wider than double. Reads dimensions and masses
(`dimensions.py`) from crates/file/templates/<template>.toml, the layout itself (throws, banks, planes, firing order) from
`descriptions.py`, and computes by brute force (`mechanics.py`). The Rust test crates/lanchester/tests/gallery.rs
compares what is written here with the closed-form kernels; it needs no Python.
"""

import datetime
import json
import pathlib
import platform
import sys
import tomllib

import numpy as np
from descriptions import LAYOUTS
from dimensions import top_speed
from mechanics import REAL, TURN, Motion, deg, loads, modulus_peak, real_extremes

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATES = HERE.parents[1] / "crates" / "model" / "templates"
EXTRA = HERE / "extra"  # engines that only serve as evidence
HIGHEST_ORDER = 8


def pair(value):
    """A complex number as JSON."""
    return [float(value.real), float(value.imag)]


def two_sided(motion, signal):
    """Coefficients of e^{i n theta} for -8 <= n <= 8, every order that the period has."""
    per_order = motion.machine.revolutions
    spectrum = motion.coefficients(signal)
    return [
        {"order": k / per_order, "value": pair(spectrum[k])}
        for k in range(-HIGHEST_ORDER * per_order, HIGHEST_ORDER * per_order + 1)
    ]


def one_sided(motion, signal):
    """Coefficients c_n of Re(c_n e^{i n theta}) for 0 <= n <= 8: their modulus is the amplitude."""
    per_order = motion.machine.revolutions
    spectrum = motion.coefficients(signal)
    return [
        {"order": k / per_order, "value": pair(spectrum[k] * (2 if k else 1))}
        for k in range(HIGHEST_ORDER * per_order + 1)
    ]


def dead_centres(motion, cylinder):
    """Angles of TDC and BDC [rad] within one revolution of the cylinder's own crank, and the stroke [m]."""
    found = real_extremes(motion, motion.piston_pin[cylinder.number])
    own_turn = TURN / abs(cylinder.pin.ratio)
    (top, tdc), (bottom, bdc) = found["max"], found["min"]
    return {
        "cylinder": cylinder.number,
        "top_dead_centre": float(tdc % own_turn),
        "bottom_dead_centre": float(bdc % own_turn),
        "stroke": float(top - bottom),
        "top": float(top),
    }


def firing(description, centres):
    """Angle after cylinder 1 at which each cylinder fires [deg], and a check that its piston is then at the top.

    The description's order and intervals say when a cylinder should fire; the linkage says where its TDC is.
    Offsets and articulation move a TDC a little away from the even interval.
    """
    if description.firing is None:
        return None
    angle, result = 0.0, []
    tops = {c["cylinder"]: c["top_dead_centre"] for c in centres}
    for number, interval in zip(description.firing, description.intervals(), strict=True):
        after = float(deg(angle)) - (tops[number] - tops[description.firing[0]])
        turn = float(TURN)
        miss = (after + turn / 2) % turn - turn / 2
        assert abs(miss) < np.radians(description.firing_slack), (
            f"{description.template}: cylinder {number} is {np.degrees(miss):.2f} deg from its TDC when it fires"
        )
        result.append({"cylinder": number, "angle_deg": angle})
        angle += interval
    cycle = 720 if description.strokes == 4 else 360
    assert abs(angle - cycle) < 1e-9, f"{description.template}: intervals add up to {angle}"
    return result


def derive(template, document):
    """The evidence for one template."""
    description = LAYOUTS[template]
    machine = description.machine(document)
    speed = top_speed(document["speed"])
    motion = Motion(machine)
    result = loads(motion, speed)
    centres = [dead_centres(motion, c) for c in sorted(machine.cylinders, key=lambda c: c.number)]
    peaks = {}
    for name, signal in (("force", result.force), ("couple", result.couple)):
        peaks[name] = float(modulus_peak(motion, signal)[0])
        for part, axis in ((signal.real, "x"), (signal.imag, "y")):
            found = real_extremes(motion, part)
            peaks[f"{name}_{axis}"] = {k: float(v[0]) for k, v in found.items()}
    for name, signal in (("roll_moment", result.roll_moment), ("shaft_torque", result.torque)):
        peaks[name] = {k: float(v[0]) for k, v in real_extremes(motion, signal).items()}
    return {
        "template": template,
        "layout": description.text,
        "script": "validation/layouts/derive.py",
        "python": platform.python_version(),
        "numpy": np.__version__,
        "date": datetime.date.today().isoformat(),
        "speed": float(speed),
        "strokes": description.strokes,
        "period_revolutions": machine.revolutions,
        "spacing": float(description.spacing(document)),
        "stagger": float(description.stagger(document)),
        "uncancelled": result.uncancelled,
        "force": two_sided(motion, result.force),
        "couple": two_sided(motion, result.couple),
        "roll_moment": one_sided(motion, result.roll_moment),
        "shaft_torque": one_sided(motion, result.torque),
        "peaks": peaks,
        "cylinders": centres,
        "firing_slack_deg": description.firing_slack,
        "firing": firing(description, centres),
    }


def main():
    """Writes the evidence of the templates named on the command line, or of all."""
    assert np.finfo(REAL).eps < 1e-18, "needs an extended long double (x87)"
    files = {path.stem: path for folder in (TEMPLATES, EXTRA) for path in sorted(folder.glob("*.toml"))}
    names = sys.argv[1:] or list(files)
    missing = [name for name in names if name not in LAYOUTS]
    for name in names:
        if name in missing:
            continue
        evidence = derive(name, tomllib.loads(files[name].read_text(encoding="utf-8")))
        target = (EXTRA if files[name].parent == EXTRA else HERE) / f"{name}.json"
        target.write_text(json.dumps(evidence, indent=1) + "\n", encoding="utf-8")
        print(f"{name}: {evidence['layout']}")
    if missing:
        sys.exit(f"no independent description of: {', '.join(missing)}")


if __name__ == "__main__":
    main()
