"""Printed lines as numbers: reads what `lag derive` writes for a terminal, and knows nothing of how it was made.

A product is pieces side by side, `½` a half, `x²` a square, a dot over a letter a rate. Values are given by the printed
names, `θ̇_lean` or `m₁`.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Mapping

_VULGAR = {"½": 0.5, "⅓": 1 / 3, "⅔": 2 / 3, "¼": 0.25, "¾": 0.75, "⅛": 0.125, "⅜": 0.375, "⅝": 0.625, "⅞": 0.875}
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+\.?\d*(?:e[-+]?\d+)?)|(?P<vulgar>[½⅓⅔¼¾⅛⅜⅝⅞])|(?P<raised>[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)"
    r"|(?P<name>[A-Za-zΑ-ω][\u0300-\u036f]*[A-Za-z₀-₉]*(?:_\w[A-Za-z0-9_,]*)?)|(?P<mark>[()+/√−-]))"
)
_FUNCTIONS = {"sin": math.sin, "cos": math.cos}


def equations(text: str, heading: str) -> list[str]:
    """The equations of a section, continued lines joined."""
    section = text.split(f"\n{heading}\n" + "-" * len(heading) + "\n")[1].split("\n\n", maxsplit=1)[0]
    lines: list[str] = []
    for line in section.splitlines():
        words = line.strip()
        if not line.startswith("    "):
            break
        if line.startswith("            ") or words.startswith("="):
            lines[-1] += f" {words}"
        else:
            lines.append(words)
    return lines


def residual(equation: str, values: Mapping[str, float]) -> float:
    """Left-hand side less right-hand side."""
    left, right = equation.split(" = ")
    return value(left, values) - value(right, values)


def value(text: str, values: Mapping[str, float]) -> float:
    reader = _Reader(
        unicodedata.normalize("NFD", text), {unicodedata.normalize("NFD", k): v for k, v in values.items()}
    )
    result = reader.sum()
    assert reader.peek() is None, text
    return result


class _Reader:
    def __init__(self, text: str, values: Mapping[str, float]) -> None:
        self._values = values
        self._tokens: list[tuple[str, str]] = []
        at = 0
        while at < len(text.rstrip()):
            found = _TOKEN.match(text, at)
            assert found is not None and found.lastgroup is not None, text[at:]
            self._tokens.append((found.lastgroup, found.group(found.lastgroup)))
            at = found.end()
        self._at = 0

    def peek(self) -> tuple[str, str] | None:
        return self._tokens[self._at] if self._at < len(self._tokens) else None

    def _take(self, *marks: str) -> str | None:
        token = self.peek()
        if token is None or token[1] not in marks:
            return None
        self._at += 1
        return token[1]

    def sum(self) -> float:
        sign = -1 if self._take("−", "-") else 1
        total = sign * self._product()
        while (mark := self._take("+", "−", "-")) is not None:
            total += self._product() if mark == "+" else -self._product()
        return total

    def _product(self) -> float:
        result = self._power()
        while (token := self.peek()) is not None and token[1] not in (")", "+", "−", "-"):
            result = result / self._power() if self._take("/") else result * self._power()
        return result

    def _power(self) -> float:
        base = self._piece()
        token = self.peek()
        if token is not None and token[0] == "raised":
            self._at += 1
            return base ** int(token[1].translate(_RAISED))
        return base

    def _piece(self) -> float:
        token = self.peek()
        assert token is not None
        self._at += 1
        kind, text = token
        if kind == "number":
            return float(text)
        if kind == "vulgar":
            return _VULGAR[unicodedata.normalize("NFC", text)]
        if text == "(":
            inside = self.sum()
            assert self._take(")") is not None
            return inside
        if text == "√":
            return math.sqrt(self._piece())
        if text in _FUNCTIONS:
            raised = self.peek()
            power = 1
            if raised is not None and raised[0] == "raised":
                self._at += 1
                power = int(raised[1].translate(_RAISED))
            return float(_FUNCTIONS[text](self._piece()) ** power)
        return self._values[text]
