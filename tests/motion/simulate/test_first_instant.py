"""Checking alone finds failures at the start."""

import pytest

import lagdsl

CART = """model Cart
  parameter Length l = 1 m;
  parameter Real a = 0;
  coordinate Length x, y;
  gravity = 0;
  mass 1 kg at {x, y};
  force (1 N)*(l/(1 m)) on y;
%s
end Cart;
"""


def errors(body: str) -> list[tuple[str, int]]:
    found = lagdsl.check(CART % body)
    return [(d.code, d.labels[0].span.first.line) for d in found if d.code[0] == "E"]


@pytest.mark.parametrize(
    ("body", "code", "line"),
    [
        ('equation\n  assert(l > 2 m, "too short");', "E0810", 9),
        ('equation\n  assert(x > 2 m, "too near");', "E0810", 9),
        ("  force (1 N)/a on x;", "E0808", 4),
        ("  force (1 N)*unit({x, y}) at {x, y};", "E0813", 8),
    ],
)
def test_failure_at_the_start_is_told_at_its_place(body, code, line):
    assert errors(body) == [(code, line)]


@pytest.mark.parametrize(
    "body",
    [
        'equation\n  assert(l < 2 m and x < 1 m, "fine");',
        '  input Force u;\n  force u on x;\nequation\n  assert(u > 1 N, "nobody knows u yet");',
        "  input Length d;\n  force (1 N.m)/d on x;",
    ],
)
def test_sound_starts_and_unknown_inputs_are_left_alone(body):
    assert errors(body) == []
