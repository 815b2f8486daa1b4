"""The checked-in tables are those of the grammar, and nothing builds them at run time."""

import os
import subprocess
import sys
from pathlib import Path

from lagdsl import resources
from lagdsl.syntax import generate, tables
from lagdsl.syntax.lexer import RESERVED

ROOT = Path(__file__).parents[2]


def run(code: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, **environment},
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return done.stdout


def test_tables_are_those_of_the_grammar():
    text = generate.tables_text(resources.grammar_file().read_text(encoding="utf-8"))
    assert text == Path(tables.__file__).read_text(encoding="utf-8"), "run `python -m lagdsl.syntax.generate`"


def test_tables_do_not_depend_on_the_hash_seed():
    code = (
        "import hashlib; from lagdsl.resources import grammar_file; from lagdsl.syntax.generate import tables_text;"
        "print(hashlib.sha256(tables_text(grammar_file().read_text(encoding='utf-8')).encode()).hexdigest())"
    )
    assert run(code, PYTHONHASHSEED="1") == run(code, PYTHONHASHSEED="2")


def test_main_writes_the_tables(tmp_path, monkeypatch):
    monkeypatch.setattr(generate, "__file__", str(tmp_path / "generate.py"))
    generate.main()
    assert (tmp_path / "tables.py").read_bytes() == Path(tables.__file__).read_bytes()


def test_parsing_loads_neither_lark_nor_anything_heavy():
    code = (
        "import sys; from lagdsl.source import SourceFile; from lagdsl.diagnostics import Sink;"
        "from lagdsl.syntax.parser import parse;"
        "assert parse(SourceFile('t', 'model M Real x = 3 kg; end M;'), Sink());"
        "print([name for name in ('lark', 'numpy', 'sympy', 'scipy', 'rich', 'pint') if name in sys.modules])"
    )
    assert run(code) == "[]\n"


def test_units_are_no_keywords():
    assert not set(tables.UNITS) & (set(tables.WORDS) | RESERVED)
    assert len(set(tables.UNITS)) == len(tables.UNITS) > 60


def test_units_are_those_of_the_vocabulary():
    from lagdsl.units.vocabulary import UNITS

    assert set(tables.UNITS) == set(UNITS)


def test_no_state_takes_a_word_for_two_keywords():
    from lagdsl.syntax.automaton import row

    for state in range(len(tables.ROWS)):
        accepted = row(state)
        for word, terminals in tables.WORDS.items():
            assert sum(terminal in accepted for terminal in terminals) <= 1, (state, word)
