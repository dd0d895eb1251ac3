"""From a layout described in words of the textbook to a machine of point masses."""

from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm

import dimensions as dim
from mechanics import REAL, Cylinder, Machine, Pin, Weight, deg


@dataclass
class Layout:
    """What the textbooks say of a layout.

    `pins`: (direction at theta = 0 [deg], plane counted along the crank from 0, side) and optionally the crankshaft;
    side -1, 0 or +1 moves the pin by half the banks' stagger. `cylinders`: number -> (axis [deg], index of its pin, side).
    """

    text: str
    pins: list
    cylinders: dict
    firing: list | None = None
    steps: list | None = None  # firing intervals [deg], from each cylinder of `firing` to the next; None: even
    strokes: int = 4
    firing_slack: float = 1e-6  # how far [deg] a firing may lie from the TDC that offsets or articulation shift
    offsets: dict = field(default_factory=dict)  # number -> sign of the template's bank offset
    slaves: dict = field(default_factory=dict)  # number -> (master's number, knuckle angle from the master rod [deg])
    ratios: tuple = (1,)  # of the crankshafts
    phases: tuple = (0,)  # of the crankshafts at theta = 0 [deg]
    template: str = ""

    def intervals(self):
        """Firing intervals in degrees."""
        cycle = 720 if self.strokes == 4 else 360
        return self.steps or [cycle / len(self.firing)] * len(self.firing)

    def spacing(self, document):
        """Distance between neighbouring planes [m]; 0 where the template has but one."""
        layout = document.get("layout", {})
        for key in ("spacing", "row_spacing"):
            if key in layout:
                return dim.quantity(layout[key])
        planes = self.planes(document)
        return planes[1] - planes[0] if len(planes) > 1 else REAL(0)

    def stagger(self, document):
        """Distance along the crank between the banks [m]."""
        return dim.quantity(document.get("layout", {}).get("bank_stagger", 0))

    def planes(self, document):
        """z of every plane [m], from the middle of the crankshaft."""
        layout = document.get("layout", {})
        count = 1 + max(pin[1] for pin in self.pins)
        if "positions" in layout:
            given = [dim.quantity(z) for z in layout["positions"]]
        elif "layout" in document:
            pitch = self.spacing(document) if count > 1 else REAL(0)
            given = [pitch * k for k in range(count)]
        else:
            # General form: the planes are the distinct z of the throws, rising.
            given = sorted({dim.quantity(throw["z"]) for throw in document["throw"]})
        assert len(given) == count, f"{self.template}: {count} planes expected, {len(given)} given"
        middle = (given[0] + given[-1]) / 2
        return [z - middle for z in given]

    def machine(self, document):
        """All moving parts with the template's dimensions and masses."""
        planes, half = self.planes(document), self.stagger(document) / 2
        crank = document.get("crank", {})
        shafts = document.get("crankshaft", [{}])
        pins = []
        for angle, plane, side, *rest in self.pins:
            shaft = rest[0] if rest else 0
            r = dim.radius(crank)
            table = shafts[shaft]
            pins.append(
                Pin(
                    angle=deg(angle),
                    z=planes[plane] + side * half,
                    radius=r,
                    unbalance=dim.crank_unbalance(crank, r),
                    ratio=REAL(Fraction(self.ratios[shaft]).numerator) / Fraction(self.ratios[shaft]).denominator,
                    phase=deg(self.phases[shaft]),
                    axis=dim.quantity(table.get("x", 0)) + 1j * dim.quantity(table.get("y", 0)),
                )
            )
        cylinders = [
            self.cylinder(document, number, pins[pin], REAL(axis), planes[self.pins[pin][1]] + side * half)
            for number, (axis, pin, side) in self.cylinders.items()
        ]
        weights = counterweights(document, pins, cylinders) + shaft_weights(document)
        denominators = [Fraction(r).denominator for r in self.ratios]
        denominators += [dim.ratio(shaft["ratio"]).denominator for shaft in document.get("shaft", [])]
        return Machine(cylinders, pins, weights, lcm(*denominators))

    def cylinder(self, document, number, pin, axis, z):
        """One cylinder with the template's masses; what the template says of this one cylinder goes first."""
        own = next((c for c in document.get("cylinder", []) if c.get("number") == number), {})
        common = document.get("piston", {})
        piston = common | own.get("piston", {})
        knuckle, rod_table = None, document["rod"]
        if number in self.slaves:
            master, angle = self.slaves[number]
            rod_table = document["rod"] | document.get("articulated_rod", {})
            if "articulated_rod" in document:
                rod = dim.rod(document["articulated_rod"], document["rod"])
            where = document.get("layout", {}) | document.get("articulated_rod", {})
            knuckle = (master, dim.quantity(where["knuckle_radius"]), deg(angle))
        else:
            rod = dim.rod(rod_table)
        if "rod" in own:
            rod = dim.rod(own["rod"], rod_table)
        offset = own.get("offset", document.get("cylinders", {}).get("offset", 0))
        if number in self.offsets:
            offset = dim.quantity(document["layout"]["bank_offset"]) * self.offsets[number]
        return Cylinder(
            number=number,
            pin=pin,
            angle=deg(axis),
            z=z,
            piston=dim.quantity(piston["mass"]),
            rod=rod,
            offset=dim.quantity(offset) if not isinstance(offset, REAL) else offset,
            pin_offset=dim.quantity(own.get("pin_offset", piston.get("pin_offset", 0))),
            knuckle=knuckle,
        )


def counterweights(document, pins, cylinders):
    """Weights on the crank: shares of each throw's masses, and single ones."""
    crank = document.get("crank", {})
    result = []
    if "counterweights" in document:
        table = document["counterweights"]
        rotating = dim.quantity(table.get("rotating_share", 0))
        reciprocating = dim.quantity(table.get("reciprocating_share", 0))
        for pin in pins:
            mine = [c for c in cylinders if c.pin is pin]
            turning = pin.unbalance + pin.radius * sum(c.rod.big_end for c in mine)
            moving = pin.radius * sum(c.piston + c.rod.small_end for c in mine)
            amount = rotating * turning + reciprocating * moving
            if table.get("at", "throws") == "webs":
                half = dim.quantity(crank["web_distance"]) / 2
                result += [opposite(pin, amount / 2, pin.z - half), opposite(pin, amount / 2, pin.z + half)]
            else:
                result.append(opposite(pin, amount, pin.z))
    for table in document.get("counterweight", []):
        result.append(single_counterweight(table, crank, pins, document))
    return result


def opposite(pin, amount, z, angle=deg(180)):
    """A weight at an angle from a throw."""
    return Weight(amount, z, pin.phase + pin.angle + angle, pin.ratio, pin.axis)


def unbalance(table):
    """Mass times radius."""
    if "unbalance" in table:
        return dim.quantity(table["unbalance"])
    return dim.quantity(table["mass"]) * dim.quantity(table["radius"])


def single_counterweight(table, crank, pins, document):
    """One [[counterweight]]."""
    amount = unbalance(table)
    if "throw" in table or "web" in table:
        angle = dim.quantity(table.get("angle", "180 deg"))
        if "throw" in table:
            pin = pins[table["throw"] - 1]
            return opposite(pin, amount, pin.z, angle)
        pin = pins[(table["web"] - 1) // 2]
        half = dim.quantity(crank["web_distance"]) / 2
        return opposite(pin, amount, pin.z + (half if table["web"] % 2 == 0 else -half), angle)
    shaft = document.get("crankshaft", [{}])[table.get("crankshaft", 1) - 1]
    return Weight(
        amount,
        dim.quantity(table["z"]),
        dim.quantity(table.get("angle", "0 deg")) + dim.quantity(shaft.get("phase", "0 deg")),
        REAL(dim.ratio(shaft.get("ratio", 1)).numerator) / dim.ratio(shaft.get("ratio", 1)).denominator,
        dim.quantity(shaft.get("x", 0)) + 1j * dim.quantity(shaft.get("y", 0)),
    )


def shaft_weights(document):
    """Weights of the balance shafts."""
    result = []
    for shaft in document.get("shaft", []):
        ratio = dim.ratio(shaft["ratio"])
        axis = dim.quantity(shaft.get("x", 0)) + 1j * dim.quantity(shaft.get("y", 0))
        for weight in shaft["weights"]:
            phase = dim.quantity(weight.get("phase", "0 deg"))
            speed = REAL(ratio.numerator) / ratio.denominator
            result.append(Weight(unbalance(weight), dim.quantity(weight["z"]), phase, speed, axis))
    return result
