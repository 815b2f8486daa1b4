"""Equilibria with contacts: each is open or closed, its gap or its multiplier is zero, and neither is negative.

The Signorini conditions, as in Brogliato, *Nonsmooth Mechanics* (2016), 1.3.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from lagdsl.derivation.textbook.recipe import Derivation
from lagdsl.derivation.textbook.small_motions.balance import Balance
from lagdsl.derivation.textbook.small_motions.roots import Condition
from lagdsl.derivation.textbook.small_motions.statics import Place, of_real_values

MOST_CONTACTS = 3
"""So many are looked at closed, in all combinations."""


def cases(derivation: Derivation) -> Iterator[frozenset[str]]:
    """Names of the contacts that are closed, none first; no others where there are too many."""
    names = [row.name for row in derivation.constraints if row.contact]
    for count in range(len(names) + 1 if len(names) <= MOST_CONTACTS else 1):
        yield from map(frozenset, combinations(names, count))


def admissible(balance: Balance, place: Place) -> Place | None:
    """The place with the conditions of its contacts that are not certain; None where one certainly fails."""
    conditions = list(place.conditions)
    for row in balance.derivation.constraints:
        if not row.contact or (row.name in balance.closed and row.multiplier not in place.at):
            continue
        value = place.at[row.multiplier] if row.name in balance.closed else row.residual.xreplace(place.at)
        real = of_real_values(balance, balance.tidy(value))
        if real.is_negative:
            return None
        if not real.is_nonnegative:
            conditions.append(Condition("nonnegative", balance.tidy(value)))
    return replace(place, conditions=tuple(dict.fromkeys(conditions)))
