"""Long and deep models: bounded time, no trouble with recursion."""

from __future__ import annotations

import cProfile
import sys
import time

import pytest
from choice import ALL
from flattening import run, said

from lagdsl.language.flat import model as fm
from lagdsl.language.semantics.operators import arrays
from lagdsl.language.semantics.scope import limits
from lagdsl.language.semantics.scope.limits import MAX_COORDINATES, MAX_TURNS

HEAD = "model A\n  coordinate Length x;\n"


def body(text: str) -> str:
    return f"{HEAD}{text}\nend A;"


def test_long_sum() -> None:
    flat, _ = run(body("  potential (1 N)*(" + " + ".join(["x"] * 900) + ");"))
    assert flat is not None


def test_definitions_in_reverse_order() -> None:
    before = sys.getrecursionlimit()
    lines = [f"  Length a{i} = a{i + 1} + x;" for i in range(1000)]
    flat, _ = run(body("\n".join([*lines, "  Length a1000 = x;", "  potential (1 N)*a0;"])))
    assert flat is not None
    assert [item.name for item in flat.named] == [f"a{i}" for i in range(1000, -1, -1)]
    assert sys.getrecursionlimit() == before


def test_chain_of_eighty_links_is_quick(root) -> None:  # type: ignore[no-untyped-def]
    text = (root / "models" / "chain.lag").read_text(encoding="utf-8")
    run(text)
    start = time.process_time()
    flat, _ = run(text, structural={"N": 80.0})
    assert flat is not None and len([item for item in flat.named if isinstance(item, fm.Point)]) == 80
    assert time.process_time() - start < 1.0


@pytest.mark.no_cover
def test_functions_that_multiply(monkeypatch: pytest.MonkeyPatch) -> None:
    if not ALL:
        monkeypatch.setattr(limits, "MAX_CALLS", limits.MAX_CALLS // 10)
    doubling = "".join(f"function f{i}(Real x) -> Real = f{i - 1}(x) + f{i - 1}(x);\n" for i in range(1, 30))
    _, sink = run(f"function f0(Real x) -> Real = x;\n{doubling}" + body("  potential f29(x/(1 m))*(1 J);"))
    assert {code for code, _ in said(sink)} == {"E0326"}


def test_shared_arguments_are_evaluated_once() -> None:
    text = "function f(Real x) -> Real = x*x;\nmodel A\n  structural parameter Real k = " + "f(" * 100 + "1" + ")" * 100
    flat, _ = run(text + ";\n  coordinate Length x;\n  potential (1 N)*k*x;\nend A;")
    assert flat is not None and flat.parameters[0].value == 1.0


def test_what_is_too_large() -> None:
    cases = {
        "  potential (1 N)*sum(x for i in 1:1000, j in 1:1000);": "i in 1:1000",
        "  potential (1 N)*sum(x for i in 1:1000000);": "1:1000000",
        "  potential (1 N)*x*sum(identity(10000)*ones(10000));": "identity(10000)",
        "  potential (1 N)*x*sum(diagonal(ones(1000)));": "diagonal(ones(1000))",
        "  potential (1 N)*x;\n  Real z[1000,1000];": "z",
    }
    for text, place in cases.items():
        _, sink = run(body(text))
        found = dict(said(sink))
        assert found.get("E0326", "").endswith(place.split(" ")[-1]), (text, said(sink))
    assert MAX_TURNS <= 1_000_000


@pytest.mark.parametrize("size", [MAX_COORDINATES + 1, 10**30])
def test_coordinates_are_counted_before_anything_is_made_of_them(size: int) -> None:
    text = f"model A\n  coordinate Length x[{size}];\n  kinetic 1/2*(1 kg)*der(x)*der(x);\nend A;"
    start = time.process_time()
    _, sink = run(text)
    assert "E0326" in {code for code, _ in said(sink)} and time.process_time() - start < 2.0


def test_a_range_that_no_memory_holds() -> None:
    _, sink = run(body("  for i in 1:1000000000000000000000000000000 loop\n    potential (1 N)*x;\n  end for;"))
    assert {code for code, _ in said(sink)} == {"E0326"}


def test_names_are_compared_for_the_first_faults_only() -> None:
    """Two thousand unknown names among four thousand took minutes."""
    known = [f"  parameter Length alpha{i:04d} = 1 m;" for i in range(100)]
    unknown = [f"  parameter Length beta{i:04d} = alpha{i:04d}x;" for i in range(100)]
    _, sink = run(body("\n".join([*known, *unknown])))
    helps = [each.help for each in sink.diagnostics if each.code == "E0201"]
    assert helps[0] == "did you mean `alpha0000`?"
    assert len(helps) == 100 and helps[-1] == "check the spelling, or declare it with its type"


@pytest.mark.parametrize(
    "text",
    [
        "for i in 1:n loop for j in 1:n loop for k in 1:n loop potential (1 N)*x; end for; end for; end for;",
        "for i in 1:n loop for j in 1:i loop end for; for j in 1:n, k in 1:n loop potential (1 N)*x; end for; end for;",
        "potential (1 N)*sum(sum(sum(x*i*j*k for k in 1:n) for j in 1:n) for i in 1:n);",
        "potential (1 N)*x*sum({sum(k for k in 1:n, l in 1:n) for i in 1:n});",
        "discrete Real w(start = 0); when x > 1 m then for i in 1:n loop for j in 1:n*n loop w = i; end for; end for; "
        "end when;",
    ],
)
def test_turns_of_loops_inside_each_other_are_counted_before_any(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Three loops of 300 each were expanded to the bound, which took twenty seconds."""
    made: list[int] = []
    first = limits.another_turn
    monkeypatch.setattr(arrays, "another_turn", lambda *given: made.append(1) or first(*given))
    _, sink = run(body(f"  structural parameter Integer n = 300;\n  {text}"))
    assert [code for code, _ in said(sink)] == ["E0326"] and not made


def test_loops_inside_each_other_that_fit() -> None:
    inner = "for j in 1:i loop for k in 1:2 loop potential (1 N)*x; end for; end for;"
    flat, _ = run(body(f"  for i in 1:30 loop if i > 2 then {inner} end if; end for;"))
    assert flat is not None and len(flat.energies) == 2 * (30 * 31 // 2 - 3)


def test_a_name_that_is_given_many_values_is_told_once() -> None:
    lines = "".join(f"    w = {k};\n" for k in range(50))
    _, sink = run(body(f"  discrete Real w(start = 0);\n  when x > 1 m then\n{lines}  end when;"))
    assert [code for code, _ in said(sink)] == ["E0307"]


def test_many_branches_of_one_event_are_compared_by_their_conditions() -> None:
    """A hundred and fifty branches took a minute and a half: each condition was compared with all others."""
    branches = "".join(f" elseif x > {k} m then w = {k};" for k in range(1, 60))
    text = body(f"  discrete Real w(start = 0); when x > 0.5 m then if x > 0 m then w = 0;{branches} end if; end when;")
    compared = cProfile.Profile()
    flat, _ = compared.runcall(run, text)
    assert flat is not None
    assert sum(each.callcount for each in compared.getstats() if "_equal" in str(each.code)) < 60**2
