"""Dimensions and masses of a template, in SI: the only things taken from it.

Angles of throws, banks and cylinders, firing orders and numbering are *not* read here: they are what the evidence is
about.
"""

import re
from decimal import Decimal
from fractions import Fraction

from mechanics import REAL, TURN, Rod

POUND = Decimal("0.45359237")
OUNCE = POUND / 16
INCH = Decimal("0.0254")
SCALE = {
    "m": 1, "cm": "0.01", "mm": "0.001", "um": "0.000001", "in": INCH, "ft": 12 * INCH, "thou": INCH / 1000,
    "kg": 1, "g": "0.001", "lb": POUND, "oz": OUNCE,
    "kg m": 1, "kg mm": "0.001", "g mm": "0.000001", "g cm": "0.00001", "oz in": OUNCE * INCH, "lb in": POUND * INCH,
    "kg m2": 1, "kg mm2": "0.000001", "kg cm2": "0.0001", "g mm2": "0.000000001", "lb in2": POUND * INCH * INCH,
    "%": "0.01", "": 1, "rad": 1, "rad/s": 1,
}
TURNS = {"deg": REAL(1) / 360, "rpm": REAL(1) / 60, "Hz": REAL(1)}


def quantity(text):
    """A quantity of the file in SI."""
    if isinstance(text, int | float):
        return REAL(str(text))
    number, unit = re.fullmatch(r"\s*([-+0-9.eE]+)\s*(.*?)\s*", text).groups()
    unit = unit.replace("*", " ").replace("·", " ").replace("^2", "2").replace("²", "2")
    if unit in TURNS:
        return REAL(number) * TURNS[unit] * TURN
    return REAL(str(Decimal(number) * Decimal(SCALE[unit])))


def top_speed(value):
    """Speed of crank 1 at which loads are reported: the highest."""
    return quantity(value[-1] if isinstance(value, list) else value)


def ratio(value):
    """Speed ratio of a shaft as a fraction."""
    return Fraction(value)


def radius(table):
    """Crank radius of a [crank] or [[throw]] table, or None."""
    if "radius" in table:
        return quantity(table["radius"])
    return quantity(table["stroke"]) / 2 if "stroke" in table else None


def crank_unbalance(table, r):
    """The crank's own unbalance of one throw [kg m]."""
    if "unbalance" in table:
        return quantity(table["unbalance"])
    webs = 2 * quantity(table.get("web_mass", 0)) * quantity(table.get("web_radius", 0))
    return quantity(table.get("pin_mass", 0)) * r + webs


def rod(table, defaults=None):
    """A connecting rod; a mass rule given in `table` replaces that of `defaults` as a whole."""
    defaults = dict(defaults or {})
    rule = {"mass", "big_end_mass", "small_end_mass", "centre_of_gravity", "inertia"}
    if rule & set(table):
        defaults = {k: v for k, v in defaults.items() if k not in rule}
    table = defaults | dict(table)
    length = quantity(table["length"])
    if "big_end_mass" in table:
        big, small = quantity(table["big_end_mass"]), quantity(table["small_end_mass"])
    else:
        mass = quantity(table["mass"])
        share = quantity(table["centre_of_gravity"]) / length if "centre_of_gravity" in table else REAL(1) / 3
        small = mass * share
        big = mass - small
    inertia = quantity(table["inertia"]) if "inertia" in table else None
    return Rod(length, big, small, inertia)
