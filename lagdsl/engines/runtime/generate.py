"""Writes the functions of a program into the C runtime: `python -m lagdsl.engines.runtime.generate`.

A tool of development.

The table is `lagdsl/derivation/program/functions.py`. From it come the function pointers of lag_model, the enumeration
lag_function and the dispatcher lag_evaluate(), and what tapes check and call, each between two marks in a written
file. Translation units (`units.py`) and the ctypes structures for the headers (`headers.py`) are written after them.
"""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import FUNCTIONS, SOLVED, SOLVED_DIRECTIONS, Presence, Result, Signature
from lagdsl.engines.backends.tape.instructions import GROUPS
from lagdsl.engines.runtime.headers import structures_text
from lagdsl.engines.runtime.units import unit_texts
from lagdsl.engines.runtime.words import words_text
from lagdsl.foundation.resources import c_folder, fmi_folder

STRUCTURES = Path(__file__).with_name("structures.py")
_FIRST = "/* ---- the functions, generated ---- */\n"
_LAST = "/* ---- end of what is generated ---- */\n"
_WIDTH = 132


def texts() -> dict[Path, str]:
    """The written files with the present sections, and a header that is written as a whole, by path."""
    sections = {
        "lag/model.h": ("    ", members()),
        "lag/evaluate.h": ("    ", enumerators()),
        "lag/equations/evaluate.c": ("", dispatcher()),
        "lag/tape/tape_check.c": ("    ", tape_signatures()),
        "lag/tape/tape_functions.c": ("", tape_functions()),
    }
    written = {c_folder() / name: _with(c_folder() / name, *section) for name, section in sections.items()}
    return {**written, fmi_folder() / "lag/words.h": words_text()}


def members() -> str:
    """The function pointers of lag_model."""
    return "".join(map(_member, _single()))


def enumerators() -> str:
    """The values of lag_function, and which is the last."""
    values = ",\n".join(f"    {_enumerator(function)}" for function in _single())
    return f"{values}\n#define LAG_LAST_FUNCTION {_enumerator(_single()[-1])}\n"


def dispatcher() -> str:
    """One function for each, which lays its results out, and the choice among them."""
    parameters = "const lag_model *model, {}const lag_arguments *at, double *results"
    every = " ".join(
        f"[{_enumerator(each)}]\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}evaluate_{each.name}," for each in _single()
    )
    cases = textwrap.indent(textwrap.fill(every, _WIDTH - 8).replace("\N{NO-BREAK SPACE}", " "), " " * 8) + "\n"
    chosen = (
        f"lag_status lag_evaluate({parameters.format('lag_function which, ')})\n{{\n"
        f"    static lag_status (*const functions[])({parameters.format('')}) = {{\n{cases}    }};\n"
        "    return (size_t)which < sizeof functions / sizeof *functions ? "
        "functions[which](model, at, results) : LAG_MISSING;\n}\n"
    )
    return "".join(map(_laid_out, _single())) + chosen


def tape_signatures() -> str:
    """Arguments that a function of a tape may read, one bit by group of arguments, and the shapes of its results."""
    lines = (f"[1 + {_enumerator(each)}] = {tape_signature(each)}," for each in _single())
    return "".join(f"{_wrapped(line)}\n" for line in lines)


def _wrapped(line: str) -> str:
    kept = line.replace(", N", ",\N{NO-BREAK SPACE}N") if len(line) + 4 > _WIDTH else line
    filled = textwrap.fill(kept, _WIDTH, initial_indent=" " * 4, subsequent_indent=" " * 8, break_on_hyphens=False)
    return filled.replace("\N{NO-BREAK SPACE}", " ")


def tape_signature(function: Signature) -> str:
    """Arguments, number of results, and rows and columns of each."""
    arguments = sum(1 << GROUPS[group] for group in function.arguments)
    kinds = ("NUMBER", "VECTOR", "MATRIX")
    shapes = [f"{kinds[len(r.shape)]}({', '.join(r.shape).upper()})" for r in function.results]
    return f"{{0x{arguments:04x}, {len(shapes)}, {{{', '.join(shapes)}}}}}".replace("NUMBER()", "NUMBER")


def tape_functions() -> str:
    """The functions of models that are filled from tapes, and what gives a model those that it has."""
    given = "".join(
        f"    tape->model.{each.name} = lag_tape_has(tape, {_enumerator(each)}) ? {each.name} : NULL;\n"
        for each in _single()
    )
    return "".join(map(_of_tape, _single())) + f"static void give(lag_tape *tape)\n{{\n{given}}}\n"


def _of_tape(function: Signature) -> str:
    names = ", ".join(result.name for result in function.results)
    parameters = ["const lag_arguments *at", *(f"double *{result.name}" for result in function.results)]
    head = _declaration(f"static lag_status {function.name}(", parameters).rstrip(";\n")
    return (
        f"{head}\n{{\n    double *const results[] = {{{names}}};\n"
        f"    return run(at, 1 + {_enumerator(function)}, results);\n}}\n\n"
    )


def _single() -> list[Signature]:
    return [function for function in FUNCTIONS if function.single]


def _enumerator(function: Signature) -> str:
    return f"LAG_{function.name.upper()}"


# ---- lag/model.h -----------------------------------------------------------------------------------------------------


def _member(function: Signature) -> str:
    where = "" if function.presence is Presence.ALWAYS else f". {function.presence.value}"
    shapes = ", ".join(result.name + _shape(result) for result in function.results)
    comment = f"{_arguments(function.arguments)} -> {shapes}: {function.says}{where}"
    parameters = ["const lag_arguments *at", *(f"double *{result.name}" for result in function.results)]
    return _comment(comment) + _declaration(f"    lag_status (*{function.name})(", parameters)


def _arguments(groups: Sequence[Group]) -> str:
    """Times and states, then directions."""
    names = [ARGUMENT_NAMES[group] for group in groups]
    along = {ARGUMENT_NAMES[group] for group in SOLVED_DIRECTIONS}
    given, directions = [n for n in names if n not in along], [n for n in names if n in along]
    assert set(names) <= along | {ARGUMENT_NAMES[group] for group in SOLVED}
    return ", ".join(" ".join(part) for part in (given, directions) if part)


def _shape(result: Result) -> str:
    return f" ({', '.join(result.shape)})" if result.shape else ""


def _comment(text: str) -> str:
    if len(text) + 10 <= _WIDTH:
        return f"    /* {text} */\n"
    lines = textwrap.wrap(text, _WIDTH - 7, break_long_words=False, break_on_hyphens=False)
    return "    /*\n" + "".join(f"     * {line}\n" for line in lines) + "     */\n"


def _declaration(head: str, parameters: Sequence[str]) -> str:
    whole = f"{head}{', '.join(parameters)});\n"
    if len(whole) <= _WIDTH:
        return whole
    joined = ", ".join(parameters).replace("double *", "double\N{NO-BREAK SPACE}*") + ");"
    wrapped = textwrap.fill(joined, _WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 8)
    return f"{head}\n{wrapped}\n".replace("\N{NO-BREAK SPACE}", " ")


# ---- src/evaluate.c --------------------------------------------------------------------------------------------------


def _laid_out(function: Signature) -> str:
    names = [result.name for result in function.results]
    lines = [f"double *const {names[0]} = results;"]
    for before, after in pairwise(function.results):
        length = " * ".join(f"model->{length}" for length in before.shape) or "1"
        lines.append(f"double *const {after.name} = {before.name} + {length};")
    if len(names) == 1:
        lines, names = [], ["results"]
    call = f"model->{function.name} == NULL ? LAG_MISSING : model->{function.name}(at, {', '.join(names)});"
    head = (
        f"static lag_status evaluate_{function.name}(const lag_model *model, const lag_arguments *at, double *results)"
    )
    body = "".join(f"    {line}\n" for line in (*lines, f"return {call}"))
    return f"{head}\n{{\n{body}}}\n\n"


def _with(path: Path, indent: str, section: str) -> str:
    text = path.read_text(encoding="utf-8")
    before, first, rest = text.partition(indent + _FIRST)
    _, last, after = rest.partition(indent + _LAST)
    assert first and last, f"{path.name} has no marks"
    return before + first + section + last + after


if __name__ == "__main__":
    for path, text in texts().items():
        path.write_text(text, encoding="utf-8")
    for path, text in unit_texts().items():
        path.write_text(text, encoding="utf-8")
    STRUCTURES.write_text(structures_text(), encoding="utf-8")
