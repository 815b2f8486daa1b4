"""The state of a session as bytes: a line of JSON, then numbers, with a checksum over all."""

from __future__ import annotations

import json
import zlib
from typing import Any

import numpy as np

from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.run import Run
from lagdsl.foundation.diagnostics import CallRefused, refused
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.version import __version__
from lagdsl.motion.sessions.opening import Method, Opening

_FIRST = b"lagdsl session 2\n"
_SUM = 4  # bytes of the checksum at the end
_ANOTHER = "save and restore sessions of one model, with the same signals in `inputs`"


@record(kw_only=True)
class Saved:
    """A state apart from its run: parameters p (np,), inputs u (nu,) and those before (nu,), the drift of invariants
    (3, ni). `columns` are the derivatives of a run that has some."""

    method: Method
    p: Floats
    u: Floats
    before: Floats
    drifts: Floats
    jumped: float
    after: float
    run: bytes
    columns: bytes


def packed(opening: Opening, method: Method, run: Run, held: HeldInputs) -> bytes:
    """The present state of a session that has not ended."""
    columns = b"" if run.results.sensitivities is None else run.results.sensitivities.saved()
    head = {
        **_identity(opening),
        "tolerance": method.tolerance,
        "solver": method.solver,
        "step": method.step,
        "jumped": held.hold.jumped.hex(),
        "after": run.results.structure.after.hex(),
        "columns": len(columns),
    }
    body = b"".join(
        [
            _FIRST,
            json.dumps(head).encode() + b"\n",
            *(each.tobytes() for each in (run.p, held.u, held.before, run.results.drifts)),
            columns,
            run.saved(),
        ]
    )
    return body + zlib.crc32(body).to_bytes(_SUM, "little")


def unpacked(opening: Opening, state: bytes, sizes: tuple[int, int, int]) -> Saved:
    """The parts that `packed` has put into `state`; `sizes` are np, nu and ni. Raises CallRefused (E0891) for
    anything else."""
    body = bytes(state[:-_SUM])
    if not body.startswith(_FIRST):
        raise _unfit("they are no state of a session", "give what `run.save()` returned")
    if zlib.crc32(body) != int.from_bytes(state[-_SUM:], "little"):
        raise _unfit("they were cut off or changed", "save the state again, or keep its bytes as they are")
    line, _, rest = body[len(_FIRST) :].partition(b"\n")
    head = json.loads(line)
    _require_same(opening, head)
    ends = np.cumsum([sizes[0], sizes[1], sizes[1], 3 * sizes[2]]) * 8
    p, u, before, drifts = (np.frombuffer(part) for part in _cut(rest, ends.tolist()))
    columns = int(ends[-1]) + int(head["columns"])
    return Saved(
        method=Method(tolerance=head["tolerance"], solver=head["solver"], step=head["step"]),
        p=p.copy(),
        u=u,
        before=before,
        drifts=drifts.reshape(3, -1) if sizes[2] else np.zeros((3, 0)),
        jumped=float.fromhex(head["jumped"]),
        after=float.fromhex(head["after"]),
        run=rest[columns:],
        columns=rest[ends[-1] : columns],
    )


def _cut(data: bytes, ends: list[int]) -> list[bytes]:
    return [data[first:end] for first, end in zip([0, *ends], ends, strict=False)]


def _identity(opening: Opening) -> dict[str, Any]:
    """Marks that must be the same where the state is restored."""
    names = [item.name for item in opening.asked.flat.inputs]
    return {
        "lagdsl": __version__,
        "model": opening.asked.flat.name,
        "equations": opening.digest,
        "arithmetic": opening.arithmetic,
        "tangents": list(opening.asked.tangents),
        "signals": [name for name, follows in zip(names, opening.signals.following, strict=True) if follows],
    }


def _require_same(opening: Opening, head: dict[str, Any]) -> None:
    own = _identity(opening)
    if head["lagdsl"] != own["lagdsl"]:
        why = f"version {head['lagdsl']} of lagdsl saved them, and this is version {own['lagdsl']}"
        raise _unfit(why, "run the motion again with this version, or restore with that one")
    if head["model"] != own["model"]:
        raise _unfit(f"they belong to the model `{head['model']}`, not to `{own['model']}`", _ANOTHER)
    if head["equations"] != own["equations"]:
        raise _unfit(
            f"they belong to another text of `{own['model']}`", "compile the text that the state was saved with"
        )
    if head["arithmetic"] != own["arithmetic"]:
        engines = {"c": 'engine="c"', "tape": 'engine="auto" or engine="tape"'}
        way = f"compile the model with {engines[head['arithmetic']]}, with which the state was saved"
        raise _unfit("C for this processor and the tape round otherwise", way)
    if head["tangents"] != own["tangents"]:
        told = ", ".join(f"`{name}`" for name in head["tangents"]) or "nothing"
        raise _unfit(f"there the motion was differentiated by {told}", "restore with the same `tangents`")
    if head["signals"] != own["signals"]:
        told = ", ".join(f"`{name}`" for name in head["signals"]) or "no input"
        raise _unfit(f"there {told} followed time", _ANOTHER)


def _unfit(why: str, way: str) -> CallRefused:
    return refused("E0891", why=why, way=way)
