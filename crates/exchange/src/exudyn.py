"""An engine of Lanchester as rigid bodies of Exudyn: six coordinates a body, every joint a constraint, trapezoidal rule of index 2.

    pip install exudyn numpy
    python THIS_FILE [LOADS.json]

Every shaft is held at its speed by a wheel far heavier than the engine. Forces of bearings and cylinder walls add up to what shakes the block; they are held
against the loads that Lanchester computes in closed form, and the script ends with status 1 where they differ by more than 1e-6 of what the largest single part
(piston, rod, unbalance of a shaft) makes alone: the sum over all parts may be nil. With a name it writes its loads there.
"""

import json
import sys

import exudyn as exu
import numpy as np
from exudyn.utilities import RigidBodyInertia, SensorBody, SensorObject

TRAIN = json.loads('{TRAIN}')

WHEEL = 1e7
STEPS = 7200  # a revolution, and twice as many
BAR = 1e-6


def turned(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def closed(own):
    """Travel of the piston pin from the axis of its shaft, angle of the rod and their first derivatives, with the shaft as it starts."""
    p, u = complex(*own["crankpin"]), np.exp(1j * own["axis"])
    # (travel + i offset) u - p has the length of the rod.
    local = p * np.conj(u)
    travel = local.real + np.sqrt(own["rod_length"] ** 2 - (local.imag - own["offset"]) ** 2)
    d = u * (travel + 1j * own["offset"]) - p
    dot = lambda a, b: (a * np.conj(b)).real
    first = dot(d, 1j * p) / dot(d, u)
    return travel, np.angle(d), first, dot(1j * d, first * u - 1j * p) / own["rod_length"] ** 2


def build():
    system = exu.SystemContainer()
    mbs = system.AddSystem()
    ground = mbs.CreateGround()
    identity = np.eye(3)

    def body(mass, inertia, place, rotation, velocity, spin):
        made = RigidBodyInertia(mass=mass, inertiaTensor=inertia, com=np.zeros(3), inertiaTensorAtCOM=True)
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

    def sensor(item):
        return mbs.AddSensor(
            SensorObject(objectNumber=item, outputVariableType=exu.OutputVariableType.ForceLocal, storeInternal=True, writeToFile=False)
        )

    forces, shafts, crank = [], [], None
    for rotor in TRAIN["rotors"]:
        speed = TRAIN["speed"] * rotor["ratio"]
        centre = np.array([*rotor["axis"], 0.0])
        mass = 10.0
        e = np.array([*rotor["first_moment"], 0.0]) / mass
        across = 1.0 + 4 * np.hypot(*rotor["product"]) + 4 * mass * e @ e
        origin = np.diag([across, across, 0.5 + 2 * mass * e @ e])
        origin[0, 2] = origin[2, 0] = -rotor["product"][0]
        origin[1, 2] = origin[2, 1] = -rotor["product"][1]
        central = origin - mass * (e @ e * identity - np.outer(e, e))
        spin = np.array([0, 0, speed])
        shaft = body(mass, central, centre + e, identity, np.cross(spin, e), spin)
        wheel = body(1.0, WHEEL * identity, centre, identity, np.zeros(3), spin)
        joint(ground, wheel, centre, identity, [1, 1, 1, 1, 1, 0])
        # Two bearings and a coupling carry shaft and wheel apart from one another: their forces are those on the block.
        for z, axes in ((-0.2, [1, 1, 1, 0, 0, 0]), (0.2, [1, 1, 0, 0, 0, 0])):
            forces.append((sensor(joint(wheel, shaft, centre + [0, 0, z], identity, axes)), rotor["ratio"], 0.0, z))
        joint(wheel, shaft, centre, identity, [0, 0, 0, 0, 0, 1])
        shafts.append((shaft, spin, centre))
        if crank is None:
            crank = shaft
    for own in TRAIN["cylinders"]:
        shaft, spin, centre = shafts[own["rotor"]]
        travel, along, rate, turn = closed(own)
        rate, turn = rate * spin[2], turn * spin[2]
        pin = np.array([*own["crankpin"], 0.0])
        foot = centre + pin + [0, 0, own["z"]]
        arm = turned(along) @ np.array([own["rod_centre"], 0, 0])
        turning = np.array([0, 0, turn])
        across = max(own["rod_inertia"], 1e-9)
        rod = body(
            own["rod_mass"],
            np.diag([0.1 * across, across, across]),
            foot + arm,
            turned(along),
            np.cross(spin, pin) + np.cross(turning, arm),
            turning,
        )
        axes = turned(own["axis"])
        place = centre + axes @ np.array([travel, own["offset"], own["z"]])
        # A piston does not turn: its inertia is none of the motion's business.
        piston = body(own["piston_mass"], 1e-3 * identity, place, axes, axes @ [rate, 0, 0], np.zeros(3))
        joint(shaft, rod, foot, identity, [1, 1, 1, 1, 1, 0])
        forces.append((sensor(joint(ground, piston, place, axes, [0, 1, 1, 1, 1, 1])), 0.0, own["axis"], own["z"]))
        joint(piston, rod, place, axes, [1, 1, 0, 0, 0, 0])
    turns = SensorBody(bodyNumber=crank, outputVariableType=exu.OutputVariableType.RotationMatrix, storeInternal=True, writeToFile=False)
    turns = mbs.AddSensor(turns)
    mbs.Assemble()
    return mbs, forces, turns


def run(a_revolution):
    """Force x, force y, couple x, couple y of all moving parts on the block at the angles of the reference."""
    mbs, forces, turns = build()
    reference = TRAIN["reference"]
    count, revolutions = len(reference["theta"]), TRAIN["revolutions"]
    every = a_revolution * revolutions // count
    steps = count * every
    step = 2 * np.pi * revolutions / TRAIN["speed"] / steps
    settings = exu.SimulationSettings()
    # One step more than the period: every sample has a step before and one behind it.
    settings.timeIntegration.endTime = step * (steps + 1)
    settings.timeIntegration.numberOfSteps = steps + 1
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    settings.timeIntegration.newton.absoluteTolerance = 1e-12
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    settings.solution.sensors.writePeriod = step
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    rotation = np.asarray(mbs.GetSensorStoredData(turns))
    stored = [np.asarray(mbs.GetSensorStoredData(number)) for number, _, _, _ in forces]
    found = np.zeros((count, 4))
    for k in range(count):
        # Row 0 is the start, before anything is in balance; after a period it is the first angle again.
        row = k * every if k else steps
        theta = reference["theta"][k]
        crank = np.arctan2(rotation[row, 4], rotation[row, 1])
        if abs((crank - theta + np.pi) % (2 * np.pi) - np.pi) > 1e-6:
            sys.exit(f"the crankshaft is at {crank:.6f} rad instead of {theta:.6f} rad")
        for (_, ratio, axis, z), data in zip(forces, stored):
            angle = ratio * theta if ratio else axis
            # The rule leaves the forces of constraints with an error that changes its sign from step to step: the mean has none.
            turn = ratio * TRAIN["speed"] * step
            local = sum(share * turned(turn * at) @ data[row + at, 1:4] for at, share in ((-1, 0.25), (0, 0.5), (1, 0.25)))
            x, y, _ = turned(angle) @ local
            found[k] += [x, y, -z * y, z * x]
    return found


def main():
    theirs = np.array(TRAIN["reference"]["loads"])
    coarse, fine = run(STEPS), run(2 * STEPS)
    # The error of the rule falls with the square of its step (Richardson).
    ours = (4 * fine - coarse) / 3
    if len(sys.argv) > 1:
        made = {"exudyn": exu.config.Version(), "numpy": np.__version__}
        with open(sys.argv[1], "w") as file:
            json.dump({"made_by": made, "speed": TRAIN["speed"], "loads": np.round(ours, 7).tolist()}, file)
    worst = 0.0
    for name, columns in (("force", [0, 1]), ("couple", [2, 3])):
        scale = TRAIN[f"{name}_scale"]
        off = np.abs(theirs[:, columns] - ours[:, columns]).max()
        print(f"{TRAIN['name']}: {name}: largest {np.abs(theirs[:, columns]).max():.9g}, differs by {off / scale:.2e} of {scale:.6g}")
        worst = max(worst, off / scale)
    return 0 if worst < BAR else 1


if __name__ == "__main__":
    sys.exit(main())
