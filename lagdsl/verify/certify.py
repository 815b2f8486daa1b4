"""`lag verify` on one screen."""

from __future__ import annotations

import hashlib
import platform
from importlib.metadata import version

from lagdsl.pipeline import Compilation
from lagdsl.runtime.engines.selection import engine_of
from lagdsl.source import SourceFile
from lagdsl.verify.certificate import Certificate, Line
from lagdsl.verify.equations import derivations, engines, power, solutions, tangents
from lagdsl.verify.motion import motion
from lagdsl.verify.states import STATES, random_states
from lagdsl.version import __version__


def certify(compilation: Compilation, source: SourceFile | None = None) -> Certificate:
    """Compare everything that two ways give, at random states and along the motion of the experiment."""
    flat, program = compilation.flat, compilation.program
    states = random_states(flat, program)
    lines: list[Line] = []
    if states:
        engine = engine_of(program, "tape")
        lines.append(derivations(flat, program, states))
        lines += engines(program, states)
        lines.append(solutions(program, engine, states))
        lines.append(tangents(program, engine, states))
        lines.append(power(program, states))
    else:
        says = f"{STATES} random states about the start"
        lines.append(Line(name="random states", says=says, note="no regular state was found near the start"))
    lines += motion(flat, engine_of(program))
    text = source.text if source is not None else ""
    return Certificate(
        model=flat.name,
        digest=hashlib.sha256(text.encode()).hexdigest(),
        versions=(
            ("lagdsl", __version__),
            ("python", platform.python_version()),
            *((name, version(name)) for name in ("numpy", "sympy")),
        ),
        lines=tuple(lines),
    )
