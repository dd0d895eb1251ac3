"""Modes and forced vibration of a damped chain and of a geared set by openTorsion: chain.json."""
import json
import platform
from importlib.metadata import version

import numpy as np
import opentorsion as ot

INERTIAS = [0.0045, 0.0025, 0.0081, 0.0079, 0.0080, 0.0083, 0.15]
STIFFNESSES = [2.0e4, 4.2e5, 6.1e5, 6.0e5, 6.2e5, 8.3e5]
RELATIVE = [6.0, 0.4, 0.5, 0.6, 0.5, 0.3]
ABSOLUTE = [0.0, 0.0, 0.8, 0.7, 0.9, 0.8, 0.1]

shafts = [ot.Shaft(i, i + 1, k=k, c=c) for i, (k, c) in enumerate(zip(STIFFNESSES, RELATIVE))]
disks = [ot.Disk(i, I=j, c=c) for i, (j, c) in enumerate(zip(INERTIAS, ABSOLUTE))]
chain = ot.Assembly(shafts, disk_elements=disks)

lam, _ = chain.undamped_modal_analysis()
undamped = sorted(np.sqrt(np.maximum(lam.real, 0.0)))[1:]
wn, wd, ratio = chain.modal_analysis()
damped = sorted((float(d), float(z)) for d, z in zip(wd, ratio) if d > 1.0)

omegas = np.array([200.0, 700.0, 1500.0, 2600.0, 4000.0])
torques = np.zeros((7, len(omegas)), dtype=complex)
for throw in range(2, 6):
    torques[throw] = 100.0 * np.exp(1j * 0.7 * throw * np.arange(1, 6))
angles, _ = chain.ss_response(torques, omegas)

# A pinion of the fifth of the radius: it turns five times as fast.
first = ot.Gear(1, I=0.4, R=100.0)
second = ot.Gear(2, I=0.002, R=20.0, parent=first)
geared = ot.Assembly(
    [ot.Shaft(0, 1, k=3.0e4), ot.Shaft(2, 3, k=900.0)],
    disk_elements=[ot.Disk(0, I=1.5), ot.Disk(3, I=0.012)],
    gear_elements=[first, second],
)
lam, _ = geared.undamped_modal_analysis()
geared_frequencies = sorted(np.sqrt(np.maximum(lam.real, 0.0)))[1:]

with open("chain.json", "w") as out:
    json.dump(
        {
            "program": "openTorsion " + version("opentorsion") + ", NumPy " + np.__version__ + ", Python " + platform.python_version(),
            "inertias": INERTIAS,
            "stiffnesses": STIFFNESSES,
            "relative": RELATIVE,
            "absolute": ABSOLUTE,
            "undamped": [float(w) for w in undamped],
            "damped": [list(pair) for pair in damped],
            "omegas": omegas.tolist(),
            "torques": [[[t.real, t.imag] for t in row] for row in torques.tolist()],
            "angles": [[[q.real, q.imag] for q in row] for row in angles.tolist()],
            "geared": [float(w) for w in geared_frequencies],
        },
        out,
        indent=1,
    )
    out.write("\n")
