"""Networks: which coordinates move without kinetic energy, which potentials are open, and what to do."""

from __future__ import annotations

from pathlib import Path

import lagdsl
from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.motion.pipeline import compile_flat, flatten_file, read

RING = """
model Ring
  parameter Resistance R = 1 kOhm;
  parameter Capacitance C = 1 uF;
  parameter Inductance L = {inductance};
  coordinate Charge capacitor(start = 1 uC), resistor, coil;
  potential capacitor^2/(2*C);
  dissipation 1/2*R*der(resistor)^2;
  kinetic 1/2*L*der(coil)^2;
  constraint first: capacitor + resistor = 1 uC;
  constraint second: {second};
end Ring;
"""


def _errors(text: str) -> list[Diagnostic]:
    return [d for d in lagdsl.check(text) if d.severity == "error"]


def test_a_loop_with_an_inductance_is_sound() -> None:
    assert not _errors(RING.format(inductance="1 mH", second="coil = resistor"))


def test_a_loop_of_sources_is_told_with_all_its_charges_once() -> None:
    text = (
        RING.format(inductance="1 mH", second="coil = 0")
        .replace("1/2*R*der(resistor)^2", "0 W")
        .replace("capacitor^2", "coil^2")
    )
    (error,) = _errors(text)
    assert error.code == "E0503"
    assert error.notes == ("no force determines the motion in which `capacitor` and `resistor` change together",)
    assert error.help is not None and "inductance" in error.help


def test_a_loop_without_an_inductance_is_told() -> None:
    found = lagdsl.check(RING.format(inductance="1 mH", second="coil = 0"))
    assert [each.code for each in found if each.code != "W0814"] == ["N0529"]


def test_a_loose_flange_is_told_with_its_component() -> None:
    (error,) = _errors(
        """
        model Shafts
          import Lag.Rotational.{Rotor, TorqueBetween};
          Rotor rotor(J = 2 kg.m2);
          TorqueBetween motor(tau = 1 N.m);
          constraint joined: rotor.phi = motor.phi_a;
        end Shafts;
        """
    )
    assert error.code == "E0503" and error.message == "`motor.phi_b` has no inertia"
    assert [label.span.text for label in error.labels] == ["phi_b", "motor"]
    assert error.help is not None and error.help.startswith("connect it")


CIRCUIT = """
model Circuit
  import Lag.Electrical.*;
  Capacitor C1(C = 10 uF, q(start = 1 mC));
  {coil}
  {ground}
  connect(C1.p, other.p);
  connect(C1.n, other.n{to_ground});
end Circuit;
"""


def test_a_circuit_without_ground_is_told_what_is_missing() -> None:
    text = CIRCUIT.format(coil="Inductor other(L = 10 mH);", ground="", to_ground="")
    (note,) = lagdsl.check(text)
    assert note.code == "N0607" and note.help is not None and "Ground" in note.help


def test_a_source_across_another_is_told_with_both() -> None:
    text = CIRCUIT.format(coil="VoltageSource other(v = 1 V);", ground="Ground ground;", to_ground=", ground.p")
    (error,) = _errors(text.replace("Capacitor C1(C = 10 uF, q(start = 1 mC))", "VoltageSource C1(v = 2 V)"))
    assert error.code == "E0503" and error.message == "`C1.q` has no inertia"
    assert error.notes == ("no force determines the motion in which `C1.q` and `other.q` change together",)
    assert [label.span.text for label in error.labels] == ["q", "C1"]
    assert not _errors(text.replace("VoltageSource other(v = 1 V)", "Resistor other(R = 1 Ohm)"))


LADDER = Path(__file__).parents[3] / "benchmarks" / "models" / "ladder.lag"


def test_a_ladder_grows_by_as_much_with_each_cell() -> None:
    """Nodes of the graph and of the solved equations; no row of a circuit lends inertia."""
    sizes = []
    for n in (2, 4, 6):
        sink = Sink()
        file = read(LADDER, sink)
        assert file is not None
        flat = flatten_file(file, sink, structural={"N": n})
        assert flat is not None
        compilation = compile_flat(flat, sink)
        assert compilation is not None
        program = compilation.program
        solved = [node for block in program.function("elimination").results for node in block.elements]
        sizes.append((len(program.graph), len(program.graph.live(solved))))
    (graph, solved), (more, solved_more), (most, solved_most) = sizes
    assert most - more <= more - graph + 5
    assert solved_most - solved_more == solved_more - solved
