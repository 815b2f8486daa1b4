"""Long functions as lists of instructions, which a loop executes: XLA compiles the loop, not its repetitions."""

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from typing import Any

import jax
import jax.numpy as jnp

from lagdsl.engines.backends.jax.elementary import Elementary

_LANES = 8


class Instructions:
    """A function as rows of _LANES instructions of one operation each, in an array of registers: constants, arguments,
    results of the rows.

    `runs` has (operation, number of operands, number of rows that follow each other); `a`, `b` and `c` the registers of
    the operands, `results` those of the results. Derivatives are linear in the tangents with partial derivatives as
    factors, in a loop over the same rows, so JAX transposes it.
    """

    def __init__(
        self,
        constants: Sequence[float],
        runs: Sequence[tuple[str, int, int]],
        a: Sequence[int],
        b: Sequence[int],
        c: Sequence[int],
        results: Sequence[int],
    ) -> None:
        self._constants = jnp.array(constants, dtype=float)
        self._results = jnp.array(results, dtype=int)
        self._names = sorted({name for name, _, _ in runs})
        self._codes = jnp.array([self._names.index(name) for name, _, rows in runs for _ in range(rows)])
        self._count = len(a) // _LANES
        self._most = max(arity for _, arity, _ in runs)
        self._arity = {name: arity for name, arity, _ in runs}
        self._places = [jnp.array(places).reshape(-1, _LANES) for places in (a, b, c)[: self._most]]
        self._alike = list(_alike(runs, (a, b, c), constants))
        self._registers = jax.custom_jvp(self._computed)
        self._registers.defjvp(self._moved)

    def __call__(self, arguments: Sequence[Any]) -> Any:
        """All results in one array."""
        return _taken(self._registers(jnp.concatenate([jnp.ravel(x) for x in arguments])), self._results)

    def _computed(self, x: Any) -> Any:
        values = self._started(self._constants, x)
        first = len(values) - self._count * _LANES
        branches = [_of_three(getattr(Elementary, name), self._arity[name]) for name in self._names]

        def step(row: Any, values: Any) -> Any:
            operands = [_taken(values, places[row]) for places in self._places]
            found = jax.lax.switch(self._codes[row], branches, *operands)
            return jax.lax.dynamic_update_slice(values, found, (first + row * _LANES,))

        return jax.lax.fori_loop(0, self._count, step, values)

    def _moved(self, primals: tuple[Any], tangents: tuple[Any]) -> tuple[Any, Any]:
        """The registers, and their derivatives along a tangent of the arguments."""
        values = self._registers(*primals)
        start = self._started(jnp.zeros(len(self._constants)), *tangents)
        first = len(values) - self._count * _LANES

        def step(moved: Any, row: Any) -> tuple[Any, None]:
            at, factors, places = row
            terms = (f * _taken(moved, p) for f, p in zip(factors, places, strict=True))
            # The branch that a `select` leaves may have no finite derivative: its factor is zero, and so is its term.
            found = sum(jnp.where(f == 0.0, 0.0, term) for f, term in zip(factors, terms, strict=True))
            return jax.lax.dynamic_update_slice(moved, found, (at,)), None

        at = first + _LANES * jnp.arange(self._count)
        return values, jax.lax.scan(step, start, (at, self._factors(values), self._places))[0]

    def _started(self, constants: Any, x: Any) -> Any:
        return jnp.concatenate([constants, x, jnp.zeros(self._count * _LANES)])

    def _factors(self, values: Any) -> list[Any]:
        """Partial derivatives by each operand. Constants are none to differentiate by."""
        found = [jnp.zeros(self._count * _LANES) for _ in self._places]
        for name, at, operands in self._alike:
            given = [x if fixed else _taken(values, x) for fixed, x in operands]
            for k, (fixed, _) in enumerate(operands):
                if not fixed:
                    function = _along(getattr(Elementary, name), given, k)
                    found[k] = found[k].at[at].set(jax.jvp(function, (given[k],), (jnp.ones(len(at)),))[1])
        return [factors.reshape(-1, _LANES) for factors in found]


def _alike(
    runs: Sequence[tuple[str, int, int]], places: Sequence[Sequence[int]], constants: Sequence[float]
) -> Iterator[tuple[str, Any, list[tuple[bool, Any]]]]:
    """Instructions of the same operation with constants as the same operands: the operation, where its instructions
    stand, and of each operand whether it is constant, and its values or else its registers."""
    kinds, at = [], 0
    for name, arity, rows in runs:
        for place in range(at, at + rows * _LANES):
            kinds.append((name, tuple(operands[place] < len(constants) for operands in places[:arity]), place))
        at += rows * _LANES
    for (name, fixed), group in groupby(sorted(kinds), key=lambda kind: kind[:2]):
        chosen = [place for _, _, place in group]
        yield (
            name,
            jnp.array(chosen),
            [
                (
                    is_fixed,
                    jnp.array([constants[operands[i]] for i in chosen], dtype=float)
                    if is_fixed
                    else jnp.array([operands[i] for i in chosen]),
                )
                for is_fixed, operands in zip(fixed, places, strict=False)
            ],
        )


def _taken(values: Any, places: Any) -> Any:
    return values.at[places].get(mode="promise_in_bounds")


def _of_three(function: Callable[..., Any], arity: int) -> Callable[..., Any]:
    return lambda *operands: function(*operands[:arity])


def _along(function: Callable[..., Any], given: Sequence[Any], k: int) -> Callable[[Any], Any]:
    return lambda x: function(*given[:k], x, *given[k + 1 :])
