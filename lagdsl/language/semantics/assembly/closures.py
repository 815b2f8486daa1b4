"""Links that close a loop: constraints, and what becomes of their coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, LENGTH
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat import model as flat_model
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import (
    Closure,
    Constraint,
    Definition,
    Frame,
    FrameStep,
    Image,
    Output,
    RotateQuaternion,
)
from lagdsl.language.flat.quantity import Variability, fields_of, is_angle
from lagdsl.language.semantics.assembly.closed_form.computed import Formula, NoFormulaError, Solver
from lagdsl.language.semantics.assembly.closed_form.linear import variables
from lagdsl.language.semantics.assembly.closed_form.pose import displacement, misalignment, misalignment_anywhere
from lagdsl.language.semantics.assembly.cuts import Cut, Place, ReadAs, Tied
from lagdsl.language.semantics.assembly.net import Net
from lagdsl.language.semantics.assembly.relative import Ancestry, is_relative, speaks_of_its_frames
from lagdsl.language.semantics.assembly.routes import Routes
from lagdsl.language.semantics.items import constraints
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Symbol
from lagdsl.language.semantics.scope.values import FrameValue, Order, Scalar
from lagdsl.language.semantics.variables import quantities
from lagdsl.language.semantics.variables.resolver import every
from lagdsl.language.syntax import nodes


class Closures:
    """Closes loops, on demand: who reads a coordinate of a cut joint needs its definition first."""

    def __init__(
        self, ctx: Context, net: Net, routes: Routes, cuts: Sequence[Cut], ties: Sequence[Tied], values: set[Symbol]
    ) -> None:
        self._ctx, self._net, self._routes = ctx, net, routes
        self.cuts, self._ties = tuple(cuts), tuple(ties)
        self._values = values
        self._ancestry = Ancestry(ctx)
        self._of = {symbol: cut for cut in cuts if cut.computed for symbol in cut.link.own}

    def is_computed(self, symbol: Symbol) -> bool:
        """True if the coordinate follows from others; closes its loop to find out."""
        cut = self._of.get(symbol)
        if cut is None:
            return False
        self.open(cut)
        return cut.computed

    def open(self, cut: Cut) -> None:
        """Make the hidden frame of the closure and, where there are formulas, the coordinates."""
        if cut.started:
            return
        cut.started = True
        end = self._routes.value(cut.link.child)
        base = self._routes.value(cut.link.base)
        if not isinstance(end, FrameValue) or not isinstance(base, FrameValue):
            cut.computed = False
            return
        mark = len(self._ctx.product.named)
        value = self._ctx.elaborate(self._ctx, cut.link.binding.scope, cut.link.binding.node, False)
        behind = self._ctx.product.named[mark:]
        if not isinstance(value, FrameValue):
            cut.computed = False
            return
        relative = is_relative(value.steps) and value.name == base.name and not behind
        if cut.computed:
            relative = relative and speaks_of_its_frames(self._ctx, self._net, cut.link, cut.equations)
        cut.start, stop, within = value.name, end.name, None
        if relative:
            cut.start, stop, within = self._ancestry.copied(
                base.name, end.name, lambda parent, steps, image: self._frame(cut.place, parent, steps, "frame", image)
            )
        image = Image(of=None, within=within) if within is not None else None
        cut.hidden = self._frame(cut.place, stop, (), "end", image)
        cut.steps = value.steps
        if cut.computed:
            self._compute(cut, behind, plain=value.name == base.name)

    def _compute(self, cut: Cut, made: list[flat_model.Named], *, plain: bool) -> None:
        """Formulas for the coordinates; where there are none they are kept and tied by the pose. `made` are the items
        that came with the kinematics, `plain`: it starts from the base of the link."""
        ctx = self._ctx
        known = self._coordinates(cut)
        starts = {item.name: item.start for item in known}
        exact = {
            element_name(symbol.name, indices)
            for symbol in cut.link.own
            if symbol in self._values
            for indices in every(ctx.resolver.shape(ctx, symbol) or ())
        }
        by_name = {item.name: item for item in known}
        behind = [item for item in made if not isinstance(item, Definition) or _needs(item, starts)]
        mark = len(ctx.product.named)

        def frame(parent: str, steps: tuple[FrameStep, ...]) -> str:
            return self._frame(cut.place, parent, steps, "frame") if steps else parent

        def found(formula: Formula) -> None:
            if formula.turn is not None and formula.name in exact:
                raise NoFormulaError
            item = by_name[formula.name]
            fields = fields_of(item)
            ctx.product.named.append(Definition(**fields, value=formula.value, variability=Variability.CONTINUOUS))
            joint = cut.link.instance.name
            value = flat.Variable(item.name)
            cut.outputs.append(Output(**fields, value=value, joint=joint, turn=formula.turn))

        try:
            if behind or not plain:
                raise NoFormulaError
            Solver(cut.start, cut.hidden, starts, frame, found).solve(cut.steps)
        except NoFormulaError:
            del ctx.product.named[mark:]
            cut.outputs.clear()
            cut.computed = False
        else:
            self._tell_starts(known)
        order = {name: k for k, name in enumerate(starts)}
        cut.outputs.sort(key=lambda output: order[output.name])

    def _tell_starts(self, known: list[flat_model.Coordinate]) -> None:
        """N0718 for starts that are not needed; that of an angle tells in which revolution it begins."""
        spans = {item.start_span or item.rate_start_span: item for item in reversed(known)}
        for span, item in spans.items():
            if span is not None:
                turns = is_angle(item) and span is item.start_span
                use = "its start value only selects the revolution of the angle" if turns else "its start has no use"
                self._ctx.sink.report("N0718", span, name=item.name, use=use)

    def _coordinates(self, cut: Cut) -> list[flat_model.Coordinate]:
        """As they would be listed; the constraints that come with them (unit quaternions) are not wanted here."""
        mark = len(self._ctx.product.constraints)
        found = [item for symbol in cut.link.own for item in quantities.coordinates(self._ctx, symbol)]
        del self._ctx.product.constraints[mark:]
        return found

    # ---- constraints -------------------------------------------------------------------------------------------------

    def finish(self) -> None:
        """Add the constraints of all loops, in the order of the text."""
        for cut in self.cuts:
            self._close(cut)
        for tied in self._ties:
            self._tie(tied)

    def _tie(self, tied: Tied) -> None:
        """Both places of a port must be one."""
        port = self._net.ports[tied.port]
        first = self._routes.value(self._routes.arrivals[self._net.root(tied.port)].port)
        second = self._routes.value(tied.port)
        if isinstance(first, FrameValue) and isinstance(second, FrameValue):
            scope = (port.symbol or port.binding).scope  # type: ignore[union-attr]
            place = Place(f"closure({port.name})", None, tied.loop, tied.span, (tied.span, *scope.spans))
            start = self._frame(place, first.name, first.steps, "start") if first.steps else first.name
            end = self._frame(place, second.name, second.steps, "end")
            self._pose(place, start, end)

    def _close(self, cut: Cut) -> None:
        """Add the constraints of one cut."""
        self.open(cut)
        if not cut.hidden:
            return
        if cut.computed:
            self._own(cut)
            return
        start = self._frame(cut.place, cut.start, cut.steps, "start")
        self._pose(cut.place, start, cut.hidden, anywhere=any(isinstance(step, RotateQuaternion) for step in cut.steps))

    def _pose(self, place: Place, start: str, end: str, *, anywhere: bool = False) -> None:
        self._rows(place, displacement(start, end), self._ctx.conventions.dimension(LENGTH), 0)
        turned = misalignment_anywhere if anywhere else misalignment
        self._rows(place, turned(start, end), DIMENSIONLESS, 3)

    def _own(self, cut: Cut) -> None:
        """The equations of the closure section, the end of the link read as the hidden frame."""
        ports = self._net.ports
        count = 0
        with ReadAs(ports[cut.link.child], cut.hidden), ReadAs(ports[cut.link.base], cut.start):
            for placed in cut.equations:
                assert isinstance(placed.node, nodes.Equation)
                residual = constraints.difference(self._ctx, placed.scope, placed.node)
                if residual is None:
                    continue
                if residual.order > Order.CONFIGURATION:
                    self._ctx.sink.report("E0707", placed.node.span)
                    continue
                parts = (residual.expression,) if isinstance(residual, Scalar) else residual.elements
                place = replace(cut.place, spans=(placed.node.span, *placed.scope.spans))
                self._rows(place, parts, residual.dimension or DIMENSIONLESS, count)
                count += len(parts)

    def _rows(self, place: Place, residuals: tuple[FlatExpression, ...], dimension: Dimension, before: int) -> None:
        rows = tuple(f"{place.name}[{before + k}]" for k in range(1, len(residuals) + 1))
        self._ctx.product.constraints.append(
            Constraint(
                spans=place.spans,
                name=place.name,
                rows=rows,
                residuals=residuals,
                dimension=dimension,
                level="position",
                closure=Closure(joint=place.joint, loop=place.loop, span=place.span),
            )
        )

    def _frame(
        self, place: Place, parent: str, steps: tuple[FrameStep, ...], what: str, image: Image | None = None
    ) -> str:
        name = self._ctx.product.unique(f"{place.name}.{what}")
        self._ctx.product.named.append(Frame(spans=place.spans, name=name, parent=parent, steps=steps, image=image))
        return name


def _needs(item: Definition, names: dict[str, FlatExpression]) -> bool:
    return any(name in names for name in variables((item.value,)))
