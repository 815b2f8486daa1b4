"""The flat model of every instance is that of its text written out by hand, for random trees of classes, and however
the text is arranged."""

from __future__ import annotations

import re
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from choice import ALL, examples
from class_trees import MODEL, Kind, Meaning, meaning, text_of, trees
from flattening import run
from hypothesis import given, settings

import lagdsl
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.syntax.parser import parse


def flat_of(text: str, model: str = "Whole") -> fm.FlatModel:
    flat, sink = run(text, model=model)
    assert flat is not None, (text, [(d.code, d.message, d.labels[0].span.text) for d in sink.diagnostics])
    return flat


def lagrangian(flat: fm.FlatModel, q: dict[str, float], qd: dict[str, float]) -> float:
    """T - V of point masses and of the energies that stand in the text."""
    values = Evaluator(flat, Values(variables=q, rates=qd))
    later = Evaluator(flat, Values(variables={name: x + qd[name] for name, x in q.items()}))
    total = -sum(values.scalar(term.value) for term in flat.energies)
    for item in flat.masses:
        moved = later.vector(item.position) - values.vector(item.position)  # positions are linear in x
        total += values.scalar(item.mass) / 2 * float(moved @ moved)
    return total


def by_formula(found: Meaning, q: dict[str, float], qd: dict[str, float]) -> float:
    each = sum(mass.m / 2 * qd[mass.name] ** 2 - mass.k / 2 * q[mass.name] ** 2 for mass in found.masses)
    return each - sum(k / 2 * (q[one] - q[two]) ** 2 for one, two, k in found.springs)


def check(flat: fm.FlatModel, found: Meaning, names: dict[str, str]) -> None:
    """Starts, heights and the Lagrangian at a random state; `names` are those of the coordinates in `flat`."""
    still = Evaluator(flat, Values())
    starts = {coordinate.name: still.scalar(coordinate.start) for coordinate in flat.coordinates}
    assert starts == pytest.approx({names[mass.name]: mass.start for mass in found.masses}, rel=1e-12)
    heights = sorted(still.vector(item.position)[1] for item in flat.masses)
    assert heights == pytest.approx(sorted(mass.height for mass in found.masses), rel=1e-12)
    random = Random(len(starts))
    q, qd = ({mass.name: random.uniform(-1, 1) for mass in found.masses} for _ in range(2))
    here, there = ({names[name]: value for name, value in state.items()} for state in (q, qd))
    assert lagrangian(flat, here, there) == pytest.approx(by_formula(found, q, qd), rel=1e-9)


def same(found: Meaning) -> dict[str, str]:
    return {mass.name: mass.name for mass in found.masses}


@given(trees())
@settings(max_examples=examples(150), deadline=None)
def test_instances_are_what_is_written_out(kinds: list[Kind]) -> None:
    found = meaning(kinds[-1])
    flat = flat_of(text_of(kinds))
    assert [coordinate.name for coordinate in flat.coordinates] == [mass.name for mass in found.masses]
    check(flat, found, same(found))
    names = {mass.name: f"x{number}" for number, mass in enumerate(found.masses)}
    check(flat_of(found.text(), "ByHand"), found, names)


@given(trees())
@settings(max_examples=examples(30), deadline=None)
def test_the_order_of_the_text_means_nothing(kinds: list[Kind]) -> None:
    found = meaning(kinds[-1])
    check(flat_of(text_of(kinds, Random(len(kinds)))), found, same(found))


@given(trees())
@settings(max_examples=examples(30), deadline=None)
def test_names_mean_nothing(kinds: list[Kind]) -> None:
    def other(text: str) -> str:
        text = re.sub(r"\b(Leaf|Row|Field|Block|House)\b", r"Z\1", text)
        return re.sub(r"\b(x|P|[abi]|[a-z]+_[a-z]+[0-9])\b", r"other_\1", text)

    found = meaning(kinds[-1])
    flat = flat_of(other(text_of(kinds)))
    check(flat, found, {mass.name: other(mass.name) for mass in found.masses})


@given(trees())
@settings(max_examples=examples(30), deadline=None)
def test_a_class_around_means_nothing(kinds: list[Kind]) -> None:
    found = meaning(kinds[-1])
    text = text_of(kinds).replace(MODEL, "model Town House h; end Town; model Whole Town t; gravity = 0; end Whole;")
    check(flat_of(text), found, {mass.name: f"t.h.{mass.name}" for mass in found.masses})


@given(trees())
@settings(max_examples=examples(20), deadline=None)
def test_files_mean_nothing(kinds: list[Kind]) -> None:
    found = meaning(kinds[-1])
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "Trees").mkdir()
        (folder / "Trees" / "package.lag").write_text("package Trees\nend Trees;\n")
        for kind in kinds:
            (folder / "Trees" / f"{kind.name}.lag").write_text(f"within Trees;\n{kind.text()}\n")
        sink = Sink()
        unit = parse(SourceFile(str(folder / "x.lag"), f"import Trees.*;\n{MODEL}"), sink)
        assert unit is not None
        flat = flatten(unit, sink)
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    check(flat, found, same(found))


@given(trees())
@settings(max_examples=4 if ALL else 2, deadline=None)
def test_they_move_as_written_out(kinds: list[Kind]) -> None:
    """x(t) = sum of modes: M x'' = -K x from the numbers of the masses and springs."""
    found = meaning(kinds[-1])
    place = {mass.name: number for number, mass in enumerate(found.masses)}
    stiffness = np.diag([mass.k for mass in found.masses])
    for one, two, k in found.springs:
        row = np.zeros(len(place))
        row[place[one]], row[place[two]] = 1.0, -1.0
        stiffness += k * np.outer(row, row)
    root = np.sqrt([mass.m for mass in found.masses])
    squares, shapes = np.linalg.eigh(stiffness / np.outer(root, root))
    modal = shapes.T @ (root * np.array([mass.start for mass in found.masses]))
    expected = shapes @ (np.cos(np.sqrt(squares) * 0.5) * modal) / root
    model = lagdsl.compile(text_of(kinds), model="Whole")
    motion = model.simulate(stop=0.5, tolerance=1e-10)
    reached = [motion[name][-1] for name in place]
    assert reached == pytest.approx(expected, abs=1e-7 * max(mass.start for mass in found.masses))


LEGS = """
model Spring point a, b; parameter Stiffness k; potential 1/2*k*(norm(b - a) - 1 m)^2; end Spring;
model Leg
  parameter Length at;
  parameter Integer n = 2;
  coordinate Length y;
  point P[2] = {{at, y}, {at, 2*y}};
  point Q[2] = {{at, 0}, {at, 0}};
  mass 1 kg at P[1];
  Spring spring[2](a = P, b = Q, each k = 1 N/m);
end Leg;
model Cell parameter Real s; input Real u; coordinate Real x(start = s); kinetic (1 kg.m2)*der(x)^2; end Cell;
"""


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        ("Leg one(at = 1 m), two(at = 2 m); output Length o[4] = "
         "{one.spring[1].a*world.x, one.spring[2].b*world.x, two.spring[1].a*world.x, two.spring[2].b*world.x};",
         [1, 1, 2, 2]),
        ("Pair one(s = {1, 2}), two(s = {3, 4}); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [1, 2, 3, 4]),
        ("Any one(n = 2, s = {1, 2}), two(n = 3, s = {3, 4, 5}); output Real o[5] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s, two.c[3].s};", [1, 2, 3, 4, 5]),
        ("Twice one(s = {1, 2}), two(s = {3, 4}); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [2, 4, 6, 8]),
        ("Cut one(s = {1, 2, 3}), two(s = {4, 5, 6}); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [2, 3, 5, 6]),
        ("Turned one(s = 1), two(s = 2); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [1, 2, 2, 4]),
        ("Heir one(s = {1, 2}), two(s = {3, 4}); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [1, 2, 3, 4]),
        ("Fed one(r = 1), two(r = 2); output Real o[4] = {one.c[1].u, one.c[2].u, two.c[1].u, two.c[2].u};",
         [1, 2, 2, 4]),
        ("Row2 row[2](p = {{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}}); output Real o[2, 2, 2] = "
         "{row[i].pair[j].c[k].s for k in 1:2, j in 1:2, i in 1:2};", [1, 2, 3, 4, 5, 6, 7, 8]),
        ("Pick one(first = true), two(first = false); output Real o[4] = "
         "{one.c[1].s, one.c[2].s, two.c[1].s, two.c[2].s};", [1, 2, 3, 4]),
    ],
)  # fmt: skip
def test_what_is_split_belongs_to_its_instance(inside: str, expected: list[float]) -> None:
    text = f"""{LEGS}
    model Pair parameter Real s[2]; Cell c[2](s = s, each u = 0); end Pair;
    model Any structural parameter Integer n; parameter Real s[n]; Cell c[n](s = s, each u = 0); end Any;
    model Twice parameter Real s[2]; Cell c[2](s = 2*s, each u = 0); end Twice;
    model Cut parameter Real s[3]; Cell c[2](s = s[2:3], each u = 0); end Cut;
    model Turned parameter Real s; Cell c[2](s = {{i*s for i in 1:2}}, each u = 0); end Turned;
    partial model Base parameter Real s[2]; Cell c[2](s = s, each u = 0); end Base;
    model Heir extends Base; end Heir;
    model Fed parameter Real r; Real v[2] = {{r, 2*r}}; Cell c[2](each s = 0, u = v); end Fed;
    model Row2 parameter Real p[2, 2]; Pair pair[2](s = p); end Row2;
    model Pick
      structural parameter Boolean first;
      Cell c[2](s = if first then {{1, 2}} else {{3, 4}}, each u = 0);
    end Pick;
    model Whole {inside} gravity = 0; end Whole;
    """
    flat = flat_of(text)
    still = Evaluator(flat, Values())
    found = [still.scalar(item.value) for item in flat.outputs]
    assert found == pytest.approx(np.ravel(expected))
