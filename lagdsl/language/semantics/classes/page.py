"""The annotation `page(sliders = {...}, curves = {...})`: controls and curves of the living page."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Page
from lagdsl.language.semantics.classes.annotations import CONTROLS, known_setting, settings_of
from lagdsl.language.semantics.items.measurements import columns_of
from lagdsl.language.semantics.scope.contents import Placed
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Poison
from lagdsl.language.syntax import nodes

_HELP = {
    "sliders": "sliders set parameters without a formula, inputs, and the start of coordinates and their rates",
    "curves": "curves show columns of the results: coordinates, rates, states, discrete variables, outputs",
}


def page(ctx: Context, flat: FlatModel, annotations: Sequence[Placed]) -> Page:
    """The controls of `flat`, inherited unless redefined; E0246 for what is none of its quantities."""
    found: dict[str, tuple[str, ...]] = {}
    moving = [name for item in flat.coordinates for name in (item.name, f"der({item.name})")]
    held = [item.name for item in (*flat.parameters, *flat.inputs) if not getattr(item, "structural", False)]
    seen = [item.name for item in (*flat.states, *flat.events.discretes, *flat.outputs)]
    allowed = {"sliders": {*moving, *held}, "curves": {*moving, *seen}}
    for scope, setting in settings_of(annotations, "page"):
        known = known_setting(ctx, setting, "page", CONTROLS, found)
        if known is not None:
            name, node = known
            found[name] = _names(ctx, scope, node, name, allowed[name])
    return Page(**found)


def _names(ctx: Context, scope: Scope, node: nodes.Expression, setting: str, allowed: set[str]) -> tuple[str, ...]:
    """Of all elements of a list, or of one quantity alone; each once."""
    names: list[str] = []
    for each in node.elements if isinstance(node, nodes.Array) else (node,):
        columns = columns_of(ctx, scope, each)
        if isinstance(columns, Poison):
            continue
        if columns is None or not allowed.issuperset(columns[0]):
            text, what = each.span.text, setting.removesuffix("s")
            ctx.sink.report("E0246", each.span, text=text, what=what, help=_HELP[setting])
            continue
        names += columns[0]
    return tuple(dict.fromkeys(names))
