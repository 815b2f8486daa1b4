"""`lag verify` on one screen."""

from __future__ import annotations

import hashlib
import platform
from importlib.metadata import version
from importlib.util import find_spec

from lagdsl.derivation.program.passes.written_out import written_out
from lagdsl.engines.runtime.building.platforms import library_name, this_machine
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.certificate import Certificate, Line
from lagdsl.exchange.verify.equations import derivations, engines, power, solutions, tangents
from lagdsl.exchange.verify.motion import motion
from lagdsl.exchange.verify.order import order
from lagdsl.exchange.verify.states import STATES, random_states
from lagdsl.exchange.verify.tangents import motion_tangents
from lagdsl.foundation.resources import runtime_library_folder
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.version import __version__
from lagdsl.motion.pipeline import Compilation


def _runtime_digest() -> str:
    """SHA-256 of the library that computes the motion."""
    library = runtime_library_folder() / library_name(this_machine().partition("-")[0])
    return hashlib.sha256(library.read_bytes()).hexdigest()


def certify(compilation: Compilation, source: SourceFile | None = None, *, fmu: bool = False) -> Certificate:
    """Compare everything that two ways give, at random states and along the motion of the experiment; with `fmu` the
    motion of FMUs in FMPy, too."""
    flat, program = compilation.flat, compilation.program
    whole = written_out(program)
    states = random_states(flat, program)
    tape = engine_of(program, "tape")
    lines: list[Line] = []
    if states:
        lines.append(derivations(flat, whole, states))
        lines += engines(program, states, tape)
        lines.append(solutions(whole, tape, states))
        lines.append(tangents(whole, tape, states))
        lines.append(power(compilation, states))
    else:
        says = f"{STATES} random states about the start"
        lines.append(Line(name="random states", says=says, note="no regular state was found near the start"))
    lines += motion(compilation, tape)
    lines.append(motion_tangents(compilation, tape))
    lines.append(order(flat, tape))
    if fmu:
        from lagdsl.exchange.verify.fmu import round_trips

        lines += round_trips(compilation, tape)
    text = source.text if source is not None else ""
    return Certificate(
        model=flat.name,
        digest=hashlib.sha256(text.encode()).hexdigest(),
        versions=(
            ("lagdsl", __version__),
            ("python", platform.python_version()),
            *((name, version(name)) for name in ("numpy", "sympy", "fmpy") if find_spec(name) is not None),
            ("runtime", _runtime_digest()[:16]),
        ),
        lines=tuple(lines),
    )
