"""Rows of a model with contacts and dry friction: what its functions say with all of them held, so that the law can
be put on top of it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from stepping.friction_modes import CLOSED, MINUS, PLUS, STICK, Floats, Friction, Problem
from stepping.state import State, System

from lagdsl.derivation.program.program import Program

Mode = dict[int, int]  # by row of the constraints; rows that are in no contact and no friction are bilateral


@dataclass(frozen=True)
class Rows:
    """At one state: M a = h + J' f, rates of rows `speed` = J v + b, their accelerations J a - gamma."""

    inverse: Floats  # of M
    h: Floats
    J: Floats
    gamma: Floats
    speed: Floats
    gap: Floats  # of contacts
    restitution: Floats
    frictions: tuple[Friction, ...]
    contacts: frozenset[int]  # the rows that are in one

    def of(self, rows: list[int], c: Floats, frictions: list[Friction]) -> Problem:
        """A problem of these rows; the others are without force."""
        place = {row: at for at, row in enumerate(rows)}
        J = self.J[rows]
        inner = tuple(
            replace(each, row=place[each.row], contact=None if each.contact is None else place[each.contact])
            for each in frictions
        )
        owned = {each.row for each in frictions}
        contacts = tuple(place[row] for row in rows if row not in owned and row in self.contacts)
        return Problem(J @ self.inverse @ J.T, c[rows], contacts, inner)


class FrictionSystem:
    """A model without states of first order whose frictions are scalar, with limits r0 + mu times the force of a
    contact."""

    def __init__(self, program: Program, length: float) -> None:
        self.system = System(program, length)
        layout = self.system.layout
        instants = layout.instants
        assert not layout.states, "states of first order"
        assert all(count == 1 for count in instants.friction_slips), "planar friction"
        self.contacts = [int(row) for row in instants.contact_rows]
        self.frictions = [int(row) for row in instants.friction_rows]
        self.one_way = list(instants.one_way) or [False] * len(self.contacts)
        self.names = {row: layout.constraints[row].name for row in (*self.contacts, *self.frictions)}
        owned = {*self.contacts, *self.frictions}
        self.bilateral = [row for row in range(len(layout.constraints)) if row not in owned]
        self._held = self.system.start.w.copy()
        for kind in ("contact", "sticks"):
            self._held[self.system.kind.get(kind, [])] = 1.0
        self.start = self.timed(self.system.start)

    def timed(self, s: State) -> State:
        """With the entries that depend on time alone as they are just behind it."""
        w = self._held.copy()
        if self.system.timed:
            w[self.system.timed] = self.system.timed_values(replace(s, w=w), s.t + 1e-10 * self.system.length)
        return replace(s, w=w)

    def rows(self, s: State) -> Rows:
        system = self.system
        found, rates = system.call("dynamics", s, None), system.call("velocity_constraint", s, None)
        contact = system.call("contact", s, None) if self.contacts else {"gap": np.zeros(0), "restitution": np.zeros(0)}
        count = len(self.contacts)
        return Rows(
            np.linalg.inv(found["M"]),
            found["f"],
            found["J"],
            found["gamma"],
            rates["residual"],
            contact["gap"][:count],
            contact["restitution"][:count],
            self._laws(s),
            frozenset(self.contacts),
        )

    def _laws(self, s: State) -> tuple[Friction, ...]:
        """Limits are affine in the force of one contact."""
        if not self.frictions:
            return ()
        none = np.zeros(len(s.q)), np.zeros(len(self.system.layout.constraints))
        found = self.system.call("friction", s, None, none)
        laws = []
        for k, row in enumerate(self.frictions):
            on = sorted({*np.flatnonzero(found["gain"][k]), *np.flatnonzero(found["sticking_gain"][k])})
            assert len(on) <= 1, "a limit of several forces"
            contact = int(on[0]) if on else None
            assert contact is None or contact in self.contacts, "a limit of a force that pulls, too"
            mu, mu_rest = (float(found[name][k, on[0]]) if on else 0.0 for name in ("gain", "sticking_gain"))
            assert contact is None or not (found["limit"][k] or found["sticking"][k]), (
                "a limit with and without a force"
            )
            limits = float(found["limit"][k]), float(found["sticking"][k])
            laws.append(Friction(row, contact, mu, limits[0], mu_rest, limits[1]))
        return tuple(laws)

    def held(self, mode: Mode) -> list[int]:
        return self.bilateral + [row for row, code in mode.items() if code in (CLOSED, STICK)]

    def forces(self, rows: Rows, mode: Mode) -> tuple[Floats, bool, float]:
        """Forces of all rows in a mode, the smallest of redundant ones; whether some are; the determinant of the
        equations of the mode against that without friction."""
        held = self.held(mode)
        J = rows.J[held]
        push = J.copy()  # what a force of each held row does, with the sliding that follows from it
        known = np.zeros(len(rows.h))
        sliding = [
            (each, 1.0 if mode[each.row] == PLUS else -1.0)
            for each in rows.frictions
            if mode[each.row] in (PLUS, MINUS)
        ]
        for each, sign in sliding:
            known -= sign * each.r0 * rows.J[each.row]
            if each.contact is not None:
                push[held.index(each.contact)] -= sign * each.mu * rows.J[each.row]
        matrix, plain = J @ rows.inverse @ push.T, J @ rows.inverse @ J.T
        right = rows.gamma[held] - J @ rows.inverse @ (rows.h + known)
        f = np.zeros(len(rows.gamma))
        unit = 1 / np.sqrt(np.where(np.diag(plain) > 0, np.diag(plain), 1.0))
        scaled, bare = matrix * np.outer(unit, unit), plain * np.outer(unit, unit)
        solved, _, rank, _ = np.linalg.lstsq(scaled, right * unit, rcond=1e-11) if held else (np.zeros(0), 0, 0, 0)
        f[held] = solved * unit
        for each, sign in sliding:
            f[each.row] = -sign * (each.r0 + (each.mu * f[each.contact] if each.contact is not None else 0.0))
        redundant = bool(rank < len(held) and np.linalg.matrix_rank(bare, 1e-10) < len(held))
        return f, redundant, 1.0 if redundant or not held else float(np.linalg.det(scaled) / np.linalg.det(bare))

    def accelerations(self, rows: Rows, f: Floats) -> Floats:
        return np.asarray(rows.inverse @ (rows.h + rows.J.T @ f))

    def projected(self, rows: Rows, held: list[int], v: Floats, speed: Floats) -> Floats:
        """Rates that satisfy the held rows, by the least change in the metric of M."""
        J = rows.J[held]
        return (
            v - rows.inverse @ J.T @ np.linalg.lstsq(J @ rows.inverse @ J.T, speed[held], rcond=1e-11)[0] if held else v
        )
