"""Texts of loops by templates: the flat model is that of the loop written out, with every fault of every turn."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import pytest
from flattening import run

from lagdsl.language.semantics.expressions import expressions
from lagdsl.language.syntax import nodes

N = 5
DECLARED = f"""
  structural parameter Integer N = {N};
  parameter Mass m[{N}] = {{i*(1 kg) for i in 1:{N}}};
  parameter Real k(unit = "N/m") = 2, EI(unit = "N.m") = 1;
  constant Real c[{N}] = {{1, 0, 2, 0, 3}};
  Length l = (1 m)/N;
  coordinate Length x[{N}], grid[{N}, {N}];
  coordinate Angle th[{N}];
  Real a[{N}] = {{th[1], 2, der(th[1])*(1 s), th[2]*th[1], c[3]}};
  Link link[{N}];
"""
LINK = "model Link\n  parameter Mass m = 2 kg;\n  coordinate Length y;\nend Link;\n"
# Differences, branches at the ends, rates, functions, numbers of the index, elements of several types, members, several
# subscripts, no index, discontinuities.
TEXTS = (
    "potential 1/2*k*(x[{i}] - (if {i} == 1 then 0 else x[max({i}-1, 1)]))^2;",
    "potential k*(x[{i}] - (if {i} == 1 then 0 else x[max({i}-1, 1)]))*l;",
    "potential 1/2*k*(if {i} > 1 and {i} < N then x[{i}-1] - x[{i}+1] else 2*x[{i}])^2;",
    "kinetic 1/2*m[{i}]*der(x[{i}])^2;",
    "potential -EI*cos((th[{i}] + th[N + 1 - {i}])/2) + EI*sin(-th[{i}]);",
    "potential EI*(c[{i}]*th[{i}] + {i}*th[1])^{i};",
    "dissipation (1 W)*(a[{i}] + th[1])^2;",
    "kinetic 1/2*link[{i}].m*der(link[{i}].y)^2;",
    "potential 1/2*k*(grid[{i}, N] - grid[1, {i}])^2;",
    "potential 1/2*k*x[1]^2;",
    "dissipation (1 W)*abs(der(th[{i}])*(1 s));",
)


def model(body: str) -> str:
    return f"{LINK}model M\n{DECLARED}  kinetic 1/2*m[1]*der(grid[1, 1])^2;\n{body}\nend M;\n"


def looped(text: str, turns: str = f"1:{N}") -> str:
    return f"for i in {turns} loop {text.replace('{i}', 'i')} end for;"


def test_a_loop_is_what_it_is_written_out() -> None:
    one, _ = run(model(looped("\n".join(TEXTS))))
    other, _ = run(model("\n".join(text.replace("{i}", str(i)) for i in range(1, N + 1) for text in TEXTS)))
    assert one is not None and other is not None
    assert [term.value for term in one.energies] == [term.value for term in other.energies]
    assert [item.name for item in one.named] == [item.name for item in other.named]
    assert [each.difference for each in one.events.relations] == [each.difference for each in other.events.relations]


def test_nested_loops_and_reductions_are_what_they_are_written_out() -> None:
    text = "potential k*x[i]*x[j] + k*sum(x[i]*grid[i, n]^2/l for n in 1:j)/N;"
    nested = f"for i in 1:3 loop for j in i:3 loop {text} end for; end for;"
    pairs = [(i, j) for i in range(1, 4) for j in range(i, 4)]
    written = [f"potential k*x[{i}]*x[{j}] + k*sum(x[{i}]*grid[{i}, n]^2/l for n in 1:{j})/N;" for i, j in pairs]
    one, _ = run(model(nested))
    other, _ = run(model("\n".join(written)))
    assert one is not None and other is not None
    assert [term.value for term in one.energies] == [term.value for term in other.energies]


def test_labels_of_turns_are_their_values() -> None:
    flat, _ = run(model(looped("potential V = 1/2*k*x[{i}]^2;")))
    assert flat is not None
    assert [item.name for item in flat.named if item.name.startswith("V")] == [f"V[{i}]" for i in range(1, N + 1)]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("potential 1/2*k*(x[{i}] - x[{i} + 1])^2;", "E0316"),
        ("potential 1/2*k*(x[{i}] - x[5 - {i}])^2;", "E0316"),
        ("potential 1/2*k*(x[{i}] - (if {i} == 4 then 1 s else 1 m))^2;", "E0401"),
        ("potential 1/2*k*x[{i}/2]^2;", "E0312"),
    ],
)
def test_a_fault_of_a_late_turn_is_told(text: str, code: str) -> None:
    body = model(looped(text))
    _, sink = run(body)
    assert [each.code for each in sink.diagnostics] == [code]
    place = sink.diagnostics[0].labels[0].span
    assert body[place.start : place.end] in re.sub(r"\{i\}", "i", text)


def test_most_turns_are_not_elaborated(monkeypatch: pytest.MonkeyPatch) -> None:
    def sums_of(turns: int) -> int:
        found = 0
        plain: Callable[..., Any] = expressions.arithmetic.binary

        def counted(ctx: Any, scope: Any, node: nodes.Binary, *operands: Any) -> Any:
            nonlocal found
            found += "x[i]" in node.span.text
            return plain(ctx, scope, node, *operands)

        with monkeypatch.context() as patch:
            patch.setattr(expressions.arithmetic, "binary", counted)
            run(f"""model M
  parameter Real k(unit = "N/m") = 2;
  coordinate Length x[{turns}];
  for i in 1:{turns} loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    potential 1/2*k*(x[i] - (if i == 1 then 0 else x[max(i-1, 1)]))^2;
  end for;
end M;
""")
        return found

    assert 0 < sums_of(4) == sums_of(40)
