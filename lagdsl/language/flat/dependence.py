"""Dependence of expressions of a flat model: variables and the number of time derivatives they occur with."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from typing import assert_never

from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.traversal import operands, postorder, step_expressions


class Orders(Mapping[str, int]):
    """Variable -> highest number of time derivatives: {"theta": 1} for an expression of theta and der(theta).

    Kept as sets of bits, `levels[k]` of the variables with at least k derivatives: in a long chain of frames each one
    depends on all joints before it, and merging must not cost as much as that.
    """

    __slots__ = ("_levels", "_variables")

    def __init__(self, variables: _Variables, levels: tuple[int, ...] = ()) -> None:
        self._variables = variables
        self._levels = levels

    def __getitem__(self, name: str) -> int:
        bit = 1 << self._variables.index[name]
        order = sum(1 for level in self._levels if level & bit) - 1
        if order < 0:
            raise KeyError(name)
        return order

    def __iter__(self) -> Iterator[str]:
        return self._variables.names_in(self._levels[0] if self._levels else 0)

    def __len__(self) -> int:
        return self._levels[0].bit_count() if self._levels else 0

    def differentiated(self, times: int = 1) -> Iterator[str]:
        """The variables that occur with at least so many derivatives."""
        return self._variables.names_in(self._levels[times] if len(self._levels) > times else 0)

    def raised(self) -> Orders:
        """Of the time derivative."""
        return Orders(self._variables, (*self._levels[:1], *self._levels))

    def with_rates(self) -> Orders:
        """The same with the rate of each variable."""
        return Orders(self._variables, (*self._levels[:1] * 2, *self._levels[2:]))

    def merged(self, *others: Orders) -> Orders:
        """Of what depends on this and on the others."""
        levels = self._levels
        for orders in others:
            more = orders._levels
            if len(more) > len(levels):
                levels, more = more, levels
            if more and more != levels:
                levels = (*(own | other for own, other in zip(levels, more, strict=False)), *levels[len(more) :])
        return self if levels is self._levels else Orders(self._variables, levels)


class _Variables:
    """Numbers of variables, by first occurrence."""

    def __init__(self) -> None:
        self.index: dict[str, int] = {}
        self._names: list[str] = []

    def alone(self, name: str) -> Orders:
        if name not in self.index:
            self.index[name] = len(self._names)
            self._names.append(name)
        return Orders(self, (1 << self.index[name],))

    def names_in(self, bits: int) -> Iterator[str]:
        while bits:
            last = bits & -bits
            yield self._names[last.bit_length() - 1]
            bits ^= last


@record()
class Dependence:
    """Answers for one flat model; named elements and shared nodes are looked at once."""

    flat: fm.FlatModel
    _variables: _Variables = field(init=False, repr=False, default_factory=_Variables)
    _named: dict[str, fm.Named] = field(init=False, repr=False)
    _by_name: dict[tuple[str, str], Orders] = field(init=False, repr=False, default_factory=dict)
    _by_node: dict[int, tuple[fx.FlatExpression, Orders]] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_named", {item.name: item for item in self.flat.named})

    def of(self, expression: fx.FlatExpression) -> Orders:
        """Parameters count too, with order 0. Quantities of the mechanics (multipliers, energies) have none."""
        known = self._by_node
        found = known.get(id(expression))
        if found is None:
            for node in postorder(expression, known):
                # The node is kept with its answer, so that its identity is not given to another one.
                known[id(node)] = (node, self._of_binary(node) if type(node) is fx.Binary else self._compute(node))
            found = known[id(expression)]
        return found[1]

    def _of_binary(self, node: fx.Binary) -> Orders:
        """As `_compute`: most nodes."""
        known = self._by_node
        return known[id(node.left)][1].merged(known[id(node.right)][1])

    @property
    def nothing(self) -> Orders:
        return Orders(self._variables)

    def of_all(self, expressions: Iterable[fx.FlatExpression]) -> Orders:
        return self.nothing.merged(*map(self.of, expressions))

    def of_frame(self, name: str, *, turning_only: bool = False) -> Orders:
        """Of position and orientation of a frame, or of its orientation only."""
        key = (name, "axes" if turning_only else "frame")
        if key not in self._by_name:
            frame = self._named.get(name)
            orders = self.nothing
            if isinstance(frame, fm.Frame):
                steps = [step_expressions(step, turning_only=turning_only) for step in frame.steps]
                parent = self.of_frame(frame.parent, turning_only=turning_only)
                orders = parent.merged(*(self.of_all(expressions) for expressions in steps))
            self._by_name[key] = orders
        return self._by_name[key]

    def of_mechanism(self) -> Orders:
        """Of the forces that masses, bodies and energies require, with accelerations that are given."""
        key = ("", "mechanism")
        if key not in self._by_name:
            flat = self.flat
            self._by_name[key] = self.nothing  # an energy that reads such a force is refused with better words
            bodies = [x for body in flat.bodies for x in (body.mass, *body.com, *body.inertia)]
            energies = [term.value for term in flat.energies]
            gravity = [flat.gravity] if flat.gravity is not None else []
            masses = [x for mass in flat.masses for x in (mass.mass, mass.position)]
            frames = [self.of_frame(body.frame) for body in flat.bodies]
            self._by_name[key] = self.of_all([*energies, *gravity, *masses, *bodies]).merged(*frames).with_rates()
        return self._by_name[key]

    def _compute(self, expression: fx.FlatExpression) -> Orders:
        match expression:
            case fx.Operation():
                return self.of_all(operands(expression))
            case fx.Variable(name):
                return self._variable(name)
            case fx.Number():
                return self.nothing
            case fx.Derivative(operand):
                return self.of(operand).raised()
            case fx.PointReference(name):
                point = self._named.get(name)
                return self.of(point.position) if isinstance(point, fm.Point) else self.nothing
            case fx.FrameOrigin(frame):
                return self.of_frame(frame)
            case fx.FrameAxis(frame):
                return self.of_frame(frame, turning_only=True)
            case fx.AngularVelocity(frame):
                return self.of_frame(frame, turning_only=True).raised()
            case fx.MaterialVelocity(point_expression, frame):
                return self.of(point_expression).merged(self.of_frame(frame).raised())
            case fx.Previous() | fx.Mechanical() | fx.Motion():
                return self.of_all(operands(expression))
            case fx.RequiredForce(motion):
                return self.of(motion).merged(self.of_mechanism())
            case _:
                assert_never(expression)

    def _variable(self, name: str) -> Orders:
        item = self._named.get(name)
        return self.of(item.value) if isinstance(item, fm.Definition) else self._variables.alone(name)
