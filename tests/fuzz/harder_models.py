"""Random models of what is hard to see: corners of time and place, other scales, instances, switched constraints, and
ticks and stops at crossings. On them what `event_models` puts on any mechanism.

`harder_model(seed)` is the same model for a seed on every machine; `known` are the instants of its text at which
something may happen, for an independent stepping.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

from fuzz.event_models import (
    Draft,
    ball,
    bead,
    box,
    cart,
    counter,
    double_pendulum,
    first,
    pendulum,
    row,
    sampled,
    thrown_back,
    two_masses,
)


@dataclass(frozen=True)
class Hard:
    text: str
    stop: float
    known: tuple[float, ...]
    scales: dict[str, float]  # of coordinates that have one of their own; of the others 1


@dataclass
class HardDraft(Draft):
    """With classes before it, instants that are known, and the scales of coordinates that have one of their own."""

    classes: list[str] = field(default_factory=list)
    known: list[float] = field(default_factory=list)
    scales: dict[str, float] = field(default_factory=dict)
    stop: float = 2.0

    def instant(self) -> float:
        return float(self.number(0.1, 1.8))


# ---- mechanisms ------------------------------------------------------------------------------------------------------


def scaled_ball(d: HardDraft) -> None:
    """A bounce in another scale of length, in the same time."""
    h, scale = d.name("h"), d.random.choice([1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9])
    d.scales[h] = scale
    start, speed, e = scale * float(d.number(0.3, 1.5)), scale * float(d.number(-2, 2)), d.restitution()
    m = d.random.choice(["1", "1e-6", "1e6"])
    d.items.append(f"coordinate Real {h}(start = {start:.6g}, nominal = {scale:g}, der(start = {speed:.6g}));")
    d.items.append(f"kinetic 1/2*{m}*der({h})^2; potential {m}*{9.81 * scale:.6g}*{h};")
    d.items.append(f"contact {d.name('c')}: {h} >= 0 with restitution = {e};")
    d.signals += [(h, 0.2 * scale, 1.0 * scale)]


def stranger(d: HardDraft) -> None:
    x, size = d.name("odo"), d.random.choice(["1e-9", "1e5", "1e7", "1e9"])
    start, rate = d.random.choice([(size, "0"), ("0", size), (size, "1")])
    d.scales |= {x: 1e-9} if size == "1e-9" else {}
    d.items.append(f"coordinate Real {x}(start = {start}, der(start = {rate})); kinetic 1/2*der({x})^2;")


def base(d: HardDraft) -> None:
    """A mass and a spring on a base that starts to move."""
    x, at, v, k = d.name("x"), d.instant(), d.number(0.2, 2), d.number(5, 50)
    ways = [
        f"max(0, {v}*(time - {at:.6g}))",
        f"(if time < {at:.6g} then 0 else {v}*(time - {at:.6g}))",
        f"{v}*limit(time - {at:.6g}, 0, 9)",
        f"table(time, {{0, {at:.6g}, {at + 8:.6g}}}, {{0, 0, 8*{v}}})",
    ]
    d.known.append(at)
    d.items.append(f"coordinate Real {x}(start = {d.number(-0.2, 0.2)}); potential 1/2*{k}*{x}^2;")
    d.items.append(f"Real r{x} = {d.random.choice(ways)}; kinetic 1/2*{d.number(0.5, 2)}*(der({x}) + der(r{x}))^2;")
    d.signals += [(x, -0.2, 0.2)]
    d.free.append(x)


def clutch(d: HardDraft) -> None:
    """Two discs that are coupled by time, by an angle, or by a clause."""
    a, b, at = d.name("x"), d.name("x"), d.instant()
    d.items.append(f"coordinate Real {a}(der(start = {d.number(0.3, 1)})), {b}(start = {d.number(-0.1, 0.1)});")
    d.items.append(f"kinetic 1/2*{d.number(0.5, 2)}*der({a})^2 + 1/2*{d.number(0.5, 2)}*der({b})^2;")
    d.items.append(f"potential 1/2*{d.number(1, 10)}*{b}^2; force {d.number(0.1, 1)} on {a};")
    how = d.random.choice(["time", "angle", "clause", "clock"])
    condition = f"time > {at:.6g}" if how == "time" else f"{a} > {d.number(0.1, 0.5)}"
    if how in ("clause", "clock"):
        on = d.name("on")
        d.items.append(f"discrete Boolean {on}(start = false);")
        trigger = condition if how == "clause" else f"sample({at:.6g}, 9)"
        d.equations.append(f"when {trigger} then {on} = true; end when;")
        condition = on
    d.items.append(f"constraint {d.name('j')}: (if {condition} then der({a}) - der({b}) else 0) = 0;")
    d.known.append(at)
    d.signals += [(b, -0.1, 0.1)]


def driven(d: HardDraft) -> None:
    """A spring whose end is driven at a speed with jumps or corners."""
    a, b, at, v = d.name("x"), d.name("x"), d.instant(), d.number(0.2, 2)
    speeds = [
        f"if time < {at:.6g} then 0 else {v}",
        f"{v}*limit((time - {at:.6g})/0.05, 0, 1)",
        f"table(time, {{0, {at:.6g}, {at + 0.1:.6g}, 9}}, {{0, 0, {v}, {v}}})",
    ]
    d.known += [at, at + 0.05, at + 0.1]
    d.items.append(f"coordinate Real {a}, {b}(start = {d.number(-0.2, 0.2)});")
    d.items.append(f"kinetic 1/2*der({a})^2 + 1/2*der({b})^2; potential 1/2*{d.number(5, 50)}*({a} - {b})^2;")
    d.items.append(f"constraint {d.name('j')}: der({a}) = {d.random.choice(speeds)};")
    d.signals += [(b, -0.2, 0.5)]
    d.free.append(b)


def instances(d: HardDraft) -> None:
    """Two of one class, with an array and a contact in it, and values of their own."""
    name = d.name("Part")
    d.classes.append(
        f"model {name}\n  parameter Real m[2] = {{1, 1}}, k = 1, wall = 1, e = 1;\n"
        "  coordinate Real x[2](start = {0.1, -0.1}, der(start = {1, 0}));\n"
        "  for i in 1:2 loop kinetic 1/2*m[i]*der(x[i])^2; end for;\n"
        "  potential 1/2*k*(x[1] - x[2])^2 + 1/2*k*x[1]^2;\n"
        "  contact c: x[1] <= wall with restitution = e;\n"
        f'  annotation(units = "none");\nend {name};\n'
    )
    for _ in range(2):
        part = d.name("p")
        masses = f"{{{d.number(0.5, 2)}, {d.number(0.5, 2)}}}"
        values = f"m = {masses}, k = {d.number(5, 50)}, wall = {d.number(0.15, 0.3)}, e = {d.restitution()}"
        d.items.append(f"{name} {part}({values});")
        d.signals += [(f"{part}.x[2]", -0.1, 0.1)]


def on_time(d: HardDraft) -> None:
    """A coordinate that is the time, and ticks, crossings and the stop where it is round."""
    x, n, k = d.name("x"), d.name("n"), d.name("k")
    period = d.random.choice(["0.1", "0.25", "0.125", "0.5"])
    at = d.random.choice(["0.5", "1", "1.5", "0.7"])
    d.items.append(f"coordinate Real {x}(der(start = 1)); kinetic 1/2*der({x})^2;")
    d.items.append(f"discrete Integer {n}(start = 0), {k}(start = 0);")
    d.equations.append(f"when {x} {d.random.choice(['>', '>='])} {at} then {n} = pre({n}) + 1; end when;")
    d.equations.append(f"when sample(0, {period}) then {k} = pre({k}) + 1; end when;")
    d.stop = d.random.choice([2.0, 1.5, 1.0])


# ---- what acts on them -----------------------------------------------------------------------------------------------


def pulse(d: HardDraft) -> None:
    at, width = d.instant(), d.random.choice([1e-5, 1e-3, 0.02, 0.1])
    strength = float(d.number(0.1, 0.5)) / width
    d.known += [at - width, at, at + width]
    force = f"{strength:.6g}*max(0, 1 - abs(time - {at:.6g})/{width})"
    d.items.append(f"force {force} on {d.random.choice(d.free)};")


def push_by_table(d: HardDraft) -> None:
    at, width = d.instant(), d.random.choice([1e-4, 0.01, 0.1])
    points = [at, at + width, at + 2 * width]
    d.known += points
    xs = ", ".join(f"{x:.9g}" for x in (-1.0, *points, 9.0))
    d.items.append(f"force table(time, {{{xs}}}, {{0, 0, {0.3 / width:.6g}, 0, 0}}) on {d.random.choice(d.free)};")


def saw(d: HardDraft) -> None:
    period = d.random.choice([0.11, 0.3, 0.7])
    d.known += [k * period for k in range(1, int(2 / period) + 1)]
    d.items.append(f"force {d.number(1, 5)}*(mod(time, {period}) - {period / 2}) on {d.random.choice(d.free)};")


def corner_of_place(d: HardDraft) -> None:
    x, a, k = d.random.choice(d.free), d.number(-0.2, 0.3), d.number(5, 100)
    forces = [
        f"-{k}*max(0, {x} - {a})",
        f"-{k}*limit({x}, -0.1, {a})/10" if float(a) > -0.1 else f"-{k}*abs({x} - {a})/10",
        f"-table({x}, {{-9, -0.1, 0.1, 9}}, {{-{k}, -0.5, 0.5, {k}}})",
        f"{k}/10*min({x}, {a})",
        f"-{d.number(0.1, 1)}*abs(der({x}))*der({x})",
    ]
    d.items.append(f"force {d.random.choice(forces)} on {x};")


def narrow_of_place(d: HardDraft) -> None:
    x, a, w = d.random.choice(d.free), d.number(-0.1, 0.2), d.random.choice(["0.003", "0.02"])
    d.items.append(f"force {d.number(1, 10)}*max(0, 1 - abs({x} - {a})/{w}) on {x};")


OWN: tuple[Callable[[HardDraft], None], ...] = (scaled_ball, base, clutch, driven, instances, on_time)
KNOWN = (ball, cart, pendulum, bead, box, row, two_masses, double_pendulum)
ACTS: tuple[Callable[[HardDraft], None], ...] = (pulse, push_by_table, saw, corner_of_place, narrow_of_place)
LATER = (counter, first, sampled, thrown_back)


def harder_model(seed: int) -> Hard:
    d = HardDraft(Random(seed))
    for mechanism in d.random.sample(OWN, d.random.choice([1, 1, 2])):
        mechanism(d)
    if d.random.random() < 0.4 or not d.free:
        d.random.choice(KNOWN)(d)
    if d.random.random() < 0.3:
        stranger(d)
    if d.free:
        for act in d.random.sample(ACTS, d.random.choice([1, 1, 2])):
            act(d)
    for later in d.random.sample(LATER, d.random.choice([0, 1, 1, 2])):
        if d.free or later in (counter, first):
            later(d)
    body = "\n  ".join(d.items)
    clauses = "".join(f"\n  {line}" for line in d.equations if line)
    section = f"\nequation{clauses}" if clauses else ""
    end = f'annotation(units = "none", experiment(StopTime = {d.stop}));'
    text = f"{''.join(d.classes)}model Hard{seed}\n  {body}\n  {end}{section}\nend Hard{seed};\n"
    return Hard(text, d.stop, tuple(sorted(t for t in set(d.known) if 0 < t < d.stop)), d.scales)
