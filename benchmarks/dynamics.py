"""Forward dynamics of serial arms against the peers: the same physics, agreement first, then all in turns."""

import contest
import numpy as np
import oracle
import ours
import peers
import serial
from contest import Contestant

AGREES = 1e-7  # of the largest acceleration of a state; who is farther off has no times
OURS = ("lagdsl", "lagdsl_fixed", "lagdsl_scalars", "lagdsl_scalars_fixed")
_LARGEST_TUNED = 10  # links up to which every set of flags is tried: C compilers are slow on long straight code
_LARGEST_CASADI = {"panda": 7, "planar_chain": 50, "spatial_chain": 20}


def measure(name: str, n: int, kinds: str = "forward", scalars: str | None = None) -> dict[str, object]:
    """Times, errors and ratios of the arm `name` of n links; `scalars` is the same arm in another text.

    `fixed` ones hold masses, lengths and inertias as numbers, as the C that peers generate does.
    """
    arm = serial.ARMS[name](n)
    states = contest.folder() / f"states_{name}_{n}.txt"
    values = serial.states(n)
    serial.write_states(states, values)
    size = None if name == "panda" else n
    made = {
        "lagdsl": ours.make(name, size, parts=("states", "tangents") if "batch" in kinds else ()),
        "lagdsl_fixed": ours.make(name, size, fixed=True),
    }
    if scalars is not None:
        made["lagdsl_scalars"] = ours.make(scalars)
        made["lagdsl_scalars_fixed"] = ours.make(scalars, fixed=True)
    enter = [
        Contestant(label, "lagdsl", (each.library, *each.symbols, kinds if label == "lagdsl" else "forward"))
        for label, each in made.items()
    ]
    generated = _generated(name, n)
    enter += [Contestant(label, "casadi", (each.library,)) for label, each in generated.items()]
    enter += _libraries(arm, "jacobian" in kinds)
    runs = contest.hold(states, enter)
    exact = {"forward": oracle.serial_arm(arm, values)}
    exact["batch"] = exact["forward"]
    if "jacobian" in kinds:
        exact["jacobian"] = oracle.serial_arm_jacobian(arm, values)
    errors = _errors(runs[0], exact)
    for run in runs:
        run.least = {key: time for key, time in run.least.items() if errors["/".join(key)] < AGREES}
    return {
        "model": name,
        "n": n,
        "runs": len(runs),
        "flops": made["lagdsl"].flops,
        "times": contest.median_times(runs),
        "errors": errors,
        "ratios": _ratios(runs),
    }


def family(label: str) -> str:
    """The peer that a label belongs to: pinocchio, pinocchio_casadi, mujoco, casadi, or lagdsl."""
    for name in ("pinocchio_casadi", "pinocchio", "mujoco", "casadi"):
        if label.startswith(name):
            return name
    return label


def ratio_name(mine: str, peer: str) -> str:
    """Name of the ratio of our contestant `mine` to `peer`."""
    return " ".join([*mine.split("_")[1:], peer])


def _libraries(arm: serial.Arm, derivatives: bool) -> list[Contestant]:
    """Peers that are linked against, not generated."""
    found: list[Contestant] = []
    if "pinocchio" in peers.where():
        numbers = contest.folder() / f"arm_{len(arm.links)}.txt"
        numbers.write_text(serial.numbers(arm))
        kinds = "jacobian" if derivatives else ""
        found += [Contestant("pinocchio", "pinocchio", (numbers, kinds))]
        found += [Contestant("pinocchio_native", "pinocchio_native", (numbers, kinds))]
    if "mujoco" in peers.where():
        xml = contest.folder() / f"arm_{len(arm.links)}.xml"
        xml.write_text(serial.mjcf(arm))
        found += [Contestant("mujoco", "mujoco", (xml,))]
    return found


def _generated(name: str, n: int) -> dict[str, peers.Generated]:
    """C that peers generate, by label."""
    flags = peers.FLAGS if n <= _LARGEST_TUNED else peers.FEW_FLAGS
    found: dict[str, peers.Generated] = {}
    if "casadi" in peers.where() and n <= _LARGEST_CASADI[name]:
        for way in ("space", *(("plane",) if name == "planar_chain" else ())):
            for each in peers.casadi(name, n, way, flags if n <= 20 else peers.NO_FLAGS):
                found[f"casadi_{way}:{_word(each.flags)}"] = each
    if {"casadi", "pinocchio"} <= set(peers.where()):
        for each in peers.pinocchio_casadi(name, n, flags if n <= 20 else peers.FLAGS[:1]):
            found[f"pinocchio_casadi:{_word(each.flags)}"] = each
    return found


def _word(flags: str) -> str:
    return flags.replace(" ", "")


def _errors(run: contest.Run, exact: dict[str, np.ndarray]) -> dict[str, float]:
    """Largest error by label/kind; of results that are no numbers 1e300."""
    errors: dict[str, float] = {}
    for (label, kind), found in run.results.items():
        with np.errstate(invalid="ignore"):
            error = float(np.max(oracle.error(found, exact[kind])))
        errors[f"{label}/{kind}"] = error if np.isfinite(error) else 1e300
    return errors


def _ratios(runs: list[contest.Run]) -> dict[str, float]:
    """Of us to the fastest variant of each peer, in the same run."""
    labels = {label for label, _ in runs[0].least}
    found: dict[str, float | None] = {}
    for peer in ("pinocchio", "pinocchio_casadi", "mujoco", "casadi"):
        theirs = sorted(label for label in labels if family(label) == peer)
        for mine in OURS:
            found[ratio_name(mine, peer)] = contest.ratio(runs, "forward", mine, theirs)
    found["jacobian"] = contest.ratio(runs, "jacobian", "lagdsl", ["pinocchio", "pinocchio_native"])
    found["batch"] = contest.ratio(runs, "batch", "lagdsl", ["lagdsl"], over="forward")
    return {name: share for name, share in found.items() if share is not None}
