"""The layouts, as textbooks describe them; every angle below was worked out by hand from the crank star.

Seen from the free end the crank turns from +x to +y, cylinder 1's throw points along +x at theta = 0, cylinder k's
piston is at the top when its throw, at theta + (its direction), lies along its cylinder. So a cylinder on axis b that
fires f degrees after cylinder 1 (axis b1) has its throw at b - b1 - f from throw 1 (whole turns aside).
"""

import numpy as np
from construction import Layout


def in_line(throws, firing, text, **more):
    """One row on +x, each cylinder on its own throw."""
    pins = [(angle, plane, 0) for plane, angle in enumerate(throws)]
    cylinders = {k + 1: (0, k, 0) for k in range(len(throws))}
    return Layout(text, pins, cylinders, firing, **more)


def two_rows_one_pin(banks, throws, firing, text, **more):
    """Two rows on the axes `banks`, two rods on each pin; bank 1 is numbered first, then bank 2."""
    half = len(throws)
    pins = [(angle, plane, 0) for plane, angle in enumerate(throws)]
    cylinders = {}
    for k in range(half):
        cylinders[k + 1] = (banks[0], k, -1)
        cylinders[half + k + 1] = (banks[1], k, 1)
    return Layout(text, pins, cylinders, firing, **more)


def vee(bank, throws, firing, text, **more):
    """A V on shared pins: rows at -bank/2 and +bank/2."""
    return two_rows_one_pin((-bank / 2, bank / 2), throws, firing, text, **more)


def two_pins(banks, pairs, firing, text, alternating=False, **more):
    """Two rows on the axes `banks`, every cylinder on a pin of its own; `pairs`: directions of (bank 1's, bank 2's)."""
    pins, cylinders = [], {}
    for plane, (first, second) in enumerate(pairs):
        pins += [(first, plane, -1), (second, plane, 1)]
        numbers = (2 * plane + 1, 2 * plane + 2) if alternating else (plane + 1, len(pairs) + plane + 1)
        cylinders[numbers[0]] = (banks[0], 2 * plane, -1)
        cylinders[numbers[1]] = (banks[1], 2 * plane + 1, 1)
    return Layout(text, pins, cylinders, firing, **more)


def boxer(throws, firing, text, **more):
    """Opposed cylinders on pins 180 degrees apart; `throws`: direction of bank 1's pin of every pair."""
    return two_pins((0, 180), [(angle, angle + 180) for angle in throws], firing, text, **more)


def radial(count, firing, text, rows=1, articulated=True, **more):
    """Stars of cylinders evenly around the crank, cylinder 1 of each row holding the master rod."""
    throws = more.pop("throws", [0])
    turned = more.pop("turned", [0] * rows)
    pins = [(angle, plane, 0) for plane, angle in enumerate(throws)]
    cylinders, slaves = {}, {}
    for row in range(rows):
        for k in range(count):
            number = row * count + k + 1
            cylinders[number] = (k * 360 / count + turned[row], row, 0)
            if k and articulated:
                # The knuckle pin stands as far from the master rod's line as the cylinder from the master's.
                slaves[number] = (row * count + 1, k * 360 / count)
    return Layout(text, pins, cylinders, firing, slaves=slaves, **more)


def broad_arrow(banks, throws, firing, text, **more):
    """Three rows, three rods on each pin; the rows stand one stagger apart along the crank."""
    rows = len(throws)
    pins = [(angle, plane, 0) for plane, angle in enumerate(throws)]
    cylinders = {}
    for side, axis, first in zip((-2, 0, 2), banks, (1, 1 + rows, 1 + 2 * rows), strict=True):
        for k in range(rows):
            cylinders[first + k] = (axis, k, side)
    return Layout(text, pins, cylinders, firing, **more)


def narrow_vee(bank, firing, text, radius_and_rod, offset, **more):
    """VR: one row of throws, odd cylinders on bank 1, even ones on bank 2, each axis passing the crank on its own side.

    At the top, crank centre, crankpin and piston pin stand in one line r + l long, whose end lies `offset` off the crank
    centre across the cylinder: the throw then leads the cylinder's axis by asin(offset / (r + l)).
    """
    shift = float(np.degrees(np.arcsin(offset / radius_and_rod)))
    tops = {k: (bank / 2 + shift) * (-1 if k % 2 else 1) for k in firing}
    interval = 720 / len(firing)
    fires = {k: interval * place for place, k in enumerate(firing)}
    throws = {k: (tops[k] - tops[1] - fires[k]) % 360 for k in firing}
    pins = [(throws[k], k - 1, 0) for k in sorted(firing)]
    cylinders = {k: (bank / 2 * (-1 if k % 2 else 1), k - 1, 0) for k in sorted(firing)}
    signs = {k: -1 if k % 2 else 1 for k in firing}
    return Layout(text, pins, cylinders, firing, offsets=signs, **more)


def star(count):
    """Firing of a radial row: twice round, past every other cylinder."""
    return [*range(1, count + 1, 2), *range(2, count + 1, 2)]


# In-line crank stars: cylinder k stands at minus its firing angle.
THREE = [0, 240, 120]  # 1-3-2 every 240: f = 0, 480, 240; also two-stroke 1-2-3 every 120: f = 0, 120, 240
FOUR = [0, 180, 180, 0]  # 1-3-4-2 every 180: f = 0, 540, 180, 360
CROSS = [0, 270, 90, 180]  # 1-3-2-4 after 270, 180, 90, 180: f = 0, 450, 270, 540
FIVE = [0, 216, 144, 72, 288]  # 1-2-4-5-3 every 144: f = 0, 144, 576, 288, 432
SIX = [0, 240, 120, 120, 240, 0]  # 1-5-3-6-2-4 every 120: f = 0, 480, 240, 600, 120, 360
EIGHT = [0, 180, 270, 90, 90, 270, 180, 0]  # 1-6-2-5-8-3-7-4 every 90: f = 0, 180, 450, 630, 270, 90, 540, 360

LAYOUTS = {
    "single": in_line([0], [1], "one cylinder"),
    "single-two-shafts": in_line([0], [1], "one cylinder, two shafts at crank speed"),
    "twin-180": in_line([0, 180], [1, 2], "parallel twin, throws opposite: fires after 180 and 540", steps=[180, 540]),
    "twin-270": in_line(
        [0, 90], [1, 2], "parallel twin, throws at right angles: fires after 270 and 450", steps=[270, 450]
    ),
    "twin-360": in_line([0, 0], [1, 2], "parallel twin, pistons abreast: fires every turn"),
    "in-line-2-two-stroke": in_line([0, 180], [1, 2], "two-stroke twin, throws opposite", strokes=2),
    "in-line-3": in_line(THREE, [1, 3, 2], "in-line three, 1-3-2"),
    "in-line-3-shaft": in_line(THREE, [1, 3, 2], "in-line three, 1-3-2, one shaft against the crank"),
    "in-line-3-two-stroke": in_line(THREE, [1, 2, 3], "two-stroke in-line three, 1-2-3", strokes=2),
    "in-line-4": in_line(FOUR, [1, 3, 4, 2], "in-line four, flat crank, 1-3-4-2"),
    "in-line-4-lanchester": in_line(FOUR, [1, 3, 4, 2], "in-line four with two shafts at twice crank speed"),
    "in-line-4-crossplane": in_line(
        CROSS, [1, 3, 2, 4], "in-line four, throws at right angles", steps=[270, 180, 90, 180]
    ),
    "in-line-5": in_line(FIVE, [1, 2, 4, 5, 3], "in-line five, 1-2-4-5-3"),
    "in-line-6": in_line(SIX, [1, 5, 3, 6, 2, 4], "in-line six, 1-5-3-6-2-4"),
    "in-line-8": in_line(EIGHT, [1, 6, 2, 5, 8, 3, 7, 4], "straight eight, 2-4-2 crank, 1-6-2-5-8-3-7-4"),
    # One pin: bank 2 is at the top 45 (90) degrees after bank 1, and fires a turn later than that.
    "v2-45": vee(45, [0], [1, 2], "V-twin, 45 degrees, one pin, fork and blade", steps=[405, 315]),
    "v2-90": vee(90, [0], [1, 2], "V-twin, 90 degrees, one pin", steps=[450, 270]),
    # The pins stand 180 - 2 x 60 degrees apart; bank 2's is behind: top 60 + 60 degrees after bank 1's, plus a turn.
    "v2-60-split": two_pins((-30, 30), [(0, -60)], [1, 2], "V-twin, 60 degrees, pins split by 60", steps=[480, 240]),
    "v4-90": vee(90, [0, 180], [1, 2, 3, 4], "V4, 90 degrees, pins opposite", steps=[180, 270, 180, 90]),
    # 1-4-2-5-3-6 every 120: f = 0, 240, 480 on bank 1, 120, 360, 600 on bank 2, whose pins stand at 60 - f.
    "v6-60": two_pins((-30, 30), [(0, -60), (120, 60), (240, 180)], [1, 4, 2, 5, 3, 6], "V6, 60 degrees, six pins"),
    # 1-4-3-6-2-5 every 120: f = 0, 480, 240 on bank 1, 120, 600, 360 on bank 2, whose pins stand at 90 - f.
    "v6-90": two_pins(
        (-45, 45), [(0, -30), (240, 210), (120, 90)], [1, 4, 3, 6, 2, 5], "V6, 90 degrees, pins split by 30"
    ),
    "v6-90-odd": vee(90, [0, 240, 120], [1, 4, 3, 6, 2, 5], "V6, 90 degrees, three pins", steps=[90, 150] * 3),
    "v6-120": vee(120, [0, 120, 240], [1, 4, 2, 5, 3, 6], "V6, 120 degrees, three pins"),
    # 1-5-4-2-6-3-7-8 every 90: f = 0, 270, 450, 180 on bank 1; 90, 360, 540, 630 on bank 2 at 90 - f: the same pins.
    "v8-crossplane": vee(90, [0, 90, 270, 180], [1, 5, 4, 2, 6, 3, 7, 8], "V8, 90 degrees, throws at right angles"),
    "v8-flat-plane": vee(90, FOUR, [1, 5, 3, 7, 4, 8, 2, 6], "V8, 90 degrees, throws in one plane"),
    # 1-6-5-10-2-7-3-8-4-9 every 72: f = 0, 288, 432, 576, 144 on bank 1; bank 2 is 72 degrees behind on the same pins.
    "v10-72": vee(72, [0, 72, 288, 144, 216], [1, 6, 5, 10, 2, 7, 3, 8, 4, 9], "V10, 72 degrees, five pins"),
    # The same crank; bank 2 is 90 degrees behind, so that f = 90, 234, 378, 522, 666 between the 144s of bank 1.
    "v10-90": vee(
        90, [0, 72, 288, 144, 216], [1, 6, 5, 10, 2, 7, 3, 8, 4, 9], "V10, 90 degrees, five pins", steps=[90, 54] * 5
    ),
    "v12-60": vee(60, SIX, [1, 7, 5, 11, 3, 9, 6, 12, 2, 8, 4, 10], "V12, 60 degrees: two in-line sixes"),
    "v16-45": vee(
        45, EIGHT, [1, 9, 6, 14, 2, 10, 5, 13, 8, 16, 3, 11, 7, 15, 4, 12], "V16, 45 degrees: two straight eights"
    ),
    # Opposed pistons on one pin: 1-9-5-12-3-8-6-10-2-7-4-11 every 60; bank 1 at -f: a six; bank 2 at 180 - f: the same.
    "flat-12": two_rows_one_pin((0, 180), SIX, [1, 9, 5, 12, 3, 8, 6, 10, 2, 7, 4, 11], "flat twelve, 180-degree V"),
    "vr6-15": narrow_vee(
        15, [1, 5, 3, 6, 2, 4], "VR6, 15 degrees, 12.5 mm offset", radius_and_rod=45.15 + 164, offset=12.5
    ),
    "w12-broad-arrow": broad_arrow(
        (-60, 0, 60), FOUR, [1, 5, 9, 3, 7, 11, 4, 8, 12, 2, 6, 10], "W12, three rows at 60 degrees, flat crank"
    ),
    "boxer-2": boxer([0], [1, 2], "boxer twin: pistons meet and part"),
    # 1-3-2-4 with 1, 3 on bank 1 and 2, 4 on bank 2: f = 0, 180 and 360, 540: pins 0, 180 and 180 - f = 180, 0.
    "boxer-4": boxer([0, 180], [1, 3, 2, 4], "boxer four, pistons of a pair opposite", alternating=True),
    # 1-6-2-4-3-5 every 120: f = 0, 240, 480 on bank 1; 360, 600, 120 on bank 2.
    "boxer-6": boxer([0, 120, 240], [1, 6, 2, 4, 3, 5], "boxer six"),
    "radial-3": radial(3, star(3), "radial three, master rod in cylinder 1", firing_slack=12),
    "radial-5": radial(5, star(5), "radial five, master rod in cylinder 1", firing_slack=12),
    "radial-7": radial(7, star(7), "radial seven, master rod in cylinder 1", firing_slack=12),
    "radial-9": radial(9, star(9), "radial nine, master rod in cylinder 1", firing_slack=12),
    # Row 2 half a pitch on and on the opposite throw: its cylinder 7 + k is at the top at (k - 1/2) 360/7 - 180.
    "radial-14": radial(
        7,
        [1, 12, 3, 14, 5, 9, 7, 11, 2, 13, 4, 8, 6, 10],
        "two rows of seven, throws opposite, master rods in cylinders 1 and 8",
        rows=2,
        throws=[0, 180],
        turned=[0, 180 / 7],
        firing_slack=12,
    ),
    # Crank 2 faces crank 1 and turns the same way; its pistons meet the others 11 degrees late.
    "opposed-piston-3": Layout(
        "two cranks turning alike, exhaust 11 degrees ahead, three cylinders with two pistons each",
        pins=[(a, k, 0, shaft) for shaft in (0, 1) for k, a in enumerate(THREE)],
        cylinders={1: (0, 0, 0), 2: (0, 1, 0), 3: (0, 2, 0), 4: (180, 3, 0), 5: (180, 4, 0), 6: (180, 5, 0)},
        firing=[1, 4, 2, 5, 3, 6],
        steps=[0, 120, 0, 120, 0, 120],
        strokes=2,
        phases=(0, 180 - 11),
        ratios=(1, 1),
        firing_slack=11.001,
    ),
    # Cranks geared directly turn against each other; pistons at opposite corners (1 and 4, 2 and 3) move together.
    "square-4": Layout(
        "two opposite-throw twins on cranks turning against each other",
        pins=[(0, 0, 0, 0), (180, 1, 0, 0), (180, 0, 0, 1), (0, 1, 0, 1)],
        cylinders={1: (0, 0, 0), 2: (0, 1, 0), 3: (0, 2, 0), 4: (0, 3, 0)},
        firing=[1, 2, 4, 3],
        phases=(0, 0),
        ratios=(1, -1),
    ),
    # No real engine: see extra/.
    "everything-at-once": vee(
        50, [0, 130], None, "V4 with offsets, articulated rods of true inertia, a shaft at half speed", slaves={3: (1, 47), 4: (2, 47)}
    ),
}
for name, layout in LAYOUTS.items():
    layout.template = name
