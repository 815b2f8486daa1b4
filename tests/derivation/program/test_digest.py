"""The digest of a program is that of what it computes and says."""

from __future__ import annotations

from dataclasses import replace

from compiled_programs import program_of

from lagdsl.derivation.program.digest import digest

TEXT = """model M
  parameter Length l = 0.5 m;
  coordinate Angle q(start = 1);
  gravity = -g_n*world.y;
  mass 2 kg at l*{sin(q), -cos(q)};
  output Length x = l*sin(q);
end M;
"""


def test_the_same_text_has_the_same_digest() -> None:
    assert digest(program_of(TEXT)) == digest(program_of(TEXT))


def test_whatever_changes_changes_it() -> None:
    """Values of parameters, constants, operations, names, which elements a function returns."""
    changed = {
        "default": TEXT.replace("0.5 m", "0.6 m"),
        "constant": TEXT.replace("2 kg", "3 kg"),
        "operation": TEXT.replace("x = l*sin(q)", "x = l*cos(q)"),
        "name": TEXT.replace("Length x", "Length y"),
        "sign": TEXT.replace("x = l*sin(q)", "x = -l*sin(q)"),
    }
    found = {name: digest(program_of(text)) for name, text in changed.items()}
    assert len({digest(program_of(TEXT)), *found.values()}) == len(found) + 1
    program = program_of(TEXT)
    first, *others = program.functions
    assert digest(replace(program, functions=(*others, first))) != digest(program)
    assert digest(replace(program, kept_rows=(0,))) != digest(program)
