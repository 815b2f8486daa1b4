"""The flat model as text (`lag flat`): the five lists q, L, D, Q, constraints, then everything around them.

For reading and for comparing: stable under any hash seed, SI units, one item per line with the place it comes from.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import assert_never

from lagdsl.foundation.diagnostics.excerpt import printable
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.naming import to_display, unit_text
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.display import display
from lagdsl.language.flat.event_text import event_sections, level_text
from lagdsl.language.flat.expression_text import flat_expression_text as text_of
from lagdsl.language.flat.expression_text import number_text
from lagdsl.language.flat.quantity import Experiment, Item, Measurement, Page, Quantity
from lagdsl.language.flat.spans import place

_WIDEST = 72  # columns after which a place is no longer aligned with the others


@dataclass(frozen=True, slots=True)
class _Line:
    text: str
    source: Item | Span | None


def flat_text(flat: fm.FlatModel) -> str:
    """The whole model, ending in a newline. Empty lists are left out, except the five."""
    lines = [f"model {flat.name}{_doc(flat.doc)}"]
    lines += _section("q", [_coordinate(coordinate) for coordinate in flat.coordinates], True)
    lines += _section("L", _lagrangian(flat), True)
    lines += _section("D", [_energy(term) for term in flat.energies if term.kind == "dissipation"], True)
    lines += _section("Q", [_load(load) for load in flat.loads], True)
    lines += _section("constraints", [line for c in flat.constraints for line in _constraint(c)], True)
    lines += _section("joints", [_joint(joint) for joint in flat.joints])
    lines += _section("states", [_state(state) for state in flat.states])
    lines += _section("inputs", [_input(item) for item in flat.inputs])
    lines += _section("parameters", [_parameter(parameter) for parameter in flat.parameters])
    lines += _section("definitions", [_named(item) for item in flat.named])
    lines += _section("outputs", [_output(output) for output in flat.outputs])
    for title, found in event_sections(flat.events):
        lines += _section(title, [_Line(text, source) for text, source in found])
    lines += _section("invariants", [_invariant(invariant) for invariant in flat.invariants])
    lines += _section("measurements", [_measurement(each) for each in flat.measurements])
    lines += _section("initial equations", [_Line(f"0 = {text_of(e.residual)}", e) for e in flat.initial_equations])
    lines += _section("assertions", [_assertion(assertion) for assertion in flat.assertions])
    lines += _section("drawings", [_drawing(drawing) for drawing in flat.drawings])
    lines += _section("experiment", [_experiment(flat.experiment)])
    lines += _section("page", _page(flat.page))
    return "".join(f"{line}\n" for line in lines)


def _section(title: str, items: list[_Line], always: bool = False) -> list[str]:
    if not items:
        return ["", f"{title}: none"] if always else []
    width = max((len(line.text) for line in items if len(line.text) <= _WIDEST), default=0)
    return ["", f"{title}:", *(_placed(line, width) for line in items)]


def _placed(line: _Line, width: int) -> str:
    span = place(line.source) if isinstance(line.source, Item) else line.source
    shown = f"  {printable(line.text)}"
    return shown if span is None else f"{shown:<{width + 2}}  // {printable(span.file.name)}:{span.first.line}"


# ---- q, L, D, Q, constraints -----------------------------------------------------------------------------------------


def _coordinate(coordinate: fm.Coordinate) -> _Line:
    start = f"start = {text_of(coordinate.start)}{_displayed(coordinate.start, coordinate)}"
    parts = [f"{coordinate.type_name} {coordinate.name} [{_units(coordinate)}]", start]
    parts += ["fixed"] if coordinate.fixed else []
    if coordinate.rate_start_explicit or coordinate.rate_fixed or coordinate.rate_start != fx.ZERO:
        parts.append(f"der start = {text_of(coordinate.rate_start)}")
    parts += ["der fixed"] if coordinate.rate_fixed else []
    parts += _bounds(coordinate.minimum, coordinate.maximum, coordinate.nominal)
    return _Line(", ".join(parts) + _doc(coordinate.doc), coordinate)


def _units(item: Quantity) -> str:
    """`rad, shown in deg`: the unit of all numbers here and in files, and the one of summaries and figures."""
    shown = display(item).unit
    return item.unit if shown in (item.unit, "") else f"{item.unit}, shown in {shown}"


def _displayed(value: fx.FlatExpression, item: Quantity) -> str:
    """The same number in the unit people see: ` (10 deg)`."""
    unit = display(item).unit
    if not isinstance(value, fx.Number) or unit in (item.unit, ""):
        return ""
    return f" ({to_display(value.value, unit):.6g} {unit})"


def _bounds(minimum: float | None, maximum: float | None, nominal: float | None = None) -> list[str]:
    pairs = (("min", minimum), ("max", maximum), ("nominal", nominal))
    return [f"{name} = {number_text(value)}" for name, value in pairs if value is not None]


def _lagrangian(flat: fm.FlatModel) -> list[_Line]:
    lines = [_Line(f"mass {text_of(mass.mass)} at {text_of(mass.position)}", mass) for mass in flat.masses]
    lines += [_body(body) for body in flat.bodies]
    if flat.gravity is not None:
        lines.append(_Line(f"gravity = {text_of(flat.gravity)}", flat.gravity_span))
    return lines + [_energy(term) for term in flat.energies if term.kind != "dissipation"]


def _body(body: fm.RigidBody) -> _Line:
    com, inertia = (", ".join(text_of(value) for value in values) for values in (body.com, body.inertia))
    label = f" {body.label}" if body.label is not None else ""
    return _Line(f"body{label}(m = {text_of(body.mass)}, com = {{{com}}}, I = {{{inertia}}}) on {body.frame}", body)


def _energy(term: fm.EnergyTerm) -> _Line:
    label = f" {term.label} =" if term.label is not None else ""
    return _Line(f"{term.kind}{label} {text_of(term.value)}", term)


def _load(load: fm.Load) -> _Line:
    label = f" {load.label} =" if load.label is not None else ""
    match load:
        case fm.PointForce():
            text = f"force{label} {text_of(load.force)} at {text_of(load.point)}{_on(load.frame)}"
            if load.origin is not None:
                text += f" from {text_of(load.origin)}{_on(load.origin_frame)}"
        case fm.FrameTorque():
            text = f"torque{label} {text_of(load.torque)} on {load.frame}"
            text += f" from {load.origin}" if load.origin is not None else ""
        case fm.GeneralizedForce():
            text = f"{load.keyword}{label} {text_of(load.value)} on {text_of(load.target)}"
            text += f" from {text_of(load.origin)}" if load.origin is not None else ""
        case fm.RateForce():
            text = f"force{label} {text_of(load.value)} along {text_of(load.rate)}"
        case _:
            assert_never(load)
    return _Line(text, load)


def _on(frame: str | None) -> str:
    return f" on {frame}" if frame is not None else ""


def _constraint(constraint: fm.Constraint) -> Iterable[_Line]:
    unit = unit_text(constraint.dimension)
    for row, residual in zip(constraint.rows, constraint.residuals, strict=True):
        kind = "unit length" if constraint.normalisation else constraint.level
        yield _Line(f"{row} [{unit}, {kind}]: 0 = {text_of(residual)}", constraint)


def _joint(joint: fm.Joint) -> _Line:
    """Joints with their two sides and coordinates; a cut joint closes a loop by constraints."""
    owned = f", {', '.join(joint.coordinates)}" if joint.coordinates else ""
    cut = ", cut" if joint.cut else ""
    return _Line(f"{joint.kind} {joint.name}: {joint.frame_a} to {joint.frame_b}{owned}{cut}", joint)


# ---- around them -----------------------------------------------------------------------------------------------------


def _quantity(item: Quantity, value: str) -> _Line:
    return _Line(f"{item.type_name} {item.name} [{_units(item)}] = {value}{_doc(item.doc)}", item)


def _state(state: fm.State) -> _Line:
    fixed = ", fixed" if state.fixed else ""
    start = f"{text_of(state.start)}{_displayed(state.start, state)}"
    text = f"{state.type_name} {state.name} [{_units(state)}], start = {start}{fixed}"
    return _Line(f"{text}, der({state.name}) = {text_of(state.derivative)}{_doc(state.doc)}", state)


def _input(item: fm.Input) -> _Line:
    smooth = f", smooth = {item.smooth}" if item.smooth else ""
    default = f"default = {text_of(item.default)}{_displayed(item.default, item)}" if item.stated else "no default"
    if item.derivative_of is not None:
        default = f"derivative of {item.derivative_of}"
    limits = "".join(f", {bound}" for bound in _bounds(item.minimum, item.maximum, item.nominal))
    text = f"{item.type_name} {item.name} [{_units(item)}], {default}{smooth}{limits}{_doc(item.doc)}"
    return _Line(text, item)


def _output(item: fm.Output) -> _Line:
    limits = "".join(f", {bound}" for bound in _bounds(item.minimum, item.maximum, item.nominal))
    if item.value == fx.Variable(item.name):
        return _quantity(item, f"the discrete variable{limits}")
    return _quantity(item, f"{text_of(item.value)}{limits}")


def _parameter(parameter: fm.Parameter) -> _Line:
    value = f"{number_text(parameter.value)}{_displayed(fx.Number(parameter.value), parameter)}"
    if parameter.kind == "Boolean":
        value = "true" if parameter.value else "false"
    if parameter.text is not None:
        value = f'"{parameter.text}"'
    bounds = "".join(f", {bound}" for bound in _bounds(parameter.minimum, parameter.maximum, parameter.nominal))
    guess = ", found with the start" if parameter.free else ", found from data" if parameter.estimated else ""
    line = _quantity(parameter, f"{value}{guess}{bounds}")
    return _Line(f"structural {line.text}", parameter) if parameter.structural else line


def _named(item: fm.Named) -> _Line:
    match item:
        case fm.Definition():
            return _quantity(item, text_of(item.value))
        case fm.Point():
            return _Line(f"point {item.name} = {text_of(item.position)}{_doc(item.doc)}", item)
        case fm.Frame():
            return _Line(f"frame {item.name} = {item.parent}{''.join(map(_step, item.steps))}{_doc(item.doc)}", item)
        case _:
            assert_never(item)


def _step(step: fm.FrameStep) -> str:
    match step:
        case fm.Rotate(axis, angle):
            return f".rot{'xyz'[axis]}({text_of(angle)})"
        case fm.RotateAbout(axis, angle):
            return f".rotate({_braced(axis)}, {text_of(angle)})"
        case fm.RotateQuaternion(e):
            return f".quat({_braced(e)})"
        case fm.SetAxes(x, y, z):
            return f".axes({text_of(x)}, {text_of(y)}, {text_of(z)})"
        case fm.Move(offset):
            return f".move({_braced(offset)})"
        case fm.Place(position):
            return f".at({text_of(position)})"
        case _:
            assert_never(step)


def _braced(values: tuple[fx.FlatExpression, ...]) -> str:
    return f"{{{', '.join(text_of(value) for value in values)}}}"


def _invariant(invariant: fm.Invariant) -> _Line:
    tolerance = f" with tol = {number_text(invariant.tolerance)}" if invariant.tolerance is not None else ""
    text = f"{invariant.name} [{unit_text(invariant.dimension)}]: {text_of(invariant.value)}{tolerance}"
    return _Line(text, invariant)


def _measurement(measurement: Measurement) -> _Line:
    means = f": {measurement.of}" if measurement.stated else ""
    sigma = f" with sigma = {number_text(measurement.sigma)}" if measurement.sigma is not None else ""
    return _Line(f"{measurement.name} [{unit_text(measurement.dimension)}]{means}{sigma}", measurement)


def _assertion(assertion: fm.Assertion) -> _Line:
    level = level_text(assertion.warning)
    return _Line(f'assert({text_of(assertion.condition)}, "{assertion.message}"{level})', assertion)


def _drawing(drawing: fm.Drawing) -> _Line:
    arguments = ", ".join(f"{name} = {_shown(value)}" for name, value in drawing.arguments)
    anchors = [_shown(anchor) for anchor in drawing.anchors]
    where = f" from {anchors[0]} to {anchors[1]}" if drawing.place == "between" else f" {drawing.place} {anchors[0]}"
    return _Line(f"{drawing.shape}{f'({arguments})' if arguments else ''}{where}", drawing)


def _shown(value: fx.FlatExpression | str) -> str:
    return value if isinstance(value, str) else text_of(value)


def _experiment(experiment: Experiment) -> _Line:
    parts = [f"{number_text(experiment.start_time)} to {number_text(experiment.stop_time)} s"]
    parts.append(f"tolerance {number_text(experiment.tolerance)}")
    parts += [f"interval {number_text(experiment.interval)} s"] if experiment.interval is not None else []
    return _Line(", ".join(parts), None)


def _page(page: Page) -> list[_Line]:
    chosen = {"sliders": page.sliders, "curves": page.curves}
    return [_Line(f"{title} {', '.join(names)}", None) for title, names in chosen.items() if names]


def _doc(doc: str | None) -> str:
    return "" if doc is None else f'  "{doc}"'
