"""Long expressions with intermediate quantities: the same values, short lines, names of the model first."""

from __future__ import annotations

import math
import re
from pathlib import Path
from unicodedata import normalize

import pytest
import sympy
from sympy import Expr, Integer, Symbol, cos, sin, sqrt

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.derivation.textbook.tidy import size
from lagdsl.documents.report.derivation import render
from lagdsl.documents.report.intermediate import LONGEST, Intermediates
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import flatten_file, read
from report.printed import value

_MODELS = Path(__file__).parents[3] / "models"
a, b, c, d = sympy.symbols("a b c d")


def nested(depth: int) -> Expr:
    """f(f(... a)), in which every level stands four times: 4^depth nodes on paper."""
    found = a
    for number, other in zip(range(depth), (b, c, d) * depth, strict=False):
        found = sin(found) * other + cos(found) ** 2 / (1 + found**2 + number)
    return found


def written_back(expression: Expr, made: list[tuple[Symbol, Expr]]) -> Expr:
    for symbol, meaning in reversed(made):
        expression = expression.subs(symbol, meaning)
    return expression


@pytest.mark.parametrize("depth", [3, 5, 7])
def test_a_long_expression_is_short_and_the_same(depth: int) -> None:
    whole = nested(depth)
    found = Intermediates(lambda number: Symbol(f"s{number}"))
    short, _ = found.short(whole)
    assert (size(whole) > LONGEST) == bool(found.made)
    assert all(size(each) <= LONGEST for each in (short, *(meaning for _, meaning in found.made)))
    at = {a: 0.3, b: 1.1, c: -0.7, d: 0.4}
    numbers = dict(at)
    for symbol, meaning in found.made:  # each stands before what is written with it
        assert meaning.free_symbols <= set(numbers)
        numbers[symbol] = float(meaning.subs(numbers))
    assert float(short.subs(numbers)) == pytest.approx(float(whole.subs(at)), rel=1e-12)


def test_a_name_of_the_model_comes_before_a_new_one() -> None:
    long_name, whole = sqrt(a**2 + 2 * a * b * cos(c) + b**2), nested(6)
    found = Intermediates(lambda number: Symbol(f"s{number}"), named={long_name: Symbol("r")})
    short, rules = found.short(whole + long_name * sin(d) + d / long_name)
    assert Symbol("r") in short.free_symbols and Symbol("r") in found.used
    assert long_name not in [meaning for _, meaning in found.made]
    term = long_name * sin(d)
    for rule in rules:
        term = term.xreplace(rule)
    assert term in short.args


def test_symbols_that_stay_are_in_no_new_one() -> None:
    found = Intermediates(lambda number: Symbol(f"s{number}"), frozenset({a}))
    found.short(sympy.Add(*(Symbol(f"x{k}") * nested(5).subs({d: Integer(k)}) for k in range(4))))
    assert all(a not in meaning.free_symbols for _, meaning in found.made)


def test_what_fills_pages_is_out_of_reach() -> None:
    found = Intermediates(lambda number: Symbol(f"s{number}"))
    assert found.reach(nested(6))
    assert not found.reach(nested(16))
    assert found.made == []  # a trial leaves nothing


@pytest.fixture(scope="module")
def four_bar() -> str:
    """Without the forces of its pins, which are outputs."""
    lines = (_MODELS / "four_bar_crank.lag").read_text(encoding="utf-8").splitlines()
    source = "\n".join(line for line in lines if "pinC" not in line and "reaction(" not in line)
    sink = Sink()
    file = read(source + "\n", sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    return render(recipe(flat), "text", units=True)


def test_a_loop_solved_by_hand_reads_by_its_angles(four_bar: str) -> None:
    for line in (
        "r_bar₃ = (d + ½ l₃ cos c, ½ l₃ sin c)  [m]",
        "v_bar₃ = (−½ l₃ ċ sin c, ½ l₃ ċ cos c)  [m/s]",
        "ω_bar₃ = ċ  [rad/s]",
        "ẋ = l₁ ȧ sin a  [m/s]",
        "Time occurs nowhere and no load or dashpot works: the energy is constant.",
    ):
        assert line in four_bar, line
    assert "𝔰" not in four_bar


def angles(crank: float) -> tuple[float, ...]:
    """Law of cosines in the triangle of crank pin, pin C and D, in the model's values."""
    x, y = 1 - 0.4 * math.cos(crank), -0.4 * math.sin(crank)
    s = math.hypot(x, y)
    coupler = math.atan2(y, x) + math.acos((1 + s * s - 0.64) / (2 * s))
    return x, y, s, coupler, math.atan2(math.sin(coupler) - y, math.cos(coupler) - x)


def test_printed_rates_are_the_slopes_of_the_angles(four_bar: str) -> None:
    lines: dict[str, str] = {}
    name = ""
    section = four_bar.split("3. Velocities")[1].split("4. Energies", maxsplit=1)[0].split("\nwith\n")[1]
    for line in section.splitlines():
        text = re.sub(r"  \[[^]]*\]$", "", line.strip())
        if " = " in text:
            name, text = text.split(" = ")
        lines[name] = f"{lines.get(name, '')} {text}".strip()
    for crank in (0.4, 1.0, 2.2):
        step, rate = 1e-5, 1.7
        x, y, s, coupler, rocker = angles(crank)
        values = {"l₁": 0.4, "l₂": 1.0, "l₃": 0.8, "d": 1.0, "a": crank, "ȧ": rate}
        values |= {"x": x, "y": y, "s": s, "b": coupler, "c": rocker}
        for name, up, down in zip("xysbc", angles(crank + step), angles(crank - step), strict=True):
            key = normalize("NFC", f"{name}\u0307")
            values[key] = value(lines[key], values)
            assert values[key] == pytest.approx(rate * (up - down) / (2 * step), rel=1e-7)
