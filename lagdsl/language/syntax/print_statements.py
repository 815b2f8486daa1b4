"""Statements that fit on a line, as runs of texts and places to break: everything but classes, loops and branches."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TypeAlias, assert_never

from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.layout import Piece
from lagdsl.language.syntax.print_expressions import ExpressionWriter, quoted

Leaf: TypeAlias = (
    nodes.Import
    | nodes.ShortClass
    | nodes.TypeDefinition
    | nodes.Function
    | nodes.Component
    | nodes.Coordinate
    | nodes.Geometry
    | nodes.Energy
    | nodes.Gravity
    | nodes.PointMass
    | nodes.RigidBody
    | nodes.Load
    | nodes.Constraint
    | nodes.Contact
    | nodes.Friction
    | nodes.Invariant
    | nodes.Measure
    | nodes.Draw
    | nodes.Connect
    | nodes.Extends
    | nodes.Annotation
    | nodes.Equation
    | nodes.CallEquation
)


def statement(node: Leaf) -> list[Piece]:
    """The pieces of a statement, `;` included."""
    writer = _StatementWriter()
    match node:
        case nodes.Import() | nodes.ShortClass() | nodes.TypeDefinition() | nodes.Function():
            writer.definition(node)
        case nodes.Component() | nodes.Coordinate() | nodes.Geometry() | nodes.Extends() | nodes.Annotation():
            writer.declaration(node)
        case nodes.Equation() | nodes.CallEquation() | nodes.Connect():
            writer.equation(node)
        case nodes.Physics():
            writer.physics(node)
        case _:
            assert_never(node)
    writer.text(";")
    return writer.pieces


class _StatementWriter(ExpressionWriter):
    # ---- definitions -----------------------------------------------------------------------------------------------

    def definition(self, node: nodes.Import | nodes.ShortClass | nodes.TypeDefinition | nodes.Function) -> None:
        match node:
            case nodes.Import():
                self.text(f"import {f'{node.alias} = ' if node.alias else ''}{dotted(node.name)}")
                if node.wildcard:
                    self.text(".*")
                if node.names:
                    self.text(f".{{{', '.join(node.names)}}}")
            case nodes.ShortClass():
                self.text(f"{' '.join((*node.prefixes, node.kind, node.name))} = {dotted(node.base)}")
                self.subscripts(node.subscripts)
                self.modifiers(node.modifiers)
                self.doc(node.doc)
            case nodes.TypeDefinition():
                self.text(f"type {node.name} = ")
                if node.base is None:
                    self._literals(node)
                else:
                    self.text(dotted(node.base))
                self.subscripts(node.subscripts)
                self.modifiers(node.modifiers)
                self.doc(node.doc)
            case nodes.Function():
                self._function(node)

    def _literals(self, node: nodes.TypeDefinition) -> None:
        self.text("enumeration(")
        for position, (name, doc) in enumerate(zip(node.literals, node.literal_docs, strict=True)):
            self.text(", " if position else "")
            self.text(name)
            self.doc(doc)
        self.text(")")

    def _function(self, node: nodes.Function) -> None:
        self.text(f"function {node.name}(")
        for position, parameter in enumerate(node.parameters):
            if position:
                self.text(",")
                self.place(1)
            self.text(f"{dotted(parameter.type_name)} {parameter.name}")
            self.subscripts(parameter.subscripts)
            self.binding(parameter.default)
        self.text(")")
        if node.result is not None:
            self.text(f" -> {dotted(node.result)}")
            self.subscripts(node.result_subscripts)
        self.binding(node.value)
        self.doc(node.doc)

    # ---- declarations ----------------------------------------------------------------------------------------------

    def declaration(
        self, node: nodes.Component | nodes.Coordinate | nodes.Geometry | nodes.Extends | nodes.Annotation
    ) -> None:
        match node:
            case nodes.Component():
                self._declarators(" ".join((*node.prefixes, dotted(node.type_name))), node.declarators)
            case nodes.Coordinate():
                self._declarators(f"coordinate {dotted(node.type_name)}", node.declarators)
            case nodes.Geometry():
                self._declarators(node.keyword, node.declarators)
            case nodes.Extends():
                self.text(f"extends {dotted(node.base)}")
                self.modifiers(node.modifiers)
            case nodes.Annotation():
                self.text("annotation")
                self.modifiers(node.modifiers)

    def _declarators(self, head: str, declarators: Iterable[nodes.Declarator]) -> None:
        self.text(head)
        for position, declarator in enumerate(declarators):
            self.text("," if position else " ")
            if position:
                self.place(0)
            self.text(declarator.name)
            self.subscripts(declarator.subscripts)
            self.modifiers(declarator.modifiers)
            self.binding(declarator.value)
            self.condition(declarator.condition)
            self.doc(declarator.doc)

    def modifiers(self, modifiers: tuple[nodes.AnyModifier, ...], level: int = 3) -> None:
        """`(start = 1, fixed = true)`, or nothing if there are none."""
        if not modifiers:
            return
        self.text("(")
        for position, modifier in enumerate(modifiers):
            if position:
                self.text(",")
                self.place(level)
            self._modifier(modifier, level)
        self.text(")")

    def _modifier(self, node: nodes.AnyModifier, level: int) -> None:
        match node:
            case nodes.Modifier():
                self.text(" ".join((*node.prefixes, dotted(node.name))))
                self.subscripts(node.subscripts)
                self.modifiers(node.modifiers, level + 1)
                self.binding(node.value, level + 1)
            case nodes.RedeclareComponent():
                self.text(f"redeclare {dotted(node.type_name)} {node.name}")
                self.subscripts(node.subscripts)
                self.modifiers(node.modifiers, level + 1)
            case nodes.RedeclareClass():
                self.text(f"redeclare {node.kind} {node.name} = {dotted(node.type_name)}")
                self.modifiers(node.modifiers, level + 1)
            case _:
                assert_never(node)

    # ---- physics ---------------------------------------------------------------------------------------------------

    def physics(
        self,
        node: nodes.Energy
        | nodes.Gravity
        | nodes.PointMass
        | nodes.RigidBody
        | nodes.Load
        | nodes.Constraint
        | nodes.Contact
        | nodes.Friction
        | nodes.Invariant
        | nodes.Measure
        | nodes.Draw,
    ) -> None:
        match node:
            case nodes.Gravity():
                self.text("gravity = ")
                self.expression(node.value, 2)
            case nodes.Energy():
                self.text(f"{node.keyword} {f'{node.label} = ' if node.label else ''}")
                self.expression(node.value, 2)
            case nodes.PointMass():
                self.text("mass ")
                self.expression(node.mass, 2)
                self.clause("at", node.at)
            case nodes.RigidBody():
                self.text(f"body {node.label or ''}" if node.label else "body")
                self.modifiers(node.modifiers)
                self.clause("on", node.on)
            case nodes.Load():
                self.text(f"{node.keyword} {f'{node.label} = ' if node.label else ''}")
                self.expression(node.value, 2)
                for word, part in (("at", node.at), ("on", node.on), ("from", node.origin), ("on", node.origin_on)):
                    self.clause(word, part)
            case nodes.Constraint():
                self._labeled("constraint", node.label, node.left)
                self.binding(node.right)
            case nodes.Contact() | nodes.Friction() | nodes.Invariant() | nodes.Measure():
                label = node.column if isinstance(node, nodes.Measure) else node.label
                self._labeled(_KEYWORDS[type(node)], label, node.value)
                self._options(node.options)
            case nodes.Draw():
                self._draw(node)
            case _:
                assert_never(node)
        if not isinstance(node, nodes.Gravity | nodes.Measure):
            self.condition(node.condition)
        if not isinstance(node, nodes.Draw):
            self.doc(node.doc)

    def _labeled(self, keyword: str, label: str | None, value: nodes.Expression) -> None:
        self.text(f"{keyword} {f'{label}: ' if label else ''}")
        self.expression(value, 2)

    def _options(self, options: tuple[nodes.Named, ...]) -> None:
        if options:
            self.place(1)
            self.text("with ")
            self.arguments(options, 2)

    def _draw(self, node: nodes.Draw) -> None:
        self.text(f"draw {node.shape}")
        if node.arguments:
            self.text("(")
            self.arguments(node.arguments, 2)
            self.text(")")
        words = ("from", "to") if node.place == "between" else (node.place or "",)
        for word, anchor in zip(words, node.anchors, strict=False):
            self.clause(word, anchor)

    # ---- equations and parts ---------------------------------------------------------------------------------------

    def equation(self, node: nodes.Equation | nodes.CallEquation | nodes.Connect) -> None:
        match node:
            case nodes.Equation():
                self.expression(node.left, 2)
                self.binding(node.right)
                self.doc(node.doc)
            case nodes.CallEquation():
                self.expression(node.call, 2)
                self.doc(node.doc)
            case nodes.Connect():
                self.text("connect(")
                self.arguments(node.items, 2)
                self.text(")")
                self.condition(node.condition)

    def binding(self, value: nodes.Expression | None, level: int = 2) -> None:
        if value is not None:
            self.text(" = ")
            self.expression(value, level)

    def clause(self, word: str, value: nodes.Expression | None) -> None:
        """` at P` and its like."""
        if value is not None:
            self.place(1)
            self.text(f"{word} ")
            self.expression(value, 2)

    def condition(self, value: nodes.Expression | None) -> None:
        self.clause("if", value)

    def doc(self, text: str | None) -> None:
        if text is not None:
            self.place(1)
            self.text(quoted(text))


_KEYWORDS: dict[type, str] = {
    nodes.Contact: "contact",
    nodes.Friction: "friction",
    nodes.Invariant: "invariant",
    nodes.Measure: "measure",
}


def dotted(name: nodes.Name) -> str:
    return ".".join(name.parts)
