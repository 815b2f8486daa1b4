"""Run by the interpreter of the peers' environment: what needs their Python packages. It answers in JSON.

in_peers.py where                              folders and versions of what is installed
in_peers.py casadi ARM N WAY FILE.c            Lagrange's equations by CasADi, as C; WAY is one of WAYS
in_peers.py pinocchio ARM N STATES.npy OUT.npy forward dynamics at many states
in_peers.py calls ARM N MUJOCO.xml             single calls of what is installed, at the state of calls.states
in_peers.py motion PROBLEM                     integrators of others on a problem of peer_motion.py
"""

import importlib.util
import json
import os
import sys
import time
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np
from serial import ARMS, Arm


def where() -> dict[str, dict[str, str]]:
    """Only what is there."""
    found = {}
    for name, package, module in (
        ("pinocchio", "pin", "cmeel"),
        ("mujoco", "mujoco", "mujoco"),
        ("casadi", "casadi", "casadi"),
        ("scipy", "scipy", "scipy"),
        ("numba", "numba", "numba"),
        ("scikit-sundae", "scikit-sundae", "sksundae"),
    ):
        spec = importlib.util.find_spec(module)
        try:
            number = version(package)
        except PackageNotFoundError:
            continue
        if spec is not None and spec.submodule_search_locations:
            found[name] = {"version": number, "folder": next(iter(spec.submodule_search_locations))}
    if "pinocchio" in found:
        found["pinocchio"]["folder"] = str(Path(found["pinocchio"]["folder"]).parent / "cmeel.prefix")
    return found


def exact(values, shape):
    """Numbers for CasADi, zeros known as such."""
    import casadi as ca

    return ca.sparsify(ca.DM(np.array(values, dtype=float).reshape(shape)))


def in_space(arm: Arm, q, v):
    """Kinetic and potential energy, link by link in its own axes."""
    import casadi as ca

    kinetic = potential = 0
    turn, speed, rotation, place = ca.SX.zeros(3), ca.SX.zeros(3), ca.SX.eye(3), ca.SX.zeros(3)
    for i, link in enumerate(arm.links):
        c, s = ca.cos(q[i]), ca.sin(q[i])
        joint = ca.SX(3, 3)
        joint[0, 0] = joint[1, 1] = c
        joint[1, 0], joint[0, 1], joint[2, 2] = s, -s, 1
        own = exact(link.rotation, (3, 3)) @ joint
        offset = exact(link.place, 3)
        speed = own.T @ (speed + ca.cross(turn, offset))
        turn = own.T @ turn
        turn[2] += v[i]
        place = place + rotation @ offset
        rotation = rotation @ own
        center = exact(link.center, 3)
        at_center = speed + ca.cross(turn, center)
        xx, yy, zz, xy, xz, yz = link.inertia
        inertia = exact([xx, xy, xz, xy, yy, yz, xz, yz, zz], (3, 3))
        kinetic += link.mass / 2 * ca.dot(at_center, at_center) + ca.dot(turn, inertia @ turn) / 2
        potential -= link.mass * ca.dot(ca.DM(arm.gravity), place + rotation @ center)
    return kinetic, potential


def in_plane(arm: Arm, q, v):
    """The same of a planar arm, in the axes of the world: sums of sines and cosines of absolute angles."""
    import casadi as ca

    kinetic = potential = angle = rate = x = y = vx = vy = 0
    for i, link in enumerate(arm.links):
        offset = link.place[0]
        if i:
            x, y = x + offset * c, y + offset * s  # noqa: F821  of the link before
            vx, vy = vx - offset * s * rate, vy + offset * c * rate  # noqa: F821
        angle, rate = angle + q[i], rate + v[i]
        c, s = ca.cos(angle), ca.sin(angle)
        center = link.center[0]
        ux, uy = vx - center * s * rate, vy + center * c * rate
        kinetic += link.mass / 2 * (ux**2 + uy**2) + link.inertia[2] / 2 * rate**2
        potential -= link.mass * (arm.gravity[0] * (x + center * c) + arm.gravity[1] * (y + center * s))
    return kinetic, potential


# Form in which the energies are typed.
WAYS = {"space": in_space, "plane": in_plane}


def casadi_function(arm: Arm, way: str):
    """f(q, qd) -> qdd: energies by hand, Lagrange's equations by differentiation, M by LDL."""
    import casadi as ca

    n = len(arm.links)
    q, v = ca.SX.sym("q", n), ca.SX.sym("v", n)
    kinetic, potential = WAYS[way](arm, q, v)
    momentum = ca.gradient(kinetic, v)
    mass = ca.jacobian(momentum, v)
    rest = ca.gradient(kinetic - potential, q) - ca.jtimes(momentum, q, v)
    d, lt, p = ca.ldl(mass)
    return ca.Function("f", [q, v], [ca.ldl_solve(rest, d, lt, p)])


def generate(arm: Arm, way: str, path: Path) -> dict[str, float]:
    """C of that function; Python's CPU seconds, imports not counted, and the number of instructions."""
    import casadi  # noqa: F401

    start = time.process_time()
    f = casadi_function(arm, way)
    os.chdir(path.parent)
    f.generate(path.name)
    return {"seconds": time.process_time() - start, "instructions": f.n_instructions()}


def forward(arm: Arm, given: Path, out: Path) -> dict[str, float]:
    """Pinocchio's articulated-body algorithm at every row of q and qd."""
    import pinocchio as pin

    model = pinocchio_model(arm)
    data, n = model.createData(), len(arm.links)
    rows = np.load(given)
    np.save(out, np.array([pin.aba(model, data, row[:n], row[n:], np.zeros(n)).copy() for row in rows]))
    return {"states": len(rows)}


def pinocchio_model(arm: Arm):
    import pinocchio as pin

    model = pin.Model()
    model.gravity.linear = np.array(arm.gravity)
    for i, link in enumerate(arm.links):
        place = pin.SE3(np.array(link.rotation, dtype=float).reshape(3, 3), np.array(link.place, dtype=float))
        xx, yy, zz, xy, xz, yz = link.inertia
        inertia = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        joint = model.addJoint(i, pin.JointModelRZ(), place, f"j{i}")
        model.appendBodyToJoint(joint, pin.Inertia(link.mass, np.array(link.center), inertia), pin.SE3.Identity())
    return model


def single_calls(arm: Arm, xml: Path) -> dict[str, object]:
    """Least CPU microseconds of a call, and results, by `peer kind` as calls.py names them."""
    n, installed = len(arm.links), where()
    q, qd, qdd = np.random.default_rng(11).uniform(-1.0, 1.0, (3, n))
    zero, work, values = np.zeros(n), {}, {}
    if "pinocchio" in installed:
        import pinocchio as pin

        model = pinocchio_model(arm)
        data, axes = model.createData(), pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
        last = model.addFrame(pin.Frame("last", n, pin.SE3.Identity(), pin.FrameType.OP_FRAME))
        data = model.createData()
        work["pinocchio forward"] = lambda: pin.aba(model, data, q, qd, zero)
        work["pinocchio mass"] = lambda: pin.crba(model, data, q)
        work["pinocchio inverse"] = lambda: pin.rnea(model, data, q, qd, qdd)
        work["pinocchio jacobian"] = lambda: pin.computeFrameJacobian(model, data, q, last, axes)
        work["pinocchio energy"] = lambda: pin.computeMechanicalEnergy(model, data, q, qd)
        upper = np.triu(pin.crba(model, data, q))
        values["pinocchio mass"] = upper + np.triu(upper, 1).T
    if "casadi" in installed:
        f = casadi_function(arm, "space")
        work["casadi forward"] = lambda: f(q, qd)
        values["casadi forward"] = np.array(f(q, qd)).ravel()
    if "mujoco" in installed:
        import mujoco

        body = mujoco.MjModel.from_xml_path(str(xml))
        state = mujoco.MjData(body)

        def forward_in_mujoco():
            state.qpos[:], state.qvel[:] = q, qd
            mujoco.mj_forward(body, state)
            return state.qacc

        work["mujoco forward"] = forward_in_mujoco
    values = {name: np.array(call()).copy() for name, call in work.items()} | values
    return {
        "times": {name: _least(call) for name, call in work.items()},
        "values": {name: value.tolist() for name, value in values.items()},
    }


def _least(call, blocks=200, calls=100):
    """As calls.least."""
    found = []
    for _ in range(blocks):
        start = time.process_time()
        for _ in range(calls):
            call()
        found.append(time.process_time() - start)
    return min(found) / calls * 1e6


def main() -> None:
    command, *rest = sys.argv[1:]
    if command == "where":
        answer: object = where()
    elif command == "motion":
        from peer_motion import measure

        answer = measure(rest[0])
    elif command == "tangents":
        from peer_tangents import measure

        answer = measure(float(rest[0]), json.loads(rest[1]))
    else:
        arm = ARMS[rest[0]](int(rest[1]))
        if command == "calls":
            answer = single_calls(arm, Path(rest[2]))
        elif command == "casadi":
            answer = generate(arm, rest[2], Path(rest[3]))
        else:
            answer = forward(arm, Path(rest[2]), Path(rest[3]))
    print(json.dumps(answer))


if __name__ == "__main__":
    main()
