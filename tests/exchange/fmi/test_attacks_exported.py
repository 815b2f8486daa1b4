"""Models that are made to go wrong, as FMUs: through FMPy they move as their references say, in both kinds."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest
from attack.rows import Attack, in_bounded_time
from attack.test_corners import PASSED as NEEDLES
from choice import in_turn
from fmpy import simulate_fmu

import lagdsl
from fmi.exact_importer import ends_exactly
from fmi.exported import VERSIONS, Exported
from fmi.texts import export_text

# Some rows run in `make check`: tests/attack has more of them, in a run.
MODULES = {
    "test_arrays_of_components": None,
    "test_contacts_in_a_row": "soft_stop_of_two",
    "test_corners": None,
    "test_crossings_at_bounds": "crossing_at_a_tick",
    "test_friction": None,
    "test_first_instants": None,
    "test_forces_that_jump": None,
    "test_impacts_beyond_newton": None,
    "test_impulses": "mass_on_a_base_by_max",
    "test_inputs_that_jump": None,
    "test_machines_with_events": None,
    "test_methods_and_tolerances": None,
    "test_missed_events": None,
    "test_nearly_at_once": "relation_1e-08_before_a_blow",
    "test_relations_at_rest": None,
    "test_rows_of_branches": "by_a_boolean_input_before",
    "test_scales": "beside_an_odometer_at_1e+07",
    "test_shapes_and_points": None,
    "test_starts": None,
    "test_states_that_move_masses": None,
    "test_steps_beyond_newton": None,
    "test_steps_in_place": None,
    "test_steps_on_contacts": None,
    "test_switched": "clutch_by_a_clock",
    "test_track_corners": "constraint_that_moves",
    "test_two_formulations": None,
}
SECONDS = 30  # of the processor, compilers left out
# FMPy integrates with CVODE at this tolerance, from anew at up to a thousand events.
TOLERANCE, NEAR = 1e-10, 1e-6
# States of an importer have no more digits: a gap of 5 mm between places at 7000 km, which closes at 1 cm/s, changes by
# 16 roundings of both, the margin, in 5e-6 s; the steps of this importer round the place by 1e-8 m, that is 1e-6 s.
ROUNDED = {"scales-relation_far_from_the_origin": 1e-5}
# Importers see what lasts for longer than their steps, and step across corners; our importer has no tables of inputs.
HIDDEN = (
    "missed_events-",
    "forces_that_jump-two_that_pass_a_hill",
    *(f"methods_and_tolerances-{name}" for name in ("1_teeth", "3_teeth", "needle", "behind_a_jump")),
    *(f"steps_in_place-{name}" for name in ("where_two_meet", "corner_of_an_input")),
    *(f"corners-{row.name}" for row in NEEDLES),
)
# FMPy does not tell its tolerance: that of the file lets places at 7000 km err by more than a gap of 5 mm.
WITHIN_THE_BAND = ("scales-relation_far_from_the_origin", "scales-craft_far_from_the_origin")


def _rows() -> dict[str, Attack]:
    """Of rows that differ in their tolerance only, which an importer chooses, the first."""
    found: dict[str, Attack] = {}
    for module in MODULES:
        tables = [v for v in vars(import_module(f"attack.{module}")).values() if isinstance(v, list)]
        alike = {
            repr((row.text, row.inputs, row.stop)): row
            for rows in tables
            for row in reversed(rows)
            if isinstance(row, Attack)
        }
        found |= {f"{module[5:]}-{row.name}": row for row in alike.values()}
    return found


def _is_for_importers(name: str, row: Attack) -> bool:
    """False for functions of time, for tables of smooth inputs, which an importer reads in its own way, and for inputs
    that are hidden from it."""
    smooth = "smooth" in row.text or not all(isinstance(given, tuple) for given in row.inputs.values())
    return not smooth and not (row.inputs and name.startswith(HIDDEN))


ROWS = {name: row for name, row in _rows().items() if _is_for_importers(name, row)}
SOME = [f"{module[5:]}-{name}" for module, name in MODULES.items() if name is not None]
PAIRS = in_turn(ROWS, VERSIONS, some=[(n, VERSIONS[i % 2]) for i, n in enumerate(SOME)])


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_models_made_to_go_wrong_as_fmus(name: str, version: int, tmp_path: Path) -> None:
    row = ROWS[name]
    fmu = _exported(row, version, tmp_path)
    if fmu is None:
        return
    if not name.startswith((*HIDDEN, *WITHIN_THE_BAND)):
        _holds(row, partial(_ends, row, fmu, "ModelExchange", TOLERANCE), max(NEAR, row.near))
    if not row.inputs:  # FMPy holds inputs over a step of co-simulation
        _holds(row, partial(_ends, row, fmu, "CoSimulation", row.tolerance), row.near)
    # Errors of CVODE are not the FMU's: events that an importer sees are as exact as its steps.
    if not row.inputs and not name.startswith(HIDDEN):
        _holds(row, partial(_exact_ends, row, fmu), ROUNDED.get(name, max(1e-8, row.near)))


def _holds(row: Attack, run: Callable[[], tuple[dict[str, float], str | None]], near: float) -> None:
    """The run ends where the reference says, or fails where it may."""
    ends, failure = in_bounded_time(run, SECONDS)
    assert failure is None or row.refused, (run, failure)
    for column, value in row.ends.items() if failure is None else ():
        close = abs(ends[column] - value) <= near * max(1.0, abs(value))
        assert close, f"{run} {column}: {ends[column]!r}, exact {value!r}"


def _exact_ends(row: Attack, fmu: Exported) -> tuple[dict[str, float], str | None]:
    try:
        return ends_exactly(fmu, row.stop, sorted(row.ends), _starts(row, fmu)), None
    except fmpy.fmi1.FMICallException as failure:
        return {}, str(failure)


def _exported(row: Attack, version: int, folder: Path) -> Exported | None:
    """None where the model is refused, as it may be."""
    path = folder / "attacked.fmu"
    try:
        told = lagdsl.compile(row.text).diagnostics
    except lagdsl.CompilationFailed as failed:
        assert failed.diagnostics[0].code in row.refused or "any" in row.refused
        return None
    if any(each.code in row.refused for each in told):
        return None
    try:
        export_text(row.text, path, version)
    except lagdsl.CompilationFailed as failed:  # E0908: the FMU that is tried ends as the run does
        assert row.refused and failed.diagnostics[0].code in (*row.refused, "E0908")
        return None
    fmpy.extract(str(path), str(folder / "unpacked"))
    return Exported(path, folder / "unpacked")


def _ends(row: Attack, fmu: Exported, kind: str, tolerance: float) -> tuple[dict[str, float], str | None]:
    """Values at the end; or the failure of a call."""
    try:
        rows = simulate_fmu(
            str(fmu.folder),
            fmi_type=kind,
            stop_time=row.stop,
            output_interval=row.stop / 10,
            relative_tolerance=tolerance,
            start_values=_starts(row, fmu),
            input=_inputs(row, fmu),
            output=sorted({fmu.entry(name)[0].name for name in row.ends}),
        )
    except fmpy.fmi1.FMICallException as failure:
        return {}, str(failure)
    return {name: float(column[-1]) for name, column in fmu.columns(rows, row.ends).items()}, None


def _starts(row: Attack, fmu: Exported) -> dict[str, Any]:
    """Of parameters; an array has one start for all of its entries."""
    starts: dict[str, Any] = {}
    for name, value in row.parameters.items():
        variable, index = fmu.entry(name)
        if index is None:
            starts[name] = value
        else:
            starts.setdefault(variable.name, np.array(variable.start.split(), dtype=float))[index] = value
    return starts


def _inputs(row: Attack, fmu: Exported) -> Any:
    """The tables of a row as one structured array."""
    if not row.inputs:
        return None
    times = next(iter(row.inputs.values()))[0]
    real = {name: fmu.variables[name].type in ("Real", "Float64") for name in row.inputs}
    table = np.zeros(
        len(times), dtype=[("time", float), *((name, float if real[name] else int) for name in row.inputs)]
    )
    table["time"] = times
    for name, (own, values) in row.inputs.items():
        assert tuple(own) == tuple(times)
        table[name] = values
    return table
