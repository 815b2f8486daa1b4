"""Random models with events: mechanisms of every kind, with contacts, clauses, clocks and switched forces on them.

`event_model(seed)` is the text of one, the same for a seed on every machine.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import pairwise
from random import Random

STOP = 2.0


@dataclass
class Draft:
    """A model in the making. `signals` are quantities with values at which something may happen, `free` coordinates
    that a force may drive."""

    random: Random
    items: list[str] = field(default_factory=list)
    equations: list[str] = field(default_factory=list)
    signals: list[tuple[str, float, float]] = field(default_factory=list)
    free: list[str] = field(default_factory=list)
    count: int = 0

    def number(self, low: float, high: float) -> str:
        return f"{self.random.uniform(low, high):.4g}"

    def name(self, stem: str) -> str:
        self.count += 1
        return f"{stem}{self.count}"

    def restitution(self) -> str:
        return self.random.choice(["0", "0.3", "0.5", "0.8", "0.95", "1"])

    def contact(self, gap: str) -> None:
        """Rigid, or sometimes with a spring and a damper."""
        law = f"restitution = {self.restitution()}"
        if self.random.random() < 0.15:
            law = f"compliance = {self.number(1e3, 1e4)}, damping = {self.number(0, 2)}"
        self.items.append(f"contact {self.name('c')}: {gap} with {law};")


# ---- mechanisms ------------------------------------------------------------------------------------------------------


def ball(d: Draft) -> None:
    h, m = d.name("h"), d.number(0.1, 3)
    d.items.append(f"coordinate Real {h}(start = {d.number(0.3, 1.5)}, der(start = {d.number(-2, 2)}));")
    d.items.append(f"kinetic 1/2*{m}*der({h})^2; potential {m}*9.81*{h};")
    table = d.random.choice(["0", "0", f"{d.number(0.01, 0.1)}*sin({d.number(2, 25)}*time)"])
    d.contact(f"{h} >= {table}")
    d.signals += [(h, 0.2, 1.0), (f"der({h})", -3.0, 3.0)]


def cart(d: Draft) -> None:
    x = d.name("x")
    d.items.append(f"coordinate Real {x}(start = {d.number(-0.5, 0.5)}, der(start = {d.number(-2, 2)}));")
    d.items.append(f"kinetic 1/2*{d.number(0.2, 3)}*der({x})^2; potential 1/2*{d.number(5, 200)}*{x}^2;")
    d.items.append(f"dissipation 1/2*{d.number(0, 1)}*der({x})^2;")
    for gap in (f"{x} >= -{d.number(0.5, 0.8)}", f"{x} <= {d.number(0.5, 0.8)}"):
        if d.random.random() < 0.5:
            d.contact(gap)
    d.signals += [(x, -0.4, 0.4), (f"der({x})", -2.0, 2.0)]
    d.free.append(x)


def pendulum(d: Draft) -> None:
    a, m, l = d.name("a"), d.number(0.2, 2), d.number(0.3, 1.5)
    d.items.append(f"coordinate Real {a}(start = {d.number(-1.2, 1.2)}, der(start = {d.number(-1, 1)}));")
    d.items.append(f"kinetic 1/2*{m}*{l}^2*der({a})^2; potential -{m}*9.81*{l}*cos({a});")
    d.items.append(f"dissipation 1/2*{d.number(0, 0.3)}*der({a})^2;")
    if d.random.random() < 0.6:
        d.contact(f"{a} >= -{d.number(1.2, 1.4)}" if d.random.random() < 0.3 else f"sin({a}) >= -0.95")
    d.signals += [(a, -0.8, 0.8), (f"der({a})", -2.0, 2.0)]
    d.free.append(a)


def bead(d: Draft) -> None:
    """On a circle, by a constraint."""
    x, y = d.name("x"), d.name("y")
    speed = float(d.number(-1, 1))
    rates = f"der(start = {speed:.4g})", f"der(start = {0.75 * speed:.17g})"
    d.items.append(f"coordinate Real {x}(start = 0.6, {rates[0]}), {y}(start = -0.8, {rates[1]});")
    d.items.append(f"kinetic 1/2*(der({x})^2 + der({y})^2); potential 9.81*{y};")
    d.items.append(f"constraint {x}^2 + {y}^2 = 1;")
    if d.random.random() < 0.7:
        d.contact(f"{x} >= -{d.number(0.1, 0.5)}")
    d.signals += [(x, -0.5, 0.5), (f"der({x})", -1.5, 1.5)]
    d.free.append(x)


def box(d: Draft) -> None:
    """A plank above the ground that falls on its corners."""
    x, y, a = d.name("x"), d.name("y"), d.name("a")
    half, e = d.number(0.1, 0.3), d.random.choice(["0", "0.3", "0.6"])
    tilt = d.random.choice(["0", d.number(-0.6, 0.6)])
    d.items.append(f"coordinate Real {x}(der(start = {d.number(-1, 1)})), {y}(start = 0.6), {a}(start = {tilt});")
    d.items.append(f"kinetic 1/2*(der({x})^2 + der({y})^2) + 1/2*{d.number(0.005, 0.03)}*der({a})^2;")
    d.items.append(f"potential 9.81*{y};")
    for sign in "+-":
        d.items.append(f"contact {d.name('c')}: {y} {sign} {half}*sin({a}) >= 0 with restitution = {e};")
    d.signals += [(y, 0.2, 0.5), (a, -0.3, 0.3)]
    d.free.append(x)


def row(d: Draft) -> None:
    """Balls in a row that strike each other."""
    n, e, start = d.random.randint(2, 4), d.restitution(), -0.5
    names = [d.name("x") for _ in range(n)]
    for i, x in enumerate(names):
        speed = d.number(0.5, 2) if i == 0 else "0"
        d.items.append(f"coordinate Real {x}(start = {start:.4g}, der(start = {speed}));")
        d.items.append(f"kinetic 1/2*{d.random.choice(['1', d.number(0.5, 2)])}*der({x})^2;")
        start += 0.1 if i and d.random.random() < 0.5 else 0.1 + float(d.number(0.01, 0.3))
    for left, right in pairwise(names):
        d.items.append(f"contact {d.name('c')}: {right} - {left} >= 0.1 with restitution = {e};")
    if d.random.random() < 0.5:
        d.contact(f"{names[-1]} <= {start + 0.2:.4g}")
    d.signals.append((names[0], -0.4, 0.2))
    d.free.append(names[0])


def two_masses(d: Draft) -> None:
    """Coupled by a spring with play."""
    a, b, k, s = d.name("x"), d.name("x"), d.number(20, 200), d.number(0.02, 0.1)
    play = f"(if {a} - {b} > {s} then {a} - {b} - {s} elseif {a} - {b} < -{s} then {a} - {b} + {s} else 0)"
    d.items.append(f"coordinate Real {a}(der(start = {d.number(0.5, 2)})), {b}(start = {d.number(-0.01, 0.01)});")
    d.items.append(f"kinetic 1/2*{d.number(0.5, 2)}*der({a})^2 + 1/2*{d.number(0.5, 2)}*der({b})^2;")
    d.items.append(f"potential 1/2*{d.number(1, 20)}*{a}^2;")
    d.items.append(f"force -{k}*{play} on {a}; force {k}*{play} on {b};")
    if d.random.random() < 0.5:
        d.contact(f"{b} <= {d.number(0.2, 0.5)}")
    d.signals += [(a, -0.2, 0.2), (f"{a} - {b}", -0.1, 0.1)]
    d.free.append(a)


def double_pendulum(d: Draft) -> None:
    a, b, c = d.name("a"), d.name("a"), d.number(0.2, 0.8)
    d.items.append(f"coordinate Real {a}(start = {d.number(-1, 1)}), {b}(start = {d.number(-1, 1)});")
    d.items.append(
        f"kinetic 1/2*der({a})^2 + 1/2*{c}*(der({a})^2 + der({b})^2 + 2*der({a})*der({b})*cos({a} - {b}));"
        f" potential -9.81*((1 + {c})*cos({a}) + {c}*cos({b}));"
    )
    d.contact(f"sin({a}) + sin({b}) >= -{d.number(0.3, 1.0)}")
    d.signals += [(a, -0.5, 0.5), (b, -0.5, 0.5)]
    d.free.append(a)


def tank(d: Draft) -> None:
    """A state that fills and drains."""
    s, pump = d.name("s"), d.name("on")
    low, high = d.number(0.2, 0.4), d.number(0.6, 0.9)
    d.items.append(f"state Real {s}(start = {d.number(0.3, 0.6)}); discrete Boolean {pump}(start = true);")
    d.equations.append(f"der({s}) = (if {pump} then {d.number(2, 6)} else 0) - {d.number(1, 2)}*{s};")
    d.equations.append(f"when {s} > {high} then {pump} = false; elsewhen {s} < {low} then {pump} = true; end when;")
    d.signals.append((s, 0.3, 0.7))


# ---- what happens to them --------------------------------------------------------------------------------------------


def _relation(d: Draft) -> str:
    signal, low, high = d.random.choice(d.signals)
    return f"{signal} {d.random.choice(['>', '<', '>=', '<='])} {d.number(low, high)}"


def counter(d: Draft) -> None:
    n = d.name("n")
    d.items.append(f"discrete Integer {n}(start = 0);")
    conditions = [_relation(d) for _ in range(d.random.choice([1, 1, 2]))]
    condition = conditions[0] if len(conditions) == 1 else "{" + ", ".join(conditions) + "}"
    d.equations.append(f"when {condition} then {n} = pre({n}) + 1; end when;")


def conjunction(d: Draft) -> None:
    n, join = d.name("n"), d.random.choice(["and", "or"])
    d.items.append(f"discrete Real {n}(start = 0);")
    d.equations.append(f"when {_relation(d)} {join} {_relation(d)} then {n} = pre({n}) + time; end when;")


def relay(d: Draft) -> None:
    x, on = d.random.choice(d.free), d.name("on")
    low, width = float(d.number(-0.2, 0.1)), float(d.number(0.05, 0.2))
    d.items.append(f"discrete Boolean {on}(start = false); force if {on} then -{d.number(1, 5)} else 1 on {x};")
    d.equations.append(
        f"when {x} > {low + width:.4g} then {on} = true; elsewhen {x} < {low:.4g} then {on} = false; end when;"
    )


def sampled(d: Draft) -> None:
    x, u, h = d.random.choice(d.free), d.name("u"), d.random.choice(["0.01", "0.05", "0.1", "0.13"])
    start = d.random.choice(["0", "0", "0.02"])
    d.items.append(f"discrete Real {u}(start = 0); force {u} on {x};")
    d.equations.append(
        f"when sample({start}, {h}) then {u} = -{d.number(1, 20)}*{x} - {d.number(0, 3)}*der({x}); end when;"
    )


def integrator(d: Draft) -> None:
    x, i, k = d.random.choice(d.free), d.name("i"), d.name("k")
    h = d.random.choice(["0.1", "0.05"])
    d.items.append(f"discrete Real {i}(start = 0); discrete Integer {k}(start = 0);")
    d.items.append(f"force -{d.number(0.5, 5)}*{i} on {x};")
    d.equations.append(f"when sample(0, {h}) then {i} = pre({i}) + {h}*{x}; {k} = pre({k}) + 1; end when;")
    if d.random.random() < 0.5:
        d.equations.append(f"when {k} >= {d.random.randint(5, 15)} then reinit(der({x}), 0); end when;")


def thrown_back(d: Draft) -> None:
    x, e = d.random.choice(d.free), d.number(0.3, 1)
    sign, at = d.random.choice([(">", "0.45"), ("<", "-0.45")])
    d.equations.append(f"when {x} {sign} {at} then reinit(der({x}), -{e}*pre(der({x}))); end when;")


def struck(d: Draft) -> None:
    x, e = d.random.choice(d.free), d.restitution()
    gap = d.random.choice([f"0.4 - {x}", f"{x} + 0.4"])
    d.equations.append(f"when {gap} <= 0 then impact({gap}, {e}); end when;")


def spring(d: Draft) -> None:
    x, a, k = d.random.choice(d.free), d.number(-0.2, 0.3), d.number(20, 500)
    d.items.append(f"force if {x} > {a} then -{k}*({x} - {a}) else 0 on {x};")


def wind(d: Draft) -> None:
    """A force that jumps with a signal or with time."""
    x = d.random.choice(d.free)
    condition = d.random.choice([_relation(d), f"time > {d.number(0.2, 1.5)}", f"sin({d.number(3, 9)}*time) > 0.3"])
    d.items.append(f"force if {condition} then {d.number(-3, 3)} else {d.number(-3, 3)} on {x};")


def friction(d: Draft) -> None:
    x = d.random.choice(d.free)
    d.items.append(f"force -{d.number(0.2, 2)}*tanh(der({x})/{d.number(0.01, 0.1)}) on {x};")


def hammer(d: Draft) -> None:
    s, x = d.name("s"), d.random.choice(d.free)
    d.items.append(f"state Real {s}(start = 0); discrete Integer {d.name('n')}(start = 0);")
    n = f"n{d.count}"
    d.equations.append(f"der({s}) = {d.number(1, 3)};")
    d.equations.append(
        f"when {s} >= 1 then reinit({s}, 0); reinit(der({x}), der({x}) + {d.number(-1, 1)});"
        f" {n} = pre({n}) + 1; end when;"
    )
    d.equations.append(f'when {n} >= 3 then terminate("enough"); end when;' if d.random.random() < 0.2 else "")


def first(d: Draft) -> None:
    n = d.name("n")
    d.items.append(f"discrete Integer {n}(start = 0);")
    d.equations.append(f"when initial() then {n} = 3; elsewhen {_relation(d)} then {n} = pre({n}) + 2; end when;")


MECHANISMS: tuple[Callable[[Draft], None], ...] = (
    ball,
    cart,
    pendulum,
    bead,
    box,
    row,
    two_masses,
    double_pendulum,
    tank,
)
ON_ANY = (counter, conjunction, first)
ON_FREE = (relay, sampled, integrator, thrown_back, struck, spring, wind, friction, hammer)


def event_model(seed: int) -> str:
    """The text of one model, named `Random<seed>`."""
    d = Draft(Random(seed))
    for mechanism in d.random.sample(MECHANISMS, d.random.choice([1, 1, 1, 2, 2, 3])):
        mechanism(d)
    kinds = (*ON_ANY, *ON_FREE) if d.free else ON_ANY
    for kind in d.random.sample(kinds, d.random.choice([0, 1, 1, 2, 3][: len(kinds) + 1])):
        kind(d)
    body = "\n  ".join(d.items)
    clauses = "".join(f"\n  {line}" for line in d.equations if line)
    section = f"\nequation{clauses}" if clauses else ""
    end = 'annotation(units = "none", experiment(StopTime = 2));'
    return f"model Random{seed}\n  {body}\n  {end}{section}\nend Random{seed};\n"
