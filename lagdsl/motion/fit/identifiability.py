"""Combinations of the unknowns that data determine, in words: `only m*l^2 is visible`.

Directions that leave all values as they are, from the singular values of the Jacobian. In the logarithms of the
unknowns they belong to products of powers, in the unknowns themselves to sums. Both can look alike at one point, so a
motion at a distance along the direction decides. Where it refutes both, sums of products are left.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from math import lcm

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.fit.combinations import reduced, visible_sums

# Entries of directions below this part are errors of the derivatives.
_NOTHING = 1e-3
# Exponents of products are fractions with at most this denominator.
_DENOMINATOR = 4
# So far along a direction a motion is compared, as a part of the unknowns; values of a sum that is none change by the
# square of it, those of one that is by the error of the integration.
_FAR, _SAME = 0.1, 1e-4


@record(kw_only=True)
class Hidden:
    """Unknowns that data do not determine one by one; `visible` are the combinations that they determine, `exact` tells
    that these were confirmed at a distance."""

    names: tuple[str, ...]
    visible: tuple[str, ...]
    exact: bool

    def __str__(self) -> str:
        names = _listed(self.names)
        near = "" if self.exact else " near these values"
        if not self.visible:
            return f"the data do not depend on {names}{near}"
        verb = "is" if len(self.visible) == 1 else "are"
        return f"of {names} only {_listed(self.visible)} {verb} visible in the data{near}"


def seen_directions(jacobian: Floats, error: float) -> tuple[Floats, Floats]:
    """Orthonormal directions (k, v) that change the values and those (k, k - v) that do not, from the scaled Jacobian
    (n, k) with a relative error of its entries."""
    k = jacobian.shape[1]
    _, sizes, across = np.linalg.svd(np.vstack([jacobian, np.zeros((k, k))]), full_matrices=False)
    rank = int(np.sum(sizes > error * np.sqrt(k) * sizes[0])) if sizes[0] > 0.0 else 0
    return across[:rank].T, across[rank:].T


def hidden_of(
    names: Sequence[str],
    x: Floats,
    sizes: Floats,
    unseen: Floats,
    changed: Callable[[Floats], float],
    unseen_at: Callable[[Floats], Floats | None],
) -> tuple[Hidden, ...]:
    """Groups of unknowns that are seen together only. `unseen` (k, d) are directions in x / sizes, `unseen_at` those of
    other unknowns, None where there is no motion; `changed` is the largest change of a value at other unknowns, as a
    part of its range, infinite where there is no motion."""
    if not unseen.shape[1]:
        return ()
    directions = reduced(unseen.T, _NOTHING).T
    found = []
    for group, columns in _groups(directions):
        null = directions[np.ix_(group, columns)]
        found.append(_hidden([names[i] for i in group], group, x, sizes, null, changed, unseen_at))
    return tuple(found)


def _hidden(
    names: list[str],
    group: list[int],
    x: Floats,
    sizes: Floats,
    null: Floats,
    changed: Callable[[Floats], float],
    unseen_at: Callable[[Floats], Floats | None],
) -> Hidden:
    own, steps = x[group], null * sizes[group][:, None]

    def there(moved: Floats) -> float:
        whole = x.copy()
        whole[group] = moved
        return changed(whole)

    if np.all(own != 0.0):
        logs = steps / own[:, None]
        powers = _exponents(logs)
        far = _FAR * logs / np.max(np.abs(logs), axis=0)
        if powers is not None and all(there(own * np.exp(each)) < _SAME for each in far.T):
            return Hidden(names=tuple(names), visible=tuple(_product(names, row) for row in powers), exact=True)
    far = _FAR * steps / np.max(np.abs(null), axis=0)
    exact = all(there(own + each) < _SAME for each in far.T)
    if not exact:
        sums = visible_sums(names, own, sizes[group], _restricted(x, group, unseen_at), len(group) - null.shape[1])
        if sums is not None:
            return Hidden(names=tuple(names), visible=tuple(sums), exact=True)
    rows = reduced(_across(null), _NOTHING) / sizes[group]
    visible = tuple(_sum(names, row / row[np.flatnonzero(row)[0]]) for row in rows)
    return Hidden(names=tuple(names), visible=visible, exact=exact)


def _restricted(
    x: Floats, group: list[int], unseen_at: Callable[[Floats], Floats | None]
) -> Callable[[Floats], Floats | None]:
    """The directions of a group of unknowns at values of these."""

    def found(own: Floats) -> Floats | None:
        whole = x.copy()
        whole[group] = own
        directions = unseen_at(whole)
        return None if directions is None else directions[group]

    return found


def _across(columns: Floats) -> Floats:
    """Orthonormal rows that are normal to the columns (k, d)."""
    left, _, _ = np.linalg.svd(columns)
    return np.asarray(left[:, columns.shape[1] :].T)


def _groups(directions: Floats) -> list[tuple[list[int], list[int]]]:
    """Unknowns and columns of directions (k, d) that hang together, but for unknowns in none."""
    left = set(range(directions.shape[1]))
    found = []
    while left:
        columns = {min(left)}
        while True:
            rows = np.flatnonzero(np.any(directions[:, sorted(columns)] != 0.0, axis=1))
            more = {c for c in left if np.any(directions[rows, c] != 0.0)} | columns
            if more == columns:
                break
            columns = more
        left -= columns
        found.append((rows.tolist(), sorted(columns)))
    return found


def _exponents(logs: Floats) -> list[list[int]] | None:
    """Whole exponents of the products that the directions (k, d) in logarithms leave as they are; None where they are
    no simple fractions."""
    found = []
    for row in reduced(_across(logs), _NOTHING).tolist():
        fractions = [Fraction(each).limit_denominator(_DENOMINATOR) for each in row]
        if any(abs(float(f) - each) > _NOTHING * max(abs(each), 1.0) for f, each in zip(fractions, row, strict=True)):
            return None
        common = lcm(*(f.denominator for f in fractions))
        found.append([int(f * common) for f in fractions])
    return found


def _product(names: Sequence[str], exponents: Sequence[int]) -> str:
    above = [_power(name, e) for name, e in zip(names, exponents, strict=True) if e > 0]
    below = [_power(name, -e) for name, e in zip(names, exponents, strict=True) if e < 0]
    divisor = below[0] if len(below) == 1 else f"({'*'.join(below)})"
    return "*".join(above or ["1"]) + (f"/{divisor}" if below else "")


def _power(name: str, exponent: int) -> str:
    return name if exponent == 1 else f"{name}^{exponent}"


def _sum(names: Sequence[str], factors: Floats) -> str:
    text = ""
    for name, factor in zip(names, factors.tolist(), strict=True):
        if factor:
            size = f"{abs(factor):.4g}*".removeprefix("1*")
            sign = "-" if factor < 0.0 else "+"
            text += f" {sign} {size}{name}" if text else f"{'-' if factor < 0.0 else ''}{size}{name}"
    return text


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
