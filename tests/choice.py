"""Choice of the cases that run where tests repeat a rule.

Where a test shows one rule of many things, `make check` takes some of them, one of each kind, and `make check-all`
(LAGDSL_ALL=1) all. LAGDSL_EXPLORE=1 takes all, too, and looks for new ones. The choice stands at the test. Of FMUs,
which take seconds each, `make check-all` takes every model, and LAGDSL_EXPLORE=1 (`make fmu-check`) every model in
every version and kind.
"""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any, TypeVar

import pytest

if TYPE_CHECKING:
    from lagdsl.engines.runtime.engines.engine import EngineName

EXPLORE = bool(os.environ.get("LAGDSL_EXPLORE"))
ALL = EXPLORE or bool(os.environ.get("LAGDSL_ALL"))
Item = TypeVar("Item")
# Of tables with more rows `make check` takes every third one.
LONG = 8


def chosen(every: Iterable[Item], some: Sequence[Item]) -> list[Item]:
    """All of them, or some, which must be among them."""
    items = list(every)
    strangers = [item for item in some if item not in items]
    assert not strangers, f"not there to choose from: {strangers}"
    return items if ALL else list(some)


def in_turn(things: Iterable[Item], *axes: Sequence[Any], some: Sequence[Any]) -> list[tuple[Any, ...]]:
    """`some`, which `make check` takes; beside them, in `make check-all`, every thing with a combination of values of
    the axes, each in turn, and with all of them where all is explored."""
    combinations = list(product(*axes))
    if EXPLORE:
        found = [(thing, *values) for thing in things for values in combinations]
    else:
        found = [(thing, *combinations[i % len(combinations)]) for i, thing in enumerate(things)]
    return list(dict.fromkeys([*some, *found])) if ALL else list(some)


def leave_out(items: list[pytest.Item]) -> list[pytest.Item]:
    """Takes all but every third row of tables with more than LONG rows out of `items`, and returns them."""
    sizes = Counter(item.nodeid.partition("[")[0] for item in items)
    seen: Counter[str] = Counter()
    left = []
    for item in items:
        table = item.nodeid.partition("[")[0]
        seen[table] += 1
        if sizes[table] > LONG and seen[table] % 3 != 1:
            left.append(item)
    names = {item.nodeid for item in left}
    items[:] = [item for item in items if item.nodeid not in names]
    return left


def spread(every: Iterable[Item], count: int) -> list[Item]:
    """All of them, or `count` at equal distances, from the first to the last; one is the first."""
    items = list(every)
    if ALL or len(items) <= count:
        return items
    return [items[round(i * (len(items) - 1) / max(count - 1, 1))] for i in range(count)]


def paired(*axes: Sequence[Any]) -> list[tuple[Any, ...]]:
    """All combinations, or as few of them as have each value of each axis."""
    if ALL:
        return list(product(*axes))
    return [tuple(axis[i % len(axis)] for axis in axes) for i in range(max(map(len, axes)))]


def together(names: str | tuple[str, ...], items: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[[], None]]:
    """One test of a rule for all items, where the rule takes a few milliseconds at most: pytest takes three for each.
    Of several names, each item is a tuple. A failure tells its item."""

    def decorated(rule: Callable[..., None]) -> Callable[[], None]:
        def test() -> None:
            for item in items:
                try:
                    if isinstance(names, str):
                        rule(item)
                    else:
                        rule(*item)
                except BaseException as failure:
                    failure.add_note(f"{names} = {item!r}")
                    raise

        test.__name__, test.__doc__, test.__module__ = rule.__name__, rule.__doc__, rule.__module__
        return test

    return decorated


def repeats(other: str) -> pytest.MarkDecorator:
    """A test or a case of what `other` shows, too: it runs in `make check-all`."""
    return pytest.mark.skipif(not ALL, reason=f"repeats {other}")


def engines(every: Sequence[EngineName]) -> list[EngineName]:
    """All of them, or the tape, for which nothing is compiled: tests in `fuzz`, `models`, `runtime` and `simulate` show
    that the others make the same motions."""
    return list(every) if ALL else ["tape"]


def examples(many: int) -> int:
    """Number of random examples of a property: all of them, or a twentieth, the same ones in every run."""
    return many if ALL else max(many // 20, min(many, 8))
