"""Random models with dry friction: scalar, with limits that are constant, higher at rest, or mu times the force of
a contact, and rows that are one way. Forces with frequencies that have nothing in common move them.

`friction_model(seed)` is the text of one, the same for a seed on every machine.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from fuzz.event_models import Draft

STOP = 2.0


class FrictionDraft(Draft):
    """With drives and limits."""

    def drive(self, x: str, strength: float = 1.0) -> None:
        """A force of two sines."""
        waves = (f"{self.number(0.3, 1)}*sin({self.number(1, 6)}*time + {self.number(0, 6)})" for _ in range(2))
        self.items.append(f"force {strength:.4g}*({' + '.join(waves)}) on {x};")

    def friction(self, slip: str, limit: str) -> None:
        law = f"limit = {limit}"
        if self.random.random() < 0.4:
            law += f", sticking = {self.number(1.05, 1.6)}*{limit}"
        self.items.append(f"friction {self.name('f')}: {slip} with {law};")

    def rough(self, gap: str, slip: str, e: str) -> None:
        law = f"restitution = {e}, friction = {self.number(0.1, 0.7)}"
        if self.random.random() < 0.3:
            law += f", sticking = {self.number(0.7, 0.9)}"
        self.items.append(f"contact {self.name('c')}: {gap} with {law}, slip = {slip};")


def _slider(d: FrictionDraft) -> None:
    """On a spring, on a floor or a belt."""
    x = d.name("x")
    belt = d.random.choice(["", f" - {d.number(0.1, 0.6)}", f" - {d.number(0.1, 0.5)}*cos({d.number(1, 4)}*time)"])
    d.items.append(f"coordinate Real {x}(start = {d.number(-1, 1)}, der(start = {d.number(-1, 1)}));")
    d.items.append(f"kinetic 1/2*{d.number(0.5, 2)}*der({x})^2; potential 1/2*{d.number(1, 20)}*{x}^2;")
    d.friction(f"der({x}){belt}", d.number(0.3, 2))
    d.drive(x)


def _chain(d: FrictionDraft) -> None:
    """Masses on springs, each with friction."""
    last = ""
    for _ in range(d.random.choice([2, 3])):
        x = d.name("x")
        d.items.append(f"coordinate Real {x}(start = {d.number(-0.5, 0.5)}, der(start = {d.number(-1, 1)}));")
        d.items.append(f"kinetic 1/2*{d.number(0.5, 2)}*der({x})^2;")
        d.items.append(f"potential 1/2*{d.number(2, 20)}*{f'({x} - {last})' if last else x}^2;")
        d.friction(f"der({x}) - der({last})" if last and d.random.random() < 0.3 else f"der({x})", d.number(0.2, 1))
        last = x
    d.drive(last, 2.0)


def _clutch(d: FrictionDraft) -> None:
    a, b = d.name("a"), d.name("b")
    for x in (a, b):
        d.items.append(
            f"coordinate Real {x}(der(start = {d.number(-2, 2)})); kinetic 1/2*{d.number(0.5, 3)}*der({x})^2;"
        )
        d.drive(x, 3.0)
    d.friction(f"der({a}) - der({b})", d.number(0.5, 2))
    if d.random.random() < 0.5:
        d.friction(f"der({b})", d.number(0.1, 0.5))


def _ratchet(d: FrictionDraft) -> None:
    a, b = d.name("a"), d.name("b")
    for x in (a, b):
        d.items.append(f"coordinate Real {x}; kinetic 1/2*{d.number(0.5, 3)}*der({x})^2;")
        d.drive(x, 3.0)
    d.items.append(f"contact {d.name('c')}: der({b}) - der({a}) >= 0;")
    if d.random.random() < 0.5:
        d.friction(f"der({b})", d.number(0.1, 0.5))


def _joint(d: FrictionDraft) -> None:
    """Pendulums with friction in their joints."""
    a, l = d.name("a"), d.number(0.5, 1.5)
    d.items.append(f"coordinate Real {a}(start = {d.number(-1.2, 1.2)}, der(start = {d.number(-1, 1)}));")
    if d.random.random() < 0.5:
        d.items.append(f"kinetic 1/2*{l}^2*der({a})^2; potential -9.81*{l}*cos({a});")
        d.friction(f"der({a})", d.number(0.5, 3))
        return
    b, c = d.name("a"), d.number(0.2, 0.8)
    d.items.append(f"coordinate Real {b}(start = {d.number(-1, 1)});")
    d.items.append(
        f"kinetic 1/2*der({a})^2 + 1/2*{c}*(der({a})^2 + der({b})^2 + 2*der({a})*der({b})*cos({a} - {b}));"
        f" potential -9.81*((1 + {c})*cos({a}) + {c}*cos({b}));"
    )
    d.friction(f"der({a})", d.number(0.5, 2))
    d.friction(f"der({b}) - der({a})", d.number(0.2, 1))


def _ball(d: FrictionDraft) -> None:
    """Spins, bounces, rolls."""
    x, y, a, r, m = d.name("x"), d.name("y"), d.name("a"), d.number(0.1, 0.3), d.number(0.3, 2)
    d.items.append(f"coordinate Real {x}(der(start = {d.number(-2, 2)})), {y}(start = {d.number(0, 0.4)});")
    d.items.append(f"coordinate Real {a}(der(start = {d.number(-15, 15)}));")
    d.items.append(f"kinetic 1/2*{m}*(der({x})^2 + der({y})^2) + 1/2*{d.number(0.4, 1)}*{m}*{r}^2*der({a})^2;")
    d.items.append(f"potential {m}*9.81*{y};")
    d.rough(f"{y} >= 0", f"der({x}) + {r}*der({a})", d.random.choice(["0", "0.3", "0.5", "0.8"]))
    d.drive(x)


def _block(d: FrictionDraft) -> None:
    """Pressed on a floor by a force that swings, sometimes lifted."""
    x, y, m = d.name("x"), d.name("y"), d.number(0.5, 2)
    d.items.append(f"coordinate Real {x}(der(start = {d.number(-1, 1)})), {y};")
    d.items.append(f"kinetic 1/2*{m}*(der({x})^2 + der({y})^2); potential {m}*9.81*{y} + 1/2*{d.number(1, 20)}*{x}^2;")
    d.items.append(f"force {m}*{d.number(2, 12)}*sin({d.number(3, 9)}*time) on {y};")
    d.rough(f"{y} >= 0", f"der({x})", "0")
    d.drive(x, 5.0)


def _stack(d: FrictionDraft) -> None:
    x, y, u, v = d.name("x"), d.name("y"), d.name("x"), d.name("y")
    for a, b in ((x, y), (u, v)):
        m = d.number(0.5, 2)
        d.items.append(f"coordinate Real {a}(der(start = {d.number(-1, 1)})), {b};")
        d.items.append(f"kinetic 1/2*{m}*(der({a})^2 + der({b})^2); potential {m}*9.81*{b};")
        d.drive(a, 6.0)
    d.rough(f"{y} >= 0", f"der({x})", "0")
    d.rough(f"{v} >= {y}", f"der({u}) - der({x})", "0")


def _rod(d: FrictionDraft) -> None:
    """Falls on one end, slides, and goes on."""
    x, y, a, l = d.name("x"), d.name("y"), d.name("a"), d.number(0.3, 1)
    tilt = d.random.uniform(0.5, 1.3)
    d.items.append(
        f"coordinate Real {x}(der(start = {d.number(-1, 1)})), {y}(start = {l}*sin({tilt:.4g}) + {d.number(0, 0.2)});"
    )
    d.items.append(f"coordinate Real {a}(start = {tilt:.4g});")
    d.items.append(f"kinetic 1/2*(der({x})^2 + der({y})^2) + 1/6*{l}^2*der({a})^2; potential 9.81*{y};")
    e = d.random.choice(["0", "0.4"])
    for sign in "-+":
        d.rough(f"{y} {sign} {l}*sin({a}) >= 0", f"der({x}) {'+' if sign == '-' else '-'} {l}*sin({a})*der({a})", e)


MECHANISMS: tuple[Callable[[FrictionDraft], None], ...] = (
    _slider,
    _chain,
    _clutch,
    _ratchet,
    _joint,
    _ball,
    _block,
    _stack,
    _rod,
)


def friction_model(seed: int) -> str:
    """The text of one model, named `Rough<seed>`."""
    d = FrictionDraft(Random(f"friction {seed}"))
    for mechanism in d.random.sample(MECHANISMS, d.random.choice([1, 1, 1, 2])):
        mechanism(d)
    body = "\n  ".join(d.items)
    end = f'annotation(units = "none", experiment(StopTime = {STOP:g}));'
    return f"model Rough{seed}\n  {body}\n  {end}\nend Rough{seed};\n"
