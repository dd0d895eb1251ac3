"""The engines by Exudyn: six coordinates a body, every joint a constraint with its multipliers, trapezoidal rule of index 2 with small steps.

A wheel far heavier than the engine keeps the speed; two bearings and a coupling join it to the crankshaft and carry its loads. For the free run it is gone.
Writes `exudyn.json`.
"""

import sys

import exudyn as exu
import numpy as np
from exudyn.utilities import RigidBodyInertia, SensorBody, SensorObject

from engines import GAS, engines, first_moment, gas_forces, loop, write

WHEEL = 1e7
ROTOR_MASS, ROTOR_ACROSS = 8.0, 0.3
MAINS = [-0.2, 0.2]
STEPS = 14400  # a revolution


def turned(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def slopes(given, index, theta):
    """First derivatives of travel and rod angle, by the closed loop: d.(s' u - P') = 0."""
    own = given["cylinders"][index]
    pin = given["throws"][own["throw"]]
    p = pin["radius"] * np.exp(1j * (pin["angle"] + theta))
    u = np.exp(1j * own["axis"])
    travel, _ = loop(given, index, theta)
    d = u * (travel + 1j * own["offset"]) - p
    dot = lambda a, b: (a * np.conj(b)).real
    first = dot(d, 1j * p) / dot(d, u)
    return first, dot(1j * d, first * u - 1j * p) / own["rod"]["length"] ** 2


def build(given, imposed, start):
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    ground = mbs.CreateGround()
    speed = given["speed"]
    s, p = first_moment(given)
    e = np.array([s.real, s.imag, 0.0]) / ROTOR_MASS
    origin = np.diag([ROTOR_ACROSS, ROTOR_ACROSS, given["crank_inertia"]])
    origin[0, 2] = origin[2, 0] = -p.real
    origin[1, 2] = origin[2, 1] = -p.imag
    central = origin - ROTOR_MASS * (e @ e * np.eye(3) - np.outer(e, e))

    def body(mass, inertia, com, place, rotation, velocity, spin):
        made = RigidBodyInertia(mass=mass, inertiaTensor=inertia, com=np.zeros(3), inertiaTensorAtCOM=True)
        if np.any(com):
            made = made.Translated(com)
        return mbs.CreateRigidBody(
            inertia=made,
            referencePosition=list(place),
            referenceRotationMatrix=rotation,
            initialVelocity=list(velocity),
            initialAngularVelocity=list(spin),
        )

    def joint(a, b, place, rotation, axes):
        return mbs.CreateGenericJoint(
            itemNumbers=[a, b], position=list(place), rotationMatrixAxes=rotation, constrainedAxes=axes, useGlobalFrame=True
        )

    def sensor(item, what):
        return mbs.AddSensor(SensorObject(objectNumber=item, outputVariableType=what, storeInternal=True, writeToFile=False))

    force, torque = exu.OutputVariableType.ForceLocal, exu.OutputVariableType.TorqueLocal
    spin = [0, 0, speed]
    crank = body(ROTOR_MASS, central, e, np.zeros(3), turned(start), np.zeros(3), spin)
    identity = np.eye(3)
    hinge = [1, 1, 1, 1, 1, 0]
    if imposed:
        wheel = body(1.0, np.diag([WHEEL, WHEEL, WHEEL]), np.zeros(3), np.zeros(3), turned(start), np.zeros(3), spin)
        joint(ground, wheel, np.zeros(3), identity, hinge)
        # Two bearings and a coupling: of a joint of six constraints the sensor's moments are not those about fixed axes.
        axes = turned(start)
        bearings = [joint(wheel, crank, [0, 0, z], axes, own) for z, own in zip(MAINS, ([1, 1, 1, 0, 0, 0], [1, 1, 0, 0, 0, 0]))]
        coupling = joint(wheel, crank, np.zeros(3), axes, [0, 0, 0, 0, 0, 1])
        sensors = {"bearings": [sensor(own, force) for own in bearings], "shaft": sensor(coupling, torque)}
    else:
        joint(ground, crank, np.zeros(3), identity, hinge)
        sensors = {}
    sensors |= {"crankpin": [], "pin": [], "wall": []}
    mbs.variables["crank"] = crank

    def angle(own):
        m = own.GetObjectOutputBody(own.variables["crank"], exu.OutputVariableType.RotationMatrix, [0, 0, 0])
        return float(np.arctan2(m[3], m[0]))

    for index, own in enumerate(given["cylinders"]):
        t, r = given["throws"][own["throw"]], own["rod"]
        foot = np.array([t["radius"] * np.cos(t["angle"] + start), t["radius"] * np.sin(t["angle"] + start), own["z"]])
        travel, along = loop(given, index, start)
        rate, turn = (speed * x for x in slopes(given, index, start))
        arm = turned(along) @ np.array([r["centre"], 0, 0])
        cross = lambda w, v: np.cross([0, 0, w], v)
        rod = body(
            r["mass"],
            np.diag([1e-9, r["inertia"], r["inertia"]]),
            np.zeros(3),
            foot + arm,
            turned(along),
            cross(speed, foot) + cross(turn, arm),
            [0, 0, turn],
        )
        axes = turned(own["axis"])
        place = axes @ np.array([travel, own["offset"], own["z"]])
        # A piston does not turn: its inertia is none of the motion's business.
        piston = body(own["piston"], 1e-3 * np.eye(3), np.zeros(3), place, axes, axes @ [rate, 0, 0], np.zeros(3))
        sensors["crankpin"].append(sensor(joint(crank, rod, foot, turned(start), hinge), force))
        sensors["wall"].append(sensor(joint(ground, piston, place, axes, [0, 1, 1, 1, 1, 1]), force))
        sensors["pin"].append(sensor(joint(piston, rod, place, axes, [1, 1, 0, 0, 0, 0]), force))

        def push(own_system, t, load, index=index, axis=own["axis"]):
            size = gas_forces(given, angle(own_system))[index]
            return [-size * np.cos(axis), -size * np.sin(axis), 0.0]

        mbs.CreateForce(itemNumber=piston, loadVector=[1.0, 0, 0], loadVectorUserFunction=push)
    if not imposed:
        mbs.CreateTorque(itemNumber=crank, loadVector=[0, 0, -given["load"]])
    turns = SensorBody(bodyNumber=crank, outputVariableType=exu.OutputVariableType.AngularVelocity, storeInternal=True, writeToFile=False)
    sensors["speed"] = mbs.AddSensor(turns)
    places = SensorBody(bodyNumber=crank, outputVariableType=exu.OutputVariableType.RotationMatrix, storeInternal=True, writeToFile=False)
    sensors["rotation"] = mbs.AddSensor(places)
    mbs.Assemble()
    return mbs, sensors


def solve(mbs, end, steps, every):
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    settings.timeIntegration.newton.absoluteTolerance = 1e-12
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = end / steps * every
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)


def main():
    out = []
    for given in engines():
        speed = given["speed"]
        mbs, sensors = build(given, True, 0.3)
        solve(mbs, 2 * np.pi / speed, STEPS, STEPS // 36)
        of = lambda number: np.asarray(mbs.GetSensorStoredData(number))
        rotation = of(sensors["rotation"])
        imposed = []
        for k in range(1, len(rotation)):
            own = rotation[k, 1:].reshape(3, 3)
            theta = float(np.arctan2(own[1, 0], own[0, 0]))
            ends = [own @ of(number)[k, 1:4] for number in sensors["bearings"]]
            moment = sum(np.cross([0, 0, z], force) for z, force in zip(MAINS, ends))
            cylinders = range(len(given["cylinders"]))
            axes = [turned(given["cylinders"][j]["axis"]) for j in cylinders]
            flat = lambda v: [float(v[0]), float(v[1])]
            imposed.append(
                {
                    "theta": theta,
                    "crankpin": [flat(own @ of(sensors["crankpin"][j])[k, 1:4]) for j in cylinders],
                    "wall": [flat(axes[j] @ of(sensors["wall"][j])[k, 1:4]) for j in cylinders],
                    "piston_pin": [flat(axes[j] @ of(sensors["pin"][j])[k, 1:4]) for j in cylinders],
                    "bearings": flat(sum(ends)) + flat(moment),
                    # Theirs is what the wheel gives to the crankshaft.
                    "shaft_torque": -float(of(sensors["shaft"])[k, 3]),
                }
            )
        mbs, sensors = build(given, False, 0.0)
        solve(mbs, 2 * np.pi / speed, STEPS, STEPS // 16)
        rotation, turning = (np.asarray(mbs.GetSensorStoredData(sensors[name])) for name in ("rotation", "speed"))
        free = [
            {"time": float(at[0]), "theta": float(np.arctan2(at[4], at[1])), "speed": float(w[3])}
            for at, w in zip(rotation[1:], turning[1:])
        ]
        out.append({"engine": given, "imposed": imposed, "free": free})
        print(given["name"], file=sys.stderr)
    write("exudyn.json", {"made_by": {"exudyn": exu.config.Version(), "numpy": np.__version__}, "gas": GAS, "engines": out})


if __name__ == "__main__":
    main()
