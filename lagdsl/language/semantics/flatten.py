"""From the tree of a file to the flat model of one class."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.events import Discrete
from lagdsl.language.flat.limits import check_limits
from lagdsl.language.flat.model import Coordinate, FlatModel, Input, Output, Parameter, State
from lagdsl.language.flat.quantity import Measurement
from lagdsl.language.semantics.assembly.assemble import assemble
from lagdsl.language.semantics.assembly.assembly import Assembly
from lagdsl.language.semantics.classes import annotations as notes
from lagdsl.language.semantics.classes.array_modifiers import check_splits
from lagdsl.language.semantics.classes.conditional_components import check_switched
from lagdsl.language.semantics.classes.declare import instance_of
from lagdsl.language.semantics.classes.expand import collect
from lagdsl.language.semantics.classes.inheritance import expand_short
from lagdsl.language.semantics.classes.page import page
from lagdsl.language.semantics.classes.selection import file_scope, functions_of, select
from lagdsl.language.semantics.discontinuities.discontinuities import discontinuities
from lagdsl.language.semantics.discontinuities.sampled import sampled_corners
from lagdsl.language.semantics.events.delays import check_assumed
from lagdsl.language.semantics.events.event_order import check_events, with_switches
from lagdsl.language.semantics.events.whens import check_targets
from lagdsl.language.semantics.expressions.expressions import elaborate
from lagdsl.language.semantics.expressions.inline import check_function
from lagdsl.language.semantics.items import measurements
from lagdsl.language.semantics.scope.contents import Contents
from lagdsl.language.semantics.scope.context import Context, Conventions, Structural
from lagdsl.language.semantics.scope.current import Current
from lagdsl.language.semantics.scope.instance_diagnostics import InstanceSink
from lagdsl.language.semantics.scope.limits import MAX_COMPONENTS
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.usage import warn_unused, warn_unused_imports
from lagdsl.language.semantics.statements import Physics, elaborate_item, initial_equation
from lagdsl.language.semantics.types.bare_numbers import warn_unlike
from lagdsl.language.semantics.variables import quantities
from lagdsl.language.semantics.variables.attributes import attributes
from lagdsl.language.semantics.variables.rates import check_inputs, check_linear
from lagdsl.language.semantics.variables.resolver import Definitions, every
from lagdsl.language.semantics.variables.scale_points import check_difference
from lagdsl.language.semantics.wellformed.corners import check_changing_inertia, check_corners
from lagdsl.language.semantics.wellformed.delays import check_delays
from lagdsl.language.semantics.wellformed.feedback import with_feedback
from lagdsl.language.semantics.wellformed.required_forces import with_required_forces
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.recursion import deep_recursion

_DEEPEST = 100_000  # definitions may stand in the reverse of their order


def flatten(
    unit: nodes.Unit,
    sink: Sink,
    model: str | None = None,
    structural: Structural = lambda parameter, alike: None,
    *,
    plain: Iterable[str] = (),
    unknowns: Iterable[str] = (),
    incomplete: bool = False,
) -> FlatModel | None:
    """The flat model of the class `model` (default: the last complete one that nothing else in the file uses).

    `structural` gives structural parameters other values; `plain` ones are elaborated as parameters. `unknowns` are
    coordinates that stay unknowns where their joint is cut. None after errors, which are in `sink`.
    `incomplete`: `unit` lacks statements of the text, so that nothing is said of names that nothing declares.
    """
    current = Current()
    found = InstanceSink(current)
    conventions = Conventions(unit.span.file, structural, plain=frozenset(plain), unknowns=frozenset(unknowns))
    ctx = Context(found, Definitions(), elaborate, conventions, current)
    ctx.reports.incomplete = incomplete
    flat = None
    with deep_recursion(_DEEPEST):
        try:
            flat = _flatten(ctx, unit, model, incomplete)
        except RecursionError:
            found.report("E0326", unit.items[0].span, what="a chain of definitions", most="some thousand links")
    for diagnostic in sorted(found.diagnostics, key=lambda diagnostic: _position(diagnostic, unit.span.file)):
        sink.add(diagnostic)
    return flat if not sink.has_errors else None


def scope_of(unit: nodes.Unit) -> Scope:
    """The names of a file and what its imports lead to, for who looks names up without a model; reports nothing."""
    current = Current()
    with deep_recursion():
        return file_scope(Context(Sink(), Definitions(), elaborate, Conventions(unit.span.file), current), unit)


def _position(diagnostic: Diagnostic, file: SourceFile) -> tuple[bool, str, int]:
    """Diagnostics are found in the order of need and told in the order of the text, those in other files after them."""
    if not diagnostic.labels:
        return False, "", -1
    span = diagnostic.labels[0].span
    return span.file is not file, span.file.name if span.file is not file else "", span.start


def _flatten(ctx: Context, unit: nodes.Unit, name: str | None, incomplete: bool) -> FlatModel | None:
    outer = file_scope(ctx, unit)
    chosen = select(ctx, unit, outer, name)
    expanded = expand_short(ctx, chosen, "a model by itself") if chosen is not None else None
    if chosen is None or expanded is None:
        return None
    symbol, modifiers = expanded
    node = symbol.node
    assert isinstance(node, nodes.Class)
    if "partial" in node.prefixes:
        ctx.sink.report("E0231", node.name_span, name=node.name, what="a model by itself")
        return None
    ctx.conventions.units = not notes.without_units(ctx, notes.annotations_of(node))
    root = instance_of(symbol, "", node.name_span, None)
    contents = collect(ctx, root, modifiers)
    if any(diagnostic.code == "E0239" for diagnostic in ctx.sink.diagnostics):
        return None  # dimensions mean nothing then
    if ctx.counts.components > MAX_COMPONENTS:
        return None  # what is there already is too much to be looked at
    check_switched(ctx, contents)
    assembly = assemble(ctx, root, contents)
    check_splits(ctx)
    flat = replace(_model(ctx, node, contents, assembly), name=chosen.node.name, doc=chosen.node.doc or node.doc)
    for function in (*contents.functions, *functions_of(outer)):
        check_function(ctx, function)
    if ctx.reports.withheld is not None and not incomplete and not ctx.sink.has_errors:
        ctx.sink.report("E0201", ctx.reports.withheld, name=ctx.reports.withheld.text, scope=root.scope.title)
    if ctx.sink.has_errors:
        return None
    warn_unused_imports(ctx, outer, unit)
    checked = _checked(ctx, flat, contents)
    controls = page(ctx, flat, contents.annotations)  # afterwards: a name that only controls have is an unused one
    return None if checked is None or ctx.sink.has_errors else replace(checked, page=controls)


def _model(ctx: Context, node: nodes.Class, contents: Contents, assembly: Assembly) -> FlatModel:
    """Elaborate all of the class, in source order; what is needed earlier comes earlier."""
    check_targets(ctx, contents.items)
    coordinates: list[Coordinate] = []
    states: list[State] = []
    inputs: list[Input] = []
    discretes: dict[str, list[Discrete]] = {}
    for symbol in contents.symbols:
        with ctx.current.inside(symbol.scope):
            attributes(ctx, symbol)
            check_difference(ctx, symbol)
            for indices in every(ctx.resolver.shape(ctx, symbol) or ()):
                if not assembly.is_open(symbol, indices):
                    ctx.resolver.element(ctx, symbol, indices, symbol.span)
            if symbol.kind == "coordinate" and not assembly.is_computed(symbol):
                coordinates += quantities.coordinates(ctx, symbol)
            elif symbol.kind == "state":
                states += quantities.states(ctx, symbol)
            elif symbol.kind == "input" and not symbol.is_name:
                inputs += quantities.inputs(ctx, symbol)
            elif symbol.kind == "discrete":
                discretes[symbol.name] = quantities.discretes(ctx, symbol)
                ctx.product.occurrences.discretes += discretes[symbol.name]
    physics, measured = Physics(), list[Measurement]()
    for placed in contents.items:
        with ctx.current.inside(placed.scope):
            if isinstance(placed.node, nodes.Measure):
                measured += measurements.make(ctx, placed.scope, placed.node)
            else:
                elaborate_item(ctx, physics, placed)
    assembly.close()
    for placed in contents.initial:
        with ctx.current.inside(placed.scope):
            initial_equation(ctx, physics, placed)
    outputs = _outputs(ctx, contents, discretes)
    check_assumed(ctx)
    return FlatModel(
        name=node.name,
        doc=node.doc,
        parameters=_found_by(physics, measured, _in_order(ctx, contents)),
        coordinates=assembly.coordinates(coordinates),
        states=tuple(states),
        inputs=tuple(inputs),
        named=tuple(ctx.product.named),
        energies=tuple(physics.energies),
        masses=tuple(physics.masses),
        bodies=tuple(physics.bodies),
        gravity=physics.gravity,
        gravity_span=physics.gravity_node.span if physics.gravity_node is not None else None,
        loads=(*physics.loads, *ctx.product.forces),
        constraints=tuple(ctx.product.constraints),
        outputs=(*outputs, *assembly.outputs()),
        invariants=tuple(physics.invariants),
        assertions=tuple(physics.assertions),
        initial_equations=tuple(physics.initial),
        drawings=tuple(physics.drawings),
        experiment=notes.experiment(ctx, contents.annotations),
        joints=assembly.joints(),
        events=ctx.product.occurrences.events(),
        observed=tuple(ctx.product.observed),
        aliases=assembly.aliases(coordinates),
        measurements=tuple(measured),
    )


def _found_by(
    physics: Physics, measured: list[Measurement], parameters: tuple[Parameter, ...]
) -> tuple[Parameter, ...]:
    """Initial equations decide about free parameters; in a model that has none, its measurements do."""
    if physics.initial or not measured:
        return parameters
    return tuple(replace(each, free=False, estimated=True) if each.free else each for each in parameters)


def _outputs(ctx: Context, contents: Contents, discretes: Mapping[str, list[Discrete]]) -> list[Output]:
    """Outputs of the text; `discretes` by the names of their symbols."""
    outputs: list[Output] = []
    for symbol in contents.symbols:
        if symbol.kind == "output":
            with ctx.current.inside(symbol.scope):
                outputs += quantities.outputs(ctx, symbol)
        elif "output" in symbol.prefixes:
            outputs += quantities.outputs_of_discretes(discretes.get(symbol.name, []))
    return outputs


def _in_order(ctx: Context, contents: Contents) -> tuple[Parameter, ...]:
    """The parameters, found in the order of need, in the order of the text; constants of the file where they stand."""
    places = {symbol.name: place for place, symbol in enumerate(contents.symbols)}
    first = min(
        (symbol.span.start for symbol in contents.symbols if symbol.span.file is ctx.conventions.home), default=0
    )

    def place(parameter: Parameter) -> tuple[int, int]:
        span = parameter.spans[0]
        name = parameter.name
        found = places.get(name, places.get(name[: name.rindex("[")] if name.endswith("]") else name))
        if found is not None:
            return 0, found
        return (-1 if span.file is not ctx.conventions.home or span.start < first else 1), span.start

    return tuple(sorted(ctx.product.parameters, key=place))


def _checked(ctx: Context, flat: FlatModel, contents: Contents) -> FlatModel | None:
    """Discontinuities, and checks that need a model without errors."""
    dimensions = {id(load): dimension for load, dimension in ctx.product.solved}
    solved = [dimensions.get(id(load)) for load in flat.loads]
    met = ctx.product.met
    sampled = sampled_corners(flat, met)
    flat = discontinuities(flat, [each for each in met if each.moves], ctx.sink)
    flat = replace(flat, events=replace(flat.events, sampled=sampled))
    if ctx.counts.motions:
        flat = with_required_forces(flat, ctx.sink)
        if ctx.sink.has_errors:
            return None
    dependence = Dependence(flat)
    flat = with_feedback(solved, flat, dependence)
    flat = with_switches(flat, dependence)
    check_inputs(flat, dependence, ctx.sink)
    check_delays(flat, dependence, ctx.sink)
    check_linear(flat, dependence, ctx.sink)
    warn_unused(ctx, contents.symbols)
    warn_unlike(ctx)
    check_events(flat, dependence, ctx.sink)
    check_limits(flat, {}, ctx.sink)
    check_corners(flat, dependence, ctx.sink)
    check_changing_inertia(flat, dependence, ctx.sink)
    return None if ctx.sink.has_errors else flat
