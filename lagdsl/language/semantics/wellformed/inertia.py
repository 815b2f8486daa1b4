"""Masses and inertias must be possible (E0505, E0506, E0509, W0514, N0523, E0524)."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.spans import around, place

_MOMENTS = ("Ixx", "Iyy", "Izz")
_GIVE = "give it a mass or an inertia, or delete it"
_SLACK = 1e-9  # a thin disc lies on the boundary, up to rounding


def check_inertias(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """Values are those of the parameters' defaults."""
    parameters = frozenset(parameter.name for parameter in flat.parameters)
    checks = _Checks(flat, dependence, sink, Evaluator(flat, Values()), parameters)
    for mass in flat.masses:
        if checks.constant(mass, "mass", mass.mass):
            checks.not_negative(mass, "mass", mass.mass, "kg")
            checks.not_nothing(mass, "mass", (mass.mass,))
    for body in flat.bodies:
        checks.body(body)


@record()
class _Checks:
    flat: fm.FlatModel
    dependence: Dependence
    sink: Sink
    moment: Evaluator
    parameters: frozenset[str]

    def body(self, body: fm.RigidBody) -> None:
        """Its mass, its moments and what they allow; each only if what comes before is sound."""
        name = f"body `{body.label}`" if body.label is not None else "body"
        parts = [(f"mass of {name}", body.mass, "kg")]
        parts += [(f"moment {axis} of {name}", body.inertia[i], "kg.m2") for i, axis in enumerate(_MOMENTS)]
        everything = [(what, value) for what, value, _ in parts]
        everything += [(f"inertia of {name}", product) for product in body.inertia[3:]]
        sound = [self.constant(body, what, value) for what, value in everything]
        self._center(body, name)
        if all(sound):
            sound = [self.not_negative(body, what, value, unit) for what, value, unit in parts]
            if all(sound):
                self._triangle(body)
                self.not_nothing(body, "body", (body.mass, *body.inertia))

    def constant(self, item: Item, what: str, value: fx.FlatExpression) -> bool:
        """E0505 unless the value is built from parameters."""
        changing = [name for name in self.dependence.of(value) if name not in self.parameters]
        if changing:
            self.sink.report("E0505", place(item), *around(item), what=what, name=changing[0])
        return not changing

    def _center(self, body: fm.RigidBody, name: str) -> None:
        """E0524 unless the mass centre rests in the frame: the body is rigid."""
        changing = [each for each in self.dependence.of_all(body.com) if each not in self.parameters]
        if changing:
            self.sink.report("E0524", place(body), *around(body), what=name, name=changing[0])

    def not_negative(self, item: Item, what: str, value: fx.FlatExpression, unit: str) -> bool:
        number = self.moment.scalar(value)
        if number < 0.0:
            self.sink.report("E0506", place(item), *around(item), what=what, value=f"{number:.6g}", unit=unit)
        return not number < 0.0

    def not_nothing(self, item: Item, keyword: str, values: tuple[fx.FlatExpression, ...]) -> None:
        """W0514 where all of them are written as zero, N0523 where the parameters make them zero."""
        if all(value == fx.ZERO for value in values):
            reason = "it has neither mass nor inertia"
            self.sink.report("W0514", place(item), *around(item), keyword=keyword, reason=reason, help=_GIVE)
        elif all(self.moment.scalar(value) == 0.0 for value in values):
            self.sink.report("N0523", place(item), *around(item), keyword=keyword)

    def _triangle(self, body: fm.RigidBody) -> None:
        """E0509 for the three moments as given, else for the principal ones.

        Entries that are not given are unstated: nothing is checked unless all three moments are.
        """
        numbers = [self.moment.scalar(value) for value in body.inertia]
        if any(moment == fx.ZERO for moment in body.inertia[:3]) or not np.all(np.isfinite(numbers)):
            return
        xx, yy, zz, xy, xz, yz = numbers
        values = (f"Ixx = {xx:.6g}, Iyy = {yy:.6g}, Izz = {zz:.6g} kg.m2",)
        for left, two, right, third in (
            ("Ixx + Iyy", xx + yy, "Izz", zz),
            ("Ixx + Izz", xx + zz, "Iyy", yy),
            ("Iyy + Izz", yy + zz, "Ixx", xx),
        ):
            if two < third * (1 - _SLACK):
                self._impossible(body, left, right, values)
                return
        principal = np.linalg.eigvalsh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
        if principal[0] + principal[1] < principal[2] * (1 - _SLACK):
            shown = ", ".join(f"{value:.6g}" for value in principal)
            note = f"with the products of inertia the principal moments are {shown} kg.m2"
            self._impossible(body, "I1 + I2", "I3", (*values, note))

    def _impossible(self, body: fm.RigidBody, left: str, right: str, notes: tuple[str, ...]) -> None:
        self.sink.report(
            "E0509", place(body), *around(body), left=left, right=right, name=body.label or body.frame, notes=notes
        )
