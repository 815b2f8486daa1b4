"""Random trees and loops of the library's joints, loaded by springs, dampers, forces and drives, as texts."""

from __future__ import annotations

import numpy as np
from maximal_coordinates import BASE, SIZES, WORLD, ZERO, Joint, Mechanism, Z, relative, turn, turns

COORDINATES = {
    "Revolute": ["q"],
    "Prismatic": ["s"],
    "Cylindrical": ["s", "q"],
    "Universal": ["a", "b"],
    "Spherical": ["e"],
    "Screw": ["q"],
    "Planar": ["x", "y", "q"],
    "FreeMotion": ["r", "angles"],
    "FreeQuaternion": ["r", "e"],
}
PLANAR = {**COORDINATES, "FreeMotion": ["x", "y", "q"]}
FREEDOM = {"Spherical": 3, "FreeMotion": 6, "FreeQuaternion": 6}
UNITS = {True: ("torque", "N.m", "N.m/rad", "N.m.s/rad", "rad"), False: ("force", "N", "N/m", "N.s/m", "m")}
DRIVES = ("RevoluteDrive", "PrismaticDrive")


class Draw:
    """Builds one mechanism; `flat`: all of it moves in a plane, `planar`: out of the planar library."""

    def __init__(self, seed, flat=False, planar=False):
        self.rng = np.random.default_rng(seed)
        self.flat, self.planar = flat or planar, planar
        self.pose = {WORLD: (ZERO, np.eye(3))}

    def place(self):
        r = self.rng.uniform(-0.6, 0.6, 3)
        if self.flat:
            return r * (1, 1, 0), turn(Z, self.rng.uniform(-3, 3))
        return r, turns(self.rng.uniform(-1.3, 1.3, 3))

    def body(self):
        com, B = self.rng.uniform(-0.3, 0.3, 3), self.rng.normal(size=(3, 3)) * 0.3
        P = B @ B.T + 0.01 * np.eye(3)
        if self.flat:
            return self.rng.uniform(0.5, 3), com * (1, 1, 0), np.diag([0.02, 0.03, 0.04])
        return self.rng.uniform(0.5, 3), com, np.trace(P) * np.eye(3) - P

    def value(self, c):
        if c == "e":
            e = self.rng.normal(size=4)
            e[0] = abs(e[0]) + 1
            return e / np.linalg.norm(e)
        if c in ("r", "angles"):
            return self.rng.uniform(-0.6, 0.6, 3)
        return self.rng.uniform(-0.5, 0.5) if c in "sxy" else self.rng.uniform(-1.2, 1.2)

    def axis(self, kind):
        if self.flat:
            slides = kind.startswith("Prismatic")
            return np.r_[self.rng.normal(size=2), 0] if slides else Z * (1 if self.planar else self.rng.choice([1, -1]))
        axis = self.rng.integers(-2, 3, 3).astype(float)
        return axis if axis.any() else np.array([1.0, 2, 2])

    def joint(self, name, kind, a, b):
        start = {c: self.value(c) for c in (PLANAR if self.planar else COORDINATES).get(kind, [])}
        joint = Joint(name, kind, a, b, self.place(), self.place(), start=start)
        if kind in ("Revolute", "Prismatic", "Cylindrical", "Screw", "Planar", *DRIVES):
            joint.axis = self.axis(kind)
        if kind == "Screw":
            joint.lead = self.rng.uniform(-0.5, 0.5)
        if kind in DRIVES:
            joint.drive = self.rng.uniform(0.2, 0.6), self.rng.uniform(1, 3), self.rng.uniform(-1, 1)
        return joint

    def loads(self, joint):
        for c in joint.start:
            if c not in SIZES and self.rng.random() < 0.4:
                on = self.rng.random(3) < (0.6, 0.35, 0.4)
                size = self.rng.uniform(-3, 3), self.rng.uniform(1, 8), self.rng.uniform(0.1, 1)
                constant, stiffness, damping = np.where(on, size, 0.0).tolist()
                joint.loads[c] = constant, stiffness, self.rng.uniform(-0.5, 0.5), damping

    def grow(self, joint):
        """The pose of the hub that the joint carries."""
        rel = relative(joint, joint.start, {c: np.zeros_like(v) for c, v in joint.start.items()}, 0.0)
        (da, Da), (db, Db) = joint.at_a, joint.at_b
        if joint.a in self.pose:
            r, R = self.pose[joint.a]
            A = R @ Da
            H = A @ rel.R @ Db.T
            self.pose[joint.b] = r + R @ da + A @ rel.p - H @ db, H
        else:
            r, R = self.pose[joint.b]
            A = R @ Db @ rel.R.T
            H = A @ Da.T
            self.pose[joint.a] = r + R @ db - A @ rel.p - H @ da, H

    def close(self, joint):
        """Moves the far end of the joint to where the loop closes."""
        rel = relative(joint, joint.start, {c: np.zeros_like(v) for c, v in joint.start.items()}, 0.0)
        (r, R), (rb, B) = self.pose[joint.a], self.pose[joint.b]
        A = R @ joint.at_a[1]
        joint.at_b = B.T @ (r + R @ joint.at_a[0] + A @ rel.p - rb), B.T @ A @ rel.R


def mechanism(seed, *, bodies, kinds, loops, flat=False, planar=False, base=False):
    """A tree with the given kinds of joints; or a chain, closed by joints `loops`: (kind, hub, hub)."""
    draw = Draw(seed, flat, planar)
    rng = draw.rng
    found = Mechanism([draw.body() for _ in range(bodies)], [])
    if base:
        way = rng.uniform(-0.2, 0.2, 3) * ((1, 1, 0) if draw.flat else 1)
        found.base = way, rng.uniform(1, 3), Z if draw.flat else rng.normal(size=3), rng.uniform(-0.5, 0.5)
        draw.pose[BASE] = ZERO, np.eye(3)
    for k in range(bodies):
        first = BASE if base else WORLD
        parent = first if k == 0 else k - 1 if loops else int(rng.choice([WORLD, k - 1, k - 1, k - 1]))
        ends = (parent, k) if rng.random() < 0.6 else (k, parent)
        joint = draw.joint(f"J{k + 1}", kinds[k % len(kinds)], *ends)
        draw.grow(joint)
        found.joints.append(joint)
    for kind, a, b in loops:
        joint = draw.joint(f"J{len(found.joints) + 1}", kind, a, b)
        draw.close(joint)
        found.joints.append(joint)
    for joint in found.joints:
        draw.loads(joint)
    ends = rng.choice([WORLD, *range(bodies)], 2, replace=False).tolist()
    found.springs.append((ends[0], draw.place()[0], ends[1], draw.place()[0], 9.0, 0.3, rng.uniform(0.1, 1)))
    keep = (1, 1, 0) if draw.flat else (1, 1, 1)
    torque = rng.normal(size=3) * ((0, 0, 1) if draw.flat else 1)
    found.loads.append((int(rng.integers(bodies)), draw.place()[0], rng.normal(size=3) * keep, torque))
    return found


def vector(values):
    return "{" + ", ".join(repr(float(x)) for x in values) + "}"


def hub(k):
    return {WORLD: "world", BASE: "base"}.get(k, f"B{k + 1}.frame_a")


def text(found, seed, planar=False):
    """The model; declarations and connections in random order, some joints marked as ones to keep or to cut. Outputs:
    `o_J_c` and `d_J_c` coordinates and rates, `F_J` and `T_J` the reaction, of joint J."""
    rng = np.random.default_rng(seed + 77)
    n = 2 if planar else 3
    parts, loads, outputs, pairs = [], [], [], []
    for k, (m, com, I) in enumerate(found.bodies):
        elements = (I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[0, 2], I[1, 2])
        inertia = f"Izz = {float(I[2, 2])!r}" if planar else f"I = {vector(elements)}"
        parts.append(f"Body B{k + 1}(m = {float(m)!r}, com = {vector(com[:n])}, {inertia});")
    closed = len(found.joints) > len(found.bodies)  # then rates of several joints would contradict each other
    for joint in found.joints:
        name = joint.name
        modifiers = ", ".join(_modifiers(joint, rng, planar, 9 if not closed else joint is found.joints[0]))
        parts.append(f"{joint.kind} {name}({modifiers});" if modifiers else f"{joint.kind} {name};")
        parts += [_weld(f"{name}a", joint.at_a, planar), _weld(f"{name}b", joint.at_b, planar)]
        pairs += [(hub(joint.a), f"{name}a.frame_a"), (f"{name}a.frame_b", f"{name}.frame_a")]
        pairs += [(f"{name}.frame_b", f"{name}b.frame_b"), (f"{name}b.frame_a", hub(joint.b))]
        loads += _loads(joint)
        outputs += _outputs(joint)
    for i, (ka, pa, kb, pb, stiffness, rest, damping) in enumerate(found.springs):
        ends = ", ".join(f"{e} = {hub(k)}.point((1 m)*{vector(p)})" for e, k, p in (("a", ka, pa), ("b", kb, pb)))
        parts.append(f"SpringDamper S{i}({ends}, k = {stiffness!r}, rest = {rest!r}, c = {float(damping)!r});")
    for k, at, force, torque in found.loads:
        loads.append(f"force (1 N)*{vector(force)} at {hub(k)}.point((1 m)*{vector(at)});")
        loads.append(f"torque (1 N.m)*{hub(k)}.vec({vector(torque)}) on {hub(k)};")
    pairs = [pair[::-1] if rng.random() < 0.5 else pair for pair in pairs]
    parts = [parts[i] for i in rng.permutation(len(parts))]
    connects = [f"connect({pairs[i][0]}, {pairs[i][1]});" for i in rng.permutation(len(pairs))]
    lines = [*_base(found), *parts, "gravity = -g_n*world.y;", *loads, *connects, *outputs]
    library = "Planar" if planar else "Spatial"
    return "\n  ".join(["model M", f"import Lag.{library}.*;", *lines]) + "\nend M;\n"


def _base(found):
    if not found.base:
        return []
    way, pace, axis, angle = found.base
    wave = f"sin({float(pace)!r}*time/(1 s))"
    n = axis / np.linalg.norm(axis)
    return [f"frame base = world.move((1 m)*{vector(way)}*{wave}).rotate({vector(n)}, {float(angle)!r}*{wave});"]


def _weld(name, at, planar):
    r, R = at
    if planar:
        return f"Weld {name}(r = {vector(r[:2])}, angle = {float(np.arctan2(R[1, 0], R[0, 0]))!r});"
    angles = np.arctan2(-R[1, 2], R[2, 2]), np.arcsin(np.clip(R[0, 2], -1, 1)), np.arctan2(-R[0, 1], R[0, 0])
    return f"Weld {name}(r = {vector(r)}, angles = {vector(angles)});"


def _modifiers(joint, rng, planar, rates):
    """With start rates of so many coordinates at most."""
    found = []
    if joint.axis is not None and not (planar and joint.kind == "Revolute"):
        found.append(f"axis = {vector(joint.axis[: 2 if planar else 3])}")
    if joint.kind == "Screw":
        found.append(f"lead = {float(joint.lead)!r}")
    if joint.drive:
        size, pace, phase = (float(x) for x in joint.drive)
        name, unit = ("angle", "1") if joint.kind == "RevoluteDrive" else ("way", "(1 m)")
        found.append(f"{name} = {unit}*{size!r}*sin({pace!r}*time/(1 s) + {phase!r})")
    wish = rng.choice(["", "", ", prefer = always", ", prefer = never"])
    for k, (c, value) in enumerate(joint.start.items()):
        rate = rng.normal(size=np.shape(value))
        if c == "e":
            rate = rate - value * (value @ rate)
        write = vector if np.shape(value) else (lambda x: repr(float(x)))
        of_rate = f", der(start = {write(rate)})" if k < rates else ""
        found.append(f"{c}(start = {write(value)}{of_rate}{wish})")
        wish = ""
    return found


def _loads(joint):
    found = []
    for c, (constant, stiffness, rest, damping) in joint.loads.items():
        word, load, spring, damper, unit = UNITS[c in "qab"]
        q = f"{joint.name}.{c}"
        if constant:
            found.append(f"{word} ({constant!r} {load}) on {q};")
        if stiffness:
            found.append(f"potential 1/2*({stiffness!r} {spring})*({q} - ({float(rest)!r} {unit}))^2;")
        if damping:
            found.append(f"dissipation 1/2*({damping!r} {damper})*der({q})^2;")
    return found


def _outputs(joint):
    name = joint.name
    found = [f"output Force F_{name}[3] = reaction({name}).force;"]
    found.append(f"output Torque T_{name}[3] = reaction({name}).torque;")
    for c in joint.start:
        size = f"[{SIZES[c]}]" if c in SIZES else ""
        unit = {"e": "1/s", "r": "m/s"}.get(c, "m/s" if c in "sxy" else "rad/s")
        kind = "Real" if c == "e" else "Length" if unit == "m/s" else "Angle"
        found.append(f"output {kind} o_{name}_{c}{size} = {name}.{c};")
        found.append(f'output Real d_{name}_{c}{size}(unit = "{unit}") = der({name}.{c});')
    return found
