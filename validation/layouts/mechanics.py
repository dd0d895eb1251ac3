"""Inertia loads of a piston engine by brute force.

Every moving mass is a point (or a rigid rod: a point at its centre of gravity and a spin) whose position is found
by solving the linkage at each angle of a fine grid: crankpin on its circle, piston pin where a circle of the rod's
length cuts the cylinder's line, knuckle pin on the master rod. Velocity and acceleration are Fourier derivatives of
these positions. Then, with F what the parts exert on the block, L their angular momentum about the origin and E
their kinetic energy,

    F = -sum m a        M_x + i M_y = sum i z F        T = -dE/dtheta        M_z = -T - dL/dt

(torque delivered to the driveline, and what is left for the block). No order coefficient, series or closed form of
the slider-crank is used, so that agreement with the closed-form kernels is evidence.

Extended precision (x87 long double) throughout: the Fourier derivative amplifies rounding by the square of the
order, and the results must be good to 1e-12.
"""

from dataclasses import dataclass, field

import numpy as np

REAL = np.longdouble
COMPLEX = np.clongdouble
TURN = REAL(2) * np.arctan2(REAL(0), REAL(-1))
STEPS = 2048  # grid points a revolution
CUT = 160  # highest order kept in a derivative: the coefficients end at rounding long before


def unit(angle):
    """e^{i angle}."""
    return (np.cos(angle) + 1j * np.sin(angle)).astype(COMPLEX)


def deg(angle):
    """Degrees to radians."""
    return REAL(angle) * TURN / 360


@dataclass
class Rod:
    """Connecting rod: two point masses, or a rigid body where its inertia is known."""

    length: REAL
    big_end: REAL
    small_end: REAL
    inertia: REAL | None = None


@dataclass
class Pin:
    """A crankpin: `ratio theta + phase + angle` on a crank axis at x + i y."""

    angle: REAL
    z: REAL
    radius: REAL
    unbalance: REAL
    ratio: REAL = REAL(1)
    phase: REAL = REAL(0)
    axis: complex = 0j


@dataclass
class Cylinder:
    """A cylinder, its piston and rod; `knuckle` = (master's number, radius, angle from the master rod's line)."""

    number: int
    pin: Pin
    angle: REAL
    z: REAL
    piston: REAL
    rod: Rod
    offset: REAL = REAL(0)
    pin_offset: REAL = REAL(0)
    knuckle: tuple | None = None


@dataclass
class Weight:
    """A weight on a turning shaft at x + i y: it stands at `ratio theta + phase`."""

    unbalance: REAL
    z: REAL
    phase: REAL
    ratio: REAL = REAL(1)
    axis: complex = 0j


@dataclass
class Machine:
    """All moving parts; `revolutions` of crank 1 make one period."""

    cylinders: list
    pins: list
    weights: list = field(default_factory=list)
    revolutions: int = 1


class Motion:
    """Positions of all bodies over one period."""

    def __init__(self, machine):
        self.machine = machine
        self.count = STEPS * machine.revolutions
        self.theta = np.arange(self.count).astype(REAL) * TURN / STEPS
        self.points = []  # (mass, z, position)
        self.spins = []  # (inertia, angle)
        self.piston_pin = {}  # number -> distance along the cylinder from the crank axis
        self.rod_line = {}  # number -> direction of the rod from big to small end, unit vector
        for pin in machine.pins:
            self.points.append((pin.unbalance / pin.radius, pin.z, self.crankpin(pin)))
        for weight in machine.weights:
            # Any radius will do: only mass times radius acts at constant speed. A small one keeps the constant
            # energy, and with it the rounding, small.
            arm = REAL("0.05")
            place = weight.axis + arm * unit(weight.ratio * self.theta + weight.phase)
            self.points.append((weight.unbalance / arm, weight.z, place))
        for cylinder in sorted(machine.cylinders, key=lambda c: c.knuckle is not None):
            self.place(cylinder)

    def crankpin(self, pin):
        """Position of a crankpin's centre."""
        return pin.axis + pin.radius * unit(pin.ratio * self.theta + pin.phase + pin.angle)

    def place(self, cylinder):
        """Solves one cylinder's linkage and adds its masses."""
        pin, rod = cylinder.pin, cylinder.rod
        big = self.crankpin(pin)
        if cylinder.knuckle is not None:
            master, radius, angle = cylinder.knuckle
            big = big + radius * self.rod_line[master] * unit(angle)
        along = unit(cylinder.angle)
        across = 1j * along
        # In the cylinder's own axes: the big end at (p, q), the piston pin at (s, e), a rod's length apart.
        local = (big - pin.axis) * np.conj(along)
        e = cylinder.offset + cylinder.pin_offset
        reach = rod.length**2 - (local.imag - e) ** 2
        assert np.all(reach > 0), "the linkage does not turn"
        s = local.real + np.sqrt(reach)
        small = pin.axis + s * along + e * across
        line = (small - big) / rod.length
        self.piston_pin[cylinder.number] = s
        self.rod_line[cylinder.number] = line
        # The piston's centre of mass runs on the cylinder's axis; its place along the axis does not matter.
        self.points.append((cylinder.piston, cylinder.z, pin.axis + s * along + cylinder.offset * across))
        if rod.inertia is None:
            self.points.append((rod.big_end, cylinder.z, big))
            self.points.append((rod.small_end, cylinder.z, small))
        else:
            mass = rod.big_end + rod.small_end
            self.points.append((mass, cylinder.z, big + (small - big) * (rod.small_end / mass)))
            swing = line * np.conj(along)
            self.spins.append((rod.inertia, np.arctan2(swing.imag, swing.real)))

    def coefficients(self, signal):
        """Two-sided Fourier coefficients, index k for order k / revolutions."""
        return np.fft.fft(signal.astype(COMPLEX)) / self.count

    def ends(self, signal):
        """Whether the series has come down to rounding at half of the highest order kept."""
        order = np.abs(np.fft.fftfreq(self.count, 1 / self.count)) / self.machine.revolutions
        tail = np.abs(self.coefficients(signal)[order > CUT / 2]).max()
        return tail < 1e-17 * np.abs(signal).max()

    def derivative(self, signal, times=1):
        """d/dtheta by Fourier series."""
        order = np.fft.fftfreq(self.count, REAL(1) / self.count).astype(REAL) / self.machine.revolutions
        spectrum = np.fft.fft(signal.astype(COMPLEX))
        assert spectrum.dtype == COMPLEX, "numpy >= 2 keeps extended precision in its FFT"
        spectrum *= np.where(np.abs(order) <= CUT, 1j * order, 0) ** times
        return np.fft.ifft(spectrum)


@dataclass
class Loads:
    """Loads over one period, on the motion's grid."""

    force: np.ndarray
    couple: np.ndarray
    roll_moment: np.ndarray
    torque: np.ndarray
    uncancelled: dict  # what force, couple and moment would be if all parts pulled together: the scale of rounding


def loads(motion, speed):
    """Forces and couples on the block at `speed` [rad/s]."""
    force = np.zeros(motion.count, COMPLEX)
    couple = np.zeros(motion.count, COMPLEX)
    momentum = np.zeros(motion.count, REAL)
    energy = np.zeros(motion.count, REAL)
    total = {"force": 0.0, "couple": 0.0, "moment": 0.0}
    for mass, z, place in motion.points:
        assert motion.ends(place), "more orders than are kept"
        velocity = speed * motion.derivative(place)
        push = -mass * speed**2 * motion.derivative(place, 2)
        force += push
        couple += 1j * z * push
        most = float(np.abs(push).max())
        total["force"] += most
        total["couple"] += most * abs(float(z))
        total["moment"] += most * float(np.abs(place - place.mean()).max() + abs(place.mean().imag))
        momentum += mass * (place.real * velocity.imag - place.imag * velocity.real)
        energy += mass * (velocity.real**2 + velocity.imag**2) / 2
    for inertia, angle in motion.spins:
        rate = speed * motion.derivative(angle).real
        momentum += inertia * rate
        energy += inertia * rate**2 / 2
    torque = -motion.derivative(energy).real
    roll_moment = -torque - speed * motion.derivative(momentum).real
    return Loads(force, couple, roll_moment, torque, total)


class Series:
    """A periodic signal as its Fourier series, to be evaluated between grid points."""

    def __init__(self, motion, signal):
        spectrum = motion.coefficients(signal)
        order = np.fft.fftfreq(motion.count, 1 / motion.count)
        keep = np.abs(order) <= CUT * motion.machine.revolutions
        self.order = order[keep].astype(REAL) / motion.machine.revolutions
        self.value = spectrum[keep]

    def at(self, theta, times=0):
        """The `times`-th derivative at one angle."""
        return np.sum(self.value * (1j * self.order) ** times * unit(self.order * theta))


def extreme(motion, samples, function, sign):
    """Largest (`sign` 1) or smallest (-1) value of a smooth function, refined from its samples.

    `function(theta)` returns value, first and second derivative. All grid points that may neighbour the extreme are
    followed, so that equal peaks cannot hide a larger one.
    """
    height = sign * samples
    peak = (height >= np.roll(height, 1)) & (height >= np.roll(height, -1))
    reach = height.max() - height.min()
    best = (-np.inf, REAL(0))
    for start in np.flatnonzero(peak & (height >= height.max() - reach * REAL(5e-3)))[:256]:
        theta = motion.theta[start]
        for _ in range(6):
            _, slope, bend = function(theta)
            if sign * bend >= 0:
                break
            step = -slope / bend
            if abs(step) > TURN / STEPS:
                break
            theta += step
        value = sign * function(theta)[0]
        if value < height[start]:
            value, theta = height[start], motion.theta[start]
        if value > best[0]:
            best = (value, theta)
    return sign * best[0], best[1]


def real_extremes(motion, signal):
    """Largest and smallest value of a real signal, with their angles."""
    series = Series(motion, signal)

    def function(theta):
        return tuple(series.at(theta, k).real for k in range(3))

    return {"max": extreme(motion, signal, function, 1), "min": extreme(motion, signal, function, -1)}


def modulus_peak(motion, signal):
    """Largest modulus of a complex signal and its angle, by way of the squared modulus."""
    series = Series(motion, signal)

    def function(theta):
        w, d, dd = (series.at(theta, k) for k in range(3))
        return (
            w.real**2 + w.imag**2,
            2 * (w.conjugate() * d).real,
            2 * (w.conjugate() * dd).real + 2 * (d.real**2 + d.imag**2),
        )

    value, theta = extreme(motion, signal.real**2 + signal.imag**2, function, 1)
    return np.sqrt(max(value, REAL(0))), theta
