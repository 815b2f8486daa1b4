"""The grammar as one of tree-sitter, with queries for colours, which Neovim, Helix, Emacs and Zed read.

tree-sitter has no rule that may be empty: such a rule is its non-empty part, and optional where it is used. It does
not look ahead behind a token: a scanner in C finds the unit of a quantity; its list of units is generated.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import assert_never

from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax.ebnf import (
    EMPTY,
    Aliased,
    Choice,
    Expansion,
    Repeat,
    Rule,
    Sequence,
    Symbol,
    Text,
    empty_rules,
    may_be_empty,
    rules,
)
from lagdsl.language.syntax.vocabulary import vocabulary

_TERMINALS = {"IDENT": "identifier", "STRING": "string", "NUMBER": "number", "QUANTITY": "_quantity"}
_PATTERNS = """    identifier: _ => /[A-Za-z_][A-Za-z0-9_]*/,
    string: _ => /"([^"\\\\]|\\\\(.|\\n))*"/,
    number: _ => /[0-9]+(\\.[0-9]+)?([eE][+-]?[0-9]+)?/,
    _quantity: $ => seq($.number, $.unit),
    comment: _ => token(choice(/\\/\\/[^\\n]*/, /\\/\\*[^*]*\\*+([^\\/*][^*]*\\*+)*\\//)),
"""
_HEAD = """// Generated from grammar/lagdsl.lark by `make update`.
/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

module.exports = grammar({
  name: "lagdsl",
  word: $ => $.identifier,
  extras: $ => [/[ \\t\\r\\n]/, $.comment],
  externals: $ => [$.unit, $._error],
  reserved: { global: _ => RESERVED },
  rules: {
"""
_GENERATED = "Generated from grammar/lagdsl.lark by `make update`."
_LITERALS = ("true", "false")


def grammar() -> str:
    """The text of `grammar.js`."""
    known = _TERMINALS | {rule.name: f"_{rule.name}" for rule in rules() if rule.is_level or _is_choice_of_names(rule)}
    lines = [_HEAD.replace("RESERVED", _listed(sorted(vocabulary().reserved)))]
    for rule in rules():
        name = known.get(rule.name, rule.name)
        body, aliased = _without_empty(rule.expansion), []
        options = body.options if isinstance(body, Choice) else (body,)
        shown = []
        for number, option in enumerate(options):
            if isinstance(option, Aliased):
                own = f"_{rule.name.strip('_')}_{number}"
                aliased.append(f"    {own}: $ => {_text(option.part, known)},\n")
                shown.append(f"alias($.{own}, $.{option.name})")
            else:
                shown.append(_text(option, known))
        whole = shown[0] if len(shown) == 1 else f"choice({', '.join(shown)})"
        if rule.name == "start":
            whole = _text(rule.expansion, known)
        lines += [f"    {name}: $ => {whole},\n", *aliased]
    return "".join([*lines, _PATTERNS, "  },\n});\n"])


def _is_choice_of_names(rule: Rule) -> bool:
    """True for a rule whose nodes all have names of their own."""
    expansion = rule.expansion
    options = expansion.options if isinstance(expansion, Choice) else (expansion,)
    return all(isinstance(option, Aliased) for option in options)


def _without_empty(expansion: Expansion) -> Expansion:
    """The expansion without the empty text."""
    empty = empty_rules()
    if not may_be_empty(expansion, empty):
        return expansion
    match expansion:
        case Symbol():
            return expansion  # such a rule is without the empty text itself
        case Sequence():
            options = []
            for number, part in enumerate(expansion.parts):
                options.append(Sequence((_without_empty(part), *expansion.parts[number + 1 :])))
                if not may_be_empty(part, empty):
                    break
            return Choice(tuple(options))
        case Choice():
            return Choice(tuple(_without_empty(option) for option in expansion.options if option != EMPTY))
        case Repeat():
            return Sequence((expansion.part, expansion))
        case Aliased():
            return Aliased(expansion.name, _without_empty(expansion.part))
        case Text():
            raise AssertionError(expansion)
        case _:
            assert_never(expansion)


def _text(expansion: Expansion, known: dict[str, str]) -> str:
    """The expansion in the language of `grammar.js`."""
    match expansion:
        case Text():
            return json.dumps(expansion.text)
        case Symbol():
            return _symbol(expansion.name, known)
        case Sequence(parts=(first, Repeat(part=again))) if first == again:
            return f"repeat1({_text(first, known)})"
        case Sequence():
            parts = [_text(part, known) for part in expansion.parts]
            return parts[0] if len(parts) == 1 else f"seq({', '.join(parts)})"
        case Choice():
            options = [_text(option, known) for option in expansion.options if option != EMPTY]
            whole = options[0] if len(options) == 1 else f"choice({', '.join(options)})"
            return f"optional({whole})" if EMPTY in expansion.options else whole
        case Repeat():
            return f"repeat({_text(expansion.part, known)})"
        case Aliased():
            raise AssertionError(f"{expansion.name} is not a whole option of its rule")
        case _:
            assert_never(expansion)


def _symbol(name: str, known: dict[str, str]) -> str:
    if name.isupper() and name not in _TERMINALS:
        words, marks, _ = vocabulary()
        spelled = [text for text, terminals in words.items() if name in terminals]
        spelled = spelled or [text for text, terminal in marks.items() if terminal == name]
        return _choice(spelled)
    found = f"$.{known.get(name, name)}"
    return f"optional({found})" if name in empty_rules() else found


def _choice(texts: list[str]) -> str:
    assert texts
    quoted = [json.dumps(text) for text in texts]
    return quoted[0] if len(quoted) == 1 else f"choice({', '.join(quoted)})"


def _listed(texts: list[str]) -> str:
    return f"[{', '.join(json.dumps(text) for text in texts)}]"


def highlights() -> str:
    """The text of `queries/highlights.scm`: colours by the names of captures that editors agree on."""
    words, marks, _ = vocabulary()
    keywords = [word for word in words if word not in _LITERALS]
    delimiters, brackets = [",", ";"], ["(", ")", "[", "]", "{", "}"]
    operators = [mark for mark in marks if mark not in (*delimiters, *brackets)]
    rows = [
        f"; {_GENERATED}",
        "(identifier) @variable",
        "(class_def (identifier) @type)",
        "(short_class . (prefix)* . _ . (identifier) @type)",
        "(type_def . _ . (identifier) @type)",
        "(function_def . _ . (identifier) @function)",
        "(comment) @comment",
        "(string) @string",
        "(number) @number",
        "(unit) @type.builtin",
        _captured(keywords, "keyword"),
        _captured(_LITERALS, "boolean"),
        _captured(operators, "operator"),
        _captured(delimiters, "punctuation.delimiter"),
        _captured(brackets, "punctuation.bracket"),
    ]
    return "\n".join(rows) + "\n"


def _captured(texts: Iterable[str], capture: str) -> str:
    return f"[\n{''.join(f'  {json.dumps(text)}{chr(10)}' for text in texts)}] @{capture}"


def units() -> str:
    """The text of `src/units.h`."""
    rows = "".join(f"  {json.dumps(unit)},\n" for unit in UNITS)
    return f"// {_GENERATED}\n\nstatic const char *const UNITS[] = {{\n{rows}}};\n"
