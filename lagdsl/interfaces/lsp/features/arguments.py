"""Names before `=` in statements of the language: what may stand in `body b(`, `draw box(`, `contact ... with`,
`friction ... with`, `annotation(`."""

from __future__ import annotations

from lagdsl.interfaces.lsp.features.cursor import Cursor
from lagdsl.language.semantics.classes.annotations import ANNOTATIONS, CONTROLS, SETTINGS
from lagdsl.language.semantics.items import contacts, frictions, measurements
from lagdsl.language.semantics.items.bodies import PROPERTIES
from lagdsl.language.semantics.items.shapes import SHAPES


def arguments_at(cursor: Cursor) -> tuple[str, ...]:
    """The names that may be given a value at the cursor, none where others may."""
    statement, brackets = cursor.statement, cursor.brackets
    if not statement or (brackets and brackets[-1].has_value):
        return ()
    match statement[0], len(brackets):
        case "annotation", 1:
            return ANNOTATIONS
        case "annotation", 2 if brackets[-1].before == ("experiment",):
            return SETTINGS
        case "annotation", 2 if brackets[-1].before == ("page",):
            return CONTROLS
        case "body", 1:
            return PROPERTIES
        case "draw", 1 if statement[1] in SHAPES:
            return tuple(dict.fromkeys(name for names in SHAPES[statement[1]].arguments.values() for name in names))
        case "contact" | "friction" | "measure", 0 if "with" in statement:
            last = max(k for k, text in enumerate(statement) if text in (",", "with"))
            options = {"contact": contacts.OPTIONS, "friction": frictions.OPTIONS, "measure": measurements.OPTIONS}
            known = options[statement[0]]
            return known if "=" not in statement[last:] else ()
        case _:
            return ()


def shapes_at(cursor: Cursor) -> tuple[str, ...]:
    """The shapes of `draw`, where one stands at the cursor."""
    is_next = cursor.statement[:1] == ("draw",) and cursor.statement[1:] in ((), (cursor.word,))
    return tuple(SHAPES) if is_next else ()
