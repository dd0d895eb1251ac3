"""The engines by Pinocchio: crankshaft, rods and pistons as a tree of joints, every loop closed at its piston pin by a constraint whose force is solved for.

Writes `pinocchio.json`: every joint load over a revolution at imposed speed, the free speed under a constant load over four revolutions, and the seven
accelerations of block and crankshaft in random motion with the block floating under gravity.
"""

import numpy as np
import pinocchio as pin
import scipy
from scipy.integrate import solve_ivp

from engines import GAS, engines, first_moment, gas_forces, loop, write

# The share of mass and transverse inertia that the rotor's body has here; the block's body has as much less.
ROTOR_MASS, ROTOR_ACROSS = 8.0, 0.3


def about(mass, centre, inertia):
    """Pinocchio's body of this mass, centre and inertia tensor about the joint's origin."""
    c = np.asarray(centre)
    return pin.Inertia(mass, c, inertia - mass * (c @ c * np.eye(3) - np.outer(c, c)))


class Model:
    def __init__(self, given, floating):
        self.given, self.floating = given, floating
        model = pin.Model()
        root = 0
        if floating:
            root = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "block")
            b = given["block"]
            ixx, iyy, izz = b["inertia"]
            ixy, iyz, izx = b["products"]
            c = np.array(b["centre"])
            central = np.array([[ixx, -ixy, -izx], [-ixy, iyy, -iyz], [-izx, -iyz, izz]])
            origin = central + b["mass"] * (c @ c * np.eye(3) - np.outer(c, c))
            alone = origin - np.diag([ROTOR_ACROSS, ROTOR_ACROSS, given["crank_inertia"]])
            mass = b["mass"] - ROTOR_MASS
            model.appendBodyToJoint(root, about(mass, b["mass"] * c / mass, alone), pin.SE3.Identity())
        crank = model.addJoint(root, pin.JointModelRZ(), pin.SE3.Identity(), "crank")
        s, p = first_moment(given)
        tensor = np.diag([ROTOR_ACROSS, ROTOR_ACROSS, given["crank_inertia"]])
        tensor[0, 2] = tensor[2, 0] = -p.real
        tensor[1, 2] = tensor[2, 1] = -p.imag
        centre = [s.real / ROTOR_MASS, s.imag / ROTOR_MASS, 0.0]
        model.appendBodyToJoint(crank, about(ROTOR_MASS, centre, tensor), pin.SE3.Identity())
        self.crank, self.root, self.rods, self.pistons, self.tips = crank, root, [], [], []
        for index, own in enumerate(given["cylinders"]):
            t, r = given["throws"][own["throw"]], own["rod"]
            place = np.array([t["radius"] * np.cos(t["angle"]), t["radius"] * np.sin(t["angle"]), own["z"]])
            joint = model.addJoint(crank, pin.JointModelRZ(), pin.SE3(np.eye(3), place), f"rod{index}")
            body = pin.Inertia(r["mass"], np.array([r["centre"], 0, 0]), np.diag([0.0, r["inertia"], r["inertia"]]))
            model.appendBodyToJoint(joint, body, pin.SE3.Identity())
            at = pin.SE3(np.eye(3), np.array([r["length"], 0, 0]))
            self.tips.append(model.addFrame(pin.Frame(f"tip{index}", joint, at, pin.FrameType.OP_FRAME)))
            self.rods.append(joint)
        # Pinocchio wants every subtree without gaps: pistons come after all rods.
        for index, own in enumerate(given["cylinders"]):
            turn = pin.utils.rotate("z", own["axis"])
            foot = pin.SE3(turn, turn @ np.array([0.0, own["offset"], 0.0]) + np.array([0, 0, own["z"]]))
            joint = model.addJoint(root, pin.JointModelPX(), foot, f"piston{index}")
            model.appendBodyToJoint(joint, pin.Inertia(own["piston"], np.zeros(3), np.zeros((3, 3))), pin.SE3.Identity())
            self.pistons.append(joint)
        model.gravity.linear = np.zeros(3)
        self.model, self.data = model, model.createData()
        self.own = [model.idx_vs[j] for j in range(model.njoints)]

    def state(self, theta, speed, pose=None, velocity=None):
        """Positions and speeds with closed loops."""
        q, v = pin.neutral(self.model), np.zeros(self.model.nv)
        if pose is not None:
            q[:7], v[:6] = pose, velocity
        at = self.model.idx_qs
        q[at[self.crank]], v[self.own[self.crank]] = theta, speed
        for index in range(len(self.rods)):
            travel, angle = loop(self.given, index, theta)
            q[at[self.rods[index]]], q[at[self.pistons[index]]] = angle - theta, travel
        # Speeds of rods and pistons from the constraints themselves.
        jacobian, _ = self.constraints(q, v)
        dependent = [self.own[j] for j in self.rods + self.pistons]
        v[dependent] = np.linalg.solve(jacobian[:, dependent], -jacobian @ v)
        return q, v

    def constraints(self, q, v):
        """Jacobian and drift of tip less piston across the crank axis, axes of the block."""
        model, data = self.model, self.data
        pin.forwardKinematics(model, data, q, v, np.zeros(model.nv))
        pin.computeJointJacobians(model, data, q)
        pin.updateFramePlacements(model, data)
        aligned = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        own = data.oMi[self.root].rotation.T
        rows, drift = [], []
        for tip, piston in zip(self.tips, self.pistons):
            a = pin.getFrameJacobian(model, data, tip, aligned)[:3]
            b = pin.getJointJacobian(model, data, piston, aligned)[:3]
            rows.append((own @ (a - b))[:2])
            aa = pin.getFrameClassicalAcceleration(model, data, tip, aligned).linear
            ab = pin.getClassicalAcceleration(model, data, piston, aligned).linear
            drift.append((own @ (aa - ab))[:2])
        return np.vstack(rows), np.concatenate(drift)

    def accelerations(self, q, v, theta, torque, imposed):
        """Accelerations and constraint forces; the crank's acceleration is 0 where it is imposed."""
        model, data = self.model, self.data
        jacobian, drift = self.constraints(q, v)
        mass = pin.crba(model, data, q).copy()
        mass = np.triu(mass) + np.triu(mass, 1).T
        forces = -pin.nle(model, data, q, v)
        for joint, force in zip(self.pistons, gas_forces(self.given, theta)):
            forces[self.own[joint]] -= force
        forces[self.own[self.crank]] += torque
        n, m = model.nv, len(drift)
        extra = 1 if imposed else 0
        system = np.zeros((n + m + extra, n + m + extra))
        system[:n, :n] = mass
        system[:n, n : n + m] = -jacobian.T
        system[n : n + m, :n] = jacobian
        if imposed:
            system[self.own[self.crank], -1] = -1.0
            system[-1, self.own[self.crank]] = 1.0
        found = np.linalg.solve(system, np.concatenate([forces, -drift, np.zeros(extra)]))
        return found[:n], found[n : n + m], (found[-1] if imposed else torque)

    def loads(self, theta, speed):
        """Every joint load at imposed speed in a block at rest."""
        model, data = self.model, self.data
        q, v = self.state(theta, speed)
        a, push, torque = self.accelerations(q, v, theta, 0.0, True)
        outer = pin.StdVec_Force()
        outer.extend([pin.Force.Zero() for _ in range(model.njoints)])
        pin.forwardKinematics(model, data, q)
        gas = gas_forces(self.given, theta)
        for index, (rod, piston) in enumerate(zip(self.rods, self.pistons)):
            on_tip = np.array([push[2 * index], push[2 * index + 1], 0.0])
            lever = np.array([self.given["cylinders"][index]["rod"]["length"], 0, 0])
            local = data.oMi[rod].rotation.T @ on_tip
            outer[rod] = pin.Force(local, np.cross(lever, local))
            local = data.oMi[piston].rotation.T @ -on_tip
            outer[piston] = pin.Force(local - np.array([gas[index], 0, 0]), np.zeros(3))
        pin.rnea(model, data, q, v, a, outer)
        world = lambda joint: data.oMi[joint].rotation @ data.f[joint].linear
        shaft = data.oMi[self.crank].rotation @ data.f[self.crank].angular
        return {
            "piston_pin": [[-float(push[2 * k]), -float(push[2 * k + 1])] for k in range(len(self.rods))],
            "crankpin": [[-float(x) for x in world(rod)[:2]] for rod in self.rods],
            "wall": [[-float(x) for x in world(piston)[:2]] for piston in self.pistons],
            "bearings": [-float(x) for x in world(self.crank)[:2]] + [-float(x) for x in shaft[:2]],
            "shaft_torque": -float(torque),
        }


def main():
    rng = np.random.default_rng(19)
    out = []
    for given in engines():
        fixed = Model(given, False)
        speed = given["speed"]
        angles = [2 * np.pi * (k + 0.37) / 36 for k in range(36)]
        imposed = [{"theta": theta, **fixed.loads(theta, speed)} for theta in angles]

        def rates(_, y):
            q, v = fixed.state(y[0], y[1])
            a, _, _ = fixed.accelerations(q, v, y[0], -given["load"], False)
            return [y[1], a[fixed.own[fixed.crank]]]

        until = 4 * 2 * np.pi / speed
        times = [until * (k + 1) / 16 for k in range(16)]
        run = solve_ivp(rates, [0, until], [0.0, speed], "DOP853", times, rtol=1e-12, atol=1e-12)
        free = [{"time": float(t), "theta": float(a), "speed": float(w)} for t, a, w in zip(run.t, *run.y)]

        moving = Model(given, True)
        states = []
        for _ in range(6):
            turn = rng.normal(size=4)
            turn /= np.linalg.norm(turn)
            velocity, theta, w = rng.normal(size=6), rng.uniform(0, 2 * np.pi), rng.uniform(50, 400)
            moving.model.gravity.linear = np.array([-9.81, 0.0, 0.0])
            q, v = moving.state(theta, w, np.concatenate([np.zeros(3), turn[1:], turn[:1]]), velocity)
            torque = rng.uniform(-100, 100)
            a, _, _ = moving.accelerations(q, v, theta, torque, False)
            states.append(
                {
                    "orientation": turn.tolist(),
                    "velocity": velocity[:3].tolist(),
                    "spin": velocity[3:].tolist(),
                    "theta": theta,
                    "speed": w,
                    "torque_from_block": torque,
                    "rates": a[:7].tolist(),
                }
            )
        out.append({"engine": given, "imposed": imposed, "free": free, "moving": states})
    made = {"pinocchio": pin.__version__, "numpy": np.__version__, "scipy": scipy.__version__}
    write("pinocchio.json", {"made_by": made, "gas": GAS, "gravity": 9.81, "engines": out})


if __name__ == "__main__":
    main()
