"""The structures and enumerations of the C runtime as ctypes sees them.

Generated from its headers: `python -m lagdsl.engines.runtime.generate`.
"""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int, c_size_t, c_uint, c_void_p
from enum import IntEnum
from typing import Any

_Numbers = POINTER(c_double)
_Fields = list[tuple[str, Any]]


def _all(kind: Any, names: str) -> _Fields:
    """Members of one type."""
    return [(name, kind) for name in names.split()]


def _evaluated(results: int) -> Any:
    """A function of lag_model that fills so many arrays."""
    return CFUNCTYPE(c_int, POINTER(Arguments), *[_Numbers] * results)


VERSION = 13

# lag_event_kind.
_WHAT = "before tick true false opened closed impact reinit terminate after jump slips sticks reverses warning"
WHAT = tuple(_WHAT.split())


class Status(IntEnum):
    """Of lag/status.h."""

    OK = 0
    SINGULAR = 1
    NOT_FINITE = 2
    MISSING = 3
    STEP_TOO_SMALL = 4
    TOO_LONG = 5
    PROJECTION_FAILED = 6
    ATTENTION = 7
    VIOLATED = 8
    STOPPED = 9
    CHATTER = 10
    EVENT_PENDING = 11
    EVENT_ITERATION_FAILED = 12
    CONFLICT = 13
    ASSERTION_FAILED = 14
    PENETRATION = 15
    POSITION_JUMP = 16
    BRANCH_POINT = 17
    BAD_STATE_DATA = 18
    BAD_CLOCK = 19
    WAY_JUMP = 20
    MOMENTUM_UNREACHABLE = 21
    NO_FORCES = 22
    BAD_DELAY = 23
    LONG_PAST = 24
    GRAZING = 25
    NOT_SMOOTH = 26


class InitialFault(IntEnum):
    """Of lag/initial.h."""

    NONE = 0
    NUMBERS = 1
    POSITIONS = 2
    RATES = 3
    EQUATIONS = 4
    RANK = 5
    SIZES = 6
    PARAMETERS = 7
    BOUNDS = 8


class SignalKind(IntEnum):
    """Of lag/signals.h."""

    HELD = 0
    STEPS = 1
    LINES = 2
    POLYNOMIAL = 3


class Arguments(Structure):
    """lag_arguments."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(c_void_p, "q qd z u w p qdd lam dq dqd dz du dp dqdd dlam workspace times context kept"),
    ]


class Model(Structure):
    """lag_model."""

    _fields_ = [
        *_all(c_uint, "version"),
        *_all(c_size_t, "size"),
        *_all(c_char_p, "name"),
        *_all(c_size_t, "nq nz nu nw np nc ny ni na ne rank workspace prepared"),
        *_all(c_void_p, "context coordinates states inputs discretes parameters constraints outputs"),
        *_all(c_void_p, "invariants assertions defaults position_level redundant"),
        *_all(_evaluated(0), "prepare"),
        *_all(_evaluated(4), "start"),
        *_all(_evaluated(2), "position_constraint velocity_constraint"),
        *_all(_evaluated(1), "mass_matrix"),
        *_all(_evaluated(4), "dynamics"),
        *_all(_evaluated(1), "inverse_dynamics"),
        *_all(_evaluated(2), "residual residual_tangent"),
        *_all(_evaluated(1), "state_derivative state_derivative_tangent output output_tangent"),
        *_all(_evaluated(4), "energies"),
        *_all(_evaluated(1), "momenta"),
        *_all(_evaluated(2), "power"),
        *_all(_evaluated(3), "monitor"),
        *_all(_evaluated(1), "initial_equation"),
        *_all(_evaluated(2), "constraint_tangent"),
        *_all(_evaluated(7), "elimination"),
        *_all(_evaluated(1), "discrete_start indicator"),
        *_all(_evaluated(2), "indicator_rate"),
        *_all(_evaluated(1), "standing"),
        *_all(_evaluated(6), "contact"),
        *_all(_evaluated(2), "clock"),
        *_all(_evaluated(7), "event"),
        *_all(_evaluated(6), "time_event"),
        *_all(_evaluated(2), "corner"),
        *_all(_evaluated(1), "way"),
        *_all(_evaluated(4), "turn"),
        *_all(_evaluated(3), "delayed"),
        *_all(_evaluated(6), "friction"),
        *_all(_evaluated(3), "load"),
        *_all(_evaluated(1), "load_tangent"),
        *_all(_evaluated(4), "load_gain"),
        *_all(_evaluated(1), "momentum_tangent definition definition_tangent"),
        *_all(_evaluated(4), "start_tangent energies_tangent"),
        *_all(_evaluated(1), "initial_equation_tangent"),
        *_all(_evaluated(11), "time_tangent"),
        *_all(_evaluated(3), "correction equation_terms"),
        *_all(_evaluated(2), "regressor"),
        *_all(_evaluated(5), "kinematics"),
        *_all(c_void_p, "patterns components"),
        *_all(c_size_t, "nk"),
        *_all(c_void_p, "kept_rows"),
        *_all(c_size_t, "nindicator ncontact ngap nclock nreset ncollision nstop nfail ntimed ndistance"),
        *_all(c_size_t, "ncorner nway nturn ndelay nslip nfriction nload"),
        *_all(c_void_p, "kinds strict jumping whole_inputs contact_rows one_way frictions friction_rows"),
        *_all(c_void_p, "friction_slips friction_contacts"),
        *_all(c_size_t, "nswitched"),
        *_all(c_void_p, "switched_rows reset_places resets stops failures"),
        *_all(c_size_t, "nd"),
        *_all(c_void_p, "definitions"),
        *_all(c_size_t, "ninertial nplace naxes ntwist"),
    ]


class Start(Structure):
    """lag_start."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(c_void_p, "x fixed written nominal minimum maximum free parameter_nominal parameter_minimum"),
        *_all(c_void_p, "parameter_maximum"),
    ]


class Range(Structure):
    """lag_range."""

    _fields_ = [
        *_all(c_size_t, "first count"),
    ]


class Strided(Structure):
    """lag_strided."""

    _fields_ = [
        *_all(c_void_p, "first"),
        *_all(c_size_t, "stride"),
    ]


class Batch(Structure):
    """lag_batch."""

    _fields_ = [
        *_all(c_size_t, "count"),
        *_all(Strided, "t q qd z u w p qdd lam dq dqd dz du dp dqdd dlam"),
        *_all(c_void_p, "workspace memory lanes"),
    ]


class Call(Structure):
    """lag_call."""

    _fields_ = [
        *_all(c_void_p, "model tangents memory zero start standing solved parameters results"),
        *_all(Arguments, "at"),
        *_all(Range, "x"),
        *_all(c_int, "what prepared"),
        *_all(c_double, "started"),
        *_all(c_size_t, "left coordinate"),
    ]


class Note(Structure):
    """lag_note."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(c_int, "what"),
        *_all(c_size_t, "which"),
    ]


class Extremes(Structure):
    """lag_extremes."""

    _fields_ = [
        *_all(c_size_t, "size count"),
        *_all(c_void_p, "low high turns pivot way sample outputs passed when"),
        *_all(c_size_t, "searched"),
    ]


class Results(Structure):
    """lag_results."""

    _fields_ = [
        *_all(c_size_t, "most_rows most_notes"),
        *_all(c_void_p, "rows notes"),
        *_all(CFUNCTYPE(c_int, c_void_p, c_void_p), "full"),
        *_all(c_void_p, "context"),
        *_all(c_size_t, "row note"),
        *_all(c_int, "any"),
        *_all(c_double, "last after"),
        *_all(c_int, "bare"),
        *_all(c_void_p, "companion extremes"),
    ]


class Initial(Structure):
    """lag_initial."""

    _fields_ = [
        *_all(c_int, "fault"),
        *_all(c_size_t, "which"),
        *_all(c_double, "residual"),
        *_all(c_size_t, "rank"),
        *_all(c_int, "moved"),
        *_all(c_size_t, "freedom excess general"),
        *_all(c_int, "given"),
        *_all(c_void_p, "dependent row_sizes p"),
    ]


class Along(Structure):
    """lag_along."""

    _fields_ = [
        *_all(c_void_p, "model tangents workspace memory"),
    ]


class SensitivityDirections(Structure):
    """lag_sensitivity_directions."""

    _fields_ = [
        *_all(c_size_t, "count"),
        *_all(c_void_p, "p u start"),
    ]


class SensitivityRows(Structure):
    """lag_sensitivity_rows."""

    _fields_ = [
        *_all(c_void_p, "rows times"),
    ]


class SensitivityFault(Structure):
    """lag_columns_fault."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(c_size_t, "guard one_sided"),
        *_all(c_double, "first"),
    ]


class RunCallbacks(Structure):
    """lag_run_callbacks."""

    _fields_ = [
        *_all(c_void_p, "context"),
        *_all(CFUNCTYPE(None, c_void_p, c_double, c_int, _Numbers), "inputs"),
        *_all(CFUNCTYPE(None, c_void_p, c_void_p), "along"),
        *_all(CFUNCTYPE(c_int, c_void_p, c_void_p, c_double, _Numbers), "output"),
        *_all(CFUNCTYPE(c_int, c_void_p, c_void_p, c_void_p), "tell"),
    ]


class Sizes(Structure):
    """lag_sizes."""

    _fields_ = [
        *_all(c_void_p, "group natural cap row_sizes"),
    ]


class Lasting(Structure):
    """lag_lasting."""

    _fields_ = [
        *_all(c_void_p, "rows"),
        *_all(c_size_t, "general"),
    ]


class RunInvariants(Structure):
    """lag_run_invariants."""

    _fields_ = [
        *_all(c_void_p, "tolerance start size drift"),
        *_all(c_int, "continued"),
    ]


class RunOptions(Structure):
    """lag_run_options."""

    _fields_ = [
        *_all(c_double, "tolerance"),
        *_all(c_void_p, "method"),
        *_all(c_double, "h_first h_most h_fixed part"),
        *_all(c_void_p, "p u"),
        *_all(RunCallbacks, "callbacks"),
        *_all(Sizes, "sizes"),
        *_all(c_int, "careful"),
        *_all(Lasting, "lasting"),
        *_all(c_double, "length"),
        *_all(c_size_t, "count"),
        *_all(c_void_p, "times rows results"),
        *_all(RunInvariants, "invariants"),
        *_all(c_void_p, "start"),
        *_all(c_int, "zeroed"),
    ]


class RunChange(Structure):
    """lag_change."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(c_int, "implicit"),
    ]


class StepCounts(Structure):
    """lag_step_counts."""

    _fields_ = [
        *_all(c_size_t, "steps rejections evaluations jacobians decompositions directions"),
    ]


class RunReport(Structure):
    """lag_run_report."""

    _fields_ = [
        *_all(c_double, "t h trouble_time"),
        *_all(_Numbers, "x"),
        *_all(c_size_t, "row steps"),
        *_all(StepCounts, "counts"),
        *_all(c_size_t, "projections events changes"),
        *_all(_Numbers, "w changed guilty doubted"),
        *_all(c_size_t, "fault"),
        *_all(c_double, "next"),
        *_all(POINTER(RunChange), "change"),
        *_all(c_int, "implicit"),
    ]


class RunFault(Structure):
    """lag_fault."""

    _fields_ = [
        *_all(c_double, "t"),
        *_all(_Numbers, "x"),
        *_all(c_size_t, "which"),
        *_all(c_double, "value limit"),
    ]


class EnsembleResults(Structure):
    """lag_ensemble_results."""

    _fields_ = [
        *_all(c_void_p, "rows kept ended status found"),
    ]


class Ensemble(Structure):
    """lag_ensemble."""

    _fields_ = [
        *_all(c_void_p, "model states options"),
        *_all(c_double, "t stop"),
        *_all(c_size_t, "breaks"),
        *_all(c_void_p, "at"),
        *_all(c_size_t, "first_piece piece most_steps"),
        *_all(c_int, "equations"),
        *_all(c_void_p, "set stopped p u natural x"),
        *_all(EnsembleResults, "results"),
        *_all(CFUNCTYPE(None, c_void_p, c_size_t, c_void_p, c_int, _Numbers, _Numbers, c_void_p), "failed"),
        *_all(c_void_p, "context"),
    ]


class Signal(Structure):
    """lag_signal."""

    _fields_ = [
        *_all(c_int, "kind"),
        *_all(c_size_t, "count terms"),
        *_all(c_void_p, "time value"),
    ]


class Signals(Structure):
    """lag_signals."""

    _fields_ = [
        *_all(c_size_t, "count"),
        *_all(c_void_p, "signal"),
    ]


class Hold(Structure):
    """lag_hold."""

    _fields_ = [
        *_all(c_void_p, "run u before signals context at"),
        *_all(c_size_t, "count breaks"),
        *_all(CFUNCTYPE(None, c_void_p, c_double, c_int, _Numbers), "inputs"),
        *_all(c_int, "rows"),
        *_all(c_double, "goal jumped"),
    ]
