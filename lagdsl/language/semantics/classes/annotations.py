"""Annotations: `experiment(...)`, `page(...)` and `units = "none"`."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence

from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat.quantity import Experiment
from lagdsl.language.semantics.scope.constants import structural_number
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Poison, Scalar
from lagdsl.language.semantics.types.dimensions import require
from lagdsl.language.syntax import nodes

SETTINGS = ("StartTime", "StopTime", "Tolerance", "Interval")
CONTROLS = ("sliders", "curves")
ANNOTATIONS = ("experiment", "page", "units")
_FINEST, _COARSEST = 1e-13, 0.1


def annotations_of(node: nodes.Class) -> list[nodes.Annotation]:
    items = [*node.items, *(item for section in node.sections for item in section.items)]
    return [item for item in items if isinstance(item, nodes.Annotation)]


def without_units(ctx: Context, annotations: Iterable[nodes.Annotation]) -> bool:
    """True if the class takes every dimension as 1; other values of `units` are reported."""
    for modifier in _modifiers(annotations):
        if modifier.name.parts == ("units",):
            if isinstance(modifier.value, nodes.String) and modifier.value.value == "none":
                return True
            ctx.sink.report("E0221", modifier.span)
    return False


def experiment(ctx: Context, annotations: Sequence[Placed]) -> Experiment:
    """The experiment, inherited unless redefined; unknown annotations and settings are reported."""
    found: dict[str, float] = {}
    for placed in annotations:
        assert isinstance(placed.node, nodes.Annotation)
        for modifier in _modifiers([placed.node]):
            name = ".".join(modifier.name.parts)
            if name not in ANNOTATIONS:
                hint = did_you_mean(name, ANNOTATIONS)
                if name in SETTINGS:
                    hint = f"it belongs to the experiment: `annotation(experiment({name} = ...));`"
                ctx.sink.report("W0216", modifier.name.span, name=name, help=hint)
    for scope, setting in settings_of(annotations, "experiment"):
        _setting(ctx, scope, setting, found)
    start = found.get("StartTime", 0.0)
    stop = found.get("StopTime", start + 10.0)
    if stop <= start:
        place = next(placed.node.span for placed in annotations)
        expected = f"later than the start time of {start:g} s"
        ctx.sink.report("E0334", place, what="`StopTime`", expected=expected, found=f"{stop:g} s")
    return Experiment(
        start_time=start,
        stop_time=stop,
        tolerance=found.get("Tolerance", 1e-8),
        interval=found.get("Interval"),
        stop_time_explicit="StopTime" in found,
    )


def settings_of(annotations: Sequence[Placed], name: str) -> list[tuple[Scope, nodes.AnyModifier]]:
    """Settings in the annotation `name`: that of the class itself, else of the last base class."""
    given: list[tuple[Scope, nodes.Modifier]] = []
    for placed in annotations:
        assert isinstance(placed.node, nodes.Annotation)
        given += [(placed.scope, each) for each in _modifiers([placed.node]) if each.name.parts == (name,)]
    own = [pair for pair in given if pair[0].instance is not None and pair[0].instance.scope is pair[0]]
    chosen = own or [pair for pair in given if pair[0] is given[-1][0]]
    return [(scope, setting) for scope, modifier in chosen for setting in modifier.modifiers]


def known_setting(
    ctx: Context, setting: nodes.AnyModifier, annotation: str, names: Sequence[str], found: Container[str]
) -> tuple[str, nodes.Expression] | None:
    """The name of a setting, one of `names` that is not in `found` yet, and its value; None after a diagnostic."""
    if not isinstance(setting, nodes.Modifier):
        ctx.sink.report("E0240", setting.span, what="an annotation")
        return None
    name = ".".join(setting.name.parts)
    if name not in names:
        hint, listed = did_you_mean(name, names), ", ".join(names)
        ctx.sink.report("E0202", setting.name.span, name=name, type=annotation, attributes=listed, help=hint)
        return None
    if setting.value is None or setting.modifiers:
        ctx.sink.report("E0220", setting.span, name=name)
        return None
    if name in found:
        ctx.sink.report("E0212", setting.span, name=name)
        return None
    return name, setting.value


def _modifiers(annotations: Iterable[nodes.Annotation]) -> list[nodes.Modifier]:
    return [modifier for item in annotations for modifier in item.modifiers if isinstance(modifier, nodes.Modifier)]


def _setting(ctx: Context, scope: Scope, setting: nodes.AnyModifier, found: dict[str, float]) -> None:
    known = known_setting(ctx, setting, "experiment", SETTINGS, found)
    if known is None:
        return
    name, node = known
    value = ctx.elaborate(ctx, scope, node, True)
    dimension = DIMENSIONLESS if name == "Tolerance" else TIME
    if isinstance(value, Poison):
        return
    if isinstance(value, Scalar) and not require(
        ctx, scope, node, value.dimension, dimension, "E0415", what=f"`{name}`"
    ):
        return
    allowed = "constants and structural parameters"
    number = structural_number(ctx, value, node, "E0317", what=f"`{name}`", allowed=allowed)
    if number is None:
        return
    if name in ("Tolerance", "Interval") and not 0.0 < number < float("inf"):
        ctx.sink.report("E0334", node.span, what=f"`{name}`", expected="a positive number", found=f"{number:g}")
        return
    if name in ("StartTime", "StopTime") and not abs(number) < float("inf"):
        ctx.sink.report("E0334", node.span, what=f"`{name}`", expected="finite", found=f"{number:g}")
        return
    if name == "Tolerance" and not _FINEST <= number <= _COARSEST:
        expected = f"between {_FINEST:g} and {_COARSEST:g}"
        ctx.sink.report("E0334", node.span, what=f"`{name}`", expected=expected, found=f"{number:g}")
        return
    found[name] = number
